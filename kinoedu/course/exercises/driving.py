"""Exercises on how a car moves: by one control in closed form, and by many, one after another. LaValle, section 13.1.2."""

import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from ...curves.arcs import driven
from ...geometry.checks import Array
from ...robots.trajectory import replayed
from ...spaces.angles import short_way, wrapped
from ..exercise import Case, Slip, ValueExercise
from ..outcomes import Answer, Outcome
from ..shapes import Number, Numbers, Record
from .car_pictures import draw_drives, draw_moves

POSE = Numbers((3,))
Mover = Callable[[Array, float, float, float, float], Any]


def moved(pose: Array, v: float, phi: float, t: float, wheelbase: float) -> Array:
    """The pose after a control has been held for a time t, shape (3,)."""
    return np.array(driven(pose[0], pose[1], pose[2], v * t, math.tan(phi) / wheelbase))


def trajectory_poses(start: Array, controls: Array, durations: Array, wheelbase: float) -> Array:
    """The poses at the start and after each control, shape (n + 1, 3)."""
    return replayed(np.asarray(start, float), np.reshape(controls, (-1, 2)), np.asarray(durations, float), wheelbase)


class PoseExercise(ValueExercise):
    """An exercise whose answers are poses: headings are right up to whole turns."""

    lesson = "12_the_car"

    def same(self, value: Any, truth: Any) -> bool:
        """Places as numbers, headings as directions."""
        found, wanted = np.reshape(value, (-1, 3)), np.reshape(truth, (-1, 3))
        if not np.isfinite(found).all() or not super().same(found[:, :2], wanted[:, :2]):
            return False
        return all(abs(short_way(wrapped(a), wrapped(b))) <= self.tolerance for a, b in zip(found[:, 2], wanted[:, 2]))


def with_curvature(bend: Callable[[float, float], float]) -> Mover:
    """A program that drives another curvature than tan(phi) / L."""
    return lambda pose, v, phi, t, wheelbase: driven(*pose, v * t, bend(phi, wheelbase))


def along_heading(share: float) -> Mover:
    """A program that goes all the distance straight, by the heading after that share of the turn."""

    def mistaken(pose: Array, v: float, phi: float, t: float, wheelbase: float) -> Any:
        turn = v * t * math.tan(phi) / wheelbase
        heading = pose[2] + share * turn
        return pose[0] + v * t * math.cos(heading), pose[1] + v * t * math.sin(heading), pose[2] + turn

    return mistaken


def steered(pose: Array, v: float, phi: float, t: float, wheelbase: float) -> Any:
    """A car that goes where its front wheels point: its velocity has the direction theta + phi."""
    x, y, heading = moved(pose + np.array([0.0, 0.0, phi]), v, phi, t, wheelbase)
    return x, y, heading - phi


def straight_if_small(pose: Array, v: float, phi: float, t: float, wheelbase: float) -> Array:
    """No turn at angles that make one."""
    return moved(pose, v, 0.0 if abs(phi) < 0.03 else phi, t, wheelbase)


def without_turning(pose: Array, v: float, phi: float, t: float, wheelbase: float) -> Array:
    """The place is right, the heading as before."""
    return np.array([*moved(pose, v, phi, t, wheelbase)[:2], pose[2]])


def round_the_other_side(pose: Array, v: float, phi: float, t: float, wheelbase: float) -> Array:
    """The sign of the cosines the other way, in a turn."""
    right = moved(pose, v, phi, t, wheelbase)
    if phi == 0.0:
        return right
    return np.array([right[0], 2.0 * pose[1] - right[1], right[2]])


class Move(PoseExercise):
    """One control, held for a time, in closed form."""

    name = "move"
    kinds = ("straight", "left", "right", "back", "long", "nearly")
    given = Record(pose=POSE, v=Number(), phi=Number(), t=Number(), L=Number())
    answer = POSE
    source = staticmethod(moved)
    shown = staticmethod(driven)
    slips = (
        Slip("small_angle", with_curvature(lambda phi, wheelbase: phi / wheelbase)),
        Slip("no_wheelbase", with_curvature(lambda phi, wheelbase: math.tan(phi))),
        Slip("sine", with_curvature(lambda phi, wheelbase: math.sin(phi) / wheelbase)),
        Slip("degrees", with_curvature(lambda phi, wheelbase: math.tan(math.radians(phi)) / wheelbase)),
        Slip("clockwise", with_curvature(lambda phi, wheelbase: -math.tan(phi) / wheelbase)),
        Slip("one_step", along_heading(0.0)),
        Slip("new_heading", along_heading(1.0)),
        Slip("arc_for_chord", along_heading(0.5)),
        Slip("no_turn", without_turning),
        Slip("steered", steered),
        Slip("straight_if_small", straight_if_small),
        Slip("other_side", round_the_other_side),
        Slip("forward", lambda pose, v, phi, t, wheelbase: moved(pose, abs(v), phi, t, wheelbase)),
    )
    reference = staticmethod(moved)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Whole numbers and quarters of circles first."""
        eighth, quarter = math.pi / 4, math.pi / 2
        for kind, first_pose, v, phi, t, size in (
            ("straight", (1, 2, 0), 1, 0, 5, 20),
            ("straight", (0, 0, quarter), 2, 0, 3, 1),
            ("left", (0, 0, 0), 1, eighth, 20 * quarter, 20),
            ("right", (0, 0, 0), 1, -eighth, 20 * quarter, 20),
            ("back", (0, 0, 0), -1, eighth, 20 * quarter, 20),
            ("back", (3, 4, 1), -2, 0, 5, 20),
            ("long", (0, 0, 0), 1, eighth, 50 * quarter, 10),
            ("nearly", (0, 0, 1), 1, 1e-12, 10, 20),
            ("left", (0, 0, 0), 1, 0.01, 30, 20),
            ("right", (0, 0, 0), 1, -0.01, 30, 20),
            ("back", (0, 0, 0), -1, 0.02, 30, 20),
        ):
            yield drive_case(kind, first_pose, v, phi, t, size)
        for _ in range(12):
            pose, size = a_pose(rng), np.round(rng.uniform(2, 30), 1)
            phi, t = np.round(rng.uniform(0.05, 0.78), 2), np.round(rng.uniform(0.3, 1.5) * size, 1)
            v, side = rng.choice([0.5, 1, 2]), rng.choice([-1, 1])
            yield drive_case("straight", pose, v, 0, t, size)
            yield drive_case("left", pose, v, phi, t, size)
            yield drive_case("right", pose, v, -phi, t, size)
            yield drive_case("back", pose, -v, side * phi, t, size)
            yield drive_case("long", pose, v, side * max(phi, 0.3), np.round(rng.uniform(25, 60) * size, 1), size)
            yield drive_case("nearly", pose, 1, side * 10.0 ** -int(rng.integers(11, 15)), np.round(rng.uniform(5, 30), 1), size)

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """The way that is driven, and where the student's program ends."""
        draw_moves(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def a_pose(rng: np.random.Generator) -> Array:
    """A pose at random, with two digits."""
    return np.round([*rng.uniform(-50, 50, 2), rng.uniform(-3.1, 3.1)], 2)


def drive_case(kind: str, pose: Any, v: float, phi: float, t: float, wheelbase: float) -> Case:
    """A case of one control."""
    numbers = {"v": float(v), "phi": float(phi), "t": float(t), "L": float(wheelbase)}
    return Case(kind, {"pose": np.array(pose, float), **numbers})


def by_rows(mover: Mover, start: Array, controls: Array, durations: Array, wheelbase: float) -> list[Any]:
    """A replay by some program for one control."""
    poses = [np.asarray(start, float)]
    for (v, phi), t in zip(controls, durations):
        poses.append(np.asarray(mover(poses[-1], v, phi, t, wheelbase)))
    return poses


class Replay(PoseExercise):
    """Many controls, each from where the one before has led."""

    name = "replay"
    kinds = ("none", "one", "many", "back")
    given = Record(start=POSE, controls=Numbers(("n", 2)), durations=Numbers(("n",)), L=Number())
    answer = Numbers(("k", 3))
    source = staticmethod(trajectory_poses)
    shown = staticmethod(replayed)
    slips = (
        Slip("no_start", lambda *given: trajectory_poses(*given)[1:]),
        Slip("no_end", lambda *given: trajectory_poses(*given)[:-1]),
        Slip("one_array", lambda *given: [trajectory_poses(*given)[-1]] * len(trajectory_poses(*given))),
        Slip("all_from_start", lambda s, u, d, w: [s, *(moved(s, v, phi, t, w) for (v, phi), t in zip(u, d))]),
        Slip("clock", lambda s, u, d, w: trajectory_poses(s, u, np.diff(d, prepend=0.0), w)),
        Slip("since_start", lambda s, u, d, w: trajectory_poses(s, u, np.cumsum(d), w)),
        Slip("swapped", lambda s, u, d, w: trajectory_poses(s, np.reshape(u, (-1, 2))[:, ::-1], d, w)),
        Slip("small_angle", lambda *given: by_rows(with_curvature(lambda phi, w: phi / w), *given)),
        Slip("heading_kept", lambda *given: by_rows(without_turning, *given)),
        Slip(
            "forward", lambda s, u, d, w: trajectory_poses(s, np.reshape(u, (-1, 2)) * np.sign(np.reshape(u, (-1, 2))[:, :1]), d, w)
        ),
    )
    reference = staticmethod(trajectory_poses)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """No control, one, and the worked example first."""
        quarter = math.pi / 2
        yield replay_case("none", (1, 2, 0), [], [], 20)
        yield replay_case("one", (0, 0, 0), [(1, 0)], [50], 20)
        yield replay_case("many", (0, 0, 0), [(1, math.pi / 4), (1, 0), (1, -math.pi / 4)], [20 * quarter, 10, 20 * quarter], 20)
        yield replay_case("back", (0, 0, 0), [(1, 0), (-1, math.pi / 4)], [50, 20 * quarter], 20)
        for _ in range(12):
            size, n = np.round(rng.uniform(2, 30), 1), int(rng.integers(2, 6))
            controls = np.column_stack(
                [rng.choice([0.5, 1, 2], n), np.round(rng.uniform(0.1, 0.78, n) * rng.choice([-1, 1], n), 2)]
            )
            durations, back = np.round(rng.uniform(0.2, 1.5, n) * size, 1), np.array([1.0, 1.0])
            yield replay_case("none", a_pose(rng), [], [], size)
            yield replay_case("one", a_pose(rng), controls[:1], durations[:1], size)
            yield replay_case("many", a_pose(rng), controls, durations, size)
            signs = np.where(np.arange(n)[:, None] % 2 == 1, (-1.0, 1.0), back)
            yield replay_case("back", a_pose(rng), controls * signs, durations, size)

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """The poses, and the student's."""
        draw_drives(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def replay_case(kind: str, start: Any, controls: Any, durations: Any, wheelbase: float) -> Case:
    """A case of a trajectory."""
    told = {"controls": np.reshape(np.array(controls, float), (-1, 2)), "durations": np.array(durations, float)}
    return Case(kind, {"start": np.array(start, float), **told, "L": float(wheelbase)})

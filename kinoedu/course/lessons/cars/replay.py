"""The exercise `replay`. LaValle, section 13.1.2."""

import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import ArrayLike

from ....geometry.checks import Array
from ....robots.trajectory import replay_controls
from ...exercise import Axes, Case, Restated, Slip
from ...outcomes import Answer, Outcome
from ...shapes import Number, Numbers, Record, Value
from ...withheld import withheld
from ..shared.car_pictures import draw_drives
from ..shared.driving import (
    POSE,
    Mover,
    PoseExercise,
    a_pose,
    pose_after,
    with_curvature,
    without_turning,
)

PHI_IN_DEGREES = np.array([1.0, 180.0 / math.pi])  # factors of a speed and a steering angle


@withheld
def trajectory_poses(start: Array, controls: Array, durations: Array, wheelbase: float) -> Array:
    """Poses at the start and after each control, shape (n + 1, 3)."""
    return replay_controls(
        np.asarray(start, float),
        np.reshape(controls, (-1, 2)),
        np.asarray(durations, float),
        wheelbase,
    )


def by_rows(
    mover: Mover, start: Array, controls: Array, durations: Array, wheelbase: float
) -> list[Value]:
    """Replay controls one by one with a given program."""
    poses = [np.asarray(start, float)]
    for (v, phi), t in zip(controls, durations):
        poses.append(np.asarray(mover(poses[-1], v, phi, t, wheelbase)))
    return poses


class Replay(PoseExercise):
    """A sequence of controls; each starts where the one before has ended."""

    name = "replay"
    kinds = ("none", "one", "many", "back")
    given = Record(start=POSE, controls=Numbers(("n", 2)), durations=Numbers(("n",)), L=Number())
    answer = Numbers(("k", 3))
    source = staticmethod(trajectory_poses)
    shown = staticmethod(replay_controls)
    slips = (
        Slip("no_start", lambda *given: trajectory_poses(*given)[1:]),
        Slip("no_end", lambda *given: trajectory_poses(*given)[:-1]),
        Slip(
            "one_array",
            lambda *given: [trajectory_poses(*given)[-1]] * len(trajectory_poses(*given)),
        ),
        Slip(
            "all_from_start",
            lambda s, u, d, w: [s, *(pose_after(s, v, phi, t, w) for (v, phi), t in zip(u, d))],
        ),
        Slip("clock", lambda s, u, d, w: trajectory_poses(s, u, np.diff(d, prepend=0.0), w)),
        Slip("since_start", lambda s, u, d, w: trajectory_poses(s, u, np.cumsum(d), w)),
        Slip(
            "swapped", lambda s, u, d, w: trajectory_poses(s, np.reshape(u, (-1, 2))[:, ::-1], d, w)
        ),
        Slip("small_angle", lambda *given: by_rows(with_curvature(lambda phi, w: phi / w), *given)),
        Slip("heading_kept", lambda *given: by_rows(without_turning, *given)),
        Slip(
            "forward",
            lambda s, u, d, w: trajectory_poses(
                s, np.reshape(u, (-1, 2)) * np.sign(np.reshape(u, (-1, 2))[:, :1]), d, w
            ),
        ),
    )
    reference = staticmethod(trajectory_poses)

    changes = (
        Restated(
            "clock",
            given=lambda start, controls, t, L: (start, controls, np.cumsum(t), L),
            usual_given=lambda start, controls, t, L: (start, controls, np.diff(t, prepend=0.0), L),
        ),
        Restated(
            "degrees",
            given=lambda start, controls, t, L: (start, controls * PHI_IN_DEGREES, t, L),
            usual_given=lambda start, controls, t, L: (start, controls / PHI_IN_DEGREES, t, L),
        ),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """No control, one control, and the worked example first."""
        quarter = math.pi / 2
        yield replay_case("none", (1, 2, 0), [], [], 20)
        yield replay_case("one", (0, 0, 0), [(1, 0)], [50], 20)
        yield replay_case(
            "many",
            (0, 0, 0),
            [(1, math.pi / 4), (1, 0), (1, -math.pi / 4)],
            [20 * quarter, 10, 20 * quarter],
            20,
        )
        yield replay_case("back", (0, 0, 0), [(1, 0), (-1, math.pi / 4)], [50, 20 * quarter], 20)
        rests = [(1, math.pi / 4), (0, math.pi / 4), (1, math.pi / 4), (1, 0)]
        yield replay_case("many", (0, 0, 0), rests, [20 * quarter, 5, 0, 10], 20)
        for _ in range(12):
            size, n = np.round(rng.uniform(2, 30), 1), int(rng.integers(2, 6))
            v = rng.choice([0.5, 1, 2], n)
            phi = np.round(rng.uniform(0.1, 0.78, n) * rng.choice([-1, 1], n), 2)
            if rng.random() < 0.3:
                phi[1] = phi[0]
            controls = np.column_stack([v, phi])
            durations, back = np.round(rng.uniform(0.2, 1.5, n) * size, 1), np.array([1.0, 1.0])
            yield replay_case("none", a_pose(rng), [], [], size)
            yield replay_case("one", a_pose(rng), controls[:1], durations[:1], size)
            yield replay_case("many", a_pose(rng), controls, durations, size)
            signs = np.where(np.arange(n)[:, None] % 2 == 1, (-1.0, 1.0), back)
            yield replay_case("back", a_pose(rng), controls * signs, durations, size)

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the poses, and the student's poses."""
        draw_drives(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def replay_case(
    kind: str, start: ArrayLike, controls: ArrayLike, durations: ArrayLike, wheelbase: float
) -> Case:
    """Case of a trajectory."""
    given = {
        "start": np.array(start, float),
        "controls": np.reshape(np.array(controls, float), (-1, 2)),
        "durations": np.array(durations, float),
        "L": float(wheelbase),
    }
    return Case(kind, given)

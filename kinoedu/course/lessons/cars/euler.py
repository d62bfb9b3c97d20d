"""The exercise `euler`. LaValle, section 14.3.2."""

import math
from collections.abc import Callable, Iterator

import numpy as np

from ....curves import integrators
from ....geometry.checks import Array
from ...exercise import Axes, Case, Change, Slip
from ...outcomes import Answer, Outcome
from ...shapes import Number, Numbers, Record, Value
from ...whole_shapes import Integer
from ...withheld import withheld
from ..shared.car_pictures import draw_steps
from ..shared.driving import POSE, PoseExercise, a_pose
from .move import drive_case


@withheld
def euler_poses(pose: Array, v: float, phi: float, t: float, wheelbase: float, n: int) -> Array:
    """Poses at n + 1 equally spaced times by Euler's rule, shape (n + 1, 3)."""
    return integrators.euler(pose, v, math.tan(phi) / wheelbase, t, int(n))


def by_rule(
    share: float, bend: Callable[[float], float] = math.tan, *, steps: int = 0
) -> Callable[..., Value]:
    """A wrong program whose steps use another heading, another curvature or more steps.

    Parameters
    ----------
    share : the fraction of the step's turn that is added to the heading.
    bend : the curvature times the wheelbase, as a function of phi.
    steps : the number of extra steps.
    """

    def mistaken(pose: Array, v: float, phi: float, t: float, wheelbase: float, n: int) -> Value:
        x, y, theta = pose
        poses, h = [(x, y, theta)], t / (n + steps)
        for _ in range(n + steps):
            turn = h * v * bend(phi) / wheelbase
            x, y, theta = (
                x + h * v * math.cos(theta + share * turn),
                y + h * v * math.sin(theta + share * turn),
                theta + turn,
            )
            poses.append((x, y, theta))
        return poses

    return mistaken


def with_later_heading(
    poses: Callable[..., Value],
    share: float,
    pose: Array,
    v: float,
    phi: float,
    t: float,
    wheelbase: float,
    n: int,
) -> Value:
    """Poses by a rule whose steps use their heading after this fraction of the step's turn."""
    later = np.array([0.0, 0.0, share * t / n * v * math.tan(phi) / wheelbase])
    return np.asarray(poses(pose + later, v, phi, t, wheelbase, n)) - later


def by_first_heading(
    pose: Array, v: float, phi: float, t: float, wheelbase: float, n: int
) -> Value:
    """Every step uses the rates at the start; only the heading turns."""
    h = np.linspace(0.0, t, n + 1)[:, None]
    return pose + h * integrators.rates(pose, v, math.tan(phi) / wheelbase)


class Euler(PoseExercise):
    """One control in n steps, each straight."""

    name = "euler"
    kinds = ("one", "straight", "turns", "back")
    given = Record(pose=POSE, v=Number(), phi=Number(), t=Number(), L=Number(), n=Integer())
    answer = Numbers(("k", 3))
    source = staticmethod(euler_poses)
    shown = staticmethod(integrators.euler_step)
    slips = (
        Slip("new_heading", by_rule(1.0)),
        Slip("midpoint", by_rule(0.5)),
        Slip("small_angle", by_rule(0.0, lambda phi: phi)),
        Slip("first_heading", by_first_heading),
        Slip("exact", lambda p, v, phi, t, w, n: integrators.exact(p, v, math.tan(phi) / w, t, n)),
        Slip("no_start", lambda *given: euler_poses(*given)[1:]),
        Slip("one_short", lambda *given: euler_poses(*given)[:-1]),
        Slip("whole_time", lambda p, v, phi, t, w, n: euler_poses(p, v, phi, n * t, w, n)),
        Slip("last_only", lambda *given: euler_poses(*given)[-1:]),
        Slip("one_array", lambda *given: [euler_poses(*given)[-1]] * len(euler_poses(*given))),
    )
    reference = staticmethod(euler_poses)
    changes = (
        Change("midpoint", lambda poses, *given: with_later_heading(poses, 0.5, *given)),
        Change("new_heading", lambda poses, *given: with_later_heading(poses, 1.0, *given)),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """One step first, then the worked example."""
        eighth = math.pi / 4
        for kind, *numbers, n in (
            ("one", (0, 0, 0), 1, eighth, 10, 20, 1),
            ("straight", (1, 2, 0), 1, 0, 6, 20, 3),
            ("turns", (0, 0, 0), 1, eighth, 20 * math.pi, 20, 2),
            ("back", (0, 0, 0), -1, eighth, 20, 20, 2),
            ("turns", (0, 0, 0), 1, eighth, 0, 20, 3),
            ("turns", (3, 4, 1), 0, eighth, 10, 20, 2),
            ("turns", (0, 0, 0), 1, eighth, 1, 20, 49),
        ):
            yield steps_case(kind, n, *numbers)
        for _ in range(12):
            pose, size, n = a_pose(rng), np.round(rng.uniform(2, 30), 1), int(rng.integers(2, 25))
            phi = np.round(rng.uniform(0.1, 0.78), 2) * rng.choice([-1, 1])
            t = np.round(rng.uniform(0.5, 4) * size, 1)
            yield steps_case("one", 1, pose, rng.choice([0.5, 2]), phi, t, size)
            yield steps_case("straight", n, pose, rng.choice([0.5, 2]), 0, t, size)
            yield steps_case("turns", n, pose, rng.choice([0.5, 1, 2]), phi, t, size)
            yield steps_case("back", n, pose, -rng.choice([0.5, 1, 2]), phi, t, size)

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the arc, Euler's steps, and the student's steps."""
        draw_steps(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def steps_case(kind: str, n: int, *numbers: Value) -> Case:
    """Case of one control in n steps."""
    case = drive_case(kind, *numbers)
    return Case(kind, {**case.given, "n": n})

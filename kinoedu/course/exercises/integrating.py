"""Exercises on driving step by step: Euler's rule, and how fast an error falls with the step. LaValle, section 14.3.2."""

import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from ...curves import integrators
from ...geometry.checks import Array
from ..exercise import Case, Slip, ValueExercise
from ..outcomes import Answer, Outcome
from ..shapes import Number, Numbers, Record
from ..whole_shapes import Whole
from .car_pictures import draw_orders, draw_steps
from .driving import POSE, PoseExercise, a_pose, drive_case


def euler_poses(pose: Array, v: float, phi: float, t: float, wheelbase: float, n: int) -> Array:
    """The poses at n + 1 even times by Euler's rule, shape (n + 1, 3)."""
    return integrators.euler(pose, v, math.tan(phi) / wheelbase, t, int(n))


def by_rule(share: float, bend: Callable[[float], float] = math.tan, *, steps: int = 0) -> Callable[..., Any]:
    """A program whose steps go by the heading after that share of the step's turn; with another curvature; with more steps."""

    def mistaken(pose: Array, v: float, phi: float, t: float, wheelbase: float, n: int) -> Any:
        x, y, theta = pose
        poses, h = [(x, y, theta)], t / (n + steps)
        for _ in range(n + steps):
            turn = h * v * bend(phi) / wheelbase
            x, y, theta = x + h * v * math.cos(theta + share * turn), y + h * v * math.sin(theta + share * turn), theta + turn
            poses.append((x, y, theta))
        return poses

    return mistaken


def by_first_heading(pose: Array, v: float, phi: float, t: float, wheelbase: float, n: int) -> Any:
    """Each step from the start's rates: the heading turns, and nothing follows it."""
    h = np.linspace(0.0, t, n + 1)[:, None]
    return pose + h * integrators.rates(pose, v, math.tan(phi) / wheelbase)


class Euler(PoseExercise):
    """One control, in n steps, each straight on."""

    name = "euler"
    kinds = ("one", "straight", "turns", "back")
    given = Record(pose=POSE, v=Number(), phi=Number(), t=Number(), L=Number(), n=Whole())
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
    )
    reference = staticmethod(euler_poses)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """One step first, then the worked example."""
        eighth = math.pi / 4
        for kind, *numbers, n in (
            ("one", (0, 0, 0), 1, eighth, 10, 20, 1),
            ("straight", (1, 2, 0), 1, 0, 6, 20, 3),
            ("turns", (0, 0, 0), 1, eighth, 20 * math.pi, 20, 2),
            ("back", (0, 0, 0), -1, eighth, 20, 20, 2),
        ):
            yield steps_case(kind, n, *numbers)
        for _ in range(12):
            pose, size, n = a_pose(rng), np.round(rng.uniform(2, 30), 1), int(rng.integers(2, 25))
            phi, t = np.round(rng.uniform(0.1, 0.78), 2) * rng.choice([-1, 1]), np.round(rng.uniform(0.5, 4) * size, 1)
            yield steps_case("one", 1, pose, rng.choice([0.5, 2]), phi, t, size)
            yield steps_case("straight", n, pose, rng.choice([0.5, 2]), 0, t, size)
            yield steps_case("turns", n, pose, rng.choice([0.5, 1, 2]), phi, t, size)
            yield steps_case("back", n, pose, -rng.choice([0.5, 1, 2]), phi, t, size)

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """The arc, Euler's steps, and the student's."""
        draw_steps(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def steps_case(kind: str, n: int, *numbers: Any) -> Case:
    """A case of one control in n steps."""
    case = drive_case(kind, *numbers)
    return Case(kind, {**case.given, "n": n})


def orders(h: Array, errors: Array) -> Array:
    """The power with which the error falls, between neighbours: log(e_i / e_i+1) / log(h_i / h_i+1), shape (n - 1,)."""
    h, errors = np.asarray(h, float), np.asarray(errors, float)
    return np.log(errors[:-1] / errors[1:]) / np.log(h[:-1] / h[1:])


class OrderOfError(ValueExercise):
    """From measured errors to the power of the step with which they fall."""

    name = "order_of_error"
    lesson = "12_the_car"
    kinds = ("halves", "steps", "rising", "floor")
    given = Record(h=Numbers(("n",)), errors=Numbers(("n",)))
    answer = Numbers(("k",))
    source = staticmethod(orders)
    slips = (
        Slip("halves", lambda h, e: np.log2(e[:-1] / e[1:])),
        Slip("ratio", lambda h, e: e[:-1] / e[1:]),
        Slip("ratios", lambda h, e: (e[:-1] / e[1:]) / (h[:-1] / h[1:])),
        Slip("upside_down", lambda h, e: 1.0 / orders(h, e)),
        Slip("sign", lambda h, e: -orders(h, e)),
        Slip("one_point", lambda h, e: (np.log(e) / np.log(h))[1:]),
        Slip("one_point", lambda h, e: (np.log(e) / np.log(h))[:-1]),
        Slip("from_first", lambda h, e: np.log(e[0] / e[1:]) / np.log(h[0] / h[1:])),
        Slip("no_log", lambda h, e: np.diff(e) / np.diff(h)),
        Slip("never_negative", lambda h, e: np.maximum(orders(h, e), 0.0)),
        Slip("one_slope", lambda h, e: np.full(len(h) - 1, np.polyfit(np.log(h), np.log(e), 1)[0])),
        Slip("rounded", lambda h, e: np.round(orders(h, e))),
    )
    reference = staticmethod(orders)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Powers of two first; then as measured, with noise."""
        yield order_case("halves", (0.8, 0.4), (0.06, 0.03))
        yield order_case("halves", (0.8, 0.4, 0.2), (0.32, 0.02, 0.00125))
        yield order_case("steps", (0.9, 0.3), (0.9, 0.1))
        yield order_case("rising", (0.1, 0.2, 0.4), (0.01, 0.02, 0.04))
        yield order_case("floor", (0.2, 0.1, 0.05), (0.000001, 0.000001, 0.000004))
        for _ in range(12):
            n, p, c = int(rng.integers(2, 6)), int(rng.integers(1, 5)), rng.uniform(0.1, 20)
            halves = rng.choice([0.2, 0.4, 0.8, 1.6]) / 2.0 ** np.arange(n)
            uneven = np.round(rng.uniform(0.5, 0.9) * np.cumprod(rng.uniform(0.2, 0.8, n)), 4)
            noise = rng.uniform(0.9, 1.1, n)
            yield order_case("halves", halves, c * halves**p * noise)
            yield order_case("steps", uneven, c * uneven**p * noise)
            yield order_case("rising", uneven[::-1], c * uneven[::-1] ** p * noise)
            yield order_case("floor", halves, 1e-12 * rng.uniform(1.1, 2.0, n) ** np.arange(n))

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """The errors against the step, both on scales of powers."""
        draw_orders(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def order_case(kind: str, h: Any, errors: Any) -> Case:
    """A case of steps and their errors."""
    return Case(kind, {"h": np.array(h, float), "errors": np.array([float(f"{e:.4g}") for e in errors])})

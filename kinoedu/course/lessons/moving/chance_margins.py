"""The exercise on chance constraints: a margin for each obstacle.

It uses the union bound and the quantile of the chi-square distribution.
"""

import math
from collections.abc import Callable, Iterator
from statistics import NormalDist

import numpy as np

from ....geometry.checks import Array
from ....worlds.uncertain import chance_margins
from ...exercise import Axes, Case, Change, Slip, ValueExercise
from ...outcomes import Answer, Outcome
from ...shapes import Number, Numbers, Record
from .pictures import draw_margins


def find_radius(share: float) -> float:
    """Return the radius that an offset of standard deviation 1 exceeds with probability `share`."""
    return math.sqrt(-2.0 * math.log(share))


def scale_by(factor: Callable[[int, float], float]) -> Callable[..., Array]:
    """Return a program that multiplies every sigma by factor(m, delta)."""
    return lambda sigma, delta: sigma * factor(len(sigma), delta)


class ChanceMargins(ValueExercise):
    """Compute margins that make the probability of any contact at most delta."""

    name = "chance_margins"
    lesson = "14_moving_and_uncertain"
    kinds = ("one", "several", "unequal", "seldom")
    given = Record(sigma=Numbers(("m",)), delta=Number())
    answer = Numbers(("m",))
    one_for_each = "sigma"
    source = staticmethod(chance_margins)
    slips = (
        Slip("not_shared", scale_by(lambda m, delta: find_radius(delta))),
        Slip("one_axis", scale_by(lambda m, delta: NormalDist().inv_cdf(1 - delta / m / 2))),
        Slip("one_tail", scale_by(lambda m, delta: NormalDist().inv_cdf(1 - delta / m))),
        Slip("one_number", scale_by(lambda m, delta: 1.96)),
        Slip("variance", lambda sigma, delta: sigma**2 * find_radius(delta / len(sigma))),
        Slip("other_tail", scale_by(lambda m, delta: math.sqrt(-2 * math.log(1 - delta / m)))),
        Slip("no_two", scale_by(lambda m, delta: math.sqrt(-math.log(delta / m)))),
        Slip("no_root", scale_by(lambda m, delta: -2 * math.log(delta / m))),
        Slip("log_ten", scale_by(lambda m, delta: math.sqrt(-2 * math.log10(delta / m)))),
        Slip("independent", scale_by(lambda m, delta: find_radius(1 - (1 - delta) ** (1 / m)))),
        Slip(
            "largest",
            lambda sigma, delta: np.full(len(sigma), sigma.max() * find_radius(delta / len(sigma))),
        ),
        Slip(
            "by_sigma",
            lambda sigma, delta: np.array(
                [s * find_radius(delta * s / sigma.sum()) for s in sigma]
            ),
        ),
    )
    reference = staticmethod(chance_margins)
    changes = (
        Change("two_drives", lambda margins, sigma, delta: margins(sigma, delta / 2)),
        Change("percent", lambda margins, sigma, delta: margins(sigma, delta / 100)),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield cases with one obstacle first, then with several."""
        yield make_case("one", [1], 0.05)
        yield make_case("one", [0.3], 0.5)
        yield make_case("several", [1, 1], 0.1)
        yield make_case("unequal", [1, 2], 0.1)
        yield make_case("seldom", [1], 1e-6)
        for _ in range(10):
            m, delta = int(rng.integers(2, 9)), round(float(rng.uniform(0.01, 0.6)), 2)
            s = np.round(rng.uniform(0.05, 2, 8), 2)
            yield make_case("one", s[:1], delta)
            yield make_case("several", np.full(m, s[0]), delta)
            yield make_case("unequal", s[:m], delta)
            yield make_case("seldom", s[:m], 10.0 ** -int(rng.integers(4, 10)))

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw each margin and the student's."""
        draw_margins(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def make_case(kind: str, sigma: object, delta: float) -> Case:
    """Return a case of some obstacles."""
    return Case(kind, {"sigma": np.array(sigma, float), "delta": float(delta)})

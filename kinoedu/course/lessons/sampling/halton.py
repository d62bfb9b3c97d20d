"""The exercise `halton`. Bullo & Smith, chapter 4; LaValle, section 5.2.4."""

from collections.abc import Iterator

import numpy as np

from ....geometry.checks import Array
from ....sampling import halton, van_der_corput
from ...exercise import Axes, Case, Change, Restated, Slip, ValueExercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Listed, Record, Value
from ...whole_shapes import Integer
from .digits import keep_order
from .grids import POINTS, TOLERANCE, find_points_fault, is_nearly, sort_points
from .pictures import draw_points

PRIMES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37)
EARLY = 20  # rows that are right although later ones are not


class Halton(ValueExercise):
    """Compute the first n points of Halton's sequence, from number 1 on."""

    name = "halton"
    lesson = "06_sampling"
    kinds = ("line", "plane", "more", "others")
    given = Record(n=Integer(), primes=Listed(Integer()))
    answer = POINTS
    tolerance = TOLERANCE
    source = staticmethod(halton)
    slips = (
        Slip("from_zero", lambda n, primes: halton(n, primes, start=0)),
        Slip("from_two", lambda n, primes: halton(n, primes, start=2)),
        Slip(
            "one_base",
            lambda n, primes: np.tile(van_der_corput(n, primes[0])[:, None], (1, len(primes))),
        ),
        Slip(
            "own_bases",
            lambda n, primes: np.column_stack(
                [van_der_corput(n, base) for base in range(2, 2 + len(primes))]
            ),
        ),
        Slip("own_primes", lambda n, primes: halton(n, PRIMES[: len(primes)])),
        Slip("sorted", lambda n, primes: halton(n, sorted(primes))),
        Slip("backwards", lambda n, primes: halton(n, primes)[:, ::-1]),
        Slip(
            "forward",
            lambda n, primes: np.array(
                [[keep_order(i, p) for p in primes] for i in range(1, n + 1)]
            ),
        ),
    )
    reference = staticmethod(halton)
    changes = (
        Change("from_ten", lambda points, n, primes: points(n + 9, primes)[9:]),
        Restated("reversed", answer=lambda points, *given: np.asarray(points)[::-1]),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield one prime, two, and more; then other primes in any order.

        The hundred points of the book are among them.
        """
        for n, *primes in (
            (1, 2),
            (3, 2),
            (2, 3),
            (1, 2, 3),
            (4, 2, 3),
            (6, 2, 3),
            (5, 2, 3, 5),
            (3, 3, 2),
            (4, 5, 2),
            (8, 7),
        ):
            yield make_case(n, primes)
        for n, *primes in (
            (100, 2, 3),
            (18, 17),
            (40, 37, 2),
            (20, 41, 19, 101),
            (300, 2),
            (1100, 2, 3),
            (250, 3, 5),
            (30, *PRIMES),
        ):
            yield make_case(n, primes)
        for _ in range(10):
            yield make_case(int(rng.integers(4, 60)), (2,))
            yield make_case(int(rng.integers(4, 60)), (2, 3))
            yield make_case(int(rng.integers(4, 60)), PRIMES[: int(rng.integers(3, 7))])
            primes = rng.permutation(PRIMES)[: int(rng.integers(2, 5))].tolist()
            yield make_case(
                int(rng.integers(4, 60)), primes[::-1] if primes == sorted(primes) else primes
            )

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge the number of points, whether they are in the cube, their order, and where."""
        rule = find_points_fault(value, case.given["n"], len(case.given["primes"]))
        if (
            not rule
            and not self.same(value, self.truth(case))
            and super().same(sort_points(value), sort_points(self.truth(case)))
        ):
            rule = "order"
        if not rule and not self.same(value, self.truth(case)):
            rule = self.find_late_fault(value, self.truth(case))
        return (
            Verdict(0.0, rule, self.describe_expected(case))
            if rule
            else super().value_verdict(case, value)
        )

    def find_late_fault(self, value: Array, truth: Array) -> str:
        """Return the rule that nearly right points, or points after right ones, break, or ""."""
        if is_nearly(value, truth):
            return "rounded"
        return "later" if self.same(value[:EARLY], truth[:EARLY]) else ""

    def same(self, value: Value, truth: Value) -> bool:
        """Whether shapes and points are the same."""
        return np.shape(value) == np.shape(truth) and super().same(value, truth)

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the right points and the student's."""
        draw_points(
            self, case, outcome.value if isinstance(outcome, Answer) else None, self.truth(case), ax
        )


def make_case(n: int, primes: Value) -> Case:
    """Return a case and classify it."""
    first = list(primes) == list(PRIMES[: len(primes)])
    kind = ("line", "plane", "more")[min(len(primes), 3) - 1] if first else "others"
    return Case(kind, {"n": n, "primes": list(primes)})

"""Exercises on van der Corput's and Halton's sequences. Bullo & Smith, chapter 4; LaValle, section 5.2.4."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from ...sampling import halton, van_der_corput
from ...sampling.halton import mirrored
from ..exercise import Case, Slip, ValueExercise, Verdict
from ..outcomes import Answer, Outcome
from ..shapes import Listed, Number, Record
from ..whole_shapes import Whole
from .grids import POINTS, TOLERANCE, fault_of_points, in_order
from .sample_pictures import draw_mirrored, draw_points

PRIMES = (2, 3, 5, 7, 11, 13)
SMALL = [(1, 2), (0, 2), (2, 3), (2, 2), (6, 2), (4, 3), (0, 5), (7, 10), (31, 16), (11, 12), (3, 2), (5, 3), (10, 10), (1000, 2)]
SMALL += [(243, 3), (1000, 10), (10**6, 10)]  # powers of the base, whose logarithm is rounded down


class RadicalInverse(ValueExercise):
    """The digits of a whole number, mirrored at the point."""

    name = "radical_inverse"
    lesson = "06_sampling"
    kinds = ("one_digit", "binary", "other", "long")
    given = Record(i=Whole(), base=Whole())
    answer = Number()
    tolerance = TOLERANCE
    source = staticmethod(van_der_corput)
    shown = staticmethod(mirrored)
    slips = (
        Slip("forward", lambda i, base: unmirrored(i, base)),
        Slip("left", lambda i, base: base * inverse(i, base)),
        Slip("right", lambda i, base: inverse(i, base) / base),
        Slip("whole", lambda i, base: number_of(digits(i, base)[::-1], base)),
        Slip("decimal", lambda i, base: float("0." + "".join(map(str, digits(i, base))))),
        Slip("base_two", lambda i, base: inverse(i, 2)),
        Slip("next", lambda i, base: inverse(i + 1, base)),
        Slip("first_lost", lambda i, base: inverse(number_of(digits(i, base)[:-1], base), base)),
        Slip("last_only", lambda i, base: i % base / base),
        Slip("divided", lambda i, base: divided(i, base)),
    )

    @staticmethod
    def reference(i: int, base: int) -> float:
        """The one number of the sequence."""
        return inverse(i, base)

    def right_answer(self, *given: Any) -> Any:
        """The library has it for many numbers at once."""
        return inverse(*given)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Small numbers in base 2 and 3 first."""
        for i, base in SMALL:
            yield inverse_case(i, base)
        yield inverse_case(10**9 + 7, 7)
        for _ in range(10):
            base = int(rng.integers(3, 17))
            yield inverse_case(int(rng.integers(base)), base)
            yield inverse_case(int(rng.integers(2, 1000)), 2)
            yield inverse_case(int(rng.integers(base, 1000)), base)
            yield inverse_case(int(rng.integers(10**6, 10**12)), int(rng.integers(2, 17)))

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """The digits, and both places between 0 and 1."""
        draw_mirrored(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


class Halton(ValueExercise):
    """The first n points of Halton's sequence, from number 1 on."""

    name = "halton"
    lesson = "06_sampling"
    kinds = ("line", "plane", "more", "others")
    given = Record(n=Whole(), primes=Listed(Whole()))
    answer = POINTS
    tolerance = TOLERANCE
    source = staticmethod(halton)
    slips = (
        Slip("from_zero", lambda n, primes: halton(n, primes, start=0)),
        Slip("from_two", lambda n, primes: halton(n, primes, start=2)),
        Slip("one_base", lambda n, primes: np.tile(van_der_corput(n, primes[0])[:, None], (1, len(primes)))),
        Slip("own_bases", lambda n, primes: np.column_stack([van_der_corput(n, base) for base in range(2, 2 + len(primes))])),
        Slip("own_primes", lambda n, primes: halton(n, PRIMES[: len(primes)])),
        Slip("sorted", lambda n, primes: halton(n, sorted(primes))),
        Slip("backwards", lambda n, primes: halton(n, primes)[:, ::-1]),
        Slip("forward", lambda n, primes: np.array([[unmirrored(i, p) for p in primes] for i in range(1, n + 1)])),
    )
    reference = staticmethod(halton)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """One prime, then two, then more; then primes that are not the first, in any order. All a hundred of the book."""
        for n, *primes in ((1, 2), (3, 2), (2, 3), (1, 2, 3), (4, 2, 3), (6, 2, 3), (5, 2, 3, 5), (3, 3, 2), (4, 5, 2), (8, 7)):
            yield halton_case(n, primes)
        yield halton_case(100, (2, 3))
        for _ in range(10):
            yield halton_case(int(rng.integers(4, 60)), (2,))
            yield halton_case(int(rng.integers(4, 60)), (2, 3))
            yield halton_case(int(rng.integers(4, 60)), PRIMES[: int(rng.integers(3, 7))])
            primes = rng.permutation(PRIMES)[: int(rng.integers(2, 5))].tolist()
            yield halton_case(int(rng.integers(4, 60)), primes[::-1] if primes == sorted(primes) else primes)

    def value_verdict(self, case: Case, value: Any) -> Verdict:
        """How many, whether they are in the cube, whether in another order, then where."""
        rule = fault_of_points(value, case.given["n"], len(case.given["primes"]))
        if not rule and not self.same(value, self.truth(case)) and super().same(in_order(value), in_order(self.truth(case))):
            rule = "order"
        return Verdict(0.0, rule, self.wanted(case)) if rule else super().value_verdict(case, value)

    def same(self, value: Any, truth: Any) -> bool:
        """Shapes count too."""
        return np.shape(value) == np.shape(truth) and super().same(value, truth)

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """The points that should be there, and the student's."""
        draw_points(self, case, outcome.value if isinstance(outcome, Answer) else None, self.truth(case), ax)


def inverse_case(i: int, base: int) -> Case:
    """A case of the kind that it is."""
    kind = "one_digit" if i < base else "long" if i >= 10**6 else "binary" if base == 2 else "other"
    return Case(kind, {"i": i, "base": base})


def halton_case(n: int, primes: Any) -> Case:
    """A case of the kind that it is."""
    first = list(primes) == list(PRIMES[: len(primes)])
    kind = ("line", "plane", "more")[min(len(primes), 3) - 1] if first else "others"
    return Case(kind, {"n": n, "primes": list(primes)})


def inverse(i: int, base: int) -> float:
    """Number i of van der Corput's sequence."""
    return float(van_der_corput(1, base, start=i)[0])


def digits(i: int, base: int) -> list[int]:
    """The digits of a whole number, the last one first; those of 0 are [0].

    >>> digits(6, 2)
    [0, 1, 1]
    """
    found = [i % base]
    while i := i // base:
        found.append(i % base)
    return found


def number_of(low_first: list[int], base: int) -> int:
    """The whole number of these digits, the last one first."""
    return sum(digit * base**place for place, digit in enumerate(low_first))


def unmirrored(i: int, base: int) -> float:
    """The digits behind the point in the order in which they stand."""
    return i / float(base) ** len(digits(i, base))


def divided(i: float, base: int) -> float:
    """The sum, where i is divided without dropping what is left over."""
    total, weight = 0.0, 1.0
    while i > 0.0 and weight > 0.0:
        weight /= base
        total += i % base * weight
        i /= base
    return total

"""The exercise `radical_inverse`. Bullo & Smith, chapter 4; LaValle, section 5.2.4."""

from collections.abc import Iterator

import numpy as np

from ....sampling import van_der_corput
from ....sampling.halton import reverse_digits
from ...exercise import Axes, Case, Slip, ValueExercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Number, Record, Value
from ...whole_shapes import Integer
from ...withheld import withheld
from .digits import find_digits, keep_order
from .grids import TOLERANCE, is_nearly
from .pictures import draw_mirrored

SMALL = [
    (1, 2),
    (0, 2),
    (2, 3),
    (2, 2),
    (6, 2),
    (4, 3),
    (0, 5),
    (7, 10),
    (31, 16),
    (11, 12),
    (3, 2),
    (5, 3),
    (10, 10),
    (1000, 2),
]


SMALL += [
    (243, 3),
    (1000, 10),
    (10**6, 10),
]  # powers of the base, whose logarithms are rounded down


class RadicalInverse(ValueExercise):
    """Mirror the digits of a whole number at the point."""

    name = "radical_inverse"
    lesson = "06_sampling"
    kinds = ("one_digit", "binary", "other", "long")
    given = Record(i=Integer(), base=Integer())
    answer = Number()
    tolerance = TOLERANCE
    source = staticmethod(van_der_corput)
    shown = staticmethod(reverse_digits)
    slips = (
        Slip("forward", lambda i, base: keep_order(i, base)),
        Slip("left", lambda i, base: base * find_inverse(i, base)),
        Slip("right", lambda i, base: find_inverse(i, base) / base),
        Slip("whole", lambda i, base: join_digits(find_digits(i, base)[::-1], base)),
        Slip("decimal", lambda i, base: float("0." + "".join(map(str, find_digits(i, base))))),
        Slip("base_two", lambda i, base: find_inverse(i, 2)),
        Slip("next", lambda i, base: find_inverse(i + 1, base)),
        Slip(
            "first_lost",
            lambda i, base: find_inverse(join_digits(find_digits(i, base)[:-1], base), base),
        ),
        Slip("first_lost", lambda i, base: lose_first_of_powers(i, base)),
        Slip("last_only", lambda i, base: i % base / base),
        Slip("divided", lambda i, base: divide_inexactly(i, base)),
    )

    @staticmethod
    @withheld
    def reference(i: int, base: int) -> float:
        """Return the number of van der Corput's sequence."""
        return find_inverse(i, base)

    def right_answer(self, *given: Value) -> Value:
        """Return the reference: the library computes many numbers at once."""
        return self.reference(*given)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield small numbers in base 2 and 3 first, then others."""
        for i, base in SMALL:
            yield make_case(i, base)
        yield make_case(10**9 + 7, 7)
        for _ in range(10):
            base = int(rng.integers(3, 17))
            yield make_case(int(rng.integers(base)), base)
            yield make_case(int(rng.integers(2, 1000)), 2)
            yield make_case(int(rng.integers(base, 1000)), base)
            yield make_case(int(rng.integers(10**6, 10**12)), int(rng.integers(2, 17)))

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Compare a number with the right one; one that is nearly right breaks another rule."""
        verdict = super().value_verdict(case, value)
        is_rounded = not verdict.is_right and is_nearly(value, self.truth(case))
        return verdict._replace(rule="rounded") if is_rounded else verdict

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the digits, and the right and the student's number between 0 and 1."""
        draw_mirrored(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def make_case(i: int, base: int) -> Case:
    """Return a case and classify it."""
    kind = "one_digit" if i < base else "long" if i >= 10**6 else "binary" if base == 2 else "other"
    return Case(kind, {"i": i, "base": base})


def find_inverse(i: int, base: int) -> float:
    """Return number i of van der Corput's sequence."""
    return float(van_der_corput(1, base, start=i)[0])


def join_digits(low_first: list[int], base: int) -> int:
    """Return the whole number with these digits, lowest first."""
    return sum(digit * base**place for place, digit in enumerate(low_first))


def lose_first_of_powers(i: int, base: int) -> float:
    """Return the inverse of the last digits of i, as many as the logarithm rounded up."""
    count = 1
    while base**count < i:
        count += 1
    return find_inverse(i % base**count, base)


def divide_inexactly(i: float, base: int) -> float:
    """Return the sum that results when i is divided with / instead of //."""
    total, weight = 0.0, 1.0
    while i > 0.0 and weight > 0.0:
        weight /= base
        total += i % base * weight
        i /= base
    return total

"""The base class of the exercises on grids in the unit cube. Bullo & Smith, chapter 4."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from ....geometry.checks import Array
from ....sampling.grids import integer_root, lattice, points_per_side
from ...exercise import Axes, Case, ValueExercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Numbers, Record, Value
from ...sizes import MOST_NUMBERS
from ...whole_shapes import Integer
from .pictures import draw_points

POINTS = Numbers(("n", "d"))
TOLERANCE = 1e-9
NEARLY = 0.006  # an answer that is wrong by less may have been rounded to two digits
DIMENSIONS = {1: "line", 2: "plane", 3: "space"}
GRIDS = tuple(DIMENSIONS.values())
SMALL = [
    (2, 1),
    (4, 2),
    (3, 1),
    (1, 1),
    (1, 2),
    (9, 2),
    (5, 1),
    (2, 2),
    (8, 3),
    (8, 2),
    (100, 2),
    (1, 3),
    (27, 3),
    (4, 3),
    (64, 3),
]


SMALL += [(125, 3), (99, 2), (100, 3)]
LARGE = [(51, 1), (101, 2), (2501, 2), (3600, 2), (6858, 3), (6860, 3), (5000, 1), (4096, 3)]
LARGE += [(49, 1), (107, 1), (2401, 2)]  # steps of 1 / k add up to a little less than 1


class GridExercise(ValueExercise):
    """An exercise on a grid of n = k^d points, in any order.

    Where n is no such power, a ValueError is the right answer.
    """

    lesson = "06_sampling"
    kinds = ("line", "plane", "space", "power")
    given = Record(n=Integer(), d=Integer())
    answer = POINTS
    tolerance = TOLERANCE

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield few points first, then other powers, and numbers that are not powers."""
        for n, d in SMALL:
            yield make_case(n, d)
        for n, d in LARGE:
            yield make_case(n, d)
        for _ in range(10):
            for d, most in ((1, 30), (2, 12), (3, 5)):
                yield make_case(int(rng.integers(2, most + 1)) ** d, d)
            d, n = int(rng.integers(2, 4)), int(rng.integers(2, 200))
            while integer_root(n, d) ** d == n:
                n = int(rng.integers(2, 200))
            yield make_case(n, d)

    def size_limit(self, case: Case) -> int:
        """Return twice the numbers of a right answer, or the usual limit if that is more."""
        return max(MOST_NUMBERS, 2 * case.given["n"] * case.given["d"])

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge the number of points, whether they are in the cube, and where."""
        verdict = self.fault_of_points(case, value) or super().value_verdict(case, value)
        is_rounded = verdict.rule in GRIDS and is_nearly(
            sort_points(np.round(value, 2)), sort_points(np.round(self.truth(case), 2))
        )
        return verdict._replace(rule="rounded") if is_rounded else verdict

    def fault_of_points(self, case: Case, value: Array) -> Verdict | None:
        """Return the verdict on points of a wrong number or outside the cube, or None."""
        rule = find_points_fault(value, case.given["n"], case.given["d"])
        return Verdict(0.0, rule, self.describe_expected(case)) if rule else None

    def same(self, value: Value, truth: Value) -> bool:
        """Whether both are the same set of points."""
        return np.shape(value) == np.shape(truth) and super().same(
            sort_points(value), sort_points(truth)
        )

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the right points and the student's."""
        found, truth = outcome.value if isinstance(outcome, Answer) else None, self.truth(case)
        no_grid, (n, d) = isinstance(truth, ValueError), case.given.values()
        cells = 0 if no_grid or d == 1 else integer_root(n, d)
        draw_points(self, case, found, None if no_grid else truth, ax, cells=cells)


def make_case(n: int, d: int) -> Case:
    """Return a case and classify it."""
    kind = DIMENSIONS[d] if integer_root(n, d) ** d == n else "power"
    return Case(kind, {"n": n, "d": d})


def find_points_fault(points: Array, n: int, d: int) -> str:
    """Return the rule that n points of the closed unit cube break, or ""."""
    if points.shape != (n, d):
        return "count"
    return "" if ((points >= -TOLERANCE) & (points <= 1.0 + TOLERANCE)).all() else "outside"


def is_nearly(value: object, truth: object) -> bool:
    """Whether all numbers of an answer, as many as are right, are nearly right."""
    off = np.asarray(value, float) - np.asarray(truth, float)
    return bool((np.abs(off) < NEARLY).all())


def sort_points(points: object) -> Array:
    """Return the points sorted by their rounded coordinates."""
    rows = np.asarray(points, float)
    return rows[np.lexsort(np.round(rows, 9).T[::-1])]


def make_grid(n: int, d: int, place: Callable[[Any, int], Any]) -> Array:
    """Return a grid whose coordinates are place(i, k) for i = 0, ..., k - 1."""
    k = points_per_side(n, d)
    return lattice(place(np.arange(k), k), d)


def make_diagonal(n: int, d: int, place: Callable[[Any, int], Any], each: int = 0) -> Array:
    """Return the points of a grid whose coordinates are all equal.

    Parameters
    ----------
    each : number of points; k by default.
    """
    k = points_per_side(n, d)
    return np.tile(place(np.arange(each or k), k)[:, None], (1, d))

"""The exercise `neighbours`. Bullo & Smith, chapter 2."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ....decomposition.cells import share_walls
from ....geometry.checks import Array
from ...exercise import RIGHT, Axes, Case, Restated, Slip, ValueExercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Record, Value
from ...whole_shapes import Integers
from ...withheld import withheld
from ..shared.random_shapes import sizes
from ..shared.random_worlds import room_in
from .cells import CELLS, cells_of
from .pictures import draw_pairs, set_title
from .slips import (
    equal_walls,
    left_cell_first,
    left_walls,
    nearly,
    nested_walls,
    only_later,
    right_walls,
    touching,
    touching_in_a_point,
)

THIN_PLATE = np.array(  # attached to the ceiling
    [(0, 1000, 0, 900, 0, 900), (1000, 1000.001, 0, 300, 0, 300), (1000.001, 2000, 0, 900, 0, 900)]
)
TWO_TIPS = np.array([(0, 4, 0, 0, -2, 2), (4, 8, -2, 2, 4, 4)], float)  # of a triangle


UPSIDE_DOWN, FLIPPED = [0, 1, 3, 2, 5, 4], np.array([1, 1, -1, -1, -1, -1])


@withheld
def neighbouring(trapezoids: Array) -> NDArray[np.int64]:
    """Pairs (i, j), i < j, of trapezoids that share a wall of positive length, (m, 2)."""
    return touching(trapezoids)


def put_left_first(pairs: Value, trapezoids: Array) -> Value:
    """Return pairs with the left trapezoid first."""
    return [(i, j) if trapezoids[i, 1] == trapezoids[j, 0] else (j, i) for i, j in pairs]


def put_smaller_first(pairs: Value, trapezoids: Array) -> Value:
    """Return pairs with the smaller index first, or last where the right trapezoid was first."""
    rows = np.reshape(pairs, (-1, 2)).astype(np.int64)
    n, found = len(trapezoids), np.sort(rows, axis=1).tolist()
    for row, (i, j) in enumerate(rows.tolist()):
        if 0 <= min(i, j) and max(i, j) < n and trapezoids[j, 1] == trapezoids[i, 0]:
            found[row].reverse()
    return np.array(found, np.int64).reshape(-1, 2)


class Neighbours(ValueExercise):
    """The pairs of trapezoids that share a wall of positive length."""

    name = "neighbours"
    lesson = "03_decomposition"
    kinds = ("side", "apart", "point", "world")
    given = Record(trapezoids=CELLS)
    answer = Integers(("m", 2))
    source = staticmethod(neighbouring)
    shown = staticmethod(share_walls)
    slips = (
        Slip("point", touching_in_a_point),
        Slip(
            "same_x",
            lambda trapezoids: np.sort(
                np.argwhere(trapezoids[:, None, 1] == trapezoids[:, 0]), axis=1
            ),
        ),
        Slip("same_x", lambda trapezoids: np.argwhere(trapezoids[:, None, 1] == trapezoids[:, 0])),
        Slip("left_wall", left_walls),
        Slip("right_wall", right_walls),
        Slip("reversed", lambda trapezoids: touching(trapezoids)[:, ::-1]),
        Slip(
            "twice",
            lambda trapezoids: np.vstack([touching(trapezoids), touching(trapezoids)[:, ::-1]]),
        ),
        Slip("left_first", left_cell_first),
        Slip("only_later", only_later),
        Slip("nearly", nearly),
        Slip(
            "in_a_row",
            lambda trapezoids: np.column_stack(
                [np.arange(len(trapezoids) - 1), np.arange(1, len(trapezoids))]
            ),
        ),
        Slip("whole_wall", equal_walls),
        Slip("nested", nested_walls),
    )
    reference = staticmethod(neighbouring)

    changes = (
        Restated("left_first", answer=put_left_first, usual_answer=put_smaller_first),
        Restated(
            "larger_first", answer=lambda pairs, trapezoids: np.reshape(pairs, (-1, 2))[:, ::-1]
        ),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Two or three trapezoids first, then all of a world in random order."""
        one, next_to = [0, 2, 0, 4, 0, 4], [2, 5, 1, 3, 0, 4]
        yield Case("side", {"trapezoids": np.array([one, next_to], float)})
        yield Case("side", {"trapezoids": np.array([next_to, one], float)})
        yield Case("side", {"trapezoids": np.array([one, [2, 5, 3, 7, 3, 7]], float)})
        two_beside = [one, [2, 5, 0, 1, 0, 1], [2, 5, 3, 4, 3, 4]]
        yield Case("side", {"trapezoids": np.array(two_beside, float)})
        yield Case("apart", {"trapezoids": np.array([one, [2, 5, 6, 8, 6, 7]], float)})
        three = [[0, 2, 0, 4, 0, 2], [2, 5, 3, 6, 3, 6], [2, 4, 0, 2, 1, 2]]
        yield Case("apart", {"trapezoids": np.array(three, float)})
        yield Case("point", {"trapezoids": np.array([one, [2, 5, 4, 7, 3, 7]], float)})
        yield Case("point", {"trapezoids": np.array([one, [2, 5, 4, 7, 3, 7], next_to], float)})
        short = [one, [2, 5, 3.99999999, 7, 3, 7], [-3, 0, 1, 3, 2, 6]]
        yield Case("side", {"trapezoids": np.array(short, float)})
        tip = [2, 5, 1, 1, 0, 4]
        yield Case("point", {"trapezoids": np.array([one, tip], float)})
        yield Case("point", {"trapezoids": np.array([mirrored(tip, 4), mirrored(one, 4)], float)})
        yield Case("point", {"trapezoids": np.array([tip, mirrored(tip, 4)], float)})
        yield Case("world", {"trapezoids": THIN_PLATE})
        yield Case("world", {"trapezoids": TWO_TIPS})
        for i, size in enumerate(sizes(4)):
            low, high, far = np.sort(rng.choice(np.arange(1, 60), 3, replace=False)) * size / 100
            left = np.array([[-size, 0, -low, high / 3, low, high]])
            for kind, floor, ceiling in (
                ("side", (low + high) / 2, far),
                ("apart", high + 1, far + 2),
                ("point", high, far),
                ("point", (low + high) / 2, (low + high) / 2),
                ("side", high - 0.001, far),
            ):
                right = np.array([[0, size, floor, ceiling, floor, floor + 1]])
                both = np.round(np.vstack([left, right]), 3)
                both = both[:, UPSIDE_DOWN] * FLIPPED if i % 2 else both
                both = np.array([mirrored(cell, 0) for cell in both]) if i % 4 > 1 else both
                yield Case(kind, {"trapezoids": rng.permutation(both + 0.0)})
            yield Case("world", {"trapezoids": rng.permutation(box_world(rng, size))})

    def same(self, value: object, truth: object) -> bool:
        """Compare pairs in any order, each once."""
        found, wanted = (
            sorted(map(tuple, np.asarray(array, float).reshape(-1, 2).tolist()))
            for array in (value, truth)
        )
        return found == wanted

    def value_verdict(self, case: Case, value: object) -> Verdict:
        """Check that they are pairs i < j, each once; then that they are the right ones."""
        if self.same(value, self.truth(case)):
            return RIGHT
        pairs, n = np.asarray(value), len(case.given["trapezoids"])
        proper = (
            np.isin(pairs, np.arange(n)).all()
            and (pairs[:, 0] < pairs[:, 1]).all()
            and len(np.unique(pairs, axis=0)) == len(pairs)
        )
        return Verdict(0.0, case.kind if proper else "pairs", self.describe_expected(case))

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the numbered trapezoids, the common walls, and the student's pairs."""
        value = outcome.value if isinstance(outcome, Answer) else None
        draw_pairs(case.given["trapezoids"], self.truth(case), value, ax)
        set_title(self, case, ax)


def mirrored(cell: ArrayLike, x: float) -> list[float]:
    """Reflect a trapezoid left to right, so that x, twice the middle, moves to 0 and 0 to x."""
    x0, x1, *heights = np.asarray(cell, float).tolist()
    return [x - x1, x - x0, *heights[2:], *heights[:2]]


def box_world(rng: np.random.Generator, size: float) -> Array:
    """Cells of a hall with triangles and boxes on a lattice, many of which share an x."""
    unit, holes = size / 8, list[Array]()
    hall = np.array([(0, 0), (16, 0), (16, 10), (0, 10)], float)
    room = room_in(hall)
    while len(holes) < 4:
        at, wide, high = rng.integers(1, 12, 2), int(rng.integers(1, 4)), int(rng.integers(1, 4))
        hole = np.array([(0, 0), (wide, 0), (wide, high), (0, high)], float)[
            : int(rng.integers(3, 5))
        ] + at.astype(float)
        holes += [hole] if room.fits(hole, holes) else []
    return cells_of(unit * hall, [unit * hole for hole in holes])

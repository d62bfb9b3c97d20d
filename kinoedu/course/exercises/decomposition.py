"""Exercises on cells: the trapezoids of a world, and who is whose neighbour. Bullo & Smith, chapter 2."""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...decomposition import trapezoidation
from ...decomposition.cells import settle, share_walls
from ...geometry.checks import Array
from ...worlds import PolygonWorld
from ..exercise import RIGHT, Case, Slip, ValueExercise, Verdict
from ..outcomes import Answer, Outcome
from ..shapes import Listed, Numbers, Record
from ..whole_shapes import WholeNumbers
from .cell_slips import (
    left_first,
    merged,
    nearly,
    nested_walls,
    only_later,
    slabs,
    touching,
    whole_walls,
    without_last,
    without_triangles,
)
from .chance import sizes
from .decomposition_pictures import draw_cells, draw_pairs, titled
from .sweeping import BAY, KITE, RING, WEDGE
from .worlds_by_chance import general_world, has_room

CELLS = Numbers(("n", 6))
THIN_PLATE = np.array(  # it hangs from the ceiling
    [(0, 1000, 0, 900, 0, 900), (1000, 1000.005, 0, 300, 0, 300), (1000.005, 2000, 0, 900, 0, 900)]
)


def cells_of(boundary: Array, obstacles: list[Array]) -> Array:
    """The trapezoids of a world, (n, 6)."""
    return trapezoidation(PolygonWorld(boundary, obstacles)).trapezoids


class TrapezoidsOfWorld(ValueExercise):
    """All trapezoids of a world in general position, in any order."""

    name = "trapezoidation"
    lesson = "03_decomposition"
    kinds = ("convex", "bays", "one", "several")
    given = Record(boundary=RING, obstacles=Listed(RING))
    answer = CELLS
    source = staticmethod(cells_of)
    shown = staticmethod(settle)
    slips = (
        Slip("slabs", slabs),
        Slip("hollow", lambda boundary, obstacles: merged(boundary, obstacles, hollow=True)),
        Slip("last", lambda boundary, obstacles: without_last(cells_of(boundary, obstacles))),
        Slip("columns", lambda boundary, obstacles: cells_of(boundary, obstacles)[:, [0, 1, 2, 4, 3, 5]]),
        Slip("columns", lambda boundary, obstacles: cells_of(boundary, obstacles)[:, [0, 1, 3, 2, 5, 4]]),
        Slip("columns", lambda boundary, obstacles: cells_of(boundary, obstacles)[:, [0, 2, 3, 1, 4, 5]]),
        Slip("no_obstacles", lambda boundary, obstacles: cells_of(boundary, [])),
        Slip("rectangles", lambda boundary, obstacles: cells_of(boundary, obstacles)[:, [0, 1, 2, 3, 2, 3]]),
        Slip("no_triangles", lambda boundary, obstacles: without_triangles(cells_of(boundary, obstacles))),
    )
    reference = staticmethod(cells_of)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Squared paper first; every world also mirrored, so that each type of vertex comes."""
        bay = {"boundary": BAY, "obstacles": []}
        for kind, world in (
            ("convex", {"boundary": np.array([(0, 0), (4, -2), (8, 4)], float), "obstacles": []}),
            ("convex", {"boundary": KITE, "obstacles": []}),
            ("bays", bay),
            ("bays", mirrored(bay)),
            ("one", {"boundary": KITE, "obstacles": [WEDGE]}),
            ("one", mirrored({"boundary": KITE, "obstacles": [WEDGE]})),
        ):
            yield Case(kind, world)
        for size in sizes(3):
            for kind, number in (("convex", 0), ("bays", 0), ("one", 1), ("several", int(rng.integers(2, 6)))):
                yield Case(kind, general_world(rng, number, size, convex=kind == "convex"))

    def same(self, value: Any, truth: Any) -> bool:
        """Whether two arrays have the same rows, in any order, but for rounding."""
        found, wanted = (np.asarray(array, float).reshape(-1, 6) for array in (value, truth))
        return len(found) == len(wanted) and bool((matches(found, wanted, self.tolerance).sum(axis=0) == 1).all())

    def value_verdict(self, case: Case, value: Any) -> Verdict:
        """The same rows; where not, whether walls are upside down or a row is no trapezoid at all."""
        if self.same(value, self.truth(case)):
            return RIGHT
        if len(value) and not (np.isfinite(value).all() and (value[:, 0] < value[:, 1]).all() and is_upright(value)):
            return Verdict(0.0, "row", self.wanted(case))
        return Verdict(0.0, case.kind, self.wanted(case))

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """The true cells pale, the student's dashed."""
        draw_cells(case.given, self.truth(case), outcome.value if isinstance(outcome, Answer) else None, ax)
        titled(self, case, ax)


def is_upright(cells: Array) -> bool:
    """Whether no floor is above its ceiling."""
    return bool((cells[:, 2] <= cells[:, 3] + 1e-9).all() and (cells[:, 4] <= cells[:, 5] + 1e-9).all())


def matches(found: Array, wanted: Array, tolerance: float) -> NDArray[np.bool_]:
    """Which rows equal which but for rounding, (found, wanted)."""
    apart = np.abs(found[:, None] - wanted[None])
    near: NDArray[np.bool_] = apart <= tolerance * (1.0 + np.abs(wanted))[None]
    return np.all(near, axis=2)


def mirrored(world: dict[str, Any]) -> dict[str, Any]:
    """A world with left and right exchanged, counter-clockwise again."""
    boundary, *obstacles = [(ring * [-1, 1])[::-1] + 0.0 for ring in (world["boundary"], *world["obstacles"])]
    return {"boundary": boundary, "obstacles": obstacles}


def neighbouring(trapezoids: Array) -> NDArray[np.int64]:
    """The pairs (i, j), i < j, of trapezoids that share a wall of positive length, (m, 2)."""
    return touching(trapezoids)


class Neighbours(ValueExercise):
    """The pairs of trapezoids that share a wall of positive length."""

    name = "neighbours"
    lesson = "03_decomposition"
    kinds = ("side", "apart", "point", "world")
    given = Record(trapezoids=CELLS)
    answer = WholeNumbers(("m", 2))
    source = staticmethod(neighbouring)
    shown = staticmethod(share_walls)
    slips = (
        Slip("point", lambda trapezoids: touching(trapezoids, point=True)),
        Slip("same_x", lambda trapezoids: np.sort(np.argwhere(trapezoids[:, None, 1] == trapezoids[:, 0]), axis=1)),
        Slip("same_x", lambda trapezoids: np.argwhere(trapezoids[:, None, 1] == trapezoids[:, 0])),
        Slip("left_wall", lambda trapezoids: touching(trapezoids, low=2, high=3)),
        Slip("reversed", lambda trapezoids: touching(trapezoids)[:, ::-1]),
        Slip("twice", lambda trapezoids: np.vstack([touching(trapezoids), touching(trapezoids)[:, ::-1]])),
        Slip("left_first", left_first),
        Slip("only_later", only_later),
        Slip("nearly", nearly),
        Slip("in_a_row", lambda trapezoids: np.column_stack([np.arange(len(trapezoids) - 1), np.arange(1, len(trapezoids))])),
        Slip("whole_wall", whole_walls),
        Slip("nested", nested_walls),
    )
    reference = staticmethod(neighbouring)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Two or three trapezoids first; then all of a world, in an order by chance."""
        one, next_to = [0, 2, 0, 4, 0, 4], [2, 5, 1, 3, 0, 4]
        yield Case("side", {"trapezoids": np.array([one, next_to], float)})
        yield Case("side", {"trapezoids": np.array([next_to, one], float)})
        yield Case("side", {"trapezoids": np.array([one, [2, 5, 3, 7, 3, 7]], float)})
        yield Case("apart", {"trapezoids": np.array([one, [2, 5, 6, 8, 6, 7]], float)})
        yield Case("apart", {"trapezoids": np.array([[0, 2, 0, 4, 0, 2], [2, 5, 3, 6, 3, 6], [2, 4, 0, 2, 1, 2]], float)})
        yield Case("point", {"trapezoids": np.array([one, [2, 5, 4, 7, 3, 7]], float)})
        yield Case("point", {"trapezoids": np.array([one, [2, 5, 4, 7, 3, 7], next_to], float)})
        yield Case("world", {"trapezoids": THIN_PLATE})
        for size in sizes(4):
            low, high, far = np.sort(rng.choice(np.arange(1, 60), 3, replace=False)) * size / 100
            left = np.array([[-size, 0, -low, high / 3, low, high]])
            for kind, floor, ceiling in (("side", (low + high) / 2, far), ("apart", high + 1, far + 2), ("point", high, far)):
                right = np.array([[0, size, floor, ceiling, floor, floor + 1]])
                yield Case(kind, {"trapezoids": rng.permutation(np.round(np.vstack([left, right]), 3))})
            yield Case("world", {"trapezoids": rng.permutation(box_world(rng, size))})

    def same(self, value: Any, truth: Any) -> bool:
        """Whether the same pairs are there, each once, in any order."""
        found, wanted = (sorted(map(tuple, np.asarray(array, float).reshape(-1, 2).tolist())) for array in (value, truth))
        return found == wanted

    def value_verdict(self, case: Case, value: Any) -> Verdict:
        """First whether they are pairs i < j, each once; then whether they are the right ones."""
        if self.same(value, self.truth(case)):
            return RIGHT
        pairs, n = np.asarray(value), len(case.given["trapezoids"])
        proper = (
            np.isin(pairs, np.arange(n)).all() and (pairs[:, 0] < pairs[:, 1]).all() and len(np.unique(pairs, axis=0)) == len(pairs)
        )
        return Verdict(0.0, case.kind if proper else "pairs", self.wanted(case))

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """The trapezoids with their numbers, the walls that are shared, and the pairs that the student joined."""
        draw_pairs(case.given["trapezoids"], self.truth(case), outcome.value if isinstance(outcome, Answer) else None, ax)
        titled(self, case, ax)


def box_world(rng: np.random.Generator, size: float) -> Array:
    """The cells of a hall with triangles and boxes on a lattice: many share an x."""
    unit, holes = size / 8, list[Array]()
    hall = np.array([(0, 0), (16, 0), (16, 10), (0, 10)], float)
    while len(holes) < 4:
        at, wide, high = rng.integers(1, 12, 2), int(rng.integers(1, 4)), int(rng.integers(1, 4))
        hole = np.array([(0, 0), (wide, 0), (wide, high), (0, high)], float)[: int(rng.integers(3, 5))] + at.astype(float)
        holes += [hole] if has_room(hole, hall, holes) else []
    return cells_of(unit * hall, [unit * hole for hole in holes])

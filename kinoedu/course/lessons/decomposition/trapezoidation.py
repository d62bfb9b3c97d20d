"""The exercise `trapezoidation`. Bullo & Smith, chapter 2."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from ....decomposition.cells import replace_cells
from ....geometry.checks import Array
from ...exercise import RIGHT, Axes, Case, Given, Restated, Slip, ValueExercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Listed, Record, Value
from ..shared.random_shapes import sizes
from ..shared.random_worlds import general_world, is_general
from .cells import CELLS, cells_of
from .free_intervals import BAY, KITE, RING, WEDGE
from .pictures import draw_cells, set_title
from .slips import hollow, slabs, without_last, without_triangles

# low cells, one of them very narrow, and numbers of many digits
LOW = np.array([(0, 0), (4.00012345, -0.01), (8, 0.02), (4.00091234, 0.015)], float)
# two vertices at nearly the same x
CLOSE = np.array([(0, 0), (4, -1), (8, 2), (4 + 2.0**-28, 3)], float)
HEIGHTS = [0, 1, 2, 4, 3, 5]  # the columns, both floors before both ceilings


class TrapezoidsOfWorld(ValueExercise):
    """All trapezoids of a world in general position, in any order."""

    name = "trapezoidation"
    lesson = "03_decomposition"
    kinds = ("convex", "bays", "one", "several")
    given = Record(boundary=RING, obstacles=Listed(RING))
    answer = CELLS
    source = staticmethod(cells_of)
    shown = staticmethod(replace_cells)
    slips = (
        Slip("slabs", slabs),
        Slip("hollow", hollow),
        Slip("last", lambda *world: without_last(cells_of(*world))),
        Slip("columns", lambda *world: cells_of(*world)[:, [0, 1, 2, 4, 3, 5]]),
        Slip("columns", lambda *world: cells_of(*world)[:, [0, 1, 3, 2, 5, 4]]),
        Slip("columns", lambda *world: cells_of(*world)[:, [0, 2, 3, 1, 4, 5]]),
        Slip("no_obstacles", lambda boundary, obstacles: cells_of(boundary, [])),
        Slip("rectangles", lambda *world: cells_of(*world)[:, [0, 1, 2, 3, 2, 3]]),
        Slip("no_triangles", lambda *world: without_triangles(cells_of(*world))),
    )
    reference = staticmethod(cells_of)

    changes = (
        Restated("level", given=lambda boundary, obstacles: swap_axes(boundary, obstacles)),
        Restated("heights", answer=lambda rows, *given: np.reshape(rows, (-1, 6))[:, HEIGHTS]),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Squared paper first; every world also mirrored, so that each type of vertex occurs."""
        bay = {"boundary": BAY, "obstacles": []}
        for kind, world in (
            ("convex", {"boundary": np.array([(0, 0), (4, -2), (8, 4)], float), "obstacles": []}),
            ("convex", {"boundary": KITE, "obstacles": []}),
            ("convex", {"boundary": LOW, "obstacles": []}),
            ("convex", {"boundary": CLOSE, "obstacles": []}),
            ("bays", bay),
            ("bays", mirrored(bay)),
            ("one", {"boundary": KITE, "obstacles": [WEDGE]}),
            ("one", mirrored({"boundary": KITE, "obstacles": [WEDGE]})),
        ):
            yield Case(kind, world)
        for size in sizes(3):
            for kind, number in (
                ("convex", 0),
                ("bays", 0),
                ("one", 1),
                ("several", int(rng.integers(2, 6))),
            ):
                yield Case(kind, draw_world(rng, number, size, convex=kind == "convex"))

    def same(self, value: object, truth: object) -> bool:
        """Compare rows up to order and rounding."""
        found, wanted = (np.asarray(array, float).reshape(-1, 6) for array in (value, truth))
        return len(found) == len(wanted) and bool(
            (matches(found, wanted, self.tolerance).sum(axis=0) == 1).all()
        )

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Compare the rows; otherwise find whether a row is not a trapezoid at all."""
        if self.same(value, self.truth(case)):
            return RIGHT
        if len(value) and not (
            np.isfinite(value).all() and (value[:, 0] < value[:, 1]).all() and is_upright(value)
        ):
            return Verdict(0.0, "row", self.describe_expected(case))
        return Verdict(0.0, case.kind, self.describe_expected(case))

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the true cells pale, the student's dashed."""
        draw_cells(
            case.given, self.truth(case), outcome.value if isinstance(outcome, Answer) else None, ax
        )
        set_title(self, case, ax)


def is_upright(cells: Array) -> bool:
    """Whether no floor is above its ceiling."""
    return bool(
        (cells[:, 2] <= cells[:, 3] + 1e-9).all() and (cells[:, 4] <= cells[:, 5] + 1e-9).all()
    )


def matches(found: Array, wanted: Array, tolerance: float) -> NDArray[np.bool_]:
    """Which rows equal which up to rounding, (found, wanted)."""
    apart = np.abs(found[:, None] - wanted[None])
    near: NDArray[np.bool_] = apart <= tolerance * (1.0 + np.abs(wanted))[None]
    return np.all(near, axis=2)


def draw_world(rng: np.random.Generator, obstacles: int, size: float, *, convex: bool) -> Given:
    """A world in general position, also with x and y exchanged: the level form needs that."""
    while True:
        world = general_world(rng, obstacles, size, convex=convex)
        boundary, holes = swap_axes(**world)
        if is_general([boundary, *holes]):
            return world


def swap_axes(boundary: Array, obstacles: list[Array]) -> tuple[Array, list[Array]]:
    """Exchange x and y of a world, and keep its rings counter-clockwise."""
    return boundary[::-1, ::-1].copy(), [ring[::-1, ::-1].copy() for ring in obstacles]


def mirrored(world: Given) -> Given:
    """Reflect a world left to right, and keep it counter-clockwise."""
    boundary, *obstacles = [
        (ring * [-1, 1])[::-1] + 0.0 for ring in (world["boundary"], *world["obstacles"])
    ]
    return {"boundary": boundary, "obstacles": obstacles}

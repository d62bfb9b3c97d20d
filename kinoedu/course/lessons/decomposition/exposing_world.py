"""The "break it" exercise of lesson 3: find a world in which a rule for common walls is wrong."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from ....decomposition import trapezoidation
from ....errors import InvalidPoint, InvalidPolygon, InvalidWorld
from ....geometry.checks import Array
from ....messages import get_message
from ....worlds import PolygonWorld
from ...exercise import RIGHT, Axes, Case, Exercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Record, Value
from .free_intervals import RING
from .pictures import draw_middles, draw_outline
from .plan_by_decomposition import shared_wall

FEWEST = 6
REFUSALS = (InvalidPoint, InvalidPolygon, InvalidWorld)


class ExposeShorterWalls(Exercise):
    """Find a world in which `middle_of_shorter_wall` is off the common wall of two neighbours."""

    name = "exposing_world"
    lesson = "03_decomposition"
    kinds = ("valid", "exposes", "smallest")
    given = Record()
    answer = RING

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """The same question three times; each case demands more of the answer."""
        return (Case(kind, {}) for kind in self.kinds)

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Check that the polygon is simple and the program wrong, and the number of vertices."""
        if not np.isfinite(value).all() or np.abs(value).max(initial=0.0) > 1e4:
            return Verdict(0.0, "range", self.describe_expected(case))
        try:
            wrong = misplaced(value).any()
        except REFUSALS:
            return Verdict(0.0, "valid", self.describe_expected(case))
        if case.kind != "valid" and not wrong:
            return Verdict(0.0, "exposes", self.describe_expected(case))
        if case.kind == "smallest" and len(value) > FEWEST:
            return Verdict(0.0, "smallest", self.describe_expected(case))
        return RIGHT

    def describe_expected(self, case: Case) -> str:
        """Description of what the case asks for."""
        return get_message(f"exposing_world.wanted.{case.kind}")

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the cells, their common walls, and the middles that are not on them."""
        from ....figures import plane

        boundary = outcome.value if isinstance(outcome, Answer) else np.empty((0, 2))
        try:
            draw_middles(*cells_in(boundary), shared_wall, middle_of_shorter_wall, ax)
        except REFUSALS:
            draw_outline(boundary, ax)
        plane.title(self.message("picture"), ax)


def cells_in(boundary: Array) -> tuple[Array, NDArray[np.int64]]:
    """Cells of a world without obstacles, (n, 6), and the pairs of neighbours, (m, 2)."""
    cut = trapezoidation(PolygonWorld(boundary, []))
    return cut.trapezoids, cut.adjacency


def misplaced(boundary: Array) -> NDArray[np.bool_]:
    """For each pair of neighbours, whether the rule's point is off their wall by 1e-6, (m,)."""
    cells, pairs = cells_in(boundary)
    walls = np.array([shared_wall(cells[i], cells[j]) for i, j in pairs]).reshape(-1, 3)
    y = np.array([middle_of_shorter_wall(cells[i], cells[j])[1] for i, j in pairs])
    off: NDArray[np.bool_] = (y < walls[:, 1] - 1e-6) | (y > walls[:, 2] + 1e-6)
    return off


def middle_of_shorter_wall(a: Array, b: Array) -> Array:
    """Middle of the wall between two neighbours.

    It takes the shorter one of the left cell's right wall and the right cell's left wall.

    It is wrong somewhere. Where?
    """
    left, right = (a, b) if a[1] == b[0] else (b, a)
    low, high = min(left[4:6], right[2:4], key=lambda wall: wall[1] - wall[0])
    return np.array([left[1], (low + high) / 2])

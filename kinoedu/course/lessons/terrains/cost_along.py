"""The exercise on the cost of a motion on a terrain: an integral over cells."""

from collections.abc import Iterator

import numpy as np

from ....collision.costs import cost_on_terrain, integral
from ....geometry.checks import Array
from ....messages import get_message
from ...exercise import Axes, Case, Change, Given, Slip, ValueExercise
from ...outcomes import Answer, Outcome
from ...shapes import Number, Numbers, Record
from ...withheld import withheld
from ..geometry.lines import POINT
from .motions import find_crossed_cells, find_cuts, measure_length

PEAK = np.array([[4.0, 1000.0], [1.0, 2.0]])


class CostAlong(ValueExercise):
    """Integrate the cost of the cells along a segment."""

    name = "cost_along"
    lesson = "10_terrains"
    kinds = ("one_cell", "row", "column", "slanted", "backwards", "corners", "nowhere")
    given = Record(cost=Numbers(("rows", "columns")), a=POINT, b=POINT)
    answer = Number()
    shown = staticmethod(cost_on_terrain)
    slips = (
        Slip(
            "ends",
            lambda cost, a, b: (
                measure_length(a, b) * (look_up_cost(cost, a) + look_up_cost(cost, b)) / 2
            ),
        ),
        Slip("middle", lambda cost, a, b: measure_length(a, b) * look_up_cost(cost, (a + b) / 2)),
        Slip("start", lambda cost, a, b: measure_length(a, b) * look_up_cost(cost, a)),
        Slip("sampled", lambda cost, a, b: sum_samples(cost, a, b, 0.5)),
        Slip(
            "whole_x_only", lambda cost, a, b: sum_pieces(cost, a, b, find_cuts(a[:1], b[:1]), 0.5)
        ),
        Slip("first_end", lambda cost, a, b: sum_pieces(cost, a, b, find_cuts(a, b), 0.0)),
        Slip("transposed", lambda cost, a, b: integrate_transposed(cost, a, b)),
        Slip("upside_down", lambda cost, a, b: integrate(cost[::-1], a, b)),
        Slip("length", lambda cost, a, b: measure_length(a, b)),
        Slip("share", lambda cost, a, b: integrate(cost, a, b) / measure_length(a, b)),
        Slip("cells", lambda cost, a, b: sum(cost[j, i] for i, j in find_crossed_cells(a, b))),
    )

    @staticmethod
    @withheld
    def reference(cost: Array, a: Array, b: Array) -> float:
        """Return the library's integral."""
        return integrate(cost, a, b)

    source = reference
    changes = (
        Change("speed", lambda paid, cost, a, b: paid(1.0 / cost, a, b)),
        Change("squared", lambda paid, cost, a, b: paid(cost * cost, a, b)),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield motions over two cells first; no motion runs along a side of a cell."""
        two = np.array([[1.0, 3.0]])
        square = np.array([[1.0, 2.0], [4.0, 8.0]])
        for kind, cost, a, b in (
            ("one_cell", two, (0.25, 0.5), (0.75, 0.5)),
            ("row", two, (0.5, 0.5), (1.5, 0.5)),
            ("column", two.T, (0.5, 0.5), (0.5, 1.5)),
            ("nowhere", two, (0.5, 0.5), (0.5, 0.5)),
            ("slanted", square, (0.5, 0.25), (1.75, 1.5)),
            ("slanted", 0.5 * square, (0.5, 0.25), (1.75, 1.5)),
            ("slanted", PEAK, (0.5, 0.5), (1.505, 1.5)),
            ("slanted", square, (0.98, 0.5), (1.02, 1.75)),
            ("slanted", square, (0.999998, 0.5), (1.000002, 1.75)),  # not quite upright
            ("slanted", square, (0.25, 0.9997), (1.75, 1.0001)),  # not quite level
            ("backwards", two, (1.75, 0.5), (0.5, 0.5)),
            ("corners", square, (0.5, 0.5), (1.5, 1.5)),
            ("row", np.array([[1.0, 2.0, 3.0, 4.0]]), (0.5, 0.5), (3.5, 0.5)),
            ("column", np.array([[1.0], [2.0], [3.0], [4.0]]), (0.5, 0.5), (0.5, 3.5)),
            ("one_cell", 1000.0 * two, (0.25, 0.5), (0.2503, 0.5004)),
        ):
            yield Case(kind, {"cost": cost, "a": np.array(a), "b": np.array(b)})
        for number in range(10):
            for kind in self.kinds:
                yield Case(kind, draw_case(kind, 2 + number // 2, rng))

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the cells with their costs, and the motion cut where it enters another cell."""
        from .pictures import draw_costs

        found = outcome.value if isinstance(outcome, Answer) else None
        draw_costs(
            self,
            case,
            found,
            get_message("picture.should_be", value=self.describe_expected(case)),
            ax,
        )


def draw_case(kind: str, n: int, rng: np.random.Generator) -> Given:
    """Draw a motion over cells with whole costs; rows and columns differ in number."""
    cost = rng.integers(1, 10, (n, n + 1)).astype(float)
    a, b = np.round(rng.uniform((0, 0), (n + 1, n), (2, 2)), 2) * 0.98 + 0.013
    if kind == "row":
        b[1] = a[1]
    elif kind == "column":
        b[0] = a[0]
    elif kind == "nowhere":
        b = a.copy()
    elif kind == "one_cell":
        b = np.floor(a) + rng.uniform(0.05, 0.95, 2).round(2)
    elif kind == "corners":
        i, k = int(rng.integers(0, 2)), int(rng.integers(1, n))
        a, b = np.array([i + 0.5, 0.5]), np.array([i + k + 0.5, k + 0.5])
        b = b if i + k < n + 1 else a + (b - a) / k * (n - i)
    if kind == "backwards" and b[0] > a[0]:
        a, b = b, a
    return {"cost": cost, "a": a, "b": b}


def integrate(cost: Array, a: Array, b: Array) -> float:
    """Return the library's integral over cells of side 1, with cost 0 outside."""
    value = float(integral(np.ascontiguousarray(cost), a[0], a[1], b[0], b[1]))
    if value == np.inf:
        raise ValueError("outside")
    return value


def integrate_transposed(cost: Array, a: Array, b: Array) -> float:
    """Return the integral with cost[column, row], 0 where there is no such cell."""
    stretches = np.diff(find_cuts(a, b)) * measure_length(a, b)
    inside = [
        (s, i, j)
        for s, (i, j) in zip(stretches, find_crossed_cells(a, b))
        if i < len(cost) and j < len(cost[0])
    ]
    return float(sum(cost[i, j] * s for s, i, j in inside))


def sum_pieces(cost: Array, a: Array, b: Array, shares: Array, look: float) -> float:
    """Return the sum of the costs of the pieces of a motion.

    Parameters
    ----------
    shares : fractions of the motion at which it is cut.
    look : where in a piece its cost is looked up, 0 at its beginning and 1 at its end.
    """
    looked = shares[:-1] + look * np.diff(shares)
    return float(
        sum(
            look_up_cost(cost, a + (b - a) * t) * s
            for t, s in zip(looked, np.diff(shares) * measure_length(a, b))
        )
    )


def look_up_cost(cost: Array, q: Array) -> float:
    """Return the cost of the cell that contains a point."""
    return float(cost[int(q[1]), int(q[0])])


def sum_samples(cost: Array, a: Array, b: Array, step: float) -> float:
    """Return the sum of costs at samples, each multiplied by the step."""
    length = measure_length(a, b)
    if not length:
        return 0.0
    shares = np.arange(0.0, length, step) / length
    return sum(look_up_cost(cost, a + (b - a) * share) * step for share in shares)

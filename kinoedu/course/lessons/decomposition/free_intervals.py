"""The exercise `free_intervals`. Bullo & Smith, chapter 2."""

from collections.abc import Iterator

import numpy as np

from ....geometry.checks import Array
from ...exercise import Axes, Case, Restated, Slip, ValueExercise
from ...outcomes import Answer, Outcome
from ...shapes import Listed, Number, Numbers, Record
from ...withheld import withheld
from ..shared.random_shapes import sizes
from ..shared.random_worlds import beside_vertex, between_vertices, edges_round, general_world
from .pictures import draw_intervals, set_title
from .sweep_line import crossed_edges, heights

RING = Numbers(("n", 2))
KITE = np.array([(0, 0), (8, -4), (12, 8), (4, 12)], float)
WEDGE = np.array([(3, 2), (7, 1), (6, 5)], float)
BAY = np.array([(0, 0), (10, -4), (6, 1), (9, 6)], float)


@withheld
def free_stretches(x: float, boundary: Array, obstacles: list[Array]) -> Array:
    """Free intervals of a vertical line, from bottom to top, (k, 2)."""
    edges = edges_round(boundary, obstacles)
    return heights(x, edges[crossed_edges(x, edges)]).reshape(-1, 2)


class FreeIntervals(ValueExercise):
    """The free intervals of a vertical line between two events."""

    name = "free_intervals"
    lesson = "03_decomposition"
    kinds = ("convex", "bays", "one", "several")
    given = Record(x=Number(), boundary=RING, obstacles=Listed(RING))
    answer = Numbers(("k", 2))
    source = staticmethod(free_stretches)
    slips = (
        Slip("hollow", lambda *given: all_intervals(*given)),
        Slip("solid", lambda *given: all_intervals(*given)[1::2]),
        Slip("no_obstacles", lambda x, boundary, obstacles: free_stretches(x, boundary, [])),
        Slip("outer", lambda *given: free_stretches(*given).reshape(-1)[[0, -1]][None]),
        Slip("top_down", lambda *given: free_stretches(*given)[::-1]),
        Slip("upside_down", lambda *given: free_stretches(*given)[:, ::-1]),
        Slip("upside_down", lambda *given: free_stretches(*given)[::-1, ::-1]),
    )
    reference = staticmethod(free_stretches)
    changes = (
        Restated("top_down", answer=lambda rows, *given: np.asarray(rows)[::-1]),
        Restated("upper_end_first", answer=lambda rows, *given: np.reshape(rows, (-1, 2))[:, ::-1]),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Squared paper first; then bays, an obstacle, and several obstacles."""
        for kind, x, boundary, obstacles in (
            ("convex", 4.0, [(0, 0), (6, 0), (8, 4), (1, 4)], []),
            ("convex", 6.0, KITE, []),
            ("convex", 0.01, KITE, []),
            ("convex", 0.0001, KITE, []),
            ("bays", 8.0, BAY, []),
            ("bays", 6.01, BAY, []),
            ("one", 5.0, KITE, [WEDGE]),
            ("one", 2.0, KITE, [WEDGE]),
            ("one", 3.01, KITE, [WEDGE]),
            ("several", 5.0, KITE, [WEDGE, WEDGE + np.array([0.5, 4.0])]),
        ):
            yield Case(
                kind, {"x": x, "boundary": np.array(boundary, float), "obstacles": obstacles}
            )
        for i, size in enumerate(sizes(4)):
            choose_x = beside_vertex if i % 2 else between_vertices
            for kind, number in (("convex", 0), ("bays", 0), ("one", 1), ("several", 3)):
                world = general_world(rng, number, size, convex=kind == "convex")
                yield Case(kind, {"x": choose_x(rng, edges_round(**world)), **world})

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the world, the line, its free intervals, and the student's beside them."""
        draw_intervals(
            case, self.truth(case), outcome.value if isinstance(outcome, Answer) else None, ax
        )
        set_title(self, case, ax)


def all_intervals(x: float, boundary: Array, obstacles: list[Array]) -> Array:
    """All intervals between neighbouring crossings, free or not."""
    levels = free_stretches(x, boundary, obstacles).reshape(-1)
    return np.column_stack([levels[:-1], levels[1:]])

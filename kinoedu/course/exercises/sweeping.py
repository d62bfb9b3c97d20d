"""Exercises on one place of the sweep line: what it crosses, and where it is free. Bullo & Smith, chapter 2."""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...geometry.checks import Array
from ..exercise import Case, Slip, ValueExercise
from ..outcomes import Answer, Outcome
from ..shapes import Listed, Number, Numbers, Record
from ..whole_shapes import WholeNumbers
from .chance import sizes
from .decomposition_pictures import draw_crossed, draw_intervals, titled
from .worlds_by_chance import between_vertices, edges_round, general_world

RING = Numbers(("n", 2))
KITE = np.array([(0, 0), (8, -4), (12, 8), (4, 12)], float)
WEDGE = np.array([(3, 2), (7, 1), (6, 5)], float)
BAY = np.array([(0, 0), (10, -4), (6, 1), (9, 6)], float)


def crossed_edges(x: float, edges: Array) -> NDArray[np.int64]:
    """The numbers of the edges that a vertical line crosses, from bottom to top, (k,)."""
    hit = np.flatnonzero((edges[:, 0] < x) != (edges[:, 2] < x))
    return hit[np.argsort(heights(x, edges[hit]))]


def heights(x: float, edges: Array) -> Array:
    """The height of each edge (n, 4) at x, (n,)."""
    slope = (edges[:, 3] - edges[:, 1]) / (edges[:, 2] - edges[:, 0])
    return edges[:, 1] + (x - edges[:, 0]) * slope


def free_stretches(x: float, boundary: Array, obstacles: list[Array]) -> Array:
    """The free stretches of a vertical line, from bottom to top, (k, 2)."""
    edges = edges_round(boundary, obstacles)
    return heights(x, edges[crossed_edges(x, edges)]).reshape(-1, 2)


class Crossings(ValueExercise):
    """The status of the sweep line: the edges that it crosses, in order."""

    name = "crossings"
    lesson = "03_decomposition"
    kinds = ("two", "slanted", "many", "none")
    given = Record(x=Number(), edges=Numbers(("n", 4)))
    answer = WholeNumbers(("k",))
    source = staticmethod(crossed_edges)
    slips = (
        Slip("unsorted", lambda x, edges: np.sort(crossed_edges(x, edges))),
        Slip("top_down", lambda x, edges: crossed_edges(x, edges)[::-1]),
        Slip("rightward", lambda x, edges: by(heights(x, edges), (edges[:, 0] < x) & (x < edges[:, 2]))),
        Slip("middles", lambda x, edges: by((edges[:, 1] + edges[:, 3]) / 2, (edges[:, 0] < x) != (edges[:, 2] < x))),
        Slip("first_ends", lambda x, edges: by(edges[:, 1], (edges[:, 0] < x) != (edges[:, 2] < x))),
        Slip("lines", lambda x, edges: np.argsort(heights(x, edges))),
        Slip("renumbered", lambda x, edges: np.argsort(np.argsort(crossed_edges(x, edges)))),
    )
    reference = staticmethod(crossed_edges)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Edges that can be drawn on squared paper first; then those of whole worlds, shuffled."""
        pair = np.array([(0, 0, 4, 0), (4, 3, 0, 1)], float)
        yield Case("two", {"x": 2.0, "edges": pair})
        yield Case("two", {"x": 2.0, "edges": pair[::-1]})
        yield Case("slanted", {"x": 1.0, "edges": np.array([(0, 0, 8, 8), (0, 4, 2, 2), (3, 0, 6, 1)], float)})
        yield Case("slanted", {"x": 7.0, "edges": np.array([(0, 0, 8, 8), (10, 2, 5, 3), (0, 1, 6, 9)], float)})
        yield Case("none", {"x": 5.0, "edges": pair})
        yield Case("many", {"x": 2.0, "edges": np.vstack([[(5, 1, 8, 1), (0, 4, 4, 4)], pair])})
        for size in sizes(6):
            world = general_world(rng, int(rng.integers(1, 4)), size)
            edges = rng.permutation(edges_round(**world))
            x = between_vertices(rng, edges)
            found = crossed_edges(x, edges)
            yield Case("many" if len(found) > 2 else "two", {"x": x, "edges": edges})
            yield Case("two", {"x": x, "edges": edges[rng.permutation(found[:2])]})
            yield Case("slanted", {"x": x, "edges": through(rng, x, size)})
            yield Case("none", {"x": float(edges[:, 0].max() + 1.0), "edges": edges})
            yield Case("many", {"x": x, "edges": np.vstack([edges, edges + np.array([0, 3, 0, 3]) * size])})

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """The line and the edges, those crossed with their places in both orders."""
        draw_crossed(case, self.truth(case), outcome.value if isinstance(outcome, Answer) else None, ax)
        titled(self, case, ax)


def by(key: Array, chosen: NDArray[np.bool_]) -> NDArray[np.int64]:
    """The numbers of the chosen edges by a key."""
    hit = np.flatnonzero(chosen)
    return hit[np.argsort(key[hit], kind="stable")]


def through(rng: np.random.Generator, x: float, size: float) -> Array:
    """Steep edges of many lengths that do not cross each other, one above the other at x, in no order."""
    rows = []
    for level in range(3):
        slope = rng.choice([-3.0, -2.0, 2.0, 3.0]) if level else 2.5
        left, right = rng.uniform(0.05, 0.3 if level else 0.9, 2) * size
        y = level * 2.5 * size
        row = [x - left, y - slope * left, x + right, y + slope * right]
        rows.append(row if rng.random() < 0.5 else row[2:] + row[:2])
    return np.round(rng.permutation(np.array(rows)), 3)


class FreeIntervals(ValueExercise):
    """The free stretches of a vertical line between two events."""

    name = "free_intervals"
    lesson = "03_decomposition"
    kinds = ("convex", "bays", "one", "several")
    given = Record(x=Number(), boundary=RING, obstacles=Listed(RING))
    answer = Numbers(("k", 2))
    source = staticmethod(free_stretches)
    slips = (
        Slip("hollow", lambda x, boundary, obstacles: consecutive(x, boundary, obstacles)),
        Slip("solid", lambda x, boundary, obstacles: consecutive(x, boundary, obstacles)[1::2]),
        Slip("no_obstacles", lambda x, boundary, obstacles: free_stretches(x, boundary, [])),
        Slip("outer", lambda x, boundary, obstacles: free_stretches(x, boundary, obstacles).reshape(-1)[[0, -1]][None]),
        Slip("top_down", lambda x, boundary, obstacles: free_stretches(x, boundary, obstacles)[::-1]),
        Slip("upside_down", lambda x, boundary, obstacles: free_stretches(x, boundary, obstacles)[:, ::-1]),
        Slip("upside_down", lambda x, boundary, obstacles: free_stretches(x, boundary, obstacles)[::-1, ::-1]),
    )
    reference = staticmethod(free_stretches)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Squared paper first; then a bay, an obstacle, several."""
        for kind, x, boundary, obstacles in (
            ("convex", 4.0, [(0, 0), (6, 0), (8, 4), (1, 4)], []),
            ("convex", 6.0, KITE, []),
            ("bays", 8.0, BAY, []),
            ("one", 5.0, KITE, [WEDGE]),
            ("one", 2.0, KITE, [WEDGE]),
            ("several", 5.0, KITE, [WEDGE, WEDGE + np.array([0.5, 4.0])]),
        ):
            yield Case(kind, {"x": x, "boundary": np.array(boundary, float), "obstacles": obstacles})
        for size in sizes(4):
            for kind, number in (("convex", 0), ("bays", 0), ("one", 1), ("several", 3)):
                world = general_world(rng, number, size, convex=kind == "convex")
                yield Case(kind, {"x": between_vertices(rng, edges_round(**world)), **world})

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """The world, the line, its free stretches and the student's beside them."""
        draw_intervals(case, self.truth(case), outcome.value if isinstance(outcome, Answer) else None, ax)
        titled(self, case, ax)


def consecutive(x: float, boundary: Array, obstacles: list[Array]) -> Array:
    """Every stretch between two neighbouring crossings, free or not."""
    levels = free_stretches(x, boundary, obstacles).reshape(-1)
    return np.column_stack([levels[:-1], levels[1:]])

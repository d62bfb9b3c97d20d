"""The exercise `crossings`. Bullo & Smith, chapter 2."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from ....geometry.checks import Array
from ...exercise import Axes, Case, Slip, ValueExercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Number, Numbers, Record, Value
from ...whole_shapes import Integers
from ..shared.random_shapes import sizes
from ..shared.random_worlds import beside_vertex, between_vertices, edges_round, general_world
from .pictures import draw_crossed, set_title
from .sweep_line import crossed_edges, heights


class Crossings(ValueExercise):
    """The status of the sweep line: the edges that it crosses, in order."""

    name = "crossings"
    lesson = "03_decomposition"
    kinds = ("two", "slanted", "many", "none")
    given = Record(x=Number(), edges=Numbers(("n", 4)))
    answer = Integers(("k",))
    source = staticmethod(crossed_edges)
    slips = (
        Slip("unsorted", lambda x, edges: np.sort(crossed_edges(x, edges))),
        Slip("top_down", lambda x, edges: crossed_edges(x, edges)[::-1]),
        Slip("rightward", lambda x, e: sorted_by(heights(x, e), (e[:, 0] < x) & (x < e[:, 2]))),
        Slip(
            "middles",
            lambda x, e: sorted_by((e[:, 1] + e[:, 3]) / 2, (e[:, 0] < x) != (e[:, 2] < x)),
        ),
        Slip("first_ends", lambda x, e: sorted_by(e[:, 1], (e[:, 0] < x) != (e[:, 2] < x))),
        Slip("lines", lambda x, edges: np.argsort(heights(x, edges))),
        Slip("renumbered", lambda x, edges: np.argsort(np.argsort(crossed_edges(x, edges)))),
    )
    reference = staticmethod(crossed_edges)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Edges on squared paper first, then the edges of whole worlds in random order."""
        pair = np.array([(0, 0, 4, 0), (4, 3, 0, 1)], float)
        yield Case("two", {"x": 2.0, "edges": pair})
        yield Case("two", {"x": 2.0, "edges": pair[::-1]})
        yield Case(
            "slanted",
            {"x": 1.0, "edges": np.array([(0, 0, 8, 8), (0, 4, 2, 2), (3, 0, 6, 1)], float)},
        )
        yield Case(
            "slanted",
            {"x": 7.0, "edges": np.array([(0, 0, 8, 8), (10, 2, 5, 3), (0, 1, 6, 9)], float)},
        )
        steep = np.array([(1.9995, 0, 2.0005, 10), (0, 4, 4, 4)], float)
        yield Case("slanted", {"x": 2.0, "edges": steep})
        yield Case("none", {"x": 5.0, "edges": pair})
        yield Case("many", {"x": 2.0, "edges": np.vstack([[(5, 1, 8, 1), (0, 4, 4, 4)], pair])})
        near = np.array([(0, 9000.01, 9000, 9000.01), (0, 9000, 9000, 9000.02)], float)
        yield Case("two", {"x": 4498.0, "edges": near})
        nearer = np.array([(0, 1.00000001, 4, 1.00000001), (0, 1, 4, 1)], float)
        yield Case("two", {"x": 2.0, "edges": nearer})
        for i, size in enumerate(sizes(6)):
            world = general_world(rng, int(rng.integers(1, 4)), size)
            edges = rng.permutation(edges_round(**world))
            x = (beside_vertex if i % 2 else between_vertices)(rng, edges)
            found = crossed_edges(x, edges)
            yield Case("many" if len(found) > 2 else "two", {"x": x, "edges": edges})
            yield Case("two", {"x": x, "edges": edges[rng.permutation(found[:2])]})
            yield Case("slanted", {"x": x, "edges": steep_edges(rng, x, size)})
            yield Case("none", {"x": float(edges[:, 0].max() + 1.0), "edges": edges})
            yield Case(
                "many", {"x": x, "edges": np.vstack([edges, edges + np.array([0, 3, 0, 3]) * size])}
            )

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Compare with the right indices; the right ones in a wrong order break a rule for that."""
        verdict = super().value_verdict(case, value)
        is_disordered = sorted(value) == sorted(self.truth(case))
        return (
            verdict._replace(rule="slanted") if verdict.rule == "two" and is_disordered else verdict
        )

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the line and the edges; the crossed ones with their places in both orders."""
        draw_crossed(
            case, self.truth(case), outcome.value if isinstance(outcome, Answer) else None, ax
        )
        set_title(self, case, ax)


def sorted_by(key: Array, chosen: NDArray[np.bool_]) -> NDArray[np.int64]:
    """Indices of the chosen edges, sorted by a key."""
    hit = np.flatnonzero(chosen)
    return hit[np.argsort(key[hit], kind="stable")]


def steep_edges(rng: np.random.Generator, x: float, size: float) -> Array:
    """Random steep edges that do not cross, one above the other at x, in random order."""
    rows = []
    for level in range(3):
        slope = float(rng.choice([-60.0, -3.0, -2.0, 2.0, 3.0, 60.0])) if level else 2.5
        left, right = (
            rng.uniform(0.05, 0.3 if level else 0.9, 2) * size * min(1.0, 3.0 / abs(slope))
        )
        y = level * 2.5 * size
        row = [x - left, y - slope * left, x + right, y + slope * right]
        rows.append(row if rng.random() < 0.5 else row[2:] + row[:2])
    return np.round(rng.permutation(np.array(rows)), 3)

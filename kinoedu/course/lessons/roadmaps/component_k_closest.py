"""The exercise `component_k_closest`. Bullo & Smith, chapter 5; LaValle, section 5.6."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from ....geometry.checks import Array
from ...exercise import Case, Restated, Slip
from ...shapes import Record, Value
from ...whole_shapes import Integer
from ...withheld import withheld
from ..shared.planned import ProblemShape
from .halls import WALL, draw_free_nodes, make_hall
from .joining import (
    allow_contact,
    check_samples,
    ignore_wrap,
    join_all_free,
    join_components,
    join_one_component,
    join_unchecked,
    renumber_pairs,
)
from .rules import (
    NODES,
    ROUND,
    Pairs,
    RuleExercise,
    draw_worlds,
    join_k_closest,
    make_case,
    make_pairs,
)


@withheld
def join_by_components(problem: Any, nodes: Array, k: int) -> Pairs:
    """Join each node to every component of the nodes before it.

    It is joined by the first free motion to one of the component's k closest nodes.
    """
    return join_components(problem, nodes, k)


def renumber_backwards(pairs: Pairs, problem: Value, nodes: Array, k: int) -> Pairs:
    """Return pairs of nodes that are numbered from the last to the first."""
    return renumber_pairs(pairs, np.arange(len(nodes))[::-1])


class ComponentNeighbours(RuleExercise):
    """Find the pairs that the component-wise K-closest rule joins."""

    name = "component_k_closest"
    kinds = ("few", "parts", "wall", "many", "torus")
    given = Record(problem=ProblemShape(), nodes=NODES, k=Integer())
    reference = staticmethod(join_by_components)
    source = staticmethod(join_by_components)
    slips = (
        Slip("blind", lambda p, q, k: join_components(p, q, k, join_unchecked)),
        Slip("goes_on", lambda p, q, k: join_components(p, q, k, join_all_free)),
        Slip("one_component", lambda p, q, k: join_components(p, q, k, join_one_component)),
        Slip("nearest_only", lambda p, q, k: join_components(p, q, 1)),
        Slip("any_number", lambda p, q, k: join_components(p, q, len(q))),
        Slip("closest", join_k_closest),
        Slip("straight", lambda p, q, k: join_by_components(ignore_wrap(p), q, k)),
        Slip("touching", lambda p, q, k: join_by_components(allow_contact(p), q, k)),
        Slip("sampled", lambda p, q, k: join_by_components(check_samples(p), q, k)),
    )

    changes = (
        Restated(
            "from_the_last",
            answer=renumber_backwards,
            given=lambda p, nodes, k: (p, nodes[::-1], k),
        ),
        Restated("larger_first", answer=lambda pairs, *given: np.reshape(pairs, (-1, 2))[:, ::-1]),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield a row, a node that joins two parts, and a wall; then random nodes.

        At the wall only the second closest node can be joined. Last, two nodes are equally far in a
        component that was joined in another order than that of their numbers.
        """
        apart = ((6, 3), (10, 3), (8, 8))
        yield make_case("few", make_hall(), ((1, 1), (3, 1)), 1)
        yield make_case("few", make_hall(), ((1, 1), (3, 1), (6, 1)), 1)
        yield make_case("few", make_hall(), ((1, 1), (1, 5), (3, 3)), 1)  # equally far
        yield make_case("few", make_hall(), ((1, 1), (1, 5), (3, 3.0000001)), 1)  # nearly
        yield make_case("few", make_hall(), ((1, 1), (1, 1), (3, 1)), 1)
        yield make_case("parts", make_hall(WALL), apart, 1)
        yield make_case("wall", make_hall(WALL), ((10, 3), (10, 8), (6, 4)), 1)
        yield make_case("wall", make_hall(WALL), ((10, 3), (10, 8), (6, 4)), 2)
        # only the third closest node can be joined
        yield make_case("wall", make_hall(WALL), ((10, 3.5), (10, 5), (7, 9), (6, 3.5)), 3)
        yield from make_pairs(1)
        for i in range(ROUND):
            yield make_case(
                "few",
                make_hall(),
                draw_free_nodes(rng, make_hall(), 3 + i % 2),
                int(rng.integers(1, 4)),
            )
            sides = np.vstack(
                [draw_pair(rng, 4, 6), draw_pair(rng, 10, 12), draw_pair(rng, 4, 12, low=7.5)]
            )
            yield make_case("parts", make_hall(WALL), sides, int(rng.integers(1, 4)))
            for kind, problem in draw_worlds(rng, i):
                yield make_case(
                    kind, problem, draw_free_nodes(rng, problem, 5 + i), int(rng.integers(1, 4))
                )
        beside, over, above = ((6, 6), (10, 6)), (8, 9.5), (8, 6.5)
        yield make_case("wall", make_hall(WALL), (*beside, over, above), 1)
        yield make_case("wall", make_hall(WALL), (*beside, (5, 6), over, above), 1)


def draw_pair(rng: np.random.Generator, left: float, right: float, low: float = 1.0) -> Array:
    """Draw two nodes in a strip of the hall."""
    return np.round(rng.uniform((left, low), (right, low + 1.5), (2, 2)), 2)

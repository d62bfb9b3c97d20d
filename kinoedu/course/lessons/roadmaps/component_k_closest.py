"""The exercise `component_k_closest`. Bullo & Smith, chapter 5; LaValle, section 5.6."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from ....geometry.checks import Array
from ...exercise import Case, Slip
from ...shapes import Record
from ...whole_shapes import Whole
from ..shared.planned import Task
from .halls import WALL, free_nodes, hall
from .joining import by_samples, in_components, with_contact, without_wrap
from .rules import NODES, ROUND, Pairs, RuleExercise, closest_pairs, rule_case, two_nodes, worlds


def component_pairs(problem: Any, nodes: Array, k: int) -> Pairs:
    """Join each node to every component of the nodes before it.

    It is joined by the first free motion to one of the component's k closest nodes.
    """
    return in_components(problem, nodes, k)


class ComponentNeighbours(RuleExercise):
    """Find the pairs that the component-wise K-closest rule joins."""

    name = "component_k_closest"
    kinds = ("few", "parts", "wall", "many", "torus")
    given = Record(problem=Task(), nodes=NODES, k=Whole())
    reference = staticmethod(component_pairs)
    source = staticmethod(component_pairs)
    slips = (
        Slip("blind", lambda p, q, k: in_components(p, q, k, blind=True)),
        Slip("goes_on", lambda p, q, k: in_components(p, q, k, goes_on=True)),
        Slip("one_component", lambda p, q, k: in_components(p, q, k, one=True)),
        Slip("nearest_only", lambda p, q, k: in_components(p, q, 1)),
        Slip("any_number", lambda p, q, k: in_components(p, q, len(q))),
        Slip("closest", closest_pairs),
        Slip("straight", lambda p, q, k: component_pairs(without_wrap(p), q, k)),
        Slip("touching", lambda p, q, k: component_pairs(with_contact(p), q, k)),
        Slip("sampled", lambda p, q, k: component_pairs(by_samples(p), q, k)),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield a row, a node that joins two parts, and a wall; then random nodes.

        At the wall only the second closest node can be joined.
        """
        apart = ((6, 3), (10, 3), (8, 8))
        yield rule_case("few", hall(), ((1, 1), (3, 1)), 1)
        yield rule_case("few", hall(), ((1, 1), (3, 1), (6, 1)), 1)
        yield rule_case("parts", hall(WALL), apart, 1)
        yield rule_case("wall", hall(WALL), ((10, 3), (10, 8), (6, 4)), 1)
        yield rule_case("wall", hall(WALL), ((10, 3), (10, 8), (6, 4)), 2)
        yield from two_nodes(1)
        for i in range(ROUND):
            yield rule_case(
                "few", hall(), free_nodes(rng, hall(), 3 + i % 2), int(rng.integers(1, 4))
            )
            sides = np.vstack([beside(rng, 4, 6), beside(rng, 10, 12), beside(rng, 4, 12, low=7.5)])
            yield rule_case("parts", hall(WALL), sides, int(rng.integers(1, 4)))
            for kind, problem in worlds(rng, i):
                yield rule_case(
                    kind, problem, free_nodes(rng, problem, 5 + i), int(rng.integers(1, 4))
                )


def beside(rng: np.random.Generator, left: float, right: float, low: float = 1.0) -> Array:
    """Draw two nodes in a strip of the hall."""
    return np.round(rng.uniform((left, low), (right, low + 1.5), (2, 2)), 2)

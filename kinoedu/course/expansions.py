"""Expansion rules for the exercise on tree roadmaps, and how they are encoded."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from ..geometry.checks import Array
from ..messages import get_message
from ..problems.protocols import PlanningProblem
from .plain import WrongShape, wrong_shape


def wander(problem: PlanningProblem, nodes: Array, rng: np.random.Generator) -> tuple[int, Array]:
    """Expand a random node to a random place nearby."""
    node = int(rng.integers(len(nodes)))
    return node, nodes[node] + rng.uniform(-1.5, 1.5, len(nodes[node]))


def leap(problem: PlanningProblem, nodes: Array, rng: np.random.Generator) -> tuple[int, Array]:
    """Expand a random node to a random sample of the whole space."""
    return int(rng.integers(len(nodes))), problem.sample(rng)


def reach_out(
    problem: PlanningProblem, nodes: Array, rng: np.random.Generator
) -> tuple[int, Array]:
    """Expand the node nearest to a sample by one step towards that sample, as an RRT does."""
    q_rand = problem.sample(rng)
    node = int(np.argmin([problem.distance(q, q_rand) for q in nodes]))
    return node, problem.steer(nodes[node], q_rand, 1.0)


def revisit(problem: PlanningProblem, nodes: Array, rng: np.random.Generator) -> tuple[int, Array]:
    """Expand a random node to a random place nearby, or to a place where the tree has a node."""
    node, q = wander(problem, nodes, rng)
    return node, q if rng.random() < 0.5 else nodes[int(rng.integers(len(nodes)))].copy()


def walk(problem: PlanningProblem, nodes: Array, rng: np.random.Generator) -> tuple[int, Array]:
    """Expand a random node by one unit along an axis: it may touch a wall at a whole number."""
    node = int(rng.integers(len(nodes)))
    q = nodes[node].copy()
    q[int(rng.integers(len(q)))] += rng.choice((-1.0, 1.0))
    return node, q


@dataclass(frozen=True)
class Expansion:
    """A rule that proposes the next edge of a tree.

    It is called with the problem, the nodes (n, d) and a generator, and returns the index of the
    node to expand and a configuration near it.
    """

    name: str

    def __call__(self, problem: Any, nodes: Any, rng: np.random.Generator) -> tuple[int, Array]:
        return RULES[self.name](problem, np.array(nodes, float).reshape(len(nodes), -1), rng)

    def __repr__(self) -> str:
        return f'EXPANSIONS["{self.name}"]'


RULES: dict[str, Callable[..., tuple[int, Array]]] = {
    rule.__name__: rule for rule in (wander, leap, reach_out, revisit, walk)
}
EXPANSIONS = {name: Expansion(name) for name in RULES}


class Rule(NamedTuple):
    """The shape of an expansion, encoded by its name."""

    @property
    def description(self) -> str:
        """Description of the shape, for messages."""
        return get_message("planner.expansion")

    def encode(self, value: object) -> str:
        """Encode an expansion as its name. Raises WrongShape."""
        if not isinstance(value, Expansion):
            raise wrong_shape(self.description, value)
        return value.name

    def decode(self, data: object) -> Expansion:
        """Decode the name of an expansion. Raises WrongShape."""
        if data not in EXPANSIONS:
            raise WrongShape(self.description)
        return EXPANSIONS[data]

"""The rules by which the exercise on tree roadmaps lets trees grow, and how they travel."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from ..geometry.checks import Array
from ..words import say
from .plain import WrongShape, wrong


def wander(problem: Any, nodes: Array, rng: np.random.Generator) -> tuple[int, Array]:
    """Any node, and a place not far from it."""
    node = int(rng.integers(len(nodes)))
    return node, nodes[node] + rng.uniform(-1.5, 1.5, len(nodes[node]))


def leap(problem: Any, nodes: Array, rng: np.random.Generator) -> tuple[int, Array]:
    """Any node, and any place."""
    return int(rng.integers(len(nodes))), problem.sample(rng)


def reach_out(problem: Any, nodes: Array, rng: np.random.Generator) -> tuple[int, Array]:
    """The node nearest to a sample, and a step from it towards the sample: what makes an RRT."""
    q_rand = problem.sample(rng)
    node = int(np.argmin([problem.distance(q, q_rand) for q in nodes]))
    return node, problem.steer(nodes[node], q_rand, 1.0)


@dataclass(frozen=True)
class Expansion:
    """A rule for the next edge: called with the problem, the nodes so far (n, d) and a generator,
    it gives the number of the node to expand, and a configuration near it."""

    name: str

    def __call__(self, problem: Any, nodes: Any, rng: np.random.Generator) -> tuple[int, Array]:
        return RULES[self.name](problem, np.array(nodes, float).reshape(len(nodes), -1), rng)

    def __repr__(self) -> str:
        return f'EXPANSIONS["{self.name}"]'


RULES: dict[str, Callable[..., tuple[int, Array]]] = {
    rule.__name__: rule for rule in (wander, leap, reach_out)
}
EXPANSIONS = {name: Expansion(name) for name in RULES}


class Rule(NamedTuple):
    """The shape of an expansion: it travels by its name."""

    @property
    def words(self) -> str:
        """In words."""
        return say("planner.expansion")

    def encode(self, value: Any) -> str:
        """The name."""
        if not isinstance(value, Expansion):
            raise wrong(self.words, value)
        return value.name

    def decode(self, data: Any) -> Expansion:
        """The expansion."""
        if data not in EXPANSIONS:
            raise WrongShape(self.words)
        return EXPANSIONS[data]

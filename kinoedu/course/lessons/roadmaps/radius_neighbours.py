"""The exercise `radius_neighbours`. Bullo & Smith, chapter 5; LaValle, section 5.6."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from ....geometry.checks import Array
from ...exercise import Case, Slip
from ...shapes import Number, Record
from ..shared.planned import Task
from .halls import WALL, distances, free_nodes, hall
from .joining import allowed, by_samples, with_contact, without_wrap
from .rules import NODES, ROUND, Pairs, RuleExercise, rule_case, two_nodes, worlds


def radius_pairs(problem: Any, nodes: Array, r: float) -> Pairs:
    """Return the pairs at most r apart whose motion is free."""
    return allowed(problem, nodes, np.argwhere(np.triu(distances(problem, nodes) <= r, 1)))


class RadiusNeighbours(RuleExercise):
    """Find the pairs that the r-radius rule joins."""

    name = "radius_neighbours"
    kinds = ("pair", "wall", "many", "torus")
    given = Record(problem=Task(), nodes=NODES, r=Number())
    reference = staticmethod(radius_pairs)
    source = staticmethod(radius_pairs)
    slips = (
        Slip("strict", lambda p, q, r: radius_pairs(p, q, np.nextafter(r, 0.0))),
        Slip("blind", lambda p, q, r: np.argwhere(np.triu(distances(p, q) <= r, 1))),
        Slip(
            "twice",
            lambda p, q, r: np.vstack([radius_pairs(p, q, r), radius_pairs(p, q, r)[:, ::-1]]),
        ),
        Slip(
            "itself",
            lambda p, q, r: np.vstack(
                [radius_pairs(p, q, r), np.repeat(np.arange(len(q)), 2).reshape(-1, 2)]
            ),
        ),
        Slip("straight", lambda p, q, r: radius_pairs(without_wrap(p), q, r)),
        Slip("touching", lambda p, q, r: radius_pairs(with_contact(p), q, r)),
        Slip("sampled", lambda p, q, r: radius_pairs(by_samples(p), q, r)),
        Slip("squared", lambda p, q, r: radius_pairs(p, q, np.sqrt(r))),
        Slip("diameter", lambda p, q, r: radius_pairs(p, q, r / 2)),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield two nodes, three nodes and a wall, then random nodes."""
        for row, far in (
            (((2, 2), (4, 2)), 3),
            (((2, 2), (6, 5)), 5),
            (((2, 2), (6, 5)), 4),
            (((1, 1), (4, 5), (7, 1)), 5),
        ):
            yield rule_case("pair", hall(), row, float(far))
        yield rule_case("wall", hall(WALL), ((5, 3), (11, 3)), 8.0)
        yield rule_case("wall", hall(WALL), ((5, 3), (11, 3), (8, 8)), 8.0)
        yield from two_nodes(8.0)
        for i in range(ROUND):
            at = rng.integers(1, 5, 2)
            yield rule_case(
                "pair", hall(), (at, at + ((3, 4), (4, 3))[i % 2]), (5.0, 4.5, 5.0, 5.5)[i % 4]
            )
            for kind, problem in worlds(rng, i):
                r = (
                    float(rng.integers(2, 6))
                    if kind != "torus"
                    else round(float(rng.uniform(1.0, 2.0)), 2)
                )
                yield rule_case(kind, problem, free_nodes(rng, problem, 4 + i), r)

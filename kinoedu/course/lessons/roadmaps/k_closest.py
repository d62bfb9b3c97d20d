"""The exercise `k_closest`. Bullo & Smith, chapter 5; LaValle, section 5.6."""

from collections.abc import Iterator

import numpy as np

from ....geometry.checks import Array
from ...exercise import Case, Slip
from ...shapes import Record
from ...whole_shapes import Whole
from ..shared.planned import Task
from .halls import WALL, free_nodes, hall
from .joining import allowed, by_samples, closest_rows, unique, with_contact, without_wrap
from .rules import NODES, ROUND, Pairs, RuleExercise, closest_pairs, rule_case, two_nodes, worlds


class KClosestNeighbours(RuleExercise):
    """Find the pairs that the K-closest rule joins."""

    name = "k_closest"
    kinds = ("few", "one_sided", "ties", "wall", "many", "torus")
    given = Record(problem=Task(), nodes=NODES, k=Whole())
    reference = staticmethod(closest_pairs)
    source = staticmethod(closest_pairs)
    slips = (
        Slip(
            "farthest", lambda p, q, k: allowed(p, q, unique(closest_rows(p, q, k, farthest=True)))
        ),
        Slip("blind", lambda p, q, k: unique(closest_rows(p, q, k))),
        Slip("itself", lambda p, q, k: closest_pairs(p, q, k - 1)),
        Slip("replaced", lambda p, q, k: unique(closest_rows(p, q, k, only_free=True))),
        Slip("mutual", lambda p, q, k: allowed(p, q, twice_named(closest_rows(p, q, k)))),
        Slip("lost", lambda p, q, k: allowed(p, q, upwards(closest_rows(p, q, k)))),
        Slip(
            "later", lambda p, q, k: allowed(p, q, unique(closest_rows(p, q, k, only_later=True)))
        ),
        Slip("straight", lambda p, q, k: closest_pairs(without_wrap(p), q, k)),
        Slip("touching", lambda p, q, k: closest_pairs(with_contact(p), q, k)),
        Slip("sampled", lambda p, q, k: closest_pairs(by_samples(p), q, k)),
        Slip("one", lambda p, q, k: closest_pairs(p, q, 1)),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield small cases made by hand, then random nodes.

        By hand: three nodes, a node that is nobody's closest, ties on a lattice, and a
        wall.
        """
        row, tail = ((1, 1), (3, 1), (6, 1)), ((6, 1), (3, 1), (1, 1))
        yield rule_case("few", hall(), row[:2], 1)
        yield rule_case("few", hall(), row, 2)
        yield rule_case("few", hall(), row, 5)
        yield rule_case("one_sided", hall(), row, 1)
        yield rule_case("one_sided", hall(), tail, 1)
        yield rule_case("one_sided", hall(), ((3, 1), (1, 1), (6, 1)), 1)
        yield rule_case("ties", hall(), ((5, 5), (3, 5), (7, 5), (5, 1)), 1)
        yield rule_case("wall", hall(WALL), ((6, 3), (10, 3), (1, 3), (1, 4)), 1)
        yield from two_nodes(1)
        for i in range(ROUND):
            yield rule_case("few", hall(), free_nodes(rng, hall(), 3), int(rng.integers(2, 5)))
            yield rule_case("one_sided", hall(), chain(rng), 1)
            yield rule_case(
                "ties", hall(), rng.permutation(lattice(2 + i % 3)), int(rng.integers(1, 4))
            )
            for kind, problem in worlds(rng, i):
                yield rule_case(
                    kind, problem, free_nodes(rng, problem, 4 + i), int(rng.integers(1, 4))
                )


def lattice(k: int) -> Array:
    """Return a lattice of k by 3 nodes with spacing 2."""
    return (2.0 + 2.0 * np.indices((k, 3)).reshape(2, -1).T).astype(float)


def chain(rng: np.random.Generator) -> Array:
    """Draw nodes in a row with growing gaps, in random order."""
    x = np.array([1.0, 2.0, 3.5, 6.0, 9.5])
    return rng.permutation(np.column_stack([x, np.round(rng.uniform(1, 1.2, 5), 2)]))


def upwards(rows: Pairs) -> Pairs:
    """Return the rows whose second index is the larger one."""
    return rows[rows[:, 0] < rows[:, 1]]


def twice_named(rows: Pairs) -> Pairs:
    """Return the pairs that occur in both directions."""
    pairs, times = np.unique(np.sort(rows, axis=1), axis=0, return_counts=True)
    return pairs[times == 2]

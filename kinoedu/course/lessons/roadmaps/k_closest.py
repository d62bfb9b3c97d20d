"""The exercise `k_closest`. Bullo & Smith, chapter 5; LaValle, section 5.6."""

from collections.abc import Iterator

import numpy as np

from ....geometry.checks import Array
from ...exercise import Case, Slip
from ...shapes import Record
from ...whole_shapes import Integer
from ..shared.planned import ProblemShape
from .halls import WALL, draw_free_nodes, make_hall
from .joining import (
    allow_contact,
    check_samples,
    find_closest,
    find_closest_free,
    find_closest_later,
    find_farthest,
    ignore_wrap,
    keep_free,
    remove_duplicates,
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


class KClosestNeighbours(RuleExercise):
    """Find the pairs that the K-closest rule joins."""

    name = "k_closest"
    kinds = ("few", "one_sided", "ties", "wall", "many", "torus")
    given = Record(problem=ProblemShape(), nodes=NODES, k=Integer())
    reference = staticmethod(join_k_closest)
    source = staticmethod(join_k_closest)
    slips = (
        Slip(
            "farthest",
            lambda p, q, k: keep_free(p, q, remove_duplicates(find_farthest(p, q, k))),
        ),
        Slip("blind", lambda p, q, k: remove_duplicates(find_closest(p, q, k))),
        Slip("itself", lambda p, q, k: join_k_closest(p, q, k - 1)),
        Slip("replaced", lambda p, q, k: remove_duplicates(find_closest_free(p, q, k))),
        Slip("mutual", lambda p, q, k: keep_free(p, q, keep_mutual(find_closest(p, q, k)))),
        Slip("lost", lambda p, q, k: keep_free(p, q, keep_upward(find_closest(p, q, k)))),
        Slip(
            "later",
            lambda p, q, k: keep_free(p, q, remove_duplicates(find_closest_later(p, q, k))),
        ),
        Slip("straight", lambda p, q, k: join_k_closest(ignore_wrap(p), q, k)),
        Slip("touching", lambda p, q, k: join_k_closest(allow_contact(p), q, k)),
        Slip("sampled", lambda p, q, k: join_k_closest(check_samples(p), q, k)),
        Slip("one", lambda p, q, k: join_k_closest(p, q, 1)),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield small cases made by hand, then random nodes.

        By hand: three nodes, a node that is nobody's closest, ties on a lattice, and a
        wall.
        """
        row, tail = ((1, 1), (3, 1), (6, 1)), ((6, 1), (3, 1), (1, 1))
        yield make_case("few", make_hall(), row[:2], 1)
        yield make_case("few", make_hall(), row, 2)
        yield make_case("few", make_hall(), row, 5)
        yield make_case("one_sided", make_hall(), row, 1)
        yield make_case("one_sided", make_hall(), tail, 1)
        yield make_case("one_sided", make_hall(), ((3, 1), (1, 1), (6, 1)), 1)
        yield make_case("ties", make_hall(), ((5, 5), (3, 5), (7, 5), (5, 1)), 1)
        for x in (6.999, 6.9999999):
            nearly = ((5, 5), (3, 5), (x, 5), (2, 5), (8, 5))
            yield make_case("one_sided", make_hall(), nearly, 1)
        yield make_case("ties", make_hall(), ((1, 1), (1, 1), (3, 1)), 1)
        yield make_case("ties", make_hall(), ((1, 1), (1, 1), (1, 1)), 1)
        yield make_case("wall", make_hall(WALL), ((6, 3), (10, 3), (1, 3), (1, 4)), 1)
        yield from make_pairs(1)
        for i in range(ROUND):
            yield make_case(
                "few", make_hall(), draw_free_nodes(rng, make_hall(), 3), int(rng.integers(2, 5))
            )
            yield make_case("one_sided", make_hall(), draw_chain(rng), 1)
            yield make_case(
                "ties",
                make_hall(),
                rng.permutation(make_lattice(2 + i % 3)),
                int(rng.integers(1, 4)),
            )
            for kind, problem in draw_worlds(rng, i):
                yield make_case(
                    kind, problem, draw_free_nodes(rng, problem, 4 + i), int(rng.integers(1, 4))
                )


def make_lattice(k: int) -> Array:
    """Return a lattice of k by 3 nodes with spacing 2."""
    return (2.0 + 2.0 * np.indices((k, 3)).reshape(2, -1).T).astype(float)


def draw_chain(rng: np.random.Generator) -> Array:
    """Draw nodes in a row with growing gaps, in random order."""
    x = np.array([1.0, 2.0, 3.5, 6.0, 9.5])
    return rng.permutation(np.column_stack([x, np.round(rng.uniform(1, 1.2, 5), 2)]))


def keep_upward(rows: Pairs) -> Pairs:
    """Return the rows whose second index is the larger one."""
    return rows[rows[:, 0] < rows[:, 1]]


def keep_mutual(rows: Pairs) -> Pairs:
    """Return the pairs that occur in both directions."""
    pairs, times = np.unique(np.sort(rows, axis=1), axis=0, return_counts=True)
    return pairs[times == 2]

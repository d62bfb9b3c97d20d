"""The exercise `radius_neighbours`. Bullo & Smith, chapter 5; LaValle, section 5.6."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from ....geometry.checks import Array
from ...exercise import Case, Change, Slip
from ...shapes import Number, Record
from ...withheld import withheld
from ..shared.planned import ProblemShape
from .halls import GRAZING, WALL, draw_free_nodes, make_hall, measure_distances
from .joining import allow_contact, check_samples, ignore_wrap, keep_free
from .rules import NODES, ROUND, Pairs, RuleExercise, draw_worlds, make_case, make_pairs


@withheld
def join_by_radius(problem: Any, nodes: Array, r: float) -> Pairs:
    """Return the pairs at most r apart whose motion is free."""
    return keep_free(
        problem, nodes, np.argwhere(np.triu(measure_distances(problem, nodes) <= r, 1))
    )


def leave_out_short(joined: Callable[..., Pairs], problem: Any, nodes: Array, r: float) -> Pairs:
    """Return the pairs that a program joins, without those at most three quarters of r apart."""
    pairs, short = (joined(problem, nodes, reach).tolist() for reach in (r, 0.75 * r))
    return np.array([pair for pair in pairs if pair not in short], np.int64).reshape(-1, 2)


def join_start_far(joined: Callable[..., Pairs], problem: Any, nodes: Array, r: float) -> Pairs:
    """Return the pairs that a program joins, and with node 0 those at most twice r apart."""
    pairs, far = (joined(problem, nodes, reach) for reach in (r, 2.0 * r))
    return np.vstack([pairs[pairs.min(axis=1) > 0], far[far.min(axis=1) == 0]])


class RadiusNeighbours(RuleExercise):
    """Find the pairs that the r-radius rule joins."""

    name = "radius_neighbours"
    kinds = ("pair", "wall", "many", "torus")
    given = Record(problem=ProblemShape(), nodes=NODES, r=Number())
    reference = staticmethod(join_by_radius)
    changes = (
        Change("long_edges", lambda joined, p, q, r: leave_out_short(joined, p, q, r)),
        Change("far_from_start", lambda joined, p, q, r: join_start_far(joined, p, q, r)),
    )
    source = staticmethod(join_by_radius)
    slips = (
        Slip("strict", lambda p, q, r: join_by_radius(p, q, np.nextafter(r, 0.0))),
        Slip("blind", lambda p, q, r: np.argwhere(np.triu(measure_distances(p, q) <= r, 1))),
        Slip(
            "twice",
            lambda p, q, r: np.vstack([join_by_radius(p, q, r), join_by_radius(p, q, r)[:, ::-1]]),
        ),
        Slip(
            "itself",
            lambda p, q, r: np.vstack(
                [join_by_radius(p, q, r), np.repeat(np.arange(len(q)), 2).reshape(-1, 2)]
            ),
        ),
        Slip("straight", lambda p, q, r: join_by_radius(ignore_wrap(p), q, r)),
        Slip("touching", lambda p, q, r: join_by_radius(allow_contact(p), q, r)),
        Slip("sampled", lambda p, q, r: join_by_radius(check_samples(p), q, r)),
        Slip("squared", lambda p, q, r: join_by_radius(p, q, np.sqrt(r))),
        Slip("diameter", lambda p, q, r: join_by_radius(p, q, r / 2)),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield two nodes, three nodes and a wall, then random nodes."""
        for row, far in (
            (((2, 2), (4, 2)), 3),
            (((2, 2), (6, 5)), 5),
            (((2, 2), (6, 5)), 4),
            (((2, 2), (6.00001, 5)), 5),  # a little more than r apart
            (((1, 1), (4, 5), (7, 1)), 5),
            (((1, 1), (1, 1), (3, 1)), 1),
        ):
            yield make_case("pair", make_hall(), row, float(far))
        yield make_case("wall", make_hall(WALL), ((5, 3), (11, 3)), 8.0)
        yield make_case("wall", make_hall(WALL), ((5, 3), (11, 3), (8, 8)), 8.0)
        yield from make_pairs(8.0)
        yield make_case("wall", make_hall(WALL), GRAZING, 4.0)
        for i in range(ROUND):
            at = rng.integers(1, 5, 2)
            yield make_case(
                "pair", make_hall(), (at, at + ((3, 4), (4, 3))[i % 2]), (5.0, 4.5, 5.0, 5.5)[i % 4]
            )
            for kind, problem in draw_worlds(rng, i):
                r = (
                    float(rng.integers(2, 6))
                    if kind != "torus"
                    else round(float(rng.uniform(1.0, 2.0)), 2)
                )
                yield make_case(kind, problem, draw_free_nodes(rng, problem, 4 + i), r)

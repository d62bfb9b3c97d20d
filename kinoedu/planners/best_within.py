"""As good a plan as there is time for: planners that draw at random are run again and again, and
the best plan is kept.
"""

import time
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ..geometry.checks import as_generator, positive
from ..problems import Plan


def best_within(
    seconds: float,
    planner: Callable[[np.random.Generator], Plan],
    *,
    rng: int | np.random.Generator,
) -> Plan:
    """The cheapest plan that a planner finds in so many seconds; at least one is made, however long
    it takes.

    Parameters
    ----------
    seconds : when to stop. Another plan is begun only while the longest so far would still end in
    time.
    planner : a function of a Generator that plans once, such as `lambda rng: rrt(problem,
    rng=rng)`.
    rng : a seed or a numpy Generator.

    Returns the best of the plans, with their number in `stats["plans"]`; without a path the last
    one. How many there is time for depends on the computer: unlike all else here this cannot be
    repeated to the last bit, but a quicker computer makes the same plans, and more of them. Raises
    InvalidParameter.

    >>> from kinoedu import Point, PolygonWorld, Problem, rrt
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [[(4, 0), (6, 0), (6, 8), (4, 8)]])
    >>> problem = Problem(Point(), world, start=(1, 1), goal=(9, 1))
    >>> best = best_within(0.05, lambda rng: rrt(problem, rng=rng), rng=0)
    >>> bool(best.cost <= rrt(problem, rng=np.random.default_rng(0)).cost)
    True
    """
    limit, generator = positive(seconds, "seconds"), as_generator(rng)
    began = time.monotonic()
    best, plans, longest = planner(generator), 1, 0.0
    longest = time.monotonic() - began
    while time.monotonic() - began + longest < limit:
        turn = time.monotonic()
        plan = planner(generator)
        longest, plans = max(longest, time.monotonic() - turn), plans + 1
        if plan.cost < best.cost or best.path is None:
            best = plan
    return replace(best, stats=best.stats | {"plans": plans})

"""The best of many plans within a time limit, for planners that use random numbers."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ..errors import InvalidParameter
from ..geometry.checks import as_generator, positive
from ..problems import Plan
from ..support.text import shortened
from .answers import plan_of


def best_within(
    seconds: float,
    planner: Callable[[np.random.Generator], Plan],
    *,
    rng: int | np.random.Generator,
) -> Plan:
    """The cheapest of the plans that a planner finds within a time limit.

    At least one plan is made, however long it takes. How many more there are depends on the
    computer, so the result cannot be repeated to the last bit. A faster computer makes the same
    plans and then more.

    Parameters
    ----------
    seconds : the time limit. Another plan is begun only if it would end in time, were it to take as
        long as the longest so far.
    planner : a function of a Generator that plans once, such as `lambda rng: rrt(problem,
        rng=rng)`.
    rng : a seed or a numpy Generator.

    Returns
    -------
    The best plan, or the last one where none has a path; `stats["plans"]` is the number of plans
    made.

    Raises
    ------
    InvalidParameter
        Where `seconds` is not a positive number, `planner` is not a function that returns a Plan,
        or `rng` is neither a seed nor a Generator.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem, rrt
    >>> wall = [(4, 0), (6, 0), (6, 8), (4, 8)]
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [wall])
    >>> problem = Problem(Point(), world, start=(1, 1), goal=(9, 1))
    >>> best = best_within(0.05, lambda rng: rrt(problem, rng=rng), rng=0)
    >>> bool(best.cost <= rrt(problem, rng=np.random.default_rng(0)).cost)
    True
    """
    limit, generator = positive(seconds, "seconds"), as_generator(rng)
    if not callable(planner):
        raise InvalidParameter(
            f"planner must be a function of a Generator, got {shortened(planner)}"
        )
    began = time.monotonic()
    best, plans = plan_of(planner(generator)), 1
    longest = time.monotonic() - began
    while time.monotonic() - began + longest < limit:
        plan_began = time.monotonic()
        plan = plan_of(planner(generator))
        longest, plans = max(longest, time.monotonic() - plan_began), plans + 1
        if plan.cost < best.cost or best.path is None:
            best = plan
    return replace(best, stats=best.stats | {"plans": plans})

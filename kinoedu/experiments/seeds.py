"""A number of many seeds: run a planner with each of them, and describe the spread in words."""

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidParameter
from ..geometry.checks import Array, as_generator, integer
from ..problems import Plan


def over_seeds(
    planner: Callable[..., Plan],
    problem: Any,
    seeds: int | Iterable[int],
    what: str = "cost",
    **tuning: Any,
) -> Array:
    """A number of a planner's plan for each seed.

    Parameters
    ----------
    planner : a planner with the keyword `rng`.
    seeds : the seeds, or how many of them, from 0 on.
    what : "cost", which is infinite where there is no path, or a name in the plan's `stats`.
    tuning : further keywords of the planner.

    Returns
    -------
    (n,)

    Raises
    ------
    InvalidParameter
        Where the plans have no such number.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem, rrt
    >>> problem = Problem(Point(), PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)]), (1, 1), (8, 5))
    >>> over_seeds(rrt, problem, 3, "nodes", step_size=20.0)
    array([2., 2., 2.])
    """
    numbers = seeds if isinstance(seeds, Iterable) else range(integer(seeds, "seeds", least=1))
    plans = (planner(problem, rng=seed, **tuning) for seed in numbers)
    return np.array([number_of(plan, what) for plan in plans])


def number_of(plan: Plan, what: str) -> float:
    """The cost of a plan, or one of its counts; or InvalidParameter."""
    if what == "cost":
        return float(plan.cost)
    if what not in plan.stats:
        raise InvalidParameter(f"what must be 'cost' or one of {sorted(plan.stats)}, got {what!r}")
    return float(plan.stats[what])


def describe_spread(values: ArrayLike, form: str = ".0f") -> str:
    """The median and the range of some numbers, in words; infinite ones are counted apart.

    Parameters
    ----------
    values : (n,), of n seeds; infinite where a run found nothing.
    form : how each number is written.

    Examples
    --------
    >>> describe_spread([739, 317, 1122])
    'median 739, from 317 to 1122 (3 seeds)'
    >>> describe_spread([1.5, 2.5, float("inf")], ".1f")
    'median 2.0, from 1.5 to 2.5 (2 of 3 seeds)'
    """
    given = np.asarray(values, float)
    found = given[np.isfinite(given)]
    if not len(found):
        return f"none (of {len(given)} seeds)"
    how_many = f"{len(given)}" if len(found) == len(given) else f"{len(found)} of {len(given)}"
    low, middle, high = found.min(), np.median(found), found.max()
    return f"median {middle:{form}}, from {low:{form}} to {high:{form}} ({how_many} seeds)"


def best_of_restarts(
    planner: Callable[..., Plan],
    problem: Any,
    iterations: int,
    *,
    rng: int | np.random.Generator,
    **tuning: Any,
) -> Plan:
    """The cheapest plan that a planner finds when it starts again until its iterations are used.

    So a planner that stops at its first path can be compared with one that goes on.

    Parameters
    ----------
    planner : a planner with the keywords `max_iterations` and `rng` that counts its iterations.
    iterations : of all runs together.
    tuning : further keywords of the planner.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem, rrt
    >>> problem = Problem(Point(), PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)]), (1, 1), (8, 5))
    >>> once, often = (best_of_restarts(rrt, problem, n, rng=0) for n in (100, 1000))
    >>> bool(often.cost <= once.cost)
    True
    """
    generator, left = as_generator(rng), integer(iterations, "iterations", least=1)
    best = planner(problem, max_iterations=left, rng=generator, **tuning)
    left -= max(1, int(best.stats["iterations"]))
    while left > 0:
        plan = planner(problem, max_iterations=left, rng=generator, **tuning)
        left -= max(1, int(plan.stats["iterations"]))
        best = min(best, plan, key=lambda found: found.cost)
    return best

"""Sampling for trees that improve their path: everywhere, or where a shorter path may pass.

J. D. Gammell, S. S. Srinivasa, T. D. Barfoot, "Informed RRT*: optimal sampling-based path planning
focused via direct sampling of an admissible ellipsoidal heuristic" (2014).
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from ...compiled import generic
from ...geometry.checks import Array
from ...problems import ProblemRecord, Recorder
from ...problems.protocols import PlanningProblem
from ...spaces.between import sample_between

TRIES = 1000  # draws until one falls where it may help; the last is taken as it is


class Everywhere(NamedTuple):
    """Sample the whole space; until there is a path, the goal with probability `goal_bias`."""

    goal_bias: float


class Informed(NamedTuple):
    """As Everywhere, but once there is a path only where a shorter one may pass."""

    goal_bias: float


@generic(1)
def draw_sample(
    sampler: Any, problem: PlanningProblem, shortest: float, rng: np.random.Generator
) -> Array:
    """A sample, given the length of the shortest path so far, which is infinite without one."""
    raise TypeError("sampler must be Everywhere or Informed")


@draw_sample.register(Everywhere)
def sample_everywhere(
    sampler: Everywhere, problem: PlanningProblem, shortest: float, rng: np.random.Generator
) -> Array:
    """The goal with probability goal_bias, until there is a path; else a uniform sample."""
    if shortest == np.inf and rng.random() < sampler.goal_bias:
        return problem.goal
    return problem.sample(rng)


@draw_sample.register(Informed)
def sample_informed(
    sampler: Informed, problem: PlanningProblem, shortest: float, rng: np.random.Generator
) -> Array:
    """The goal or, once there is a path, a sample of where a shorter one may pass."""
    if shortest < np.inf:
        return sample_shorter(problem, shortest, rng)
    return problem.goal if rng.random() < sampler.goal_bias else problem.sample(rng)


@generic(1)
def sample_shorter(problem: PlanningProblem, length: float, rng: np.random.Generator) -> Array:
    """A uniform sample of the q with |start - q| + |q - goal| < length, in the plane an ellipse.

    Samples of a reader's own problem are rejected until one fits, which works for any distance.
    """
    q = problem.sample(rng)
    for _ in range(TRIES):
        if problem.distance(problem.start, q) + problem.distance(q, problem.goal) < length:
            break
        q = problem.sample(rng)
    return q


@sample_shorter.register(ProblemRecord)
def sample_in_space(problem: ProblemRecord, length: float, rng: np.random.Generator) -> Array:
    """Drawn from the ellipse itself, where the space has one."""
    return sample_between(problem.space, problem.start, problem.goal, length, rng)


@sample_shorter.register(Recorder)
def sample_as_recorded(problem: Recorder, length: float, rng: np.random.Generator) -> Array:
    """The sample of the recorded problem; nothing is recorded."""
    return sample_shorter(problem.problem, length, rng)

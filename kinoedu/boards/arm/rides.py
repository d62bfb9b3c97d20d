"""A plan of an arm on its board: what was built and the path on the square of angles, and the arm
that rides along it in both.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from ...errors import KinoeduError
from ...figures.drawing import growth_of, summary
from ...figures.robots import spread, track_of
from ...geometry.checks import Array
from ...problems import Plan, Problem, ProblemRecord
from ...robots.arm import ArmRobot
from ..core.drawing import Layer, bodies, dots, edges
from ..planning.own import Attempt, attempt, result
from .arm_drawn import outlines
from .glued import split

STEPS = 120  # of a ride


class Ride(NamedTuple):
    """What came of a planner: the plan, or the attempt of a reader's own; what is said of it; path
    (n, 2), and the configurations (k, 2) at the steps of a ride along it, none without a path."""

    plan: Plan | Attempt | None
    text: str
    path: Array
    stops: Array

    @property
    def total(self) -> int:
        """How many steps it has."""
        return max(len(self.stops) - 1, 0)


def ride_of(
    planner: Callable[..., Any], arm: ArmRobot, world: Any, ends: tuple[Array, Array], seed: int
) -> Ride:
    """Let a planner join two configurations, or say what hinders it; a reader's own is judged and
    stopped as on `board`.
    """
    nowhere = np.empty((0, 2))
    try:
        problem = Problem(arm, world, *ends)
        plan = planner(problem, rng=seed) if is_ours(planner) else attempt(planner, problem, seed)
    except KinoeduError as error:
        return Ride(None, str(error), nowhere, nowhere)
    text = told(plan)
    path = nowhere if plan.path is None else np.asarray(plan.path)
    return Ride(plan, text, path, stops_along(problem, path))


def is_ours(planner: Callable[..., Any]) -> bool:
    """Whether a planner is one of this package's."""
    return getattr(planner, "__module__", "").startswith("kinoedu.planners")


def told(plan: Plan | Attempt) -> str:
    """What came of it, in words."""
    if isinstance(plan, Plan):
        return summary(plan, growth_of(plan)[0])
    return plan.fault or result(plan.length, plan.motions)


def stops_along(problem: ProblemRecord, path: Array) -> Array:
    """Configurations evenly along a path, its ends included, (k, 2)."""
    if len(path) == 0:
        return path
    return np.array([path[0], *spread(problem.space, path, STEPS - 1), path[-1]])


def ride_in_workspace(arm: ArmRobot, ride: Ride) -> list[Layer]:
    """The way of the tip, and the arm at each step."""
    if ride.total == 0:
        return []
    shapes, steps = (
        np.concatenate([outlines(arm, q) for q in ride.stops]),
        np.repeat(np.arange(ride.total + 1), 2),
    )
    track = track_of(arm, ride.path)
    return [
        *line(np.stack([track[:-1], track[1:]], axis=1)),
        bodies(shapes, "robot", when=steps, until=steps + 1),
    ]


def ride_in_square(ride: Ride) -> list[Layer]:
    """What the planner built, its path, cut where it crosses a side, and the configuration at each
    step.
    """
    steps = np.arange(len(ride.stops))
    here = [
        dots(ride.stops, colour, radius=r, when=steps, until=steps + 1)
        for colour, r in (("free", 9.0), ("robot", 7.0))
    ]
    return [
        *built(ride.plan),
        *(line(split(ride.path[:-1], ride.path[1:])) + here if ride.total else []),
    ]


def built(plan: Any) -> list[Layer]:
    """The tree or the roadmap of a plan on the square."""
    if getattr(plan, "tree", None) is not None:
        grown = np.flatnonzero(plan.tree.parent >= 0)
        return [
            edges(split(plan.tree.nodes[plan.tree.parent[grown]], plan.tree.nodes[grown]), "tree")
        ]
    if getattr(plan, "roadmap", None) is not None:
        ends = plan.roadmap.nodes[plan.roadmap.edges]
        return [edges(split(ends[:, 0], ends[:, 1]), "roadmap", width=0.8)]
    return []


def line(segments: Array) -> list[Layer]:
    """Segments as a path is drawn, on a dark casing."""
    return [edges(segments, "ink", width=5.0), edges(segments, "path", width=3.0)]

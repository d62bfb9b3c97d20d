"""A plan of an arm on its board: tree or roadmap and path in the square, and the moving arm."""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from ...errors import KinoeduError
from ...figures.drawing import growth_of, summary
from ...figures.robots import spread_configurations, track_of
from ...geometry.checks import Array
from ...planners.own import call_planner, is_own
from ...problems import Plan, Problem, ProblemRecord
from ...robots.arm import ArmRobot
from ...worlds.checks import World
from ..core.drawing import Layer, bodies, dots, edges, path_edges, segments_along
from ..planning.own import Attempt, describe_result, try_planner
from .arm_drawn import link_outlines
from .glued import split_motions

STEPS = 120  # of a ride


class Ride(NamedTuple):
    """The result of a planner, in words too, and a ride along its path.

    Attributes
    ----------
    plan : the plan, or the Attempt of a reader's planner; None where there was no valid problem.
    text : the result in words.
    path : (n, 2), empty without a path.
    stops : (k, 2), the configurations at the steps of the ride.
    """

    plan: Plan | Attempt | None
    text: str
    path: Array
    stops: Array

    @property
    def total(self) -> int:
        """The number of its steps."""
        return max(len(self.stops) - 1, 0)


def plan_ride(
    planner: Callable[..., Any],
    arm: ArmRobot,
    world: World,
    ends: tuple[Array, Array],
    seed: int,
) -> Ride:
    """Plan between two configurations, or say why that is impossible.

    A reader's planner is judged and stopped as on `board`.
    """
    nowhere = np.empty((0, 2))
    try:
        problem = Problem(arm, world, *ends)
        run = try_planner if is_own(planner) else call_planner
        plan = run(planner, problem, seed)
    except KinoeduError as error:
        return Ride(None, str(error), nowhere, nowhere)
    text = describe_plan(plan)
    path = nowhere if plan.path is None else np.asarray(plan.path)
    return Ride(plan, text, path, spread_stops(problem, path))


def describe_plan(plan: Plan | Attempt) -> str:
    """The result of a plan or an attempt, in words."""
    if isinstance(plan, Plan):
        return summary(plan, growth_of(plan)[0])
    return plan.fault or describe_result(plan.length, plan.motions)


def spread_stops(problem: ProblemRecord, path: Array) -> Array:
    """Equally spaced configurations along a path, ends included, (k, 2)."""
    if len(path) == 0:
        return path
    return np.array([path[0], *spread_configurations(problem.space, path, STEPS - 1), path[-1]])


def draw_ride_in_workspace(arm: ArmRobot, ride: Ride) -> list[Layer]:
    """Draw the path of the tip, and the arm at each step."""
    if ride.total == 0:
        return []
    shapes = np.concatenate([link_outlines(arm, q) for q in ride.stops])
    steps = np.repeat(np.arange(ride.total + 1), 2)
    return [
        *path_edges(segments_along(track_of(arm, ride.path))),
        bodies(shapes, "robot", when=steps, until=steps + 1),
    ]


def draw_ride_in_square(ride: Ride) -> list[Layer]:
    """Draw tree or roadmap, the path cut at the sides, and the configuration at each step."""
    steps = np.arange(len(ride.stops))
    here = [
        dots(ride.stops, colour, radius=r, when=steps, until=steps + 1)
        for colour, r in (("free", 9.0), ("robot", 7.0))
    ]
    if ride.total == 0:
        return draw_growth(ride.plan)
    return [
        *draw_growth(ride.plan),
        *path_edges(split_motions(ride.path[:-1], ride.path[1:])),
        *here,
    ]


def draw_growth(plan: Any) -> list[Layer]:
    """Draw the tree or the roadmap of a plan on the square."""
    if getattr(plan, "tree", None) is not None:
        nodes, parent = plan.tree.nodes, plan.tree.parent
        grown = np.flatnonzero(parent >= 0)
        return [edges(split_motions(nodes[parent[grown]], nodes[grown]), "tree")]
    if getattr(plan, "roadmap", None) is not None:
        ends = plan.roadmap.nodes[plan.roadmap.edges]
        return [edges(split_motions(ends[:, 0], ends[:, 1]), "roadmap", width=0.8)]
    return []

"""Common parts of the planners that drive a car: targets, random drives, and trees of drives.

S. M. LaValle, J. J. Kuffner, "Randomized kinodynamic planning" (2001).
"""

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...compiled import callable_from_compiled, compiled
from ...errors import InvalidParameter
from ...geometry.checks import Array
from ...graphs import extract_path
from ...problems import Plan, ProblemRecord, Recorder
from ...problems.protocols import CarProblem
from ...problems.recorder import record_as, unwrap_recorder
from ...robots.car import CarRobot
from ...robots.trajectory import DrivenTree, TrajectoryRecord
from ...spaces import SE2
from ...spaces.angles import angle_difference, wrap_angle
from ...spaces.buckets import GrowingTree, add
from ...support.text import shortened
from ..problem_input import new_tree
from ..tuning import positive
from .parameters import DrivesRecord, GoalBiasRecord, GoalRegionRecord


class DrivenGrowth(NamedTuple):
    """A growing tree with the control (v, phi) that leads to each node, and its duration."""

    tree: GrowingTree
    controls: Array
    durations: Array


@callable_from_compiled
def next_target(
    problem: Any, bias: GoalBiasRecord, iteration: int, rng: np.random.Generator
) -> Array:
    """The target of an iteration, counted from 1."""
    if bias.region_every > 0 and iteration % bias.region_every == 0:
        off, towards = bias.region * rng.random(), 2.0 * math.pi * rng.random()
        heading = wrap_angle(problem.goal[2] + bias.region_turn * (2.0 * rng.random() - 1.0))
        x, y = problem.goal[0] + off * math.cos(towards), problem.goal[1] + off * math.sin(towards)
        return np.array([x, y, heading])
    if bias.goal_every > 0 and iteration % bias.goal_every == 0:
        return problem.goal.copy()
    return problem.sample(rng)


@callable_from_compiled
def free_drive(
    problem: Any, q: Array, q_rand: Array, drives: DrivesRecord, rng: np.random.Generator
) -> tuple[float, float, float]:
    """A free drive from q towards q_rand: a control (v, phi) and its duration.

    Of M random controls it is the one that comes closest to q_rand, ended where it is closest.
    Where that drive is not free, another M controls are drawn; after the last batch the duration is
    0.
    """
    there = np.empty(3)
    for _ in range(drives.batches):
        best_v, best_phi, best_step, least = 0.0, 0.0, 0, np.inf
        for _ in range(drives.trials):
            v, phi = problem.control(rng)
            step, apart = closest_step(problem, q, q_rand, v, phi, drives, least, there)
            if step > 0:
                best_v, best_phi, best_step, least = v, phi, step, apart
        if problem.is_free_drive(q, best_v, best_phi, best_step * drives.time_step):
            return best_v, best_phi, best_step * drives.time_step
    return 0.0, 0.0, 0.0


@callable_from_compiled
def closest_step(
    problem: CarProblem,
    q: Array,
    q_rand: Array,
    v: float,
    phi: float,
    drives: DrivesRecord,
    least: float,
    there: Array,
) -> tuple[int, float]:
    """The step of a drive from q that comes closest to q_rand, and its distance.

    Only steps closer than `least` count; where there is none, the step is 0. While a control is
    held, the distance changes by at most a constant in each step, so steps that cannot be the
    closest are skipped.
    """
    turning = problem.space.weight[2] * problem.curvature(phi)
    pace = abs(v) * math.sqrt(1.0 + turning * turning) * drives.time_step
    best, k = 0, 1
    while k <= drives.steps:
        problem.drive(q, v, phi, k * drives.time_step, there)
        apart = problem.distance(there, q_rand)
        if apart < least:
            best, least = k, apart
        k += max(1, int((apart - least) / pace))
    return best, least


@callable_from_compiled
def add_drive(
    problem: CarProblem, growth: DrivenGrowth, parent: int, v: float, phi: float, t: float
) -> int:
    """Append the node that a control leads to from its parent; returns the node's number."""
    there = np.empty(3)
    problem.drive(growth.tree.nodes[parent], v, phi, t, there)
    node = add(growth.tree, there, parent)
    growth.controls[node, 0], growth.controls[node, 1], growth.durations[node] = v, phi, t
    return node


@compiled
def is_near(q: Array, goal: Array, near: GoalRegionRecord) -> bool:
    """Whether a pose counts as the goal."""
    dx, dy = q[0] - goal[0], q[1] - goal[1]
    return (
        math.sqrt(dx * dx + dy * dy) <= near.tolerance
        and abs(angle_difference(q[2], goal[2])) <= near.turn_tolerance
    )


def as_car_problem(
    problem: ProblemRecord | Recorder,
    planner: str,
    turn_weight: float | None,
    wheelbases: float = 0.25,
) -> CarProblem:
    """The problem of a car with the distance of SE(2), for planners that drive.

    A radian counts as `turn_weight` units of length; by default as `wheelbases` wheelbases.

    Raises
    ------
    InvalidParameter
        Where the robot is not a car, or `turn_weight` is not positive.
    """
    inner = check_car(problem, planner)
    weight = wheelbases * inner.robot.wheelbase
    if turn_weight is not None:
        weight = positive(turn_weight, "turn_weight")
    space = SE2(inner.world.lo, inner.world.hi, turn_weight=weight)
    car_problem: CarProblem = record_as(problem, inner._replace(space=space))
    return car_problem


def check_car(problem: ProblemRecord | Recorder, planner: str) -> ProblemRecord:
    """The problem of a car, without its recorder.

    Raises
    ------
    InvalidParameter
        Where the robot is not a car.
    """
    inner = unwrap_recorder(problem)
    if not isinstance(inner, ProblemRecord) or not isinstance(inner.robot, CarRobot):
        raise InvalidParameter(
            f"{planner} needs a Problem(Car(...), world, start, goal), got {shortened(problem)}"
        )
    return inner


def begin_tree(problem: Any, capacity: int) -> DrivenGrowth:
    """A tree that holds the start alone, with room for `capacity` nodes."""
    growth = DrivenGrowth(new_tree(problem, capacity), np.zeros((capacity, 2)), np.zeros(capacity))
    add.py_func(growth.tree, problem.start, -1)
    return growth


def copy_tree(growth: DrivenGrowth) -> DrivenTree:
    """A copy of the tree that has grown, without unused room."""
    n = int(growth.tree.size[0])
    tree = growth.tree
    return DrivenTree(
        tree.nodes[:n].copy(),
        tree.parent[:n].copy(),
        growth.controls[:n].copy(),
        growth.durations[:n].copy(),
    )


def trajectory_to(
    problem: CarProblem, tree: DrivenTree, numbers: NDArray[np.int64]
) -> TrajectoryRecord:
    """The trajectory along numbered nodes, the root first."""
    there = numbers[1:]
    return TrajectoryRecord(
        problem.start, tree.controls[there], tree.durations[there], problem.robot.wheelbase
    )


def plan_from_driven_tree(
    problem: CarProblem, growth: DrivenGrowth, at_goal: int, planner: str, stats: dict[str, int]
) -> Plan:
    """The plan to a node of a tree of drives; with -1, a plan without a path.

    Its trajectory then leads to the node nearest to the goal.
    """
    tree = copy_tree(growth)
    last = at_goal if at_goal >= 0 else int(problem.nearest(growth.tree, problem.goal))
    trajectory = trajectory_to(problem, tree, extract_path(tree.parent, last))
    stats = {"nodes": len(tree.nodes), **stats}
    return plan_from_trajectory(
        problem, trajectory, at_goal >= 0, planner=planner, tree=tree, stats=stats
    )


def plan_from_trajectory(
    problem: CarProblem, trajectory: TrajectoryRecord, arrived: bool, **built: Any
) -> Plan:
    """The plan along a trajectory; where it only comes near the goal, a plan without a path."""
    if arrived:
        return Plan(
            trajectory.poses, trajectory.length, trajectory=trajectory, problem=problem, **built
        )
    x, y, theta = trajectory.poses[-1]
    distance, angle = math.dist((x, y), problem.goal[:2]), abs(wrap_angle(theta - problem.goal[2]))
    reason = (
        "no pose is near enough to the goal; the trajectory leads to the nearest one, "
        f"{distance:.3g} away and {math.degrees(angle):.3g} degrees askew: allow more iterations, "
        "or a larger tolerance"
    )
    return Plan(None, math.inf, trajectory=trajectory, reason=reason, problem=problem, **built)

"""Driving by arrow keys: each moment is one control, applied until something is in the way.

The drive is a trajectory like any other.
"""

from collections.abc import Set
from typing import NamedTuple

import numpy as np

from ...collision import is_free, is_free_drive
from ...geometry.checks import Array
from ...planners.driving.common import is_near
from ...planners.driving.parameters import GoalRegion, as_goal_region
from ...problems import ProblemRecord
from ...robots.car import CarRobot
from ...robots.trajectory import Trajectory, TrajectoryRecord

NOTCHES = 8  # of the steering wheel either way
MOMENT = 0.06  # the distance driven in one moment, in wheelbases
# The fraction of a moment's way that is left before a contact, so that the car can back off
# despite rounding.
SHORT = 1e-6


class Drive(NamedTuple):
    """A trajectory driven, the notch of the wheel (positive: left), and whether it was stopped."""

    trajectory: TrajectoryRecord
    notch: int
    stopped: bool


def start_drive(problem: ProblemRecord) -> Drive:
    """The drive of a car that stands at its start."""
    return Drive(Trajectory(problem.robot, problem.start, np.empty((0, 2)), []), 0, False)


def continue_drive(problem: ProblemRecord, drive: Drive, held: Set[str]) -> Drive:
    """The drive after one more moment with arrow keys held.

    Left and right steer by a notch, up and down drive. The wheel stays where it is when keys are
    released. Opposite keys cancel out. A motion in collision is cut before the contact.
    """
    notch = drive.notch + ("ArrowLeft" in held) - ("ArrowRight" in held)
    notch = int(np.clip(notch, -NOTCHES, NOTCHES))
    v = greatest_speed(problem.robot, ("ArrowUp" in held) - ("ArrowDown" in held))
    if v == 0.0:
        return drive._replace(notch=notch)
    phi, moment = steering_angle(problem.robot, notch), MOMENT * problem.robot.wheelbase / abs(v)
    trajectory, stopped = extend_trajectory(problem, drive.trajectory, v, phi, moment)
    return Drive(trajectory, notch, stopped)


def greatest_speed(car: CarRobot, direction: int) -> float:
    """A car's greatest speed forward, direction 1, or backward, -1; 0 where it has none."""
    if direction == 0:
        return 0.0
    return float(max(car.speeds.max(), 0.0) if direction > 0 else min(car.speeds.min(), 0.0))


def steering_angle(car: CarRobot, notch: int) -> float:
    """The steering angle at a notch of the wheel."""
    return car.max_steering * notch / NOTCHES


def extend_trajectory(
    problem: ProblemRecord, trajectory: TrajectoryRecord, v: float, phi: float, moment: float
) -> tuple[TrajectoryRecord, bool]:
    """A trajectory extended by a control for a moment, and whether something is in the way.

    If the control is the last one again, its arc is extended and judged as a whole, from where it
    began.
    """
    controls, durations, poses = trajectory.controls, trajectory.durations, trajectory.poses
    again = len(controls) > 0 and controls[-1].tolist() == [v, phi]
    before = float(durations[-1]) if again else 0.0
    time, stopped = find_free_time(
        problem, poses[-2 if again else -1], v, phi, before, before + moment
    )
    if time > before:
        count = len(controls) - again
        controls = np.vstack([controls[:count], (v, phi)])
        durations = np.append(durations[:count], time)
    return trajectory._replace(controls=controls, durations=durations), stopped


def find_free_time(
    problem: ProblemRecord, pose: Array, v: float, phi: float, least: float, most: float
) -> tuple[float, bool]:
    """How long a control can be applied from a pose, and whether something is in the way.

    Parameters
    ----------
    least : a duration known to be free.
    most : the longest duration wanted.
    """
    robot, world, clearance = problem.robot, problem.world, problem.clearance
    curvature = robot.curvature(phi)

    def is_free_for(time: float) -> bool:
        return is_free_drive(robot, world, pose, v * time, curvature, clearance)

    if is_free_for(most):
        return most, False
    short, first, farthest = SHORT * (most - least), least, most
    while first < (middle := 0.5 * (first + farthest)) < farthest:
        first, farthest = (middle, farthest) if is_free_for(middle) else (first, middle)
    time = max(first - short, least)
    there = robot.move(pose, v, phi, time)
    return (time if is_free(robot, world, there, clearance) else least), True


def is_at_goal(problem: ProblemRecord, pose: Array) -> bool:
    """Whether a pose counts as the goal, by the default `GoalRegion`."""
    return is_near(pose, problem.goal, as_goal_region(problem, GoalRegion()))

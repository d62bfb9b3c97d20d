"""Driving by arrow keys: each moment is a control, held while nothing is in the way. The drive is a
trajectory like any other.
"""

import math
from collections.abc import Set
from typing import NamedTuple

import numpy as np

from ...collision import is_free, is_free_drive
from ...geometry.checks import Array
from ...planners.driving.common import is_near, near_of
from ...problems import ProblemRecord
from ...robots.car import CarRobot
from ...robots.trajectory import Trajectory, TrajectoryRecord

NOTCHES = 8  # of the steering wheel either way
MOMENT = 0.06  # wheelbases that the car goes while a key is held for a moment
# of a moment's way is left before what the car comes upon: so it can back off, whatever rounding
# does
SHORT = 1e-6


class Drive(NamedTuple):
    """What was driven, the notch of the steering wheel (positive to the left), and whether
    something is in the way.
    """

    trajectory: TrajectoryRecord
    notch: int
    stopped: bool


def standing_at(problem: ProblemRecord) -> Drive:
    """Nothing is driven yet."""
    return Drive(Trajectory(problem.robot, problem.start, np.empty((0, 2)), []), 0, False)


def driven_on(problem: ProblemRecord, drive: Drive, held: Set[str]) -> Drive:
    """The drive after one more moment in which arrow keys are held: left and right steer by a
    notch, up and down drive.

    The wheel stays where it is let. Keys against each other do nothing. What cannot be driven is
    left out, up to the contact.
    """
    notch = drive.notch + ("ArrowLeft" in held) - ("ArrowRight" in held)
    notch = int(np.clip(notch, -NOTCHES, NOTCHES))
    v = speed(problem.robot, ("ArrowUp" in held) - ("ArrowDown" in held))
    if v == 0.0:
        return drive._replace(notch=notch)
    phi, moment = steering(problem.robot, notch), MOMENT * problem.robot.wheelbase / abs(v)
    trajectory, stopped = held_on(problem, drive.trajectory, v, phi, moment)
    return Drive(trajectory, notch, stopped)


def speed(car: CarRobot, way: int) -> float:
    """The fastest of a car's speeds forward, 1, or back, -1; 0 where it has none."""
    return float(
        max(car.speeds.max(), 0.0) if way > 0 else min(car.speeds.min(), 0.0) if way < 0 else 0.0
    )


def steering(car: CarRobot, notch: int) -> float:
    """The steering angle at a notch of the wheel."""
    return car.max_steering * notch / NOTCHES


def held_on(
    problem: ProblemRecord, trajectory: TrajectoryRecord, v: float, phi: float, moment: float
) -> tuple[TrajectoryRecord, bool]:
    """A trajectory after a control was held for a moment more, or until something is in the way;
    and whether it is.

    A control that is held on is one arc, not many: it is judged whole, from where it began.
    """
    controls, durations, poses = trajectory.controls, trajectory.durations, trajectory.poses
    again = len(controls) > 0 and controls[-1].tolist() == [v, phi]
    before = float(durations[-1]) if again else 0.0
    time, stopped = free_time(problem, poses[-2 if again else -1], v, phi, before, before + moment)
    if time > before:
        kept = len(controls) - again
        controls, durations = (
            np.vstack([controls[:kept], (v, phi)]),
            np.append(durations[:kept], time),
        )
    return trajectory._replace(controls=controls, durations=durations), stopped


def free_time(
    problem: ProblemRecord, pose: Array, v: float, phi: float, least: float, most: float
) -> tuple[float, bool]:
    """For how long a control can be held from a pose, at most `most`, if `least` is free; and
    whether something is in the way.
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


def at_goal(problem: ProblemRecord, pose: Array) -> bool:
    """Whether a pose counts as the goal: as near as `kinodynamic_rrt` asks by default."""
    near = near_of(problem, None, math.radians(15.0))
    return is_near(pose, problem.goal, near)

"""The scene of a car: start and goal, each a place and a tip that it looks at, and the car."""

import math
from collections.abc import Iterable, Sequence

import numpy as np

from ...geometry.checks import Array
from ...messages import get_message
from ...problems import ProblemRecord
from ...robots.car import CarRobot
from ..core.scene import Scene, handle, mark_drawn, mark_driven
from ..planning.plans import make_world_scene

NAMES = ("start", "start_looks", "goal", "goal_looks", "car")
CAR = 4  # the number of the handle that is driven
BEFORE = 0.35  # the distance from the car's front to its tip, in wheelbases


def make_car_scene(problem: ProblemRecord) -> Scene:
    """The scene of a problem's world, with the handles of its poses."""
    places = handle_places(problem.robot, problem.start, problem.goal, problem.start)
    handles = [
        mark_drawn(handle(get_message(f"car_board.{name}"), at, colour="ink"))
        for name, at in zip(NAMES, places, strict=True)
    ]
    return {
        **make_world_scene(problem.world, [*handles[:CAR], mark_driven(handles[CAR])]),
        "posed": True,
    }


def handle_places(car: CarRobot, start: Array, goal: Array, here: Array) -> list[Array]:
    """The positions of the handles for a start, a goal, and the car's present pose `here`."""
    return [
        start[:2],
        tip_of(car, start),
        goal[:2],
        tip_of(car, goal),
        body_middles(car, here[None])[0],
    ]


def poses_in(scene: Scene, car: CarRobot, former: Iterable[tuple[Array, Array]]) -> list[Array]:
    """The poses of start and goal, from their handles.

    former : pairs (start, goal). A tip that stands exactly where a former pose has it keeps that
        heading to the last digit, so that moving a place does not turn the pose.
    """
    start, start_tip, goal, goal_tip = (np.array(h["at"]) for h in scene["handles"][:CAR])
    starts, goals = zip(*former, strict=True)
    return [
        pose_from_handles(start, start_tip, car, starts),
        pose_from_handles(goal, goal_tip, car, goals),
    ]


def pose_from_handles(place: Array, tip: Array, car: CarRobot, former: Sequence[Array]) -> Array:
    """The pose at a place that looks at a tip."""
    for pose in former:
        if np.array_equal(tip, tip_of(car, pose)):
            return np.array([*place, pose[2]])
    return np.array([*place, math.atan2(tip[1] - place[1], tip[0] - place[0])])


def tip_of(car: CarRobot, pose: Array) -> Array:
    """The point in front of the car that a pose looks at."""
    reach = float(car.outline[:, 0].max()) + BEFORE * car.wheelbase
    return pose[:2] + reach * np.array([math.cos(pose[2]), math.sin(pose[2])])


def body_middles(car: CarRobot, poses: Array) -> Array:
    """The midpoints of the car's body at poses (m, 3), shape (m, 2)."""
    ahead = 0.5 * float(car.outline[:, 0].max() + car.outline[:, 0].min())
    return poses[:, :2] + ahead * np.column_stack([np.cos(poses[:, 2]), np.sin(poses[:, 2])])

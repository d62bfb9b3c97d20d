"""The bodies of the bugs' board: a bug's walk, and its distance to the goal."""

from typing import NamedTuple

import numpy as np

from ..compiled import algorithm, compiled
from ..geometry.checks import Array
from ..geometry.rings import SIMPLE
from ..planners.bugs.bug0 import bug0_walk
from ..planners.bugs.bug1 import bug1_walk
from ..planners.bugs.bug2 import bug2_walk
from ..planners.bugs.bug2_prelim import bug2_prelim_walk
from ..planners.bugs.bug_base import bug_base_walk
from ..planners.bugs.robot import BugRobot, corners_of, new_robot
from ..planners.bugs.trail import HITS, LEAVES, SIZE
from ..planners.bugs.walk import divide_moves, measure_moves
from ..planners.bugs.walls import Walls, contact, rings_meet, walls_of_rings
from .scenes import REFUSED, SceneArrays, find_fault, refuse_ring, rings_of_scene
from .walks import Course, ShownWalk, show_nothing, show_walk

START_IN_WALL, GOAL_ON_WALL, UNITED = REFUSED, REFUSED - 1, REFUSED - 2


class BugSettings(NamedTuple):
    """The settings of a bug's board.

    turn : 1 to turn right at a wall, -1 to turn left.
    step : the longest distance between two points of the walk.
    """

    turn: float
    step: float


@algorithm
def show_bug_base(scene: SceneArrays, settings: BugSettings, rng: np.random.Generator) -> ShownWalk:
    """A walk of BugBase."""
    refused, robot = pose_bug(scene, settings)
    return show(refused, robot, bug_base_walk(robot), settings.step)


@algorithm
def show_bug0(scene: SceneArrays, settings: BugSettings, rng: np.random.Generator) -> ShownWalk:
    """A walk of Bug 0."""
    refused, robot = pose_bug(scene, settings)
    return show(refused, robot, bug0_walk(robot), settings.step)


@algorithm
def show_bug1(scene: SceneArrays, settings: BugSettings, rng: np.random.Generator) -> ShownWalk:
    """A walk of Bug 1, which takes the shorter way back."""
    refused, robot = pose_bug(scene, settings)
    return show(refused, robot, bug1_walk(robot, True), settings.step)


@algorithm
def show_bug2_prelim(
    scene: SceneArrays, settings: BugSettings, rng: np.random.Generator
) -> ShownWalk:
    """A walk of Bug 2.prelim."""
    refused, robot = pose_bug(scene, settings)
    return show(refused, robot, bug2_prelim_walk(robot), settings.step)


@algorithm
def show_bug2(scene: SceneArrays, settings: BugSettings, rng: np.random.Generator) -> ShownWalk:
    """A walk of Bug 2."""
    refused, robot = pose_bug(scene, settings)
    return show(refused, robot, bug2_walk(robot), settings.step)


@compiled
def pose_bug(scene: SceneArrays, settings: BugSettings) -> tuple[Array, BugRobot]:
    """The facts of an answer that refuses a scene, zeros where a bug can walk, and its robot.

    In a scene that is refused the robot has no walls.
    """
    start, goal = scene.handles[0, :2].copy(), scene.handles[1, :2].copy()
    ring, fault = find_fault(scene)
    facts, walls = np.zeros(3), walls_of_rings(np.empty((0, 2)), np.zeros(1, np.int64))
    if fault.kind != SIMPLE:
        facts = refuse_ring(ring, fault)
    elif any_touch(scene):
        facts[0] = UNITED
    else:
        walls = walls_of_rings(rings_of_scene(scene).points, scene.first)
        if contact(walls, start) >= 0:
            facts = np.array([START_IN_WALL, start[0], start[1]])
        elif contact(walls, goal) == 0:
            facts = np.array([GOAL_ON_WALL, goal[0], goal[1]])
        if facts[0] < 0.0:
            walls = walls_of_rings(np.empty((0, 2)), np.zeros(1, np.int64))
    return facts, new_robot(walls, start, goal, int(settings.turn))


@compiled
def any_touch(scene: SceneArrays) -> bool:
    """Whether two obstacles, taken as solid, share a point."""
    points, first = scene.points, scene.first
    for i in range(1, len(first) - 1):
        for j in range(1, i):
            if rings_meet(points[first[i] : first[i + 1]], points[first[j] : first[j + 1]]):
                return True
    return False


@compiled
def show(refused: Array, robot: BugRobot, outcome: int, step: float) -> ShownWalk:
    """What is shown of a walk that has ended, unless its scene is refused."""
    if refused[0] < 0.0:
        return show_nothing(refused)
    corners, trail = corners_of(robot), robot.trail
    following = trail.following[: trail.counts[SIZE]]
    lengths, pieces = measure_moves(corners, step)
    points, along, travelled, number = divide_moves(corners, following, lengths, pieces)
    hits, leaves = trail.hits[: trail.counts[HITS]], trail.leaves[: trail.counts[LEAVES]]
    course = Course(points, along, travelled, number[hits], number[leaves])
    ends = np.empty((2, 2))
    ends[0], ends[1] = robot.start, robot.goal
    return show_walk(outcome, course, ends, sides_of_walls(robot.walls), step)


@compiled
def sides_of_walls(walls: Walls) -> Array:
    """The edges of walls, (n, 4)."""
    sides = np.empty((len(walls.points), 4))
    sides[:, :2], sides[:, 2:] = walls.points, walls.points[walls.after]
    return sides

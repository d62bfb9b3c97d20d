"""Collision detection for cars: along arcs and curves of arcs, by conservative advancement."""

import math

import numpy as np

from ..curves.arcs import drive_arc
from ..curves.space import pieces_between
from ..errors import InvalidParameter
from ..geometry.checks import Array
from ..robots.car import CarRobot
from ..robots.trajectory import TrajectoryRecord
from ..support.text import shortened
from ..worlds.checks import World, check_world
from ..worlds.polygon_world import PolygonWorldRecord
from ..worlds.terrain import TerrainRecord
from .interface import is_free, is_free_drive, is_free_path
from .turning import contact_size, first_in_contact


@is_free_drive.register(CarRobot, PolygonWorldRecord)
@is_free_drive.register(CarRobot, TerrainRecord)
def is_free_arc(
    robot: CarRobot, world: World, pose: Array, distance: float, curvature: float, clearance: float
) -> bool:
    """Conservative advancement along the arc."""
    contact = contact_size(world.lo, world.hi)
    change = np.array([distance, distance * curvature])
    return first_in_contact(robot, world, pose, change, clearance + contact, contact) < 0


@is_free.register(CarRobot, PolygonWorldRecord)
@is_free.register(CarRobot, TerrainRecord)
def is_free_pose(robot: CarRobot, world: World, q: Array, clearance: float) -> bool:
    """An arc of length zero."""
    return is_free_drive(robot, world, q, 0.0, 0.0, clearance)


@is_free_path.register(CarRobot, PolygonWorldRecord)
@is_free_path.register(CarRobot, TerrainRecord)
def is_free_curve(robot: CarRobot, world: World, a: Array, b: Array, clearance: float) -> bool:
    """Every arc of the shortest curve from a to b."""
    turns, lengths = pieces_between(a, b, robot.radius, robot.both_ways)
    pose = np.array([a[0], a[1], a[2]])
    for i in range(len(turns)):
        curvature = turns[i] / robot.radius
        if lengths[i] != 0.0 and not is_free_drive(
            robot, world, pose, lengths[i], curvature, clearance
        ):
            return False
        pose[0], pose[1], pose[2] = drive_arc(pose[0], pose[1], pose[2], lengths[i], curvature)
    return is_free_drive(robot, world, b, 0.0, 0.0, clearance)


def is_free_trajectory(
    robot: CarRobot, world: World, trajectory: TrajectoryRecord, clearance: float = 0.0
) -> bool:
    """Whether a car keeps more than `clearance` from every obstacle along a trajectory.

    Each control drives an arc, which is tested as a whole.

    Returns
    -------
    bool

    Raises
    ------
    InvalidWorld
        Where `world` is not a world.
    InvalidParameter
        Where `trajectory` is not a trajectory.

    Examples
    --------
    >>> from kinoedu import Car, PolygonWorld
    >>> from kinoedu.robots import Trajectory
    >>> car, world = Car(3, 1, 2), PolygonWorld([(0, 0), (20, 0), (20, 20), (0, 20)])
    >>> around = Trajectory(car, (10, 10, 0), [(1, 0.6)], [12])
    >>> is_free_trajectory(car, world, around), is_free_trajectory(car, world, around, 8)
    (True, False)
    """
    check_world(world)
    if not isinstance(trajectory, TrajectoryRecord):
        raise InvalidParameter(
            f"expected a Trajectory(car, start, controls, durations), got {shortened(trajectory)}"
        )
    begins, drives = trajectory.poses, zip(trajectory.controls, trajectory.durations)
    return is_free(robot, world, trajectory.start, clearance) and all(
        is_free_drive(robot, world, pose, v * t, math.tan(phi) / trajectory.wheelbase, clearance)
        for pose, ((v, phi), t) in zip(begins, drives)
    )

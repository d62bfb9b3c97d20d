"""The positions, velocities and accelerations of a robot's corners during a motion.

Collision detection needs nothing else from a robot. Each piece of the robot's `shape` is placed
separately.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ..compiled import generic
from ..curves.arcs import drive_arc
from ..geometry.checks import Array
from ..geometry.exact import length
from ..geometry.parts import Parts
from ..spaces.angles import angle_difference
from .arm import ArmRobot
from .car import CarRobot
from .kinds import Robot
from .polygon import RigidPolygonRobot, TranslatingPolygonRobot
from .round import RoundRobot

# columns of corners: position, velocity, and an upper bound on the acceleration's magnitude that
# holds for the whole motion
X, Y, VX, VY, ACC = range(5)


@generic(1)
def displacement(robot: Robot, a: Array, b: Array) -> Array:
    """The change of configuration from a to b, shape (d,); angles change along the shorter arc."""
    raise TypeError("this robot does not move")


@generic(1)
def place_piece(robot: Robot, i: int, a: Array, change: Array, t: float, corners: Array) -> None:
    """Write the corners of piece i at a + t * change, 0 <= t <= 1, into their rows of `corners`.

    The motion takes one unit of time. corners has shape (n, 5): position and velocity at time t,
    and an upper bound on the acceleration that holds for the whole motion.
    """
    raise TypeError("this robot has no body")


@generic(1)
def place_body(robot: Any, q: Array) -> Parts:
    """The robot's body at a configuration.

    Returns
    -------
    Parts, in the coordinates of the world.
    """
    corners = np.empty((len(robot.shape.points), 5))
    for i in range(len(robot.shape.radius)):
        place_piece(robot, i, q, np.zeros(len(q)), 0.0, corners)
    return Parts(corners[:, :2].copy(), robot.shape.first, robot.shape.radius)


@place_body.register(RoundRobot)
def place_disc(robot: RoundRobot, q: Array) -> Parts:
    """A disc centred at q."""
    points = np.empty((1, 2))
    points[0, 0], points[0, 1] = q[0], q[1]
    return Parts(points, np.array([0, 1]), np.array([robot.radius]))


@displacement.register(TranslatingPolygonRobot)
def straight_displacement(robot: TranslatingPolygonRobot, a: Array, b: Array) -> Array:
    """The difference b - a."""
    return b - a


@place_piece.register(TranslatingPolygonRobot)
def place_translated(
    robot: TranslatingPolygonRobot, i: int, a: Array, change: Array, t: float, corners: Array
) -> None:
    """Translate the piece; all corners have the same velocity."""
    for k in range(robot.shape.first[i], robot.shape.first[i + 1]):
        corners[k, X] = robot.shape.points[k, 0] + (a[0] + t * change[0])
        corners[k, Y] = robot.shape.points[k, 1] + (a[1] + t * change[1])
        corners[k, VX], corners[k, VY], corners[k, ACC] = change[0], change[1], 0.0


@displacement.register(RigidPolygonRobot)
def rigid_displacement(robot: RigidPolygonRobot, a: Array, b: Array) -> Array:
    """The difference of positions, and the shorter turn."""
    return np.array([b[0] - a[0], b[1] - a[1], angle_difference(a[2], b[2])])


@place_piece.register(RigidPolygonRobot)
def place_rotated(
    robot: RigidPolygonRobot, i: int, a: Array, change: Array, t: float, corners: Array
) -> None:
    """Translate the piece and rotate it about the reference point."""
    x, y, heading = a[0] + t * change[0], a[1] + t * change[1], a[2] + t * change[2]
    cos, sin, turning = math.cos(heading), math.sin(heading), change[2]
    for k in range(robot.shape.first[i], robot.shape.first[i + 1]):
        px, py = robot.shape.points[k, 0], robot.shape.points[k, 1]
        rx, ry = cos * px - sin * py, sin * px + cos * py
        corners[k, X], corners[k, Y] = x + rx, y + ry
        corners[k, VX], corners[k, VY] = change[0] - turning * ry, change[1] + turning * rx
        corners[k, ACC] = turning * turning * length(px, py)


@place_piece.register(CarRobot)
def place_on_arc(
    robot: CarRobot, i: int, a: Array, change: Array, t: float, corners: Array
) -> None:
    """Drive the piece along an arc; `change` is the distance and the change of heading."""
    s, turning = change[0], change[1]
    x, y, heading = drive_arc(a[0], a[1], a[2], t * s, turning / s if s != 0.0 else 0.0)
    cos, sin = math.cos(heading), math.sin(heading)
    for k in range(robot.shape.first[i], robot.shape.first[i + 1]):
        px, py = robot.shape.points[k, 0], robot.shape.points[k, 1]
        rx, ry = cos * px - sin * py, sin * px + cos * py
        corners[k, X], corners[k, Y] = x + rx, y + ry
        corners[k, VX], corners[k, VY] = s * cos - turning * ry, s * sin + turning * rx
        corners[k, ACC] = abs(turning * s) + turning * turning * length(px, py)


@displacement.register(ArmRobot)
def joint_displacement(robot: ArmRobot, a: Array, b: Array) -> Array:
    """The shorter turn of each joint."""
    change = np.empty(len(a))
    for i in range(len(a)):
        change[i] = angle_difference(a[i], b[i])
    return change


@place_piece.register(ArmRobot)
def place_link(robot: ArmRobot, i: int, a: Array, change: Array, t: float, corners: Array) -> None:
    """Add up the rotations of all links up to link i."""
    x, y, angle, turning = robot.base[0], robot.base[1], 0.0, 0.0
    vx, vy, acceleration = 0.0, 0.0, 0.0
    for k in range(i + 1):
        if k == i:
            corners[2 * i, X], corners[2 * i, Y] = x, y
            corners[2 * i, VX], corners[2 * i, VY], corners[2 * i, ACC] = vx, vy, acceleration
        size = robot.lengths[k]
        angle += a[k] + t * change[k]
        turning += change[k]
        cos, sin = math.cos(angle), math.sin(angle)
        x, y = x + size * cos, y + size * sin
        vx, vy = vx - size * turning * sin, vy + size * turning * cos
        acceleration += size * turning * turning
    end = 2 * i + 1
    corners[end, X], corners[end, Y] = x, y
    corners[end, VX], corners[end, VY], corners[end, ACC] = vx, vy, acceleration

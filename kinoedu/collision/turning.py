"""Collision detection for robots that rotate, and for arms: conservative advancement.

At some time of the motion a line separates a piece of the robot from an obstacle. The distance of
each corner of the piece from that line, its velocity towards the line and the bound on its
acceleration give a time before which there is no contact. From that time on the next line is used.
No fixed resolution is involved: a motion cannot jump over an obstacle, however thin.

Contact is decided to 1e-9 of the world's size. Source: B. Mirtich, "Impulse-based dynamic
simulation of rigid body systems" (1996), section 2.3.2, here with the direction and acceleration of
each corner; LaValle, section 5.3.4.
"""

import math

import numpy as np

from ..compiled import compiled
from ..geometry.checks import Array
from ..geometry.exact import height, length
from ..geometry.parts import Parts
from ..geometry.separation import dividing_line
from ..robots.arm import ArmRobot
from ..robots.moving import ACC, VX, VY, X, Y, displacement, place_piece
from ..robots.polygon import RigidPolygonRobot
from ..worlds.checks import World
from ..worlds.nearby import obstacles_near, rim
from ..worlds.polygon_world import PolygonWorldRecord
from ..worlds.terrain import TerrainRecord
from .interface import is_free_path, is_semi_free_path

CONTACT = 1e-9  # of the world's size: this distance counts as contact
FAR = 1e-14  # of the largest coordinate: an upper bound on the rounding of a corner's position


@is_free_path.register(RigidPolygonRobot, PolygonWorldRecord)
@is_free_path.register(RigidPolygonRobot, TerrainRecord)
@is_free_path.register(ArmRobot, PolygonWorldRecord)
@is_free_path.register(ArmRobot, TerrainRecord)
def is_free_turning_path(
    robot: ArmRobot | RigidPolygonRobot, world: World, a: Array, b: Array, clearance: float
) -> bool:
    """Every piece stays inside the world and off each obstacle by more than the tolerance."""
    contact = contact_size(world.lo, world.hi)
    return (
        first_in_contact(robot, world, a, displacement(robot, a, b), clearance + contact, contact)
        < 0
    )


@is_semi_free_path.register(RigidPolygonRobot, PolygonWorldRecord)
@is_semi_free_path.register(RigidPolygonRobot, TerrainRecord)
@is_semi_free_path.register(ArmRobot, PolygonWorldRecord)
@is_semi_free_path.register(ArmRobot, TerrainRecord)
def is_semi_free_turning_path(
    robot: ArmRobot | RigidPolygonRobot, world: World, a: Array, b: Array, clearance: float
) -> bool:
    """No piece penetrates an obstacle by more than twice the tolerance."""
    contact = contact_size(world.lo, world.hi)
    return (
        first_in_contact(
            robot, world, a, displacement(robot, a, b), clearance - 2.0 * contact, contact
        )
        < 0
    )


@compiled
def contact_size(lo: Array, hi: Array) -> float:
    """The distance that counts as contact in a world with bounding box lo, hi."""
    extent = max(hi[0] - lo[0], hi[1] - lo[1])
    farthest = max(max(abs(lo[0]), abs(lo[1])), max(abs(hi[0]), abs(hi[1])))
    return max(CONTACT * extent, FAR * farthest)


@compiled
def first_in_contact(
    robot: ArmRobot | RigidPolygonRobot,
    world: World,
    a: Array,
    change: Array,
    margin: float,
    contact: float,
) -> int:
    """The first piece that does not keep `margin` on the motion from a to a + change, or -1."""
    corners = np.empty((len(robot.shape.points), 5))
    for i in range(len(robot.shape.radius)):
        if piece_in_contact(robot, i, world, a, change, corners, margin, contact):
            return i
    return -1


@compiled
def piece_in_contact(
    robot: ArmRobot | RigidPolygonRobot,
    i: int,
    world: World,
    a: Array,
    change: Array,
    corners: Array,
    margin: float,
    contact: float,
) -> bool:
    """Whether piece i does not keep `margin` from the boundary or an obstacle on its motion."""
    begin, end = robot.shape.first[i], robot.shape.first[i + 1]
    offset, ring = robot.shape.radius[i] + margin, rim(world)
    place_piece(robot, i, a, change, 0.5, corners)
    x0, y0, x1, y1 = swept_box(corners, begin, end, offset)
    for edge in range(0 if box_within(x0, y0, x1, y1, ring) else len(ring)):
        if crosses_edge(robot, i, a, change, corners, ring[edge - 1], ring[edge], offset, contact):
            return True
    parts, near = obstacles_near(world, x0, y0, x1, y1)
    for j in near:
        if meets_part(robot, i, a, change, corners, parts, j, offset, contact):
            return True
    return False


@compiled
def meets_part(
    robot: ArmRobot | RigidPolygonRobot,
    i: int,
    a: Array,
    change: Array,
    corners: Array,
    parts: Parts,
    j: int,
    offset: float,
    contact: float,
) -> bool:
    """Whether piece i does not keep its distance from part j on its motion."""
    begin, end, least = robot.shape.first[i], robot.shape.first[i + 1], offset + parts.radius[j]
    t = 0.0
    while True:
        place_piece(robot, i, a, change, t, corners)
        x, y, nx, ny = dividing_line(
            corners, begin, end, parts.points, parts.first[j], parts.first[j + 1]
        )
        room, time = clear_time(corners, begin, end, x, y, nx, ny, least)
        before, t = t, t + time
        if room <= 0.0 or t > 1.0:
            return room <= 0.0
        if room <= contact or not t > before:  # so fast that no time is known to be clear
            return True


@compiled
def crosses_edge(
    robot: ArmRobot | RigidPolygonRobot,
    i: int,
    a: Array,
    change: Array,
    corners: Array,
    p: Array,
    q: Array,
    offset: float,
    contact: float,
) -> bool:
    """Whether piece i does not keep its distance from the outer side of the boundary's edge p-q."""
    size = length(q[0] - p[0], q[1] - p[1])
    nx, ny = (p[1] - q[1]) / size, (q[0] - p[0]) / size
    t = 0.0
    while True:
        place_piece(robot, i, a, change, t, corners)
        room, time = clear_time(
            corners, robot.shape.first[i], robot.shape.first[i + 1], p[0], p[1], nx, ny, offset
        )
        before, t = t, t + time
        if room <= 0.0 or t > 1.0:
            return room <= 0.0
        if room <= contact or not t > before:
            return True


@compiled
def clear_time(
    corners: Array, begin: int, end: int, x: float, y: float, nx: float, ny: float, offset: float
) -> tuple[float, float]:
    """The least distance of the corners from a line, less `offset`, and a time without contact."""
    least, time = np.inf, np.inf
    for k in range(begin, end):
        room = (corners[k, X] - x) * nx + (corners[k, Y] - y) * ny - offset
        speed = -(corners[k, VX] * nx + corners[k, VY] * ny)
        least, time = min(least, room), min(time, time_across(room, speed, corners[k, ACC]))
    return least, time


@compiled
def time_across(room: float, speed: float, acceleration: float) -> float:
    """The first t > 0 with speed * t + acceleration * t^2 / 2 = room.

    Infinite where there is none, 0 where room <= 0.
    """
    if room <= 0.0:
        return 0.0
    root = math.sqrt(speed * speed + 2.0 * acceleration * room)
    if speed > 0.0:
        return 2.0 * room / (speed + root)
    return (root - speed) / acceleration if acceleration > 0.0 else np.inf


@compiled
def swept_box(
    corners: Array, begin: int, end: int, offset: float
) -> tuple[float, float, float, float]:
    """A bounding box of the corners for half a unit of time, back and forth, grown by `offset`."""
    x0, y0, x1, y1 = np.inf, np.inf, -np.inf, -np.inf
    for k in range(begin, end):
        off = offset + corners[k, ACC] / 8.0
        dx, dy = abs(corners[k, VX]) / 2.0 + off, abs(corners[k, VY]) / 2.0 + off
        x0, y0 = min(x0, corners[k, X] - dx), min(y0, corners[k, Y] - dy)
        x1, y1 = max(x1, corners[k, X] + dx), max(y1, corners[k, Y] + dy)
    return x0, y0, x1, y1


@compiled
def box_within(x0: float, y0: float, x1: float, y1: float, ring: Array) -> bool:
    """Whether a box lies inside a convex ring."""
    for i in range(len(ring)):
        px, py, qx, qy = ring[i - 1, 0], ring[i - 1, 1], ring[i, 0], ring[i, 1]
        x, y = (x0 if qy < py else x1), (y0 if qx > px else y1)  # the corner farthest out
        if height(px, py, qx, qy, x, y) <= 0.0:
            return False
    return True

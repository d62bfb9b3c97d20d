"""Collision detection for round robots among polygons and discs."""

import numpy as np

from ..compiled import compiled, inlined
from ..geometry.checks import Array
from ..geometry.exact import height, length, orientation_sign
from ..geometry.parts import segment_part_distance
from ..geometry.segments import segment_distance, shared_points
from ..robots.round import RoundRobot
from ..worlds.occupancy import FREE, RIM, SOLID, occupancy_at, occupancy_between
from ..worlds.parts_index import motion_touches_any, point_touches_any
from ..worlds.polygon_world import PolygonWorldRecord
from .interface import is_free, is_free_path, is_semi_free_path

# of a radius: the tolerance of contact; of a motion: shorter stretches are ignored
ROUND = 1e-12


@is_free_path.register(RoundRobot, PolygonWorldRecord)
def is_free_disc_path(
    robot: RoundRobot, world: PolygonWorldRecord, a: Array, b: Array, clearance: float
) -> bool:
    """Both ends are inside the hull of the boundary, and no part is touched on the way.

    Motions of a point are tested exactly.
    """
    radius = robot.radius + clearance
    if not (is_in_box(a, world) and is_in_box(b, world)):
        return False
    found = occupancy_between(a[0], a[1], b[0], b[1], radius, world.occupancy)
    if found in (FREE, SOLID):
        return found == FREE
    if (found == RIM or radius > 0.0) and not (
        is_inside(a, radius, world.hull) and is_inside(b, radius, world.hull)
    ):
        return False
    return not motion_touches_any(a[0], a[1], b[0], b[1], radius, world.obstacles, world.cells)


@is_free.register(RoundRobot, PolygonWorldRecord)
def is_free_disc(robot: RoundRobot, world: PolygonWorldRecord, q: Array, clearance: float) -> bool:
    """A motion of length zero; for a point, only one cell of the index is searched."""
    x, y, radius = q[0], q[1], robot.radius + clearance
    if not is_in_box(q, world):
        return False
    found = occupancy_at(x, y, radius, world.occupancy)
    # one condition, because a processor guesses two in a row wrong more often
    if (found == FREE) != (found == SOLID):
        return found == FREE
    if (found == RIM or radius > 0.0) and not is_inside(q, radius, world.hull):
        return False
    if radius == 0.0:
        return not point_touches_any(x, y, world.obstacles, world.cells)
    return not motion_touches_any(x, y, x, y, radius, world.obstacles, world.cells)


@inlined
def is_in_box(q: Array, world: PolygonWorldRecord) -> bool:
    """Whether a point is strictly inside the world's bounding box."""
    return world.lo[0] < q[0] < world.hi[0] and world.lo[1] < q[1] < world.hi[1]


@inlined
def is_inside(q: Array, radius: float, ring: Array) -> bool:
    """Whether a disc lies inside a convex ring without touching it."""
    last = len(ring) - 1
    for i in range(len(ring)):
        px, py, rx, ry = ring[last, 0], ring[last, 1], ring[i, 0], ring[i, 1]
        last = i
        if orientation_sign(px, py, rx, ry, q[0], q[1]) <= 0:
            return False
        if radius > 0.0 and height(px, py, rx, ry, q[0], q[1]) <= radius:
            return False
    return True


@is_semi_free_path.register(RoundRobot, PolygonWorldRecord)
def is_semi_free_disc_path(
    robot: RoundRobot, world: PolygonWorldRecord, a: Array, b: Array, clearance: float
) -> bool:
    """Whether the centre of a disc keeps the radius, or a point stays outside every interior."""
    radius = robot.radius + clearance
    return disc_slides(world, a, b, radius) if radius > 0.0 else point_slides(world, a, b)


@compiled
def disc_slides(world: PolygonWorldRecord, a: Array, b: Array, radius: float) -> bool:
    """Whether a disc moved from a to b penetrates nothing, to 1e-12 of its radius."""
    for i in range(len(world.hull)):
        p, r = world.hull[i - 1], world.hull[i]
        for q in (a, b):
            if height(p[0], p[1], r[0], r[1], q[0], q[1]) < radius * (1.0 - ROUND):
                return False
    for i in range(len(world.obstacles.radius)):
        reach = (radius + world.obstacles.radius[i]) * (1.0 - ROUND)
        if segment_part_distance(a[0], a[1], b[0], b[1], world.obstacles, i) < reach:
            return False
    return True


@compiled
def point_slides(world: PolygonWorldRecord, a: Array, b: Array) -> bool:
    """Whether the motion of a point from a to b stays outside the interior of all obstacles.

    Between two consecutive contacts a motion is inside an obstacle, outside, or along edges. It
    penetrates where both its left and its right side are solid: one obstacle, or two that touch.
    """
    parts = world.obstacles
    for i in range(len(parts.radius)):
        if parts.radius[i] > 0.0 and segment_part_distance(
            a[0], a[1], b[0], b[1], parts, i
        ) < parts.radius[i] * (1.0 - ROUND):
            return False
    if a[0] == b[0] and a[1] == b[1]:
        return not is_surrounded(world, a)
    for t in stretch_middles(world, a, b):
        if is_inside_solid(world, a, b, t):
            return False
    return True


@compiled
def is_surrounded(world: PolygonWorldRecord, q: Array) -> bool:
    """Whether a point is surrounded by obstacles: both sides of every edge through it are solid."""
    touched = False
    for edge in world.edges:
        if segment_distance(q[0], q[1], edge[0], edge[1], edge[2], edge[3]) > 0.0:
            continue
        touched = True
        for end in (edge[0:2], edge[2:4]):
            if (end[0] != q[0] or end[1] != q[1]) and not is_inside_solid(
                world, q, end, stretch_middles(world, q, end)[0]
            ):
                return False
    anywhere = np.array([q[0] + 1.0, q[1]])
    return touched or is_inside_solid(world, q, anywhere, 0.0)


@compiled
def is_inside_solid(world: PolygonWorldRecord, a: Array, b: Array, t: float) -> bool:
    """Whether both sides of the motion a-b are solid at its fraction t."""
    left, right = solid_sides(world, a, b, t)
    return left and right


@compiled
def stretch_middles(world: PolygonWorldRecord, a: Array, b: Array) -> Array:
    """The middles of the stretches between consecutive contacts, as fractions of the motion a-b."""
    contacts = np.sort(contacts_along(world, a, b))
    middles, size = np.empty(len(contacts)), 0
    for i in range(len(contacts) - 1):
        if contacts[i + 1] - contacts[i] > ROUND:
            middles[size] = 0.5 * (contacts[i] + contacts[i + 1])
            size += 1
    return middles[:size]


@compiled
def contacts_along(world: PolygonWorldRecord, a: Array, b: Array) -> Array:
    """The fractions of the motion at which it meets an edge, with 0 and 1."""
    found = np.empty(2 + 2 * len(world.edges))
    found[0], found[1], size = 0.0, 1.0, 2
    points = np.empty((2, 2))
    total = length(b[0] - a[0], b[1] - a[1])
    for edge in world.edges:
        for i in range(shared_points(a, b, edge[0:2], edge[2:4], points)):
            found[size] = (
                length(points[i, 0] - a[0], points[i, 1] - a[1]) / total if total > 0.0 else 0.0
            )
            size += 1
    return found[:size]


@compiled
def solid_sides(world: PolygonWorldRecord, a: Array, b: Array, t: float) -> tuple[bool, bool]:
    """Whether the left and the right side of the motion a-b are solid at its fraction t.

    For each obstacle this follows from the edge that the motion runs along, or else from the
    winding number of the obstacle's rings about the point.
    """
    x, y = a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])
    left, right = False, False
    winding, along = 1, 0  # the outside has winding number 1, less 1 inside its clockwise ring
    for i in range(len(world.edges)):
        cx, cy = world.edges[i, 0], world.edges[i, 1]
        dx, dy, solid = world.edges[i, 2], world.edges[i, 3], world.edges[i, 4]
        if edge_runs_along(a, b, cx, cy, dx, dy, x, y):
            along = 1 if (dx - cx) * (b[0] - a[0]) + (dy - cy) * (b[1] - a[1]) > 0.0 else -1
        elif (cy > y) != (dy > y):
            side = orientation_sign(cx, cy, dx, dy, x, y)
            winding += int(side > 0 and dy > y) - int(side < 0 and cy > y)
        if i + 1 == len(world.edges) or world.edges[i + 1, 4] != solid:
            left = left or along > 0 or (along == 0 and winding != 0)
            right = right or along < 0 or (along == 0 and winding != 0)
            winding, along = 0, 0
    return left, right


@compiled
def edge_runs_along(
    a: Array, b: Array, cx: float, cy: float, dx: float, dy: float, x: float, y: float
) -> bool:
    """Whether the edge c-d lies on the line a-b and extends beyond (x, y) on both sides."""
    if (
        orientation_sign(a[0], a[1], b[0], b[1], cx, cy) != 0
        or orientation_sign(a[0], a[1], b[0], b[1], dx, dy) != 0
    ):
        return False
    if abs(b[0] - a[0]) >= abs(b[1] - a[1]):
        return min(cx, dx) < x < max(cx, dx)
    return min(cy, dy) < y < max(cy, dy)

"""The headings at which a rotating robot is free at a given position: exact intervals.

While the robot rotates on the spot, contact can begin or end only at a *critical* heading, where a
corner of the robot lies on an edge of an obstacle, or a corner of an obstacle on an edge of the
robot. There are finitely many; each is an intersection of a segment with a circle about the
position. Between two consecutive critical headings either all headings are free or none is, so one
collision query per interval is enough.

LaValle, section 4.3.3: contacts of types VE and EV, here for one fixed position.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InvalidParameter
from ..geometry.checks import Array, as_point
from ..geometry.parts import Parts
from ..robots.kinds import Robot
from ..robots.polygon import RigidPolygonRobot
from ..spaces.angles import wrap_angle
from ..worlds.checks import World, check_world
from ..worlds.nearby import obstacles_near, rim
from .batches import free_configurations

# of an edge's length: a circle may intersect it so far beyond its ends; a superfluous heading is
# harmless, a missing one is not
SLACK = 1e-9


def free_headings(robot: Robot, world: World, point: ArrayLike) -> Array:
    """The open intervals of headings at which a robot is free with its reference point at `point`.

    Results are exact to rounding; intervals shorter than the tolerance of collision detection,
    1e-9, may be missing. O(k log k) and 2 k collision queries for k critical headings, of which
    there are at most 4 for each pair of an edge of the robot and an edge of an obstacle near it.

    Parameters
    ----------
    robot : a RigidPolygon.
    world : a PolygonWorld or a Terrain.
    point : (2,).

    Returns
    -------
    (k, 2) array of rows low, high with -pi <= low < pi and low < high <= low + 2 pi; an interval
    may extend beyond pi. Where every heading is free the one row is -pi, pi.

    Raises
    ------
    InvalidPoint
        Where `point` is not a point.
    InvalidWorld
        Where `world` is not a world.
    InvalidParameter
        Where the robot is not a RigidPolygon.

    Examples
    --------
    >>> from kinoedu import PolygonWorld, RigidPolygon
    >>> corridor = PolygonWorld([(0, 0), (20, 0), (20, 2), (0, 2)])
    >>> bar = RigidPolygon([(-2, -0.5), (2, -0.5), (2, 0.5), (-2, 0.5)])
    >>> free_headings(bar, corridor, (10, 1)).round(3)
    array([[-0.261,  0.261],
           [ 2.88 ,  3.403]])
    """
    if not isinstance(robot, RigidPolygonRobot):
        raise InvalidParameter(
            "expected a RigidPolygon; the other robots do not rotate, or rotation does not change "
            "their collisions"
        )
    check_world(world)
    place = as_point(point)
    stops = np.unique(
        [wrap_angle(float(theta)) for theta in critical_headings(robot, world, place)]
    )
    if not len(stops):
        stops = np.array([-np.pi])
    ends = np.append(stops, stops[0] + 2.0 * np.pi)
    tried = np.concatenate([(ends[:-1] + ends[1:]) / 2.0, stops])
    free = free_configurations(
        robot, world, np.column_stack([np.tile(place, (len(tried), 1)), tried])
    )
    return join_intervals(ends, free[: len(stops)], free[len(stops) :])


def free_heading(robot: Robot, world: World, point: ArrayLike) -> float | None:
    """The middle of the widest free interval of headings at a point.

    Returns
    -------
    float in [-pi, pi), or None where no heading is free. Raises as `free_headings`.

    Examples
    --------
    >>> from kinoedu import PolygonWorld, RigidPolygon
    >>> corridor = PolygonWorld([(0, 0), (20, 0), (20, 2), (0, 2)])
    >>> bar = RigidPolygon([(-2, -0.5), (2, -0.5), (2, 0.5), (-2, 0.5)])
    >>> round(free_heading(bar, corridor, (10, 1)), 9) + 0.0, free_heading(bar, corridor, (10, 0.4))
    (0.0, None)
    """
    intervals = free_headings(robot, world, point)
    if not len(intervals):
        return None
    widths = (intervals[:, 1] - intervals[:, 0]).round(9)  # ties go to the first
    return wrap_angle(float(intervals[np.argmax(widths)].mean()))


def join_intervals(ends: Array, between: NDArray[np.bool_], at: NDArray[np.bool_]) -> Array:
    """Join free intervals ends[i] to ends[i + 1] whose common end is free.

    between : whether the interior of each interval is free. at : whether its first end is free.
    """
    if between.all() and at.all():
        return np.array([[-np.pi, np.pi]])
    begins = np.flatnonzero(between & ~(at & np.roll(between, 1)))
    rows = []
    for begin in begins:
        last, n = begin, len(between)
        while between[(last + 1) % n] and at[(last + 1) % n]:
            last += 1
        low, high = ends[begin], ends[(last + 1) % n] + 2.0 * np.pi * ((last + 1) // n)
        rows.append((low, high))
    return np.array(rows).reshape(-1, 2)


def critical_headings(robot: RigidPolygonRobot, world: World, place: Array) -> Array:
    """The headings at which contact may begin or end, and some others; (k,)."""
    reach = np.hypot(*robot.shape.points.T).max()
    parts, near = obstacles_near(world, *(place - reach), *(place + reach))
    rings = [ring_of(parts, j) - place for j in near] + [rim(world) - place]
    radius = np.repeat([*parts.radius[near], 0.0], [len(ring) for ring in rings])[:, None]
    pieces = [ring_of(robot.shape, i) for i in range(len(robot.shape.radius))]
    robot_corners, corners = np.vstack(pieces)[:, None], np.vstack(rings)[:, None]
    robot_edges = np.vstack([edges_of(ring) for ring in pieces])
    found = [
        edge_directions(robot_corners, np.vstack([edges_of(ring) for ring in rings]))
        - direction(robot_corners)[..., None]
    ]
    for off in (radius, -radius) if radius.any() else (radius,):
        found.append(
            direction(corners)[..., None] - edge_directions(corners, offset_edges(robot_edges, off))
        )
    discs = radius[:, 0] > 0.0
    found.append(
        direction(corners[discs])[..., None]
        - circle_directions(corners[discs], robot_corners[:, 0], radius[discs])
    )
    headings = np.concatenate([angles.ravel() for angles in found])
    return headings[np.isfinite(headings)]


def edge_directions(corners: Array, edges: Array) -> Array:
    """The directions of the intersections of edges with circles about the origin through corners.

    edges (..., 2, 2), corners (..., 2); shape (..., 2), because a line intersects a circle at most
    twice. nan for intersections that do not exist or lie beyond the ends of the edge.
    """
    a, u = edges[..., 0, :], edges[..., 1, :] - edges[..., 0, :]
    square, size = (u * u).sum(axis=-1), (corners * corners).sum(axis=-1)
    middle = -(a * u).sum(axis=-1) / square
    foot = a + middle[..., None] * u
    room = size - (foot * foot).sum(axis=-1)
    half = np.sqrt(np.where(room >= -SLACK * size, np.maximum(room, 0.0), np.nan) / square)
    fractions = np.stack([middle - half, middle + half], axis=-1)
    fractions[(fractions < -SLACK) | (fractions > 1.0 + SLACK)] = np.nan
    return direction(a[..., None, :] + fractions[..., None] * u[..., None, :])


def circle_directions(centres: Array, corners: Array, radius: Array) -> Array:
    """The directions of the points of circles about the origin at distance `radius` from corners.

    The circles pass through centres (m, 1, 2), the corners are (n, 2), radius is (m, 1). Shape (m,
    n, 2), nan where there is no such point.
    """
    d, r = np.hypot(centres[..., 0], centres[..., 1]), np.hypot(*corners.T)
    with np.errstate(divide="ignore", invalid="ignore"):
        cos = (d * d + r * r - radius * radius) / (2.0 * d * r)
        turn = np.arccos(np.where(np.abs(cos) <= 1.0 + SLACK, np.clip(cos, -1.0, 1.0), np.nan))
    return direction(corners)[:, None] + np.stack([-turn, turn], axis=-1)


def offset_edges(edges: Array, off: Array) -> Array:
    """Edges (n, 2, 2) moved to their right by each of the distances (m, 1); shape (m, n, 2, 2)."""
    u = edges[:, 1] - edges[:, 0]
    right = np.column_stack([u[:, 1], -u[:, 0]]) / np.hypot(*u.T)[:, None]
    return edges + off[..., None, None] * right[:, None]


def edges_of(ring: Array) -> Array:
    """The edges of a ring, (n, 2, 2); none where it is a single point."""
    return np.stack([ring, np.roll(ring, -1, axis=0)], axis=1)[: len(ring) if len(ring) > 2 else 0]


def ring_of(parts: Parts, i: int) -> Array:
    """The corners of a convex piece."""
    return parts.points[parts.first[i] : parts.first[i + 1]]


def direction(points: Array) -> Any:
    """The direction from the origin to a point (2,), or to each of (k, 2)."""
    return np.arctan2(points[..., 1], points[..., 0])

"""At which headings a robot that turns is free at a place: exact intervals, with nothing tried at
random.

As the robot turns on the spot, it can come into contact or out of it only at a *critical* heading,
where a corner of the robot is on an edge of an obstacle, or a corner of an obstacle on an edge of
the robot. These are finitely many, each where a segment meets a circle round the place. Between two
of them that follow each other all headings are free or none is, so one is asked for all.

LaValle, section 4.3.3: contacts of the types VE and EV; here for one fixed place.
"""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InvalidParameter
from ..geometry.checks import Array, as_point
from ..geometry.parts import Parts
from ..robots.polygon import RigidPolygonRobot
from ..spaces.angles import wrapped
from ..worlds.nearby import obstacles_near, rim
from .batches import free_configurations

# of an edge: how far past its ends a circle may meet it; a heading too many is harmless, one too
# few is not
SLACK = 1e-9


def free_headings(robot: Any, world: Any, point: ArrayLike) -> Array:
    """The open intervals of headings at which a robot is free with its reference point at `point`,
    as rows low, high; (k, 2).

    Parameters
    ----------
    robot : a RigidPolygon. world : a PolygonWorld or a Terrain. point : (2,).

    -pi <= low < pi, and low < high <= low + 2 pi, so an interval may reach across pi; if no heading
    is in contact the one row is
    -pi, pi. Exact but for rounding: what is free over less than collision's tolerance of 1e-9 may
    be left out. O(k log k) for k critical headings, at most 4 for each pair of an edge of the robot
    and one of an obstacle near it, and a question for each. Raises InvalidPoint, InvalidParameter.

    >>> from kinoedu import PolygonWorld, RigidPolygon
    >>> corridor = PolygonWorld([(0, 0), (20, 0), (20, 2), (0, 2)])
    >>> free_headings(RigidPolygon([(-2, -0.5), (2, -0.5), (2, 0.5), (-2, 0.5)]), corridor, (10, 1)).round(3)
    array([[-0.261,  0.261],
           [ 2.88 ,  3.403]])
    """
    if not isinstance(robot, RigidPolygonRobot):
        raise InvalidParameter(
            "free headings are those of a RigidPolygon; other robots do not turn, or look the "
            "same turned"
        )
    place = as_point(point)
    stops = np.unique([wrapped(float(theta)) for theta in critical_headings(robot, world, place)])
    if not len(stops):
        stops = np.array([-np.pi])
    ends = np.append(stops, stops[0] + 2.0 * np.pi)
    tried = np.concatenate([(ends[:-1] + ends[1:]) / 2.0, stops])
    free = free_configurations(
        robot, world, np.column_stack([np.tile(place, (len(tried), 1)), tried])
    )
    return joined(ends, free[: len(stops)], free[len(stops) :])


def free_heading(robot: Any, world: Any, point: ArrayLike) -> float | None:
    """The middle of the widest free interval of headings at a point, in [-pi, pi); None where there
    is none. See `free_headings`.

    >>> from kinoedu import PolygonWorld, RigidPolygon
    >>> corridor = PolygonWorld([(0, 0), (20, 0), (20, 2), (0, 2)])
    >>> bar = RigidPolygon([(-2, -0.5), (2, -0.5), (2, 0.5), (-2, 0.5)])
    >>> round(free_heading(bar, corridor, (10, 1)), 9) + 0.0, free_heading(bar, corridor, (10, 0.4))
    (0.0, None)
    """
    intervals = free_headings(robot, world, point)
    if not len(intervals):
        return None
    widths = (intervals[:, 1] - intervals[:, 0]).round(9)  # among equally wide ones the first
    return wrapped(float(intervals[np.argmax(widths)].mean()))


def joined(ends: Array, between: NDArray[np.bool_], at: NDArray[np.bool_]) -> Array:
    """The free intervals, from stretches ends[i] to ends[i + 1] and from whether each stretch, and
    its first end, is free.
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


def critical_headings(robot: RigidPolygonRobot, world: Any, place: Array) -> Array:
    """Headings at which the robot may touch something: all at which it comes into contact or out of
    it, and some more; (k,).
    """
    reach = np.hypot(*robot.shape.points.T).max()
    parts, near = obstacles_near(world, *(place - reach), *(place + reach))
    rings = [ring_of(parts, j) - place for j in near] + [rim(world) - place]
    radius = np.repeat([*parts.radius[near], 0.0], [len(ring) for ring in rings])[:, None]
    mine = [ring_of(robot.shape, i) for i in range(len(robot.shape.radius))]
    ours, theirs = np.vstack(mine)[:, None], np.vstack(rings)[:, None]
    sides = np.vstack([edges_of(ring) for ring in mine])
    found = [meetings(ours, np.vstack([edges_of(ring) for ring in rings])) - angle(ours)[..., None]]
    for off in (radius, -radius) if radius.any() else (radius,):
        found.append(angle(theirs)[..., None] - meetings(theirs, moved_out(sides, off)))
    discs = radius[:, 0] > 0.0
    found.append(
        angle(theirs[discs])[..., None] - round_meetings(theirs[discs], ours[:, 0], radius[discs])
    )
    headings = np.concatenate([angles.ravel() for angles in found])
    return headings[np.isfinite(headings)]


def meetings(corners: Array, edges: Array) -> Array:
    """The directions in which edges (..., 2, 2) meet the circles round the origin on which corners
    (..., 2) turn.

    Shape (..., 2): a line meets a circle twice at the most. nan where it does not, or beyond the
    edge's ends.
    """
    a, u = edges[..., 0, :], edges[..., 1, :] - edges[..., 0, :]
    square, size = (u * u).sum(axis=-1), (corners * corners).sum(axis=-1)
    middle = -(a * u).sum(axis=-1) / square
    foot = a + middle[..., None] * u
    room = size - (foot * foot).sum(axis=-1)
    half = np.sqrt(np.where(room >= -SLACK * size, np.maximum(room, 0.0), np.nan) / square)
    share = np.stack([middle - half, middle + half], axis=-1)
    share[(share < -SLACK) | (share > 1.0 + SLACK)] = np.nan
    return angle(a[..., None, :] + share[..., None] * u[..., None, :])


def round_meetings(centres: Array, corners: Array, radius: Array) -> Array:
    """The directions of the places a radius away from corners (n, 2) on the circles round the
    origin through centres (m, 1, 2).

    Shape (m, n, 2), nan where there are none; radius (m, 1).
    """
    d, r = np.hypot(centres[..., 0], centres[..., 1]), np.hypot(*corners.T)
    with np.errstate(divide="ignore", invalid="ignore"):
        cos = (d * d + r * r - radius * radius) / (2.0 * d * r)
        turn = np.arccos(np.where(np.abs(cos) <= 1.0 + SLACK, np.clip(cos, -1.0, 1.0), np.nan))
    return angle(corners)[:, None] + np.stack([-turn, turn], axis=-1)


def moved_out(edges: Array, off: Array) -> Array:
    """Edges, (n, 2, 2), moved to their right by each of some distances (m, 1); shape (m, n, 2,
    2).
    """
    u = edges[:, 1] - edges[:, 0]
    right = np.column_stack([u[:, 1], -u[:, 0]]) / np.hypot(*u.T)[:, None]
    return edges + off[..., None, None] * right[:, None]


def edges_of(ring: Array) -> Array:
    """A ring's edges, (n, 2, 2); none where it is one point."""
    return np.stack([ring, np.roll(ring, -1, axis=0)], axis=1)[: len(ring) if len(ring) > 2 else 0]


def ring_of(parts: Parts, i: int) -> Array:
    """The corners of a convex piece."""
    return parts.points[parts.first[i] : parts.first[i + 1]]


def angle(points: Array) -> Any:
    """The direction from the origin to a point (2,), or to each of (k, 2)."""
    return np.arctan2(points[..., 1], points[..., 0])

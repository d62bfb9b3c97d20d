"""The C-obstacle of a polygon that translates and rotates: a solid in (x, y, theta).

LaValle, section 4.3.3. At each theta the slice of the solid is the Minkowski difference of the
obstacle and the rotated robot. Each of its corners is a difference of two corners: i of the
obstacle and j of the robot. The set of these pairs i, j changes only at the *critical* angles,
where an edge of the robot is antiparallel to an edge of the obstacle: there one corner slides into
an edge and another one leaves it. Between two critical angles every corner moves along a smooth
curve, and each face is swept by an edge on a vertex ("EV") or a vertex on an edge ("VE").
"""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..geometry.checks import Array, integer
from ..geometry.convex import convex_hull, convex_parts
from ..geometry.minkowski import corner_pairs
from ..geometry.rings import as_convex_ring, as_ring, leftmost_corner
from ..support.constructors import with_type_names
from .translating import rotate_corners

if TYPE_CHECKING:
    from trimesh import Trimesh

SAME = 1e-9  # radians: critical angles closer than this count as one
Pairs = list[tuple[int, int]]
Numbers = dict[tuple[int, int], int]


@with_type_names
class Slice(NamedTuple):
    """The slice of the solid at one angle, by the pairs i, j that make its corners, in order."""

    theta: float
    pairs: Pairs


def turning_obstacle(
    robot_vertices: ArrayLike, obstacle: ArrayLike, *, n_angles: int = 72
) -> Trimesh:
    """The C-obstacle of a polygon that translates and rotates, as a closed triangle mesh.

    The mesh is in (x, y, theta), theta from -pi to pi. Its slices are exact to rounding. Between
    them, with d = 2 pi / n_angles, the mesh lies within R d^2 / 8 + L d / 16 of the solid, where R
    is the distance of the robot's farthest vertex from its reference point and L the length of its
    longest edge. The solid is periodic: its flat ends at -pi and pi are the same set. Where a
    polygon is not convex, the mesh has one closed component for each pair of convex parts; the
    components overlap, and their union is the C-obstacle. `mesh.export("solid.stl")` or `.glb`
    writes it to a file.

    Parameters
    ----------
    robot_vertices : (n, 2), a simple polygon, convex or not; it rotates about its reference point,
        the origin.
    obstacle : (m, 2), a simple polygon, convex or not.
    n_angles : slices are at most 2 pi / n_angles apart. There are also slices at each critical
        angle and at least one between two of them.

    Returns
    -------
    trimesh.Trimesh

    Raises
    ------
    InvalidPolygon, InvalidPoint, InvalidParameter
        Where an argument is not valid.

    Examples
    --------
    >>> robot, obstacle = [(0, 0), (2, 0), (0, 1)], [(2, 2), (4, 2), (4, 3), (2, 3)]
    >>> mesh = turning_obstacle(robot, obstacle)
    >>> mesh.is_watertight, round(float(mesh.volume) / turning_volume(robot, obstacle), 3)
    (True, 1.0)
    """
    from trimesh import Trimesh

    count = integer(n_angles, "n_angles", least=3)
    robots = [convex_hull(part) for part in convex_parts(as_ring(robot_vertices, "robot"))]
    obstacles = [convex_hull(part) for part in convex_parts(as_ring(obstacle, "obstacle"))]
    vertices: list[Array] = []
    faces: list[Array] = []
    for robot in robots:
        for solid in obstacles:
            points, triangles = build_solid(robot, solid, 2.0 * np.pi / count)
            faces.append(triangles + sum(map(len, vertices)))
            vertices.append(points)
    return Trimesh(np.concatenate(vertices), np.concatenate(faces), process=False)


def turning_volume(robot_vertices: ArrayLike, obstacle: ArrayLike) -> float:
    """The volume of the C-obstacle of two convex polygons, in area times radians.

    It is 2 pi (A + B) + a b, with their areas A and B and perimeters a and b. Source: Santaló,
    Integral Geometry and Geometric Probability, chapter 6.

    Raises
    ------
    InvalidPolygon
        Where a polygon is not convex.

    Examples
    --------
    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> turning_volume(square, square) == 4 * np.pi + 16
    True
    """
    A, a = area_and_perimeter(as_convex_ring(robot_vertices, "robot"))
    B, b = area_and_perimeter(as_convex_ring(obstacle, "obstacle"))
    return 2.0 * np.pi * (A + B) + a * b


def area_and_perimeter(ring: Array) -> tuple[float, float]:
    """The area and the perimeter of a polygon."""
    near, along = ring - ring[0], np.roll(ring, -1, axis=0) - ring
    area = float((near[:, 0] * along[:, 1] - near[:, 1] * along[:, 0]).sum()) / 2.0
    return area, float(np.sqrt((along * along).sum(axis=1)).sum())


def build_solid(robot: Array, obstacle: Array, spacing: float) -> tuple[Array, Any]:
    """The solid of two strictly convex polygons.

    Returns vertices (n, 3) and triangles (m, 3), counter-clockwise when seen from outside.
    """
    slices = slices_of(robot, obstacle, spacing)
    first = np.cumsum([0, *(len(slice_.pairs) for slice_ in slices)])
    levels = [
        obstacle[i] - rotate_corners(robot, theta)[j]
        for theta, pairs in slices
        for i, j in [np.array(pairs).T]
    ]
    heights = np.repeat([slice_.theta for slice_ in slices], np.diff(first))
    points = np.column_stack([np.concatenate(levels), heights])
    numbers = [
        dict(zip(pairs, range(begin, begin + len(pairs))))
        for (_, pairs), begin in zip(slices, first.tolist())
    ]
    bottom, top = list(numbers[0].values()), list(numbers[-1].values())
    faces = [(bottom[0], b, a) for a, b in pairwise(bottom[1:])] + [
        (top[0], a, b) for a, b in pairwise(top[1:])
    ]
    twisted: list[tuple[int, ...]] = []
    for low, high in pairwise(numbers):
        add_side_faces(low, high, faces, twisted)
    quads = np.array(twisted)
    middles = len(points) + np.arange(len(quads))
    fans = [np.column_stack([quads[:, k], quads[:, (k + 1) % 4], middles]) for k in range(4)]
    vertices = np.concatenate([points, points[quads].mean(axis=1)])
    return vertices, np.concatenate([np.array(faces), *fans])


def slices_of(robot: Array, obstacle: Array, spacing: float) -> list[Slice]:
    """The slices from -pi to pi, at most `spacing` apart: at the ends and around critical angles.

    At a critical angle one corner of each neighbouring slice lies inside an edge. The slice there
    has only the pairs that both neighbours share. So of two neighbouring slices one has all the
    pairs of the other, and the faces between them do not fold.
    """
    stops = critical_angles(robot, obstacle)
    pieces = [corner_pairs_at(robot, obstacle, (a + b) / 2.0) for a, b in pairwise(stops)]
    slices: list[Slice] = []
    for k, (a, b) in enumerate(pairwise(stops)):
        shared = set(pieces[k - 1])  # for k = 0, the last piece: angles are periodic
        slices.append(Slice(a, [pair for pair in pieces[k] if pair in shared]))
        count = max(int(np.ceil((b - a) / spacing)), 2)
        slices += [Slice(a + (b - a) * i / count, pieces[k]) for i in range(1, count)]
    return [*slices, Slice(np.pi, slices[0].pairs)]


def critical_angles(robot: Array, obstacle: Array) -> list[float]:
    """The angles from -pi to pi at which edges of robot and obstacle are antiparallel.

    Both ends are included.
    """
    robot_angles, obstacle_angles = (
        np.arctan2(*(np.roll(ring, -1, axis=0) - ring).T[::-1]) for ring in (robot, obstacle)
    )
    turns = obstacle_angles[:, None] - robot_angles[None, :]
    angles = np.sort(np.mod(turns, 2.0 * np.pi).ravel() - np.pi)
    inner = angles[(angles > -np.pi + SAME) & (angles < np.pi - SAME)]
    return [-np.pi, *inner[np.diff(inner, prepend=-np.inf) > SAME].tolist(), np.pi]


def corner_pairs_at(robot: Array, obstacle: Array, theta: float) -> Pairs:
    """The pairs i, j that make the corners of the slice at an angle that is not critical."""
    mirrored = -rotate_corners(robot, theta)
    left = [leftmost_corner(obstacle), leftmost_corner(mirrored)]
    pairs = corner_pairs(np.roll(obstacle, -left[0], axis=0), np.roll(mirrored, -left[1], axis=0))
    return [(i, j) for i, j in ((pairs + left) % [len(obstacle), len(robot)]).tolist()]


def add_side_faces(
    low: Numbers, high: Numbers, faces: list[tuple[int, int, int]], twisted: list[tuple[int, ...]]
) -> None:
    """Add the faces between two slices, given as the vertex number of each pair, in order.

    One slice has all the pairs of the other. A face swept by an edge of the obstacle is flat: two
    triangles. An edge of the robot rotates while it sweeps: the four corners of its face are not in
    one plane. They are added to `twisted` for a fan about their mean, which lies on the solid, as
    neither diagonal does.
    """
    ring = list(low if len(low) >= len(high) else high)
    begin = next(k for k, pair in enumerate(ring) if pair in low and pair in high)
    ring = ring[begin:] + ring[: begin + 1]
    below, above = low[ring[0]], high[ring[0]]
    for before, pair in pairwise(ring):
        right, over = low.get(pair, below), high.get(pair, above)
        if right != below and over != above and before[1] != pair[1]:
            twisted.append((below, right, over, above))
        else:
            if right != below:
                faces.append((below, right, above))
            if over != above:
                faces.append((right, over, above))
        below, above = right, over

"""Polygons from triangles in space: their projection to the plane, or a slice at one height.

shapely computes the unions, on a grid of about 2^-40 of the size of the mesh: narrow gaps between
triangles that should share an edge are closed, and the results are simple polygons. Coordinates in
single precision, as in STL files, lie on this grid already.
"""

import numpy as np
from numpy.typing import NDArray

from ..geometry.checks import Array
from ..geometry.frames import Frame, frame_of, into_frame, out_of_frame
from ..geometry.rings import as_ring

GRID = 2.0**-40

# an outline and the outlines of its rooms, as for an obstacle of PolygonWorld
Solid = tuple[Array, list[Array]]


def project_triangles(triangles: Array) -> list[Solid]:
    """The projection of triangles (m, 3, 3) to the plane. Vertical triangles cover no area."""
    import shapely

    frame = frame_of(triangles[:, :, :2].reshape(-1, 2), GRID)
    flat = np.round(into_frame(frame, triangles[:, :, :2]) / frame.grid) * frame.grid
    (ax, ay), (bx, by) = (flat[:, 1] - flat[:, 0]).T, (flat[:, 2] - flat[:, 0]).T
    covered = shapely.union_all(shapely.polygons(flat[ax * by != ay * bx]))
    return as_solids(shapely.set_precision(covered, frame.grid), frame)


def slice_triangles(triangles: Array, height: float) -> list[Solid] | None:
    """The slice of bodies just above a height; None where they are not closed.

    The bodies are bounded by triangles (m, 3, 3), counter-clockwise from outside. A point is solid
    where its winding number is not 0: bodies may overlap and have cavities. O(n k) for n lines in k
    faces.
    """
    import shapely

    frame = frame_of(triangles[:, :, :2].reshape(-1, 2), GRID)
    in_plane = into_frame(frame, triangles[:, :, :2])
    heights = np.ldexp(triangles[:, :, 2:], -frame.power)
    lines = intersect_plane(
        np.concatenate([in_plane, heights], axis=2), float(np.ldexp(height, -frame.power))
    )
    if not is_closed(lines):
        return None
    lines = lines[(lines[:, 0] != lines[:, 1]).any(axis=1)]
    noded = shapely.union_all(shapely.linestrings(lines), grid_size=frame.grid)
    faces = shapely.get_parts(shapely.polygonize(shapely.get_parts(noded)))
    inside = shapely.get_coordinates(shapely.point_on_surface(faces))
    solid = [face for face, q in zip(faces, inside) if winding_number(lines, q) != 0]
    return as_solids(shapely.union_all(solid, grid_size=frame.grid), frame)


def rectangle(lo: Array, hi: Array) -> Array:
    """The corners of a rectangle, (4, 2)."""
    return np.array([(lo[0], lo[1]), (hi[0], lo[1]), (hi[0], hi[1]), (lo[0], hi[1])])


def intersect_plane(triangles: Array, height: float) -> Array:
    """The segments in which triangles intersect a horizontal plane, (k, 2, 2), solid to their left.

    A corner at the height counts as below it. Two triangles that share an edge get exactly the same
    point on it.
    """
    above = triangles[:, :, 2] > height
    passing = above.any(axis=1) & ~above.all(axis=1)
    above, triangles = above[passing], triangles[passing]
    top_heavy = above.sum(axis=1) == 2
    # the only corner on its side of the plane
    lone = np.argmax(above != top_heavy[:, None], axis=1)
    rows = np.arange(len(lone))
    a, b, c = (triangles[rows, (lone + k) % 3] for k in range(3))
    ends = [points_at_height(a, other, top_heavy, height) for other in (b, c)]
    lines = np.stack(ends, axis=1)
    lines[top_heavy] = lines[top_heavy, ::-1]
    return lines


def points_at_height(
    lone: Array, other: Array, top_heavy: NDArray[np.bool_], height: float
) -> Array:
    """The points (k, 2) at which edges reach the height, computed from their lower ends."""
    low, high = np.where(top_heavy[:, None], lone, other), np.where(top_heavy[:, None], other, lone)
    t = (height - low[:, 2]) / (high[:, 2] - low[:, 2])
    return low[:, :2] + t[:, None] * (high - low)[:, :2]


def is_closed(lines: Array) -> bool:
    """Whether at each point as many segments end as begin."""
    _, numbers = np.unique(lines.reshape(-1, 2), axis=0, return_inverse=True)
    begin, end = numbers.reshape(-1, 2).T
    return np.array_equal(np.sort(begin), np.sort(end))


def winding_number(lines: Array, q: Array) -> int:
    """The winding number of segments (n, 2, 2) about q, by those that cross a ray to the right."""
    (ax, ay), (bx, by) = lines[:, 0].T - q[:, None], lines[:, 1].T - q[:, None]
    left = ax * by - ay * bx
    return int(
        ((ay <= 0) & (by > 0) & (left > 0)).sum() - ((by <= 0) & (ay > 0) & (left < 0)).sum()
    )


def as_solids(shape: object, frame: Frame) -> list[Solid]:
    """The polygons of a shapely geometry, from left to right, without corners inside an edge."""
    import shapely

    parts = [
        part
        for part in shapely.get_parts(shapely.simplify(shape, frame.grid))
        if part.geom_type == "Polygon" and not part.is_empty
    ]

    def checked(ring: object) -> Array:
        return as_ring(out_of_frame(frame, shapely.get_coordinates(ring)[:-1]))

    solids = [
        (checked(part.exterior), [checked(room) for room in part.interiors]) for part in parts
    ]
    return sorted(solids, key=lambda solid: solid[0].min(axis=0).tolist())

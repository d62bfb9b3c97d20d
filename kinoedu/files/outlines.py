"""From triangles in space to polygons in the plane: their shadow, or a slice at one height.

shapely unites them, on a grid of 2^-40 of their size: hairline cracks between triangles that should
share an edge close, and what comes out is simple. Coordinates of single precision, as STL has them,
lie on that grid already.
"""

import numpy as np
from numpy.typing import NDArray

from ..geometry.checks import Array
from ..geometry.rings import as_ring

GRID = 2.0**-40

Solid = tuple[
    Array, list[Array]
]  # an outline and the outlines of its rooms, as PolygonWorld takes an obstacle


def shadow(triangles: Array) -> list[Solid]:
    """What triangles (m, 3, 3) cover, seen from above. Upright ones cover nothing."""
    import shapely

    unit = unit_of(triangles)
    flat = np.round(triangles[:, :, :2] / (unit * GRID)) * GRID
    (ax, ay), (bx, by) = (flat[:, 1] - flat[:, 0]).T, (flat[:, 2] - flat[:, 0]).T
    return solids(
        shapely.set_precision(shapely.union_all(shapely.polygons(flat[ax * by != ay * bx])), GRID),
        unit,
    )


def slice_of(triangles: Array, height: float) -> list[Solid] | None:
    """What the bodies bounded by triangles (m, 3, 3), outward side out, have just above a height;
    None where they are not closed.

    A place is solid where the outlines go round it at all: bodies may overlap, and have cavities.
    O(n k) for n lines in k faces.
    """
    import shapely

    unit = unit_of(triangles)
    lines = crossings(triangles / unit, height / unit)
    if not closed(lines):
        return None
    lines = lines[(lines[:, 0] != lines[:, 1]).any(axis=1)]
    noded = shapely.union_all(shapely.linestrings(lines), grid_size=GRID)
    faces = shapely.get_parts(shapely.polygonize(shapely.get_parts(noded)))
    inside = shapely.get_coordinates(shapely.point_on_surface(faces))
    return solids(
        shapely.union_all(
            [face for face, q in zip(faces, inside) if winding(lines, q) != 0], grid_size=GRID
        ),
        unit,
    )


def rectangle(lo: Array, hi: Array) -> Array:
    """The corners of a rectangle, (4, 2)."""
    return np.array([(lo[0], lo[1]), (hi[0], lo[1]), (hi[0], hi[1]), (lo[0], hi[1])])


def unit_of(triangles: Array) -> float:
    """A power of two above the largest coordinate in the plane, so that shapely's products neither
    overflow nor vanish.
    """
    return float(2.0 ** np.frexp(np.abs(triangles[:, :, :2]).max())[1])


def crossings(triangles: Array, height: float) -> Array:
    """The lines in which triangles pass a height, (k, 2, 2), the solid to their left. A corner at
    the height counts as below.

    Two triangles that share an edge get the very same point on it.
    """
    above = triangles[:, :, 2] > height
    passing = above.any(axis=1) & ~above.all(axis=1)
    above, triangles = above[passing], triangles[passing]
    top_heavy = above.sum(axis=1) == 2
    lone = np.argmax(above != top_heavy[:, None], axis=1)  # the corner that is alone on its side
    rows = np.arange(len(lone))
    a, b, c = (triangles[rows, (lone + k) % 3] for k in range(3))
    ends = [between(a, other, top_heavy, height) for other in (b, c)]
    lines = np.stack(ends, axis=1)
    lines[top_heavy] = lines[top_heavy, ::-1]
    return lines


def between(lone: Array, other: Array, top_heavy: NDArray[np.bool_], height: float) -> Array:
    """Where edges (k, 3) to (k, 3) pass the height, (k, 2), reckoned from their lower ends."""
    low, high = np.where(top_heavy[:, None], lone, other), np.where(top_heavy[:, None], other, lone)
    t = (height - low[:, 2]) / (high[:, 2] - low[:, 2])
    return low[:, :2] + t[:, None] * (high - low)[:, :2]


def closed(lines: Array) -> bool:
    """Whether as many lines end at each point as begin there."""
    _, numbers = np.unique(lines.reshape(-1, 2), axis=0, return_inverse=True)
    begin, end = numbers.reshape(-1, 2).T
    return np.array_equal(np.sort(begin), np.sort(end))


def winding(lines: Array, q: Array) -> int:
    """How often closed lines (n, 2, 2) go round q, counter-clockwise counting positive: those that
    pass a ray to the right.
    """
    (ax, ay), (bx, by) = lines[:, 0].T - q[:, None], lines[:, 1].T - q[:, None]
    left = ax * by - ay * bx
    return int(
        ((ay <= 0) & (by > 0) & (left > 0)).sum() - ((by <= 0) & (ay > 0) & (left < 0)).sum()
    )


def solids(shape: object, unit: float) -> list[Solid]:
    """The polygons of a shapely geometry, in their order from left to right, without the corners
    that are none.
    """
    import shapely

    parts = [
        part
        for part in shapely.get_parts(shapely.simplify(shape, GRID))
        if part.geom_type == "Polygon" and not part.is_empty
    ]
    made = [
        (ring_of(part.exterior, unit), [ring_of(room, unit) for room in part.interiors])
        for part in parts
    ]
    return sorted(made, key=lambda solid: solid[0].min(axis=0).tolist())


def ring_of(ring: object, unit: float) -> Array:
    """A shapely ring as ours."""
    import shapely

    return as_ring(shapely.get_coordinates(ring)[:-1] * unit)

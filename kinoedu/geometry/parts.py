"""`Parts`: the convex pieces that make up robots and obstacles.

One vertex with a radius is a disc, two are a rounded bar such as an arm's link, three or more are a
convex polygon, counter-clockwise. A polygon that is not convex is several parts. So one distance
routine serves them all.

`Parts` is a record, as is every object that compiled code reads: a NamedTuple of arrays, numbers
and records. Records that are passed on often hold few arrays, because compiled code counts
references to each of them then. These are the main records; their fields are listed in their files.

| records | meaning | file |
|---|---|---|
| `Parts` | convex pieces, each grown by a radius | geometry/parts.py |
| `RoundRobot` | a point or a disc | robots/round.py |
| `TranslatingPolygonRobot`, `RigidPolygonRobot` | a polygon | robots/polygon.py |
| `ArmRobot`, `CarRobot` | an arm; a car | robots/arm.py, robots/car.py |
| `PolygonWorldRecord` | a polygon with obstacles | worlds/polygon_world.py |
| `PartsIndex` | a grid of cells that finds nearby parts | worlds/parts_index.py |
| `MovingWorldRecord` | a world with moving obstacles | worlds/moving.py |
| `UncertainWorldRecord` | a world with uncertain obstacles | worlds/uncertain.py |
| `TerrainRecord` | a bitmap | worlds/terrain.py |
| `RealSpace`, `WrappingSpace` | R^n; spaces with angles | spaces/real.py, spaces/wrapping.py |
| `CurveSpace`, `Curve` | a car's poses; a curve | curves/space.py, curves/curve.py |
| `GrowingTree` | a tree with its buckets of nodes | spaces/buckets.py |
| `Nearest`, `Closest` | results of a bucket search | spaces/rings.py, spaces/closest.py |
| `CostTree`, `Corners` | an RRT*; a visibility graph | planners/trees/, planners/exact/ |
| `Grid`, `Cells`, `Motions` | a grid and its motions | planners/grids/grid.py |
| `JumpPoints` | the jump points of a grid | planners/grids/jump_points.py |
| `GraphRecord`, `RadixHeap`, `Labels` | a graph and its search | graphs/ |
| `Sweep` | the state of a sweep line | decomposition/sweep.py |
| `Rounded`, `Slide` | shapes and paths in C-space | c_space/ |
| `ProblemRecord`, `TimedProblemRecord` | a problem | problems/ |
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import compiled, inlined
from .checks import Array
from .exact import orientation_sign
from .segments import is_between, segment_distance

TOUCHING = 1.0 + 1e-15  # times a reach: touching up to a few roundings is contact


class Parts(NamedTuple):
    """Convex pieces, each grown by a radius, in one flat array; see the table above."""

    points: Array
    first: NDArray[np.int64]
    radius: Array


def make_parts(pieces: Sequence[Array], radius: Sequence[float]) -> Parts:
    """Store convex pieces, each of shape (n_i, 2), one after another.

    Examples
    --------
    >>> make_parts([np.zeros((1, 2)), np.eye(3, 2)], [0.5, 0.0]).first
    array([0, 1, 4])
    """
    first = np.cumsum([0, *map(len, pieces)], dtype=np.int64)
    return Parts(np.concatenate([np.empty((0, 2)), *pieces]), first, np.array(radius, np.float64))


@compiled
def join_parts(one: Parts, other: Parts) -> Parts:
    """The parts of both, one after the other."""
    return Parts(
        np.concatenate((one.points, other.points)),
        np.concatenate((one.first, other.first[1:] + one.first[-1])),
        np.concatenate((one.radius, other.radius)),
    )


@compiled
def part_boxes(parts: Parts) -> Array:
    """The bounding box (x0, y0, x1, y1) of each part with its radius, shape (k, 4)."""
    boxes = np.empty((len(parts.radius), 4))
    for i in range(len(boxes)):
        lo, hi = box_of(parts.points[parts.first[i] : parts.first[i + 1]])
        for axis in range(2):
            boxes[i, axis] = lo[axis] - parts.radius[i]
            boxes[i, 2 + axis] = hi[axis] + parts.radius[i]
    return boxes


@compiled
def box_of(points: Array) -> tuple[Array, Array]:
    """The corners of the bounding box of points (n, d): the lowest and the highest, (d,) each."""
    lo, hi = points[0].copy(), points[0].copy()
    for p in points:
        for axis in range(len(p)):
            lo[axis], hi[axis] = min(lo[axis], p[axis]), max(hi[axis], p[axis])
    return lo, hi


@inlined
def segment_meets_part(ax: float, ay: float, bx: float, by: float, parts: Parts, i: int) -> bool:
    """Whether the closed segment a-b shares a point with part i, a point or a polygon. Exact.

    The part's radius is ignored. A segment and a polygon are disjoint exactly when the polygon is
    strictly on one side of the segment's line, or the segment is strictly to the right of an edge
    (separating axis theorem). The segment may be a single point.
    """
    points, begin, end = parts.points, parts.first[i], parts.first[i + 1]
    if end - begin == 1:
        x, y = points[begin, 0], points[begin, 1]
        return is_between(ax, ay, bx, by, x, y) and orientation_sign(ax, ay, bx, by, x, y) == 0
    left, right = 0, 0
    last = end - 1
    for k in range(begin, end):
        side = orientation_sign(ax, ay, bx, by, points[k, 0], points[k, 1])
        left += side > 0
        right += side < 0
        px, py, qx, qy = points[last, 0], points[last, 1], points[k, 0], points[k, 1]
        if (
            max(orientation_sign(px, py, qx, qy, ax, ay), orientation_sign(px, py, qx, qy, bx, by))
            < 0
        ):
            return False
        last = k
    return left < end - begin and right < end - begin


@inlined
def segment_part_distance(
    ax: float, ay: float, bx: float, by: float, parts: Parts, i: int
) -> float:
    """The distance between the segment a-b and part i, 0 where they meet; the radius is ignored."""
    if segment_meets_part(ax, ay, bx, by, parts, i):
        return 0.0
    points, begin, end = parts.points, parts.first[i], parts.first[i + 1]
    best = np.inf
    last = end - 1
    for k in range(begin, end):
        px, py, qx, qy = points[last, 0], points[last, 1], points[k, 0], points[k, 1]
        to_corner = segment_distance(qx, qy, ax, ay, bx, by)
        to_edge = min(
            segment_distance(ax, ay, px, py, qx, qy), segment_distance(bx, by, px, py, qx, qy)
        )
        best = min(best, min(to_corner, to_edge))
        last = k
    return best


@inlined
def motion_touches_part(
    ax: float, ay: float, bx: float, by: float, radius: float, parts: Parts, i: int
) -> bool:
    """Whether a disc moved along a-b touches part i.

    Exact for a point and a polygon. Accurate to 1e-12 where a radius is positive.
    """
    reach = radius + parts.radius[i]
    if reach == 0.0:
        return segment_meets_part(ax, ay, bx, by, parts, i)
    return segment_part_distance(ax, ay, bx, by, parts, i) <= reach * TOUCHING

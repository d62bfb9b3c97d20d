"""`Parts`: what every robot's body and every obstacle is made of.

The record table (every record is a NamedTuple; compiled code reads its fields):

| record | fields |
|---|---|
| `Parts` | points (n, 2), first (k + 1,), radius (k,): part i is points[first[i]:first[i + 1]], grown by radius[i] |
| `RoundRobot` | radius (its body, Parts of one point, is made when asked for) |
| `TranslatingPolygonRobot` | outline (n, 2) and shape: Parts, at the origin (robots/polygon.py) |
| `RigidPolygonRobot` | outline, shape, turn_weight (robots/polygon.py) |
| `ArmRobot` | lengths (n,), base (2,), shape: Parts, each link along its own x-axis (robots/arm.py) |
| `CarRobot` | outline, shape, wheelbase, max_steering, radius, speeds, both_ways (robots/car.py) |
| `PolygonWorldRecord` | edges (m, 5), hull, obstacles: Parts, cells: PartsIndex, known, lo and hi (worlds/polygon_world.py) |
| `PartsIndex` | x, y, cell, columns, rows, first, parts, boxes (worlds/parts_index.py) |
| `MovingWorldRecord` | still, shapes, times, places, knots, outlines, owner, lo, hi (worlds/moving.py) |
| `UncertainWorldRecord` | expected, empty, parts, owner (k,), sigma (m,) (worlds/uncertain.py) |
| `TerrainRecord` | free (rows, columns), resolution, origin, lo and hi (worlds/terrain.py) |
| `RealSpace` | lo and hi (d,) (spaces/real.py) |
| `WrappingSpace` | lo, hi, wraps and weight (d,) (spaces/wrapping.py) |
| `CurveSpace` | lo, hi (3,), radius, both_ways (curves/space.py) |
| `Curve` | start (3,), radius, turns (k,), lengths (k,) (curves/curve.py) |
| `Nearest`, `Closest` | what a search of buckets has found so far (spaces/rings.py, spaces/closest.py) |
| `GrowingTree` | nodes, parent, size, and the buckets of its nearest neighbours (spaces/buckets.py) |
| `CostTree` | tree, cost, length, child, sibling, log, hung (planners/cost_tree.py) |
| `Corners` | points, nodes, before, after (planners/corners.py) |
| `GraphRecord` | size, edges, weights, first, to, weight (graphs/flat.py) |
| `Sweep` | the state of a sweep line, flat (decomposition/sweep.py) |
| `Rounded`, `Slide` | a grown convex shape; a robot's way round an obstacle (c_space/rounded.py, c_space/sliding.py) |
| `ProblemRecord` | robot, world, space, start, goal, clearance, asked (problems.py) |
| `TimedProblemRecord` | robot, world, start, goal, speed, horizon, clearance (timed_problems.py) |
| `Grid`; `Cells`, `Motions` | a grid's place and size; what its moves are judged by (planners/grid.py) |
| `RadixHeap`, `Known` | a search's queue, and what it knows of each node (graphs/radix_heap.py, graphs/search.py) |

One vertex with a radius is a disc, two a rounded bar such as an arm's link, three or more a convex
polygon, counter-clockwise; a non-convex polygon is several parts. So one distance routine judges
them all. Records hold few arrays: compiled code counts a reference to each of them wherever a
record is handed on.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import inlined
from .checks import Array
from .exact import turn
from .segments import between, segment_distance


class Parts(NamedTuple):
    """Convex pieces in one flat array."""

    points: Array
    first: NDArray[np.int64]
    radius: Array


def make_parts(pieces: Sequence[Array], radius: Sequence[float]) -> Parts:
    """Lay convex pieces, each of shape (n_i, 2), one after another.

    >>> make_parts([np.zeros((1, 2)), np.eye(3, 2)], [0.5, 0.0]).first
    array([0, 1, 4])
    """
    first = np.cumsum([0, *map(len, pieces)], dtype=np.int64)
    return Parts(np.concatenate([np.empty((0, 2)), *pieces]), first, np.array(radius, np.float64))


def part_boxes(parts: Parts) -> Array:
    """The bounding box (x0, y0, x1, y1) of each part with its radius, shape (k, 4)."""
    lo, hi = (
        ufunc.reduceat(parts.points, parts.first[:-1], axis=0) for ufunc in (np.minimum, np.maximum)
    )
    return np.hstack([lo - parts.radius[:, None], hi + parts.radius[:, None]])


@inlined
def segment_meets_part(ax: float, ay: float, bx: float, by: float, parts: Parts, i: int) -> bool:
    """Whether the closed segment a-b shares a point with part i, its radius left aside. Exact.

    A segment and a polygon are apart exactly when the segment's line has the polygon strictly on
    one side, or the segment lies strictly to the right of an edge (separating axis theorem). The
    segment may be a single point.
    """
    points, begin, end = parts.points, parts.first[i], parts.first[i + 1]
    if end - begin == 1:
        x, y = points[begin, 0], points[begin, 1]
        return between(ax, ay, bx, by, x, y) and turn(ax, ay, bx, by, x, y) == 0
    left, right = 0, 0
    last = end - 1
    for k in range(begin, end):
        side = turn(ax, ay, bx, by, points[k, 0], points[k, 1])
        left += side > 0
        right += side < 0
        px, py, qx, qy = points[last, 0], points[last, 1], points[k, 0], points[k, 1]
        if max(turn(px, py, qx, qy, ax, ay), turn(px, py, qx, qy, bx, by)) < 0:
            return False
        last = k
    return left < end - begin and right < end - begin


@inlined
def segment_part_distance(
    ax: float, ay: float, bx: float, by: float, parts: Parts, i: int
) -> float:
    """The distance between the segment a-b and part i, its radius left aside; 0 where they meet."""
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
    """Whether a disc moved along a-b touches part i: exact for a point against a polygon, to 1e-12
    where something is round.
    """
    reach = radius + parts.radius[i]
    if reach == 0.0:
        return segment_meets_part(ax, ay, bx, by, parts, i)
    return segment_part_distance(ax, ay, bx, by, parts, i) <= reach * (1.0 + 1e-15)

"""A board's scene as arrays, and what a body makes of it.

The same arrays are made in a page by `worker.js`.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import compiled
from ..geometry.checks import Array
from ..geometry.parts import Parts
from ..geometry.rings import SIMPLE, RingFault, counter_clockwise, find_ring_fault
from ..worlds.polygon_world import PolygonWorldRecord, Rings, world_of_rings

# the status of an answer, facts[0]; RING_FAULT and the fault's kind make one number
FOUND, NOT_FOUND, START_NOT_FREE, GOAL_NOT_FREE, RING_FAULT = 0, 1, 2, 3, 4
REASON = 5  # the place of the reason among the facts


class SceneArrays(NamedTuple):
    """A scene of polygons without rooms, discs and handles; or of a bitmap and handles.

    points, first : ring k is points[first[k]:first[k + 1]], in any order; ring 0 is the boundary.
    discs : (k, 3), rows x, y, radius.
    handles : (n, 3), rows x, y, radius of the body.
    free : (rows, columns), the bitmap, lowest row first.
    lo, hi : the corners of the world.
    """

    points: Array
    first: NDArray[np.int64]
    discs: Array
    handles: Array
    free: NDArray[np.bool_]
    lo: Array
    hi: Array


class Shown(NamedTuple):
    """What a body shows: facts, and layers with one row for each thing.

    facts : (6,), the status, cost, steps, iterations, nodes, and the number of the reason why there
        is no path; where a ring has a fault, the status, the ring, and the fault's i and j.
    edges, others : (m, 7), rows x, y, next x, next y, two numbers that the edge says when one
        points at it, the step at which it appears.
    dots : (n, 4), rows x, y and two numbers that the dot says.
    path : (k, 2), with no rows where there is none.
    """

    facts: Array
    edges: Array
    others: Array
    dots: Array
    path: Array


def pack_scene(scene: dict[str, Any], free: NDArray[np.bool_] | None = None) -> SceneArrays:
    """A scene of a board, `kinoedu.boards.core.scene`, as arrays."""
    rings = [scene["boundary"] or [], *(p["rings"][0] for p in scene["polygons"])]
    discs = [(*disc["at"], disc["radius"]) for disc in scene["discs"]]
    handles = [(*handle["at"], handle.get("radius", 0.0)) for handle in scene["handles"]]
    return SceneArrays(
        np.array([point for ring in rings for point in ring], np.float64).reshape(-1, 2),
        np.cumsum([0, *map(len, rings)], dtype=np.int64),
        np.array(discs, np.float64).reshape(-1, 3),
        np.array(handles, np.float64).reshape(-1, 3),
        np.zeros((0, 0), np.bool_) if free is None else np.ascontiguousarray(free, np.bool_),
        np.array(scene["lo"], np.float64),
        np.array(scene["hi"], np.float64),
    )


@compiled
def find_fault(scene: SceneArrays) -> tuple[int, RingFault]:
    """The first ring that is not a simple polygon and its fault; -1 where there is none."""
    for k in range(len(scene.first) - 1):
        fault = find_ring_fault(scene.points[scene.first[k] : scene.first[k + 1]])
        if fault.kind != SIMPLE:
            return k, fault
    return -1, RingFault(SIMPLE, -1, -1)


@compiled
def without_obstacles(scene: SceneArrays) -> SceneArrays:
    """The same scene in its empty box."""
    box = np.empty((4, 2))
    for k in range(4):
        box[k, 0] = scene.lo[0] if k in (0, 3) else scene.hi[0]
        box[k, 1] = scene.lo[1] if k < 2 else scene.hi[1]
    first, discs = np.array([0, 4]), np.empty((0, 3))
    return SceneArrays(box, first, discs, scene.handles, scene.free, scene.lo, scene.hi)


@compiled
def world_of_scene(scene: SceneArrays) -> PolygonWorldRecord:
    """The world of a scene whose rings have no fault."""
    points = np.empty_like(scene.points)
    for k in range(len(scene.first) - 1):
        begin, end = scene.first[k], scene.first[k + 1]
        ring = counter_clockwise(scene.points[begin:end])
        points[begin:end] = ring if k > 0 else ring[::-1]
    rings = Rings(points, scene.first, np.arange(len(scene.first) - 1))
    no_parts = Parts(np.empty((0, 2)), np.zeros(1, np.int64), np.empty(0))
    return world_of_rings(rings, no_parts, scene.discs)


@compiled
def show_nothing(status: float, ring: int, first: int, second: int) -> Shown:
    """The answer to a scene in which nothing can be planned."""
    facts = np.array([status, ring, first, second, 0.0, 0.0])
    return Shown(facts, np.empty((0, 7)), np.empty((0, 7)), np.empty((0, 4)), np.empty((0, 2)))

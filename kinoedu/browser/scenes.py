"""A board's scene as arrays, and the faults in it.

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

# The status of an answer: the number of what is said, or a fault of the scene. From RING_FAULT on
# the fault's kind is subtracted; then the facts after the status are the ring and the fault's i, j.
FOUND, START_NOT_FREE, GOAL_NOT_FREE, RING_FAULT = 0, -1, -2, -3
REFUSED = -20  # from here on down the reasons of a body's own, `Body.warns`


class SceneArrays(NamedTuple):
    """A scene of polygons without rooms, discs and handles; or of a bitmap and handles.

    points, first : ring k is points[first[k]:first[k + 1]], in any order; ring 0 is the boundary,
        empty in the open plane.
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


EMPTY_SCENE = pack_scene(
    {"boundary": [], "polygons": [], "discs": [], "handles": [], "lo": [0, 0], "hi": [1, 1]}
)  # has the types that all bodies take


@compiled
def find_fault(scene: SceneArrays) -> tuple[int, RingFault]:
    """The first ring that is not a simple polygon and its fault; -1 where there is none."""
    for k in range(0 if scene.first[1] > 0 else 1, len(scene.first) - 1):
        fault = find_ring_fault(scene.points[scene.first[k] : scene.first[k + 1]])
        if fault.kind != SIMPLE:
            return k, fault
    return -1, RingFault(SIMPLE, -1, -1)


@compiled
def refuse_ring(ring: int, fault: RingFault) -> Array:
    """The facts of an answer where a ring has a fault."""
    return np.array([RING_FAULT - fault.kind, ring, fault.i, fault.j], np.float64)


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
    no_parts = Parts(np.empty((0, 2)), np.zeros(1, np.int64), np.empty(0))
    return world_of_rings(rings_of_scene(scene), no_parts, scene.discs)


@compiled
def rings_of_scene(scene: SceneArrays) -> Rings:
    """The rings of a scene without a fault: the boundary clockwise, obstacles counter-clockwise."""
    points = np.empty_like(scene.points)
    for k in range(0 if scene.first[1] > 0 else 1, len(scene.first) - 1):
        begin, end = scene.first[k], scene.first[k + 1]
        ring = counter_clockwise(scene.points[begin:end])
        points[begin:end] = ring if k > 0 else ring[::-1]
    return Rings(points, scene.first, np.arange(len(scene.first) - 1))


@compiled
def no_rows() -> Array:
    """An empty layer. Each needs memory of its own, which a page gives back."""
    return np.empty((0, 4))


@compiled
def no_four() -> tuple[Array, Array, Array, Array]:
    """Four empty layers, for an answer that has many."""
    return no_rows(), no_rows(), no_rows(), no_rows()

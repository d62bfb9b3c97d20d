"""The body of the distance board: a polygon's point that is nearest to q, and the tangent at q."""

from typing import NamedTuple

import numpy as np

from ..compiled import algorithm
from ..geometry.checks import Array
from ..geometry.polygons import distances_to_ring, nearest_on_ring, tangent_to_ring
from ..geometry.rings import SIMPLE, counter_clockwise, find_ring_fault
from .scenes import SceneArrays, no_rows, refuse_ring

INSIDE, EDGE, VERTEX = 0, 1, 2  # the status


class NoSettings(NamedTuple):
    """The settings of a body that has none."""


class ShownNearest(NamedTuple):
    """What is shown of the nearest point.

    facts : (3,), the status, the distance, and the number of the nearest edge or vertex.
    vertices : (n, 3), rows x, y, number.
    way : (k, 4), from q to the nearest point, with no rows where q is inside.
    near : (k, 2), the nearest point.
    sizes : (k, 3), rows x, y, distance, at the middle of the way.
    tangent : (k, 4), rows x, y, dx, dy.
    """

    facts: Array
    vertices: Array
    way: Array
    near: Array
    sizes: Array
    tangent: Array


@algorithm
def show_nearest(
    scene: SceneArrays, settings: NoSettings, rng: np.random.Generator
) -> ShownNearest:
    """The nearest point of the first polygon to the first handle."""
    ring = scene.points[scene.first[1] : scene.first[2]]
    fault = find_ring_fault(ring)
    if fault.kind != SIMPLE:
        facts = refuse_ring(1, fault)
        return ShownNearest(facts, no_rows(), no_rows(), no_rows(), no_rows(), no_rows())
    ring, x, y = counter_clockwise(ring), scene.handles[0, 0], scene.handles[0, 1]
    vertices = np.empty((len(ring), 3))
    for i in range(len(ring)):
        vertices[i, 0], vertices[i, 1], vertices[i, 2] = ring[i, 0], ring[i, 1], i
    dx, dy = tangent_to_ring(x, y, ring)
    tangent = np.array([x, y, dx, dy]).reshape(1, 4)
    distance = distances_to_ring(np.array([x, y]).reshape(1, 2), ring)[0]
    if distance == 0.0:
        facts = np.array([INSIDE, 0.0, -1.0])
        return ShownNearest(facts, vertices, no_rows(), no_rows(), no_rows(), tangent)
    edge, near_x, near_y, region = nearest_on_ring(x, y, ring)
    status = EDGE if region == 0 else VERTEX
    number = (edge + 1) % len(ring) if region == 2 else edge
    way, near = (
        np.array([x, y, near_x, near_y]).reshape(1, 4),
        np.array([near_x, near_y]).reshape(1, 2),
    )
    sizes = np.array([(x + near_x) / 2.0, (y + near_y) / 2.0, distance]).reshape(1, 3)
    facts = np.array([status, distance, number])
    return ShownNearest(facts, vertices, way, near, sizes, tangent)

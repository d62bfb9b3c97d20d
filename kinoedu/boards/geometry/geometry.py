"""The board of the distance from a point to a polygon."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ...geometry import point_polygon_distance, polygon_tangent
from ...geometry.checks import as_point
from ...geometry.polygons import nearest_on_ring
from ...geometry.rings import as_ring
from ...messages import get_message
from ..core.canvas import Canvas
from ..core.drawing import Drawing, arrows, dots, edges, labels
from ..core.scene import Scene, handle, make_scene, place_of, polygon


def distance_board(vertices: ArrayLike, q: ArrayLike) -> Canvas:
    """Drag q, a polygon or its vertices: the nearest point, the distance and the tangent.

    Parameters
    ----------
    vertices : (n, 2), a simple polygon.
    q : (2,), where q begins. The arrow at q is `polygon_tangent`, one unit long.

    Raises
    ------
    InvalidPolygon, InvalidPoint

    Examples
    --------
    >>> distance_board([(0, 0), (4, 0), (4, 4), (0, 4)], q=(7, 8))
    Canvas(distance 5; nearest: vertex 2)
    """
    ring, name = as_ring(vertices), get_message("board.distance.q")
    here = as_point(q, name)
    lo, hi = np.minimum(ring.min(axis=0), here), np.maximum(ring.max(axis=0), here)
    margin = 0.25 * (hi - lo).max()
    scene = make_scene(
        lo - margin,
        hi + margin,
        handles=[handle(name, here, colour="start")],
        polygons=[polygon(get_message("board.distance.polygon"), [ring])],
    )
    return Canvas(scene, draw_nearest)


def draw_nearest(scene: Scene) -> Drawing:
    """Draw the polygon's point that is nearest to q."""
    ring = as_ring(scene["polygons"][0]["rings"][0])
    q = place_of(scene, scene["handles"][0]["name"])
    tangent = arrows([q], [polygon_tangent(q, ring)], "path")
    numbers = labels(ring, [str(i) for i in range(len(ring))], "obstacle")
    distance = point_polygon_distance(q, ring)
    if distance == 0.0:
        return Drawing([numbers, tangent], text=get_message("board.distance.inside"))
    edge, x, y, region = nearest_on_ring(q[0], q[1], ring)
    near, size = np.array([x, y]), f"{distance:.4g}"
    if region == 0:
        text = get_message("board.distance.edge", distance=size, number=edge)
    else:
        vertex = edge if region == 1 else (edge + 1) % len(ring)
        text = get_message("board.distance.vertex", distance=size, number=vertex)
    layers = [
        numbers,
        edges([[q, near]], "tree", width=2.5, dash=(6, 4)),
        dots([near], "tree", radius=6.0),
        labels([(q + near) / 2.0], [size], "tree"),
        tangent,
    ]
    return Drawing(layers, text=text)

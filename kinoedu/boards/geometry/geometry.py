"""The board of the distance from a point to a polygon."""

from __future__ import annotations

from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from ...geometry.checks import as_point
from ...geometry.rings import as_ring
from ...messages import get_message
from ..core.canvas import Canvas
from ..core.scene import handle, make_scene, polygon
from ..core.shown import answer_by, make_live


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
    return Canvas(scene, partial(answer_by, "nearest", ()), live=make_live("nearest", ()))

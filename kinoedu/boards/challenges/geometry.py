"""Challenges of lesson 1, on `distance_board`."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...geometry import point_polygon_distance, point_segment_distance, polygon_tangent
from ..core.canvas import Canvas
from ..core.challenge import Answer, posed

NEAR = 0.02  # two distances are equal if they differ by less than this share
DEGREES = 3.0


@posed
def between_two_walls(board: Canvas, kept: dict[str, Any]) -> Answer:
    """Two edges without a common vertex are equally near."""
    q, ring = read(board)
    if point_polygon_distance(q, ring) == 0.0:
        return "inside", {}
    n = len(ring)
    far = np.array([point_segment_distance(q, ring[i], ring[(i + 1) % n]) for i in range(n)])
    first = int(far.argmin())
    apart = [i for i in range(n) if (i - first) % n not in (0, 1, n - 1)]
    second = min(apart, key=lambda i: far[i])
    values = {"first": first, "second": second, "a": f"{far[first]:.3g}", "b": f"{far[second]:.3g}"}
    return "reached" if far[second] <= (1.0 + NEAR) * far[first] else "not_yet", values


@posed
def diagonal_tangent(board: Canvas, kept: dict[str, Any]) -> Answer:
    """The tangent has a heading of 45 degrees."""
    q, ring = read(board)
    x, y = polygon_tangent(q, ring)
    heading = float(np.degrees(np.arctan2(y, x)))
    values = {"heading": f"{heading:.0f}"}
    return "reached" if abs(heading - 45.0) <= DEGREES else "not_yet", values


def read(board: Canvas) -> tuple[np.ndarray, np.ndarray]:
    """The point q and the polygon that the board shows."""
    scene = board.shown
    return np.array(scene["handles"][0]["at"]), np.array(scene["polygons"][0]["rings"][0])

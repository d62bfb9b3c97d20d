"""Lesson 1: Geometry, or the wall that a robot must follow.

Its exercises, in the order of the notebook.
"""

from .exposing_case import ExposeRayCounting
from .line_through_points import LineThroughPoints
from .point_line_distance import PointLineDistance
from .point_polygon_distance import PointPolygonDistance
from .point_segment_distance import PointSegmentDistance
from .polygon_tangent import PolygonTangent

EXERCISES = [
    LineThroughPoints,
    PointLineDistance,
    PointSegmentDistance,
    PointPolygonDistance,
    PolygonTangent,
    ExposeRayCounting,
]

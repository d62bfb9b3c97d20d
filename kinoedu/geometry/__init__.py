"""Plane geometry: lines, segments, polygons and convex polygons.

Predicates (on which side, inside, intersecting) are exact. Distances are accurate to 1e-12.
"""

from .convex import convex_hull, convex_polygons_intersect, point_in_convex_polygon
from .convex_pairs import ConvexPolygons, convex_pairs_intersect
from .displacements import configuration, displaced, displacement, inverse, rotation
from .lines import line_through_points, orientation, point_line_distance
from .minkowski import erosion, minkowski_difference, minkowski_sum
from .polygons import point_in_polygon, point_polygon_distance, polygon_tangent
from .segments import (
    closest_point_on_segment,
    point_segment_distance,
    segment_intersection,
    segments_intersect,
)

__all__ = [
    "ConvexPolygons",
    "closest_point_on_segment",
    "configuration",
    "convex_hull",
    "convex_pairs_intersect",
    "convex_polygons_intersect",
    "displaced",
    "displacement",
    "erosion",
    "inverse",
    "line_through_points",
    "minkowski_difference",
    "minkowski_sum",
    "orientation",
    "point_in_convex_polygon",
    "point_in_polygon",
    "point_line_distance",
    "point_polygon_distance",
    "point_segment_distance",
    "polygon_tangent",
    "rotation",
    "segment_intersection",
    "segments_intersect",
]

"""Lesson 7: Collision detection, or does it fit? Its exercises, in the order of the notebook."""

from .c_obstacle import CObstacle
from .convex_polygons_intersect import ConvexPolygonsIntersect
from .link_in_contact import LinkInContact
from .overlooked_gap import OverlookedGap
from .plot_configuration_space import PlotConfigurationSpace
from .plot_environment import PlotEnvironment
from .point_in_convex_polygon import PointInConvexPolygon
from .segment_intersection import SegmentIntersection

EXERCISES = [
    PointInConvexPolygon,
    SegmentIntersection,
    ConvexPolygonsIntersect,
    CObstacle,
    LinkInContact,
    PlotEnvironment,
    PlotConfigurationSpace,
    OverlookedGap,
]

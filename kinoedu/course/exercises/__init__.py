"""Every exercise of the course, by the name of the function that it asks for."""

import functools

from ...errors import InvalidParameter
from ...words import say
from ..exercise import Exercise
from .angles import CircleDistance, TorusDistance
from .arm_contact import LinkInContact
from .best_controls import BestControl
from .bugs import Bug1, Bug2, BugBase
from .c_obstacles import CObstacle
from .cell_paths import PlanByDecomposition
from .chance_by_margins import ChanceMargins
from .comparing import ComparePlanners
from .connection_rules import ComponentNeighbours, KClosestNeighbours, RadiusNeighbours
from .convex import ConvexPolygonsIntersect, PointInConvexPolygon
from .decomposition import Neighbours, TrapezoidsOfWorld
from .displacements import Displacement, Rotation
from .driving import Move, Replay
from .environment_plot import PlotEnvironment
from .fastest_drives import FastestDrive
from .following import Follow
from .four_chords import ExposeFourChords
from .freedoms import DegreesOfFreedom
from .graph_paths import BfsPath, DfsPath
from .graphs import BfsTree, ExtractPath
from .grazed_corners import ExposeSight
from .grids import CornerGrid, SukharevGrid
from .half_separating import OverlookedGap
from .hasty_goal import ExposeHastyGoal
from .headings import FreeHeading
from .hidden_corridor import ExposeGrids
from .holes import DispersionBounds
from .integrating import Euler, OrderOfError
from .kinematics import ForwardKinematics, InverseKinematics
from .kinodynamic import KinodynamicPrm, KinodynamicRrt
from .law_of_sines import ExposeReach
from .lines import LineThroughPoints, PointLineDistance
from .matrices import AdjacencyMatrix, BfsOnMatrix, DfsOnMatrix
from .mended_bug import ExposeMendedBug
from .misleading import MisleadingEstimate
from .missed_moments import ExposeMoments
from .polygons import PointPolygonDistance, PolygonTangent
from .pose_distances import HeadingDistance
from .random_points import UniformRandom
from .ray_counting import ExposeRayCounting
from .repeats import RepeatedRows
from .rewiring import Insert
from .roadmap_paths import ShortestPath
from .safe_arrival import EarliestArrival
from .sampled_edges import ExposeSampling
from .sampled_roadmap import SampledRoadmap
from .sampled_space import PlotConfigurationSpace
from .scenario_chance import CollisionProbability
from .searches import Astar, Dijkstra
from .segment_pairs import SegmentIntersection
from .segments import PointSegmentDistance
from .sequences import Halton, RadicalInverse
from .shorter_walls import ExposeShorterWalls
from .small_angles import ExposeSmallAngles
from .sweeping import Crossings, FreeIntervals
from .tangent_curves import CscLength
from .terrain_costs import CostAlong
from .terrain_planners import RrtOnTerrain
from .terrain_roadmaps import PrmOnTerrain
from .timed_contact import FirstContact
from .tree_roadmaps import TreeRoadmap
from .trees import Rrt, RrtConnect
from .turning_trees import RrtForPolygon
from .visible_corners import VisibleCorners

EXERCISES: dict[str, Exercise] = {
    exercise.name: exercise()
    for exercise in (
        LineThroughPoints,
        PointLineDistance,
        PointSegmentDistance,
        PointPolygonDistance,
        PolygonTangent,
        ExposeRayCounting,
        BugBase,
        Bug1,
        Bug2,
        ExposeMendedBug,
        BfsTree,
        ExtractPath,
        BfsPath,
        DfsPath,
        Dijkstra,
        Astar,
        MisleadingEstimate,
        Crossings,
        FreeIntervals,
        TrapezoidsOfWorld,
        Neighbours,
        PlanByDecomposition,
        ExposeShorterWalls,
        DegreesOfFreedom,
        Rotation,
        Displacement,
        ForwardKinematics,
        InverseKinematics,
        CircleDistance,
        TorusDistance,
        ExposeReach,
        CornerGrid,
        SukharevGrid,
        UniformRandom,
        RadicalInverse,
        Halton,
        DispersionBounds,
        ExposeGrids,
        PointInConvexPolygon,
        SegmentIntersection,
        ConvexPolygonsIntersect,
        CObstacle,
        LinkInContact,
        PlotEnvironment,
        PlotConfigurationSpace,
        OverlookedGap,
        TreeRoadmap,
        Rrt,
        RrtConnect,
        Insert,
        Follow,
        ExposeHastyGoal,
        RrtOnTerrain,
        PrmOnTerrain,
        RepeatedRows,
        ComparePlanners,
        CostAlong,
        ExposeSampling,
        RrtForPolygon,
        FreeHeading,
        AdjacencyMatrix,
        BfsOnMatrix,
        DfsOnMatrix,
        ExposeFourChords,
        VisibleCorners,
        RadiusNeighbours,
        KClosestNeighbours,
        ComponentNeighbours,
        SampledRoadmap,
        ShortestPath,
        ExposeSight,
        Move,
        Replay,
        Euler,
        OrderOfError,
        CscLength,
        ExposeSmallAngles,
        HeadingDistance,
        BestControl,
        KinodynamicRrt,
        FastestDrive,
        KinodynamicPrm,
        FirstContact,
        EarliestArrival,
        ChanceMargins,
        CollisionProbability,
        ExposeMoments,
    )
}


def find(name: str, variant: str = "") -> Exercise:
    """The exercise that asks for a function of this name, with a contract of its own where a variant is named. Raises
    InvalidParameter.

    >>> find("point_line_distance").lesson
    '01_geometry'
    """
    if name not in EXERCISES:
        raise InvalidParameter(say("check.unknown", name=name, names=", ".join(EXERCISES)))
    exercise = EXERCISES[name]
    if variant and variant not in exercise.variants:
        raise InvalidParameter(say("check.no_variant", name=name, variant=variant, names=", ".join(exercise.variants) or "none"))
    return varied(type(exercise), variant) if variant else exercise


@functools.cache
def varied(kind: type[Exercise], variant: str) -> Exercise:
    """An exercise with a contract, each once: what it computes is kept by what it is."""
    return kind(variant)


__all__ = ["EXERCISES", "find"]

"""Lesson 10: Terrains, and how to compare planners. Its exercises, in the order of the notebook."""

from .compare_planners import ComparePlanners
from .cost_along import CostAlong
from .exposing_motion import ExposeSampling
from .prm_on_terrain import PrmOnTerrain
from .repeated_rows import RepeatedRows
from .rrt_on_terrain import RrtOnTerrain

EXERCISES = [
    RrtOnTerrain,
    PrmOnTerrain,
    RepeatedRows,
    ComparePlanners,
    CostAlong,
    ExposeSampling,
]

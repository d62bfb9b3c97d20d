"""Lesson 10: Terrains, or fifty seeds against one. Its exercises, as the notebook asks for them."""

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

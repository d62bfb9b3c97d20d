"""Lesson 8: Roadmaps, built once and used a thousand times.

Its exercises, in the order of the notebook.
"""

from .component_k_closest import ComponentNeighbours
from .exposing_sight import ExposeSight
from .k_closest import KClosestNeighbours
from .radius_neighbours import RadiusNeighbours
from .sampled_roadmap import SampledRoadmap
from .shortest_path import ShortestPath
from .visibility_roadmap import VisibleCorners

EXERCISES = [
    VisibleCorners,
    RadiusNeighbours,
    KClosestNeighbours,
    ComponentNeighbours,
    SampledRoadmap,
    ShortestPath,
    ExposeSight,
]

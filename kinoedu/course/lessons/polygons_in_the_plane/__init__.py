"""Lesson 11: Polygons in the plane: one task, three planners.

Its exercises, in the order of the notebook.
"""

from .adjacency_matrix import AdjacencyMatrix
from .bfs_on_matrix import BfsOnMatrix
from .dfs_on_matrix import DfsOnMatrix
from .exposing_obstacle import ExposeFourChords
from .free_heading import FreeHeading
from .rrt_for_polygon import RrtForPolygon

EXERCISES = [
    RrtForPolygon,
    FreeHeading,
    AdjacencyMatrix,
    BfsOnMatrix,
    DfsOnMatrix,
    ExposeFourChords,
]

"""Lesson 4: Graph search, or how to know that a path is the shortest.

Its exercises, in the order of the notebook.
"""

from .astar import Astar
from .bfs_path import BfsPath
from .bfs_tree import BfsTree
from .dfs_path import DfsPath
from .dijkstra import Dijkstra
from .extract_path import ExtractPath
from .misleading_estimate import MisleadingEstimate

EXERCISES = [
    BfsTree,
    ExtractPath,
    BfsPath,
    DfsPath,
    Dijkstra,
    Astar,
    MisleadingEstimate,
]

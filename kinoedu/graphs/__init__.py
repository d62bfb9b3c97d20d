"""Graphs and the searches on them."""

from .bfs import bfs, bfs_expansions, bfs_path, bfs_tree
from .dfs import dfs, dfs_expansions, dfs_path
from .flat import GraphRecord, flat_graph
from .graph import Graph
from .paths import Expansion, Search, Steps, extract_path
from .search import astar, astar_expansions, dijkstra, dijkstra_expansions

__all__ = [
    "Expansion",
    "Graph",
    "GraphRecord",
    "Search",
    "Steps",
    "astar",
    "astar_expansions",
    "bfs",
    "bfs_expansions",
    "bfs_path",
    "bfs_tree",
    "dfs",
    "dfs_expansions",
    "dfs_path",
    "dijkstra",
    "dijkstra_expansions",
    "extract_path",
    "flat_graph",
]

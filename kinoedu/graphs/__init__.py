"""Graphs and the searches on them."""

from .graph import Graph
from .search import astar, dijkstra, extract_path

__all__ = ["Graph", "astar", "dijkstra", "extract_path"]

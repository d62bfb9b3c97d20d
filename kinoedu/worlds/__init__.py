"""Worlds: where a robot moves, made from polygons or bitmaps or read from files."""

from .benchmr import read_benchmr
from .meshes import mesh_outline, mesh_world, read_mesh
from .polygon_world import PolygonWorld
from .range_sensor import Scan, scan
from .reading import read_world
from .terrain import Terrain

__all__ = ["PolygonWorld", "Scan", "Terrain", "mesh_outline", "mesh_world", "read_benchmr", "read_mesh", "read_world", "scan"]

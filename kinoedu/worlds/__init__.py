"""Worlds: where a robot moves, made from polygons or bitmaps or read from files."""

from .polygon_world import PolygonWorld
from .range_sensor import Scan, scan
from .reading import read_world
from .terrain import Terrain

__all__ = ["PolygonWorld", "Scan", "Terrain", "read_world", "scan"]

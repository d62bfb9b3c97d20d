"""Worlds: where a robot moves, made from polygons or bitmaps or read from files."""

from .polygon_world import PolygonWorld
from .reading import read_world
from .terrain import Terrain

__all__ = ["PolygonWorld", "Terrain", "read_world"]

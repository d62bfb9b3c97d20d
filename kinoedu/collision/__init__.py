"""Collision: whole motions of a robot's body against a world."""

from . import round_polygons, round_terrain
from .asks import is_free, is_free_path, is_semi_free_path

__all__ = ["is_free", "is_free_path", "is_semi_free_path", "round_polygons", "round_terrain"]

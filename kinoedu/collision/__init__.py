"""Collision: whole motions of a robot's body against a world."""

from . import round_polygons, round_terrain
from .asks import coordinates, is_free, is_free_path, is_semi_free_path
from .batches import free_configurations, free_motions

__all__ = [
    "coordinates",
    "free_configurations",
    "free_motions",
    "is_free",
    "is_free_path",
    "is_semi_free_path",
    "round_polygons",
    "round_terrain",
]

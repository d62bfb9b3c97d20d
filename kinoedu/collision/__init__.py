"""Collision detection for whole motions of a robot in a world."""

from . import driving, in_time, round_polygons, round_terrain, translating, turning
from .arms import link_in_contact, paint_configuration_space
from .batches import free_configurations, free_motions
from .clearances import clearance_of
from .costs import check_cost, motion_cost
from .driving import is_free_trajectory
from .headings import free_heading, free_headings
from .interface import coordinates, is_free, is_free_drive, is_free_path, is_semi_free_path
from .probability import Chance, collision_bound, collision_probability, path_clearances

__all__ = [
    "Chance",
    "check_cost",
    "clearance_of",
    "collision_bound",
    "collision_probability",
    "coordinates",
    "driving",
    "free_configurations",
    "free_heading",
    "free_headings",
    "free_motions",
    "in_time",
    "is_free",
    "is_free_drive",
    "is_free_path",
    "is_free_trajectory",
    "is_semi_free_path",
    "link_in_contact",
    "motion_cost",
    "paint_configuration_space",
    "path_clearances",
    "round_polygons",
    "round_terrain",
    "translating",
    "turning",
]

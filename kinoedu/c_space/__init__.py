"""Configuration-space obstacles: where the reference point of a robot must not be."""

from .disk import free_regions, grown_obstacles, shrunk_workspace
from .rounded import Rounded
from .sliding import Slide, slide
from .translating import c_space_world, translating_obstacles, turned
from .turning import turning_obstacle, turning_volume

__all__ = [
    "Rounded",
    "Slide",
    "c_space_world",
    "free_regions",
    "grown_obstacles",
    "shrunk_workspace",
    "slide",
    "translating_obstacles",
    "turned",
    "turning_obstacle",
    "turning_volume",
]

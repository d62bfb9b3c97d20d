"""Planners: each takes a problem and returns a plan."""

from .grid import plan_on_grid
from .prm import prm
from .rrt import rrt

__all__ = ["plan_on_grid", "prm", "rrt"]

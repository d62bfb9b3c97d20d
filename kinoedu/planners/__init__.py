"""Planners: each takes a problem and returns a plan; the Bug family takes what a bug is given."""

from ..decomposition import decomposition_roadmap, sweep, trapezoidation, triangulation
from .bug0 import bug0
from .bug1 import bug1
from .bug2 import bug2
from .bug2_prelim import bug2_prelim
from .bug_base import bug_base
from .by_decomposition import plan_by_decomposition
from .grid import plan_on_grid
from .prm import prm
from .rrt import rrt

__all__ = [
    "bug0",
    "bug1",
    "bug2",
    "bug2_prelim",
    "bug_base",
    "decomposition_roadmap",
    "plan_by_decomposition",
    "plan_on_grid",
    "prm",
    "rrt",
    "sweep",
    "trapezoidation",
    "triangulation",
]

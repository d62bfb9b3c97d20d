"""Planners: each takes a problem and returns a plan; the Bug family takes what a bug is given."""

from .bug0 import bug0
from .bug1 import bug1
from .bug2 import bug2
from .bug2_prelim import bug2_prelim
from .bug_base import bug_base
from .grid import plan_on_grid
from .prm import prm
from .rrt import rrt

__all__ = ["bug0", "bug1", "bug2", "bug2_prelim", "bug_base", "plan_on_grid", "prm", "rrt"]

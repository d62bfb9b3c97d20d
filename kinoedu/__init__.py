"""kinoedu: a motion-planning course you can run.

A plan in four lines:

>>> import kinoedu as ke
>>> world = ke.PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [[(4, 0), (6, 0), (6, 8), (4, 8)]])
>>> plan = ke.rrt(ke.Problem(ke.Point(), world, start=(1, 1), goal=(9, 1)), rng=0)
>>> plan.path is not None
True

The rooms of the house: `geometry`, `graphs`, `spaces`, `worlds`, `robots`, `collision`, `problems`, `planners`, `figures`.
"""

from . import collision, geometry, graphs, planners, problems, robots, spaces, worlds
from .planners import plan_on_grid, prm, rrt
from .problems import Plan, Problem, Recorder
from .robots import Disk, Point
from .worlds import PolygonWorld, Terrain, read_world

__version__ = "0.1.0"

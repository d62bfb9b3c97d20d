"""Lesson 3: Decomposition, or how a program can know that there is no path.

Its exercises, in the order of the notebook.
"""

from .crossings import Crossings
from .exposing_world import ExposeShorterWalls
from .free_intervals import FreeIntervals
from .neighbours import Neighbours
from .plan_by_decomposition import PlanByDecomposition
from .trapezoidation import TrapezoidsOfWorld

EXERCISES = [
    Crossings,
    FreeIntervals,
    TrapezoidsOfWorld,
    Neighbours,
    PlanByDecomposition,
    ExposeShorterWalls,
]

"""Lesson 6: Sampling, or where to put a hundred points.

Its exercises, in the order of the notebook.
"""

from .corner_grid import CornerGrid
from .dispersion_bounds import DispersionBounds
from .exposing_corridor import ExposeGrids
from .halton import Halton
from .radical_inverse import RadicalInverse
from .sukharev_grid import SukharevGrid
from .uniform_random import UniformRandom

EXERCISES = [
    CornerGrid,
    SukharevGrid,
    UniformRandom,
    RadicalInverse,
    Halton,
    DispersionBounds,
    ExposeGrids,
]

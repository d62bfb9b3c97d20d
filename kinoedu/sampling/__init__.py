"""Point sets in the unit cube (grids, random points, Halton's sequence) and their dispersion."""

from .dispersion import EmptyBall, dispersion, largest_empty_ball
from .grids import corner_grid, sukharev_bound, sukharev_grid
from .halton import halton, van_der_corput
from .uniform import uniform_random

__all__ = [
    "EmptyBall",
    "corner_grid",
    "dispersion",
    "halton",
    "largest_empty_ball",
    "sukharev_bound",
    "sukharev_grid",
    "uniform_random",
    "van_der_corput",
]

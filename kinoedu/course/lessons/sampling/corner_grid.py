"""The exercise `corner_grid`. Bullo & Smith, chapter 4."""

from ....sampling import corner_grid, sukharev_grid
from ....sampling.grids import lattice
from ...exercise import Slip
from .grids import GridExercise, make_diagonal, make_grid


class CornerGrid(GridExercise):
    """Put a point at the lower corner of each of k^d cells."""

    name = "corner_grid"
    source = staticmethod(corner_grid)
    shown = staticmethod(lattice)
    slips = (
        Slip("both_ends", lambda n, d: make_grid(n, d, lambda i, k: i / max(k - 1, 1))),
        Slip("centres", sukharev_grid),
        Slip("upper", lambda n, d: make_grid(n, d, lambda i, k: (i + 1) / k)),
        Slip("unscaled", lambda n, d: make_grid(n, d, lambda i, k: i)),
        Slip("diagonal", lambda n, d: make_diagonal(n, d, lambda i, k: i / k)),
        Slip("all_along", lambda n, d: make_diagonal(n, d, lambda i, k: i / n, each=n)),
    )
    reference = staticmethod(corner_grid)

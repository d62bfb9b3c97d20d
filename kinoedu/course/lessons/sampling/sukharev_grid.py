"""The exercise `sukharev_grid`. Bullo & Smith, chapter 4."""

from ....sampling import corner_grid, sukharev_grid
from ....sampling.grids import lattice
from ...exercise import Slip
from .grids import GridExercise, make_diagonal, make_grid


class SukharevGrid(GridExercise):
    """Put a point at the centre of each of k^d cells."""

    name = "sukharev_grid"
    source = staticmethod(sukharev_grid)
    shown = staticmethod(lattice)
    slips = (
        Slip("corners", corner_grid),
        Slip("both_ends", lambda n, d: make_grid(n, d, lambda i, k: i / max(k - 1, 1))),
        Slip("wide_margin", lambda n, d: make_grid(n, d, lambda i, k: (i + 1) / (k + 1))),
        Slip("half_of_n", lambda n, d: corner_grid(n, d) + 0.5 / n),
        Slip("half", lambda n, d: make_grid(n, d, lambda i, k: i / k + 0.5)),
        Slip("unscaled", lambda n, d: make_grid(n, d, lambda i, k: i + 0.5)),
        Slip("diagonal", lambda n, d: make_diagonal(n, d, lambda i, k: (i + 0.5) / k)),
    )
    reference = staticmethod(sukharev_grid)

"""The exercise `bfs_on_matrix`. Bullo & Smith, chapters 2 and 5."""

from ...exercise import Slip
from ..graphs.bfs_path import BfsPath
from .matrices import MatrixExercise, search_matrix_by


class BfsOnMatrix(MatrixExercise, BfsPath):
    """Find a path with the fewest edges; any such path is right."""

    name = "bfs_on_matrix"
    slips = tuple(
        Slip(slip.key, search_matrix_by(slip.answer))
        for slip in BfsPath.slips
        if slip.key in ("deep", "order", "reversed")
    )
    source = staticmethod(search_matrix_by(BfsPath.reference))

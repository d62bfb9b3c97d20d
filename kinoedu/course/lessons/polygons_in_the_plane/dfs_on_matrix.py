"""The exercise `dfs_on_matrix`. Bullo & Smith, chapters 2 and 5."""

from ...exercise import Slip
from ..graphs.dfs_path import DfsPath
from .matrices import MatrixExercise, search_matrix_by


class DfsOnMatrix(MatrixExercise, DfsPath):
    """Find a path that meets no node twice; any such path is right."""

    name = "dfs_on_matrix"
    slips = tuple(
        Slip(slip.key, search_matrix_by(slip.answer))
        for slip in DfsPath.slips
        if slip.key in ("order", "never_back", "reversed")
    )
    source = staticmethod(search_matrix_by(DfsPath.reference))

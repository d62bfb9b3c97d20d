"""The exercise `dfs_path`. Bullo & Smith, chapter 2; LaValle, section 2.2."""

from typing import ClassVar

from .... import graphs
from ....graphs.dfs import depth_first
from ...exercise import Case, Slip
from ...withheld import withheld
from ..shared.graph_slips import dfs_order, dfs_walk, never_back, undirected
from ..shared.random_graphs import Neighbours, as_graph
from .paths import PathExercise, convert_path, search_depth_first


class DfsPath(PathExercise):
    """Find a path that meets no node twice; any such path is right."""

    name = "dfs_path"
    last_rule = "simple"
    shown = staticmethod(depth_first)
    slips: ClassVar[tuple[Slip, ...]] = (
        Slip("order", dfs_order),
        Slip("walk", dfs_walk),
        Slip("never_back", never_back),
        Slip(
            "reversed",
            lambda neighbours, start, goal: (
                (search_depth_first(neighbours, start, goal) or [])[::-1] or None
            ),
        ),
        Slip(
            "undirected",
            lambda neighbours, start, goal: search_depth_first(undirected(neighbours), start, goal),
        ),
        Slip(
            "nowhere",
            lambda neighbours, start, goal: (
                search_depth_first(neighbours, start, goal) if start != goal else None
            ),
        ),
    )

    @staticmethod
    @withheld
    def reference(neighbours: Neighbours, start: int, goal: int) -> list[int] | None:
        """Return the path that the library finds."""
        return convert_path(graphs.dfs_path(as_graph(neighbours), start, goal))

    source = reference

    def is_good(self, case: Case, path: list[int]) -> bool:
        """Whether the path meets no node twice."""
        return len(set(path)) == len(path)

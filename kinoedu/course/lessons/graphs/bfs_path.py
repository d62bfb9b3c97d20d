"""The exercise `bfs_path`. Bullo & Smith, chapter 2; LaValle, section 2.2."""

from typing import ClassVar

from .... import graphs
from ....graphs.bfs import breadth_first
from ...exercise import Case, Slip
from ...withheld import withheld
from ..shared.graph_slips import (
    followed,
    search_breadth_first,
    search_by_stack,
    search_marking_late,
    tree_path,
    undirected,
    visit_breadth_first,
)
from ..shared.random_graphs import Neighbours, as_graph
from .paths import PathExercise, convert_path, search_depth_first


def find_visit_order(neighbours: Neighbours, start: int, goal: int) -> list[int] | None:
    """Return the order of visit of breadth-first search up to the goal, mistaken for a path."""
    order = visit_breadth_first(neighbours, start)
    return order[: order.index(goal) + 1] if goal in order else None


class BfsPath(PathExercise):
    """Find a path with the fewest edges; any such path is right."""

    name = "bfs_path"
    last_rule = "fewest"
    shown = staticmethod(breadth_first)
    slips: ClassVar[tuple[Slip, ...]] = (
        Slip(
            "stack",
            lambda neighbours, start, goal: tree_path(neighbours, start, goal, search_by_stack),
        ),
        Slip("deep", search_depth_first),
        Slip(
            "late",
            lambda neighbours, start, goal: tree_path(neighbours, start, goal, search_marking_late),
        ),
        Slip("order", find_visit_order),
        Slip(
            "reversed",
            lambda neighbours, start, goal: (
                (tree_path(neighbours, start, goal) or [])[::-1] or None
            ),
        ),
        Slip(
            "undirected",
            lambda neighbours, start, goal: tree_path(undirected(neighbours), start, goal),
        ),
        Slip(
            "from_goal",
            lambda neighbours, start, goal: (
                (tree_path(neighbours, goal, start) or [])[::-1] or None
            ),
        ),
        Slip(
            "goal_alone",
            lambda neighbours, start, goal: followed(search_breadth_first(neighbours, start), goal),
        ),
        Slip(
            "nowhere",
            lambda neighbours, start, goal: (
                tree_path(neighbours, start, goal) if start != goal else None
            ),
        ),
    )

    @staticmethod
    @withheld
    def reference(neighbours: Neighbours, start: int, goal: int) -> list[int] | None:
        """Return the path that the library finds."""
        return convert_path(graphs.bfs_path(as_graph(neighbours), start, goal))

    source = reference

    def is_good(self, case: Case, path: list[int]) -> bool:
        """Whether the path has the fewest edges."""
        return len(path) == len(self.truth(case))

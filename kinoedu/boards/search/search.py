"""The searches' board: a search on a graph or a grid, expansion by expansion, with its frontier and
its parents.
"""

from typing import Any

import ipywidgets as widgets
import numpy as np

from ...geometry.checks import Array
from ...graphs import Expansion, Graph, astar_expansions, bfs_expansions, dfs_expansions
from ...planners.tuning import one_of
from ...words import say
from ..core.canvas import Canvas, with_picture
from ..core.controls import look
from ..core.drawing import Drawing
from ..core.scene import Scene
from .expanding import search_drawn
from .ground import ENDS, graph_in, ground_of

SEARCHES = ("bfs", "dfs", "dijkstra", "astar")


def search_board(
    graph_or_problem: Any, *, search: str = "bfs", start: int | None = None, goal: int | None = None
) -> "SearchBoard":
    """Drag start and goal, which mean the nodes nearest to them, and scrub through the search:
    frontier, parents, path.

    The nodes of a Graph, up to 40 of them, can be dragged too, and the search runs anew; weights
    that are lengths follow. A click on one, or Enter, calls the goal to it, with Shift the start.

    Parameters
    ----------
    graph_or_problem : a Graph whose nodes have places in the plane; a grid (rows, columns), true
    where a cell is free, row 0 the
        lowest, whose cells are joined to those at their four sides; or a Problem in the plane: on a
        Terrain its cells are taken, among polygons a PRM roadmap of 40 samples.
    search : "bfs", "dfs", "dijkstra" or "astar". start, goal : nodes; by default the first and the
    last.

    Up to 900 nodes. `board.moments` are the expansions on show. Raises InvalidParameter,
    InvalidGraph.

    >>> search_board(Graph(nodes=[(0, 0), (1, 0), (0, 1)], edges=[(0, 1), (1, 2)]))
    SearchBoard(from node 0 to node 2: expanded 3 of 3; frontier 0; path cost 2.414, edges 2)
    """
    return SearchBoard(graph_or_problem, search=search, start=start, goal=goal)


class SearchBoard(widgets.VBox):
    """What `search_board` makes: the choice of the search, and the graph in `canvas`."""

    def __init__(
        self, graph_or_problem: Any, *, search: str, start: int | None, goal: int | None
    ) -> None:
        self.ground = ground_of(graph_or_problem, start, goal)
        self.moments: list[Expansion] = []
        names = (
            say("search_board.bfs"),
            say("search_board.dfs"),
            say("search_board.dijkstra"),
            say("search_board.astar"),
        )
        self.search = widgets.Dropdown(
            options=list(zip(names, SEARCHES, strict=True)),
            value=one_of(search, "search", SEARCHES),
            **{**look("planner"), "description": say("search_board.search")},
        )
        self.canvas = Canvas(self.ground.scene, self.answer, free=self.ground.free)
        super().__init__([self.search, self.canvas])
        self.search.observe(lambda _: self.canvas.refresh(), "value")

    def answer(self, scene: Scene) -> Drawing:
        """Search from the node nearest to the start to that nearest to the goal, and draw it."""
        graph, here = (
            graph_in(scene, self.ground.graph),
            [item["at"] for item in scene["handles"][:ENDS]],
        )
        start, goal = graph.closest(here[0])[0], graph.closest(here[1])[0]
        self.moments = moments_of(graph, self.search.value, start, goal)
        return search_drawn(
            graph, self.moments, (start, goal), np.array(here), self.ground.side, scene
        )

    def picture(self) -> bytes:
        """The board as it is now, as a PNG."""
        return self.canvas.picture()

    def __repr__(self) -> str:
        return f"SearchBoard({self.canvas.drawing.says})"

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        return with_picture(super()._repr_mimebundle_(**kwargs), self, self)


def moments_of(graph: Graph, search: str, start: int, goal: int) -> list[Expansion]:
    """A search from node to node, expansion by expansion; Dijkstra's algorithm stops at the goal as
    the others do.
    """
    if search == "bfs":
        return list(bfs_expansions(graph, start, goal))
    if search == "dfs":
        return list(dfs_expansions(graph, start, goal))
    return list(
        astar_expansions(
            graph, start, goal, estimate_of(graph, goal) if search == "astar" else None
        )
    )


def estimate_of(graph: Graph, goal: int) -> Array:
    """Lower bounds on the cost to the goal: distances, made smaller where an edge costs less than
    it is long.
    """
    ends = graph.nodes[graph.edges]
    lengths = np.sqrt(((ends[:, 1] - ends[:, 0]) ** 2).sum(axis=1))
    long = lengths > 0.0
    rate = min(1.0, float((graph.weights[long] / lengths[long]).min(initial=1.0)))
    apart = graph.distances(graph.nodes[goal])
    return np.where(np.isfinite(apart), rate * apart, 0.0)

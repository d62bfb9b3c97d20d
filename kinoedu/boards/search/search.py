"""The board of searches on a graph or a grid, expansion by expansion."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ...browser.searches import ENDS, lower_bounds
from ...geometry.checks import Array
from ...graphs import Expansion, Graph, astar_expansions, bfs_expansions, dfs_expansions
from ...messages import get_message
from ...planners.tuning import one_of
from ...problems import ProblemRecord
from ...support.json_fields import JsonObject
from ..core.canvas import Canvas
from ..core.drawing import Drawing
from ..core.framed import Framed, make_code_box, make_menu
from ..core.scene import Scene
from .expanding import SEARCHES, describe_live, draw_search
from .ground import make_ground, move_nodes
from .lit import trace_search


def search_board(
    graph_or_problem: Graph | ProblemRecord | ArrayLike,
    *,
    search: str = "bfs",
    start: int | None = None,
    goal: int | None = None,
) -> SearchBoard:
    """Scrub through a search from the node nearest to the start to the one nearest to the goal.

    Frontier, parents and path are shown. Start and goal can be dragged. The nodes of a Graph with
    up to 40 nodes can be dragged too, and the search runs again; weights that are lengths follow.
    A click on a node, or Enter, moves the goal to it, with Shift the start. With the box "code" a
    step is a line of the search.

    Parameters
    ----------
    graph_or_problem : of up to 900 nodes: a Graph with positions in the plane; a grid
        (rows, columns), true where a cell is free, row 0 the lowest, whose cells are joined to
        their four neighbours; or a Problem in the plane: on a Terrain its cells are searched,
        among polygons a PRM roadmap of 40 samples.
    search : "bfs", "dfs", "dijkstra" or "astar".
    start, goal : nodes; by default the first and the last.

    Returns
    -------
    SearchBoard
        `moments` are the expansions shown, of the search in `graph` between the nodes `ends`.

    Raises
    ------
    InvalidParameter, InvalidGraph

    Examples
    --------
    >>> search_board(Graph(nodes=[(0, 0), (1, 0), (0, 1)], edges=[(0, 1), (1, 2)]))
    SearchBoard(from node 0 to node 2: expanded 3 of 3; frontier 0; path cost 2.414, edges 2)
    """
    return SearchBoard(graph_or_problem, search=search, start=start, goal=goal)


class SearchBoard(Framed):
    """The widget that `search_board` returns: the menu of searches, and the graph in `canvas`."""

    def __init__(
        self,
        graph_or_problem: Graph | ProblemRecord | ArrayLike,
        *,
        search: str,
        start: int | None,
        goal: int | None,
    ) -> None:
        self.ground = make_ground(graph_or_problem, start, goal)
        options = [(get_message(f"search_board.{name}"), name) for name in SEARCHES]
        chosen = one_of(search, "search", tuple(SEARCHES))
        self.search = make_menu("search_board.search", options, chosen)
        self.code = make_code_box()
        canvas = Canvas(self.ground.scene, self.answer, free=self.ground.free)
        super().__init__([self.search, self.code], [canvas])

    def answer(self, scene: Scene) -> Drawing:
        """Search from the node nearest to the start to that nearest to the goal, and draw it."""
        graph = move_nodes(scene, self.ground.graph)
        here = np.array([item["at"] for item in scene["handles"][:ENDS]])
        start, goal = graph.closest(here[0])[0], graph.closest(here[1])[0]
        guess = heuristic_to(graph, goal) if self.search.value == "astar" else None
        self.graph, self.ends, self._guess = graph, (start, goal), guess
        name = self.search.value
        drawing = draw_search(name, self.ground, graph, self.ends, here, guess)
        if not self.code.value:
            return drawing
        return drawing.completed_by(
            lambda: trace_search(name, graph, (start, goal), guess).draw_over(drawing)
        )

    @property
    def moments(self) -> list[Expansion]:
        """The expansions shown."""
        return list_expansions(self.graph, self.search.value, *self.ends, self._guess)

    def record(self) -> list[JsonObject]:
        """The board as it is now; without its code a page answers it, with it the page plays it."""
        chosen = self.search.value
        self.canvas.live = None if self.code.value else describe_live(self.ground, chosen)
        return super().record()


def list_expansions(
    graph: Graph, search: str, start: int, goal: int, heuristic: Array | None
) -> list[Expansion]:
    """The expansions of a search from node to node; Dijkstra's algorithm stops at the goal too."""
    if search == "bfs":
        return list(bfs_expansions(graph, start, goal))
    if search == "dfs":
        return list(dfs_expansions(graph, start, goal))
    return list(astar_expansions(graph, start, goal, heuristic))


def heuristic_to(graph: Graph, goal: int) -> Array:
    """Lower bounds on the cost to the goal.

    They are distances, scaled down where an edge costs less than its length.
    """
    apart = graph.distances(graph.nodes[goal])
    return np.asarray(lower_bounds(graph.nodes, graph.edges, graph.weights, apart))

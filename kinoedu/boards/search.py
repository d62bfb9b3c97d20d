"""The searches' board: a search on a graph or a grid, expansion by expansion, with its frontier and its parents."""

from typing import Any, NamedTuple

import ipywidgets as widgets
import numpy as np
from numpy.typing import NDArray

from ..errors import InvalidGraph, InvalidParameter
from ..geometry.checks import Array, as_point, shortened
from ..graphs import Expansion, Graph, astar_expansions, bfs_expansions, dfs_expansions
from ..planners import prm
from ..planners.tuning import one_of
from ..problems import ProblemRecord
from ..words import say
from ..worlds.polygon_world import PolygonWorldRecord
from ..worlds.terrain import TerrainRecord
from .board import look
from .canvas import Canvas, with_picture
from .drawing import Drawing
from .expanding import search_drawn
from .plans import scene_of
from .scene import Scene, handle, make_scene

SEARCHES = ("bfs", "dfs", "dijkstra", "astar")
MOST = 900  # nodes: so many expansions are drawn while something is dragged
SAMPLES, NEIGHBOURS = 40, 5  # of the roadmap that a problem among polygons gets


class Ground(NamedTuple):
    """What is searched: a graph, the scene it stands in, and for a grid its free cells and the side of one."""

    graph: Graph
    scene: Scene
    free: NDArray[np.bool_] | None
    side: float


def search_board(graph_or_problem: Any, *, search: str = "bfs", start: int | None = None, goal: int | None = None) -> "SearchBoard":
    """Drag start and goal, which mean the nodes nearest to them, and scrub through the search: frontier, parents, path.

    Parameters
    ----------
    graph_or_problem : a Graph whose nodes have places in the plane; a grid (rows, columns), true where a cell is free, row 0 the
        lowest, whose cells are joined to those at their four sides; or a Problem in the plane: on a Terrain its cells are taken,
        among polygons a PRM roadmap of 40 samples.
    search : "bfs", "dfs", "dijkstra" or "astar". start, goal : nodes; by default the first and the last.

    Up to 900 nodes. `board.moments` are the expansions on show. Raises InvalidParameter, InvalidGraph.

    >>> search_board(Graph(nodes=[(0, 0), (1, 0), (0, 1)], edges=[(0, 1), (1, 2)]))
    SearchBoard(expanded 3 of 3; frontier 0; path cost 2.414, edges 2)
    """
    return SearchBoard(graph_or_problem, search=search, start=start, goal=goal)


class SearchBoard(widgets.VBox):
    """What `search_board` makes: the choice of the search, and the graph in `canvas`."""

    def __init__(self, graph_or_problem: Any, *, search: str, start: int | None, goal: int | None) -> None:
        self.ground = ground_of(graph_or_problem, start, goal)
        self.moments: list[Expansion] = []
        names = (say("search_board.bfs"), say("search_board.dfs"), say("search_board.dijkstra"), say("search_board.astar"))
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
        graph, here = self.ground.graph, [item["at"] for item in scene["handles"]]
        start, goal = graph.closest(here[0])[0], graph.closest(here[1])[0]
        self.moments = moments_of(graph, self.search.value, start, goal)
        return search_drawn(graph, self.moments, (start, goal), np.array(here), self.ground.side, scene)

    def picture(self) -> bytes:
        """The board as it is now, as a PNG."""
        return self.canvas.picture()

    def __repr__(self) -> str:
        return f"SearchBoard({self.canvas.drawing.says})"

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        return with_picture(super()._repr_mimebundle_(**kwargs), self, self)


def moments_of(graph: Graph, search: str, start: int, goal: int) -> list[Expansion]:
    """A search from node to node, expansion by expansion; Dijkstra's algorithm stops at the goal as the others do."""
    if search == "bfs":
        return list(bfs_expansions(graph, start, goal))
    if search == "dfs":
        return list(dfs_expansions(graph, start, goal))
    return list(astar_expansions(graph, start, goal, estimate_of(graph, goal) if search == "astar" else None))


def estimate_of(graph: Graph, goal: int) -> Array:
    """Lower bounds on the cost to the goal: distances, made smaller where an edge costs less than it is long."""
    ends = graph.nodes[graph.edges]
    lengths = np.sqrt(((ends[:, 1] - ends[:, 0]) ** 2).sum(axis=1))
    long = lengths > 0.0
    rate = min(1.0, float((graph.weights[long] / lengths[long]).min(initial=1.0)))
    apart = graph.distances(graph.nodes[goal])
    return np.where(np.isfinite(apart), rate * apart, 0.0)


def ground_of(given: Any, start: int | None, goal: int | None) -> Ground:
    """The graph of what was given, with its scene. Raises InvalidParameter, InvalidGraph."""
    if isinstance(given, Graph):
        if given.space is None or given.nodes.shape[1] != 2 or len(given) == 0:
            raise InvalidGraph(say("search_board.needs", given=shortened(given)))
        return checked(given, ends_in(given, start, goal), None, 0.0)
    if isinstance(given, ProblemRecord) and given.start.shape == (2,):
        world = given.world
        if isinstance(world, TerrainRecord):
            graph = grid_graph(world.free, world.lo, world.resolution)
            return checked(graph, np.array([given.start, given.goal]), world.free, world.resolution, (world.lo, world.hi))
        if isinstance(world, PolygonWorldRecord):
            roadmap = prm(given, n=SAMPLES, k=NEIGHBOURS, rng=0).roadmap
            ground = checked(Graph(nodes=roadmap.nodes, edges=roadmap.edges), np.array([given.start, given.goal]), None, 0.0)
            return ground._replace(scene=standing(scene_of(given), ground.scene))
    free: Any = np.asarray(given) if isinstance(given, np.ndarray | list | tuple) else np.empty(0)
    if free.ndim != 2 or free.dtype != np.bool_ or not free.any():
        raise InvalidParameter(say("search_board.needs", given=shortened(given)))
    graph = grid_graph(free, np.zeros(2), 1.0)
    return checked(graph, ends_in(graph, start, goal), free, 1.0, (np.zeros(2), np.array(free.shape[::-1], float)))


def ends_in(graph: Graph, start: int | None, goal: int | None) -> Array:
    """The places of the nodes where start and goal begin, (2, 2)."""
    nodes = list(graph)
    ends = [nodes[0] if start is None else start, nodes[-1] if goal is None else goal]
    for node in ends:
        if node not in graph:
            raise InvalidGraph(f"start and goal must be nodes of the graph, got {shortened(node)}")
    return graph.nodes[ends]


def checked(
    graph: Graph, ends: Array, free: NDArray[np.bool_] | None, side: float, box: tuple[Array, Array] | None = None
) -> Ground:
    """The ground of a graph that is small enough, in a box or round its nodes."""
    if len(graph) > MOST:
        raise InvalidParameter(say("search_board.too_many", most=MOST, nodes=len(graph)))
    places = graph.nodes[list(graph)]
    lo, hi = box or (places.min(axis=0), places.max(axis=0))
    margin = 0.0 if box else 0.12 * float((hi - lo).max()) or 1.0
    handles = [
        handle(say("search_board.start"), as_point(ends[0], "start"), colour="start"),
        handle(say("search_board.goal"), as_point(ends[1], "goal"), colour="goal", marker="star"),
    ]
    return Ground(graph, make_scene(lo - margin, hi + margin, handles=handles), free, side)


def standing(scene: Scene, searched: Scene) -> Scene:
    """A problem's scene in which nothing but start and goal moves."""
    polygons = [{**item, "movable": False, "vertices": False} for item in scene["polygons"]]
    discs = [{**item, "movable": False} for item in scene["discs"]]
    return {**scene, "handles": searched["handles"], "polygons": polygons, "discs": discs}


def grid_graph(free: NDArray[np.bool_], corner: Array, side: float) -> Graph:
    """A node in the middle of each free cell, row by row, joined to those at its four sides."""
    number = np.full(free.shape, -1)
    number[free] = np.arange(np.count_nonzero(free))
    across = np.stack([number[:, :-1], number[:, 1:]], axis=-1)[free[:, :-1] & free[:, 1:]]
    up = np.stack([number[:-1], number[1:]], axis=-1)[free[:-1] & free[1:]]
    rows, columns = np.nonzero(free)
    return Graph(nodes=corner + side * (np.column_stack([columns, rows]) + 0.5), edges=np.concatenate([across, up]))

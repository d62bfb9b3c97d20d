"""The graph that a search board searches, and the scene in which it is shown."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...browser.search_layers import MOST_NUMBERED
from ...browser.searches import ENDS
from ...errors import InvalidGraph, InvalidParameter
from ...geometry.checks import Array, as_point
from ...graphs import Graph
from ...graphs.checks import edge_lengths
from ...messages import get_message
from ...planners import prm
from ...problems import ProblemRecord
from ...support.text import shortened
from ...worlds.polygon_world import PolygonWorldRecord
from ...worlds.terrain import TerrainRecord
from ..core.scene import Scene, handle, make_scene, stop
from ..planning.plans import make_problem_scene

MOST = 900  # the most nodes: all their expansions are drawn again while something is dragged
SAMPLES, NEIGHBOURS = 40, 5  # of the roadmap that is made for a problem among polygons


class Ground(NamedTuple):
    """A graph and its scene; for a grid also its free cells and the side of a cell."""

    graph: Graph
    scene: Scene
    free: NDArray[np.bool_] | None
    side: float


def make_ground(
    given: Graph | ProblemRecord | ArrayLike, start: int | None, goal: int | None
) -> Ground:
    """The graph of the argument of a search board, with its scene.

    Raises
    ------
    InvalidParameter, InvalidGraph
    """
    if isinstance(given, Graph):
        if given.space is None or given.nodes.shape[1] != 2 or len(given) == 0:
            raise InvalidGraph(get_message("search_board.needs", given=shortened(given)))
        ground = make_small_ground(given, place_ends(given, start, goal), None, 0.0)
        return add_stops(ground) if len(given) <= MOST_NUMBERED else ground
    if isinstance(given, ProblemRecord) and given.start.shape == (2,):
        world = given.world
        ends = np.array([given.start, given.goal])
        if isinstance(world, TerrainRecord):
            graph = make_grid_graph(world.free, world.lo, world.resolution)
            return make_small_ground(
                graph, ends, world.free, world.resolution, (world.lo, world.hi)
            )
        if isinstance(world, PolygonWorldRecord):
            roadmap = prm(given, n=SAMPLES, k=NEIGHBOURS, rng=0).roadmap
            ground = make_small_ground(
                Graph(nodes=roadmap.nodes, edges=roadmap.edges), ends, None, 0.0
            )
            return ground._replace(scene=fix_obstacles(make_problem_scene(given), ground.scene))
    free: Any = np.asarray(given) if isinstance(given, np.ndarray | list | tuple) else np.empty(0)
    if free.ndim != 2 or free.dtype != np.bool_ or not free.any():
        raise InvalidParameter(get_message("search_board.needs", given=shortened(given)))
    graph = make_grid_graph(free, np.zeros(2), 1.0)
    box = np.zeros(2), np.array(free.shape[::-1], float)
    return make_small_ground(graph, place_ends(graph, start, goal), free, 1.0, box)


def place_ends(graph: Graph, start: int | None, goal: int | None) -> Array:
    """The positions of the nodes where start and goal begin, (2, 2)."""
    nodes = list(graph)
    ends = [nodes[0] if start is None else start, nodes[-1] if goal is None else goal]
    for node in ends:
        if node not in graph:
            raise InvalidGraph(f"start and goal must be nodes of the graph, got {shortened(node)}")
    return graph.nodes[ends]


def make_small_ground(
    graph: Graph,
    ends: Array,
    free: NDArray[np.bool_] | None,
    side: float,
    box: tuple[Array, Array] | None = None,
) -> Ground:
    """The ground of a graph that is small enough, in a box or round its nodes."""
    check_size(len(graph))
    places = graph.nodes[list(graph)]
    lo, hi = box or (places.min(axis=0), places.max(axis=0))
    margin = 0.0 if box else 0.16 * float((hi - lo).max()) or 1.0
    handles = [
        handle(get_message("search_board.start"), as_point(ends[0], "start"), colour="start"),
        handle(
            get_message("search_board.goal"),
            as_point(ends[1], "goal"),
            colour="goal",
            marker="star",
        ),
    ]
    return Ground(graph, make_scene(lo - margin, hi + margin, handles=handles), free, side)


def check_size(nodes: int) -> None:
    """Refuse more nodes than a board shows with InvalidParameter."""
    if nodes > MOST:
        raise InvalidParameter(get_message("search_board.too_many", most=MOST, nodes=nodes))


def add_stops(ground: Ground) -> Ground:
    """The ground with a stop on each node: nodes can be dragged, and clicked for start and goal."""
    graph = ground.graph
    stops = [stop(get_message("search_board.node", number=u), graph.nodes[u]) for u in graph]
    return ground._replace(scene={**ground.scene, "handles": ground.scene["handles"] + stops})


def move_nodes(scene: Scene, graph: Graph) -> Graph:
    """The graph with its nodes at the stops of a scene."""
    stops = scene["handles"][ENDS:]
    return place_nodes(graph, [item["at"] for item in stops]) if stops else graph


def place_nodes(graph: Graph, places: ArrayLike) -> Graph:
    """The graph with its nodes at other places, (n, 2).

    Weights that were lengths become the new lengths; others stay.
    """
    nodes, edges, weights = graph.nodes, graph.edges, graph.weights
    were_lengths = has_length_weights(graph)
    nodes[list(graph)] = places
    weights = np.where(were_lengths, edge_lengths(graph.space, nodes, edges), weights)
    moved = Graph(
        edges=edges, weights=weights, nodes=nodes, space=graph.space, directed=graph.directed
    )
    for u in set(range(graph.size)) - set(graph):
        moved.delete_node(u)
    return moved


def has_length_weights(graph: Graph) -> NDArray[np.bool_]:
    """Whether the weight of each edge is its length, (m,)."""
    lengths = edge_lengths(graph.space, graph.nodes, graph.edges)
    return np.isclose(graph.weights, lengths, rtol=1e-9, atol=0.0)


def fix_obstacles(scene: Scene, searched: Scene) -> Scene:
    """A problem's scene in which only start and goal can be dragged."""
    polygons = [{**item, "movable": False, "vertices": False} for item in scene["polygons"]]
    discs = [{**item, "movable": False} for item in scene["discs"]]
    return {**scene, "handles": searched["handles"], "polygons": polygons, "discs": discs}


def make_grid_graph(free: NDArray[np.bool_], corner: Array, side: float) -> Graph:
    """A node in the middle of each free cell, row by row, joined to its four neighbours.

    More cells than a board shows are refused before a graph is made of them.
    """
    check_size(int(np.count_nonzero(free)))
    number = np.full(free.shape, -1)
    number[free] = np.arange(np.count_nonzero(free))
    across = np.stack([number[:, :-1], number[:, 1:]], axis=-1)[free[:, :-1] & free[:, 1:]]
    up = np.stack([number[:-1], number[1:]], axis=-1)[free[:-1] & free[1:]]
    rows, columns = np.nonzero(free)
    nodes = corner + side * (np.column_stack([columns, rows]) + 0.5)
    return Graph(nodes=nodes, edges=np.concatenate([across, up]))

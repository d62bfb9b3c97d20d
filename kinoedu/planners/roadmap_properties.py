"""Four properties of a roadmap, measured: accessible, departable, connected, efficient. Bullo & Smith, section 4.1."""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import body
from ..errors import InvalidParameter
from ..geometry.checks import Array, as_generator, shortened
from ..graphs import dijkstra, flat_graph
from ..problems import ProblemRecord, Recorder, Roadmap
from ..robots.round import RoundRobot
from .asking import askable, body_for
from .multi_query import lengths_of
from .prm import sample_free
from .tuning import whole


class RoadmapProperties(NamedTuple):
    """What `roadmap_properties` measured.

    accessible, departable : the share of free configurations from which a motion leads to some node, and to which one leads.
    connected : whether a path along the roadmap leads from every node to every other.
    efficiency : delta, the greatest ratio of a path along the roadmap to the shortest path, over the pairs drawn; infinite where
        one pair is not joined, and not a number where there was no pair.
    """

    accessible: float
    departable: float
    connected: bool
    efficiency: float


@body
def in_reach(problem: Any, nodes: Array, places: Array) -> NDArray[np.bool_]:
    """For each place (n, d) whether a free motion leads from it to some node, and from some node to it, (n, 2)."""
    reached = np.zeros((len(places), 2), np.bool_)
    for i in range(len(places)):
        for j in range(len(nodes)):
            reached[i, 0] = reached[i, 0] or problem.is_free_path(places[i], nodes[j])
            reached[i, 1] = reached[i, 1] or problem.is_free_path(nodes[j], places[i])
    return reached


@body
def in_sliding_reach(problem: Any, nodes: Array, places: Array) -> NDArray[np.bool_]:
    """The same by semi-free motions: the nodes of a visibility roadmap are in contact."""
    reached = np.zeros((len(places), 2), np.bool_)
    for i in range(len(places)):
        for j in range(len(nodes)):
            reached[i, 0] = reached[i, 0] or problem.is_semi_free_path(places[i], nodes[j])
            reached[i, 1] = reached[i, 1] or problem.is_semi_free_path(nodes[j], places[i])
    return reached


def roadmap_properties(
    problem: Any,
    roadmap: Roadmap,
    *,
    n: int = 200,
    shortest: Callable[[Array, Array], float] | None = None,
    rng: int | np.random.Generator,
) -> RoadmapProperties:
    """Measure how well a roadmap serves its free space.

    Parameters
    ----------
    problem : whose roadmap it is.
    roadmap : what build_roadmap, grid_roadmap or visibility_roadmap made; the roadmap of a plan.
    n : how many free configurations are drawn, and how many pairs of nodes.
    shortest : a function of two nodes' configurations that gives the length of the shortest path between them. Without it their
        distance is taken, which no path undercuts: then the efficiency is at most what is measured.
    rng : a seed or a numpy Generator.

    Shares are those of the draws: all of them reached proves nothing, one missed disproves. Points and disks may slide along
    obstacles. O(n m) motions for m nodes. Raises InvalidParameter.

    >>> from kinoedu import Point, PolygonWorld, Problem, visibility_roadmap
    >>> world = PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(3, 2), (6, 2), (6, 4), (3, 4)]])
    >>> problem = Problem(Point(), world, start=(1, 1), goal=(8, 1))
    >>> roadmap_properties(problem, visibility_roadmap(world), n=50, rng=0)[:3]
    (1.0, 1.0, True)
    """
    if not isinstance(roadmap, Roadmap):
        raise InvalidParameter(f"expected a roadmap, such as build_roadmap makes, got {shortened(roadmap)}")
    asked, draws, generator = askable(problem), whole(n, "n", least=1), as_generator(rng)
    inner = problem.problem if isinstance(problem, Recorder) else problem
    slides = isinstance(inner, ProblemRecord) and isinstance(inner.robot, RoundRobot)
    places = body_for(asked, sample_free)(asked, draws, 100 * draws, generator)
    reached = body_for(asked, in_sliding_reach if slides else in_reach)(asked, roadmap.nodes, places)
    graph = flat_graph(len(roadmap.nodes), roadmap.edges, body_for(asked, lengths_of)(asked, *roadmap))
    connected = len(roadmap.nodes) > 0 and bool(np.isfinite(dijkstra(graph, 0).cost).all())
    accessible, departable = reached.mean(axis=0).tolist() if len(places) else (np.nan, np.nan)
    delta = worst_ratio(roadmap.nodes, graph, asked.distance if shortest is None else shortest, draws, generator)
    return RoadmapProperties(accessible, departable, connected, delta)


def worst_ratio(nodes: Array, graph: Any, shortest: Callable[[Array, Array], float], pairs: int, rng: np.random.Generator) -> float:
    """The greatest ratio of the way along the graph to the shortest one, over random pairs of nodes at different places."""
    worst = np.nan
    if len(nodes) == 0:
        return worst
    for u in rng.integers(len(nodes), size=pairs):
        v = rng.integers(len(nodes))
        least = float(shortest(nodes[u], nodes[v])) if u != v else 0.0
        if 0.0 < least < np.inf:
            worst = float(np.fmax(worst, dijkstra(graph, int(u)).cost[v] / least))
    return worst

"""Four properties of a roadmap, measured: accessible, departable, connected, efficient.

Bullo & Smith, chapter 5.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...compiled import algorithm
from ...errors import InvalidParameter
from ...geometry.checks import Array, as_generator
from ...graphs import GraphRecord, Search, dijkstra, extract_path, flat_graph
from ...graphs.components import label_components
from ...problems import ProblemRecord, Recorder, Roadmap
from ...problems.protocols import PlanningProblem, ProblemLike
from ...problems.recorder import unwrap_recorder
from ...robots.round import RoundRobot
from ...support.constructors import with_type_names
from ...support.text import shortened
from ..problem_input import as_problem
from ..tuning import integer
from .multi_query import motion_costs
from .prm import sample_free

Length = Callable[[Array, Array], float]


@with_type_names
class RoadmapProperties(NamedTuple):
    """The four properties of a roadmap, as measured by `roadmap_properties`.

    accessible : the fraction of free configurations from which a free motion leads to some node.
    departable : the fraction to which a free motion leads from some node.
    connected : whether a path along the roadmap joins every two nodes.
    efficiency : delta, the greatest ratio of a path along the roadmap to the shortest path, over
        the pairs drawn; infinite where one pair is not joined, nan where there was no pair.
    """

    accessible: float
    departable: float
    connected: bool
    efficiency: float


@with_type_names
class RoadmapSurvey(NamedTuple):
    """The data from which the properties of a roadmap are computed.

    places : (n, d), the free configurations that were drawn.
    reached : (n, 2), whether a motion leads from each of them to some node, and from some node to
        it.
    component : (m,), the component of each node, numbered from the largest to the smallest.
    worst : the pair of nodes, of those drawn, with the greatest ratio; empty where there was no
        pair.
    path : the nodes of the path along the roadmap between them; empty where there is no path.
    efficiency : the ratio of that path's length to the shortest length.
    """

    places: Array
    reached: NDArray[np.bool_]
    component: NDArray[np.int64]
    worst: tuple[int, ...]
    path: NDArray[np.int64]
    efficiency: float

    @property
    def properties(self) -> RoadmapProperties:
        """The four properties."""
        accessible, departable = (
            self.reached.mean(axis=0).tolist() if len(self.places) else (np.nan, np.nan)
        )
        connected = len(self.component) > 0 and not self.component.any()
        return RoadmapProperties(accessible, departable, connected, self.efficiency)


@algorithm
def find_reached(problem: PlanningProblem, nodes: Array, places: Array) -> NDArray[np.bool_]:
    """Whether each place (n, d) can reach some node by a free motion, and some node it, (n, 2)."""
    reached = np.zeros((len(places), 2), np.bool_)
    for i in range(len(places)):
        for j in range(len(nodes)):
            reached[i, 0] = reached[i, 0] or problem.is_free_path(places[i], nodes[j])
            reached[i, 1] = reached[i, 1] or problem.is_free_path(nodes[j], places[i])
    return reached


@algorithm
def find_reached_sliding(
    problem: ProblemRecord | Recorder, nodes: Array, places: Array
) -> NDArray[np.bool_]:
    """As `find_reached`, by semi-free motions: the nodes of a visibility roadmap are in contact."""
    reached = np.zeros((len(places), 2), np.bool_)
    for i in range(len(places)):
        for j in range(len(nodes)):
            reached[i, 0] = reached[i, 0] or problem.is_semi_free_path(places[i], nodes[j])
            reached[i, 1] = reached[i, 1] or problem.is_semi_free_path(nodes[j], places[i])
    return reached


def roadmap_properties(
    problem: ProblemLike,
    roadmap: Roadmap,
    *,
    n: int = 200,
    shortest: Length | None = None,
    rng: int | np.random.Generator,
) -> RoadmapProperties:
    """Measure four properties of a roadmap on random configurations and pairs of nodes.

    That all configurations were reached proves nothing about others; that one was missed disproves
    the property. Points and disks may slide along obstacles. O(n m) motions for m nodes.

    Parameters
    ----------
    problem : the problem for which the roadmap was built.
    roadmap : of build_roadmap, grid_roadmap, visibility_roadmap, or of a plan.
    n : how many free configurations are drawn, and how many pairs of nodes.
    shortest : a function of the configurations of two nodes that returns the length of the shortest
        path between them. By default it is their distance, which is a lower bound: then the true
        efficiency is at most the measured one.
    rng : a seed or a numpy Generator.

    Returns
    -------
    RoadmapProperties

    Raises
    ------
    InvalidParameter
        Where `roadmap` is not a roadmap, or a parameter is out of its range.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem, visibility_roadmap
    >>> world = PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(3, 2), (6, 2), (6, 4), (3, 4)]])
    >>> problem = Problem(Point(), world, start=(1, 1), goal=(8, 1))
    >>> roadmap_properties(problem, visibility_roadmap(world), n=50, rng=0)[:3]
    (1.0, 1.0, True)
    """
    return survey_roadmap(problem, roadmap, n=n, shortest=shortest, rng=rng).properties


def survey_roadmap(
    problem: ProblemLike,
    roadmap: Roadmap,
    *,
    n: int = 200,
    shortest: Length | None = None,
    rng: int | np.random.Generator,
) -> RoadmapSurvey:
    """The data of `roadmap_properties`, which has the same parameters.

    Returns
    -------
    RoadmapSurvey

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> world = PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(3, 0), (6, 0), (6, 6), (3, 6)]])
    >>> problem = Problem(Point(), world, start=(1, 1), goal=(8, 1))
    >>> roadmap = Roadmap(np.array([(1.0, 1.0), (2.0, 5.0), (8.0, 1.0)]), np.array([(0, 1)]))
    >>> survey = survey_roadmap(problem, roadmap, n=9, rng=0)
    >>> survey.component, survey.reached.all(), survey.efficiency
    (array([0, 0, 1]), np.True_, inf)
    """
    if not isinstance(roadmap, Roadmap):
        raise InvalidParameter(
            f"expected a roadmap, such as build_roadmap makes, got {shortened(roadmap)}"
        )
    problem, draws, generator = as_problem(problem), integer(n, "n", least=1), as_generator(rng)
    inner = unwrap_recorder(problem)
    slides = isinstance(inner, ProblemRecord) and isinstance(inner.robot, RoundRobot)
    places = sample_free(problem, draws, 100 * draws, generator)
    reached = (find_reached_sliding if slides else find_reached)(problem, roadmap.nodes, places)
    graph = flat_graph(len(roadmap.nodes), roadmap.edges, motion_costs(problem, *roadmap))
    worst, path, delta = worst_pair(
        roadmap.nodes, graph, problem.distance, shortest or problem.distance, draws, generator
    )
    return RoadmapSurvey(places, reached, number_components(graph), worst, path, delta)


def number_components(graph: GraphRecord) -> NDArray[np.int64]:
    """The component of each node, (m,), numbered from the largest; ties go to the first."""
    labels = label_components(graph, graph.size)
    order = np.argsort(-np.bincount(labels), kind="stable")
    return np.argsort(order)[labels]


def worst_pair(
    nodes: Array,
    graph: GraphRecord,
    distance: Length,
    shortest: Length,
    pairs: int,
    rng: np.random.Generator,
) -> tuple[tuple[int, ...], NDArray[np.int64], float]:
    """The pair of nodes with the greatest ratio of its path along the graph to its shortest path.

    Random pairs of nodes at different places are compared. The ratio to the distance bounds the
    ratio to the shortest path from above, so pairs are tried in that order until no other can be
    worse.

    Returns
    -------
    The pair, the path between them, and the ratio.
    """
    worst: tuple[int, ...] = ()
    path, delta = np.empty(0, np.int64), np.nan
    searches: dict[int, Search] = {}
    candidates = []
    for u in rng.integers(len(nodes), size=pairs).tolist() if len(nodes) else []:
        v = int(rng.integers(len(nodes)))
        search = searches.get(u) or searches.setdefault(u, dijkstra(graph, u))
        apart = float(distance(nodes[u], nodes[v])) if u != v else 0.0
        if apart > 0.0:
            candidates.append((search.cost[v] / apart, u, v))
    for bound, u, v in sorted(candidates, key=lambda candidate: -candidate[0]):
        if bound <= delta:
            break
        least = float(shortest(nodes[u], nodes[v]))
        ratio = searches[u].cost[v] / least if 0.0 < least < np.inf else np.nan
        if not ratio <= delta and not np.isnan(ratio):
            worst, delta = (u, v), float(ratio)
            path = extract_path(searches[u].parent, v) if ratio < np.inf else path[:0]
    return worst, path, delta

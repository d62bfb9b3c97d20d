"""The properties' board: the quality of a roadmap, measured again when obstacles are dragged."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...figures.drawing import dot_size
from ...geometry.checks import Array
from ...messages import get_message
from ...planners import build_roadmap, plan_by_visibility
from ...planners.roadmaps.properties import Length, RoadmapSurvey, survey_roadmap
from ...problems import Plan, ProblemRecord, Roadmap
from ...worlds.polygon_world import PolygonWorldRecord, discs_of
from ..core.drawing import Drawing, Layer, dots, edges, labels, path, segments_along
from ..core.framed import Framed
from ..core.scene import Scene
from ..planning.plans import check_in_plane, make_canvas, make_world_scene, world_in
from .roadmaps import RoadmapControls

PLACES = 100  # the places sampled, and the pairs of nodes
DRAGGED = 25  # those while something is dragged
Style = tuple[str, float, tuple[float, ...]]  # colour, width, dashes
LOOKS: tuple[Style, ...] = (  # of components, the largest first
    ("roadmap", 0.9, ()),
    ("robot", 2.0, ()),
    ("cut", 2.0, (7.0, 4.0)),
    ("clear", 2.0, (2.0, 4.0)),
    ("ink", 1.6, (9.0, 3.0, 2.0, 3.0)),
)


def properties_board(
    problem: ProblemRecord,
    n: int = 100,
    *,
    rule: str = "closest",
    sampler: str = "random",
    rng: int = 0,
) -> PropertiesBoard:
    """Drag obstacles, and see whether the roadmap is accessible, departable and efficient.

    Red crosses are places without a free motion to a node. Each component has its own style. Of the
    pairs of nodes sampled, the one with the worst way is shown, beside the shortest path, dashed.
    The ways of a point among polygons are compared with shortest paths, all others with straight
    lines.

    Parameters
    ----------
    problem : a Problem in the plane; its start and goal are left out.
    n, rule, sampler, rng : as for `roadmap_board`.

    Returns
    -------
    PropertiesBoard
        `survey` is the result of the measurement, `survey.properties` the four properties.

    Raises
    ------
    InvalidParameter

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> room = [(0, 0), (10, 0), (10, 10), (0, 10)]
    >>> world = PolygonWorld(room, [[(4, 0), (6, 0), (6, 8), (4, 8)]])
    >>> board = properties_board(Problem(Point(), world, start=(1, 1), goal=(9, 1)), n=20)
    >>> print(board.canvas.drawing.text)
    accessible 100 of 100 places sampled, departable 100; components 1
    efficient: δ at least 1.94, for u and v, the worst pair sampled
    """
    return PropertiesBoard(problem, n, rule, sampler, rng)


class PropertiesBoard(Framed):
    """The widget that `properties_board` returns: controls, and the survey in `canvas`."""

    def __init__(self, problem: ProblemRecord, n: int, rule: str, sampler: str, rng: int) -> None:
        self._given = check_in_plane(problem)
        self.controls = RoadmapControls(problem, n, rule, sampler, rng)
        self.survey: RoadmapSurvey | None = None
        canvas = make_canvas(problem.world, make_world_scene(problem.world, []), self.answer)
        super().__init__(self.controls.all, [canvas])

    def answer(self, scene: Scene) -> Drawing:
        """Build the roadmap in a scene and measure it, briefly while something is dragged."""
        self.survey = None
        world = self._given.world
        if isinstance(world, PolygonWorldRecord):
            world = world_in(scene)
        problem = self._given._replace(world=world, query_counts=np.zeros(2, np.int64))
        roadmap = build_roadmap(problem, **self.controls.given)
        first = self._measure(problem, roadmap, DRAGGED)
        text = get_message("properties_board.first", text=first.text, most=PLACES)
        return replace(
            first,
            text=text,
            whole=lambda: self._measure(problem, roadmap, PLACES),
            unfinished=True,
        )

    def _measure(self, problem: ProblemRecord, roadmap: Roadmap, n: int) -> Drawing:
        """Measure a roadmap with n places and n pairs of nodes, and draw both."""
        exact = knows_shortest_paths(problem)
        shortest = make_length(problem) if exact else None
        # Another seed than the roadmap's: with the same one the places would be its nodes.
        rng = np.random.default_rng((self.controls.seed.value, 1))
        self.survey = survey_roadmap(problem, roadmap, n=n, shortest=shortest, rng=rng)
        return draw_survey(problem, roadmap, self.survey, exact)

    def _dress(self) -> None:
        self.controls.dress()


def knows_shortest_paths(problem: ProblemRecord) -> bool:
    """Whether shortest paths can be computed: for a point among polygons."""
    world = problem.world
    if not isinstance(world, PolygonWorldRecord) or len(discs_of(world)):
        return False
    return getattr(problem.robot, "radius", np.inf) + problem.clearance == 0.0


def plan_shortest(problem: ProblemRecord, u: Array, v: Array) -> Plan:
    """The shortest path between two nodes."""
    return plan_by_visibility(problem._replace(start=u, goal=v, query_counts=np.zeros(2, np.int64)))


def make_length(problem: ProblemRecord) -> Length:
    """The length of the shortest path, as a function of two nodes."""
    return lambda u, v: plan_shortest(problem, u, v).cost


def draw_survey(
    problem: ProblemRecord, roadmap: Roadmap, survey: RoadmapSurvey, exact: bool
) -> Drawing:
    """Draw components, places without a motion to the roadmap, and the worst pair."""
    layers = draw_components(roadmap, survey)
    reached = survey.reached.all(axis=1)
    layers += [
        dots(survey.places[reached], "outside", radius=2.5),
        draw_crosses(survey.places[~reached], problem),
    ]
    if survey.worst:
        layers += draw_worst_pair(problem, roadmap.nodes, survey, exact)
    return Drawing(
        [layer for layer in layers if len(layer.rows)], text=describe_survey(survey, exact)
    )


def draw_components(roadmap: Roadmap, survey: RoadmapSurvey) -> list[Layer]:
    """Draw each component in its own style; styles repeat from the second one on."""
    style = np.where(survey.component == 0, 0, 1 + (survey.component - 1) % (len(LOOKS) - 1))
    radius = max(dot_size(len(roadmap.nodes)) / 2.0, 2.5)
    layers = []
    for k, (colour, width, dash) in enumerate(LOOKS):
        own = roadmap.edges[style[roadmap.edges[:, 0]] == k]
        layers.append(edges(roadmap.nodes[own], colour, width=width, dash=dash))
        look, size = ("tree", radius) if k == 0 else (colour, radius + 1.5)
        layers.append(dots(roadmap.nodes[style == k], look, radius=size))
    return layers


def draw_crosses(places: Array, problem: ProblemRecord) -> Layer:
    """Crosses at places."""
    size = 0.011 * float((problem.world.hi - problem.world.lo).max())
    arms = size * np.array([[(-1, -1), (1, 1)], [(-1, 1), (1, -1)]])
    return edges((places[:, None, None] + arms).reshape(-1, 2, 2), "hit", width=2.6)


def draw_worst_pair(
    problem: ProblemRecord, nodes: Array, survey: RoadmapSurvey, exact: bool
) -> list[Layer]:
    """Draw the worst pair, its way along the roadmap, and the shortest path or a straight line."""
    u, v = nodes[list(survey.worst)]
    best = plan_shortest(problem, u, v).path if exact else None
    line = np.array([u, v]) if best is None else best
    return [
        path(nodes[survey.path], "path"),
        edges(segments_along(line), "free", width=5.0),
        edges(segments_along(line), "ink", width=2.2, dash=(7.0, 5.0)),
        dots([u, v], "ink", radius=6.0),
        labels(
            [u, v], [get_message("properties_board.u"), get_message("properties_board.v")], "ink"
        ),
    ]


def describe_survey(survey: RoadmapSurvey, exact: bool) -> str:
    """The four properties in words."""
    delta = survey.efficiency
    reach, leave = survey.reached.sum(axis=0).tolist() if len(survey.places) else (0, 0)
    if np.isnan(delta):
        efficient = get_message("properties_board.none")
    elif np.isinf(delta):
        efficient = get_message("properties_board.apart")
    else:
        bound = "least" if exact else "most"
        efficient = get_message(f"properties_board.{bound}", delta=f"{delta:.3g}")
    return get_message(
        "properties_board.result",
        accessible=reach,
        departable=leave,
        places=len(survey.places),
        components=int(survey.component.max(initial=-1)) + 1,
        efficient=efficient,
    )

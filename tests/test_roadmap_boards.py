"""The boards of roadmaps, their properties, races, rewiring and exploration, without a browser."""

import io
from functools import partial

import numpy as np
import pytest
from PIL import Image
from test_board import LET_GO, Page
from test_planning_boards import layers_of, shown

import kinoedu as ke
from kinoedu.boards import (
    exploring_board,
    properties_board,
    race_board,
    rewiring_board,
    roadmap_board,
)
from kinoedu.boards.core.drawing import Drawing, cells, encode_drawing
from kinoedu.boards.planning import race
from kinoedu.boards.planning.racing import run_planner
from kinoedu.boards.trees.rewired import (
    costs_at,
    find_last_path,
    find_near_pairs,
    find_paths_to_goal,
)
from kinoedu.errors import InvalidParameter
from kinoedu.graphs import dijkstra
from kinoedu.planners.exploring.receding_horizon import plan_from_looks, receding_horizon_looks
from kinoedu.planners.roadmaps.prm import sample_free
from kinoedu.planners.roadmaps.properties import survey_roadmap
from kinoedu.planners.trees.rewiring import rrt_star_rewirings
from kinoedu.problems import Roadmap
from kinoedu.worlds.polygon_world import world_of_triangles

SQUARE = [(0, 0), (10, 0), (10, 10), (0, 10)]
WALL = [(4, 0), (6, 0), (6, 8), (4, 8)]
CLOSED = [(4, -1), (6, -1), (6, 11), (4, 11)]
MAKERS = {
    "roadmap": lambda problem: roadmap_board(problem, n=60),
    "properties": lambda problem: properties_board(problem, n=40),
    "race": lambda problem: race_board(problem, nodes=150),
    "rewiring": lambda problem: rewiring_board(problem, nodes=150),
    "exploring": lambda problem: exploring_board(problem, 3.0),
}


def problem_of(*obstacles, start=(1, 1), goal=(9, 1), **given):
    """A point between start and goal, by default with a wall between them."""
    return ke.Problem(
        ke.Point(), ke.PolygonWorld(SQUARE, obstacles or [WALL]), start, goal, **given
    )


def length_of(points):
    return float(np.hypot(*np.diff(points, axis=0).T).sum())


# ---- all boards


@pytest.mark.parametrize("kind", MAKERS)
def test_growing_layers_come_in_order_with_a_text_for_each_step(kind):
    """The page stops at the first later row; rows disappear after they appear; pictures exist."""
    made = MAKERS[kind](problem_of())
    for canvas in made.canvases:
        drawing = canvas.drawing
        assert not drawing.warning and drawing.text
        assert len(drawing.step_texts) == drawing.total
        for layer in drawing.layers:
            assert layer.when is None or (
                len(layer.when) == len(layer.rows) and (np.diff(layer.when) >= 0).all()
            )
            assert layer.until is None or (layer.until > layer.when).all()
    assert Image.open(io.BytesIO(made.picture())).width > 300
    assert repr(made).startswith(type(made).__name__)


@pytest.mark.parametrize("kind", MAKERS)
def test_an_obstacle_is_dragged_and_a_fault_is_told(kind):
    """The drawing changes; a ring that crosses itself is a warning, and the board goes on."""
    made = MAKERS[kind](problem_of())
    page, before = Page(made.canvas), made.canvas.drawing.text
    after = page.moves(("polygon", 0, [[(x, y + 1.5) for x, y in WALL]]))
    assert after["text"] != before and not after["warning"]
    assert (
        "crosses" in page.moves(("polygon", 0, [[WALL[0], WALL[2], WALL[1], WALL[3]]]))["warning"]
    )
    page.moves(("polygon", 0, [WALL]))
    assert made.canvas.drawing.text == before


@pytest.mark.parametrize("kind", MAKERS)
def test_what_is_no_problem_in_the_plane_is_refused(kind):
    """Errors are raised before anything is shown."""
    turning = ke.Problem(
        ke.RigidPolygon([(0, 0), (1, 0), (0, 1)]), ke.PolygonWorld(SQUARE), (2, 2, 0), (8, 8, 0)
    )
    for wrong in (None, turning):
        with pytest.raises(InvalidParameter):
            MAKERS[kind](wrong)


def test_boards_of_roadmaps_and_races_play_on_terrains_too():
    """With the bitmap beneath; only the exploring board needs walls."""
    problem = ke.Problem(ke.Point(), ke.Terrain(np.ones((9, 9), bool)), (1, 1), (8, 8))
    for kind in ("roadmap", "properties", "race", "rewiring"):
        made = MAKERS[kind](problem)
        assert made.canvas.bitmap and not made.canvas.drawing.warning
    with pytest.raises(InvalidParameter, match="PolygonWorld"):
        exploring_board(problem)


# ---- roadmaps


def test_a_roadmap_grows_node_by_node_and_counts_its_components():
    """At each step the components are those of networkx; the path comes last."""
    import networkx as nx

    made = roadmap_board(problem_of(), n=60)
    roadmap, drawing = made.plan.roadmap, made.canvas.drawing
    n, (lines,) = len(roadmap.nodes), layers_of(made.canvas, "edges", "roadmap")
    assert drawing.total == 2 * n and drawing.layers[-1].last
    for step in range(0, 2 * n, 7):
        graph = nx.empty_graph(n)
        graph.add_edges_from(edge for edge in roadmap.edges.tolist() if edge[0] < step - n)
        assert len(shown(lines, step)) == graph.number_of_edges()
        if step > n:
            assert drawing.step_texts[step].endswith(
                f"components {nx.number_connected_components(graph)}"
            )


def test_the_rule_is_switched_live():
    """The plan is prm's with that rule; only its number is shown; a forest has few edges."""
    made = roadmap_board(problem_of(), n=80)
    assert made.controls.k.layout.display is None and made.controls.r.layout.display == "none"
    made.controls.rule.value = "radius"
    assert made.controls.k.layout.display == "none" and made.controls.r.layout.display is None
    made.controls.r.value = 2.0
    same = ke.prm(problem_of(), n=80, neighbours=ke.Radius(made.controls.r.value), rng=0)
    assert np.array_equal(made.plan.roadmap.edges, same.roadmap.edges)
    made.controls.rule.value = "component"
    components = int(made.canvas.drawing.text.rpartition(" ")[2])
    assert len(made.plan.roadmap.edges) == 82 - components
    made.controls.sampler.value = "halton"
    assert made.controls.seed.layout.display == "none"
    free = [q for q in 10.0 * ke.halton(80) if made.plan.problem.is_free(q)]
    assert np.allclose(made.plan.roadmap.nodes[2:], free)
    made.controls.sampler.value = "grid"
    assert len(np.unique(made.plan.roadmap.nodes[2:, 0])) <= 8


def test_without_a_path_the_board_says_why():
    """A wall from side to side."""
    assert "no path: " in repr(roadmap_board(problem_of(CLOSED), n=60))
    with pytest.raises(InvalidParameter, match="rule"):
        roadmap_board(problem_of(), rule="nearest")


# ---- properties


def test_a_survey_is_what_the_properties_are_reckoned_from():
    """Fractions, components and the worst pair against networkx, over the ratios of all pairs."""
    import networkx as nx

    problem, roadmap = problem_of(), ke.build_roadmap(problem_of(), n=40, k=3, rng=3)
    survey = survey_roadmap(problem, roadmap, n=60, rng=5)
    graph = nx.empty_graph(len(roadmap.nodes))
    for u, v in roadmap.edges.tolist():
        graph.add_edge(u, v, weight=float(np.hypot(*(roadmap.nodes[u] - roadmap.nodes[v]))))
    pieces = sorted(
        map(sorted, nx.connected_components(graph)), key=lambda piece: (-len(piece), piece[0])
    )
    assert [np.flatnonzero(survey.component == k).tolist() for k in range(len(pieces))] == pieces
    for place, (there, back) in zip(survey.places, survey.reached, strict=True):
        assert (
            there == back == any(problem.is_semi_free_path(place, node) for node in roadmap.nodes)
        )
    found = ke.roadmap_properties(problem, roadmap, n=60, rng=5)
    assert found == survey.properties
    assert survey.efficiency == np.inf or survey.efficiency == pytest.approx(
        length_of(roadmap.nodes[survey.path])
        / np.hypot(*np.subtract(*roadmap.nodes[list(survey.worst)]))
    )


def test_the_worst_pair_is_the_worst_of_all_that_were_drawn():
    """The search stops early and misses none: against the ratios of all pairs sampled."""
    problem, roadmap = problem_of(), ke.build_roadmap(problem_of(), n=50, k=8, rng=1)
    graph, taken = ke.Graph(nodes=roadmap.nodes, edges=roadmap.edges), []

    def shortest(u, v):
        taken.append(ke.plan_by_visibility(problem._replace(start=u, goal=v)).cost)
        return taken[-1]

    survey = survey_roadmap(problem, roadmap, n=40, shortest=shortest, rng=2)
    measured, rng = len(taken), np.random.default_rng(2)
    assert np.array_equal(
        sample_free(problem, 40, 4000, rng), survey.places
    )  # the pairs are drawn after them
    pairs = [(u, rng.integers(50)) for u in rng.integers(50, size=40)]
    ratios = [
        dijkstra(graph, u).cost[v] / shortest(*roadmap.nodes[[u, v]]) for u, v in pairs if u != v
    ]
    assert (
        np.isfinite(survey.efficiency)
        and survey.efficiency == pytest.approx(max(ratios))
        and measured < len(ratios)
    )
    u, v = survey.worst
    assert survey.efficiency == pytest.approx(
        length_of(roadmap.nodes[survey.path]) / shortest(*roadmap.nodes[[u, v]])
    )


def test_cut_off_places_are_crosses_and_components_have_styles():
    """One neighbour each: pieces, and delta infinite; few nodes: some places are out of reach."""
    made = properties_board(problem_of(), n=40)
    assert made.survey.properties.connected and not layers_of(made.canvas, "edges", "robot")
    made.controls.k.value = 1
    assert "δ is infinite" in repr(made) and layers_of(made.canvas, "edges", "robot")
    made.controls.n.value = 2
    (crosses,) = layers_of(made.canvas, "edges", "hit")
    assert len(crosses.rows) == 2 * np.count_nonzero(~made.survey.reached[:, 0]) > 0
    one = Roadmap(np.array([(1.0, 1.0)]), np.empty((0, 2), np.int64))
    survey = survey_roadmap(problem_of(CLOSED), one, n=100, rng=0)
    assert (survey.reached[:, 0] == (survey.places[:, 0] < 5)).all() and np.isnan(survey.efficiency)


def test_pairs_that_no_path_joins_are_no_fault_of_the_roadmap():
    """A wall from side to side: not connected, but efficient where there are paths."""
    made = properties_board(problem_of(CLOSED), n=40)
    assert not made.survey.properties.connected and 1.0 <= made.survey.efficiency < np.inf


def test_places_are_not_the_nodes():
    """The roadmap's own samples would always be accessible."""
    made = properties_board(problem_of(), n=50)
    nodes = ke.build_roadmap(problem_of(), n=50, rng=0).nodes
    assert not (made.survey.places[:, None] == nodes).all(axis=2).any()


# ---- rewiring


def test_the_log_of_an_rrt_star_ends_with_its_tree():
    """Replayed it ends as the planner's tree, and each rewired edge made its node cheaper."""
    plan, log = rrt_star_rewirings(problem_of(), max_nodes=400, rng=1)
    same = ke.rrt_star(problem_of(), max_nodes=400, rng=1)
    assert np.array_equal(plan.tree.nodes, same.tree.nodes) and np.array_equal(
        plan.tree.parent, same.tree.parent
    )
    parent = np.full(len(log.nodes), -1)

    def cost(node):
        return (
            0.0
            if parent[node] < 0
            else cost(parent[node]) + np.hypot(*(log.nodes[node] - log.nodes[parent[node]]))
        )

    for node, above, came in zip(log.node, log.parent, log.created_at, strict=True):
        before = cost(node) if node != came else np.inf
        assert above < came or node != came
        parent[node] = above
        assert cost(node) < before
        assert node == came or above == came
    assert np.array_equal(parent, same.tree.parent)
    assert np.count_nonzero(log.node != log.created_at) > 50


def test_a_log_without_room_is_kept_once_more():
    """More rewirings than the first log has rows: the same log, complete."""
    from kinoedu.planners.trees import rewiring

    _, whole = rrt_star_rewirings(problem_of(), max_nodes=200, rng=1)
    usual, rewiring.EDGES_PER_NODE = rewiring.EDGES_PER_NODE, 1
    try:
        _, again = rrt_star_rewirings(problem_of(), max_nodes=200, rng=np.random.default_rng(1))
    finally:
        rewiring.EDGES_PER_NODE = usual
    assert all(np.array_equal(a, b) for a, b in zip(whole, again, strict=True))
    assert len(whole.node) > 200


def test_the_tree_and_the_way_are_shown_as_they_were():
    """At every step each node but the root has one edge, and the path is that tree's."""
    made = rewiring_board(problem_of(), nodes=200)
    log, (tree,) = made.rewirings, layers_of(made.canvas, "edges", "tree")
    paths = find_paths_to_goal(log)
    assert paths[-1].cost == pytest.approx(made.plan.cost) and paths[0].step == log.at_goal + 1
    costs = np.array(costs_at(paths, len(log.nodes)))
    assert (np.diff(costs[np.isfinite(costs)]) <= 1e-12).all()
    (way,) = layers_of(made.canvas, "edges", "path")
    for step in range(1, len(log.nodes) + 1, 13):
        assert (
            len(np.unique(shown(tree, step)[:, 2:], axis=0)) == len(shown(tree, step)) == step - 1
        )
        legs = shown(way, step)
        walked = np.hypot(legs[:, 2] - legs[:, 0], legs[:, 3] - legs[:, 1]).sum()
        assert walked == pytest.approx(costs[step]) if np.isfinite(costs[step]) else len(legs) == 0
    smaller = ke.rrt_star(problem_of(), max_nodes=150, rng=0)
    assert costs[151] == pytest.approx(smaller.cost)


@pytest.mark.parametrize("goal", [(9, 1), (9.9, 9.9)])
def test_the_last_path_is_that_of_the_whole_history(goal):
    """A drag draws only this one. A goal that was not reached has none."""
    _, log = rrt_star_rewirings(problem_of()._replace(goal=np.array(goal)), max_nodes=90, rng=1)
    for mine, whole in zip(find_last_path(log), find_paths_to_goal(log)[-1:], strict=True):
        assert mine.step == whole.step and mine.cost == whole.cost
        assert np.array_equal(mine.points, whole.points)


def test_every_re_hung_node_was_within_the_ball():
    """Rewired nodes were near, and so was the parent chosen, unless it was the nearest of all."""
    _, log = rrt_star_rewirings(problem_of(), max_nodes=300, rng=4)
    near = set(map(tuple, find_near_pairs(log, np.arange(len(log.nodes))).tolist()))
    for node, parent, came in zip(
        log.node.tolist(), log.parent.tolist(), log.created_at.tolist(), strict=True
    ):
        if node != came:
            assert (came, node) in near and parent == came
        elif node != log.at_goal and (node, parent) not in near:
            apart = np.hypot(*(log.nodes[:node] - log.nodes[node]).T)
            assert apart[parent] == apart.min()


# ---- races


def test_a_race_is_dragged_in_one_and_moves_in_all():
    """Every page gets the new places, and every planner's plan there, on one clock."""
    made = race_board(problem_of(), nodes=150)
    pages = [Page(canvas) for canvas in made.canvases]
    pages[1].moves(("handle", 1, [9, 9]))
    for canvas, page in zip(made.canvases, pages, strict=True):
        assert canvas.shown["handles"][1]["at"] == [9, 9]
        assert page.sent[-1][0]["total"] == made.canvases[0].drawing.total
    assert ["handle", 1, [9.0, 9.0]] in pages[0].sent[-1][0]["places"]
    assert all(plan.path[-1].tolist() == [9, 9] for plan in made.plans if plan.path is not None)
    assert {canvas.partner for canvas in made.canvases[1:]} == {made.canvas.key}
    pages[1].says(LET_GO)
    assert all(canvas.scene == made.canvas.shown for canvas in made.canvases)
    pages[0].moves(("handle", 1, [8, 9]))
    pages[2].moves(("handle", 0, [2, 1]))
    pages[0].says(LET_GO)  # the lane that is let go keeps what was moved in another
    ends = [[item["at"] for item in canvas.scene["handles"]] for canvas in made.canvases]
    assert ends == [[[2, 1], [8, 9]]] * len(pages)
    for page in pages:
        page.sent.clear()
    pages[2].moves(("handle", 0, [5, 5]))
    assert made.plans == [] and all("not free" in page.sent[-1][0]["warning"] for page in pages)


def test_an_interrupted_race_leaves_all_lanes_as_they_were(monkeypatch):
    """The lane that was not reached yet would show another scene."""
    made = race_board(problem_of(), nodes=150)
    page, plans, started = Page(made.canvas), made.plans, []

    def run_first_only(planner, problem, given):
        started.append(planner)
        if len(started) > 1:
            raise KeyboardInterrupt
        return run_planner(planner, problem, given)

    monkeypatch.setattr(race, "run_planner", run_first_only)
    with pytest.raises(KeyboardInterrupt):
        page.moves(("handle", 1, [9, 9]))
    monkeypatch.undo()
    assert [*map(id, made.plans)] == [*map(id, plans)]
    page.moves(("handle", 1, [9, 9]))
    assert all(canvas.shown["handles"][1]["at"] == [9, 9] for canvas in made.canvases)
    assert [plan.problem.goal.tolist() for plan in made.plans] == [[9, 9]] * len(plans)


def test_each_racer_stays_as_it_ended():
    """RRT's path appears with its last node, long before RRT* has all nodes; the text says so."""
    made = race_board(problem_of(), nodes=400)
    rrt, star = made.canvases[0].drawing, made.canvases[2].drawing
    nodes = len(made.plans[0].tree.nodes)
    (way,) = (layer for layer in rrt.layers if layer.kind == "path")
    assert nodes < star.total == rrt.total and not way.last and (way.when == nodes).all()
    assert (
        "no path yet" in rrt.step_texts[nodes - 1]
        and f"{made.plans[0].cost:.4g}" in rrt.step_texts[nodes]
    )
    assert rrt.text == rrt.step_texts[nodes]
    assert f"{made.plans[2].cost:.4g}" in star.text


def test_a_readers_own_planner_races_too():
    """It is recorded and judged; an exception is reported, and the others run on."""

    def straight(problem):
        return (
            [problem.start, problem.goal]
            if problem.is_free_path(problem.start, problem.goal)
            else None
        )

    def breaks(problem):
        raise ValueError("never")

    made = race_board(problem_of(goal=(1, 9)), [straight, breaks, ke.rrt], nodes=100)
    first, second, third = (canvas.drawing.text for canvas in made.canvases)
    assert (
        first.startswith("straight: length 8")
        and "ValueError: never" in second
        and third.startswith("RRT")
    )
    for wrong in ([], [1], [ke.rrt] * 5, ke.rrt):
        with pytest.raises(InvalidParameter, match="race"):
            race_board(problem_of(), wrong)


@pytest.mark.parametrize(
    ("planner", "text"),
    [
        (ke.plan_by_visibility, "visibility: a path of length"),
        (ke.plan_by_decomposition, "decomposition: a path of length"),
        (ke.plan_on_grid, "A*: nodes"),
        (ke.prm, "PRM: a path of length"),
        (partial(ke.rrt, step_size=1.0), "RRT: nodes"),
    ],
)
def test_every_planner_can_race(planner, text):
    """Also one that draws no random numbers, one with settings, and one without a tree."""
    made = race_board(problem_of(), [planner, ke.rrt], nodes=100)
    first, second = (canvas.drawing for canvas in made.canvases)
    plan = made.plans[0]
    assert first.text.startswith(text) and second.text.startswith("RRT: ")
    assert len(first.step_texts) == first.total
    if plan.roadmap is not None:
        edges = len(plan.roadmap.edges)
        assert first.text.endswith(f"{edges:,} edges")
        assert first.step_texts[0].endswith(f"0 of {edges:,} edges")
    assert made.canvases[0].lane not in ("?", "partial")


def test_a_control_of_the_race_runs_all_anew():
    """Another seed gives other trees on all canvases."""
    made = race_board(problem_of(), nodes=100)
    before = [canvas.drawing.text for canvas in made.canvases]
    made.seed.value = 7
    assert [canvas.drawing.text for canvas in made.canvases] != before
    assert (
        made.plans[0].cost
        == ke.rrt(problem_of(), step_size=made.step_size.value, max_nodes=100, rng=7).cost
    )


# ---- exploring


def test_an_exploration_is_shown_as_it_was_known():
    """At a look's first step only walls seen so far are red; each step has one robot and region."""
    made = exploring_board(problem_of(), 3.0)
    assert made.plan.path is not None and "at the goal" in repr(made)
    (red,) = layers_of(made.canvas, "edges", "hit")
    (region,) = layers_of(made.canvas, "bodies", "roadmap")
    (robot,) = layers_of(made.canvas, "dots", "robot")
    for k, look in enumerate(made.looks):
        assert len(shown(red, 8 * k)) == len(look.walls)
        assert shown(robot, 8 * k)[0] == pytest.approx(look.scan.origin)
        assert len(shown(region, 8 * k + 3)) == 1
    assert shown(robot, made.canvas.drawing.total)[0].tolist() == [9, 1]


def test_a_sensor_can_be_given_twice_its_reach_and_half_of_it():
    """Lesson 9 asks for both, with the hall and the reach of its board."""
    walls = [[(4, 0), (5, 0), (5, 7), (4, 7)], [(8, 4), (9, 4), (9, 12), (8, 12)]]
    hall = ke.PolygonWorld([(0, 0), (20, 0), (20, 12), (0, 12)], walls)
    made = exploring_board(ke.Problem(ke.Point(), hall, start=(1.5, 2), goal=(18, 9)), 6.0)
    for reach in (12.0, 3.0):
        made.reach.value = reach
        assert made.reach.value == pytest.approx(reach)


def test_a_browsers_rounding_moves_no_slider():
    """Of a board that would answer otherwise: a page sends back what it has rounded to a notch."""
    made = exploring_board(problem_of(), 6.0)
    asked, answer = [], made.canvas._answer
    made.canvas._answer = lambda scene: asked.append(scene) or answer(scene)
    made.horizon.set_state({"value": 10 * 0.3 - 1e-15})
    assert made.horizon.value == 3.0 and not asked
    made.horizon.set_state({"value": 3.3})
    assert made.horizon.value == 3.3 and len(asked) == 1


def test_looks_add_up_to_the_plan():
    """The generator's looks match the planner's counts; a robot at its goal does not look."""
    problem = problem_of()
    plan, looks = ke.receding_horizon(problem, rng=3), list(receding_horizon_looks(problem, rng=3))
    same = plan_from_looks(problem, looks)
    assert np.array_equal(plan.path, same.path) and plan.stats == same.stats
    assert all(
        len(a.walls) <= len(b.walls) and (b.walls[: len(a.walls)] == a.walls).all()
        for a, b in zip(looks, looks[1:], strict=False)
    )
    assert "at the goal after 0 looks" in repr(exploring_board(problem_of(goal=(1, 1))))
    assert "shows no way" in repr(exploring_board(problem_of(CLOSED), 9.0))


def test_a_world_of_triangles_is_the_polygon_world_of_them():
    """Array for array, except for the precomputed index."""
    rng = np.random.default_rng(0)
    corners = 9.0 * rng.random((30, 1, 2)) + 0.5 * rng.random((30, 3, 2))
    area = np.cross(
        np.append(corners[:, 1] - corners[:, 0], np.zeros((30, 1)), 1),
        np.append(corners[:, 2] - corners[:, 0], np.zeros((30, 1)), 1),
    )[:, 2]
    corners[area < 0] = corners[area < 0, ::-1]
    checked = ke.PolygonWorld(SQUARE, list(corners))
    made = world_of_triangles(np.zeros(2), np.full(2, 10.0), corners)._replace(
        occupancy=checked.occupancy
    )
    assert all(np.array_equal(a, b) for a, b in zip(flat(made), flat(checked), strict=True))


def flat(record):
    """The arrays and numbers of a record of records."""
    return [
        value for item in record for value in (flat(item) if isinstance(item, tuple) else [item])
    ]


def test_cells_may_have_any_number_of_corners():
    """Their rows are sent complete."""
    about, (buffer,) = encode_drawing(Drawing([cells(np.ones((1, 5, 2)), "cell")]), (0, 0), 2.0)
    assert (
        about["layers"][0]["points"] == 5
        and np.frombuffer(buffer, np.float32).tolist() == [0.5] * 10
    )


def test_a_planner_that_could_not_be_stopped_is_not_started_again(monkeypatch):
    """Not after a scene that has no plan either; the others run on."""
    runs = []

    def hang(problem):
        return None

    def run(planner, problem, given):
        runs.append(planner.__name__)
        if planner is not hang:
            return run_planner(planner, problem, given)
        return race.Runner(race.Attempt([], 0, fault="stopped", still_running=True), Drawing())

    monkeypatch.setattr(race, "run_planner", run)
    made = race_board(problem_of(), [hang, ke.rrt], nodes=50)
    start = made.canvas.scene["handles"][0]["at"]
    outside = [made.canvas.scene["hi"][0], start[1]]
    for seq, at in enumerate((outside, [start[0] + 0.01, start[1]])):
        Page(made.canvas).moves(("handle", 0, at), seq=seq)
        assert len(made.plans) == (2 if seq else 0)
    assert runs == ["hang", "rrt", "rrt"]

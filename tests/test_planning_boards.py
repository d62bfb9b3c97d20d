"""The boards of bugs, of the sweep line and of searches, without a browser."""

import io
import re

import numpy as np
import pytest
from PIL import Image
from test_board import Page

import kinoedu as ke
from kinoedu.boards import bug_board, moving_board, samples_board, search_board, sweep_board
from kinoedu.boards.bugs.bugs import BUGS
from kinoedu.boards.core.drawing import Drawing, cells, dots, encode_drawing, labels
from kinoedu.boards.core.scene import move_parts
from kinoedu.boards.search import ground
from kinoedu.boards.search.search import heuristic_to
from kinoedu.decomposition import sweep, trapezoidation
from kinoedu.errors import InvalidGraph, InvalidParameter, InvalidPolygon, InvalidWorld
from kinoedu.geometry import point_polygon_distance
from kinoedu.graphs import Graph, bfs_path, dijkstra
from kinoedu.worlds import PolygonWorld

BOX = [(1, -1), (2, -1), (2, 2), (1, 2)]
SPIRAL = [(1, -3), (9, -3), (9, 3), (3, 3), (3, 2), (8, 2), (8, -2), (2, -2), (2, 3.5), (1, 3.5)]
SQUARE = [(0, 0), (9, 0), (9, 6), (0, 6)]
ROOMS = PolygonWorld(
    SQUARE,
    [
        [(3, 3), (6, 2), (5, 4)],
        ([(6.5, 1), (8.5, 1), (8.5, 5), (6.5, 5)], [[(7, 2), (8, 2), (8, 4), (7, 4)]]),
    ],
)
DIAMOND = Graph(
    nodes=[(0, 0), (1, 1), (1, -1), (2, 0), (3, 0)], edges=[(0, 1), (0, 2), (1, 3), (2, 3), (3, 4)]
)


def shown(layer, step):
    """The rows of a layer that a board shows at a step, as board.js does."""
    here = np.ones(len(layer.rows), bool) if layer.when is None else layer.when <= step
    return layer.rows[here if layer.until is None else here & (layer.until > step)]


def layers_of(canvas, kind, colour):
    return [
        layer for layer in canvas.drawing.layers if (layer.kind, layer.colour) == (kind, colour)
    ]


# ---- layers whose rows come and go


def test_rows_that_go_carry_two_steps():
    """A buffer's rows end with two steps; the text of each step is sent with the drawing."""
    spot = dots([(1, 1), (2, 2)], "robot", when=[0, 1], until=[1, np.inf])
    drawing = Drawing(
        [spot, labels([(1, 1)], ["H1"], "ink", when=[1]), cells(np.ones((1, 4, 2)), "cell")],
        total=1,
        step_texts=["before"],
    )
    about, (comes, _, _) = encode_drawing(drawing, (0, 0), 2.0)
    assert np.frombuffer(comes, np.float32).reshape(2, 4).tolist() == [
        [0.5, 0.5, 0, 1],
        [1, 1, 1, np.inf],
    ]
    assert [layer["ends"] for layer in about["layers"]] == [True, False, False]
    assert about["step_texts"] == ["before"]


def test_growing_layers_come_in_order():
    """The page stops at the first later row: steps never decrease; each but the last has text."""
    boards = [bug_board((0, 0), (4, 0), [BOX], bug=bug) for bug in (*BUGS, "all")]
    boards += [
        search_board(graph, search=search)
        for graph in (DIAMOND, np.ones((3, 4), bool))
        for search in ("bfs", "dfs", "astar")
    ]
    for made in boards:
        for canvas in (made.canvas, getattr(made, "plot", made.canvas)):
            for layer in canvas.drawing.layers:
                assert layer.when is None or (np.diff(layer.when) >= 0).all()
                assert layer.until is None or (layer.until > layer.when).all()
                assert layer.when is None or len(layer.when) == len(layer.rows)
        assert len(made.canvas.drawing.step_texts) == made.canvas.drawing.total + 1


# ---- bugs


@pytest.mark.parametrize("turn", ["left", "right"])
@pytest.mark.parametrize("bug", BUGS)
def test_a_bug_board_shows_the_bugs_own_walk(bug, turn):
    """Text, hits and length are the planner's; the drawn parts make up the whole walk."""
    made = bug_board((0, 0), (4, 0), [BOX], bug=bug, turn=turn)
    plan = BUGS[bug][1]((0, 0), (4, 0), [BOX], 0.01, turn=turn)
    walk = made.plans[0][1]
    assert walk.travelled[-1] == pytest.approx(plan.walk.travelled[-1])
    assert f"after {plan.walk.travelled[-1]:.4g}; hits {len(plan.walk.hit)}" in repr(made)
    drawn = [
        layer for colour in ("tree", "path") for layer in layers_of(made.canvas, "edges", colour)
    ]
    legs = np.concatenate([layer.rows for layer in drawn])
    assert np.hypot(legs[:, 2] - legs[:, 0], legs[:, 3] - legs[:, 1]).sum() == pytest.approx(
        walk.travelled[-1]
    )


def test_a_dragged_scene_is_walked_anew_in_both_pictures():
    """A box beside the line is not hit; world and plot have the new walk and equal steps."""
    made = bug_board((0, 0), (4, 0), [BOX])
    world, plot = Page(made.canvas), Page(made.plot)
    away = [(x, y + 5) for x, y in BOX]
    assert world.moves(("polygon", 0, [away]))["text"] == "Bug 1: reached after 4; hits 0"
    assert (
        plot.sent[-1][0]["total"] == made.canvas.drawing.total
        and made.plot.partner == made.canvas.key
    )
    assert "lies in or on an obstacle" in world.moves(("handle", 0, [1.5, 6]))["warning"]
    assert made.plans == [] and made.plot.drawing.layers  # the last good walk stays
    assert "crosses" in world.moves(("polygon", 0, [[BOX[0], BOX[2], BOX[1], BOX[3]]]))["warning"]


def test_the_sensor_feels_the_wall_that_is_followed():
    """In the open it touches nothing, on a wall an edge, at a corner both; one robot per step."""
    made = bug_board((0, 0), (4, 0), [BOX])
    walk, canvas = made.plans[0][1], made.canvas
    (touched,) = layers_of(canvas, "edges", "contact")
    (robot,) = layers_of(canvas, "dots", "robot")
    for step in range(canvas.drawing.total + 1):
        (place,) = shown(robot, step)
        edges = shown(touched, step)
        on_box = point_polygon_distance(place, BOX) < 1e-9
        assert (len(edges) > 0) == on_box and len(edges) <= 2
    assert shown(robot, canvas.drawing.total).tolist() == [walk.points[-1].tolist()]


def test_hits_and_leaves_are_named_once_for_all_that_they_are():
    """A walk in a circle is reported, and its hit carries both names."""
    made = bug_board((-2, 0), (6, 0), [SPIRAL], bug="bug0")
    assert "not reached" in repr(made) and "circle" in repr(made)
    (names,) = (layer for layer in layers_of(made.canvas, "labels", "contact"))
    assert "H2, H3" in names.texts and "H1" in names.texts


def test_all_bugs_race_side_by_side():
    """Every length, and which bugs failed; at each step all have walked the same distance."""
    made = bug_board((0, 0), (4, 0), [BOX], bug="all")
    assert repr(made) == (
        "BugBoard(reached after: Bug 0 6.828, Bug 1 14, Bug 2.prelim 8, Bug 2 8\nnot reached: "
        "BugBase)"
    )
    assert made.canvas.drawing.total == made.plot.drawing.total
    made.bug.value = "bug2"
    assert repr(made) == "BugBoard(Bug 2: reached after 8; hits 1)"
    made.turn.value = "right"
    assert "Bug 2: reached after 6; hits 1" in repr(made)


def test_what_is_no_bug_scene_is_refused():
    """Errors are raised before anything is shown."""
    with pytest.raises(InvalidPolygon):
        bug_board((0, 0), (4, 0), [[(0, 0), (1, 1)]])
    with pytest.raises(InvalidParameter, match="bug"):
        bug_board((0, 0), (4, 0), [BOX], bug="bug3")
    with pytest.raises(InvalidParameter, match="turn"):
        bug_board((0, 0), (4, 0), [BOX], turn="up")
    assert "lies in or on" in repr(bug_board((1.5, 0), (4, 0), [BOX]))
    assert repr(bug_board((0, 0), (0, 0), [])) == "BugBoard(Bug 1: reached after 0; hits 0)"


# ---- the sweep line


@pytest.mark.parametrize("x", np.linspace(-0.3, 9.3, 33))
def test_a_sweep_board_shows_the_cells_closed_and_open(x):
    """Their area is that of the free space left of the line; the status is in order."""
    made = sweep_board(ROOMS, x=x)
    cut = trapezoidation(ROOMS)
    closed = sum(len(step.closed) for step in made.steps)
    assert closed == (cut.trapezoids[:, 1] <= x).sum()
    if not made.steps:
        assert "has met no vertex yet" in repr(made)
        return
    dashed = [one.rows for one in made.canvas.drawing.layers if one.dash]
    begun = np.reshape(dashed, (-1, 4, 4))[:, :, :2]
    assert len(begun) == len(made.steps[-1].status) // 2
    for (x0, low0), (x1, low1), (x2, high1), (x3, high0) in begun:
        assert x0 == x3 and x1 == x2 == x and low0 <= high0 and low1 <= high1
        (whole,) = (
            row
            for row in cut.trapezoids
            if row[0] == x0 and np.allclose(row[2:4], [low0, high0]) and row[1] >= x
        )
        share = (x - x0) / (whole[1] - x0)
        assert [low1, high1] == pytest.approx(
            [whole[k] + share * (whole[k + 2] - whole[k]) for k in (2, 3)]
        )
    heights = [one.rows[:, 1] for one in made.canvas.drawing.layers if one.width == 3.0]
    assert (np.diff(heights) >= -1e-12).all()


def test_edges_and_cells_of_a_sweep_do_not_have_the_same_names():
    """Cells are numbered; the names of edges begin with e, and the text lists the same edges."""
    made = sweep_board(ROOMS, x=5.0)
    named = [one for one in made.canvas.drawing.layers if one.kind == "labels"]
    cells, edges = (
        [text for one in named if (one.colour == "tree") == is_cell for text in one.texts]
        for is_cell in (True, False)
    )
    assert cells == [str(1 + k) for k in range(len(cells))] and len(cells) > 0
    listed = re.findall(r"edge (\d+)", made.canvas.drawing.text)
    assert sorted(edges) == sorted(f"e{number}" for number in listed)


def test_the_sweep_line_is_dragged_by_hand():
    """Text, list and numbers follow the line; obstacles can be dragged; bad ones are reported."""
    made = sweep_board(PolygonWorld(SQUARE, [[(3, 3), (6, 2), (5, 4)]]), x=4)
    page = Page(made.canvas)
    assert repr(made) == (
        "SweepBoard(at x = 3: an obstacle begins; cells closed 1, open 2\nstatus: edge 0, edge 2, "
        "edge 3, edge 1)"
    )
    assert made.status.value.index("edge 3, a floor") < made.status.value.index("edge 2, a ceiling")
    assert page.moves(("handle", 0, [7, -1]))["text"].startswith(
        "at x = 6: an obstacle ends; cells closed 4, open 1"
    )
    assert (
        page.moves(("handle", 0, [9.5, -1]))["text"]
        == "at x = 9: 2 vertices; all 5 cells are closed\nstatus: empty"
    )
    assert "empty" in made.status.value
    assert page.moves(("polygon", 0, [[[3, 3], [4, 3], [6, 3]]]))["warning"] and made.steps == []
    assert (
        "cells closed"
        in page.moves(("polygon", 0, [[[3, 3], [6, 2], [5, 4]]]), ("handle", 0, [5, 0]))["text"]
    )


def test_a_world_that_cannot_be_cut_is_refused():
    """Discs and terrains; overlapping obstacles are united."""
    with pytest.raises(InvalidWorld, match="round"):
        sweep_board(PolygonWorld(SQUARE, [((3, 3), 1)]))
    with pytest.raises(InvalidWorld):
        sweep_board(ke.Terrain(np.ones((3, 3), bool)))
    both = PolygonWorld(
        SQUARE, [[(2, 2), (5, 2), (5, 4), (2, 4)], [(4, 3), (7, 3), (7, 5), (4, 5)]]
    )
    assert "cells closed 2, open 2" in repr(sweep_board(both, x=4.5)) and list(sweep(both))


# ---- searches


@pytest.mark.parametrize("search", ["bfs", "dfs", "dijkstra", "astar"])
def test_a_search_board_shows_the_searchs_own_steps(search):
    """Each step shows one expansion with its frontier and parents; the path comes last."""
    made = search_board(DIAMOND, search=search)
    canvas, places = made.canvas, DIAMOND.nodes
    (waiting,), (arrows,) = (
        layers_of(canvas, "dots", "frontier"),
        layers_of(canvas, "arrows", "tree"),
    )
    for step, moment in enumerate(made.moments, start=1):
        assert sorted(shown(waiting, step).tolist()) == sorted(places[moment.frontier].tolist())
        children = np.flatnonzero(moment.parent >= 0)
        assert sorted(shown(arrows, step)[:, :2].tolist()) == sorted(
            places[moment.parent[children]].tolist()
        )
    assert shown(waiting, 0).tolist() == [[0, 0]] and canvas.drawing.total == len(made.moments)
    assert canvas.drawing.layers[-2].kind == "path" and "path cost 3.828, edges 3" in repr(made)


def test_start_and_goal_mean_the_nearest_nodes():
    """Dragged anywhere they are joined to their nodes; a missing path is reported."""
    apart = Graph(nodes=[(0, 0), (1, 0), (2, 0), (5, 5)], edges=[(0, 1), (1, 2)])
    made = search_board(apart, goal=2)
    page = Page(made.canvas)
    assert page.moves(("handle", 0, [0.8, 0.3]))["text"] == (
        "from node 1 to node 2: expanded 3 of 4; frontier 0; path cost 1, edges 1"
    )
    assert page.moves(("handle", 1, [4, 5]))["text"] == (
        "from node 1 to node 3: expanded 3 of 4; frontier 0; no path leads to the goal"
    )
    assert page.moves(("handle", 1, [1, 0]))["text"].endswith("path cost 0, edges 0")
    (link,) = layers_of(made.canvas, "edges", "start")
    assert link.rows.tolist() == [[0.8, 0.3, 1, 0]]


def test_a_dragged_node_takes_its_edges_along():
    """Weights that are lengths follow, others stay; the given graph is not changed."""
    graph = Graph(
        nodes=[(0, 0), (1, 1), (1, -1), (2, 0)],
        edges=[(0, 1), (0, 2), (1, 3), (2, 3)],
        weights=[5, *[2**0.5] * 3],
    )
    made = search_board(graph, search="dijkstra")
    page = Page(made.canvas)
    assert [item["name"] for item in made.canvas.scene["handles"][2:]] == [
        "node 0",
        "node 1",
        "node 2",
        "node 3",
    ]
    assert "path cost 2.828, edges 2" in repr(made)
    reply = page.moves(("handle", 2 + 2, [1, -3]))
    anew = Graph(
        nodes=[(0, 0), (1, 1), (1, -3), (2, 0)],
        edges=graph.edges,
        weights=[5, 10**0.5, 2**0.5, 10**0.5],
    )
    cost = dijkstra(anew, 0).cost[3]
    assert reply["text"].endswith(f"path cost {cost:.4g}, edges 2") and cost == pytest.approx(
        2 * 10**0.5
    )
    assert (
        "path cost 6.414, edges 2" in page.moves(("handle", 2 + 2, [1, -9]))["text"]
    )  # by the edge whose weight is its own
    assert graph.nodes[2].tolist() == [1, -1] and graph.weights[1] == 2**0.5


def test_only_nodes_that_can_be_told_apart_are_dragged():
    """In grids, roadmaps and large graphs only start and goal move; deleted nodes are no stops."""
    many = Graph(nodes=np.random.default_rng(1).random((41, 2)), edges=[(0, 1)])
    for given in (np.ones((3, 3), bool), ke.Problem(ke.Point(), ROOMS, (1, 1), (8.8, 5.5)), many):
        assert [item["name"] for item in search_board(given).canvas.scene["handles"]] == [
            "start",
            "goal",
        ]
    graph = Graph(nodes=[(0, 0), (1, 0), (2, 0), (3, 0)], edges=[(0, 1), (1, 2), (2, 3)])
    graph.delete_node(1)
    made = search_board(graph, start=2)
    assert [item["name"] for item in made.canvas.scene["handles"][2:]] == [
        "node 0",
        "node 2",
        "node 3",
    ]
    assert Page(made.canvas).moves(("handle", 4, [3, 4]), ("handle", 1, [3, 4]))["text"] == (
        "from node 2 to node 3: expanded 2 of 3; frontier 0; path cost 4.123, edges 1"
    )


def test_a_grid_and_problems_become_graphs():
    """Cells of a grid and of a terrain, and a roadmap among polygons that cannot be dragged."""
    free = np.ones((4, 6), bool)
    free[:3, 3] = False
    made = search_board(free, search="astar")
    graph = made.ground.graph
    assert (
        len(graph) == 21
        and graph.nodes[0].tolist() == [0.5, 0.5]
        and len(bfs_path(graph, 0, 20)) == 9
    )
    assert "path cost 8, edges 8" in repr(made) and made.canvas.scene["size"] == [4, 6]
    terrain = ke.Problem(
        ke.Point(), ke.Terrain(free, resolution=2.0, origin=(10, 10)), (11, 11), (21, 17)
    )
    assert "path cost 16, edges 8" in repr(search_board(terrain, search="dijkstra"))
    yard = ke.Problem(ke.Point(), ROOMS, (1, 1), (8.8, 5.5))
    made = search_board(yard)
    assert "path cost" in repr(made) and not any(
        item["movable"] for item in made.canvas.scene["polygons"]
    )
    assert Page(made.canvas).moves(("handle", 0, [2, 5]))["warning"] == ""


def test_the_estimate_never_exceeds_the_cost():
    """Where edges cost less than their length the distance is scaled, so that A* stays optimal."""
    rng = np.random.default_rng(5)
    for _ in range(20):
        nodes = rng.random((12, 2))
        edges = [(u, v) for u in range(12) for v in range(u) if rng.random() < 0.4]
        graph = Graph(nodes=nodes, edges=edges, weights=rng.random(len(edges)))
        cost = dijkstra(graph, 3).cost
        assert (heuristic_to(graph, 3) <= cost + 1e-12).all()


def test_what_cannot_be_searched_is_refused():
    """With a message: no positions, no cells, too many nodes, an unknown node."""
    for nothing in (Graph(3, [(0, 1)]), Graph(nodes=[(0, 0, 0)])):
        with pytest.raises(InvalidGraph, match="needs a Graph with places"):
            search_board(nothing)
    for nothing in ("graph", np.ones((2, 2)), np.zeros((2, 2), bool), 5):
        with pytest.raises(InvalidParameter, match="needs a Graph with places"):
            search_board(nothing)
    with pytest.raises(InvalidParameter, match="at most 900 nodes"):
        search_board(np.ones((40, 40), bool))
    with pytest.raises(InvalidGraph, match="start and goal must be nodes"):
        search_board(DIAMOND, goal=9)
    with pytest.raises(InvalidParameter, match="search"):
        search_board(DIAMOND, search="best")


def test_deleted_nodes_are_left_out():
    """They are not counted, drawn or picked."""
    graph = Graph(nodes=[(0, 0), (1, 0), (2, 0), (3, 0)], edges=[(0, 1), (1, 2), (2, 3)])
    graph.delete_node(3)
    made = search_board(graph)
    assert (
        repr(made)
        == "SearchBoard(from node 0 to node 2: expanded 3 of 3; frontier 0; path cost 2, edges 2)"
    )
    assert made.canvas.drawing.layers[-1].texts == ("0", "1", "2")


def random_graph(seed):
    """A graph: directed or not, parallel edges, own weights or lengths, a deleted node."""
    rng = np.random.default_rng(seed)
    n = int(rng.integers(2, 14))
    pairs = rng.integers(0, n, (int(rng.integers(1, 3 * n)), 2))
    weights = rng.random(len(pairs)) if seed % 3 == 0 else None
    graph = Graph(
        nodes=rng.random((n, 2)),
        edges=[(u, v) for u, v in pairs.tolist() if u != v],
        weights=None if weights is None else weights[pairs[:, 0] != pairs[:, 1]],
        directed=seed % 2 == 1,
    )
    if seed % 5 == 0 and n > 3:
        graph.delete_node(int(rng.integers(n)))
    return graph


@pytest.mark.parametrize("search", ["bfs", "dfs", "dijkstra", "astar"])
def test_each_node_is_at_each_step_what_the_expansions_say(search):
    """State, parent, cost and the numbers of the text, for 60 graphs, against the iterators."""
    unseen, frontier, expanded, expanding = range(4)
    for seed in range(60):
        made = search_board(random_graph(seed), search=search)
        drawing, graph = made.canvas.drawing, made.graph
        (notes,) = (layer for layer in drawing.layers if layer.kind == "nodes")
        assert (np.diff(notes.when) >= 0).all() and (notes.until > notes.when).all()
        for step, moment in enumerate(made.moments, start=1):
            now = notes.notes[(notes.when <= step) & (step < notes.until)]
            now = now[np.argsort(now[:, 0])]
            states = np.full(graph.size, unseen)
            states[moment.expanded] = expanded
            states[moment.frontier] = frontier
            states[moment.node] = expanding
            there = list(graph)
            wanted = [there, moment.parent[there], states[there], moment.cost[there]]
            assert now[:, :4].T.tolist() == [np.asarray(row, float).tolist() for row in wanted]
            counts = f"expanded {step} of {len(graph)}; frontier {len(moment.frontier)}; now node"
            assert drawing.step_texts[step] == f"{counts} {moment.node}"
        assert drawing.total == len(made.moments)


# ---- stored notebooks


def test_a_notebook_keeps_a_picture_of_each():
    """The same text always, and a PNG; the bugs' has world and plot."""
    makers = [
        lambda: bug_board((0, 0), (4, 0), [BOX], bug="all"),
        lambda: sweep_board(ROOMS, x=4.2),
        lambda: search_board(np.ones((20, 30), bool), search="astar"),
        lambda: search_board(DIAMOND),
    ]
    for make in makers:
        made = make()
        data, _ = made._repr_mimebundle_()
        assert data["text/plain"] == repr(made) == repr(make()) and len(data["image/png"]) < 80_000
        assert Image.open(io.BytesIO(made.picture())).size[0] > 250


@pytest.mark.parametrize("n", [0, 401, 1.5])
def test_a_samples_board_has_a_bounded_number_of_points(n):
    """It says from what to what, and takes no other number in its place."""
    with pytest.raises(InvalidParameter, match="n must be a whole number from 1 to 400"):
        samples_board("random", n)


@pytest.mark.parametrize(
    ("sampler", "shown_points"), [("corner", 49), ("sukharev", 49), ("random", 60), ("halton", 60)]
)
def test_a_samples_board_shows_points_and_their_largest_hole(sampler, shown_points):
    """As many points as fit a grid, or as wanted; no place is farther from them than the hole."""
    made = samples_board(sampler, 60)
    (points,), (hole,) = (
        layers_of(made.canvas, "dots", "tree"),
        layers_of(made.canvas, "edges", "path"),
    )
    assert len(points.rows) == shown_points
    ball = ke.sampling.largest_empty_ball(points.rows)
    assert np.allclose(np.linalg.norm(hole.rows.reshape(-1, 2) - ball.centre, axis=1), ball.radius)
    text = made.answer(move_parts(made.canvas.scene, [["handle", 0, ball.centre.tolist()]])).text
    assert text.count(f"{ball.radius:.4f}") == 2
    made.n.value = 9
    assert repr(made).startswith("SamplesBoard(points 9;")
    made.sampler.value = "sukharev"
    assert (
        repr(made)
        == "SamplesBoard(points 9; largest hole 0.2357; q is 0.0000 from the nearest point)"
    )
    assert made.picture().startswith(b"\x89PNG")


def test_a_samples_board_refuses_what_it_does_not_have():
    """An unknown sampler, fewer than one point; q outside the square moves to its side."""
    for given in (("sobol", 9), ("halton", 0)):
        with pytest.raises(InvalidParameter):
            samples_board(*given)
    made = samples_board("sukharev", 1)
    assert (
        "q is 0.7071"
        in made.answer(move_parts(made.canvas.scene, [["handle", 0, [9.0, -9.0]]])).text
    )


def test_a_large_grid_is_refused_at_once(monkeypatch):
    """No graph is made of its cells, which would take seconds and gigabytes."""
    monkeypatch.setattr(ground.Graph, "__init__", None)
    cells = np.ones((2000, 2000), bool)
    for given in (cells, ke.Problem(ke.Point(), ke.Terrain(cells), (1, 1), (2, 2))):
        with pytest.raises(InvalidParameter, match="4000000"):
            ground.make_ground(given, None, None)


def test_a_robot_that_is_at_its_goal_does_not_wait():
    """Then its path has one place, and each moment of the board its text."""
    hall = ke.PolygonWorld([(0, 0), (10, 0), (10, 6), (0, 6)])
    world = ke.MovingWorld(hall, [ke.Moving(0.5, [0, 9], [(9, 4), (1, 4)])])
    drawing = moving_board(ke.TimedProblem(ke.Disk(0.5), world, (1, 1), (1, 1))).canvas.drawing
    assert drawing.text == "at the goal at time 0, waited 0" and not drawing.warning
    assert len(drawing.step_texts) == drawing.total

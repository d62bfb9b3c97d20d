"""Lines traced as they run, and the board that shows them beside their picture."""

import importlib
import io
import itertools
import linecache
import sys

import numpy as np
import pytest
from PIL import Image, ImageColor
from test_board import WALL, Page, walled
from test_planning_boards import shown

import kinoedu as ke
from kinoedu.boards import board, code_board
from kinoedu.boards.code.searches import draw_search_state
from kinoedu.boards.core.drawing import dots, encode_drawing
from kinoedu.boards.core.notes import with_notes
from kinoedu.boards.core.scene import move_parts
from kinoedu.boards.planning.board import ON_BOARD
from kinoedu.boards.planning.lit import CODE
from kinoedu.boards.tracing.moments import rows_over_time
from kinoedu.boards.tracing.variables import Variable, format_short, note_variables
from kinoedu.errors import InvalidParameter
from kinoedu.figures import palette
from kinoedu.geometry.segments import closest_on_segment
from kinoedu.support.line_trace import RAISED, RETURNED, LineTrace

SOURCE_OF_COUNT = ["def count(n):", "    total = 0", "    for i in range(n):", "        total += i"]


def count(n):
    """Add up the numbers below n."""
    total = 0
    for i in range(n):
        total += i
    return total


def halve(n):
    if n == 0:
        raise ValueError("nothing to halve")
    try:
        halve(n // 2)
    except ValueError:
        return n
    return 0


def traced(function, *given, most=100):
    """The trace of a call, and what it raised."""
    with LineTrace(function, lambda local, _: dict(local), most=most) as trace:
        try:
            function(*given)
        except ValueError as error:
            return trace, error
    return trace, None


def test_lines_are_traced_in_the_order_in_which_they_run():
    """Each with the variables after it; the last one says how the call ended."""
    trace, _ = traced(count, 2)
    first = SOURCE_OF_COUNT.index("    total = 0") + 1  # the docstring is a line of the source
    assert [moment.line - first for moment in trace.moments] == [0, 1, 2, 1, 2, 1, 3]
    assert [moment.note.get("total") for moment in trace.moments] == [0, 0, 0, 0, 1, 1, 1]
    assert trace.moments[-1].ending == RETURNED and trace.moments[-1].result == 1
    assert [moment.ending for moment in trace.moments[:-1]] == [""] * 6


def test_calls_within_calls_and_errors_are_traced():
    """A call that raises ends so; one that catches the error goes on and returns."""
    trace, error = traced(halve, 1)
    endings = [moment.ending for moment in trace.moments if moment.ending]
    assert error is None and endings == [RAISED, RETURNED]
    trace, error = traced(halve, 0)
    assert isinstance(error, ValueError) and trace.moments[-1].ending == RAISED


def collatz(n):
    steps = 0
    while n != 1:
        if n % 2:
            n = 3 * n + 1
        else:
            n //= 2
        steps += 1
    return steps


def is_number(text):
    try:
        if float(text):
            return True
    except ValueError:
        return False


def test_each_condition_says_whether_it_was_true():
    """By the line that follows; a line without a condition, and one that raises, say nothing."""
    trace, _ = traced(collatz, 3)
    said = [moment.holds for moment in trace.moments]
    assert said[:5] == [None, True, True, None, None] and said[5:7] == [True, False]
    assert said[-2:] == [False, None]
    trace, _ = traced(halve, 1)
    assert [moment.holds for moment in trace.moments] == [False, None, None, True, None, None, None]
    trace, _ = traced(is_number, "three")
    assert [moment.holds for moment in trace.moments] == [None, None, None, None]


def test_only_the_first_lines_are_kept_and_the_result_is_the_same():
    """Later lines run without being traced."""
    before = sys.gettrace()
    trace, _ = traced(count, 1000, most=10)
    assert len(trace.moments) == 10 and trace.is_cut and sys.gettrace() is before
    with LineTrace(count, lambda *_: None, most=10):
        assert count(1000) == 499500


@pytest.mark.parametrize("function", [len, np.add, 5, "count"])
def test_what_has_no_source_is_refused(function):
    with pytest.raises(InvalidParameter, match="written in Python"):
        LineTrace(function, lambda *_: None, most=1)


def test_rows_are_there_from_their_step_to_their_last():
    """A list that grows and shrinks has each of its points once while it stays."""
    lists = [[(0, 0)], [(0, 0), (1, 1)], [(0, 0)], [(2, 2)], []]
    values = [Variable("", np.array(points, float).reshape(-1, 2)) for points in lists]
    rows, when, until = rows_over_time([None, *values])
    assert rows.tolist() == [[0, 0], [1, 1], [2, 2]]
    assert (when, until) == ([2, 3, 5], [5, 4, 6])


def test_points_are_told_from_numbers_of_nodes():
    """Two floats are a point; two integers are not, nor is a number with a node."""
    noted = note_variables(
        {
            "q": (1.0, 2.0),
            "pair": (1.5, 3),
            "parent": [-1, 0],
            "nodes": [np.zeros(2), np.ones(2)],
            "cell": (2, 3),
            "rng": np.random.default_rng(0),
            "f": len,
        }
    )
    drawn = {name for name, one in noted.items() if one.points is not None}
    assert drawn == {"q", "nodes"} and noted["q"].is_point and not noted["nodes"].is_point
    assert "rng" not in noted and "f" not in noted


def nearest_on(q, p1, p2):
    """The nearest point of a segment."""
    way = p2 - p1
    t = np.dot(q - p1, way) / np.dot(way, way)
    t = min(max(t, 0.0), 1.0)
    return p1 + t * way


def test_the_code_stands_beside_the_picture():
    """Its lines without the docstring, the line of each step, and the variables after it."""
    made = code_board(nearest_on, (3.0, 4.0), (0.0, 0.0), (6.0, 0.0), vectors={"way": "p1"})
    message, _ = encode_drawing(made.drawing, (0, 0), 1.0)
    listing = message["listing"]
    assert listing["lines"][0] == "def nearest_on(q, p1, p2):" and "way" in listing["lines"][1]
    assert listing["ran"] == [1, 2, 3, 4] and message["total"] == 4
    assert listing["changes"][1] == {"t": "0.5"} and listing["changes"][2] == {}
    assert made.drawing.text == "nearest_on returns (3, 0)" and listing["legend"] == ""
    kinds = {layer.kind for layer in made.drawing.layers}
    assert kinds == {"arrows", "labels"}


def test_a_dragged_argument_runs_the_function_again():
    """The points that were passed in are handles, in the order of the parameters."""
    made = code_board(nearest_on, (3.0, 4.0), (0.0, 0.0), (6.0, 0.0))
    drawing = Page(made).moves(["handle", 0, [9.0, 1.0]])
    assert drawing["text"] == "nearest_on returns (6, 0)"
    drawing = Page(made).moves(["handle", 2, [0.0, 0.0]], seq=2)  # a segment of length 0
    assert "nearest_on" in drawing["text"] + drawing["warning"]


def test_polygons_lists_of_them_and_other_arguments():
    """Polygons are dragged, what is fixed is not, and lists are copied before each run."""

    def work(polygon, obstacles, log, q):
        log.append(len(obstacles))
        return len(polygon), log

    square = np.array([(0.0, 0), (1, 0), (1, 1), (0, 1)])
    given = square, [square + 2, square[:3] + 4], [], (0.5, 0.5)
    made = code_board(work, *given, fixed=["q"])
    names = [polygon["name"] for polygon in made.scene["polygons"]]
    assert names == ["polygon", "obstacles 0", "obstacles 1"] and not made.scene["handles"]
    made.refresh()
    assert made.drawing.text == "work returns (4, [2])"


@pytest.mark.parametrize(("areas", "colour"), [([], palette.OBSTACLE), (["ring"], palette.SHAPE)])
def test_a_polygon_that_is_no_obstacle_is_pale(areas, colour):
    """In the picture, and for the page that draws it; it stays so where it is dragged."""

    def count_corners(ring):
        return len(ring)

    made = code_board(count_corners, np.array([(0, 0), (9, 0), (9, 9), (0, 9.0)]), areas=areas)
    (ring,) = made.scene["polygons"]
    (moved,) = move_parts(made.scene, [("polygon", 0, ring["rings"])])["polygons"]
    assert palette.NAMED[moved.get("colour", "obstacle")] == colour
    picture = Image.open(io.BytesIO(made.picture())).convert("RGB")
    assert picture.getpixel((picture.width // 4, picture.height // 2)) == ImageColor.getrgb(colour)


def extend(problem, nodes, q_rand, step):
    near = int(np.argmin([problem.distance(q, q_rand) for q in nodes]))
    q_new = problem.steer(nodes[near], q_rand, step)
    if problem.is_free_path(nodes[near], q_new):
        return q_new
    return None


def test_the_motions_that_a_function_asks_about_are_drawn():
    """From the line that asks, thick while it runs; the problem's parts can be dragged too."""
    nodes = [np.array([1.0, 1.0]), np.array([3.0, 3.0])]
    made = code_board(extend, walled(), nodes, (8.0, 3.0), 2.0, points={"q_near": "nodes[near]"})
    assert made.drawing.text == "extend returns None"
    assert "Dashed grey motions were refused" in made.drawing.listing.legend
    thin, thick = (layer for layer in made.drawing.layers if layer.kind == "edges")
    assert (thin.colour, thick.colour) == ("obstacle", "contact")
    asks = 3  # the third line that runs
    assert len(shown(thin, asks - 1)) == 0 and len(shown(thin, asks)) == 1
    assert len(shown(thick, asks)) == 1 and len(shown(thick, asks + 1)) == 0
    drawing = Page(made).moves(["polygon", 0, [np.add(WALL, (0, 4)).tolist()]])
    assert drawing["text"] == "extend returns (5, 3)"


def squares(rows):
    [print(end="") for row in rows]
    found = {
        # a comment keeps the lines apart
        row: [k * k for k in range(row)]
        for row in rows
        if row
    }
    while len(rows) > 1:
        rows = [row - 1 for row in rows][1:]
    return found, {-k for k in rows}


def test_a_comprehension_is_one_moment():
    """In every version of Python, however many items and lines it has, and without its variable."""
    with LineTrace(squares, lambda variables, _: set(variables), most=100) as trace:
        squares([3, 2, 1])
    assert [moment.line for moment in trace.moments] == [1, 2, 8, 9, 8, 9, 8, 10]
    assert {name for moment in trace.moments for name in moment.note} == {"rows", "found"}


def thin_out(rows):
    while any(row > 1 for row in rows):
        rows = tuple(row - 1 for row in rows)
        if all(row < 3 for row in rows if row):
            rows = rows[1:]
    return tuple(
        # a comment keeps the lines apart
        row
        for row in rows
    )


def test_a_question_about_all_items_is_one_moment():
    """In every version of Python, and the condition says whether it was true."""
    trace, _ = traced(thin_out, (4, 3, 2))
    said = [(moment.line, moment.holds) for moment in trace.moments][:9]
    assert said == [
        *[(1, True), (2, None), (3, False)],
        *[(1, True), (2, None), (3, True), (4, None)],
        *[(1, False), (5, None)],
    ]
    assert {moment.line for moment in trace.moments[8:]} <= {5, 7, 8} and len(trace.moments) < 13


def halves(n):
    total = 0.0
    for i in range(n):
        half = i / 2
        while half > 1:
            rest = half - 1
            half = rest
        total += half
    return total


def test_values_of_an_earlier_round_are_told_from_new_ones():
    """From the head of a loop until a line assigns them; none after it, nor what outlasts it."""
    made = code_board(halves, 5, window=((0, 0), (1, 1)))
    old = made.drawing.listing.old
    ran = [made.drawing.listing.lines[line].strip() for line in made.drawing.listing.ran]
    rounds = [step for step, line in enumerate(ran) if line == "for i in range(n):"]
    assert [set(old[step]) for step in rounds] == [
        set(),
        *[{"half"}] * 3,
        {"half", "rest"},
        set(),
    ]
    assert old[ran.index("half = i / 2", rounds[1])] == set()
    assert not any({"total", "i", "n"} & set(names) for names in old)
    message, _ = encode_drawing(made.drawing, (0, 0), 1.0)
    told = message["listing"]["old"]
    assert told[0] == [] and told[1] is None and ["half"] in told


def paired(names):
    pairs = []
    for name, number in zip(
        names,
        range(len(names)),
    ):
        pair = name, number
        pairs.append(pair)
    while (
        pairs  # a condition may have several lines, too
        and len(pairs) > 1
    ):
        last = pairs.pop()
        first = last[0]
    return first


def test_the_head_of_a_loop_may_have_several_lines():
    """A round begins after the last of them, in a `for` and in a `while`."""
    made = code_board(paired, ["a", "b", "c"], window=((0, 0), (1, 1)))
    old = made.drawing.listing.old
    ran = [made.drawing.listing.lines[line].strip() for line in made.drawing.listing.ran]
    then = list(zip(ran, ran[1:], strict=False))
    entered = [k for k, pair in enumerate(then) if pair[1] == "pair = name, number"]
    assert [set(old[k]) for k in entered] == [set(), {"pair"}, {"pair"}]
    entered = [k for k, pair in enumerate(then) if pair[1] == "last = pairs.pop()"]
    assert [set(old[k]) for k in entered] == [set(), {"last", "first"}]


def walk(q, n):
    for _ in range(n):
        step = q / 4
        q = q + step
    return q


def test_points_of_an_earlier_round_are_not_drawn():
    """Nor those of an expression that has one of its variables."""
    made = code_board(walk, (4.0, 0.0), 2, points={"beside": "q + 2 * step"})
    ran = [made.drawing.listing.lines[line].strip() for line in made.drawing.listing.ran]
    head = ran.index("for _ in range(n):", 2) + 1  # the step of its second round
    assert made.drawing.listing.old[head - 1] == {"step", "beside"}
    names = {layer.texts[0]: layer for layer in made.drawing.layers if layer.kind == "labels"}
    for name in ("step", "beside"):
        there = [len(shown(names[name], step)) for step in (head - 1, head, head + 1)]
        assert there == [1, 0, 1]


def test_a_function_that_fails_stops_at_its_line():
    """The error is told with its line; the steps end with it."""
    made = code_board(lambda q: 1 / 0, (0.0, 0.0))
    assert "ZeroDivisionError" in made.drawing.warning and "your planner" not in repr(made)

    def fails(q):
        x = q[0]
        return [][int(x)]

    made = code_board(fails, (0.0, 0.0))
    assert made.drawing.total == 2 and "IndexError" in made.drawing.warning
    assert "in line 3 of fails: return [][int(x)]" in made.drawing.warning


def test_a_function_that_never_ends_is_stopped(monkeypatch):
    monkeypatch.setattr("kinoedu.boards.code.code_board.SECONDS", 0.2)

    def endless(q):
        while True:
            q = q + 1.0

    made = code_board(endless, (0.0, 0.0), most=50)
    assert made.drawing.total == 50 and made.drawing.warning.startswith("no answer after")


def test_what_is_drawn_belongs_to_its_line_where_a_function_calls_itself():
    """A line that calls its own function ends after the lines of that call."""

    def halve(problem, q):
        if q[0] < 4.0:
            return problem.is_free_path(problem.start, q)
        half = q / 2.0
        return halve(problem, half)

    made = code_board(halve, walled(), (6.0, 9.0), circles={"q": "q[0]"})
    lines = [made.drawing.listing.lines[k].strip() for k in made.drawing.listing.ran]
    asks = lines.index("return problem.is_free_path(problem.start, q)") + 1
    motions = [layer for layer in made.drawing.layers if layer.kind == "edges"]
    asked = min(motions, key=lambda layer: len(layer.rows))
    assert len(shown(asked, asks - 1)) == 0 and len(shown(asked, asks)) == 1
    circle = max(motions, key=lambda layer: len(layer.rows))
    sizes = [np.ptp(shown(circle, step)[:, 0]) for step in (1, asks)]
    assert sizes == pytest.approx([12.0, 6.0], rel=1e-3)


def test_own_layers_are_shown_at_their_moment():
    """`draw` gets the variables after each line; its layers stay for that step."""

    def steps(a, b):
        middle = (a + b) / 2
        for end in (a,):
            middle = (end + middle) / 2
        return middle

    def draw(variables):
        return [dots([variables["middle"]], "hit", radius=9.0)] if "middle" in variables else []

    made = code_board(steps, (0.0, 0.0), (4.0, 0.0), draw=draw)
    (own,) = [layer for layer in made.drawing.layers if layer.width == 9.0]
    assert [shown(own, step).tolist() for step in (0, 2, 3)] == [[], [[2.0, 0.0]], [[1.0, 0.0]]]


def halfway(a, b):
    """The point in the middle."""
    return (a + b) / 2


def test_own_layers_may_have_notes_and_must_be_layers():
    """Notes are left out. Where `draw` returns none, the board says so, and not that it failed."""

    def noted(variables):
        yield with_notes(dots([(0, 0)], "hit"), "number {k}", k=[1])

    made = code_board(halfway, (0.0, 0.0), (4.0, 0.0), draw=noted)
    assert made.drawing.text == "halfway returns (2, 0)"
    made = code_board(halfway, (0.0, 0.0), (4.0, 0.0), draw=lambda variables: None)
    assert "draw must return a list of layers, got None" in made.drawing.warning


def test_functions_of_the_library_are_shown_too():
    """A compiled function's own source runs, without types, as the reader would write it."""
    given = 3.0, 4.0, 0.0, 0.0, 6.0, 0.0
    made = code_board(closest_on_segment, *given, window=((0, 0), (6, 6)))
    assert made.drawing.listing.lines[0] == "def closest_on_segment(px, py, ax, ay, bx, by):"
    assert made.drawing.total > 0 and not made.drawing.warning


def test_circles_have_their_radius_while_point_and_radius_have_values():
    """A radius is an expression; a circle that cannot be drawn is left out."""

    def grow(q):
        d = 1.0
        d = d + 1.0
        return q, d

    made = code_board(grow, (3.0, 4.0), circles={"q": "d"}, window=((0, 0), (9, 9)))
    (circle,) = made.drawing.layers
    for step, radius in ((0, None), (1, 1.0), (2, 2.0), (3, 2.0)):
        sides = shown(circle, step)
        far = np.hypot(*(sides[:, :2] - (3.0, 4.0)).T)
        assert len(far) == 0 if radius is None else np.allclose(far, radius)
    made = code_board(grow, (3.0, 4.0), circles={"q": "1 / 0"}, window=((0, 0), (9, 9)))
    assert not made.drawing.warning and sum(len(one.rows) for one in made.drawing.layers) == 0


ROADS = ke.Graph(nodes=[(0, 0), (4, 3), (8, 0)], edges=[(0, 1), (1, 2), (0, 2)])


def expand(graph, k):
    now = list(ke.graphs.dijkstra_expansions(graph, 0))[k]
    u, cost, parent, waiting = now.node, now.cost, now.parent, set(now.frontier)
    for v in graph.neighbours(u):
        by_u = cost[u] + graph.weight(u, v)
        if by_u < cost[v]:
            cost[v], parent[v] = by_u, u
            waiting.add(v)
    return float(cost[2])


def test_the_nodes_of_a_graph_are_dragged_and_lengths_follow():
    """Each node is a handle; the state of the search is drawn at each line."""
    made = code_board(expand, ROADS, 0, draw=draw_search_state)
    assert [one["name"] for one in made.scene["handles"]] == ["0", "1", "2"]
    assert made.drawing.text == "expand returns 8" and not made.drawing.warning
    assert made.drawing.layers[0].rows.shape == (3, 4)  # the edges
    costs = [layer for layer in made.drawing.layers if layer.kind == "labels"]
    assert {text for layer in costs for text in layer.texts} == {"0.0", "5.0", "8.0"}
    drawing = Page(made).moves(["handle", 2, [6.0, 0.0]])
    assert drawing["text"] == "expand returns 6"


def test_a_bitmap_lies_beneath_the_picture():
    """Cells are squares of side 1, free where the array is true; a terrain is shown too."""

    def look(free, q):
        return bool(free[int(q[1]), int(q[0])])

    free = np.array([[True, False, True], [True, True, True]])
    made = code_board(look, free, (1.5, 0.5))
    assert made.scene["hi"] == [3.0, 2.0] and made.scene["size"] == [2, 3]
    assert made.drawing.text == "look returns False"
    assert Page(made).moves(["handle", 0, [1.5, 1.5]])["text"] == "look returns True"
    ground = ke.Problem(ke.Point(), ke.Terrain(free), (0.5, 0.5), (2.5, 0.5))
    made = code_board(lambda problem: problem.is_free_path((0.5, 0.5), (2.5, 0.5)), ground)
    assert made.scene["size"] == [2, 3] and made.drawing.text.endswith("returns False")


def swept(problem, q_near, q_rand):
    q_new = problem.steer(q_near, q_rand, 20.0)
    return problem.is_free_path(q_near, q_new)


def test_poses_of_a_robot_are_dragged_turned_and_drawn():
    """A pose has a place and a tip that keeps its distance; the body is drawn at variables too."""
    stick = ke.RigidPolygon([(-1.0, -0.2), (1.0, -0.2), (1.0, 0.2), (-1.0, 0.2)])
    gate = ke.PolygonWorld(
        [(0, 0), (8, 0), (8, 4), (0, 4)],
        [[(4, 0), (4.2, 0), (4.2, 1.5), (4, 1.5)], [(4, 2.5), (4.2, 2.5), (4.2, 4), (4, 4)]],
    )
    problem = ke.Problem(stick, gate, (1.5, 2, 0), (6, 2, 0))
    made = code_board(swept, problem, (1.5, 2.0, 0.0), (6.0, 2.0, 0.0))
    names = [one["name"] for one in made.scene["handles"]]
    assert names == ["q_near", "heading of q_near", "q_rand", "heading of q_rand"]
    assert len(made.scene["polygons"]) == 2 and made.drawing.text == "swept returns True"
    found = [layer for layer in made.drawing.layers if layer.kind == "bodies"]
    assert [len(layer.rows) for layer in found] == [1, 1, 1]  # of q_near, q_rand and q_new
    assert len(shown(found[2], 0)) == 0 and np.allclose(shown(found[2], 1)[0, :2], (5.0, 1.8))
    drawing = Page(made).moves(["handle", 3, [6.0, 3.9]])
    assert drawing["text"] == "swept returns False"
    (moved,) = [at for kind, number, at in drawing["places"] if number == 3]
    assert np.allclose(moved, (6.0, 3.5))


def test_a_pose_keeps_its_heading_while_its_place_is_dragged():
    """However many messages a drag sends; and after its tip was moved too."""

    def stand(robot, q):
        return q

    canvas = code_board(stand, ke.Car(3, 1, 2), (5.0, 5.0, 0.3), window=((0, 0), (10, 10)))
    page = Page(canvas)
    for y in (5.5, 6.0, 6.5):
        assert page.moves(["handle", 0, [5.0, y]])["text"] == f"stand returns (5, {y:g}, 0.3)"
    assert page.moves(["handle", 1, [5.0, 9.0]])["text"] == "stand returns (5, 6.5, 1.571)"
    body = next(layer for layer in canvas.drawing.layers if layer.kind == "bodies")
    assert np.ptp(body.rows[0, 0::2]) < np.ptp(body.rows[0, 1::2])
    for x in (4.0, 3.0):
        assert page.moves(["handle", 0, [x, 6.5]])["text"] == f"stand returns ({x:g}, 6.5, 1.571)"


AT = ((0.0, 0.0), (1.0, 1.0), (2.0, 2.0))  # q, p1, p2


@pytest.mark.parametrize(
    ("given", "more", "says"),
    [
        ((), {}, "do not fit"),
        (((0.0, 0.0), 1, 2, 3), {}, "do not fit"),
        ((1, 2, 3), {}, "window"),
        ((1, 2, 3), {"window": ((9, 9), (0, 0))}, "lo must lie"),
        ((1, 2, 3), {"window": ((0, 0), (9, 0))}, "lo must lie"),
        (AT, {"points": {"a": "b ="}}, "expressions"),
        (AT, {"most": 0}, "most"),
        (AT, {"first": -1}, "first"),
        (AT, {"fixed": ["wall"]}, "has no parameter 'wall'; it has"),
        (AT, {"areas": ["wall"]}, "has no parameter 'wall'; it has"),
        (AT, {"lines": [("q", "nearst")]}, "has no variable 'nearst'; it has q, "),
        (AT, {"circles": {"nearst": "1.0"}}, "has no variable 'nearst'"),
        (AT, {"vectors": {"q": "nearst"}}, "has no variable 'nearst'"),
    ],
)
def test_arguments_that_do_not_fit_are_refused(given, more, says):
    """Names that the function does not have, too."""
    with pytest.raises(InvalidParameter, match=says):
        code_board(nearest_on, *given, **more)


def own(problem, rng):
    """A planner that takes one random step, and then goes straight to the goal."""
    q_new = problem.steer(problem.start, problem.sample(rng), 1.0)
    if problem.is_free_path(problem.start, q_new):
        return [problem.start, q_new, problem.goal]
    return None


@pytest.mark.parametrize(
    ("planner", "head"),
    [
        (own, "def own("),
        ("rrt", "def grow(problem, tree,"),
        ("rrt_connect", "def extend(problem, tree,"),
        ("rrt_star", "def grow_shortest(problem, costs,"),
        ("prm", "def join_in_order(problem, nodes,"),
        ("astar", "def expand(graph, goal,"),
    ],
)
def test_a_planners_lines_are_shown_on_its_board(planner, head):
    """The box "code" makes each line a step; without it the steps are as before."""
    made = board(walled(), planner=planner)
    before = made.canvas.drawing
    made.code.value = True
    drawing = made.canvas.drawing
    assert before.listing is None and drawing.listing.lines[0].startswith(head)
    assert drawing.total == len(drawing.listing.ran) and drawing.layers[-1].last
    made.code.value = False
    assert made.canvas.drawing.text == before.text


@pytest.mark.parametrize("planner", sorted(CODE.keys() & ON_BOARD))
def test_the_lit_planner_is_the_planner(planner):
    """Tracing changes no answer, and all points that the picture names are drawn."""
    made = board(walled(), planner=planner, samples=400)
    length = made.plan.cost
    made.code.value = True
    assert made.plan.cost == length
    look, noted = CODE[planner][1], made.canvas.drawing.listing.values
    assert {*look.points, *look.circles} <= {name for values in noted for name in values}


CAR = ke.Problem(ke.Car(1, 0.5, 1), walled().world, (2, 2, 0), (2, 8, 3))
NEAR = ke.Problem(ke.Point(), walled().world, (1, 1), (2, 2))
HALL = ke.MovingWorld(walled().world, [ke.Moving(1.0, [0, 5], [(9, 5), (1, 5)])])
FREE = np.ones((9, 9), bool)
OTHER_BOARDS = {  # a board, and how the code that it shows begins
    "roadmap": (lambda: ke.boards.roadmap_board(walled(), 40), "def join_in_order("),
    "forest": (
        lambda: ke.boards.roadmap_board(walled(), 40, rule="component"),
        "def join_components(",
    ),
    "rewiring": (lambda: ke.boards.rewiring_board(walled(), nodes=60), "def grow_shortest("),
    "bfs": (lambda: ke.boards.search_board(ROADS), "def breadth_first("),
    "dfs": (lambda: ke.boards.search_board(ROADS, search="dfs"), "def depth_first("),
    "dijkstra": (lambda: ke.boards.search_board(ROADS, search="dijkstra"), "def expand("),
    "grid": (lambda: ke.boards.search_board(FREE, search="astar"), "def expand("),
    "sweep": (lambda: ke.boards.sweep_board(walled().world), "def handle_event("),
    **{
        bug: (
            lambda bug=bug: ke.boards.bug_board((0, 5), (10, 5), [WALL], bug=bug),
            f"def {bug}_walk(",
        )
        for bug in ("bug_base", "bug0", "bug1", "bug2_prelim", "bug2")
    },
    "exploring": (
        lambda: ke.boards.exploring_board(NEAR, 6.0),
        "def receding_horizon_looks(",
    ),
    "moving": (
        lambda: ke.boards.moving_board(ke.TimedProblem(ke.Point(), HALL, (1, 1), (9, 1)), nodes=40),
        "def search_intervals(",
    ),
    "car": (lambda: ke.boards.car_board(CAR, "rrt", max_iterations=20), "def grow("),
    "driven": (lambda: ke.boards.car_board(CAR, max_iterations=3), "def grow_by_driving("),
    "drives": (
        lambda: ke.boards.car_board(CAR, "kinodynamic_prm", max_iterations=2),
        "def drive_from_nearest(",
    ),
}


@pytest.mark.parametrize("name", OTHER_BOARDS)
def test_every_growing_board_shows_the_code_that_ran(name):
    """With the box "code" a step is a line; the board's own drawing grows with the lines."""
    make, head = OTHER_BOARDS[name]
    made = make()
    before = made.canvas.drawing
    made.code.value = True
    drawing = made.canvas.drawing
    assert not before.listing and drawing.listing.lines[0].startswith(head), drawing.warning
    assert drawing.total == len(drawing.listing.ran) > 1
    for layer in drawing.layers:
        assert layer.when is None or np.isfinite(layer.when).all()
    assert drawing.text and not drawing.warning
    made.code.value = False
    assert made.canvas.drawing.text == before.text


@pytest.mark.parametrize(
    ("leader", "head", "counted"),
    [(0, "def grow(", "nodes in tree"), (1, "def extend(", ""), (2, "def grow_shortest(", "")],
)
def test_a_race_shows_the_lines_of_the_planner_that_is_chosen(leader, head, counted):
    """The other trees have at each line as many nodes as the leader's; one slider scrubs all."""
    made = ke.boards.race_board(walled(), nodes=40, step_size=1.0)
    plain = [canvas.drawing for canvas in made.canvases]
    assert [drawing.listing for drawing in plain] == [None] * 3
    made.code.value = str(leader)
    lit = [canvas.drawing for canvas in made.canvases]
    assert lit[leader].listing.lines[0].startswith(head)
    assert {drawing.total for drawing in lit} == {len(lit[leader].listing.ran)}
    for number in {0, 1, 2} - {leader}:
        assert lit[number].listing is None and len(lit[number].step_texts) == lit[number].total
    if counted:
        values = lit[leader].listing.values
        for line, seen in enumerate(values, start=1):
            nodes = int(seen[counted])
            for before, now in zip(plain[1].layers, lit[1].layers, strict=True):
                assert len(shown(now, line)) == len(shown(before, nodes))
    made.code.value = ""
    assert [canvas.drawing.text for canvas in made.canvases] == [one.text for one in plain]


def test_a_race_shows_the_lines_of_a_planner_of_the_reader():
    """The other planner of the reader has made as many queries at each line."""

    def theirs(problem):
        half = [0.5, 0.5]
        problem.is_free(half)
        problem.is_free_path(problem.start, problem.goal)
        return [problem.start, problem.goal]

    def other(problem):
        for _ in range(5):
            problem.is_free_path(problem.goal, problem.start)

    made = ke.boards.race_board(walled(), [theirs, other])
    made.code.value = "0"
    first, second = (canvas.drawing for canvas in made.canvases)
    assert [line.split("(")[0].strip() for line in first.listing.lines][:2] == [
        "def theirs",
        "half = [0.5, 0.5]",
    ]
    (asked,) = (one for one in second.layers if one.kind == "edges" and len(one.rows))
    assert [len(shown(asked, line)) for line in range(5)] == [0, 0, 1, 2, 2]


@pytest.mark.parametrize("search", ["bfs", "dfs", "astar"])
def test_a_search_expands_its_nodes_with_its_lines(search):
    """After the last line all that the search expanded is shown, before the first line nothing."""
    made = ke.boards.search_board(ROADS, search=search)
    plain = made.canvas.drawing
    made.code.value = True
    lit = made.canvas.drawing
    grows = [layer for layer in plain.layers if not layer.last]
    assert any(layer.when is not None for layer in grows)
    for one, other in zip(grows, lit.layers, strict=False):
        if one.when is not None:
            assert len(shown(other, lit.total)) == len(shown(one, plain.total))
            assert len(shown(other, 0)) == len(shown(one, 0))
    named = {text for layer in lit.layers if layer.kind == "labels" for text in layer.texts}
    assert {"u", "v"} <= named


def test_a_trace_that_is_full_keeps_the_line_that_fails_later():
    """The last moment of a long run is the line that raised the exception, with its variables."""

    def fails(n):
        for i in range(n):
            x = 1 / (50 - i)
        return x

    with pytest.raises(ZeroDivisionError), LineTrace(fails, lambda v, _: v["i"], most=9) as trace:
        fails(99)
    last = trace.moments[-1]
    assert (len(trace.moments), last.line, last.note, last.ending) == (10, 2, 50, RAISED)


def test_a_notebook_stores_the_code_in_its_picture():
    """The picture has the code at its right, at the step that the board shows at first."""
    given = (3.0, 4.0), (0.0, 0.0), (6.0, 0.0)
    wide = Image.open(io.BytesIO(code_board(nearest_on, *given, first=2).picture()))
    early = code_board(nearest_on, *given, first=0).picture()
    plain = Image.open(
        io.BytesIO(ke.boards.distance_board([(0, 0), (6, 0), (3, 4)], (9, 9)).picture())
    )
    assert wide.width > 1.3 * plain.width
    assert early != code_board(nearest_on, *given, first=2).picture()


def test_a_board_that_shows_its_code_does_not_answer_in_a_page():
    """The page has the planner as machine code, whose lines nobody sees."""
    made = board(walled(), "prm", samples=200, step_size=0.5, rng=4)
    assert "live" in made.record()[0]
    made.code.value = True
    made.planner.value = "rrt"
    assert "live" not in made.record()[0]


def test_to_show_values_uses_none_of_them_up():
    """An iterator is as it was, also one that never ends; of many items a few are looked at."""
    numbers, ones = iter([1.0, 2.0]), itertools.count()
    assert [format_short(numbers), format_short(ones)] == ["list_iterator", "count"]
    assert (next(numbers), next(ones)) == (1.0, 0)
    assert format_short(zip([1], [2])) == "zip"
    assert format_short({1: 2}.values()) == "[2]"
    seen = []

    class Noted(float):
        def __float__(self):
            seen.append(1)
            return 0.5

    assert format_short([Noted(k) for k in range(1, 500)]).endswith("(499)")
    assert len(seen) < 10


class Spoken:
    def words(self):
        """A method whose text begins at the left margin."""
        text = """
at the margin
"""
        if text:
            return len(text)
        return 0


def test_lines_are_traced_where_a_text_begins_at_the_margin():
    with LineTrace(Spoken.words, lambda local, _: dict(local), most=10) as trace:
        assert Spoken().words() == 15
    assert [moment.holds for moment in trace.moments if moment.holds is not None] == [True]


def test_a_function_that_is_written_again_has_its_new_lines(monkeypatch):
    """Also where Python makes the same code of both texts."""

    def lines_of(comment):
        text = f"def one():\n    return 1  # {comment}\n"
        name, names = f"<cell {comment}>", {}
        entry = (len(text), None, text.splitlines(keepends=True), name)
        monkeypatch.setitem(linecache.cache, name, entry)
        exec(compile(text, name, "exec"), names)
        with LineTrace(names["one"], lambda local, _: None, most=10) as trace:
            names["one"]()
        return trace.source.lines

    assert lines_of("first") == ("def one():", "    return 1  # first")
    assert lines_of("second") == ("def one():", "    return 1  # second")


def test_every_variable_has_a_short_text():
    """Also one that Python cannot write, or would write for long; the function runs as it does."""
    nested = []
    nested.append(nested)
    assert format_short(nested) == "list" and format_short(10**5000) == "int"
    assert format_short(np.array(2.5)) == "2.5" and format_short("a\nb") == r"a\nb"
    assert format_short(range(10**18)) == "[0, 1, 2, ..., 999999999999999999] (1000000000000000000)"
    assert format_short(set(range(9))) == "[0, 1, 2, ..., 8] (9)"
    assert len(format_short("word " * 1000)) < 300

    def chain(q):
        huge, links = 10**5000, None
        for k in range(400):
            links = (k, links)
        return q if huge else links

    assert code_board(chain, (1.0, 2.0), most=2000).drawing.text == "chain returns (1, 2)"


def test_an_expression_may_have_a_lambda_over_the_variables():
    """And a comprehension: both see the variables of the function."""

    def look(q, nodes):
        return len(nodes)

    points = {"near": "min(nodes, key=lambda p: abs(p[0] - q[0]))"}
    circles = {"q": "max(abs(p[0] - q[0]) for p in nodes)"}
    nodes = [(0.0, 0.0), (2.0, 2.0)]
    drawing = code_board(look, (1.8, 1.0), nodes, points=points, circles=circles).drawing
    assert drawing.listing.values[-1]["near"] == "(2, 2)"
    (circle,) = (layer for layer in drawing.layers if layer.colour == "roadmap" and layer.rows.size)
    assert np.isclose(np.ptp(circle.rows[:, 0]), 2 * 1.8)


def test_a_function_of_any_number_of_points_gets_them_one_by_one():
    """Each of them can be dragged, unless they are fixed."""

    def count_right(least, *points):
        return sum(p[0] > least for p in points)

    canvas = code_board(count_right, 1.5, (1.0, 1.0), (2.0, 2.0), (3.0, 3.0))
    assert canvas.drawing.text == "count_right returns 2"
    assert [item["name"] for item in canvas.scene["handles"]] == [
        "points 0",
        "points 1",
        "points 2",
    ]
    Page(canvas).moves(("handle", 0, [2.5, 1.0]))
    assert canvas.drawing.text == "count_right returns 3"
    window = (0, 0), (4, 4)
    still = code_board(count_right, 1.5, (1.0, 1.0), (2.0, 2.0), fixed=["points"], window=window)
    assert still.drawing.text == "count_right returns 1" and not still.scene["handles"]


def test_the_lines_of_odd_functions_are_shown(tmp_path, monkeypatch):
    """One on a single line with a docstring, and one whose first statement has decorators."""
    lines = ['def short(q): "Where."; return q', "", "def wrapped(q):", "    @staticmethod"]
    lines += ["    def same(p):", "        return p", "    return same(q)", ""]
    tmp_path.joinpath("odd_functions.py").write_text("\n".join(lines), encoding="utf-8")
    monkeypatch.syspath_prepend(str(tmp_path))
    odd = __import__("odd_functions")
    assert code_board(odd.short, (1.0, 2.0)).drawing.listing.lines == lines[:1]
    assert code_board(odd.wrapped, (1.0, 2.0)).drawing.listing.lines == lines[2:-1]


def test_a_page_break_and_a_separator_are_within_a_line(tmp_path, monkeypatch):
    """They end no line of Python, so each line that has run is shown as it is."""
    text = "def odd():\n    x = 'a\u2028b'\n\x0c\n    return x\n"
    (tmp_path / "odd_lines.py").write_text(text, encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    function = importlib.import_module("odd_lines").odd
    with LineTrace(function, lambda *_: None, most=10) as trace:
        function()
    run = [trace.source.lines[moment.line].strip() for moment in trace.moments]
    assert run == ["x = 'a\u2028b'", "return x"]

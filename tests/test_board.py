"""Boards without a browser: questions and answers, readers' planners, and stored notebooks."""

import base64
import inspect
import io
import json
import re
import sys
import threading
from contextlib import suppress
from functools import partial

import numpy as np
import pytest
from PIL import Image

import kinoedu as ke
from kinoedu.boards import (
    Canvas,
    Drawing,
    board,
    car_board,
    code_board,
    distance_board,
    solid_board,
)
from kinoedu.boards.car.car import ON_BOARD as ON_CAR_BOARD
from kinoedu.boards.core.drawing import edges, encode_drawing, labels, path
from kinoedu.boards.core.printed import fit_page
from kinoedu.boards.core.scene import handle, make_scene, move_parts
from kinoedu.boards.planning.board import ON_BOARD
from kinoedu.boards.planning.own import draw_questions, try_planner
from kinoedu.boards.planning.plans import make_problem_scene, problem_in
from kinoedu.errors import InvalidParameter, KinoeduError
from kinoedu.figures import palette, torus_mesh
from kinoedu.planners.registry import PLANNERS

SQUARE = [(0, 0), (10, 0), (10, 10), (0, 10)]
WALL = [(4, 0), (6, 0), (6, 8), (4, 8)]
ROOM = ([(1, 6), (3, 6), (3, 9), (1, 9)], [[(1.5, 6.5), (2.5, 6.5), (2.5, 8.5), (1.5, 8.5)]])


def walled(*more):
    """A wall between start and goal, and more."""
    return ke.Problem(ke.Point(), ke.PolygonWorld(SQUARE, [WALL, *more]), (1, 1), (9, 1))


LET_GO = {"kind": "keep", "from": "page"}  # what a page sends when a moved thing is released


class Page:
    """Replaces a browser: records messages from the board, and sends messages to it."""

    def __init__(self, canvas):
        self.canvas, self.sent = canvas, []
        canvas.send = lambda content, buffers=None: self.sent.append((content, buffers))

    def says(self, message):
        """Send a message, and return the drawings that are answered."""
        self.sent.clear()
        self.canvas._received(self.canvas, message, [])
        return [content for content, _ in self.sent if content["kind"] == "drawing"]

    def moves(self, *parts, seq=1):
        """Send parts of the scene, and return the one drawing that is answered."""
        (drawing,) = self.says(
            {"kind": "scene", "from": "page", "seq": seq, "moved": [list(part) for part in parts]}
        )
        return drawing


def test_a_moved_goal_is_planned_anew():
    """The answer has the question's number and page, a buffer per layer, and the new goal."""
    made = board(walled())
    drawing = Page(made.canvas).moves(("handle", 1, [9, 9]), seq=7)
    assert (drawing["seq"], drawing["to"]) == (7, "page")
    assert made.plan.path[-1].tolist() == [9, 9]
    assert [layer["kind"] for layer in drawing["layers"]] == ["edges", "path"]
    assert json.loads(json.dumps(drawing)) == drawing  # nothing but plain data


def test_a_buffer_holds_places_in_world_sizes_and_when_each_came():
    """Coordinates are relative to the world, without loss far away; the last column is the step."""
    drawing = Drawing(
        [
            edges([[(1e9 + 1, 2), (1e9 + 3, 4)]], "tree", when=[5]),
            path([(1e9, 0), (1e9 + 10, 10)], "path"),
        ]
    )
    about, (tree, way) = encode_drawing(drawing, (1e9, 0), 10.0)
    assert np.allclose(np.frombuffer(tree, np.float32), [0.1, 0.2, 0.3, 0.4, 5.0])
    assert np.frombuffer(way, np.float32).tolist() == [0, 0, 1, 1]
    assert about["layers"][0]["grows"] and about["layers"][1]["last"]


def test_every_planner_draws_its_growth_in_order():
    """Steps rise from 1 to their number; the path comes last."""
    for planner in ("rrt", "prm", "astar"):
        drawing = board(walled(), planner=planner, samples=200).canvas.drawing
        growing = next(layer for layer in drawing.layers if layer.when is not None)
        assert (
            (np.diff(growing.when) > 0).all()
            and growing.when[0] >= 1
            and growing.when[-1] == drawing.total
        )
        assert drawing.layers[-1].kind == "path" and drawing.layers[-1].last


def test_controls_answer_anew_for_every_page():
    """Another seed sends another plan to all pages; only the planner's own controls are shown."""
    made = board(walled())
    assert made.step_size.layout.display is None and made.samples.layout.display == "none"
    page, before = Page(made.canvas), made.plan
    made.seed.value = 5
    ((content, _),) = page.sent
    assert content["seq"] is None and content["to"] is None and made.plan is not before
    made.planner.value = "prm"
    assert made.step_size.layout.display == "none" and made.samples.layout.display is None
    assert "PRM" in repr(made)


@pytest.mark.parametrize(("function", "planners"), [(board, ON_BOARD), (car_board, ON_CAR_BOARD)])
def test_the_docstring_names_the_planners(function, planners):
    """All that the board's menu has, and no other planner."""
    named = re.findall(r'"(\w+)"', inspect.getdoc(function))
    assert set(named) & set(PLANNERS) == set(planners)


@pytest.mark.parametrize("step", [None, 0.001, 0.8, 50.0])
def test_the_first_step_is_kept_by_the_slider(step):
    """It lies on a notch; otherwise the browser would move it and change the stored plan."""
    slider = board(walled(), step_size=step).step_size
    assert slider.value == pytest.approx(np.sqrt(200) / 20 if step is None else step)
    notches = (slider.value - slider.min) / slider.step
    assert slider.min <= slider.value <= slider.max and notches == pytest.approx(
        round(notches), abs=1e-6
    )


def test_the_same_scene_is_answered_once():
    """A hello or an unchanged scene is answered from memory, without running a planner again."""
    calls = []
    canvas = Canvas(
        make_scene((0, 0), (1, 1)), lambda scene: calls.append(scene) or Drawing(text="done")
    )
    page = Page(canvas)
    assert page.says({"kind": "hello", "from": "page"})[0]["text"] == "done"
    page.moves()
    page.says(LET_GO)
    assert len(calls) == 1


@pytest.mark.parametrize(
    ("part", "words"),
    [
        (("handle", 0, [5, 5]), "the start (5.0, 5.0) is not free"),
        (("handle", 1, [20, 1]), "the goal (20.0, 1.0) is not free: it must lie inside the world"),
        (
            ("polygon", 0, [[[4, 0], [6, 8], [6, 0], [4, 8]]]),
            "obstacle 0 crosses or touches itself",
        ),
    ],
)
def test_what_cannot_be_planned_is_said(part, words):
    """A warning without layers; the next good scene is planned as if nothing had happened."""
    made = board(walled())
    page, good = Page(made.canvas), made.canvas.drawing.text
    drawing = page.moves(part)
    assert words in drawing["warning"] and drawing["layers"] == [] and words in repr(made)
    kind, number, _ = part
    back = made.canvas.home[{"handle": "handles", "polygon": "polygons"}[kind]][number]
    again = page.moves((kind, number, back.get("at", back.get("rings"))))
    assert again["warning"] == "" and again["text"] == good


HOSTILE = [
    None,
    "scene",
    [],
    {},
    {"kind": "scene"},
    {"kind": "scene", "from": "p", "seq": "1", "moved": []},
    {"kind": "scene", "from": "p", "seq": 1},
    {"kind": "scene", "from": "p", "seq": 1, "moved": 5},
    {"kind": "scene", "from": "p", "seq": 1, "moved": [5]},
    {"kind": "scene", "from": ["p"], "seq": 1, "moved": []},
    {"kind": ["scene"], "from": "p", "seq": 1, "moved": []},
    *(
        {"kind": "scene", "from": "p", "seq": 1, "moved": [part]}
        for part in (
            ["handle", 1, [float("nan"), 1]],
            ["handle", 1, [float("inf"), 1]],
            ["handle", 1, [None, 1]],
            ["handle", 1, ["a", "b"]],
            ["handle", 1, {"x": 1}],
            ["handle", 1, [1]],
            ["handle", 1, 10**400],
            ["handle", -1, [1, 1]],
            ["handle", 9, [1, 1]],
            ["handle", True, [1, 1]],
            ["handle", "0", [1, 1]],
            ["tower", 0, [1, 1]],
            [["handle"], 0, [1, 1]],
            ["polygon", 0, [[1, 1]]],
            ["polygon", 0, [[[1, 1], [2, 2], [3, 1]]]],
            ["polygon", 0, None],
            ["polygon", 0, []],
            ["disc", 0, [1, 1]],
        )
    ),
]


@pytest.mark.parametrize("message", HOSTILE, ids=repr)
def test_a_broken_front_raises_nothing(message):
    """Invalid messages are reported or ignored, and change nothing."""
    made = board(walled())
    page, scene = Page(made.canvas), made.canvas.scene
    assert all(drawing["warning"] for drawing in page.says(message) if (message.get("moved") != []))
    assert (
        page.moves()["text"] == "RRT: a path of length 23.12, 84 nodes"
        or page.moves()["warning"] == ""
    )
    assert made.canvas.scene == scene


def test_a_front_cannot_write_into_the_state():
    """Words, home, and even a good scene are ignored: they may be older than what is shown."""
    made = board(walled())
    before = made.canvas.scene
    good = move_parts(before, [("handle", 1, [9, 9])])
    made.canvas.set_state({"scene": good, "words": {}, "home": {}})
    assert made.canvas.scene == before and made.canvas.words and made.canvas.home == before


def test_what_is_shown_is_kept_when_something_is_let_go():
    """`scene` stays through a drag, and becomes the newest scene at its end."""
    made = board(walled())
    page, before = Page(made.canvas), made.canvas.scene
    page.moves(("handle", 1, [9, 9]))
    assert made.canvas.scene == before
    assert page.says(LET_GO) == [] and made.canvas.scene == made.canvas.shown
    assert made.canvas.scene["handles"][1]["at"] == [9, 9]
    made.canvas.scene = before  # a lesson sets it
    assert made.plan.path[-1].tolist() == [9, 1]


def test_an_answer_that_fails_is_told(caplog):
    """A lesson's own error is shown on its board and logged, and the board goes on."""
    canvas = Canvas(make_scene((0, 0), (1, 1)), lambda scene: 1 / 0)
    assert "ZeroDivisionError" in repr(canvas) and "could not answer" in caplog.text


def test_answers_come_one_at_a_time():
    """Messages in several threads, as from JupyterLab's subshells, never answer at once."""
    inside, most = [], []

    def answer(scene):
        inside.append(1)
        most.append(len(inside))
        threading.Event().wait(0.01)
        inside.pop()
        return Drawing()

    canvas = Canvas(make_scene((0, 0), (1, 1), handles=[{"name": "q", "at": [0.0, 0.0]}]), answer)
    pages = [
        threading.Thread(
            target=canvas._received,
            args=(
                canvas,
                {"kind": "scene", "from": "p", "seq": k, "moved": [["handle", 0, [k / 9, 0]]]},
                [],
            ),
        )
        for k in range(1, 9)
    ]
    for thread in pages:
        thread.start()
    for thread in pages:
        thread.join()
    assert len(most) == 9 and max(most) == 1


@pytest.mark.parametrize(
    "more",
    [[], [ROOM], [ROOM, ((8, 5), 1)], [[(4, 0), (4, 8), (3, 4)]]],
    ids=["wall", "room", "disc", "corner"],
)
def test_a_scene_is_its_problem(more):
    """Problem to scene and back is the same world, also where two obstacles begin at one corner."""
    problem = walled(*more)
    again = problem_in(json.loads(json.dumps(make_problem_scene(problem))), problem)
    assert (again.world.edges == problem.world.edges).all()
    assert (again.world.obstacles.points == problem.world.obstacles.points).all()
    assert (again.start == problem.start).all() and (again.goal == problem.goal).all()


def test_a_terrain_goes_to_the_page_once_as_bits():
    """One bit per cell in the state; only start and goal can be moved."""
    free = np.ones((20, 30), bool)
    free[5:9, 5:9] = False
    canvas = board(ke.Problem(ke.Disk(0.5), ke.Terrain(free), (1, 1), (25, 15))).canvas
    bits = np.unpackbits(np.frombuffer(canvas.bitmap, np.uint8))[: free.size]
    assert (bits.reshape(free.shape) == free).all() and canvas.scene["size"] == [20, 30]
    assert canvas.scene["polygons"] == [] and canvas.scene["handles"][0]["radius"] == 0.5


def around(problem, rng):
    """A reader's planner: over the wall, after queries of the straight motion and of a place."""
    problem.is_free_path(problem.start, problem.goal)
    problem.is_free(problem.start)
    corners = [problem.start, np.array([3.0, 9.0]), np.array([7.0, 9.0]), problem.goal]
    return (
        corners
        if all(problem.is_free_path(a, b) for a, b in zip(corners, corners[1:], strict=False))
        else None
    )


def test_a_readers_planner_is_recorded_judged_and_raced():
    """Its queries are drawn in order, blocked motions apart; its length is compared with ours."""
    made = board(walled(), planner=around)
    assert made.plan.length == pytest.approx(2 * np.hypot(2, 8) + 4)
    assert repr(made).startswith("Board(yours: length 20.49, 4 motions checked; ours: length ")
    blocked, free, _, places = draw_questions(made.plan.questions)
    assert (
        free.when.tolist() == [3, 4, 5]
        and blocked.when.tolist() == [1]
        and places.when.tolist() == [2]
    )
    assert (free.colour, blocked.colour) == ("tree", "obstacle") and blocked.dash and not free.dash
    assert made.canvas.drawing.total == 5


def forever(problem):
    """Never ends, and catches every exception that it can."""
    while True:
        with suppress(Exception):
            problem.is_free_path(problem.start, problem.goal)


def out_of_range(problem):
    """An error in a reader's own line."""
    nodes = [problem.start]
    return nodes[3]


def wrong_step(problem):
    """An error that the library raises."""
    return ke.rrt(problem, step_size=-1, rng=0)


def leaves(problem):
    """Ends Python."""
    raise SystemExit


@pytest.mark.parametrize(
    ("planner", "words"),
    [
        (lambda problem: None, "yours: no path, 0 motions checked; ours: length"),
        (
            lambda problem: [problem.start, problem.goal],
            "motion 1 of your path, from (1, 1) to (9, 1), is not free",
        ),
        (
            lambda problem: [problem.start, (1, 9)],
            "your path must end at the goal (9, 1), it ends at (1, 9)",
        ),
        (
            lambda problem: [problem.goal],
            "your path must begin at the start (1, 1), it begins at (9, 1)",
        ),
        (lambda problem: 5, "it returned 5"),
        (lambda problem: [], "it returned []"),
        (lambda problem: [[1, 2, 3]], "it returned [[1, 2, 3]]"),
        (lambda problem: [[float("nan"), 1]], "it returned [[nan, 1]]"),
        (out_of_range, "your planner raised IndexError: list index out of range - in line 4 of"),
        (wrong_step, "return ke.rrt(problem, step_size=-1, rng=0)"),
        (leaves, "your planner raised SystemExit"),
        (lambda problem, rng: ke.rrt(problem, rng=rng), "yours: length"),
    ],
)
def test_what_a_readers_planner_did_is_said(planner, words):
    """Every failure has its message, with the reader's own line and none of the library's."""
    text = repr(board(walled(), planner=planner))
    assert words in text and "kinoedu/" not in text and "site-packages" not in text


def test_a_hanging_planner_is_stopped():
    """Its time and its recorded queries are bounded, and the picture shows them."""
    tried = try_planner(forever, walled(), 0, seconds=0.3)
    assert tried.fault.startswith("no answer after") and "It was stopped" in tried.fault
    assert 0 < len(tried.questions) <= 20_000 and not tried.still_running


def test_a_planner_that_cannot_be_stopped_is_not_started_again(monkeypatch):
    """The first run still uses the processor; a second one would only add to it."""
    released, started = threading.Event(), []

    def waits(problem):
        started.append(1)
        released.wait()

    module = sys.modules[
        "kinoedu.boards.planning.board"
    ]  # the package's attribute of that name is the function
    patched = partial(try_planner, seconds=0.1)
    monkeypatch.setattr(module, "try_planner", patched)
    made = board(walled(), planner=waits)
    assert "could not be stopped" in repr(made)
    Page(made.canvas).moves(("handle", 1, [9, 9]))
    assert "could not be stopped" in repr(made) and len(started) == 1
    released.set()


def test_a_reader_cannot_bend_the_judges_world():
    """The planner gets a copy: an obstacle that it removes is still there for the judge."""

    def vandal(problem):
        problem.world.obstacles.points[:] = 0
        problem.start[:] = problem.goal
        return [(1, 1), problem.goal]

    assert "motion 1 of your path" in repr(board(walled(), planner=vandal))


def test_our_own_functions_are_found_in_the_menu():
    """board(problem, planner=ke.prm) is board(problem, "prm"); anything else is refused."""
    assert board(walled(), planner=ke.prm, samples=100).planner.value == "prm"
    for planner in ("rtt", 5, None):
        with pytest.raises(
            InvalidParameter, match="planner must be one of rrt, rrt_connect, rrt_star, prm, astar"
        ):
            board(walled(), planner=planner)
    with pytest.raises(KinoeduError):
        board("problem")


ROOMS = ke.PolygonWorld(
    [(0, 0), (10, 0), (10, 10), (0, 10)],
    [([(1, 1), (9, 1), (9, 8), (1, 8)], [[(2, 2), (8, 2), (8, 7)]]), ((9.5, 9.5), 0.25)],
)
TRIANGLE = ke.TranslatingPolygon([(0, 0), (0.2, 0), (0, 0.1)])
CELLS = np.random.default_rng(0).random((3, 7)) < 0.9


def test_the_code_of_a_board_names_a_readers_planner():
    """A lambda has no name that code could use."""
    for planner, name in ((around, "around"), (lambda problem: None, "my_planner")):
        line = board(walled(), planner).write_code().splitlines()[-1]
        assert line.startswith(f"ke.board(problem, {name}, step_size=")


@pytest.mark.parametrize(
    "problem",
    [
        ke.Problem(ke.Disk(0.1), ROOMS, (0.3, 0.3), (0.3, 9.1), clearance=0.02),
        ke.Problem(TRIANGLE, ROOMS, (0.3, 0.3), (7.5, 2.2)),
        ke.Problem(
            ke.Point(),
            ke.Terrain(CELLS, resolution=0.1, origin=(-3, 1), cost=np.arange(21).reshape(3, 7) + 1),
            *([-3 + 0.1 * (i + 0.5), 1 + 0.1 * (j + 0.5)] for j, i in np.argwhere(CELLS)[[0, -1]]),
        ),
    ],
)
def test_a_board_as_code_is_the_same_board(problem):
    """The code makes the same problem, with the same planner and settings, to the last bit."""
    made = board(problem, "rrt_connect", step_size=0.3, samples=70, rng=5)
    names = {}
    exec(made.write_code().replace("ke.board(", "again = ke.board("), names)
    again = names["again"]
    assert flat(again.problem) == flat(made.problem)
    for control in ("planner", "seed", "step_size", "samples"):
        assert getattr(again, control).value == getattr(made, control).value
    assert again.plan.cost == made.plan.cost


def flat(record):
    """The numbers of a record, in order."""
    if isinstance(record, tuple):
        return [number for field in record for number in flat(field)]
    return np.asarray(record).ravel().tolist()


def test_a_reader_can_take_away_samples_until_a_roadmap_falls_into_pieces():
    """Lesson 11 asks for it, and says that it happens at 47 samples: the slider goes so far."""
    car = ke.Car(length=1.4, width=0.6, wheelbase=0.9)
    yard = ke.worlds.scattered(
        20, side=30, radius=2.2, keep_free=[(2, 2, 1.5), (28, 28, 1.5)], rng=4
    )
    drive = ke.Problem(ke.Disk(car.radius), yard, start=(2, 2), goal=(28, 28))
    made, pieces = board(drive, planner="prm", samples=60, rng=1), {}
    for samples in (48, 47):
        made.samples.value = samples
        roadmap = made.plan.roadmap
        pieces[samples] = len(ke.Graph(nodes=roadmap.nodes, edges=roadmap.edges).components())
    assert pieces == {48: 1, 47: 2}


def test_a_notebook_keeps_text_and_a_small_picture():
    """Without JavaScript: always the same text, and a PNG of 100 KB at most."""
    made = board(walled(), planner="prm", samples=2000)
    for widget in (made, made.canvas, distance_board(WALL, q=(1, 9))):
        data, _ = widget._repr_mimebundle_()
        assert data["text/plain"] == repr(widget) and "0x" not in repr(widget)
        assert len(base64.b64decode(data["image/png"])) < 100_000
        assert Image.open(io.BytesIO(base64.b64decode(data["image/png"]))).size[0] > 300
        assert "application/vnd.jupyter.widget-view+json" in data
    assert repr(board(walled())) == repr(board(walled()))


def test_a_stored_picture_has_twice_the_dots_of_its_page():
    """What notebooks store says how large it is shown; one with far too many bytes is coarser."""
    data, about = board(walled())._repr_mimebundle_()
    stored = Image.open(io.BytesIO(base64.b64decode(data["image/png"])))
    shown = about["image/png"]
    assert stored.size == (2 * shown["width"], 2 * shown["height"])
    picture, size = fit_page(noise_of(200))
    assert size == {"width": 100, "height": 100}
    assert Image.open(io.BytesIO(picture)).size == (200, 200)
    assert len(few_colours(picture)) <= 2 * len(set(palette.NAMED.values())) + 3
    picture, size = fit_page(noise_of(600))
    assert Image.open(io.BytesIO(picture)).size == (size["width"], size["height"]) == (300, 300)


def noise_of(side):
    """A square picture of random colours, as a PNG."""
    noise, stream = np.random.default_rng(0).integers(0, 256, (side, side, 3)), io.BytesIO()
    Image.fromarray(noise.astype(np.uint8)).save(stream, "png")
    return stream.getvalue()


def few_colours(picture):
    return Image.open(io.BytesIO(picture)).convert("RGB").getcolors()


def test_distance_board_tells_distance_nearest_point_and_inside():
    """Inside an edge, at a vertex, in the polygon; clockwise polygons; a crossing is reported."""
    canvas = distance_board(WALL[::-1], q=(1, 4))
    page = Page(canvas)
    assert repr(canvas) == "Canvas(distance 3; nearest: inside edge 3)"
    assert page.moves(("handle", 0, [7, 9]))["text"] == "distance 1.414; nearest: vertex 2"
    assert page.moves(("handle", 0, [5, 4]))["text"] == "q is in the polygon: distance 0"
    assert "crosses" in page.moves(("polygon", 0, [[[4, 0], [6, 8], [6, 0], [4, 8]]]))["warning"]


@pytest.mark.parametrize("wrong", [KeyboardInterrupt(), ZeroDivisionError(), None])
def test_a_page_has_a_reply_whatever_happens(wrong):
    """Also where the answer is interrupted, fails, or is no drawing; the next one is right."""
    failing = []

    def answer(scene):
        if not failing:
            return Drawing([], text="here")
        failing.clear()
        if wrong is not None:
            raise wrong
        return None

    canvas = Canvas(
        make_scene((0, 0), (9, 9), handles=[handle("q", (1, 1), colour="start")]), answer
    )
    failing.append("once")
    page = Page(canvas)
    message = {"kind": "scene", "from": "p", "seq": 3, "moved": [["handle", 0, [2, 2]]]}
    if isinstance(wrong, KeyboardInterrupt):
        with pytest.raises(KeyboardInterrupt):
            page.says(message)
        assert canvas.shown["handles"][0]["at"] == [1, 1]  # as it was answered last
        assert [content["seq"] for content, _ in page.sent] == [3]
        assert page.sent[0][0]["places"] == [["handle", 0, [1, 1]]]  # where the page puts it back
    else:
        (drawing,) = page.says(message)
        assert drawing["seq"] == 3
        assert "could not answer" in drawing["warning"]
    drawing = page.moves(("handle", 0, [3, 3]), seq=4)
    assert (drawing["seq"], drawing["text"]) == (4, "here")


def test_a_bitmap_can_be_taken_away():
    canvas = Canvas(make_scene((0, 0), (2, 2)), lambda scene: Drawing(), free=np.ones((2, 2), bool))
    canvas.set_bitmap(None)
    assert canvas.bitmap == b""


def test_a_dollar_sign_is_no_formula_in_a_picture():
    """Neither in a name, a text of the answer or a label, nor in a line of code."""
    odd = r"$\frac$"
    scene = make_scene((0, 0), (1, 1), handles=[handle(odd, (0.5, 0.5), colour="start")])
    canvas = Canvas(scene, lambda _: Drawing([labels([(0, 0)], [odd], "ink")], text=odd))
    assert canvas.picture().startswith(b"\x89PNG")

    def price(q):
        return rf"$\frac$ of {q[0]} is $\q$"

    assert code_board(price, (1.0, 2.0)).picture().startswith(b"\x89PNG")
    empty = {"text": odd, "shapes": []}
    solid = solid_board(torus_mesh(np.zeros((3, 3), int)), section=lambda theta, place: empty)
    assert solid.picture().startswith(b"\x89PNG")

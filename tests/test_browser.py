"""Boards that answer in a page: the same numbers and the same words as the boards of a lesson."""

import base64
import json
import shutil

import numpy as np
import pytest
import shapely
from lab_driver import keep
from test_board import Page

import kinoedu as ke
from kinoedu.boards import (
    Challenge,
    arm_board,
    bug_board,
    challenge,
    curves_board,
    distance_board,
    search_board,
    sweep_board,
)
from kinoedu.boards.car.curves import pose_in
from kinoedu.boards.core.drawing import as_rows
from kinoedu.boards.core.page_script import BROWSER, CORE, page_script
from kinoedu.boards.core.recorded import pack_records
from kinoedu.boards.core.scene import move_parts
from kinoedu.boards.core.shown import answer_by, draw_beside, draw_shown
from kinoedu.boards.planning.board import ON_BOARD
from kinoedu.boards.planning.live import describe_live, list_settings
from kinoedu.boards.planning.plans import draw_plan, make_problem_scene
from kinoedu.browser.bodies import BODIES, ON_TERRAIN, PLANNED, SEARCHED, describe_bodies
from kinoedu.browser.bug_looks import WALKED
from kinoedu.browser.scenes import pack_scene
from kinoedu.browser.wasm import write_scripts
from kinoedu.compiled import INTERPRETED, running
from kinoedu.curves import dubins_path, reeds_shepp_path
from kinoedu.errors import InvalidPolygon, InvalidStart, KinoeduError
from kinoedu.geometry.rings import as_ring, find_ring_fault
from kinoedu.graphs import Graph
from kinoedu.messages import get_message
from kinoedu.planners.grids.grid import grid_for
from kinoedu.planners.registry import PLANNERS

ROOM = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (5.0, 9.0), (0.0, 10.0)]
CONTROLS = {"step_size": 0.7, "nodes": 60}
SPACING = 0.4  # of a grid's cells
AGREE = 1e-12  # of coordinates up to 40
PROBLEMS = 50  # of each body; benchmarks/page.py compares 200
FEW = {"max_nodes": 120, "max_iterations": 400}  # where there is no path
WEDGE = [(1.2, 1.4), (2.6, 1.2), (2.4, 2.4), (1.4, 2.2)]
CELLS = "terrain_cells"  # the body of A* on the cells of a bitmap
PLANNERS_OF_PAGES = [*PLANNED, *ON_TERRAIN]


def make_problem(seed):
    """A problem with a point or a disk among four random obstacles, some of them not convex."""
    rng = np.random.default_rng(seed)
    robot = ke.Disk(0.2) if seed % 3 == 0 else ke.Point()
    while True:
        obstacles = [star(rng) for _ in range(3)] + [(rng.uniform(2, 8, 2), rng.uniform(0.3, 1.2))]
        try:
            world = ke.PolygonWorld(ROOM, obstacles)
            return ke.Problem(
                robot, world, *rng.uniform(0.5, 8.5, (2, 2)), clearance=0.1 * (seed % 2)
            )
        except KinoeduError:
            continue


def make_terrain_problem(seed, by_cells=False):
    """A problem with a point or a disk on random cells, of side 1 or not."""
    rng = np.random.default_rng(seed)
    robot = ke.Disk(0.3) if seed % 3 == 0 and not by_cells else ke.Point()
    size = [1.0, 0.5, 0.7][seed % 3]
    while True:
        free = rng.random((9 + seed % 4, 12)) < 0.85
        try:
            world = ke.Terrain(free, resolution=size)
            ends = world.lo + rng.uniform(0.05, 0.95, (2, 2)) * (world.hi - world.lo)
            margin = 0.0 if by_cells else 0.1 * (seed % 2)
            return ke.Problem(robot, world, *ends, clearance=margin)
        except KinoeduError:
            continue


def posed(name, seed):
    """A problem for a planner's body, its scene and its bitmap."""
    problem = (
        make_terrain_problem(seed, name == CELLS) if name in ON_TERRAIN else make_problem(seed)
    )
    return problem, make_problem_scene(problem), getattr(problem.world, "free", None)


def star(rng):
    """A simple polygon of three to eight corners."""
    angles = np.sort(rng.uniform(0.0, 2.0 * np.pi, rng.integers(3, 9)))
    reach = rng.uniform(0.4, 1.6, len(angles))
    return rng.uniform(2.0, 8.0, 2) + reach[:, None] * np.column_stack(
        [np.cos(angles), np.sin(angles)]
    )


def short_settings(problem, name, spacing):
    """The numbers that a body takes, with few nodes where there is no path."""
    few = FEW
    if name == "astar":
        grid = grid_for(problem, spacing)
        few = {"spacing": grid.side, "columns": float(grid.columns), "rows": float(grid.rows)}
    numbers = list_settings(problem, name, CONTROLS)
    fields = PLANNED[name].settings._fields
    return [float(few.get(key, n)) for key, n in zip(fields, numbers, strict=True)]


def planner_of(name):
    """The planner of a body."""
    return "astar" if name == CELLS else name.removeprefix("terrain_")


def ask(name, seed, rng, mode=INTERPRETED):
    """What a body shows of a problem, and what a page asks its worker."""
    problem, scene, free = posed(name, seed)
    settings = short_settings(problem, planner_of(name), None if name == CELLS else SPACING)
    made = BODIES[name].settings(*settings)
    with running(mode):
        shown = BODIES[name].function(pack_scene(scene, free), made, np.random.default_rng(rng))
    cells = None if free is None else [free.astype(int).ravel().tolist(), list(free.shape)]
    return shown, {"scene": scene, "cells": cells, "settings": settings, "seed": rng}


@pytest.mark.parametrize("name", PLANNERS_OF_PAGES)
def test_a_body_shows_what_the_board_shows(name):
    """The same layers, to the last bit, and the same words, for 12 problems."""
    planner = planner_of(name)
    for seed in range(12):
        keywords = {"step_size": 0.7, "rng": seed, **FEW}
        keywords = {"n": 60, "rng": seed} if planner == "prm" else keywords
        keywords = {"spacing": SPACING} if planner == "astar" else keywords
        keywords = {} if name == CELLS else keywords
        with running(INTERPRETED):
            theirs = draw_plan(PLANNERS[planner].function(posed(name, seed)[0], **keywords))
        shown, _ = ask(name, seed, seed)
        status, *facts = shown.facts
        mine = draw_shown(BODIES[name], int(status), facts, shown).completed
        for drawn, wanted in zip(mine.layers, theirs.layers, strict=True):
            assert same_layer(drawn, wanted)
        assert (mine.text, mine.total, mine.unit) == (theirs.text, theirs.total, theirs.unit)


def same_layer(a, b):
    """Whether all fields of two layers are equal, every number to its last bit."""
    return all(
        np.array_equal(x, y) if isinstance(x, np.ndarray) else x == y
        for x, y in zip(a, b, strict=True)
    )


def test_only_what_a_page_can_answer_is_called_live():
    """No body drives a car, plans among rooms, or with costs; A* has two for bitmaps."""
    problem = make_problem(1)
    assert describe_live(problem, "rrt", 0, CONTROLS)["body"] == "rrt"
    assert describe_live(problem, "own", 0, CONTROLS) is None
    rooms = ke.PolygonWorld(ROOM, [([(1, 1), (9, 1), (9, 8), (1, 8)], [[(2, 2), (8, 2), (8, 7)]])])
    bitmap, costly = (ke.Terrain(np.ones((5, 5)), cost=c) for c in (None, np.full((5, 5), 2.0)))
    for world, start in ((rooms, (7, 3)), (costly, (1.5, 1.5))):
        assert (
            describe_live(ke.Problem(ke.Point(), world, start, start), "rrt", 0, CONTROLS) is None
        )
    bodies = describe_live(ke.Problem(ke.Point(), bitmap, (1, 1), (4, 4)), "prm", 0, CONTROLS)
    assert bodies["body"] == "terrain_prm"
    assert set(bodies["settings"]) == set(ON_TERRAIN) - {"terrain_astar"}
    round_robot = ke.Problem(ke.Disk(0.1), bitmap, (1, 1), (4, 4))
    assert describe_live(round_robot, "astar", 0, CONTROLS)["body"] == "terrain_astar"


def test_a_board_says_what_a_page_needs():
    """The planner shown, the seed, and settings for all planners that the page has."""
    board = ke.board(make_problem(1), "prm", samples=200, step_size=0.5, rng=4)
    (record,) = board.record()
    assert record["live"]["body"] == "prm" and record["live"]["seed"] == 4
    assert set(record["live"]["settings"]) == set(PLANNED)
    assert record["live"]["settings"]["prm"] == [0.1, 200.0, 10.0]
    assert record["live"]["settings"]["rrt"][:2] == [0.1, 0.5]
    assert set(ON_BOARD) <= set(PLANNED)


# ---- bodies of other boards


def nearest_case(seed):
    """A polygon, of every fourth clockwise, and q beside it, in it, at a vertex or on an edge."""
    rng = np.random.default_rng(seed)
    ring, at = star(rng)[:: -1 if seed % 4 == 0 else 1], rng.uniform(0.0, 10.0, 2)
    while find_ring_fault(ring).kind:
        ring = star(rng)
    if seed % 5 == 1:
        at = ring[0]
    if seed % 5 == 2:
        at = (ring[0] + ring[1]) / 2.0
    if seed % 5 == 3:
        at = ring.mean(axis=0)
    return distance_board(ring, at).record()[0]


def crossing_case(seed):
    """A polygon with a vertex where an edge is crossed."""
    record = distance_board([(0, 0), (4, 0), (4, 4), (0, 4)], (seed, 9)).record()[0]
    record["scene"]["polygons"][0]["rings"][0][2] = [1.0 + 0.1 * seed, -2.0 - seed]
    return record


def curves_case(seed):
    """Two poses, near and far."""
    rng = np.random.default_rng(seed)
    far = [0.5, 3.0, 12.0][seed % 3]
    poses = np.column_stack([rng.uniform(-far, far, (2, 2)), rng.uniform(-np.pi, np.pi, 2)])
    return curves_board(*poses, rng.uniform(0.5, 2.0)).record()[0]


def graph_case(seed, search):
    """A graph with handles for its nodes, or without, or a grid; start, goal and a node moved."""
    rng, n = np.random.default_rng(seed), 3 + seed
    if seed % 3 == 2:
        made = search_board(rng.random((4 + seed % 9, 12)) < 0.7, search=search)
    else:
        pairs = [(u, v) for u in range(n) for v in range(u) if rng.random() < 3.0 / n]
        pairs = pairs if seed % 7 else []
        weights = rng.random(len(pairs)) if seed % 4 == 0 else None
        graph = Graph(nodes=9.0 * rng.random((n, 2)), edges=pairs, weights=weights)
        if seed % 5 == 0:
            graph.delete_node(1)
        made = search_board(graph, search=search)
    places = [("handle", k, (9.0 * rng.random(2)).tolist()) for k in (0, 1)]
    if len(made.canvas.scene["handles"]) > 2:
        places.append(("handle", 3, (9.0 * rng.random(2)).tolist()))
    Page(made.canvas).moves(*places)
    return made


def sweep_case(seed):
    """A line before, in and after a room of stars, of which some touch its wall."""
    rng = np.random.default_rng(seed)
    stars = [star(rng) for _ in range(1 + seed % 5)]
    touching = [(0, 5), (1, 6), (1, 4)]
    try:
        world = ke.PolygonWorld(ROOM, [*stars, touching] if seed % 3 == 0 else stars)
    except KinoeduError:
        return sweep_case(seed + 1000)
    return sweep_board(world, x=[rng.uniform(-0.5, 10.5), 5.0, 0.0][seed % 3]).record()[0]


def broken_sweep_case(seed):
    """A vertex across an edge, or one obstacle in another."""
    record = sweep_board(ke.PolygonWorld(ROOM, [SQUARE, [(5, 6), (7, 6), (6, 7)]])).record()[0]
    record["scene"]["polygons"][0]["rings"][0][2] = [6.0, 6.4] if seed % 2 else [1.0, -2.0 - seed]
    return record


ROUND = ke.PolygonWorld([(-4, -4), (4, -4), (4, 4), (-4, 4)], [WEDGE, ((0.4, 2.2), 0.4)])


def arm_case(seed):
    """An arm whose elbow, tip or q was moved, or both, or whose tip is pulled out of reach."""
    rng = np.random.default_rng(seed)
    q = rng.uniform(-np.pi, np.pi, 2)
    record = arm_board(ke.TwoLinkArm(1.5, [1.2, 1.5][seed % 2], 0.2), ROUND, q).record()[0]
    handles = record["scene"]["handles"] + record["live"]["beside"]
    for number in [(), (0,), (1,), (0, 1), (2,)][seed % 5]:
        handles[number]["at"] = rng.uniform(-3.9, 3.9, 2).tolist()
    record["scene"] = {**record["scene"], "handles": handles}
    return record


def bug_case(seed, bug):
    """Stars, which touch in some cases, and start and goal, in some of them or on a wall."""
    rng = np.random.default_rng(seed)
    stars = [star(rng).round(1 if seed % 3 else 9) for _ in range(seed % 4)]
    stars = [ring for ring in stars if not find_ring_fault(ring).kind]
    ends = rng.uniform(0.0, 10.0, (2, 2)).round(1)
    if seed % 5 == 4 and stars:
        ends[seed % 2] = stars[0][0]
    made = bug_board(*ends, stars, bug=bug, turn=("left", "right")[seed % 2])
    record = made.record()[0]
    live = {"body": bug, "seed": 0, "settings": {bug: [2.0 * (seed % 2) - 1.0, made.step]}}
    return {**record, "live": live}


def broken_bug_case(seed, bug):
    """An obstacle whose vertex was moved across an edge."""
    record = bug_board((-1, 1), (5, 1), [SQUARE], bug=bug).record()[0]
    record["scene"]["polygons"][0]["rings"][0][2] = [1.0 + 0.1 * seed, -2.0 - seed]
    return record


def walked_case(make, bug):
    return lambda seed: make(seed, bug)


def searched_case(search):
    return lambda seed: graph_case(seed, search.removeprefix("search_")).record()[0]


CASES = {
    "nearest": [nearest_case, crossing_case],
    "curves": [curves_case],
    "sweep": [sweep_case, broken_sweep_case],
    "arm": [arm_case],
    **{name: [searched_case(name)] for name in SEARCHED},
    **{name: [walked_case(bug_case, name)] for name in WALKED},
}
CASES["bug2"].append(walked_case(broken_bug_case, "bug2"))


def shown_natively(record):
    """What the body of a live board shows of its scene, run by Python."""
    live = record["live"]
    body = BODIES[live["body"]]
    settings = [as_rows(s, 4) if s == [] else np.array(s) for s in given_to(live)]
    settings = [s if s.ndim else float(s) for s in settings]
    rng = np.random.default_rng(live["seed"])
    return body.function(pack_scene(record["scene"]), body.settings(*settings), rng)


def given_to(live):
    """The settings of a live board's body, possibly those of another body."""
    given = live["settings"][live["body"]]
    return live["settings"][given] if isinstance(given, str) else given


@pytest.mark.parametrize("name", WALKED)
def test_a_bugs_body_walks_as_the_planner_does(name):
    """The same layers of both pictures, words and texts of steps, among separate obstacles."""
    compared = 0
    for seed in range(PROBLEMS // 2):
        made = bug_board((0, 0), (1, 0), [], bug=name)
        record = bug_case(seed, name)
        scene, live = record["scene"], record["live"]["settings"][name]
        rings = [item["rings"][0] for item in scene["polygons"]]
        ends = [item["at"] for item in scene["handles"]]
        made = bug_board(*ends, rings, bug=name, turn="left" if live[0] < 0.0 else "right")
        shown = shown_natively(record)
        status, *facts = shown.facts
        if status < 0:
            continue
        mine = draw_shown(WALKED[name], int(status), facts, shown).completed
        plot = draw_beside(WALKED[name], int(status), facts, shown).completed
        for own, theirs in ((mine, made.canvas.drawing), (plot, made.plot.drawing)):
            for drawn, wanted in zip(own.layers, theirs.layers, strict=True):
                assert same_layer(drawn, wanted)
            assert (own.text, own.step_texts) == (theirs.text, theirs.step_texts)
        compared += 1
    assert compared > 5


@pytest.mark.parametrize("name", SEARCHED)
def test_a_search_shows_what_the_board_shows(name):
    """The same layers and words, whether the nodes nearest to the ends are found here or there."""
    for seed in range(30):
        made = graph_case(seed, name.removeprefix("search_"))
        shown = shown_natively(made.record()[0])
        status, *facts = shown.facts
        mine = draw_shown(SEARCHED[name], int(status), facts, shown).completed
        theirs = made.canvas.drawing
        for drawn, wanted in zip(mine.layers, theirs.layers, strict=True):
            assert same_layer(drawn, wanted)
        assert (mine.text, mine.step_texts) == (theirs.text, theirs.step_texts)


def test_the_nearest_point_is_that_of_shapely():
    """The distance, and where the line to it ends."""
    for seed in range(PROBLEMS):
        record = nearest_case(seed)
        shape = shapely.Polygon(record["scene"]["polygons"][0]["rings"][0])
        here, shown = shapely.Point(record["scene"]["handles"][0]["at"]), shown_natively(record)
        assert shown.facts[1] == pytest.approx(shape.distance(here), abs=1e-12)
        assert (shown.facts[0] == 0) == (shown.facts[1] == 0.0) == (len(shown.way) == 0)
        for *_, x, y in shown.way:
            assert shape.exterior.distance(shapely.Point(x, y)) < 1e-12


def test_curves_of_a_body_are_those_of_the_library():
    """Words, lengths, and every drawn piece, from pose to pose."""
    for seed in range(PROBLEMS):
        record = curves_case(seed)
        shown, (radius,) = shown_natively(record), record["live"]["settings"]["curves"]
        poses = [pose_in(record["scene"], name) for name in "ab"]
        dubins, both = dubins_path(*poses, radius), reeds_shepp_path(*poses, radius)
        text = answer_by("curves", (radius,), record["scene"]).text
        assert dubins.word in text and both.word in text
        assert shown.facts[2] == dubins.length and shown.facts[4] == both.length
        for rows, end in ((shown.forward, dubins.length), (shown.driven, None)):
            if end is not None:
                assert rows[-1, 2:] == pytest.approx(poses[1][:2], abs=1e-8)
        drawn = sum(np.hypot(*(rows[:, 2:] - rows[:, :2]).T).sum() for rows in shown[2:4])
        assert drawn == pytest.approx(both.length, rel=0.01)


def test_a_board_says_what_is_wrong_with_a_ring():
    """In the words of the function that makes rings."""
    scene = crossing_case(0)["scene"]
    with pytest.raises(InvalidPolygon) as told:
        answer_by("nearest", (), scene)
    with pytest.raises(InvalidPolygon) as wanted:
        as_ring(scene["polygons"][0]["rings"][0])
    assert str(told.value) == str(wanted.value)


# ---- in Chromium


@pytest.fixture(scope="module")
def folder(chromium, tmp_path_factory):
    """The folder of a page with live boards."""
    pytest.importorskip("ziglang", reason="the compiler of the site is not installed")
    place = tmp_path_factory.mktemp("page")
    write_page(place)
    return place


def write_page(place):
    """Write a page with live boards, its scripts, and the modules."""
    write_scripts(place / "live")
    shutil.copy(BROWSER / "worker.js", place)
    world = ke.PolygonWorld(ROOM, [[(4, 0), (6, 0), (6, 8), (4, 8)], ((8, 5), 1)])
    problem = ke.Problem(ke.Point(), world, start=(1, 1), goal=(9, 1))
    boards = [ke.board(problem, "rrt", step_size=0.5), ke.board(problem, "prm", samples=200)]
    boards += [distance_board(SQUARE, (8, 8)), curves_board((0, 0, 0), (0, 4, 0), 2.0)]
    boards.append(search_board(GRID, search="bfs"))
    boards.append(ke.board(ke.Problem(ke.Point(), ke.Terrain(GRID), (1, 1), (8, 2)), "rrt"))
    boards += [sweep_board(SWEPT, x=4.0), arm_board(*ARMED), bug_board(*WALKED_ROUND)]
    write_records(place, boards, page_script(describe_bodies()))


def write_records(place, boards, script):
    """Write a page with records of boards, and its script."""
    (place / "boards.js").write_text(script, encoding="utf-8")
    shutil.copy(CORE / "board.css", place)
    records = [json.dumps(pack_records(board.record())) for board in boards]
    text = "".join(
        '<div class="kinoedu-record"><p class="still"></p>'
        f'<script type="application/json">{record}</script></div>'
        for record in records
    )
    head = '<meta charset="utf-8"><link rel="stylesheet" href="board.css">'
    head += '<script src="boards.js" defer></script>'
    (place / "index.html").write_text(f"<!doctype html>{head}<body>{text}", encoding="utf-8")


@pytest.fixture
def page(chromium, folder):
    """The page, opened from the disk; nothing may be fetched and nothing fail."""
    opened = chromium.new_page(viewport={"width": 760, "height": 8000})
    faults, asked = [], []
    opened.on("console", lambda message: faults.append(message.text))
    opened.on("pageerror", lambda error: faults.append(str(error)))
    opened.on("request", lambda request: asked.append(request.url))
    opened.goto((folder / "index.html").as_uri())
    opened.wait_for_function(
        "document.querySelectorAll('.kinoedu-board[data-paints]').length === 11"
    )
    yield opened
    assert faults == []
    assert all(url.startswith((folder.as_uri(), "blob:null/")) for url in asked)
    opened.close()


@pytest.fixture(scope="module")
def blank(chromium):
    """A page without boards, in which bodies are run."""
    opened = chromium.new_page()
    yield opened
    opened.close()


RUN = """([source, module, name, fields, cases]) => new Promise((resolve) => {
    const worker = new Worker(URL.createObjectURL(new Blob([source])));
    const letter = (byte) => String.fromCharCode(byte), answers = [];
    const text = ({ numbers }) => btoa(Array.from(new Uint8Array(numbers.buffer), letter).join(""));
    worker.onmessage = ({ data }) => {
        answers.push(data.error ?? [data.facts.map(String),
            Object.values(data.layers).map(text), data.took]);
        if (answers.length === cases.length) { worker.terminate(); resolve(answers); }
    };
    const letters = atob(module);
    const bytes = Uint8Array.from(letters, (c) => c.charCodeAt(0));
    worker.postMessage({ name, fields, module: bytes });
    const taken = (cells) => (cells ? [Uint8Array.from(cells[0]), cells[1]] : undefined);
    cases.forEach((one, k) => worker.postMessage(
        { ...one, free: taken(one.cells), name, ask: k }));
})"""


@pytest.mark.parametrize("name", PLANNERS_OF_PAGES)
def test_webassembly_gives_the_same_bits(blank, folder, name):
    """Every number of what 50 problems show, their worlds and random numbers included."""
    asked = [ask(name, seed, 1000 * seed + 2**31 * (seed % 2)) for seed in range(PROBLEMS)]
    given = run_in_page(blank, folder, name, [case for _, case in asked])
    for (shown, _), (facts, layers, _) in zip(asked, given, strict=True):
        assert [float(fact) for fact in facts] == shown.facts.tolist()
        assert layers == [in_base64(layer) for layer in shown[1:]]


def run_in_page(page, folder, name, cases):
    """Of each case the facts as texts, the layers' bytes in base64, and the milliseconds taken."""
    module = (folder / "live" / f"{name}.js").read_text(encoding="ascii").split('"')[3]
    assert base64.b64decode(module)[:4] == b"\0asm"
    source = (folder / "worker.js").read_text(encoding="utf-8")
    return page.evaluate(RUN, [source, module, name, list(BODIES[name].shows._fields), cases])


def in_base64(layer):
    """The bytes of an array as text."""
    return base64.b64encode(layer.tobytes()).decode("ascii")


def case_for_page(record):
    """What a page asks its worker of a live board."""
    return {"scene": record["scene"], "settings": given_to(record["live"]), "seed": 0}


# bodies with sines: their facts that are exact, and problems, few where each has an image to paint
ROUNDED = {"curves": ([0, 1, 3], PROBLEMS), "arm": ([0, 8], 5)}
EXACT = [(name, make) for name in CASES if name not in ROUNDED for make in CASES[name]]


@pytest.mark.parametrize(("name", "make"), EXACT)
def test_other_boards_give_the_same_bits(blank, folder, name, make):
    """Facts and layers of 50 scenes each, those with a fault included."""
    records = [make(seed) for seed in range(PROBLEMS)]
    given = run_in_page(blank, folder, name, [case_for_page(record) for record in records])
    for record, (facts, layers, _) in zip(records, given, strict=True):
        shown = shown_natively(record)
        assert [float(fact) for fact in facts] == shown.facts.tolist()
        assert layers == [in_base64(layer) for layer in shown[1:]]


@pytest.mark.parametrize("name", ROUNDED)
def test_sines_differ_in_the_last_digits_only(blank, folder, name):
    """The same words; numbers to 1e-12: sin, cos, atan2, acos and asin are each C library's own."""
    (exact, problems), most = ROUNDED[name], 0.0
    records = [CASES[name][0](seed) for seed in range(problems)]
    given = run_in_page(blank, folder, name, [case_for_page(record) for record in records])
    for record, (facts, layers, _) in zip(records, given, strict=True):
        shown = shown_natively(record)
        assert [float(facts[k]) for k in exact] == shown.facts[exact].tolist()
        for theirs, mine in zip(layers, shown[1:], strict=True):
            numbers = np.frombuffer(base64.b64decode(theirs)).reshape(mine.shape)
            most = max(most, np.abs(numbers - mine).max(initial=0.0))
    assert most < AGREE


def place_on_page(page, board, at, lo, hi):
    """Where a point of a world is on the page."""
    box = page.locator(".kinoedu-board canvas").nth(board).bounding_box()
    part = (box["width"] - 16, box["height"] - 16)
    x, y = (np.array(at) - lo) / np.subtract(hi, lo)
    return box["x"] + 8 + part[0] * x, box["y"] + 8 + part[1] * (1.0 - y)


def drag(page, board, begin, end, lo=(0.0, 0.0), hi=(10.0, 10.0)):
    """Drag from one point of a world to another."""
    page.mouse.move(*place_on_page(page, board, begin, lo, hi))
    page.mouse.down()
    for part in np.linspace(0.0, 1.0, 6):
        here = np.array(begin) * (1 - part) + np.array(end) * part
        page.mouse.move(*place_on_page(page, board, here, lo, hi))
    page.mouse.up()


SAYS = """([board, text]) => document.querySelectorAll('.kinoedu-board')[board]
    ?.querySelector('[role=status]')?.textContent === text"""


def test_a_page_says_what_was_wrong_with_a_recorded_answer(chromium, tmp_path):
    """Also on a page on which no board is live."""
    problem = ke.Problem(ke.Point(), ke.PolygonWorld(ROOM, [SQUARE]), start=(6, 1), goal=(1, 6))
    made = ke.board(problem, lambda problem: [problem.start, problem.goal])
    write_records(tmp_path, [made], page_script())
    opened = chromium.new_page()
    opened.goto((tmp_path / "index.html").as_uri())
    assert made.canvas.drawing.warning
    opened.wait_for_function(SAYS, arg=[0, made.canvas.drawing.warning], timeout=20_000)
    opened.close()


@pytest.fixture
def bare(chromium, tmp_path):
    """A live board whose page has no modules: it says the name of that which it could not load."""
    problem = ke.Problem(ke.Point(), ke.PolygonWorld(ROOM, [SQUARE]), start=(6, 1), goal=(1, 6))
    write_records(tmp_path, [ke.board(problem, "rrt")], page_script(describe_bodies()))
    opened = chromium.new_page()
    opened.goto((tmp_path / "index.html").as_uri())
    opened.wait_for_selector(".kinoedu-board[data-paints]")
    yield opened
    opened.close()


NAMED = "name => document.querySelector('.kinoedu-text').textContent.includes(`live/${name}.js`)"


def test_a_module_that_was_not_there_is_asked_for_again(bare):
    """At the next answer that needs it; nothing is remembered of a network that was lost."""
    asked, menu = [], bare.locator(".kinoedu-live select")
    bare.on("request", lambda request: asked.append(request.url.rpartition("/")[2]))
    for name in ("prm", "rrt_star", "prm"):
        menu.select_option(name)
        bare.wait_for_function(NAMED, arg=name)
    assert asked == ["prm.js", "rrt_star.js", "prm.js"]


LATER = """late => {
    const { head } = document, { append } = head;
    head.append = (element) => {
        if (element.src.endsWith(late)) globalThis.come = () => append.call(head, element);
        else append.call(head, element);
    }; }"""


def test_what_is_not_chosen_any_more_is_not_shown(bare):
    """A module that comes late does not replace the answer of the one chosen after it."""
    menu = bare.locator(".kinoedu-live select")
    bare.evaluate(LATER, "prm.js")
    menu.select_option("prm")
    menu.select_option("rrt_star")
    bare.wait_for_function(NAMED, arg="rrt_star")
    bare.evaluate("come()")
    with pytest.raises(Exception, match="Timeout"):
        bare.wait_for_function(NAMED, arg="prm", timeout=1_000)
    menu.select_option("prm")
    bare.evaluate("come()")
    bare.wait_for_function(NAMED, arg="prm")


def test_the_link_of_a_picture_goes_with_it(chromium, tmp_path):
    """Tab finds no link without a name before a board that plays."""
    made = distance_board(SQUARE, (8, 8))
    write_records(tmp_path, [made], page_script(describe_bodies()))
    file = tmp_path / "index.html"
    picture = '<a href="board.png"><img alt="a board"></a><p class="still">'
    text = file.read_text(encoding="utf-8").replace('<p class="still">', picture)
    file.write_text(text, encoding="utf-8")
    opened = chromium.new_page()
    opened.goto(file.as_uri())
    opened.wait_for_selector(".kinoedu-board[data-paints]")
    opened.keyboard.press("Tab")
    assert opened.evaluate("document.activeElement.tagName") == "BUTTON"
    opened.close()


BREAKS = """(() => {
    const Whole = Blob;
    let workers = 0;
    globalThis.Blob = class extends Whole {
        constructor(parts, about) {
            const first = about?.type === "text/javascript" && (workers += 1) === 1;
            super(first ? [...parts, "onmessage = () => { throw new Error('no memory'); };"]
                : parts, about);
        } }; })()"""


def test_a_worker_that_ended_is_replaced(chromium, folder):
    """Its question is answered with the reason, the next one by another worker."""
    opened = chromium.new_page(viewport={"width": 760, "height": 8000})
    opened.add_init_script(BREAKS)
    opened.goto((folder / "index.html").as_uri())
    opened.wait_for_selector(".kinoedu-board[data-paints]")
    goal, text = (opened.locator(name).first for name in (".kinoedu-thing", ".kinoedu-text"))
    for key, says in (("ArrowUp", "no memory"), ("ArrowDown", "RRT: ")):
        goal.press(key)
        opened.wait_for_function(
            "([e, says]) => e.textContent.includes(says)",
            arg=[text.element_handle(), says],
            timeout=20_000,
        )
    opened.close()


def test_a_challenge_stays_when_the_page_answers(chromium, tmp_path):
    """Its sentence does, and who can tell whether it is met."""
    few = Challenge("Come near.", lambda board, kept: (False, "Not yet."))
    made = challenge(distance_board(SQUARE, (8, 8)), few)
    write_records(tmp_path, [made], page_script(describe_bodies()))
    opened = chromium.new_page()
    opened.goto((tmp_path / "index.html").as_uri())
    board = opened.locator(".kinoedu-board[data-paints]")
    before = board.get_attribute("data-answers")
    assert board.locator(".kinoedu-goal-text").inner_text() == "Not yet."
    board.locator(".kinoedu-thing").first.press("ArrowUp")
    opened.wait_for_function(
        "([e, before]) => e.dataset.answers !== before", arg=[board.element_handle(), before]
    )
    goal = board.locator(".kinoedu-goals li").inner_text()
    assert "Come near." in goal and get_message("site.unjudged") in goal
    opened.close()


def lab_text(name, start, goal, polygon, seed):
    """What the board of a lesson says of the same scene."""
    try:
        world = ke.PolygonWorld(ROOM, [polygon, ((8, 5), 1)])
        problem = ke.Problem(ke.Point(), world, start=start, goal=goal)
    except KinoeduError as error:
        return str(error)
    given = {"rrt": {"step_size": 0.5}, "prm": {"nodes": 200}}[name]
    return draw_plan(PLANNERS[name].plan(problem, seed=seed, **given)).text


WALL = [(4, 0), (6, 0), (6, 8), (4, 8)]
SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]
GRID = np.ones((10, 10), bool)
GRID[:8, 4] = False
ARMED = ke.TwoLinkArm(1.5, 1.2, 0.2), ROUND, (0.6, 0.3)
WALKED_ROUND = (0, 4), (10, 4), [[(2, 2), (4, 2), (4, 6), (2, 6)], [(6, 3), (8, 3), (7, 7)]]
SWEPT = ke.PolygonWorld(ROOM, [[(2, 2), (5, 3), (3, 5)], [(6, 6), (8, 6), (7, 8)]])


def test_boards_are_dragged_in_the_page(page):
    """Start and goal; another seed is chosen; the words are those of a lesson's board."""
    drag(page, 0, (9, 1), (9, 8.5))
    page.wait_for_function(SAYS, arg=[0, lab_text("rrt", (1, 1), (9, 8.5), WALL, 0)])
    drag(page, 1, (1, 1), (2, 6))
    page.wait_for_function(SAYS, arg=[1, lab_text("prm", (2, 6), (9, 1), WALL, 0)])
    page.locator(".kinoedu-live button").first.click()
    page.wait_for_function(SAYS, arg=[0, lab_text("rrt", (1, 1), (9, 8.5), WALL, 1)])
    drag(page, 0, (1, 1), (5, 4))
    page.wait_for_function(SAYS, arg=[0, lab_text("rrt", (5, 4), (9, 8.5), WALL, 1)])
    drag(page, 1, (4, 8), (7, 2))  # a corner across the opposite edge
    crossed = [(4, 0), (6, 0), (6, 8), (7, 2)]
    page.wait_for_function(SAYS, arg=[1, lab_text("prm", (2, 6), (9, 1), crossed, 0)])
    keep(page, "live_boards")


def moved(scene, kind, number, at):
    """A scene in which one thing was moved."""
    return move_parts(scene, [(kind, number, at)])


def said_by(record, scene):
    """What the board of a lesson says of a scene."""
    live = record["live"]
    try:
        return answer_by(live["body"], live["settings"][live["body"]], scene).text
    except InvalidPolygon as error:
        return str(error)


def test_a_point_and_a_polygon_are_dragged_in_the_page(page):
    """q, then a vertex, then a vertex across an edge: the words are those of a lesson's board."""
    (record,) = distance_board(SQUARE, (8, 8)).record()
    scene, box = record["scene"], (record["scene"]["lo"], record["scene"]["hi"])
    for part, begin, end in (
        (("handle", 0, [7, 2]), (8, 8), (7, 2)),
        (("polygon", 0, [[[0, 0], [6, 0], [4, 4], [0, 4]]]), (4, 0), (6, 0)),
        (("polygon", 0, [[[0, 0], [6, 0], [2, -2], [0, 4]]]), (4, 4), (2, -2)),
    ):
        drag(page, 2, begin, end, *box)
        scene = moved(scene, *part)
        page.wait_for_function(SAYS, arg=[2, said_by(record, scene)])
    keep(page, "live_distance")


def test_poses_are_dragged_in_the_page(page):
    """A place, back along its heading, and what both look at, which returns to its distance."""
    (record,) = curves_board((0, 0, 0), (0, 4, 0), 2.0).record()
    scene, box = record["scene"], (record["scene"]["lo"], record["scene"]["hi"])
    for number, begin, end in ((3, (3, 4), (1, 6)), (0, (0, 0), (-3, 0)), (1, (0, 0), (-3, -5))):
        drag(page, 3, begin, end, *box)
        drawing = answer_by("curves", (2.0,), moved(scene, "handle", number, list(end)))
        scene = move_parts(moved(scene, "handle", number, list(end)), drawing.places)
        page.wait_for_function(SAYS, arg=[3, drawing.text])
    page.locator(".kinoedu-record").nth(3).locator(".kinoedu-live button").click()
    linked = json.loads(base64.urlsafe_b64decode(page.evaluate("location.hash").partition("=")[2]))
    places = [at for _, _, at in linked["places"]]
    assert places == [pytest.approx(item["at"], abs=1e-9) for item in scene["handles"]]
    keep(page, "live_curves")


def test_a_search_on_a_grid_is_dragged_in_the_page(page):
    """The start is moved, another search is chosen, and one scrubs through its expansions."""
    drag(page, 4, (0.5, 0.5), (2.5, 6.5))
    made = search_board(GRID, search="bfs")
    made.canvas.arrange(moved(made.canvas.scene, "handle", 0, [2.5, 6.5]))
    page.wait_for_function(SAYS, arg=[4, made.canvas.drawing.text])
    page.locator(".kinoedu-live select").nth(2).select_option("search_astar")
    made.search.value = "astar"
    page.wait_for_function(SAYS, arg=[4, made.canvas.drawing.text])
    board = page.locator(".kinoedu-board").nth(4)
    slider = board.locator(".kinoedu-slider")
    slider.press("Home")
    for _ in range(9):
        slider.press("ArrowRight")
    page.wait_for_function(SAYS, arg=[4, made.canvas.drawing.step_texts[9]])
    keep(page, "live_search")


def test_planners_on_a_bitmap_are_dragged_in_the_page(page):
    """Goal, another planner, and a start on a blocked cell: the words are those of a lesson."""
    drag(page, 5, (8, 2), (6.5, 4.5))
    problem = ke.Problem(ke.Point(), ke.Terrain(GRID), (1, 1), (6.5, 4.5))
    page.wait_for_function(SAYS, arg=[5, draw_plan(ke.rrt(problem, rng=0)).text])
    page.locator(".kinoedu-live select").nth(3).select_option("terrain_rrt_connect")
    page.wait_for_function(SAYS, arg=[5, draw_plan(ke.rrt_connect(problem, rng=0)).text])
    drag(page, 5, (1, 1), (4.5, 3.5))
    with pytest.raises(KinoeduError) as told:
        ke.Problem(ke.Point(), ke.Terrain(GRID), (4.5, 3.5), (6.5, 4.5))
    page.wait_for_function(SAYS, arg=[5, str(told.value)])
    keep(page, "live_terrain")


def test_the_sweep_line_is_dragged_in_the_page(page):
    """The line, a vertex, and an obstacle into another: the last good picture stays."""
    made = sweep_board(SWEPT, x=4.0)
    scene, box = made.canvas.scene, (made.canvas.scene["lo"], made.canvas.scene["hi"])
    low = scene["handles"][0]["at"][1]
    drag(page, 6, (4.0, low), (7.5, low), *box)
    made.canvas.arrange(moved(scene, "handle", 0, [7.5, low]))
    page.wait_for_function(SAYS, arg=[6, made.canvas.drawing.text])
    ring = [[2, 2], [5, 1], [3, 5]]
    drag(page, 6, (5, 3), (5, 1), *box)
    made.canvas.arrange(moved(made.canvas.shown, "polygon", 0, [ring]))
    page.wait_for_function(SAYS, arg=[6, made.canvas.drawing.text])
    board = page.locator(".kinoedu-board").nth(6)
    layers = board.get_attribute("data-layers")
    assert layers == " ".join(one.kind for one in made.canvas.drawing.layers)
    drag(page, 6, (3, 5), (7, 6.5), *box)
    page.wait_for_function(SAYS, arg=[6, get_message("sweep_board.overlap")])
    assert board.get_attribute("data-refused") == "true"
    assert board.get_attribute("data-layers") == layers
    keep(page, "live_sweep")


def test_an_arm_is_dragged_in_both_pictures(page):
    """q in the square, a disc, a vertex across an edge, which changes nothing, and the tip."""
    made, says = arm_board(*ARMED), page.locator(".kinoedu-board [role=status]")
    here, there = [(c.scene["lo"], c.scene["hi"]) for c in (made.canvas, made.square)]

    def both_say(*texts):
        for board, text in zip((7, 8), texts, strict=True):
            page.wait_for_function(SAYS, arg=[board, text])

    drag(page, 8, (0.6, 0.3), (2.0, 1.0), *there)
    made.square.arrange(moved(made.square.shown, "handle", 0, [2.0, 1.0]))
    both_say(made.canvas.drawing.text, made.square.drawing.text)
    drag(page, 7, (0.4, 2.2), (-0.6, 1.2), *here)
    made.canvas.arrange(moved(made.canvas.shown, "disc", 0, [-0.6, 1.2]))
    both_say(made.canvas.drawing.text, made.square.drawing.text)
    crossed = [list(corner) for corner in [WEDGE[0], (2.0, 3.0), *WEDGE[2:]]]
    drag(page, 7, (2.6, 1.2), (2.0, 3.0), *here)
    made.canvas.arrange(moved(made.canvas.shown, "polygon", 0, [crossed]))
    both_say(made.canvas.drawing.warning, made.square.drawing.text)
    assert page.locator(".kinoedu-board").nth(7).get_attribute("data-layers").startswith("bodies")
    drag(page, 7, (2.0, 3.0), (2.6, 1.2), *here)
    tip = made.canvas.shown["handles"][1]["at"]
    drag(page, 7, tip, (0.0, -3.5), *here)
    page.wait_for_function(
        "says => says[0].textContent.includes('reach only 2.7') && says[1].textContent.length",
        arg=[says.nth(7).element_handle(), says.nth(8).element_handle()],
    )
    keep(page, "live_arm")


def test_a_bug_is_dragged_in_the_page(page):
    """The goal, another bug, a step of its walk in both pictures, and what a bug cannot have."""
    made = bug_board(*WALKED_ROUND)
    box = made.canvas.scene["lo"], made.canvas.scene["hi"]
    drag(page, 9, (10, 4), (9, 7), *box)
    made.canvas.arrange(moved(made.canvas.shown, "handle", 1, [9, 7]))
    page.wait_for_function(SAYS, arg=[9, made.canvas.drawing.text])
    record = page.locator(".kinoedu-record").last
    record.locator("select").select_option("bug2")
    made.bug.value = "bug2"
    page.wait_for_function(SAYS, arg=[9, made.canvas.drawing.text])
    boards = [page.locator(".kinoedu-board").nth(number) for number in (9, 10)]
    for board, canvas in zip(boards, (made.canvas, made.plot), strict=True):
        layers = " ".join(one.kind for one in canvas.drawing.layers)
        page.wait_for_function(
            "([e, kinds]) => e.dataset.layers === kinds", arg=[board.element_handle(), layers]
        )
    slider = boards[0].locator(".kinoedu-slider")
    slider.press("Home")
    for _ in range(30):
        slider.press("ArrowRight")
    for number, canvas in ((9, made.canvas), (10, made.plot)):
        page.wait_for_function(SAYS, arg=[number, canvas.drawing.step_texts[30]])
    keep(page, "live_bug")
    slider.press("End")
    drag(page, 9, (0, 4), (3, 4), *box)
    with pytest.raises(InvalidStart) as told:
        ke.bug2((3, 4), (9, 7), WALKED_ROUND[2], 1.0)
    page.wait_for_function(SAYS, arg=[9, str(told.value)])
    drag(page, 9, (3, 4), (0, 4), *box)
    drag(page, 9, (4, 6), (7, 4), *box)
    page.wait_for_function(SAYS, arg=[9, get_message("bug_board.united")])
    assert boards[0].get_attribute("data-refused") == "true"
    assert boards[0].get_attribute("data-layers").startswith("edges")


def test_the_controls_of_a_board_fit_a_narrow_page(page):
    """At 320 pixels they stand below each other."""
    page.set_viewport_size({"width": 320, "height": 8000})
    parts = page.locator(".kinoedu-live > *").all()
    edges = [part.bounding_box()["x"] + part.bounding_box()["width"] for part in parts]
    assert len(edges) > 9 and max(edges) <= 320


def test_a_link_brings_the_same_world(page, folder):
    """A planner, a seed, a step and what was moved are in the address; nonsense there is said."""
    drag(page, 1, (9, 1), (9, 8.5))
    page.locator(".kinoedu-live select").nth(1).select_option("rrt_connect")
    page.locator(".kinoedu-live button").nth(2).click()
    page.wait_for_function(
        "document.querySelectorAll('.kinoedu-board')[1].querySelector('[role=status]').textContent"
        ".startsWith('RRT-Connect')"
    )
    text = page.locator(".kinoedu-board [role=status]").nth(1).inner_text()
    slider = page.locator(".kinoedu-board").nth(1).locator(".kinoedu-slider")
    slider.press("Home")
    slider.press("ArrowRight")
    share = page.locator(".kinoedu-live button").nth(3)
    before = share.text_content()
    share.click()
    address = page.evaluate("location.href")
    assert share.text_content() != before
    drag(page, 1, (9, 8.5), (9, 7.5))  # the address does not have this
    assert share.text_content() == before
    page.goto("about:blank")
    page.goto(address)
    page.wait_for_function("document.querySelectorAll('.kinoedu-board')[1]?.dataset.step === '1'")
    page.locator(".kinoedu-board").nth(1).locator(".kinoedu-slider").press("End")
    page.wait_for_function(SAYS, arg=[1, text])
    page.goto("about:blank")
    page.goto((folder / "index.html").as_uri() + "#kinoedu=nonsense")
    page.wait_for_function(SAYS, arg=[0, get_message("live.bad_link")])
    assert "path" in page.locator(".kinoedu-board").first.get_attribute("data-layers")


def test_a_link_shows_its_board_at_once(chromium, folder):
    """Also where the page's style scrolls smoothly, as the site's does."""
    smooth = "<style>html { scroll-behavior: smooth } p { height: 900px }</style><body>"
    text = (folder / "index.html").read_text(encoding="utf-8").replace("<body>", smooth)
    (folder / "smooth.html").write_text(text, encoding="utf-8")
    link = base64.urlsafe_b64encode(json.dumps({"version": 1, "key": "5-0"}).encode()).decode()
    opened = chromium.new_page(viewport={"width": 760, "height": 400})
    opened.add_init_script(
        "addEventListener('DOMContentLoaded', () => { globalThis.at = scrollY; })"
    )
    opened.goto(f"{(folder / 'smooth.html').as_uri()}#kinoedu={link}")
    assert opened.evaluate("at") > 0
    opened.close()


def test_a_link_opens_all_pictures_of_its_board_at_its_step(page):
    """The bug's world and the plot beside it."""
    slider = page.locator(".kinoedu-board").nth(9).locator(".kinoedu-slider")
    slider.press("Home")
    slider.press("ArrowRight")
    page.locator(".kinoedu-live").last.locator("button").last.click()
    address = page.evaluate("location.href")
    page.goto("about:blank")
    page.goto(address)
    for number in (9, 10):
        page.wait_for_function(
            "k => document.querySelectorAll('.kinoedu-board')[k]?.dataset.step === '1'", arg=number
        )


def test_odd_links_are_refused_and_the_last_seed_is_followed_by_the_first(page, folder):
    """Names that every object has are no planners; what a board links to can be opened."""
    link, first = page.locator(".kinoedu-live button").nth(1), (folder / "index.html").as_uri()
    link.click()
    board = json.loads(base64.urlsafe_b64decode(page.evaluate("location.hash").split("=", 1)[1]))

    def open_link(**changed):
        text = base64.urlsafe_b64encode(json.dumps({**board, **changed}).encode()).decode()
        page.goto("about:blank")
        page.goto(f"{first}#kinoedu={text}")

    for body in ("toString", "constructor", "__proto__"):
        open_link(body=body)
        page.wait_for_function(SAYS, arg=[0, get_message("live.bad_link")])
    open_link(seed=2**32 - 1)
    page.wait_for_function("document.querySelectorAll('.kinoedu-board').length === 11")
    page.locator(".kinoedu-live button").first.click()
    link.click()
    text = page.evaluate("location.hash").split("=", 1)[1]
    assert json.loads(base64.urlsafe_b64decode(text))["seed"] == 0

"""Boards that answer in a page: the same numbers and the same words as the boards of a lesson."""

import base64
import json
import shutil

import numpy as np
import pytest
from lab_driver import CHROMIUM, FLAGS, keep, needs_chromium

import kinoedu as ke
from kinoedu.boards.core.page_script import BROWSER, CORE, page_script
from kinoedu.boards.core.recorded import pack_records
from kinoedu.boards.planning.board import ON_BOARD
from kinoedu.boards.planning.live import describe_live, list_settings
from kinoedu.boards.planning.plans import draw_plan, make_problem_scene
from kinoedu.browser.bodies import BODIES, describe_bodies
from kinoedu.browser.scenes import pack_scene
from kinoedu.browser.wasm import write_scripts
from kinoedu.errors import KinoeduError
from kinoedu.messages import get_message
from kinoedu.planners.registry import PLANNERS

ROOM = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (5.0, 9.0), (0.0, 10.0)]
CONTROLS = {"step_size": 0.7, "nodes": 150}
PROBLEMS = 50  # of each body; the first seed of each problem is its number


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


def star(rng):
    """A simple polygon of three to eight corners."""
    angles = np.sort(rng.uniform(0.0, 2.0 * np.pi, rng.integers(3, 9)))
    reach = rng.uniform(0.4, 1.6, len(angles))
    return rng.uniform(2.0, 8.0, 2) + reach[:, None] * np.column_stack(
        [np.cos(angles), np.sin(angles)]
    )


def short_settings(problem, name):
    """The numbers that a body takes, with few nodes where there is no path."""
    few = {"max_nodes": 300.0, "max_iterations": 1000.0}
    numbers = list_settings(problem, name, CONTROLS)
    return [few.get(key, n) for key, n in zip(BODIES[name].settings, numbers, strict=True)]


def ask(name, problem, seed):
    """What a body shows, run by Python."""
    scene = pack_scene(make_problem_scene(problem))
    settings = np.array(short_settings(problem, name))
    return BODIES[name].function(scene, settings, np.random.default_rng(seed))


@pytest.mark.parametrize("name", BODIES)
def test_a_body_shows_what_the_board_shows(name):
    """The same layers, to the last bit, for 12 problems."""
    for seed in range(12):
        problem = make_problem(seed)
        keywords = {"step_size": 0.7, "max_nodes": 300, "max_iterations": 1000}
        keywords = {"n": 150} if name == "prm" else keywords
        drawing = draw_plan(PLANNERS[name].function(problem, rng=seed, **keywords))
        shown = ask(name, problem, seed)
        layers = [getattr(shown, look.field) for look in BODIES[name].layers]
        rows = [
            np.column_stack(
                [part for part in (layer.rows, layer.notes, layer.when) if part is not None]
            )
            for layer in drawing.layers
        ]
        for mine, theirs in zip(filter(len, layers), rows, strict=True):
            np.testing.assert_array_equal(mine, theirs)


def test_only_what_a_page_can_answer_is_called_live():
    """No body drives a car, plans on a bitmap, or among rooms."""
    problem = make_problem(1)
    assert describe_live(problem, "rrt", 0, CONTROLS)["body"] == "rrt"
    assert describe_live(problem, "own", 0, CONTROLS) is None
    rooms = ke.PolygonWorld(ROOM, [([(1, 1), (9, 1), (9, 8), (1, 8)], [[(2, 2), (8, 2), (8, 7)]])])
    bitmap = ke.Terrain(np.ones((5, 5), bool))
    for world, start in ((rooms, (7, 3)), (bitmap, (1.5, 1.5))):
        assert (
            describe_live(ke.Problem(ke.Point(), world, start, start), "rrt", 0, CONTROLS) is None
        )


def test_a_board_says_what_a_page_needs():
    """The planner shown, the seed, and settings for all planners that the page has."""
    board = ke.board(make_problem(1), "prm", samples=200, step_size=0.5, rng=4)
    (record,) = board.record()
    assert record["live"]["body"] == "prm" and record["live"]["seed"] == 4
    assert set(record["live"]["settings"]) == set(BODIES)
    assert record["live"]["settings"]["prm"] == [0.1, 200.0, 10.0]
    assert record["live"]["settings"]["rrt"][:2] == [0.1, 0.5]
    board.code.value = True
    board.planner.value = "rrt"
    assert "live" not in board.record()[0]
    assert set(ON_BOARD) - set(BODIES) <= {"astar"}


# ---- in Chromium


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A page with two boards, its scripts, and the modules."""
    needs_chromium()
    pytest.importorskip("ziglang", reason="the compiler of the site is not installed")
    place = tmp_path_factory.mktemp("page")
    write_scripts(place / "live")
    (place / "boards.js").write_text(page_script(describe_bodies()), encoding="utf-8")
    shutil.copy(CORE / "board.css", place)
    shutil.copy(BROWSER / "worker.js", place)
    world = ke.PolygonWorld(ROOM, [[(4, 0), (6, 0), (6, 8), (4, 8)], ((8, 5), 1)])
    problem = ke.Problem(ke.Point(), world, start=(1, 1), goal=(9, 1))
    boards = [ke.board(problem, "rrt", step_size=0.5), ke.board(problem, "prm", samples=200)]
    records = [json.dumps(pack_records(board.record())) for board in boards]
    text = "".join(
        '<div class="kinoedu-record"><p class="still"></p>'
        f'<script type="application/json">{record}</script></div>'
        for record in records
    )
    head = '<meta charset="utf-8"><link rel="stylesheet" href="board.css">'
    head += '<script src="boards.js" defer></script>'
    (place / "index.html").write_text(f"<!doctype html>{head}<body>{text}", encoding="utf-8")
    return place


@pytest.fixture
def page(folder):
    """The page, opened from the disk; nothing may be fetched and nothing fail."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
        opened = browser.new_page(viewport={"width": 760, "height": 1400})
        faults, asked = [], []
        opened.on("console", lambda message: faults.append(message.text))
        opened.on("pageerror", lambda error: faults.append(str(error)))
        opened.on("request", lambda request: asked.append(request.url))
        opened.goto((folder / "index.html").as_uri())
        opened.wait_for_selector(".kinoedu-board[data-paints]")
        yield opened
        assert faults == []
        assert all(url.startswith((folder.as_uri(), "blob:null/")) for url in asked)
        browser.close()


RUN = """([source, module, cases]) => new Promise((resolve) => {
    const worker = new Worker(URL.createObjectURL(new Blob([source])));
    const answers = [];
    worker.onmessage = ({ data }) => {
        const bytes = (numbers) => Array.from(new Uint8Array(numbers.buffer));
        answers.push(data.error ?? [data.facts.map(String),
            Object.values(data.layers).map(({ numbers }) => bytes(numbers))]);
        if (answers.length === cases.length) { worker.terminate(); resolve(answers); }
    };
    const letters = atob(module);
    worker.postMessage({ name: "body", module: Uint8Array.from(letters, (c) => c.charCodeAt(0)) });
    cases.forEach((one, k) => worker.postMessage({ ...one, name: "body", ask: k }));
})"""


@pytest.mark.parametrize("name", BODIES)
def test_webassembly_gives_the_same_bits(page, folder, name):
    """Every number of what 50 problems show, their worlds and random numbers included."""
    cases, wanted = [], []
    for seed in range(PROBLEMS):
        problem = make_problem(seed)
        settings = short_settings(problem, name)
        scene = make_problem_scene(problem)
        cases.append(
            {"scene": scene, "settings": settings, "seed": 1000 * seed + 2**31 * (seed % 2)}
        )
        shown = BODIES[name].function(
            pack_scene(scene), np.array(settings), np.random.default_rng(cases[-1]["seed"])
        )
        wanted.append([list(layer.tobytes()) for layer in shown[1:]])
    module = (folder / "live" / f"{name}.js").read_text(encoding="ascii").split('"')[3]
    assert base64.b64decode(module)[:4] == b"\0asm"
    source = (folder / "worker.js").read_text(encoding="utf-8")
    given = page.evaluate(RUN, [source, module, cases])
    assert [layers for _, layers in given] == wanted


def place_on_page(page, board, x, y):
    """Where a point of the world is on the page."""
    box = page.locator(".kinoedu-board canvas").nth(board).bounding_box()
    part = box["width"] - 16
    return box["x"] + 8 + part * x / 10.0, box["y"] + 8 + part * (1.0 - y / 10.0)


def drag(page, board, begin, end):
    """Drag from one point of the world to another."""
    page.mouse.move(*place_on_page(page, board, *begin))
    page.mouse.down()
    for part in np.linspace(0.0, 1.0, 6):
        page.mouse.move(
            *place_on_page(page, board, *(np.array(begin) * (1 - part) + np.array(end) * part))
        )
    page.mouse.up()


SAYS = """([board, text]) => document.querySelectorAll('.kinoedu-board')[board]
    ?.querySelector('[role=status]')?.textContent === text"""


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


def test_a_link_brings_the_same_world(page, folder):
    """A planner, a seed and what was moved are in the address; nonsense there is said."""
    drag(page, 1, (9, 1), (9, 8.5))
    page.locator(".kinoedu-live select").nth(1).select_option("rrt_connect")
    page.locator(".kinoedu-live button").nth(2).click()
    page.wait_for_function(
        "document.querySelectorAll('.kinoedu-board')[1].querySelector('[role=status]').textContent"
        ".startsWith('RRT-Connect')"
    )
    text = page.locator(".kinoedu-board [role=status]").nth(1).inner_text()
    page.locator(".kinoedu-live button").nth(3).click()
    address = page.evaluate("location.href")
    page.goto("about:blank")
    page.goto(address)
    page.wait_for_function(SAYS, arg=[1, text])
    page.goto("about:blank")
    page.goto((folder / "index.html").as_uri() + "#kinoedu=nonsense")
    page.wait_for_function(SAYS, arg=[0, get_message("live.bad_link")])

"""What is under the pointer, by mouse, keys and touch; dark pages; challenges: in a real browser.

The boards are shown as the site shows them, without a kernel.
"""

import base64
import io
import json
import re
import shutil
from contextlib import contextmanager

import numpy as np
import pytest
import trimesh
from lab_driver import keep
from PIL import Image
from test_board import walled
from test_challenges import SAMPLES

from kinoedu.boards import (
    Canvas,
    Drawing,
    board,
    bug_board,
    challenge,
    challenges,
    code_board,
    curves_board,
    race_board,
    search_board,
)
from kinoedu.boards.core.drawing import arrows, edges, labels, path
from kinoedu.boards.core.notes import note, with_notes
from kinoedu.boards.core.page_script import CORE, page_script
from kinoedu.boards.core.recorded import RECORD
from kinoedu.boards.core.scene import handle, make_scene
from kinoedu.boards.geometry.solid import SolidBoard
from kinoedu.figures import palette
from kinoedu.graphs import Graph
from kinoedu.messages import get_message

BIG = 10_000
# a notebook cuts off what is wider than its column, such as the right side of a frame
FRAMED = """[...document.querySelectorAll('.kinoedu-stage')].every(stage =>
    stage.getBoundingClientRect().right <= stage.parentElement.getBoundingClientRect().right)"""
BYTES = ("vertices", "faces", "colours")  # of a solid


def tree_of(n):
    """A board of one big tree: a random one, whose nodes are joined to near older ones."""
    rng = np.random.default_rng(0)
    nodes, parent = np.zeros((n, 2)), np.zeros(n, np.int64)
    for k in range(1, n):
        parent[k] = rng.integers(max(0, k - 2000), k)
        nodes[k] = np.clip(nodes[parent[k]] + rng.normal(0, 0.6, 2), -5, 5)
    segments = np.stack([nodes[parent[1:]], nodes[1:]], axis=1)
    numbers = np.arange(1, n)
    layer = edges(segments, "tree", width=0.5, when=numbers)
    layer = with_notes(layer, note("node", node=None), node=numbers, parent=parent[1:])
    drawing = Drawing([layer], text="a tree", total=n - 1, unit="nodes")
    return Canvas(make_scene((-5, -5), (5, 5)), lambda scene: drawing)


def two_lines(x):
    """A program for a code board."""
    y = 2 * x
    return y + x


def refused(problem):
    """A planner with one motion through the wall, and one out of the world."""
    problem.is_free_path((1, 5), (7, 5))
    problem.is_free_path((1, 5), (-1, 5))


def site_page(folder, theme, *boards):
    """A page with recorded boards, as the site has it."""
    records = [json.dumps(made._repr_mimebundle_()[0][RECORD]) for made in boards]
    parts = [
        f'<div class="kinoedu-record"><script type="application/json">{one}</script></div>'
        for one in records
    ]
    words = '<p>The <b class="ke-goal">goal</b></p>'
    (folder / "index.html").write_text(
        '<!doctype html><meta charset="utf-8"><meta name="viewport" content="width=device-width">'
        f'<link rel="stylesheet" href="board.css"><body data-theme="{theme}">{words}'
        f'{"".join(parts)}<script src="boards.js"></script>',
        encoding="utf-8",
    )
    (folder / "boards.js").write_text(page_script(), encoding="utf-8")
    shutil.copy(CORE / "board.css", folder)
    return (folder / "index.html").as_uri()


@pytest.fixture
def browser(chromium):
    """A page of a browser, made by what is asked of it; `page.errors` must stay empty."""

    @contextmanager
    def opened(**how):
        size = {"viewport": {"width": 900, "height": 900}}
        page = chromium.new_page(**{**size, **how})
        page.errors = []
        page.on("pageerror", lambda error: page.errors.append(str(error)))
        try:
            yield page
            assert page.errors == []
        finally:
            page.close()

    return opened


def shown(page, number=0):
    """A board that has its drawing."""
    made = page.locator(".kinoedu-record").nth(number)
    made.scroll_into_view_if_needed()
    root = made.locator(".kinoedu-board")
    page.wait_for_function(
        "root => root.dataset.answers > 0 && root.dataset.paints > 0", arg=root.element_handle()
    )
    return root


def frames(page):
    """Wait until what was asked for is painted."""
    page.evaluate(
        "() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))"
    )


def place(root, x, y):
    """A point of the page at a share of the picture."""
    box = root.locator("canvas").bounding_box()
    return box["x"] + x * box["width"], box["y"] + y * box["height"]


def pointed(page, root, x, y):
    """What a board says with the mouse at a share of its picture."""
    page.mouse.move(*place(root, x, y))
    frames(page)
    return root.get_attribute("data-pointed")


@pytest.fixture(scope="module")
def light(chromium, tmp_path_factory):
    """The page: a tree, a search, refused motions, and a big tree."""
    made = board(walled(), step_size=0.5)
    grid = search_board(np.ones((6, 8), bool), search="astar")
    own = board(walled(), planner=refused)
    sampled = challenge(SAMPLES(), challenges.in_the_largest_hole)
    folder = tmp_path_factory.mktemp("light")
    return site_page(folder, "light", made, grid, own, tree_of(BIG), sampled)


def test_a_node_says_its_cost_and_lights_its_branch(light, browser):
    """By the mouse; beside the tree nothing is said, and nothing when the mouse has left."""
    with browser() as page:
        page.goto(light)
        root = shown(page)
        before = root.locator("canvas").screenshot()
        texts = {pointed(page, root, 0.05 + 0.04 * k, y) for k in range(9) for y in (0.4, 0.8)}
        said = [text for text in texts if text]
        assert said and all(re.match(r"node \d+: [\d.]+ from the root, \d+ edges", t) for t in said)
        assert pointed(page, root, 0.5, 0.7) == ""  # in the wall
        assert pointed(page, root, 0.5, -0.3) == ""
        frames(page)
        assert root.locator("canvas").screenshot() == before


def test_cells_of_a_search_say_their_costs(light, browser):
    """At the last step expanded ones, at the first nothing is seen yet but the start."""
    with browser() as page:
        page.goto(light)
        root = shown(page, 1)
        assert re.match(
            r"node \d+ is expanded: g = .*, h = .*, f = ", pointed(page, root, 0.3, 0.5)
        )
        root.locator(".kinoedu-slider").fill("0")
        assert re.match(r"node \d+: not seen yet", pointed(page, root, 0.31, 0.5))
        keep(page, "pointed_grid")


def test_a_refused_motion_says_what_it_meets(light, browser):
    """The reason is not sent: the browser finds it in the scene."""
    with browser() as page:
        page.goto(light)
        root = shown(page, 2)
        assert pointed(page, root, 0.3, 0.5) == "motion 1 was refused: it meets obstacle 0"
        assert pointed(page, root, 0.06, 0.5) == "motion 2 was refused: it leaves the world"


def test_keys_go_from_node_to_node(light, browser):
    """Tab reaches it, arrows go on, Enter goes to the parent, Escape leaves; each is spoken."""
    with browser() as page:
        page.goto(light)
        root = shown(page)
        root.locator(".kinoedu-pointer").focus()
        frames(page)
        seen = [root.get_attribute("data-pointed")]
        for key in ("ArrowUp", "ArrowRight", "ArrowUp"):
            page.keyboard.press(key)
            frames(page)
            seen.append(root.get_attribute("data-pointed"))
        assert len(set(seen)) >= 3 and all(seen)
        assert root.locator(".kinoedu-state").inner_text() == seen[-1]
        edges_before = int(re.search(r"(\d+) edges", seen[-1])[1])
        page.keyboard.press("Enter")
        frames(page)
        edges_now = int(re.search(r"(\d+) edges", root.get_attribute("data-pointed"))[1])
        assert edges_now == edges_before - 1
        page.keyboard.press("Escape")
        frames(page)
        assert root.get_attribute("data-pointed") == ""


def test_a_touch_says_it_too(light, browser):
    """A tap shows what is there, and it stays."""
    with browser(has_touch=True, is_mobile=True, viewport={"width": 480, "height": 800}) as page:
        page.goto(light)
        root = shown(page, 1)
        page.touchscreen.tap(*place(root, 0.3, 0.5))
        frames(page)
        assert "is expanded" in root.get_attribute("data-pointed")
        assert page.evaluate("document.documentElement.scrollWidth") <= 480
        assert page.evaluate(FRAMED)
        keep(page, "pointed_touch")


# A board with a kernel that the test plays: it answers scenes from when `answering` is set.
WITH_KERNEL = """key => {
  const board = globalThis[Symbol.for("kinoedu.boards")].get(key), { model } = board;
  const plain = { layers: [], text: "", warning: "", total: 0, unit: "", step_texts: [], took: 1 };
  const drawing = { kind: "drawing", to: null, listing: null, places: [], ...plain };
  const answer = ({ kind, seq }) => {
    if (kind === "scene") board.receive({ ...drawing, seq }, []); };
  const values = { recorded: false }, sent = [];
  board.model = { get: name => values[name] ?? model.get(name), send: message => {
    sent.push(message);
    if (kernel.answering) queueMicrotask(() => answer(message)); } };
  const says = (more) => board.receive({ ...drawing, seq: board.seq, ...more }, []);
  globalThis.kernel = { board, values, sent, says, answering: false, start: () => {
    kernel.answering = true;
    sent.forEach(answer); } }; }"""
PLACES = "kernel.board.scene.handles.map(({ at }) => at)"
SET_SCENE = """places => {
  const scene = JSON.parse(JSON.stringify(kernel.board.scene));
  places.forEach((at, i) => { scene.handles[i].at = at; });
  kernel.values.scene = scene;
  kernel.board.replaced(); }"""


def test_what_is_dragged_is_not_put_back_by_a_scene_of_before(light, browser):
    """A scene that Python sets meanwhile moves the other things, and the drag is not lost."""
    with browser() as page:
        page.goto(light)
        root = shown(page)
        page.evaluate(WITH_KERNEL, "0-0")
        x, y = place(root, 0.89, 0.89)
        page.mouse.move(x, y)
        page.mouse.down()
        page.mouse.move(x - 50, y - 60, steps=5)
        goal = page.evaluate(PLACES)[1]
        assert goal != [9, 1]
        page.evaluate(SET_SCENE, [[2, 3], [9, 1]])
        assert page.evaluate(PLACES) == [[2, 3], goal]
        page.mouse.up()
        page.evaluate("kernel.start()")
        page.wait_for_function("kernel.sent.at(-1).kind === 'keep'")
        moved = page.evaluate("kernel.sent.filter(({ kind }) => kind === 'scene').at(-1).moved")
        assert moved == [["handle", 1, goal]] and page.evaluate(PLACES) == [[2, 3], goal]


def test_no_ring_stays_behind_what_is_dragged(light, browser):
    """The ring of the focus is at a thing; during a drag, which leaves it behind, there is none."""
    with browser() as page:
        page.goto(light)
        root = shown(page)
        page.evaluate(WITH_KERNEL, "0-0")
        page.evaluate("kernel.start()")
        page.mouse.move(*place(root, 0.3, 0.3))  # painted again, with buttons
        goal = root.locator(".kinoedu-thing[data-thing='handle-1']")
        goal.press("ArrowUp")
        shows = "button => Number(getComputedStyle(button).opacity)"
        assert goal.evaluate(shows) == 1
        box = goal.bounding_box()
        page.mouse.move(box["x"] + 14, box["y"] + 14)
        page.mouse.down()
        page.mouse.move(*place(root, 0.6, 0.6), steps=5)
        frames(page)
        assert page.evaluate("kernel.board.isDragged()") and goal.evaluate(shows) == 0
        page.mouse.up()
        page.wait_for_function(
            f"button => ({shows})(button) === 1", arg=goal.element_handle(), timeout=10_000
        )


def press_both_and_leave(page, x, y, away):
    """Drag from a point, press the right button too, and release the left outside a picture."""
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x - 20, y - 20, steps=3)
    page.mouse.down(button="right")
    page.mouse.up(button="right")
    page.mouse.move(*away, steps=3)
    page.mouse.up()


def test_nothing_sticks_to_a_pointer_without_a_button(light, browser):
    """A drag ends where the browser takes the pointer away, as at a press of the right button."""
    with browser() as page:
        page.goto(light)
        root = shown(page)
        page.evaluate(WITH_KERNEL, "0-0")
        page.evaluate("kernel.start()")
        press_both_and_leave(page, *place(root, 0.89, 0.89), place(root, 1.2, 0.5))
        page.wait_for_function("kernel.sent.at(-1)?.kind === 'keep'")
        goal = page.evaluate(PLACES)[1]
        page.mouse.move(*place(root, 0.3, 0.3), steps=3)
        assert page.evaluate(PLACES)[1] == goal != [9, 1]
        assert not page.evaluate("kernel.board.isDragged()")


SOLID = """([script, values, packed]) => {
  const bytes = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer;
  for (const [name, text] of Object.entries(packed)) values[name] = new DataView(bytes(text));
  const model = { get: name => values[name], on: () => {}, set: () => {}, save_changes: () => {} };
  const file = new Blob([script], { type: "text/javascript" });
  return import(URL.createObjectURL(file)).then(
    ({ default: { render } }) => { render({ model, el: document.body }); }); }"""


def test_a_solid_does_not_stick_to_a_pointer_without_a_button(browser):
    """The same on the board of solids."""
    made = SolidBoard(trimesh.creation.box((2, 2, 2)), None, 0.2, None)
    packed = {name: base64.b64encode(getattr(made, name)).decode() for name in BYTES}
    names = ("theta", "place", "section", "cut", "box", "palette", "words")
    with browser() as page:
        page.set_content(f"<style>{made._css}</style><body>")
        values = {name: getattr(made, name) for name in names}
        page.evaluate(SOLID, [made._esm, values, packed])
        root = page.locator(".kinoedu-solid")
        box = root.locator(".kinoedu-solid-mesh").bounding_box()
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        press_both_and_leave(page, x, y, (x, y + box["height"]))
        frames(page)
        before = root.get_attribute("data-azimuth")
        page.mouse.move(x + 30, y, steps=3)
        frames(page)
        assert root.get_attribute("data-azimuth") == before


def test_a_touch_that_the_browser_takes_over_is_no_click(tmp_path, browser):
    """The goal of a graph stays where it is."""
    made = search_board(Graph(nodes=[(0, 0), (4, 3), (8, 0)], edges=[(0, 1), (1, 2)]))
    with browser(has_touch=True) as page:
        page.goto(site_page(tmp_path, "light", made))
        root = shown(page)
        page.evaluate(WITH_KERNEL, "0-0")
        page.evaluate("kernel.start()")
        frames(page)
        goal, box = page.evaluate(PLACES)[1], root.locator("canvas").bounding_box()
        x, y = page.evaluate("[...kernel.board.views][0].toPixels([4, 3])")
        touch = page.context.new_cdp_session(page)
        for kind, points in (
            ("touchStart", [{"x": box["x"] + x, "y": box["y"] + y}]),
            ("touchCancel", []),
        ):
            touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
        page.wait_for_function("kernel.sent.at(-1)?.kind === 'keep'")
        assert page.evaluate(PLACES)[1] == goal != [4, 3]


# A second picture of the board, as a page with a kernel has it, at the top of a long page.
AGAIN = """() => {
  const { board } = kernel, place = document.createElement("div");
  document.body.append(place);
  document.body.style.paddingBottom = "2000px";
  globalThis.again = new ([...board.views][0].constructor)(board, place);
  place.scrollIntoView(); }"""
ON_PAGE = """at => {
  const { x, y } = again.canvas.getBoundingClientRect(), [px, py] = again.toPixels(at);
  return [x + px, y + py]; }"""


def swipe(page, x, y):
    """Move one finger up by 150 pixels."""
    touch = page.context.new_cdp_session(page)
    for k, kind in enumerate(["touchStart", *["touchMove"] * 6, "touchEnd"]):
        points = [] if kind == "touchEnd" else [{"x": x, "y": y - 25 * k}]
        touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
        frames(page)


def test_a_finger_on_the_ground_scrolls_and_one_on_a_thing_drags(light, browser):
    """On a telephone a board is as wide as the page, so there is no other place to scroll."""
    phone = {"has_touch": True, "is_mobile": True, "viewport": {"width": 360, "height": 640}}
    with browser(**phone, device_scale_factor=3) as page:
        page.goto(light)
        shown(page)
        page.evaluate(WITH_KERNEL, "0-0")
        page.evaluate("kernel.start()")
        page.evaluate(AGAIN)
        frames(page)
        begun, places = page.evaluate("scrollY"), page.evaluate(PLACES)
        swipe(page, *page.evaluate(ON_PAGE, [9, 1]))
        dragged = page.evaluate(PLACES)
        assert dragged[0] == places[0] and dragged[1][1] > places[1][1] + 2
        assert abs(page.evaluate("scrollY") - begun) < 40
        swipe(page, *page.evaluate(ON_PAGE, [2, 1]))
        assert page.evaluate("scrollY") > begun + 80
        assert page.evaluate(PLACES) == dragged


def test_an_arrow_with_another_key_is_the_browsers(light, browser):
    """Alt and an arrow goes back in the history; a key that is let go while Ctrl is held ends."""
    with browser() as page:
        page.goto(light)
        shown(page)
        page.evaluate(WITH_KERNEL, "0-0")
        page.evaluate(AGAIN)
        frames(page)
        page.evaluate("again.buttons.get('handle-1').focus()")
        for key in ("Alt+ArrowUp", "Control+ArrowLeft"):
            page.keyboard.press(key)
        assert page.evaluate(PLACES)[1] == [9, 1]
        page.keyboard.press("ArrowUp")
        assert page.evaluate(PLACES)[1] == [9, 1.1]
        page.evaluate("again.steered(again.growth); again.back.focus()")
        held = "[...kernel.board.held]"
        page.keyboard.down("ArrowUp")
        assert page.evaluate(held) == ["ArrowUp"]
        page.keyboard.down("Control")
        page.keyboard.up("ArrowUp")
        assert page.evaluate(held) == []


def test_a_plot_without_things_has_no_button_to_start_again(light, browser):
    """There is nothing in it to put back; the board that has things keeps the button."""
    with browser() as page:
        page.goto(light)
        shown(page)
        page.evaluate(WITH_KERNEL, "0-0")
        another = """bare => {
            const { board } = kernel, View = [...board.views][0].constructor;
            if (bare) Object.assign(board.scene, { handles: [], polygons: [], discs: [] });
            const view = new View(board, document.body), { hidden } = view.back;
            view.close();
            return hidden; }"""
        assert [page.evaluate(another, bare) for bare in (False, True)] == [False, True]


def test_the_plot_beside_a_refused_bug_is_pale(tmp_path, browser):
    """Both pictures show what was before; they take their colours again together."""
    made = bug_board((0, 4), (10, 4), [[(2, 2), (4, 2), (4, 6), (2, 6)]])
    with browser() as page:
        page.goto(site_page(tmp_path, "light", made))
        page.wait_for_function("document.querySelectorAll('[data-paints]').length === 2")
        plot = page.locator(".kinoedu-board canvas").nth(1)
        page.evaluate(WITH_KERNEL, "0-0")
        frames(page)
        before = plot.screenshot()
        page.evaluate("kernel.says({ warning: 'no' })")
        frames(page)
        assert plot.screenshot() != before
        page.evaluate("kernel.says({})")
        frames(page)
        assert plot.screenshot() == before


ANSWERED = """([number, more]) => {
  const lane = globalThis[Symbol.for("kinoedu.boards")].get(`0-${number}`);
  const plain = { layers: [], text: "", warning: "", total: 0, unit: "", step_texts: [], took: 1 };
  lane.receive({ kind: "drawing", to: null, seq: null, listing: null, places: [], ...plain,
    ...more }, []); }"""
STEPS = """() => [0, 1, 2].map((number) =>
  globalThis[Symbol.for("kinoedu.boards")].get(`0-${number}`).step)"""
LISTED = {"lines": ["x"], "ran": [0] * 9, "changes": [{}] * 9, "colours": {}}


def test_lanes_whose_answers_come_late_are_scrubbed_too(tmp_path, browser):
    """Each takes the step of those that have theirs; the lane with code, which keeps its step when
    something is dragged, takes the others along.
    """
    with browser() as page:
        page.goto(site_page(tmp_path, "light", race_board(walled(), nodes=60)))
        page.wait_for_function("document.querySelectorAll('[data-paints]').length === 3")

        def answer(*numbers, **more):
            for number in numbers:
                page.evaluate(ANSWERED, [number, more])

        answer(0, 1, 2, brief=True, total=5)
        answer(0, total=9)
        page.evaluate("globalThis[Symbol.for('kinoedu.boards')].get('0-0').growTo(4)")
        assert page.evaluate(STEPS) == [4, 5, 5]
        answer(1, 2, total=9)
        assert page.evaluate(STEPS) == [4, 4, 4]
        answer(0, 1, 2, brief=True, total=5)
        answer(0, 1, 2, total=9)
        assert page.evaluate(STEPS) == [9, 9, 9]
        answer(1, total=9, listing=LISTED)
        page.evaluate("globalThis[Symbol.for('kinoedu.boards')].get('0-0').growTo(4)")
        answer(0, 1, 2, brief=True, total=5)
        answer(0, total=8)
        answer(2, total=8)
        answer(1, total=8, listing=LISTED)
        assert page.evaluate(STEPS) == [4, 4, 4]


def test_a_board_that_changes_no_longer_says_that_it_is_copied(light, browser):
    """The whole of the same drawing, which comes when all is at rest, changes nothing."""
    with browser() as page:
        page.goto(light)
        button = shown(page).locator(".kinoedu-copy")
        page.evaluate(WITH_KERNEL, "0-0")
        copy = button.text_content()
        page.evaluate("kernel.says({ brief: true })")
        page.evaluate("kernel.board.copy('board(problem)')")
        page.evaluate("kernel.says({})")
        copied = button.text_content()
        page.evaluate("kernel.says({ brief: true })")
        assert [copied, button.text_content()] == ["copied", copy] != [copy, copy]


def test_a_board_whose_kernel_was_restarted_says_so(light, browser):
    """It asks the lost Python nothing, and does not say that it plans."""
    with browser() as page:
        page.goto(light)
        shown(page)
        page.evaluate(WITH_KERNEL, "0-0")
        sent, *texts = page.evaluate(
            """() => {
            const heard = {}, on = (event, hear) => { heard[event] = hear; };
            const board = new kernel.board.constructor({ ...kernel.board.model, on });
            const say = () => {
              board.hasMoved({ kind: "handle", i: 1 });
              board.pendingSince = -Infinity;   // it waits since long ago
              return board.text(); };
            const before = say(), count = kernel.sent.length;
            heard.comm_live_update();
            board.open = board.asked = 0;
            const after = say();
            board.stop();
            return [kernel.sent.length - count, before, after]; }"""
        )
        assert sent == 0
        assert texts == [get_message(f"board.front.{name}") for name in ("thinking", "lost")]


def test_a_board_whose_kernel_was_shut_down_says_so(light, browser):
    """JupyterLab then refuses to send; a board that went on would say for ever that it plans."""
    with browser() as page:
        page.goto(light)
        shown(page)
        page.evaluate(WITH_KERNEL, "0-0")
        tried, text = page.evaluate(
            """() => {
            let tried = 0;
            const send = ({ kind }) => {
              if (kind === "hello") return;
              tried += 1;
              throw new Error("Cannot send"); };
            const on = () => {}, model = { ...kernel.board.model, on, send };
            globalThis.reportError = () => {};
            const board = new kernel.board.constructor(model);
            const say = () => {
              board.hasMoved({ kind: "handle", i: 1 });
              board.pendingSince = -Infinity;   // it waits since long ago
              return board.text(); };
            const text = (say(), say());
            board.stop();
            return [tried, text]; }"""
        )
        assert tried == 1 and text == get_message("board.front.lost")


def test_nothing_dead_is_offered_beside_a_refused_scene(light, browser):
    """What was answered briefly before has no steps: the slider comes back with the next answer."""
    with browser() as page:
        page.goto(light)
        slider = shown(page).locator(".kinoedu-slider")
        page.evaluate(WITH_KERNEL, "0-0")
        page.evaluate("kernel.says({ brief: true, total: 5 })")
        frames(page)
        assert slider.is_visible()
        page.evaluate("kernel.says({ warning: 'no' })")
        frames(page)
        assert not slider.is_visible()
        page.evaluate("kernel.says({ brief: true, total: 5 })")
        page.evaluate("kernel.says({ total: 5 })")
        frames(page)
        assert slider.is_visible() and slider.get_attribute("max") == "5"
        page.evaluate("kernel.says({ warning: 'no' })")  # beside a whole one it can be used
        frames(page)
        assert slider.is_visible()


def test_ten_thousand_nodes_stay_usable(light, browser):
    """Twenty places are pointed at and painted in less than 0.2 s each."""
    with browser() as page:
        page.goto(light)
        root = shown(page, 3)
        said = 0
        box = root.locator("canvas").bounding_box()
        page.evaluate("window.began = performance.now()")
        for k in range(20):
            page.mouse.move(
                box["x"] + box["width"] * (0.3 + 0.02 * k), box["y"] + 0.5 * box["height"]
            )
            frames(page)
            said += bool(root.get_attribute("data-pointed"))
        took = page.evaluate("performance.now() - window.began") / 20
        print(f"{took:.0f} ms a place")
        assert said >= 15 and took < 200


def test_challenges_stand_below_the_picture(light, browser):
    """Without a kernel nobody judges, so only the sentence is shown."""
    with browser() as page:
        page.goto(light)
        root = shown(page, 4)
        text = root.locator(".kinoedu-goals").inner_text()
        assert text.startswith("☆ Challenge, optional: drag q") and "Not yet" not in text


FREE_PIXEL = """() => { const canvas = document.querySelector('.kinoedu-board canvas');
    const data = canvas.getContext('2d').getImageData(
        canvas.width * 0.75, canvas.height * 0.6, 1, 1).data;
    return [...data].slice(0, 3); }"""


@pytest.mark.parametrize(
    ("theme", "prefers", "expected"),
    [
        ("dark", "light", "dark"),
        ("light", "dark", "light"),
        ("auto", "dark", "dark"),
        ("auto", "light", "light"),
    ],
)
def test_boards_and_words_follow_the_page(tmp_path, theme, prefers, expected, browser):
    """The free ground has the colour of the theme, and so has the line under a word."""
    address = site_page(tmp_path, theme, board(walled(), step_size=0.5))
    with browser(color_scheme=prefers) as page:
        page.goto(address)
        root = shown(page)
        assert root.get_attribute("data-theme") == expected
        colours = palette.THEMES[expected]
        pixel = page.evaluate(FREE_PIXEL)
        assert "#" + "".join(f"{level:02X}" for level in pixel) == colours["free"]
        line = page.evaluate(
            "getComputedStyle(document.querySelector('.ke-goal')).borderBottomColor"
        )
        red, green, blue = (int(part) for part in re.findall(r"\d+", line))
        assert f"#{red:02X}{green:02X}{blue:02X}" == colours["goal"]


PRINTED = f"""() => {{ const pixel = {FREE_PIXEL}, seen = [pixel()];
    for (const kind of ["beforeprint", "afterprint"]) {{
        dispatchEvent(new Event(kind));
        seen.push(pixel());
    }}
    return seen; }}"""


@pytest.mark.parametrize("theme", ["dark", "auto"])
def test_a_dark_page_prints_light_boards(tmp_path, theme, browser):
    """The picture is light as soon as the page is to be printed, and dark again afterwards."""
    with browser(color_scheme="dark") as page:
        page.goto(site_page(tmp_path, theme, board(walled(), step_size=0.5)))
        root = shown(page)
        dark, light = (
            [int(palette.THEMES[name]["free"][k : k + 2], 16) for k in (1, 3, 5)]
            for name in ("dark", "light")
        )
        frames(page)
        assert page.evaluate(PRINTED)[:2] == [dark, light]
        frames(page)
        assert page.evaluate(FREE_PIXEL) == dark
        page.emulate_media(media="print", color_scheme="dark")
        frames(page)
        assert page.evaluate(FREE_PIXEL) == light
        assert root.get_attribute("data-theme") == "light"
        line = page.evaluate(
            "getComputedStyle(document.querySelector('.ke-goal')).borderBottomColor"
        )
        goal = palette.THEMES["light"]["goal"]
        assert line == f"rgb({int(goal[1:3], 16)}, {int(goal[3:5], 16)}, {int(goal[5:], 16)})"
        page.emulate_media(media="screen", color_scheme="dark")
        frames(page)
        assert page.evaluate(FREE_PIXEL) == dark


def test_a_word_of_the_lesson_lights_what_it_names(light, browser):
    """All else is pale meanwhile; where nothing has its colour, nothing changes."""
    with browser() as page:
        page.goto(light)
        root = shown(page)
        root.scroll_into_view_if_needed()
        picture = root.locator("canvas")
        before = picture.screenshot()
        page.locator(".ke-goal").hover()
        frames(page)
        lit = picture.screenshot()
        page.mouse.move(1, 1)
        frames(page)
        assert lit != before and picture.screenshot() == before
        page.evaluate("document.querySelector('.ke-goal').className = 'ke-frontier'")
        page.locator(".ke-frontier").hover()
        frames(page)
        assert picture.screenshot() == before


WRITTEN = """window.written = {};
    const write = CanvasRenderingContext2D.prototype.strokeText;
    CanvasRenderingContext2D.prototype.strokeText = function (text, x, y) {
        written[text] = [this.textAlign, y];
        write.call(this, text, x, y);
    };"""


def test_names_keep_off_paths_and_arrows(tmp_path, browser):
    """Each stands to the upper right, unless a path or an arrow passes there; 30 pixels lower, and
    then to the left. Where lines pass on all sides it keeps off the path.
    """
    spots = {"A": (1, 5), "B": (3, 5), "C": (5, 5), "D": (7, 5)}
    spots |= {"E": (3, 8), "F": (1, 8), "G": (5, 2), "H": (1, 2)}
    scene = make_scene(
        (0, 0), (10, 10), handles=[handle(*one, colour="goal") for one in spots.items()]
    )
    ways = [
        path([(3, 5), (4.5, 6)], "path"),
        arrows([(5, 5), (7, 5)], [(1, 0.7), (1, -0.7)], "tree"),
        path([(7, 5), (8, 5.7)], "path"),
        edges([[(3, 8), (3.5, 8.5)], [(3.5, 8.5), (4, 9)]], "path", when=[0, 1]),  # it grows
        path([(5, 2), (6.5, 3)], "path"),
        *(path([(5, 2), to], "tree") for to in [(6.5, 1), (3.5, 3), (3.5, 1)]),
    ]
    named = Canvas(scene, lambda _: Drawing(ways, text="eight names", total=1))
    address = site_page(tmp_path, "light", named)
    with browser() as page:
        page.add_init_script(WRITTEN)
        page.goto(address)
        shown(page)
        written = page.evaluate("written")
    as_high = {"A": "ABCD", "F": "EF", "H": "GH"}
    levels = {name: written[one][1] for one in "AFH" for name in as_high[one]}
    assert {name: [align, y - levels[name]] for name, (align, y) in written.items()} == {
        "A": ["left", 0],
        "B": ["left", 30],
        "C": ["left", 30],
        "D": ["right", 0],
        "E": ["left", 30],
        "F": ["left", 0],
        "G": ["left", 30],
        "H": ["left", 0],
    }


def test_a_label_stands_nearest_to_its_own_point(tmp_path, browser):
    """The first spot of the first label would cover the second point, and its next, below, would be
    nearer to that than to its own; so it stands to the left.
    """
    scene = make_scene((0, 0), (10, 10))
    texts = labels([(5, 5), (5.5, 5), (8, 5)], ["first label", "second", "third"], "ink")
    address = site_page(tmp_path, "light", Canvas(scene, lambda _: Drawing([texts], text="three")))
    with browser() as page:
        page.add_init_script(WRITTEN)
        page.goto(address)
        shown(page)
        written = page.evaluate("written")
    level = written["third"][1]
    assert {text: [align, y - level] for text, (align, y) in written.items()} == {
        "first label": ["right", 0],
        "second": ["left", 0],
        "third": ["left", 0],
    }


def test_a_word_is_chosen_by_keys(light, browser):
    """Tab comes to it from the top of the page; the next Tab leaves it."""
    with browser() as page:
        page.goto(light)
        root = shown(page)
        before = root.locator("canvas").screenshot()
        for expected in ("goal", ""):
            page.keyboard.press("Tab")
            frames(page)
            assert root.get_attribute("data-word") == expected
            assert root.locator("canvas").screenshot() != before  # the next has a ring


def test_a_page_that_turns_dark_takes_its_boards_along(light, browser):
    with browser() as page:
        page.goto(light)
        root = shown(page)
        before = root.locator("canvas").screenshot()
        page.evaluate("document.body.dataset.theme = 'dark'")
        frames(page)
        assert root.get_attribute("data-theme") == "dark"
        assert root.locator("canvas").screenshot() != before
        for theme, text, expected in (
            ("vscode-dark", "#d4d4d4", "dark"),
            ("vscode-light", "#3b3b3b", "light"),
            ("vscode-high-contrast", "#ffffff", "dark"),
            ("vscode-high-contrast vscode-high-contrast-light", "#292929", "light"),
        ):  # VS Code names its theme so, and gives its colours by variables
            page.evaluate(
                """([theme, text]) => { document.body.className = theme;
                delete document.body.dataset.theme;
                document.body.style.setProperty("--vscode-editor-foreground", text); }""",
                [theme, text],
            )
            page.wait_for_function(
                "theme => document.querySelector('.kinoedu-board').dataset.theme === theme",
                arg=expected,
            )
            channels = ", ".join(str(int(text[k : k + 2], 16)) for k in (1, 3, 5))
            assert root.evaluate("root => getComputedStyle(root).color") == f"rgb({channels})"


# Chromium without a window does not tell a page that its zoom has changed; the test does.
RATIOS = """window.ratios = [];
    const match = window.matchMedia;
    window.matchMedia = (query) => {
      if (!query.includes("resolution")) return match.call(window, query);
      ratios.push(new EventTarget());
      return ratios.at(-1); };"""


def test_a_page_that_is_zoomed_has_sharp_boards(light, browser):
    """More than once, though the size of the board stays the same."""
    with browser() as page:
        page.add_init_script(RATIOS)
        page.goto(light)
        canvas = shown(page).locator("canvas")
        screen = page.context.new_cdp_session(page)
        size = {"width": 900, "height": 900, "mobile": False}
        wide = canvas.evaluate("canvas => canvas.width")
        for ratio in (2, 1, 1.5):
            screen.send("Emulation.setDeviceMetricsOverride", {**size, "deviceScaleFactor": ratio})
            page.evaluate("[...ratios].forEach(one => one.dispatchEvent(new Event('change')))")
            frames(page)
            assert canvas.evaluate("canvas => canvas.width") == ratio * wide


BOX = (0, 0), (4, 4)
BARS = """() => [...document.querySelectorAll(".kinoedu-line")].map((line) => {
    const { borderLeftWidth, borderLeftStyle } = getComputedStyle(line), range = new Range();
    range.selectNodeContents(line);
    return [line.matches(".kinoedu-lit"), borderLeftWidth, borderLeftStyle,
      range.getBoundingClientRect().left]; })"""


def test_the_lit_line_has_a_bar_also_without_colours(tmp_path, browser):
    """Where the system forces its colours no other line has one, and no line moves aside."""
    with browser(forced_colors="active") as page:
        page.goto(site_page(tmp_path, "light", code_board(two_lines, 1.0, window=BOX)))
        shown(page)
        lines = page.evaluate(BARS)
        assert [one[1:3] for one in lines if one[0]] == [["4px", "solid"]]
        assert all(one[1] == "0px" for one in lines if not one[0])
        assert lines[1][3] == lines[2][3]  # both are indented once


def test_code_is_read_from_the_left_on_every_page(tmp_path, browser):
    """Also where the language is not: else a colon at the end of a line stands before it."""
    with browser() as page:
        page.goto(site_page(tmp_path, "light", code_board(two_lines, 1.0, window=BOX)))
        root = shown(page)
        page.evaluate("document.documentElement.dir = 'rtl'")
        assert root.locator(".kinoedu-text").evaluate("e => getComputedStyle(e).direction") == "rtl"
        for part in (".kinoedu-line >> nth=0", ".kinoedu-values", ".kinoedu-growth"):
            found = root.locator(part)
            assert found.evaluate("e => getComputedStyle(e).direction") == "ltr"


LATE = """
const append = Element.prototype.append;
Element.prototype.append = function (...nodes) {
  if (nodes[0]?.className !== "kinoedu-row") return append.apply(this, nodes);
  setTimeout(() => append.apply(this, nodes), 100); };"""


def test_a_board_that_enters_a_page_late_takes_its_theme(tmp_path, browser):
    """VS Code and JupyterLab make a widget first, and then put it into the page."""
    with browser() as page:
        page.add_init_script(LATE)
        page.goto(site_page(tmp_path, "dark", board(walled(), step_size=0.5)))
        assert shown(page).get_attribute("data-theme") == "dark"


IN_VS_CODE = """<style>.cell-output-ipywidget-background { background: white !important; }
body { --vscode-editor-foreground: #cccccc; --jp-widgets-label-color: black; }
.widget-label { color: var(--jp-widgets-label-color); }</style><body class="vscode-dark">
<div class="cell-output-ipywidget-background"><label class="widget-label">a</label>BOARD</div>
<div class="cell-output-ipywidget-background"><label class="widget-label">a</label></div>"""
COLOURS = """() => [...document.querySelectorAll(".cell-output-ipywidget-background")].map(
    output => [getComputedStyle(output).backgroundColor,
               getComputedStyle(output.firstChild).color])"""


@pytest.mark.parametrize("kind", ["board", "solid"])
def test_a_board_in_vs_code_stands_on_the_page_and_not_on_white(kind, browser):
    """VS Code puts each output with a widget on white; those of others stay so."""
    style = {"board": Canvas, "solid": SolidBoard}[kind]._css
    made = IN_VS_CODE.replace("BOARD", f'<div class="kinoedu-{kind}"></div>')
    with browser() as page:
        page.set_content(f"<style>{style}</style>{made}")
        ours, other = page.evaluate(COLOURS)
        assert ours == ["rgba(0, 0, 0, 0)", "rgb(204, 204, 204)"]
        assert other == ["rgb(255, 255, 255)", "rgb(0, 0, 0)"]


def test_the_colours_of_words_are_those_of_the_palette():
    """The style sheet repeats them, since pages do not run Python."""
    text = (CORE / "board.css").read_text(encoding="utf-8")
    rules = re.findall(
        r"\.ke-([\w-]+) {.*?--kinoedu-lit, (#\w+)\) var\(--kinoedu-dim, (#\w+)", text
    )
    assert {name for name, _, _ in rules} >= {
        "start",
        "goal",
        "tree",
        "frontier",
        "path",
        "roadmap",
    }
    for name, light_colour, dark_colour in rules:
        key = name.replace("-", "_")
        assert light_colour == palette.THEMES["light"][key]
        assert dark_colour == palette.THEMES["dark"][key]


SHARE_OF_DASHES = """canvas => {
  const { width, height } = canvas, pen = canvas.getContext("2d");
  const { data } = pen.getImageData(0, 0, width, height);
  const rows = [...Array(height).keys()].map((y) => [...Array(width).keys()].filter((x) => {
    const k = 4 * (y * width + x);
    return data[k] === 0xE6 && data[k + 1] === 0x9F && data[k + 2] === 0;
  }));
  const row = rows.reduce((best, one) => (one.length > best.length ? one : best));
  return row.length / (row.at(-1) - row[0] + 1); }"""


def test_what_is_driven_backwards_is_dashed(tmp_path, browser):
    """Its dashes go on from one of its short segments to the next; a picture has the same."""
    made = curves_board((0, 0, 0), (-80, 0, 0), 20)
    with browser() as page:
        page.goto(site_page(tmp_path, "light", made))
        assert 0.4 < shown(page).locator("canvas").evaluate(SHARE_OF_DASHES) < 0.8
    levels = np.asarray(Image.open(io.BytesIO(made.picture())).convert("RGB"))
    row = max((levels == (0xE6, 0x9F, 0)).all(axis=2), key=np.count_nonzero)
    there = np.flatnonzero(row)
    assert 0.4 < len(there) / (there[-1] - there[0] + 1) < 0.8

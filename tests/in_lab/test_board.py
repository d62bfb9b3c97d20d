"""Boards in a real JupyterLab: dragging, answers, and use without a mouse."""

import json
import re

import pytest
from lab_driver import keep

YARD = """
import kinoedu as ke
left = [(2, 3), (3.5, 2.6), (3.9, 6.5), (2.4, 6.1)]
right = [(5, 0.6), (6.2, 0.9), (6, 4.4), (5.2, 4.6)]
world = ke.PolygonWorld([(0, 0), (12, 0), (12, 9), (0, 9)], [left, right, ((10, 6.2), 0.9)])
yard = ke.Problem(ke.Point(), world, (1, 1), (11, 8))
board = ke.board(yard)
board
"""
HANGS = """
def hangs(problem):
    while not problem.is_free_path(problem.start, problem.goal):
        pass
    return [problem.start, problem.goal]
ke.board(yard, planner=hangs)
"""
SLOW = """
import time
def slow(problem):
    time.sleep(1.1)
    return None
ke.board(yard, planner=slow)
"""
DISTANCE = "ke.boards.distance_board([(2, 1), (6, 1), (7, 4), (4, 3), (2, 5)], q=(8, 6))"


@pytest.fixture(scope="module")
def page(run_in_lab):
    """One notebook for all: the yard twice, a planner that hangs, distances, a slow planner."""
    with run_in_lab(YARD, "board", HANGS, DISTANCE, SLOW) as page:
        yield page


class Seen:
    """One board on the page."""

    def __init__(self, page, number):
        self.page, self.board = page, page.locator(".kinoedu-board").nth(number)
        self.board.scroll_into_view_if_needed()
        self.until("root.dataset.answers > 0")

    def until(self, condition, **values):
        """Wait for a condition on `root`, the board's element, its `text`, and given values."""
        names = ", ".join(values)
        self.page.wait_for_function(
            f"([root, {{{names}}}]) => {{ const text = "
            f"root.querySelector('.kinoedu-text').textContent; return {condition}; }}",
            arg=[self.board.element_handle(), values],
            timeout=120_000,
        )

    def settled(self):
        """Wait until every change is painted and answered."""
        self.page.evaluate(
            "() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))"
        )
        self.until("root.dataset.seq === root.dataset.newest && root.dataset.seq > 0")

    def shown_text(self):
        return self.board.locator(".kinoedu-text").inner_text()

    def data(self, name):
        return self.board.get_attribute(f"data-{name}")

    def pixels(self):
        return self.board.locator("canvas").screenshot()

    def label(self, thing):
        return self.board.locator(f"[data-thing={thing}]").get_attribute("aria-label")

    def middle(self, thing):
        box = self.board.locator(f"[data-thing={thing}]").bounding_box()
        return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    def drag(self, thing, dx, dy, *, release=True):
        """Drag a thing by so many pixels, in ten moves, until the last is answered."""
        x, y = self.middle(thing)
        self.page.mouse.move(x, y)
        self.page.mouse.down()
        self.page.mouse.move(x + dx, y + dy, steps=10)
        if release:
            self.page.mouse.up()
            self.settled()


@pytest.fixture
def yard(page):
    """The yard, reset."""
    seen = Seen(page, 0)
    seen.board.locator(".kinoedu-reset").click()
    seen.settled()
    return seen


@pytest.mark.parametrize("thing", ["handle-1", "handle-0", "polygon-0", "disc-0"])
def test_dragging_plans_anew(yard, thing):
    """During a drag new plans arrive in order, and the picture and the label change."""
    answers, pixels, label = int(yard.data("answers")), yard.pixels(), yard.label(thing)
    yard.drag(thing, -25, 10, release=False)
    yard.until(
        "root.dataset.answers > answers && root.dataset.seq === root.dataset.newest",
        answers=answers,
    )  # still held
    yard.page.mouse.up()
    yard.drag(thing, -20, 10)
    assert yard.pixels() != pixels and yard.label(thing) != label
    assert yard.data("stale") == "0" and "a path of length" in yard.shown_text()


def test_a_drag_leaves_the_icon_of_the_tab(yard, page):
    """JupyterLab would fetch another with each question. Afterwards it can change it again."""
    icons, requested = "document.querySelectorAll('link.favicon').length", []

    def note(request):
        requested.append(request.url)

    page.wait_for_function(f"{icons} > 0")
    page.on("request", note)
    yard.drag("handle-1", -60, 60, release=False)
    yard.settled()
    page.remove_listener("request", note)
    page.mouse.up()
    assert [url for url in requested if "favicon" in url] == []
    page.wait_for_function(f"{icons} > 0")


def test_a_drag_leaves_the_tool_bar(yard, page):
    """JupyterLab would look through it with each question, and does so once when they are over."""
    bar = "document.querySelector('.jp-NotebookPanel-toolbar')"
    yard.board.evaluate(
        f"""board => {{
            const bar = {bar}, looks = bar.childItemsChanged;
            window.looked = 0;
            Object.getPrototypeOf(bar).childItemsChanged = function () {{
                window.looked += 1;
                looks.call(this);
            }};
            window.idle = [];
            board.addEventListener('kinoedu-sent',
                () => idle.push(Object.hasOwn(bar, 'childItemsChanged')));
        }}"""
    )
    yard.drag("handle-1", -60, 60)
    sent = page.evaluate("idle")
    assert sent and all(sent)  # its own method is set aside at each question
    page.wait_for_function(f"!Object.hasOwn({bar}, 'childItemsChanged') && looked > 0")


def test_the_scene_is_kept_in_the_notebook(yard, page):
    """A released thing's place is in Python, and a second view shows the same."""
    yard.drag("handle-1", -60, 10)
    other, label = Seen(page, 1), yard.label("handle-1")
    other.until("root.querySelector('[data-thing=handle-1]').ariaLabel === label", label=label)
    assert other.shown_text() == yard.shown_text()
    script = """async () => {
        const kernel = jupyterapp.shell.currentWidget.sessionContext.session.kernel; let text = '';
        const code = "print(board.canvas.scene['handles'][1]['at'], board.plan.path[-1].tolist())";
        const future = kernel.requestExecute({code});
        future.onIOPub = m => { text += m.content.text ?? ''; };
        await future.done; return text; }"""
    scene, goal = json.loads(f"[{page.evaluate(script).replace('] [', '], [')}]")
    assert scene == goal
    assert label == f"goal at ({scene[0]:.2f}, {scene[1]:.2f})"


def test_a_vertex_is_dragged_and_a_crossing_told(yard):
    """A vertex across the opposite edge gives a warning over the last plan; back again, a plan."""
    yard.board.locator("[data-thing=polygon-0]").focus()
    yard.page.keyboard.press("Enter")
    yard.drag("vertex-0-0-0", 0, -250, release=False)
    yard.until(
        "root.dataset.warning.includes('crosses or touches itself')"
        " && root.dataset.refused === 'true'"
    )
    assert "obstacle 0" in yard.shown_text() and yard.data("layers") == "edges path"
    keep(yard.page, "warning")
    x, y = yard.middle("vertex-0-0-0")
    yard.page.mouse.move(x, y + 250, steps=5)
    yard.page.mouse.up()
    yard.until("root.dataset.warning === '' && root.dataset.refused === 'false'")
    assert "a path of length" in yard.shown_text()


def test_the_growth_is_scrubbed_and_played(yard):
    """The slider shows earlier trees; playing goes to the end by itself."""
    whole, pixels = int(yard.data("total")), yard.pixels()
    slider = yard.board.locator(".kinoedu-slider")
    slider.focus()
    for _ in range(5):
        slider.press("ArrowLeft")
    yard.until("text === words", words=f"{whole - 5} of {whole} nodes")
    assert yard.pixels() != pixels
    slider.press("Home")
    yard.until("root.dataset.step === '0'")
    yard.board.locator(".kinoedu-play").click()
    yard.until("root.dataset.step > 0 && root.dataset.step < root.dataset.total")
    yard.until("root.dataset.step === root.dataset.total && text.includes('a path of length')")


def test_reduced_motion_steps_and_does_not_play(yard):
    """Readers who prefer reduced motion press a button for each step."""
    yard.page.emulate_media(reduced_motion="reduce")
    try:
        yard.board.locator(".kinoedu-slider").press("Home")
        button = yard.board.locator(".kinoedu-play")
        yard.until(
            "root.querySelector('.kinoedu-play').textContent === 'next step' && root.dataset.step "
            "=== '0'"
        )
        button.click()
        yard.until("root.dataset.step > 0")
        step = yard.data("step")
        yard.page.wait_for_timeout(300)
        assert yard.data("step") == step and int(step) < int(yard.data("total"))
    finally:
        yard.page.emulate_media(reduced_motion="no-preference")


def test_everything_is_reached_by_keyboard(yard):
    """Tab, arrow keys, Enter to vertices, Escape back; the text is read out when quiet."""
    keys = yard.page.keyboard
    yard.board.locator("[data-thing=handle-0]").focus()
    focus = "document.activeElement.dataset.thing"
    keys.press("Tab")
    assert yard.page.evaluate(focus) == "handle-1"
    assert yard.label("handle-1") == "goal at (11.00, 8.00)"
    keys.press("ArrowLeft")
    keys.press("Shift+ArrowDown")
    yard.until("root.querySelector('[data-thing=handle-1]').ariaLabel === 'goal at (10.88, 7.40)'")
    yard.settled()
    keys.press("Tab")
    assert yard.label("polygon-0").endswith("press Enter to reach its vertices")
    keys.press("Enter")
    assert yard.page.evaluate(focus) == "vertex-0-0-0"
    keys.press("ArrowUp")
    yard.until(
        "root.querySelector('[data-thing=vertex-0-0-0]').ariaLabel.startsWith('obstacle 0, vertex "
        "0, at (2.00, 3.12)')"
    )
    keys.press("Tab")
    assert yard.page.evaluate(focus) == "vertex-0-0-1"
    keys.press("Escape")
    assert yard.page.evaluate(focus) == "polygon-0"
    yard.until(
        "root.querySelector('[role=status]').textContent === text && "
        "root.querySelector('canvas').ariaLabel === text"
    )
    assert yard.page.evaluate("jupyterapp.shell.currentWidget.content.mode") is not None


def test_the_controls_are_used_by_keys(yard):
    """Arrow keys are theirs, not the notebook's; sliders have names, and all show their focus."""
    controls = yard.page.locator(".kinoedu-framed").first
    menu, slider = controls.locator("select"), controls.locator(".noUi-handle").first
    assert [one.get_attribute("aria-label") for one in controls.locator(".noUi-handle").all()] == [
        one.inner_text() for one in controls.locator(".widget-hslider .widget-label").all()
    ]
    menu.focus()
    yard.page.keyboard.press("ArrowDown")
    yard.until("text.startsWith('RRT-Connect')")
    yard.page.keyboard.press("ArrowUp")
    yard.until("text.startsWith('RRT:')")
    yard.page.keyboard.press("Tab")
    yard.page.keyboard.press("ArrowRight")
    yard.page.wait_for_function("() => document.activeElement.ariaValueNow === '1.0'")
    assert slider.evaluate("e => e === document.activeElement")
    assert slider.evaluate("e => getComputedStyle(e).outline").endswith("solid 3px")
    yard.page.keyboard.press("ArrowLeft")
    yard.settled()


def test_a_hanging_planner_ends_with_a_message(page):
    """It is run again when the goal is released or rests, and works once the planner does."""
    hangs = Seen(page, 2)
    hangs.until("text.includes('It was stopped; the picture')")
    answers = int(hangs.data("answers"))
    hangs.drag("handle-1", 0, 60)
    assert int(hangs.data("answers")) > answers
    assert "It was stopped; the picture" in hangs.shown_text()
    x, y = hangs.middle("handle-0")
    there = hangs.middle("handle-1")
    hangs.drag("handle-1", x + 60 - there[0], y - there[1])
    hangs.until("text.startsWith('yours: length')")


def test_a_slow_planner_is_asked_when_the_held_thing_rests(page):
    """A board whose answers take a second does not wait for the release."""
    seen = Seen(page, 4)
    answers = int(seen.data("answers"))
    seen.drag("handle-1", -40, 20, release=False)
    seen.until(
        "root.dataset.answers > answers && root.dataset.seq === root.dataset.newest",
        answers=answers,
    )
    page.mouse.up()
    seen.settled()


def test_the_distance_board_follows_q(page):
    """q is dragged: distance and nearest point follow, and there is no growth to scrub."""
    seen = Seen(page, 3)
    assert seen.shown_text() == "distance 2.236; nearest: vertex 2"
    seen.drag("handle-0", -100, 0)
    assert (
        seen.shown_text().startswith("distance")
        and seen.shown_text() != "distance 2.236; nearest: vertex 2"
    )
    assert not seen.board.locator(".kinoedu-slider").is_visible()
    keep(page, "distance")


def test_a_board_is_copied_as_code(yard):
    """The button puts Python code for the board as it is now on the clipboard."""
    yard.page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    yard.drag("handle-1", -25, 10)
    yard.board.locator(".kinoedu-copy").click()
    yard.until("root.querySelector('.kinoedu-copy').textContent === 'copied'")
    code = yard.page.evaluate("navigator.clipboard.readText()")
    x, y = map(float, re.findall(r"-?\d+\.\d+", code.partition("goal=")[2])[:2])
    assert f"goal at ({x:g}, {y:g})" in yard.label("handle-1") and 'ke.board(problem, "rrt"' in code
    assert not Seen(yard.page, 3).board.locator(".kinoedu-copy").is_visible()

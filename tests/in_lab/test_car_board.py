"""The car's board in a real JupyterLab: poses are set and planned, the car is driven by keys."""

import json

import pytest
from lab_driver import keep

from .test_board import Seen
from .test_planning_boards import scrub

YARD = """import numpy as np
import kinoedu as ke
walls = [[(70, 0), (90, 0), (90, 90), (70, 90)], [(150, 70), (170, 70), (170, 160), (150, 160)]]
world = ke.PolygonWorld([(0, 0), (240, 0), (240, 160), (0, 160)], walls)
yard = ke.Problem(ke.Car(30, 10, 20), world, (25, 30, np.pi / 2), (210, 110, np.pi / 2))
ke.boards.car_board(yard)"""
DRIVEN = "yours = ke.boards.car_board(yard, 'you')\nyours"
ASK = """async code => {
    const kernel = jupyterapp.shell.currentWidget.sessionContext.session.kernel; let text = '';
    const future = kernel.requestExecute({code});
    future.onIOPub = m => { text += m.content.text ?? ''; };
    await future.done; return text; }"""


@pytest.fixture(scope="module")
def page(run_in_lab):
    """One notebook for both boards: one with a planner, one driven by keys."""
    with run_in_lab(YARD, DRIVEN) as page:
        yield page


@pytest.fixture(params=[0, 1], ids=["planned", "driven"])
def either(page, request):
    """Each board, reset."""
    return started_again(page, request.param)


@pytest.fixture
def planned(page):
    """The board on which a planner drives."""
    return started_again(page, 0)


@pytest.fixture
def driven(page):
    """The board that is driven by keys."""
    return started_again(page, 1)


def started_again(page, number):
    """A board, reset."""
    seen = Seen(page, number)
    seen.board.locator(".kinoedu-reset").click()
    seen.settled()
    return seen


def on_ground(seen, x, y):
    """The position on the page of a place of the world."""
    box = seen.board.locator("canvas").bounding_box()
    scale = (box["width"] - 16) / 240
    return box["x"] + 8 + x * scale, box["y"] + box["height"] - 8 - y * scale


def test_a_goal_is_dragged_and_planned_anew(planned):
    """Its heading stays and its tip follows; plans arrive during the drag; the tree grows first."""
    answers, pixels = int(planned.data("answers")), planned.pixels()
    planned.drag("handle-2", -30, 40, release=False)
    planned.until(
        "root.dataset.answers > answers && root.dataset.seq === root.dataset.newest",
        answers=answers,
    )
    planned.page.mouse.up()
    planned.settled()
    (x, y), (tip_x, tip_y) = planned.middle("handle-2"), planned.middle("handle-3")
    assert abs(x - tip_x) < 2 and y - tip_y > 50 and planned.pixels() != pixels
    scrub(planned, 20)
    planned.until("text.startsWith('kinodynamic RRT: ') && text.includes(' of ')")
    scrub(planned, int(planned.data("total")) - 100)
    planned.until("text.startsWith('time ')")
    keep(planned.page, "car_planned")


def test_a_pose_is_set_on_the_ground(either):
    """Press and drag sets a pose; a press alone keeps the heading; with Shift it is the start."""
    page = either.page
    page.mouse.move(*on_ground(either, 120, 40))
    page.mouse.down()
    page.mouse.move(*on_ground(either, 90 + 15, 40), steps=4)
    page.mouse.up()
    either.settled()
    assert either.label("handle-2").startswith("goal at (1") and either.label(
        "handle-3"
    ).startswith("goal's heading at (")
    (x, y), (tip_x, tip_y) = either.middle("handle-2"), either.middle("handle-3")
    assert abs(y - tip_y) < 2 and x - tip_x > 50
    page.mouse.click(*on_ground(either, 200, 40))
    either.settled()
    (x, y), (tip_x, tip_y) = either.middle("handle-2"), either.middle("handle-3")
    assert abs(y - tip_y) < 2 and x - tip_x > 50 and abs(x - on_ground(either, 200, 40)[0]) < 2
    page.keyboard.down("Shift")
    page.mouse.click(*on_ground(either, 40, 100))
    page.keyboard.up("Shift")
    either.settled()
    assert abs(either.middle("handle-0")[0] - on_ground(either, 40, 100)[0]) < 2


def test_what_is_not_free_goes_back_when_it_is_let_go(either):
    """With the reason in words; the start returns to its last free place."""
    either.drag(
        "handle-0",
        *(b - a for a, b in zip(either.middle("handle-0"), on_ground(either, 80, 50), strict=True)),
    )
    either.until("root.dataset.warning.includes('is not free')")
    either.until(
        "root.querySelector('[data-thing=handle-0]').ariaLabel.startsWith('start at (80') === false"
    )
    keep(either.page, "car_refused")


def test_headings_are_turned_by_keys(driven):
    """Moving the goal's tip to the left turns its heading to the left."""
    x = driven.middle("handle-3")[0]
    driven.board.locator("[data-thing=handle-3]").focus()
    for _ in range(4):
        driven.page.keyboard.press("Shift+ArrowLeft")
    driven.settled()
    driven.page.wait_for_timeout(400)  # a tip moved by keys is released after a moment
    assert driven.middle("handle-3")[0] < x - 20


def test_the_car_is_driven_by_arrow_keys(driven):
    """The car moves while a key is held, steers, stops at the wall, and Python has the drive."""
    page = driven.page
    driven.board.locator("[data-thing=handle-4]").focus()
    page.keyboard.press("ArrowUp")
    driven.until("text.startsWith('you have driven 1.2;')")
    page.keyboard.down("ArrowUp")
    page.keyboard.down("ArrowRight")
    driven.until("text.includes('turned by -45°')")
    page.keyboard.up("ArrowRight")
    driven.until("text.includes('Contact')")
    page.keyboard.up("ArrowUp")
    keep(page, "car_driven")
    controls, free = json.loads(
        page.evaluate(
            ASK,
            "import json; t = yours.driven; "
            "print(json.dumps([t.controls.tolist(), ke.collision.is_free_trajectory(yard.robot, "
            "world, t)]))",
        )
    )
    assert free and controls[0] == [1.0, 0.0] and {v for v, _ in controls} == {1.0}
    page.keyboard.down("ArrowDown")
    driven.until("!text.includes('Contact')")
    page.keyboard.up("ArrowDown")


def test_fingers_have_buttons_and_a_planner_hands_over_the_wheel(planned):
    """Holding a button drives; the menu changes to "you"; a view follows the car."""
    forward = planned.board.locator("[data-key=ArrowUp]")
    assert forward.get_attribute("aria-label") == "drive forward"
    forward.scroll_into_view_if_needed()
    box = forward.bounding_box()
    planned.page.mouse.move(box["x"] + 5, box["y"] + 5)
    planned.page.mouse.down()
    planned.until("text.startsWith('you have driven 2')")
    planned.page.mouse.up()
    menus = planned.page.locator(".widget-dropdown select")
    assert menus.nth(0).evaluate("menu => menu.selectedOptions[0].text").startswith("you")
    before = planned.middle("handle-0")
    menus.nth(1).select_option("following the car")
    planned.until("root.dataset.layers.includes('eye')")
    planned.page.wait_for_timeout(300)
    box = planned.board.locator("canvas").bounding_box()
    x, y = planned.middle("handle-4")
    assert abs(x - box["x"] - box["width"] / 2) < 2 and abs(y - box["y"] - box["height"] / 2) < 2
    assert planned.middle("handle-0") != before
    keep(planned.page, "car_followed")
    menus.nth(1).select_option("whole world, from above")
    menus.nth(0).select_option("kinodynamic RRT: a tree of drives")
    planned.until("text.startsWith('kinodynamic RRT')")


def test_on_a_narrow_page_nothing_is_cut(driven):
    """Picture, text and buttons are at most as wide as the page."""
    page = driven.page
    page.evaluate("jupyterapp.shell.collapseLeft()")
    page.set_viewport_size({"width": 480, "height": 900})
    try:
        page.wait_for_timeout(1000)
        driven.board.scroll_into_view_if_needed()
        board = driven.board.bounding_box()
        for part in ("canvas", ".kinoedu-pad", "[data-key=ArrowRight]", ".kinoedu-reset"):
            box = driven.board.locator(part).bounding_box()
            assert box["x"] + box["width"] <= board["x"] + board["width"] + 1
        keep(page, "car_narrow")
    finally:
        page.set_viewport_size({"width": 1280, "height": 1000})

"""The boards of an arm and of a sliding robot in a real JupyterLab."""

import math
import re

import pytest
from lab_driver import keep

from .test_board import Seen

ARM = """import kinoedu as ke
from kinoedu.boards import arm_board, slide_board
triangles = [[(1.2, 1.4), (2.6, 1.2), (2.2, 2.4)], [(-2.4, 0.4), (-1.2, 0.6), (-1.4, 1.8)]]
obstacles = [*triangles, ((0.4, 2.2), 0.4), ((0.2, -1.4), 0.3)]
world = ke.PolygonWorld([(-4, -4), (4, -4), (4, 4), (-4, 4)], obstacles)
arm_board(ke.TwoLinkArm(1.5, 1.2, 0.2), world, q=(0.6, 0.3))"""
PLAN = "arm_board(ke.TwoLinkArm(1.5, 1.2, 0.2), world, q=(-0.5, 2.6), goal=(0.8, -2.5))"
SLIDE = "slide_board([(-.5, -.4), (1, -.2), (.2, 1)], [(2, 2), (4, 1.5), (5, 3), (4, 4), (2, 3.6)])"
WORKSPACE, SQUARE, SLIDING = 0, 1, 4  # the numbers of the pictures; 2 and 3 belong to the plan


@pytest.fixture(scope="module")
def page(run_in_lab):
    """One notebook for all."""
    with run_in_lab(ARM, PLAN, SLIDE) as page:
        yield page


@pytest.fixture
def arm(page):
    """Both pictures of the arm, reset."""
    both = Seen(page, WORKSPACE), Seen(page, SQUARE)
    for seen in both[::-1]:
        seen.board.locator(".kinoedu-reset").click()
        seen.settled()
    both[0].until("text.startsWith('q = (0.60, 0.30)')")
    return both


def numbers(label):
    """The coordinates in a thing's label."""
    return [float(x) for x in re.findall(r"-?\d+\.\d+", label)]


def test_a_pulled_tip_moves_q_and_stays_within_reach(arm):
    """A tip pulled out of the world stays at full reach; q follows, and both texts say so."""
    workspace, square = arm
    keep(workspace.page, "arm")
    before = square.pixels()
    workspace.drag("handle-1", 40, 120)
    workspace.until("text.includes('reach only 2.7') && text.includes('(0.00, 0.00)') === false")
    x, y = numbers(workspace.label("handle-1"))
    assert math.hypot(x, y) == pytest.approx(2.7, abs=0.02)
    square.until("text.includes('θ₂ = 0°') || text.includes('θ₂ = -0°')")
    assert square.pixels() != before and numbers(square.label("handle-0"))[1] == pytest.approx(
        0.0, abs=0.01
    )


def test_a_pulled_elbow_turns_link_1_alone(arm):
    """The second angle does not change."""
    workspace, square = arm
    before = numbers(square.label("handle-0"))
    workspace.drag("handle-0", -30, -60)
    square.until("!text.startsWith('θ₁ = 34°') && text.includes('θ₂ = 17°')")
    after = numbers(square.label("handle-0"))
    assert after[0] != before[0] and after[1] == before[1]


def test_keys_turn_joints_and_cross_the_side_of_the_square(arm):
    """An arrow key in the square turns a joint; beyond the right side q enters at the left."""
    workspace, square = arm
    q = square.board.locator("[data-thing=handle-0]")
    q.focus()
    q.press("ArrowUp")
    square.until("text.includes('θ₂ = 21°') && text.startsWith('θ₁ = 34°')")
    for _ in range(8):
        q.press("Shift+ArrowRight")
        square.settled()
    square.until("text.startsWith('θ₁ = -')")
    x, _ = numbers(square.label("handle-0"))
    assert -math.pi <= x < -1.5
    workspace.until("text.startsWith('q = (-')")
    keep(workspace.page, "arm_keys")


def test_q_is_dragged_across_a_side(arm):
    """The pointer leaves the picture below; q enters above."""
    workspace, square = arm
    _, y = square.middle("handle-0")
    box = square.board.locator("canvas").bounding_box()
    square.drag("handle-0", 0, box["y"] + box["height"] - y + 10)
    square.until("/θ₂ = 1[0-9][0-9]°/.test(text)")
    workspace.until("/q = \\(0.6., [23]/.test(text)")
    _, above = numbers(square.label("handle-0"))
    assert math.pi / 2 < above < math.pi


def test_a_dragged_obstacle_repaints_the_square_live(arm):
    """New images arrive during the drag, and their colours change; the arm does not move."""
    workspace, square = arm
    before, pictures = square.pixels(), int(square.data("bitmaps"))
    workspace.drag("disc-0", 60, 30, release=False)
    square.until("root.dataset.bitmaps > pictures", pictures=pictures)
    workspace.until("root.dataset.seq === root.dataset.newest")
    assert square.pixels() != before and workspace.shown_text().startswith("q = (0.60, 0.30)")
    workspace.page.mouse.up()
    workspace.settled()


def test_a_plan_is_scrubbed_in_both_pictures(page):
    """A step in one is the same step in the other, and the arm moves along."""
    workspace, square = Seen(page, 2), Seen(page, 3)
    assert (
        "RRT: a path of length" in workspace.shown_text()
        and workspace.data("total") == square.data("total") == "120"
    )
    before = workspace.pixels()
    slider = square.board.locator(".kinoedu-slider")
    slider.evaluate(
        "(slider, step) => { slider.value = step; slider.dispatchEvent(new Event('input')); }", 40
    )
    workspace.until("root.dataset.step === '40' && text.startsWith('on the way to the goal: (')")
    assert workspace.pixels() != before
    keep(page, "arm_plan")
    answers = int(workspace.data("answers"))
    square.drag("handle-1", 0, -20)
    workspace.until("root.dataset.answers > answers", answers=answers)


def test_a_robot_slides_by_dragging_and_by_its_slider(page):
    """q stays on the boundary, the text names the contact, a dragged vertex changes the shape."""
    sliding = Seen(page, SLIDING)
    first = sliding.shown_text()
    sliding.drag("handle-0", 150, 60)
    sliding.until("text !== first && text.includes('contact')", first=first)
    keep(page, "slide")
    follows = "document.querySelector('.widget-slider .widget-readout').textContent !== '0%'"
    sliding.until(follows)  # once q is let go; before that Home would change nothing
    slider = page.locator(".widget-slider [role=slider]")
    slider.focus()
    slider.press("Home")
    sliding.until("text === first", first=first)
    sliding.board.locator("[data-thing=polygon-1]").focus()
    page.keyboard.press("Enter")
    pixels = sliding.pixels()
    sliding.drag("vertex-1-0-0", -15, 10)
    assert sliding.pixels() != pixels and sliding.data("warning") == ""
    sliding.board.locator("[data-thing=polygon-0]").focus()
    page.keyboard.press("Enter")
    sliding.drag("vertex-0-0-0", 110, -50)
    sliding.until(
        "root.dataset.warning.includes('obstacle') && root.dataset.layers.includes('bodies')"
    )
    keep(page, "slide_warning")

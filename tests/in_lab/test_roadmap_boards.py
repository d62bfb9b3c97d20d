"""The boards of roadmaps, races, rewiring and exploration in a real JupyterLab."""

import pytest
from lab_driver import keep

from .test_board import Seen
from .test_planning_boards import scrub

YARD = """import kinoedu as ke
left = [(2, 3), (3.5, 2.6), (3.9, 6.5), (2.4, 6.1)]
right = [(5, 0.6), (6.2, 0.9), (6, 4.4), (5.2, 4.6)]
world = ke.PolygonWorld([(0, 0), (12, 0), (12, 9), (0, 9)], [left, right])
yard = ke.Problem(ke.Point(), world, (1, 1), (11, 8))"""
BOARDS = [
    "ke.boards.roadmap_board(yard, n=100)",
    "ke.boards.properties_board(yard, n=60)",
    "ke.boards.race_board(yard, nodes=300)",
    "ke.boards.rewiring_board(yard, nodes=200)",
    "ke.boards.exploring_board(yard)",
    "ke.boards.bug_board((0, 0), (5, 3), [[(1, 2), (1, 0), (3, 0)]])",
]

# Again and again, because the answers to the last drag, which may still come, show their ends.
SCRUBBED = """boards => {
    const slider = boards[0].querySelector('.kinoedu-slider');
    slider.value = 40;
    slider.dispatchEvent(new Event('input'));
    return boards.every(board => board.dataset.step === '40'); }"""
NAMED = "root.querySelector(`[data-thing=${thing}]`).ariaLabel === label"


@pytest.fixture(scope="module")
def page(run_in_lab):
    """One notebook for all; the race has the boards 2, 3 and 4."""
    with run_in_lab(YARD, *BOARDS) as page:
        yield page


def test_a_roadmap_is_scrubbed_and_dragged(page):
    """Half way there are nodes and no edges; a dragged obstacle gives another roadmap."""
    seen = Seen(page, 0)
    assert "path of length" in seen.shown_text() and "components 1" in seen.shown_text()
    scrub(seen, 60)
    seen.until("text === 'nodes 60 of 102'")
    before = seen.shown_text()
    seen.drag("polygon-0", 40, 10)
    assert seen.shown_text() != before and "path of length" in seen.shown_text()
    keep(page, "roadmap")


def test_the_rule_is_chosen_from_the_menu(page):
    """Another rule gives another roadmap at once, and its own slider appears."""
    seen = Seen(page, 0)
    before = seen.shown_text()
    page.locator(".widget-dropdown select").first.select_option("all within radius r")
    seen.until("text !== before && text.includes('edges')", before=before)
    assert page.locator(".widget-label").get_by_text("r", exact=True).first.is_visible()


def test_properties_are_measured_while_an_obstacle_is_dragged(page):
    """The text gives all four, before and after."""
    seen = Seen(page, 1)
    assert "accessible" in seen.shown_text() and "δ at least" in seen.shown_text()
    answers = int(seen.data("answers"))
    seen.drag("polygon-1", 60, 30)
    assert int(seen.data("answers")) > answers and "departable" in seen.shown_text()
    keep(page, "properties")


def test_a_race_is_one_scene_on_one_clock(page):
    """A drag in the second moves in all; the first slider leads, and is the only one visible."""
    first, second, third = (Seen(page, number) for number in (2, 3, 4))
    second.drag("handle-1", -60, 40)
    lane, label = second.label("handle-1").split(": ")
    assert lane == "rrt connect" and first.label("handle-1").startswith("rrt: ")
    for other, name in ((first, "rrt"), (third, "rrt star")):
        other.until(NAMED, thing="handle-1", label=f"{name}: {label}")
    first.drag("polygon-1", 30, 20)
    label = first.label("polygon-1").removeprefix("rrt: ")
    third.until(NAMED, thing="polygon-1", label=f"rrt star: {label}")
    third.drag("handle-0", 30, 0)
    for other, name in ((first, "rrt"), (third, "rrt star")):
        assert other.label("polygon-1") == f"{name}: {label}"
    page.wait_for_function(
        SCRUBBED, arg=[seen.board.element_handle() for seen in (first, second, third)]
    )
    third.until("text.startsWith('RRT*: nodes 40')")
    assert [
        seen.board.locator(".kinoedu-slider").is_visible() for seen in (first, second, third)
    ] == [True, False, False]
    keep(page, "race")


def test_how_to_use_a_board_stands_below_its_code(page):
    """In a narrow lane it would push the code out of sight."""
    seen = Seen(page, 2)
    menu = page.locator(".kinoedu-framed").nth(2).locator("select")
    menu.select_option("rrt")
    seen.until("root.querySelector('.kinoedu-lines').children.length > 5")
    page.set_viewport_size({"width": 480, "height": 1000})
    for part in (".kinoedu-column", ".kinoedu-code"):
        above = seen.board.locator(part).bounding_box()
        below = seen.board.locator("> .kinoedu-hint").bounding_box()
        assert above["y"] + above["height"] <= below["y"] + 1
    keep(page, "lane")
    page.set_viewport_size({"width": 1280, "height": 1000})
    menu.select_option("no planner")
    seen.until("!root.classList.contains('kinoedu-coded')")


def test_rewiring_is_told_at_each_step(page):
    """Node, neighbours, parent and rewired edges in words; another step is another picture."""
    seen = Seen(page, 5)
    scrub(seen, 120)
    seen.until("text.startsWith('node 119: ') && text.includes('rewired')")
    before = seen.pixels()
    scrub(seen, 121)
    seen.until("text.startsWith('node 120')")
    assert seen.pixels() != before
    keep(page, "rewiring")


def test_an_explorer_knows_little_at_first(page):
    """It begins with one look, and ends at the goal, wherever that was dragged."""
    seen = Seen(page, 6)
    scrub(seen, 0)
    seen.until("text.startsWith('look 1: ') && text.includes('path in its map')")
    keep(page, "exploring")
    seen.drag("handle-1", -40, 60)
    seen.until("text.startsWith('at the goal after')")


def test_an_obstacle_whose_box_has_its_middle_outside_is_held_where_it_is(page):
    """The button of a triangle lies on the triangle, so that a pointer there drags it."""
    seen = Seen(page, 7)
    before = seen.label("polygon-0")
    seen.drag("polygon-0", 40, -40)
    assert seen.label("polygon-0") != before

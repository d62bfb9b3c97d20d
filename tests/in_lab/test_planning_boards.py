"""The boards of bugs, of the sweep line and of searches in a real JupyterLab."""

import io

import numpy as np
import pytest
from lab_driver import keep
from PIL import Image, ImageColor

from kinoedu.figures import palette

from .test_board import Seen

BUG = (
    "import kinoedu as ke\nke.boards.bug_board((0, 0), (4, 0), [[(1, -1), (2, -1), (2, 2), (1, "
    "2)]])"
)
SWEEP = (
    "ke.boards.sweep_board(ke.PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(3, 3), (6, 2), "
    "(5, 4)]]), x=4)"
)
GRAPH = """from kinoedu.graphs import Graph
nodes = [(0, 0), (4, 3), (4, -3), (8, 0), (11, 0)]
ke.boards.search_board(Graph(nodes=nodes, edges=[(0, 1), (0, 2), (1, 3), (2, 3), (3, 4)]))"""
CODE = """def nearest_on(q, p1, p2):
    way = p2 - p1
    t = np.dot(q - p1, way) / np.dot(way, way)
    t = min(max(t, 0.0), 1.0)
    return p1 + t * way
ke.boards.code_board(nearest_on, (3.0, 4.0), (0.0, 0.0), (6.0, 0.0), first=2)"""
ROUNDS = """def walk(q, n):
    begin = q.copy()
    for _ in range(n):
        step = q / 4
        q = q + step
    return q
ke.boards.code_board(walk, (4.0, 0.0), 2, first=5, window=((0, -1), (8, 1)))"""
LINES = """from kinoedu.boards.core.drawing import Drawing, edges
from kinoedu.boards.core.scene import make_scene
places = np.linspace((0, 0), (8, 0), 400)
def draw(scene):
    lines = np.stack([places[:-1], places[1:]], axis=1)
    return Drawing([edges(lines + (0, 1), "hit", width=12), edges(lines - (0, 1), "hit")])
ke.boards.Canvas(make_scene((0, -2), (8, 2)), draw)"""
SEARCH = "import numpy as np\nke.boards.search_board(np.ones((6, 9), bool), search='astar')"


@pytest.fixture(scope="module")
def page(run_in_lab):
    """One notebook for all; the bugs' world is board 0, its plot board 1."""
    with run_in_lab(BUG, SWEEP, SEARCH, GRAPH, CODE, ROUNDS, LINES) as page:
        yield page


def scrub(seen, step):
    """Move the slider of growth to a step."""
    slider = seen.board.locator(".kinoedu-slider")
    slider.evaluate(
        "(slider, step) => { slider.value = step; slider.dispatchEvent(new Event('input')); }", step
    )


def test_a_walk_and_its_plot_are_scrubbed_together(page):
    """A step in the plot is the same step in the world, with its text; a drag changes both."""
    world, plot = Seen(page, 0), Seen(page, 1)
    assert world.shown_text() == "Bug 1: reached after 14; hits 1"
    before = world.pixels()
    scrub(plot, 100)
    world.until("root.dataset.step === '100' && text.includes('follows the wall')")
    assert world.pixels() != before
    answers = int(plot.data("answers"))
    world.drag("handle-1", 0, -20)
    plot.until("root.dataset.answers > answers", answers=answers)
    assert "reached after" in world.shown_text()


BESIDE_A_DRAG = """([root, partner]) => {
    const boards = [...globalThis[Symbol.for("kinoedu.boards")].values()];
    const of = (it) => boards.find(({ views }) => [...views].some((view) => view.root === it));
    const [dragged, plot] = [of(root), of(partner)], [view] = plot.views;
    Object.assign(view, { painted: 0, request() { this.painted += 1; } });
    const requests = (lag) => {
        const before = view.painted;
        dragged.lag = lag;
        plot.painted = performance.now();
        [1, 2, 3].forEach(() => plot.changed());
        return view.painted - before;
    };
    const found = [requests(0), requests(1000)], before = view.painted;
    return new Promise((done) => {
        const look = () => {
            if (view.painted === before) { setTimeout(look, 10); return; }
            delete view.request;
            plot.changed();
            done(found);
        };
        look();
    });
}"""


def test_on_a_slow_page_a_plot_is_painted_seldom_beside_a_drag(page):
    """With each answer of a fast page; on a slow one not at once, but before long."""
    world, plot = Seen(page, 0), Seen(page, 1)
    world.drag("handle-1", 0, 20, release=False)
    roots = [seen.board.element_handle() for seen in (world, plot)]
    found = page.evaluate(BESIDE_A_DRAG, roots)
    page.mouse.up()
    world.settled()
    assert found == [3, 0]


def test_the_sweep_line_is_dragged_and_its_status_listed(page):
    """Farther right more cells are closed, and the list shows other edges."""
    seen = Seen(page, 2)
    assert "an obstacle begins; cells closed 1, open 2" in seen.shown_text()
    seen.drag("handle-0", 150, 0)
    seen.until("text.includes('an obstacle ends; cells closed 4, open 1')")
    assert page.locator("li", has_text="edge 1, a ceiling").count() == 1


def test_a_search_is_scrubbed_with_its_frontier(page):
    """At each step the text gives the frontier's size, and the picture is another."""
    seen = Seen(page, 3)
    assert "path cost 13" in seen.shown_text()
    before = seen.pixels()
    scrub(seen, 0)
    seen.until("text === 'expanded 0 of 54; frontier 1'")
    assert seen.pixels() != before


def test_code_is_stepped_through_and_its_arguments_dragged(page):
    """By buttons, by a click on a line, by keys; a drag keeps the line that is shown."""
    seen = Seen(page, 5)
    lines, values = (seen.board.locator(f".kinoedu-{name}") for name in ("line", "values"))
    lit = "root.querySelector('.kinoedu-lit').textContent.trim()"
    seen.until(f"root.dataset.step === '2' && {lit}.startsWith('t = np.dot')")
    assert "t = 0.5" in seen.shown_text() and "0.5" in values.inner_text()
    seen.board.get_by_role("button", name="run the next line").click()
    seen.until(f"root.dataset.step === '3' && {lit}.startsWith('t = min')")
    lines.nth(1).click()
    seen.until(f"root.dataset.step === '1' && {lit} === 'way = p2 - p1'")
    assert lines.nth(0).is_disabled() and lines.nth(1).get_attribute("aria-current") == "step"
    answers = int(seen.data("answers"))
    seen.drag("handle-2", -30, -40)
    seen.until("root.dataset.answers > answers && root.dataset.step === '1'", answers=answers)
    assert "(6, 0)" not in values.inner_text()
    slider = seen.board.locator(".kinoedu-slider")
    slider.focus()
    slider.press("End")
    seen.until("root.dataset.step === root.dataset.total && text.includes('nearest_on returns')")
    keep(page, "code_board")


def test_a_value_of_the_round_before_says_so(page):
    """From the head of the loop until the line that assigns it."""
    seen = Seen(page, 6)
    old = seen.board.locator(".kinoedu-old")
    assert old.all_inner_texts() == ["step\t(1, 0) of the round before"]
    seen.board.get_by_role("button", name="run the next line").click()
    seen.until("root.dataset.step === '6'")
    assert old.count() == 0 and "step\t(1.25, 0)" in seen.board.inner_text()


def painted(seen):
    """The colours on a board's canvas, (rows, columns, 3)."""
    return np.asarray(Image.open(io.BytesIO(seen.pixels())).convert("RGB")).astype(int)


IS_RINGED = """(() => {
    const canvas = root.querySelector('canvas'), pen = canvas.getContext('2d');
    const [box, dot] = [canvas, root.querySelector('[data-thing=handle-0]')].map(
        (element) => element.getBoundingClientRect());
    const [x, y] = [dot.x + dot.width / 2 - box.x, dot.y + dot.height / 2 - box.y];
    const angles = [...Array(60).keys()].map((k) => k * Math.PI / 30);
    return angles.filter((angle) => {
        const at = [x + 13 * Math.cos(angle), y + 13 * Math.sin(angle)];
        const pixel = pen.getImageData(...at.map((p) => p * canvas.width / box.width), 1, 1).data;
        return colour.every((part, k) => Math.abs(part - pixel[k]) < 60);
    }).length > 40; })()"""


def test_a_point_that_a_handle_hides_has_a_ring(page):
    """In its colour: `begin` is where q is, which can be dragged."""
    Seen(page, 6).until(IS_RINGED, colour=ImageColor.getrgb(palette.NAMED["tree"]))


def test_many_lines_keep_their_width_unless_they_are_fine(page):
    """Those of a roadmap are painted one pixel wide, a walk's are not."""
    pixels = painted(Seen(page, 7))
    column = pixels[20:-20, pixels.shape[1] // 2]  # without the frame
    wide, fine = np.array_split((column < 250).any(axis=1), 2)  # above and below the middle
    assert 12 <= wide.sum() <= 13 and 1 <= fine.sum() <= 2


@pytest.fixture
def graph(page):
    """The board of a graph, reset."""
    seen = Seen(page, 4)
    seen.board.locator(".kinoedu-reset").click()
    seen.until(
        "text === 'from node 0 to node 4: expanded 5 of 5; frontier 0; path cost 13, edges 3'"
    )
    return seen


def test_a_node_is_dragged_and_its_weights_follow(graph):
    """Edges grow and the search runs again; the start, on node 0, moves with it by keys."""
    pixels = graph.pixels()
    graph.drag("handle-3", 60, -20)  # node 1
    graph.until("text.includes('from node 0 to node 4') && !text.includes('path cost 13,')")
    assert graph.pixels() != pixels
    node = graph.board.locator("[data-thing=handle-2]")
    node.focus()
    node.press("Shift+ArrowDown")
    graph.until(
        "root.querySelector('[data-thing=handle-0]').ariaLabel === 'start at (0.00, -0.73)'"
    )
    place, keys = graph.label("handle-2").split("; ")
    assert place == "node 0 at (0.00, -0.73)"
    assert keys == "press Enter to move the goal here, Shift and Enter to move the start"
    graph.settled()


def test_start_and_goal_are_called_to_nodes(graph):
    """A click or Enter moves the goal, with Shift the start; a release near a node snaps to it."""
    page, label = graph.page, graph.label("handle-4")
    page.mouse.click(*graph.middle("handle-4"))  # node 2
    graph.until("text.startsWith('from node 0 to node 2:')")
    assert graph.label("handle-4") == label and graph.label("handle-1") == "goal at (4.00, -3.00)"
    page.keyboard.down("Shift")
    page.mouse.click(*graph.middle("handle-5"))
    page.keyboard.up("Shift")
    graph.until("text.startsWith('from node 3 to node 2:')")
    graph.board.locator("[data-thing=handle-6]").press("Enter")
    graph.until("text.startsWith('from node 3 to node 4:')")
    graph.board.locator("[data-thing=handle-3]").press("Shift+Enter")
    graph.until("text.startsWith('from node 1 to node 4:')")
    (x, y), (nx, ny) = graph.middle("handle-0"), graph.middle("handle-2")
    graph.drag("handle-0", nx - x + 6, ny - y + 5)
    graph.until("text.startsWith('from node 0 to node 4:')")
    assert graph.label("handle-0") == "start at (0.00, 0.00)"
    keep(page, "graph")

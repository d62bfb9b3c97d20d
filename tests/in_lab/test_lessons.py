"""Lessons in a real JupyterLab: every board is painted there, and what can be played with moves.

One lesson runs whole. Of the others, whose cells nbval runs, only what their boards need.
"""

import json
import re
from pathlib import Path

import pytest
from board_cells import keep_what_boards_need
from lab_driver import OPEN, RUN_ALL, keep

from kinoedu.lab import TOUR

from .conftest import HOUSE

LESSONS = sorted(path.name for path in (HOUSE / "notebooks").glob("*.ipynb"))
WHOLE = "09_trees.ipynb"
TOLD = "document.querySelectorAll('.kinoedu-text')"
# JupyterLab renders what is in view
SCROLL = "number => jupyterapp.shell.currentWidget.content.scrollToItem(number, 'center')"
SHOW = """number => jupyterapp.shell.currentWidget.content.widgets[number].node
    .querySelector('.kinoedu-board, .kinoedu-solid').scrollIntoView({block: 'center'})"""
# The next lesson gets the same kernel: a new one would have to import everything again.
CLOSE = """async () => {
    const { context, sessionContext } = jupyterapp.shell.currentWidget;
    const kernel = sessionContext.session.kernel.clone();
    const run = code => kernel.requestExecute({code}).done;
    await context.save();
    await run('pass');  // what was asked before is answered now
    jupyterapp.shell.currentWidget.close();
    await run('import ipywidgets; ipywidgets.Widget.close_all(); get_ipython().reset(False)');
    kernel.dispose(); }"""
PAINTED = """number => {
    const cell = jupyterapp.shell.currentWidget.content.widgets[number].node;
    const boards = [...cell.querySelectorAll('.kinoedu-board, .kinoedu-solid')]
        .map(board => board.dataset);
    return boards.length && boards.every(({answers = 1, paints}) => answers > 0 && paints > 0); }"""
COLOURS = """number => {
    const cell = jupyterapp.shell.currentWidget.content.widgets[number].node;
    return [...cell.querySelectorAll('.kinoedu-canvas, .kinoedu-solid canvas')].map(canvas => {
        const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
        return new Set(new Uint32Array(pixels.buffer)).size; }); }"""


@pytest.fixture(scope="module")
def lessons(opened):
    """The page, with lessons that are made shorter."""
    for lesson in LESSONS:
        file = opened.course / "notebooks" / lesson
        if lesson != WHOLE:
            book = keep_what_boards_need(json.loads(file.read_text("utf-8")), boards_of(lesson))
            file.write_text(json.dumps(book), encoding="utf-8")
    opened.kernel = None
    return opened


@pytest.fixture
def page(lessons):
    """The page, with no notebook open afterwards, and without the errors of earlier notebooks."""
    lessons.outside.clear()
    lessons.errors.clear()
    yield lessons
    lessons.evaluate(CLOSE)


def boards_of(lesson):
    """The numbers of a stored notebook's cells that show boards: each says what it is in text,
    too.
    """
    cells = json.loads((HOUSE / "notebooks" / lesson).read_text(encoding="utf-8"))["cells"]
    data = [[out.get("data", {}) for out in cell.get("outputs", [])] for cell in cells]
    texts = ["".join("".join(one.get("text/plain", "")) for one in outputs) for outputs in data]
    return [number for number, text in enumerate(texts) if re.match(r"\w*(Board|Canvas)\(", text)]


@pytest.mark.parametrize("lesson", LESSONS)
def test_a_lesson_runs_and_its_boards_are_painted(page, lesson):
    """They run without error, without a request to the outside and without a complaint; every board
    shows its answer.
    """
    page.kernel = page.evaluate(OPEN, [f"notebooks/{lesson}", page.kernel])
    book = page.evaluate(RUN_ALL)
    code = [cell for cell in book["cells"] if cell["cell_type"] == "code"]
    assert all(cell["execution_count"] for cell in code)
    assert [
        o["evalue"] for cell in code for o in cell["outputs"] if o["output_type"] == "error"
    ] == []
    for number in boards_of(lesson):
        page.evaluate(SCROLL, number)
        page.wait_for_function(PAINTED, arg=number)
        page.evaluate(SHOW, number)
        keep(page, f"{lesson.removesuffix('.ipynb')}-{number}")
        assert min(page.evaluate(COLOURS, number)) > 3  # a world, an answer, and their words
    if lesson in PLAYED:
        page.evaluate(SCROLL, boards_of(lesson)[0])
        PLAYED[lesson](page)
    assert page.outside == [] and page.errors == []


def play_tour(page):
    """The first board is dragged, scrubbed, and replanned."""
    board = page.locator(".kinoedu-board").first
    page.wait_for_function(f"() => {TOLD}[0].innerText === 'RRT: a path of length 270.4, 78 nodes'")
    board.locator("[data-thing=handle-1]").scroll_into_view_if_needed()
    goal, whole = (
        board.locator("[data-thing=handle-1]").bounding_box(),
        board.locator("canvas").screenshot(),
    )
    x, y = goal["x"] + goal["width"] / 2, goal["y"] + goal["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 34, y, steps=8)  # into a building
    page.wait_for_function(f"() => {TOLD}[0].innerText.includes('is not free')")
    page.mouse.move(x, y - 25, steps=8)
    page.mouse.up()
    page.wait_for_function(f"() => {TOLD}[0].innerText.includes('a path of length')")
    assert board.locator("canvas").screenshot() != whole
    board.locator(".kinoedu-slider").press("Home")
    page.wait_for_function(f"() => {TOLD}[0].innerText.startsWith('0 of ')")
    page.locator("select").filter(has_text="A* on a grid").first.select_option(label="A* on a grid")
    page.wait_for_function(f"() => {TOLD}[0].innerText.startsWith('A*: a path')")


def play_distance(page):
    """What the prediction asks for: q through the notch, by keys."""
    page.wait_for_function(f"() => {TOLD}[0].innerText.includes('distance 0.8')")
    q = page.locator(".kinoedu-board").first.locator("[data-thing=handle-0]")
    q.focus()
    for _ in range(3):
        q.press("ArrowLeft")
    page.wait_for_function(
        f"() => {TOLD}[0].innerText.includes('distance') && "
        f"!{TOLD}[0].innerText.includes('distance 0.8,')"
    )


PLAYED = {Path(TOUR).name: play_tour, "01_geometry.ipynb": play_distance}

"""The course in a real JupyterLab: every notebook runs there, and what can be played with moves."""

import os
import shutil
import sys
from pathlib import Path

import pytest
from lab_driver import RUN_ALL, lab, needs_chromium, notebook_page

from kinoedu.lab import TOUR, has_display, lab_command

HOUSE = Path(__file__).resolve().parent.parent
TOLD = "document.querySelectorAll('.kinoedu-told')"


@pytest.fixture
def course(tmp_path):
    """A copy of the notebooks, since running them in JupyterLab saves them."""
    needs_chromium()
    shutil.copytree(HOUSE / "notebooks", tmp_path / "course" / "notebooks")
    return tmp_path / "course"


def test_the_tour_runs_and_its_boards_move(course, tmp_path):
    """All cells run without error and without a request to the outside; the first board is dragged, scrubbed, and replanned."""
    with lab(course, tmp_path) as (address, token), notebook_page(address, token, TOUR) as page:
        book = page.evaluate(RUN_ALL)
        code = [cell for cell in book["cells"] if cell["cell_type"] == "code"]
        assert all(cell["execution_count"] for cell in code)
        assert [o["evalue"] for cell in code for o in cell["outputs"] if o["output_type"] == "error"] == []
        board = page.locator(".kinoedu-board").first
        board.scroll_into_view_if_needed()  # JupyterLab renders what is in view
        page.wait_for_function(f"() => {TOLD}[0].innerText === 'RRT: a path of length 270.4, 78 nodes'")
        board.locator("[data-thing=handle-1]").scroll_into_view_if_needed()
        goal, whole = board.locator("[data-thing=handle-1]").bounding_box(), board.locator("canvas").screenshot()
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
        board.scroll_into_view_if_needed()
        page.screenshot(path=os.environ.get("KINOEDU_SCREENSHOT", str(tmp_path / "tour.png")))
        assert page.outside == [] and page.errors == []


def test_lesson_1_runs_and_its_board_is_dragged(course, tmp_path):
    """The whole lesson, and what its prediction asks for: q through the notch, by pointer and by keys."""
    with lab(course, tmp_path) as (address, token), notebook_page(address, token, "notebooks/01_geometry.ipynb") as page:
        book = page.evaluate(RUN_ALL)
        code = [cell for cell in book["cells"] if cell["cell_type"] == "code"]
        assert all(cell["execution_count"] for cell in code)
        assert [o["evalue"] for cell in code for o in cell["outputs"] if o["output_type"] == "error"] == []
        page.evaluate("() => document.querySelector('.kinoedu-board')?.scrollIntoView({block: 'center'})")
        board = page.locator(".kinoedu-board").first
        board.scroll_into_view_if_needed()
        page.wait_for_function(f"() => {TOLD}[0].innerText.includes('distance 0.8')")
        q = board.locator("[data-thing=handle-0]")
        q.focus()
        for _ in range(3):
            q.press("ArrowLeft")
        page.wait_for_function(f"() => {TOLD}[0].innerText.includes('distance') && !{TOLD}[0].innerText.includes('distance 0.8,')")
        page.screenshot(path=os.environ.get("KINOEDU_SCREENSHOT", str(tmp_path / "lesson.png")))
        assert page.outside == [] and page.errors == []


def test_jupyter_keeps_its_token_and_stays_on_this_computer(monkeypatch):
    """The command listens on localhost and switches no guard off; without a display it opens no browser."""
    command = lab_command(browser=False)
    assert command[:4] == [sys.executable, "-m", "jupyterlab", TOUR]
    assert "--ServerApp.ip=127.0.0.1" in command
    assert "--no-browser" in command
    assert "--no-browser" not in lab_command(browser=True)
    assert not any("token" in word or "password" in word or "xsrf" in word for word in command)
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    assert not has_display()

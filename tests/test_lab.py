"""The course in a real JupyterLab: every notebook runs there, and what can be played with moves."""

import os
import shutil
import sys
from pathlib import Path

import pytest
from lab_driver import CHROMIUM, RUN_ALL, lab, notebook_page

from kinoedu.lab import TOUR, has_display, lab_command

HOUSE = Path(__file__).resolve().parent.parent


@pytest.fixture
def course(tmp_path):
    """A copy of the notebooks, since running them in JupyterLab saves them."""
    if CHROMIUM is None:
        if os.environ.get("CI"):
            pytest.fail("this test needs Chromium, which the project's CI installs")
        pytest.skip("Chromium is not installed here; the same notebooks are run without a browser by nbval")
    shutil.copytree(HOUSE / "notebooks", tmp_path / "course" / "notebooks")
    return tmp_path / "course"


def test_the_tour_runs_and_its_explorer_moves(course, tmp_path):
    """All cells run without error and without a request to the outside; scrubbing and another planner change the picture."""
    with lab(course, tmp_path) as (address, token), notebook_page(address, token, TOUR) as page:
        book = page.evaluate(RUN_ALL)
        code = [cell for cell in book["cells"] if cell["cell_type"] == "code"]
        assert all(cell["execution_count"] for cell in code)
        assert [o["evalue"] for cell in code for o in cell["outputs"] if o["output_type"] == "error"] == []
        page.locator("img.kinoedu-explorer").first.scroll_into_view_if_needed()  # JupyterLab renders what is in view
        said = "document.querySelector('.kinoedu-state').innerText"
        page.wait_for_function(f"() => {said}.includes('a path of length')")
        picture, told = page.locator("img.kinoedu-explorer").first, page.locator(".kinoedu-state").first.inner_text()
        whole = picture.get_attribute("src")
        growth = page.locator(".jupyter-widgets:has-text('growth') [role=slider][aria-valuemax='60.0']").first
        growth.focus()
        for _ in range(20):
            growth.press("ArrowLeft")
        page.wait_for_function(f"() => {said}.includes(' of ') && !{said}.includes('a path')")
        assert picture.get_attribute("src") != whole
        page.locator("select").filter(has_text="A* on a grid").first.select_option(label="A* on a grid")
        page.wait_for_function(f"told => {said}.startsWith('A*: a path') && {said} != told", arg=told)
        picture.scroll_into_view_if_needed()
        page.screenshot(path=os.environ.get("KINOEDU_SCREENSHOT", str(tmp_path / "tour.png")))
        assert page.outside == []


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

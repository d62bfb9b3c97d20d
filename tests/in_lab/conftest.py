"""The page of JupyterLab in which each file here opens notebooks of its own."""

import shutil
from contextlib import contextmanager
from pathlib import Path

import pytest
from lab_driver import OPEN, RUN_ALL, lab, lab_page, needs_chromium, written_notebook

HOUSE = Path(__file__).resolve().parent.parent.parent
SHUT_DOWN = """async () => {
    const { context, sessionContext } = jupyterapp.shell.currentWidget;
    await context.save();
    await sessionContext.shutdown();
    jupyterapp.shell.currentWidget.close(); }"""


@pytest.fixture(scope="package")
def opened(tmp_path_factory):
    """JupyterLab on a copy of the lessons, because it saves them; `page.course` is their folder."""
    needs_chromium()
    course = tmp_path_factory.mktemp("course")
    shutil.copytree(HOUSE / "notebooks", course / "notebooks")
    with (
        lab(course, tmp_path_factory.mktemp("home")) as (address, token),
        lab_page(address, token) as page,
    ):
        page.course = course
        yield page


@pytest.fixture(scope="module")
def run_in_lab(opened):
    """A function that shows the page with a notebook whose cells have run.

    No cell fails, the browser reports no error, and nothing is asked of other computers.
    """

    @contextmanager
    def run(*cells):
        (opened.course / "boards.ipynb").write_text(written_notebook(*cells))
        opened.outside.clear()
        opened.errors.clear()
        opened.evaluate(OPEN, ["boards.ipynb", None])
        try:
            book = opened.evaluate(RUN_ALL)
            outputs = [output for cell in book["cells"] for output in cell["outputs"]]
            assert [one["evalue"] for one in outputs if one["output_type"] == "error"] == []
            yield opened
            assert opened.outside == [] and opened.errors == []
        finally:  # the next file must not find these boards
            opened.evaluate(SHUT_DOWN)

    return run

"""The course in a real JupyterLab: every board is painted there, and what can be played with moves.

One lesson runs whole. Of the others, whose cells nbval runs, only what their boards need.
"""

import importlib
import json
import os
import re
import shutil
import subprocess
import sys
import urllib.request
from pathlib import Path

import pytest
from board_cells import keep_what_boards_need
from lab_driver import RUN_ALL, keep, lab, needs_chromium, notebook_page

import kinoedu.lab
from kinoedu.errors import InvalidParameter
from kinoedu.lab import TOUR, has_display, lab_command

HOUSE = Path(__file__).resolve().parent.parent
LESSONS = sorted(path.name for path in (HOUSE / "notebooks").glob("*.ipynb"))
WHOLE = "09_trees.ipynb"
TOLD = "document.querySelectorAll('.kinoedu-text')"
# JupyterLab renders what is in view
SCROLL = "number => jupyterapp.shell.currentWidget.content.scrollToItem(number, 'center')"
SHOW = """number => jupyterapp.shell.currentWidget.content.widgets[number].node
    .querySelector('.kinoedu-board, .kinoedu-solid').scrollIntoView({block: 'center'})"""
OPEN = """async ([path, id]) => {
    const { commands, shell } = jupyterapp;
    const kernel = id ? {id} : undefined;
    await commands.execute('docmanager:open', {path, factory: 'Notebook', kernel});
    await shell.currentWidget.context.ready;
    await shell.currentWidget.sessionContext.ready;
    return shell.currentWidget.sessionContext.session.kernel.id; }"""
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
def opened(tmp_path_factory):
    """One page of JupyterLab for all, on a copy of the notebooks, because JupyterLab saves them."""
    needs_chromium()
    course = tmp_path_factory.mktemp("course")
    shutil.copytree(HOUSE / "notebooks", course / "notebooks")
    for lesson in LESSONS:
        file = course / "notebooks" / lesson
        if lesson != WHOLE:
            book = keep_what_boards_need(json.loads(file.read_text("utf-8")), boards_of(lesson))
            file.write_text(json.dumps(book), encoding="utf-8")
    with (
        lab(course, tmp_path_factory.mktemp("home")) as (address, token),
        notebook_page(address, token, TOUR) as page,
    ):
        page.kernel = None
        yield page


@pytest.fixture
def page(opened):
    """The page, with no notebook open afterwards, and without the errors of earlier notebooks."""
    opened.outside.clear()
    opened.errors.clear()
    yield opened
    opened.evaluate(CLOSE)


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


def test_jupyter_keeps_its_token_and_stays_on_this_computer(monkeypatch):
    """The command listens on localhost, asks nobody for news and switches no guard off; without a
    display it opens no browser.
    """
    command = lab_command(browser=False)
    assert command[:3] == [sys.executable, "-m", "jupyterlab"]
    assert TOUR not in command  # its folder would be all that can be opened
    assert "--ServerApp.ip=127.0.0.1" in command
    assert "--LabApp.news_url=None" in command
    assert "--no-browser" in command
    assert "--no-browser" not in lab_command(browser=True)
    assert not any("token" in word or "password" in word or "xsrf" in word for word in command)
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    assert not has_display()


def test_a_course_that_is_only_read_is_written_at_home(monkeypatch, tmp_path):
    """Lessons, exercises and maps are copied once; what a student wrote there is kept."""
    assert kinoedu.lab.lessons() == HOUSE
    monkeypatch.setattr(kinoedu.lab.os, "access", lambda *_: False)
    monkeypatch.setattr(Path, "home", lambda: tmp_path)
    assert kinoedu.lab.lessons() == tmp_path / "kinoedu"
    tour, town = (
        tmp_path / "kinoedu" / TOUR,
        tmp_path / "kinoedu" / "notebooks" / "maps" / "Paris_1_256.map",
    )
    assert tour.read_bytes() == (HOUSE / TOUR).read_bytes() and town.is_file()
    tour.write_text("mine", encoding="utf-8")
    town.unlink()
    kinoedu.lab.lessons()
    assert tour.read_text(encoding="utf-8") == "mine" and town.is_file()


def test_what_is_compiled_meanwhile_ends_with_the_lab(monkeypatch):
    """A server that stops at once leaves no process behind."""
    started = []

    class Noted(subprocess.Popen):
        def __init__(self, *args, **options):
            super().__init__(*args, **options)
            started.append(self)

    monkeypatch.setattr(subprocess, "Popen", Noted)
    monkeypatch.setattr(
        kinoedu.lab, "lab_command", lambda browser: [sys.executable, "-c", "raise SystemExit(3)"]
    )
    assert kinoedu.lab.open_lab(browser=False) == 3
    assert [process.poll() is None for process in started] == [False, False]
    assert started[1].args[1:] == ["-m", "kinoedu", "warm", "--behind"]


def test_figures_are_shown_where_the_caller_shows_none(monkeypatch):
    """MPLBACKEND, which servers and editors set, would lead a lesson's figures elsewhere."""
    monkeypatch.setenv("MPLBACKEND", "agg")
    code = "import os; raise SystemExit(3 if 'MPLBACKEND' in os.environ else 4)"
    monkeypatch.setattr(kinoedu.lab, "lab_command", lambda browser: [sys.executable, "-c", code])
    assert kinoedu.lab.open_lab(browser=False) == 4


@pytest.mark.skipif(sys.platform == "win32", reason="Windows ends a process without asking it")
def test_a_terminated_lab_leaves_no_server_behind():
    """As where a container or a service manager stops it."""
    endless = [sys.executable, "-c", "import time; time.sleep(600)"]
    code = (
        "import kinoedu.lab as lab; lab.address_of = lambda server: print(server.pid); "
        f"lab.lab_command = lambda browser: {endless!r}; raise SystemExit(lab.open_lab())"
    )
    running = subprocess.Popen(
        [sys.executable, "-u", "-c", code], stdout=subprocess.PIPE, text=True, cwd=HOUSE
    )
    number = int(running.stdout.readline())
    running.terminate()
    assert running.wait() != 0
    with pytest.raises(ProcessLookupError):
        os.kill(number, 0)
    running.stdout.close()


def test_without_jupyterlab_a_line_says_what_to_install(monkeypatch):
    """Nothing is started, and nothing is copied."""
    monkeypatch.setattr(kinoedu.lab.importlib.util, "find_spec", lambda name: None)
    monkeypatch.setattr(kinoedu.lab, "copy_lessons", lambda folder: pytest.fail("copied"))
    with pytest.raises(InvalidParameter, match="pip install jupyterlab"):
        kinoedu.lab.open_lab(browser=False)


def test_a_home_that_cannot_be_written_is_refused_in_a_line(monkeypatch, tmp_path):
    """Before JupyterLab begins, which would end with a traceback."""
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("JUPYTER_RUNTIME_DIR", str(tmp_path / "file" / "runtime"))
    monkeypatch.setattr(kinoedu.lab, "lab_command", lambda browser: pytest.fail("it began"))
    with pytest.raises(InvalidParameter, match="set HOME to a folder of yours"):
        kinoedu.lab.open_lab(tmp_path / "lessons", browser=False)


def test_the_lab_sends_small_messages_at_once():
    """Its connection is JupyterLab's, with Nagle's algorithm switched off when it connects."""
    from jupyter_server.services.kernels.connection.channels import ZMQChannelsWebsocketConnection

    name = "--ServerApp.kernel_websocket_connection_class="
    (given,) = [word for word in lab_command(browser=False) if word.startswith(name)]
    module, _, kind = given.removeprefix(name).rpartition(".")
    connection = getattr(importlib.import_module(module), kind)
    assert issubclass(connection, ZMQChannelsWebsocketConnection)
    heard = []

    class Handler:
        def set_nodelay(self, value):
            heard.append(value)

    class Begun(Exception):
        """The connection goes on to connect."""

    class Stub(connection):
        websocket_handler = Handler()

        @property
        def multi_kernel_manager(self):
            raise Begun

    with pytest.raises(Begun):
        Stub.connect(Stub.__new__(Stub))
    assert heard == [True]


def test_a_kernel_does_not_warn_of_eavesdroppers(tmp_path):
    """In the terminal, where a student would wonder; what it says is encrypted."""
    from jupyter_client import BlockingKernelClient
    from lab_driver import lab

    (tmp_path / "course").mkdir()
    (tmp_path / "home").mkdir()
    with lab(tmp_path / "course", tmp_path / "home") as (address, token):
        headers = {"Authorization": f"token {token}", "Content-Type": "application/json"}
        asked = urllib.request.Request(f"{address}/api/kernels", b"{}", headers)
        with urllib.request.urlopen(asked, timeout=60) as answer:
            kernel = json.load(answer)["id"]
        (file,) = (tmp_path / "home" / "jupyter_runtime_dir").glob(f"kernel-{kernel}.json")
        client = BlockingKernelClient(connection_file=str(file))
        client.load_connection_file()
        client.start_channels()
        client.wait_for_ready(60)
        client.stop_channels()
    assert "encryption" not in (tmp_path / "home" / "server.log").read_text()

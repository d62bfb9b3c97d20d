"""The command that opens JupyterLab: what it starts, asks for, copies and leaves behind."""

import ast
import importlib
import json
import os
import subprocess
import sys
import urllib.request
from pathlib import Path

import lab_driver
import pytest

import kinoedu.lab
from kinoedu.errors import InvalidParameter
from kinoedu.lab import TOUR, has_display, lab_command

HOUSE = Path(__file__).resolve().parent.parent


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

    (tmp_path / "course").mkdir()
    (tmp_path / "home").mkdir()
    with lab_driver.lab(tmp_path / "course", tmp_path / "home") as (address, token):
        headers = {"Authorization": f"token {token}", "Content-Type": "application/json"}
        asked = urllib.request.Request(f"{address}/api/kernels", b"{}", headers)
        with urllib.request.urlopen(asked, timeout=60) as answer:
            kernel = json.load(answer)["id"]
        (file,) = (tmp_path / "home" / "jupyter_runtime_dir").glob(f"kernel-{kernel}.json")
        client = BlockingKernelClient(connection_file=str(file))
        client.load_connection_file()
        client.start_channels()
        client.kernel_info(reply=True, timeout=60)  # its heart may be late while it imports
        client.stop_channels()
    assert "encryption" not in (tmp_path / "home" / "server.log").read_text()


def test_scripts_find_what_drives_the_lab():
    """Those that make pictures and measure boards, which no other test runs."""
    for script in (*HOUSE.glob("docs/*.py"), *HOUSE.glob("benchmarks/*.py")):
        for node in ast.walk(ast.parse(script.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and node.module == "lab_driver":
                missing = [one.name for one in node.names if not hasattr(lab_driver, one.name)]
                assert missing == [], script

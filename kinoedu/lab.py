"""Opens the course in JupyterLab, on this computer only, with its token kept."""

import json
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

from .errors import UnreadableScene

COURSE = Path(__file__).resolve().parent.parent
TOUR = "notebooks/00_tour.ipynb"


def open_lab(*, browser: bool = True) -> int:
    """Run JupyterLab at the tour until it is stopped.

    The lessons' functions are compiled meanwhile, those of the first lessons first. Without a
    display the address is only printed.

    Returns
    -------
    int
        The exit status of JupyterLab.

    Raises
    ------
    UnreadableScene
        Where the tour is missing.
    """
    if not (COURSE / TOUR).is_file():
        raise UnreadableScene(
            f"{COURSE / TOUR} is missing: start the course from its own folder, with python "
            "start.py"
        )
    server = subprocess.Popen(lab_command(browser=browser and has_display()), cwd=lessons())
    silent = subprocess.DEVNULL
    warm = [sys.executable, "-m", "kinoedu", "warm", "--behind"]
    warming = subprocess.Popen(warm, cwd=COURSE, stdin=silent, stdout=silent, stderr=silent)
    try:
        address = address_of(server)
        if address:
            print(f"\nThe course is open at\n\n    {address}\n\nStop it with Ctrl-C.\n", flush=True)
        return server.wait()
    except KeyboardInterrupt:
        server.wait()
        return 130
    finally:
        warming.terminate()
        warming.wait()


def lessons() -> Path:
    """The folder of the notebooks: the course's, or one in the user's home if that is read-only."""
    writable = os.access(COURSE / "notebooks", os.W_OK)
    return COURSE if writable else copy_lessons(Path.home() / "kinoedu")


def copy_lessons(folder: Path) -> Path:
    """Copy missing lessons, maps and exercises into a folder, and return it.

    Files that are there are kept, because they hold the student's work.
    """
    for room in ("notebooks", "exercises"):
        for source in sorted((COURSE / room).rglob("*")):
            copy = folder / source.relative_to(COURSE)
            if source.is_file() and not copy.exists():
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(source, copy)  # without its mode, so that the copy is writable
    return folder


def lab_command(*, browser: bool) -> list[str]:
    """The command that starts JupyterLab, without news and update checks over the network."""
    command = [
        sys.executable,
        "-m",
        "jupyterlab",
        TOUR,
        "--ServerApp.ip=127.0.0.1",
        "--ServerApp.answer_yes=True",
        "--LabApp.news_url=None",
        "--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate",
        "--log-level=WARN",
    ]
    if not browser:
        command.append("--no-browser")
    if hasattr(os, "geteuid") and os.geteuid() == 0:
        command.append("--allow-root")  # for containers; the token still protects the server
    return command


def has_display() -> bool:
    """Whether a browser could open a window here."""
    return sys.platform in ("win32", "darwin") or bool(
        os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")
    )


def address_of(server: "subprocess.Popen[bytes]") -> str | None:
    """The tour's address with its token, once the server has stored it; None if it ended."""
    from jupyter_core.paths import jupyter_runtime_dir

    note = Path(jupyter_runtime_dir()) / f"jpserver-{server.pid}.json"
    while server.poll() is None:
        try:
            running = json.loads(note.read_text(encoding="utf-8"))
        except (OSError, ValueError):
            time.sleep(0.1)
            continue
        return f"{running['url']}lab/tree/{TOUR}?token={running['token']}"
    return None

"""Opens the course in JupyterLab, on this computer only, with its token kept."""

import importlib.util
import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

from .errors import InvalidParameter, UnreadableScene
from .support.whole_files import written_whole

TOUR = "notebooks/00_tour.ipynb"
CONNECTION = "kinoedu.cli.prompt_socket.PromptConnection"
PACKAGE = Path(__file__).resolve().parent
# The lessons are in the package where pip has installed it, and beside it in the whole course.
COURSE = PACKAGE if (PACKAGE / TOUR).is_file() else PACKAGE.parent


def open_lab(folder: Path | None = None, *, browser: bool = True) -> int:
    """Run JupyterLab at the tour until it is stopped, by Ctrl-C or by SIGTERM.

    The lessons' functions are compiled meanwhile, those of the first lessons first. Without a
    display the address is only printed.

    Parameters
    ----------
    folder : where the lessons are opened, as in `lessons`.

    Returns
    -------
    int
        The exit status of JupyterLab.

    Raises
    ------
    InvalidParameter
        Where JupyterLab is not installed, or cannot keep its files in the user's home.
    UnreadableScene
        Where the tour is missing.
    """
    if importlib.util.find_spec("jupyterlab") is None:
        raise InvalidParameter("the lab needs JupyterLab: python -m pip install jupyterlab")
    place = lessons(folder)
    make_runtime_folder()
    # with the caller's choice of a backend, lessons would show no figures
    kept = {name: value for name, value in os.environ.items() if name != "MPLBACKEND"}
    command = lab_command(browser=browser and has_display())
    server = subprocess.Popen(command, cwd=place, env=kept)
    silent = subprocess.DEVNULL
    warm = [sys.executable, "-m", "kinoedu", "warm", "--behind"]
    warming = subprocess.Popen(warm, cwd=PACKAGE.parent, stdin=silent, stdout=silent, stderr=silent)
    before = signal.signal(signal.SIGTERM, lambda *_: server.terminate())
    try:
        address = address_of(server)
        if address:
            print(
                f"\nThe course is open at\n\n    {address}\n\nThe lessons are in {place}. Stop it "
                "with Ctrl-C.\n",
                flush=True,
            )
        return server.wait()
    except KeyboardInterrupt:
        server.wait()
        return 130
    finally:
        signal.signal(signal.SIGTERM, before)
        warming.terminate()
        warming.wait()


def make_runtime_folder() -> None:
    """Make the folder that JupyterLab needs while it runs. Raises InvalidParameter."""
    from jupyter_core.paths import jupyter_runtime_dir

    folder = Path(jupyter_runtime_dir())
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    except OSError as error:
        raise InvalidParameter(
            f"JupyterLab keeps its files in your home, and {folder} cannot be made "
            f"({error.strerror}): set HOME to a folder of yours"
        ) from error


def lessons(folder: Path | None = None) -> Path:
    """The folder of the notebooks, where students work.

    Parameters
    ----------
    folder : missing lessons are copied to it. By default it is the course's own folder; where that
        is read-only, or is a package that pip has installed, it is kinoedu in the user's home.

    Raises
    ------
    UnreadableScene
        Where the tour is missing.
    """
    is_own = COURSE != PACKAGE and os.access(COURSE / "notebooks", os.W_OK)
    if folder is None and is_own and (COURSE / TOUR).is_file():
        return COURSE
    place = (folder or Path.home() / "kinoedu").resolve()
    copy_lessons(place)
    return place


def copy_lessons(folder: Path) -> list[Path]:
    """Copy missing lessons, maps and exercises into a folder, and return the copies.

    Files that are there are kept, because they hold the student's work.

    Raises
    ------
    UnreadableScene
        Where the course has no tour to copy.
    """
    if not (COURSE / TOUR).is_file():
        raise UnreadableScene(
            f"{COURSE / TOUR} is missing: start the course from its own folder, with python "
            "start.py"
        )
    copies = []
    for room in ("notebooks", "exercises"):
        for source in sorted((COURSE / room).rglob("*")):
            place = source.relative_to(COURSE)
            copy, hidden = folder / place, any(part.startswith(".") for part in place.parts)
            if source.is_file() and not hidden and not os.path.lexists(copy):
                copy.parent.mkdir(parents=True, exist_ok=True)
                with written_whole(copy) as part:  # a half would be kept as the student's work
                    shutil.copyfile(source, part)  # without its mode, so that it is writable
                copies.append(copy)
    return copies


def lab_command(*, browser: bool) -> list[str]:
    """The command that starts JupyterLab, without news and update checks over the network."""
    import zmq  # which JupyterLab brings

    command = [
        sys.executable,
        "-m",
        "jupyterlab",
        f"--LabApp.default_url=/lab/tree/{TOUR}",  # a file as argument would hide the exercises
        "--ServerApp.ip=127.0.0.1",
        "--ServerApp.answer_yes=True",
        "--LabApp.news_url=None",
        "--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate",
        "--log-level=WARN",
        f"--ServerApp.kernel_websocket_connection_class={CONNECTION}",
    ]
    if zmq.has("curve"):  # kernels that do not encrypt warn of eavesdroppers, in the terminal
        command.append("--KernelManager.transport_encryption=auto")
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

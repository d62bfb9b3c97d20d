"""What a class needs on one server: several students have a lesson open at once, each in a
JupyterLab and a kernel of their own, and have run it as far as its first board.

Memory is told apart by Linux: what a student adds is private, and what all have from the same files
is shared. Compile the code before, into a folder that KINOEDU_WARMED names, as on a hub:

    KINOEDU_CACHE=/tmp/warmed python -m kinoedu warm
    KINOEDU_WARMED=/tmp/warmed python benchmarks/classroom.py
"""

import argparse
import json
import os
import re
import statistics
import subprocess
import tempfile
import time
from contextlib import suppress
from pathlib import Path
from typing import Any, NamedTuple
from urllib.request import urlopen

import nbformat
from jupyter_client import KernelManager
from jupyter_client.blocking import BlockingKernelClient

from kinoedu.lab import lab_command

HOUSE = Path(__file__).resolve().parent.parent
NOTEBOOKS = HOUSE / "notebooks"
BOARD = "application/vnd.kinoedu.board+json"
# a page drags the board's last handle a little, and waits for the answer
CLICK = """
import gc as _gc, time as _time
from kinoedu.boards.core.canvas import Canvas as _Canvas
_canvas = next(one for one in _gc.get_objects() if isinstance(one, _Canvas))
_number = len(_canvas.scene["handles"]) - 1
_x, _y = _canvas.scene["handles"][_number]["at"]
_moved = {"kind": "scene", "from": "page", "seq": 1, "moved": [["handle", _number, [_x, _y - 3]]]}
_began = _time.perf_counter()
_canvas._received(_canvas, _moved, [])
print("took", _time.perf_counter() - _began)
"""


class Memory(NamedTuple):
    """Bytes of a process: its own, those it shares, and all with a fair part of what is shared."""

    private: int
    shared: int
    fair: int


class Student(NamedTuple):
    """What one student's processes hold, and how long the student waits."""

    server: Memory
    kernel: Memory
    first_board: float
    first_click: float


def read_memory(pid: int) -> Memory:
    """Ask Linux what a process holds."""
    text = Path(f"/proc/{pid}/smaps_rollup").read_text(encoding="ascii")
    held = {name: int(kilo) * 1024 for name, kilo in re.findall(r"(\w+): +(\d+) kB", text)}
    return Memory(
        held["Private_Clean"] + held["Private_Dirty"],
        held["Shared_Clean"] + held["Shared_Dirty"],
        held["Pss"],
    )


def cells_to_first_board(file: Path) -> list[str]:
    """The code of a lesson's cells, the last of which shows its first board."""
    cells: list[str] = []
    for cell in nbformat.read(file, as_version=4).cells:
        if cell.cell_type == "code":
            cells.append(cell.source)
            if any(BOARD in output.get("data", {}) for output in cell.outputs):
                return cells
    raise SystemExit(f"{file.name} has no board")


def run(client: BlockingKernelClient, code: str) -> str:
    """Run a cell; what it prints."""
    printed: list[str] = []

    def keep(message: dict[str, Any]) -> None:
        if message["msg_type"] == "stream":
            printed.append(message["content"]["text"])

    reply = client.execute_interactive(code, output_hook=keep, timeout=600)
    if reply["content"]["status"] != "ok":
        raise SystemExit("\n".join(reply["content"]["traceback"]))
    return "".join(printed)


def begin(home: Path) -> tuple[dict[str, str], "subprocess.Popen[bytes]"]:
    """A student logs in: a home with nothing in it, and a JupyterLab."""
    variables = os.environ | {"KINOEDU_CACHE": str(home / "cache"), "HOME": str(home)}
    variables |= {"JUPYTER_RUNTIME_DIR": str(home / "run"), "IPYTHONDIR": str(home / "ipython")}
    home.mkdir()
    silent = subprocess.DEVNULL
    command = lab_command(browser=False)
    return variables, subprocess.Popen(
        command, cwd=HOUSE, env=variables, stdout=silent, stderr=silent
    )


def open_page(home: Path, lesson: str) -> None:
    """Wait until a JupyterLab has started, and ask for its page and for a lesson as browsers do."""
    while True:
        time.sleep(0.1)
        with suppress(OSError, ValueError, StopIteration):
            note = next((home / "run").glob("jpserver-*.json"))
            server = json.loads(note.read_text(encoding="utf-8"))
            for path in ("lab", f"api/contents/notebooks/{lesson}"):
                with urlopen(f"{server['url']}{path}?token={server['token']}", timeout=60) as page:
                    page.read()
            return


def open_lesson(
    cells: list[str], variables: dict[str, str]
) -> tuple[KernelManager, BlockingKernelClient, float, float]:
    """Start a kernel, run cells, and drag on the board; the seconds of both."""
    began = time.perf_counter()
    kernel = KernelManager(kernel_name="python3")
    kernel.start_kernel(env=variables, cwd=str(NOTEBOOKS))
    client = kernel.client()
    client.start_channels()
    client.wait_for_ready(timeout=120)
    for cell in cells:
        run(client, cell)
    shown = time.perf_counter() - began
    return kernel, client, shown, float(run(client, CLICK).split()[-1])


def measure(lesson: str, at_once: int) -> list[Student]:
    """Let some students open a lesson one after another; measure when all have it open."""
    (file,) = NOTEBOOKS.glob(f"{lesson}*.ipynb")
    cells, opened = cells_to_first_board(file), []
    with tempfile.TemporaryDirectory() as place:
        try:
            for number in range(at_once):
                home = Path(place) / f"student{number}"
                variables, server = begin(home)
                open_page(home, file.name)
                opened.append((server, *open_lesson(cells, variables)))
            return [
                Student(
                    read_memory(server.pid), read_memory(kernel.provisioner.pid), shown, clicked
                )
                for server, kernel, _, shown, clicked in opened
            ]
        finally:
            for server, kernel, client, *_ in opened:
                client.stop_channels()
                kernel.shutdown_kernel(now=True)
                server.terminate()
                server.wait()


def main() -> None:
    """Print a table, and what a class needs."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("lesson", nargs="?", default="00_tour", help="the beginning of its name")
    options.add_argument("--students", type=int, default=120, help="of the class")
    options.add_argument("--at-once", type=int, default=4, help="how many are measured together")
    given = options.parse_args()
    students = measure(given.lesson, given.at_once)
    print("| a student's | private, MB | shared, MB | with a fair part of the shared, MB |")
    print("|---|---:|---:|---:|")
    each = {}
    for name in ("server", "kernel"):
        held = [getattr(student, name) for student in students]
        each[name] = [statistics.median(column) / 1e6 for column in zip(*held)]
        print(f"| {name} | {' | '.join(f'{number:.0f}' for number in each[name])} |")
    private = each["server"][0] + each["kernel"][0]
    shared = each["server"][1] + each["kernel"][1]
    total = (given.students * private + shared) / 1e3
    print(
        json.dumps(
            {
                "students": given.students,
                "private of each, MB": round(private),
                "all together, GB": round(total, 1),
                "first board, s": [round(student.first_board, 1) for student in students],
                "first click, s": [round(student.first_click, 2) for student in students],
            },
            indent=1,
        )
    )


if __name__ == "__main__":
    main()

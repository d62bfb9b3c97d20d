"""A reader's first minute: the tour's first board in a new JupyterLab, dragged as soon as it is
there, with an empty cache of machine code, which is filled behind as the course does it, and with
what that run left.
"""

import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from board import CHROMIUM, RUN_ALL, drag, lab, written_notebook
from dragged import GOAL, HOUSE
from timing import Missing, run
from unwatched import open_notebook

from kinoedu.lab import TOUR

COLUMNS = ("picture", "first", "delay", "late", "longest", "plans", "paints")


def first_board() -> list[str]:
    """The code of the tour up to its first board."""
    cells = json.loads((HOUSE / TOUR).read_text(encoding="utf-8"))["cells"]
    code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
    end = next(number for number, source in enumerate(code) if "board(" in source)
    maps = str(HOUSE / "notebooks" / "maps")
    return [source.replace('"maps', f'"{maps}') for source in code[: end + 1]]


@contextmanager
def compiled_behind(cache: Path) -> Iterator[None]:
    """What `python start.py` compiles behind the lab, into a cache of its own."""
    os.environ["KINOEDU_CACHE"] = str(cache)
    behind = subprocess.Popen(
        [sys.executable, "-m", "kinoedu", "warm", "--behind"], stderr=subprocess.DEVNULL
    )
    try:
        yield
    finally:
        behind.terminate()
        behind.wait()


def first_minute(cache: Path, seconds: float) -> dict[str, float]:
    """Open the lab, run the tour up to its board, and drag the goal."""
    with tempfile.TemporaryDirectory() as home, tempfile.TemporaryDirectory() as course:
        (Path(course) / "tour.ipynb").write_text(written_notebook(*first_board()))
        with (
            compiled_behind(cache),
            lab(Path(course), Path(home)) as (address, token),
            open_notebook(address, token, "tour.ipynb") as browser,
        ):
            began = time.perf_counter()
            browser.page.evaluate(RUN_ALL)
            browser.page.wait_for_selector(".kinoedu-board[data-answers]")
            picture = time.perf_counter() - began
            return {"picture": picture, **drag(browser, GOAL, seconds)}


def main(seconds: float = 20.0, repeats: int = 3) -> None:
    """Some rounds, each with an empty cache and then with what the round has left in it."""
    if CHROMIUM is None:
        raise Missing("Chromium")
    print(
        "| cache | board is there, s | first answer, ms | median, ms | 95 % | longest | plans/s | "
        "paints/s |"
    )
    print("|---|---:|---:|---:|---:|---:|---:|---:|")
    for _ in range(repeats):
        with tempfile.TemporaryDirectory() as place:
            for cache in ("empty", "left by that run"):
                seen = first_minute(Path(place), seconds)
                cells = [f"{seen[name]:.3g}" for name in COLUMNS]
                print(f"| {cache} | {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    run(main)

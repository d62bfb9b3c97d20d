"""How lively a board is: new plans and paints a second while a thing is dragged, in a real
JupyterLab in headless Chromium.
"""

import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext
from pathlib import Path
from typing import Any

import numpy as np
from dragged import BOARDS, HOUSE
from timing import Missing, run

from kinoedu.compiled import COMPILED_FIRST

sys.path.insert(0, str(HOUSE / "tests"))

# E402: the file lies in tests, which the line above adds to the path
from lab_driver import CHROMIUM, RUN_ALL, lab, notebook_page, written_notebook

SECONDS = 900
LISTEN = """board => {
    window.events = []; window.held = board;
    if (board.heard) return;
    board.heard = true;
    for (const what of ['sent', 'answered', 'painted'])
        board.addEventListener('kinoedu-' + what,
            e => { if (held === board) events.push([what, e.detail, performance.now()]); }); }"""
# The real mouse holds the thing; its moves are made in the page, a hundred a second, as
# Playwright's own wait for each other.
DRAG = """([board, x, y, seconds]) => new Promise(done => {
    const canvas = board.querySelector('canvas'), began = performance.now(); let moves = 0;
    const timer = setInterval(() => {
        const t = (performance.now() - began) / 1000;
        if (t > seconds) { clearInterval(timer); done(moves / t); return; }
        const [clientX, clientY] = [x - 40 + 40 * Math.cos(3 * t), y + 40 * Math.sin(3 * t)];
        const where = {clientX, clientY, pointerId: 1, bubbles: true};
        canvas.dispatchEvent(new PointerEvent('pointermove', where)); moves += 1;
    }, 10); })"""
SLIDE = """([board, seconds]) => new Promise(done => {
    const slider = board.querySelector('input'), began = performance.now(); let moves = 0;
    const [lo, hi] = [Number(slider.min), Number(slider.max)];
    const timer = setInterval(() => {
        const t = (performance.now() - began) / 1000;
        if (t > seconds) { clearInterval(timer); done(moves / t); return; }
        slider.value = lo + (hi - lo) * (0.5 + 0.4 * Math.sin(3 * t));
        slider.dispatchEvent(new Event('input', {bubbles: true})); moves += 1;
    }, 10); })"""
SETTLED = "board => board.dataset.seq === board.dataset.newest"
GOALS = {"plans": 44.0, "paints": 55.0}


def drag(page: Any, name: str, seconds: float, number: int = 0) -> dict[str, float]:
    """Drag a thing of one of a page's boards round in circles; what was seen meanwhile, and for how
    long.
    """
    board = page.locator(".kinoedu-board").nth(number)
    board.scroll_into_view_if_needed()
    board.locator(".kinoedu-reset").click()  # all rounds begin with the same scene
    page.wait_for_timeout(500)
    page.wait_for_function(SETTLED, arg=board.element_handle())  # on a slow page much later
    box = board.locator(f"[data-thing={name}]").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    board.evaluate(LISTEN)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x, y + 1)
    began = time.perf_counter()
    moves = page.evaluate(DRAG, [board.element_handle(), x, y, seconds])
    spent = time.perf_counter() - began
    events = page.evaluate("events.slice()")
    page.mouse.up()
    page.wait_for_timeout(500)
    return {
        "spent": spent,
        "moves": moves,
        **seen(events, spent),
        "stale": float(board.get_attribute("data-stale")),
    }


def slide(page: Any, _: str, seconds: float) -> dict[str, float]:
    """Move the slider of a solid's plane up and down; what was seen meanwhile."""
    board = page.locator(".kinoedu-solid").first
    board.scroll_into_view_if_needed()
    board.evaluate(LISTEN)
    began = time.perf_counter()
    moves = page.evaluate(SLIDE, [board.element_handle(), seconds])
    spent = time.perf_counter() - began
    return {"spent": spent, "moves": moves, **seen(page.evaluate("events.slice()"), spent)}


def warm(page: Any, pull: Callable[..., Any], name: str, seconds: float = 120.0) -> None:
    """Drag until two drags in a row are answered, or for so long: what was not compiled yet is
    compiled meanwhile, and after a very slow answer a board asks only when nothing is dragged.
    """
    until, answered = time.perf_counter() + seconds, 0
    while answered < 2 and time.perf_counter() < until:
        try:
            pull(page, name, 1.0)
            answered += 1
        except Unanswered:
            answered = 0


class Unanswered(RuntimeError):
    """Nothing came back while a thing was dragged."""


def seen(events: list[Any], spent: float) -> dict[str, float]:
    """Rates a second, delays of answers in ms, and how often an older answer was painted after a
    newer one.
    """
    sent = {seq: when for what, seq, when in events if what == "sent"}
    answered = [(seq, when) for what, seq, when in events if what == "answered" and seq in sent]
    painted = [seq for what, seq, _ in events if what == "painted"]
    if not answered:
        raise Unanswered("nothing was answered: was anything grabbed?")
    delays = [when - sent[seq] for seq, when in answered]
    backward = sum(after < before for before, after in zip(painted, painted[1:], strict=False))
    return {
        "plans": len(answered) / spent,
        "paints": len(painted) / spent,
        "first": delays[0],
        "delay": float(np.median(delays)),
        "late": float(np.percentile(delays, 95)),
        "longest": max(delays),
        "backward": backward,
    }


def print_row(what: str, rounds: list[dict[str, float]]) -> None:
    """Print the medians of some rounds as a row."""
    mean = {key: float(np.median([r[key] for r in rounds])) for key in rounds[0]}
    verdict = (
        "holds"
        if all(mean[key] >= least for key, least in GOALS.items()) and not mean["backward"]
        else "MISSED"
    )
    cells = [
        f"{mean[key]:.3g}" for key in ("moves", "plans", "paints", "delay", "late", "backward")
    ]
    print(f"| {what} | {' | '.join(cells)} | {verdict} |", flush=True)


@contextmanager
def slow_computer(page: Any, slower: float) -> Iterator[None]:
    """Slow the page down so many times, and let another program take a core."""
    page.context.new_cdp_session(page).send("Emulation.setCPUThrottlingRate", {"rate": slower})
    busy = subprocess.Popen([sys.executable, "-c", "while True: pass"])
    try:
        yield
    finally:
        busy.kill()
        busy.wait()


def show(page: Any, name: str) -> Callable[..., dict[str, float]]:
    """Run the notebook that is open until its board is there; returns how it is dragged."""
    page.evaluate(RUN_ALL)
    is_solid = name == "solid"
    page.wait_for_selector(".kinoedu-solid" if is_solid else ".kinoedu-board[data-answers]")
    page.wait_for_timeout(2000)  # JupyterLab is still moving cells about
    return slide if is_solid else drag


def main(seconds: float = 3.0, repeats: int = 3, slower: float = 1.0, only: str = "") -> None:
    """Drag on every board and print a table.

    `seconds` is how long each is dragged. Where the computer is made `slower`, by 4.0 for example,
    another program runs beside it. `only` is a part of the names of the boards that are measured.
    """
    if CHROMIUM is None:
        raise Missing("Chromium")
    os.environ["KINOEDU_MACHINE_CODE"] = COMPILED_FIRST  # for the kernels
    chosen = [name for name in BOARDS if only in name]
    print(
        "| what is dragged | moves/s | plans/s | paints/s | delay ms, median | 95 % | out of "
        "order | |"
    )
    print("|---|---:|---:|---:|---:|---:|---:|---|")
    with tempfile.TemporaryDirectory() as home, tempfile.TemporaryDirectory() as course:
        for number, name in enumerate(chosen):
            (Path(course) / f"{number}.ipynb").write_text(written_notebook(BOARDS[name][0]))
        with lab(Path(course), Path(home)) as (address, token):
            for number, name in enumerate(chosen):
                with notebook_page(address, token, f"{number}.ipynb") as page:
                    pull = show(page, name)
                    with slow_computer(page, slower) if slower > 1.0 else nullcontext():
                        for thing in BOARDS[name][1]:
                            warm(page, pull, thing)
                            rows = [pull(page, thing, seconds) for _ in range(repeats)]
                            print_row(f"{name}: {thing}", rows)


if __name__ == "__main__":
    run(main)

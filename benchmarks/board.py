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

# E402: both need the folder tests, which the line above adds to the path
from lab_driver import CHROMIUM, RUN_ALL, lab, written_notebook
from unwatched import Browser, open_notebook

SECONDS = 900
LISTEN = """board => {
    window.events = []; window.held = board;
    if (board.heard) return;
    board.heard = true;
    for (const what of ['sent', 'answered', 'painted'])
        board.addEventListener('kinoedu-' + what,
            e => { if (held === board) events.push([what, e.detail, performance.now()]); }); }"""
PAUSE = 1.0  # seconds until a drag begins, in which the page is left
# The real mouse holds the thing; its moves are made in the page, a hundred a second, as
# Playwright's own wait for each other.
DRAG = """([board, x, y, seconds, pause]) => setTimeout(() => {
    const canvas = board.querySelector('canvas'), began = performance.now(); let moves = 0;
    const timer = setInterval(() => {
        const t = (performance.now() - began) / 1000;
        if (t > seconds) { clearInterval(timer); window.dragged = [moves / t, t]; return; }
        const [clientX, clientY] = [x - 40 + 40 * Math.cos(3 * t), y + 40 * Math.sin(3 * t)];
        const where = {clientX, clientY, pointerId: 1, bubbles: true};
        canvas.dispatchEvent(new PointerEvent('pointermove', where)); moves += 1;
    }, 10); }, 1000 * pause)"""
SLIDE = """([board, seconds, pause]) => setTimeout(() => {
    const slider = board.querySelector('input'), began = performance.now(); let moves = 0;
    const [lo, hi] = [Number(slider.min), Number(slider.max)];
    const timer = setInterval(() => {
        const t = (performance.now() - began) / 1000;
        if (t > seconds) { clearInterval(timer); window.dragged = [moves / t, t]; return; }
        slider.value = lo + (hi - lo) * (0.5 + 0.4 * Math.sin(3 * t));
        slider.dispatchEvent(new Event('input', {bubbles: true})); moves += 1;
    }, 10); }, 1000 * pause)"""
SETTLED = "board => board.dataset.seq === board.dataset.newest"
GOALS = {"plans": 44.0, "paints": 55.0}


def drag(browser: Browser, name: str, seconds: float, number: int = 0) -> dict[str, float]:
    """Drag a thing of one of a page's boards round in circles; what was seen meanwhile, and for how
    long.
    """
    page = browser.page
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
    page.evaluate(DRAG, [board.element_handle(), x, y, seconds, PAUSE])
    rates = wait_and_see(browser, seconds)
    browser.page.mouse.up()
    browser.page.wait_for_timeout(500)
    stale = browser.page.locator(".kinoedu-board").nth(number).get_attribute("data-stale")
    return {**rates, "stale": float(stale)}


def slide(browser: Browser, _: str, seconds: float) -> dict[str, float]:
    """Move the slider of a solid's plane up and down; what was seen meanwhile."""
    board = browser.page.locator(".kinoedu-solid").first
    board.scroll_into_view_if_needed()
    board.evaluate(LISTEN)
    browser.page.evaluate(SLIDE, [board.element_handle(), seconds, PAUSE])
    return wait_and_see(browser, seconds)


def wait_and_see(browser: Browser, seconds: float) -> dict[str, float]:
    """Leave the page until its drag is over; what was seen meanwhile."""
    browser.page.evaluate("() => { events.length = 0; window.dragged = null; }")
    browser.leave()
    time.sleep(PAUSE + seconds)
    browser.page.wait_for_function("window.dragged")
    (moves, spent), events = browser.page.evaluate("[dragged, events.slice()]")
    return {"spent": spent, "moves": moves, **seen(events, spent)}


def warm(browser: Browser, pull: Callable[..., Any], name: str, seconds: float = 120.0) -> None:
    """Drag until two drags in a row are answered, or for so long: what was not compiled yet is
    compiled meanwhile, and after a very slow answer a board asks only when nothing is dragged.
    """
    until, answered = time.perf_counter() + seconds, 0
    while answered < 2 and time.perf_counter() < until:
        try:
            pull(browser, name, 1.0)
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
def slow_computer(browser: Browser, slower: float) -> Iterator[None]:
    """Slow the page down so many times, and let another program take a core."""
    busy = subprocess.Popen([sys.executable, "-c", "while True: pass"])
    try:
        with browser.slowed(slower):
            yield
    finally:
        busy.kill()
        busy.wait()


def show(browser: Browser, name: str) -> Callable[..., dict[str, float]]:
    """Run the notebook that is open until its board is there; returns how it is dragged."""
    page, is_solid = browser.page, name == "solid"
    page.evaluate(RUN_ALL)
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
                with open_notebook(address, token, f"{number}.ipynb") as browser:
                    pull = show(browser, name)
                    with slow_computer(browser, slower) if slower > 1.0 else nullcontext():
                        for thing in BOARDS[name][1]:
                            warm(browser, pull, thing)
                            rows = [pull(browser, thing, seconds) for _ in range(repeats)]
                            print_row(f"{name}: {thing}", rows)


if __name__ == "__main__":
    run(main)

"""Boards that answer in a page: whether WebAssembly gives the same bits as machine code, for 200
problems of each body, how its time compares, how lively a board is that is dragged in headless
Chromium, and what a page loads.
"""

import base64
import gzip
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from board import CHROMIUM, drag
from timing import Missing, run
from unwatched import open_browser
from worlds import among_boxes, among_polygons, bitmap

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests"))

# E402: the files lie in tests, which the line above adds to the path
from lab_driver import FLAGS
from test_browser import (
    CASES,
    PLANNERS_OF_PAGES,
    ask,
    case_for_page,
    in_base64,
    run_in_page,
    shown_natively,
    write_page,
)

import kinoedu as ke
from kinoedu.boards.planning.plans import make_problem_scene
from kinoedu.browser.bodies import BODIES
from kinoedu.browser.scenes import pack_scene
from kinoedu.compiled import COMPILED_FIRST, running

CELLS = 1000
WARM = 6  # answers before which the browser is still compiling a module for speed
FAR = 1e9  # more iterations than are needed
THINGS = (
    ("RRT, goal", 0, "handle-1"),
    ("RRT, wall", 0, "polygon-0"),
    ("PRM, 200 samples, goal", 1, "handle-1"),
    ("nearest point, q", 2, "handle-0"),
    ("Dubins' and Reeds and Shepp's curves, a pose", 3, "handle-0"),
    ("BFS on a grid, start", 4, "handle-0"),
    ("RRT on a bitmap, goal", 5, "handle-1"),
    ("sweep, the line", 6, "handle-0"),
    ("arm, its tip", 7, "handle-1"),
    ("arm, a disc", 7, "disc-0"),
    ("arm, q in the square", 8, "handle-0"),
    ("Bug 1, goal", 9, "handle-1"),
    ("Bug 1, a triangle", 9, "polygon-1"),
)


def compare(page: Any, folder: Path, problems: int) -> None:
    """Print how many answers of each body are the same bits, and how far others differ."""
    print(
        "| body | problems | numbers | same bits | largest difference |\n|---|---:|---:|---:|---:|"
    )
    for name in BODIES:
        if name in PLANNERS_OF_PAGES:
            asked = [ask(name, seed, seed, COMPILED_FIRST) for seed in range(problems)]
        else:
            makers = CASES[name]
            records = [makers[k % len(makers)](k) for k in range(problems)]
            asked = [(shown_natively(record), case_for_page(record)) for record in records]
        given = run_in_page(page, folder, name, [case for _, case in asked])
        same, count, most = 0, 0, 0.0
        for (shown, _), (facts, layers, _) in zip(asked, given, strict=True):
            theirs = [np.array(facts, np.float64), *map(numbers_in, layers)]
            pairs = [(mine.ravel(), other) for mine, other in zip(shown, theirs, strict=True)]
            same += [in_base64(mine) for mine in shown[1:]] == layers and shown[0].tolist() == list(
                map(float, facts)
            )
            count += sum(len(mine) for mine, _ in pairs)
            apart = [np.abs(a[np.isfinite(a)] - b[np.isfinite(a)]) for a, b in pairs]
            most = max(most, *(values.max(initial=0.0) for values in apart))
        print(f"| {name} | {problems} | {count:,} | {same} | {most:.1g} |", flush=True)


def numbers_in(layer: str) -> np.ndarray:
    """The numbers of a layer in base64."""
    return np.frombuffer(base64.b64decode(layer))


def big_problems() -> dict[str, tuple[str, Any, list[float]]]:
    """What is timed: a body, its problem, and its settings."""
    open_cells = ke.Terrain(bitmap(0, 0.1, CELLS))
    across = ke.Problem(ke.Point(), open_cells, (0.5, 0.5), (CELLS - 0.5, CELLS - 0.5))
    tree = [0.0, 5.0, 0.05, 5000.0, FAR]
    return {
        "RRT, 5,000 nodes among 24 polygons": ("rrt", among_polygons(0).problem, tree),
        "PRM, 2,000 samples among 24 boxes": ("prm", among_boxes(0).problem, [0.0, 2000.0, 10.0]),
        "A*, a million cells": ("terrain_cells", across, [0.0, 1.0, CELLS + 2.0, CELLS + 2.0]),
    }


def race(page: Any, folder: Path, repeats: int) -> None:
    """Print the least times of the same bodies as WebAssembly and as machine code."""
    print("| work | WebAssembly, ms | machine code, ms | ratio |\n|---|---:|---:|---:|")
    for what, (name, problem, settings) in big_problems().items():
        scene, free = make_problem_scene(problem), getattr(problem.world, "free", None)
        cells = None if free is None else [free.astype(int).ravel().tolist(), list(free.shape)]
        case = {"scene": scene, "cells": cells, "settings": settings, "seed": 0}
        body, packed = BODIES[name], pack_scene(scene, free)
        made = body.settings(*settings)
        theirs, ours = list[float](), list[float]()
        with running(COMPILED_FIRST):
            body.function(packed, made, np.random.default_rng(0))
            for _ in range(repeats):
                answers = run_in_page(page, folder, name, [case] * (WARM + 5))
                theirs += [took for _, _, took in answers[WARM:]]
                ours += [1e3 * seconds_of(body.function, packed, made) for _ in range(5)]
        mine, other = min(ours), min(theirs)  # other programs only add time
        print(f"| {what} | {other:.1f} | {mine:.1f} | {other / mine:.2f} |", flush=True)


def seconds_of(function: Callable[..., Any], *given: Any) -> float:
    """How long a body runs."""
    rng = np.random.default_rng(0)
    began = time.perf_counter()
    function(*given, rng)
    return time.perf_counter() - began


def touch(folder: Path, seconds: float) -> None:
    """Print the milliseconds from the first touch to its answer, and the plans a second after."""
    print("| what is dragged | first touch, ms | plans/s | paints/s | delay, ms |")
    print("|---|---:|---:|---:|---:|")
    for what, number, thing in THINGS:
        with open_browser((folder / "index.html").as_uri(), 760, 8000) as browser:
            board = browser.page.locator(".kinoedu-board").nth(number)
            browser.page.wait_for_function("e => e.dataset.paints", arg=board.element_handle())
            first = browser.page.evaluate(FIRST, [board.element_handle(), thing])
            rates = drag(browser, thing, seconds, number)
        numbers = first, rates["plans"], rates["paints"], rates["delay"]
        print(f"| {what} | {' | '.join(f'{n:.3g}' for n in numbers)} |", flush=True)


# Press an arrow key on a thing, and wait for the answer.
FIRST = """([board, thing]) => new Promise((done) => {
    const began = performance.now();
    board.addEventListener("kinoedu-answered", () => done(performance.now() - began));
    const button = board.querySelector(`[data-thing=${thing}]`);
    button.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft", bubbles: true }));
})"""


def weigh(folder: Path) -> None:
    """Print the size of each body's script, as it is and as a server sends it."""
    print("| body | kB | compressed |\n|---|---:|---:|")
    for name in BODIES:
        script = (folder / "live" / f"{name}.js").read_bytes()
        print(f"| {name} | {len(script) / 1e3:.0f} | {len(gzip.compress(script)) / 1e3:.0f} |")


def main(problems: int = 200, repeats: int = 3, seconds: float = 3.0) -> None:
    """Compare, race, drag and weigh, and print a table of each."""
    if CHROMIUM is None:
        raise Missing("Chromium")
    from playwright.sync_api import sync_playwright

    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        write_page(folder)
        weigh(folder)
        touch(folder, seconds)
        with sync_playwright() as playwright:
            browser = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
            page = browser.new_page()
            race(page, folder, repeats)
            compare(page, folder, problems)
            browser.close()


if __name__ == "__main__":
    run(main)

"""How lively a board is: new plans and paints a second while a thing is dragged, in a real
JupyterLab in headless Chromium.
"""

import sys
import tempfile
import time
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
from timing import Missing, run

HOUSE = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(HOUSE / "tests"))

# E402: the file lies in tests, which the line above adds to the path
from lab_driver import CHROMIUM, RUN_ALL, lab, notebook_page, written_notebook  # noqa: E402

SECONDS = 400
SCENE = """
import kinoedu as ke
obstacles = [[(2, 3), (3.5, 2.6), (3.9, 6.5), (2.4, 6.1)],
             [(5, 0.6), (6.2, 0.9), (6, 4.4), (5.2, 4.6)],
             [(5, 6), (7.2, 5.8), (8, 7.6), (6.2, 7.2), (5.4, 8.2)],
             [(8, 2), (10.4, 2.4), (10, 3.4), (9.2, 3.1), (8.8, 4.8), (7.8, 4.6)], ((10, 6.2), 0.9)]
world = ke.PolygonWorld([(0, 0), (12, 0), (12, 9), (0, 9)], obstacles)
ke.board(ke.Problem(ke.Point(), world, (1, 1), (11, 8)))
"""
TOWN = f"""
import kinoedu as ke
ke.board(ke.read_problem({str(HOUSE / "notebooks" / "maps" / "Paris_1_256.map")!r}, query=324))
"""
BUG = """
from kinoedu.boards import bug_board
bug_board((0, 0), (5, 3), [[(1, 2), (1, 0), (3, 0)], [(2, 3), (4, 1), (5, 2)]], bug="bug1")
"""
SWEEP = f"""
{SCENE.replace("ke.board(", "(")}
from kinoedu.boards import sweep_board
sweep_board(ke.PolygonWorld([(0, 0), (12, 0), (12, 9), (0, 9)], obstacles[:4]))
"""
SEARCH = """
import numpy as np
from kinoedu.boards import search_board
from kinoedu.graphs import Graph
nodes = np.random.default_rng(1).random((30, 2))
apart = ((nodes[:, None] - nodes) ** 2).sum(axis=2)
near = {tuple(sorted((i, int(j)))) for i in range(30) for j in np.argsort(apart[i])[1:4]}
search_board(Graph(nodes=nodes, edges=sorted(near)), search="astar")
"""
YARD = SCENE.replace("ke.board(", "yard = (")
ROADMAP = YARD + "ke.boards.roadmap_board(yard, n=1000)"
PROPERTIES = YARD + "ke.boards.properties_board(yard, n=300)"
RACE = YARD + "ke.boards.race_board(yard, nodes=1000)"
REWIRING = YARD + "ke.boards.rewiring_board(yard, nodes=1000)"
EXPLORING = YARD + "ke.boards.exploring_board(yard)"
CAR = """
import numpy as np
import kinoedu as ke
walls = [[(70, 0), (90, 0), (90, 90), (70, 90)], [(150, 70), (170, 70), (170, 160), (150, 160)]]
world = ke.PolygonWorld([(0, 0), (240, 0), (240, 160), (0, 160)], walls)
yard = ke.Problem(ke.Car(30, 10, 20), world, (25, 30, np.pi / 2), (200, 90, np.pi / 2))
ke.boards.car_board(yard)
"""
DRAGGED = {  # on the first board of each notebook: what, and the thing
    SCENE: (("goal", "handle-1"), ("polygon", "polygon-2")),
    TOWN: (("goal in the town", "handle-1"),),
    BUG: (("goal of a bug", "handle-1"), ("obstacle of a bug", "polygon-0")),
    SWEEP: (("sweep line", "handle-0"), ("obstacle under the sweep", "polygon-2")),
    SEARCH: (("goal of a search", "handle-1"), ("node of a search", "handle-9")),
    ROADMAP: (
        ("goal of a roadmap, 1,000 nodes", "handle-1"),
        ("obstacle in a roadmap", "polygon-2"),
    ),
    PROPERTIES: (("obstacle in a roadmap measured", "polygon-2"),),
    RACE: (("goal of a race, 1,000 nodes", "handle-1"), ("obstacle in a race", "polygon-2")),
    REWIRING: (("goal of RRT*, 1,000 nodes", "handle-1"), ("obstacle in RRT*", "polygon-2")),
    EXPLORING: (("goal of an explorer", "handle-1"), ("obstacle of an explorer", "polygon-2")),
    CAR: (
        ("goal of a car, kinodynamic RRT", "handle-2"),
        ("its heading", "handle-3"),
        ("wall in a car's way", "polygon-0"),
    ),
}
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
GOALS = {"plans": 30.0, "paints": 50.0}


def drag(page: Any, name: str, seconds: float, number: int = 0) -> dict[str, float]:
    """Drag a thing of one of a page's boards round in circles; what was seen meanwhile, and for how
    long.
    """
    board = page.locator(".kinoedu-board").nth(number)
    board.scroll_into_view_if_needed()
    page.wait_for_timeout(500)
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


def warm(page: Any, name: str, seconds: float = 120.0) -> None:
    """Drag until it is answered, or for so long: what was not compiled yet is compiled
    meanwhile.
    """
    until = time.perf_counter() + seconds
    while time.perf_counter() < until:
        with suppress(Unanswered):
            drag(page, name, 0.5)
            return


class Unanswered(RuntimeError):
    """Nothing came back while a thing was dragged."""


def seen(events: list[Any], spent: float) -> dict[str, float]:
    """Rates a second, the delay of an answer in ms, and how often an older answer was painted after
    a newer one.
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
        "delay": float(np.median(delays)),
        "late": float(np.percentile(delays, 95)),
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


def main(seconds: float = 4.0, repeats: int = 3) -> None:
    """Drag on every board and print a table; `seconds` is how long each is dragged."""
    if CHROMIUM is None:
        raise Missing("Chromium")
    print(
        "| what is dragged | moves/s | plans/s | paints/s | delay ms, median | 95 % | out of "
        "order | |"
    )
    print("|---|---:|---:|---:|---:|---:|---:|---|")
    with tempfile.TemporaryDirectory() as home, tempfile.TemporaryDirectory() as course:
        for number, code in enumerate(DRAGGED):
            (Path(course) / f"{number}.ipynb").write_text(written_notebook(code))
        with lab(Path(course), Path(home)) as (address, token):
            for number, things in enumerate(DRAGGED.values()):
                with notebook_page(address, token, f"{number}.ipynb") as page:
                    page.evaluate(RUN_ALL)
                    page.wait_for_selector(".kinoedu-board[data-answers]")
                    page.wait_for_timeout(2000)  # JupyterLab is still moving cells about
                    for what, name in things:
                        warm(page, name)
                        print_row(what, [drag(page, name, seconds) for _ in range(repeats)])


if __name__ == "__main__":
    run(main)

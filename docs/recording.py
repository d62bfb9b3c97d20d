"""Makes docs/live.gif: a page without Python, on which things are dragged and RRT* plans.

python docs/recording.py. It needs Chromium, the tests' tools and the site's packages, which python
start.py test brings. Look at the recording before it is kept.
"""

import io
import json
import shutil
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

HOUSE = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(HOUSE), str(HOUSE / "tests")]

from lab_driver import CHROMIUM, FLAGS  # noqa: E402 - beside the tests, which it serves first

import kinoedu as ke  # noqa: E402 - the one beside this file
from kinoedu.boards.core.page_script import BROWSER, CORE, page_script  # noqa: E402
from kinoedu.boards.core.recorded import pack_records  # noqa: E402
from kinoedu.browser.bodies import describe_bodies  # noqa: E402
from kinoedu.browser.wasm import write_scripts  # noqa: E402

GIF, WIDE, COLOURS, BYTES = HOUSE / "docs" / "live.gif", 560, 48, 900_000
FRAME = 90  # milliseconds
ROOM = [(0, 0), (16, 0), (16, 9), (0, 9)]
WALLS = [
    [(4, 0), (5, 0), (5, 6), (4, 6)],
    [(8.5, 3.5), (9.5, 3.5), (9.5, 9), (8.5, 9)],
    [(12, 1.5), (14, 2.5), (12.5, 4)],
]
# the goal is dragged round, then a wall, and both come back
ROUND = [(14.5, 7.5), (14.8, 4.5), (11, 4.8), (10.5, 1.5), (7, 4.5), (6.5, 8), (7, 3), (11, 2)]
DRAGS = [
    [*ROUND, (11, 7), (14.5, 7.5)],
    [(4.5, 3), (4.5, 1.2), (6.5, 1.5), (6.5, 4), (4.5, 3)],
]


def write_page(folder: Path) -> str:
    """A page with one board that answers; returns its address."""
    world = ke.PolygonWorld(ROOM, WALLS)
    problem = ke.Problem(ke.Point(), world, start=(1.5, 1.5), goal=ROUND[0])
    board = ke.board(problem, "rrt_star", step_size=1.0, samples=400, rng=3)
    write_scripts(folder / "live")
    (folder / "boards.js").write_text(page_script(describe_bodies()), encoding="utf-8")
    for file in (CORE / "board.css", BROWSER / "worker.js"):
        shutil.copy(file, folder)
    record = json.dumps(pack_records(board.record()))
    (folder / "index.html").write_text(
        '<!doctype html><meta charset="utf-8"><link rel="stylesheet" href="board.css">'
        '<script src="boards.js" defer></script><body><div class="kinoedu-record">'
        f'<script type="application/json">{record}</script></div>',
        encoding="utf-8",
    )
    return (folder / "index.html").as_uri()


def frames(page: Any) -> Iterator[bytes]:
    """The board while its things are dragged."""
    canvas = page.locator(".kinoedu-board canvas")
    box = canvas.bounding_box()
    for places in DRAGS:
        on_page = [
            (box["x"] + box["width"] * x / 16, box["y"] + box["height"] * (1 - y / 9))
            for x, y in places
        ]
        page.mouse.move(*on_page[0])
        page.mouse.down()
        for a, b in zip(on_page, on_page[1:], strict=False):
            steps = max(3, round(np.hypot(b[0] - a[0], b[1] - a[1]) / 30))
            for t in np.linspace(0, 1, steps + 1)[1:]:
                page.mouse.move(*(np.array(a) * (1 - t) + np.array(b) * t))
                page.wait_for_timeout(FRAME)
                yield canvas.screenshot()
        page.mouse.up()


def keep(shots: list[bytes]) -> None:
    """The frames as one file, with the same few colours."""
    pictures = [Image.open(io.BytesIO(shot)).convert("RGB") for shot in shots]
    size = WIDE, round(pictures[0].height * WIDE / pictures[0].width)
    small = [picture.resize(size, Image.Resampling.LANCZOS) for picture in pictures]
    palette = small[-1].quantize(COLOURS, Image.Quantize.MAXCOVERAGE)
    first, *rest = (p.quantize(palette=palette, dither=Image.Dither.NONE) for p in small)
    first.save(GIF, save_all=True, append_images=rest, duration=FRAME, loop=0, optimize=True)
    print(f"{GIF.relative_to(HOUSE)}: {len(small)} frames, {GIF.stat().st_size / 1000:.0f} KB")
    if GIF.stat().st_size > BYTES:
        raise SystemExit(f"{GIF.name} is larger than {BYTES / 1000:.0f} KB")


def main() -> None:
    """Record."""
    from playwright.sync_api import sync_playwright

    if CHROMIUM is None:
        sys.exit("this needs Chromium")
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as play:
        browser = play.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
        page = browser.new_page(viewport={"width": 900, "height": 800})
        page.goto(write_page(Path(folder)))
        page.wait_for_selector(".kinoedu-board[data-paints]")
        keep(list(frames(page)))
        browser.close()


if __name__ == "__main__":
    main()

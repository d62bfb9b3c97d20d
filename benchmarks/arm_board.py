"""How lively the arm's board is: pictures of the configuration space, 360 x 360, a second while an
obstacle is dragged, in a real JupyterLab in headless Chromium; and answers a second while the tip
or q is.
"""

import tempfile
from pathlib import Path

import numpy as np
from board import CHROMIUM, RUN_ALL, drag, lab, written_notebook
from timing import Missing, run
from unwatched import Browser, open_notebook

SECONDS = 120
ARM = """
import kinoedu as ke
obstacles = [[(1.2, 1.4), (2.6, 1.2), (2.2, 2.4)], [(-2.4, 0.4), (-1.2, 0.6), (-1.4, 1.8)],
             ((0.4, 2.2), 0.4), ((0.2, -1.4), 0.3)]
world = ke.PolygonWorld([(-4, -4), (4, -4), (4, 4), (-4, 4)], obstacles)
ke.boards.arm_board(ke.TwoLinkArm(1.5, 1.2, 0.2), world, q=(0.6, 0.3))
"""
WORKSPACE, SQUARE = 0, 1
DRAGGED = (
    ("disc", "disc-0", WORKSPACE),
    ("polygon", "polygon-1", WORKSPACE),
    ("tip", "handle-1", WORKSPACE),
    ("q", "handle-0", SQUARE),
)
PICTURES, PLANS = (
    30.0,
    44.0,
)  # a second: of an obstacle that is dragged, and answers to anything else


def dragged(browser: Browser, name: str, number: int, seconds: float) -> dict[str, float]:
    """What is seen while a thing is dragged, with the rate of the pictures that came to the square;
    then all is put back.
    """
    before = pictures_of(browser)
    rates = drag(browser, name, seconds, number)
    pictures = (pictures_of(browser) - before) / rates["spent"]
    browser.page.locator(".kinoedu-board").nth(number).locator(".kinoedu-reset").click()
    browser.page.wait_for_timeout(500)
    return {**rates, "pictures": pictures}


def pictures_of(browser: Browser) -> int:
    """How many pictures have come to the square."""
    square = browser.page.locator(".kinoedu-board").nth(SQUARE)
    return int(square.get_attribute("data-bitmaps"))


def main(seconds: float = 4.0, repeats: int = 3) -> None:
    """Drag an obstacle, the tip and q, and print a table; `seconds` is how long each is dragged."""
    if CHROMIUM is None:
        raise Missing("Chromium")
    print(
        "| what is dragged | moves/s | pictures/s | answers/s | paints/s | delay ms, median | 95 "
        "% | out of order | |"
    )
    print("|---|---:|---:|---:|---:|---:|---:|---:|---|")
    with tempfile.TemporaryDirectory() as home, tempfile.TemporaryDirectory() as course:
        (Path(course) / "arm.ipynb").write_text(written_notebook(ARM))
        with (
            lab(Path(course), Path(home)) as (address, token),
            open_notebook(address, token, "arm.ipynb") as browser,
        ):
            browser.page.evaluate(RUN_ALL)
            browser.page.wait_for_selector(".kinoedu-board[data-answers]")
            for what, name, number in DRAGGED:
                rounds = [dragged(browser, name, number, seconds) for _ in range(repeats)]
                mean = {key: float(np.median([r[key] for r in rounds])) for key in rounds[0]}
                goal, rate = (
                    (PICTURES, mean["pictures"])
                    if name.startswith(("disc", "polygon"))
                    else (PLANS, mean["plans"])
                )
                cells = [
                    f"{mean[key]:.3g}"
                    for key in ("moves", "pictures", "plans", "paints", "delay", "late", "backward")
                ]
                verdict = "holds" if rate >= goal and not mean["backward"] else "MISSED"
                print(f"| {what} | {' | '.join(cells)} | {verdict} |", flush=True)


if __name__ == "__main__":
    run(main)

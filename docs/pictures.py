"""Makes the pictures of boards.md: opens the lessons that it names in a real JupyterLab, runs them,
and photographs their boards.

python docs/pictures.py [NAME ...], such as race_board; without names, all. It needs Chromium, the
tests' tools, which python start.py test brings, and some minutes. Look at each picture before it is
kept.
"""

import io
import re
import shutil
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

from PIL import Image, ImageOps

HOUSE = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(HOUSE / "tests"))

from lab_driver import CHROMIUM, OPEN, RUN_ALL, lab, lab_page, written_notebook  # noqa: E402 - beside the tests, which it serves first

PAGE, PICTURES = HOUSE / "docs" / "boards.md", HOUSE / "docs" / "boards"
ENTRY = re.compile(
    r"^!\[[^]]+\]\(boards/(?P<name>\w+)\.png\)\n\n(?P<text>.+?)\n\n```python\n(?P<code>.+?)\n```",
    re.MULTILINE | re.DOTALL,
)
LESSON = re.compile(r"\]\(\.\./notebooks/(.+?\.ipynb)\)")
ALONE = "alone.ipynb"  # a notebook made here, for what no lesson shows
MARGIN, WIDEST, BYTES = 12, 1280, 80_000

READY = """number => {
    const cell = jupyterapp.shell.currentWidget.content.widgets[number].node;
    const found = [...cell.querySelectorAll('.kinoedu-board, .kinoedu-solid')];
    const boards = found.map(board => board.dataset);
    return boards.length && boards.every(({answers = 1, paints}) => answers > 0 && paints > 0); }"""
SCROLL = "number => jupyterapp.shell.currentWidget.content.scrollToItem(number, 'start')"
OUTPUT = """number => {
    const cell = jupyterapp.shell.currentWidget.content.widgets[number].node;
    const inner = cell.querySelector('.kinoedu-board, .kinoedu-solid');
    const board = inner.closest('.jp-OutputArea-output');
    board.scrollIntoView({block: 'center'});
    return board; }"""


class Entry(NamedTuple):
    """A board on the page: its name, the notebook whose board is photographed, the lines that open
    one.
    """

    name: str
    lesson: str
    code: str


def entries(page: str) -> Iterator[Entry]:
    """What the page shows, in its order. The first lesson that an entry names is the one that is
    opened.
    """
    for found in ENTRY.finditer(page):
        lesson = LESSON.search(found["text"])
        yield Entry(found["name"], lesson[1] if lesson else ALONE, found["code"])


def cell_of(book: dict[str, Any], name: str) -> int:
    """The first cell with a statement that opens the board."""
    opens = re.compile(rf"(?m)^.*\b{name}\(")
    sources = [
        "".join(cell["source"]) if cell["cell_type"] == "code" else "" for cell in book["cells"]
    ]
    return next(number for number, source in enumerate(sources) if opens.search(source))


def cropped(shot: bytes) -> Image.Image:
    """A screenshot without the white round it, but for a margin."""
    whole = Image.open(io.BytesIO(shot)).convert("RGB")
    return ImageOps.expand(whole.crop(ImageOps.invert(whole).getbbox()), MARGIN, "white")


def keep(picture: Image.Image, file: Path) -> None:
    """In all its colours, or in as many as there is room for, the rare ones kept: they mean
    something.
    """
    if picture.width > WIDEST:
        picture = picture.resize(
            (WIDEST, round(picture.height * WIDEST / picture.width)), Image.Resampling.LANCZOS
        )
    picture.save(file, optimize=True)
    if file.stat().st_size > BYTES:
        picture.quantize(256, Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE).save(
            file, optimize=True
        )
    print(
        f"{file.relative_to(HOUSE)}: {picture.width} x {picture.height}, "
        f"{file.stat().st_size / 1000:.0f} KB",
        flush=True,
    )
    if file.stat().st_size > BYTES:
        raise SystemExit(f"{file.name} is larger than {BYTES / 1000:.0f} KB")


def photograph(page: Any, wanted: list[Entry]) -> None:
    """Run the notebook that is open, and keep a picture of each board."""
    page.set_viewport_size({"width": 1500, "height": 1600})
    page.evaluate("() => jupyterapp.commands.execute('application:toggle-left-area')")
    book = page.evaluate(RUN_ALL)
    for entry in wanted:
        number = cell_of(book, entry.name)
        page.evaluate(SCROLL, number)
        page.wait_for_function(READY, arg=number)
        page.wait_for_timeout(1500)  # JupyterLab is still moving cells about
        box = page.evaluate_handle(OUTPUT, number).as_element().bounding_box()
        # with the frame's line
        clip = {
            "x": box["x"] - 2,
            "y": box["y"] - 2,
            "width": box["width"] + 4,
            "height": box["height"] + 4,
        }
        keep(cropped(page.screenshot(clip=clip)), PICTURES / f"{entry.name}.png")


def main() -> None:
    """Make the pictures that are asked for."""
    wanted = [
        entry
        for entry in entries(PAGE.read_text(encoding="utf-8"))
        if not sys.argv[1:] or entry.name in sys.argv[1:]
    ]
    if CHROMIUM is None or not wanted:
        sys.exit("this needs Chromium, and names of boards in boards.md or none")
    PICTURES.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as home, tempfile.TemporaryDirectory() as course:
        shutil.copytree(HOUSE / "notebooks", Path(course) / "notebooks")
        own = [entry.code for entry in wanted if entry.lesson == ALONE]
        (Path(course) / "notebooks" / ALONE).write_text(written_notebook(*own))
        with lab(Path(course), Path(home)) as (address, token):
            for lesson in sorted({entry.lesson for entry in wanted}):
                with lab_page(address, token) as page:
                    page.evaluate(OPEN, [f"notebooks/{lesson}", None])
                    photograph(page, [entry for entry in wanted if entry.lesson == lesson])


if __name__ == "__main__":
    main()

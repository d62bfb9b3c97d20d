"""Pages with recorded boards: what a link leads to, and what is printed."""

import json
import shutil

import pytest

from kinoedu.boards import distance_board
from kinoedu.boards.core.page_script import CORE, page_script
from kinoedu.boards.core.recorded import pack_records

TOP = "Math.round(document.getElementById('part').getBoundingClientRect().top)"
PAGE = """<!doctype html><meta charset="utf-8"><link rel="stylesheet" href="board.css">
<script src="boards.js" defer></script><style>
p { height: 3000px } html { overflow-anchor: none }</style><body>
<div class="kinoedu-record"><script type="application/json">{record}</script></div>
<h2 id="part">Part</h2><p></p>"""


@pytest.fixture
def page(chromium, tmp_path):
    """A page with a board above a part, and a browser that has not opened it yet."""
    board = distance_board([(2, 2), (6, 2), (4, 6)], (8, 8))
    record = json.dumps(pack_records(board.record()))
    (tmp_path / "index.html").write_text(PAGE.replace("{record}", record), encoding="utf-8")
    (tmp_path / "boards.js").write_text(page_script(), encoding="utf-8")
    shutil.copy(CORE / "board.css", tmp_path)
    opened = chromium.new_page(viewport={"width": 900, "height": 700})
    yield opened, (tmp_path / "index.html").as_uri()
    opened.close()


def test_a_part_stays_in_its_place_while_boards_above_it_come(page):
    """A link to a part leads there: when the page opens, and from another part of it; also in a
    browser that does not keep places itself.
    """
    opened, address = page
    opened.goto(f"{address}#part")
    opened.wait_for_selector(".kinoedu-board[data-paints]")
    opened.wait_for_function(f"{TOP} === 0")
    opened.mouse.wheel(0, -200)  # the reader goes elsewhere, and stays there
    opened.wait_for_function(f"{TOP} > 0")
    before = opened.evaluate(TOP)
    opened.evaluate("document.querySelector('.kinoedu-record').style.paddingLeft = '9px'")
    opened.wait_for_timeout(200)
    assert opened.evaluate(TOP) == before
    opened.evaluate("location.hash = ''")
    opened.evaluate("location.hash = 'part'")
    opened.evaluate("document.querySelector('.kinoedu-record').style.paddingTop = '90px'")
    opened.wait_for_function(f"{TOP} === 0")


def test_a_picture_is_as_narrow_as_its_column_on_paper(page):
    """It keeps its shape, and covers nothing beside it; a page is printed before it is laid out.
    Nobody is told to drag something.
    """
    opened, address = page
    opened.goto(address)
    opened.wait_for_selector(".kinoedu-board[data-paints]")
    opened.emulate_media(media="print")
    hint = opened.locator(".kinoedu-hint").first
    assert hint.evaluate("hint => getComputedStyle(hint).display") == "none"
    width, shape = opened.evaluate("""() => {
        const stage = document.querySelector('.kinoedu-stage');
        const wide = stage.getBoundingClientRect();
        document.querySelector('.kinoedu-record').style.width = '200px';
        const { width, height } = stage.getBoundingClientRect();
        return [width, (width / height) / (wide.width / wide.height)]; }""")
    assert width <= 200 and abs(shape - 1) < 0.02

"""Slides: every lesson has them, they follow the rule, and a browser shows them without network."""

import base64
import json
import re
from contextlib import contextmanager
from html import unescape
from pathlib import Path

import nbformat
import pytest

from kinoedu.cli import main
from kinoedu.slides.exporter import PageWithBoards
from kinoedu.slides.markdown import cut_into_blocks, to_html
from kinoedu.slides.page import lessons_with_slides, make_slides
from kinoedu.slides.rule import MOST_WORDS, cut_into_slides, without_documentation

HOUSE = Path(__file__).resolve().parent.parent
LESSONS = lessons_with_slides()
PNG = base64.b64encode(bytes(32)).decode()
PICTURE = {"data": {"image/png": PNG, "text/plain": "<Figure size 1x1>"}}
BOARD = {"data": {"image/png": PNG, "application/vnd.kinoedu.board+json": {}}}


def text(source, **metadata):
    """A text cell."""
    return {"cell_type": "markdown", "source": source, "metadata": metadata}


def code(source, *outputs, **metadata):
    """A code cell with its outputs."""
    return {"cell_type": "code", "source": source, "outputs": list(outputs), "metadata": metadata}


def cut(*cells):
    """The slides of some cells."""
    return cut_into_slides({"cells": list(cells)})


def printed(words):
    """An output of printed text."""
    return {"output_type": "stream", "name": "stdout", "text": words}


def test_an_answer_is_not_on_the_slide_of_its_question():
    """A board is, since it is for trying; also a definition between them is left out."""
    question = text("## A\n\n**Predict, then try.** Which?")
    asked, answered = cut(question, code("f()", printed("42")))
    assert "Which?" in asked.text[0]
    assert not asked.figure
    assert "42" in answered.figure
    (tried,) = cut(question, code("def f():\n    return 1"), code("board(f)", BOARD))
    assert "kinoedu-record" in tried.figure
    assert "Which?" in tried.text[0]


def test_a_slide_has_one_figure_and_what_is_said_of_it():
    """Text before a figure is beside it, else the first paragraph after it."""
    before = cut(text("## A\n\nLook here."), code("draw()", PICTURE), text("It was so."))
    assert ["Look here" in before[0].text[0], "It was so" in before[1].text[0]] == [True, True]
    (after,) = cut(text("## A"), code("draw()", PICTURE), text("It was so."))
    assert "It was so" in after.text[0]
    two = cut(text("## A"), code("draw()", PICTURE), code("draw()", PICTURE))
    assert [slide.figure.count("<img") for slide in two] == [1, 1]


def test_long_text_is_in_the_notes():
    """Of a long paragraph the first sentence, questions and bold words stay; a proof does not."""
    long = "First. " + "Then it goes on. " * 20 + "**Why?**"
    (slide,) = cut(text(f"## A\n\n{long}\n\n> **Theorem.** So.\n>\n> *Proof.* Thus."))
    assert "First." in slide.text[0]
    assert "Why?" in slide.text[0]
    assert "goes on" not in "".join(slide.text)
    assert slide.notes[0] == long
    assert "Thus" in slide.notes[1]
    assert "Thus" not in "".join(slide.text)


def test_code_is_short_or_folded():
    """Behind a picture it is folded; long code too; imports are left out."""
    (slide,) = cut(text("## A"), code("import x\ny = 1\ny", printed("1")))
    assert "import" not in slide.figure
    assert "<details>" not in slide.figure
    (drawn,) = cut(text("## A"), code("draw()", PICTURE))
    assert drawn.figure.index("<img") < drawn.figure.index("<details>")
    (long,) = cut(text("## A"), code("\n".join(["x = 1"] * 9), printed("1")))
    assert "<details>" in long.figure
    assert cut(text("## A"), code("x = 1")) == []
    shown = 'def f():\n    """It is.\n\n    More.\n    """\n    return 1'
    assert without_documentation(shown) == 'def f():\n    """It is."""\n    return 1'


def test_a_slide_type_comes_before_the_rule():
    """Skip, notes, slide: as in JupyterLab."""
    (slide,) = cut(
        text("## A\n\nShown."),
        text("Left out.", slideshow={"slide_type": "skip"}),
        text("Said.", slideshow={"slide_type": "notes"}),
    )
    assert len(slide.text) == 1
    assert slide.notes == ["Said."]
    first, second = cut(text("## A\n\nOne."), text("Two.", slideshow={"slide_type": "slide"}))
    assert first.title == second.title


def test_blocks_and_formulas():
    """Formulas with empty lines stay whole, and become MathML; links lead to slides only."""
    blocks = cut_into_blocks("A $x$.\n\n$$a\n\nb$$\n\n```\nx\n\ny\n```\n\n| a |\n|---|\n| 1 |")
    assert [block.kind for block in blocks] == ["prose", "formula", "prose", "table"]
    page = to_html("$a_1 < b$ in [lesson 7](07_x.ipynb), [here](../exercises/07_x.ipynb)")
    assert "<math" in page
    assert "$" not in page
    assert 'href="07_x.html"' in page
    assert "exercises" not in page


@pytest.mark.parametrize("lesson", LESSONS)
def test_the_slides_of_a_lesson(lesson):
    """Each section of the notebook has a slide; no slide has much text or two pictures.

    Each board of the notebook plays on some slide.
    """
    book = json.loads((HOUSE / "notebooks" / f"{lesson}.ipynb").read_text(encoding="utf-8"))
    slides = cut_into_slides(book)
    sources = ["".join(cell["source"]) for cell in book["cells"] if cell["cell_type"] == "markdown"]
    sections = {line[3:] for source in sources for line in source.split("\n") if line[:3] == "## "}
    titles = {re.sub(r"<[^>]*>", "", slide.title).strip() for slide in slides}
    plain = {section for section in sections if "$" not in section and "`" not in section}
    missing = {section for section in plain if unescape(section) not in set(map(unescape, titles))}
    assert not missing
    blocks = [slide for slide in slides if slide.words > MOST_WORDS]
    assert all(len(slide.text) == 1 for slide in blocks)  # one block that cannot be cut
    assert not [slide for slide in slides if slide.figure.count('class="figure') > 2]
    records = json.dumps(book).count('"application/vnd.kinoedu.board+json"')
    assert sum(slide.figure.count("kinoedu-record") for slide in slides) == records


def test_the_command_writes_files_that_need_no_network(tmp_path, capsys):
    """An unknown lesson is refused by name."""
    assert main(["slides", "04_graph_search", "--out", str(tmp_path / "a" / "b")]) == 0
    page = (tmp_path / "a" / "b" / "04_graph_search.html").read_text(encoding="utf-8")
    assert not re.search(r"(src|href)=[\"']https?://(?!.*</a>)", page.partition("<script>")[0])
    assert main(["slides", "graphs", "--out", str(tmp_path)]) == 2
    assert "04_graph_search" in capsys.readouterr().err


@pytest.mark.parametrize("lesson", ["03_decomposition", "09_trees"])
def test_a_browser_shows_every_slide(lesson, chromium, tmp_path):
    """Nothing is fetched, nothing complains, everything fits, boards play, keys lead on."""
    made = make_slides(lesson, tmp_path)
    complaints = []
    page = chromium.new_page(viewport={"width": 1280, "height": 720})
    page.on("console", lambda m: complaints.append(m.text) if m.type == "error" else None)
    page.on("pageerror", lambda error: complaints.append(str(error)))
    page.on("request", lambda r: complaints.append(r.url) if r.url[:4] == "http" else None)
    page.goto(made.as_uri())
    count = page.locator("section").count()
    boards = 0
    for number in range(1, count + 1):
        section = page.locator("section:not([hidden])")
        assert section.count() == 1
        if section.locator(".kinoedu-record").count():
            section.locator("canvas").first.wait_for()
            boards += 1
        page.wait_for_timeout(80)
        over = section.locator(".row").evaluate("e => e.scrollHeight - e.clientHeight")
        assert over <= 2, number
        assert page.locator("#place").inner_text() == f"Slide {number} of {count}"
        page.keyboard.press("ArrowRight")
    assert boards > 0
    page.keyboard.press("Home")
    page.keyboard.press("n")
    assert page.locator("section:not([hidden]) aside").is_visible()
    page.close()
    assert complaints == []


@contextmanager
def shown_slides(chromium, tmp_path, **how):
    """The slides of a lesson in a browser with a small window."""
    page = chromium.new_page(viewport={"width": 800, "height": 450}, **how)
    page.goto(make_slides("09_trees", tmp_path).as_uri())
    yield page
    page.close()


ON_PAPER = """() => [...document.querySelectorAll(".slide")].map((slide) => {
    const { width, height } = slide.getBoundingClientRect(), row = slide.querySelector(".row");
    return [width, height, row.scrollHeight - row.clientHeight <= 2]; })"""


def test_every_slide_fills_its_sheet_of_paper(chromium, tmp_path):
    """Those that the small window has shown, and those that it has not; nothing is cut."""
    with shown_slides(chromium, tmp_path) as page:
        page.keyboard.press("ArrowRight")
        page.evaluate("dispatchEvent(new Event('beforeprint'))")
        page.emulate_media(media="print")
        sizes = page.evaluate(ON_PAPER)
        assert len(sizes) > 20 and all(size == [1280, 720, True] for size in sizes)
        page.emulate_media(media="screen")
        page.evaluate("dispatchEvent(new Event('afterprint'))")
        section = page.locator("section:not([hidden])")
        assert section.count() == 1 and section.bounding_box()["width"] == 800


BROKEN = """() => [...document.querySelectorAll(".beside > .code pre")].filter((code) => {
    const lines = code.textContent.trimEnd().split("\\n").length;
    return code.clientHeight > (lines + 0.5) * parseFloat(getComputedStyle(code).lineHeight); })"""


def test_lines_of_code_are_not_broken(chromium, tmp_path):
    """A line that is too long to stand beside a text has the width of the slide."""
    with shown_slides(chromium, tmp_path) as page:
        page.evaluate("dispatchEvent(new Event('beforeprint'))")
        page.emulate_media(media="print")
        assert page.evaluate(BROKEN) == []


FITS = """() => {
    const row = document.querySelector("section:not([hidden]) .row");
    return row.scrollHeight - row.clientHeight <= 2; }"""


def test_code_that_is_opened_is_not_cut(chromium, tmp_path):
    """Its slide is made smaller until it fits."""
    with shown_slides(chromium, tmp_path) as page:
        opened = 0
        for _ in range(page.locator("section").count()):
            codes = page.locator("section:not([hidden]) .beside summary")
            if codes.count():
                codes.first.press("Enter")
                page.wait_for_function(FITS, timeout=10_000)
                opened += 1
            page.keyboard.press("PageDown")
        assert opened > 5


FINGERS = """([kind, places, changed]) => {
    const touch = ([identifier, clientX]) =>
        new Touch({ identifier, clientX, target: document.body });
    document.body.dispatchEvent(new TouchEvent(kind, {
        touches: places.map(touch), changedTouches: [touch(changed)], bubbles: true })); }"""


def test_two_fingers_zoom_and_do_not_turn_the_slide(chromium, tmp_path):
    """Neither when they are lifted nor when one finger moves what is zoomed; else this turns it."""
    with shown_slides(chromium, tmp_path, has_touch=True) as page:
        for _ in range(3):
            page.keyboard.press("ArrowRight")
        place = page.locator("#place")

        def turns(*events):
            before = place.inner_text()
            for kind, places, changed in events:
                page.evaluate(FINGERS, [kind, places, changed])
            return place.inner_text() != before

        swipe = [("touchstart", [[0, 300]], [0, 300]), ("touchend", [], [0, 500])]
        more = [("touchstart", [[0, 300], [1, 500]], [1, 500])]
        lifted = [("touchend", [[0, 300]], [1, 600]), ("touchend", [], [0, 300])]
        assert not turns(swipe[0], *more, *lifted)
        assert turns(*swipe)
        page.evaluate("Object.defineProperty(window, 'visualViewport', { value: { scale: 2 } })")
        assert not turns(*swipe)


def test_a_slide_is_whole_on_a_telephone(chromium, tmp_path):
    """There the page is first as wide as the slide was before it was made smaller."""
    with shown_slides(chromium, tmp_path, is_mobile=True) as page:
        for _ in range(3):
            place = page.locator("section:not([hidden]) .slide").bounding_box()
            assert place["x"] >= 0 and place["x"] + place["width"] <= 800
            page.keyboard.press("ArrowRight")


def test_an_exported_notebook_has_boards_that_play(chromium, tmp_path):
    """nbconvert's page shows the stored picture until the board itself is there. Programs are shown
    in the font of code, and on paper no line is cut.
    """
    page_text, _ = PageWithBoards().from_filename(str(HOUSE / "notebooks" / "09_trees.ipynb"))
    (tmp_path / "trees.html").write_text(page_text, encoding="utf-8")
    page, errors = chromium.new_page(), []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.route("**/*", lambda r: r.continue_() if r.request.url[:5] == "file:" else r.abort())
    page.goto((tmp_path / "trees.html").as_uri(), wait_until="domcontentloaded")
    shown = page.locator(".jp-RenderedHTML .highlight pre").first
    assert "monospace" in shown.evaluate("code => getComputedStyle(code).fontFamily")
    page.emulate_media(media="print")
    page.set_viewport_size({"width": 703, "height": 1032})  # A4 without margins of 12 mm
    assert page.evaluate("""() => [...document.querySelectorAll('.highlight pre')]
        .every((code) => code.scrollWidth <= code.clientWidth)""")
    page.emulate_media(media="screen")
    page.set_viewport_size({"width": 1280, "height": 720})
    record = page.locator(".kinoedu-record").nth(1)
    record.scroll_into_view_if_needed()
    record.locator(".kinoedu-board[data-paints]").wait_for()
    assert not record.locator("> img").is_visible()
    before = record.locator("canvas").first.screenshot()
    record.locator("input[type=range]").first.focus()
    page.keyboard.press("Home")
    page.wait_for_timeout(200)
    assert record.locator("canvas").first.screenshot() != before
    page.close()
    assert errors == []


def test_a_notebook_without_boards_is_exported_as_ever():
    """Without a player; and no export changes the notebook."""
    plain = nbformat.v4.new_notebook(cells=[nbformat.v4.new_markdown_cell("# Nothing")])
    assert "kinoedu" not in PageWithBoards().from_notebook_node(plain)[0]
    book = nbformat.read(HOUSE / "notebooks" / "09_trees.ipynb", as_version=4)
    kept = nbformat.writes(book)
    page, _ = PageWithBoards().from_notebook_node(book)
    assert nbformat.writes(book) == kept
    assert "No description" not in page  # nbconvert's alt text of a picture without one

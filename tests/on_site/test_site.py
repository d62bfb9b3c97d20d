"""The course as a site: built from what is stored, without a warning; every link leads somewhere;
nothing is fetched.
"""

import json
import re
import subprocess
import sys
from html.parser import HTMLParser
from urllib.parse import unquote, urlsplit

import pytest
from lab_driver import keep

from kinoedu.messages import get_message
from kinoedu.slides.formulas import to_mathml

from .conftest import HOUSE

LESSONS = sorted((HOUSE / "notebooks").glob("*.ipynb"))
NOTEBOOKS = [*LESSONS, *sorted((HOUSE / "exercises").glob("*.ipynb"))]
BOARD = "application/vnd.jupyter.widget-view+json"


class Page(HTMLParser):
    """What a page leads to, what can be led to on it, and its pictures."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.links: list[str] = []
        self.parts: set[str] = {"", "top"}
        self.pictures: list[dict[str, str | None]] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        given = dict(attributes)
        self.links += [given[name] or "" for name in ("href", "src") if name in given]
        self.parts |= {given[name] or "" for name in ("id", "name") if name in given}
        self.pictures += [given] if tag == "img" else []


def test_a_copy_with_answers_is_not_on_the_site(tmp_path):
    """A teacher tried an exercise under another name; Sphinx finds the exercise, and no copy."""
    for place in ("solutions/a.ipynb", "exercises/a.ipynb", "exercises/a-Copy1.ipynb"):
        (tmp_path / place).parent.mkdir(exist_ok=True)
        (tmp_path / place).write_text("{}")
    program = f"""
from sphinx.application import Sphinx
app = Sphinx({str(tmp_path)!r}, "docs", *[{str(tmp_path / "out")!r}] * 2, "dummy")
print(sorted(app.project.discover(app.config.exclude_patterns, app.config.include_patterns)))
"""
    found = subprocess.run(
        [sys.executable, "-P", "-c", program], cwd=HOUSE, capture_output=True, text=True, check=True
    )
    assert "left out exercises/a-Copy1.ipynb: no solution makes it" in found.stdout
    assert found.stdout.splitlines()[-1] == "['exercises/a']"


@pytest.fixture(scope="module")
def pages(site):
    """Every page by its file."""
    return {file: Page(file.read_text(encoding="utf-8")) for file in site.rglob("*.html")}


def test_every_link_leads_somewhere(site, pages):
    """To a file of the site, and a part of it that is there; to other sites only where a reader may
    follow or not.
    """
    broken = []
    for file, page in pages.items():
        for link in page.links:
            there = urlsplit(link)
            target = file.parent.joinpath(unquote(there.path)).resolve() if there.path else file
            if not (there.scheme or there.netloc):
                sound = target.is_file() and (
                    target not in pages or unquote(there.fragment) in pages[target].parts
                )
                broken += (
                    []
                    if sound and target.is_relative_to(site)
                    else [(file.relative_to(site).as_posix(), link)]
                )
    assert len(pages) > 100 and broken == []


def test_every_lesson_and_guide_is_a_page(site):
    """And no solution, whole or in part."""
    guides = [file for file in (HOUSE / "docs").glob("*.md") if file.name != "contents.md"]
    others = [
        HOUSE / name for name in ("README.md", "CHANGELOG.md", "benchmarks/README.md", "index.md")
    ]
    for source in (*NOTEBOOKS, *guides, *others):
        assert (site / source.relative_to(HOUSE)).with_suffix(".html").is_file(), source
    assert [file.name for file in (site / "solutions").iterdir()] == ["README.html"]
    assert not any(
        "### BEGIN SOLUTION" in file.read_text(encoding="utf-8")
        for file in (site / "exercises").iterdir()
    )


def test_every_public_name_is_in_the_reference(pages):
    """What `kinoedu` and its rooms export has its place there."""
    import kinoedu

    parts = {part.removeprefix("module-") for page in pages.values() for part in page.parts}
    assert (
        set(kinoedu.__all__)
        - {part.rpartition(".")[2] for part in parts if part.startswith("kinoedu.")}
        == set()
    )


@pytest.mark.parametrize("notebook", LESSONS, ids=lambda file: file.stem)
def test_pictures_stand_for_boards(site, pages, notebook):
    """Every picture stored is shown and says what it is; a board is neither live nor spelled
    out.
    """
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    outputs = [output.get("data", {}) for cell in cells for output in cell.get("outputs", [])]
    file = site / "notebooks" / f"{notebook.stem}.html"
    pictures, text = pages[file].pictures, file.read_text(encoding="utf-8")
    assert len(pictures) == sum("image/png" in output for output in outputs)
    assert all(picture["alt"] and not picture["alt"].endswith(".png") for picture in pictures)
    named = [
        picture["alt"].removesuffix(get_message("site.figure", section="")) for picture in pictures
    ]
    sections = [
        name for name, picture in zip(named, pictures, strict=True) if name != picture["alt"]
    ]
    assert len(sections) == sum(
        "".join(output.get("text/plain", "")).startswith("<Figure") for output in outputs
    )
    words = "\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown")
    titles = re.findall(r"(?m)^#+ (.+)", words)
    assert {re.sub(r"\W", "", name) for name in sections} <= {
        re.sub(r"\W", "", title) for title in titles
    }
    assert text.count('class="still"') == sum(BOARD in output for output in outputs)
    assert BOARD not in text and "<script src=" in text


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda file: "/".join(file.parts[-2:]))
def test_formulas_in_lines_of_their_own_are_paragraphs(notebook):
    """Elsewhere the site shows their dollar signs."""
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    words = ["\n" + "".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown"]
    begun = [text for text in words if re.search(r"(?m)^(?!>? *$)(?!.*\$\$$).+\n>? *\$\$", text)]
    assert begun == []


def test_docstrings_are_plain_text(monkeypatch):
    """Code, lists of names and examples become markup; what only looks like markup stays as it
    is.
    """
    monkeypatch.syspath_prepend(HOUSE / "docs")
    from rendering import marked

    assert marked("RRT* and `a * b`, O_i, |x|") == r"RRT\* and ``a * b``, O\_i, \|x\|"
    assert (
        marked("Parameters\n----------\na_b, c (n,) : one\n    more\nd : two")
        == "**a\\_b, c (n,)**\n    one\n    more\n**d**\n    two"
    )
    assert (
        marked("pose : where it is. Raises\nInvalidPoint.")
        == "pose : where it is. Raises\nInvalidPoint."
    )
    assert marked(">>> a * b\n4") == ">>> a * b\n4"
    assert marked("    {1: *}") == "::\n\n    {1: *}"


def test_formulas_are_spaced_as_in_print():
    """A sign is no difference, a quotient is narrow, a function keeps off its argument, and := is
    one sign.
    """
    assert '<mo form="prefix">' in to_mathml(
        "v = -1", "inline"
    ) and '<mo form="prefix">' in to_mathml("(-20, 20)", "inline")
    assert "form=" not in to_mathml("a - 1", "inline") and "form=" not in to_mathml(
        "(a) - 1", "inline"
    )
    assert 'lspace="0"' in to_mathml(r"\pi/2", "inline")
    assert "<mo>:=</mo>" in to_mathml(r"q_\text{new} :=", "inline")
    assert 'rspace="0.278em">:<' in to_mathml(r"\{a : a > 0\}", "inline")
    assert to_mathml(r"r\sin\theta", "inline").count("<mspace") == 2 and "<mspace" not in to_mathml(
        r"\sin(x)", "inline"
    )
    assert "atan2" in to_mathml(r"\operatorname{atan2}(y, x)", "inline")


@pytest.fixture(scope="module")
def browser_page(chromium, site):
    """A page of Chromium, and the site's address on the disk; in the end there were no complaints,
    and no requests elsewhere.
    """
    address = site.as_uri()
    outside, errors = [], []
    page = chromium.new_page(viewport={"width": 480, "height": 900})
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on(
        "console",
        lambda message: (
            errors.append(message.text) if message.type in ("error", "warning") else None
        ),
    )
    page.route(
        lambda url: not url.startswith((address, "data:")),
        lambda route: (outside.append(route.request.url), route.abort()),
    )
    yield page, address
    page.close()
    assert outside == [] and errors == []


# Elements of the text that reach beyond the screen and cannot be scrolled to; pictures that are not
# there.
LOST = """() => {
    const scrolled = element => element.tagName !== 'ARTICLE'
        && (/auto|scroll/.test(getComputedStyle(element).overflowX)
            || scrolled(element.parentElement));
    const cut = [...document.querySelectorAll('article *')]
        .filter(element => element.getBoundingClientRect().right > innerWidth
            && !scrolled(element));
    const broken = [...document.images].filter(image => !image.naturalWidth);
    return [...cut, ...broken].map(lost => lost.outerHTML.slice(0, 200)); }"""


def test_pages_fit_a_telephone(browser_page, site):
    """Nothing is cut off, and every picture is there. Pages of source are all alike: the first
    stands for them.
    """
    page, address = browser_page
    files = sorted(file.relative_to(site).as_posix() for file in site.rglob("*.html"))
    sources = [file for file in files if file.startswith("_modules/")]
    for file in sources[:1] + [file for file in files if file not in sources]:
        page.goto(f"{address}/{file}", wait_until="load")
        for width in (360, 480):
            page.set_viewport_size({"width": width, "height": 900})
            assert page.evaluate(LOST) == [], file
            assert page.evaluate("document.documentElement.scrollWidth") == width, file
    page.goto(f"{address}/notebooks/09_trees.html")
    keep(page, "site_lesson")


def test_recorded_boards_play(browser_page):
    """A picture gives place to its board, which is scrubbed; only live ones are dragged."""
    page, address = browser_page
    page.goto(f"{address}/notebooks/09_trees.html", wait_until="load")
    records = page.locator(".kinoedu-record")
    assert records.count() > 0
    for number in range(records.count()):
        record = records.nth(number)
        record.scroll_into_view_if_needed()
        board = record.locator(".kinoedu-board[data-paints]").first
        board.wait_for()
        assert not record.locator("img").is_visible()
        total = int(board.get_attribute("data-total"))
        if total == 0:
            continue
        board.locator(".kinoedu-slider").press("Home")
        board.locator(".kinoedu-slider").press("ArrowRight")
        page.wait_for_function("board => board.dataset.step === '1'", arg=board.element_handle())
        is_live = record.locator(".kinoedu-live").count() > 0
        assert (board.locator(".kinoedu-thing").count() > 0) == is_live
    keep(page, "site_recorded")


def test_the_site_begins_with_a_board_that_answers(browser_page):
    """Its goal is moved by the keyboard, and the plan is another one."""
    page, address = browser_page
    page.goto(f"{address}/index.html", wait_until="load")
    board = page.locator(".kinoedu-board[data-paints]").first
    board.wait_for()
    status = board.locator("[role=status]")
    page.wait_for_function("e => e.textContent !== ''", arg=status.element_handle())
    before = status.inner_text()
    board.locator(".kinoedu-thing[aria-label^=goal]").press("ArrowUp")
    page.wait_for_function(
        "([e, before]) => e.textContent !== before", arg=[status.element_handle(), before]
    )
    assert "RRT" in status.inner_text()
    keep(page, "site_front")


@pytest.mark.parametrize(
    "lesson", ["02_bug_algorithms", "03_decomposition", "05_configuration_spaces"]
)
def test_boards_of_lessons_answer(browser_page, lesson):
    """A bug, whose plot follows, the sweep line, and an arm, whose second picture follows too."""
    page, address = browser_page
    page.goto(f"{address}/notebooks/{lesson}.html", wait_until="load")
    for place in page.locator(".kinoedu-record").all():
        place.scroll_into_view_if_needed()
    live = page.locator(".kinoedu-record:has(.kinoedu-live)").first
    live.wait_for()
    boards = live.locator(".kinoedu-board[data-paints]").all()
    before = [board.get_attribute("data-answers") for board in boards]
    boards[0].locator(".kinoedu-thing[data-thing^=handle]").last.press("ArrowUp")
    for board, answers in zip(boards, before, strict=True):
        changed = "([board, answers]) => board.dataset.answers !== answers"
        page.wait_for_function(changed, arg=[board.element_handle(), answers])
        assert board.get_attribute("data-warning") == ""
    keep(page, f"site_live_{lesson[:2]}")


def test_a_link_leads_to_its_section(browser_page):
    """Also past boards, which take more room than their pictures."""
    page, address = browser_page
    for part in ("two-trees", "a-world-that-is-only-seen"):
        page.goto(f"{address}/notebooks/09_trees.html#{part}", wait_until="load")
        page.wait_for_selector(".kinoedu-board[data-paints]", state="attached")
        place = "part => Math.abs(document.getElementById(part).getBoundingClientRect().top) < 100"
        page.wait_for_function(place, arg=part)
        page.wait_for_timeout(500)
        assert page.evaluate(place, part)


def test_a_page_is_whole_on_paper(browser_page):
    """No line of code, wide figure or column is cut off, and nothing stands over the text."""
    page, address = browser_page
    size = page.viewport_size
    page.emulate_media(media="print")
    page.set_viewport_size({"width": 703, "height": 1032})  # A4 without margins of 12 mm
    for name, wide in (("notebooks/09_trees", "img.wide"), ("docs/algorithms", "table")):
        page.goto(f"{address}/{name}.html", wait_until="load")
        assert page.locator(wide).count() > 0
        assert page.evaluate("""() => [...document.querySelectorAll(
                '.highlight pre, .cell_output, .table-wrapper')]
            .every((part) => part.scrollWidth <= part.clientWidth)""")
        assert not page.locator(".skip-to-content").is_visible()
    page.emulate_media(media="screen")
    page.set_viewport_size(size)


def test_words_are_found(browser_page):
    """Search answers with the lesson, the exercises and the place in the reference."""
    page, address = browser_page
    page.goto(f"{address}/search.html?q=dispersion")
    for target in (
        "notebooks/06_sampling.html",
        "exercises/06_sampling.html",
        "#kinoedu.sampling.dispersion",
    ):
        page.wait_for_selector(
            f"#search-results a[href*='{target}']", state="attached"
        )  # they come one after another

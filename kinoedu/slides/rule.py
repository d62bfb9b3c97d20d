"""The rule by which a notebook becomes slides.

1. A slide begins at each heading, with each figure or board (text before it is beside it, else the
   first paragraph after it), and where a slide has as much text as one can read.
2. Of a long paragraph the slide shows the first sentence (two, if the first is a label in bold),
   questions and what is in bold; all of it is in the notes. Lists, tables, formulas and theorems
   are shown whole; a proof is in the notes.
3. A question ("Predict") is shown whole. What is computed afterwards comes on the next slide; a
   board comes on the same one, since it is for trying.
4. Code of at most eight lines is shown with what it prints. Behind a picture, code is folded. Of a
   function's documentation the first line is shown.

A cell's own slide type (in JupyterLab: property inspector, Slide Type) comes before the rule:
`skip` leaves the cell out, `notes` puts it into the notes, `slide` and `subslide` begin a slide.
"""

import base64
import json
import re
from dataclasses import dataclass, field
from html import escape
from typing import Any

from ..boards.core.recorded import RECORD
from ..course.questions.asking import question_html
from ..course.questions.question import read_questions
from ..messages import get_message
from .markdown import Block, cut_into_blocks, shorten, title_html, to_html

MOST_WORDS = 95  # of text on one slide
MOST_LINES = 8  # of code that is shown with what it prints
LONGEST_CODE = 16  # lines of code that is shown for itself
MOST_PRINTED = 12  # lines of printed text
WIDE = 1.7  # of a picture that stands below its text: width by height
LONG = 56  # letters of a line of code that does not fit beside a text: it stands below it
NOT_SHOWN = re.compile(r"^(import |from \S+ import |# NBVAL|plt\.show|%)")
ASKS = re.compile(r'ke\.ask\("(\w+)"\)')


@dataclass
class Slide:
    """A slide: its title, its text, at most one figure, and its notes.

    Attributes
    ----------
    title : HTML of the title.
    text : HTML of the blocks beside the figure.
    figure : HTML of the figure, board or output, or "".
    notes : Markdown of what the lecturer says.
    words : how many words the text has.
    waits : whether a question was asked, whose answer must not be on this slide.
    """

    title: str = ""
    text: list[str] = field(default_factory=list)
    figure: str = ""
    notes: list[str] = field(default_factory=list)
    words: int = 0
    waits: bool = False

    @property
    def is_empty(self) -> bool:
        """Whether nothing but a title and notes is on it."""
        return not self.text and not self.figure


def cut_into_slides(book: Any) -> list[Slide]:
    """The slides of a notebook that was stored with its outputs."""
    slides = [Slide()]
    for cell in book["cells"]:
        kind = cell.get("metadata", {}).get("slideshow", {}).get("slide_type", "-")
        if kind in ("slide", "subslide"):
            begin(slides)
        if kind == "notes":
            slides[-1].notes.append("".join(cell["source"]))
        elif kind != "skip" and cell["cell_type"] == "markdown":
            for block in cut_into_blocks("".join(cell["source"])):
                add_block(slides, block)
        elif kind != "skip" and cell["cell_type"] == "code":
            add_code(slides, cell)
    return [slide for slide in slides if not slide.is_empty]


def begin(slides: list[Slide], title: str = "") -> Slide:
    """The slide to go on with: a new one, unless the last is still empty.

    Notes of an empty slide go to the slide that follows.
    """
    last = slides[-1]
    if not last.is_empty:
        slides.append(Slide(last.title))
    slides[-1].title = title or slides[-1].title
    return slides[-1]


def add_block(slides: list[Slide], block: Block) -> None:
    """Put a block of text on the last slide, or on a new one."""
    if block.kind == "heading":
        begin(slides, title_html(block.text))
        return
    last = slides[-1]
    if block.kind == "proof":
        last.notes.append(block.text)
        return
    shown = shorten(block.text) if block.kind == "prose" else block.text
    words = len(shown.split())
    comments = block.kind == "prose" and not last.text
    too_long = last.text and last.words + words > MOST_WORDS
    if last.waits or too_long or (last.figure and not comments):
        last = begin(slides)
    last.text.append(f'<div class="{block.kind}">{to_html(shown)}</div>')
    last.words += words
    last.waits = block.kind == "predict"
    if shown != block.text:
        last.notes.append(block.text)


def add_code(slides: list[Slide], cell: Any) -> None:
    """Put what a code cell shows on the last slide, or on a new one; short code beside it."""
    source = "".join(cell["source"])
    asked = ASKS.search(source)
    if asked:
        for question in read_questions(asked[1]):
            begin(slides).text.append(f'<div class="question">{question_html(question)}</div>')
        return
    outputs = [made for made in map(output_html, cell.get("outputs", ())) if made]
    lines = [line for line in source.strip().splitlines() if not NOT_SHOWN.match(line)]
    code = "\n".join(lines).strip()
    drawn = any('class="figure' in made for made in outputs)
    is_try = any("kinoedu-record" in made for made in outputs)
    last = slides[-1]
    if not outputs and (last.waits or not code.startswith("def ")):
        return
    if last.figure or (last.waits and not is_try):
        last = begin(slides)
    folded = drawn or len(lines) > (MOST_LINES if outputs else LONGEST_CODE)
    last.figure = (code_html(code, folded) if code else "") + "".join(outputs)
    if drawn and folded:
        last.figure = "".join(outputs) + code_html(code, folded)
    last.waits = False


def code_html(code: str, folded: bool) -> str:
    """Code, coloured; folded where it is not to be read now."""
    from pygments import highlight
    from pygments.formatters import HtmlFormatter
    from pygments.lexers import PythonLexer

    formatter = HtmlFormatter(noclasses=True, nobackground=True, style="friendly")
    is_long = any(len(line) > LONG for line in code.splitlines())
    shown = highlight(code, PythonLexer(), formatter)
    page = f'<div class="code{" long" if is_long else ""}">{shown}</div>'
    if not folded:
        return page
    return f"<details><summary>{escape(get_message('slides.code'))}</summary>{page}</details>"


def describe_picture(output: Any) -> str:
    """The alt text of an output's picture: its own, or the printed form of what it shows."""
    alt = output.get("metadata", {}).get("image/png", {}).get("alt", "")
    plain = "".join(output.get("data", {}).get("text/plain", ""))
    if not alt and plain and not plain.startswith("<"):
        alt = plain
    return str(alt or get_message("slides.picture"))


def base64_of_picture(output: Any) -> str:
    """An output's picture as a notebook stores it, in base64, without its line ends."""
    return "".join("".join(output["data"]["image/png"]).split())


def record_html(output: Any) -> str:
    """What an output has stored of its boards, where the page's script looks for it."""
    record = json.dumps(output["data"][RECORD]).replace("</", "<\\/")
    return f'<script type="application/json">{record}</script>'


def output_html(output: Any) -> str:
    """An output of a cell as HTML: a board that plays, a picture, or text."""
    data = output.get("data", {})
    plain = "".join(data.get("text/plain", output.get("text", "")))
    if "image/png" in data:
        alt = describe_picture(output)
        source = base64_of_picture(output)
        picture = f'<img alt="{escape(alt)}" src="data:image/png;base64,{source}">'
        if RECORD not in data:
            return f'<div class="figure{" wide" if is_wide(source) else ""}">{picture}</div>'
        shown = f'<div class="still-board">{picture}</div>'
        return f'<div class="figure kinoedu-record">{shown}{record_html(output)}</div>'
    if plain.startswith("# kinoedu/"):
        return code_html(without_documentation(plain), folded=False)
    if "text/html" in data:
        return f'<div class="printed">{"".join(data["text/html"])}</div>'
    lines = plain.rstrip().splitlines()
    if not lines or output.get("name") == "stderr":
        return ""
    more = ["..."] if len(lines) > MOST_PRINTED else []
    return f'<pre class="printed">{escape(chr(10).join(lines[:MOST_PRINTED] + more))}</pre>'


def is_wide(png: str) -> bool:
    """Whether a picture, in base64, needs the whole width of a slide."""
    head = base64.b64decode(png[:32])
    width, height = (int.from_bytes(head[at : at + 4], "big") for at in (16, 20))
    return width > WIDE * height


def without_documentation(source: str) -> str:
    """A function's source, with the first line of each docstring only."""
    documentation = re.compile(r'"""([^\n"]+)\n(?:(?!""").)*"""', re.DOTALL)
    return documentation.sub(r'"""\1"""', source)

"""One file of HTML with the slides of a lesson. It needs no network, and no kernel."""

import json
import os
from html import escape
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from ..boards.core.page_script import CORE, page_script
from ..errors import InvalidParameter
from ..lab import COURSE
from ..messages import get_message
from ..support.notebooks import read_notebook
from ..support.whole_files import written_whole
from .markdown import to_html
from .rule import Slide, cut_into_slides

HERE = Path(__file__).parent
NOTEBOOKS = COURSE / "notebooks"
PAGE = """\
<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<style>
{style}
</style>
</head>
<body>
<main>
{slides}
</main>
<nav>
<button id="previous" aria-label="{previous}">&#8592;</button>
<span id="place" aria-live="polite"></span>
<button id="next" aria-label="{next}">&#8594;</button>
<button id="notes">{notes}</button>
<button id="window">{window}</button>
</nav>
<p id="help">{help}</p>
<script>
const SLIDE_WORDS = {words};
{script}
</script>
<script>
{boards}
</script>
</body>
</html>
"""


def make_slides(
    lesson: str, folder: str | os.PathLike[str], notebooks: str | os.PathLike[str] = NOTEBOOKS
) -> Path:
    """Write the slides of a lesson.

    Parameters
    ----------
    lesson : name of its notebook, such as "01_geometry".
    folder : where to write LESSON.html.
    notebooks : the folder of the notebooks, which were stored with their outputs.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    InvalidParameter
        Where there is no such notebook, or formulas cannot be converted.
    UnreadableScene
        Where the notebook is damaged.
    """
    file = Path(notebooks) / f"{lesson}.ipynb"
    if not file.is_file():
        names = ", ".join(lessons_with_slides(notebooks)) or "none"
        raise InvalidParameter(get_message("slides.no_notebook", name=repr(lesson), names=names))
    if find_spec("latex2mathml") is None:
        raise InvalidParameter(get_message("slides.needs_formulas"))
    book = read_notebook(file)
    made = Path(folder) / f"{lesson}.html"
    made.parent.mkdir(parents=True, exist_ok=True)
    with written_whole(made) as part:
        part.write_text(page_html(book), encoding="utf-8")
    return made


def lessons_with_slides(notebooks: str | os.PathLike[str] = NOTEBOOKS) -> list[str]:
    """Names of the notebooks, in order."""
    return sorted(file.stem for file in Path(notebooks).glob("[0-9][0-9]_*.ipynb"))


def page_html(book: Any) -> str:
    """The page of a notebook's slides."""
    slides = cut_into_slides(book)
    words = {key: get_message(f"slides.{key}") for key in ("previous", "next", "notes", "window")}
    title = slides[0].title if slides else ""
    return PAGE.format(
        **words,
        title=escape(get_message("slides.title", title=title)),
        style=(CORE / "board.css").read_text(encoding="utf-8")
        + (HERE / "deck.css").read_text(encoding="utf-8"),
        slides="\n".join(slide_html(slide, n == 0) for n, slide in enumerate(slides)),
        help=escape(get_message("slides.help")),
        words=json.dumps(
            {
                "place": get_message("slides.place", number="{number}", count="{count}"),
                "notes": words["notes"],
                "no_notes": get_message("slides.no_notes"),
            }
        ),
        script=(HERE / "deck.js").read_text(encoding="utf-8"),
        boards=page_script().replace("</script", "<\\/script"),
    )


def slide_html(slide: Slide, is_first: bool) -> str:
    """A slide: title, text, figure, and the notes, which are hidden at first."""
    title = f"<h1>{slide.title}</h1>" if is_first else f"<h2>{slide.title}</h2>"
    text = f'<div class="text">{"".join(slide.text)}</div>' if slide.text else ""
    figure = f'<div class="beside">{slide.figure}</div>' if slide.figure else ""
    notes = to_html("\n\n".join(slide.notes)) if slide.notes else ""
    return (
        f'<section><div class="slide">{title}<div class="row">{text}{figure}</div></div>'
        f"<aside hidden>{notes}</aside></section>"
    )

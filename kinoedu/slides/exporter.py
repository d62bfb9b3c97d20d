"""A notebook as a page of HTML whose boards play without a kernel, made by nbconvert:

jupyter nbconvert --to kinoedu.slides.exporter.PageWithBoards NOTEBOOK.ipynb
"""

from copy import deepcopy
from html import escape
from typing import Any

from nbconvert.exporters import HTMLExporter

from ..boards.core.page_script import CORE, page_script
from ..boards.core.recorded import RECORD
from .rule import base64_of_picture, describe_picture, record_html

PLAYS = ".kinoedu-plays > img { display: none; }"  # the board itself is there instead
# On paper lines are wrapped, not cut, and headings stay with what follows.
PAGE = """
@media print {
  .jp-Cell .highlight pre { white-space: pre-wrap; }
  h1, h2, h3 { break-after: avoid; }
}
"""
WIDGET = "application/vnd.jupyter.widget-view+json"


class PageWithBoards(HTMLExporter):
    """nbconvert's page of HTML, in which every board that the notebook has stored can be played."""

    export_from_notebook = "HTML with boards"  # the name in JupyterLab's menu

    def from_notebook_node(  # type: ignore[override]  # HTMLExporter returns a text, too
        self, nb: Any, resources: dict[str, Any] | None = None, **options: Any
    ) -> tuple[str, dict[str, Any]]:
        """The page, and nbconvert's resources; the notebook stays as it is."""
        book = deepcopy(nb)
        outputs = [output for cell in book.cells for output in cell.get("outputs", [])]
        pictures = [output for output in outputs if "image/png" in output.get("data", {})]
        stored = [output for output in pictures if RECORD in output.data]
        for output in pictures:
            output.data.pop(WIDGET, None)  # which nbconvert would prefer, and which needs a kernel
            output.data["text/html"] = (board_html if output in stored else picture_html)(output)
        page, resources = super().from_notebook_node(book, resources, **options)
        page = page.replace("</head>", f"<style>{PAGE}</style>\n</head>", 1)
        return (add_player(page) if stored else page), resources


def board_html(output: Any) -> str:
    """The element of the boards of an output, with their picture for those without JavaScript."""
    return f'<div class="kinoedu-record">{picture_html(output)}{record_html(output)}</div>'


def picture_html(output: Any) -> str:
    """The picture of an output at the size at which it is shown, with its alt text."""
    about = output.get("metadata", {}).get("image/png", {})
    size = "".join(f' {name}="{about[name]}"' for name in ("width", "height") if name in about)
    alt = escape(describe_picture(output), quote=True)
    return f'<img alt="{alt}"{size} src="data:image/png;base64,{base64_of_picture(output)}">'


def add_player(page: str) -> str:
    """A page with the style and the script that play boards."""
    style = (CORE / "board.css").read_text(encoding="utf-8")
    script = page_script().replace("</script", "<\\/script")
    end = page.rindex("</body>")
    return f"{page[:end]}<style>\n{style}{PLAYS}</style>\n<script>\n{script}</script>\n{page[end:]}"

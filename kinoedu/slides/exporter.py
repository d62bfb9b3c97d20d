"""A notebook as a page of HTML whose boards play without a kernel, made by nbconvert:

jupyter nbconvert --to kinoedu.slides.exporter.PageWithBoards NOTEBOOK.ipynb
"""

import json
from copy import deepcopy
from html import escape
from typing import Any

from nbconvert.exporters import HTMLExporter

from ..boards.core.page_script import CORE, page_script
from ..boards.core.recorded import RECORD
from ..messages import get_message

PLAYS = ".kinoedu-plays > img { display: none; }"  # the board itself is there instead
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
        stored = [output.data for output in outputs if RECORD in output.get("data", {})]
        for data in stored:
            data.pop(WIDGET, None)  # which nbconvert would prefer, and which needs a kernel
            data["text/html"] = board_html(data)
        page, resources = super().from_notebook_node(book, resources, **options)
        return (add_player(page) if stored else page), resources


def board_html(data: dict[str, Any]) -> str:
    """The element of the boards of an output, with their picture for those without JavaScript."""
    source = "".join("".join(data.get("image/png", "")).split())
    text = escape("".join(data.get("text/plain", get_message("slides.picture"))), quote=True)
    record = json.dumps(data[RECORD]).replace("</", "<\\/")
    return (
        f'<div class="kinoedu-record"><img alt="{text}" src="data:image/png;base64,{source}">'
        f'<script type="application/json">{record}</script></div>'
    )


def add_player(page: str) -> str:
    """A page with the style and the script that play boards."""
    style = (CORE / "board.css").read_text(encoding="utf-8")
    script = page_script().replace("</script", "<\\/script")
    end = page.rindex("</body>")
    return f"{page[:end]}<style>\n{style}{PLAYS}</style>\n<script>\n{script}</script>\n{page[end:]}"

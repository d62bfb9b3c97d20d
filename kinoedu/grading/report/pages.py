"""Pages of HTML that stand alone: one file each, without scripts or anything fetched.

All text is escaped.
"""

import re
from collections.abc import Iterable
from html import escape
from pathlib import Path

from ...figures import palette
from ...messages import get_message
from ...support.text import show_controls, with_code
from ...support.whole_files import written_whole

STYLE = f"""
body {{
  font: 16px/1.5 system-ui, "Segoe UI", Roboto, sans-serif; color: {palette.INK};
  margin: 2rem auto; max-width: 62rem; padding: 0 1rem;
}}
h1 {{ font-size: 1.6rem; margin: 0 0 .3rem }}
h2 {{ font-size: 1.2rem; margin: 2.2rem 0 .5rem }}
p {{ margin: .4rem 0; max-width: 46rem; overflow-wrap: anywhere }}
table {{ border-collapse: collapse }}
.wide {{ overflow-x: auto }}
th, td {{ text-align: left; padding: .3rem .9rem .3rem 0; border-bottom: 1px solid #E5E7EB; \
vertical-align: top }}
td {{ overflow-wrap: break-word }}
.wide :is(th, td):first-child {{ position: sticky; left: 0; background: #FFFFFF }}
td wbr {{ display: none }}
.wide + p {{ margin-top: 2.2rem }}
.n {{ text-align: right; font-variant-numeric: tabular-nums }}
td.n, h2 .n {{ white-space: nowrap }}
section {{ border-left: 6px solid {palette.OUTSIDE}; padding: .1rem 0 .3rem 1.1rem; \
margin: 1.6rem 0 }}
section h2 {{ margin: 0; display: flex; justify-content: space-between; gap: 1rem }}
section.all {{ border-color: {palette.TRUE} }}
section.some {{ border-color: {palette.PATH} }}
section.none {{ border-color: {palette.YOURS} }}
dl {{ display: grid; grid-template-columns: 9rem 1fr; gap: .3rem .8rem; margin: .6rem 0 }}
dt {{ color: {palette.OBSTACLE} }}
dd {{ margin: 0; min-width: 0; white-space: pre-wrap; overflow-wrap: anywhere }}
code, pre {{ font: 15px/1.45 ui-monospace, Consolas, monospace }}
pre {{ white-space: pre-wrap; overflow-wrap: anywhere; margin: .3rem 0 }}
img, svg {{ max-width: 100%; height: auto; display: block; margin: .4rem 0 }}
.two {{ display: grid; grid-template-columns: 1fr 1fr; gap: 0 1.2rem; \
margin: 1rem calc(50% - 48vw) }}
.two > * {{ min-width: 0; margin: 0; padding: .5rem .8rem; border-bottom: 1px solid #E5E7EB }}
mark {{ background: {palette.PATH}40; color: inherit }}
.quiet {{ color: {palette.OBSTACLE} }}
@media (max-width: 40rem) {{
  dl {{ grid-template-columns: 1fr }}
  dt {{ margin-top: .3rem }}
  table {{ font-size: .85rem }}
  td wbr {{ display: inline }}
  th, td {{ padding-right: .6rem }}
  .two {{ grid-template-columns: 1fr; margin: 1rem 0 }}
  .two > * {{ padding: .5rem 0 }}
  .two > h2, .two > pre:empty {{ display: none }}
  .two > pre {{ font-size: .8rem }}
  .two > pre::before {{ content: attr(title); display: block; \
font: 600 1rem system-ui, sans-serif }}
}}
@media print {{ body {{ margin: 0 }} section {{ break-inside: avoid }} }}
"""
BETWEEN_WORDS = re.compile(r"([_/])(?=[^_/])")
POLICY = "default-src 'none'; img-src data:; style-src 'unsafe-inline'"


def page(title: str, body: Iterable[str]) -> str:
    """A whole page; `body` is HTML."""
    return (
        f'<!doctype html>\n<html lang="{get_message("grades.language")}">\n<meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">\n'
        f'<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{escape(title)}</title>\n<style>{STYLE}</style>\n<h1>{escape(title)}</h1>\n"
        + "\n".join(body)
        + "\n</html>\n"
    )


def paragraph(text: str, kind: str = "") -> str:
    """A paragraph of text, with code between backticks.

    >>> paragraph("`a < b`", "quiet")
    '<p class="quiet"><code>a &lt; b</code></p>'
    """
    return f'<p class="{kind}">{with_code(text)}</p>' if kind else f"<p>{with_code(text)}</p>"


def breakable(text: str) -> str:
    """Text of a cell, in which long names may be broken after _ and / on narrow pages.

    >>> breakable("a/b_c < d")
    'a/<wbr>b_<wbr>c &lt; d'
    """
    return BETWEEN_WORDS.sub(r"\1<wbr>", escape(text))


def heading(text: str) -> str:
    """The heading of a part of a page."""
    return f"<h2>{escape(text)}</h2>"


def table(head: Iterable[str], rows: Iterable[Iterable[str]], numbers: int = 0) -> str:
    """A table of HTML cells with column names; the last `numbers` columns hold numbers."""
    names = list(head)
    kinds = ["" if at < len(names) - numbers else ' class="n"' for at in range(len(names))]
    lines = ["".join(f"<td{kind}>{cell}</td>" for kind, cell in zip(kinds, row)) for row in rows]
    top = "".join(f"<th{kind}>{breakable(name)}</th>" for kind, name in zip(kinds, names))
    return (
        '<div class="wide"><table>\n<tr>'
        + top
        + "</tr>\n"
        + "".join(f"<tr>{line}</tr>\n" for line in lines)
        + "</table></div>"
    )


def write_page(file: Path, text: str) -> None:
    """Write a page, completely or not at all, with its control characters made visible."""
    file.parent.mkdir(parents=True, exist_ok=True)
    with written_whole(file) as part:
        part.write_text(show_controls(text), encoding="utf-8")

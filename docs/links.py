"""Follows the links of the course's pages: Markdown files, and the text of notebooks.

python docs/links.py prints how many links there are, those that lead nowhere, and those that lead
to other sites, which are not fetched.
"""

import json
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple
from urllib.parse import unquote, urlsplit

from markdown_it import MarkdownIt

HOUSE = Path(__file__).resolve().parent.parent
MARKDOWN = MarkdownIt("commonmark").enable("table")
ATTRIBUTE = re.compile(r"""(href|src|id|name)=["']([^"']*)["']""")
GENERATED = {"build", "dist", "node_modules", "__pycache__"}


class Page(NamedTuple):
    """What the text of a file leads to, and the parts of it that can be led to."""

    links: list[str]
    parts: set[str]


class Link(NamedTuple):
    """A link, and the file that it is in."""

    file: Path
    target: str


def find_pages(house: Path) -> list[Path]:
    """All Markdown files and notebooks, but for those that tools have made."""
    files = [file for kind in ("md", "ipynb") for file in house.rglob(f"*.{kind}")]
    return sorted(file for file in files if not is_generated(file.relative_to(house)))


def is_generated(place: Path) -> bool:
    """Whether a path in the course is in a folder of a tool."""
    folders = place.parts[:-1]
    hidden = any(name.startswith(".") and name != ".github" for name in folders)
    return hidden or not GENERATED.isdisjoint(folders)


def read_page(file: Path) -> Page:
    """The links and parts of a Markdown file, or of a notebook's text."""
    text = file.read_text(encoding="utf-8")
    texts = [text]
    if file.suffix == ".ipynb":
        cells = json.loads(text)["cells"]
        texts = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown"]
    links, parts = [], set()
    for tokens in map(MARKDOWN.parse, texts):
        for before, token in zip([None, *tokens], tokens):
            if before is not None and before.type == "heading_open":
                parts |= anchors(token.content)
            for part in [token, *(token.children or [])]:
                links += [part.attrs[name] for name in ("href", "src") if name in part.attrs]
                if part.type in ("html_inline", "html_block"):
                    found = ATTRIBUTE.findall(part.content)
                    links += [value for name, value in found if name in ("href", "src")]
                    parts |= {value for name, value in found if name in ("id", "name")}
    return Page(links, parts)


def anchors(heading: str) -> set[str]:
    """How a heading is led to: on GitHub and the site, and in JupyterLab.

    Examples
    --------
    >>> sorted(anchors("What `check` needs"))
    ['What-check-needs', 'what-check-needs']
    """
    plain = re.sub(r"[`*]|\]\([^)]*\)|\[", "", heading)
    return {re.sub(r"[^\w -]", "", plain).lower().replace(" ", "-"), plain.replace(" ", "-")}


def follow(house: Path) -> Iterator[tuple[Link, bool | None]]:
    """All links of a course, each with whether it leads somewhere; None for other sites."""
    pages = {file: read_page(file) for file in find_pages(house)}
    for file, page in pages.items():
        for target in page.links:
            there = urlsplit(target)
            if there.scheme or there.netloc:
                yield Link(file, target), None
                continue
            leads_to = file.parent.joinpath(unquote(there.path)).resolve() if there.path else file
            has_part = not there.fragment or (
                leads_to in pages and unquote(there.fragment) in pages[leads_to].parts
            )
            yield (
                Link(file, target),
                leads_to.exists() and leads_to.is_relative_to(house) and has_part,
            )


def main() -> int:
    """Print the links; 1 if some lead nowhere."""
    links = list(follow(HOUSE))
    broken = [link for link, sound in links if sound is False]
    outside = sorted({link.target for link, sound in links if sound is None})
    print(f"{len(links)} links, {len(broken)} of them broken, {len(outside)} addresses outside")
    for link in broken:
        print(f"broken: {link.file.relative_to(HOUSE)}: {link.target}")
    for address in outside:
        print(f"outside: {address}")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())

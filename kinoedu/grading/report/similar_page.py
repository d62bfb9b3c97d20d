"""Similar programs, for people to look at: a page and a table of pairs, and a page per pair."""

from collections.abc import Iterable, Iterator
from html import escape
from itertools import repeat
from pathlib import Path

from ...messages import get_message
from ...support.csv_cells import escape_formula, number, write_rows
from .fingerprints import Piece
from .pages import breakable, heading, page, paragraph, table, write_page
from .similar import Likeness, Similar

COLUMNS = ("assignment", "first", "second", "weight", "share_of_first", "share_of_second", "page")


def write_similar(found: list[Similar], folder: Path) -> int:
    """Write similar.html, similar.csv and pairs/*.html, and remove pages of earlier pairs.

    Returns
    -------
    int
        The number of pairs.
    """
    pairs = [(place, of, one) for of in found for place, one in place_pairs(of)]
    for place, of, one in pairs:
        write_page(folder / place, render_pair_page(of, one))
    for file in (folder / "pairs").glob("*.html"):
        if file.relative_to(folder).as_posix() not in {place for place, _, _ in pairs}:
            file.unlink()
    lines = []
    for place, of, one in pairs:
        names = map(escape_formula, (of.assignment, one.first.name, one.second.name))
        lines.append([*names, *map(number, one[2:]), place])
    folder.mkdir(parents=True, exist_ok=True)
    write_rows(folder / "similar.csv", [COLUMNS, *lines])
    body = [paragraph(get_message("similar.about")), *map(render_pairs, found)]
    write_page(folder / "similar.html", page(get_message("similar.title"), body))
    return len(pairs)


def place_pairs(of: Similar) -> Iterator[tuple[str, Likeness]]:
    """Yield each pair of an assignment, with the path of its page."""
    for at, one in enumerate((*of.each_other, *of.course), 1):
        yield f"pairs/{of.assignment}-{at:04d}.html", one


def render_pairs(of: Similar) -> str:
    """An assignment's pairs, as two tables."""
    pages, middle = list(place_pairs(of)), len(of.each_other)
    count = get_message("similar.count", count=len(of.programs))
    parts = [paragraph(f"{of.assignment}: {count}", "quiet")]
    columns = ("first", "second", "of_first", "of_second", "weight")
    head = [get_message(f"similar.{column}") for column in columns]
    for key, pairs in (("each_other", pages[:middle]), ("course", pages[middle:])):
        parts.append(heading(f"{of.assignment}: {get_message(f'similar.{key}')}"))
        parts.append(
            table(head, map(render_row, pairs), numbers=3)
            if pairs
            else paragraph(get_message("similar.nothing"), "quiet")
        )
    return "\n".join(parts)


def render_row(pair: tuple[str, Likeness]) -> list[str]:
    """A pair's cells, in HTML."""
    place, one = pair
    names = f'<a href="{place}">{breakable(one.first.name)}</a>', breakable(one.second.name)
    return [*names, *map(format_percent, (one.of_first, one.of_second)), f"{one.weight:.0f}"]


def format_percent(fraction: float) -> str:
    """A fraction as text.

    >>> format_percent(0.996)
    '100 %'
    """
    return f"{100.0 * fraction:.0f} %"


def render_pair_page(of: Similar, one: Likeness) -> str:
    """Two programs side by side: the pieces that have something in common, with it marked."""
    shared = one.first.prints & one.second.prints
    shares = get_message(
        "similar.shares", first=format_percent(one.of_first), second=format_percent(one.of_second)
    )
    names = (one.first.name, one.second.name)
    body = [paragraph(get_message("similar.about")), paragraph(shares, "quiet")]
    body += ['<div class="two">', *(f"<h2>{escape(name)}</h2>" for name in names)]
    for pieces in match_pieces(one.first.pieces, one.second.pieces, shared):
        body += map(render_piece, pieces, names, repeat(shared))
    return page(f"{of.assignment}: {get_message('similar.title')}", [*body, "</div>"])


def match_pieces(
    first: Iterable[Piece], second: Iterable[Piece], shared: set[int]
) -> Iterator[tuple[Piece | None, Piece | None]]:
    """Yield the pieces with common fingerprints in pairs.

    Each piece of the first is paired with that of the second that shares the most with it.
    """
    left = [piece for piece in second if shared & piece.prints.keys()]
    for piece in first:
        common = shared & piece.prints.keys()
        if common:
            partner = max(left, key=lambda other: len(common & other.prints.keys()), default=None)
            left = [other for other in left if other is not partner]
            yield piece, partner
    for other in left:
        yield None, other


def render_piece(piece: Piece | None, name: str, shared: set[int]) -> str:
    """A piece as HTML, with its author's name for narrow pages; empty if there is no piece."""
    if piece is None:
        return "<pre></pre>"
    return f'<pre title="{escape(name)}">{mark_lines(piece, shared)}</pre>'


def mark_lines(piece: Piece, shared: set[int]) -> str:
    """A piece's lines as HTML, with the shared ones marked."""
    common = {
        line
        for one in shared & piece.prints.keys()
        for line in range(piece.prints[one][0], piece.prints[one][1] + 1)
    }
    return "\n".join(
        f"<mark>{escape(line)}</mark>" if at in common else escape(line)
        for at, line in enumerate(piece.lines)
    )

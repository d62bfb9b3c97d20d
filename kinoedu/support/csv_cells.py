"""Tables for spreadsheets, in which no cell is taken for a formula and no cell breaks its row."""

import csv
import io
import unicodedata
from collections.abc import Iterable
from pathlib import Path

from .text import show_controls
from .whole_files import written_whole

# what a formula begins with; spreadsheets also accept the full-width forms, the last four
FORMULA = ("=", "+", "-", "@", "\uff1d", "\uff0b", "\uff0d", "\uff20")


def one_line(text: str) -> str:
    """Text on one line, where control characters are visible, also those for right-to-left text.

    Letters have one spelling: macOS writes an accent in a file's name as a character of its own.

    >>> print(one_line("ann\\x1b[2J\\u202e\\nb"))
    ann\\x1b[2J\\u202e b
    """
    shown = show_controls(unicodedata.normalize("NFC", text))
    return " ".join("".join(c if c.isprintable() else " " for c in shown).split())


def escape_formula(text: str) -> str:
    """Text on one line, after an apostrophe where a spreadsheet would take it for a formula.

    >>> escape_formula("=cmd|' /C calc'!A0"), escape_formula("two\\nlines"), escape_formula("-1")
    ("'=cmd|' /C calc'!A0", 'two lines', "'-1")
    """
    line = one_line(text)
    return f"'{line}" if line.lstrip("'").startswith(FORMULA) else line


def unescape_formula(text: str) -> str:
    """The text of a cell before `escape_formula`.

    >>> unescape_formula(escape_formula("=ann")), unescape_formula("'tis")
    ('=ann', "'tis")
    """
    return text[1:] if text.startswith("'") and text.lstrip("'").startswith(FORMULA) else text


def number(score: float | None) -> str:
    """A score as a cell; empty where there is none.

    >>> number(2.0000000000000004), number(1 / 3), number(None)
    ('2', '0.333333', '')
    """
    return "" if score is None else f"{round(score, 6):.12g}"


def write_rows(file: Path, rows: Iterable[Iterable[str]]) -> None:
    """Write a table, whole or not at all, in UTF-8."""
    with written_whole(file) as part:
        part.write_bytes(format_table(rows))


def format_table(rows: Iterable[Iterable[str]]) -> bytes:
    """The bytes of a table.

    >>> format_table([["a", "b"], ["1", "2,5"]])
    b'a,b\\n1,"2,5"\\n'
    """
    stream = io.StringIO(newline="")
    csv.writer(stream, lineterminator="\n").writerows(rows)
    return stream.getvalue().encode("utf-8", "replace")

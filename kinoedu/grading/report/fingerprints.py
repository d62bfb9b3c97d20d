"""A program's fingerprints, which do not change with names, comments, layout or order of functions.

The program is read as Python's syntax tree. All names that it binds itself become one word;
annotations, imports and docstrings are left out. Each run of RUN words gives one number, and of
every WINDOW neighbouring numbers the smallest is kept. So a common part of two programs, if it is
long enough, has a fingerprint in both. If Python cannot parse a cell, each of its lines gives a
number. Nothing is run. Source: Schleimer, Wilkerson, Aiken, Winnowing: local algorithms for
document fingerprinting, SIGMOD 2003.
"""

import ast
import warnings
import zlib
from collections.abc import Iterable, Iterator
from itertools import groupby
from typing import NamedTuple

from ...support.text import split_lines

RUN = 24  # words, about two lines; shorter runs are often equal by chance
WINDOW = 8  # neighbours of which one is kept; RUN + WINDOW - 1 common words are always seen
LONGEST = 200_000  # characters of a cell that is parsed
SHORTEST = 12  # characters of a line that counts, in a cell that Python cannot parse
IGNORED_FIELDS = ("annotation", "returns", "ctx", "type_comment", "type_params")
Lines = tuple[int, int]  # the first and the last line


class Piece(NamedTuple):
    """A function, a class, or consecutive statements.

    lines : its source.
    prints : its fingerprints, each with its first and last line, from 0.
    """

    lines: list[str]
    prints: dict[int, Lines]


class Cell(NamedTuple):
    """A cell's lines and its syntax tree; None where Python cannot parse it."""

    lines: list[str]
    tree: ast.Module | None


def split_program(sources: Iterable[str], window: int = WINDOW) -> list[Piece]:
    """The pieces of a program, given as cells; pieces without fingerprints are left out.

    window : the number of neighbours of which one is kept; 1 keeps every fingerprint.

    >>> text = (
    ...     "def {0}({1}):\\n    {2} = {1} + 1  # {0}\\n"
    ...     "    return [{2} * {1} for _ in range({2}) if {1} > {2}]"
    ... )
    >>> one, other = (split_program([text.format(*names)]) for names in ("fgh", "uvw"))
    >>> one[0].prints == other[0].prints != {}
    True
    """
    cells = [
        Cell([line.rstrip("\r\n") for line in split_lines(source)], parse_cell(source))
        for source in sources
    ]
    own = {name for cell in cells if cell.tree is not None for name in find_bound_names(cell.tree)}
    found = [
        piece
        for cell in cells
        for piece in (
            fingerprint_lines(cell) if cell.tree is None else fingerprint_syntax(cell, own, window)
        )
    ]
    return [piece for piece in found if piece.prints]


def parse_cell(source: str) -> ast.Module | None:
    """The syntax tree of a cell; None where Python cannot parse it."""
    if len(source) > LONGEST:
        return None
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return ast.parse(source)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None


def find_bound_names(tree: ast.Module) -> Iterator[str]:
    """Yield the names that a program binds itself, except by imports."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Name | ast.Attribute) and isinstance(node.ctx, ast.Store):
            yield node.id if isinstance(node, ast.Name) else node.attr
        elif isinstance(node, ast.FunctionDef | ast.ClassDef | ast.AsyncFunctionDef):
            yield node.name
        elif isinstance(node, ast.arg):
            yield node.arg


def fingerprint_lines(cell: Cell) -> Iterator[Piece]:
    """Yield a cell that Python cannot parse, with a fingerprint for each longer line."""
    lines = {at: "".join(line.partition("#")[0].split()) for at, line in enumerate(cell.lines)}
    yield Piece(
        cell.lines,
        {
            hash_text("line " + line): (at, at)
            for at, line in lines.items()
            if len(line) >= SHORTEST
        },
    )


def fingerprint_syntax(cell: Cell, own: set[str], window: int) -> Iterator[Piece]:
    """Yield each function and each class of a cell, and the statements between them."""
    assert cell.tree is not None
    numbered = enumerate(cell.tree.body)
    for _, group in groupby(
        numbered, lambda one: one[0] if isinstance(one[1], ast.FunctionDef | ast.ClassDef) else None
    ):
        nodes = [node for _, node in group]
        first = (
            min(node.lineno for node in (nodes[0], *getattr(nodes[0], "decorator_list", ()))) - 1
        )
        yield Piece(
            cell.lines[first : nodes[-1].end_lineno],
            select_fingerprints(list(list_words(nodes, own, first)), window),
        )


def select_fingerprints(words: list[tuple[int, int]], window: int) -> dict[int, Lines]:
    """The fingerprints of words, each word given with its line.

    Of every `window` neighbouring runs the smallest is kept; ties go to the last.
    """
    runs = [
        hash(tuple(word for word, _ in words[at : at + RUN])) for at in range(len(words) - RUN + 1)
    ]
    selected: dict[int, Lines] = {}
    for at in range(min(len(runs), max(1, len(runs) - window + 1))):
        _, back = min((run, -place) for place, run in enumerate(runs[at : at + window]))
        lines = [line for _, line in words[at - back : at - back + RUN]]
        selected.setdefault(runs[at - back], (min(lines), max(lines)))
    return selected


def list_words(nodes: list[ast.stmt], own: set[str], first: int) -> Iterator[tuple[int, int]]:
    """Yield the words of a syntax tree from the top, as numbers, with their lines after `first`."""
    line, left = first, list[ast.AST](reversed(nodes))
    while left:
        node = left.pop()
        line = getattr(node, "lineno", line + 1) - 1
        if has_no_effect(node):
            continue
        yield hash_text(name_node(node, own)), line - first
        below = [value for name, value in ast.iter_fields(node) if name not in IGNORED_FIELDS]
        children = [
            child for value in below for child in (value if isinstance(value, list) else [value])
        ]
        left += [child for child in reversed(children) if isinstance(child, ast.AST)]


def has_no_effect(node: ast.AST) -> bool:
    """Whether a node has no effect on how a program works: an import, a docstring."""
    text = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
    return text or isinstance(node, ast.Import | ast.ImportFrom)


def name_node(node: ast.AST, own: set[str]) -> str:
    """A node as a word. Names that the program does not bind itself, such as sqrt, are kept."""
    if isinstance(node, ast.Name):
        return "own" if node.id in own else node.id
    if isinstance(node, ast.Attribute):
        return ".own" if node.attr in own else f".{node.attr}"
    if isinstance(node, ast.Constant):
        return spell_constant(node.value)
    return {"AnnAssign": "Assign"}.get(type(node).__name__, type(node).__name__)


def spell_constant(value: object) -> str:
    """A constant as a word; all texts are equal, and so are all very long numbers."""
    if isinstance(value, str | bytes):
        return "text"
    return "long" if isinstance(value, int) and abs(value) > 10**18 else repr(value)


def hash_text(text: str) -> int:
    """A number for a text, the same in every process."""
    return zlib.crc32(text.encode("utf-8", "replace"))

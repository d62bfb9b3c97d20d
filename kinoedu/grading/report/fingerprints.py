"""A program's fingerprints: numbers that stay the same when names, comments, layout and the order
of functions change.

The program is read as Python's own syntax tree. Names that it binds itself are all one word,
annotations, imports and documentation are left out. Of every run of so many words one number is
made, and of neighbouring numbers the smallest is kept, so that whatever two programs share, if it
is long enough, is seen in both. Where Python cannot read a cell, its lines count as they are.
Nothing is run. Source: Schleimer, Wilkerson, Aiken, Winnowing: local algorithms for document
fingerprinting, SIGMOD 2003.
"""

import ast
import warnings
import zlib
from collections.abc import Iterable, Iterator
from itertools import groupby
from typing import Any, NamedTuple

RUN = 24  # words: about two lines; less than that many write by themselves
WINDOW = 8  # neighbours, of which one is kept: what is RUN + WINDOW - 1 words long is always seen
LONGEST = 200_000  # characters of a cell to be read as Python
SHORTEST = 12  # characters of a line that counts, where Python cannot read the cell
UNSAID = ("annotation", "returns", "ctx", "type_comment", "type_params")
Lines = tuple[int, int]  # the first and the last


class Piece(NamedTuple):
    """A function, a class, or some statements in a row: its lines, and where in them, from 0, each
    fingerprint is from.
    """

    lines: list[str]
    prints: dict[int, Lines]


class Cell(NamedTuple):
    """A cell's lines, and what Python reads in them; None where it cannot."""

    lines: list[str]
    tree: ast.Module | None


def pieces(sources: Iterable[str], window: int = WINDOW) -> list[Piece]:
    """The pieces of a program given as cells, those without fingerprints left out. window : 1 keeps
    every fingerprint.

    >>> text = "def {0}({1}):\\n    {2} = {1} + 1  # {0}\\n    return [{2} * {1} for _ in range({2}) if {1} > {2}]"
    >>> one, other = (pieces([text.format(*names)]) for names in ("fgh", "uvw"))
    >>> one[0].prints == other[0].prints != {}
    True
    """
    cells = [Cell(source.splitlines(), tree_of(source)) for source in sources]
    own = {name for cell in cells if cell.tree is not None for name in bound(cell.tree)}
    found = [
        piece
        for cell in cells
        for piece in (by_lines(cell) if cell.tree is None else by_syntax(cell, own, window))
    ]
    return [piece for piece in found if piece.prints]


def tree_of(source: str) -> ast.Module | None:
    """What Python reads in a cell; None where it cannot."""
    if len(source) > LONGEST:
        return None
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return ast.parse(source)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None


def bound(tree: ast.Module) -> Iterator[str]:
    """The names that a program binds itself, but for what it imports."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Name | ast.Attribute) and isinstance(node.ctx, ast.Store):
            yield node.id if isinstance(node, ast.Name) else node.attr
        elif isinstance(node, ast.FunctionDef | ast.ClassDef | ast.AsyncFunctionDef):
            yield node.name
        elif isinstance(node, ast.arg):
            yield node.arg


def by_lines(cell: Cell) -> Iterator[Piece]:
    """A cell that Python cannot read: each line that is not short."""
    lines = {at: "".join(line.partition("#")[0].split()) for at, line in enumerate(cell.lines)}
    yield Piece(
        cell.lines,
        {crc("line " + line): (at, at) for at, line in lines.items() if len(line) >= SHORTEST},
    )


def by_syntax(cell: Cell, own: set[str], window: int) -> Iterator[Piece]:
    """Each function and each class of a cell, and what stands between them."""
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
            cell.lines[first : nodes[-1].end_lineno], prints(list(words(nodes, own, first)), window)
        )


def prints(said: list[tuple[int, int]], window: int) -> dict[int, Lines]:
    """The fingerprints of words, each with its line: of every window of neighbours the smallest,
    the last of equal ones.
    """
    runs = [
        hash(tuple(word for word, _ in said[at : at + RUN])) for at in range(len(said) - RUN + 1)
    ]
    kept: dict[int, Lines] = {}
    for at in range(min(len(runs), max(1, len(runs) - window + 1))):
        _, back = min((run, -place) for place, run in enumerate(runs[at : at + window]))
        lines = [line for _, line in said[at - back : at - back + RUN]]
        kept.setdefault(runs[at - back], (min(lines), max(lines)))
    return kept


def words(nodes: list[ast.stmt], own: set[str], first: int) -> Iterator[tuple[int, int]]:
    """What a syntax tree says, word by word from the top, each as a number and with its line after
    the first.
    """
    line, left = first, list[ast.AST](reversed(nodes))
    while left:
        node = left.pop()
        line = getattr(node, "lineno", line + 1) - 1
        if is_silent(node):
            continue
        yield crc(word(node, own)), line - first
        below = [value for name, value in ast.iter_fields(node) if name not in UNSAID]
        children = [
            child for value in below for child in (value if isinstance(value, list) else [value])
        ]
        left += [child for child in reversed(children) if isinstance(child, ast.AST)]


def is_silent(node: ast.AST) -> bool:
    """Whether it says nothing of how a program works: imports, documentation."""
    text = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
    return text or isinstance(node, ast.Import | ast.ImportFrom)


def word(node: ast.AST, own: set[str]) -> str:
    """A node as a word. What others have named, such as sqrt, keeps its name."""
    if isinstance(node, ast.Name):
        return "own" if node.id in own else node.id
    if isinstance(node, ast.Attribute):
        return ".own" if node.attr in own else f".{node.attr}"
    if isinstance(node, ast.Constant):
        return spelled(node.value)
    return {"AnnAssign": "Assign"}.get(type(node).__name__, type(node).__name__)


def spelled(value: Any) -> str:
    """A constant: texts are all the same, and so are numbers too long to be spelled."""
    if isinstance(value, str | bytes):
        return "text"
    return "long" if isinstance(value, int) and abs(value) > 10**18 else repr(value)


def crc(text: str) -> int:
    """The same number for the same text, in every process."""
    return zlib.crc32(text.encode("utf-8", "replace"))

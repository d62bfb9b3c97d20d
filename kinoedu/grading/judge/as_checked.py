"""A notebook as the check of one question saw it: its cells down to that check.

Checks run where they stand, and grading calls functions after all cells have run. A cell below a
check may give another meaning to a name that the function uses, such as a helper `dist` that
another exercise needs with other arguments. The function was right for its check, and is not wrong.

Cells are only parsed here. Compiling them may take more time and memory than there is.
"""

import ast
import re
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from ..collect.notebook import Cell
from ..sandbox.cells import Failure, find_names, is_placeholder, parse_cell

FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)


class CellNames(NamedTuple):
    """The names to which a cell gives or takes a meaning, and those that its functions use."""

    bound: set[str]
    used: set[str]


def find_cells_as_checked(questions: Iterable[str], cells: list[Cell]) -> dict[str, list[Cell]]:
    """The cells down to each question's last check, or to its last definition if none checks it.

    Returns
    -------
    dict
        Without those questions that are not answered there, or below which no cell gives another
        meaning to the function, or to a name that functions above use.

    Examples
    --------
    >>> texts = "d = abs", "def f(x): return d(x)", "check(f)", "d = max", "check(d)"
    >>> cells = [Cell(number, text) for number, text in enumerate(texts, 1)]
    >>> len(find_cells_as_checked(["f"], cells)["f"]), find_cells_as_checked(["f"], cells[:3])
    (3, {})
    """
    names = [list_names(cell) for cell in cells]
    found = {}
    for question in questions:
        check = re.compile(rf"^check *\( *{question}\b", re.MULTILINE)
        checked = [at for at, cell in enumerate(cells) if check.search(cell.source)]
        defined = [at for at, its in enumerate(names) if question in its.bound]
        end = max(checked or defined, default=-1) + 1
        used = {question}.union(*(its.used for its in names[:end]))
        if min(defined, default=end) < end and any(used & its.bound for its in names[end:]):
            found[question] = cells[:end]
    return found


def list_names(cell: Cell) -> CellNames:
    """The names of a cell, apart from placeholders for answers.

    A star stands for all that a module holds. Every function uses it, since such an import may hide
    Python's own names.
    """
    names = CellNames(set(), set())
    for part in parse_cell(cell.source, ""):
        if isinstance(part, Failure) or is_placeholder(part):
            continue
        names.bound.update(find_names(part))
        for node in ast.walk(part):
            if isinstance(node, ast.alias):
                names.bound.add((node.asname or node.name).partition(".")[0])
            elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Del):
                names.bound.add(node.id)
            elif isinstance(node, FUNCTIONS):
                names.used.update("*", list_used(node))
    return names


def list_used(function: ast.AST) -> set[str]:
    """The names that a function uses, without its own and without the functions in it."""
    own, used = set[str](), set[str]()
    for node in walk_within(function):
        if isinstance(node, ast.arg):
            own.add(node.arg)
        elif isinstance(node, ast.Name):
            (used if isinstance(node.ctx, ast.Load) else own).add(node.id)
    return used - own


def walk_within(function: ast.AST) -> Iterator[ast.AST]:
    """Yield the nodes of a function, without the functions in it."""
    nodes = [function]
    for node in nodes:
        yield node
        if node is function or not isinstance(node, FUNCTIONS):
            nodes.extend(ast.iter_child_nodes(node))

"""A notebook as the check of one question saw it: its cells down to that check.

Checks run where they stand, and grading calls functions after all cells have run. A cell below a
check may give another meaning to a name that the function uses, such as a helper `dist` that
another exercise needs with other arguments. The function was right for its check, and is not wrong.
"""

import ast
import re
from collections.abc import Iterator
from types import CodeType

from ..collect.notebook import Cell
from ..sandbox.cells import Compiler, Failure, find_names, is_placeholder, parse_cell


def find_cells_as_checked(name: str, cells: list[Cell]) -> list[Cell]:
    """The cells down to a question's last check, or to its last definition if none checks it.

    Returns
    -------
    list of Cell
        Empty if no cell below gives another meaning to the function, or to a name that functions
        above use.

    Examples
    --------
    >>> texts = "d = abs", "def f(x): return d(x)", "check(f)", "d = max", "check(d)"
    >>> cells = [Cell(number, text) for number, text in enumerate(texts, 1)]
    >>> len(find_cells_as_checked("f", cells)), find_cells_as_checked("f", cells[:3])
    (3, [])
    """
    check = re.compile(rf"^check *\( *{name}\b", re.MULTILINE)
    checked = [at for at, cell in enumerate(cells) if check.search(cell.source)]
    defined = [at for at, cell in enumerate(cells) if name in list_bound(cell)]
    last = max(checked or defined, default=-1)
    above, below = cells[: last + 1], cells[last + 1 :]
    used = {name, *(used for cell in above for used in list_used(cell))}
    return above if any(used.intersection(list_bound(cell)) for cell in below) else []


def list_parts(cell: Cell) -> Iterator[ast.stmt]:
    """Yield the statements of a cell that are Python, but no placeholders for answers."""
    for part in parse_cell(cell.source, ""):
        if not isinstance(part, Failure) and not is_placeholder(part):
            yield part


def list_bound(cell: Cell) -> set[str]:
    """The names to which a cell gives a meaning; a star stands for what a module holds."""
    parts = list(list_parts(cell))
    imports = (node for part in parts for node in ast.walk(part) if isinstance(node, ast.alias))
    bound = {(one.asname or one.name).partition(".")[0] for one in imports}
    return bound.union(*map(find_names, parts))


def list_used(cell: Cell) -> Iterator[str]:
    """Yield the names that a cell's functions use, other than their own, and those of attributes.

    A star is among them, since a function may use names of Python that a whole module would hide.
    """
    compiler = Compiler()
    for part in list_parts(cell):
        try:
            codes = [compiler.compile(part, "")]
        except Exception:  # such as too much for Python, or `return` outside a function
            continue
        for code in codes:
            inner = [one for one in code.co_consts if isinstance(one, CodeType)]
            codes += inner
            for function in inner:
                yield from ("*", *function.co_names)

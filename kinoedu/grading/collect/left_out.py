"""Find the notebook's commands that grading does not run, such as `!ls` and `%cd`.

They are listed on the student's page.
"""

import ast
import warnings
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from ..sandbox.stand_ins import RUNS_CELL, RUNS_LINE
from .notebook import Cell

SHELL = ("system", "getoutput")
SETTINGS = ("matplotlib", "config", "load_ext", "autoreload")  # nothing depends on them
HELP = {"pinfo": "?", "pinfo2": "??"}
MOST_LISTED = 20  # commands of a notebook
LONGEST_LISTED = 200  # characters of a command


class LeftOut(NamedTuple):
    """A command that is not run, as the notebook has it, and where."""

    cell: int
    line: int
    command: str


def find_left_out(cells: Iterable[Cell]) -> list[LeftOut]:
    """The first commands of a notebook that grading leaves out.

    >>> find_left_out([Cell(3, "x = 1\\nfiles = get_ipython().getoutput('ls')")])
    [LeftOut(cell=3, line=2, command='!ls')]
    """
    found = [
        LeftOut(cell.number, line, command[:LONGEST_LISTED])
        for cell in cells
        if "get_ipython" in cell.source
        for line, command in list_commands(cell.source)
    ]
    return found[:MOST_LISTED]


def list_commands(source: str) -> Iterator[tuple[int, str]]:
    """Yield the line and the text of each command in a cell that is not run, line by line."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            tree = ast.parse(source)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return
    calls = [node for node in ast.walk(tree) if isinstance(node, ast.Call)]
    for node in sorted(calls, key=lambda call: (call.lineno, call.col_offset)):
        if not is_of_ipython(node.func):
            continue
        texts = [one.value for one in node.args if isinstance(one, ast.Constant)]
        command = write_command(node.func.attr, list(map(str, texts)))  # type: ignore[attr-defined]
        if command:
            yield node.lineno, command


def is_of_ipython(function: ast.expr) -> bool:
    """Whether a function is a method of `get_ipython()`, as IPython writes commands."""
    return (
        isinstance(function, ast.Attribute)
        and isinstance(function.value, ast.Call)
        and isinstance(function.value.func, ast.Name)
        and function.value.func.id == "get_ipython"
    )


def write_command(method: str, texts: list[str]) -> str:
    """A command as the notebook has it; "" for one that is run, or that changes nothing."""
    if method in SHELL and texts:
        return f"!{texts[0]}"
    signs = {"run_line_magic": ("%", RUNS_LINE), "run_cell_magic": ("%%", RUNS_CELL)}
    if method not in signs or not texts or texts[0] in (*SETTINGS, *signs[method][1]):
        return ""
    if texts[0] in HELP:
        return f"{' '.join(texts[1:])}{HELP[texts[0]]}"
    return f"{signs[method][0]}{' '.join(texts[:2])}".rstrip()

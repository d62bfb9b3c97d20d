"""The rows of the table: benchmark scripts that declare how many SECONDS they take."""

import ast
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from ..errors import InvalidParameter

BENCHMARKS = Path(__file__).resolve().parent.parent.parent / "benchmarks"


class Row(NamedTuple):
    """A script: its name, what it measures, about how long it takes, and its options."""

    name: str
    about: str
    seconds: float
    options: tuple[str, ...]
    file: Path


def read_rows(folder: Path) -> list[Row]:
    """Read the scripts of a folder by name, without running them.

    Returns
    -------
    list of Row

    Raises
    ------
    InvalidParameter
        Where there are none.
    """
    rows = [row for file in sorted(folder.glob("*.py")) if (row := read_row(file)) is not None]
    if not rows:
        raise InvalidParameter(
            f"there are no benchmarks in {folder}; a student's copy of the course does not have "
            "them, the repository does"
        )
    return rows


def read_row(file: Path) -> Row | None:
    """Read a script as a row; None where it is not a benchmark.

    Raises
    ------
    InvalidParameter
        Where it is not valid Python.
    """
    try:
        script = ast.parse(file.read_text(encoding="utf-8"))
    except (SyntaxError, ValueError) as error:
        raise InvalidParameter(f"{file} is not valid Python: {error}") from None
    seconds = [
        node.value.value
        for node in script.body
        if isinstance(node, ast.Assign)
        and [ast.unparse(target) for target in node.targets] == ["SECONDS"]
        if isinstance(node.value, ast.Constant) and isinstance(node.value.value, int | float)
    ]
    if not seconds:
        return None
    mains = [
        node for node in script.body if isinstance(node, ast.FunctionDef) and node.name == "main"
    ]
    options = tuple(argument.arg for main in mains for argument in main.args.args)
    about = " ".join((ast.get_docstring(script) or "").split("\n\n")[0].split())
    return Row(file.stem, about, float(seconds[0]), options, file)


def select_rows(rows: Sequence[Row], names: Sequence[str]) -> list[Row]:
    """Rows with the given names, each once, in the given order; all rows where no name is given.

    Raises
    ------
    InvalidParameter
        Where there is no such row.
    """
    by_name = {row.name: row for row in rows}
    for name in names:
        if name not in by_name:
            raise InvalidParameter(f"there is no row {name!r}; the rows are {', '.join(by_name)}")
    return [by_name[name] for name in dict.fromkeys(names)] if names else list(rows)

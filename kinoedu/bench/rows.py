"""The rows of the speed table. A row is a script that says, beside what it measures, how many
SECONDS that takes.
"""

import ast
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from ..errors import InvalidParameter

BENCHMARKS = Path(__file__).resolve().parent.parent.parent / "benchmarks"


class Row(NamedTuple):
    """A script: its name, what it measures, about how long that takes, and which options it
    knows.
    """

    name: str
    about: str
    seconds: float
    options: tuple[str, ...]
    file: Path


def read_rows(folder: Path) -> list[Row]:
    """The rows that are in a folder, by name. Nothing of them is run. Raises InvalidParameter where
    there are none.
    """
    rows = [row for file in sorted(folder.glob("*.py")) if (row := read_row(file)) is not None]
    if not rows:
        raise InvalidParameter(
            f"there are no benchmarks in {folder}; a course for students comes without, the "
            "repository has them"
        )
    return rows


def read_row(file: Path) -> Row | None:
    """A script as a row; None where it is none. Raises InvalidParameter for one that no Python can
    read.
    """
    try:
        script = ast.parse(file.read_text(encoding="utf-8"))
    except (SyntaxError, ValueError) as error:
        raise InvalidParameter(f"{file} is no Python that can be read: {error}") from None
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


def chosen(rows: Sequence[Row], names: Sequence[str]) -> list[Row]:
    """The rows that are named, each once, in that order; all where none is. Raises
    InvalidParameter.
    """
    by_name = {row.name: row for row in rows}
    for name in names:
        if name not in by_name:
            raise InvalidParameter(f"there is no row {name!r}; the rows are {', '.join(by_name)}")
    return [by_name[name] for name in dict.fromkeys(names)] if names else list(rows)

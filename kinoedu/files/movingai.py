"""MovingAI grid maps and scenarios.

Sturtevant 2012, https://movingai.com/benchmarks/formats.html.
"""

import os
import re
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..errors import UnreadableScene
from ..support.reading import read_text
from ..worlds.terrain import Terrain, TerrainRecord
from .sizes import check_size

_PASSABLE, _BLOCKED = ".GS", "@OTW"


class Query(NamedTuple):
    """One line of a scenario: a map, a start, a goal, and the length of the shortest path.

    `start` and `goal` (2,) are centres of cells in a terrain of resolution 1 at the origin, y up.
    `length` is the shortest octile length: moves between centres, diagonal only where the two cells
    beside the diagonal are free. `columns` and `rows` are the size of the map.
    """

    map_name: str
    start: NDArray[np.float64]
    goal: NDArray[np.float64]
    length: float
    columns: int
    rows: int


def read_map(path: str | os.PathLike[str]) -> TerrainRecord:
    """Read a terrain from a MovingAI map: `.`, `G`, `S` are free, `@`, `O`, `T`, `W` are blocked.

    Returns
    -------
    TerrainRecord

    Raises
    ------
    UnreadableScene
        Where the file is missing or is not text, a character is unknown, or rows contradict the
        header.
    SceneTooLarge
        Where it has more than `MAX_CELLS` cells.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     corner = Path(folder) / "corner.map"
    ...     _ = corner.write_text("type octile\\nheight 2\\nwidth 3\\nmap\\n..@\\n@@@\\n")
    ...     read_map(corner).free.tolist()  # row 0 is the lowest
    [[False, False, False], [True, True, False]]
    """
    path = Path(path)
    parts = re.split(r"^map[ \t]*(?:\n|\Z)", read_text(path), maxsplit=1, flags=re.MULTILINE)
    if len(parts) != 2:
        raise UnreadableScene(f"{path}: expected a line that says 'map' before the rows, got none")
    height, width = _header(path, parts[0])
    rows = parts[1].rstrip().split("\n")
    _check_rows(path, rows, height, width)
    return Terrain(_free_cells(path, rows)[::-1])


def _header(path: Path, head: str) -> tuple[int, int]:
    """The height and the width in the lines before `map`, in any order."""
    entries = [line.split() for line in head.splitlines() if line.strip()]
    keys = sorted(fields[0] for fields in entries)
    if keys != ["height", "type", "width"] or any(len(fields) != 2 for fields in entries):
        raise UnreadableScene(
            f"{path}: expected lines 'type octile', 'height ...', 'width ...' before 'map', got "
            f"{head[:80]!r}"
        )
    header = dict(entries)
    if header["type"] != "octile":
        raise UnreadableScene(f"{path}: expected 'type octile', got 'type {header['type'][:40]}'")
    height, width = (_whole_number(header[key], f"{path}: {key}") for key in ("height", "width"))
    check_size(path, width, height)
    return height, width


def _check_rows(path: Path, rows: list[str], height: int, width: int) -> None:
    """Refuse rows whose number or length differs from the header."""
    if len(rows) != height:
        raise UnreadableScene(f"{path}: expected {height} rows as the header says, got {len(rows)}")
    for number, row in enumerate(rows, start=1):
        if len(row) != width:
            raise UnreadableScene(
                f"{path}: expected {width} characters in row {number}, got {len(row)}"
            )


def _free_cells(path: Path, rows: list[str]) -> NDArray[np.bool_]:
    """Whether each cell is passable, (rows, columns), top row first."""
    codes = np.frombuffer("".join(rows).encode("ascii", "replace"), np.uint8).reshape(len(rows), -1)
    unknown = ~np.isin(codes, list((_PASSABLE + _BLOCKED).encode()))
    if unknown.any():
        row, column = np.argwhere(unknown)[0]
        raise UnreadableScene(
            f"{path}: row {row + 1}, column {column + 1} of the map: expected one of "
            f"{_PASSABLE}{_BLOCKED}, got {rows[row][column]!r}"
        )
    return np.isin(codes, list(_PASSABLE.encode()))


def read_scenario(path: str | os.PathLike[str]) -> list[Query]:
    """Read the queries of a MovingAI scenario, in the order of the file.

    Returns
    -------
    list of Query

    Raises
    ------
    UnreadableScene
        Where the file is missing or is not text, or a line is not valid; the message names the
        line.
    SceneTooLarge
        Where a map has more than `MAX_CELLS` cells.
    """
    path = Path(path)
    version, *lines = read_text(path).split("\n")
    if not re.fullmatch(r"version\s+1(\.0*)?", version.strip()):
        raise UnreadableScene(f"{path}: line 1: expected 'version 1', got {version[:40]!r}")
    return [
        _query(line, f"{path}: line {n}") for n, line in enumerate(lines, start=2) if line.strip()
    ]


def _query(line: str, where: str) -> Query:
    """The query on one line, whose cells are counted from the top left corner."""
    fields = [word.strip() for word in line.strip().split("\t" if "\t" in line else None)]
    if len(fields) != 9:
        raise UnreadableScene(
            f"{where}: expected 9 columns, from bucket to optimal length, got {len(fields)}"
        )
    _, width, height, *cells = (_whole_number(word, where) for word in fields[:1] + fields[2:8])
    check_size(where, width, height)
    for x, y in (ends := (cells[:2], cells[2:])):
        if x >= width or y >= height:
            raise UnreadableScene(
                f"{where}: expected a cell of the {width} x {height} map, got ({x}, {y})"
            )
    start, goal = (np.array([x + 0.5, height - 1 - y + 0.5]) for x, y in ends)
    return Query(fields[1], start, goal, _length(fields[8], where), width, height)


def _whole_number(word: str, where: str) -> int:
    """An integer number of cells; too many digits are refused before `int` fails on them."""
    if not re.fullmatch("[0-9]{1,18}", word):
        raise UnreadableScene(f"{where}: expected a whole number, got {word[:40]!r}")
    return int(word)


def _length(word: str, where: str) -> float:
    """The length of a path: finite and not negative, in decimals."""
    if not re.fullmatch(r"[0-9]{1,18}(\.[0-9]*)?(e(\+?[0-9]{1,2}|-[0-9]{1,3}))?", word):
        raise UnreadableScene(f"{where}: expected a length, got {word[:40]!r}")
    return float(word)


def scenario_beside(path: str | os.PathLike[str]) -> Path | None:
    """The scenario of a map `X.map`: `X.map.scen`, `X.scen`, or the first `X-even-1.scen`, ....

    Returns
    -------
    Path, or None where there is no such file.
    """
    path = Path(path)
    numbered = re.compile(re.escape(path.stem) + r"-(even|random)-[0-9]+\.scen")
    try:
        beside = sorted(name for name in os.listdir(path.parent) if numbered.fullmatch(name))
    except (OSError, ValueError):  # there is no such folder
        return None
    names = [f"{path.name}.scen", f"{path.stem}.scen", *beside]
    return next(
        (path.with_name(name) for name in names if os.path.isfile(path.with_name(name))), None
    )

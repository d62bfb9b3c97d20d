"""Scenarios of MovingAI as problems by name, for experiments; and queries as a scenario."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from pathlib import Path

from ..errors import InvalidParameter, UnknownFormat, UnreadableScene
from ..geometry.checks import as_float, integer
from ..problems import Problem, ProblemRecord
from ..robots import Point
from ..robots.kinds import Robot
from ..support.reading import as_path
from ..support.text import shortened
from ..support.whole_files import written_whole
from .movingai import Query, read_map, read_scenario
from .sizes import check_size

BUCKET = 4.0  # lengths of one bucket of a scenario
LONGEST = 1e18  # `read_scenario` reads lengths with 18 digits before the point


def read_scenario_problems(
    path: str | os.PathLike[str],
    queries: Sequence[int] | None = None,
    *,
    robot: Robot | None = None,
) -> dict[str, ProblemRecord]:
    """Read the queries of a MovingAI scenario as problems by name, as an Experiment takes them.

    The map is beside the scenario, under the name that the scenario says.

    Parameters
    ----------
    queries : the numbers of queries, from 0; by default all.
    robot : by default a point.

    Returns
    -------
    dict
        Each problem under the scenario's name and the number, such as "maze-even-1 3".

    Raises
    ------
    UnreadableScene
        Where a file is missing or damaged, or the map has another size.
    InvalidParameter
        Where `queries` are not numbers of queries, each once.
    InvalidStart, InvalidGoal
        Where the robot is not free.
    """
    file = as_path(path)
    if file.suffix.lower() != ".scen":
        raise UnknownFormat(f"{file}: a scenario ends in .scen")
    found = read_scenario(file)
    numbers = as_numbers(queries, len(found), file)
    maps = {name: read_map(map_beside(file, name)) for name in {found[k].map_name for k in numbers}}
    problems = {}
    for k in numbers:
        query = found[k]
        world = maps[query.map_name]
        if world.free.shape != (query.rows, query.columns):
            raise UnreadableScene(
                f"{file}: query {k} is for a map of {query.columns} x {query.rows} cells, "
                f"{query.map_name} has {world.free.shape[1]} x {world.free.shape[0]}"
            )
        ends = query.start, query.goal
        problems[f"{file.stem} {k}"] = Problem(Point() if robot is None else robot, world, *ends)
    return problems


def as_numbers(queries: object, count: int, file: Path) -> list[int]:
    """The numbers of queries, checked."""
    if queries is None:
        return list(range(count))
    if not isinstance(queries, Iterable) or isinstance(queries, str):
        raise InvalidParameter(f"queries must be a list of numbers, got {shortened(queries)}")
    numbers = [integer(k, f"a query of {file}", least=0, most=count - 1) for k in queries]
    if not numbers or len(set(numbers)) < len(numbers):
        raise InvalidParameter(f"queries must be at least one, each once, got {shortened(numbers)}")
    return numbers


def map_beside(file: Path, name: str) -> Path:
    """The map of a scenario: its own name says it, perhaps with folders that are not here."""
    own = name.replace("\\", "/").rpartition("/")[2]
    if own in ("", ".", ".."):
        raise UnreadableScene(f"{file}: expected the name of a map, got {shortened(name)}")
    return file.with_name(own)


def write_scenario(queries: Sequence[Query], path: str | os.PathLike[str]) -> None:
    """Write queries as a scenario of MovingAI, from which `read_scenario` reads the same.

    Raises
    ------
    UnknownFormat
        Where the file name extension is not .scen.
    InvalidParameter
        Where `queries` is no list, a query is none, a length is not a number from 0 to less than
        1e18, or an end is not the centre of a cell.
    SceneTooLarge
        Where a map has more than `MAX_CELLS` cells.
    OSError
    """
    file = Path(path)
    if file.suffix.lower() != ".scen":
        raise UnknownFormat(f"{file}: a scenario ends in .scen")
    if not isinstance(queries, Iterable):
        raise InvalidParameter(f"queries must be a list of Query records, got {shortened(queries)}")
    lines = [line_of(query) for query in queries]
    with written_whole(file) as part:
        part.write_text("\n".join(["version 1", *lines, ""]), encoding="utf-8")


def line_of(query: Query) -> str:
    """A query as a line; cells count from the top left corner."""
    if not isinstance(query, Query):
        raise InvalidParameter(f"a scenario holds Query records, got {shortened(query)}")
    length = as_float(query.length)
    if not 0.0 <= length < LONGEST:
        raise InvalidParameter(
            f"a length must be zero or more, and less than {LONGEST:g}, got "
            f"{shortened(query.length)}"
        )
    name = query.map_name
    if not isinstance(name, str) or not name.isprintable() or name != name.strip():
        raise InvalidParameter(
            f"a map's name is text on one line, without blanks at its ends, got {shortened(name)}"
        )
    columns, rows = (integer(n, "a map's side", least=1) for n in (query.columns, query.rows))
    check_size(name, columns, rows)
    cells = []
    for q in (query.start, query.goal):
        column, row = float(q[0]) - 0.5, rows - 0.5 - float(q[1])
        inside = 0 <= column < columns and 0 <= row < rows
        if not inside or column != int(column) or row != int(row):
            raise InvalidParameter(f"{tuple(map(float, q))} is not the centre of a cell of the map")
        cells += [int(column), int(row)]
    fields = int(length // BUCKET), name, columns, rows, *cells
    rounded = f"{length:.8f}"
    exact = rounded if float(rounded) == length else repr(length)
    return "\t".join([*map(str, fields), exact])

"""The results of an experiment as a tidy table: a row for each run, a column for each quantity."""

import csv
import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple, overload

import numpy as np

from ..errors import InvalidParameter, UnknownFormat
from ..geometry.checks import Array
from ..support.text import shortened
from ..support.whole_files import written_whole
from .cells import FOUND, NOT_RUN, OUT_OF_TIME, WRONG


class Row(NamedTuple):
    """One run.

    Attributes
    ----------
    problem, planner, tuning : names; `tuning` distinguishes planners of the same name, such as
        "max_nodes=500", and is often empty.
    seed : None for a deterministic planner.
    found, status : whether there is a correct path; "found", "no path", "wrong" (a path that is not
        free, of a planner of yours), "out of time" or "not run".
    cost : length of the path, infinite without a path.
    seconds : median time of the repeated runs.
    motions, places : number of calls of `is_free_path` and `is_free`.
    nodes, iterations : None where the planner has none.
    reason : why there is no path.
    path : a digest of the path, equal for equal paths.
    """

    problem: str
    planner: str
    tuning: str
    seed: int | None
    found: bool
    status: str
    cost: float
    seconds: float
    motions: int | None
    places: int | None
    nodes: int | None
    iterations: int | None
    reason: str
    path: str

    @property
    def label(self) -> str:
        """Name of the planner with its tuning."""
        return f"{self.planner}, {self.tuning}" if self.tuning else self.planner


@dataclass(frozen=True)
class Table:
    """Rows in the experiment's order. `pandas.DataFrame(table)` makes a frame of it."""

    rows: tuple[Row, ...]

    def __iter__(self) -> Iterator[Row]:
        return iter(self.rows)

    def __len__(self) -> int:
        return len(self.rows)

    @overload
    def __getitem__(self, i: int) -> Row: ...
    @overload
    def __getitem__(self, i: slice) -> tuple[Row, ...]: ...
    def __getitem__(self, i: int | slice) -> Row | tuple[Row, ...]:
        return self.rows[i]

    def __repr__(self) -> str:
        counts = {
            status: sum(row.status == status for row in self)
            for status in (FOUND, WRONG, OUT_OF_TIME, NOT_RUN)
        }
        return (
            f"<Table: {len(self)} runs; "
            f"{', '.join(f'{n} {status}' for status, n in counts.items() if n or status == FOUND)}>"
        )

    def column(self, name: str) -> list[Any]:
        """Values of one column. Raises InvalidParameter where it does not exist."""
        if name not in Row._fields:
            raise InvalidParameter(
                f"a table has the columns {', '.join(Row._fields)}, got {shortened(name)}"
            )
        return [getattr(row, name) for row in self]

    def problems(self) -> list[str]:
        """Names of the problems, in order."""
        return list(dict.fromkeys(row.problem for row in self))

    def of(self, problem: str) -> "Table":
        """Rows of one problem. Raises InvalidParameter where there are none."""
        if problem not in self.problems():
            raise InvalidParameter(
                f"problem must be one of {', '.join(map(repr, self.problems()))}, got "
                f"{shortened(problem)}"
            )
        return Table(tuple(row for row in self if row.problem == problem))

    def values(self, column: str) -> dict[str, Array]:
        """Values of a numeric column for each planner with its tuning, for figures.

        Cells that were not run are left out. A run without a path has infinite cost and seconds,
        since it never finished. A quantity that the planner does not count is infinite too.

        Raises
        ------
        InvalidParameter
            Where there is no such column, or it has words.
        """
        if any(isinstance(value, str) for value in self.column(column)):
            raise InvalidParameter(
                f"column must be one of numbers, such as 'cost' or 'motions', got {column!r}"
            )
        groups: dict[str, list[float]] = {}
        for row in self:
            if row.status != NOT_RUN:
                value = getattr(row, column)
                never = column in ("cost", "seconds") and not row.found
                groups.setdefault(row.label, []).append(
                    np.inf if never or value is None else float(value)
                )
        return {label: np.array(values) for label, values in groups.items()}

    def growth(self) -> dict[str, tuple[Array, Array]]:
        """Costs over nodes for each planner of several tunings, from few nodes to many.

        A planner is left out where no tuning found a path with at least half of the seeds: then no
        median can be drawn. A run that was stopped has infinite cost, and does not count for the
        median of nodes.

        Returns
        -------
        dict
            For each planner the medians of nodes (m,), and the costs (m, seeds).
        """
        grown: dict[str, dict[str, list[Row]]] = {}
        for row in self:
            if row.status != NOT_RUN:
                grown.setdefault(row.planner, {}).setdefault(row.tuning, []).append(row)
        curves = {}
        for planner, tunings in grown.items():
            counts = [
                [n for row in rows if (n := row.nodes) is not None] for rows in tunings.values()
            ]
            columns = sorted(
                (float(np.median(nodes)), [row.cost for row in rows])
                for nodes, rows in zip(counts, tunings.values())
                if nodes
            )
            complete = len(columns) > 1 and len({len(costs) for _, costs in columns}) == 1
            if complete and any(2 * np.isfinite(costs).sum() >= len(costs) for _, costs in columns):
                curves[planner] = (
                    np.array([n for n, _ in columns]),
                    np.array([costs for _, costs in columns]),
                )
        return curves

    def write(self, path: str | os.PathLike[str]) -> None:
        """Write the table atomically as .csv, or as .parquet where pyarrow is installed.

        Raises
        ------
        UnknownFormat
            Where the name has another ending.
        OSError
        """
        file = Path(path)
        writers = {".csv": self._write_csv, ".parquet": self._write_parquet}
        if file.suffix.lower() not in writers:
            raise UnknownFormat(f"{file}: a table ends in .csv or .parquet")
        with written_whole(file) as part:
            writers[file.suffix.lower()](part)

    def _write_csv(self, file: Path) -> None:
        with file.open("w", encoding="utf-8", newline="") as stream:
            writer = csv.writer(stream)
            writer.writerow(Row._fields)
            writer.writerows(self)

    def _write_parquet(self, file: Path) -> None:
        try:
            import pyarrow
            from pyarrow import parquet
        except ImportError:
            raise InvalidParameter(
                "a .parquet file needs the package pyarrow: pip install pyarrow; or choose a name "
                "that ends in .csv"
            ) from None
        types = {
            "str": pyarrow.string(),
            "float": pyarrow.float64(),
            "bool": pyarrow.bool_(),
            "int | None": pyarrow.int64(),
        }
        named = {
            name: types[getattr(kind, "__name__", str(kind))]
            for name, kind in Row.__annotations__.items()
        }
        columns = {name: pyarrow.array(self.column(name), kind) for name, kind in named.items()}
        parquet.write_table(pyarrow.table(columns), file)

"""Ratios of times as a tidy table, with a row for each contestant of each comparison."""

import csv
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

from ..errors import UnreadableScene

HELD, MISSED, NO_GOAL = "holds", "missed", ""


class Ratio(NamedTuple):
    """A contestant in a comparison: its median time, and its ratio to kinoedu.

    Attributes
    ----------
    ratio, low, high : the median of the ratio over the rounds, and the middle half; None for
        kinoedu itself.
    goal : what must hold, such as "<= 1.2" for kinoedu's time divided by a ruler's, or ">= 4" for a
        peer's time divided by kinoedu's.
    """

    row: str
    title: str
    contestant: str
    median_ms: float
    ratio: float | None
    low: float | None
    high: float | None
    goal: str
    holds: str
    rounds: int


def append_ratios(file: Path, ratios: Iterable[Ratio]) -> None:
    """Append rows to a table, with a header where the file is new."""
    is_new = not file.exists()
    with file.open("a", newline="", encoding="utf-8") as table:
        lines = csv.writer(table)
        lines.writerows([Ratio._fields] if is_new else [])
        lines.writerows(
            [f"{cell:.6g}" if isinstance(cell, float) else cell for cell in ratio]
            for ratio in ratios
        )


def read_ratios(file: Path) -> list[Ratio]:
    """Read a table that `append_ratios` has written; [] where there is no file.

    Returns
    -------
    list of Ratio

    Raises
    ------
    UnreadableScene
        Where the header is not that of a table of ratios.
    """
    if not file.exists():
        return []
    with file.open(newline="", encoding="utf-8") as table:
        heading, *lines = [*csv.reader(table)] or [[]]
    if tuple(heading) != Ratio._fields:
        raise UnreadableScene(
            f"{file} is not a table of ratios: its header must be {','.join(Ratio._fields)}"
        )
    return [ratio_of(line) for line in lines]


def ratio_of(cells: list[str]) -> Ratio:
    """Ratio from a row of the table."""
    row, title, contestant, median, *middle, goal, holds, rounds = cells
    ratio, low, high = (float(cell) if cell else None for cell in middle)
    return Ratio(row, title, contestant, float(median), ratio, low, high, goal, holds, int(rounds))

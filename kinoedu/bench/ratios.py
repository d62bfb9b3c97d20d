"""Ratios of times as a tidy table: a line for each contestant of each comparison."""

import csv
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

from ..errors import UnreadableScene

HELD, MISSED, NO_GOAL = "holds", "missed", ""


class Ratio(NamedTuple):
    """A contestant in a comparison: its median time, and the ratio with the middle half of the
    rounds; blank for kinoedu itself.

    `goal` is what is to hold, such as "<= 1.2": our time by a ruler's; or ">= 4": a peer's time by
    ours.
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
    """Add lines to a table, with its heading where it is new."""
    is_new = not file.exists()
    with file.open("a", newline="", encoding="utf-8") as table:
        lines = csv.writer(table)
        lines.writerows([Ratio._fields] if is_new else [])
        lines.writerows(
            [f"{cell:.6g}" if isinstance(cell, float) else cell for cell in ratio]
            for ratio in ratios
        )


def read_ratios(file: Path) -> list[Ratio]:
    """A table as `append_ratios` wrote it; empty where there is none. Raises UnreadableScene."""
    if not file.exists():
        return []
    with file.open(newline="", encoding="utf-8") as table:
        heading, *lines = [*csv.reader(table)] or [[]]
    if tuple(heading) != Ratio._fields:
        raise UnreadableScene(
            f"{file} is no table of ratios: its heading should be {','.join(Ratio._fields)}"
        )
    return [ratio_of(line) for line in lines]


def ratio_of(cells: list[str]) -> Ratio:
    """A line of the table."""
    row, title, contestant, median, *middle, goal, holds, rounds = cells
    ratio, low, high = (float(cell) if cell else None for cell in middle)
    return Ratio(row, title, contestant, float(median), ratio, low, high, goal, holds, int(rounds))

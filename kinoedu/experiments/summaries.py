"""Many runs in a line for each planner on each problem: how often a path was found, how long it is,
what it took.
"""

import math
from typing import NamedTuple

import numpy as np

from ..chances import wilson
from .cells import NOT_RUN
from .table import Row, Table


class Spread(NamedTuple):
    """A median between the quartiles; NaN where there is nothing to take them of."""

    low: float
    median: float
    high: float


class Summary(NamedTuple):
    """The runs of one planner on one problem.

    runs, not_run : how many are judged, and how many could not be run; found : how many have a
        path; share : found / runs between the ends of its 95 % Wilson interval. cost, seconds : of
        those found. motions : of all judged.
    """

    problem: str
    planner: str
    tuning: str
    runs: int
    not_run: int
    found: int
    share: Spread
    cost: Spread
    seconds: Spread
    motions: Spread


def summary(table: Table) -> list[Summary]:
    """A line for each planner on each problem, in the table's order."""
    groups: dict[tuple[str, str, str], list[Row]] = {}
    for row in table:
        groups.setdefault((row.problem, row.planner, row.tuning), []).append(row)
    return [summed_up(*names, rows) for names, rows in groups.items()]


def summed_up(problem: str, planner: str, tuning: str, rows: list[Row]) -> Summary:
    """One line."""
    judged = [row for row in rows if row.status != NOT_RUN]
    found = [row for row in judged if row.found]
    share = share_of(len(found), len(judged))
    motions = [float(row.motions) for row in judged if row.motions is not None]
    spreads = (
        share,
        spread([row.cost for row in found]),
        spread([row.seconds for row in found]),
        spread(motions),
    )
    return Summary(
        problem, planner, tuning, len(judged), len(rows) - len(judged), len(found), *spreads
    )


def spread(values: list[float]) -> Spread:
    """Quartiles and median."""
    return (
        Spread(*np.quantile(values, (0.25, 0.5, 0.75)).tolist())
        if values
        else Spread(math.nan, math.nan, math.nan)
    )


def share_of(found: int, runs: int) -> Spread:
    """The share of runs that found a path between the ends of its interval; NaN between 0 and 1
    without runs.

    >>> [round(end, 3) for end in share_of(9, 10)]
    [0.596, 0.9, 0.982]
    """
    low, high = wilson(found, runs)
    return Spread(float(low), found / runs if runs else math.nan, float(high))


HEAD = (
    "problem",
    "planner",
    "found",
    "95 %",
    "length",
    "quartiles",
    "motions",
    "seconds",
    "not run",
)


def as_text(summaries: list[Summary]) -> str:
    """Summaries as a table of plain text; medians, with the quartiles of the lengths."""
    lines = [HEAD, *map(line, summaries)]
    widths = [max(len(cells[i]) for cells in lines) for i in range(len(HEAD))]
    aligned = [
        "  ".join(
            cell.ljust(w) if i < 2 else cell.rjust(w) for i, (cell, w) in enumerate(zip(c, widths))
        )
        for c in lines
    ]
    return "\n".join(text.rstrip() for text in aligned)


def line(of: Summary) -> tuple[str, ...]:
    """The cells of one summary's line."""
    return (
        of.problem,
        f"{of.planner}, {of.tuning}" if of.tuning else of.planner,
        f"{of.found}/{of.runs}",
        f"{of.share.low:.0%} to {of.share.high:.0%}",
        number(of.cost.median),
        f"{number(of.cost.low)} to {number(of.cost.high)}" if of.found else "-",
        number(of.motions.median),
        number(of.seconds.median, ".3g"),
        str(of.not_run or "-"),
    )


def number(value: float, form: str = ".5g") -> str:
    """A number as a table shows it."""
    return (
        "-" if math.isnan(value) else f"{value:,.0f}" if abs(value) >= 10_000 else f"{value:{form}}"
    )

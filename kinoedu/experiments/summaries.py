"""Summaries of many runs: one line for each planner on each problem."""

import math
from typing import NamedTuple

import numpy as np

from ..chances import wilson_interval
from .cells import NOT_RUN
from .table import Row, Table


class Spread(NamedTuple):
    """A median between the quartiles; NaN where there are no values."""

    low: float
    median: float
    high: float


class Summary(NamedTuple):
    """The runs of one planner on one problem.

    Attributes
    ----------
    runs, not_run : number of runs that are judged, and of those that could not be run.
    found : number of runs that found a path.
    share : found / runs, between the ends of its 95 % Wilson interval.
    cost, seconds : spread over the runs that found a path.
    motions : spread over all judged runs.
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
    """Summarise a table: one line for each planner on each problem, in the table's order.

    Returns
    -------
    list of Summary
    """
    groups: dict[tuple[str, str, str], list[Row]] = {}
    for row in table:
        groups.setdefault((row.problem, row.planner, row.tuning), []).append(row)
    return [summarise_group(*names, rows) for names, rows in groups.items()]


def summarise_group(problem: str, planner: str, tuning: str, rows: list[Row]) -> Summary:
    """Summary of one planner on one problem."""
    judged = [row for row in rows if row.status != NOT_RUN]
    found = [row for row in judged if row.found]
    share = success_fraction(len(found), len(judged))
    motions = [float(row.motions) for row in judged if row.motions is not None]
    spreads = (
        share,
        quartiles([row.cost for row in found]),
        quartiles([row.seconds for row in found]),
        quartiles(motions),
    )
    return Summary(
        problem, planner, tuning, len(judged), len(rows) - len(judged), len(found), *spreads
    )


def quartiles(values: list[float]) -> Spread:
    """Quartiles and median."""
    if not values:
        return Spread(math.nan, math.nan, math.nan)
    return Spread(*np.quantile(values, (0.25, 0.5, 0.75)).tolist())


def success_fraction(found: int, runs: int) -> Spread:
    """Fraction of runs that found a path, between the ends of its 95 % Wilson interval.

    Without runs it is NaN between 0 and 1.

    >>> [round(end, 3) for end in success_fraction(9, 10)]
    [0.596, 0.9, 0.982]
    """
    low, high = wilson_interval(found, runs)
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
    """Format summaries as a plain-text table of medians, with the quartiles of the lengths."""
    lines = [HEAD, *map(format_line, summaries)]
    widths = [max(len(cells[i]) for cells in lines) for i in range(len(HEAD))]
    aligned = [
        "  ".join(
            cell.ljust(w) if i < 2 else cell.rjust(w) for i, (cell, w) in enumerate(zip(c, widths))
        )
        for c in lines
    ]
    return "\n".join(text.rstrip() for text in aligned)


def format_line(of: Summary) -> tuple[str, ...]:
    """Cells of a summary's line."""
    return (
        of.problem,
        f"{of.planner}, {of.tuning}" if of.tuning else of.planner,
        f"{of.found}/{of.runs}",
        f"{of.share.low:.0%} to {of.share.high:.0%}",
        format_number(of.cost.median),
        f"{format_number(of.cost.low)} to {format_number(of.cost.high)}" if of.found else "-",
        format_number(of.motions.median),
        format_number(of.seconds.median, ".3g"),
        str(of.not_run or "-"),
    )


def format_number(value: float, form: str = ".5g") -> str:
    """Format a number for the table."""
    if math.isnan(value):
        return "-"
    return f"{value:,.0f}" if abs(value) >= 10_000 else f"{value:{form}}"

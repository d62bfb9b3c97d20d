"""The table of all results as Markdown."""

from collections.abc import Iterable, Sequence
from itertools import groupby

from ..support.progress import format_duration
from .ratios import HELD, MISSED, Ratio
from .running import Outcome

HEADING = "| contestant | median, ms | ratio (middle half) | to hold | |\n|---|---:|---:|---:|---|"
ROWS = "| row | | clock | processor | most memory | left out |\n|---|---|---:|---:|---:|---|"
EXPLANATION = """\
If the goal is an upper bound (`<=`), the ratio is kinoedu's time divided by the other's, and less
is better. Otherwise it is the other's time divided by kinoedu's, and more is better. The ratio is
the median over the rounds, with the middle half of them in brackets."""


def as_markdown(ratios: Sequence[Ratio], outcomes: Sequence[Outcome], around: Sequence[str]) -> str:
    """All ratios, and how each row ended, as a Markdown page.

    Parameters
    ----------
    around : lines that state what the numbers depend on.

    Returns
    -------
    str
    """
    blocks = [
        "# Ratios, side by side",
        "\n".join(f"- {line}" for line in around),
        f"{totals(ratios, outcomes)}\n{EXPLANATION}",
    ]
    for title, compared in groupby(ratios, key=lambda ratio: ratio.title):
        blocks.append(f"### {title}\n\n{as_table(compared)}")
    blocks.append("\n".join([ROWS, *map(outcome_line, outcomes)]))
    return "\n\n".join(blocks) + "\n"


def totals(ratios: Sequence[Ratio], outcomes: Sequence[Outcome]) -> str:
    """One line with the numbers of goals held and missed, and the rows that did not finish.

    >>> totals([Ratio("rrt", "RRT", "C ruler", 1.0, 1.1, 1.0, 1.2, "<= 1.3", "holds", 5)], [])
    '1 goal held, 0 missed.'
    """
    held, missed = (sum(ratio.holds == verdict for ratio in ratios) for verdict in (HELD, MISSED))
    parts = [f"{held} {'goal' if held == 1 else 'goals'} held, {missed} missed."]
    for ended in ("failed", "skipped"):
        named = [f"{one.row.name} ({one.reason})" for one in outcomes if one.ended == ended]
        parts += [f"{ended.capitalize()}: {', '.join(named)}."] if named else []
    return " ".join(parts)


def as_table(compared: Iterable[Ratio]) -> str:
    """Markdown table of a comparison, with a line for each contestant.

    >>> ratio = Ratio("rrt", "RRT", "C ruler", 1.0, 1.1, 1.0, 1.2, "<= 1.3", "holds", 5)
    >>> print(as_table([ratio]).splitlines()[-1])
    | C ruler | 1 | 1.1 (1 to 1.2) | <= 1.3 | holds |
    """
    return "\n".join([HEADING, *map(ratio_line, compared)])


def ratio_line(ratio: Ratio) -> str:
    """Line of a contestant."""
    middle = (
        "" if ratio.ratio is None else f"{ratio.ratio:.3g} ({ratio.low:.3g} to {ratio.high:.3g})"
    )
    verdict = "**missed**" if ratio.holds == MISSED else ratio.holds
    return (
        f"| {ratio.contestant.replace('|', '/')} | {ratio.median_ms:.3g} | {middle} | "
        f"{ratio.goal} | {verdict} |"
    )


def outcome_line(outcome: Outcome) -> str:
    """Line of a benchmark row; its output is in a file of its own."""
    name = outcome.row.name
    processor = "" if outcome.processor is None else format_duration(outcome.processor)
    memory = "" if outcome.memory is None else f"{outcome.memory / 1e6:.0f} MB"
    ended = f"{outcome.ended}: {outcome.reason}" if outcome.reason else outcome.ended
    cells = [
        f"[{name}]({name}.md)",
        ended,
        format_duration(outcome.seconds),
        processor,
        memory,
        "; ".join(outcome.left_out),
    ]
    return f"| {' | '.join(cell.replace('|', '/') for cell in cells)} |"

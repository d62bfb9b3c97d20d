"""The table of the whole, for people."""

from collections.abc import Iterable, Sequence
from itertools import groupby

from ..support.progress import duration
from .ratios import HELD, MISSED, Ratio
from .running import Outcome

HEADING = "| contestant | median, ms | ratio (middle half) | to hold | |\n|---|---:|---:|---:|---|"
ROWS = "| row | | clock | processor | most memory | left out |\n|---|---|---:|---:|---:|---|"
WHAT = """\
Where something is to hold at most (`<=`) the ratio is kinoedu's time by the other's, the less the better; otherwise the other's by
kinoedu's, the more the better. The median over the rounds, with the middle half of them in brackets."""


def as_markdown(ratios: Sequence[Ratio], outcomes: Sequence[Outcome], around: Sequence[str]) -> str:
    """All ratios, how each row ended and what it took, and `around`: lines that say what the
    numbers depend on.
    """
    blocks = [
        "# Ratios, side by side",
        "\n".join(f"- {line}" for line in around),
        f"{totals(ratios, outcomes)}\n{WHAT}",
    ]
    for title, compared in groupby(ratios, key=lambda ratio: ratio.title):
        blocks.append(f"### {title}\n\n{as_table(compared)}")
    blocks.append("\n".join([ROWS, *map(ending_of, outcomes)]))
    return "\n\n".join(blocks) + "\n"


def totals(ratios: Sequence[Ratio], outcomes: Sequence[Outcome]) -> str:
    """In a line: how many goals are held and missed, and which rows did not come to an end.

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
    """A comparison: a line for each contestant.

    >>> print(as_table([Ratio("rrt", "RRT", "C ruler", 1.0, 1.1, 1.0, 1.2, "<= 1.3", "holds", 5)]).splitlines()[-1])
    | C ruler | 1 | 1.1 (1 to 1.2) | <= 1.3 | holds |
    """
    return "\n".join([HEADING, *map(line_of, compared)])


def line_of(ratio: Ratio) -> str:
    """A line of it."""
    middle = (
        "" if ratio.ratio is None else f"{ratio.ratio:.3g} ({ratio.low:.3g} to {ratio.high:.3g})"
    )
    verdict = "**missed**" if ratio.holds == MISSED else ratio.holds
    return (
        f"| {ratio.contestant.replace('|', '/')} | {ratio.median_ms:.3g} | {middle} | "
        f"{ratio.goal} | {verdict} |"
    )


def ending_of(outcome: Outcome) -> str:
    """A line for a row; what it printed stands in a file beside."""
    name = outcome.row.name
    processor = "" if outcome.processor is None else duration(outcome.processor)
    memory = "" if outcome.memory is None else f"{outcome.memory / 1e6:.0f} MB"
    ended = f"{outcome.ended}: {outcome.reason}" if outcome.reason else outcome.ended
    cells = [
        f"[{name}]({name}.md)",
        ended,
        duration(outcome.seconds),
        processor,
        memory,
        "; ".join(outcome.left_out),
    ]
    return f"| {' | '.join(cell.replace('|', '/') for cell in cells)} |"

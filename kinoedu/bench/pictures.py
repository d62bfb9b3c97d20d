"""A picture of the ratios: against libraries above, against a ruler below."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from .ratios import HELD, NO_GOAL, Ratio, read_ratios

PICTURES = ("ratios.png", "ratios.svg")
TITLE = "Speed of kinoedu compared with others"
BESIDE = "the other's time divided by kinoedu's: more is better"
BY_RULER = "kinoedu's time divided by the other's: less is better"


def draw_folder(folder: Path) -> None:
    """Draw the ratios.csv of a folder into pictures beside it; do nothing where there is none.

    Raises
    ------
    OSError
    """
    ratios = [ratio for ratio in read_ratios(folder / "ratios.csv") if ratio.ratio is not None]
    panels: dict[str, Sequence[Any]] = {
        label: [as_mark(ratio) for ratio in ratios if ratio.goal.startswith("<") == by_ruler]
        for label, by_ruler in ((BESIDE, False), (BY_RULER, True))
    }
    panels = {label: marks for label, marks in panels.items() if marks}
    if panels:
        from ..figures.ratios import save_ratios  # only pictures need matplotlib

        for name in PICTURES:
            save_ratios(panels, folder / name, title=TITLE)


def as_mark(ratio: Ratio) -> Any:
    """A ratio as a mark of the figure."""
    from ..figures.ratios import Mark

    goal = float(ratio.goal.split()[-1]) if ratio.goal else None
    holds = None if ratio.holds == NO_GOAL else ratio.holds == HELD
    return Mark(ratio.title, ratio.contestant, ratio.low, ratio.ratio, ratio.high, goal, holds)  # type: ignore[arg-type]

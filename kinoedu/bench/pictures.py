"""The ratios as a picture, those beside libraries above those beside a ruler."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from .ratios import HELD, NO_GOAL, Ratio, read_ratios

PICTURES = ("ratios.png", "ratios.svg")
TITLE = "How fast kinoedu is, side by side"
BESIDE = "the other's time by kinoedu's: the more, the better"
BY_RULER = "kinoedu's time by the other's: the less, the better"


def draw_folder(folder: Path) -> None:
    """Draw a folder's ratios.csv into pictures beside it; nothing where it has none. Raises
    OSError.
    """
    ratios = [ratio for ratio in read_ratios(folder / "ratios.csv") if ratio.ratio is not None]
    panels: dict[str, Sequence[Any]] = {
        label: [mark_of(ratio) for ratio in ratios if ratio.goal.startswith("<") == by_ruler]
        for label, by_ruler in ((BESIDE, False), (BY_RULER, True))
    }
    panels = {label: marks for label, marks in panels.items() if marks}
    if panels:
        from ..figures.ratios import save_ratios  # matplotlib is for those who want pictures

        for name in PICTURES:
            save_ratios(panels, folder / name, title=TITLE)


def mark_of(ratio: Ratio) -> Any:
    """A ratio as figures know it."""
    from ..figures.ratios import Mark

    goal = float(ratio.goal.split()[-1]) if ratio.goal else None
    holds = None if ratio.holds == NO_GOAL else ratio.holds == HELD
    return Mark(ratio.title, ratio.contestant, ratio.low, ratio.ratio, ratio.high, goal, holds)  # type: ignore[arg-type]

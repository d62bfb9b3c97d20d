"""The exercise "break it" of lesson 6: a corridor that a sequence of grids never finds."""

from collections.abc import Iterator

import numpy as np

from ....geometry.checks import Array
from ....messages import get_message
from ....sampling import sukharev_grid
from ...exercise import RIGHT, Axes, Case, Exercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Numbers, Record, Value
from .pictures import draw_corridor

WIDE = 0.031  # the widest hidden corridor is 1/32 = 0.03125 wide
SLACK = 1e-9


class ExposeGrids(Exercise):
    """Give a corridor across the unit square that `finds_corridor` does not find.

    It must be as wide as possible.
    """

    name = "exposing_corridor"
    lesson = "06_sampling"
    kinds = ("valid", "exposes", "widest")
    given = Record()
    answer = Numbers((4,))

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield the same question three times; each time the answer must fulfil more."""
        return (Case(kind, {}) for kind in self.kinds)

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge that it is a corridor, that no grid finds it, and its width."""
        rule = find_corridor_fault(value)
        if not rule and case.kind != "valid" and finds_corridor(value):
            rule = "exposes"
        if not rule and case.kind == "widest" and measure_width(value) < WIDE - SLACK:
            rule = "widest"
        return Verdict(0.0, rule, self.describe_expected(case)) if rule else RIGHT

    def describe_expected(self, case: Case) -> str:
        """Describe what the answer to a case must be."""
        return get_message(f"exposing_corridor.wanted.{case.kind}")

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the points of all grids, the corridor, and the points inside it."""
        draw_corridor(outcome.value if isinstance(outcome, Answer) else None, ax)
        from ....figures import plane

        plane.title(self.message("picture"), ax)


def finds_corridor(corridor: Array) -> bool:
    """Whether some grid has a point inside an open rectangle (x0, y0, x1, y1).

    The program returns False for corridors that are wide open. Which?
    """
    x0, y0, x1, y1 = corridor
    for k in (1, 2, 4, 8, 16):  # finer and finer grids, 341 points in all: what could they miss?
        x, y = sukharev_grid(k * k).T
        if ((x0 < x) & (x < x1) & (y0 < y) & (y < y1)).any():
            return True
    return False


def find_corridor_fault(corridor: Array) -> str:
    """Return the rule that a corridor across the unit square breaks, or ""."""
    x0, y0, x1, y1 = corridor
    if not (-SLACK <= x0 < x1 <= 1.0 + SLACK and -SLACK <= y0 < y1 <= 1.0 + SLACK):
        return "valid"
    return "" if max(x1 - x0, y1 - y0) >= 1.0 - SLACK else "across"


def measure_width(corridor: Array) -> float:
    """Return the width of a corridor."""
    x0, y0, x1, y1 = corridor
    return float(min(x1 - x0, y1 - y0))

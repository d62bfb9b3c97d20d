"""Flowcharts: actions in boxes, questions in diamonds, arrows between them."""

from typing import NamedTuple

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.patches import FancyBboxPatch, Polygon

from . import palette
from .palette import Style

WIDE, HIGH = 3.4, 0.9  # the size of a box; columns are 4.4 apart, rows 1.6


class Step(NamedTuple):
    """One element of a flowchart: its kind "do", "ask" or "end", its text, column, and row."""

    kind: str
    text: str
    column: float
    row: float

    @property
    def middle(self) -> tuple[float, float]:
        """Its centre."""
        return 4.4 * self.column, -1.6 * self.row

    @property
    def half(self) -> tuple[float, float]:
        """Half of its width and height."""
        return (WIDE / 2 + 0.35, 0.68) if self.kind == "ask" else (WIDE / 2, HIGH / 2)


def draw_flowchart(
    steps: dict[str, Step], arrows: list[tuple[str, str, str]], ax: Axes
) -> list[Artist]:
    """Draw steps by name, and arrows (from, to, text) between them.

    Arrows run across, straight down, or back up.
    """
    artists: list[Artist] = []
    for step in steps.values():
        artists += draw_step(step, ax)
    aside = 2.4
    for begin, end, text in sorted(arrows, key=lambda arrow: rows_up(steps, arrow)):
        artists += draw_arrow(steps[begin], steps[end], text, ax, aside)
        aside += 0.35 if rows_up(steps, (begin, end, text)) > 0 else 0.0
    xs, ys = zip(*(step.middle for step in steps.values()))
    ax.set(
        xlim=(min(xs) - max(2.5, aside - 0.3), max(xs) + 2.2),
        ylim=(min(ys) - 0.8, max(ys) + 0.8),
        aspect="equal",
    )
    ax.axis("off")
    return artists


def draw_step(step: Step, ax: Axes) -> list[Artist]:
    """Draw a box, a diamond, or a box with round ends."""
    (x, y), (w, h) = step.middle, step.half
    if step.kind == "ask":
        corners = [(x - w, y), (x, y - h), (x + w, y), (x, y + h)]
        look: Style = {"facecolor": palette.CELL, "edgecolor": palette.TREE, "linewidth": 1.8}
        shape: Artist = ax.add_patch(Polygon(corners, **look))
    else:
        style = "round,pad=0,rounding_size=0.44" if step.kind == "end" else "square,pad=0"
        colour = palette.INK if step.kind == "end" else palette.OBSTACLE
        look = {"facecolor": "white", "edgecolor": colour, "linewidth": 1.8}
        box = FancyBboxPatch((x - w, y - h), WIDE, HIGH, boxstyle=style, **look)
        shape = ax.add_patch(box)
    font: Style = {"fontsize": palette.TEXT_SIZE - 1, "color": palette.INK}
    return [shape, ax.text(x, y, step.text, **palette.CENTRED, **font)]


def rows_up(steps: dict[str, Step], arrow: tuple[str, str, str]) -> float:
    """How many rows an arrow goes back up; at most 0 for others."""
    return steps[arrow[0]].row - steps[arrow[1]].row


def draw_arrow(begin: Step, end: Step, text: str, ax: Axes, aside: float = 2.4) -> list[Artist]:
    """Draw an arrow from one step to the next: across, down, or back up so far to the left."""
    (x0, y0), (x1, y1) = begin.middle, end.middle
    (w0, h0), (w1, h1) = begin.half, end.half
    if y0 == y1:
        sign = 1.0 if x1 > x0 else -1.0
        points = [(x0 + sign * w0, y0), (x1 - sign * w1, y1)]
        label = (x0 + sign * (w0 + 0.35), y0 + 0.28)
    elif y1 < y0:
        points, label = [(x0, y0 - h0), (x1, y1 + h1)], (x0 + 0.35, (y0 - h0 + y1 + h1) / 2)
    else:
        points = [(x0 - w0, y0), (x0 - aside, y0), (x0 - aside, y1), (x1 - w1, y1)]
        label = (x0 - w0, y0 + 0.28)
    properties = {"arrowstyle": "-|>", "color": palette.INK, "shrinkA": 0, "shrinkB": 0}
    style = {"fontsize": palette.TEXT_SIZE - 1, "fontweight": "bold", "color": palette.TREE}
    return [
        *ax.plot(*zip(*points), color=palette.INK, linewidth=1.4, zorder=0),
        ax.annotate("", points[-1], xytext=points[-2], arrowprops=properties),
        ax.text(*label, text, fontdict=style, **palette.CENTRED),
    ]

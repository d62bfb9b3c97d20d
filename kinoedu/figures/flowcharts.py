"""Flowcharts: what an algorithm does in boxes, what it asks in diamonds, what comes next in arrows."""

from typing import NamedTuple

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.patches import FancyBboxPatch, Polygon

from . import palette

WIDE, HIGH = 3.4, 0.9  # of a box; columns are 4.4 apart, rows 1.6


class Step(NamedTuple):
    """One place of a flowchart: "do", "ask" or "end", its words, its column and its row from the top."""

    kind: str
    words: str
    column: float
    row: float

    @property
    def middle(self) -> tuple[float, float]:
        """Where it is drawn."""
        return 4.4 * self.column, -1.6 * self.row


def draw_flowchart(steps: dict[str, Step], arrows: list[tuple[str, str, str]], ax: Axes) -> list[Artist]:
    """Draw steps by name, and arrows (from, to, words) between them; an arrow between columns goes out at the side."""
    artists: list[Artist] = []
    for step in steps.values():
        artists += draw_step(step, ax)
    for begin, end, words in arrows:
        artists += draw_arrow(steps[begin], steps[end], words, ax)
    xs, ys = zip(*(step.middle for step in steps.values()))
    ax.set(xlim=(min(xs) - 2.5, max(xs) + 2.2), ylim=(min(ys) - 0.8, max(ys) + 0.8), aspect="equal")
    ax.axis("off")
    return artists


def draw_step(step: Step, ax: Axes) -> list[Artist]:
    """A box, a diamond, or a box with round ends."""
    x, y = step.middle
    if step.kind == "ask":
        corners = [(x - WIDE / 2 - 0.35, y), (x, y - 0.68), (x + WIDE / 2 + 0.35, y), (x, y + 0.68)]
        shape: Artist = ax.add_patch(Polygon(corners, facecolor="#E5F0FA", edgecolor=palette.TREE, linewidth=1.8))
    else:
        style = "round,pad=0,rounding_size=0.44" if step.kind == "end" else "square,pad=0"
        colour = palette.START if step.kind == "end" else palette.OBSTACLE
        box = FancyBboxPatch(
            (x - WIDE / 2, y - HIGH / 2), WIDE, HIGH, boxstyle=style, facecolor="white", edgecolor=colour, linewidth=1.8
        )
        shape = ax.add_patch(box)
    return [shape, ax.text(x, y, step.words, ha="center", va="center", fontsize=palette.TEXT_SIZE - 1, color=palette.INK)]


def draw_arrow(begin: Step, end: Step, words: str, ax: Axes) -> list[Artist]:
    """From one step to the next."""
    (x0, y0), (x1, y1) = begin.middle, end.middle
    side = WIDE / 2 + (0.35 if begin.kind == "ask" else 0.0)
    half = {"ask": 0.68}.get(begin.kind, HIGH / 2), {"ask": 0.68}.get(end.kind, HIGH / 2)
    if x0 == x1 and y1 < y0 and y0 - y1 < 2.0:
        points = [(x0, y0 - half[0]), (x1, y1 + half[1])]
    elif y0 == y1:
        way = 1.0 if x1 > x0 else -1.0
        points = [(x0 + way * side, y0), (x1 - way * (WIDE / 2 + (0.35 if end.kind == "ask" else 0.0)), y1)]
    elif x0 == x1:  # back up: out at the left, and in at the left
        points = [(x0 - side, y0), (x0 - 2.4, y0), (x0 - 2.4, y1), (x1 - WIDE / 2 - (0.35 if end.kind == "ask" else 0.0), y1)]
    else:
        points = [(x0, y0 - half[0]), (x0, (y0 + y1) / 2), (x1, (y0 + y1) / 2), (x1, y1 + half[1])] if y1 < y0 else [
            (x0, y0 + half[0]), (x0, y1), (x1 + (WIDE / 2 if x1 < x0 else -WIDE / 2), y1)]  # fmt: skip
    line = ax.plot(*zip(*points[:-1], points[-1]), color=palette.INK, linewidth=1.4, zorder=0)
    head = ax.annotate(
        "", points[-1], xytext=points[-2], arrowprops={"arrowstyle": "-|>", "color": palette.INK, "shrinkA": 0, "shrinkB": 0}
    )
    (ax0, ay0), (bx, by) = points[0], points[1]
    level, left = ay0 == by, bx < ax0
    place = (ax0 + (-0.3 if left else 0.3), ay0 + 0.28) if level else (ax0 + 0.12, ay0 - 0.22)
    style = {"fontsize": palette.TEXT_SIZE - 2, "fontweight": "bold", "color": palette.TREE}
    label = ax.text(*place, words, ha="center" if level else "left", va="center", fontdict=style)
    return [*line, head, label]

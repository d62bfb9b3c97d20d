"""Names at the ends of curves, each in its curve's colour, none over another."""

from typing import Any

from matplotlib.artist import Artist
from matplotlib.axes import Axes

from . import palette
from .drawing import HALO

GAP = 0.062  # of the axes' height, from a name to the next


def name_ends(x: float, ends: list[tuple[str, float, str]], ax: Axes) -> list[Artist]:
    """Write names beside x; `ends` are names, heights and colours, in the order in which equal
    heights are written upwards.
    """
    look: dict[str, Any] = {
        "fontsize": palette.TEXT_SIZE,
        "fontweight": "bold",
        "va": "center",
        "path_effects": HALO,
    }
    ax.get_ylim()  # the limits are settled when they are asked for
    to_share = ax.transData + ax.transAxes.inverted()
    sorted_ends = sorted(ends, key=lambda end: end[1])
    places = spread_out([float(to_share.transform((x, height))[1]) for _, height, _ in sorted_ends])
    return [
        ax.annotate(
            name, (x, place), xycoords=("data", "axes fraction"), xytext=(6, 0), textcoords="offset points", color=colour,
            annotation_clip=False, **look,
        )
        for (name, _, colour), place in zip(sorted_ends, places)
    ]  # fmt: skip


def spread_out(places: list[float]) -> list[float]:
    """Places from low to high, moved up where two are close, and all that pass the top moved down
    again.

    >>> [round(place, 3) for place in spread_out([0.0, 0.03, 1.0, 1.0])]
    [0.0, 0.062, 0.938, 1.0]
    """
    moved: list[float] = []
    for place in places:
        moved.append(max(place, moved[-1] + GAP) if moved else place)
    top = 1.0
    for i in range(len(moved) - 1, -1, -1):
        moved[i], top = min(moved[i], top), min(moved[i], top) - GAP
    return moved

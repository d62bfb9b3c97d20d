"""Names at the ends of curves, in the curves' colours, without overlaps."""

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes

from . import palette
from .names import HALO
from .palette import Style

GAP = 0.062  # the distance between names, as a fraction of the axes' height


def name_ends(x: float, ends: list[tuple[str, float, str]], ax: Axes) -> list[Artist]:
    """Write names beside x.

    ends : names, heights and colours; equal heights are written upwards in this order.
    """
    look: Style = {"va": "center", "path_effects": HALO, "annotation_clip": False, **palette.BOLD}
    beside: Style = {"xytext": (6, 0), "textcoords": "offset points"}
    ax.get_ylim()  # makes matplotlib compute the limits now
    to_share = ax.transData + ax.transAxes.inverted()
    sorted_ends = sorted(ends, key=lambda end: end[1])
    places = spread_out([float(to_share.transform((x, height))[1]) for _, height, _ in sorted_ends])
    across = ("data", "axes fraction")
    return [
        ax.annotate(name, (x, place), xycoords=across, color=colour, **beside, **look)
        for (name, _, colour), place in zip(sorted_ends, places)
    ]


def spread_out(places: list[float]) -> list[float]:
    """Heights from low to high, moved apart where two are close, as little as possible.

    Heights that are too close form a group, which stays around its middle, within the axes.

    Examples
    --------
    >>> [round(place, 3) for place in spread_out([0.1, 0.102, 0.5, 1.0, 1.0])]
    [0.07, 0.132, 0.5, 0.938, 1.0]
    """
    groups: list[list[float]] = []
    for k, place in enumerate(places):
        groups.append([place - GAP * k])  # so that those of a group are equal
        while len(groups) > 1 and np.mean(groups[-2]) > np.mean(groups[-1]):
            groups[-2:] = [groups[-2] + groups[-1]]
    middles = np.repeat([np.mean(group) for group in groups], [len(group) for group in groups])
    top = 1.0 - GAP * (len(places) - 1)
    return [float(height) for height in np.clip(middles, 0.0, top) + GAP * np.arange(len(places))]

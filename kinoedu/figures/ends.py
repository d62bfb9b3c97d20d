"""Names at the ends of curves, in the curves' colours, without overlaps."""

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
    """Heights from low to high, moved up where two are close, and down where they pass the top.

    Examples
    --------
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

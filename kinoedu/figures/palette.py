"""The colours of the course: each means the same on every page, and stays apart for colour-blind
eyes and on a projector.

After M. Okabe and K. Ito, "Color universal design" (2008). Line styles and markers differ as well.
"""

from typing import Any

START = "#007A5E"
GOAL = "#C44E00"
OBSTACLE = "#4B5563"
FREE = "#FFFFFF"
DEAR = "#A98467"  # ground that costs most to cross; the cheapest is as what is free
OUTSIDE = "#9CA3AF"
CELL = "#E3F0FA"
TREE = "#0072B2"
ROADMAP = "#3B9BD9"
PATH = "#E69F00"
ROBOT = "#CC79A7"
CONTACT = "#000000"
FRONTIER = "#F0E442"  # seen by a search, and waiting
INK = "#111827"
FREE_LINK = "#0072B2"
HIT = "#D32F2F"
LINKS = (
    "#2F7FD0",
    "#111827",
    "#D32F2F",
)  # an arm is free, its link 1 hits, its link 2 does: the book's blue, black and red
FREE_AREA, HIT_1_AREA, HIT_2_AREA = "#CFE3F7", "#3B4250", "#E8837F"
LINKS_LIGHT = (FREE_AREA, HIT_1_AREA, HIT_2_AREA)  # the same as areas

TEXT_SIZE = 13

NAMED = {
    name.lower(): colour
    for name, colour in list(globals().items())
    if name.isupper() and isinstance(colour, str)
}


def hex_of(colour: Any) -> str:
    """A matplotlib colour as "#rrggbb", or "none" where it is none or cannot be seen.

    >>> hex_of("red"), hex_of((0, 0, 1, 0.5)), hex_of("none")
    ('#ff0000', '#0000ff', 'none')
    """
    from matplotlib.colors import to_hex, to_rgba

    red, green, blue, opacity = to_rgba(colour)
    return to_hex((red, green, blue)) if opacity > 0.0 else "none"

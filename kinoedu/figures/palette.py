"""The colours and text styles of the course.

Each colour means the same thing on every page, and they are distinguishable for colour-blind eyes
and on a projector. After M. Okabe and K. Ito, "Color universal design" (2008). Line styles and
markers differ as well.
"""

from typing import Any

from matplotlib import pyplot as plt
from matplotlib.axes import Axes

START = "#007A5E"
GOAL = "#7B1FA2"  # purple, which nothing else has
OBSTACLE = "#4B5563"
FREE = "#FFFFFF"
DEAR = "#A98467"  # the most expensive ground; the cheapest has the colour of free space
OUTSIDE = "#9CA3AF"
CELL = "#E3F0FA"
TREE = "#0072B2"
GOAL_TREE = "#5B8C1A"  # light green: the tree that grows from the goal
ROADMAP = "#3B9BD9"
PATH = "#E69F00"  # called orange
ROBOT = "#CC79A7"
CONTACT = "#000000"
FRONTIER = "#F0E442"  # yellow: the frontier of a search
INK = "#111827"
FREE_LINK = "#0072B2"
HIT = "#D32F2F"
CLEAR = "#007A5E"  # green: a motion, pose or place that is free
TRUE = "#007A5E"  # green and solid: the right answer in the picture of a wrong one
YOURS = "#A84300"  # brown and dashed: the student's answer in that picture
FLOOR, CEILING = "#009E73", "#882255"  # of a cell: the edges below and above it
CUT = "#882255"  # a slice through a solid, and what it meets
LEFT, RIGHT = TREE, PATH  # of a line
SHAPE = "#C7CCD4"  # a polygon that is no obstacle, with room for words in it
GROWN = "#D5D9E0"  # a C-obstacle: the colour of obstacles, paler
ROUTE = "#F6D58A"  # a way on which another is drawn
LIT = "#FFE9A8"  # behind the line of code that has just run
# The book's blue, black and red: an arm is free, its link 1 is in contact, its link 2 is.
LINKS = ("#2F7FD0", "#111827", "#D32F2F")
FREE_AREA, HIT_1_AREA, HIT_2_AREA = "#CFE3F7", "#3B4250", "#E8837F"
LINKS_LIGHT = (FREE_AREA, HIT_1_AREA, HIT_2_AREA)  # the same, for areas

# Methods that are compared, in the order in which they are named.
METHODS = ("#0072B2", "#C44E00", "#009E73", "#882255", "#111827", "#3B9BD9")

TEXT_SIZE = 13

# Styles, as keyword arguments of matplotlib's functions.
Style = dict[str, Any]
TEXT: Style = {"fontsize": TEXT_SIZE}
BOLD: Style = {"fontsize": TEXT_SIZE, "fontweight": "bold"}
CENTRED: Style = {"ha": "center", "va": "center"}
SOLID: Style = {"facecolor": OBSTACLE, "edgecolor": OBSTACLE}
RIM: Style = {"markeredgecolor": "white"}  # of a marker
GRID: Style = {"color": "#E5E7EB", "linewidth": 0.8}

NAMED = {
    name.lower(): colour
    for name, colour in list(globals().items())
    if name.isupper() and isinstance(colour, str)
}
# What differs where a page is dark: boards in JupyterLab's dark themes and on the site. Stored
# pictures stay on a white card.
DARK = {
    "free": "#161B26",
    "obstacle": "#8792A5",
    "outside": "#414A5C",
    "ink": "#E5E7EB",
    "contact": "#FFFFFF",
    "start": "#2FC79B",
    "goal": "#C792EA",
    "tree": "#5AB0EE",
    "free_link": "#5AB0EE",
    "left": "#5AB0EE",
    "goal_tree": "#A4D25A",
    "roadmap": "#3F8FCB",
    "cell": "#22405C",
    "shape": "#364152",
    "frontier": "#A8951A",
    "dear": "#7A5B3E",
    "hit": "#FF7066",
    "clear": "#2FC79B",
    "true": "#2FC79B",
    "yours": "#F09B5A",
    "floor": "#2FC79B",
    "ceiling": "#E07AA8",
    "cut": "#FFC4DD",
    "free_area": "#1F4468",
    "hit_1_area": "#9AA3B2",
    "hit_2_area": "#A14B45",
}
THEMES = {"light": NAMED, "dark": {**NAMED, **DARK}}


def axes_or_new(ax: Axes | None, size: tuple[float, float]) -> Axes:
    """The axes given, or those of a new figure of a size in inches."""
    return plt.subplots(figsize=size, dpi=72, layout="constrained")[1] if ax is None else ax

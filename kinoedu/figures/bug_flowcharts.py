"""The flowchart of BugBase. Bug 1's is an exercise, so it is drawn in the solutions."""

from matplotlib.artist import Artist
from matplotlib.axes import Axes

from ..messages import get_message
from .flowcharts import Step, draw_flowchart
from .palette import axes_or_new


def draw_bug_base_flowchart(ax: Axes | None = None) -> list[Artist]:
    """Draw the flowchart of BugBase for a robot that moves in steps."""
    steps = {
        "start": Step("end", get_message("flowchart.start"), 0, 0),
        "at": Step("ask", get_message("flowchart.at_goal"), 0, 1),
        "reached": Step("end", get_message("flowchart.reached"), 1, 1),
        "near": Step("ask", get_message("flowchart.near"), 0, 2),
        "hit": Step("end", get_message("flowchart.hit"), 1, 2),
        "move": Step("do", get_message("flowchart.move"), 0, 3),
    }
    yes, no = get_message("flowchart.yes"), get_message("flowchart.no")
    arrows = [("start", "at", ""), ("at", "reached", yes), ("at", "near", no)]
    arrows += [("near", "hit", yes), ("near", "move", no), ("move", "at", "")]
    return draw_flowchart(steps, arrows, axes_or_new(ax, (8, 6)))

"""The lines of a bug that its board shows as they run."""

from collections.abc import Callable

from ...planners.bugs.bug0 import bug0_walk
from ...planners.bugs.bug1 import bug1_walk
from ...planners.bugs.bug2 import bug2_walk
from ...planners.bugs.bug2_prelim import bug2_prelim_walk
from ...planners.bugs.bug_base import bug_base_walk
from ..tracing.code_run import CodeRun, Look, trace_lines

CODE: dict[str, Callable[..., int]] = {
    "bug_base": bug_base_walk,
    "bug0": bug0_walk,
    "bug1": bug1_walk,
    "bug2_prelim": bug2_prelim_walk,
    "bug2": bug2_walk,
}
POINTS = {
    "place": "(robot.place.x, robot.place.y)",
    "hit": "(hit.x, hit.y)",
    "nearest": "(nearest.x, nearest.y)",
    "travelled": "robot.travelled",
    "distance to goal": "robot.place.distance",
}


def trace_bug(name: str, tick: float, walk: Callable[[], object]) -> CodeRun:
    """The lines of a bug in a call that walks.

    tick : how far it walks in one step of its board.
    """
    look = Look(
        POINTS,
        names={"tick": tick},
        colours={"place": "robot", "hit": "contact", "nearest": "hit"},
        hidden=("robot",),
        progress="robot.travelled / tick + 1e-6",
    )
    return trace_lines(CODE[name], look, lambda _: walk())

"""Challenges of lesson 2, on `bug_board`."""

from __future__ import annotations

from typing import Any

from ..bugs.bugs import BUGS, BugBoard
from ..core.challenge import Answer, posed
from ..core.scene import place_of
from ..planning.plans import GOAL, START


@posed
def bug2_walks_farther(board: BugBoard, kept: dict[str, Any]) -> Answer:
    """Both arrive, and Bug 2 has walked farther than Bug 1."""
    lengths = {}
    for name in ("bug1", "bug2"):
        plan = walk_of(board, name)
        if plan.path is None:
            return "no_way", {}
        lengths[name] = float(plan.walk.travelled[-1])
    values = {name: f"{length:.4g}" for name, length in lengths.items()}
    return "reached" if lengths["bug2"] > lengths["bug1"] else "not_yet", values


@posed
def bug0_is_lost(board: BugBoard, kept: dict[str, Any]) -> Answer:
    """Bug 0 never arrives, though Bug 1 does."""
    if walk_of(board, "bug1").path is None:
        return "no_way", {}
    lost = walk_of(board, "bug0")
    length = f"{lost.walk.travelled[-1]:.4g}"
    return "reached" if lost.path is None else "not_yet", {"length": length}


def walk_of(board: BugBoard, name: str) -> Any:
    """The plan of a bug in the scene that the board shows, with its turn."""
    scene = board.canvas.shown
    rings = [item["rings"][0] for item in scene["polygons"]]
    ends = place_of(scene, START), place_of(scene, GOAL)
    return BUGS[name][1](*ends, rings, board.step, turn=board.turn.value)

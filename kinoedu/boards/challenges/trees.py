"""Challenges of lesson 9, on `board` and `race_board`."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...geometry.paths import path_length
from ...planners.problem_input import world_size
from ..core.challenge import Answer, posed
from ..planning.board import Board
from ..planning.race import RaceBoard

SMALL, JUMP = 0.03, 1.1  # a move, as a share of the world; the ratio of two lengths
FEWER = 2.0  # the ratio of two numbers of nodes


@posed
def path_jumps(board: Board, kept: dict[str, Any]) -> Answer:
    """A small move of something has changed the path's length by a tenth."""
    plan, problem = board.plan, board.problem
    path = getattr(plan, "path", None)
    before, kept["before"] = kept.get("before"), (places_in(board), path)
    if path is None:
        return "no_path", {}
    if before is None or before[1] is None or before[0].shape != places_in(board).shape:
        return "move", {}
    moved = float(np.abs(before[0] - places_in(board)).max())
    if moved > SMALL * world_size(problem):
        return "slower", {}
    short, long = sorted(path_length(way[:, :2]) for way in (before[1], path))
    if moved == 0.0:
        return "move", {}
    values = {"short": f"{short:.4g}", "long": f"{long:.4g}"}
    return "reached" if long >= JUMP * short else "not_yet", values


@posed
def second_tree_pays(board: RaceBoard, kept: dict[str, Any]) -> Answer:
    """RRT-Connect needs half of RRT's nodes."""
    by_name = {plan.planner: plan for plan in board.plans if hasattr(plan, "planner")}
    one: Any = by_name.get("RRT")
    two: Any = by_name.get("RRT-Connect")
    if one is None or two is None or one.path is None or two.path is None:
        return "no_path", {}
    values = {"one": len(one.tree.nodes), "two": len(two.tree.nodes)}
    return "reached" if values["one"] >= FEWER * values["two"] else "not_yet", values


def places_in(board: Board) -> np.ndarray:
    """All places of a scene, as one row of numbers."""
    scene = board.canvas.shown
    points = [np.ravel(item["at"]) for item in [*scene["handles"], *scene["discs"]]]
    rings = [np.ravel(ring) for item in scene["polygons"] for ring in item["rings"]]
    return np.concatenate([*points, *rings])

"""Challenges of lesson 13, on `car_board`."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..car.car import CarBoard, trajectory_of
from ..core.challenge import Answer, posed

FEW = 40


@posed
def mostly_backwards(board: CarBoard, kept: dict[str, Any]) -> Answer:
    """The plan drives back for more time than forward."""
    if board.plan is None or not np.isfinite(board.plan.cost):
        return "no_path", {}
    drive = trajectory_of(board.plan)
    back = float(np.sum(drive.durations[drive.controls[:, 0] < 0.0]))
    values = {"back": f"{back:.3g}", "forward": f"{drive.duration - back:.3g}"}
    return "reached" if back > drive.duration - back else "not_yet", values


@posed
def small_tree(board: CarBoard, kept: dict[str, Any]) -> Answer:
    """The plan reaches its goal with a tree of at most forty nodes."""
    plan = board.plan
    if plan is None or plan.tree is None or not np.isfinite(plan.cost):
        return "no_path", {}
    nodes = len(plan.tree.nodes)
    return "reached" if nodes <= FEW else "not_yet", {"nodes": nodes, "few": FEW}

"""Challenges of lesson 14, on `moving_board` and `chance_board`."""

from __future__ import annotations

from typing import Any

from ..core.challenge import Answer, posed
from ..moving.chances import ChanceBoard
from ..moving.moving import MovingBoard, waiting_time

NO_TIME = 0.1  # a shorter wait is none


@posed
def without_waiting(board: MovingBoard, kept: dict[str, Any]) -> Answer:
    """The robot arrives, and has not waited."""
    if board.plan is None or board.plan.path is None:
        return "no_path", {}
    waited = waiting_time(board.plan.path)
    return "reached" if waited < NO_TIME else "not_yet", {"waited": f"{waited:.3g}"}


@posed
def no_risk_no_way(board: ChanceBoard, kept: dict[str, Any]) -> Answer:
    """So small a chance is asked for that no path is left between free places."""
    if board.plan is None:
        return "invalid", {}
    delta = f"{board.delta.value:.6g}"
    return "reached" if board.plan.path is None else "not_yet", {"delta": delta}

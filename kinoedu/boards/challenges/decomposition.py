"""Challenges of lesson 3, on `sweep_board`."""

from __future__ import annotations

from typing import Any

from ..core.challenge import Answer, posed
from ..geometry.sweep import SweepBoard

EDGES = 8


@posed
def eight_edges(board: SweepBoard, kept: dict[str, Any]) -> Answer:
    """The line crosses eight edges at once."""
    crossed = len(board.steps[-1].status) if board.steps else 0
    return "reached" if crossed >= EDGES else "not_yet", {"crossed": crossed, "wanted": EDGES}


@posed
def one_event_for_two(board: SweepBoard, kept: dict[str, Any]) -> Answer:
    """The line meets two vertices at one event."""
    met = max((len(step.vertices) for step in board.steps), default=0)
    return "reached" if met >= 2 else "not_yet", {"met": met}

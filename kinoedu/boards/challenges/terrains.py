"""Challenges of lesson 10, on `race_board` with two planners of the reader's."""

from __future__ import annotations

from typing import Any

from ..core.challenge import Answer, posed
from ..planning.race import RaceBoard

LONGER = 1.25


@posed
def only_one_finds(board: RaceBoard, kept: dict[str, Any]) -> Answer:
    """One planner finds a path where the other finds none."""
    found = [lengths is not None for lengths in lengths_of(board)]
    if len(found) < 2:
        return "wrong", {}
    return ("reached", {}) if any(found) and not all(found) else ("both", {"found": sum(found)})


@posed
def much_longer(board: RaceBoard, kept: dict[str, Any]) -> Answer:
    """One planner's path is longer by a quarter than the other's."""
    found = [length for length in lengths_of(board) if length is not None]
    if len(found) < 2:
        return "wrong", {}
    values = {"short": f"{min(found):.4g}", "long": f"{max(found):.4g}"}
    return "reached" if max(found) >= LONGER * min(found) else "not_yet", values


def lengths_of(board: RaceBoard) -> list[float | None]:
    """The length of each planner's path, or None."""
    return [getattr(plan, "length", None) for plan in board.plans]

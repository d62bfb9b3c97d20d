"""Challenges of the tour, on `board`."""

from __future__ import annotations

from typing import Any

from ..core.challenge import Answer, posed
from ..planning.board import Board

MANY, FEW = 1000, 300


@posed
def many_nodes(board: Board, kept: dict[str, Any]) -> Answer:
    """The tree has found a path, and has 1,000 nodes or more."""
    plan: Any = board.plan
    tree = getattr(plan, "tree", None)
    if tree is None or plan.path is None:
        return "no_path", {}
    values = {"n": len(tree.nodes), "many": MANY}
    return "reached" if len(tree.nodes) >= MANY else "not_yet", values


@posed
def lucky_roadmap(board: Board, kept: dict[str, Any]) -> Answer:
    """A roadmap of 300 samples or fewer has a path."""
    plan: Any = board.plan
    if board.samples.value > FEW:
        return "many", {"few": FEW}
    found = getattr(plan, "roadmap", None) is not None and plan.path is not None
    return "reached" if found else "not_yet", {"n": board.samples.value}

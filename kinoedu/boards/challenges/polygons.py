"""Challenges of lesson 11, on `board` with a roadmap."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...geometry.paths import path_length
from ...planners import prm
from ..core.challenge import Answer, posed
from ..planning.board import Board

MANY, DETOUR = 600, 1.4


@posed
def more_samples_help(board: Board, kept: dict[str, Any]) -> Answer:
    """The roadmap has no path, and one of 600 samples has."""
    if board.plan is None or board.plan.path is not None:
        return "not_yet", {}
    more = prm(board.problem, n=MANY, k=10, rng=board.seed.value)
    return ("none" if more.path is None else "reached"), {"many": MANY}


@posed
def detour(board: Board, kept: dict[str, Any]) -> Answer:
    """The path is much longer than the straight line to the goal."""
    if board.plan is None or board.plan.path is None:
        return "no_path", {}
    straight = float(np.hypot(*(board.problem.goal[:2] - board.problem.start[:2])))
    way = path_length(board.plan.path[:, :2])
    ratio = way / straight if straight > 0.0 else 0.0
    return "reached" if ratio >= DETOUR else "not_yet", {"ratio": f"{ratio:.3g}"}

"""Challenges of lesson 6, on `samples_board`."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...sampling import largest_empty_ball
from ..core.challenge import Answer, posed
from ..geometry.samples import SAMPLERS, SamplesBoard

NEAR = 0.99


@posed
def in_the_largest_hole(board: SamplesBoard, kept: dict[str, Any]) -> Answer:
    """q is nearly as far from all points as a place of the square can be."""
    points = SAMPLERS[board.sampler.value](board.n.value)
    q = np.clip(board.canvas.shown["handles"][0]["at"], 0.0, 1.0)
    away = float(np.sqrt(((points - q) ** 2).sum(axis=1)).min())
    share = away / largest_empty_ball(points).radius
    return "reached" if share >= NEAR else "not_yet", {"share": f"{share:.0%}"}


@posed
def random_beats_halton(board: SamplesBoard, kept: dict[str, Any]) -> Answer:
    """With so many points the random ones have the smaller largest hole."""
    n = board.n.value
    chance, halton = (largest_empty_ball(SAMPLERS[s](n)).radius for s in ("random", "halton"))
    values = {"n": n, "chance": f"{chance:.4f}", "halton": f"{halton:.4f}"}
    return "reached" if chance < halton else "not_yet", values

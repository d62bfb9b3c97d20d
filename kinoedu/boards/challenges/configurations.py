"""Challenges of lesson 5, on `reach_board` and `torus_board`."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...robots.arm import ArmRobot, why_unreachable
from ...spaces import torus_distance
from ..core.canvas import Canvas
from ..core.challenge import Answer, Challenge, posed
from ..core.scene import place_of

DEGREES = 20.0
SAVING = 4.0


def elbows_agree(arm: ArmRobot) -> Challenge:
    """The target's two configurations have nearly the same elbow: it is at a rim of the ring."""

    def two_elbows_in_one(board: Canvas, kept: dict[str, Any]) -> Answer:
        p = place_of(board.shown, "p")
        if why_unreachable(arm, p):
            return "out_of_reach", {}
        elbows = [q[1] for q in arm.inverse(p)]
        apart = (elbows[0] - elbows[-1] + np.pi) % (2.0 * np.pi) - np.pi
        degrees = abs(float(np.degrees(apart)))
        return "reached" if degrees <= DEGREES else "not_yet", {"degrees": f"{degrees:.0f}"}

    return posed(two_elbows_in_one)


@posed
def short_way_round(board: Canvas, kept: dict[str, Any]) -> Answer:
    """The way on the torus is a quarter of the straight way on the square."""
    a, b = place_of(board.shown, "a"), place_of(board.shown, "b")
    plane, torus = float(np.hypot(*(a - b))), float(torus_distance(a, b))
    values = {"plane": f"{plane:.3g}", "torus": f"{torus:.3g}"}
    return "reached" if plane >= SAVING * torus and plane > 0.0 else "not_yet", values

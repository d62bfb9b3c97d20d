"""Challenges of lesson 12, on `curves_board`."""

from __future__ import annotations

from typing import Any

from ...curves import dubins_path, reeds_shepp_path
from ..car.curves import pose_in
from ..core.canvas import Canvas
from ..core.challenge import Answer, Challenge, posed

HALF = 2.0


def three_arcs(radius: float) -> Challenge:
    """Dubins' curve consists of three arcs, without a straight piece."""

    def no_straight_piece(board: Canvas, kept: dict[str, Any]) -> Answer:
        word = dubins_path(*poses(board), radius).word
        return "reached" if set(word) == {"L", "R"} and len(word) == 3 else "not_yet", {
            "word": word
        }

    return posed(no_straight_piece)


def reverse_halves(radius: float) -> Challenge:
    """Driving back makes the way half as long, or shorter."""

    def worth_reversing(board: Canvas, kept: dict[str, Any]) -> Answer:
        a, b = poses(board)
        forward, both = (curve(a, b, radius).length for curve in (dubins_path, reeds_shepp_path))
        values = {"forward": f"{forward:.3g}", "both": f"{both:.3g}"}
        return "reached" if forward >= HALF * both and both > 0.0 else "not_yet", values

    return posed(worth_reversing)


def poses(board: Canvas) -> tuple[Any, Any]:
    """The two poses that the board shows."""
    return pose_in(board.shown, "a"), pose_in(board.shown, "b")

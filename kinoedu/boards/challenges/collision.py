"""Challenges of lesson 7, on `slide_board` and `arm_board`."""

from __future__ import annotations

from typing import Any

from ...geometry import point_in_convex_polygon
from ..arm.arm import ArmBoard
from ..arm.arm_drawn import links_in_contact
from ..core.challenge import Answer, posed
from ..geometry.slide import SlideBoard


@posed
def free_in_the_obstacle(board: SlideBoard, kept: dict[str, Any]) -> Answer:
    """A vertex of the obstacle is outside the C-obstacle."""
    corners, obstacle = board.slide.corners, board.slide.obstacle
    free = [i for i, v in enumerate(obstacle) if not point_in_convex_polygon(v, corners)]
    if not free:
        return "not_yet", {}
    return "reached", {"number": free[0]}


@posed
def both_links_touch(board: ArmBoard, kept: dict[str, Any]) -> Answer:
    """Both links are in contact."""
    hits = links_in_contact(board.arm, board.q, board.world)
    if len(hits) == 1:
        return "one", {"link": hits[0]}
    return "reached" if len(hits) == 2 else "not_yet", {}

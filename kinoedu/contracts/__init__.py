"""Checks of a reader's own planner, robot or world: what it promises, and what it breaks."""

from .planner import PlannerReport, check_planner
from .report import Finding, Report
from .robot import check_robot, check_world
from .traps import Trap, traps_for

__all__ = [
    "Finding",
    "PlannerReport",
    "Report",
    "Trap",
    "check_planner",
    "check_robot",
    "check_world",
    "traps_for",
]

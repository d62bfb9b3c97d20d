"""Challenges of lesson 8, on `roadmap_board` and `properties_board`."""

from __future__ import annotations

from typing import Any

import numpy as np

from ...planners import plan_by_visibility
from ..core.challenge import Answer, posed
from ..roadmaps.properties import PropertiesBoard
from ..roadmaps.roadmaps import RoadmapBoard

DELTA = 3.0


@posed
def missed_way(board: RoadmapBoard, kept: dict[str, Any]) -> Answer:
    """The roadmap of 60 samples or more has no path, though there is one."""
    plan, n = board.plan, board.controls.n.value
    if n < 60:
        return "few", {"n": n}
    if plan is None or plan.path is not None:
        return "not_yet", {}
    best = plan_by_visibility(plan.problem)
    return ("none", {}) if best.path is None else ("reached", {"length": f"{best.cost:.4g}"})


@posed
def long_way_round(board: PropertiesBoard, kept: dict[str, Any]) -> Answer:
    """The roadmap is connected, and its worst pair goes three times as far as it must."""
    survey = board.survey
    if survey is None or not np.isfinite(survey.efficiency):
        return "apart", {}
    values = {"delta": f"{survey.efficiency:.3g}"}
    return "reached" if survey.efficiency >= DELTA else "not_yet", values

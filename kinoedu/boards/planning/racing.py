"""One planner of a race: its result, drawn step by step on a clock that all planners share."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from ...messages import get_message
from ...planners import rrt, rrt_connect
from ...planners.trees.rewiring import rrt_star_rewirings
from ...planners.trees.rrt_star import rrt_star
from ...problems import Plan, ProblemRecord
from ..arm.rides import is_ours
from ..core.drawing import Drawing, Layer
from ..trees.rewired import costs_at, draw_paths, draw_tree_history, find_paths_to_goal
from .own import Attempt, describe_result, draw_attempt, try_planner
from .plans import Settings, draw_plan


class Runner(NamedTuple):
    """The result of a planner, and its drawing with its own number of steps."""

    plan: Plan | Attempt
    drawing: Drawing


def run_planner(planner: Callable[..., Any], problem: ProblemRecord, given: Settings) -> Runner:
    """Run a planner on a problem, and draw its result.

    The tree of an RRT* is drawn as it was at each step; a reader's own planner is stopped in time.
    """
    tuning = tuning_of(given)
    if planner is rrt_star:
        plan, log = rrt_star_rewirings(problem, **tuning, rng=given.seed)
        paths, n = find_paths_to_goal(log), len(log.nodes)
        layers = [draw_tree_history(log), *draw_paths(paths)]
        texts = describe_steps(plan.planner, costs_at(paths, n))
        return Runner(plan, Drawing(layers, total=n, step_texts=texts))
    if not is_ours(planner):
        tried = try_planner(planner, problem, given.seed)
        drawing = draw_attempt(tried, None)
        name = getattr(planner, "__name__", "?")
        outcome = tried.fault or describe_result(tried.length, tried.motions)
        texts = [get_message("race_board.reader", name=name, result=outcome)] * (drawing.total + 1)
        return Runner(tried, replace(drawing, warning="", step_texts=texts))
    plan = planner(problem, rng=given.seed, **(tuning if planner in (rrt, rrt_connect) else {}))
    drawing = draw_plan(plan)
    costs = [np.inf] * drawing.total + [plan.cost]
    return Runner(plan, replace(drawing, step_texts=describe_steps(plan.planner, costs)))


def tuning_of(given: Settings) -> dict[str, Any]:
    """The keywords of the planners of trees for the settings of a race."""
    return {"step_size": given.step_size, "max_nodes": given.samples}


def describe_steps(name: str, costs: list[float]) -> list[str]:
    """The number of nodes at each step, and the length of the path found by then, in words."""
    texts = []
    for step, cost in enumerate(costs):
        values = {"name": name, "nodes": f"{step:,}"}
        if np.isfinite(cost):
            texts.append(get_message("race_board.arrived", **values, cost=f"{cost:.4g}"))
        else:
            texts.append(get_message("race_board.growing", **values))
    if not np.isfinite(costs[-1]):
        texts[-1] = get_message("race_board.failed", name=name, nodes=f"{len(costs) - 1:,}")
    return texts


def stretch_growth(drawing: Drawing, total: int) -> Drawing:
    """A drawing stretched to more steps.

    Its path appears at its own last step; afterwards it stays as it is.
    """
    layers = [show_from(layer, drawing.total) for layer in drawing.layers]
    last = list(drawing.step_texts[-1:])
    *texts, text = [*drawing.step_texts, *last * (total - drawing.total)]
    unit = get_message("race_board.unit")
    return Drawing(layers, text=text, total=total, unit=unit, step_texts=texts)


def show_from(layer: Layer, step: int) -> Layer:
    """A layer that is shown at the end, as one whose rows appear at a given step."""
    if not layer.last:
        return layer
    return layer._replace(last=False, when=np.full(len(layer.rows), float(step)))

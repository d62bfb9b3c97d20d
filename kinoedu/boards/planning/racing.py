"""One planner of a race: its result, drawn step by step on a clock that all planners share."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from ...figures.drawing import summary
from ...messages import get_message
from ...planners import rrt, rrt_connect
from ...planners.own import call_planner, is_own, name_of
from ...planners.trees.rewiring import Rewirings, rrt_star_rewirings
from ...planners.trees.rrt_star import rrt_star
from ...problems import Plan, ProblemRecord
from ..core.drawing import Drawing, Layer
from ..trees.rewired import (
    costs_at,
    draw_paths,
    draw_tree_history,
    find_last_path,
    find_paths_to_goal,
)
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
        return Runner(plan, draw_history(plan, log))
    if is_own(planner):
        tried = try_planner(planner, problem, given.seed)
        drawing = draw_attempt(tried, None)
        outcome = tried.fault or describe_result(tried.length, tried.motions)
        text = get_message("race_board.reader", name=name_of(planner), result=outcome)
        texts = [text] * drawing.total
        return Runner(tried, replace(drawing, warning="", text=text, step_texts=texts))
    tuned = partial(planner, **tuning) if planner in (rrt, rrt_connect) else planner
    plan = call_planner(tuned, problem, given.seed)
    drawing = draw_plan(plan)
    n, name = drawing.total, plan.planner
    if plan.tree is None:  # it grows by the edges of its roadmap
        return Runner(plan, drawing.with_texts(lambda: [summary(plan, k) for k in range(n)]))
    last = replace(drawing, text=describe_end(name, n, plan.cost))
    return Runner(plan, last.with_texts(lambda: [describe_step(name, k, np.inf) for k in range(n)]))


def draw_history(plan: Plan, log: Rewirings) -> Drawing:
    """The tree of an RRT* at each step; while something is dragged at the last one."""
    n, name, tree = len(log.nodes), plan.planner, draw_tree_history(log)
    text = describe_end(name, n, plan.cost)
    last = Drawing([tree, *draw_paths(find_last_path(log))], text=text, total=n)

    def draw_all() -> Drawing:
        paths = find_paths_to_goal(log)
        texts = [describe_step(name, k, cost) for k, cost in enumerate(costs_at(paths, n)[:-1])]
        return replace(last, layers=[tree, *draw_paths(paths)], step_texts=texts)

    return last.completed_by(draw_all)


def tuning_of(given: Settings) -> dict[str, Any]:
    """The keywords of the planners of trees for the settings of a race."""
    return {"step_size": given.step_size, "max_nodes": given.samples}


def describe_step(name: str, step: int, cost: float) -> str:
    """The number of nodes at a step, and the length of the path found by then, in words."""
    values = {"name": name, "nodes": f"{step:,}"}
    if np.isfinite(cost):
        return get_message("race_board.arrived", **values, cost=f"{cost:.4g}")
    return get_message("race_board.growing", **values)


def describe_end(name: str, step: int, cost: float) -> str:
    """The same at the last step, where no path yet means none at all."""
    if np.isfinite(cost):
        return describe_step(name, step, cost)
    return get_message("race_board.failed", name=name, nodes=f"{step:,}")


def stretch_growth(drawing: Drawing, total: int) -> Drawing:
    """A drawing stretched to more steps.

    Its path appears at its own last step; afterwards it stays as it is.
    """
    unit = get_message("race_board.unit")

    def stretch(own: Drawing) -> Drawing:
        layers = [show_from(layer, own.total) for layer in own.layers]
        return Drawing(layers, text=own.text, total=total, unit=unit)

    def stretch_all() -> Drawing:
        own = drawing.completed
        texts = [*own.step_texts, *[own.text] * (total - own.total)]
        return replace(stretch(own), step_texts=texts)

    return stretch(drawing).completed_by(stretch_all)


def show_from(layer: Layer, step: int) -> Layer:
    """A layer that is shown at the end, as one whose rows appear at a given step."""
    if not layer.last:
        return layer
    return layer._replace(last=False, when=np.full(len(layer.rows), float(step)))

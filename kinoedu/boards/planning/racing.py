"""One planner of a race: what came of it, drawn on a clock that all share, a node at a step."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from ...planners import rrt, rrt_connect
from ...planners.trees.rewiring import rrt_star_rewirings
from ...planners.trees.rrt_star import rrt_star
from ...problems import Plan, ProblemRecord
from ...words import say
from ..arm.rides import is_ours
from ..core.drawing import Drawing, Layer
from ..trees.rewired import costs_at, tree_as_it_was, ways_drawn, ways_to_goal
from .own import Attempt, attempt, drawing_of_attempt, result
from .plans import Settings, drawing_of


class Runner(NamedTuple):
    """What came of a planner, and its drawing on a clock of its own."""

    plan: Plan | Attempt
    drawing: Drawing


def run(planner: Callable[..., Any], problem: ProblemRecord, given: Settings) -> Runner:
    """Let a planner try a problem. The tree of an RRT* is drawn as it was at each step; a reader's
    own planner is stopped.
    """
    if planner is rrt_star:
        plan, log = rrt_star_rewirings(
            problem, step=given.step, max_nodes=given.samples, rng=given.seed
        )
        ways = ways_to_goal(log)
        layers = [tree_as_it_was(log), *ways_drawn(ways)]
        n = len(log.nodes)
        return Runner(plan, Drawing(layers, total=n, told=told_of(plan.planner, costs_at(ways, n))))
    if not is_ours(planner):
        tried = attempt(planner, problem, given.seed)
        drawing = drawing_of_attempt(tried, None)
        name = getattr(planner, "__name__", "?")
        said = say(
            "race_board.asked", name=name, result=tried.fault or result(tried.length, tried.motions)
        )
        return Runner(tried, replace(drawing, warning="", told=[said] * (drawing.total + 1)))
    tuning = (
        {"step": given.step, "max_nodes": given.samples} if planner in (rrt, rrt_connect) else {}
    )
    plan = planner(problem, rng=given.seed, **tuning)
    drawing = drawing_of(plan)
    costs = [np.inf] * drawing.total + [plan.cost]
    return Runner(plan, replace(drawing, told=told_of(plan.planner, costs)))


def told_of(name: str, costs: list[float]) -> list[str]:
    """How many nodes there are at each step, and how long the path is by then."""
    told = []
    for nodes, cost in enumerate(costs):
        if np.isfinite(cost):
            told.append(
                say("race_board.arrived", name=name, nodes=f"{nodes:,}", cost=f"{cost:.4g}")
            )
        else:
            told.append(say("race_board.growing", name=name, nodes=f"{nodes:,}"))
    if not np.isfinite(costs[-1]):
        told[-1] = say("race_board.failed", name=name, nodes=f"{len(costs) - 1:,}")
    return told


def on_clock(drawing: Drawing, total: int) -> Drawing:
    """A drawing on a longer clock: after its own last step it stays as it is, and its path comes at
    that.
    """
    layers = [at_its_end(layer, drawing.total) for layer in drawing.layers]
    told = [*drawing.told, *list(drawing.told[-1:]) * (total - drawing.total)]
    return Drawing(layers, text=told.pop(), total=total, unit=say("race_board.unit"), told=told)


def at_its_end(layer: Layer, step: int) -> Layer:
    """A layer that is shown at the end, as one whose rows come at a step."""
    return (
        layer._replace(last=False, when=np.full(len(layer.rows), float(step)))
        if layer.last
        else layer
    )

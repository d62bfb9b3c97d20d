"""The lines of one planner of a race: it leads, and the others grow as far as it has grown."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

from ...geometry.checks import Array
from ...messages import get_message
from ...planners import rrt, rrt_connect, rrt_star
from ...planners.own import is_own
from ...problems import ProblemRecord
from ...spaces.buckets import GrowingTree
from ..core.drawing import Drawing
from ..tracing.code_run import CodeRun, Look, retime, trace_lines
from .lit import CODE
from .own import draw_attempt, try_planner
from .plans import Settings
from .racing import Runner, stretch_growth, tuning_of

TREES: dict[Callable[..., object], str] = {
    rrt: "rrt",
    rrt_connect: "rrt_connect",
    rrt_star: "rrt_star",
}


class NodeCount:
    """Counts the nodes of all trees that a run has shown."""

    def __init__(self) -> None:
        self._sizes: dict[int, int] = {}

    def __call__(self, tree: GrowingTree) -> int:
        self._sizes[id(tree.nodes)] = int(tree.size[0])
        return sum(self._sizes.values())


def has_lines(planner: Callable[..., object]) -> bool:
    """Whether a race can show the lines of a planner: of a tree, or of a reader's own."""
    return planner in TREES or is_own(planner)


def follow_lines(
    planner: Callable[..., Any],
    runners: Sequence[Runner],
    leader: int,
    problem: ProblemRecord,
    given: Settings,
) -> list[Drawing]:
    """The drawings of a race in which a step is a line of one planner, the leader.

    The others have at each step as many nodes as the leader has, or have made as many queries.
    """
    run, lit = trace_leader(planner, problem, given)
    drawings = [retime_drawing(runner.drawing, run.steps) for runner in runners]
    grown = drawings[leader]
    beneath = [] if run.log else grown.layers  # the queries of a reader's planner are in `lit`
    text = get_message("board.code.planned", plan=grown.text, lines=lit.text)
    drawings[leader] = replace(lit, layers=[*beneath, *lit.layers], text=text, warning="")
    return drawings


def trace_leader(
    planner: Callable[..., Any], problem: ProblemRecord, given: Settings
) -> tuple[CodeRun, Drawing]:
    """The lines of a planner, and their drawing."""
    if planner not in TREES:
        run = CodeRun(planner, Look())
        return run, draw_attempt(try_planner(planner, problem, given.seed, run=run), None, run)
    function, look = CODE[TREES[planner]]
    count = {**look.names, "count_nodes": NodeCount()}
    look = replace(look, names=count, progress="count_nodes(tree)")
    run = trace_lines(
        function, look, lambda _: planner(problem, rng=given.seed, **tuning_of(given))
    )
    return run, run.draw()


def retime_drawing(drawing: Drawing, steps: Array) -> Drawing:
    """A drawing that is at its step `steps[k]` after line k; with the text that it has then."""
    own = stretch_growth(drawing, drawing.total).completed
    texts = [*own.step_texts, own.text]
    *now, last = [texts[min(int(step), own.total)] for step in (0.0, *steps)]
    return Drawing(
        [retime(layer, steps) for layer in own.layers],
        text=last,
        total=len(steps),
        unit=get_message("board.code.lines"),
        step_texts=now,
    )

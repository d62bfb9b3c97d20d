"""The lines of a car's planner that its board shows as they run."""

from collections.abc import Callable
from typing import Any

from ...planners.driving.kinodynamic_prm import drive_from_nearest
from ...planners.driving.kinodynamic_rrt import grow_by_driving
from ...planners.trees.rrt import grow
from ...problems import ProblemRecord
from ..tracing.code_run import CodeRun, Look, trace_lines

NEAR = {"near": "tree.nodes[q_near]", "new": "tree.nodes[tree.size[0] - 1]"}
MOST = 400  # lines: a line that tries twenty drives takes long until there is machine code
COLOURS = {"q_rand": "hit", "near": "path", "q_near": "path", "new": "robot", "q_new": "robot"}
CODE: dict[str, tuple[Callable[..., object], dict[str, str], str]] = {
    "rrt": (grow, {"q_near": "tree.nodes[near]"}, "tree.size[0] - 1"),
    "kinodynamic_rrt": (grow_by_driving, NEAR, "tree.size[0] - 1"),
    "kinodynamic_prm": (drive_from_nearest, NEAR, "tree.size[0] - 1"),
}


def trace_car_planner(
    name: str, problem: ProblemRecord, call: Callable[[Any], object], pace: float
) -> CodeRun:
    """The first lines of a planner, in a call with a car's problem.

    pace : how many steps of the board one edge of the tree takes.
    """
    function, poses, progress = CODE[name]
    points = {**poses, "nodes in tree": "tree.size[0]"}
    look = Look(
        points,
        most=MOST,
        robot=problem.robot,
        names={"pace": pace},
        colours=COLOURS,
        progress=f"pace * ({progress})",
        hidden=("apart",),
    )
    return trace_lines(function, look, lambda _: call(problem))

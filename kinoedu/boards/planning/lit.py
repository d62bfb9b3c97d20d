"""The lines of a planner that its board shows as they run, and what it draws of their variables."""

from collections.abc import Callable

from ...planners.roadmaps.connecting import join_in_order
from ...planners.trees.rrt import grow
from ...planners.trees.rrt_connect import extend
from ...planners.trees.rrt_star import grow_shortest
from ..tracing.code_run import Look

CODE: dict[str, tuple[Callable[..., object], Look]] = {
    "rrt": (grow, Look({"q_near": "tree.nodes[near]"}, lines=(("q_near", "q_rand"),))),
    "rrt_star": (
        grow_shortest,
        Look(
            {"q_nearest": "costs.tree.nodes[nearest]"},
            lines=(("q_nearest", "q_rand"),),
            circles={"q_new": "radii[tree.size[0]]"},
        ),
    ),
    "rrt_connect": (extend, Look({"q_near": "tree.nodes[near]"}, lines=(("q_near", "q"),))),
    "prm": (join_in_order, Look({"q_i": "nodes[i]", "q_j": "nodes[j]"}, lines=(("q_i", "q_j"),))),
}

"""The last edge of a tree: from a node near the goal to the goal."""

from ...compiled import callable_from_compiled
from ...problems.protocols import PlanningProblem
from ...spaces.buckets import GrowingTree, add


@callable_from_compiled
def join_goal(problem: PlanningProblem, tree: GrowingTree, node: int, step_size: float) -> int:
    """Append the goal below a node within one free step of it; returns the goal's node, or -1."""
    if problem.distance(tree.nodes[node], problem.goal) > step_size:
        return -1
    if not problem.is_free_path(tree.nodes[node], problem.goal):
        return -1
    return add(tree, problem.goal, node)

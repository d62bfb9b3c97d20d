"""The exercises of lesson 4: the judge's own mistaken searches, and the rules it tells apart."""

import pytest

from kinoedu.course import EXERCISES
from kinoedu.course.exercise import Case
from kinoedu.course.lessons.graphs.paths import find_path_fault
from kinoedu.course.lessons.shared import graph_slips


@pytest.mark.parametrize(
    "relax", [graph_slips.improve, graph_slips.overwrite, graph_slips.keep_closed]
)
def test_a_negative_cycle_does_not_keep_the_judge(relax):
    """Costs on a graph with a negative cycle are returned although they have no limit."""
    cost = graph_slips.dijkstra_costs([[1], [0, 2], []], [[-1.0], [-1.0, 5.0], []], 0, relax)
    assert len(cost) == 3
    assert max(cost) < float("inf")


def test_a_path_over_a_negative_cycle_is_none():
    """The parents form a cycle."""
    neighbours, weights = [[1], [0], []], [[-1.0], [-1.0], []]
    assert graph_slips.astar_path(neighbours, weights, [0.0] * 3, 0, 2) is None


NEIGHBOURS, WEIGHTS, ESTIMATE = [[1, 2], [2], []], [[1.0, 3.0], [1.0], []], [0.0, 3.0, 0.0]
RING = [[(u + 1) % 21] for u in range(21)]


@pytest.mark.parametrize(
    ("answer", "rule"),
    [
        (([], [], [], 0, 0), "valid"),
        ((RING, [[1.0]] * 21, [0.0] * 21, 0, 2), "valid"),
        ((NEIGHBOURS, WEIGHTS[:2], ESTIMATE, 0, 2), "valid"),
        ((NEIGHBOURS, WEIGHTS, ESTIMATE[:2], 0, 1), "valid"),
        ((NEIGHBOURS, WEIGHTS, [*ESTIMATE, 0.0], 0, 2), "valid"),
        ((NEIGHBOURS, WEIGHTS, ESTIMATE, 3, 2), "valid"),
        ((NEIGHBOURS, WEIGHTS, ESTIMATE, 0, -1), "valid"),
        ((NEIGHBOURS, WEIGHTS, ESTIMATE, 0, 3), "valid"),
        ((NEIGHBOURS, [[1.0], [1.0, 1.0], []], ESTIMATE, 0, 2), "valid"),
        (([[1, 3], [2], []], WEIGHTS, ESTIMATE, 0, 2), "valid"),
        (([[1, -1], [2], []], WEIGHTS, ESTIMATE, 0, 2), "valid"),
        (([[1, 0], [2], []], WEIGHTS, ESTIMATE, 0, 2), "valid"),
        (([[1, 1], [2], []], WEIGHTS, ESTIMATE, 0, 2), "valid"),
        ((NEIGHBOURS, [[1.0, -3.0], [1.0], []], ESTIMATE, 0, 2), "range"),
        ((NEIGHBOURS, WEIGHTS, [0.0, 2e6, 0.0], 0, 2), "range"),
        ((NEIGHBOURS, WEIGHTS, [0.0, float("nan"), 0.0], 0, 2), "range"),
        ((NEIGHBOURS, WEIGHTS, [0.0, 3.0, 0.5], 0, 2), "at_goal"),
        ((NEIGHBOURS, WEIGHTS, [0.0, 3.0, 0.0], 2, 0), "path"),
        ((NEIGHBOURS, WEIGHTS, [0.0, 1.0, 0.0], 0, 2), "misleads"),
        (([*NEIGHBOURS, []], [*WEIGHTS, []], [*ESTIMATE, 0.0], 0, 2), "smallest"),
        ((NEIGHBOURS, WEIGHTS, ESTIMATE, 0, 2), ""),
    ],
)
def test_a_graph_for_a_misleading_estimate_breaks_one_rule(answer, rule):
    """Lists that fit no graph are refused before A* runs; each other rule has its own answer."""
    exercise = EXERCISES["misleading_estimate"]
    verdict = exercise.value_verdict(Case("smallest", {}), answer)
    assert verdict.rule == rule
    assert verdict.is_right is (rule == "")


@pytest.mark.parametrize(
    ("path", "rule"),
    [
        ([0, 1, 2], ""),
        ([], "ends"),
        ([1, 2], "ends"),
        ([0, 1], "ends"),
        ([0, 2], "edge"),
        ([0, 3, 2], "edge"),
        ([0, -1, 2], "edge"),
        ([0, 1, 0, 1, 2], "one_way"),
        (None, "missing"),
    ],
)
def test_a_path_breaks_one_rule(path, rule):
    """Both ends count, each step is along an edge, and a wrong node is no error of the judge."""
    case = Case("directed", {"neighbours": [[1], [2], []], "start": 0, "goal": 2})
    assert find_path_fault(case, path, [0, 1, 2]) == rule

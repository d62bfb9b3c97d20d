"""The exercises of lesson 4: the judge's own mistaken searches."""

import pytest

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

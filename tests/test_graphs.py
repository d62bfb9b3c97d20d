"""Graphs and searches against networkx."""

import networkx as nx
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kinoedu.errors import InvalidGraph
from kinoedu.graphs import Graph, astar, dijkstra, extract_path
from kinoedu.graphs.search import expansions

graphs = st.integers(1, 12).flatmap(
    lambda n: st.tuples(
        st.just(n),
        st.lists(st.tuples(st.integers(0, n - 1), st.integers(0, n - 1), st.integers(0, 9)), max_size=40),
        st.booleans(),
    )
)


def both(n, rows, directed):
    """The same graph here and in networkx, where parallel edges keep the least weight."""
    graph = Graph(n, [row[:2] for row in rows], [row[2] for row in rows], directed=directed)
    other = nx.DiGraph() if directed else nx.Graph()
    other.add_nodes_from(range(n))
    for u, v, w in rows:
        if not other.has_edge(u, v) or other[u][v]["weight"] > w:
            other.add_edge(u, v, weight=w)
    return graph, other


@given(graphs)
@settings(derandomize=True, deadline=None, max_examples=200)
def test_dijkstra_costs_equal_networkx(case):
    """Costs equal, and each parent's cost plus an edge makes the child's."""
    graph, other = both(*case)
    found = dijkstra(graph, 0)
    expected = nx.single_source_dijkstra_path_length(other, 0)
    assert [found.cost[u] for u in range(case[0])] == [expected.get(u, np.inf) for u in range(case[0])]
    for u in expected:
        path = extract_path(found.parent, u)
        assert path[0] == 0
        assert sum(other[a][b]["weight"] for a, b in zip(path[:-1], path[1:], strict=True)) == expected[u]
    assert sorted(found.expanded) == sorted(expected)


@given(graphs, st.data())
@settings(derandomize=True, deadline=None, max_examples=200)
def test_astar_with_any_admissible_estimate_is_optimal(case, data):
    """Also where the estimate is not consistent, so that nodes are expanded again."""
    n, rows, directed = case
    graph, other = both(n, rows, directed)
    goal = data.draw(st.integers(0, n - 1))
    left = nx.single_source_dijkstra_path_length(other.reverse() if directed else other, goal)
    share = data.draw(st.lists(st.floats(0, 1), min_size=n, max_size=n))
    estimate = [share[u] * left.get(u, 100.0) for u in range(n)]
    path, found = astar(graph, 0, goal, estimate)
    if 0 not in left:
        assert path is None
    else:
        assert found.cost[goal] == left[0]
        assert path[0] == 0
        assert path[-1] == goal


def test_expansions_can_be_stepped():
    """The generator behind the searches yields one node after another, with the costs filled in so far."""
    graph = Graph(3, [(0, 1), (1, 2)], [1.0, 2.0])
    cost, parent = np.full(3, np.inf), np.full(3, -1)
    steps = expansions(graph, 0, -1, np.zeros(3), cost, parent)
    assert next(steps) == 0
    assert next(steps) == 1
    assert cost.tolist() == [0.0, 1.0, np.inf] or cost.tolist() == [0.0, 1.0, 3.0]
    assert list(steps) == [2]


def test_interpreted_search_is_the_same():
    """The Python the search was compiled from gives the same order, costs and parents."""
    from kinoedu.graphs.search import search

    rng = np.random.default_rng(0)
    graph = Graph(60, rng.integers(0, 60, (200, 2)), rng.random(200))
    for fast, slow in zip(search(graph, 0, -1, np.zeros(60)), search.py_func(graph, 0, -1, np.zeros(60)), strict=True):
        assert np.array_equal(fast, slow)


@pytest.mark.parametrize(
    "arguments",
    [
        (3, [(0, 3)]),
        (3, [(-1, 0)]),
        (3, [(0, 1)], [-1.0]),
        (3, [(0, 1)], [np.nan]),
        (3, [(0, 1)], [1.0, 2.0]),
        (3, [0, 1, 2]),
        (3, [(0.5, 1)]),
    ],
)
def test_bad_graphs_are_refused(arguments):
    """Edges to nodes that are not there, negative or missing weights, shapes that are no edges."""
    with pytest.raises(InvalidGraph):
        Graph(*arguments)


@pytest.mark.parametrize("node", [-1, 3, True, 1.0, "0"])
def test_a_search_from_no_node_is_refused(node):
    """Start and goal must be nodes."""
    with pytest.raises(InvalidGraph):
        dijkstra(Graph(3, [(0, 1)]), node)


def test_parents_in_a_circle_are_refused():
    """extract_path ends on any input."""
    with pytest.raises(InvalidGraph):
        extract_path([1, 0], 0)

"""Graphs and searches against networkx."""

import networkx as nx
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import kinoedu as ke
from kinoedu.errors import InvalidGraph, InvalidPoint
from kinoedu.graphs import (
    Graph,
    astar,
    astar_expansions,
    bfs,
    bfs_expansions,
    bfs_path,
    bfs_tree,
    dfs,
    dfs_expansions,
    dfs_path,
    dijkstra,
    dijkstra_expansions,
    extract_path,
    flat_graph,
)
from kinoedu.graphs.bfs import search_breadth_first
from kinoedu.graphs.components import label_components
from kinoedu.graphs.dfs import search_depth_first
from kinoedu.graphs.search import begin_search, search

graphs = st.integers(1, 12).flatmap(
    lambda n: st.tuples(
        st.just(n),
        st.lists(
            st.tuples(st.integers(0, n - 1), st.integers(0, n - 1), st.integers(0, 9)), max_size=40
        ),
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
    assert [found.cost[u] for u in range(case[0])] == [
        expected.get(u, np.inf) for u in range(case[0])
    ]
    for u in expected:
        path = extract_path(found.parent, u)
        assert path[0] == 0
        assert (
            sum(other[a][b]["weight"] for a, b in zip(path[:-1], path[1:], strict=True))
            == expected[u]
        )
    assert sorted(found.expanded) == sorted(expected)


@pytest.mark.parametrize("n", [33, 34, 50, 100, 200, 5000])
def test_dijkstra_reaches_the_end_of_a_tree_of_any_size(n):
    """Each node waits once, so none waits any more when the last one is expanded; and a star, whose
    nodes all wait together.
    """
    rows = np.stack([np.arange(n - 1), np.arange(1, n)], axis=1)
    assert np.array_equal(dijkstra(Graph(n, rows, np.ones(n - 1)), 0).cost, np.arange(n))
    star = dijkstra(Graph(n, [(0, leaf) for leaf in range(1, n)], np.ones(n - 1)), 0)
    assert star.cost.sum() == n - 1 and star.steps.nodes == n


@given(graphs, st.data())
@settings(derandomize=True, deadline=None, max_examples=200)
def test_astar_with_any_admissible_estimate_is_optimal(case, data):
    """The path is optimal also where the heuristic is not consistent."""
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


def test_interpreted_search_is_the_same():
    """The Python the searches were compiled from gives the same order, costs, parents and
    counts.
    """
    rng = np.random.default_rng(0)
    for directed in (False, True):
        graph = Graph(60, rng.integers(0, 60, (150, 2)), rng.random(150), directed=directed).flat()
        for goal, heuristic in ((-1, np.zeros(60)), (7, rng.random(60))):
            fast, slow = (
                (*run(graph, goal, heuristic, labels, queue), *labels)
                for run, (labels, queue) in (
                    (search, begin_search(60, 0, heuristic)),
                    (search.py_func, begin_search(60, 0, heuristic)),
                )
            )
            assert all(map(np.array_equal, fast, slow))
        calls = [(label_components, (graph, 60))]
        for goal in (-1, 7):
            calls += [
                (search_breadth_first, (graph, 60, 0, goal)),
                (search_depth_first, (graph, 60, 0, goal)),
            ]
        for function, arguments in calls:
            fast, slow = function(*arguments), function.py_func(*arguments)
            for a, b in zip(fast, slow) if isinstance(fast, tuple) else [(fast, slow)]:
                assert np.array_equal(a, b)


@pytest.mark.parametrize(
    "arguments",
    [
        (3, [(0, 3)]),
        (3, [(-1, 0)]),
        (3, [(0, 1)], [-1.0]),
        (3, [(0, 1)], [np.nan]),
        (3, [(0, 1)], [1.0, 2.0]),
        (3, [(0, 1)], [np.inf]),
        (3, [(0, 1)], [None]),
        (3, [(0, 1)], ["1"]),
        (3, [(0, 1), (1, 2)], [1.0, [2.0]]),
        (3, [0, 1, 2]),
        (3, [(0.5, 1)]),
        (3, [(0, 1), (1,)]),
        (3, [(0, np.nan)]),
        (3, [(0, 10**30)]),
        (3, [(True, False)]),
        (3, [[(0, 1)]]),
        (0, [(0, 0)]),
        (-1,),
        (2.0,),
        (True,),
        ([(0, 0), (1, 1)],),
    ],
)
def test_bad_graphs_are_refused(arguments):
    """Edges to nodes that are not there, negative, infinite or missing weights, shapes that are no
    edges, sizes that are none.
    """
    with pytest.raises(InvalidGraph):
        Graph(*arguments)


@pytest.mark.parametrize("node", [-1, 3, True, 1.0, "0", None, 1])
def test_a_node_that_is_not_there_is_refused(node):
    """Every search and method names the argument; node 1 was deleted."""
    graph = Graph(3, [(0, 1)], directed=True)
    graph.delete_node(1)
    for ask in (
        *(
            lambda f=f: f(graph, node)
            for f in (
                dijkstra,
                bfs_tree,
                bfs,
                dfs,
                bfs_expansions,
                dfs_expansions,
                dijkstra_expansions,
            )
        ),
        *(lambda f=f: f(graph, node, 0) for f in (bfs_path, dfs_path, astar, astar_expansions)),
    ):
        with pytest.raises(InvalidGraph, match="start must be a node"):
            ask()
    for f in (bfs_path, dfs_path, astar, astar_expansions):
        if node is not None:
            with pytest.raises(InvalidGraph, match="goal must be a node"):
                f(graph, 0, node)
    for ask in (graph.neighbours, graph.degree, graph.delete_node):
        with pytest.raises(InvalidGraph, match="u must be a node"):
            ask(node)
    for ask in (graph.is_edge, graph.weight, graph.edge_data, graph.delete_edge, graph.add_edge):
        with pytest.raises(InvalidGraph, match="v must be a node"):
            ask(0, node)
    with pytest.raises(InvalidGraph, match="goal must be a node"):
        graph.cost_to_go(node)
    assert node not in graph


def test_a_deleted_node_is_refused_as_deleted():
    """The message says that the node was deleted."""
    graph = Graph(2)
    graph.delete_node(1)
    with pytest.raises(InvalidGraph, match="got 1, which was deleted"):
        graph.degree(1)


@pytest.mark.parametrize("search_of", [dijkstra, bfs_tree, dfs])
@pytest.mark.parametrize(
    "graph", [nx.path_graph(3), [[0, 1]], None, (0, 1), np.eye(3)], ids=lambda g: type(g).__name__
)
def test_what_is_no_graph_is_refused(search_of, graph):
    """Other libraries' graphs and matrices are named in the refusal."""
    with pytest.raises(InvalidGraph, match="expected a Graph"):
        search_of(graph, 0)


@pytest.mark.parametrize(
    "estimate",
    [
        [0.0],
        [0.0, np.nan, 0.0],
        [0.0, -1.0, 0.0],
        "abc",
        [[0.0]] * 3,
        begin_search(3, 0, np.zeros(3))[0],
    ],
)
def test_a_bad_heuristic_is_refused(estimate):
    """The heuristic must be a number of zero or more for each node."""
    with pytest.raises(InvalidGraph, match="heuristic"):
        astar(Graph(3, [(0, 1)]), 0, 1, estimate)


def test_parents_in_a_circle_are_refused():
    """extract_path terminates on any input."""
    with pytest.raises(InvalidGraph):
        extract_path([1, 0], 0)


@pytest.mark.parametrize(
    ("parent", "said"),
    [
        ([1, 0], "from node 1 to a root.*form a cycle"),
        ([0, 0], "form a cycle"),
        ([-1, 7], "lead to 7, no node"),
        ([-2, 0], "lead to -2, no node"),
        ([None, 0], r"-1 where there is none, got \[None, 0\]"),
        ([np.nan, 0], "whole numbers"),
        ([np.inf, 0], "whole numbers"),
        ([-1, 0.5], "whole numbers"),
        (["a", "b"], "whole numbers"),
    ],
)
def test_parents_without_a_root_are_refused_with_the_reason(parent, said):
    """The message says what parents must be: a program may use None, or the root itself, for -1."""
    with pytest.raises(InvalidGraph, match=said):
        extract_path(parent, 1)


def test_parents_may_be_whole_floats():
    """An array that numpy has made of floats gives the same path, as numbers."""
    assert extract_path(np.array([-1.0, 0.0, 1.0]), 2).tolist() == [0, 1, 2]


@pytest.mark.parametrize("goal", [-1, 2, True, 0.0])
def test_a_path_to_no_node_is_refused(goal):
    """extract_path does not accept negative indices."""
    with pytest.raises(InvalidGraph):
        extract_path([-1, 0], goal)


def edge_list(graph):
    """Edges with weights, undirected ones with the lesser node first, in increasing order."""
    pairs = graph.edges if graph.directed else np.sort(graph.edges, axis=1)
    return sorted((int(u), int(v), float(w)) for (u, v), w in zip(pairs, graph.weights))


@given(graphs, st.data())
@settings(derandomize=True, deadline=None, max_examples=200)
def test_breadth_first_distances_equal_networkx(case, data):
    """bfs counts the fewest edges, its tree and its path have as many, and its order never goes
    back nearer.
    """
    graph, other = both(*case)
    goal = data.draw(st.integers(0, case[0] - 1))
    expected = nx.single_source_shortest_path_length(other, 0)
    found, parents, path = bfs(graph, 0), bfs_tree(graph, 0), bfs_path(graph, 0, goal)
    assert [found.cost[u] for u in range(case[0])] == [
        expected.get(u, np.inf) for u in range(case[0])
    ]
    for u in expected:
        along = extract_path(parents, u).tolist()
        assert along[0] == 0 and len(along) == expected[u] + 1
        assert all(other.has_edge(a, b) for a, b in zip(along[:-1], along[1:]))
    assert all(parents[u] == -1 for u in range(case[0]) if u == 0 or u not in expected)
    assert (np.diff(found.cost[found.expanded]) >= 0).all() and sorted(found.expanded) == sorted(
        expected
    )
    assert (None if path is None else path.tolist()) == (
        extract_path(parents, goal).tolist() if goal in expected else None
    )


def recursive_depth_first(graph, v, parent, order):
    """The textbook's recursion."""
    order.append(v)
    for u in graph.neighbours(v).tolist():
        if u not in parent:
            parent[u] = v
            recursive_depth_first(graph, u, parent, order)


@given(graphs, st.data())
@settings(derandomize=True, deadline=None, max_examples=200)
def test_depth_first_equals_the_recursion(case, data):
    """The same order and parents, and a path exactly where one exists, each edge of it in the graph
    and no node twice.
    """
    graph, other = both(*case)
    parent, order, goal = {0: -1}, [], data.draw(st.integers(0, case[0] - 1))
    recursive_depth_first(graph, 0, parent, order)
    found, path = dfs(graph, 0), dfs_path(graph, 0, goal)
    assert found.expanded.tolist() == order
    assert found.parent.tolist() == [parent.get(u, -1) for u in range(case[0])]
    assert [u for u in range(case[0]) if np.isfinite(found.cost[u])] == sorted(order)
    assert (path is not None) == nx.has_path(other, 0, goal)
    if path is not None:
        assert (
            path[0] == 0
            and path[-1] == goal
            and len(set(path.tolist())) == len(path) == found.cost[goal] + 1
        )
        assert all(other.has_edge(a, b) for a, b in zip(path[:-1], path[1:]))


def test_depth_first_needs_no_stack_of_calls():
    """A path of 100,000 nodes is no deeper for Python than one of ten."""
    n = 100_000
    line = np.column_stack([np.arange(n - 1), np.arange(1, n)])
    assert dfs(Graph(n, line), 0).cost[-1] == n - 1


@given(graphs, st.data())
@settings(derandomize=True, deadline=None, max_examples=100)
def test_expansions_drained_are_the_plain_search(case, data):
    """The generators take out the nodes of the plain function, and end with its costs and parents;
    also with a goal.
    """
    graph, _ = both(*case)
    goal = data.draw(st.integers(0, case[0] - 1))
    for plain, moments in (
        (dijkstra(graph, 0), dijkstra_expansions(graph, 0)),
        (astar(graph, 0, goal)[1], astar_expansions(graph, 0, goal)),
        *(
            (f(graph, 0, to), g(graph, 0, to))
            for f, g in ((bfs, bfs_expansions), (dfs, dfs_expansions))
            for to in (None, goal)
        ),
    ):
        drained = list(moments)
        assert [moment.node for moment in drained] == plain.expanded.tolist()
        assert [moment.expanded.tolist() for moment in drained] == [
            plain.expanded[:i].tolist() for i in range(len(drained))
        ]
        assert plain.steps.nodes == len(drained)
        assert np.array_equal(drained[-1].cost, plain.cost) and np.array_equal(
            drained[-1].parent, plain.parent
        )


@given(graphs)
@settings(derandomize=True, deadline=None, max_examples=100)
def test_a_frontier_holds_what_was_seen_and_waits(case):
    """Queues: seen and not expanded, in the order of the search. A stack: the path to the node,
    backwards.
    """
    graph, _ = both(*case)
    for moments in (list(bfs_expansions(graph, 0)), list(dijkstra_expansions(graph, 0))):
        for moment, after in zip(moments, [*moments[1:], None]):
            taken = {*moment.expanded.tolist(), moment.node}
            seen = set(np.flatnonzero(np.isfinite(moment.cost)).tolist())
            assert set(moment.frontier.tolist()) == seen - taken and len(
                set(moment.frontier.tolist())
            ) == len(moment.frontier)
            assert (np.diff(moment.cost[moment.frontier]) >= 0).all()
            news = (
                []
                if after is None
                else [u for u in [after.node, *after.frontier] if u not in moment.frontier]
            )
            assert all(after.parent[u] == moment.node for u in news)
    for moment in dfs_expansions(graph, 0):
        assert [*moment.frontier[::-1], moment.node] == extract_path(
            moment.parent, moment.node
        ).tolist()


@given(graphs, st.lists(st.integers(0, 9), min_size=12, max_size=12))
@settings(derandomize=True, deadline=None, max_examples=100)
def test_the_first_of_the_frontier_is_next(case, estimate):
    """It is expanded next, unless the search has just found a better path to another node."""
    graph, _ = both(*case)
    for moments in (
        bfs_expansions(graph, 0),
        astar_expansions(graph, 0, case[0] - 1, estimate[: case[0]]),
    ):
        drained = list(moments)
        for moment, after in zip(drained, drained[1:]):
            better = after.cost[after.node] < moment.cost[after.node]
            assert better or after.node == moment.frontier[0]


def test_a_node_that_is_expanded_again_waits_again():
    """With a heuristic that is not consistent A* puts an expanded node back into the frontier."""
    graph = Graph(5, [(0, 1), (0, 2), (2, 1), (1, 3), (2, 4)], [3.0, 1.0, 1.0, 10.0, 0.5])
    moments = list(astar_expansions(graph, 0, 3, [0.0, 0.0, 9.0, 0.0, 0.0]))
    assert [moment.node for moment in moments] == [0, 1, 2, 4, 1, 3]
    assert [moment.frontier.tolist() for moment in moments] == [[], [2], [3], [1, 3], [3], []]
    assert moments[2].expanded.tolist() == [0, 1] and moments[5].cost[3] == 12.0


def test_moments_stay_as_they_were():
    """The arrays of an expansion are not overwritten by the next one."""
    moments = list(bfs_expansions(Graph(3, [(0, 1), (1, 2)]), 0))
    assert [np.isfinite(moment.cost).sum() for moment in moments] == [1, 2, 3]


def test_steps_count_nodes_and_edges():
    """By hand on a square with a diagonal: undirected edges are looked at from both ends, none at
    the goal.
    """
    graph = Graph(4, [(0, 1), (1, 2), (2, 3), (3, 0), (0, 2)])
    assert bfs(graph, 0).steps == dfs(graph, 0).steps == dijkstra(graph, 0).steps == (4, 10)
    assert bfs(graph, 0, 2).steps == (3, 3 + 2)  # 0 and 1, then 2
    assert dfs(graph, 0, 2).steps == (3, 1 + 2)  # 0: to 1; 1: to 0 and to 2
    assert astar(graph, 0, 2)[1].steps == (3, 3 + 2)
    assert bfs(graph, 1, 1).steps == dfs(graph, 1, 1).steps == astar(graph, 1, 1)[1].steps == (1, 0)


def test_searches_run_on_grids():
    """Any kind that answers degree and edge: breadth-first search finds the Manhattan distance
    where no move is diagonal.
    """
    from kinoedu.planners.grids.grid import Cells, Grid

    free = np.zeros((5, 5), bool)
    free[1:-1, 1:-1] = [[1, 1, 1], [1, 0, 1], [1, 1, 1]]
    grid = Grid(Cells(free.ravel()), 0.0, 0.0, 1.0, 5, 5)
    first, middle, last = 6, 12, 18
    assert bfs(grid, first).cost.reshape(5, 5)[1:-1, 1:-1].tolist() == [
        [0, 1, 2],
        [1, np.inf, 3],
        [2, 3, 4],
    ]
    assert len(dfs_path(grid, first, last)) >= 5
    assert [m.node for m in bfs_expansions(grid, first)] == bfs(grid, first).expanded.tolist()
    assert bfs_path(grid, first, middle) is None and dfs_path(grid, first, middle) is None


@given(graphs)
@settings(derandomize=True, deadline=None, max_examples=200)
def test_what_a_graph_knows_equals_networkx(case):
    """Neighbours, degrees, edges, least weights, components (weak ones of a directed graph)."""
    n, rows, directed = case
    graph, other = both(*case)
    multi = (nx.MultiDiGraph if directed else nx.MultiGraph)([row[:2] for row in rows])
    multi.add_nodes_from(range(n))
    for u in range(n):
        assert graph.neighbours(u).tolist() == sorted(other.neighbors(u))
        assert graph.degree(u) == (multi.out_degree(u) if directed else multi.degree(u))
        for v in range(n):
            assert graph.is_edge(u, v) == other.has_edge(u, v)
            if other.has_edge(u, v):
                assert graph.weight(u, v) == other[u][v]["weight"]
    parts = nx.weakly_connected_components(other) if directed else nx.connected_components(other)
    assert [part.tolist() for part in graph.components()] == sorted(sorted(part) for part in parts)


@given(graphs)
@settings(derandomize=True, deadline=None, max_examples=200)
def test_matrices_equal_networkx(case):
    """Adjacency, Laplacian and oriented incidence (networkx: -1 where an edge leaves), weighted and
    not; L = B W B^T.
    """
    n, rows, directed = case
    graph = Graph(n, [row[:2] for row in rows], [row[2] for row in rows], directed=directed)
    other = nx.MultiDiGraph() if directed else nx.MultiGraph()
    other.add_nodes_from(range(n))
    other.add_weighted_edges_from(rows)
    for weighted, name in ((True, "weight"), (False, None)):
        a = nx.to_numpy_array(other, weight=name)
        assert np.array_equal(graph.adjacency(weighted=weighted).toarray(), a)
        assert np.array_equal(
            graph.laplacian(weighted=weighted).toarray(), np.diag(a.sum(axis=1)) - a
        )
    numbered = nx.MultiDiGraph([(u, v, i) for i, (u, v, _) in enumerate(rows)])
    b = graph.incidence().toarray()
    if rows:
        edges = [(u, v, i) for i, (u, v, _) in enumerate(rows)]
        columns = nx.incidence_matrix(numbered, sorted(numbered), edges, oriented=True).toarray()
        assert np.array_equal(b[sorted(numbered)], -columns)
    assert b.shape == (n, len(rows)) and np.array_equal(b.sum(axis=0), np.zeros(len(rows)))
    laplacian = graph.laplacian().toarray()
    assert np.array_equal(laplacian.sum(axis=1), np.zeros(n))
    if not directed:
        assert np.array_equal(b @ np.diag([row[2] for row in rows]) @ b.T, laplacian)
        unweighted = graph.laplacian(weighted=False).toarray()
        assert n - np.linalg.matrix_rank(unweighted) == len(graph.components())


def test_a_directed_laplacian_counts_what_leaves():
    """One edge from 0 to 1: D has the out-degrees."""
    graph = Graph(2, [(0, 1)], [5.0], directed=True)
    assert graph.laplacian().toarray().tolist() == [[5.0, -5.0], [0.0, 0.0]]
    assert graph.incidence().toarray().tolist() == [[1.0], [-1.0]]


@given(graphs, st.data())
@settings(derandomize=True, deadline=None, max_examples=200)
def test_cost_to_go_is_the_cost_of_going(case, data):
    """Equal to networkx on the reversed graph, and to Dijkstra's algorithm from each node."""
    graph, other = both(*case)
    goal = data.draw(st.integers(0, case[0] - 1))
    left = nx.single_source_dijkstra_path_length(other.reverse() if case[2] else other, goal)
    assert graph.cost_to_go(goal).tolist() == [left.get(u, np.inf) for u in range(case[0])]
    assert graph.cost_to_go(goal).tolist() == [
        dijkstra(graph, u).cost[goal] for u in range(case[0])
    ]


changes = st.lists(
    st.tuples(
        st.sampled_from(["node", "edge", "edge", "edge", "no node", "no edge"]),
        *[st.integers(0, 11)] * 3,
    ),
    max_size=40,
)


@given(st.booleans(), st.integers(0, 4), changes)
@settings(derandomize=True, deadline=None, max_examples=200)
def test_a_graph_that_grows_and_shrinks_equals_networkx(directed, size, changes):
    """Any sequence of additions and deletions leaves the nodes, edges, weights, data and answers of
    a multigraph of networkx.
    """
    graph, other = (
        Graph(size, directed=directed),
        (nx.MultiDiGraph if directed else nx.MultiGraph)(),
    )
    other.add_nodes_from(range(size), data=None)
    for number, (what, *given_nodes, weight) in enumerate(changes):
        u, v = (node % max(graph.size, 1) for node in given_nodes)
        if what == "node":
            assert graph.add_node(data=number) == graph.size - 1
            other.add_node(graph.size - 1, data=number)
        elif what == "no node" and u in other:
            graph.delete_node(u)
            other.remove_node(u)
        elif what == "edge" and u in other and v in other:
            graph.add_edge(u, v, weight, data=number)
            other.add_edge(u, v, weight=float(weight), data=number)
        elif what == "no edge" and other.has_edge(u, v):
            graph.delete_edge(u, v)
            other.remove_edges_from([(u, v)] * other.number_of_edges(u, v))
        elif u in other and number % 3 == 0:
            graph.neighbours(
                u
            )  # so that what is kept for searches must be noticed to be out of date
        assert list(graph) == sorted(other) and len(graph) == len(other)
    ends = [(u, v) if directed else (min(u, v), max(u, v)) for u, v, _ in other.edges]
    assert edge_list(graph) == sorted(
        (u, v, other.edges[e]["weight"]) for (u, v), e in zip(ends, other.edges)
    )
    assert [graph.node_data[u] for u in graph] == [other.nodes[u]["data"] for u in sorted(other)]
    for u, v in ends:
        between = sorted(
            (other.edges[e]["weight"], other.edges[e]["data"])
            for e in other.edges
            if set(e[:2]) == {u, v} and (not directed or e[:2] == (u, v))
        )
        assert (graph.weight(u, v), graph.edge_data(u, v)) == between[0]
    for u in graph:
        assert graph.neighbours(u).tolist() == sorted(set(other.neighbors(u)))
        assert {v for v in graph if np.isfinite(dijkstra(graph, u).cost[v])} == nx.descendants(
            other, u
        ) | {u}
    parts = nx.weakly_connected_components(other) if directed else nx.connected_components(other)
    assert [part.tolist() for part in graph.components()] == sorted(sorted(part) for part in parts)


def test_a_grown_graph_is_the_one_made_in_one_go():
    """The same records, so the same searches; and what was handed in or out is not shared."""
    rng = np.random.default_rng(3)
    nodes, pairs = rng.random((30, 2)), rng.integers(0, 30, (70, 2))
    whole, grown = Graph(nodes=nodes, edges=pairs), Graph(nodes=[])
    for q in nodes:
        grown.add_node(q)
    for u, v in pairs:
        grown.add_edge(u, v)
    for a, b in zip(whole.flat(), grown.flat()):
        assert np.array_equal(a, b)
    for array in (nodes, pairs, whole.nodes, whole.edges, whole.weights):
        array[:] = 0
    assert np.array_equal(whole.nodes, grown.nodes) and np.array_equal(whole.edges, grown.edges)
    assert whole.flat() is whole.flat()


def test_a_record_made_by_a_planner_is_the_graphs_own():
    """flat_graph and Graph agree, array by array and type by type: nothing compiles twice."""
    pairs, weights = np.array([(2, 0), (0, 1), (1, 2)]), np.array([1.0, 2.0, 3.0])
    for directed in (False, True):
        ours = Graph(3, np.asfortranarray(pairs), weights, directed=directed).flat()
        for a, b in zip(ours, flat_graph(3, pairs, weights, directed=directed)):
            assert np.array_equal(a, b) and np.asarray(a).dtype == np.asarray(b).dtype
            assert [
                getattr(np.asarray(x).flags, f)
                for x in (a, b)
                for f in ("c_contiguous", "writeable")
            ] == [True] * 4


@given(st.integers(1, 3), st.data())
@settings(derandomize=True, deadline=None, max_examples=100)
def test_closest_is_the_least_distance(d, data):
    """In one to three dimensions, the first among equals, deleted nodes left out."""
    coordinates = st.lists(st.integers(-5, 5), min_size=d, max_size=d)
    nodes, q = data.draw(st.lists(coordinates, min_size=2, max_size=9)), data.draw(coordinates)
    graph = Graph(nodes=nodes)
    gone = data.draw(st.integers(0, len(nodes) - 1))
    graph.delete_node(gone)
    apart = np.sqrt(((np.array(nodes) - q) ** 2).sum(axis=1))
    apart[gone] = np.inf
    assert np.allclose(graph.distances(q), apart, rtol=1e-12)
    node, least = graph.closest(q)
    assert (
        node != gone
        and least == pytest.approx(apart.min())
        and node == np.flatnonzero(np.isclose(apart, apart.min()))[0]
    )


def test_a_record_names_its_nodes_from_0():
    """A record that can be searched, here the flat graph, refuses the numbers before and after."""
    record = Graph(3, [(0, 1)]).flat()
    assert dijkstra(record, 2).cost.tolist() == [np.inf, np.inf, 0.0]
    for node in (-1, 3):
        with pytest.raises(InvalidGraph, match="start must be a node from 0 to 2"):
            dijkstra(record, node)


def test_the_metric_is_the_spaces():
    """Weights, distances and the closest node by a space of the reader's own, here the long way of
    a taxi.
    """
    from typing import NamedTuple

    from kinoedu.spaces import distance

    class Taxi(NamedTuple):
        lo: np.ndarray
        hi: np.ndarray

    @distance.register(Taxi)
    def taxi(space, a, b):
        total = 0.0
        for i in range(len(a)):
            total += abs(a[i] - b[i])
        return total

    graph = Graph(nodes=[(0, 0), (3, 4)], edges=[(0, 1)], space=Taxi(np.zeros(2), np.ones(2)))
    assert graph.add_node((1, 1)) == 2
    graph.add_edge(2, 1)
    assert (
        graph.weights.tolist() == [7.0, 5.0]
        and graph.closest((3, 0)) == (0, 3.0)
        and graph.distances((3, 0)).tolist() == [3, 4, 3]
    )
    with pytest.raises(InvalidPoint):
        Graph(nodes=[(0, 0, 0)], space=graph.space)


def test_a_graph_in_no_space_knows_no_distances():
    """And refuses places; an embedded one wants them, of its own shape."""
    for ask in (
        lambda g: g.distances((0, 0)),
        lambda g: g.closest((0, 0)),
        lambda g: g.nodes,
        lambda g: g.add_node((0, 0)),
    ):
        with pytest.raises(InvalidGraph, match="position"):
            ask(Graph(2))
    embedded = Graph(nodes=[(0, 0)])
    with pytest.raises(InvalidPoint, match="needs its position q"):
        embedded.add_node()
    with pytest.raises(InvalidGraph, match="give positions as nodes="):
        Graph([(0, 0), (1, 1)])
    for ask in (
        embedded.add_node,
        lambda: embedded.add_node((1,)),
        lambda: embedded.distances((1, 2, 3)),
        lambda: Graph(nodes=[1]),
        lambda: Graph(nodes=np.empty((0, 2, 2))),
    ):
        with pytest.raises(InvalidPoint):
            ask()
    with pytest.raises(InvalidGraph, match="closest"):
        Graph(nodes=[]).closest((0, 0))
    with pytest.raises(InvalidGraph, match="as many positions"):
        Graph(3, nodes=[(0, 0)])
    assert len(embedded) == 1


def test_what_is_refused_changes_nothing():
    """A graph stays as it was after an error."""
    graph = Graph(3, [(0, 1)])
    for change in (
        lambda: graph.add_edge(0, 1, -1.0),
        lambda: graph.delete_edge(1, 2),
        lambda: graph.add_edge(0, 1, np.nan),
    ):
        with pytest.raises(InvalidGraph):
            change()
    assert edge_list(graph) == [(0, 1, 1.0)] and repr(graph) == "<Graph: 3 nodes, 1 edges>"


def test_astar_on_an_embedded_graph_expands_less():
    """Distances to the goal are lower bounds, so the path costs the same for less work."""
    rng = np.random.default_rng(5)
    nodes = rng.random((300, 2))
    near = np.argwhere(np.triu(np.linalg.norm(nodes[:, None] - nodes, axis=2) < 0.12, 1))
    graph = Graph(nodes=nodes, edges=near)
    _, blind = astar(graph, 0, 1)
    path, guided = astar(graph, 0, 1, graph.distances(nodes[1]))
    assert guided.cost[1] == blind.cost[1] == graph.cost_to_go(0)[1] or guided.cost[
        1
    ] == pytest.approx(blind.cost[1])
    assert guided.steps.nodes < blind.steps.nodes and path is not None


def test_a_search_is_stepped_interpreted_and_drained_as_machine_code(tmp_path):
    """numba cannot load compiled generators from the disk: Python steps them, and machine code has
    its own inside.
    """
    import os
    import subprocess
    import sys

    make = (
        "import numpy as np; from kinoedu.graphs import Graph, bfs; from kinoedu.graphs.bfs "
        "import breadth_first; "
    )
    steps = "breadth_first(Graph(1).flat(), 0, -1, np.zeros(1), np.zeros(1, int), np.zeros(1, int))"
    for code in (f"print([int(u) for u in {steps}])", "print(bfs(Graph(1), 0).expanded)"):
        run = subprocess.run(
            [sys.executable, "-c", make + code],
            env={**os.environ, "KINOEDU_CACHE": str(tmp_path), "KINOEDU_MACHINE_CODE": "first"},
            capture_output=True, text=True, timeout=300,
        )  # fmt: skip
        assert (run.returncode, run.stdout) == (0, "[0]\n"), run.stderr


def test_pictures_show_every_state():
    """draw_graph and draw_search draw arrows, rings, weights and markers, and leave the graph as it
    was.
    """
    import matplotlib.pyplot as plt

    from kinoedu.figures import draw_graph, draw_search

    graph = Graph(
        nodes=[(0, 0), (1, 0), (0, 1), (2, 2)],
        edges=[(0, 1), (1, 0), (1, 2), (2, 2)],
        directed=True,
    )
    artists = draw_graph(
        graph,
        weights=True,
        path=[0, 1, 2],
        highlight=3,
        highlight_edges=[(1, 2)],
        parents=[-1, 0, 1, -1],
    )
    assert artists and {text.get_text() for text in plt.gca().texts} >= {"0", "1", "2", "3", "1.41"}
    plt.close()
    for moment in bfs_expansions(graph, 0):
        _, ax = plt.subplots()
        assert draw_search(moment, graph, ax, costs=True, weights=True)
        markers = {line.get_marker() for line in ax.lines if len(line.get_xdata()) == 1}
        assert markers >= {"H", "o"} and (len(moment.expanded) == 0) == ("s" not in markers)
        assert (len(moment.frontier) == 0) == ("D" not in markers)
        plt.close()
    graph.delete_node(0)
    for empty in (
        graph,
        Graph(0),
        Graph(3, [(0, 1)]),
        Graph(nodes=[[0.0], [1.0]], edges=[(0, 1)]),
        Graph(nodes=np.ones((99, 3))),
    ):
        draw_graph(empty)
        plt.close()


def test_public_names_are_at_the_top():
    """The names that notebooks rely on."""
    assert (ke.Graph, ke.bfs_tree, ke.bfs_path, ke.dfs_path, ke.dijkstra, ke.astar) == (
        Graph,
        bfs_tree,
        bfs_path,
        dfs_path,
        dijkstra,
        astar,
    )


def test_a_bound_of_minus_zero_is_zero():
    """Its bits are those of a large negative number."""
    graph = ke.Graph(4, [(0, 1), (0, 2), (1, 3), (2, 3)], [1.0, 5.0, 1.0, 5.0])
    path, _ = ke.astar(graph, 0, 3, -np.zeros(4))
    assert path.tolist() == [0, 1, 3]


def test_no_sum_of_weights_is_infinite():
    with pytest.raises(InvalidGraph, match="from zero to 1e"):
        ke.Graph(3, [(0, 1), (1, 2)], [1e308, 1e308])

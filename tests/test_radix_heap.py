"""The radix heap of the searches, against a binary heap of (priority, time of insertion)."""

import heapq
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kinoedu.compiled import compiled
from kinoedu.graphs import Graph, astar, astar_expansions, dijkstra
from kinoedu.graphs.radix_heap import (
    NONE,
    empty_heap,
    enlarge,
    has_room,
    insert,
    list_in_order,
    peek,
    remove_first,
)

PRIORITIES = st.one_of(
    st.integers(0, 5).map(float),
    st.floats(0.0, allow_nan=False),
    st.integers(0, 3).map(
        lambda n: float(np.nextafter(1.0, 2.0)) if n == 3 else 1.0 + n * 2.0**-52
    ),
)
RETRIEVE = None


class Reference:
    """The least priority comes first; ties go to the most recently inserted node."""

    def __init__(self) -> None:
        self.heap: list[tuple[float, int, int]] = []
        self.count = 0

    def insert(self, node: int, priority: float) -> None:
        heapq.heappush(self.heap, (priority, -self.count, node))
        self.count += 1

    def retrieve(self) -> int:
        return heapq.heappop(self.heap)[-1] if self.heap else NONE


def retrieved(queue: Any) -> int:
    """The first node, which is removed."""
    node = peek(queue)
    if node != NONE:
        remove_first(queue)
    return int(node)


@given(st.lists(st.one_of(PRIORITIES, st.none()), max_size=80))
@settings(derandomize=True, deadline=None, max_examples=400)
def test_it_retrieves_what_a_heap_does(actions):
    """For any sequence of insertions and retrievals; the waiting nodes are listed in that order."""
    queue, reference = empty_heap(1), Reference()
    for node, priority in enumerate(actions):
        if priority is RETRIEVE:
            assert retrieved(queue) == reference.retrieve()
            continue
        if not has_room(queue, 1):
            queue = enlarge(queue, 1)
        insert(queue, node, priority)
        reference.insert(node, priority)
        assert list_in_order(queue) == [node for *_, node in sorted(reference.heap)]
    left = list_in_order(queue)
    assert [retrieved(queue) for _ in left] == [reference.retrieve() for _ in left] == left
    assert retrieved(queue) == reference.retrieve() == NONE


def test_entries_are_used_again():
    """A queue that never holds more than three nodes needs no more room than that."""
    queue = empty_heap(3)
    for node in range(1000):
        insert(queue, node, float(node // 3))
        if node % 3 == 2:
            assert [retrieved(queue) for _ in range(3)] == [node, node - 1, node - 2]
    assert len(queue.entries) == 3


@compiled
def drained(priorities: Any) -> Any:
    """The order of retrieval, compiled."""
    queue, order = empty_heap(4), np.empty(len(priorities), np.int64)
    for node in range(len(priorities)):
        if not has_room(queue, 1):
            queue = enlarge(queue, 1)
        insert(queue, node, priorities[node])
    for i in range(len(order)):
        order[i] = peek(queue)
        remove_first(queue)
    return order


@pytest.mark.parametrize("scale", [1e-320, 1e-150, 1.0, 1e150])
def test_it_sorts_floats_of_any_size(scale):
    """Compiled and interpreted; also the smallest, infinity and 0."""
    rng = np.random.default_rng(0)
    priorities = np.concatenate(
        [rng.integers(0, 50, 300) * scale, rng.random(300) * scale, [0.0, np.inf, np.inf, 0.0]]
    )
    wanted = np.lexsort([-np.arange(len(priorities)), priorities])
    assert np.array_equal(drained(priorities), wanted)
    assert np.array_equal(drained.py_func(priorities), wanted)


def test_a_search_makes_room_as_it_needs_it():
    """A star and a complete graph have many more edges than a queue begins with; all nodes are
    expanded, some of them again.
    """
    star = Graph(300, [(0, v) for v in range(1, 300)], np.arange(299.0))
    assert (
        np.array_equal(dijkstra(star, 0).expanded, np.arange(300)) and star.cost_to_go(7)[8] == 13.0
    )
    n = 80
    pairs = [(u, v) for u in range(n) for v in range(u)]
    whole = Graph(n, pairs, [(u - v) ** 1.5 for u, v in pairs])
    found = dijkstra(whole, 0)
    assert np.array_equal(found.cost, np.arange(float(n))) and found.steps == (n, n * (n - 1))
    estimate = np.where(np.arange(n) % 2 == 1, np.arange(n)[::-1], 0.0)
    path, found = astar(whole, 0, n - 1, estimate)
    assert path is not None and path.tolist() == list(range(n)) and len(found.expanded) > n


def test_a_search_goes_on_from_where_it_is():
    """A* breaks ties for the newest node: without obstacles it expands only its path."""
    n = 12
    number = np.arange(n * n).reshape(n, n)
    across, up = (
        np.stack([number[:, :-1], number[:, 1:]], axis=-1),
        np.stack([number[:-1], number[1:]], axis=-1),
    )
    edges = np.concatenate([across.reshape(-1, 2), up.reshape(-1, 2)])
    graph = Graph(n * n, edges, np.ones(len(edges)))
    estimate = np.add.outer(np.arange(n)[::-1], np.arange(n)[::-1]).ravel()
    path, found = astar(graph, 0, n * n - 1, estimate)
    assert path is not None and found.expanded.tolist() == path.tolist()
    moments = list(astar_expansions(graph, 0, n * n - 1, estimate))
    assert [moment.node for moment in moments] == path.tolist()
    assert all(after.node not in moment.frontier[1:] for moment, after in zip(moments, moments[1:]))


NODES = 8
ROWS = st.lists(
    st.tuples(st.integers(0, NODES - 1), st.integers(0, NODES - 1), st.integers(0, 4)), max_size=30
)
SHARES = st.lists(st.sampled_from([0.0, 0.3, 0.7, 1.0]), min_size=NODES, max_size=NODES)


@given(ROWS, SHARES, st.integers(0, NODES - 1))
@settings(derandomize=True, deadline=None, max_examples=300)
def test_lower_bounds_that_are_not_consistent_cost_no_optimality(rows, shares, goal):
    """Any estimate from zero to the true cost that remains."""
    graph = Graph(NODES, [row[:2] for row in rows], [float(row[2]) for row in rows], directed=True)
    remaining = graph.cost_to_go(goal)
    estimate = np.floor(np.minimum(remaining, 50.0) * shares)
    path, found = astar(graph, 0, goal, estimate)
    assert found.cost[goal] == remaining[0] and (path is None) == np.isinf(remaining[0])

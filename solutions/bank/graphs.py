"""Wrong answers to the exercises of lesson 4.

Each is a mistake that students make; `slip` is the misconception that a check must recognise.
"""

import heapq
from collections import deque
from math import inf
from pathlib import Path

from kinoedu.course.bank import Solutions, wrong

solutions = Solutions(Path(__file__).parents[1] / "04_graph_search.ipynb")
changed, right, varied = solutions.changed, solutions.right, solutions.varied


def both_ways(neighbours):
    """Return the adjacency lists with every edge in both directions."""
    return [
        [v for v in range(len(neighbours)) if v in row or u in neighbours[v]]
        for u, row in enumerate(neighbours)
    ]


def both_ways_with_weights(neighbours, weights):
    """Return adjacency lists and weights with every edge in both directions."""
    rows = [dict(zip(row, beside)) for row, beside in zip(neighbours, weights)]
    for u, row in enumerate([dict(row) for row in rows]):
        for v, w in row.items():
            rows[v][u] = min(w, rows[v].get(u, inf))
    rows = [dict(sorted(row.items())) for row in rows]
    return [list(row) for row in rows], [list(row.values()) for row in rows]


# The breadth-first tree

order_of_visit = changed(
    "bfs_tree",
    ("{start}", "[start]"),
    ("seen.add", "seen.append"),
    ("return parent", "return seen"),
    slip="order",
)
stack_for_a_queue = changed("bfs_tree", ("queue.popleft()", "queue.pop()"), slip="stack")
start_is_its_own_parent = changed(
    "bfs_tree", ("return parent", "parent[start] = start\n    return parent"), slip="own_parent"
)
zero_means_nobody = changed(  # but 0 is a node
    "bfs_tree", ("[-1]", "[0]"), ("while", "parent[start] = -1\n    while"), slip="zeros"
)
counts_from_one = changed(  # as MATLAB does
    "bfs_tree", ("return parent", "return [p + 1 for p in parent]"), slip="from_one"
)
numbers_of_edges = changed(
    "bfs_tree",
    ("while", "parent[start] = 0\n    while"),
    ("parent[u] = v", "parent[u] = parent[v] + 1"),
    slip="distances",
)
never_marks_anything = changed("bfs_tree", ("u not in seen", "True"))
asks_the_parent_whether_it_was_seen = changed(  # and sees the start again
    "bfs_tree", ("u not in seen", "parent[u] == -1")
)
first_level_only = changed("bfs_tree", ("while queue", "if queue"))
none_for_nobody = changed("bfs_tree", ("[-1]", "[None]"))


@wrong("bfs_tree", slip="late")
def marks_when_taken_out(neighbours, start):
    """Sees waiting nodes again and overwrites their parents."""
    parent, queue, done = [-1] * len(neighbours), deque([start]), set()
    while queue:
        v = queue.popleft()
        if v not in done:
            done.add(v)
            for u in neighbours[v]:
                if u not in done:
                    parent[u] = v
                    queue.append(u)
    return parent


@wrong("bfs_tree", slip="undirected")
def against_one_way_edges(neighbours, start):
    """Takes every edge to lead in both directions."""
    return right["bfs_tree"](both_ways(neighbours), start)


# The path from the root

from_the_goal_to_the_root = changed("extract_path", ("path[::-1]", "path"), slip="reversed")
without_the_goal = changed("extract_path", ("path[::-1]", "path[::-1][:-1]"), slip="no_goal")
without_the_root = changed("extract_path", ("path[::-1]", "path[::-1][1:]"), slip="no_root")
no_path_to_a_root = changed(  # takes it for a node out of reach
    "extract_path",
    ("return path[::-1]", "return path[::-1] if path[1:] else None"),
    slip="root_none",
)
one_step_up = changed("extract_path", ("while", "if"), slip="one_step")
parents_of_the_path = changed(
    "extract_path", ("path[::-1]", "[parent[u] for u in path[::-1]]"), slip="parents"
)
root_must_be_zero = changed("extract_path", ("parent[path[-1]] != -1", "path[-1] != 0"))
as_text = changed("extract_path", ("path[::-1]", "' -> '.join(map(str, path[::-1]))"))


@wrong("extract_path")
def round_and_round(parent, goal):
    """Never ends on a cycle."""
    path = []
    while goal != -1:
        path.insert(0, goal)
        goal = parent[goal]
    return path


circles_where_there_is_no_root = changed(  # else the last node of a walk round the circle
    "extract_path",
    ("return None", "return None if -1 not in parent else path[::-1]"),
)


@wrong("extract_path", slip="any_circle")
def any_circle_in_the_list(parent, goal):
    """Returns None where any node, not only the goal, is on a circle."""
    paths = [right["extract_path"](parent, u) for u in range(len(parent))]
    return None if None in paths else paths[goal]


# A path of the fewest edges

stack_for_a_queue_again = changed(
    "bfs_path", ("queue.popleft()", "queue.pop()"), slip="stack", within="bfs_tree"
)
backwards = changed("bfs_path", ("return path", "return path[::-1]"), slip="reversed")
searches_from_the_goal = changed(
    "bfs_path",
    ("start), goal)", "goal), start)"),
    ("return path if path[0] == start", "return path[::-1] if path[0] == goal"),
    slip="from_goal",
)
goal_alone_when_out_of_reach = changed(
    "bfs_path", ("path if path[0] == start else None", "path"), slip="goal_alone"
)
nowhere_to_go = changed("bfs_path", ("path[0] == start", "path[1:]"), slip="nowhere")
zero_from_anywhere = changed(
    "bfs_path", ("path[0] == start", "path[0] in (0, start)"), slip="goal_alone"
)
number_of_edges = changed("bfs_path", ("return path", "return len(path) - 1"))


@wrong("bfs_path", slip="deep")
def depth_first_called_shortest(neighbours, start, goal):
    """Returns a depth-first path instead of a shortest one."""
    return right["dfs_path"](neighbours, start, goal)


@wrong("bfs_path", slip="late")
def parents_written_again(neighbours, start, goal):
    """Marks nodes when they are taken out."""
    path = right["extract_path"](marks_when_taken_out.function(neighbours, start), goal)
    return path if path[0] == start else None


@wrong("bfs_path", slip="order")
def order_of_visit_for_a_path(neighbours, start, goal):
    """Returns all nodes visited before the goal."""
    order = order_of_visit.function(neighbours, start)
    return order[: order.index(goal) + 1] if goal in order else None


@wrong("bfs_path", slip="undirected")
def path_against_one_way_edges(neighbours, start, goal):
    """Takes every edge to lead in both directions."""
    return right["bfs_path"](both_ways(neighbours), start, goal)


@wrong("bfs_path")
def follows_first_neighbours(neighbours, start, goal):
    """Never ends where the first neighbour leads back."""
    path = [start]
    while path[-1] != goal:
        path.append(neighbours[path[-1]][0])
    return path


@wrong("bfs_path")
def all_paths_that_never_forget(neighbours, start, goal):
    """Keeps a queue of paths without marks.

    It ends where the goal can be reached, and never where it cannot.
    """
    queue = deque([[start]])
    while queue:
        path = queue.popleft()
        if path[-1] == goal:
            return path
        queue.extend([*path, v] for v in neighbours[path[-1]])
    return None


# Any path, depth first

deep_and_backwards = changed(
    "dfs_path", ("(parent, goal)", "(parent, goal)[::-1]"), slip="reversed"
)
deep_and_nowhere_to_go = changed("dfs_path", ("goal in seen", "parent[goal] != -1"), slip="nowhere")
never_marks_and_falls = changed("dfs_path", ("u not in seen", "True"))
not_deep_enough = changed(
    "dfs_path",
    ("def visit(v):", "def visit(v, depth=0):"),
    ("visit(u)\n", "if depth < 30:\n                    visit(u, depth + 1)\n"),
)
empty_when_out_of_reach = changed("dfs_path", ("else None", "else []"))


@wrong("dfs_path", slip="order")
def dead_ends_and_all(neighbours, start, goal):
    """Returns the order of visit."""
    visited = []

    def visit(u):
        visited.append(u)
        if u == goal:
            return True
        return any(v not in visited and visit(v) for v in neighbours[u])

    visit(start)
    return visited


@wrong("dfs_path", slip="walk")
def into_dead_ends_and_back(neighbours, start, goal):
    """Returns a walk along edges that meets nodes twice."""
    walk, seen = [start], {start}

    def visit(u):
        if u == goal:
            return True
        for v in neighbours[u]:
            if v not in seen:
                seen.add(v)
                walk.append(v)
                if visit(v):
                    return True
                walk.append(u)
        return False

    return walk if visit(start) else None


@wrong("dfs_path", slip="never_back")
def gives_up_in_a_dead_end(neighbours, start, goal):
    """Returns from the loop at the first neighbour."""
    seen = {start}

    def visit(u):
        if u == goal:
            return [u]
        for v in neighbours[u]:
            if v not in seen:
                seen.add(v)
                path = visit(v)
                return [u, *path] if path else None
        return None

    return visit(start)


@wrong("dfs_path", slip="undirected")
def deep_against_one_way_edges(neighbours, start, goal):
    """Takes every edge to lead in both directions."""
    return right["dfs_path"](both_ways(neighbours), start, goal)


@wrong("dfs_path")
def marks_its_own_path_only(neighbours, start, goal):
    """Tries every simple path: right, but exponential except on small graphs."""

    def visit(path):
        if path[-1] == goal:
            return path
        ways = (visit([*path, u]) for u in neighbours[path[-1]] if u not in path)
        return next(filter(None, ways), None)

    return visit([start])


# Dijkstra's algorithm

EDGES = "zip(neighbours[u], weights[u])"

counts_edges = changed("dijkstra", (EDGES, "[(v, 1) for v in neighbours[u]]"), slip="edges")
keeps_the_first_cost = changed(
    "dijkstra", ("c + w < cost[v]", "cost[v] == inf"), slip="first_found"
)
minus_one_for_out_of_reach = changed(
    "dijkstra", ("return cost", "return [c if c < inf else -1 for c in cost]"), slip="minus_one"
)
zero_for_out_of_reach = changed(
    "dijkstra", ("return cost", "return [c if c < inf else 0 for c in cost]"), slip="zero"
)
takes_negative_weights = changed(
    "dijkstra", ("any(w < 0 for row in weights for w in row)", "False")
)
takes_small_negative_weights = changed("dijkstra", ("w < 0", "w < -0.001"))
looks_at_whole_numbers = changed("dijkstra", ("w < 0", "int(w) < 0"))
looks_at_the_first_edges = changed("dijkstra", ("for w in row)", "for w in row[:1])"))
looks_at_all_rows_but_the_last = changed("dijkstra", ("row in weights", "row in weights[:-1]"))
a_thousand_for_infinity = changed(
    "dijkstra",
    ("[inf]", "[1000]"),
    ("return cost", "return [c if c < 1000 else inf for c in cost]"),
)
a_billion_for_infinity = changed(
    "dijkstra",
    ("[inf]", "[10**9]"),
    ("return cost", "return [c if c < 10**9 else inf for c in cost]"),
)
refuses_zero_weights_too = changed("dijkstra", ("w < 0", "w <= 0"))
ignores_little_gains = changed("dijkstra", ("< cost[v]:", "< cost[v] - 1e-4:"))
rounds_costs = changed("dijkstra", ("cost[v] = c + w", "cost[v] = round(c + w, 3)"))
weights_by_node = changed(  # as in a matrix
    "dijkstra", (EDGES, "[(v, weights[u][v]) for v in neighbours[u]]")
)


def refuse_negative(weights):
    """Raise a ValueError where a weight is negative."""
    if any(w < 0 for row in weights for w in row):
        raise ValueError("negative weight")


@wrong("dijkstra", slip="last_edge")
def weight_of_the_last_edge(neighbours, weights, start):
    """Is Prim's algorithm, which finds a minimum spanning tree."""
    refuse_negative(weights)
    cost, done = [inf] * len(neighbours), set()
    cost[start], queue = 0.0, [(0.0, start)]
    while queue:
        _, u = heapq.heappop(queue)
        if u in done:
            continue
        done.add(u)
        for v, w in zip(neighbours[u], weights[u]):
            if v not in done and w < cost[v]:
                cost[v] = w
                heapq.heappush(queue, (w, v))
    return cost


@wrong("dijkstra", slip="overwritten")
def overwrites_a_better_cost(neighbours, weights, start):
    """Does not compare before it writes a cost."""
    refuse_negative(weights)
    cost, waiting, done = [inf] * len(neighbours), {start}, set()
    cost[start] = 0.0
    while waiting:
        u = min(waiting, key=lambda v: (cost[v], v))
        waiting.remove(u)
        done.add(u)
        for v, w in zip(neighbours[u], weights[u]):
            if v not in done:
                cost[v] = cost[u] + w
                waiting.add(v)
    return cost


@wrong("dijkstra", slip="lightest_first")
def queue_of_single_edges(neighbours, weights, start):
    """Pushes the weight of the edge instead of the cost of the path."""
    refuse_negative(weights)
    cost, queue, done = [inf] * len(neighbours), [(0.0, start)], set()
    cost[start] = 0.0
    while queue:
        _, u = heapq.heappop(queue)
        if u in done:
            continue
        done.add(u)
        for v, w in zip(neighbours[u], weights[u]):
            if cost[u] + w < cost[v]:
                cost[v] = cost[u] + w
                heapq.heappush(queue, (w, v))
    return cost


@wrong("dijkstra", slip="in_turn")
def plain_queue(neighbours, weights, start):
    """Processes nodes first come, first served, each once."""
    refuse_negative(weights)
    cost, queue, seen = [inf] * len(neighbours), deque([start]), {start}
    cost[start] = 0.0
    while queue:
        u = queue.popleft()
        for v, w in zip(neighbours[u], weights[u]):
            cost[v] = min(cost[v], cost[u] + w)
            if v not in seen:
                seen.add(v)
                queue.append(v)
    return cost


@wrong("dijkstra", slip="undirected")
def costs_against_one_way_edges(neighbours, weights, start):
    """Takes every edge to lead in both directions."""
    refuse_negative(weights)
    return right["dijkstra"](*both_ways_with_weights(neighbours, weights), start)


# A*

by_the_estimate_alone = changed(
    "astar",
    ("cost[u] + w < cost[v]", "cost[v] == inf"),
    ("cost[v] + estimate[v]", "estimate[v]"),
    slip="greedy",
)
stops_at_first_sight = changed(  # on an expensive path
    "astar",
    (
        "parent[v] = u",
        "parent[v] = u\n                if v == goal: return extract_path(parent, goal)",
    ),
    slip="at_sight",
)
closed_for_ever = changed(  # right for consistent estimates only
    "astar",
    ("while", "done = set()\n    while"),
    ("        for", "        done.add(u)\n        for"),
    ("if cost[u]", "if v not in done and cost[u]"),
    slip="closed",
)
keeps_the_first_way = changed(
    "astar", ("cost[u] + w < cost[v]", "cost[v] == inf"), slip="first_found"
)
star_backwards = changed("astar", ("(parent, goal)", "(parent, goal)[::-1]"), slip="reversed")
adds_estimates_up = changed(
    "astar",
    ("cost[u] + w < cost[v]", "cost[u] + w + estimate[v] < cost[v]"),
    ("cost[v] = cost[u] + w", "cost[v] = cost[u] + w + estimate[v]"),
    ("(cost[v] + estimate[v], v)", "(cost[v], v)"),
    slip="summed",
)
larger_estimates = changed(
    "astar",
    ("(estimate[start], start)", "(1.5 * estimate[start], start)"),
    ("cost[v] + estimate[v]", "cost[v] + 1.5 * estimate[v]"),
    slip="larger",
)
slightly_larger_estimates = changed(
    "astar", ("cost[v] + estimate[v]", "cost[v] + 1.1 * estimate[v]"), slip="larger"
)
whole_weights = changed("astar", (EDGES, "zip(neighbours[u], map(int, weights[u]))"))
a_million_for_infinity = changed("astar", ("[inf]", "[10**6]"))
largest_int_for_infinity = changed("astar", ("[inf]", "[2**63 - 1]"))
three_times_at_most = changed(
    "astar",
    ("while", "times = [0] * len(cost)\n    while"),
    ("if cost[u] + w < cost[v]", "if times[v] < 3 and cost[u] + w < cost[v]"),
    ("parent[v] = u", "times[v] += 1\n                parent[v] = u"),
    slip="closed",
)
parent_of_the_first_way = changed(
    "astar",
    ("parent[v] = u", "parent[v] = u if parent[v] == -1 else parent[v]"),
    slip="first_found",
)
pushed_once = changed(  # a lower cost of a waiting node does not move it in the queue
    "astar",
    ("heappush(", "any(v == waiting for _, waiting in heap) or heappush("),
    slip="pushed_once",
)
two_nodes_for_one = changed(
    "astar", ("    while", "    if start == goal:\n        return [start, goal]\n    while")
)
nodes_taken_out = changed(
    "astar",
    ("while", "order = []\n    while"),
    ("heappop(heap)", "heappop(heap)\n        order.append(u)"),
    ("return extract_path(parent, goal)", "return order"),
)


@wrong("astar", slip="edges")
def fewest_edges(neighbours, weights, estimate, start, goal):
    """Is a breadth-first search."""
    return right["bfs_path"](neighbours, start, goal)


@wrong("astar", slip="undirected")
def star_against_one_way_edges(neighbours, weights, estimate, start, goal):
    """Takes every edge to lead in both directions."""
    return right["astar"](*both_ways_with_weights(neighbours, weights), estimate, start, goal)


# Break it


@wrong("misleading_estimate")
def estimate_that_misleads_nobody():
    """Gives a lower bound."""
    return [[1, 2], [2], []], [[1, 3], [1], []], [2, 1, 0], 0, 2


@wrong("misleading_estimate")
def too_large_where_it_does_not_matter():
    """Overestimates, but only on the expensive path."""
    return [[1, 2], [2], []], [[2, 3], [2], []], [2, 9, 0], 0, 2


@wrong("misleading_estimate")
def one_node_too_many():
    """Misleads A*, but with four nodes where three are enough."""
    return [[1, 2], [3], [3], []], [[1, 3], [1], [3], []], [0, 9, 0, 0], 0, 3


@wrong("misleading_estimate")
def estimate_at_the_goal():
    """Gives the goal an estimate other than 0."""
    return [[1, 2], [2], []], [[1, 3], [1], []], [0, 5, 5], 0, 2


@wrong("misleading_estimate")
def negative_weight():
    """Misleads A* by a weight that is refused."""
    return [[1, 2], [2], []], [[5, 3], [-4], []], [0, 0, 0], 0, 2


@wrong("misleading_estimate")
def no_way_to_the_goal():
    """Gives a graph without a path."""
    return [[1], [], []], [[1], [], []], [0, 9, 0], 0, 2


@wrong("misleading_estimate")
def weights_as_a_matrix():
    """Gives a weight for every pair of nodes."""
    return [[1, 2], [2], []], [[0, 1, 3], [0, 0, 1], [0, 0, 0]], [0, 5, 0], 0, 2


@wrong("misleading_estimate")
def two_parallel_edges():
    """Has only two nodes, with two edges between them."""
    return [[1, 1], []], [[1, 3], []], [0, 0], 0, 1


# Long chains, costs that are nearly equal, nodes that are expanded again and again

at_most_fifty_nodes = changed("extract_path", ("len(path) > len(parent)", "len(path) > 50"))
rounded_queue = changed(
    "astar", ("(cost[v] + estimate[v], v)", "(round(cost[v] + estimate[v]), v)")
)
expanded_twice_at_most = changed(
    "astar",
    ("    while heap:", "    times = [0] * len(cost)\n    while heap:"),
    (
        "        if u == goal:",
        "        times[u] += 1\n        if times[u] > 2 and u != goal:\n            continue\n"
        "        if u == goal:",
    ),
    slip="closed",
)
ignores_little_gains_of_a_way = changed("astar", ("< cost[v]:", "< cost[v] - 1e-4:"))
start_without_edges = changed("astar", ("while heap:", "while heap and neighbours[start]:"))


# Variants

FOUND = "return path if path[0] == start else None"
SEARCHED = "path = extract_path(bfs_tree(neighbours, start), goal)"
reversed_by_breadth = varied(
    "bfs_path", "from_goal", (FOUND, FOUND.replace("path if", "path[::-1] if"))
)
breadth_first_from_the_goal = varied(
    "bfs_path",
    "incoming",
    (SEARCHED, "path = extract_path(bfs_tree(neighbours, goal), start)"),
    (FOUND, "return path[::-1] if path[0] == goal else None"),
)
backwards_along_the_edges = changed(
    "bfs_path",
    (SEARCHED, "path = extract_path(bfs_tree(neighbours, goal), start)"),
    (FOUND, "return path if path[0] == goal else None"),
    variant="from_goal",
    slip="undirected",
)
both_directions_are_open = changed(
    "bfs_path",
    (
        SEARCHED,
        "nodes = range(len(neighbours))\n"
        "    lead = lambda u, v: v in neighbours[u] or u in neighbours[v]\n"
        "    both = [[v for v in nodes if lead(u, v)] for u in nodes]\n"
        "    path = extract_path(bfs_tree(both, start), goal)",
    ),
    variant="incoming",
)
LEADS, DEEP = "for u in neighbours[v]:", "return extract_path(parent, goal)"
LEADS_BACK = "for u in [u for u in range(len(neighbours)) if v in neighbours[u]]:"
reversed_by_depth = varied("dfs_path", "from_goal", (DEEP, DEEP + "[::-1]"))
depth_first_backwards = varied("dfs_path", "incoming", (LEADS, LEADS_BACK))
reversed_nodes_of_a_search_without_the_goal = changed(
    "dfs_path", (DEEP, DEEP + "[-2::-1]"), variant="from_goal"
)
START_COST, CHEAPER = "    cost[start] = 0\n", "c + w < cost[v]"
EACH_EDGE = "for v, w in zip(neighbours[u], weights[u]):"
EACH_EDGE_TO_U = (
    "for v, w in [(v, w) for v, row in enumerate(neighbours) for t, w in zip(row, weights[v]) "
    "if t == u]:"
)
costs_to_the_start = varied("dijkstra", "to_start", (EACH_EDGE, EACH_EDGE_TO_U))
costs_of_squares = varied(
    "dijkstra", "squared", (EACH_EDGE, EACH_EDGE + "\n                w = w * w")
)
square_of_the_least_cost = changed(
    "dijkstra", ("return cost", "return [c * c for c in cost]"), variant="squared"
)
costs_to_the_start_in_edges = changed(
    "dijkstra",
    (EACH_EDGE, EACH_EDGE_TO_U + "\n                w = 1"),
    variant="to_start",
    slip="edges",
)
BEST = "return extract_path(parent, goal)"
reversed_by_cost = varied("astar", "from_goal", (BEST, BEST + "[::-1]"))
cheapest_backwards = varied("astar", "incoming", (EACH_EDGE, EACH_EDGE_TO_U))
cheapest_backwards_without_costs = changed(
    "astar",
    (EACH_EDGE, EACH_EDGE_TO_U + "\n            w = 1"),
    variant="incoming",
    slip="greedy",
)

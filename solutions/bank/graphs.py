"""Wrong answers to the exercises of lesson 4.

Each is a mistake that students make; `slip` is the misconception that a check must recognise.
"""

import heapq
from collections import deque
from math import inf

from kinoedu.course.bank import wrong


def tree(neighbours, start):
    """Return a right breadth-first tree, for wrong answers whose mistake is elsewhere."""
    parent, queue, seen = [-1] * len(neighbours), deque([start]), {start}
    while queue:
        v = queue.popleft()
        for u in neighbours[v]:
            if u not in seen:
                seen.add(u)
                parent[u] = v
                queue.append(u)
    return parent


def climb(parent, goal):
    """Return the right path from the root."""
    path = [goal]
    while parent[path[-1]] != -1:
        path.append(parent[path[-1]])
        if len(path) > len(parent):
            return None
    return path[::-1]


def right_path(neighbours, start, goal):
    """Return a right path with the fewest edges, or None."""
    path = climb(tree(neighbours, start), goal)
    return path if path[0] == start else None


def both_ways(neighbours):
    """Return the adjacency lists with every edge in both directions."""
    return [
        [v for v in range(len(neighbours)) if v in row or u in neighbours[v]]
        for u, row in enumerate(neighbours)
    ]


# The breadth-first tree


@wrong("bfs_tree", slip="order")
def order_of_visit(neighbours, start):
    """Returns the nodes in the order of visit."""
    queue, visited = deque([start]), [start]
    while queue:
        for u in neighbours[queue.popleft()]:
            if u not in visited:
                visited.append(u)
                queue.append(u)
    return visited


@wrong("bfs_tree", slip="stack")
def stack_for_a_queue(neighbours, start):
    """Uses pop(), which takes the newest node."""
    parent, stack, seen = [-1] * len(neighbours), [start], {start}
    while stack:
        v = stack.pop()
        for u in neighbours[v]:
            if u not in seen:
                seen.add(u)
                parent[u] = v
                stack.append(u)
    return parent


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


@wrong("bfs_tree", slip="own_parent")
def start_is_its_own_parent(neighbours, start):
    """Makes the root its own parent."""
    parent = tree(neighbours, start)
    parent[start] = start
    return parent


@wrong("bfs_tree", slip="zeros")
def zero_means_nobody(neighbours, start):
    """Begins with parents 0, but 0 is a node."""
    parent, queue, seen = [0] * len(neighbours), deque([start]), {start}
    parent[start] = -1
    while queue:
        v = queue.popleft()
        for u in neighbours[v]:
            if u not in seen:
                seen.add(u)
                parent[u] = v
                queue.append(u)
    return parent


@wrong("bfs_tree", slip="from_one")
def counts_from_one(neighbours, start):
    """Numbers nodes from 1, as MATLAB does."""
    return [p + 1 for p in tree(neighbours, start)]


@wrong("bfs_tree", slip="distances")
def numbers_of_edges(neighbours, start):
    """Returns distances instead of parents."""
    far, queue = [-1] * len(neighbours), deque([start])
    far[start] = 0
    while queue:
        v = queue.popleft()
        for u in neighbours[v]:
            if far[u] == -1:
                far[u] = far[v] + 1
                queue.append(u)
    return far


@wrong("bfs_tree", slip="undirected")
def against_one_way_edges(neighbours, start):
    """Takes every edge to lead in both directions."""
    return tree(both_ways(neighbours), start)


@wrong("bfs_tree")
def never_marks_anything(neighbours, start):
    """Loops for ever on any edge that leads back."""
    parent, queue = [-1] * len(neighbours), deque([start])
    while queue:
        v = queue.popleft()
        for u in neighbours[v]:
            parent[u] = v
            queue.append(u)
    return parent


@wrong("bfs_tree")
def asks_the_parent_whether_it_was_seen(neighbours, start):
    """Takes a parent of -1 for unseen, so that the start is seen again."""
    parent, queue = [-1] * len(neighbours), deque([start])
    while queue:
        v = queue.popleft()
        for u in neighbours[v]:
            if parent[u] == -1:
                parent[u] = v
                queue.append(u)
    return parent


@wrong("bfs_tree")
def first_level_only(neighbours, start):
    """Stops at the neighbours of the start."""
    parent = [-1] * len(neighbours)
    for u in neighbours[start]:
        parent[u] = start
    return parent


@wrong("bfs_tree")
def none_for_nobody(neighbours, start):
    """Returns None instead of -1."""
    return [None if p == -1 else p for p in tree(neighbours, start)]


# The path from the root


@wrong("extract_path", slip="reversed")
def from_the_goal_to_the_root(parent, goal):
    """Returns the path in reverse."""
    path = climb(parent, goal)
    return path[::-1] if path else None


@wrong("extract_path", slip="no_goal")
def without_the_goal(parent, goal):
    """Collects the parents, and forgets the goal itself."""
    path, seen = [], set()
    while parent[goal] != -1 and goal not in seen:
        seen.add(goal)
        goal = parent[goal]
        path.insert(0, goal)
    return path if parent[goal] == -1 else None


@wrong("extract_path", slip="no_root")
def without_the_root(parent, goal):
    """Stops before it adds the root."""
    path, seen = [], set()
    while parent[goal] != -1 and goal not in seen:
        seen.add(goal)
        path.insert(0, goal)
        goal = parent[goal]
    return path if parent[goal] == -1 else None


@wrong("extract_path", slip="root_none")
def no_path_to_a_root(parent, goal):
    """Takes a root for a node out of reach."""
    return None if parent[goal] == -1 else climb(parent, goal)


@wrong("extract_path", slip="one_step")
def one_step_up(parent, goal):
    """Has an `if` instead of a `while`."""
    return [parent[goal], goal] if parent[goal] != -1 else [goal]


@wrong("extract_path", slip="parents")
def parents_of_the_path(parent, goal):
    """Lists the parents of the path's nodes."""
    path = climb(parent, goal)
    return [parent[u] for u in path] if path else None


@wrong("extract_path")
def round_and_round(parent, goal):
    """Never ends on a cycle."""
    path = []
    while goal != -1:
        path.insert(0, goal)
        goal = parent[goal]
    return path


@wrong("extract_path")
def root_must_be_zero(parent, goal):
    """Takes node 0 for the root."""
    path = [goal]
    while path[0] != 0 and len(path) <= len(parent):
        path.insert(0, parent[path[0]])
    return path


@wrong("extract_path")
def as_text(parent, goal):
    """Returns strings instead of numbers."""
    path = climb(parent, goal)
    return " -> ".join(map(str, path)) if path else None


# A path of the fewest edges


@wrong("bfs_path", slip="stack")
def stack_for_a_queue_again(neighbours, start, goal):
    """Finds long detours."""
    path = climb(stack_for_a_queue.function(neighbours, start), goal)
    return path if path[0] == start else None


@wrong("bfs_path", slip="deep")
def depth_first_called_shortest(neighbours, start, goal):
    """Returns a depth-first path instead of a shortest one."""
    seen = {start}

    def visit(u):
        if u == goal:
            return [u]
        for v in neighbours[u]:
            if v not in seen:
                seen.add(v)
                path = visit(v)
                if path:
                    return [u, *path]
        return None

    return visit(start)


@wrong("bfs_path", slip="late")
def parents_written_again(neighbours, start, goal):
    """Marks nodes when they are taken out."""
    path = climb(marks_when_taken_out.function(neighbours, start), goal)
    return path if path[0] == start else None


@wrong("bfs_path", slip="order")
def order_of_visit_for_a_path(neighbours, start, goal):
    """Returns all nodes visited before the goal."""
    order = order_of_visit.function(neighbours, start)
    return order[: order.index(goal) + 1] if goal in order else None


@wrong("bfs_path", slip="reversed")
def backwards(neighbours, start, goal):
    """Returns the path in reverse."""
    path = right_path(neighbours, start, goal)
    return path[::-1] if path else None


@wrong("bfs_path", slip="undirected")
def path_against_one_way_edges(neighbours, start, goal):
    """Takes every edge to lead in both directions."""
    return right_path(both_ways(neighbours), start, goal)


@wrong("bfs_path", slip="from_goal")
def searches_from_the_goal(neighbours, start, goal):
    """Searches from the goal and reverses that path."""
    path = right_path(neighbours, goal, start)
    return path and path[::-1]


@wrong("bfs_path", slip="goal_alone")
def goal_alone_when_out_of_reach(neighbours, start, goal):
    """Does not check that the path begins at the start."""
    return climb(tree(neighbours, start), goal)


@wrong("bfs_path", slip="nowhere")
def nowhere_to_go(neighbours, start, goal):
    """Takes a goal without a parent for one out of reach."""
    parent = tree(neighbours, start)
    return None if parent[goal] == -1 else climb(parent, goal)


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


@wrong("bfs_path")
def number_of_edges(neighbours, start, goal):
    """Returns the length of the path instead of its nodes."""
    path = right_path(neighbours, start, goal)
    return len(path) - 1 if path else None


# Any path, depth first


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


@wrong("dfs_path", slip="reversed")
def deep_and_backwards(neighbours, start, goal):
    """Returns the path in reverse."""
    path = depth_first_called_shortest.function(neighbours, start, goal)
    return path[::-1] if path else None


@wrong("dfs_path", slip="undirected")
def deep_against_one_way_edges(neighbours, start, goal):
    """Takes every edge to lead in both directions."""
    return depth_first_called_shortest.function(both_ways(neighbours), start, goal)


@wrong("dfs_path", slip="nowhere")
def deep_and_nowhere_to_go(neighbours, start, goal):
    """Returns None where start and goal are the same."""
    return depth_first_called_shortest.function(neighbours, start, goal) if start != goal else None


@wrong("dfs_path")
def never_marks_and_falls(neighbours, start, goal):
    """Recurses for ever on a cycle."""
    if start == goal:
        return [start]
    for v in neighbours[start]:
        path = never_marks_and_falls.function(neighbours, v, goal)
        if path:
            return [start, *path]
    return None


@wrong("dfs_path")
def marks_its_own_path_only(neighbours, start, goal):
    """Tries every simple path: right, but exponential except on small graphs."""

    def visit(path):
        if path[-1] == goal:
            return path
        ways = (visit([*path, u]) for u in neighbours[path[-1]] if u not in path)
        return next(filter(None, ways), None)

    return visit([start])


@wrong("dfs_path")
def empty_when_out_of_reach(neighbours, start, goal):
    """Returns an empty list instead of None."""
    return depth_first_called_shortest.function(neighbours, start, goal) or []


# Dijkstra's algorithm


def costs_by_heap(neighbours, weights, start):
    """Return the right costs by Dijkstra's algorithm."""
    cost = [inf] * len(neighbours)
    cost[start], queue = 0.0, [(0.0, start)]
    while queue:
        c, u = heapq.heappop(queue)
        for v, w in zip(neighbours[u], weights[u]):
            if c + w < cost[v]:
                cost[v] = c + w
                heapq.heappush(queue, (cost[v], v))
    return cost


def refuse_negative(weights):
    """Raise a ValueError where a weight is negative."""
    if any(w < 0 for row in weights for w in row):
        raise ValueError("negative weight")


@wrong("dijkstra", slip="edges")
def counts_edges(neighbours, weights, start):
    """Is a breadth-first search."""
    refuse_negative(weights)
    return [d if d >= 0 else inf for d in numbers_of_edges.function(neighbours, start)]


@wrong("dijkstra", slip="first_found")
def keeps_the_first_cost(neighbours, weights, start):
    """Does not update a cost when a better one is found."""
    refuse_negative(weights)
    cost = [inf] * len(neighbours)
    cost[start], queue = 0.0, [(0.0, start)]
    while queue:
        c, u = heapq.heappop(queue)
        for v, w in zip(neighbours[u], weights[u]):
            if cost[v] == inf:
                cost[v] = c + w
                heapq.heappush(queue, (cost[v], v))
    return cost


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
    rows = [dict(zip(row, beside)) for row, beside in zip(neighbours, weights)]
    for u, row in enumerate([dict(row) for row in rows]):
        for v, w in row.items():
            rows[v][u] = min(w, rows[v].get(u, inf))
    return costs_by_heap([list(row) for row in rows], [list(row.values()) for row in rows], start)


@wrong("dijkstra", slip="minus_one")
def minus_one_for_out_of_reach(neighbours, weights, start):
    """Returns -1 instead of infinity."""
    refuse_negative(weights)
    return [c if c < inf else -1 for c in costs_by_heap(neighbours, weights, start)]


@wrong("dijkstra", slip="zero")
def zero_for_out_of_reach(neighbours, weights, start):
    """Returns 0 instead of infinity."""
    refuse_negative(weights)
    return [c if c < inf else 0 for c in costs_by_heap(neighbours, weights, start)]


@wrong("dijkstra")
def takes_negative_weights(neighbours, weights, start):
    """Settles each node once and does not check for negative weights."""
    cost, done = [inf] * len(neighbours), set()
    cost[start], queue = 0.0, [(0.0, start)]
    while queue:
        c, u = heapq.heappop(queue)
        if u not in done:
            done.add(u)
            for v, w in zip(neighbours[u], weights[u]):
                if c + w < cost[v]:
                    cost[v] = c + w
                    heapq.heappush(queue, (cost[v], v))
    return cost


@wrong("dijkstra")
def refuses_zero_weights_too(neighbours, weights, start):
    """Refuses zero as if it were negative."""
    if any(w <= 0 for row in weights for w in row):
        raise ValueError("not positive")
    return costs_by_heap(neighbours, weights, start)


@wrong("dijkstra")
def weights_by_node(neighbours, weights, start):
    """Reads weights[u][v], as in a matrix."""
    refuse_negative(weights)
    cost = [inf] * len(neighbours)
    cost[start], queue = 0.0, [(0.0, start)]
    while queue:
        c, u = heapq.heappop(queue)
        for v in neighbours[u]:
            if c + weights[u][v] < cost[v]:
                cost[v] = c + weights[u][v]
                heapq.heappush(queue, (cost[v], v))
    return cost


# A*


def star(neighbours, weights, start, goal, rank, *, once=False, first=False, at_sight=False):
    """Run A* with its queue ordered by rank(cost, node)."""
    cost, parent, done = [inf] * len(neighbours), [-1] * len(neighbours), set()
    cost[start], queue = 0.0, [(rank(0.0, start), start)]
    while queue:
        _, u = heapq.heappop(queue)
        if once and u in done:
            continue
        done.add(u)
        if u == goal:
            return climb(parent, goal)
        for v, w in zip(neighbours[u], weights[u]):
            if (once and v in done) or (first and cost[v] < inf) or cost[u] + w >= cost[v]:
                continue
            cost[v], parent[v] = cost[u] + w, u
            if at_sight and v == goal:
                return climb(parent, goal)
            heapq.heappush(queue, (rank(cost[v], v), v))
    return None


@wrong("astar", slip="greedy")
def by_the_estimate_alone(neighbours, weights, estimate, start, goal):
    """Is greedy: the cost so far does not count."""
    return star(neighbours, weights, start, goal, lambda cost, u: estimate[u], first=True)


@wrong("astar", slip="at_sight")
def stops_at_first_sight(neighbours, weights, estimate, start, goal):
    """Stops when the goal is first seen, on an expensive path."""
    return star(neighbours, weights, start, goal, lambda cost, u: cost + estimate[u], at_sight=True)


@wrong("astar", slip="closed")
def closed_for_ever(neighbours, weights, estimate, start, goal):
    """Never reopens a node: right for consistent estimates only."""
    return star(neighbours, weights, start, goal, lambda cost, u: cost + estimate[u], once=True)


@wrong("astar", slip="first_found")
def keeps_the_first_way(neighbours, weights, estimate, start, goal):
    """Does not update a cost when a better one is found."""
    return star(neighbours, weights, start, goal, lambda cost, u: cost + estimate[u], first=True)


@wrong("astar", slip="edges")
def fewest_edges(neighbours, weights, estimate, start, goal):
    """Is a breadth-first search."""
    return right_path(neighbours, start, goal)


@wrong("astar", slip="undirected")
def star_against_one_way_edges(neighbours, weights, estimate, start, goal):
    """Takes every edge to lead in both directions."""
    rows = [dict(zip(row, beside)) for row, beside in zip(neighbours, weights)]
    for u, row in enumerate([dict(row) for row in rows]):
        for v, w in row.items():
            rows[v][u] = min(w, rows[v].get(u, inf))
    rows = [dict(sorted(row.items())) for row in rows]
    lists = [list(row) for row in rows], [list(row.values()) for row in rows]
    return star(*lists, start, goal, lambda cost, u: cost + estimate[u])


@wrong("astar", slip="reversed")
def star_backwards(neighbours, weights, estimate, start, goal):
    """Returns the path in reverse."""
    path = star(neighbours, weights, start, goal, lambda cost, u: cost + estimate[u])
    return path[::-1] if path else None


@wrong("astar", slip="summed")
def adds_estimates_up(neighbours, weights, estimate, start, goal):
    """Stores cost plus estimate as the cost, so that estimates add up along the path."""
    total, parent = [inf] * len(neighbours), [-1] * len(neighbours)
    total[start], queue = estimate[start], [(estimate[start], start)]
    while queue:
        f, u = heapq.heappop(queue)
        if u == goal:
            return climb(parent, goal)
        for v, w in zip(neighbours[u], weights[u]):
            if f + w + estimate[v] < total[v]:
                total[v], parent[v] = f + w + estimate[v], u
                heapq.heappush(queue, (total[v], v))
    return None


@wrong("astar")
def nodes_taken_out(neighbours, weights, estimate, start, goal):
    """Returns the order of expansion."""
    cost, order, queue = [inf] * len(neighbours), [], [(estimate[start], start)]
    cost[start] = 0.0
    while queue:
        _, u = heapq.heappop(queue)
        order.append(u)
        if u == goal:
            return order
        for v, w in zip(neighbours[u], weights[u]):
            if cost[u] + w < cost[v]:
                cost[v] = cost[u] + w
                heapq.heappush(queue, (cost[v] + estimate[v], v))
    return None


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

"""Wrong answers to the exercises of lesson 9.

Each is a mistake that students make; `slip` is the misconception that a check must recognise.
"""

import random

import numpy as np

from kinoedu.course.bank import wrong


def nearest(problem, nodes, q):
    """Return the index of the nearest node."""
    return int(np.argmin([problem.distance(node, q) for node in nodes]))


def way_up(nodes, parent, node):
    """Return the nodes from a node to the root."""
    path = []
    while node >= 0:
        path.append(nodes[node])
        node = parent[node]
    return path


# The tree roadmap


def planted(problem, expand, iterations, rng, accepts, number=lambda node, nodes: node):
    """Grow a tree by `expand`; the arguments replace parts."""
    rng = np.random.default_rng(rng)
    nodes, parent = [problem.start], [-1]
    for _ in range(iterations):
        node, q = expand(problem, np.array(nodes), rng)
        if accepts(problem, nodes[node], q):
            nodes.append(q)
            parent.append(number(node, nodes))
    return nodes, parent


def is_free_path(problem, a, b):
    """Whether the motion is free."""
    return problem.is_free_path(a, b)


@wrong("tree_roadmap", slip="unchecked")
def every_edge(problem, expand, iterations, rng):
    """Adds whatever expand proposes."""
    return planted(problem, expand, iterations, rng, lambda problem, a, b: True)


@wrong("tree_roadmap", slip="ends_only")
def free_ends(problem, expand, iterations, rng):
    """Checks points instead of motions."""
    return planted(problem, expand, iterations, rng, lambda problem, a, b: problem.is_free(b))


@wrong("tree_roadmap")
def eleven_points(problem, expand, iterations, rng):
    """Checks eleven points of the motion."""
    return planted(
        problem,
        expand,
        iterations,
        rng,
        lambda p, a, b: all(p.is_free(a + t * (b - a)) for t in np.linspace(0, 1, 4)),
    )


@wrong("tree_roadmap", slip="from_one")
def numbers_from_one(problem, expand, iterations, rng):
    """Numbers nodes from 1, as MATLAB does."""
    return planted(problem, expand, iterations, rng, is_free_path, lambda node, nodes: node + 1)


@wrong("tree_roadmap", slip="chained")
def one_long_chain(problem, expand, iterations, rng):
    """Makes the last node the parent."""
    return planted(
        problem, expand, iterations, rng, is_free_path, lambda node, nodes: len(nodes) - 2
    )


@wrong("tree_roadmap")
def everything_on_the_root(problem, expand, iterations, rng):
    """Makes the root the parent of every node."""
    return planted(problem, expand, iterations, rng, is_free_path, lambda node, nodes: 0)


@wrong("tree_roadmap")
def stops_at_the_first_wall(problem, expand, iterations, rng):
    """Has `break` instead of `continue`."""
    rng = np.random.default_rng(rng)
    nodes, parent = [problem.start], [-1]
    for _ in range(iterations):
        node, q = expand(problem, np.array(nodes), rng)
        if not problem.is_free_path(nodes[node], q):
            break
        nodes.append(q)
        parent.append(node)
    return nodes, parent


@wrong("tree_roadmap")
def counts_nodes(problem, expand, iterations, rng):
    """Goes on until there are as many nodes as iterations."""
    rng = np.random.default_rng(rng)
    nodes, parent = [problem.start], [-1]
    while len(nodes) <= iterations:
        node, q = expand(problem, np.array(nodes), rng)
        if problem.is_free_path(nodes[node], q):
            nodes.append(q)
            parent.append(node)
    return nodes, parent


@wrong("tree_roadmap")
def new_chance_each_time(problem, expand, iterations, rng):
    """Makes a new generator with the same seed in every iteration."""
    nodes, parent = [problem.start], [-1]
    for _ in range(iterations):
        node, q = expand(problem, np.array(nodes), np.random.default_rng(rng))
        if problem.is_free_path(nodes[node], q):
            nodes.append(q)
            parent.append(node)
    return nodes, parent


@wrong("tree_roadmap")
def no_root(problem, expand, iterations, rng):
    """Returns only what was added."""
    nodes, parent = planted(problem, expand, iterations, rng, is_free_path)
    return nodes[1:], parent[1:]


# RRT


def rrt_by(
    problem,
    step,
    goal_bias,
    iterations,
    rng,
    *,
    choose=nearest,
    accepts=is_free_path,
    draw=lambda problem, rng: problem.sample(rng),
    accepts_goal=is_free_path,
    steer=lambda problem, a, b, step: problem.steer(a, b, step),
    number=lambda near: near,
):
    """Grow an RRT; each argument that is given replaces a part."""
    rng = np.random.default_rng(rng)
    nodes, parent = [problem.start], [-1]
    for i in range(iterations + 1):
        if problem.distance(nodes[-1], problem.goal) <= step and accepts_goal(
            problem, nodes[-1], problem.goal
        ):
            nodes.append(problem.goal)
            parent.append(number(len(nodes) - 2))
            return nodes, parent, way_up(nodes, parent, len(nodes) - 1)[::-1]
        q_rand = problem.goal if rng.random() < goal_bias else draw(problem, rng)
        near = choose(problem, nodes, q_rand)
        q_new = steer(problem, nodes[near], q_rand, step)
        if i < iterations and accepts(problem, nodes[near], q_new):
            nodes.append(q_new)
            parent.append(number(near))
    return nodes, parent, None


@wrong("rrt")
def last_edge_unchecked(problem, step, goal_bias, iterations, rng):
    """Takes a node near the goal for the goal."""
    return rrt_by(
        problem, step, goal_bias, iterations, rng, accepts_goal=lambda problem, a, b: True
    )


@wrong("rrt")
def points_for_edges(problem, step, goal_bias, iterations, rng):
    """Checks only the new node."""

    def free_end(problem, a, b):
        return problem.is_free(b)

    return rrt_by(
        problem, step, goal_bias, iterations, rng, accepts=free_end, accepts_goal=free_end
    )


@wrong("rrt")
def ten_points_of_an_edge(problem, step, goal_bias, iterations, rng):
    """Checks ten points of the motion."""

    def sampled(problem, a, b):
        return all(problem.is_free(a + t * (b - a)) for t in np.linspace(0, 1, 11))

    return rrt_by(problem, step, goal_bias, iterations, rng, accepts=sampled, accepts_goal=sampled)


@wrong("rrt")
def always_the_root(problem, step, goal_bias, iterations, rng):
    """Always extends the root, so that no node is farther than a step."""
    return rrt_by(problem, step, goal_bias, iterations, rng, choose=lambda problem, nodes, q: 0)


@wrong("rrt")
def root_with_long_steps(problem, step, goal_bias, iterations, rng):
    """Joins every sample to the start."""
    return rrt_by(
        problem,
        step,
        goal_bias,
        iterations,
        rng,
        choose=lambda p, nodes, q: 0,
        steer=lambda problem, a, b, step: b,
    )


@wrong("rrt")
def farthest_for_nearest(problem, step, goal_bias, iterations, rng):
    """Uses argmax."""
    return rrt_by(
        problem,
        step,
        goal_bias,
        iterations,
        rng,
        choose=lambda p, nodes, q: int(np.argmax([p.distance(node, q) for node in nodes])),
    )


@wrong("rrt")
def the_last_node(problem, step, goal_bias, iterations, rng):
    """Always extends the last node, which gives a random walk."""
    return rrt_by(
        problem, step, goal_bias, iterations, rng, choose=lambda problem, nodes, q: len(nodes) - 1
    )


@wrong("rrt")
def nearest_to_the_goal(problem, step, goal_bias, iterations, rng):
    """Always extends the node nearest to the goal."""
    return rrt_by(
        problem,
        step,
        goal_bias,
        iterations,
        rng,
        choose=lambda p, nodes, q: nearest(p, nodes, p.goal),
    )


@wrong("rrt")
def whole_way_to_the_sample(problem, step, goal_bias, iterations, rng):
    """Does not steer."""
    return rrt_by(problem, step, goal_bias, iterations, rng, steer=lambda problem, a, b, step: b)


@wrong("rrt")
def unit_steps(problem, step, goal_bias, iterations, rng):
    """Takes a whole step even past a sample that is nearer."""
    return rrt_by(
        problem,
        step,
        goal_bias,
        iterations,
        rng,
        steer=lambda p, a, b, step: a + 1.2 * step * (b - a) / max(p.distance(a, b), 1e-12),
    )


@wrong("rrt")
def corner_samples(problem, step, goal_bias, iterations, rng):
    """Draws from the unit square."""
    return rrt_by(
        problem, step, goal_bias, iterations, rng, draw=lambda problem, rng: rng.random(2)
    )


@wrong("rrt")
def samples_near_the_start(problem, step, goal_bias, iterations, rng):
    """Draws from half of the room."""
    return rrt_by(
        problem,
        step,
        goal_bias,
        iterations,
        rng,
        draw=lambda problem, rng: 0.7 * problem.sample(rng),
    )


@wrong("rrt")
def only_towards_the_goal(problem, step, goal_bias, iterations, rng):
    """Always draws the goal."""
    return rrt_by(problem, step, 1.0, min(iterations, 300), rng)


@wrong("rrt")
def parents_from_one(problem, step, goal_bias, iterations, rng):
    """Returns parents that are one too large."""
    nodes, parent, path = rrt_by(problem, step, goal_bias, iterations, rng)
    return nodes, [-1, *(p + 1 for p in parent[1:])], path


@wrong("rrt")
def backwards(problem, step, goal_bias, iterations, rng):
    """Returns the path in reverse."""
    nodes, parent, path = rrt_by(problem, step, goal_bias, iterations, rng)
    return nodes, parent, None if path is None else path[::-1]


@wrong("rrt")
def nearly_there(problem, step, goal_bias, iterations, rng):
    """Ends the path before the goal."""
    nodes, parent, path = rrt_by(problem, step, goal_bias, iterations, rng)
    return (nodes, parent, None) if path is None else (nodes[:-1], parent[:-1], path[:-1])


@wrong("rrt")
def all_nodes_for_the_path(problem, step, goal_bias, iterations, rng):
    """Returns all nodes as the path."""
    nodes, parent, path = rrt_by(problem, step, goal_bias, iterations, rng)
    return nodes, parent, None if path is None else nodes


@wrong("rrt")
def straight_at_the_end(problem, step, goal_bias, iterations, rng):
    """Goes straight from the nearest node to the goal where no path was found."""
    nodes, parent, path = rrt_by(problem, step, goal_bias, iterations, rng)
    if path is None:
        path = [*way_up(nodes, parent, nearest(problem, nodes, problem.goal))[::-1], problem.goal]
    return nodes, parent, path


@wrong("rrt")
def start_left_out(problem, step, goal_bias, iterations, rng):
    """Stops at parent[node] != -1."""
    nodes, parent, path = rrt_by(problem, step, goal_bias, iterations, rng)
    return nodes, parent, None if path is None else (path[1:] if len(path) > 1 else path)


@wrong("rrt")
def global_chance(problem, step, goal_bias, iterations, rng):
    """Uses NumPy's global generator."""
    return rrt_by(problem, step, goal_bias, iterations, np.random.randint(10**6))


@wrong("rrt")
def seeds_the_world(problem, step, goal_bias, iterations, rng):
    """Seeds and uses Python's global generator."""
    random.seed(rng)
    return rrt_by(problem, step, goal_bias, iterations, random.randrange(10**6))


@wrong("rrt")
def never_the_same(problem, step, goal_bias, iterations, rng):
    """Uses a generator without a seed."""
    return rrt_by(problem, step, goal_bias, iterations, None)


@wrong("rrt")
def always_the_same(problem, step, goal_bias, iterations, rng):
    """Uses the seed 0."""
    return rrt_by(problem, step, goal_bias, iterations, 0)


@wrong("rrt")
def many_nodes_at_once(problem, step, goal_bias, iterations, rng):
    """Extends as far as possible in every iteration."""
    rng = np.random.default_rng(rng)
    nodes, parent = [problem.start], [-1]
    for _ in range(iterations):
        q_rand = problem.sample(rng)
        near = nearest(problem, nodes, q_rand)
        while problem.distance(nodes[near], q_rand) > 0 and len(nodes) < 700:
            q_new = problem.steer(nodes[near], q_rand, step / 4)
            if not problem.is_free_path(nodes[near], q_new):
                break
            nodes.append(q_new)
            parent.append(near)
            near = nearest(problem, nodes, q_rand)
    return nodes, parent, None


@wrong("rrt")
def ignores_the_bias(problem, step, goal_bias, iterations, rng):
    """Ignores goal_bias."""
    return rrt_by(problem, step, 0.0, iterations, rng)


@wrong("rrt")
def asks_for_the_whole_way(problem, step, goal_bias, iterations, rng):
    """Checks the motion to the sample, far beyond the step that it adds."""
    rng = np.random.default_rng(rng)
    nodes, parent = [problem.start], [-1]
    for _ in range(iterations):
        if problem.distance(nodes[-1], problem.goal) <= step and problem.is_free_path(
            nodes[-1], problem.goal
        ):
            nodes.append(problem.goal)
            parent.append(len(nodes) - 2)
            return nodes, parent, way_up(nodes, parent, len(nodes) - 1)[::-1]
        q_rand = problem.goal if rng.random() < goal_bias else problem.sample(rng)
        near = nearest(problem, nodes, q_rand)
        if problem.is_free_path(nodes[near], q_rand):
            nodes.append(problem.steer(nodes[near], q_rand, step))
            parent.append(near)
    return nodes, parent, None


@wrong("rrt")
def waits_for_the_goal_as_a_sample(problem, step, goal_bias, iterations, rng):
    """Reaches the goal only by a step towards a sample that is the goal."""
    return rrt_by(
        problem,
        step,
        goal_bias,
        iterations,
        rng,
        accepts_goal=lambda p, a, b: p.distance(a, b) == 0.0,
    )


@wrong("rrt")
def half_a_step(problem, step, goal_bias, iterations, rng):
    """Takes steps of half the length."""
    return rrt_by(
        problem,
        step,
        goal_bias,
        iterations,
        rng,
        steer=lambda problem, a, b, step: problem.steer(a, b, step / 2),
    )


@wrong("rrt")
def gives_up_soon(problem, step, goal_bias, iterations, rng):
    """Makes ten iterations."""
    return rrt_by(problem, step, goal_bias, 10, rng)


# RRT-Connect


def two_trees(
    problem,
    step,
    iterations,
    rng,
    *,
    accepts=is_free_path,
    steps=10**6,
    accepts_last=is_free_path,
    choose=nearest,
):
    """Grow two trees; each argument that is given replaces a part."""
    rng = np.random.default_rng(rng)
    trees = [([problem.start], [-1]), ([problem.goal], [-1])]
    for turn in range(iterations):
        here, there = trees[turn % 2], trees[1 - turn % 2]
        q_new = problem.sample(rng)
        near = choose(problem, here[0], q_new)
        q_new = problem.steer(here[0][near], q_new, step)
        if not accepts(problem, here[0][near], q_new):
            continue
        here[0].append(q_new)
        here[1].append(near)
        for _ in range(steps):
            near = choose(problem, there[0], q_new)
            q = problem.steer(there[0][near], q_new, step)
            last = problem.distance(q, q_new) == 0.0
            if not (accepts_last if last else accepts)(problem, there[0][near], q):
                break
            there[0].append(q)
            there[1].append(near)
            if last:
                ways = [way_up(*tree, len(tree[0]) - 1) for tree in trees]
                return *trees[0], *trees[1], [*ways[0][::-1], *ways[1][1:]]
    return *trees[0], *trees[1], None


@wrong("rrt_connect")
def bridge_unchecked(problem, step, iterations, rng):
    """Does not check the motion that joins the trees."""
    return two_trees(problem, step, iterations, rng, accepts_last=lambda problem, a, b: True)


@wrong("rrt_connect")
def one_step_each(problem, step, iterations, rng):
    """Extends by one step where it should connect."""
    return two_trees(problem, step, iterations, rng, steps=1)


@wrong("rrt_connect")
def free_places(problem, step, iterations, rng):
    """Checks points instead of motions."""

    def free_end(problem, a, b):
        return problem.is_free(b)

    return two_trees(problem, step, iterations, rng, accepts=free_end, accepts_last=free_end)


@wrong("rrt_connect")
def from_the_newest(problem, step, iterations, rng):
    """Grows from the last node instead of the nearest."""
    return two_trees(
        problem, step, min(iterations, 200), rng, choose=lambda problem, nodes, q: len(nodes) - 1
    )


@wrong("rrt_connect")
def swapped_after_a_turn(problem, step, iterations, rng):
    """Returns the goal's tree first."""
    a, b, c, d, path = two_trees(problem, step, iterations, rng)
    return c, d, a, b, path


@wrong("rrt_connect")
def second_half_reversed(problem, step, iterations, rng):
    """Goes on from the goal to the meeting point."""
    a, b, c, d, path = two_trees(problem, step, iterations, rng)
    if path is None:
        return a, b, c, d, None
    return a, b, c, d, [*way_up(a, b, len(a) - 1)[::-1], *way_up(c, d, len(c) - 1)[::-1]]


@wrong("rrt_connect")
def from_goal_to_start(problem, step, iterations, rng):
    """Returns the path in reverse."""
    *trees, path = two_trees(problem, step, iterations, rng)
    return *trees, None if path is None else path[::-1]


@wrong("rrt_connect")
def up_to_the_meeting_place(problem, step, iterations, rng):
    """Leaves out the goal's half."""
    a, b, c, d, path = two_trees(problem, step, iterations, rng)
    return a, b, c, d, None if path is None else way_up(a, b, len(a) - 1)[::-1]


@wrong("rrt_connect")
def jump_across(problem, step, iterations, rng):
    """Joins the newest nodes of both trees at the end, whatever is between."""
    a, b, c, d, _ = two_trees(problem, step, iterations, rng)
    return a, b, c, d, [*way_up(a, b, len(a) - 1)[::-1], *way_up(c, d, len(c) - 1)]


@wrong("rrt_connect")
def chance_without_seed(problem, step, iterations, rng):
    """Returns another answer each time."""
    return two_trees(problem, step, iterations, None)


@wrong("rrt_connect")
def one_seed_for_all(problem, step, iterations, rng):
    """Returns the same answer for every seed."""
    return two_trees(problem, step, iterations, 7)


@wrong("rrt_connect")
def steps_twice_as_long(problem, step, iterations, rng):
    """Takes steps of twice the length."""
    return two_trees(problem, 2 * step, iterations, rng)


@wrong("rrt_connect")
def one_tree_alone(problem, step, iterations, rng):
    """Is an RRT, with only the goal as the other tree."""
    nodes, parent, path = rrt_by(problem, step, 0.0, iterations, rng)
    return nodes, parent, [problem.goal], [-1], path


# One insertion of RRT*


def put_in(problem, nodes, parent, cost, q_new, radius, *, price=lambda c, d: c + d, depth=10**6):
    """Insert a node as RRT* does; each argument that is given replaces a part."""
    n, parent, cost = len(nodes), list(parent), list(cost)
    apart = [problem.distance(q, q_new) for q in nodes]
    near = [i for i in range(n) if apart[i] <= radius and problem.is_free_path(nodes[i], q_new)]
    best = min(near, key=lambda i: price(cost[i], apart[i]))
    parent.append(best)
    cost.append(cost[best] + apart[best])
    for i in near:
        if cost[n] + apart[i] < cost[i]:
            gain = cost[i] - cost[n] - apart[i]
            parent[i] = n
            cost[i] -= gain
            below = [i]
            for _ in range(depth):
                below = [j for j in range(n) if parent[j] in below and j not in below]
                for j in below:
                    cost[j] -= gain
                if not below:
                    break
    return parent, cost


@wrong("insert", slip="nearest")
def nearest_parent(*given):
    """Takes the nearest neighbour as the parent, as RRT does."""
    return put_in(*given, price=lambda c, d: d)


@wrong("insert", slip="no_rewiring")
def parent_only(problem, nodes, parent, cost, q_new, radius):
    """Does not rewire."""
    apart = [problem.distance(q, q_new) for q in nodes]
    near = [
        i for i in range(len(nodes)) if apart[i] <= radius and problem.is_free_path(nodes[i], q_new)
    ]
    best = min(near, key=lambda i: cost[i] + apart[i])
    return [*parent, best], [*cost, cost[best] + apart[best]]


@wrong("insert", slip="not_below")
def cost_not_propagated(*given):
    """Does not update the costs of descendants."""
    return put_in(*given, depth=0)


@wrong("insert", slip="unchecked")
def through_walls(problem, nodes, parent, cost, q_new, radius):
    """Checks no motion."""

    class NoWalls:
        distance = staticmethod(problem.distance)

        @staticmethod
        def is_free_path(a, b):
            return True

    return put_in(NoWalls, nodes, parent, cost, q_new, radius)


@wrong("insert")
def children_but_not_theirs(*given):
    """Updates the costs of children only."""
    return put_in(*given, depth=1)


@wrong("insert")
def cheapest_node(*given):
    """Takes the neighbour of least cost, however far away it is."""
    return put_in(*given, price=lambda c, d: c)


@wrong("insert")
def all_neighbours_rewired(problem, nodes, parent, cost, q_new, radius):
    """Rewires neighbours even where that is more expensive."""
    parents, costs = put_in(problem, nodes, parent, cost, q_new, radius)
    for i in range(1, len(nodes)):
        apart = problem.distance(nodes[i], q_new)
        if apart <= radius and i != parents[-1] and problem.is_free_path(nodes[i], q_new):
            parents[i], costs[i] = len(nodes), costs[-1] + apart
    return parents, costs


@wrong("insert")
def costs_not_updated(problem, nodes, parent, cost, q_new, radius):
    """Changes parents, but not costs."""
    parents, costs = put_in(problem, nodes, parent, cost, q_new, radius)
    return parents, [*cost, costs[-1]]


@wrong("insert")
def new_from_one(*given):
    """Counts the new node from 1."""
    parents, costs = put_in(*given)
    return [p + 1 if p == len(parents) - 1 else p for p in parents[:-1]] + [parents[-1] + 1], costs


@wrong("insert")
def everybody_is_a_neighbour(problem, nodes, parent, cost, q_new, radius):
    """Ignores the radius."""
    return put_in(problem, nodes, parent, cost, q_new, 1e9)


@wrong("insert")
def nearer_than_the_radius(problem, nodes, parent, cost, q_new, radius):
    """Leaves out a node that is exactly at the radius."""
    return put_in(problem, nodes, parent, cost, q_new, np.nextafter(radius, 0.0))


@wrong("insert")
def costs_in_order_of_numbers(problem, nodes, parent, cost, q_new, radius):
    """Recomputes all costs in order, as if every parent came before its child."""
    parents, costs = put_in(problem, nodes, parent, cost, q_new, radius, depth=0)
    for i in range(len(nodes)):
        if 0 <= parents[i] < len(nodes):
            costs[i] = costs[parents[i]] + problem.distance(nodes[parents[i]], nodes[i])
    return parents, costs


@wrong("insert")
def neighbours_of_the_start(problem, nodes, parent, cost, q_new, radius):
    """Takes the distance to the start for the cost."""
    parents, costs = put_in(problem, nodes, parent, cost, q_new, radius)
    return parents, [*costs[:-1], problem.distance(nodes[0], q_new)]


# The stretch of a plan


@wrong("follow", slip="to_the_corner")
def on_to_the_next_corner(problem, path, horizon):
    """Follows whole motions only."""
    gone = [path[0]]
    for a, b in zip(path, path[1:]):
        if horizon <= 0 or not problem.is_free_path(a, b):
            break
        gone.append(b)
        horizon -= problem.distance(a, b)
    return gone


@wrong("follow", slip="before_the_corner")
def last_corner_before(problem, path, horizon):
    """Does not follow a part of a motion."""
    gone = [path[0]]
    for a, b in zip(path, path[1:]):
        horizon -= problem.distance(a, b)
        if horizon < -1e-12 or not problem.is_free_path(a, b):
            break
        gone.append(b)
    return gone


@wrong("follow", slip="trusting")
def trusts_the_plan(problem, path, horizon):
    """Checks no motion."""
    gone = [path[0]]
    for a, b in zip(path, path[1:]):
        if horizon <= 0:
            break
        gone.append(problem.steer(a, b, horizon))
        horizon -= problem.distance(a, b)
    return gone


@wrong("follow", slip="each_within")
def horizon_for_each(problem, path, horizon):
    """Forgets to subtract from the horizon."""
    gone = [path[0]]
    for a, b in zip(path, path[1:]):
        q = problem.steer(a, b, horizon)
        if not problem.is_free_path(a, q):
            break
        gone.append(q)
        if (q != b).any():
            break
    return gone


@wrong("follow")
def as_the_crow_flies(problem, path, horizon):
    """Measures from the robot straight to every corner."""
    gone = [path[0]]
    for a, b in zip(path, path[1:]):
        q = problem.steer(a, b, horizon - problem.distance(path[0], a))
        if problem.distance(path[0], a) >= horizon or not problem.is_free_path(a, q):
            break
        gone.append(q)
    return gone


@wrong("follow", slip="asking_beyond")
def whole_motion_asked(problem, path, horizon):
    """Checks motions also beyond the horizon."""
    gone = [path[0]]
    for a, b in zip(path, path[1:]):
        if horizon <= 0 or not problem.is_free_path(a, b):
            break
        gone.append(problem.steer(a, b, horizon))
        horizon -= problem.distance(a, b)
    return gone


@wrong("follow")
def end_only(problem, path, horizon):
    """Returns only the last point."""
    return trusts_the_plan.function(problem, path, horizon)[-1:]


@wrong("follow")
def without_the_beginning(problem, path, horizon):
    """Leaves out the first point."""
    return trusts_the_plan.function(problem, path, horizon)[1:]


@wrong("follow")
def same_row_again(problem, path, horizon):
    """Adds a motion of length 0 at the horizon."""
    gone = [path[0]]
    for a, b in zip(path, path[1:]):
        q = problem.steer(a, b, max(horizon, 0.0)) if horizon > 0 else a
        if not problem.is_free_path(a, q):
            break
        gone.append(q)
        horizon -= problem.distance(a, b)
    return gone


@wrong("follow")
def jumps_over_what_is_in_the_way(problem, path, horizon):
    """Has `continue` instead of `break`."""
    gone = [path[0]]
    for a, b in zip(path, path[1:]):
        q = problem.steer(a, b, horizon)
        if horizon <= 0 or not problem.is_free_path(a, q):
            continue
        gone.append(q)
        horizon -= problem.distance(a, b)
    return gone


# Break it


@wrong("exposing_room")
def all_is_free():
    """Gives a triangle that is in no motion's way."""
    return (1, 1), (9, 9), [(4, 1), (6, 1), (5, 2)]


@wrong("exposing_room")
def goal_in_the_triangle():
    """Gives an invalid problem."""
    return (1, 1), (5, 5), [(4, 4), (6, 4), (5, 7)]


@wrong("exposing_room")
def thick_wall():
    """Gives a goal farther than a step from every reachable point."""
    return (1, 1), (9.5, 9.5), [(4, 12), (12, 4), (6, 6)]


@wrong("exposing_room")
def one_line():
    """Gives a triangle without an interior."""
    return (1, 1), (9, 1), [(5, 0), (5, 5), (5, 9)]


@wrong("exposing_room")
def round_the_end():
    """Blocks the straight motion, but not the path around the wall."""
    return (4.8, 5), (5.4, 5), [(5, 2), (5.2, 2), (5.1, 8)]


@wrong("exposing_room")
def outside():
    """Gives a goal outside the room."""
    return (1, 1), (11, 5), [(9, 4), (9.5, 4), (9.2, 6)]

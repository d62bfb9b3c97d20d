"""The midterm on lessons 1 to 8. Every answer is computed by the library.

Each function draws numbers with which one can compute by hand. It returns the text, the answer, and
how one comes to it.
"""

import numpy as np

import kinoedu as ke
from kinoedu.course.midterm import Asked, midterm_question
from kinoedu.planners.roadmaps.connecting import connect_nodes


def number(value):
    """A number as it is written by hand."""
    return f"{round(float(value), 6) + 0.0:g}"


def place(point):
    """A point as it is written by hand."""
    return f"({number(point[0])}, {number(point[1])})"


@midterm_question("01_geometry", points=6)
def segment_and_line(rng):
    """Beyond the end of a level segment, by a triangle 3, 4, 5."""
    k, (x, y), length = rng.integers(1, 4), rng.integers(-5, 6, 2), rng.integers(2, 9)
    p1, p2 = np.array([x, y], float), np.array([x + length, y], float)
    q = p2 + k * np.array([3, 4])
    segment = ke.geometry.point_segment_distance(q, p1, p2)
    line = ke.geometry.point_line_distance(q, p1, p2)
    t = (q - p1) @ (p2 - p1) / length**2
    return Asked(
        f"A wall is the segment from p1 = {place(p1)} to p2 = {place(p2)}. A robot is at q = "
        f"{place(q)}.\n(a) How far is it from the wall? (b) And from the line through p1 and p2? "
        f"(c) Compute t, the share of the way from p1 to p2 at which the foot of the perpendicular "
        f"lies, and say why (a) and (b) differ.",
        f"(a) {number(segment)}, (b) {number(line)}, (c) t = {number(3 * k + length)}/{length}",
        f"t = (q - p1)·(p2 - p1) / |p2 - p1|² = {3 * k + length}/{length}: {t:.3g} is more than 1, "
        f"so the segment ends before the foot, so its nearest point is p2, and the distance is "
        f"√({3 * k}² + {4 * k}²) = {number(segment)}. The line does not end: {number(line)}.",
    )


@midterm_question("02_bug_algorithms", points=6)
def round_a_box(rng):
    """Bug 1 and Bug 2 round one box."""
    a, width, up, down = (int(n) for n in rng.integers((2, 1, 1, 4), (5, 5, 4, 7)))
    goal = a + width + int(rng.integers(2, 5))
    box = np.array([(a, -down), (a + width, -down), (a + width, up), (a, up)], float)
    bugs = [bug((0.0, 0.0), (float(goal), 0.0), [box], 1.0) for bug in (ke.bug1, ke.bug2)]
    one, two = (plan.cost for plan in bugs)
    around = 2 * (width + up + down)
    return Asked(
        f"The only obstacle is the box with the corners {place(box[0])}, {place(box[1])}, "
        f"{place(box[2])}, {place(box[3])}. The start is (0, 0), the goal ({goal}, 0). The bugs "
        f"turn left at a wall.\nHow far does (a) Bug 2, (b) Bug 1 walk? (c) Compare (b) with the "
        f"bound for Bug 1.",
        f"(a) {number(two)}, (b) {number(one)}, (c) the bound is {number(goal + 1.5 * around)}",
        f"Bug 2 goes up {up}, across {width}, down {up}, and leaves where it meets the line: "
        f"{goal} + 2 · {up} = {number(two)}. Bug 1 goes once round, {around}, and then the shorter "
        f"way, {width} + 2 · {up}, to ({a + width}, 0): {goal - width} + {around} + "
        f"{width + 2 * up} = {number(one)}. The bound is {goal} + 3/2 · {around}: the way to the "
        f"leave point is shorter than half of the round.",
    )


@midterm_question("03_decomposition", points=5)
def count_the_cells(rng):
    """Triangles in a slanted room, all vertices at different x."""
    n = int(rng.integers(2, 8))
    room = [(0.0, 0.0), (100.0, 1.0), (99.0, 50.0), (1.0, 49.0)]
    triangles = []
    for i in range(n):
        x, y = 5 + 12 * i + rng.uniform(0, 1), rng.uniform(10, 30)
        triangles.append([(x, y), (x + 7.1, y + 1), (x + 3.3, y + 6)])
    cells = len(ke.trapezoidation(ke.PolygonWorld(room, triangles)).trapezoids)
    without = len(ke.trapezoidation(ke.PolygonWorld(room, [])).trapezoids)
    return Asked(
        f"A room with four corners and {n} triangles in it are cut into trapezoids. No two "
        f"vertices have the same x.\n(a) How many cells has the empty room? (b) How many are there "
        f"with the triangles? (c) A planner on these cells finds no path for a point. "
        f"Is there one?",
        f"(a) {without}, (b) {cells}, (c) no",
        f"The two inner corners of the empty room cut it into {without}. Where a triangle begins, "
        f"one cell ends and two begin; at its bend one ends and one begins; where it ends, two end "
        f"and one begins. So each adds 2 + 1 + 1 = 4 cells: {without} + 4 · {n} = {cells}. The "
        f"cells cover all the free space, so the planner is complete: without a path in the "
        f"roadmap there is none.",
    )


@midterm_question("04_graph_search", points=7)
def cheapest_path(rng):
    """A small graph in which the fewest edges are not the cheapest."""
    edges = [(0, 1), (0, 2), (1, 2), (1, 3), (2, 3), (2, 4), (3, 4), (3, 5), (4, 5)]
    while True:
        weights = rng.integers(1, 10, len(edges))
        graph = ke.Graph(6, edges, weights)
        cost = ke.dijkstra(graph, 0).cost
        path, _ = ke.astar(graph, 0, 5)
        fewest = ke.bfs_path(graph, 0, 5)
        ways = [cost[a] + w - cost[b] for (a, b), w in zip(edges, weights)]
        ways += [cost[b] + w - cost[a] for (a, b), w in zip(edges, weights)]
        is_tree = ways.count(0) == 5  # each node but the start has one cheapest way
        if is_tree and len(set(cost.tolist())) == 6 and len(path) > len(fewest):
            break
    order = np.argsort(cost).tolist()
    table = ", ".join(f"{a}-{b}: {w}" for (a, b), w in zip(edges, weights))
    return Asked(
        f"A graph has the nodes 0 to 5 and these edges with their weights, in both directions: "
        f"{table}.\n(a) In which order does Dijkstra's algorithm, from node 0, take out the nodes, "
        f"and with which costs? (b) Which is the cheapest path from 0 to 5? (c) How many edges has "
        f"a path that breadth-first search finds?",
        f"(a) {', '.join(f'{v} ({number(cost[v])})' for v in order)}; "
        f"(b) {', '.join(map(str, path))}, cost {number(cost[5])}; (c) {len(fewest) - 1}",
        "Each time the waiting node of the least cost is taken out; its cost is final. "
        "Breadth-first search counts edges and does not know weights.",
    )


@midterm_question("05_configuration_spaces", points=6)
def arm_and_headings(rng):
    """Right angles, so that the tip can be read from a sketch; and the short way round."""
    l1, l2 = sorted(rng.choice(np.arange(1, 7), 2, replace=False), reverse=True)
    turns = rng.integers(-1, 3), rng.choice([-1, 1])
    q = np.array(turns) * np.pi / 2
    elbow, tip = ke.TwoLinkArm(float(l1), float(l2), 0.1).joints(q)
    a, b = int(rng.integers(91, 176)), -int(rng.integers(91, 176))
    far = np.degrees(ke.circle_distance(np.radians(a), np.radians(b)))
    angles = [f"{90 * turn}°" for turn in turns]
    return Asked(
        f"An arm at the origin has the links {l1} and {l2}; the angle of the second link is "
        f"measured from the first.\n(a) Where are elbow and tip for the angles {angles[0]} and "
        f"{angles[1]}? (b) Which distances from the base can the tip have? (c) How far apart are "
        f"the headings {a}° and {b}°?",
        f"(a) {place(np.round(elbow, 9))}, {place(np.round(tip, 9))}; "
        f"(b) from {l1 - l2} to {l1 + l2}; (c) {number(far)}°",
        f"The second link points in the direction {90 * sum(turns)}°. Base, elbow and tip form a "
        f"triangle, so the distance is between the difference and the sum of the links. The "
        f"difference of the numbers is {a - b}°; the other way round is 360° - {a - b}°.",
    )


@midterm_question("06_sampling", points=5)
def grid_and_halton(rng):
    """The hole of Sukharev's grid, a corridor, and one of Halton's points."""
    k, i = int(rng.integers(4, 11)), int(rng.integers(5, 24))
    hole = ke.dispersion(ke.sukharev_grid(k * k), np.inf)
    point = ke.halton(1, start=i)[0]
    halves = int(2 ** np.ceil(np.log2(i + 1)))
    thirds = 3 ** next(e for e in range(9) if 3**e > i)
    x, y = round(point[0] * halves), round(point[1] * thirds)
    return Asked(
        f"(a) How large is the largest hole of Sukharev's grid of {k * k} points in the unit "
        f"square, in the sup norm? (b) How many of its points can lie in a corridor along the "
        f"x-axis, from side to side, that is narrower than 1/{k}? (c) Where is point number {i} of "
        f"Halton's sequence, with the bases 2 and 3?",
        f"(a) 1/{round(1 / hole)}, (b) none or {k}, (c) ({x}/{halves}, {y}/{thirds})",
        f"The points are the middles of cells of side 1/{k}; the cells' corners are 1/{2 * k} "
        f"away. Rows lie in the corridor as a whole or not at all, and two rows are 1/{k} "
        f"apart. {i} is {np.base_repr(i, 2)} in base 2 and {np.base_repr(i, 3)} in base 3; the "
        f"digits are mirrored at the point.",
    )


@midterm_question("07_collision_detection", points=6)
def box_and_triangle(rng):
    """The C-obstacle of a box for a right triangle: the robot is mirrored."""
    (x, y), (w, h) = rng.integers(3, 9, 2), rng.integers(1, 6, 2)
    a, b = rng.integers(1, 4, 2)
    box = np.array([(x, y), (x + w, y), (x + w, y + h), (x, y + h)], float)
    robot = np.array([(0, 0), (a, 0), (0, b)], float)
    grown = ke.geometry.minkowski_difference(box, robot)
    first = min(range(len(grown)), key=lambda i: (grown[i][1], grown[i][0]))
    corners = ", ".join(place(p) for p in np.roll(grown, -first, axis=0))
    return Asked(
        f"The robot is the triangle (0, 0), ({a}, 0), (0, {b}); its reference point is (0, 0), and "
        f"it does not turn. The obstacle is the box with the corners {', '.join(map(place, box))}."
        f"\n(a) Give the corners of the C-obstacle. (b) A program tests whether a corner of the "
        f"robot is in the box, or a corner of the box in the robot. Sketch two positions of convex "
        f"bodies for which such a program is wrong.",
        f"(a) {corners}; (b) two bodies whose edges cross, such as two long bars",
        "At q the robot's point b lies at q + b. It is a point of the box where q = a - b: add to "
        "each corner of the box the mirrored robot, and take the convex hull. Two bars that cross "
        "have no corner in each other.",
    )


@midterm_question("08_roadmaps", points=5)
def closest_on_a_line(rng):
    """Nodes on a line, all gaps different, and the rule of the K closest."""
    gaps, k = rng.permutation([1, 2, 3, 4, 5, 6]), int(rng.integers(1, 3))
    xs = np.concatenate([[0], np.cumsum(gaps)]).astype(float)
    nodes = np.column_stack([xs, np.ones(len(xs))])
    world = ke.PolygonWorld([(-1, 0), (99, 0), (99, 2), (-1, 2)], [])
    problem = ke.Problem(ke.Point(), world, nodes[0], nodes[-1])
    edges, _ = connect_nodes(ke.KClosest(k), problem, nodes)
    pairs = sorted((min(e), max(e)) for e in edges.tolist())
    degree = np.bincount(np.ravel(pairs))
    return Asked(
        f"Seven nodes, numbered 0 to 6 from left to right, lie on the x-axis at "
        f"{', '.join(map(number, xs))}. There are no obstacles. They are joined by the rule of the "
        f"K closest, with K = {k}; of equally close nodes the one with the lower number counts.\n"
        f"(a) Which edges are there? (b) Which is the largest number of edges of a node, and why "
        f"can it be more than K?",
        f"(a) {', '.join(f'{a}-{b}' for a, b in pairs)}; (b) {degree.max()}",
        "Each node chooses its closest ones; an edge is there if one of its ends has chosen the "
        "other. So a node has an edge to each node by which it was chosen, too.",
    )

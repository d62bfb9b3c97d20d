"""Wrong answers to the exercises of lesson 2. Most walk exactly and make one mistake."""

from pathlib import Path

import numpy as np

from kinoedu.course.bank import Solutions, wrong
from kinoedu.course.lessons.bugs.exposing_problem import mended_bug0
from kinoedu.geometry import point_polygon_distance, polygon_tangent
from kinoedu.geometry.leash import densify_path
from kinoedu.planners import bug0, bug1, bug2, bug2_prelim, bug_base

changed = Solutions(Path(__file__).parents[1] / "02_bug_algorithms.ipynb").changed

# BugBase


@wrong("bug_base")
def blind(start, goal, obstacles, step):
    """Ignores all obstacles."""
    return densify_path([start, goal], step)


@wrong("bug_base")
def in_one_leap(start, goal, obstacles, step):
    """Goes from start to end in a single step."""
    return bug_base(start, goal, obstacles, step).walk.points[[0, -1]]


@wrong("bug_base")
def keeps_too_far_away(start, goal, obstacles, step):
    """Stops twenty steps before the wall."""
    path = bug_base(start, goal, obstacles, step).walk.points
    return (
        path
        if not len(bug_base(start, goal, obstacles, step).walk.hit)
        else path[: max(1, len(path) - 20)]
    )


@wrong("bug_base")
def forgets_the_goal(start, goal, obstacles, step):
    """Stops when the goal is nearer than five steps."""
    path = bug_base(start, goal, obstacles, step).walk.points
    return path[np.linalg.norm(path - goal, axis=1) > 5 * step]


@wrong("bug_base")
def sees_the_first_obstacle_only(start, goal, obstacles, step):
    """Looks at obstacles[0] and at no other."""
    return bug_base(start, goal, obstacles[:1], step).walk.points


@wrong("bug_base")
def sees_the_last_obstacle_only(start, goal, obstacles, step):
    """Keeps only the distance to the last obstacle of its loop."""
    return bug_base(start, goal, obstacles[-1:], step).walk.points


@wrong("bug_base")
def sees_two_obstacles_only(start, goal, obstacles, step):
    """Looks at obstacles[0] and obstacles[1]."""
    return bug_base(start, goal, obstacles[:2], step).walk.points


@wrong("bug_base")
def sees_the_obstacle_nearest_to_the_start(start, goal, obstacles, step):
    """Takes for granted that the nearest obstacle is the one that is hit."""
    nearest = sorted(obstacles, key=lambda wall: point_polygon_distance(start, wall))[:1]
    return bug_base(start, goal, nearest, step).walk.points


# the usual step in place of the given one
hits_at_a_fixed_distance = changed("bug_base", ("wall) < step", "wall) < 0.05"))
moves_by_a_fixed_step = changed("bug_base", ("goal, step))", "goal, 0.05))"))
first_bug_of_fixed_steps = changed(
    "bug1", ("    def round_trip", "    step = 0.05\n\n    def round_trip")
)
second_bug_of_fixed_steps = changed("bug2", ("    def side", "    step = 0.05\n\n    def side"))


@wrong("bug_base")
def where_it_ends(start, goal, obstacles, step):
    """Returns the last point, not the path."""
    return bug_base(start, goal, obstacles, step).path[-1] if not obstacles else start


@wrong("bug_base")
def the_same_array_each_time(start, goal, obstacles, step):
    """Uses q += ... on the array that it appends."""
    path = bug_base(start, goal, obstacles, step).walk.points
    return np.repeat(path[-1:], len(path), axis=0)


@wrong("bug_base")
def moves_the_start(start, goal, obstacles, step):
    """Uses q += ... on the given array."""
    path = bug_base(start, goal, obstacles, step).walk.points
    start += path[-1] - path[0]
    return path


@wrong("bug_base")
def stops_beside_a_wall(start, goal, obstacles, step):
    """Treats every obstacle as one in the way."""
    path = bug_base(start, goal, obstacles, step).walk.points
    return path[: len(path) // 2] if obstacles else path


@wrong("bug_base")
def without_the_start(start, goal, obstacles, step):
    """The path begins with the first step."""
    return bug_base(start, goal, obstacles, step).walk.points[1:]


@wrong("bug_base")
def never_arrives(start, goal, obstacles, step):
    """Steps over the goal and back forever."""
    q = start
    while (q != goal).any():
        q = q + 0.7 * step * (goal - q) / np.linalg.norm(goal - q)


# Bug 1


@wrong("bug1")
def bug_0(start, goal, obstacles, step):
    """Leaves the wall as soon as the way to the goal is free."""
    return bug0(start, goal, obstacles, step).walk.points


@wrong("bug1")
def bug_2(start, goal, obstacles, step):
    """Leaves the wall where the line is met."""
    return bug2(start, goal, obstacles, step).walk.points


def pieces(start, goal, obstacles, step):
    """The exact walk, cut at its hits and leaves: for each wall the round and the way back."""
    walk = bug1(start, goal, obstacles, step, way_back="same").walk
    return walk.points, walk.hit, walk.leave


@wrong("bug1")
def does_not_close_the_circle(start, goal, obstacles, step):
    """Leaves at the point nearest to the goal before it has completed the round."""
    points, hits, leaves = pieces(start, goal, obstacles, step)
    parts, begin = [], 0
    for hit, leave in zip(hits, leaves):
        round_end = (
            hit + int(np.linalg.norm(points[hit + 1 : leave] - points[leave], axis=1).argmin()) + 1
        )
        parts += [points[begin : hit + 1], points[hit + 1 : round_end]]
        begin = leave
    return np.concatenate([*parts, points[begin:]])


@wrong("bug1")
def jumps_back(start, goal, obstacles, step):
    """Jumps to the nearest point after the round."""
    points, hits, leaves = pieces(start, goal, obstacles, step)
    parts, begin = [], 0
    for hit, leave in zip(hits, leaves):
        home = (
            hit + 9 + int(np.linalg.norm(points[hit + 10 : leave] - points[hit], axis=1).argmin())
        )
        parts.append(points[begin:home])
        begin = leave
    return np.concatenate([*parts, points[begin:]])


@wrong("bug1")
def leaves_at_the_hit(start, goal, obstacles, step):
    """After the round it goes on through the wall from the hit."""
    points, hits, _ = pieces(start, goal, obstacles, step)
    return densify_path([start, *points[hits], goal], step)


@wrong("bug1")
def ignores_the_second_obstacle(start, goal, obstacles, step):
    """Sees only the first obstacle."""
    return bug1(start, goal, obstacles[:1], step).walk.points


@wrong("bug1")
def ends_at_the_nearest_point(start, goal, obstacles, step):
    """Stops at the nearest point."""
    points, _, leaves = pieces(start, goal, obstacles, step)
    return points[: leaves[0] + 1] if len(leaves) else points


@wrong("bug1")
def goes_round_for_ever(start, goal, obstacles, step):
    """Waits until it is exactly at the hit."""
    path = bug_base(start, goal, obstacles, step).walk.points
    while (path[-1] != goal).any():
        pass
    return path


# a small obstacle is behind it by then
a_hundred_steps_at_least = changed("bug1", ("len(tour) < 10", "len(tour) < 100"))
# the round ends where the goal is ten steps farther than at the nearest point so far
half_a_round = changed(
    "bug1",
    (
        "len(tour) < 10 or math.dist(tour[-1], hit) > step:",
        "min(math.dist(q, goal) for q in tour) > math.dist(tour[-1], goal) - 10 * step:",
    ),
    ("while math.dist(path[-1], goal) > 0:", "while 0 < math.dist(path[-1], goal) < 50:"),
    (
        "    path += [towards",
        "    if len(path) > 3000:\n            break\n        path += [towards",
    ),
)


# Bug 2


LEAVES = "while not met or math.dist(walk[-1], goal) > math.dist(hit, goal) - step:"
# "nearer" compares the x alone
nearer_in_x = changed(
    "bug2",
    (
        LEAVES,
        """while len(walk) < 2000 and (
            not met or abs(walk[-1][0] - goal[0]) > abs(hit[0] - goal[0]) - step
        ):""",
    ),
)
# leaves where it is left of the line and nearer than the hit, far from the line too
left_of_the_line = changed(
    "bug2", ("met = side(walk[-2]) * side(walk[-1]) <= 0", "met = side(walk[-1]) > 0")
)


@wrong("bug2")
def leaves_anywhere_on_the_line(start, goal, obstacles, step):
    """Bug2.prelim: leaves also where the line is met farther from the goal; walks in a circle."""
    return bug2_prelim(start, goal, obstacles, step, turn="left").walk.points


@wrong("bug2")
def leaves_anywhere_turning_right(start, goal, obstacles, step):
    """The same, turning right."""
    return bug2_prelim(start, goal, obstacles, step, turn="right").walk.points


@wrong("bug2")
def farther_from_the_start(start, goal, obstacles, step):
    """Leaves where the infinite line is met farther from the start than the hit.

    It walks in steps and turns right.
    """

    def side(q):
        return np.sign(np.linalg.det([goal - start, q - start]))

    def in_the_way(q):
        far = [point_polygon_distance(q, wall) for wall in obstacles]
        near = [
            point_polygon_distance(q + step / 10 * (goal - q) / np.linalg.norm(goal - q), wall)
            for wall in obstacles
        ]
        return next(
            (wall for wall, a, b in zip(obstacles, far, near, strict=True) if a < step and b < a),
            None,
        )

    def along(q, wall):
        ahead = q + 0.7 * step * polygon_tangent(q, wall)
        x, y = polygon_tangent(ahead, wall)
        return ahead + (step / 2 - point_polygon_distance(ahead, wall)) * np.array([y, -x])

    path = [start]
    while np.linalg.norm(path[-1] - goal) > step and len(path) < 5000:
        hit, wall = path[-1], in_the_way(path[-1])
        if wall is None:
            path.append(hit + step * (goal - hit) / np.linalg.norm(goal - hit))
            continue
        path.append(along(hit, wall))
        while len(path) < 5000:
            path.append(along(path[-1], wall))
            if side(path[-2]) != side(path[-1]) and np.linalg.norm(
                path[-1] - start
            ) > np.linalg.norm(hit - start):
                break
    return np.array(path)


@wrong("bug2")
def mended_bug_0(start, goal, obstacles, step):
    """Leaves as soon as the way is free and the goal nearer than at the start."""
    return mended_bug0(start, goal, obstacles, step).walk.points


@wrong("bug2")
def first_bug(start, goal, obstacles, step):
    """Goes all the way round."""
    return bug1(start, goal, obstacles, step).walk.points


@wrong("bug2")
def greedy_bug(start, goal, obstacles, step):
    """Leaves the wall as soon as the way to the goal is free."""
    return bug0(start, goal, obstacles, step).walk.points


@wrong("bug2")
def through_the_wall(start, goal, obstacles, step):
    """Keeps to the line through all obstacles."""
    return densify_path([start, goal], step)


@wrong("bug2")
def cuts_corners(start, goal, obstacles, step):
    """Keeps every tenth point only, and goes straight between them."""
    walk = bug2(start, goal, obstacles, step).walk
    return densify_path(walk.points[[0, *walk.hit, *walk.leave[-1:], -1]], step)


@wrong("bug2")
def never_leaves(start, goal, obstacles, step):
    """Stops at the hit."""
    return bug_base(start, goal, obstacles, step).walk.points


@wrong("bug2")
def two_columns_swapped(start, goal, obstacles, step):
    """(y, x) for (x, y)."""
    return bug2(start, goal, obstacles, step).walk.points[:, ::-1]


# Break it

HOOK = [(8, 5), (0, 3), (6, 3), (6, -2)]  # a wall to hit, and one that leads back
POCKET = [(2, -3), (8, -3), (8, 3), (2, 3), (2, 1.8), (6.8, 1.8), (6.8, -1.8), (2, -1.8)]


@wrong("exposing_problem")
def the_pocket_of_the_lesson():
    """The program gets out of this pocket."""
    return (4, 0), (10, 0), [POCKET]


@wrong("exposing_problem")
def the_pocket_from_outside():
    """It exposes the program, but is not the smallest."""
    return (-5, 0), (10, 0), [POCKET]


@wrong("exposing_problem")
def a_box():
    """The program is right on a box."""
    return (0, 0), (6, 0), [[(2, -1), (4, -1), (4, 2), (2, 2)]]


@wrong("exposing_problem")
def nothing_there():
    """No obstacle."""
    return (0, 0), (6, 0), []


@wrong("exposing_problem")
def no_list():
    """One obstacle in place of a list of one."""
    return (-4, 0.5), (10, 0), HOOK


@wrong("exposing_problem")
def goal_inside():
    """The goal is inside an obstacle."""
    return (-4, 0.5), (6.5, 3.5), [HOOK]


@wrong("exposing_problem")
def start_on_the_wall():
    """The start is on a wall."""
    return (0, 3), (10, 0), [HOOK]


@wrong("exposing_problem")
def crossing_edges():
    """The polygon is not simple."""
    return (-4, 0.5), (10, 0), [[(0, 0), (4, 4), (4, 0), (0, 4)]]


@wrong("exposing_problem")
def not_a_number():
    """A coordinate is nan."""
    return (-4, np.nan), (10, 0), [HOOK]


@wrong("exposing_problem")
def beside_the_wrong_arm():
    """The wall that leads back is the right-hand one, but the program turns left."""
    return (-4, -0.5), (10, 0), [[(x, -y) for x, y in HOOK]]


# Long ways and thin walls

a_thousand_steps = changed(
    "bug_base",
    ("math.dist(path[-1], goal) > 0 and", "len(path) < 1000 and math.dist(path[-1], goal) > 0 and"),
)
gives_up_after_a_thousand = changed(
    "bug1",
    (
        "    while math.dist(path[-1], goal) > 0:",
        "    while 0 < math.dist(path[-1], goal) and len(path) < 1000:",
    ),
)
a_thousand_points = changed(
    "bug2",
    (
        "    while math.dist(path[-1], goal) > 0:",
        "    while len(path) < 1000 and math.dist(path[-1], goal) > 0:",
    ),
)
# the line beyond a small obstacle is met before
thirty_steps_at_least = changed(
    "bug2", (LEAVES, LEAVES.replace("not met", "len(walk) < 30 or not met"))
)
much_nearer_than_the_hit = changed(
    "bug2", ("math.dist(hit, goal) - step", "math.dist(hit, goal) - 12 * step")
)

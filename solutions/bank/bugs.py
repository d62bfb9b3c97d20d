"""Wrong answers to the exercises of lesson 2. Most walk exactly, in small steps, and do the wrong thing at one place."""

import numpy as np

from kinoedu.course.bank import wrong
from kinoedu.course.leash import at_most_apart
from kinoedu.planners import bug0, bug1, bug2, bug2_prelim, bug_base

# BugBase


@wrong("bug_base")
def blind(start, goal, obstacles, step):
    """Sees no obstacle."""
    return at_most_apart([start, goal], step)


@wrong("bug_base")
def in_one_leap(start, goal, obstacles, step):
    """No steps between start and end."""
    return bug_base(start, goal, obstacles, step).walk.points[[0, -1]]


@wrong("bug_base")
def keeps_too_far_away(start, goal, obstacles, step):
    """Stops twenty steps before the wall."""
    path = bug_base(start, goal, obstacles, step).walk.points
    return path if not len(bug_base(start, goal, obstacles, step).walk.hit) else path[: max(1, len(path) - 20)]


@wrong("bug_base")
def forgets_the_goal(start, goal, obstacles, step):
    """Stops when the goal is nearer than five steps."""
    path = bug_base(start, goal, obstacles, step).walk.points
    return path[np.linalg.norm(path - goal, axis=1) > 5 * step]


@wrong("bug_base")
def shows_the_first_obstacle_only(start, goal, obstacles, step):
    """Looks at obstacles[0] and at no other."""
    return bug_base(start, goal, obstacles[-1:], step).walk.points + (1e-9 if not obstacles else 0.0)


@wrong("bug_base")
def stops_beside_a_wall(start, goal, obstacles, step):
    """Takes every obstacle for one that is in the way."""
    path = bug_base(start, goal, obstacles, step).walk.points
    return path[: len(path) // 2] if obstacles else path


@wrong("bug_base")
def without_the_start(start, goal, obstacles, step):
    """The path begins with the first step."""
    return bug_base(start, goal, obstacles, step).walk.points[1:]


@wrong("bug_base")
def never_arrives(start, goal, obstacles, step):
    """Steps over the goal and back, for ever."""
    q = start
    while (q != goal).any():
        q = q + 0.7 * step * (goal - q) / np.linalg.norm(goal - q)


# Bug 1


@wrong("bug1")
def bug_0(start, goal, obstacles, step):
    """Leaves as soon as the way to the goal is free."""
    return bug0(start, goal, obstacles, step).walk.points


@wrong("bug1")
def bug_2(start, goal, obstacles, step):
    """Leaves where the line is met."""
    return bug2(start, goal, obstacles, step).walk.points


def pieces(start, goal, obstacles, step):
    """The exact walk, cut at its hits and leaves; for each wall its round and the way back."""
    walk = bug1(start, goal, obstacles, step, way_back="same").walk
    return walk.points, walk.hit, walk.leave


@wrong("bug1")
def does_not_close_the_circle(start, goal, obstacles, step):
    """Leaves at the nearest point of the first round, before it knows that it is the nearest."""
    points, hits, leaves = pieces(start, goal, obstacles, step)
    parts, begin = [], 0
    for hit, leave in zip(hits, leaves):
        round_end = hit + int(np.linalg.norm(points[hit + 1 : leave] - points[leave], axis=1).argmin()) + 1
        parts += [points[begin : hit + 1], points[hit + 1 : round_end]]
        begin = leave
    return np.concatenate([*parts, points[begin:]])


@wrong("bug1")
def jumps_back(start, goal, obstacles, step):
    """After the round it is at the nearest point without walking there."""
    points, hits, leaves = pieces(start, goal, obstacles, step)
    parts, begin = [], 0
    for hit, leave in zip(hits, leaves):
        home = hit + 9 + int(np.linalg.norm(points[hit + 10 : leave] - points[hit], axis=1).argmin())
        parts.append(points[begin:home])
        begin = leave
    return np.concatenate([*parts, points[begin:]])


@wrong("bug1")
def leaves_at_the_hit(start, goal, obstacles, step):
    """After the round it goes on through the wall."""
    points, hits, _ = pieces(start, goal, obstacles, step)
    return at_most_apart([start, *points[hits], goal], step)


@wrong("bug1")
def ignores_the_second_obstacle(start, goal, obstacles, step):
    """Only the first obstacle is one."""
    return bug1(start, goal, obstacles[:1], step).walk.points


@wrong("bug1")
def ends_at_the_nearest_point(start, goal, obstacles, step):
    """Forgets to go on."""
    points, _, leaves = pieces(start, goal, obstacles, step)
    return points[: leaves[0] + 1] if len(leaves) else points


@wrong("bug1")
def goes_round_for_ever(start, goal, obstacles, step):
    """Waits until it is at the very point of the hit."""
    path = bug_base(start, goal, obstacles, step).walk.points
    while (path[-1] != goal).any():
        pass
    return path


# Bug 2


@wrong("bug2")
def leaves_anywhere_on_the_line(start, goal, obstacles, step):
    """Bug2.prelim: leaves where the line is met, also farther from the goal; walks in a circle."""
    return bug2_prelim(start, goal, obstacles, step, turn="left").walk.points


@wrong("bug2")
def leaves_anywhere_turning_right(start, goal, obstacles, step):
    """The same, turning right."""
    return bug2_prelim(start, goal, obstacles, step, turn="right").walk.points


@wrong("bug2")
def first_bug(start, goal, obstacles, step):
    """All the way round."""
    return bug1(start, goal, obstacles, step).walk.points


@wrong("bug2")
def greedy_bug(start, goal, obstacles, step):
    """Leaves as soon as the way to the goal is free."""
    return bug0(start, goal, obstacles, step).walk.points


@wrong("bug2")
def through_the_wall(start, goal, obstacles, step):
    """Keeps to the line, whatever stands on it."""
    return at_most_apart([start, goal], step)


@wrong("bug2")
def cuts_corners(start, goal, obstacles, step):
    """Every tenth corner only: the way between goes straight."""
    walk = bug2(start, goal, obstacles, step).walk
    return at_most_apart(walk.points[[0, *walk.hit, *walk.leave[-1:], -1]], step)


@wrong("bug2")
def never_leaves(start, goal, obstacles, step):
    """Stays where it hit."""
    return bug_base(start, goal, obstacles, step).walk.points


@wrong("bug2")
def two_columns_swapped(start, goal, obstacles, step):
    """(y, x) for (x, y)."""
    return bug2(start, goal, obstacles, step).walk.points[:, ::-1]

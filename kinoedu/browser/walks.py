"""A bug's walk as it is shown: in the world, and as distance to the goal against distance walked.

Both pictures share one clock: at each step the bug has walked the same distance.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import compiled
from ..geometry.checks import Array
from ..geometry.exact import length
from .scenes import no_four

ARROWS = 12  # about the number of arrows that show the direction of a walk
ARROW = 0.02  # the length of an arrow, as a fraction of the size of what is shown
TOUCHING = 1e-9  # a wall that is nearer is touched, as a fraction of the same
MOST_NAMES = 6  # of one point
WIDE, HIGH = 2.0, 1.2  # the size of the plot
FREE, ALONG = 0, 1  # what a bug does

Numbers = NDArray[np.int64]


class Course(NamedTuple):
    """The fields of a `Walk` that are shown; `walked` is its `travelled`."""

    points: Array
    following: NDArray[np.bool_]
    walked: Array
    hit: Numbers
    leave: Numbers


class ShownWalk(NamedTuple):
    """What is shown of a walk.

    facts : (4,), the status, the distance walked, the number of hits, and the number of steps.
    sight : (1, 4), the line from start to goal.
    free, along : (k, 7), rows of an edge of the walk, distance walked, distance to the goal, step.
    directions : (k, 5), arrows and their steps.
    marks : (k, 3), points where a wall was hit or left, and their steps.
    names : (k, 10), rows x, y, number of names less one, the names, step. A hit k is k, a leave -k.
    touched : (k, 6), walls that are touched, from a step until another.
    feels : (k, 4), where the robot touches one.
    robot : (s, 4), where the robot is at each step.
    moments : (s, 3), what the robot does at each step, distance walked, distance to the goal.
    grid, axes : (k, 4), the lines of the plot.
    below, beside : (k, 3), rows x, y, value at an axis.
    titles : (2, 3), rows x, y, axis.
    plotted_* : the same in the plot.
    """

    facts: Array
    sight: Array
    free: Array
    along: Array
    directions: Array
    marks: Array
    names: Array
    touched: Array
    feels: Array
    robot: Array
    moments: Array
    grid: Array
    axes: Array
    below: Array
    beside: Array
    titles: Array
    plotted_free: Array
    plotted_along: Array
    plotted_marks: Array
    plotted_names: Array
    plotted_robot: Array


@compiled
def show_walk(outcome: int, course: Course, ends: Array, walls: Array, step: float) -> ShownWalk:
    """What is shown of a walk.

    Parameters
    ----------
    outcome : the number of the reason why it failed, 0 at the goal.
    ends : (2, 2), start and goal.
    walls : (m, 4), the edges of all obstacles.
    step : the longest distance walked in one step.
    """
    points, travelled = course.points, course.walked
    far = distances_to(ends[1], points)
    longest, farthest = scales_of(travelled, far)
    total, tick = count_steps(travelled[-1], step)
    when = steps_of(travelled, tick, total)
    reached = points_reached(when, total)
    curve = np.empty((len(points), 2))
    for k in range(len(points)):
        curve[k, 0] = travelled[k] / longest * WIDE
        curve[k, 1] = far[k] / farthest * HIGH
    size = size_of(points, walls)
    touched, feels = sense_steps(points, reached, walls, TOUCHING * size)
    grid, axes, below, beside, titles = draw_axes(longest, farthest)
    legs, plotted_legs = legs_of(points, course, far, when), legs_of(curve, course, far, when)
    marks, names = name_points(points, course, when)
    plotted_marks, plotted_names = name_points(curve, course, when)
    follows, sight = course.following[1:], np.empty((1, 4))
    sight[0, :2], sight[0, 2:] = ends[0], ends[1]
    facts = np.array([float(outcome), travelled[-1], float(len(course.hit)), float(total)])
    return ShownWalk(
        facts,
        sight,
        legs[~follows],
        legs[follows],
        directions_of(course, tick, ARROW * size),
        marks,
        names,
        touched,
        feels,
        robot_at_steps(points, reached),
        moments_of(course, far, reached),
        grid,
        axes,
        below,
        beside,
        titles,
        plotted_legs[~follows],
        plotted_legs[follows],
        plotted_marks,
        plotted_names,
        robot_at_steps(curve, reached),
    )


@compiled
def show_nothing(facts: Array) -> ShownWalk:
    """The answer where no walk is shown."""
    return ShownWalk(facts, *no_four(), *no_four(), *no_four(), *no_four(), *no_four())


# ---- the clock


@compiled
def count_steps(longest: float, step: float) -> tuple[int, float]:
    """The number of steps of the longest walk, and the distance walked in each."""
    total = max(1, int(np.ceil(longest / step)))
    return total, longest / total if longest > 0.0 else 1.0


@compiled
def steps_of(travelled: Array, tick: float, total: int) -> Array:
    """The step at which each point of a walk is reached."""
    when = np.empty(len(travelled))
    for k in range(len(travelled)):
        when[k] = min(np.ceil(travelled[k] / tick - 1e-9), float(total))
    return when


@compiled
def points_reached(when: Array, total: int) -> Numbers:
    """The last point that is reached at each step from 0, (total + 1,)."""
    reached, k = np.empty(total + 1, np.int64), 0
    for step in range(total + 1):
        while k + 1 < len(when) and when[k + 1] <= step:
            k += 1
        reached[step] = k
    return reached


# ---- the layers


@compiled
def distances_to(goal: Array, points: Array) -> Array:
    """The distance from each point to the goal."""
    far = np.empty(len(points))
    for k in range(len(points)):
        far[k] = length(points[k, 0] - goal[0], points[k, 1] - goal[1])
    return far


@compiled
def size_of(points: Array, walls: Array) -> float:
    """The size of a walk and all walls, in x or y."""
    size = 0.0
    for axis in range(2):
        low = high = points[0, axis]
        for k in range(len(points)):
            low, high = min(low, points[k, axis]), max(high, points[k, axis])
        for k in range(len(walls)):
            low, high = min(low, walls[k, axis]), max(high, walls[k, axis])
        size = max(size, high - low)
    return size


@compiled
def legs_of(places: Array, course: Course, far: Array, when: Array) -> Array:
    """The legs of a line through places that stand for the walk's points, with what they say."""
    legs = np.empty((len(places) - 1, 7))
    legs[:, :2], legs[:, 2:4] = places[:-1], places[1:]
    legs[:, 4], legs[:, 5], legs[:, 6] = course.walked[1:], far[1:], when[1:]
    return legs


@compiled
def directions_of(course: Course, tick: float, size: float) -> Array:
    """Arrow heads at equal distances along a walk, not at corners."""
    rows, count = np.empty((ARROWS, 5)), 0
    for i in range(ARROWS):
        tip = (i + 0.5) / ARROWS * course.walked[-1]
        begin, end = point_at(course, tip - size), point_at(course, tip)
        dx, dy = end[0] - begin[0], end[1] - begin[1]
        if length(dx, dy) > 0.999 * size:
            rows[count, 0], rows[count, 1] = begin
            rows[count, 2], rows[count, 3], rows[count, 4] = dx, dy, np.ceil(tip / tick)
            count += 1
    return rows[:count].copy()


@compiled
def point_at(course: Course, distance: float) -> tuple[float, float]:
    """The point of a walk at a distance walked, its start or its end where that is outside."""
    points, travelled = course.points, course.walked
    if distance <= 0.0:
        return points[0, 0], points[0, 1]
    k = np.searchsorted(travelled, distance)
    if k >= len(points):
        return points[-1, 0], points[-1, 1]
    part = (distance - travelled[k - 1]) / (travelled[k] - travelled[k - 1])
    x, y = points[k - 1]
    return x + part * (points[k, 0] - x), y + part * (points[k, 1] - y)


@compiled
def name_points(places: Array, course: Course, when: Array) -> tuple[Array, Array]:
    """Marks and names of the points where walls were hit or left, and names of one point together.

    The places (n, 2) stand for the walk's points.
    """
    hits, leaves = len(course.hit), len(course.leave)
    marks, names, size = np.empty((hits + leaves, 3)), np.zeros((hits + leaves, 10)), 0
    h = m = 0
    while h < hits or m < leaves:
        is_hit = h < hits and (m == leaves or course.hit[h] <= course.leave[m])
        k = course.hit[h] if is_hit else course.leave[m]
        h, m = (h + 1, m) if is_hit else (h, m + 1)
        row = 0
        while row < size and (names[row, 0] != places[k, 0] or names[row, 1] != places[k, 1]):
            row += 1
        if row == size:
            names[row, 0], names[row, 1], names[row, 2] = places[k, 0], places[k, 1], -1
            names[row, 9], size = when[k], size + 1
            marks[row, 0], marks[row, 1], marks[row, 2] = places[k, 0], places[k, 1], when[k]
        if names[row, 2] < MOST_NAMES - 1:
            names[row, 2] += 1
            names[row, 3 + int(names[row, 2])] = h if is_hit else -m
    return marks[:size].copy(), names[:size].copy()


@compiled
def sense_steps(points: Array, reached: Numbers, walls: Array, reach: float) -> tuple[Array, Array]:
    """The walls that the robot touches at each step, and where it is then."""
    near = np.zeros((len(reached), len(walls)), np.bool_)
    count = felt = 0
    for step in range(len(reached)):
        touches = 0
        for j in range(len(walls)):
            near[step, j] = distance_to_wall(points[reached[step]], walls[j]) <= reach
            touches += 1 if near[step, j] else 0
        count, felt = count + touches, felt + (1 if touches > 0 else 0)
    touched, feels = np.empty((count, 6)), np.empty((felt, 4))
    count = felt = 0
    for step in range(len(reached)):
        before = count
        for j in range(len(walls)):
            if near[step, j]:
                touched[count, :4] = walls[j]
                touched[count, 4], touched[count, 5] = step, step + 1
                count += 1
        if count > before:
            feels[felt, :2] = points[reached[step]]
            feels[felt, 2], feels[felt, 3] = step, step + 1
            felt += 1
    return touched, feels


@compiled
def distance_to_wall(q: Array, wall: Array) -> float:
    """The distance from a point to a segment."""
    ux, uy = wall[2] - wall[0], wall[3] - wall[1]
    x, y = q[0] - wall[0], q[1] - wall[1]
    along = (x * ux + y * uy) / max(ux * ux + uy * uy, 1e-300)
    along = min(max(along, 0.0), 1.0)
    return length(x - along * ux, y - along * uy)


@compiled
def robot_at_steps(places: Array, reached: Numbers) -> Array:
    """The robot at each step, at places that stand for the walk's points."""
    rows = np.empty((len(reached), 4))
    for step in range(len(reached)):
        rows[step, :2] = places[reached[step]]
        rows[step, 2], rows[step, 3] = step, step + 1
    return rows


@compiled
def moments_of(course: Course, far: Array, reached: Numbers) -> Array:
    """What the robot does at each step."""
    rows = np.empty((len(reached), 3))
    for step in range(len(reached)):
        k = reached[step]
        rows[step, 0] = ALONG if course.following[k] else FREE
        rows[step, 1], rows[step, 2] = course.walked[k], far[k]
    return rows


# ---- the plot


@compiled
def scales_of(travelled: Array, far: Array) -> tuple[float, float]:
    """The ends of a plot's axes: the longest way and the farthest distance, 1 where they are 0."""
    longest, farthest = travelled[-1], 0.0
    for k in range(len(far)):
        farthest = max(farthest, far[k])
    return longest if longest > 0.0 else 1.0, farthest if farthest > 0.0 else 1.0


@compiled
def draw_axes(longest: float, far: float) -> tuple[Array, Array, Array, Array, Array]:
    """The lines of a plot, its axes, the numbers below and beside them at round values, titles."""
    across, up = round_values(longest, 5), round_values(far, 4)
    below, beside = np.empty((len(across), 3)), np.empty((len(up) - 1, 3))
    grid = np.zeros((len(across) + len(up) - 2, 4))
    for i in range(len(across)):
        x = across[i] / longest * WIDE
        below[i, 0], below[i, 1], below[i, 2] = x - 0.06, -0.17, across[i]
        if i > 0:
            grid[i - 1, 0], grid[i - 1, 2], grid[i - 1, 3] = x, x, HIGH
    for i in range(1, len(up)):
        y, row = up[i] / far * HIGH, len(across) + i - 2
        beside[i - 1, 0], beside[i - 1, 1], beside[i - 1, 2] = -0.22, y - 0.06, up[i]
        grid[row, 1], grid[row, 2], grid[row, 3] = y, WIDE, y
    axes = np.array([0.0, HIGH, 0.0, 0.0, 0.0, 0.0, WIDE, 0.0]).reshape(2, 4)
    titles = np.array([-0.22, HIGH + 0.08, 0.0, 0.62 * WIDE, -0.31, 1.0]).reshape(2, 3)
    return grid, axes, below, beside, titles


@compiled
def round_values(most: float, count: int) -> Array:
    """Multiples of 1, 2 or 5 times a power of ten, from 0 to `most`, about `count` of them."""
    rough, power = most / count, 1.0
    # no logarithm, which each C library rounds in its own way
    while power * 10.0 <= rough:
        power *= 10.0
    while power > rough:
        power /= 10.0
    step = power
    for multiple in (1.0, 2.0, 5.0, 10.0):
        step = multiple * power
        if step >= rough * (1.0 - 1e-9):
            break
    values = np.empty(int(most / step * (1.0 + 1e-9)) + 1)
    for i in range(len(values)):
        values[i] = step * i
    return values

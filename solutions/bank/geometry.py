"""Typical wrong answers of students to the exercises of lesson 1.

A check must recognise the named misconception.
"""

import math
import time

import numpy as np

from kinoedu.course.bank import wrong
from kinoedu.course.lessons.geometry.exposing_case import ray_counting_distance
from kinoedu.geometry import (
    point_in_polygon,
    point_line_distance,
    point_polygon_distance,
    point_segment_distance,
)


def edges(polygon):
    return list(zip(polygon, np.roll(polygon, -1, axis=0)))


# A line through two points


@wrong("line_through_points")
def slope_and_intercept(p1, p2):
    """Has no answer for upright lines."""
    slope = (p2[1] - p1[1]) / (p2[0] - p1[0])
    size = math.sqrt(slope**2 + 1)
    return slope / size, -1 / size, (p1[1] - slope * p1[0]) / size


@wrong("line_through_points", slip="unscaled")
def not_scaled(p1, p2):
    """Forgets a^2 + b^2 = 1."""
    a, b = p1[1] - p2[1], p2[0] - p1[0]
    return a, b, -(a * p1[0] + b * p1[1])


@wrong("line_through_points", slip="direction")
def along_instead_of_across(p1, p2):
    """Uses the direction as the normal."""
    a, b = (p2 - p1) / np.linalg.norm(p2 - p1)
    if (p1 == p2).all():
        raise ValueError("one point")
    return a, b, -(a * p1[0] + b * p1[1])


@wrong("line_through_points", slip="sign_of_c")
def c_on_the_other_side(p1, p2):
    """Solves a x + b y = c."""
    if (p1 == p2).all():
        raise ValueError("one point")
    x, y = (p2 - p1) / np.linalg.norm(p2 - p1)
    return -y, x, -y * p1[0] + x * p1[1]


@wrong("line_through_points")
def small_c_becomes_zero(p1, p2):
    """Tests c < 1e-10 in place of |c| < 1e-10."""
    if (p1 == p2).all():
        raise ValueError("one point")
    x, y = (p2 - p1) / np.linalg.norm(p2 - p1)
    c = y * p1[0] - x * p1[1]
    return -y, x, 0.0 if c < 1e-10 else c


@wrong("line_through_points")
def divides_zero_by_zero(p1, p2):
    """Returns nan for points that coincide."""
    with np.errstate(all="ignore"):
        x, y = (p2 - p1) / np.linalg.norm(p2 - p1)
    return -y, x, y * p1[0] - x * p1[1]


@wrong("line_through_points")
def only_two_numbers(p1, p2):
    """Returns slope and intercept."""
    return np.polyfit([p1[0], p2[0] + 1e-12], [p1[1], p2[1]], 1)


@wrong("line_through_points", slip="sign_of_c")
def upright_at_the_wrong_place(p1, p2):
    """Forgets the sign of c for upright lines."""
    if (p1 == p2).all():
        raise ValueError("one point")
    if p1[0] == p2[0]:
        return 1.0, 0.0, p1[0]
    x, y = (p2 - p1) / np.linalg.norm(p2 - p1)
    return -y, x, y * p1[0] - x * p1[1]


# Distance to a line


@wrong("point_line_distance", slip="segment")
def to_the_segment(q, p1, p2):
    """Measures to the segment."""
    if (p1 == p2).all():
        raise ValueError("one point")
    return point_segment_distance(q, p1, p2)


@wrong("point_line_distance", slip="signed")
def with_a_sign(q, p1, p2):
    """Forgets the absolute value."""
    if (p1 == p2).all():
        raise ValueError("one point")
    (ux, uy), (vx, vy) = p2 - p1, q - p1
    return (ux * vy - uy * vx) / math.hypot(ux, uy)


@wrong("point_line_distance", slip="unscaled")
def the_area_itself(q, p1, p2):
    """Forgets to divide by the length."""
    (ux, uy), (vx, vy) = p2 - p1, q - p1
    return abs(ux * vy - uy * vx)


@wrong("point_line_distance", slip="along")
def dot_for_cross(q, p1, p2):
    """Uses the dot product in place of the cross product."""
    if (p1 == p2).all():
        raise ValueError("one point")
    return abs(np.dot(p2 - p1, q - p1)) / np.linalg.norm(p2 - p1)


@wrong("point_line_distance", slip="nearer_point")
def to_the_nearer_point(q, p1, p2):
    """Measures to the nearer of the two points."""
    return min(math.dist(q, p1), math.dist(q, p2))


@wrong("point_line_distance", slip="square")
def squared_distance(q, p1, p2):
    """Forgets the root."""
    return point_line_distance(q, p1, p2) ** 2


@wrong("point_line_distance", slip="half")
def area_of_the_triangle(q, p1, p2):
    """Forgets that a triangle is half of a parallelogram."""
    return point_line_distance(q, p1, p2) / 2


@wrong("point_line_distance", slip="vertical")
def straight_up(q, p1, p2):
    """Measures along y."""
    with np.errstate(all="ignore"):
        return abs(p1[1] + (p2[1] - p1[1]) * (q[0] - p1[0]) / (p2[0] - p1[0]) - q[1])


@wrong("point_line_distance", slip="rounded")
def rounds_its_answer(q, p1, p2):
    """Rounds its answer."""
    return round(point_line_distance(q, p1, p2), 2)


@wrong("point_line_distance", slip="rounded")
def small_is_zero(q, p1, p2):
    """Uses a tolerance that was not asked for."""
    d = point_line_distance(q, p1, p2)
    return 0.0 if d < 1e-3 else d


@wrong("point_line_distance")
def by_slope(q, p1, p2):
    """Has no answer for upright lines."""
    slope = (p2[1] - p1[1]) / (p2[0] - p1[0])
    return abs(slope * (q[0] - p1[0]) - (q[1] - p1[1])) / math.sqrt(slope**2 + 1)


@wrong("point_line_distance")
def zero_for_coincident_points(p1, p2, q):
    """Takes its arguments in another order."""
    return point_line_distance(q, p1, p2)


@wrong("point_line_distance")
def silent_about_coincident_points(q, p1, p2):
    """Returns a number where there is no line."""
    return math.dist(q, p1) if (p1 == p2).all() else point_line_distance(q, p1, p2)


# Distance to a segment


@wrong("point_segment_distance", slip="line")
def line_for_segment(q, p1, p2):
    """Treats the segment as a line."""
    return point_line_distance(q, p1, p2) if (p1 != p2).any() else math.dist(q, p1)


@wrong("point_segment_distance", slip="ends")
def nearer_end(q, p1, p2):
    """Measures only to the ends."""
    return min(math.dist(q, p1), math.dist(q, p2))


def at_share(q, p1, p2, t):
    return float(np.linalg.norm(q - (p1 + t * (p2 - p1))))


def share(q, p1, p2):
    return np.dot(q - p1, p2 - p1) / np.dot(p2 - p1, p2 - p1) if (p1 != p2).any() else 0.0


@wrong("point_segment_distance", slip="one_end")
def goes_on_beyond_p2(q, p1, p2):
    """Limits t from below only."""
    return at_share(q, p1, p2, max(0.0, share(q, p1, p2)))


@wrong("point_segment_distance", slip="other_end")
def goes_on_beyond_p1(q, p1, p2):
    """Limits t from above only."""
    return at_share(q, p1, p2, min(1.0, share(q, p1, p2)))


@wrong("point_segment_distance", slip="unscaled")
def share_by_length(q, p1, p2):
    """Divides by the length, not by its square."""
    if (p1 == p2).all():
        return math.dist(q, p1)
    return at_share(q, p1, p2, np.clip(np.dot(q - p1, p2 - p1) / np.linalg.norm(p2 - p1), 0, 1))


@wrong("point_segment_distance", slip="square")
def squared(q, p1, p2):
    """Forgets the root."""
    return point_segment_distance(q, p1, p2) ** 2


@wrong("point_segment_distance", slip="nan")
def nan_for_a_point(q, p1, p2):
    """Divides zero by zero where the segment is a point."""
    with np.errstate(all="ignore"):
        t = np.clip(np.dot(q - p1, p2 - p1) / np.dot(p2 - p1, p2 - p1), 0, 1)
    return at_share(q, p1, p2, t)


@wrong("point_segment_distance")
def shows_instead_of_returning(q, p1, p2):
    """Has no return statement."""
    point_segment_distance(q, p1, p2)


@wrong("point_segment_distance")
def always_the_first_end(q, p1, p2):
    """Beyond p2 it returns the distance to p1."""
    t = share(q, p1, p2)
    return at_share(q, p1, p2, t) if 0 <= t <= 1 else math.dist(q, p1)


@wrong("point_segment_distance")
def never_ends(q, p1, p2):
    """Halves an interval forever."""
    lo, hi = 0.0, 1.0
    while lo < hi + 1:
        middle = (lo + hi) / 2
        lo, hi = (lo, middle) if at_share(q, p1, p2, lo) < at_share(q, p1, p2, hi) else (middle, hi)


# Distance to a polygon


@wrong("point_polygon_distance", slip="vertices")
def vertices_only(q, polygon):
    """Forgets the edges."""
    return min(math.dist(q, vertex) for vertex in polygon)


@wrong("point_polygon_distance", slip="open")
def never_closed(q, polygon):
    """Forgets the last edge."""
    if point_in_polygon(q, polygon):
        return 0.0
    return min(point_segment_distance(q, a, b) for a, b in zip(polygon, polygon[1:]))


@wrong("point_polygon_distance", slip="rim")
def hollow(q, polygon):
    """Forgets the inside."""
    return min(point_segment_distance(q, a, b) for a, b in edges(polygon))


@wrong("point_polygon_distance", slip="lines")
def lines_for_edges(q, polygon):
    """Treats the edges as lines."""
    return (
        0.0
        if point_in_polygon(q, polygon)
        else min(point_line_distance(q, a, b) for a, b in edges(polygon))
    )


@wrong("point_polygon_distance", slip="farthest")
def farthest_edge(q, polygon):
    """Uses max in place of min."""
    return (
        0.0
        if point_in_polygon(q, polygon)
        else max(point_segment_distance(q, a, b) for a, b in edges(polygon))
    )


@wrong("point_polygon_distance", slip="centre")
def to_the_centre(q, polygon):
    """Measures to the mean of the vertices."""
    return math.dist(q, polygon.mean(axis=0))


@wrong("point_polygon_distance", slip="signed")
def negative_outside(q, polygon):
    """Returns a depth, not a distance."""
    return -hollow.function(q, polygon)


@wrong("point_polygon_distance", slip="first_edge")
def returns_in_the_loop(q, polygon):
    """Returns inside the loop, so only the first edge counts."""
    for a, b in edges(polygon):
        return 0.0 if point_in_polygon(q, polygon) else point_segment_distance(q, a, b)
    return 0.0


@wrong("point_polygon_distance", slip="rim")
def counts_a_ray(q, polygon):
    """The program of the "break it" exercise."""
    return ray_counting_distance(q, polygon)


@wrong("point_polygon_distance", slip="rounded")
def two_decimals(q, polygon):
    """Rounds its answer."""
    return round(float(point_polygon_distance(q, polygon)), 2)


@wrong("point_polygon_distance")
def begins_at_a_thousand(q, polygon):
    """Starts its minimum with a number that is not large enough."""
    least = 1000.0
    for a, b in edges(polygon):
        least = min(least, point_segment_distance(q, a, b))
    return 0.0 if point_in_polygon(q, polygon) else least


@wrong("point_segment_distance", slip="rounded")
def rounds_to_cents(q, p1, p2):
    """Rounds its answer."""
    return round(float(point_segment_distance(q, p1, p2)), 2)


@wrong("point_segment_distance")
def takes_short_for_a_point(q, p1, p2):
    """Uses a tolerance that was not asked for."""
    return math.dist(q, p1) if math.dist(p1, p2) < 0.5 else point_segment_distance(q, p1, p2)


@wrong("point_segment_distance")
def changes_its_input(q, p1, p2):
    """Uses p2 -= p1 on the caller's array."""
    before = point_segment_distance(q, p1, p2)
    p2 -= p1
    return before


@wrong("line_through_points", slip="c_unscaled")
def c_not_divided(p1, p2):
    """Divides a and b, but not c."""
    if (p1 == p2).all():
        raise ValueError("one point")
    (x, y), size = p2 - p1, math.dist(p1, p2)
    return -y / size, x / size, y * p1[0] - x * p1[1]


@wrong("line_through_points")
def takes_near_for_the_same(p1, p2):
    """Uses a tolerance that was not asked for."""
    if np.allclose(p1, p2, atol=0.1):
        raise ValueError("one point")
    x, y = (p2 - p1) / math.dist(p1, p2)
    return -y, x, y * p1[0] - x * p1[1]


@wrong("line_through_points")
def always_refuses(p1, p2):
    """Compares p1 == p2, for which numpy raises a ValueError."""
    if p1 == p2:
        raise ValueError("one point")
    return 1.0, 0.0, 0.0


@wrong("point_polygon_distance")
def runs_off_the_end(q, polygon):
    """Uses polygon[i + 1], which does not exist for the last i."""
    return min(point_segment_distance(q, polygon[i], polygon[i + 1]) for i in range(len(polygon)))


@wrong("point_polygon_distance")
def inside_by_bounding_box(q, polygon):
    """Uses the bounding box in place of the polygon."""
    if (polygon.min(axis=0) <= q).all() and (q <= polygon.max(axis=0)).all():
        return 0.0
    return min(point_segment_distance(q, a, b) for a, b in edges(polygon))


# Tangent to a polygon


def nearest_edge(q, polygon):
    return min(edges(polygon), key=lambda edge: point_segment_distance(q, *edge))


def tangent(q, a, b):
    t = share(q, a, b)
    if 0 < t < 1:
        return (b - a) / np.linalg.norm(b - a)
    x, y = q - (a if t <= 0 else b)
    return np.array([-y, x]) / math.hypot(x, y)


@wrong("polygon_tangent", slip="clockwise")
def clockwise(q, polygon):
    """Goes clockwise."""
    return -tangent(q, *nearest_edge(q, polygon))


@wrong("polygon_tangent", slip="towards")
def straight_to_the_wall(q, polygon):
    """Returns the direction to the nearest point."""
    x, y = tangent(q, *nearest_edge(q, polygon))
    return -y, x


@wrong("polygon_tangent", slip="away")
def straight_off_the_wall(q, polygon):
    """Returns the direction from the nearest point."""
    x, y = tangent(q, *nearest_edge(q, polygon))
    return y, -x


@wrong("polygon_tangent", slip="unscaled")
def as_long_as_the_edge(q, polygon):
    """Forgets to divide by the length."""
    a, b = nearest_edge(q, polygon)
    t = share(q, a, b)
    if 0 < t < 1:
        return b - a
    x, y = q - (a if t <= 0 else b)
    return -y, x


@wrong("polygon_tangent", slip="edge_at_vertex")
def along_the_edge_at_a_vertex(q, polygon):
    """Forgets the circle round a vertex."""
    nearest = [point_segment_distance(q, a, b) for a, b in edges(polygon)]
    number = max(i for i in range(len(polygon)) if nearest[i] <= min(nearest) + 1e-12)
    if number == len(polygon) - 1 and nearest[0] <= min(nearest) + 1e-12:
        number = 0
    a, b = edges(polygon)[number]
    return (b - a) / np.linalg.norm(b - a)


@wrong("polygon_tangent", slip="open")
def forgets_the_closing_edge(q, polygon):
    """Forgets the last edge."""
    return tangent(
        q, *min(zip(polygon, polygon[1:]), key=lambda edge: point_segment_distance(q, *edge))
    )


@wrong("polygon_tangent")
def circles_the_centre(q, polygon):
    """Circles the mean of the vertices."""
    x, y = q - polygon.mean(axis=0)
    return np.array([-y, x]) / math.hypot(x, y)


@wrong("polygon_tangent")
def an_angle(q, polygon):
    """Returns the heading, not the vector."""
    x, y = tangent(q, *nearest_edge(q, polygon))
    return math.degrees(math.atan2(y, x))


@wrong("polygon_tangent")
def sleeps(q, polygon):
    """Waits forever."""
    time.sleep(1e6)


# Break it


@wrong("exposing_case")
def an_ordinary_triangle():
    """The program is right on it."""
    return (1.0, 1.0), [(0, 0), (4, 0), (0, 3)]


@wrong("exposing_case")
def a_quadrilateral():
    """It exposes the program, but is not the smallest."""
    return (1, 2), [(0, 0), (4, 0), (4, 2), (0, 4)]


@wrong("exposing_case")
def two_points():
    """Two points are not a polygon."""
    return (1, 2), [(0, 0), (4, 2)]


@wrong("exposing_case")
def crossing_edges():
    """The polygon is not simple."""
    return (1, 1), [(0, 0), (4, 4), (4, 0), (0, 4)]


@wrong("exposing_case")
def polygon_first():
    """The polygon comes first."""
    return [(0, 0), (4, 2), (0, 4)], (1, 2)


@wrong("exposing_case")
def not_a_number():
    """A coordinate is nan."""
    return (math.nan, 2), [(0, 0), (4, 2), (0, 4)]


@wrong("exposing_case")
def far_away():
    """It exposes the program, but its coordinates are too large."""
    return (1e9, 2e9), [(0, 0), (4e9, 2e9), (0, 4e9)]


@wrong("exposing_case")
def flat():
    """The polygon has no area."""
    return (1, 0), [(0, 0), (4, 0), (2, 0)]

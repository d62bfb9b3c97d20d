"""Typical wrong answers of students to the exercises of lesson 1.

A check must recognise the named misconception.
"""

import math
import time
from pathlib import Path

import numpy as np

from kinoedu.course.bank import Solutions, wrong
from kinoedu.course.lessons.geometry.exposing_case import ray_counting_distance
from kinoedu.geometry import (
    point_in_polygon,
    point_line_distance,
    point_polygon_distance,
    point_segment_distance,
)

solutions = Solutions(Path(__file__).parents[1] / "01_geometry.ipynb")
changed, varied = solutions.changed, solutions.varied


def edges(polygon):
    return list(zip(polygon, np.roll(polygon, -1, axis=0)))


# A line through two points

not_scaled = changed("line_through_points", (" / math.dist(p1, p2)", ""), slip="unscaled")
along_instead_of_across = changed(
    "line_through_points",
    ("return -y, x, y * p1[0] - x * p1[1]", "return x, y, -(x * p1[0] + y * p1[1])"),
    slip="direction",
)
c_on_the_other_side = changed(  # solves a x + b y = c
    "line_through_points", ("y * p1[0] - x * p1[1]", "x * p1[1] - y * p1[0]"), slip="sign_of_c"
)
upright_at_the_wrong_place = changed(
    "line_through_points",
    ("    x, y", "    if p1[0] == p2[0]:\n        return 1.0, 0.0, p1[0]\n    x, y"),
)
c_not_divided = changed(
    "line_through_points",
    ("y * p1[0] - x * p1[1]", "(y * p1[0] - x * p1[1]) * math.dist(p1, p2)"),
    slip="c_unscaled",
)
takes_near_for_the_same = changed(
    "line_through_points", ("(p1 == p2).all()", "np.allclose(p1, p2, atol=0.1)")
)
has_a_tolerance = changed("line_through_points", ("(p1 == p2).all()", "np.allclose(p1, p2)"))
is_close_in_both = changed(
    "line_through_points",
    ("(p1 == p2).all()", "math.isclose(p1[0], p2[0]) and math.isclose(p1[1], p2[1])"),
)
has_a_tiny_tolerance = changed(
    "line_through_points", ("(p1 == p2).all()", "math.dist(p1, p2) < 1e-15")
)
steep_is_upright = changed(
    "line_through_points",
    ("    x, y", "    if abs(p2[0] - p1[0]) < 0.01:\n        return 1.0, 0.0, -p1[0]\n    x, y"),
    slip="steep",
)
flat_is_level = changed(
    "line_through_points",
    ("    x, y", "    if abs(p2[1] - p1[1]) < 0.01:\n        return 0.0, 1.0, -p1[1]\n    x, y"),
    slip="flat",
)
always_refuses = changed(  # numpy raises a ValueError
    "line_through_points", ("(p1 == p2).all()", "p1 == p2")
)


@wrong("line_through_points")
def slope_and_intercept(p1, p2):
    """Has no answer for upright lines."""
    slope = (p2[1] - p1[1]) / (p2[0] - p1[0])
    size = math.sqrt(slope**2 + 1)
    return slope / size, -1 / size, (p1[1] - slope * p1[0]) / size


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


# Distance to a line

with_a_sign = changed("point_line_distance", ("abs", ""), slip="signed")
the_area_itself = changed(
    "point_line_distance",
    (" / math.dist(p1, p2)", ""),
    slip="unscaled",
    within="line_through_points",
)
squared_distance = changed("point_line_distance", ("+ c)", "+ c) ** 2"), slip="square")
near_points_are_refused = changed(
    "point_line_distance",
    ("(p1 == p2).all()", "math.dist(p1, p2) < 1e-6"),
    within="line_through_points",
)
close_points_are_refused = changed(
    "point_line_distance",
    ("(p1 == p2).all()", "math.isclose(p1[0], p2[0]) and math.isclose(p1[1], p2[1])"),
    within="line_through_points",
)
zero_before_the_test = changed(  # also where there is no line
    "point_line_distance", ("    a, b", "    if (q == p1).all():\n        return 0.0\n    a, b")
)
area_of_the_triangle = changed("point_line_distance", ("+ c)", "+ c) / 2"), slip="half")


@wrong("point_line_distance", slip="segment")
def to_the_segment(q, p1, p2):
    """Measures to the segment."""
    if (p1 == p2).all():
        raise ValueError("one point")
    return point_segment_distance(q, p1, p2)


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


@wrong("point_line_distance", slip="vertical")
def straight_up(q, p1, p2):
    """Measures along y."""
    with np.errstate(all="ignore"):
        return abs(p1[1] + (p2[1] - p1[1]) * (q[0] - p1[0]) / (p2[0] - p1[0]) - q[1])


@wrong("point_line_distance", slip="rounded")
def rounds_its_answer(q, p1, p2):
    """Rounds its answer."""
    return round(point_line_distance(q, p1, p2), 2)


@wrong("point_line_distance")
def by_pythagoras(q, p1, p2):
    """Subtracts squares that are nearly equal."""
    if (p1 == p2).all():
        raise ValueError("one point")
    along = np.dot(q - p1, p2 - p1) / math.dist(p1, p2)
    return math.sqrt(max(0.0, math.dist(q, p1) ** 2 - along**2))


@wrong("point_line_distance")
def small_is_zero(q, p1, p2):
    """Uses a tolerance that was not asked for."""
    d = point_line_distance(q, p1, p2)
    return 0.0 if d < 1e-4 else d


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

LIMITED = "min(max(t, 0.0), 1.0)"

line_for_segment = changed("point_segment_distance", (LIMITED, "t"), slip="line")
goes_on_beyond_p2 = changed("point_segment_distance", (LIMITED, "max(t, 0.0)"), slip="one_end")
goes_on_beyond_p1 = changed("point_segment_distance", (LIMITED, "min(t, 1.0)"), slip="other_end")
share_by_length = changed(
    "point_segment_distance", ("np.dot(way, way)", "np.linalg.norm(way)"), slip="unscaled"
)
squared = changed("point_segment_distance", ("* way)", "* way) ** 2"), slip="square")
shows_instead_of_returning = changed("point_segment_distance", ("return ", ""))
always_the_first_end = changed(  # beyond p2 too
    "point_segment_distance", (LIMITED, "(t if 0.0 <= t <= 1.0 else 0.0)")
)
takes_short_for_a_point = changed(
    "point_segment_distance", ("way.any()", "np.linalg.norm(way) > 0.5"), slip="near"
)
nearly_equal_ends = changed(
    "point_segment_distance", ("way.any()", "not np.allclose(p1, p2)"), slip="near"
)
changes_its_input = changed("point_segment_distance", ("way = p2 - p1", "way = p2\n    way -= p1"))


@wrong("point_segment_distance", slip="ends")
def nearer_end(q, p1, p2):
    """Measures only to the ends."""
    return min(math.dist(q, p1), math.dist(q, p2))


def at_share(q, p1, p2, t):
    return float(np.linalg.norm(q - (p1 + t * (p2 - p1))))


@wrong("point_segment_distance", slip="nan")
def nan_for_a_point(q, p1, p2):
    """Divides zero by zero where the segment is a point."""
    with np.errstate(all="ignore"):
        t = np.clip(np.dot(q - p1, p2 - p1) / np.dot(p2 - p1, p2 - p1), 0, 1)
    return at_share(q, p1, p2, t)


@wrong("point_segment_distance")
def tries_many_places(q, p1, p2):
    """Takes the nearest of 2001 places."""
    return min(at_share(q, p1, p2, t) for t in np.linspace(0, 1, 2001))


@wrong("point_segment_distance")
def never_ends(q, p1, p2):
    """Halves an interval forever."""
    lo, hi = 0.0, 1.0
    while lo < hi + 1:
        middle = (lo + hi) / 2
        lo, hi = (lo, middle) if at_share(q, p1, p2, lo) < at_share(q, p1, p2, hi) else (middle, hi)


@wrong("point_segment_distance", slip="rounded")
def rounds_to_cents(q, p1, p2):
    """Rounds its answer."""
    return round(float(point_segment_distance(q, p1, p2)), 2)


@wrong("point_segment_distance")
def nearly_on_it(q, p1, p2):
    """Uses a tolerance that was not asked for."""
    d = point_segment_distance(q, p1, p2)
    return d if d > 1e-4 else 0.0


# Distance to a polygon

never_closed = changed(
    "point_polygon_distance", ("range(len(polygon))", "range(1, len(polygon))"), slip="open"
)
hollow = changed("point_polygon_distance", ("point_in_polygon(q, polygon)", "False"), slip="rim")
lines_for_edges = changed(
    "point_polygon_distance", ("point_segment_distance", "point_line_distance"), slip="lines"
)
farthest_edge = changed("point_polygon_distance", ("min", "max"), slip="farthest")
runs_off_the_end = changed(
    "point_polygon_distance", ("polygon[i - 1], polygon[i]", "polygon[i], polygon[i + 1]")
)
inside_by_bounding_box = changed(
    "point_polygon_distance",
    (
        "point_in_polygon(q, polygon)",
        "(polygon.min(axis=0) <= q).all() and (q <= polygon.max(axis=0)).all()",
    ),
)


@wrong("point_polygon_distance", slip="vertices")
def vertices_only(q, polygon):
    """Forgets the edges."""
    return min(math.dist(q, vertex) for vertex in polygon)


@wrong("point_polygon_distance", slip="vertices")
def vertices_only_outside(q, polygon):
    """Forgets the edges, but not that a polygon is solid."""
    return 0.0 if point_in_polygon(q, polygon) else vertices_only.function(q, polygon)


@wrong("point_polygon_distance", slip="square")
def square_of_the_distance(q, polygon):
    """Forgets the root."""
    return point_polygon_distance(q, polygon) ** 2


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
    least = 10_000.0
    for a, b in edges(polygon):
        least = min(least, point_segment_distance(q, a, b))
    return 0.0 if point_in_polygon(q, polygon) else least


@wrong("point_polygon_distance")
def leaves_out_short_edges(q, polygon):
    """Takes a short edge for a vertex that is listed twice."""
    if point_in_polygon(q, polygon):
        return 0.0
    return min(point_segment_distance(q, a, b) for a, b in edges(polygon) if math.dist(a, b) > 0.1)


@wrong("point_polygon_distance")
def stops_where_it_is_near(q, polygon):
    """Ends its loop at the first edge that is near enough."""
    least = math.inf
    for a, b in edges(polygon):
        least = min(least, point_segment_distance(q, a, b))
        if least < 0.01:
            break
    return 0.0 if point_in_polygon(q, polygon) else least


@wrong("point_polygon_distance")
def contact_within_a_tolerance(q, polygon):
    """Takes a point near the boundary for one on it."""
    d = point_polygon_distance(q, polygon)
    return d if d > 1e-4 else 0.0


@wrong("point_polygon_distance")
def twenty_edges(q, polygon):
    """Expects no more edges than a polygon drawn by hand has."""
    if point_in_polygon(q, polygon):
        return 0.0
    return min(point_segment_distance(q, a, b) for a, b in edges(polygon)[-20:])


# Tangent to a polygon

clockwise = changed("polygon_tangent", ("return", "return -"), slip="clockwise")
as_long_as_the_edge = changed("polygon_tangent", (" / np.linalg.norm(vector)", ""), slip="unscaled")
straight_to_the_wall = changed(
    "polygon_tangent",
    ("return vector", "vector = np.array([-vector[1], vector[0]])\n    return vector"),
    slip="towards",
)
straight_off_the_wall = changed(
    "polygon_tangent",
    ("return vector", "vector = np.array([vector[1], -vector[0]])\n    return vector"),
    slip="away",
)
forgets_the_closing_edge = changed(
    "polygon_tangent", ("np.roll(polygon, -1, axis=0)", "polygon[1:]"), slip="open"
)
nearly_at_a_vertex = changed(
    "polygon_tangent",
    ("0.0 < t < 1.0", "0.01 < t < 0.99"),
    ("t <= 0.0", "t < 0.5"),
    slip="vertex_at_edge",
)
compares_rounded_distances = changed(
    "polygon_tangent",
    ("point_segment_distance(q, *edge)", "round(point_segment_distance(q, *edge), 3)"),
)
an_angle = changed(
    "polygon_tangent",
    ("vector / np.linalg.norm(vector)", "math.degrees(math.atan2(*vector[::-1]))"),
)
nearly_a_vertex = changed(
    "polygon_tangent",
    (
        "0.0 < t < 1.0",
        "not any(math.isclose(math.dist(q, p), point_segment_distance(q, a, b)) for p in (a, b))",
    ),
)


exactly_at_an_end_forgotten = changed(
    "polygon_tangent",
    (
        "x, y = q - (a if t <= 0.0 else b)",
        "x, y = (np.nan, np.nan) if t in (0.0, 1.0) else q - (a if t < 0.0 else b)",
    ),
)
first_end_taken_for_the_second = changed("polygon_tangent", ("t <= 0.0", "t < 0.0"))


@wrong("polygon_tangent", slip="edge_at_vertex")
def along_the_edge_at_a_vertex(q, polygon):
    """Forgets the circle round a vertex."""
    nearest = [point_segment_distance(q, a, b) for a, b in edges(polygon)]
    number = max(i for i in range(len(polygon)) if nearest[i] <= min(nearest) + 1e-12)
    if number == len(polygon) - 1 and nearest[0] <= min(nearest) + 1e-12:
        number = 0
    a, b = edges(polygon)[number]
    return (b - a) / np.linalg.norm(b - a)


@wrong("polygon_tangent")
def circles_the_centre(q, polygon):
    """Circles the mean of the vertices."""
    x, y = q - polygon.mean(axis=0)
    return np.array([-y, x]) / math.hypot(x, y)


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


# Variants

round_clockwise = varied("polygon_tangent", "clockwise", ("return vector /", "return -vector /"))
NEITHER = "vector = b - a if 0.0 < t < 1.0 else np.array([-y, x])"
outward = varied(
    "polygon_tangent", "outward", (NEITHER, "vector = q - a - min(max(t, 0), 1) * (b - a)")
)
inward = changed(
    "polygon_tangent",
    (NEITHER, "vector = a + min(max(t, 0), 1) * (b - a) - q"),
    variant="outward",
    slip="clockwise",
)
outward_from_an_end = changed(
    "polygon_tangent", (NEITHER, "vector = np.array([x, y])"), variant="outward"
)
clockwise_along_the_edge = changed(
    "polygon_tangent", (NEITHER, "vector = a - b"), variant="clockwise"
)

TO_THE_LINE = "return abs(a * q[0] + b * q[1] + c)"  # positive on the left without abs
positive_on_the_left = varied(
    "point_line_distance", "left", (TO_THE_LINE, "return a * q[0] + b * q[1] + c")
)
positive_on_the_right = varied(
    "point_line_distance", "right", (TO_THE_LINE, "return -(a * q[0] + b * q[1] + c)")
)
positive_above = changed(
    "point_line_distance",
    (TO_THE_LINE, "return (a * q[0] + b * q[1] + c) * (1 if b >= 0 else -1)"),
    variant="left",
)
INSIDE = "if point_in_polygon(q, polygon):\n        return 0.0\n    return min("
minus_inside = varied(
    "point_polygon_distance",
    "signed",
    (INSIDE, "return (-1 if point_in_polygon(q, polygon) else 1) * min("),
)
to_the_boundary = varied("point_polygon_distance", "boundary", (INSIDE, "return min("))
minus_outside = changed(
    "point_polygon_distance",
    (INSIDE, "return (1 if point_in_polygon(q, polygon) else -1) * min("),
    variant="signed",
    slip="signed",
)
to_the_vertices = changed(
    "point_polygon_distance",
    (INSIDE, "return min(math.dist(q, v) for v in polygon)\n    return min("),
    variant="boundary",
    slip="vertices",
)

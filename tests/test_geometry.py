"""Plane geometry compared with rational arithmetic.

Predicates are never wrong, and distances have a relative error of at most 1e-12. The oracles below
use fractions, and where possible another formula than the library: segments are intersected by
solving for both parameters, membership uses winding numbers, convex polygons are clipped.
"""

import json
import math
from collections import Counter
from fractions import Fraction
from itertools import combinations, permutations
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import HealthCheck, assume, example, given, settings
from hypothesis import strategies as st

from kinoedu.errors import InvalidPoint, InvalidPolygon, InvalidSegment, KinoeduError
from kinoedu.geometry import (
    closest_point_on_segment,
    convex_hull,
    convex_polygons_intersect,
    line_through_points,
    orientation,
    point_in_convex_polygon,
    point_in_polygon,
    point_line_distance,
    point_polygon_distance,
    point_segment_distance,
    polygon_tangent,
    segment_intersection,
    segments_intersect,
)
from kinoedu.geometry.convex import convex_parts
from kinoedu.geometry.rings import CROSSES, as_ring, find_reflex_vertex, find_ring_fault

Exact = tuple[Fraction, Fraction]
Floats = tuple[float, float]

CASES = json.loads(
    (Path(__file__).parent / "data" / "geometry" / "cases.json").read_text(encoding="utf-8")
)["cases"]
LAW = settings(
    derandomize=True,
    deadline=None,
    database=None,
    max_examples=300,
    suppress_health_check=list(HealthCheck),
)
SLOW_LAW = settings(LAW, max_examples=120)

CORNER = [(0, 0), (4, 0), (4, 4), (2, 4), (2, 2), (0, 2)]
SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]


# ---- exact oracles -----------------------------------------------------------------------------


def exact(p: Any) -> Exact:
    """A point as fractions."""
    return Fraction(p[0]), Fraction(p[1])


def minus(p: Exact, q: Exact) -> Exact:
    return p[0] - q[0], p[1] - q[1]


def cross(u: Exact, v: Exact) -> Fraction:
    return u[0] * v[1] - u[1] * v[0]


def dot(u: Exact, v: Exact) -> Fraction:
    return u[0] * v[0] + u[1] * v[1]


def sign(value: Any) -> int:
    return (value > 0) - (value < 0)


def turn_of(a: Any, b: Any, c: Any) -> int:
    """The sign of (b - a) x (c - a)."""
    a, b, c = exact(a), exact(b), exact(c)
    return sign(cross(minus(b, a), minus(c, a)))


def nearest_exactly(q: Any, a: Any, b: Any) -> tuple[Fraction, Exact, int]:
    """Squared distance, nearest point and region, by clamping the parameter of the projection."""
    q, a, b = exact(q), exact(a), exact(b)
    u = minus(b, a)
    t = dot(minus(q, a), u) / dot(u, u) if a != b else Fraction(0)
    region = 1 if t <= 0 else 2 if t >= 1 else 0
    t = min(max(t, Fraction(0)), Fraction(1))
    near = a[0] + t * u[0], a[1] + t * u[1]
    return dot(minus(q, near), minus(q, near)), near, region


def shared_exactly(a: Any, b: Any, c: Any, d: Any) -> list[Exact]:
    """The points that two closed segments share; an overlap runs from a to b."""
    a, b, c, d = exact(a), exact(b), exact(c), exact(d)
    u, v, w = minus(b, a), minus(d, c), minus(c, a)
    across = cross(u, v)
    if across != 0:  # a + t u = c + s v
        t, s = cross(w, v) / across, cross(w, u) / across
        return [(a[0] + t * u[0], a[1] + t * u[1])] if 0 <= t <= 1 and 0 <= s <= 1 else []
    if a == b:
        return [a] if nearest_exactly(a, c, d)[0] == 0 else []
    if cross(u, w) != 0:
        return []
    ends = sorted(dot(minus(p, a), u) / dot(u, u) for p in (c, d))
    first, last = max(ends[0], Fraction(0)), min(ends[1], Fraction(1))
    return [
        (a[0] + t * u[0], a[1] + t * u[1])
        for t in ([first, last] if first < last else [first] if first == last else [])
    ]


def place_exactly(q: Any, polygon: Any) -> int:
    """1 inside, 0 on the boundary, -1 outside, by the winding number of the boundary around q."""
    q, ring = exact(q), [exact(p) for p in polygon]
    winding = 0
    for a, b in zip(ring, ring[1:] + ring[:1], strict=True):
        if nearest_exactly(q, a, b)[0] == 0:
            return 0
        if (a[1] <= q[1]) != (b[1] <= q[1]):
            x = a[0] + (q[1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1])
            winding += (1 if b[1] > a[1] else -1) if x > q[0] else 0
    return 1 if winding else -1


def twice_area(polygon: Any) -> Fraction:
    """Twice the signed area, by the shoelace formula."""
    ring = [exact(p) for p in polygon]
    return sum((cross(a, b) for a, b in zip(ring, ring[1:] + ring[:1], strict=True)), Fraction(0))


def is_simple(polygon: Any) -> bool:
    """Whether edges meet only at the vertex between two consecutive ones."""
    n = len(polygon)
    for i, j in combinations(range(n), 2):
        shared = shared_exactly(polygon[i], polygon[(i + 1) % n], polygon[j], polygon[(j + 1) % n])
        if len(shared) > (1 if j == i + 1 or (i == 0 and j == n - 1) else 0):
            return False
        if n == 3 and len(shared) != 1:
            return False
    return twice_area(polygon) != 0 and len(set(map(exact, polygon))) == n


def overlap_exactly(P: Any, Q: Any) -> list[Exact]:
    """The intersection of two convex polygons, by Sutherland and Hodgman's clipping."""
    P, Q = [exact(p) for p in P], [exact(q) for q in Q]
    Q = Q if twice_area(Q) > 0 else Q[::-1]
    for c, d in zip(Q, Q[1:] + Q[:1], strict=True):
        kept = []
        for a, b in zip(P, P[1:] + P[:1], strict=True):
            at_a, at_b = cross(minus(d, c), minus(a, c)), cross(minus(d, c), minus(b, c))
            if at_a >= 0:
                kept.append(a)
            if at_a * at_b < 0:
                t = at_a / (at_a - at_b)
                kept.append((a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])))
        P = kept
    return P


def is_close(value: float, squared: Fraction, tolerance: Fraction = Fraction(1, 10**12)) -> bool:
    """Whether a float is the root of an exact square, with relative error at most 1e-12."""
    return (1 - tolerance) ** 2 * squared <= Fraction(value) ** 2 <= (1 + tolerance) ** 2 * squared


# ---- strategies --------------------------------------------------------------------------------

lattice = st.tuples(st.integers(-6, 6), st.integers(-6, 6)).map(
    lambda p: (float(p[0]), float(p[1]))
)
tenths = st.tuples(st.integers(-9, 9), st.integers(-9, 9)).map(lambda p: (p[0] * 0.1, p[1] * 0.1))
ulps = st.tuples(st.integers(0, 31), st.integers(0, 31)).map(
    lambda p: (0.5 + p[0] * 2.0**-53, 0.5 + p[1] * 2.0**-53)
)
diagonal = st.sampled_from([(12.0, 12.0), (24.0, 24.0), (17.3, 17.3), (-0.1, -0.1), (0.5, 0.5)])
coordinate = st.one_of(
    st.floats(-10.0, 10.0),
    st.floats(-1e150, 1e150),
    st.floats(-1e-150, 1e-150, allow_subnormal=True),
    st.sampled_from(
        [
            0.0,
            -0.0,
            5e-324,
            -5e-324,
            2.2250738585072014e-308,
            1e-160,
            1e150,
            -1e150,
            1.0,
            1.0 + 2.0**-52,
        ]
    ),
)
wild = st.tuples(coordinate, coordinate)
point = st.one_of(lattice, tenths, st.one_of(ulps, diagonal), wild)
# no coordinate between 0 and 1e-100, so that squares and products of errors are normal numbers
measured = st.one_of(
    lattice,
    tenths,
    ulps,
    diagonal,
    st.tuples(*[st.floats(-1e150, 1e150).map(lambda x: x if abs(x) > 1e-100 else 0.0)] * 2),
)


KINDS = (lattice, tenths, st.one_of(ulps, diagonal), wild)


def alike(count: int, kinds: Any = KINDS) -> Any:
    """Several points of one kind, sometimes repeated, so that degenerate cases are common."""
    return st.one_of(*[st.lists(kind, min_size=count, max_size=count).map(tuple) for kind in kinds])


@st.composite
def simple_polygons(draw: Any, most: int = 8, reach: int = 6) -> list[Floats]:
    """A simple lattice polygon: points are inserted into the first edge where nothing crosses."""
    number = st.integers(-reach, reach)
    points = draw(st.lists(st.tuples(number, number), min_size=3, max_size=most, unique=True))
    assume(turn_of(*points[:3]))
    ring = points[:3]
    for p in points[3:]:
        for i in range(len(ring)):
            if is_simple([*ring[: i + 1], p, *ring[i + 1 :]]):
                ring.insert(i + 1, p)
                break
    return [(float(x), float(y)) for x, y in ring]


@st.composite
def convex_polygons(draw: Any, reach: int = 6) -> list[Floats]:
    """A convex lattice polygon in either direction, sometimes with points on its edges."""
    number = st.integers(-reach, reach)
    points = draw(st.lists(st.tuples(number, number), min_size=3, max_size=7, unique=True))
    corners = hull_exactly(points)
    assume(len(corners) > 2)
    a, b = corners[0], corners[1]
    if draw(st.booleans()) and (a[0] + b[0]) % 2 == 0 and (a[1] + b[1]) % 2 == 0:
        corners.insert(1, ((a[0] + b[0]) // 2, (a[1] + b[1]) // 2))
    return [(float(x), float(y)) for x, y in (corners if draw(st.booleans()) else corners[::-1])]


def hull_exactly(points: Any) -> list[Any]:
    """The corners of the convex hull of lattice points, counter-clockwise, by brute force.

    A corner is in no triangle and on no segment of other points.
    """
    points = sorted(set(points))
    corners = [
        p
        for p in points
        if not any(
            place_exactly(p, t) >= 0
            for t in combinations([q for q in points if q != p], 3)
            if turn_of(*t)
        )
        and not any(
            nearest_exactly(p, *s)[0] == 0 for s in combinations([q for q in points if q != p], 2)
        )
    ]
    if len(corners) < 3:
        return corners
    x, y = sum(p[0] for p in corners) / len(corners), sum(p[1] for p in corners) / len(corners)
    corners.sort(key=lambda p: math.atan2(p[1] - y, p[0] - x))
    start = corners.index(min(corners))
    return corners[start:] + corners[:start]


moves = st.sampled_from(
    [
        (1.0, 0.0),
        (0.1, 0.0),
        (1.0, 1e6),
        (0.1, 0.3),
        (1e-6, 0.0),
        (1e6, 1e9),
        (1e-140, 0.0),
        (1e140, 0.0),
    ]
)


def moved(points: Any, move: tuple[float, float]) -> list[Floats]:
    """Points scaled and shifted in floating-point arithmetic, with its rounding."""
    return [(x * move[0] + move[1], y * move[0] + move[1]) for x, y in points]


# ---- the collected cases -----------------------------------------------------------------------


def cases(kind: str) -> list[Any]:
    return [
        pytest.param(case, case["expected"], id=case["id"])
        for case in CASES
        if case["kind"] == kind
    ]


def test_every_kind_of_collected_case_is_tested() -> None:
    """Every kind of case in the collection has a test below."""
    kinds = Counter(case["kind"] for case in CASES)
    points = {"orient": 45, "point_seg": 29, "point_poly": 41, "point_poly_dist": 41, "tangent": 30}
    assert kinds == {**points, "seg_seg": 54, "convex_pair": 68}


@pytest.mark.parametrize(("case", "expected"), cases("orient"))
def test_collected_orientations(case: Any, expected: Any) -> None:
    """The sign is right, even where the determinant is 1e-300."""
    assert orientation(case["a"], case["b"], case["c"]) == expected["sign"]


@pytest.mark.parametrize(("case", "expected"), cases("seg_seg"))
def test_collected_segment_pairs(case: Any, expected: Any) -> None:
    """The number of shared points is exact, and the points are accurate to 1e-12."""
    ends = [case[name] for name in "abcd"]
    shared = segment_intersection(*ends)
    assert len(shared) == {"none": 0, "point": 1, "overlap": 2}[expected["relation"]]
    assert segments_intersect(*ends) == (expected["relation"] != "none")
    assert shared == pytest.approx(
        np.array(expected["points"]).reshape(-1, 2), rel=1e-12, abs=1e-12 * np.abs(ends).max()
    )


@pytest.mark.parametrize(("case", "expected"), cases("point_seg"))
def test_collected_points_and_segments(case: Any, expected: Any) -> None:
    """Distance, nearest point and region of a point and a segment."""
    q, a, b = case["p"], case["a"], case["b"]
    near, region = closest_point_on_segment(q, a, b)
    assert is_close(point_segment_distance(q, a, b), Fraction(expected["distance2"]))
    assert region == {"inner": 0, "start": 1, "end": 2}[expected["region"]]
    assert near == pytest.approx(
        np.array(expected["closest"]), rel=1e-12, abs=1e-12 * np.abs([a, b]).max()
    )


@pytest.mark.parametrize(("case", "expected"), cases("point_poly"))
def test_collected_points_and_polygons(case: Any, expected: Any) -> None:
    """Points inside and on the boundary are in the polygon."""
    held = expected["where"] != "outside"
    assert point_in_polygon(case["p"], case["poly"]) is held
    if expected["convex"]:
        assert point_in_convex_polygon(case["p"], case["poly"]) is held


@pytest.mark.parametrize(("case", "expected"), cases("point_poly_dist"))
def test_collected_distances_to_polygons(case: Any, expected: Any) -> None:
    """The distance is zero inside the polygon."""
    assert point_polygon_distance(case["p"], case["poly"]) == pytest.approx(
        expected["distance_to_solid"], rel=1e-12, abs=0.0
    )


@pytest.mark.parametrize(("case", "expected"), cases("convex_pair"))
def test_collected_convex_pairs(case: Any, expected: Any) -> None:
    """Touching polygons intersect."""
    assert convex_polygons_intersect(case["P"], case["Q"]) is expected["intersect_closed"]
    assert convex_polygons_intersect(case["Q"], case["P"]) is expected["intersect_closed"]


def test_the_tangent_at_a_straight_vertex_is_that_of_the_edges() -> None:
    """Inside the polygon as outside; it was the opposite one inside."""
    room = [(0, 0), (2, 0), (4, 0), (4, 4), (0, 4)]
    for q in ((2, 1), (1.9, 1), (2.1, 1), (2, -1), (2, 0)):
        assert polygon_tangent(q, room).tolist() == [1, 0]


@pytest.mark.parametrize(("case", "expected"), cases("tangent"))
def test_collected_tangents(case: Any, expected: Any) -> None:
    """The direction is counter-clockwise, for vertices in either order."""
    assert polygon_tangent(case["p"], case["poly"]) == pytest.approx(
        np.array(expected["tangent_ccw"]), rel=1e-12, abs=1e-12
    )


# ---- orientation -------------------------------------------------------------------------------


@LAW
@given(alike(3))
@example(((0.5, 0.5), (12.0, 12.0), (24.0, 24.0)))
@example(((0.0, 0.0), (5e-324, 5e-324), (5e-324, 0.0)))
@example(((-1e150, -1e150), (1e150, 1e150), (1e-150, 5e-324)))
@example(((1e150, 5e-324), (0.0, 0.0), (-1e150, -5e-324)))
def test_orientation_is_the_exact_sign(points: Any) -> None:
    """From subnormal numbers to 1e150, on lattices and one rounding error away from a line."""
    assert orientation(*points) == turn_of(*points)


def test_orientation_near_a_diagonal_is_exact_for_every_neighbour() -> None:
    """All floats of a 16 x 16 patch around a line through two points, far and near."""
    for far, further in (
        ((12.0, 12.0), (24.0, 24.0)),
        ((17.3, 17.3), (24.0, 24.0)),
        ((0.500001, 0.500001), (0.5, 0.5)),
    ):
        for i in range(16):
            for j in range(16):
                p = (0.5 + i * 2.0**-53, 0.5 + j * 2.0**-53)
                assert orientation(p, far, further) == turn_of(p, far, further)


@LAW
@given(alike(3))
def test_orientation_changes_sign_when_two_points_swap(points: Any) -> None:
    """Even permutations keep the sign, odd permutations change it."""
    straight = orientation(*points)
    for order in permutations(range(3)):
        even = sum(order[i] > order[j] for i, j in combinations(range(3), 2)) % 2 == 0
        assert orientation(*(points[i] for i in order)) == (straight if even else -straight)


@st.composite
def near_a_line(draw: Any) -> tuple[Floats, Floats, Floats]:
    """Two points anywhere and a third within two floats of their line.

    The products of coordinates range from underflow to huge numbers.
    """
    number, scale = (
        st.floats(-30.0, 30.0),
        draw(st.sampled_from([1.0, 1.0, 2.0**-450, 2.0**-480, 2.0**-500, 2.0**-530, 2.0**490])),
    )
    a, b = draw(st.tuples(number, number)), draw(st.tuples(number, number))
    t = draw(st.floats(-2.0, 3.0))
    c = [p + t * (q - p) for p, q in zip(a, b, strict=True)]
    for axis in (0, 1):
        for _ in range(draw(st.integers(0, 2))):
            c[axis] = math.nextafter(c[axis], draw(st.sampled_from([-math.inf, math.inf])))
    return tuple((x * scale, y * scale) for x, y in (a, b, c))


@LAW
@given(near_a_line(), st.permutations(range(3)))
@example(
    (
        (17.3, 17.3),
        (24.00000000000005, 24.0000000000000517765),
        (0.5000000000000024, 0.5000000000000006),
    ),
    (0, 1, 2),
)
@example(((8.8, 8.8), (12.1, 12.1), (0.5, 0.5000000000000001)), (0, 1, 2))
def test_orientation_near_a_line_is_exact(points: Any, order: Any) -> None:
    """The floating-point determinant is noise there, or its products underflow."""
    a, b, c = (points[i] for i in order)
    assert orientation(a, b, c) == turn_of(a, b, c)


@LAW
@given(near_a_line())
def test_distances_near_a_line_are_good_to_1e12(points: Any) -> None:
    """All leading digits of the determinant cancel there."""
    a, b, c = points
    assume(max(map(abs, (*a, *b))) > 1e-100 and a != b)
    u = minus(exact(b), exact(a))
    squared = cross(u, minus(exact(c), exact(a))) ** 2 / dot(u, u)
    # subnormal numbers do not have twelve digits
    assume(squared == 0 or squared > Fraction(1e-300) ** 2)
    assert is_close(point_line_distance(c, a, b), squared)
    assert is_close(point_segment_distance(c, a, b), nearest_exactly(c, a, b)[0])


@pytest.mark.parametrize("end", [(5e-324, 0.0), (5e-324, 5e-324), (1e-310, -3e-310), (0.0, 2e-308)])
@pytest.mark.parametrize("q", [(1.0, 1.0), (1e150, 0.0), (0.1, -3.0), (1e-200, 1e-150)])
def test_a_line_through_two_points_that_nearly_coincide(end: Any, q: Any) -> None:
    """Distances and normals are as good as elsewhere."""
    u = exact(end)
    squared = cross(u, exact(q)) ** 2 / dot(u, u)
    assert is_close(point_line_distance(q, (0.0, 0.0), end), squared)
    a, b, c = line_through_points((0.0, 0.0), end)
    assert math.hypot(a, b) == pytest.approx(1.0, rel=1e-15) and c == 0.0
    assert line_through_points(q, (q[0], q[1] + 1e150)) == pytest.approx((-1.0, 0.0, q[0]))


# ---- segments ----------------------------------------------------------------------------------


@LAW
@given(alike(4))
@example(((0.0, 0.0), (4.0, 0.0), (4.0, 0.0), (9.0, 0.0)))
@example(((3.0, 0.0), (0.0, 0.0), (1.0, 0.0), (2.0, 0.0)))
@example(((1.0, 1.0), (1.0, 1.0), (0.0, 0.0), (2.0, 2.0)))
@example(((0.0, 0.0), (2.0, 2.0), (1.0, 1.0), (1.0, 1.0)))
@example(((1.0, 1.0), (1.0, 1.0), (1.0, 1.0), (1.0, 1.0)))
@example(((1.0, 1.0), (1.0, 1.0), (2.0, 1.0), (2.0, 1.0)))
@example(((0.0, 0.0), (0.0, 0.0), (1.0, 1.0), (2.0, 2.0)))
@example(((0.0, 3.0), (0.0, 0.0), (0.0, 1.0), (0.0, 2.0)))
def test_segments_intersect_exactly(ends: Any) -> None:
    """Whether two segments share a point, for every order of their ends."""
    a, b, c, d = ends
    meet = bool(shared_exactly(a, b, c, d))
    assert [
        segments_intersect(*s) for s in ((a, b, c, d), (b, a, c, d), (a, b, d, c), (c, d, a, b))
    ] == [meet] * 4


@LAW
@given(alike(4, (lattice, lattice, tenths, st.one_of(ulps, diagonal))))
@example(((0.0, 0.0), (4.0, 0.0), (9.0, 0.0), (1.0, 0.0)))
@example(((4.0, 0.0), (0.0, 0.0), (1.0, 0.0), (9.0, 0.0)))
@example(((3.0, 3.0), (0.0, 0.0), (1.0, 1.0), (2.0, 2.0)))
@example(((0.0, 0.0), (3.0, 3.0), (2.0, 2.0), (1.0, 1.0)))
@example(((0.0, 3.0), (0.0, 0.0), (0.0, 1.0), (0.0, 9.0)))
@example(((1.0, 1.0), (1.0, 1.0), (2.0, 2.0), (0.0, 0.0)))
@example(((2.0, 2.0), (0.0, 0.0), (1.0, 1.0), (1.0, 1.0)))
def test_segment_intersection_is_what_they_share(ends: Any) -> None:
    """The number of points is exact, ends are returned unrounded, and crossings are close.

    An overlap runs in the direction from p1 to p2.
    """
    expected = shared_exactly(*ends)
    shared = segment_intersection(*ends)
    assert shared.shape == (len(expected), 2)
    for got, wanted in zip(shared, expected, strict=True):
        if wanted in map(exact, ends):
            assert exact(got) == wanted
        reach = max(abs(Fraction(x)) for p in ends for x in p)
        assert max(abs(Fraction(g) - w) for g, w in zip(got, wanted, strict=True)) <= reach / 10**12


@LAW
@given(alike(4, (wild, measured)))
def test_crossings_of_any_size_are_near(ends: Any) -> None:
    """A crossing is within 1e-12 of the largest coordinate, from 5e-324 to 1e150, and never NaN."""
    expected, shared = shared_exactly(*ends), segment_intersection(*ends)
    assert len(shared) == len(expected)
    reach = max(abs(Fraction(x)) for p in ends for x in p)
    for got, wanted in zip(shared, expected, strict=True):
        assert np.isfinite(got).all()
        assert max(
            abs(Fraction(g) - w) for g, w in zip(got, wanted, strict=True)
        ) <= reach / 10**12 + Fraction(5e-324)


def test_a_tiny_crossing_is_a_point() -> None:
    """Two diagonals of a square of side 2e-170 cross at its centre."""
    shared = segment_intersection(
        (-1e-170, -1e-170), (1e-170, 1e-170), (-1e-170, 1e-170), (1e-170, -1e-170)
    )
    assert shared.tolist() == [[0.0, 0.0]]


@LAW
@given(alike(3, (lattice, tenths, ulps, measured)))
def test_distance_to_a_segment_is_good_to_1e12(points: Any) -> None:
    """Compared with the exact square; zero exactly where the point is on the segment."""
    q, a, b = points
    assert is_close(point_segment_distance(q, a, b), nearest_exactly(q, a, b)[0])
    assert point_segment_distance(q, a, b) == pytest.approx(
        point_segment_distance(q, b, a), rel=2e-12
    )


def test_distances_below_1e_150_are_not_lost() -> None:
    """A point above a segment of length 1e-170 is not on it."""
    assert point_segment_distance((5e-171, 1e-170), (0, 0), (1e-170, 0)) == pytest.approx(
        1e-170, rel=1e-12, abs=0.0
    )
    assert point_line_distance((5e-171, 1e-170), (0, 0), (1e-170, 0)) == pytest.approx(
        1e-170, rel=1e-12, abs=0.0
    )
    assert line_through_points((0, 1e-170), (1e-170, 1e-170)) == pytest.approx(
        (0.0, 1.0, -1e-170), rel=1e-12, abs=0.0
    )


@LAW
@given(alike(3, (lattice, tenths, ulps, measured)))
@example(((0.0, 5.0), (1.0, 1.0), (1.0, 1.0)))
@example(((0.0, 5.0), (0.0, 0.0), (4.0, 0.0)))
@example(((4.0, 5.0), (0.0, 0.0), (4.0, 0.0)))
def test_closest_point_and_its_region(points: Any) -> None:
    """The region is exact, and a nearest point that is an end is returned unrounded."""
    q, a, b = points
    _, wanted, region = nearest_exactly(q, a, b)
    near, got = closest_point_on_segment(q, a, b)
    assert got == region
    reach = max(abs(Fraction(x)) for x in (*a, *b))
    if region:
        assert near.tolist() == list((None, a, b)[region])
    assert max(abs(Fraction(g) - w) for g, w in zip(near, wanted, strict=True)) <= reach / 10**12


# ---- lines -------------------------------------------------------------------------------------


@LAW
@given(alike(3, (lattice, tenths, ulps, measured)))
def test_distance_to_a_line_is_good_to_1e12(points: Any) -> None:
    """Compared with the exact square of the distance."""
    q, a, b = points
    assume(a != b)
    u = minus(exact(b), exact(a))
    assert is_close(
        point_line_distance(q, a, b), cross(u, minus(exact(q), exact(a))) ** 2 / dot(u, u)
    )


@LAW
@given(alike(3, (lattice, tenths, ulps)))
def test_line_is_unit_holds_both_points_and_has_left_positive(points: Any) -> None:
    """a^2 + b^2 = 1, both points are on the line, and the value is the signed distance."""
    q, p1, p2 = points
    assume(p1 != p2)
    a, b, c = line_through_points(p1, p2)
    u = minus(exact(p2), exact(p1))
    assert is_close(math.sqrt(a * a + b * b), Fraction(1))
    assert [is_close(a, u[1] ** 2 / dot(u, u)), is_close(b, u[0] ** 2 / dot(u, u))] == [True, True]
    assert (sign(a), sign(b)) == (-sign(u[1]), sign(u[0]))
    offset = cross(exact(p1), exact(p2))
    assert is_close(c, offset**2 / dot(u, u))
    assert sign(c) == sign(offset)
    value, tolerance = a * q[0] + b * q[1] + c, 1e-12 * max(map(abs, (*q, c)))
    assert value == pytest.approx(
        orientation(p1, p2, q) * point_line_distance(q, p1, p2), abs=tolerance
    )


def test_a_line_has_no_negative_zero() -> None:
    """Students compare printed coefficients."""
    for p1, p2 in (
        ((0, 0), (1, 0)),
        ((0, 0), (0, 1)),
        ((1, 0), (0, 0)),
        ((0, 1), (0, 0)),
        ((1, 1), (2, 2)),
        ((0.0, 0.0), (-0.0, 1.0)),
        ((1e-200, 0.0), (0.0, 1e150)),
    ):
        assert "-0.0" not in [str(number) for number in line_through_points(p1, p2)]


# ---- polygons ----------------------------------------------------------------------------------


@SLOW_LAW
@given(simple_polygons(), st.lists(lattice, min_size=1, max_size=8), moves, st.booleans())
def test_point_in_polygon_is_exact(polygon: Any, points: Any, move: Any, reverse: bool) -> None:
    """Compared with the winding number, on lattices scaled and shifted with rounding.

    Vertices in either order; the vertices themselves are tested too.
    """
    ring, points = moved(polygon, move), moved([*points, *polygon], move)
    assume(is_simple(ring))
    expected = [place_exactly(q, ring) >= 0 for q in points]
    given_ring = ring[::-1] if reverse else ring
    assert point_in_polygon(points, given_ring).tolist() == expected
    assert [point_in_polygon(q, given_ring) for q in points] == expected


@SLOW_LAW
@given(simple_polygons(), st.integers(0, 7), st.integers(-2, 2), st.integers(-2, 2), moves)
def test_points_a_rounding_error_off_an_edge(
    polygon: Any, edge: int, right: int, up: int, move: Any
) -> None:
    """Membership is exact within two floats of the middle of an edge."""
    ring = moved(polygon, move)
    assume(is_simple(ring))
    (ax, ay), (bx, by) = ring[edge % len(ring)], ring[(edge + 1) % len(ring)]
    q = [0.5 * (ax + bx), 0.5 * (ay + by)]
    for axis, steps in enumerate((right, up)):
        for _ in range(abs(steps)):
            q[axis] = math.nextafter(q[axis], math.copysign(math.inf, steps))
    assert point_in_polygon(q, ring) is (place_exactly(q, ring) >= 0)


@SLOW_LAW
@given(convex_polygons(), st.lists(lattice, min_size=1, max_size=8), moves)
def test_point_in_convex_polygon_is_exact(polygon: Any, points: Any, move: Any) -> None:
    """Compared with the winding number, for vertices in either order and with straight angles."""
    ring, points = moved(polygon, move), moved([*points, *polygon], move)
    order = sign(twice_area(ring))
    n = len(ring)
    assume(
        is_simple(ring)
        and all(turn_of(ring[i - 2], ring[i - 1], ring[i]) * order >= 0 for i in range(n))
    )
    expected = [place_exactly(q, ring) >= 0 for q in points]
    assert point_in_convex_polygon(points, ring).tolist() == expected
    assert [point_in_convex_polygon(q, ring) for q in points] == expected


@SLOW_LAW
@given(convex_polygons(), convex_polygons(), lattice)
@example([(0.0, 0.0), (2.0, 0.0), (0.0, 2.0)], [(1.0, 1.0), (2.0, 1.0), (2.0, 2.0)], (0.0, 0.0))
@example([(0.0, 0.0), (2.0, 0.0), (0.0, 2.0)], [(2.0, 0.0), (4.0, 0.0), (4.0, 2.0)], (0.0, 0.0))
def test_convex_polygons_intersect_exactly(P: Any, Q: Any, shift: Floats) -> None:
    """Compared with clipping; touching counts, and the order does not matter."""
    Q = [(x + shift[0], y + shift[1]) for x, y in Q]
    meet = bool(overlap_exactly(P, Q))
    assert [convex_polygons_intersect(P, Q), convex_polygons_intersect(Q, P)] == [meet, meet]


@SLOW_LAW
@given(simple_polygons(), lattice, moves)
def test_distance_to_a_polygon_is_good_to_1e12(polygon: Any, q: Floats, move: Any) -> None:
    """Zero inside and on the boundary, else the exact distance to the nearest edge."""
    ring, (q,) = moved(polygon, move), moved([q], move)
    assume(is_simple(ring))
    squared = min(
        nearest_exactly(q, a, b)[0] for a, b in zip(ring, ring[1:] + ring[:1], strict=True)
    )
    distance = point_polygon_distance(q, ring)
    assert is_close(distance, squared if place_exactly(q, ring) < 0 else Fraction(0))
    assert distance == point_polygon_distance([q, q], ring)[1]
    if max(map(abs, move)) <= 1e6:
        assert distance == pytest.approx(
            shapely.Point(q).distance(shapely.Polygon(ring)), rel=1e-9, abs=1e-9 * move[0]
        )


@SLOW_LAW
@given(simple_polygons(), lattice)
def test_the_tangent_follows_the_nearest_boundary_point(polygon: Any, q: Floats) -> None:
    """A unit vector along the nearest edge, or square to the line from the nearest vertex."""
    ring = [tuple(p) for p in as_ring(polygon).tolist()]
    nearest = [
        (nearest_exactly(q, a, b), a, b) for a, b in zip(ring, ring[1:] + ring[:1], strict=True)
    ]
    least = min(entry[0][0] for entry in nearest)
    chosen = {entry[0][1] for entry in nearest if entry[0][0] == least}
    assume(len(chosen) == 1)
    (_, vertex, region), a, b = next(entry for entry in nearest if entry[0][0] == least)
    tangent = polygon_tangent(q, polygon)
    assert math.hypot(*tangent) == pytest.approx(1.0, rel=1e-12)
    if region == 0:
        assert tangent == pytest.approx(np.subtract(b, a) / math.dist(a, b), rel=1e-12, abs=1e-12)
    elif least == 0:
        i = ring.index((float(vertex[0]), float(vertex[1])))
        leaving = np.subtract(ring[(i + 1) % len(ring)], ring[i])
        assert tangent == pytest.approx(leaving / math.hypot(*leaving), rel=1e-12, abs=1e-12)
    elif place_exactly(q, ring) < 0:
        x, y = float(Fraction(q[0]) - vertex[0]), float(Fraction(q[1]) - vertex[1])
        assert tangent == pytest.approx(np.array([-y, x]) / math.hypot(x, y), rel=1e-12, abs=1e-12)


@SLOW_LAW
@given(st.lists(st.tuples(st.integers(-4, 4), st.integers(-4, 4)), min_size=1, max_size=9))
@example([(0, 0), (1, 0), (2, 0), (3, 0)])
@example([(0, 0), (0, 3), (0, 1), (0, 1)])
@example([(2, 2), (2, 2)])
def test_convex_hull_is_what_brute_force_says(points: Any) -> None:
    """The corners are the points in no triangle and on no segment of others, from the leftmost."""
    hull = convex_hull(points)
    assert [tuple(p) for p in hull.tolist()] == hull_exactly(points)


@SLOW_LAW
@given(st.lists(st.one_of(ulps, diagonal), min_size=3, max_size=9))
def test_convex_hull_is_exact_near_a_line(points: Any) -> None:
    """The hull is strictly convex, consists of given points, and contains all of them."""
    hull = [tuple(p) for p in convex_hull(points).tolist()]
    assert set(hull) <= set(points)
    n = len(hull)
    if n > 2:
        assert all(turn_of(hull[i - 2], hull[i - 1], hull[i]) == 1 for i in range(n))
        assert all(turn_of(hull[i - 1], hull[i], p) >= 0 for i in range(n) for p in points)
    else:
        assert all(turn_of(hull[0], hull[-1], p) == 0 for p in points)


# ---- convex parts ------------------------------------------------------------------------------


def holes_in(polygon: Any, corners: Any) -> list[list[Floats]]:
    """Small disjoint triangles at given corners, as many as lie strictly inside a polygon."""
    region, holes = shapely.Polygon(polygon), []
    for x, y in corners:
        hole = shapely.Polygon([(x, y), (x + 2, y), (x + 1, y + 2)])
        if region.contains_properly(hole):
            region = region.difference(hole)
            holes.append([(x, y), (x + 2.0, y), (x + 1.0, y + 2.0)])
    return holes


@SLOW_LAW
@given(
    simple_polygons(most=10),
    st.lists(st.tuples(st.integers(-24, 24), st.integers(-24, 24)), max_size=5),
    st.lists(st.tuples(st.integers(-49, 49), st.integers(-49, 49)), min_size=10, max_size=20),
    st.sampled_from([(1.0, 0.0), (0.1, 0.3), (1e-6, 0.0), (1.0, 1e6)]),
)
@example(  # beyond one edge of each ear are other vertices
    [(7, 1), (3, 2), (5, 4), (5, 2), (7, 7), (1, 5), (4, 0)], [], [(0, 0)], (1.0, 0.0)
)
def test_convex_parts_cover_a_polygon_once(
    polygon: Any, corners: Any, probes: Any, move: Any
) -> None:
    """Areas add up exactly, parts are convex, and a point is in the polygon iff it is in a part."""
    outline = [(4 * x, 4 * y) for x, y in polygon]
    holes = [as_ring(moved(hole, move)) for hole in holes_in(outline, corners)]
    assume(is_simple(moved(outline, move)))
    ring = as_ring(moved(outline, move))
    parts = convex_parts(ring, holes)
    own = {tuple(p) for r in (ring, *holes) for p in r.tolist()}
    assert sum(map(twice_area, parts)) == twice_area(ring) - sum(map(twice_area, holes))
    for part in parts:
        assert len(part) >= 3
        assert {tuple(p) for p in part.tolist()} <= own
        assert twice_area(part) > 0
        assert all(turn_of(part[i - 2], part[i - 1], part[i]) >= 0 for i in range(len(part)))
    for q in moved([(x / 2, y / 2) for x, y in probes], move):
        places = [place_exactly(q, part) for part in parts]
        held = place_exactly(q, ring) >= 0 and all(place_exactly(q, hole) <= 0 for hole in holes)
        assert (max(places) >= 0) is held
        assert places.count(1) <= 1
        assert not (1 in places and 0 in places)


def test_a_convex_ring_is_its_own_part() -> None:
    """A convex polygon is not cut."""
    (part,) = convex_parts(as_ring(SQUARE))
    assert part.tolist() == as_ring(SQUARE).tolist()
    assert len(convex_parts(as_ring(CORNER))) == 2


def test_a_comb_is_cut_into_few_parts() -> None:
    """At most four times as many parts as needed: a comb of 20 teeth needs 20 or 21."""
    comb = [(0.0, 3.0), (0.0, 0.0), (39.0, 0.0), (39.0, 3.0)]
    for tooth in range(19, 0, -1):
        comb += [
            (2.0 * tooth, 3.0),
            (2.0 * tooth, 1.0),
            (2.0 * tooth - 1.0, 1.0),
            (2.0 * tooth - 1.0, 3.0),
        ]
    parts = convex_parts(as_ring(comb))
    assert len(parts) <= 84
    assert sum(map(twice_area, parts)) == twice_area(as_ring(comb))


def test_a_frame_is_cut_into_few_parts() -> None:
    """Around a square hole the eight triangles make four convex parts."""
    hole = as_ring([(1, 1), (3, 1), (3, 3), (1, 3)])
    assert len(convex_parts(as_ring(SQUARE), [hole])) == 4


# ---- batches -----------------------------------------------------------------------------------


@LAW
@given(st.lists(alike(4), min_size=1, max_size=5))
def test_batches_agree_with_single_calls(rows: Any) -> None:
    """Many points give the same answers as single points; one point is paired with each of many."""
    p1, p2, p3, p4 = (np.array([row[k] for row in rows]) for k in range(4))
    one_by_one = [segments_intersect(*row) for row in rows]
    assert segments_intersect(p1, p2, p3, p4).tolist() == one_by_one
    shared = segments_intersect(p1, p2, p3[0], p4[0])
    assert shared.tolist() == [
        segments_intersect(a, b, p3[0], p4[0]) for a, b in zip(p1, p2, strict=True)
    ]
    distances = point_segment_distance(p1, p3[0], p4[0])
    assert distances.tolist() == [point_segment_distance(a, p3[0], p4[0]) for a in p1]


def test_one_answer_is_a_plain_python_value() -> None:
    """bool or float for one point, an array of shape (m,) for m points, also for m = 1."""
    assert type(point_in_polygon((1, 1), CORNER)) is bool
    assert type(point_in_convex_polygon((1, 1), SQUARE)) is bool
    assert type(segments_intersect((0, 0), (1, 1), (0, 1), (1, 0))) is bool
    assert type(convex_polygons_intersect(SQUARE, SQUARE)) is bool
    assert type(orientation((0, 0), (1, 0), (0, 1))) is int
    for number in (
        point_segment_distance((1, 1), (0, 0), (1, 0)),
        point_polygon_distance((9, 9), SQUARE),
    ):
        assert type(number) is float
    assert all(type(number) is float for number in line_through_points((0, 0), (1, 2)))
    assert point_in_polygon([(1, 1)], CORNER).shape == (1,)
    assert point_polygon_distance([(1, 1)], CORNER).shape == (1,)
    assert segments_intersect([(0, 0)], (1, 1), (0, 1), (1, 0)).shape == (1,)


# ---- checks of arguments -----------------------------------------------------------------------

BAD_POINTS = [
    pytest.param((math.nan, 0), "finite", id="nan"),
    pytest.param((0, math.inf), "finite", id="inf"),
    pytest.param((0, -math.inf), "finite", id="minus inf"),
    pytest.param((1.0000001e150, 0), "1e150", id="too large"),
    pytest.param((0, -1e308), "1e150", id="far too large"),
    pytest.param((1, 2, 3), "", id="three numbers"),
    pytest.param((1,), "", id="one number"),
    pytest.param(5, "", id="a number"),
    pytest.param([], "", id="nothing"),
    pytest.param("ab", "numbers", id="a string"),
    pytest.param(("a", "b"), "numbers", id="strings"),
    pytest.param((None, 1), "", id="None"),
    pytest.param([[1, 2], [3]], "numbers", id="ragged"),
    pytest.param((1 + 2j, 0), "numbers", id="complex"),
    pytest.param((10**400, 0), "", id="a whole number beyond floats"),
]
POINT_TAKERS = {
    "orientation": lambda q: orientation((0, 0), q, (1, 0)),
    "line_through_points": lambda q: line_through_points(q, (9, 9)),
    "point_line_distance": lambda q: point_line_distance(q, (0, 0), (9, 9)),
    "point_segment_distance": lambda q: point_segment_distance(q, (0, 0), (9, 9)),
    "segment's end": lambda q: point_segment_distance((0, 0), (9, 9), q),
    "closest_point_on_segment": lambda q: closest_point_on_segment((0, 0), q, (9, 9)),
    "segments_intersect": lambda q: segments_intersect((0, 0), q, (9, 9), (1, 0)),
    "segment_intersection": lambda q: segment_intersection((0, 0), (1, 0), (9, 9), q),
    "point_in_polygon": lambda q: point_in_polygon(q, SQUARE),
    "point_in_convex_polygon": lambda q: point_in_convex_polygon(q, SQUARE),
    "point_polygon_distance": lambda q: point_polygon_distance(q, SQUARE),
    "polygon_tangent": lambda q: polygon_tangent(q, SQUARE),
    "convex_hull": lambda q: convex_hull([(0, 0), q, (1, 0)]),
}


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize(("bad", "words"), BAD_POINTS)
@pytest.mark.parametrize("taker", POINT_TAKERS)
def test_a_bad_point_is_refused_by_name(taker: str, bad: Any, words: str) -> None:
    """InvalidPoint, with a message that says what is wrong."""
    with pytest.raises(InvalidPoint) as caught:
        POINT_TAKERS[taker](bad)
    assert type(caught.value) is InvalidPoint
    assert words in str(caught.value)
    assert len(str(caught.value)) > 20


BAD_POLYGONS = [
    pytest.param([], "", id="nothing"),
    pytest.param([(0, 0), (1, 1)], "three", id="two vertices"),
    pytest.param([(0, 0)], "three", id="one vertex"),
    pytest.param([(0, 0, 0), (1, 0, 0), (0, 1, 0)], "(n, 2)", id="in space"),
    pytest.param([1, 2, 3, 4], "(n, 2)", id="flat"),
    pytest.param([(0, 0), (2, 2), (2, 0), (0, 2)], "crosses or touches itself", id="bow-tie"),
    pytest.param(
        [(0, 0), (4, 0), (4, 4), (2, 0), (0, 4)],
        "crosses or touches itself",
        id="a vertex on an edge",
    ),
    pytest.param(
        [(0, 0), (4, 0), (2, 2), (4, 4), (0, 4), (2, 2)],
        "crosses or touches itself",
        id="a vertex twice",
    ),
    pytest.param([(0, 0), (4, 0), (4, 4), (2, 4), (2, 8), (2, 4), (0, 4)], "itself", id="a spike"),
    pytest.param([(0, 0), (6, 0), (4, 0), (4, 4)], "itself", id="folds back along an edge"),
    pytest.param(
        [(0, 0), (-2, 0), (0, 0.5), (4, 4), (4, 0), (0, 0.25), (-2, 0.5)],
        "itself",
        id="crosses twice",
    ),
    pytest.param([(0, 0), (4, 0), (4, 0), (0, 4)], "repeats vertex 1", id="a vertex after itself"),
    pytest.param([(0, 0), (4, 0), (0, 4), (0, 0)], "leave out the last", id="closed"),
    pytest.param([(0, 0), (2, 2), (4, 4)], "area", id="on one line"),
    pytest.param([(0, 0), (4, 4), (2, 2)], "area", id="on one line, back"),
    pytest.param([(0, 0), (4, 4), (0, 0), (4, 4)], "area", id="there and back"),
]
POLYGON_TAKERS = {
    "point_in_polygon": lambda P: point_in_polygon((1, 1), P),
    "point_in_convex_polygon": lambda P: point_in_convex_polygon((1, 1), P),
    "convex_polygons_intersect": lambda P: convex_polygons_intersect(SQUARE, P),
    "point_polygon_distance": lambda P: point_polygon_distance((1, 1), P),
    "polygon_tangent": lambda P: polygon_tangent((1, 1), P),
}


@pytest.mark.parametrize(("bad", "words"), BAD_POLYGONS)
@pytest.mark.parametrize("taker", POLYGON_TAKERS)
def test_a_bad_polygon_is_refused_by_name(taker: str, bad: Any, words: str) -> None:
    """InvalidPolygon for vertices in either order, with a message that says what is wrong."""
    for polygon in (bad, bad[::-1]):
        with pytest.raises(InvalidPolygon) as caught:
            POLYGON_TAKERS[taker](polygon)
        assert type(caught.value) is InvalidPolygon
        if polygon is bad:
            assert words in str(caught.value)


@pytest.mark.parametrize("taker", POLYGON_TAKERS)
@pytest.mark.parametrize("bad", [math.nan, math.inf, 1e151, "x", None])
def test_a_bad_coordinate_of_a_polygon_is_a_bad_point(taker: str, bad: Any) -> None:
    """InvalidPoint says what the coordinate should be."""
    with pytest.raises(InvalidPoint):
        POLYGON_TAKERS[taker]([(0, 0), (4, bad), (4, 4)])


@SLOW_LAW
@given(st.lists(st.tuples(st.integers(-3, 3), st.integers(-3, 3)), min_size=3, max_size=7))
@example([(0, 0), (2, 0), (2, 2), (0, 2), (0, 1)])  # the last vertex is on the leftmost edge
def test_exactly_the_simple_polygons_are_accepted(vertices: Any) -> None:
    """A lattice ring is accepted iff it is simple by brute force, and made counter-clockwise."""
    if is_simple(vertices):
        ring = as_ring(vertices)
        assert twice_area(ring) == abs(twice_area(vertices))
        assert ring.tolist() == [
            list(map(float, p)) for p in (vertices if twice_area(vertices) > 0 else vertices[::-1])
        ]
    else:
        with pytest.raises(InvalidPolygon):
            as_ring(vertices)


@LAW
@given(st.lists(st.tuples(st.integers(-3, 3), st.integers(-3, 3)), min_size=4, max_size=7))
@example([(0, 0), (6, 0), (4, 0), (4, 4)])
def test_the_edges_that_are_named_do_cross(vertices: Any) -> None:
    """The two edges in the message share a point, other than the vertex between them."""
    n, fault = len(vertices), find_ring_fault(np.array(vertices, float))
    assume(fault.kind == CROSSES)
    a, b, c, d = (vertices[k % n] for k in (fault.i, fault.i + 1, fault.j, fault.j + 1))
    assert set(shared_exactly(a, b, c, d)) - ({exact(b)} if fault.j == fault.i + 1 else set())


@LAW
@given(simple_polygons(), st.integers(0, 7))
def test_the_first_reflex_vertex_is_found(polygon: Any, begin: int) -> None:
    """The first vertex at which the ring turns right, or -1 where it is convex."""
    ring = np.roll(as_ring(polygon), begin, axis=0)
    reflex = [
        i for i in range(len(ring)) if turn_of(ring[i - 1], ring[i], np.roll(ring, -1, 0)[i]) < 0
    ]
    assert find_reflex_vertex(ring) == (reflex[0] if reflex else -1)


def test_polygons_that_are_not_convex_are_refused() -> None:
    """Where a convex polygon is needed, the error names the first reflex vertex."""
    for ask in (
        lambda: point_in_convex_polygon((1, 1), CORNER),
        lambda: convex_polygons_intersect(CORNER, SQUARE),
    ):
        with pytest.raises(InvalidPolygon, match=r"convex.*\(2\.0, 2\.0\)"):
            ask()
    with pytest.raises(InvalidPolygon, match=r"^Q "):
        convex_polygons_intersect(SQUARE, CORNER)


def test_a_line_needs_two_points() -> None:
    """InvalidSegment where they coincide; a segment may be a single point."""
    for ask in (
        lambda: line_through_points((1, 2), (1, 2)),
        lambda: point_line_distance((0, 0), (1, 2), (1, 2)),
    ):
        with pytest.raises(InvalidSegment, match="distinct"):
            ask()
    assert point_segment_distance((4, 6), (1, 2), (1, 2)) == 5.0


def test_arguments_are_not_changed() -> None:
    """Arguments are copied."""
    ring, points = np.array(SQUARE[::-1], float), np.array([[1.0, 1.0], [9.0, 9.0]])
    before = ring.copy(), points.copy()
    point_in_polygon(points, ring)
    as_ring(ring)[:] = 7.0
    convex_hull(ring)[:] = 7.0
    convex_parts(as_ring(ring))[0][:] = 7.0
    assert (ring == before[0]).all()
    assert (points == before[1]).all()


def test_every_error_is_a_value_error() -> None:
    """So `except ValueError` catches them."""
    assert issubclass(KinoeduError, ValueError)
    for error in (InvalidPoint, InvalidPolygon, InvalidSegment):
        assert issubclass(error, KinoeduError)

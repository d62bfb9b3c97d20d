"""Minkowski sums compared with the hull of all sums of corners, in rational arithmetic.

Differences and erosions are compared with collision tests.
"""

from fractions import Fraction

import numpy as np
import pytest
import shapely

from kinoedu.errors import InvalidPoint, InvalidPolygon
from kinoedu.geometry import (
    convex_hull,
    convex_polygons_intersect,
    erosion,
    minkowski_difference,
    minkowski_sum,
)
from kinoedu.geometry.exact import cross_sign
from kinoedu.geometry.rings import as_convex_ring

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]


def lattice_shapes(seed, count=120, reach=6):
    """Convex polygons, segments and points with integer coordinates: parallel edges, exact sums."""
    rng = np.random.default_rng(seed)
    return [
        convex_hull(rng.integers(-reach, reach, size=(rng.integers(1, 9), 2))) for _ in range(count)
    ]


def float_shapes(seed, count=60):
    """Convex polygons of all sizes, near the origin or far away."""
    rng = np.random.default_rng(seed)
    return [
        convex_hull(
            rng.normal(size=(rng.integers(3, 30), 2)) * 10.0 ** rng.integers(-6, 6)
            + rng.normal(size=2)
        )
        for _ in range(count)
    ]


def all_sums(P, Q):
    """The hull of all sums of corners, by Andrew's algorithm on fractions."""
    points = sorted({tuple(Fraction(a) + Fraction(b) for a, b in zip(p, q)) for p in P for q in Q})
    if len(points) < 3:
        return points

    def chain(ordered):
        kept = []
        for p in ordered:
            while len(kept) > 1 and cross(kept[-2], kept[-1], p) <= 0:
                kept.pop()
            kept.append(p)
        return kept[:-1]

    return chain(points) + chain(points[::-1])


def cross(a, b, c):
    """(b - a) x (c - a)."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def area(P):
    """The area of a polygon, 0 for fewer than three corners; exact for fractions."""
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(P, [*P[1:], *P[:1]])) / 2


def perimeter(P):
    """The length of the boundary."""
    return float(np.linalg.norm(np.asarray(P) - np.roll(P, -1, axis=0), axis=1).sum())


def test_a_sum_on_the_lattice_is_the_hull_of_all_sums_of_corners():
    """The same corners in the same order, for polygons, segments and points."""
    for P, Q in zip(lattice_shapes(1, 400), lattice_shapes(2, 400)):
        assert [tuple(map(Fraction, p)) for p in minkowski_sum(P, Q).tolist()] == all_sums(
            P.tolist(), Q.tolist()
        )
        negated = (-Q).tolist()
        assert [tuple(map(Fraction, p)) for p in minkowski_difference(P, Q).tolist()] == all_sums(
            P.tolist(), negated
        )


def test_a_sum_of_floats_is_within_one_rounding_of_the_exact_one():
    """The sum is convex, and each exact corner is near one of its corners, or near its boundary."""
    for P, Q in zip(float_shapes(3), float_shapes(4)):
        S, exact = minkowski_sum(P, Q), all_sums(P.tolist(), Q.tolist())
        # strictly convex, from the leftmost corner
        assert np.array_equal(as_convex_ring(S), convex_hull(S))
        size = max(np.abs(P).max() + np.abs(Q).max(), 1e-300)
        corners = np.array([[float(x) for x in corner] for corner in exact])
        distances = shapely.distance(shapely.polygons(S).exterior, shapely.points(corners))
        assert distances.max() <= 4e-16 * size
        error = area([tuple(map(Fraction, p)) for p in S.tolist()]) - area(exact)
        assert abs(error) <= 1e-15 * size * perimeter(S)


def test_sums_commute_and_associate():
    """P + Q = Q + P always; (P + Q) + R = P + (Q + R) where nothing is rounded."""
    for P, Q, R in zip(lattice_shapes(5), lattice_shapes(6), lattice_shapes(7)):
        assert np.array_equal(minkowski_sum(P, Q), minkowski_sum(Q, P))
        assert np.array_equal(
            minkowski_sum(minkowski_sum(P, Q), R), minkowski_sum(P, minkowski_sum(Q, R))
        )
    for P, Q in zip(float_shapes(8), float_shapes(9)):
        assert np.array_equal(minkowski_sum(P, Q), minkowski_sum(Q, P))


def test_areas_follow_the_mixed_area():
    """area(P + t Q) = area(P) + 2 t V + t^2 area(Q) for t = 1, 2, 3 with one V; perimeters add."""
    for P, Q in zip(lattice_shapes(10), lattice_shapes(11)):
        twice_mixed = [
            area(minkowski_sum(P, t * Q).tolist()) - area(P.tolist()) - t * t * area(Q.tolist())
            for t in (1, 2, 3)
        ]
        assert twice_mixed[1] == 2 * twice_mixed[0] and twice_mixed[2] == 3 * twice_mixed[0]
        assert perimeter(minkowski_sum(P, Q)) == pytest.approx(
            perimeter(P) + perimeter(Q), rel=1e-13
        )


def test_nearly_parallel_edges_keep_their_order():
    """Edges whose directions differ in the last bit stay two edges; equal directions become one."""
    P = [(0, 0), (3.0, 1.0), (0, 5.0)]
    for end in (1.0, np.nextafter(1.0, 2), np.nextafter(1.0, 0)):
        Q = [(0, 0), (3.0, end), (0, 4.0)]
        exact = all_sums(np.array(P).tolist(), np.array(Q).tolist())
        assert cross_sign(0.0, 0.0, 3.0, 1.0, 0.0, 0.0, 3.0, end) == int(end > 1.0) - int(end < 1.0)
        assert len(minkowski_sum(P, Q)) <= len(exact) and (len(exact) == 4) == (end == 1.0)


def test_directions_are_compared_exactly():
    """The sign is that of the rational cross product, also for almost equal directions."""
    rng = np.random.default_rng(12)
    for _ in range(3000):
        a, u, c = rng.normal(size=(3, 2)) * 10.0 ** rng.integers(-8, 8, size=(3, 1))
        b, d = a + u, c + u * rng.integers(-3, 4) + rng.integers(-1, 2) * np.spacing(c)
        (ax, ay), (bx, by), (cx, cy), (dx, dy) = (tuple(map(Fraction, p)) for p in (a, b, c, d))
        value = (bx - ax) * (dy - cy) - (by - ay) * (dx - cx)
        assert cross_sign(*a, *b, *c, *d) == (value > 0) - (value < 0)


def test_the_difference_is_where_the_robot_touches():
    """q is in P ⊖ Q exactly when Q moved to q meets P, contact included."""
    shapes = [
        (P, Q) for P, Q in zip(lattice_shapes(13), lattice_shapes(14)) if len(P) > 2 and len(Q) > 2
    ]
    for P, Q in shapes[:30]:
        obstacle = shapely.Polygon(minkowski_difference(P, Q))
        for q in np.random.default_rng(15).integers(-12, 12, size=(40, 2)):
            assert obstacle.intersects(shapely.Point(q)) == convex_polygons_intersect(P, Q + q)


def test_an_erosion_is_where_the_robot_fits():
    """q is in erosion(P, Q) exactly when Q moved to q is in P; the erosion of P + Q by Q is P."""
    rng = np.random.default_rng(16)
    for P, Q in zip(lattice_shapes(17, 300, 12), lattice_shapes(18, 300, 3)):
        if len(P) < 3:
            continue
        inner, whole = erosion(P, Q), shapely.Polygon(P)
        shape = shapely.Polygon(inner) if len(inner) else shapely.Polygon()
        for q in rng.uniform(-12, 12, size=(30, 2)):
            assert shape.contains(shapely.Point(q)) == whole.contains(
                shapely.MultiPoint(Q + q).convex_hull
            )
        back = erosion(minkowski_sum(P, Q), Q)
        assert shapely.Polygon(back).symmetric_difference(whole).area <= 1e-12 * whole.area


def test_the_erosion_is_empty_where_nothing_fits():
    """The result is empty if Q is too large, or touches P on opposite sides."""
    assert (
        erosion(SQUARE, 2 * np.array(SQUARE)).shape
        == erosion(SQUARE, [(0, 0), (1, 0)]).shape
        == (0, 2)
    )
    assert erosion(SQUARE, [(0, 0), (0.5, 0)]).tolist() == [[0, 0], [0.5, 0], [0.5, 1], [0, 1]]


def test_points_and_segments():
    """Sums of points, of segments, and of a point and a polygon."""
    assert minkowski_sum(SQUARE, (3, 4)).tolist() == [[3, 4], [4, 4], [4, 5], [3, 5]]
    assert minkowski_sum([(0, 0), (2, 0)], [(0, 0), (1, 3)]).tolist() == [
        [0, 0],
        [2, 0],
        [3, 3],
        [1, 3],
    ]
    assert minkowski_sum([(0, 0), (2, 0)], [(5, 0), (1, 0)]).tolist() == [[1, 0], [7, 0]]
    assert minkowski_sum((1, 2), (3, 4)).tolist() == [[4, 6]]


def test_straight_angles_and_clockwise_polygons_are_taken():
    """Arguments are as for as_convex_ring; the result has only true corners."""
    straight = [(0, 0), (0, 1), (0.5, 1), (1, 1), (1, 0)]
    assert minkowski_sum(straight, SQUARE).tolist() == [[0, 0], [2, 0], [2, 2], [0, 2]]


def test_huge_and_tiny_together():
    """A polygon too small for the other's digits changes nothing, and no corner is repeated."""
    huge, tiny = 1e150 * np.array(SQUARE), 1e-150 * np.array(SQUARE)
    assert np.array_equal(minkowski_sum(huge, tiny), huge)
    assert minkowski_sum(tiny, tiny).tolist() == (2 * tiny).tolist()


@pytest.mark.parametrize(
    ("P", "error"),
    [
        ([(0, 0), (4, 0), (1, 1), (0, 4)], InvalidPolygon),
        ([(0, 0), (1, 1), (2, 2)], InvalidPolygon),
        ([], InvalidPolygon),
        (np.empty((0, 2)), InvalidPolygon),
        ([(0, 0), (1, np.nan), (2, 2)], InvalidPoint),
        ([(0, 0, 0)], InvalidPolygon),
    ],
)
def test_polygons_that_are_not_convex_are_refused(P, error):
    """Reflex, without area, empty, not finite, not two-dimensional."""
    for function in (minkowski_sum, minkowski_difference):
        for arguments in ((P, SQUARE), (SQUARE, P)):
            with pytest.raises(error):
                function(*arguments)

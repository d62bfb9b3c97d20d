"""Motions of points and disks among polygons and on terrains, against fractions and shapely.

In worlds with integer coordinates, where contact is common, every answer must equal that of exact
fractions. In worlds with arbitrary coordinates the answers must equal shapely's, except for motions
within rounding of a contact.
"""

import math
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import example, given
from hypothesis import strategies as st
from test_geometry import (
    SLOW_LAW,
    SQUARE,
    exact,
    holes_in,
    minus,
    nearest_exactly,
    place_exactly,
    shared_exactly,
    simple_polygons,
)

from kinoedu import Disk, Point, PolygonWorld, Problem, Recorder, Terrain, UncertainWorld
from kinoedu.collision import is_free, is_free_path, is_semi_free_path
from kinoedu.errors import (
    InvalidGoal,
    InvalidParameter,
    InvalidPoint,
    InvalidPolygon,
    InvalidRobot,
    InvalidStart,
    InvalidWorld,
)
from kinoedu.geometry.parts import motion_touches_part
from kinoedu.worlds.parts_index import motion_touches_any
from kinoedu.worlds.polygon_world import discs_of, rings_of

EPSILON = Fraction(
    1, 10**18
)  # far below the gaps between features of the whole-numbered worlds used here
BOX = [(-24, -24), (24, -24), (24, 24), (-24, 24)]


def at(x: float, y: float) -> Any:
    return np.array([x, y], float)


def free(robot: Any, world: Any, a: Any, b: Any, clearance: float = 0.0) -> bool:
    return bool(is_free_path(robot, world, at(*a), at(*b), clearance))


def semi_free(robot: Any, world: Any, a: Any, b: Any, clearance: float = 0.0) -> bool:
    return bool(is_semi_free_path(robot, world, at(*a), at(*b), clearance))


# ---- polygons, exactly --------------------------------------------------------------------------


class ExactWorld:
    """A world of polygons with rooms and discs, tested by brute force with fractions."""

    def __init__(self, boundary: Any, polygons: Any, discs: Any = ()) -> None:
        self.boundary, self.polygons, self.discs = boundary, polygons, discs
        rings = [boundary, *(ring for polygon, rooms in polygons for ring in (polygon, *rooms))]
        self.edges = [
            edge for ring in rings for edge in zip(ring, [*ring[1:], ring[0]], strict=True)
        ]
        self.record = PolygonWorld(
            boundary, [(p, rooms) if rooms else p for p, rooms in polygons] + list(discs)
        )

    def is_solid(self, q: Any) -> bool:
        return (
            place_exactly(q, self.boundary) <= 0
            or any(
                place_exactly(q, p) >= 0 and all(place_exactly(q, r) <= 0 for r in rooms)
                for p, rooms in self.polygons
            )
            or any(nearest_exactly(q, c, c)[0] <= r * r for c, r in self.discs)
        )

    def is_free(self, a: Any, b: Any) -> bool:
        """No contact: the motion starts in the free space and meets neither an edge nor a disc."""
        return not (
            self.is_solid(a)
            or any(shared_exactly(a, b, *edge) for edge in self.edges)
            or any(nearest_exactly(c, a, b)[0] <= r * r for c, r in self.discs)
        )

    def is_semi_free(self, a: Any, b: Any) -> bool:
        """Nowhere solid on both sides, by points beside each stretch between contacts."""
        if any(nearest_exactly(c, a, b)[0] < r * r for c, r in self.discs):
            return False
        a, b = exact(a), exact(b)
        u = minus(b, a)
        k = 0 if u[0] else 1
        cuts = sorted(
            {
                Fraction(0),
                Fraction(1),
                *((p[k] - a[k]) / u[k] for e in self.edges for p in shared_exactly(a, b, *e)),
            }
        )
        for t in [(s + e) / 2 for s, e in pairwise(cuts)]:
            x, y = a[0] + t * u[0], a[1] + t * u[1]
            if all(
                self.is_solid((x - side * u[1], y + side * u[0])) for side in (EPSILON, -EPSILON)
            ):
                return False
        return True


whole = st.tuples(st.integers(-24, 24), st.integers(-24, 24))


@st.composite
def exact_worlds(draw: Any) -> ExactWorld:
    """Boundaries with pockets; obstacles that overlap, touch, have rooms, or are round."""
    boundary = (
        BOX if draw(st.booleans()) else [(4 * x, 4 * y) for x, y in draw(simple_polygons(most=9))]
    )
    polygons = []
    for polygon in draw(st.lists(simple_polygons(most=6), max_size=4)):
        size = draw(st.sampled_from([1, 2, 3]))
        x0, y0 = draw(whole)
        ring = [(int(size * x + x0), int(size * y + y0)) for x, y in polygon]
        rooms = holes_in(ring, draw(st.lists(whole, max_size=4)))
        polygons.append((ring, rooms))
    discs = draw(st.lists(st.tuples(whole, st.integers(1, 6)), max_size=2))
    return ExactWorld([(int(x), int(y)) for x, y in boundary], polygons, discs)


@SLOW_LAW
@given(exact_worlds(), st.lists(st.tuples(whole, whole), min_size=4, max_size=8))
@example(
    ExactWorld(
        BOX, [([(0, 0), (4, 0), (4, 4), (0, 4)], []), ([(4, 0), (8, 0), (8, 4), (4, 4)], [])]
    ),
    [((4, -9), (4, 9))],
)
@example(
    ExactWorld([(0, 0), (8, 0), (8, 8), (4, 2), (0, 8)], []),
    [((0, 8), (8, 8)), ((1, 1), (7, 1)), ((2, 5), (6, 5))],
)
def test_points_among_polygons_are_judged_exactly(world: ExactWorld, motions: Any) -> None:
    """Free and semi-free motions and configurations of a point are tested exactly.

    In both directions, on a lattice, where motions graze, slide and touch at corners.
    """
    corners = [edge[0] for edge in world.edges]
    motions += zip(corners[::2], corners[1::2], strict=False)
    motions += [(corner, a) for corner, (a, _) in zip(corners, motions, strict=False)]
    for a, b in motions:
        assert bool(is_free(Point(), world.record, at(*a), 0.0)) is world.is_free(a, a)
        if a == b:
            continue
        assert (a, b, free(Point(), world.record, a, b)) == (a, b, world.is_free(a, b))
        assert free(Point(), world.record, b, a) is free(Point(), world.record, a, b)
        assert (a, b, semi_free(Point(), world.record, a, b)) == (a, b, world.is_semi_free(a, b))
        assert semi_free(Point(), world.record, b, a) is semi_free(Point(), world.record, a, b)


@SLOW_LAW
@given(
    exact_worlds(),
    st.lists(st.tuples(whole, whole), min_size=1, max_size=4),
    st.integers(0, 4),
    st.integers(0, 4),
)
def test_parts_of_a_free_path_are_free(world: ExactWorld, motions: Any, i: int, j: int) -> None:
    """Every part of a free motion is free; a free motion is semi-free, and its ends are free."""
    for a, b in motions:
        whole_motion = [at(*a) + k / 4 * (at(*b) - at(*a)) for k in range(5)]
        for robot, clearance in ((Point(), 0.0), (Disk(0.75), 0.5)):
            if free(robot, world.record, a, b, clearance):
                assert free(robot, world.record, whole_motion[i], whole_motion[j], clearance)
                assert semi_free(robot, world.record, a, b, clearance)
                assert is_free(robot, world.record, whole_motion[i], clearance)
            if semi_free(robot, world.record, a, b, clearance) and i != j:
                assert semi_free(robot, world.record, whole_motion[i], whole_motion[j], clearance)


class TestContact:
    """A motion in contact is not free; it is semi-free unless both of its sides are solid."""

    box = PolygonWorld(
        BOX, [SQUARE, [(x + 4, y) for x, y in SQUARE], [(x + 8, y + 4) for x, y in SQUARE]]
    )

    @pytest.mark.parametrize(
        ("a", "b", "semi"),
        [
            pytest.param((-4, 0), (4, 8), True, id="grazes a corner"),
            pytest.param((-4, 0), (12, 0), True, id="runs along two edges"),
            pytest.param((1, 4), (3, 4), True, id="within an edge"),
            pytest.param((-4, 2), (0, 2), True, id="ends on an edge"),
            pytest.param((4, -4), (4, 0), True, id="ends at the seam's end"),
            pytest.param((4, 0), (4, 4), False, id="slides along the seam"),
            pytest.param((4, 1), (4, 2), False, id="within the seam"),
            pytest.param((4, -4), (4, 8), False, id="through the seam"),
            pytest.param((4, 8), (12, 0), True, id="between two corners that meet"),
            pytest.param((-4, 2), (1, 2), False, id="ends inside"),
            pytest.param((1, 1), (2, 3), False, id="all inside"),
            pytest.param((0, 0), (4, 4), False, id="from corner to corner through the inside"),
            pytest.param((-24, -20), (-24, 20), True, id="along the boundary"),
            pytest.param((-24, -24), (24, -24), True, id="the whole of a boundary's edge"),
            pytest.param((-24, 0), (-20, 0), True, id="starts on the boundary"),
            pytest.param((-25, 0), (-20, 0), False, id="comes from outside"),
            pytest.param((-30, 30), (30, 30), False, id="stays outside"),
            pytest.param((0, -30), (0, -20), False, id="through the boundary"),
        ],
    )
    def test_contact_is_not_free(self, a: Any, b: Any, semi: bool) -> None:
        for start, end in ((a, b), (b, a)):
            assert not free(Point(), self.box, start, end)
            assert semi_free(Point(), self.box, start, end) is semi

    @pytest.mark.parametrize(
        ("q", "is_free_there", "semi"),
        [
            pytest.param((-4, 0), True, True, id="in the open"),
            pytest.param((0, 2), False, True, id="on an edge"),
            pytest.param((1, 0), False, True, id="on a level edge"),
            pytest.param((0, 0), False, True, id="at a corner"),
            pytest.param((8, 4), False, True, id="where two corners meet"),
            pytest.param((1, 3), False, False, id="inside"),
            pytest.param((4, 2), False, False, id="on a seam"),
            pytest.param((-24, 3), False, True, id="on the boundary"),
            pytest.param((24, 24), False, True, id="at the boundary's corner"),
            pytest.param((-25, 3), False, False, id="outside"),
        ],
    )
    def test_standing_still(self, q: Any, is_free_there: bool, semi: bool) -> None:
        """A configuration in contact is semi-free; a configuration inside an obstacle is not."""
        assert bool(is_free(Point(), self.box, at(*q), 0.0)) is is_free_there
        assert free(Point(), self.box, q, q) is is_free_there
        assert semi_free(Point(), self.box, q, q) is semi

    def test_a_disk_touches_at_its_radius(self) -> None:
        """Along an edge, past a corner (3-4-5), between walls, and at the boundary."""
        for a, b in (
            ((-6, -1), (12, -1)),
            ((-1, -1.0), (-1, 9)),
            ((-1, 2), (-5, 2)),
            ((-23, 0), (-23, 5)),
        ):
            assert not free(Disk(1.0), self.box, a, b)
            assert semi_free(Disk(1.0), self.box, a, b)
            assert free(Disk(0.999999), self.box, a, b)
            assert not semi_free(Disk(1.000001), self.box, a, b)
        assert not free(Disk(5.0), self.box, (-3, -4), (-3, -4))
        assert semi_free(Disk(5.0), self.box, (-3, -4), (-3, -4))
        gate = PolygonWorld(
            BOX,
            [[(-24, 1), (24, 1), (24, 9), (-24, 9)], [(-24, -9), (24, -9), (24, -1), (-24, -1)]],
        )
        assert not free(Disk(1.0), gate, (-20, 0), (20, 0))
        assert semi_free(Disk(1.0), gate, (-20, 0), (20, 0))
        assert free(Disk(0.9999999), gate, (-20, 0), (20, 0))

    def test_a_round_obstacle_touches_at_its_radius(self) -> None:
        """A point past it at exactly its radius, a disk at the sum of the two."""
        world = PolygonWorld(BOX, [((0, 0), 5)])
        assert not free(Point(), world, (-9, 5), (9, 5))
        assert semi_free(Point(), world, (-9, 5), (9, 5))
        assert free(Point(), world, (-9, 5.000000001), (9, 5.000000001))
        assert not semi_free(Point(), world, (-9, 4.999999999), (9, 4.999999999))
        assert not free(Disk(2), world, (-9, 7), (9, 7))
        assert semi_free(Disk(2), world, (-9, 7), (9, 7))
        assert not free(Point(), world, (3, 4), (9, 9))
        assert not free(Point(), world, (1, 1), (1, 1))


def test_a_radius_may_be_an_array_without_axes() -> None:
    """As np.squeeze and np.load return one number."""
    world = PolygonWorld(BOX, [((0, 0), np.array(5.0))])
    assert world.obstacles.radius.tolist() == [5.0]


def test_rooms_are_free_within_and_hold_obstacles() -> None:
    """In nested walls and rooms every wall blocks a motion and every room is free."""
    wall, room = (
        [(-12, -12), (12, -12), (12, 12), (-12, 12)],
        [(-10, -10), (10, -10), (10, 10), (-10, 10)],
    )
    island, cell = [(-6, -6), (6, -6), (6, 6), (-6, 6)], [(-4, -4), (4, -4), (4, 4), (-4, 4)]
    world = PolygonWorld(BOX, [(wall, [room]), (island, [cell]), ((0, 0), 1)])
    for a, b, is_free_way in (
        ((-20, 0), (-20, 20), True),
        ((-20, 0), (-8, 0), False),
        ((-8, -8), (8, -8), True),
        ((-8, -8), (-8, 8), True),
        ((-8, 0), (-3, 0), False),
        ((-3, -3), (3, -3), True),
        ((-3, 0), (3, 0), False),
        ((-11, 0), (-11, 5), False),
        ((-10, 0), (-10, 5), False),
        ((-5, -5), (-5, 5), False),
    ):
        assert free(Point(), world, a, b) is is_free_way
    assert semi_free(Point(), world, (-10, 0), (-10, 5))
    assert not semi_free(Point(), world, (-11, 0), (-11, 5))
    assert free(Disk(1.5), world, (-8, -8), (8, -8))
    assert not free(Disk(2.0), world, (-8, -8), (8, -8))
    assert semi_free(Disk(2.0), world, (-8, -8), (8, -8))
    assert [len(rings) for rings in rings_of(world)] == [1, 2, 2]
    assert discs_of(world).tolist() == [[0.0, 0.0, 1.0]]


def test_pockets_of_the_boundary_are_solid() -> None:
    """Also where a vertex between two pockets lies on an edge of the hull, and at its corners."""
    boundary = [
        (0, 0),
        (12, 0),
        (12, 8),
        (10, 8),
        (9, 4),
        (8, 8),
        (6, 8),
        (4, 8),
        (3, 2),
        (2, 8),
        (0, 8),
    ]
    world = ExactWorld(boundary, [])
    for i in range(-1, 14):
        for j in range(-1, 10):
            assert bool(is_free(Point(), world.record, at(i, j), 0.0)) is (
                place_exactly((i, j), boundary) > 0
            )
            for b in ((1, 1), (11, 7), (5, 7), (7, 7), (1, 7)):
                if (i, j) != b:
                    assert free(Point(), world.record, (i, j), b) is world.is_free((i, j), b)
                    assert semi_free(Point(), world.record, (i, j), b) is world.is_semi_free(
                        (i, j), b
                    )


@pytest.mark.parametrize("width", [1e-9, 1e-12, 1e-15])
@pytest.mark.parametrize("robot", [Point(), Disk(1e-3)], ids=["point", "disk"])
def test_a_sliver_of_a_wall_stops_everything(width: float, robot: Any) -> None:
    """No motion through a wall of width 1e-9, or of a few floats, is free, whatever its length."""
    wall = [(0.5, -30), (0.5 + width, -30), (0.5 + width, 30), (0.5, 30)]
    world = PolygonWorld(BOX, [wall])
    rng = np.random.default_rng(0)
    for _ in range(300):
        a, b = rng.uniform([-23, -23], [0.4, 23]), rng.uniform([0.6, -23], [23, 23])
        assert not free(robot, world, a, b)
        assert not free(robot, world, b, a)
        if width >= 1e-9:
            assert not semi_free(robot, world, a, b)
        assert free(robot, world, a, (0.4, a[1]))


# ---- polygons, against shapely ------------------------------------------------------------------


def random_world(
    rng: np.random.Generator, scale: float, shift: float
) -> tuple[Any, list[Any], list[Any]]:
    """A boundary with pockets, its solids as shapely polygons (the outside first) and its discs.

    Scaled and shifted.
    """

    def star(centre: Any, low: float, high: float, n: int) -> Any:
        angles = (np.arange(n) + rng.uniform(0.1, 0.9, n)) * 2 * np.pi / n
        radii = rng.uniform(low, high, n)
        return np.column_stack([np.cos(angles), np.sin(angles)]) * radii[:, None] + centre

    boundary = star((0, 0), 6, 12, 14) * scale + shift
    polygons = []
    for _ in range(6):
        centre = rng.uniform(-8, 8, 2)
        ring = star(centre, 0.6, 3.0, int(rng.integers(3, 9)))
        rooms = [centre + np.array([(-0.2, -0.2), (0.2, -0.2), (0.0, 0.2)])]
        has_room = shapely.Polygon(ring).contains_properly(shapely.Polygon(rooms[0]))
        polygons.append(
            (ring * scale + shift, [room * scale + shift for room in rooms] if has_room else [])
        )
    discs = [
        (rng.uniform(-8, 8, 2) * scale + shift, float(rng.uniform(0.2, 1.5) * scale))
        for _ in range(3)
    ]
    outside = shapely.Polygon(boundary).buffer(30 * scale).difference(shapely.Polygon(boundary))
    return (
        boundary,
        polygons,
        [discs, [outside, *(shapely.Polygon(*polygon) for polygon in polygons)]],
    )


@pytest.mark.parametrize(
    ("scale", "shift"), [(1.0, 0.0), (1.0, 1e6), (1e-6, 0.0), (1e6, 0.0), (1e6, -1e9)]
)
def test_motions_among_polygons_agree_with_shapely(scale: float, shift: float) -> None:
    """Points and disks, with and without clearance, in worlds of any size and position.

    Cases within rounding of contact are left out.
    """
    rng = np.random.default_rng(1)
    margin = 1e-9 * scale + 1e-14 * abs(shift)
    judged = {True: 0, False: 0}
    for _ in range(8):
        boundary, polygons, (discs, solids) = random_world(rng, scale, shift)
        world = PolygonWorld(
            boundary, [(p, rooms) if rooms else p for p, rooms in polygons] + discs
        )
        shapely.prepare(solids)
        for _ in range(60):
            a = rng.uniform(-11, 11, 2) * scale + shift
            b = (
                rng.uniform(-11, 11, 2) * scale + shift
                if rng.random() < 0.3
                else a + rng.uniform(-2, 2, 2) * scale
            )
            line = shapely.LineString([a, b])
            gap = min(
                [line.distance(s) for s in solids]
                + [line.distance(shapely.Point(c)) - r for c, r in discs]
            )
            inside = max(line.intersection(s).length for s in solids)
            for reach in (0.0, 0.01 * scale, 0.4 * scale):
                robot = Disk(reach) if reach else Point()
                answer = free(robot, world, a, b)
                assert free(robot, world, b, a) is answer
                if gap > reach + margin:
                    assert answer
                    assert semi_free(robot, world, a, b)
                elif gap < reach - margin or inside > margin:
                    assert not answer
                    if inside > 1e-3 * scale or (reach and gap < reach - margin):
                        assert not semi_free(robot, world, a, b)
                judged[answer] += 1
    assert min(judged.values()) > 100


@SLOW_LAW
@given(exact_worlds(), whole, whole, st.floats(0.01, 3.0), st.floats(0.0, 3.0))
def test_clearance_is_a_larger_disk(
    world: ExactWorld, a: Any, b: Any, radius: float, clearance: float
) -> None:
    """Disk(r) with clearance c is Disk(r + c); a point with clearance c is Disk(c)."""
    for ask in (free, semi_free):
        expected = ask(Disk(radius + clearance), world.record, a, b)
        assert ask(Disk(radius), world.record, a, b, clearance) is expected
        assert ask(Point(), world.record, a, b, radius + clearance) is expected


def test_the_index_finds_what_looking_at_every_part_finds() -> None:
    """The index gives the same answers as a test of every part, for points and discs.

    150 obstacles, some across the boundary or outside; motions of every length, also along grid
    lines.
    """
    rng = np.random.default_rng(2)
    obstacles: list[Any] = []
    for k in range(150):
        x, y = rng.integers(-52, 52, 2).tolist()
        size = float(rng.choice([0.5, 1, 1, 2, 9]))
        square = [(x, y), (x + size, y), (x + size, y + size), (x, y + size)]
        obstacles.append((((x, y), size / 2), square[:3], square)[k % 3])
    world = PolygonWorld([(-50, -50), (50, -50), (50, 30), (-50, 30)], obstacles)
    parts, cells = world.obstacles, world.cells
    found = 0
    for k in range(400):
        a = rng.uniform((-50, -50), (50, 30))
        b = a + rng.normal(0, float(rng.choice([0.1, 2, 40])), 2)
        if k % 3 == 0:
            a, b = np.round(a), np.round(b)
        if k % 5 == 0:
            b[int(rng.integers(2))] = a[0] if k % 2 else b[0]
            b[1] = a[1] if k % 10 == 0 else b[1]
        if not ((world.lo <= b) & (b <= world.hi)).all():
            continue
        for radius in (0.0, 0.3, 4.0):
            touches = any(
                motion_touches_part(*a, *b, radius, parts, i) for i in range(len(parts.radius))
            )
            assert motion_touches_any(*a, *b, radius, parts, cells) == touches
            found += touches
    assert 150 < found < 1000


def test_a_world_without_obstacles_is_free_inside() -> None:
    """Only the boundary blocks motions."""
    world = PolygonWorld(SQUARE)
    assert free(Point(), world, (1, 1), (3, 3))
    assert not free(Point(), world, (1, 1), (4, 3))
    assert free(Disk(0.9), world, (1, 1), (3, 3))
    assert not free(Disk(1.0), world, (1, 1), (3, 3))


# ---- terrains -----------------------------------------------------------------------------------


class ExactTerrain:
    """A bitmap with cells of side 1 from (0, 0), tested by brute force with fractions."""

    def __init__(self, cells: Any) -> None:
        self.cells = cells
        self.rows, self.columns = len(cells), len(cells[0])

    def is_solid(self, x: Fraction, y: Fraction) -> bool:
        """For points on no grid line."""
        i, j = math.floor(x), math.floor(y)
        return not (0 <= i < self.columns and 0 <= j < self.rows and self.cells[j][i])

    def is_free(self, a: Any, b: Any) -> bool:
        """Strictly inside the border, and no blocked cell meets the motion."""
        if not all(0 < x < self.columns and 0 < y < self.rows for x, y in (a, b)):
            return False
        u = minus(b, a)
        for j in range(self.rows):
            for i in range(self.columns):
                first, last = Fraction(0), Fraction(1)
                for start, way, low in ((a[0], u[0], i), (a[1], u[1], j)):
                    if way == 0:
                        first = first if low <= start <= low + 1 else Fraction(2)
                        continue
                    enter, leave = sorted([(low - start) / way, (low + 1 - start) / way])
                    first, last = max(first, enter), min(last, leave)
                if first <= last and not self.cells[j][i]:
                    return False
        return True

    def is_semi_free(self, a: Any, b: Any) -> bool:
        """Between two grid lines the motion never has solid cells on both sides."""
        u = minus(b, a)
        cuts = {Fraction(0), Fraction(1)}
        for k, size in ((0, self.columns), (1, self.rows)):
            cuts |= {
                t
                for line in range(-1, size + 2)
                if u[k]
                for t in [(line - a[k]) / u[k]]
                if 0 < t < 1
            }
        ordered = sorted(cuts)
        for t in [(s + e) / 2 for s, e in pairwise(ordered)]:
            x, y = a[0] + t * u[0], a[1] + t * u[1]
            if all(
                self.is_solid(x - e * u[1] + e * e, y + e * u[0] + e * e)
                for e in (EPSILON, -EPSILON)
            ):
                return False
        return True


cell = st.sampled_from([True, True, False])
bitmaps = st.integers(1, 5).flatmap(
    lambda n: st.lists(st.lists(cell, min_size=n, max_size=n), min_size=1, max_size=5)
)
halves = st.tuples(st.integers(-1, 11), st.integers(-1, 11)).map(
    lambda p: (Fraction(p[0], 2), Fraction(p[1], 2))
)
placements = st.sampled_from(
    [(1.0, (0.0, 0.0)), (0.5, (3.0, -7.0)), (0.125, (-2.0, 1.5)), (64.0, (1024.0, -4096.0))]
)


@SLOW_LAW
@given(bitmaps, st.lists(st.tuples(halves, halves), min_size=5, max_size=15), placements)
@example(
    [[True, False], [False, True]],
    [((Fraction(1, 2), Fraction(1, 2)), (Fraction(3, 2), Fraction(3, 2)))],
    (1.0, (0.0, 0.0)),
)
def test_points_on_terrains_are_judged_exactly(cells: Any, motions: Any, placement: Any) -> None:
    """Motions, semi-free motions and configurations, in both directions, between half cells.

    At any resolution and origin.
    """
    oracle, (side, (x0, y0)) = ExactTerrain(cells), placement
    world = Terrain(cells, resolution=side, origin=(x0, y0))
    for a, b in motions:
        p, q = ((x0 + side * float(x), y0 + side * float(y)) for x, y in (a, b))
        assert bool(is_free(Point(), world, at(*p), 0.0)) is oracle.is_free(a, a)
        assert (a, b, free(Point(), world, p, q)) == (a, b, oracle.is_free(a, b))
        assert free(Point(), world, q, p) is oracle.is_free(a, b)
        if a != b:
            assert (a, b, semi_free(Point(), world, p, q)) == (a, b, oracle.is_semi_free(a, b))
            assert semi_free(Point(), world, q, p) is oracle.is_semi_free(a, b)


class TestTerrainContact:
    """Two blocked cells side by side, and two that meet at a corner; rows are given from below."""

    world = Terrain(
        [[1, 1, 1, 1, 1, 1], [1, 0, 0, 1, 1, 1], [1, 1, 1, 0, 1, 1], [1, 1, 1, 1, 1, 1]]
    )

    @pytest.mark.parametrize(
        ("a", "b", "semi"),
        [
            pytest.param(
                (2.5, 2.5), (3.5, 1.5), True, id="between two cells that meet at a corner"
            ),
            pytest.param((0.5, 1.5), (1.0, 1.5), True, id="ends on an edge"),
            pytest.param((0.5, 0.5), (1.0, 1.0), True, id="ends at a corner"),
            pytest.param((0.5, 1.5), (1.5, 0.5), True, id="grazes a corner"),
            pytest.param((0.5, 1), (4.5, 1), True, id="along a grid line"),
            pytest.param((1, 0.5), (1, 2.5), True, id="up a grid line"),
            pytest.param((2, 1), (2, 2), False, id="between two cells that share an edge"),
            pytest.param((2, 1.25), (2, 1.75), False, id="within the shared edge"),
            pytest.param((2, 0.5), (2, 2.5), False, id="through the shared edge"),
            pytest.param((0.5, 1.5), (1.5, 1.5), False, id="ends inside"),
            pytest.param((0.5, 0.5), (0.5, 0), True, id="ends on the rim"),
            pytest.param((0, 0), (6, 0), True, id="along the rim"),
            pytest.param((0.5, 0.5), (-0.5, 0.5), False, id="leaves"),
            pytest.param((-1, -1), (7, -1), False, id="stays outside"),
        ],
    )
    def test_contact_is_not_free(self, a: Any, b: Any, semi: bool) -> None:
        for start, end in ((a, b), (b, a)):
            assert not free(Point(), self.world, start, end)
            assert semi_free(Point(), self.world, start, end) is semi

    def test_a_blocked_cell_at_the_rim_leaves_no_way_between(self) -> None:
        """The outside is solid: no motion runs between it and a blocked cell."""
        world = Terrain([[0, 1, 0], [1, 1, 1], [0, 1, 0]])
        for a, b in (
            ((0, 0), (1, 0)),
            ((0, 0), (0, 1)),
            ((2, 3), (3, 3)),
            ((3, 2), (3, 3)),
            ((0, 0), (3, 0)),
            ((0, 3), (0, 0)),
        ):
            assert not semi_free(Point(), world, a, b)
        assert semi_free(Point(), world, (1, 0), (2, 0))
        assert semi_free(Point(), world, (0, 1), (0, 2))

    @pytest.mark.parametrize(
        ("q", "semi"),
        [
            pytest.param((0.5, 0.5), True, id="in the open"),
            pytest.param((1, 1.5), True, id="on an edge"),
            pytest.param((1, 1), True, id="at a corner"),
            pytest.param((3, 2), True, id="between two cells that meet at a corner"),
            pytest.param((0, 0.5), True, id="on the rim"),
            pytest.param((1.5, 1.5), False, id="inside"),
            pytest.param((2, 1.5), False, id="on an edge that two cells share"),
        ],
    )
    def test_standing_still(self, q: Any, semi: bool) -> None:
        """Interiors of cells and of their common edges are not semi-free; contacts are."""
        assert semi_free(Point(), self.world, q, q) is semi

    def test_a_disk_touches_at_its_radius(self) -> None:
        """Beside a cell, past a corner, at the rim; the same on a terrain of another scale."""
        for side, (x0, y0) in ((1.0, (0.0, 0.0)), (0.5, (2.0, -3.0))):
            world = Terrain(self.world.free, resolution=side, origin=(x0, y0))
            for a, b, radius in (
                ((0.5, 0.5), (5.5, 0.5), 0.5),  # the rim
                ((5.0, 1.0), (5.0, 3.0), 1.0),  # the rim and a cell
                ((4.5, 2.25), (4.5, 2.75), 0.5),  # a cell alone
                ((4.75, 2.5), (4.5, 2.5), 0.5),  # at the very end
            ):
                p, q = ((x0 + side * x, y0 + side * y) for x, y in (a, b))
                assert not free(Disk(radius * side), world, p, q)
                assert semi_free(Disk(radius * side), world, p, q)
                assert free(Disk(0.999 * radius * side), world, p, q)
                assert not semi_free(Disk(1.001 * radius * side), world, p, q)
                assert not free(
                    Disk(0.999 * radius * side), world, p, q, 0.001 * radius * side * 1.01
                )

    def test_a_disk_passes_a_corner_at_the_distance_of_the_corner(self) -> None:
        """3-4-5: the corner (4, 2) is at distance 1 from (4.6, 2.8), up to rounding."""
        assert (
            free(Disk(0.999999999), self.world, (4.6, 2.8), (4.6, 2.8)) is False
        )  # the rim of the cell (3, 2) is nearer
        lone = Terrain([[0, 1, 1], [1, 1, 1], [1, 1, 1]])
        assert free(Disk(1.0 - 1e-9), lone, (1.6, 1.8), (1.6, 1.8))
        assert not free(Disk(1.0 + 1e-9), lone, (1.6, 1.8), (1.6, 1.8))


@pytest.mark.parametrize(
    ("side", "origin"),
    [(1.0, (0.0, 0.0)), (0.3, (-3.7, 100.1)), (1e-6, (0.0, 0.0)), (7e5, (1e6, -1e6))],
)
def test_motions_on_terrains_agree_with_shapely(side: float, origin: Any) -> None:
    """Points and disks on random bitmaps of any scale.

    Cases within rounding of contact are left out.
    """
    rng = np.random.default_rng(3)
    margin = 1e-9 * side + 1e-14 * max(map(abs, origin))
    judged = {True: 0, False: 0}
    for _ in range(6):
        rows, columns = rng.integers(1, 14, 2).tolist()
        cells = rng.random((rows, columns)) < 0.8
        world = Terrain(cells, resolution=side, origin=origin)
        corners = np.array(origin) + side * np.argwhere(~cells)[:, ::-1]
        blocked = shapely.MultiPolygon([shapely.box(x, y, x + side, y + side) for x, y in corners])
        for _ in range(60):
            a = (
                rng.uniform(-0.2, 1.2, 2) * (columns, rows)
                if rng.random() < 0.2
                else rng.uniform(0, 1, 2) * (columns, rows)
            )
            b = (
                rng.uniform(0, 1, 2) * (columns, rows)
                if rng.random() < 0.4
                else a + rng.normal(0, 0.7, 2)
            )
            a, b = np.array(origin) + side * a, np.array(origin) + side * b
            line = shapely.LineString([a, b])
            rim = min((np.minimum(a, b) - world.lo).min(), (world.hi - np.maximum(a, b)).min())
            gap = min(line.distance(blocked) if not cells.all() else math.inf, rim)
            inside = (
                max(line.intersection(box).length for box in blocked.geoms)
                if not cells.all()
                else 0.0
            )
            for reach in (0.0, 0.2 * side, 1.3 * side):
                robot = Disk(reach) if reach else Point()
                answer = free(robot, world, a, b)
                assert free(robot, world, b, a) is answer
                if gap > reach + margin:
                    assert answer
                    assert semi_free(robot, world, a, b)
                elif gap < reach - margin or inside > margin:
                    assert not answer
                    if inside > 1e-3 * side or gap < reach - margin:
                        assert not semi_free(robot, world, a, b)
                judged[answer] += 1
    assert min(judged.values()) > 50


def test_a_terrain_of_one_blocked_column_stops_everything() -> None:
    """A blocked column blocks motions of every slope."""
    cells = np.ones((200, 300), bool)
    cells[:, 150] = False
    world = Terrain(cells)
    rng = np.random.default_rng(4)
    for _ in range(500):
        a, b = rng.uniform((0, 0), (150, 200)), rng.uniform((151, 0), (300, 200))
        assert not free(Point(), world, a, b)
        assert not semi_free(Point(), world, b, a)


@pytest.mark.parametrize(
    ("cells", "options", "error", "words"),
    [
        ([1, 0, 1], {}, InvalidWorld, "(rows, columns)"),
        ([], {}, InvalidWorld, "(rows, columns)"),
        ([[]], {}, InvalidWorld, "(rows, columns)"),
        ([[[1]]], {}, InvalidWorld, "(rows, columns)"),
        ([[0, 2]], {}, InvalidWorld, "true (free) or false"),
        ([[0.5, 1]], {}, InvalidWorld, "true (free) or false"),
        ([["a", "b"]], {}, InvalidWorld, "true (free) or false"),
        ([[1]], {"resolution": 0.0}, InvalidWorld, "resolution"),
        ([[1]], {"resolution": -1.0}, InvalidWorld, "resolution"),
        ([[1]], {"resolution": (1.0, 2.0)}, InvalidWorld, "resolution"),
        ([[1]], {"resolution": math.nan}, InvalidPoint, "resolution"),
        ([[1]], {"origin": (1.0,)}, InvalidPoint, "origin"),
        ([[1]], {"origin": (1.0, math.inf)}, InvalidPoint, "origin"),
        ([[1, 0], [1]], {}, InvalidWorld, "bitmap"),
    ],
)
def test_a_bad_terrain_is_refused_by_name(cells: Any, options: Any, error: Any, words: str) -> None:
    """The message says what is wrong with it."""
    with pytest.raises(error) as caught:
        Terrain(cells, **options)
    assert type(caught.value) is error
    assert words in str(caught.value)


# ---- what makes a world and a problem -----------------------------------------------------------

INNER = [(1, 1), (3, 1), (3, 3), (1, 3)]


@pytest.mark.parametrize(
    ("obstacle", "error"),
    [
        pytest.param(((1, 1), 0.0), InvalidWorld, id="radius 0"),
        pytest.param(((1, 1), -2.0), InvalidWorld, id="negative radius"),
        pytest.param(((1, 1), math.nan), InvalidPoint, id="radius nan"),
        pytest.param(((1, math.inf), 1.0), InvalidPoint, id="centre inf"),
        pytest.param(((1, 1, 1), 1.0), InvalidPoint, id="centre in space"),
        pytest.param([(0, 0), (1, 1)], InvalidPolygon, id="two vertices"),
        pytest.param([(0, 0), (2, 2), (2, 0), (0, 2)], InvalidPolygon, id="bow-tie"),
        pytest.param([(0, 0), (1, math.nan), (1, 1)], InvalidPoint, id="nan"),
        pytest.param(
            (INNER, [[(1.5, 1.5), (2, 2)], INNER]), InvalidPolygon, id="a room of two vertices"
        ),
        pytest.param(
            (INNER, [[(0, 0), (2, 2), (2, 0), (0, 2)]]), InvalidPolygon, id="a bow-tie of a room"
        ),
        pytest.param(
            (INNER, [[(2, 2), (5, 2), (5, 2.5)]]),
            InvalidPolygon,
            id="a room that leaves its obstacle",
        ),
        pytest.param((INNER, [[(5, 5), (6, 5), (6, 6)]]), InvalidPolygon, id="a room outside"),
        pytest.param(
            (INNER, [[(0, 0), (9, 0), (9, 9), (0, 9)]]),
            InvalidPolygon,
            id="a room round its obstacle",
        ),
        pytest.param((INNER, [INNER]), InvalidPolygon, id="a room as large as its obstacle"),
        pytest.param(
            (INNER, [[(1.2, 1.2), (2, 1.2), (2, 2)], [(1.5, 1.3), (2.5, 1.3), (2.5, 2.5)]]),
            InvalidPolygon,
            id="rooms that overlap",
        ),
    ],
)
def test_a_bad_obstacle_is_refused_by_its_number(obstacle: Any, error: Any) -> None:
    """The message gives the number of the obstacle."""
    good = [(10, 10), (12, 10), (12, 12)]
    with pytest.raises(error, match="obstacle 1") as caught:
        PolygonWorld(BOX, [good, obstacle])
    assert type(caught.value) in (error, InvalidWorld)


@pytest.mark.parametrize("make", [list, np.array])
def test_one_polygon_without_a_list_is_refused(make: Any) -> None:
    """Its first vertex is no round obstacle; the message says to put the polygon into a list."""
    square = [(0, 0), (9, 0), (9, 9), (0, 9)]
    alone = make([(1, 2), (3, 2), (2, 4)])
    for world in (PolygonWorld, lambda boundary, given: UncertainWorld(boundary, given, 0.1)):
        with pytest.raises(InvalidWorld, match=r"obstacle 0 .* two numbers; put .* a list"):
            world(square, alone)


def test_an_obstacle_may_have_no_rooms() -> None:
    """(polygon, []) is the polygon."""
    assert (
        PolygonWorld(BOX, [(INNER, [])]).edges.tolist() == PolygonWorld(BOX, [INNER]).edges.tolist()
    )


def test_a_room_may_touch_its_obstacle_at_a_point() -> None:
    """The room is free, and its point of contact with the outline is not."""
    outer, room = [(0, 0), (8, 0), (8, 8), (0, 8)], [(4, 0), (6, 4), (2, 4)]
    world = PolygonWorld(BOX, [(outer, [room])])
    assert free(Point(), world, (4, 1), (4, 3))
    assert not free(Point(), world, (4, 0), (4, 3))
    assert semi_free(Point(), world, (4, -2), (4, 3))
    assert not free(Point(), world, (4, 1), (4, 5))


@pytest.mark.parametrize("clockwise", [False, True])
def test_the_direction_of_rings_does_not_matter(clockwise: bool) -> None:
    """Boundary, obstacle and room may be clockwise or counter-clockwise; the world is the same."""
    turned = slice(None, None, -1 if clockwise else 1)
    room = [(1.5, 1.5), (2.5, 1.5), (2.0, 2.5)]
    world = PolygonWorld(BOX[turned], [(INNER[turned], [room[turned]])])
    assert free(Point(), world, (2.0, 1.6), (2.0, 2.2))
    assert not free(Point(), world, (2.0, 1.6), (2.0, 2.9))
    boundary, obstacle = rings_of(world)
    assert [shapely.LinearRing(ring).is_ccw for ring in (*boundary, *obstacle)] == [
        False,
        True,
        False,
    ]


@pytest.mark.parametrize("radius", [0, -1, (1, 2)])
def test_a_disk_needs_a_size(radius: Any) -> None:
    """InvalidRobot recommends Point()."""
    with pytest.raises(InvalidRobot, match=r"Point\(\)"):
        Disk(radius)


@pytest.mark.parametrize(
    ("start", "words"),
    [
        ((2, 2), "obstacle"),
        ((1, 2), "obstacle"),
        ((1, 1), "obstacle"),
        ((-24, 0), "inside the world"),
        ((99, 0), "inside the world"),
        ((24, 24), "inside the world"),
    ],
)
def test_start_and_goal_must_be_free(start: Any, words: str) -> None:
    """InvalidStart and InvalidGoal give the position and the reason."""
    world = PolygonWorld(BOX, [INNER])
    with pytest.raises(InvalidStart, match=words) as caught:
        Problem(Point(), world, start, (10, 10))
    assert f"({float(start[0])}, {float(start[1])})" in str(caught.value)
    with pytest.raises(InvalidGoal, match=words):
        Problem(Point(), world, (10, 10), start)


def test_start_must_keep_the_clearance() -> None:
    """The message mentions the clearance; the radius of a disk counts."""
    world = PolygonWorld(BOX, [INNER])
    Problem(Point(), world, (0.5, 2), (10, 10), clearance=0.4)
    with pytest.raises(InvalidStart, match=r"clearance of 0\.5"):
        Problem(Point(), world, (0.5, 2), (10, 10), clearance=0.5)
    with pytest.raises(InvalidGoal):
        Problem(Disk(0.3), world, (10, 10), (0.5, 2), clearance=0.2)
    Problem(Disk(0.3), world, (10, 10), (0.5, 2), clearance=0.1)


@pytest.mark.parametrize("bad", [(1,), (1, 2, 3), "ab", 5, (math.nan, 1)])
def test_a_start_of_the_wrong_shape_is_an_invalid_point(bad: Any) -> None:
    """For start and for goal."""
    for ends in ((bad, (10, 10)), ((10, 10), bad)):
        with pytest.raises(InvalidPoint):
            Problem(Point(), PolygonWorld(BOX), *ends)


def test_bad_clearance_and_bad_robot_are_invalid_parameters() -> None:
    """Negative or several clearances, and arguments that are not robots."""
    for clearance in (-0.1, (1, 2)):
        with pytest.raises(InvalidParameter, match="clearance"):
            Problem(Point(), PolygonWorld(BOX), (0, 0), (1, 1), clearance=clearance)
    with pytest.raises(InvalidParameter, match=r"Point\(\)"):
        Problem("robot", PolygonWorld(BOX), (0, 0), (1, 1))


def test_a_problem_asks_collision_with_its_clearance_and_counts() -> None:
    """The methods of a problem equal the collision functions, and a recorder logs their calls."""
    world = PolygonWorld(BOX, [INNER, ((10, -10), 3)])
    problem = Problem(Disk(0.5), world, (-10, 2), (10, 2), clearance=0.25)
    recorder = Recorder(problem)
    rng = np.random.default_rng(5)
    for _ in range(200):
        a, b = rng.uniform(-24, 24, (2, 2))
        assert recorder.is_free_path(a, b) == free(Disk(0.75), world, a, b)
        assert recorder.is_semi_free_path(a, b) == semi_free(Disk(0.75), world, a, b)
        assert recorder.is_free(a) == bool(is_free(Disk(0.75), world, a, 0.0))
    assert problem.query_counts.tolist() == [400, 200]
    assert recorder.counts() == {"is_free": 200, "is_free_path": 200, "is_semi_free_path": 200}

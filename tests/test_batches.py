"""Many collision queries at once: equal to the single queries, and exact on integer worlds."""

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.ndimage import distance_transform_cdt
from test_collision import BOX, ExactWorld, exact_worlds, whole
from test_geometry import SLOW_LAW, exact, place_exactly, shared_exactly

from kinoedu import Disk, Point, PolygonWorld, Terrain
from kinoedu.collision import coordinates, free_configurations, free_motions, is_free, is_free_path
from kinoedu.collision.batches import judge_motions
from kinoedu.errors import InvalidParameter, InvalidPoint, InvalidPolygon
from kinoedu.geometry import (
    ConvexPolygons,
    convex_hull,
    convex_pairs_intersect,
    convex_polygons_intersect,
)
from kinoedu.geometry.convex_pairs import as_convex_polygons, convex_orientation
from kinoedu.worlds.occupancy import (
    ALONG,
    FINE,
    FREE,
    MIXED,
    MOST,
    RIM,
    SOLID,
    no_occupancy,
    occupancy_at,
    occupancy_between,
)

TRIANGLE, SQUARE = [(0, 0), (2, 0), (0, 2)], [(1, 1), (2, 1), (2, 2), (1, 2)]
WORLD = PolygonWorld(
    BOX, [[(1, 1), (3, 1), (3, 3), (1, 3)], [(5, 5), (20, 5), (12, 20)], ((-8, -8), 3)]
)
UNKNOWN = WORLD._replace(occupancy=no_occupancy())  # the same without occupancy cells
NONE = np.empty((0, 2))


# ---- configurations and motions ----------------------------------------------------------------


@SLOW_LAW
@given(exact_worlds(), st.lists(st.tuples(whole, whole), min_size=1, max_size=20))
def test_batches_are_exact(world: ExactWorld, motions: Any) -> None:
    """Integer points and motions, on edges, through corners and along walls."""
    a, b = map(np.array, zip(*motions, strict=True))
    assert free_configurations(Point(), world.record, a).tolist() == [
        not world.is_solid(exact(p)) for p in a.tolist()
    ]
    assert free_motions(Point(), world.record, a, b).tolist() == [
        world.is_free(exact(p), exact(q)) for p, q in motions
    ]


@pytest.mark.parametrize(
    "world", [WORLD, Terrain(np.arange(100).reshape(10, 10) % 7 > 0)], ids=["polygons", "terrain"]
)
@pytest.mark.parametrize("robot", [Point(), Disk(0.7)], ids=["point", "disk"])
@pytest.mark.parametrize("clearance", [0.0, 0.25])
def test_batches_agree_with_single_queries(robot: Any, world: Any, clearance: float) -> None:
    """For every kind of world, robot and clearance, also outside the world."""
    rng = np.random.default_rng(1)
    a, b = rng.uniform(world.lo - 2, world.hi + 2, (2, 300, 2))
    ones = [bool(is_free(robot, world, q, clearance)) for q in a]
    assert free_configurations(robot, world, a, clearance=clearance).tolist() == ones
    assert free_motions(robot, world, a, a, clearance=clearance).tolist() == ones
    pairs = [bool(is_free_path(robot, world, p, q, clearance)) for p, q in zip(a, b, strict=True)]
    assert free_motions(robot, world, a, b, clearance=clearance).tolist() == pairs
    assert len(set(ones)) == 2


@pytest.mark.parametrize("size", [1e-300, 5e-324, 1e-120, 1.0, 1e120])
@pytest.mark.parametrize("shift", [0.0, 1e12])
def test_points_are_located_at_any_scale(size: float, shift: float) -> None:
    """Free in the middle, not on the boundary or outside, with and without occupancy cells."""
    x, far = shift * size, 24 * size
    world = PolygonWorld([(x - far, -far), (x + far, -far), (x + far, far), (x - far, far)])
    qs = [(x, 0), (x + far, 0), (x, -far), (x + 2 * far, 0), (-x - 2 * far, 0)]
    assert free_configurations(Point(), world, qs).tolist() == [True, False, False, False, False]
    assert (world.occupancy.reach.size > 0) == (size > 1e-290 and shift == 0.0)


def test_points_are_located_between_the_smallest_numbers() -> None:
    """The world is not divided if it is narrower, in floats, than the number of its obstacles."""
    u, places = 5e-324, range(1, 7)
    obstacles = [
        [(x * u, y * u), ((x + 1) * u, y * u), (x * u, (y + 1) * u)] for x in places for y in places
    ]
    halves = [[(9 * u - x, 9 * u - y) for x, y in triangle] for triangle in obstacles]
    world = PolygonWorld([(0, 0), (10 * u, 0), (10 * u, 10 * u), (0, 10 * u)], obstacles + halves)
    qs = [(u, u), (8 * u, 8 * u), (9 * u, 9 * u), (8 * u, u), (10 * u, u)]
    assert free_configurations(Point(), world, qs).tolist() == [False, False, True, True, False]


def test_occupancy_cells_are_right() -> None:
    """Many points of each kind of cell; most cells are entirely free or entirely blocked."""
    rng = np.random.default_rng(2)
    known = WORLD.occupancy
    assert known.reach.shape == (FINE * WORLD.cells.rows, FINE * WORLD.cells.columns)
    assert (known.reach == MIXED).mean() < 0.5
    assert {FREE, FREE + 1, MIXED, SOLID} <= set(known.reach.flat)
    for j, i in np.argwhere((known.reach >= FREE) | (known.reach == SOLID)).tolist():
        qs = (
            np.array([known.x, known.y])
            + (np.array([i, j]) + rng.uniform(0, 1, (5, 2))) * known.side
        )
        assert (free_motions(Point(), UNKNOWN, qs, qs[::-1]) == (known.reach[j, i] >= FREE)).all()


def test_the_reach_of_a_cell_is_its_distance_to_what_is_not_free() -> None:
    """Measured in moves of a chess king, up to a limit."""
    free = np.pad(WORLD.occupancy.reach >= FREE, 1)  # what lies outside is not free
    far = distance_transform_cdt(free, "chessboard")[1:-1, 1:-1]
    assert far.max() > MOST == WORLD.occupancy.reach.max()
    assert (np.maximum(WORLD.occupancy.reach, 0) == np.minimum(far, MOST)).all()


def test_a_box_has_no_doubtful_rim() -> None:
    """All cells of an empty box are free; at the rim of another hull some are not known."""
    assert (PolygonWorld(BOX).occupancy.reach >= FREE).all()
    cut = PolygonWorld([*BOX[:3], (-23, 24), (-24, 23)]).occupancy.reach
    assert set(cut[[0, -1]].flat) == {RIM}
    triangle = PolygonWorld(BOX[:3]).occupancy.reach
    assert {RIM, FREE} < set(triangle.flat)


@pytest.mark.parametrize("rows", [1, 3, 8])
def test_discs_at_the_rim_of_a_box_are_judged_exactly(rows: int) -> None:
    """Discs of whole and of other numbers of cells, which touch the rim, or almost."""
    side = 1 / 8
    world = PolygonWorld(
        [(0, 0), (1, 0), (1, rows / 8), (0, rows / 8)],
        [[(x / 64, 0.01), (x / 64 + 0.001, 0.01), (x / 64, 0.011)] for x in range(1, 17)],
    )
    unknown = world._replace(occupancy=no_occupancy())
    cell = world.occupancy.side
    assert FREE in world.occupancy.reach[[0, -1]] and FREE in world.occupancy.reach[:, [0, -1]]
    for radius in (0.5 * cell, cell, 1.99 * cell, 2 * cell, 3 * cell):
        disc = Disk(radius)
        for gap in (-1e-9, 0.0, 1e-9, cell / 128, cell / 2, cell):
            d = radius + gap
            along = np.linspace(0.3, 0.85, 40)
            top = np.column_stack([along, np.full(40, rows * side - d)])
            right = np.column_stack([np.full(40, 1.0 - d), along * rows * side])
            for qs in (top, right):
                free = free_configurations(disc, world, qs)
                assert free.tolist() == free_configurations(disc, unknown, qs).tolist()
                motions = free_motions(disc, world, qs, qs[::-1])
                assert motions.tolist() == free_motions(disc, unknown, qs, qs[::-1]).tolist()
                assert free.all() if gap > 0.0 else gap == 0.0 or not free.any()


@pytest.mark.parametrize("excess", [0.0, 1e-12, 1e-4, 0.005, 0.0099, 0.3])
@pytest.mark.parametrize("upright", [False, True])
def test_occupancy_cells_are_right_in_oblong_worlds(excess: float, upright: bool) -> None:
    """The shorter side is a little longer than a whole number of cells."""
    rng = np.random.default_rng(8)
    turned = slice(None, None, -1 if upright else 1)
    for cells in range(1, 8):
        height = (cells + excess) / 8
        # 16 parts make 8 cells per side
        boxes = [
            (0.055 * k, height - 0.001 * k, 0.055 * k + 0.05, height - 0.0003 * k)
            for k in range(1, 17)
        ]
        corners = [np.array([(a, b), (c, b), (c, d), (a, d)])[:, turned] for a, b, c, d in boxes]
        world = PolygonWorld(
            np.array([(0, 0), (1, 0), (1, height), (0, height)])[:, turned], corners
        )
        judged = world._replace(occupancy=no_occupancy())
        assert (world.occupancy.reach[[0, -1]] <= FREE).all()
        assert (world.occupancy.reach[:, [0, -1]] <= FREE).all()
        a = rng.uniform((0, height - 0.02), (1, height), (400, 2))[:, turned]
        b = np.clip(a + rng.uniform(-0.1, 0.1, a.shape), 0, 1)
        for robot in (Point(), Disk(0.0005), Disk(0.01), Disk(0.05)):
            lower = a - 0.7 * robot.radius
            assert (
                free_configurations(robot, world, lower)
                == free_configurations(robot, judged, lower)
            ).all()
            assert (
                free_motions(robot, world, lower, b) == free_motions(robot, judged, lower, b)
            ).all()


@pytest.mark.parametrize("size", [10.0, 1e6, 1e15])
def test_occupancy_cells_are_right_beside_obstacles_of_any_size(size: float) -> None:
    """A triangle and a disc that reach into the world from outside."""
    rng = np.random.default_rng(9)
    triangle = [(-size, 0.3 * size), (size, -0.3 * size), (size, size)]
    world = PolygonWorld(BOX, [triangle, ((-size, -size), math.sqrt(2.0) * size - 5.0)])
    a, b = rng.uniform(-12, 12, (2, 3000, 2))
    for robot in (Point(), Disk(0.3)):
        answers = free_motions(robot, world, a, a + 0.1 * b)
        judged = world._replace(occupancy=no_occupancy())
        assert answers.tolist() == free_motions(robot, judged, a, a + 0.1 * b).tolist()
        assert 0.0 < answers.mean() < 1.0


def test_a_disc_fills_the_reach_and_no_more() -> None:
    """At the corners of free cells, for discs of about their reach."""
    known, rng = WORLD.occupancy, np.random.default_rng(3)
    for j, i in rng.permutation(np.argwhere(known.reach >= FREE))[:400].tolist():
        corner = np.array(
            [
                [
                    known.x + (i + rng.integers(2)) * known.side,
                    known.y + (j + rng.integers(2)) * known.side,
                ]
            ]
        )
        for rim in (-1.0, -0.5, 0.0, 0.5, 1.0, 1.5):
            disc = (
                Disk((known.reach[j, i] + rim) * known.side)
                if known.reach[j, i] + rim > 0
                else Point()
            )
            assert free_configurations(disc, WORLD, corner) == free_configurations(
                disc, UNKNOWN, corner
            )
    inside = np.nextafter(3, 0)
    assert not free_configurations(
        Point(), PolygonWorld(BOX, [[(1, 1), (inside, 1), (inside, 3), (1, 3)]]), [(inside, 2)]
    )[0]


def test_occupancy_cells_decide_most_queries() -> None:
    """The cells decide most queries of points and short motions, and of discs in open space."""
    rng = np.random.default_rng(4)
    ends = [
        (*a, *np.clip(a + step, WORLD.lo, WORLD.hi))
        for a, step in zip(rng.uniform(-24, 24, (300, 2)), rng.uniform(-3, 3, (300, 2)))
    ]
    answers = [occupancy_between.py_func(*motion, 0.0, WORLD.occupancy) for motion in ends]
    assert {SOLID, FREE} < set(answers) and np.isin(answers, (SOLID, FREE)).mean() > 0.8
    assert (
        np.isin(
            [occupancy_at.py_func(*motion[:2], 0.0, WORLD.occupancy) for motion in ends],
            (SOLID, FREE),
        ).mean()
        > 0.9
    )
    assert (
        np.isin(
            [occupancy_at.py_func(*motion[:2], 1.0, WORLD.occupancy) for motion in ends],
            (SOLID, FREE),
        ).mean()
        > 0.6
    )


def test_a_world_of_many_parts_has_no_more_small_cells() -> None:
    """The more cells the index of a city has, the fewer occupancy cells each is divided into."""
    x, y = np.meshgrid(np.arange(-23.0, 23.0), np.arange(-23.0, 23.0))
    parts = [[(x, y), (x + 0.5, y), (x, y + 0.5)] for x, y in zip(x.flat, y.flat, strict=True)]
    world = PolygonWorld(BOX, parts)
    assert (
        ALONG / 2 < max(world.occupancy.reach.shape) <= ALONG
        and (world.occupancy.reach == SOLID).any()
    )


@pytest.mark.parametrize("robot", [Point(), Disk(0.05), Disk(1.7)])
def test_occupancy_cells_change_no_answer(robot: Any) -> None:
    """For random motions, and motions along the sides and through the corners of cells.

    Compiled and interpreted.
    """
    rng, known = np.random.default_rng(5), WORLD.occupancy
    corners = (
        np.array([known.x, known.y])
        + rng.integers(0, known.reach.shape[::-1], (4000, 2, 2)) * known.side
    )
    near = (
        corners + rng.choice([0.0, 0.0, 1e-15, -1e-15, 1e-9, 0.5, 2.0], corners.shape) * known.side
    )
    anywhere = rng.uniform(WORLD.lo, WORLD.hi, (4000, 2, 2))
    vertices = rng.choice(WORLD.edges[:, :2], (2000, 2))
    for ends in (
        near,
        anywhere,
        vertices,
        np.concatenate([anywhere[:2000, :1], vertices[:, 1:]], axis=1),
    ):
        a, b = ends[:, 0].copy(), ends[:, 1].copy()
        free = free_motions(robot, WORLD, a, b)
        assert (free == free_motions(robot, UNKNOWN, a, b)).all()
        assert (free_configurations(robot, WORLD, a) == free_motions(robot, UNKNOWN, a, a)).all()
        assert (free[:40] == judge_motions.py_func(robot, WORLD, a[:40], b[:40], 0.0)).all()


def test_a_users_own_robot_is_interpreted() -> None:
    """A class that is not a record registers its implementations and its number of coordinates."""

    class Bead:
        """A bead on a wire."""

    coordinates.register(Bead)(lambda robot: 1)
    is_free_path.register(Bead, type(WORLD))(
        lambda robot, world, a, b, clearance: max(a[0], b[0]) + clearance < 1
    )
    assert free_configurations(Bead(), WORLD, [[0.0], [2.0]], clearance=0.5).tolist() == [
        True,
        False,
    ]
    assert free_motions(Bead(), WORLD, [[0.0], [0.0]], [[0.5], [2.0]]).tolist() == [True, False]


@pytest.mark.parametrize(
    "laid",
    [np.asfortranarray, lambda q: np.repeat(q, 2, axis=0)[::2], lambda q: q.astype(">f8"), list],
    ids=["by columns", "every second row", "bytes reversed", "list"],
)
def test_batches_may_lie_in_memory_in_any_way(laid: Any) -> None:
    """What is given is only read: it may be write-protected."""
    qs = np.random.default_rng(5).uniform(-5, 20, (50, 2))
    given, ends = laid(qs), np.roll(qs, 1, axis=0)
    if isinstance(given, np.ndarray):
        given.flags.writeable = False
    free = free_configurations(Point(), WORLD, given)
    assert free.tolist() == [bool(is_free(Point(), WORLD, q, 0.0)) for q in qs]
    assert (
        free_motions(Point(), WORLD, given, ends) == free_motions(Point(), WORLD, qs, ends)
    ).all()
    assert np.array_equal(given, qs)


def test_empty_batches_have_empty_results() -> None:
    """Empty arrays and lists give empty results."""
    assert (
        free_configurations(Point(), WORLD, []).shape
        == free_configurations(Point(), WORLD, NONE).shape
        == (0,)
    )
    assert free_motions(Point(), WORLD, [], NONE).shape == (0,)
    assert convex_pairs_intersect(
        np.empty((0, 3, 2)), ConvexPolygons(np.empty((0, 4, 2)))
    ).shape == (0,)


@pytest.mark.parametrize(
    "bad",
    [
        (1, 2),
        [(1, 2, 3)],
        [[1]],
        [[(1, 2)]],
        [(1, math.nan)],
        [(1, math.inf)],
        [(1, 2), (3,)],
        "ab",
    ],
)
def test_bad_configurations_are_refused_by_name(bad: Any) -> None:
    """The message names the argument."""
    good = [(0, 0)]
    for name, ask in {
        "qs": lambda: free_configurations(Point(), WORLD, bad),
        "a": lambda: free_motions(Point(), WORLD, bad, good),
        "b": lambda: free_motions(Point(), WORLD, good, bad),
    }.items():
        with pytest.raises(InvalidPoint, match=rf"^{name} "):
            ask()


def test_bad_robots_clearances_and_lengths_are_refused_by_name() -> None:
    """Lists of different lengths are refused too."""
    with pytest.raises(InvalidParameter, match=r"Point\(\)"):
        free_configurations("robot", WORLD, NONE)
    for clearance in (-1.0, math.nan, (1, 2)):
        with pytest.raises((InvalidParameter, InvalidPoint), match="clearance"):
            free_motions(Point(), WORLD, NONE, NONE, clearance=clearance)
    with pytest.raises(InvalidPoint, match="equally many configurations, got 1 and 2"):
        free_motions(Point(), WORLD, [(0, 0)], [(0, 0), (1, 1)])


# ---- pairs of convex polygons ------------------------------------------------------------------


def meet_exactly(P: Any, Q: Any) -> bool:
    """Whether edges intersect, or a polygon contains a corner of the other; in fractions."""
    sides = [list(pairwise([*map(exact, ring), exact(ring[0])])) for ring in (P, Q)]
    return (
        any(shared_exactly(*e, *f) for e in sides[0] for f in sides[1])
        or place_exactly(exact(P[0]), Q) >= 0
        or place_exactly(exact(Q[0]), P) >= 0
    )


few = st.lists(st.tuples(st.integers(-4, 4), st.integers(-4, 4)), min_size=3, max_size=7)
hulls = (
    few.map(convex_hull)
    .filter(lambda hull: len(hull) > 2)
    .map(lambda hull: [tuple(map(int, p)) for p in hull])
)


@SLOW_LAW
@given(
    hulls,
    hulls,
    st.tuples(st.integers(-6, 6), st.integers(-6, 6)),
    st.integers(0, 9),
    st.booleans(),
)
def test_convex_pairs_are_exact(P: Any, Q: Any, shift: Any, first: int, reverse: bool) -> None:
    """On a small lattice: touching, shared edges, containment and coincidence."""
    Q = [(x + shift[0], y + shift[1]) for x, y in Q]
    turned = np.roll(Q, first, axis=0)[:: -1 if reverse else 1]
    truth = meet_exactly(P, Q)
    assert convex_pairs_intersect([P, P], [turned, turned]).tolist() == [truth, truth]
    assert convex_pairs_intersect([turned], [P]).tolist() == [truth]
    assert convex_pairs_intersect(ConvexPolygons([turned]), [P]).tolist() == [truth]
    assert convex_pairs_intersect(ConvexPolygons([P]), ConvexPolygons([turned])).tolist() == [truth]


def test_pairs_agree_with_single_queries() -> None:
    """Near and far, contained, and touching or almost touching at a corner."""
    cases = [
        (SQUARE, True),
        (np.add(SQUARE, 9), False),
        (np.multiply(SQUARE, 0.1), True),
        (np.add(SQUARE, [0, 2**-52]), False),
    ]
    Q = [np.asarray(square, float) for square, _ in cases]
    Q[3][0] = (1, 1 + 2**-52)
    assert convex_pairs_intersect([TRIANGLE] * 4, Q).tolist() == [truth for _, truth in cases]
    assert [convex_polygons_intersect(TRIANGLE, q) for q in Q] == [truth for _, truth in cases]


@SLOW_LAW
@given(st.lists(st.tuples(st.integers(0, 3), st.integers(0, 3)), min_size=3, max_size=7))
def test_rings_are_refused_with_the_messages_of_single_polygons(ring: Any) -> None:
    """The same rings are refused, with the same messages as for single polygons."""
    try:
        convex_polygons_intersect(ring, ring)
        refused = ""
    except InvalidPolygon as error:
        refused = "P[1]" + str(error).removeprefix("P")
    good = (
        [(math.cos(k), math.sin(k)) for k in range(len(ring))]
        if len(ring) < 7
        else [(k, k * k) for k in range(7)]
    )
    assert (convex_orientation(np.array(ring, float)) == 0) == bool(refused)
    if refused:
        with pytest.raises(InvalidPolygon) as caught:
            convex_pairs_intersect([good, ring], [good, ring])
        assert str(caught.value) == refused
    else:
        assert convex_pairs_intersect([ring], [ring]).tolist() == [True]


def test_polygons_are_checked_once() -> None:
    """The checked polygons are a counter-clockwise copy, and are not checked again."""
    mine = np.array([TRIANGLE, TRIANGLE[::-1]], float)
    checked = ConvexPolygons(mine)
    mine[:] = np.nan
    assert as_convex_polygons(checked, "P") is checked
    assert [convex_orientation(ring) for ring in checked.rings] == [1, 1]
    assert {(*box,) for box in checked.boxes.tolist()} == {
        (*np.min(TRIANGLE, axis=0), *np.max(TRIANGLE, axis=0))
    }
    with pytest.raises(InvalidPolygon, match=r"^P\[1\] "):
        ConvexPolygons([SQUARE, [(0, 0), (1, 1), (1, 0), (0, 1)]])
    with pytest.raises(InvalidPolygon, match="equally many polygons, got 2 and 1"):
        convex_pairs_intersect(checked, [SQUARE])


def test_a_pentagram_is_not_a_convex_polygon() -> None:
    """It turns left at every corner, but winds around twice."""
    star = [(math.cos(0.8 * math.pi * k), math.sin(0.8 * math.pi * k)) for k in range(5)]
    with pytest.raises(InvalidPolygon, match=r"^Q\[1\] crosses"):
        convex_pairs_intersect([TRIANGLE] * 2, [np.array(star)[[0, 2, 4, 1, 3]], star])


def test_bad_pairs_are_refused_by_name() -> None:
    """Wrong shapes, values that are not numbers, different counts."""
    for bad in (TRIANGLE, [], [TRIANGLE[:2]], np.zeros((1, 3, 3))):
        with pytest.raises(InvalidPolygon, match=r"^P must be polygons of shape \(m, n, 2\)"):
            convex_pairs_intersect(bad, [SQUARE])
    with pytest.raises(InvalidPoint, match=r"^Q must be finite"):
        convex_pairs_intersect([TRIANGLE], [[(0, 0), (1, 0), (math.nan, 1)]])
    with pytest.raises(InvalidPoint, match="regular array"):
        convex_pairs_intersect([TRIANGLE, SQUARE], [SQUARE, SQUARE])
    with pytest.raises(InvalidPolygon, match="equally many polygons, got 1 and 2"):
        convex_pairs_intersect([TRIANGLE], [SQUARE, SQUARE])

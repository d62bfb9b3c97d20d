"""Motions of robots that rotate, bend or slide, against shapely at fine steps and fractions."""

from typing import Any

import numpy as np
import pytest
import shapely

from kinoedu import (
    Plan,
    PolygonWorld,
    Problem,
    RigidPolygon,
    Terrain,
    TranslatingPolygon,
    TwoLinkArm,
    prm,
    rrt,
)
from kinoedu.c_space import turned
from kinoedu.collision import is_free_path, is_semi_free_path
from kinoedu.compiled import compiled
from kinoedu.errors import InvalidPoint
from kinoedu.geometry.separation import dividing_line, insides_meet, pieces_distance, pieces_meet
from kinoedu.robots import place_body
from kinoedu.spaces import distance, interpolate

L_SHAPE = [(-1, -0.3), (1, -0.3), (1, 0.3), (-0.6, 0.3), (-0.6, 1.2), (-1, 1.2)]
NEEDLE = [(-1.5, -0.01), (1.5, -0.01), (1.5, 0.01), (-1.5, 0.01)]
THIN = [(5, 0.5), (5.0000001, 0.5), (5.0000001, 3.5), (5, 3.5)]
AMONG = PolygonWorld(
    [(0, 0), (10, 0), (10, 10), (5, 9), (0, 10)],
    [
        THIN,
        [(1, 4), (2, 3.6), (2.4, 4.9), (1.4, 5.2)],
        [(6, 6), (8, 6), (7, 7.5)],
        ((2.5, 7.5), 0.6),
        ((8, 2), 0.4),
    ],
)
CELLS = Terrain(np.random.default_rng(2).random((20, 20)) > 0.06, resolution=0.5)
ROBOTS = [
    RigidPolygon(L_SHAPE),
    RigidPolygon(NEEDLE),
    TwoLinkArm(2.4, 2.0, 0.12, base=(4.3, 4.9)),
    TranslatingPolygon(L_SHAPE),
]
NAMES = ["turning", "needle", "arm", "sliding"]


def scenery(world: Any) -> tuple[Any, Any, Any]:
    """The polygonal solids, the discs, and the interior of the boundary, as shapely geometries."""
    if isinstance(world, type(CELLS)):
        boxes = [
            shapely.box(i / 2, j / 2, i / 2 + 0.5, j / 2 + 0.5) for j, i in np.argwhere(~world.free)
        ]
        return shapely.union_all(boxes), [], shapely.box(*world.lo, *world.hi)
    from kinoedu.worlds.polygon_world import discs_of, rings_of

    (outline,), *solids = rings_of(world)
    return (
        shapely.union_all([shapely.Polygon(rings[0]) for rings in solids]),
        discs_of(world),
        shapely.Polygon(outline),
    )


def gaps(robot: Any, scene: Any, qs: Any) -> Any:
    """The clearance of the robot at each q; zero or less in contact. numpy places its body."""
    solid, discs, room = scene
    if hasattr(robot, "lengths"):
        angles = np.cumsum(qs, axis=1)
        steps = robot.lengths[:, None] * np.stack([np.cos(angles), np.sin(angles)], -1)
        bodies = shapely.linestrings(
            np.concatenate([np.zeros((len(qs), 1, 2)), np.cumsum(steps, axis=1)], axis=1)
            + robot.base
        )
        radius = robot.shape.radius[0]
    else:
        theta = qs[:, 2:3] if qs.shape[1] == 3 else np.zeros((len(qs), 1))
        (x, y), cos, sin = robot.outline.T, np.cos(theta), np.sin(theta)
        bodies = shapely.polygons(
            np.stack([cos * x - sin * y + qs[:, :1], sin * x + cos * y + qs[:, 1:2]], -1)
        )
        radius = 0.0
    apart = shapely.distance(bodies, solid)
    for x, y, r in discs:
        apart = np.minimum(apart, shapely.distance(bodies, shapely.Point(x, y)) - r)
    inside = shapely.contains_properly(room, bodies)
    return (
        np.minimum(apart, np.where(inside, shapely.distance(bodies, room.exterior), -1.0)) - radius
    )


def least_gap(robot: Any, scene: Any, a: Any, b: Any) -> float:
    """The least clearance on the motion from a to b, by ever finer steps near the minimum."""
    angles = np.arange(len(a)) >= (0 if hasattr(robot, "lengths") else 2)
    change = np.where(angles, (b - a + np.pi) % (2 * np.pi) - np.pi, b - a)
    t, h = np.linspace(0, 1, 201), 1 / 200
    found = gaps(robot, scene, a + t[:, None] * change)
    least = found.min()
    for _ in range(6):
        if least <= 0:
            break
        t = np.clip(
            np.concatenate([t[k] + np.linspace(-h, h, 41) for k in np.argsort(found)[:6]]), 0, 1
        )
        found, h = gaps(robot, scene, a + t[:, None] * change), h / 20
        least = min(least, found.min())
    return float(least)


@compiled
def judged(robot: Any, world: Any, a: Any, b: Any) -> Any:
    """`is_free_path` of many motions."""
    free = np.empty(len(a), np.bool_)
    for i in range(len(a)):
        free[i] = is_free_path(robot, world, a[i], b[i], 0.0)
    return free


@pytest.mark.parametrize("world", [AMONG, CELLS], ids=["polygons", "terrain"])
@pytest.mark.parametrize("robot", ROBOTS, ids=NAMES)
def test_no_false_free_and_no_false_hit(robot: Any, world: Any) -> None:
    """120 motions from free configurations, many of them across a wall of width 1e-7.

    A few are also interpreted. Deterministic.
    """
    scene, rng = scenery(world), np.random.default_rng(7)
    angles = np.arange(
        len(robot.lengths) if hasattr(robot, "lengths") else 2 + hasattr(robot, "turn_weight")
    ) >= (0 if hasattr(robot, "lengths") else 2)
    places = rng.uniform(
        np.where(angles, -np.pi, 0.3), np.where(angles, np.pi, 9.7), (3000, len(angles))
    )
    places = places[gaps(robot, scene, places) > 0]
    a = places[rng.integers(len(places), size=120)]
    b = a + rng.normal(0, 0.7, a.shape)
    b[::3] = places[rng.integers(len(places), size=40)]
    b[:, angles] = (b[:, angles] + np.pi) % (2 * np.pi) - np.pi
    free = judged(robot, world, a, b)
    assert 10 < free.sum() < 110
    for i in range(len(a)):
        gap = least_gap(robot, scene, a[i], b[i])
        assert (i, gap > 0 or not free[i]) == (i, True)
        assert (i, gap < 1e-7 or bool(free[i])) == (i, True)
    for i in range(0, 120, 12):
        assert bool(is_free_path(robot, world, a[i], b[i], 0.0)) is bool(free[i])


def test_needle_does_not_jump_a_wall() -> None:
    """A needle rotates by half a turn across a wall thinner than any step; both ends are free.

    Without the wall the motion is free.
    """
    wall = [(3, 1), (3 + 1e-12, 1), (3 + 1e-12, 1.4), (3, 1.4)]
    box = [(-5, -5), (5, -5), (5, 5), (-5, 5)]
    robot = RigidPolygon([(2.9, -0.01), (3.2, -0.01), (3.2, 0.01), (2.9, 0.01)])
    a, b = np.array([0.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0])
    assert is_free_path(robot, PolygonWorld(box), a, b, 0.0)
    assert not is_free_path(robot, PolygonWorld(box, [wall]), a, b, 0.0)
    assert not is_free_path(robot, PolygonWorld(box, [wall]), b, a, 0.0)


def test_motions_go_the_short_way_round() -> None:
    """From 3 to -3 radians an arm passes through pi and not through 0."""
    box = [(-5, -5), (5, -5), (5, 5), (-5, 5)]
    a, b = np.array([3.0, 0.0]), np.array([-3.0, 0.0])
    for x, free in ((1.0, True), (-1.0, False)):
        assert (
            bool(
                is_free_path(TwoLinkArm(1, 1, 0.1), PolygonWorld(box, [((x, 0), 0.05)]), a, b, 0.0)
            )
            is free
        )


class TestContact:
    """Motions in contact are semi-free, not free; motions into an obstacle are neither."""

    world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [[(4, 0), (6, 0), (6, 4), (4, 4)]])
    square = ((-1, -1), (1, -1), (1, 1), (-1, 1))

    @pytest.mark.parametrize(
        "robot", [TranslatingPolygon(square), RigidPolygon(square)], ids=["sliding", "turning"]
    )
    @pytest.mark.parametrize(
        ("a", "b", "free", "semi"),
        [
            ((2, 7), (8, 7), True, True),
            ((2, 5), (8, 5), False, True),
            ((2, 4.9), (8, 4.9), False, False),
            ((1, 7), (2, 7), False, True),
            ((0.9, 7), (2, 7), False, False),
            ((3, 1), (3, 8), False, True),
            ((2, 1.5), (8, 1.5), False, False),
        ],
    )
    def test_squares(self, robot: Any, a: Any, b: Any, free: bool, semi: bool) -> None:
        """A square along a block and along the rim, there and back."""
        turn = (0.0,) * (hasattr(robot, "turn_weight"))
        p, q = np.array([*a, *turn], float), np.array([*b, *turn], float)
        for start, end in ((p, q), (q, p)):
            assert bool(is_free_path(robot, self.world, start, end, 0.0)) is free
            assert bool(is_semi_free_path(robot, self.world, start, end, 0.0)) is semi


def test_pieces_against_shapely() -> None:
    """Contact, distance and separating line of points, segments and polygons on a small lattice."""
    rng = np.random.default_rng(4)
    for _ in range(1500):
        P, Q = (
            shapely.MultiPoint(rng.integers(0, 7, (rng.integers(1, 6), 2)) + at).convex_hull
            for at in (0, rng.integers(0, 4))
        )
        p, q = (corners(piece) for piece in (P, Q))
        assert bool(pieces_meet(p, 0, len(p), q, 0, len(q))) is bool(P.intersects(Q))
        apart = pieces_distance(p, 0, len(p), q, 0, len(q))
        assert apart == pytest.approx(P.distance(Q), rel=1e-12, abs=1e-15)
        x, y, nx, ny = dividing_line(p, 0, len(p), q, 0, len(q))
        assert ((q - [x, y]) @ [nx, ny]).max() < 1e-12
        if apart > 0:
            assert ((p - [x, y]) @ [nx, ny]).min() == pytest.approx(apart, rel=1e-9)
        if len(p) > 2 and len(q) > 2:
            assert bool(insides_meet(p, 0, len(p), q, 0, len(q))) is bool(
                P.intersection(Q).area > 0
            )


def corners(shape: Any) -> Any:
    """The corners of a convex shape, counter-clockwise."""
    if shape.geom_type == "Polygon":
        return np.array(shapely.geometry.polygon.orient(shape).exterior.coords)[:-1]
    return np.array(shape.coords)


def path_is_free(plan: Plan) -> bool:
    """Whether a path touches nothing at 100 configurations of each of its motions, by shapely."""
    problem, scene = plan.problem, scenery(plan.problem.world)
    assert plan.path is not None
    places = [
        interpolate(problem.space, a, b, t)
        for a, b in zip(plan.path, plan.path[1:])
        for t in np.linspace(0, 1, 100)
    ]
    return bool((gaps(problem.robot, scene, np.array(places)) > 0).all())


@pytest.mark.parametrize("world", [AMONG, CELLS], ids=["polygons", "terrain"])
@pytest.mark.parametrize(
    "robot",
    [
        RigidPolygon(np.array(L_SHAPE) / 3),
        TranslatingPolygon(np.array(L_SHAPE) / 3),
        TwoLinkArm(1.2, 1.0, 0.1, base=(4.3, 5.2)),
    ],
    ids=["turning", "sliding", "arm"],
)
def test_planners_plan(robot: Any, world: Any) -> None:
    """RRT and PRM find paths that are free by shapely; the cost is the sum of distances."""
    rng = np.random.default_rng(3)
    lo, hi = (
        (np.full(2, -np.pi), np.full(2, np.pi))
        if hasattr(robot, "lengths")
        else (np.full(2, 0.5), np.full(2, 9.5))
    )
    qs = rng.uniform(lo, hi, (400, 2))
    if hasattr(robot, "turn_weight"):
        qs = np.hstack([qs, rng.uniform(-np.pi, np.pi, (400, 1))])
    qs = qs[gaps(robot, scenery(world), qs) > 0.05]
    problem = Problem(robot, world, qs[0], qs[1])
    for plan in (rrt(problem, rng=0), prm(problem, n=150, rng=0)):
        assert plan.path is not None
        assert (plan.path[0] == problem.start).all() and (plan.path[-1] == problem.goal).all()
        assert path_is_free(plan)
        assert plan.cost == pytest.approx(
            sum(distance(problem.space, a, b) for a, b in zip(plan.path, plan.path[1:]))
        )


def test_placed_turns_about_the_reference_point() -> None:
    """A quarter turn of a polygon about a point outside it."""
    body = place_body(RigidPolygon([(1, 0), (2, 0), (2, 1)]), np.array([5.0, 5.0, np.pi / 2]))
    np.testing.assert_allclose(
        body.points[np.lexsort(body.points.T)], [(5, 6), (4, 7), (5, 7)], atol=1e-15
    )


def test_a_motion_too_fast_to_be_judged_is_not_free() -> None:
    """Where even the least time is too long; the judge must come to an end."""
    room = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [[(4, 4), (5, 4), (5, 5), (4, 5)]])
    body = RigidPolygon([(0, 0), (1, 0), (1, 1)])
    near, far = np.array([2.0, 2.0, 0.0]), np.array([-1e308, 2.0, 0.0])
    with np.errstate(all="ignore"):
        assert not is_free_path(body, room, near, far, 0.0)


@pytest.mark.parametrize("theta", [np.nan, [0.5], None, "a"])
def test_an_angle_is_one_finite_number(theta: Any) -> None:
    with pytest.raises(InvalidPoint, match="theta"):
        turned([(0, 0), (1, 0), (1, 1)], theta)

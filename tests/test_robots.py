"""Robots that rotate or bend: their configurations, their clearance, and the link in contact."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely

from kinoedu import (
    PolygonWorld,
    Problem,
    RigidPolygon,
    Terrain,
    TranslatingPolygon,
    TwoLinkArm,
    link_in_contact,
)
from kinoedu.collision import clearance_of, is_free, paint_configuration_space
from kinoedu.collision.arms import paint_image
from kinoedu.collision.turning import contact_size
from kinoedu.errors import (
    InvalidParameter,
    InvalidPoint,
    InvalidPolygon,
    InvalidRobot,
    InvalidStart,
)
from kinoedu.files.scenes import read_scene, write_scene
from kinoedu.robots import ArmChain, Disk, place_body, why_unreachable
from kinoedu.robots.arm import RIM

CASES = json.loads(
    (Path(__file__).parent / "data" / "arm" / "cases.json").read_text(encoding="utf-8")
)["cases"]
WIDE = [(-50, -50), (50, -50), (50, 50), (-50, 50)]
L_SHAPE = [(-1, -0.3), (1, -0.3), (1, 0.3), (-0.6, 0.3), (-0.6, 1.0), (-1, 1.0)]
ROOM = PolygonWorld(
    [(-4, -4), (4, -4), (4, 4), (-4, 4)],
    [
        [(1.2, 1.4), (2.6, 1.2), (2.2, 2.4)],
        [(-2.4, 0.4), (-1.2, 0.6), (-1.4, 1.8)],
        ((0.4, 2.2), 0.4),
        ((0.2, -1.4), 0.3),
    ],
)
CELLS = Terrain(np.random.default_rng(3).random((16, 16)) > 0.08, resolution=0.5, origin=(-4, -4))


def cases(kind: str) -> list[Any]:
    return [pytest.param(case, id=case["id"]) for case in CASES if case["kind"] == kind]


def same_angles(q: Any, p: Any) -> bool:
    return bool(np.abs((np.subtract(q, p) + np.pi) % (2 * np.pi) - np.pi).max() < 1e-9)


class TestArm:
    """Forward and inverse kinematics."""

    @pytest.mark.parametrize("case", cases("fk"))
    def test_joints(self, case: Any) -> None:
        """Elbow and tip are accurate to 1e-12."""
        elbow, tip = TwoLinkArm(case["L1"], case["L2"], 0).joints((case["t1"], case["t2"]))
        np.testing.assert_allclose(
            [elbow, tip], [case["expected"]["elbow"], case["expected"]["tip"]], atol=1e-12
        )

    @pytest.mark.parametrize("case", cases("ik"))
    def test_inverse(self, case: Any) -> None:
        """All solutions are found, up to full turns; without one `why_unreachable` is not empty.

        Their angles lie in [-pi, pi).
        """
        arm = TwoLinkArm(case["L1"], case["L2"], 0)
        found, expected = arm.inverse(case["p"]), case["expected"]["solutions"]
        assert all(any(same_angles(q, p) for p in expected) for q in found)
        assert all(any(same_angles(q, p) for q in found) for p in expected)
        assert all(((q >= -np.pi) & (q < np.pi)).all() for q in found)
        assert bool(why_unreachable(arm, case["p"])) is (not found)

    def test_inverse_undoes_joints(self) -> None:
        """A reachable tip has two solutions, one of them the original configuration.

        Near the rims too.
        """
        rng = np.random.default_rng(0)
        for _ in range(300):
            arm = TwoLinkArm(*rng.uniform(0.1, 3.0, 2), 0, base=rng.uniform(-5, 5, 2))
            q = rng.uniform(-np.pi, np.pi, 2) * rng.choice([1.0, 1e-2], 2)
            q[1] += np.copysign(1e-4, q[1])  # nearer than 1e-12 to a rim is on it
            tip = arm.joints(q)[-1]
            found = arm.inverse(tip)
            assert len(found) == 2
            for solution in found:
                np.testing.assert_allclose(arm.joints(solution)[-1], tip, atol=1e-12)
            assert min(np.abs((s - q + np.pi) % (2 * np.pi) - np.pi).max() for s in found) < 1e-6

    def test_rims(self) -> None:
        """One solution for a stretched or folded arm; an error at the base of equal links."""
        assert [q.tolist() for q in TwoLinkArm(2, 1, 0).inverse((-3, 0))] == [[-np.pi, 0.0]]
        assert [q.tolist() for q in TwoLinkArm(1, 2, 0).inverse((1, 0))] == [[-np.pi, -np.pi]]
        assert TwoLinkArm(2, 1, 0).inverse((0, 0)) == []
        assert "folded" in why_unreachable(TwoLinkArm(2, 1, 0), (0, 0))
        with pytest.raises(InvalidPoint, match="infinitely many"):
            TwoLinkArm(1, 1, 0).inverse((0, 0))
        assert len(TwoLinkArm(1, 1, 0).inverse((1e-12, 0))) == 2

    @pytest.mark.parametrize("equal", [False, True])
    def test_there_is_a_reason_exactly_where_there_is_no_solution(self, equal: bool) -> None:
        """A few floats to either side of where the rims of the reachable ring end."""
        rng = np.random.default_rng(0)
        for _ in range(100):
            l1, l2 = rng.uniform(0.1, 3.0, 2)
            arm = TwoLinkArm(l1, l1 if equal else l2, 0)
            (l1, l2), steps = arm.lengths, np.arange(-3.0, 4.0)
            ends = np.array([l1 + l2, abs(l1 - l2)])[:, None] + np.array([-RIM, RIM]) * (l1 + l2)
            for x in (ends[..., None] + steps * np.spacing(np.abs(ends))[..., None]).ravel():
                assert bool(why_unreachable(arm, (x, 0))) is not bool(arm.inverse((x, 0)))

    def test_the_reason_has_numbers_that_differ(self) -> None:
        """Six digits where they are enough, and more for a tip that nearly reaches."""
        arm = TwoLinkArm(2, 1, 0)
        assert why_unreachable(arm, (10 / 3, 0)).startswith("it is 3.33333 from the base")
        reason = why_unreachable(arm, (3.0000001, 0))
        assert reason == "it is 3.0000001 from the base, and the links together reach only 3"
        assert why_unreachable(arm, (0.9999999, 0)).startswith("it is 0.9999999 from the base")

    @pytest.mark.parametrize("other", [Disk(1), [1.0, 1.0], None])
    def test_reach_of_no_arm(self, other: Any) -> None:
        """Another robot, or only the lengths, are refused with an arm as the example."""
        with pytest.raises(InvalidRobot, match=r"such as TwoLinkArm\(1.5, 1.2, 0.2\), got"):
            why_unreachable(other, (1, 1))

    @pytest.mark.parametrize("case", cases("clear"))
    def test_clearance(self, case: Any) -> None:
        """The distance to 1e-12, and contact exactly where it is 0."""
        world = PolygonWorld(WIDE, case["polys"] + [((x, y), r) for x, y, r in case["discs"]])
        arm, q = TwoLinkArm(case["L1"], case["L2"], 0), (case["t1"], case["t2"])
        assert clearance_of(arm, world, q) == pytest.approx(
            case["expected"]["distance"], rel=1e-12, abs=1e-15
        )
        assert (link_in_contact(arm, q, world) > 0) is case["expected"]["collides"]

    @pytest.mark.parametrize("case", cases("link1_blocked"))
    def test_range_of_link_1(self, case: Any) -> None:
        """Link 1 hits the disc within the half range and not beyond it."""
        x, y, r = case["disc"]
        world, arm = PolygonWorld(WIDE, [((x, y), r)]), TwoLinkArm(case["L1"], 0.01, 0)
        half = case["expected"]["half_range"]
        assert link_in_contact(arm, (half + 1e-3, np.pi), world) == 0
        assert link_in_contact(arm, (max(half - 1e-6, 0.0), np.pi), world) == 1

    @pytest.mark.parametrize("case", cases("grid"))
    def test_grid(self, case: Any) -> None:
        """As many colliding configurations as the case counts, at multiples of 2 pi / n."""
        world = PolygonWorld(WIDE, [((x, y), r) for x, y, r in case["discs"]])
        arm, angles = (
            TwoLinkArm(case["L1"], case["L2"], 0),
            np.arange(case["n"]) * 2 * np.pi / case["n"],
        )
        hits = [link_in_contact(arm, (t1, t2), world) > 0 for t1 in angles for t2 in angles]
        assert sum(hits) == case["expected"]["colliding"]


def solids(world: Any) -> tuple[Any, Any]:
    """The obstacles and the free interior of the boundary, as shapely geometries."""
    if world is CELLS:
        boxes = [
            shapely.box(i / 2 - 4, j / 2 - 4, i / 2 - 3.5, j / 2 - 3.5)
            for j, i in np.argwhere(~world.free)
        ]
        return shapely.union_all(boxes), shapely.box(-4, -4, 4, 4)
    from kinoedu.worlds.polygon_world import discs_of, rings_of

    (outline,), *rest = rings_of(world)
    discs = [shapely.Point(x, y).buffer(r, quad_segs=4000) for x, y, r in discs_of(world)]
    return shapely.union_all([shapely.Polygon(ring[0]) for ring in rest] + discs), shapely.Polygon(
        outline
    )


@pytest.mark.parametrize("world", [ROOM, CELLS], ids=["polygons", "terrain"])
@pytest.mark.parametrize(
    "robot",
    [
        Disk(0.3),
        TranslatingPolygon(L_SHAPE),
        RigidPolygon(L_SHAPE),
        TwoLinkArm(1.5, 1.2, 0.2),
        ArmChain([1, 0.8, 0.6], 0),
    ],
)
def test_clearance_is_shapelys(robot: Any, world: Any) -> None:
    """The clearance of every robot in both kinds of world is the distance that shapely computes."""
    solid, room = solids(world)
    rng = np.random.default_rng(1)
    for _ in range(60):
        d = (
            len(robot.lengths)
            if hasattr(robot, "lengths")
            else 3
            if isinstance(robot, type(RigidPolygon(L_SHAPE)))
            else 2
        )
        q = rng.uniform(-3.5, 3.5, d)
        body = place_body(robot, q)
        pieces = [body.points[a:b] for a, b in zip(body.first, body.first[1:])]
        shapes = [
            shapely.Point(p[0]) if len(p) == 1 else shapely.MultiPoint(p).convex_hull
            for p in pieces
        ]
        gap = min(
            min(
                shapely.distance(s, solid),
                shapely.distance(s, room.exterior) if room.contains(s) else 0.0,
            )
            - r
            for s, r in zip(shapes, body.radius)
        )
        assert clearance_of(robot, world, q) == pytest.approx(max(gap, 0.0), abs=2e-7)
        if abs(gap) > 1e-6:
            assert bool(is_free(robot, world, q, 0.0)) is bool(gap > 0)
        if gap > 1e-6:
            assert is_free(robot, world, q, gap - 1e-6)
            assert not is_free(robot, world, q, gap + 1e-6)


@pytest.mark.parametrize("world", [ROOM, CELLS], ids=["polygons", "terrain"])
def test_painter_is_link_in_contact(world: Any) -> None:
    """The image equals `link_in_contact` in each cell, compiled and interpreted.

    For a wide arm and for an arm without width; few cells and an odd number of cells.
    """
    if world is CELLS:
        world = CELLS._replace(free=CELLS.free.copy())
        world.free[7:9, 7:9] = True
    for arm in (TwoLinkArm(1.5, 1.2, 0.2), TwoLinkArm(0.9, 3.2, 0.0, base=(0.1, 0.2))):
        for n in (1, 2, 3, 5, 40):
            angles = -np.pi + (np.arange(n) + 0.5) * 2 * np.pi / n
            image = paint_configuration_space(arm, world, n)
            assert image.dtype == np.int8
            assert image.tolist() == [
                [link_in_contact(arm, (t1, t2), world) for t1 in angles] for t2 in angles
            ]
    by_hand = paint_image.py_func(arm, world, 5, contact_size(world.lo, world.hi))
    assert (by_hand == paint_configuration_space(arm, world, 5)).all()


@pytest.mark.parametrize("seed", range(40))
def test_painter_is_link_in_contact_for_any_base(seed: int) -> None:
    """Also where the base is in contact or outside the world, and at walls that are not upright."""
    rng = np.random.default_rng(seed)
    wide, base = rng.uniform(0.8, 4.0), rng.uniform(-2, 2, 2)
    at = base if seed % 4 == 0 else rng.uniform(-3, 3, 2)
    obstacles: list[Any] = [(at, rng.uniform(0.1, 0.8))]
    at = base if seed % 4 == 1 else rng.uniform(-3, 3, 2)
    for centre in [at, *rng.uniform(-3, 3, (rng.integers(0, 3), 2))]:
        turns = rng.uniform(0, 2 * np.pi) + np.array([0.0, 2.0, 4.0])
        size = rng.uniform(0.2, 1.2, (3, 1))
        obstacles.append(centre + size * np.column_stack([np.cos(turns), np.sin(turns)]))
    world = PolygonWorld([(-wide, -wide), (wide, -0.7 * wide), (0.2 * wide, wide)], obstacles)
    arm = TwoLinkArm(*rng.uniform(0.2, 2, 2), rng.choice([0.0, 0.05, 0.3]), base=base)
    n = int(rng.integers(1, 30))
    angles = -np.pi + (np.arange(n) + 0.5) * 2 * np.pi / n
    assert paint_configuration_space(arm, world, n).tolist() == [
        [link_in_contact(arm, (t1, t2), world) for t1 in angles] for t2 in angles
    ]


class TestRefused:
    """Invalid robots and configurations raise their named errors."""

    @pytest.mark.parametrize(
        ("make", "error"),
        [
            (lambda: TwoLinkArm(0, 1, 0.1), InvalidRobot),
            (lambda: TwoLinkArm(1, 1, -0.1), InvalidRobot),
            (lambda: TwoLinkArm(1, float("nan"), 0.1), InvalidPoint),
            (lambda: ArmChain([], 0.1), InvalidRobot),
            (lambda: RigidPolygon([(0, 0), (1, 0)]), InvalidPolygon),
            (lambda: RigidPolygon(L_SHAPE, turn_weight=0), InvalidRobot),
            (lambda: TranslatingPolygon([(0, 0), (1, 1), (1, 0), (0, 1)]), InvalidPolygon),
            (lambda: TwoLinkArm(1, 1, 0.1).joints((1, 2, 3)), InvalidPoint),
            (lambda: ArmChain([1, 1, 1], 0.1).inverse((1, 1)), InvalidRobot),
            (lambda: link_in_contact(TwoLinkArm(1, 1, 0.1), (1,), ROOM), InvalidPoint),
            (lambda: link_in_contact(Disk(1), (1, 1), ROOM), InvalidRobot),
            (lambda: paint_configuration_space(ArmChain([1], 0.1), ROOM), InvalidRobot),
            (lambda: paint_configuration_space(TwoLinkArm(1, 1, 0.1), ROOM, 0), InvalidParameter),
            (lambda: clearance_of(RigidPolygon(L_SHAPE), ROOM, (1, 1)), InvalidPoint),
            (lambda: Problem(TwoLinkArm(1, 1, 0.1), ROOM, (0, 0, 0), (1, 1)), InvalidPoint),
        ],
    )
    def test_by_name(self, make: Any, error: type[Exception]) -> None:
        """Each by its own error."""
        with pytest.raises(error):
            make()

    def test_start_says_which_link(self) -> None:
        """An arm that starts in contact names the link."""
        with pytest.raises(InvalidStart, match="link 2"):
            Problem(TwoLinkArm(1.5, 1.2, 0.2), ROOM, (0.9, 0.0), (-0.5, 0.0))


@pytest.mark.parametrize(
    ("robot", "start", "goal"),
    [
        (TranslatingPolygon(L_SHAPE), (-2.5, -2), (2.5, -2)),
        (RigidPolygon(L_SHAPE, turn_weight=0.5), (-2.5, -2, 0), (2.5, -2, 7)),
        (TwoLinkArm(1.5, 1.2, 0.2, base=(0.1, 0)), (-0.5, 0), (2.0, 6.6)),
    ],
)
def test_scenes_keep_robots(robot: Any, start: Any, goal: Any, tmp_path: Path) -> None:
    """A robot that is written and read back is equal; angles are wrapped."""
    problem = Problem(robot, ROOM, start, goal)
    write_scene(problem, tmp_path / "scene.json")
    again = read_scene(tmp_path / "scene.json")
    for mine, theirs in zip(
        (*problem.robot, problem.start, problem.goal), (*again.robot, again.start, again.goal)
    ):
        for a, b in zip(mine, theirs) if isinstance(mine, tuple) else ((mine, theirs),):
            np.testing.assert_array_equal(a, b)
    if len(start) == 3:
        assert problem.goal[2] == pytest.approx(7 - 2 * np.pi)

"""The car: it moves as the closed form says, drives its curves, and touches nothing that it claims
to miss.
"""

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely

import kinoedu as ke
from kinoedu.collision import is_free_drive
from kinoedu.curves import Curve
from kinoedu.curves.space import pieces_between
from kinoedu.errors import InvalidParameter, InvalidPoint, InvalidRobot, InvalidStart
from kinoedu.spaces import diameter, distance, interpolate
from kinoedu.spaces.angles import wrap_angle

CASES = json.loads((Path(__file__).parent / "data" / "kino" / "cases_expected.json").read_text())[
    "cases"
]
SEEDS_B = [
    [(75, 75), (100, 75), (100, 100), (75, 100)],
    [(125, 175), (225, 175), (235, 165), (135, 165)],
]
SQUARE = [(0, 0), (300, 0), (300, 300), (0, 300)]
THIN = [(0, 150), (200, 150), (200, 150 + 1e-9), (0, 150 + 1e-9)]
WORLD = ke.PolygonWorld(SQUARE, SEEDS_B)
CAR = ke.Car(30, 10, 20)


def apart(a: Any, b: Any) -> float:
    """How far two poses differ, in any coordinate."""
    return max(math.dist(a[:2], b[:2]), abs(wrap_angle(a[2] - wrap_angle(b[2]))))


def ahead(pose: Any, distance: float) -> Any:
    """The pose of a point so far ahead."""
    x, y, theta = pose
    return x + distance * math.cos(theta), y + distance * math.sin(theta), theta


@pytest.mark.parametrize(
    "case", [case for case in CASES if case["kind"] == "arc"], ids=lambda case: case["id"]
)
def test_one_arc(case: dict[str, Any]) -> None:
    """The pose after driving; an acceleration is as good as the mean speed, and any point of the
    car moves with the rear axle.

    A point `lr` before the axle moves askew, by the angle beta with tan(beta) = lr tan(phi) / L:
    the axle is slower by cos(beta).
    """
    car, lr = ke.Car(2 * case["L"], 1, case["L"], max_steering=1.5), case.get("lr", 0.0)
    mean = case["v"] + 0.5 * case.get("a", 0.0) * case["T"]
    beta = math.atan(lr * math.tan(case["delta"]) / case["L"])
    end = car.move(ahead(case["pose"], -lr), mean * math.cos(beta), case["delta"], case["T"])
    assert apart(ahead(end, lr), case["expected"]["pose"]) < 1e-9
    assert (
        apart(
            car.move(case["pose"], mean, case["delta"], case["T"], reference=lr),
            case["expected"]["pose"],
        )
        < 1e-9
    )


@pytest.mark.parametrize(
    "case", [case for case in CASES if case["kind"] == "arcs"], ids=lambda case: case["id"]
)
def test_arc_after_arc(case: dict[str, Any]) -> None:
    """Each begins where the one before it ended."""
    car, pose = ke.Car(2 * case["L"], 1, case["L"], max_steering=1.5), case["pose"]
    for (v, phi, t), expected in zip(case["segments"], case["expected"]["poses"], strict=True):
        pose = car.move(pose, v, phi, t)
        assert apart(pose, expected) < 1e-9


def test_nearly_straight_is_nearly_straight() -> None:
    """As the steering angle goes to zero the arc goes to the line, without a jump."""
    for phi in (1e-3, 1e-6, 1e-9, 1e-12, 1e-300, 0.0):
        x, y, theta = CAR.move((0, 0, 0), 1, phi, 50)
        curvature = math.tan(phi) / 20
        assert (x, y, theta) == pytest.approx(
            (50, 50 * 50 * curvature / 2, 50 * curvature), rel=1e-5, abs=1e-300
        )


def bodies(poses: Any, car: Any = CAR) -> Any:
    """The car's outlines at many poses, as shapely's polygons."""
    cos, sin, (x, y) = np.cos(poses[:, 2:]), np.sin(poses[:, 2:]), car.outline.T
    corners = np.stack(
        [poses[:, :1] + cos * x - sin * y, poses[:, 1:2] + sin * x + cos * y], axis=-1
    )
    return shapely.polygons(corners)


def solid(obstacles: Any) -> Any:
    """All that is not free, as one shape."""
    outside = shapely.box(-200, -200, 500, 500).difference(shapely.Polygon(SQUARE))
    return shapely.union_all([outside, *map(shapely.Polygon, obstacles)])


def drawn_poses(rng: np.random.Generator, n: int) -> Any:
    """Poses all over the world, some beyond it."""
    return rng.uniform([10, 10, -np.pi], [290, 290, np.pi], (n, 3))


def test_curves_are_judged_as_fine_steps_are() -> None:
    """600 curves, both kinds: free exactly where shapely sees no contact in 500 steps, but for what
    steps cannot tell.
    """
    rng, wall = np.random.default_rng(0), solid(SEEDS_B)
    forward = ke.Car(30, 10, 20, speeds=(1,))
    verdicts = []
    for a, b in zip(drawn_poses(rng, 300), drawn_poses(rng, 300)):
        for car in (CAR, forward):
            free = ke.collision.is_free_path(car, WORLD, a, b, 0.0)
            curve = Curve(a, car.radius, *pieces_between(a, b, car.radius, car.both_ways))
            gap = shapely.distance(bodies(curve.at(np.linspace(0, curve.length, 500))), wall).min()
            assert gap > 0.0 if free else gap < 0.6 * curve.length / 500 + 1e-3
            verdicts.append(free)
    assert 60 < sum(verdicts) < 500


def test_no_wall_is_too_thin() -> None:
    """A wall a billionth thick stops every arc across it, however fast it is driven."""
    world = ke.PolygonWorld(SQUARE, [THIN])
    for curvature in (0.0, 0.01, -0.015):
        assert not is_free_drive(
            CAR, world, np.array([60.0, 100.0, np.pi / 2]), 100.0, curvature, 0.0
        )
        assert is_free_drive(CAR, world, np.array([60.0, 100.0, np.pi / 2]), 10.0, curvature, 0.0)
    assert not is_free_drive(CAR, world, np.array([60.0, 100.0, -np.pi / 2]), -100.0, 0.0, 0.0)


def test_a_margin_is_kept() -> None:
    """The whole body keeps off by the clearance, and by no more."""
    world, pose = (
        ke.PolygonWorld(SQUARE, [[(100, 0), (110, 0), (110, 60), (100, 60)]]),
        np.array([20.0, 67.0, 0.0]),
    )
    assert is_free_drive(CAR, world, pose, 200.0, 0.0, 1.99)
    assert not is_free_drive(CAR, world, pose, 200.0, 0.0, 2.01)


@pytest.mark.parametrize("planner", [ke.rrt, ke.prm])
def test_planners_drive_the_car(planner: Any) -> None:
    """On the map of the seed: the path is made of curves that the car can drive, and shapely sees
    no contact on any.
    """
    problem = ke.Problem(CAR, WORLD, (50, 50, 0), (250, 250, np.pi / 2))
    more = {} if planner is ke.rrt else {"n": 100}
    plan = planner(problem, rng=1, **more)
    wall, length = solid(SEEDS_B), 0.0
    for a, b in zip(plan.path, plan.path[1:]):
        curve = ke.reeds_shepp_path(a, b, CAR.radius)
        assert not shapely.intersects(
            bodies(curve.at(np.linspace(0, curve.length, 300))), wall
        ).any()
        length += curve.length
    assert plan.cost == pytest.approx(length, abs=1e-6)
    assert apart(plan.path[0], problem.start) == apart(plan.path[-1], problem.goal) == 0.0
    assert np.array_equal(planner(problem, rng=1, **more).path, plan.path)


def test_a_car_without_a_reverse_gear() -> None:
    """RRT drives it forward only; planners that use their edges both ways say that they cannot."""
    problem = ke.Problem(
        ke.Car(30, 10, 20, speeds=(1, 2)), WORLD, (50, 50, 0), (250, 250, np.pi / 2)
    )
    plan = ke.rrt(problem, rng=0)
    assert plan.cost == pytest.approx(
        sum(ke.dubins_path(a, b, 20).length for a, b in zip(plan.path, plan.path[1:])), abs=1e-6
    )
    for planner in (ke.prm, ke.build_roadmap, ke.rrt_connect, ke.rrt_star):
        with pytest.raises(InvalidParameter, match="only goes forward"):
            planner(problem, rng=0)


def test_the_space_of_poses() -> None:
    """Steps lie on the curve: the way to them and on from them is no longer than the whole."""
    space, rng = ke.Problem(CAR, WORLD, (50, 50, 0), (250, 250, 0)).space, np.random.default_rng(1)
    for a, b in zip(drawn_poses(rng, 100), drawn_poses(rng, 100)):
        whole, middle = distance(space, a, b), interpolate(space, a, b, 0.3)
        assert distance(space, a, middle) + distance(space, middle, b) <= whole + 1e-6
        assert whole <= 2 * diameter(space)


def test_the_front_axle_may_be_at_the_front_end() -> None:
    """Also where the sum of the sizes is rounded: 0.3 - 0.1 is less than 0.2."""
    assert ke.Car(0.3, 0.1, 0.1, rear_overhang=0.2).outline[1, 0] == pytest.approx(0.1)
    with pytest.raises(InvalidRobot, match="both axles must be under the body"):
        ke.Car(0.3, 0.1, 0.1, rear_overhang=0.2 + 1e-9)


def test_a_body_reaches_as_far_behind_its_axles_as_before_them() -> None:
    """Unless its overhang is given."""
    assert ke.Car(4.0, 2.0, 2.5).outline[:, 0].min() == -0.75
    assert ke.Car(4.0, 2.0, 2.5, rear_overhang=1.0).outline[:, 0].min() == -1.0


def test_nonsense_is_refused_by_name() -> None:
    """Cars that cannot be, and drives that they cannot do."""
    for wrong in (
        {"length": 0},
        {"width": -1},
        {"wheelbase": 40},
        {"rear_overhang": 15},
        {"rear_overhang": -1},
        {"max_steering": 2},
    ):
        with pytest.raises(InvalidRobot):
            ke.Car(**({"length": 30, "width": 10, "wheelbase": 20} | wrong))
    with pytest.raises(InvalidParameter, match=r"at most 0.785398163\d* rad .* = 0.785398164"):
        CAR.curvature(-math.pi / 4 - 1e-9)
    for speeds in ((), (0,), (1, 0), [[1]]):
        with pytest.raises(InvalidRobot):
            ke.Car(30, 10, 20, speeds=speeds)
    for v, phi, t in ((1, 1, 1), (1, 0, -1)):
        with pytest.raises(InvalidParameter):
            CAR.move((0, 0, 0), v, phi, t)
    for pose, v in (((0, 0), 1), ((0, 0, 0), (1, 2)), ((0, 0, 0), np.nan)):
        with pytest.raises(InvalidPoint):
            CAR.move(pose, v, 0, 1)
    with pytest.raises(InvalidStart):
        ke.Problem(CAR, WORLD, (3, 50, 0), (250, 250, 0))


def test_the_last_moment_of_a_long_drive_is_its_last_pose() -> None:
    """However the durations round when they are added up, one by one or in pairs."""
    rng = np.random.default_rng(0)
    for _ in range(200):
        n = int(rng.integers(1, 60))
        controls = np.column_stack([rng.choice([-1.0, 1.0], n), rng.uniform(-0.7, 0.7, n)])
        drive = ke.Trajectory(CAR, (0, 0, 0), controls, rng.uniform(0.01, 3.0, n))
        assert apart(drive.at(drive.duration), drive.poses[-1]) < 1e-9

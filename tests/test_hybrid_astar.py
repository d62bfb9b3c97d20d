"""Hybrid A*: drives are replayed and checked by shapely, and no other node has a shorter one."""

import math
from typing import Any

import numpy as np
import pytest
import shapely

import kinoedu as ke
from kinoedu.errors import InvalidParameter
from kinoedu.planners.driving.lattice import lattices_for
from kinoedu.problems import Recorder
from kinoedu.robots import Trajectory
from kinoedu.robots import trajectory as trajectories

ROOM = [(0, 0), (20, 0), (20, 20), (0, 20)]
WALL = [(9, 0), (11, 0), (11, 10), (9, 10)]
CAR = ke.Car(3, 1, 2)
PROBLEM = ke.Problem(CAR, ke.PolygonWorld(ROOM, [WALL]), (4, 4, 0), (16, 4, 0))
SOLID = shapely.union_all(
    [shapely.box(-50, -50, 70, 70) - shapely.Polygon(ROOM), shapely.Polygon(WALL)]
)


def replayed(plan: Any) -> np.ndarray:
    """The poses (m, 3) of a plan's drive, a hundred for each control, without the library."""
    there = plan.trajectory
    poses = [there.start]
    for (v, phi), t in zip(there.controls, there.durations):
        turn = v * math.tan(phi) / there.wheelbase
        x, y, theta = poses[-1]
        for s in np.linspace(0, t, 101)[1:]:
            angle = turn * s
            along, aside = (
                (v * s, 0.0)
                if turn == 0.0
                else (v / turn * math.sin(angle), v / turn * (1.0 - math.cos(angle)))
            )
            cos, sin = math.cos(theta), math.sin(theta)
            poses.append(
                np.array(
                    [x + cos * along - sin * aside, y + sin * along + cos * aside, theta + angle]
                )
            )
    return np.array(poses)


def is_clear(poses: np.ndarray, car: Any, solid: Any) -> bool:
    """Whether shapely finds no contact at any pose."""
    cos, sin, (x, y) = np.cos(poses[:, 2:]), np.sin(poses[:, 2:]), car.outline.T
    corners = np.stack(
        [poses[:, :1] + cos * x - sin * y, poses[:, 1:2] + sin * x + cos * y], axis=-1
    )
    return not shapely.intersects(shapely.polygons(corners), solid).any()


def check(plan: Any, problem: Any, solid: Any = SOLID) -> None:
    """Check that a drive leads from the start to the goal by free moves of the car, at its cost."""
    poses, there = replayed(plan), plan.trajectory
    assert np.array_equal(poses[0], problem.start) and np.array_equal(plan.path, there.poses)
    off = poses[-1] - problem.goal
    assert np.abs(off[:2]).max() < 1e-9 and abs(math.sin(off[2] / 2.0)) < 1e-9
    assert (np.abs(there.controls[:, 1]) <= problem.robot.max_steering * (1 + 1e-15)).all()
    assert (
        np.isin(there.controls[:, 0], problem.robot.speeds).all() and (there.durations > 0.0).all()
    )
    assert math.isclose(plan.cost, np.hypot(*np.diff(poses[:, :2], axis=0).T).sum(), rel_tol=1e-3)
    assert is_clear(poses, problem.robot, solid)


def test_it_reaches_the_very_goal_and_nothing_left_over_is_shorter() -> None:
    """What the search keeps has no free curve to the goal that would make a shorter drive; the
    first that is free ends it.
    """
    plan = ke.hybrid_astar(PROBLEM)
    check(plan, PROBLEM)
    tree, cost = plan.tree, np.zeros(len(plan.tree.nodes))
    for i in range(1, len(cost)):
        cost[i] = cost[tree.parent[i]] + abs(tree.controls[i, 0] * tree.durations[i])
    whole = [
        c + PROBLEM.distance(q, PROBLEM.goal)
        for c, q in zip(cost, tree.nodes)
        if PROBLEM.is_free_path(q, PROBLEM.goal)
    ]
    assert math.isclose(min(whole), plan.cost, rel_tol=1e-12)
    assert plan.stats["nodes"] == len(tree.nodes) and plan.stats["expanded"] <= len(tree.nodes)


@pytest.mark.parametrize("speeds", [(-1.0, 1.0), (2.0,), (-0.5, 1.0, 3.0)])
def test_where_nothing_is_in_the_way_it_drives_the_shortest_curve(
    speeds: tuple[float, ...],
) -> None:
    """One pose, and on along Reeds and Shepp's curve, or Dubins' for a car that goes forward
    alone.
    """
    car = ke.Car(3, 1, 2, speeds=speeds)
    problem = ke.Problem(car, ke.PolygonWorld(ROOM), (10, 10, 0), (12, 11, 2.5))
    plan = ke.hybrid_astar(problem)
    shortest = ke.dubins_path if min(speeds) > 0 else ke.reeds_shepp_path
    assert math.isclose(
        plan.cost, shortest(problem.start, problem.goal, car.radius).length, rel_tol=1e-12
    )
    assert len(plan.tree.nodes) == 1
    check(plan, problem, shapely.box(-50, -50, 70, 70) - shapely.Polygon(ROOM))


def test_a_car_that_goes_forward_alone_never_drives_back() -> None:
    """Round the wall by Dubins' curves and arcs."""
    problem = ke.Problem(ke.Car(3, 1, 2, speeds=[1.0]), PROBLEM.world, PROBLEM.start, PROBLEM.goal)
    plan = ke.hybrid_astar(problem)
    check(plan, problem)
    assert (plan.trajectory.controls[:, 0] > 0).all() and plan.cost >= ke.hybrid_astar(PROBLEM).cost


def test_a_recorder_sees_the_same_search() -> None:
    """Compiled or interpreted, pose by pose."""
    recorder = Recorder(PROBLEM)
    there, plan = ke.hybrid_astar(recorder), ke.hybrid_astar(PROBLEM)
    assert np.array_equal(there.tree.nodes, plan.tree.nodes) and np.array_equal(
        there.path, plan.path
    )
    assert recorder.counts()["is_free_path"] == plan.stats["expanded"]
    assert there.stats == plan.stats


KERB = [
    [(5.8, 0), (6.7, 0), (6.7, 1.3), (5.8, 1.3)],
    [(10.3, 0), (11.5, 0), (11.5, 1.3), (10.3, 1.3)],
]
PARKED, ROAD = (7.5, 0.6, 0.0), (12.0, 3.0, 0.0)


@pytest.mark.parametrize("speeds", [(-1.0, 1.0), (-0.5, 1.0, 3.0)])
@pytest.mark.parametrize("ends", [(PARKED, ROAD), (ROAD, PARKED)], ids=["out", "in"])
def test_a_tight_place_needs_no_parameter(
    ends: tuple[tuple[float, ...], ...], speeds: tuple[float, ...]
) -> None:
    """Between two cars at a kerb, 0.3 to spare at either end: out, and in. What is searched from
    the goal is driven from the start, at the car's own speeds.
    """
    problem = ke.Problem(ke.Car(3, 1, 2, speeds=speeds), ke.PolygonWorld(ROOM, KERB), *ends)
    plan = ke.hybrid_astar(problem, max_nodes=5000)
    solid = shapely.union_all(
        [shapely.box(-50, -50, 70, 70) - shapely.Polygon(ROOM), *map(shapely.Polygon, KERB)]
    )
    check(plan, problem, solid)
    assert plan.stats["searches"] > 2
    assert np.array_equal(plan.tree.nodes[0], PARKED)  # of the last search


def test_what_is_given_is_not_refined() -> None:
    """One search from either end, or from the start alone if the car cannot reverse."""
    walls = [*KERB, [(6.7, 1.3), (10.3, 1.3), (10.3, 1.5), (6.7, 1.5)]]
    for speeds, searches in (((-1.0, 1.0), 2), ((1.0,), 1)):
        car = ke.Car(3, 1, 2, speeds=speeds)
        problem = ke.Problem(car, ke.PolygonWorld(ROOM, walls), PARKED, ROAD)
        for given in ({"spacing": 0.5}, {"step_size": 0.5}):
            plan = ke.hybrid_astar(problem, **given)
            assert plan.path is None and plan.stats["searches"] == searches
        ever = ke.hybrid_astar(problem, max_nodes=300)
        assert ever.path is None and ever.stats["searches"] > searches


def test_cells_become_smaller_as_fast_as_two_moves_shift_the_car() -> None:
    """A move to the left and one back to the right shift the car by half a cell of each lattice.
    Lattices whose cells cannot be numbered are left out.
    """
    lattices = lattices_for(PROBLEM, None, None, 3)
    shifts = []
    for lattice in lattices:
        d, phi = lattice.step_size, CAR.max_steering
        there = CAR.move(CAR.move((0, 0, 0), 1, phi, d), -1, -phi, d)
        shifts.append(abs(there[1]) / lattice.side)
    assert len(lattices) == 5 and 0.5 < min(shifts) <= max(shifts) < 0.6
    wide = ke.PolygonWorld([(0, 0), (1e8, 0), (1e8, 1e8), (0, 1e8)])
    far = ke.Problem(CAR, wide, (4, 4, 0), (16, 4, 0))
    assert 1 <= len(lattices_for(far, None, None, 3)) < 5


def test_one_who_is_there_stays() -> None:
    """Where start and goal are equal, there are no controls."""
    plan = ke.hybrid_astar(ke.Problem(CAR, PROBLEM.world, (4, 4, 1), (4, 4, 1)))
    assert (
        plan.cost == 0.0
        and np.array_equal(plan.path, [(4, 4, 1)])
        and len(plan.trajectory.controls) == 0
    )


def test_no_way_is_an_answer_with_its_reason() -> None:
    """A goal that is walled in: the cells run out. A tree too small: the nodes do."""
    box = [[(0, 14), (7, 14), (7, 14.5), (0, 14.5)], [(6.5, 14.5), (7, 14.5), (7, 20), (6.5, 20)]]
    walled = ke.hybrid_astar(
        ke.Problem(CAR, ke.PolygonWorld(ROOM, box), (10, 10, 0), (3, 17, 0)), spacing=1.0
    )
    few = ke.hybrid_astar(PROBLEM, max_nodes=1)
    for plan in (walled, few):
        assert (
            plan.path is None
            and plan.trajectory is None
            and plan.cost == math.inf
            and "finer spacing" in plan.reason
        )
    assert walled.stats["nodes"] > 100 and few.stats["nodes"] <= 14


def test_bad_input_is_refused_by_name() -> None:
    """A robot that is no car, sizes that are not positive, and too many cells are refused."""
    point = ke.Problem(ke.Point(), PROBLEM.world, (1, 1), (2, 2))
    for call in (
        lambda: ke.hybrid_astar(point),
        lambda: ke.hybrid_astar(None),
        lambda: ke.hybrid_astar(PROBLEM, spacing=0.0),
        lambda: ke.hybrid_astar(PROBLEM, spacing=1e-9, step_size=1e-9),
        lambda: ke.hybrid_astar(PROBLEM, step_size=math.nan),
        lambda: ke.hybrid_astar(PROBLEM, angles=1),
        lambda: ke.hybrid_astar(PROBLEM, max_nodes=0),
    ):
        with pytest.raises(InvalidParameter):
            call()


def test_a_pose_at_the_very_end_of_a_trajectory_is_its_last(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """However the durations' sum is rounded, no control is looked for after the last one;
    interpreted code would notice.
    """
    monkeypatch.setattr(trajectories, "poses_between", trajectories.poses_between.py_func)
    rng = np.random.default_rng(0)
    for _ in range(300):
        durations = rng.random(rng.integers(1, 40)) * 10.0 ** rng.integers(-6, 3)
        controls = np.column_stack(
            [np.ones(len(durations)), rng.uniform(-0.7, 0.7, len(durations))]
        )
        there = Trajectory(CAR, (0, 0, 0), controls, durations)
        ends = np.append(np.cumsum(durations), there.duration)
        off = there.at(ends)[:, :2] - there.poses[[*range(1, len(durations) + 1), -1], :2]
        assert np.abs(off).max() <= 1e-9 * max(1.0, there.duration)
    assert np.array_equal(Trajectory(CAR, (1, 2, 0.5), [], []).at([0.0, 5.0]), [(1, 2, 0.5)] * 2)


@pytest.mark.parametrize(
    ("speeds", "moves"), [((1,), 3), ((1, 2), 3), ((-1, 1), 6), ((-1, 1, 2), 6)]
)
def test_a_lattice_has_each_move_once(speeds, moves):
    """Of several speeds in a direction the fastest counts."""
    world = ke.PolygonWorld([(0, 0), (30, 0), (30, 30), (0, 30)])
    car = ke.Car(4, 2, 2.5, speeds=speeds)
    problem = ke.Problem(car, world, (5, 5, 0), (20, 20, 0))
    found = lattices_for(problem, 1.0, 1.5, 3)[0].moves
    assert len(found) == moves == len(np.unique(found, axis=0))

"""Moving obstacles: contact, safe intervals, departures and plans, against sampling in time."""

import numpy as np
import pytest
import shapely

from kinoedu import (
    Disk,
    Moving,
    MovingWorld,
    Point,
    PolygonWorld,
    Problem,
    RigidPolygon,
    TimedProblem,
    TranslatingPolygon,
    plan_in_time,
)
from kinoedu.collision import clearance_of, free_configurations, free_motions
from kinoedu.collision import collision_intervals as departures
from kinoedu.errors import (
    InvalidGoal,
    InvalidParameter,
    InvalidPoint,
    InvalidPolygon,
    InvalidStart,
    InvalidWorld,
)
from kinoedu.planners.moving.safe_intervals import safe_intervals, search_intervals
from kinoedu.worlds import movers_at

HALL = PolygonWorld([(0, 0), (12, 0), (12, 8), (0, 8)], [[(5, 0), (7, 0), (7, 3), (5, 3)]])
EMPTY = PolygonWorld([(-50, -50), (50, -50), (50, 50), (-50, 50)])
L_SHAPE = [(0, 0), (2, 0), (2, 0.6), (0.6, 0.6), (0.6, 2), (0, 2)]
ROBOTS = [
    Point(),
    Disk(0.4),
    TranslatingPolygon([(-0.4, -0.3), (0.5, -0.3), (0, 0.5)]),
    TranslatingPolygon(L_SHAPE),
]


def some_movers(rng, n=3):
    """Discs and polygons on random ways."""
    movers = []
    for _ in range(n):
        times = np.cumsum(rng.uniform(0.5, 3, rng.integers(1, 5))) - 1.0
        shape = (
            rng.uniform(0.3, 1.2) if rng.random() < 0.4 else np.array(L_SHAPE) * rng.uniform(0.4, 1)
        )
        movers.append(Moving(shape, times, rng.uniform(0, 8, (len(times), 2)) * (1.5, 1)))
    return movers


def body_at(robot, q):
    """A robot's outline as shapely's polygon; for a disc its centre and radius."""
    radius = getattr(robot, "radius", None)
    if radius is not None:
        return shapely.Point(q), radius
    return shapely.affinity.translate(shapely.Polygon(robot.outline), *q), 0.0


def gap_at(robot, world, q, t):
    """The distance from the robot to all moving obstacles at one moment, by shapely."""
    body, reach = body_at(robot, q)
    gaps = [np.inf]
    for outline, radius in movers_at(world, t):
        shape = shapely.Point(outline[0]) if radius else shapely.Polygon(outline)
        gaps.append(body.distance(shape) - radius - reach)
    return min(gaps)


def least_gap(robot, world, a, b, n=1500):
    """The least of these distances at many moments of a motion."""
    return min(
        gap_at(robot, world, a[:2] + s * (b[:2] - a[:2]), a[2] + s * (b[2] - a[2]))
        for s in np.linspace(0, 1, n)
    )


@pytest.mark.parametrize("robot", ROBOTS, ids=range(len(ROBOTS)))
def test_a_motion_is_judged_as_dense_sampling_sees_it(robot):
    """Free motions keep a gap at every sampled moment; others come near to contact at one."""
    rng, verdicts = np.random.default_rng(5), []
    for _ in range(25):
        world = MovingWorld(EMPTY, some_movers(rng))
        problem = TimedProblem(robot, world, (40, 40), (40, 40), speed=100.0)
        a, b = (
            np.append(rng.uniform(0, 8, 2), rng.uniform(0, 4)),
            np.append(rng.uniform(0, 8, 2), 0.0),
        )
        b[2] = a[2] + rng.uniform(0.5, 5)
        free, gap = problem.is_free_path(a, b), least_gap(robot, world, a, b)
        assert (gap > 0.0) if free else (gap < 0.05)
        verdicts.append(free)
    assert 3 < sum(verdicts) < 23


def test_crossing_paths_at_different_times_is_no_contact_and_touching_is():
    """Two ways cross: who comes later passes; a disc that is passed at exactly its radius is
    touched.
    """
    world = MovingWorld(EMPTY, [Moving(1.0, [0, 10], [(5, -5), (5, 5)])])
    problem = TimedProblem(Point(), world, (0, 0), (20, 0), speed=10.0)
    assert problem.is_free_path(np.array([0, 0, 0.0]), np.array([10, 0, 2.0]))
    assert not problem.is_free_path(np.array([0, 0, 0.0]), np.array([10, 0, 10.0]))
    beside = MovingWorld(EMPTY, [Moving(1.0, [0, 10], [(0, 1), (10, 1)])])
    touching = TimedProblem(Point(), beside, (-5, 0), (20, 0), speed=10.0)
    assert not touching.is_free_path(np.array([2, 0, 0.0]), np.array([8, 0, 10.0]))
    assert touching.is_free_path(np.array([2, -1e-9, 0.0]), np.array([8, -1e-9, 10.0]))
    box = MovingWorld(EMPTY, [Moving([(0, 0), (1, 0), (1, 1), (0, 1)], [0, 8], [(8, 0), (0, 0)])])
    meets = TimedProblem(Point(), box, (-3, 0), (-3, 0), speed=10.0)
    assert not meets.is_free_path(
        np.array([0, 0.5, 0.0]), np.array([0, 0.5, 8.0])
    )  # it arrives at the last moment
    assert meets.is_free_path(np.array([0, 0.5, 0.0]), np.array([0, 0.5, 7.999]))


def test_time_and_speed_are_kept():
    """Back in time, anywhere in no time, or faster than the robot is not free; waiting is."""
    problem = TimedProblem(Point(), MovingWorld(HALL, []), (1, 1), (11, 1), speed=2.0)
    a = np.array([1.0, 1.0, 3.0])
    assert not problem.is_free_path(a, np.array([1.0, 1.0, 2.0]))
    assert not problem.is_free_path(a, np.array([2.0, 1.0, 3.0]))
    assert not problem.is_free_path(a, np.array([4.0, 1.0, 4.0]))
    assert problem.is_free_path(a, np.array([3.0, 1.0, 4.0]))
    assert problem.is_free_path(a, np.array([1.0, 1.0, 9.0]))
    assert not problem.is_free_path(a, np.array([11.0, 1.0, 99.0]))  # the wall stands


@pytest.mark.parametrize("robot", ROBOTS, ids=range(len(ROBOTS)))
def test_safe_intervals_are_when_the_place_is_free(robot):
    """Inside them every moment is free; outside there is contact, or for what is round nearly
    so.
    """
    rng = np.random.default_rng(2)
    for _ in range(8):
        world = MovingWorld(EMPTY, some_movers(rng))
        problem, q = (
            TimedProblem(robot, world, (40, 40), (40, 40), horizon=12.0),
            rng.uniform(1, 7, 2),
        )
        intervals = safe_intervals(problem, q)
        assert (np.diff(intervals.ravel()) >= 0).all()
        for t in np.linspace(0, 12, 400):
            inside = ((intervals[:, 0] <= t) & (t <= intervals[:, 1])).any()
            gap = gap_at(robot, world, q, t)
            assert gap > 0 if inside else gap < 0.02


@pytest.mark.parametrize("robot", ROBOTS, ids=range(len(ROBOTS)))
def test_departures_that_are_met_are_met(robot):
    """A departure outside the intervals makes a free motion; one inside makes contact, or for what
    is round nearly so.
    """
    rng, seen = np.random.default_rng(3), set()
    for _ in range(12):
        world = MovingWorld(EMPTY, some_movers(rng))
        problem = TimedProblem(robot, world, (40, 40), (40, 40), speed=9.0, horizon=12.0)
        hulls, knots = departures.relative_obstacles(
            problem.robot, problem.world, problem.clearance
        )
        a, v, duration = rng.uniform(0, 8, 2), rng.uniform(-2, 2, 2), rng.uniform(0.3, 3)
        met = departures.collision_intervals(
            hulls, knots, world.times, world.places, 12.0, a, *v, duration
        )
        for t in rng.uniform(0, 12 - duration, 40):
            is_met = bool(((met[:, 0] <= t) & (t <= met[:, 1])).any())
            begin, end = np.append(a, t), np.append(a + duration * v, t + duration)
            if is_met:
                assert least_gap(robot, world, begin, end, 200) < 0.12
            else:
                assert problem.is_free_path(begin, end)
            seen.add(is_met)
    assert seen == {True, False}


def corridor(n=4):
    """A hall through which boxes sweep to and fro."""
    boxes = [
        Moving(
            [(-0.5, -1.2), (0.5, -1.2), (0.5, 1.2), (-0.5, 1.2)],
            np.arange(9) * 3.0,
            [(x, 1.2 if k % 2 else 6.8) for k in range(9)],
        )
        for x in np.linspace(2.5, 10, n)
    ]
    return TimedProblem(Disk(0.3), MovingWorld(HALL, boxes), (1, 4), (11.2, 4), speed=1.5)


def test_a_plan_is_free_at_every_moment_and_no_faster_than_the_robot():
    """From start at 0 to goal, forward in time, each stretch free, by the ask and by dense
    sampling.
    """
    for seed in range(4):
        problem = corridor()
        plan = plan_in_time(problem, n=80, k=8, rng=seed)
        path = plan.path
        assert (
            np.array_equal(path[0], [1, 4, 0])
            and np.array_equal(path[-1, :2], [11.2, 4])
            and path[-1, 2] == plan.cost
        )
        for a, b in zip(path, path[1:]):
            assert problem.is_free_path(a, b)
            assert least_gap(problem.robot, problem.world, a, b, 300) > 0.0
            assert np.hypot(*(b - a)[:2]) <= 1.5 * (b[2] - a[2]) * (1 + 1e-9)
        assert plan.cost >= 10.2 / 1.5
        assert np.array_equal(path, plan_in_time(problem, n=80, k=8, rng=seed).path)


def brute_arrival(problem, nodes, edges, dt):
    """The earliest arrival on the same roadmap when departures are whole multiples of dt, by
    stepping through all moments.
    """
    steps = int(problem.horizon / dt)
    at = np.zeros((steps + 1, len(nodes)), bool)
    at[0, 0] = True
    ways = [(u, v) for u, v in (*edges.tolist(), *edges[:, ::-1].tolist())]
    later = {way: np.hypot(*(nodes[way[1]] - nodes[way[0]])) / problem.speed for way in ways}
    arrivals = []
    for i in range(steps):
        now = np.append
        for u in np.flatnonzero(at[i]):
            here = now(nodes[u], i * dt)
            if problem.is_free_path(here, now(nodes[u], (i + 1) * dt)):
                at[i + 1, u] = True
            for (a, v), duration in later.items():
                there = now(nodes[v], i * dt + duration)
                if a != u or there[2] > problem.horizon or not problem.is_free_path(here, there):
                    continue
                if v == 1:
                    arrivals.append(there[2])
                j = int(np.ceil((i * dt + duration) / dt - 1e-12))
                if j <= steps and problem.is_free_path(there, now(nodes[v], j * dt)):
                    at[j, v] = True
    return min(arrivals, default=np.inf)


def test_the_arrival_is_the_earliest_on_the_roadmap():
    """No later than a search that steps through time, and hardly earlier: the steps alone cost
    something.
    """
    waited = 0
    for seed in range(3):
        problem = corridor(2)._replace(horizon=20.0)
        plan = plan_in_time(problem, n=7, k=4, rng=seed)
        brute = brute_arrival(problem, plan.roadmap.nodes, plan.roadmap.edges, 0.05)
        assert plan.cost <= brute * (1 + 1e-3) + 1e-9 or plan.cost == brute == np.inf
        assert brute < plan.cost + 0.6 or plan.cost == np.inf
        waited += (
            plan.path is not None and (np.diff(plan.path[:, 2]) > 0).sum() > len(plan.path) - 2
        )
    assert waited


@pytest.mark.parametrize(
    ("start", "goal", "leaves", "speed", "move"),
    [
        (
            (1.5194218724809203, 2.919239810079656),
            (9.601449848240483, 1.269131716496395),
            14.665366967925877,
            1.9236150508177428,
            (2.4837597898144708, 1.7166264771772077),
        ),
        (
            (2.399104139385451, 4.178783715805385),
            (9.62960263852425, 5.238473253991642),
            11.279212202255975,
            2.6425709406303746,
            (6.228619609903028, -5.217500754070304),
        ),
    ],
)
def test_an_arrival_the_moment_the_goal_is_free_is_not_lost(start, goal, leaves, speed, move):
    """The goal is free from t on, and t - duration + duration is rounded to less than t."""
    hall = PolygonWorld([(0, 0), (12, 0), (12, 8), (0, 8)])
    square = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)]
    box = Moving(square, [0, leaves, leaves + 5], [goal, goal, np.add(goal, move)])
    world = MovingWorld(hall, [box])
    problem = TimedProblem(Point(), world, start, goal, speed=speed, horizon=60.0)
    [(free_from, _)] = safe_intervals(problem, goal)
    assert plan_in_time(problem, n=0, k=1, rng=0).cost == free_from


def test_it_waits_no_longer_than_it_must():
    """Nothing in the way: it goes at once. A gate that lifts: it leaves so as to pass the moment it
    is open.
    """
    hall = PolygonWorld([(0, 0), (10, 0), (10, 2), (0, 2)])
    off = Moving(
        [(-0.5, -1), (0.5, -1), (0.5, 1), (-0.5, 1)], [0, 2, 12], [(5, 20), (5, 20), (5, 20)]
    )
    problem = TimedProblem(Point(), MovingWorld(hall, [off]), (1, 1), (9, 1))
    assert plan_in_time(problem, n=0, k=1, rng=0).cost == pytest.approx(8.0)
    gate = Moving(
        [(-0.5, -3), (0.5, -3), (0.5, 3), (-0.5, 3)], [0, 10, 11], [(5, 1), (5, 1), (5, 30)]
    )
    closed = TimedProblem(Point(), MovingWorld(hall, [gate]), (1, 1), (9, 1))
    plan = plan_in_time(closed, n=0, k=1, rng=0)
    assert len(plan.path) == 3 and plan.path[1, 2] == pytest.approx(10 + 3 / 29 - 3.5, abs=1e-6)
    assert plan.cost == pytest.approx(plan.path[1, 2] + 8)


def test_no_way_is_an_answer_and_start_at_the_goal_is_one():
    """A gate that never opens; a goal that is where the robot stands; a start that is touched at
    once.
    """
    hall = PolygonWorld([(0, 0), (10, 0), (10, 2), (0, 2)])
    gate = Moving([(-0.5, -3), (0.5, -3), (0.5, 3), (-0.5, 3)], [0], [(5, 1)])
    plan = plan_in_time(
        TimedProblem(Point(), MovingWorld(hall, [gate]), (1, 1), (9, 1)), n=30, rng=0
    )
    assert (
        plan.path is None
        and plan.cost == np.inf
        and "30" not in plan.reason[:4]
        and "32 nodes" in plan.reason
    )
    stay = plan_in_time(
        TimedProblem(Point(), MovingWorld(hall, [gate]), (1, 1), (1, 1)), n=5, rng=0
    )
    assert stay.cost == 0.0 and np.array_equal(stay.path, [[1, 1, 0]])


def test_compiled_and_interpreted_search_alike():
    """The arrivals are equal to the last bit."""
    problem = corridor(2)
    plan = plan_in_time(problem, n=12, k=4, rng=1)
    nodes, edges = plan.roadmap
    hulls, knots = departures.relative_obstacles(problem.robot, problem.world, problem.clearance)
    given = hulls, knots, problem.world.times, problem.world.places, problem.horizon, nodes
    from kinoedu.graphs import flat_graph

    graph = flat_graph(len(nodes), edges, np.hypot(*(nodes[edges[:, 0]] - nodes[edges[:, 1]]).T))
    safe, first = departures.find_safe_intervals(*given)
    again = departures.find_safe_intervals.py_func(*given)
    assert np.array_equal(safe, again[0]) and np.array_equal(first, again[1])
    both = [
        search(problem, graph, nodes, safe, first, hulls, knots)
        for search in (search_intervals, search_intervals.py_func)
    ]
    assert all(np.array_equal(a, b) for a, b in zip(*both))


def test_what_makes_no_sense_is_refused_by_name():
    """Times that do not increase, shapes that do not fit, ends that are not free, robots that
    turn.
    """
    hall = MovingWorld(HALL, [Moving(1.0, [0, 9], [(1, 1), (1, 7)])])
    for error, call in (
        (InvalidWorld, lambda: Moving(1.0, [0, 0], [(1, 1), (2, 2)])),
        (InvalidWorld, lambda: Moving(1.0, [], np.empty((0, 2)))),
        (InvalidWorld, lambda: Moving(1.0, [0, 1], [(1, 1)])),
        (InvalidWorld, lambda: Moving(-1.0, [0], [(1, 1)])),
        (InvalidPoint, lambda: Moving(1.0, [0, np.nan], [(1, 1), (2, 2)])),
        (InvalidPolygon, lambda: Moving([(0, 0), (1, 1)], [0], [(1, 1)])),
        (InvalidWorld, lambda: MovingWorld(HALL, [((1, 1), 2)])),
        (InvalidWorld, lambda: MovingWorld("hall", [])),
        (InvalidStart, lambda: TimedProblem(Point(), hall, (1, 1.5), (9, 4))),
        (InvalidGoal, lambda: TimedProblem(Point(), hall, (4, 4), (6, 1))),
        (InvalidParameter, lambda: TimedProblem(Point(), hall, (4, 4), (9, 4), speed=0)),
        (InvalidParameter, lambda: TimedProblem(Point(), HALL, (4, 4), (9, 4))),
        (InvalidParameter, lambda: TimedProblem(RigidPolygon(L_SHAPE), hall, (4, 4, 0), (9, 4, 0))),
        (InvalidParameter, lambda: plan_in_time("hall", rng=0)),
        (
            InvalidPoint,
            lambda: safe_intervals(TimedProblem(Point(), hall, (4, 4), (9, 4)), (1, np.inf)),
        ),
    ):
        with pytest.raises(error):
            call()
    for timeless in (
        lambda: Problem(Point(), hall, (4, 4), (9, 4)),
        lambda: free_configurations(Point(), hall, [(4, 4)]),
        lambda: free_motions(Point(), hall, [(4, 4)], [(9, 4)]),
        lambda: clearance_of(Point(), hall, (4, 4)),
    ):
        with pytest.raises(InvalidWorld, match="give the world to TimedProblem"):
            timeless()
    for error, start, goal in ((InvalidStart, (1, 1.5), (9, 4)), (InvalidGoal, (4, 4), (6, 1))):
        with pytest.raises(error, match="move it into the free space"):
            TimedProblem(Point(), hall, start, goal)
    assert len(safe_intervals(TimedProblem(Point(), hall, (4, 4), (9, 4)), (6, 1))) == 0

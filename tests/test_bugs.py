"""The Bug family: exact walks that find a path where there is one, and stop where there is none."""

import inspect
import json
import math
from decimal import Decimal
from fractions import Fraction
from itertools import pairwise
from pathlib import Path

import matplotlib
import numpy as np
import pytest
import shapely
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

import kinoedu as ke
from kinoedu.errors import (
    InvalidGoal,
    InvalidParameter,
    InvalidPoint,
    InvalidPolygon,
    InvalidStart,
    InvalidWorld,
    UnknownFormat,
)
from kinoedu.planners.bugs.bug0 import bug0_walk
from kinoedu.planners.bugs.bug1 import bug1_walk
from kinoedu.planners.bugs.bug2 import bug2_walk
from kinoedu.planners.bugs.bug2_prelim import bug2_prelim_walk
from kinoedu.planners.bugs.bug_base import bug_base_walk
from kinoedu.planners.bugs.place import CROSSING, FOOT, GIVEN, Place, compare_distances
from kinoedu.planners.bugs.places import add_place, empty_places
from kinoedu.planners.bugs.robot import corners_of, new_robot
from kinoedu.planners.bugs.trail import append, new_trail
from kinoedu.planners.bugs.walls import check_obstacles, contact, make_walls

matplotlib.use("Agg")

WORLDS = json.loads(
    (Path(__file__).parent / "data" / "bug" / "worlds_expected.json").read_text(encoding="utf-8")
)["worlds"]
CASES = [
    (world, name, answer)
    for world in WORLDS
    for name, answer in world["expected"].items()
    if name != "shortest"
]
ME145 = WORLDS[0]
LAW = settings(
    derandomize=True,
    deadline=None,
    database=None,
    max_examples=150,
    suppress_health_check=list(HealthCheck),
)

BUGS = {
    "bug0": ke.bug0,
    "bug1": ke.bug1,
    "bug1_same": lambda *args, **options: ke.bug1(*args, way_back="same", **options),
    "bug2": ke.bug2,
    "bug2_prelim": ke.bug2_prelim,
}
COMPLETE = ("bug1", "bug1_same", "bug2")

BOX = [(4, -1), (6, -1), (6, 2), (4, 2)]
SPIRAL = [(1, -3), (9, -3), (9, 3), (3, 3), (3, 2), (8, 2), (8, -2), (2, -2), (2, 3.5), (1, 3.5)]
RING = [
    [(0, 0), (9, 0), (9, 2), (0, 2)],
    [(0, 1), (2, 1), (2, 9), (0, 9)],
    [(1, 7), (9, 7), (9, 9), (1, 9)],
    [(7, 1), (9, 1), (9, 8), (7, 8)],
]


def run(world, name):
    """The plan of a case: its name is an algorithm, a turn and Bug 1's way back."""
    bug, *words = name.split("_")
    options = {"way_back": "same" if "same" in words else "shorter"} if bug == "bug1" else {}
    turn = "right" if "right" in words else "left"
    return BUGS[bug](
        world["start"], world["goal"], world["obstacles"], world["step"], turn=turn, **options
    )


def corners(plan):
    """A walk's points without those between two others on one straight move, as lists."""
    kept = [plan.walk.points[0]]
    for b, c in zip(plan.walk.points[1:], [*plan.walk.points[2:], None]):
        a = kept[-1]
        straight = (
            c is not None
            and abs((b - a)[0] * (c - b)[1] - (b - a)[1] * (c - b)[0]) < 1e-12
            and (b - a) @ (c - b) >= 0.0
        )
        if not straight:
            kept.append(b)
    return [point.tolist() for point in kept]


# ---- the worlds with known answers


@pytest.mark.parametrize(
    ("world", "name", "answer"), CASES, ids=[f"{world['id']}-{name}" for world, name, _ in CASES]
)
def test_walks_are_the_continuum_walks(world, name, answer):
    """Success, hit points and corners of every case; the length to 1e-9, which is what the data are
    rounded to.
    """
    plan = run(world, name)
    assert (plan.path is not None) == answer["success"]
    assert bool(plan.reason) != answer["success"]
    assert plan.walk.hits == pytest.approx(np.array(answer["hits"], float).reshape(-1, 2), abs=1e-9)
    if answer["success"]:
        assert plan.cost == pytest.approx(answer["length"], rel=1e-9)
        line = shapely.LineString(answer["path"])
        assert all(line.distance(shapely.Point(point)) < 1e-8 for point in plan.path)
        points = iter(plan.path)
        assert all(
            any(np.abs(point - corner).max() < 1e-8 for point in points)
            for corner in answer["path"]
        )  # in that order
    elif "bug0" not in name:
        length = answer.get("length_at_detection_with_return", answer["length_at_detection"])
        assert plan.walk.travelled[-1] == pytest.approx(length, rel=1e-9)
        assert plan.cost == math.inf
        if "nearest" in answer:
            assert plan.walk.points[-1] == pytest.approx(answer["nearest"], abs=1e-9)


@pytest.mark.parametrize("step", [1e3, 1.0, 0.1, 0.0137])
@pytest.mark.parametrize(
    "name", ["bug1_left_same", "bug1_right_same", "bug1_short", "bug0_left", "bug0_right"]
)
def test_lengths_are_exact_to_1e_12_whatever_the_step(name, step):
    """Where the corners are short decimals, the length is that of the listed walk, summed with
    fifty digits.
    """
    walk = [[Decimal(str(x)) for x in point] for point in ME145["expected"][name]["path"]]
    exact = sum(((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2).sqrt() for a, b in pairwise(walk))
    assert run({**ME145, "step": step}, name).cost == pytest.approx(float(exact), rel=1e-14)


def test_figures_of_me_145():
    """Bug 1 in the world of ME 145: 23.5071 turning right, 26.2511 turning left with the way back
    in the same direction.
    """
    assert round(run(ME145, "bug1_right_same").cost, 4) == 23.5071
    assert round(run(ME145, "bug1_left_same").cost, 4) == 26.2511


def test_bug_base_stops_at_the_first_wall():
    """A straight walk to the goal where nothing is in the way, and to the wall otherwise."""
    free = ke.bug_base((0, 0), (3, 4), [BOX], 0.5)
    assert free.cost == 5.0 and len(free.path) == 11
    stopped = ke.bug_base((0, 0), (10, 0), [BOX], 0.5)
    assert stopped.path is None and "obstacle" in stopped.reason
    assert stopped.walk.points[-1].tolist() == [4.0, 0.0] == stopped.walk.hits[0].tolist()


# ---- laws


@st.composite
def scattered(draw):
    """Disjoint star-shaped polygons, one at most in each cell of a grid, and a start and a goal off
    them.
    """
    polygons = []
    for cell in draw(st.lists(st.integers(0, 15), min_size=1, max_size=9, unique=True)):
        n = draw(st.integers(3, 8))
        turns = np.sort(draw(st.lists(st.floats(0.0, 0.8), min_size=n, max_size=n))) + np.arange(n)
        radii = np.array(draw(st.lists(st.floats(0.3, 1.95), min_size=n, max_size=n)))
        middle = np.array([4.0 * (cell % 4) + 2.0, 4.0 * (cell // 4) + 2.0])
        angles = 2.0 * np.pi * turns / (n + 0.8)
        polygon = np.column_stack([radii * np.cos(angles), radii * np.sin(angles)]) + middle
        assume(shapely.Polygon(polygon).is_valid and shapely.Polygon(polygon).area > 1e-3)
        polygons.append(polygon)
    ends = [draw(st.tuples(st.floats(-1.0, 17.0), st.floats(-1.0, 17.0))) for _ in range(2)]
    solids = [shapely.Polygon(polygon) for polygon in polygons]
    assume(all(solid.distance(shapely.Point(end)) > 1e-6 for end in ends for solid in solids))
    assume(all(a.distance(b) > 1e-6 for i, a in enumerate(solids) for b in solids[:i]))
    return *ends, polygons


@st.composite
def on_a_lattice(draw):
    """Polygons with corners on a small lattice that overlap, touch, line up or share a corner, and
    a start and a goal on it.
    """
    polygons, shared = [], draw(st.sampled_from([[], [(3, 3)]]))
    for _ in range(draw(st.integers(1, 5))):
        points = draw(
            st.lists(
                st.tuples(st.integers(0, 6), st.integers(0, 6)),
                min_size=3 - len(shared),
                max_size=7,
                unique=True,
            )
        )
        points = sorted({*points, *shared})
        assume(len(points) >= 3)
        middle = np.mean(points, axis=0)
        polygon = sorted(points, key=lambda p: math.atan2(p[1] - middle[1], p[0] - middle[0]))
        solid = shapely.Polygon(polygon)
        assume(solid.is_valid and solid.area > 0.0)
        polygons.append(polygon)
    return *(draw(st.tuples(st.integers(-1, 7), st.integers(-1, 7))) for _ in range(2)), polygons


bug_names, turns = st.sampled_from(sorted(BUGS)), st.sampled_from(["left", "right"])


def assert_is_a_walk(plan, start, goal, step, solid):
    """Check what holds of every walk, with or without a path; shapely checks for contact."""
    walk = plan.walk
    moves = np.hypot(*np.diff(walk.points, axis=0).T)
    assert walk.points[0].tolist() == list(start)
    assert moves.max(initial=0.0) <= step * (1.0 + 1e-12)
    assert walk.travelled == pytest.approx(
        np.concatenate([[0.0], np.cumsum(moves)]), rel=1e-9, abs=1e-12
    )
    assert walk.distance_to_goal == pytest.approx(
        np.hypot(*(walk.points - np.array(goal)).T), rel=1e-12, abs=1e-12
    )
    inside = shapely.LineString(walk.points).intersection(solid.buffer(-1e-7))
    assert inside.length < 1e-9
    wall = solid.boundary
    assert all(wall.distance(shapely.Point(point)) < 1e-9 for point in walk.points[walk.following])
    assert 0 <= len(walk.hit) - len(walk.leave) <= 1
    assert not walk.following[walk.hit].any()
    assert (
        walk.following[walk.leave].all() or plan.planner == "Bug 1"
    )  # Bug 1 may leave where it hit
    if plan.path is None:
        assert plan.reason and plan.cost == math.inf
    else:
        assert (
            plan.path[-1].tolist() == list(goal)
            and plan.cost == walk.travelled[-1]
            and plan.reason == ""
        )
        assert len(walk.hit) == len(walk.leave)


@LAW
@given(scattered(), bug_names, turns, st.floats(0.05, 30.0))
def test_walks_hold_their_promises(world, name, turn, step):
    """Semi-free, along walls where they say so, points a step apart; among disjoint obstacles Bug 1
    and Bug 2 always arrive.
    """
    start, goal, polygons = world
    plan = BUGS[name](start, goal, polygons, step, turn=turn)
    assert_is_a_walk(
        plan,
        start,
        goal,
        step,
        shapely.union_all([shapely.Polygon(polygon) for polygon in polygons]),
    )
    assert plan.path is not None or name not in COMPLETE


@LAW
@given(on_a_lattice(), bug_names, turns)
def test_obstacles_that_meet_are_one(world, name, turn):
    """Overlapping, touching, collinear: a path is found exactly when start and goal lie in one part
    of what is free.
    """
    start, goal, polygons = world
    solid = shapely.union_all([shapely.Polygon(polygon) for polygon in polygons])
    assume(
        not solid.intersects(shapely.Point(start))
        and not solid.boundary.intersects(shapely.Point(goal))
    )
    parts = shapely.get_parts(shapely.box(-9, -9, 20, 20).difference(solid))
    joined = any(
        part.contains(shapely.Point(start)) and part.contains(shapely.Point(goal)) for part in parts
    )
    plan = BUGS[name](start, goal, polygons, 0.5, turn=turn)
    assert_is_a_walk(plan, start, goal, 0.5, solid)
    assert joined or plan.path is None
    assert plan.path is not None or not joined or name not in COMPLETE


@LAW
@given(on_a_lattice(), bug_names, turns, st.floats(0.1, 6.2))
def test_nearly_degenerate_worlds_end_too(world, name, turn, angle):
    """The lattice turned, so that what lined up does so but for rounding: every walk ends, and
    enters nothing.
    """
    turned = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    start, goal, *polygons = (
        np.array(points, float) @ turned.T for points in (world[0], world[1], *world[2])
    )
    solid = shapely.union_all([shapely.Polygon(polygon) for polygon in polygons])
    assume(all(solid.boundary.distance(shapely.Point(end)) > 1e-9 for end in (start, goal)))
    assume(not solid.intersects(shapely.Point(start)))
    plan = BUGS[name](start, goal, polygons, 0.5, turn=turn)
    assert_is_a_walk(plan, start.tolist(), goal.tolist(), 0.5, solid)


@LAW
@given(scattered(), turns, st.sampled_from(["shorter", "same"]))
def test_bug1_keeps_its_bound(world, turn, way_back):
    """At most D + 3/2 of the perimeters met, 2 with the way back in the same direction; it leaves
    where the goal is nearest.
    """
    start, goal, polygons = world
    plan = ke.bug1(start, goal, polygons, 1.0, turn=turn, way_back=way_back)
    solids = [shapely.Polygon(polygon) for polygon in polygons]
    met = [
        solid
        for solid in solids
        if any(solid.distance(shapely.Point(hit)) < 1e-9 for hit in plan.walk.hits)
    ]
    rounds = 1.5 if way_back == "shorter" else 2.0
    assert plan.cost <= (math.dist(start, goal) + rounds * sum(solid.length for solid in met)) * (
        1.0 + 1e-12
    )
    assert len(met) == len(plan.walk.hits)  # none is met twice
    for leave in plan.walk.leaves:
        (left,) = [solid for solid in met if solid.distance(shapely.Point(leave)) < 1e-9]
        assert math.dist(leave, goal) == pytest.approx(left.distance(shapely.Point(goal)), rel=1e-9)


@LAW
@given(scattered(), turns)
def test_bug2_keeps_its_bound(world, turn):
    """At most D + n p / 2 for each obstacle, met n times by the start-goal line; it leaves on that
    line, closer than it hit.
    """
    start, goal, polygons = world
    plan = ke.bug2(start, goal, polygons, 1.0, turn=turn)
    line = shapely.LineString([start, goal])
    bound = math.dist(start, goal)
    for solid in map(shapely.Polygon, polygons):
        bound += solid.length * len(shapely.get_parts(solid.boundary.intersection(line))) / 2.0
    assert plan.cost <= bound * (1.0 + 1e-12)
    hits, leaves = (
        plan.walk.distance_to_goal[plan.walk.hit],
        plan.walk.distance_to_goal[plan.walk.leave],
    )
    assert (leaves < hits).all() and (hits[1:] < leaves[:-1]).all()
    assert all(
        line.distance(shapely.Point(point)) < 1e-9 for point in (*plan.walk.hits, *plan.walk.leaves)
    )


@LAW
@given(scattered(), bug_names)
def test_a_mirrored_world_and_the_other_turn_give_the_mirrored_walk(world, name):
    """Left and right are symmetric."""
    start, goal, polygons = world
    plan = BUGS[name](start, goal, polygons, 0.7, turn="left")
    across = np.array([-1.0, 1.0])
    mirrored = BUGS[name](
        start * across, goal * across, [polygon * across for polygon in polygons], 0.7, turn="right"
    )
    assert mirrored.walk.points == pytest.approx(plan.walk.points * across, abs=1e-9)
    assert mirrored.walk.hit.tolist() == plan.walk.hit.tolist()


@LAW
@given(scattered(), bug_names, turns, st.sampled_from([-480, -300, 40, 300, 450]))
def test_size_does_not_matter(world, name, turn, power):
    """A world 2^power times as large has a walk 2^power times as large, to 1e-13 of its size."""
    start, goal, polygons = (np.array(world[0]), np.array(world[1]), world[2])
    plan = BUGS[name](start, goal, polygons, 8.0, turn=turn)
    scaled = BUGS[name](
        *(np.ldexp(end, power) for end in (start, goal)),
        [np.ldexp(p, power) for p in polygons],
        2.0 ** (power + 3),
        turn=turn,
    )
    assert np.ldexp(scaled.walk.points, -power) == pytest.approx(plan.walk.points, abs=1e-12)


# ---- what an algorithm may ask

QUERIES = {"place", "travelled", "move_to_goal", "can_move_to_goal", "follow_wall", "turn_round"}
QUERIES |= {"was_hit_before"}
ENDINGS = {"REACHED", "OBSTACLE", "IN_A_CIRCLE", "SHUT_IN", "NO_PATH"}


class Witness:
    """A robot that answers the algorithm's calls, records them, and has no other attributes."""

    def __init__(self, robot):
        self.__robot, self.queries = robot, []

    def __getattr__(self, name):
        if name.startswith("_"):  # numba asks whether it is a type of its own
            raise AttributeError(name)
        self.queries.append(name)
        assert name in QUERIES, f"an algorithm used {name}"
        return getattr(self.__robot, name)


@pytest.mark.parametrize("turn", [-1, 1])
@pytest.mark.parametrize(
    "algorithm",
    [
        bug_base_walk,
        bug0_walk,
        lambda robot: bug1_walk(robot, True),
        bug2_walk,
        bug2_prelim_walk,
    ],
    ids=["bug_base", "bug0", "bug1", "bug2", "bug2_prelim"],
)
def test_algorithms_ask_a_contact_sensor_and_nothing_else(algorithm, turn):
    """With a Witness instead of the robot the walk is the same."""
    start, goal = np.array(ME145["start"], float), np.array(ME145["goal"], float)
    walls = make_walls(check_obstacles(ME145["obstacles"]), 0.0)
    robot, watched = new_robot(walls, start, goal, turn), new_robot(walls, start, goal, turn)
    witness = Witness(watched)
    assert algorithm(witness) == algorithm(robot)
    assert np.array_equal(corners_of(watched), corners_of(robot))
    assert watched.trail.counts.tolist() == robot.trail.counts.tolist()
    assert "move_to_goal" in witness.queries


@pytest.mark.parametrize("walk", [bug_base_walk, bug0_walk, bug1_walk, bug2_walk, bug2_prelim_walk])
def test_algorithms_hold_no_obstacles(walk):
    """Their code names the robot's questions, what a place tells, and how a walk can end: there is
    no other way to the world.
    """
    tells = {"distance", "on_line", "is_nearer_than", "x", "y"}
    code = inspect.unwrap(walk)
    assert set(code.__code__.co_names) <= QUERIES | tells | ENDINGS
    assert code.__closure__ is None


@pytest.mark.parametrize("name", sorted(BUGS))
def test_obstacles_never_touched_change_nothing(name):
    """The walk does not depend on obstacles that the robot does not touch."""
    plan = BUGS[name]((0, 0), (10, 0), [BOX], 0.3)
    far = BUGS[name](
        (0, 0), (10, 0), [BOX, [(0, 7), (9, 7), (4, 9)], [(4.5, 0), (5, 0.5), (5.5, 0)]], 0.3
    )
    assert np.array_equal(plan.walk.points, far.walk.points)


# ---- circles and closed rooms


def test_bug0_walks_in_a_circle_and_says_so():
    """In the spiral Bug 0 comes back to the same hit: no path, and the walk shows the loop once
    round. Bugs 1 and 2 arrive.
    """
    plan = ke.bug0((-2, 0), (6, 0), [SPIRAL], 0.5)
    assert plan.path is None and "circle" in plan.reason
    hits = plan.walk.hits.tolist()
    assert hits[-1] == hits[1] and len(hits) == 3
    loop = plan.walk.points[plan.walk.hit[1] :]
    assert loop[0].tolist() == loop[-1].tolist()
    turns = np.unwrap(np.arctan2(*(loop - [6.0, 0.0]).T))
    assert abs(turns[-1] - turns[0]) == pytest.approx(2.0 * math.pi)
    for name in COMPLETE:
        assert BUGS[name]((-2, 0), (6, 0), [SPIRAL], 0.5).path is not None


def test_a_circle_ends_where_a_wall_is_hit_again_along_the_same_line():
    """The robot hits the wall from the start, and again from a corner behind it on the same line:
    one point, found from two places, so the walk is recorded for one round.
    """
    hook = [(1, 0), (9, 0), (11, 4), (9, 10), (0, 6), (9, 8), (9, 4), (7, 3)]
    plan = ke.bug0((3, 3), (13, -7), [hook], 99)
    assert "circle" in plan.reason and plan.walk.leaves.tolist() == [[0.0, 6.0]]
    assert len(plan.walk.hits) == 2 and np.array_equal(*plan.walk.hits)


def test_bug2_leaves_a_wall_only_between_start_and_goal():
    """Behind the goal the wall meets their line too, nearer to the goal than the hit."""
    wall = [(8, -5), (9, -4), (6, 2), (5, -1), (1, 4)]
    plan = ke.bug2((0, 0), (5, 0), [wall], 99, turn="right")
    assert plan.path[[1, -2]] == pytest.approx(np.array([(37 / 9, 0), (4.2, 0)]))


def test_bug2_prelim_walks_in_a_circle_where_bug2_arrives():
    """Without its rule Bug 2 leaves farther from the goal than it hit, and comes back; with it, it
    arrives.
    """
    hook = [(4, -1), (5, -1), (5, 3), (-1, 3), (-1, -3), (0, -3), (0, 2), (4, 2)]
    assert circles(ke.bug2_prelim, hook) and not circles(ke.bug2, hook)


def circles(bug, polygon):
    """Whether a bug walks in a circle in one of the worlds with this obstacle, in either turn, from
    some start to some goal.
    """
    grid = [(x, y) for x in np.arange(-3.0, 9.0, 1.5) for y in (-4.0, -1.5, 0.5, 2.5, 5.0)]
    free = [q for q in grid if not shapely.Polygon(polygon).intersects(shapely.Point(q))]
    plans = [
        bug(a, b, [polygon], 9.0, turn=turn)
        for a in free
        for b in free
        for turn in ("left", "right")
    ]
    return any("circle" in plan.reason for plan in plans)


@pytest.mark.parametrize("name", sorted(BUGS))
@pytest.mark.parametrize("turn", ["left", "right"])
@pytest.mark.parametrize(
    ("start", "goal"),
    [((-3, 4), (4, 4)), ((4, 4), (12, 5)), ((3, 3), (6, 6))],
    ids=["in", "out", "inside"],
)
def test_rooms_between_obstacles(name, turn, start, goal):
    """Four overlapping bars close a room: no way in, no way out, and free within."""
    plan = BUGS[name](start, goal, RING, 0.5, turn=turn)
    assert (plan.path is not None) == (start == (3, 3))
    assert plan.walk.travelled[-1] < 200.0


def test_a_room_with_a_gap_is_entered():
    """The same room with one bar moved away by little."""
    room = [*RING[:3], [(7.001, 2.001), (9, 2.001), (9, 6.999), (7.001, 6.999)]]
    for name in COMPLETE:
        assert BUGS[name]((-3, 4), (4, 4), room, 0.5).path is not None


def test_a_goal_inside_an_obstacle_is_found_out_by_walking():
    """The robot has no map: Bug 1 and Bug 2 say that no path reaches it, Bug 0 that the wall lets
    it go nowhere.
    """
    for name, bug in BUGS.items():
        plan = bug((0, 0), (5, 0.5), [BOX], 0.5)
        assert plan.path is None and plan.walk.travelled[-1] >= 10.0, name


@pytest.mark.parametrize("turn", ["left", "right"])
def test_both_ways_back(turn):
    """Bug 1 goes back the shorter way or in the same direction; nothing else differs."""
    shorter = ke.bug1((0, 0), (10, 0), [BOX], 0.5, turn=turn)
    same = ke.bug1((0, 0), (10, 0), [BOX], 0.5, turn=turn, way_back="same")
    assert shorter.cost == 22.0
    assert same.cost == (24.0 if turn == "left" else 22.0)
    assert np.array_equal(shorter.walk.leaves, same.walk.leaves)


# ---- degenerate worlds


@pytest.mark.parametrize("name", sorted(BUGS))
@pytest.mark.parametrize("turn", ["left", "right"])
@pytest.mark.parametrize(
    ("obstacles", "touching"),
    [
        ([[(4, 0), (6, 2), (4, 4)]], "a corner"),
        ([[(4, 0), (6, 0), (5, 3)]], "an edge"),
        ([[(2, 0), (3, 0), (3, 1)], [(5, 0), (7, 0), (7, -3)]], "edges on both sides"),
        ([[(4, 0), (5, 1), (6, 0), (6, 3), (4, 3)]], "two corners of a notch"),
        ([[(3, 0), (4, 0), (5, 0), (6, 0), (5, 3)]], "straight corners"),
        ([[(5, 0), (8, 3), (7, 4)], [(5, 0), (3, 4), (2, 3)]], "a corner that obstacles share"),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_what_is_only_touched_stops_nobody(name, turn, obstacles, touching):
    """A straight way that touches a corner or slides along an edge is walked straight, without a
    hit.
    """
    plan = BUGS[name]((0, 0), (10, 0), obstacles, 100.0, turn=turn)
    assert plan.cost == 10.0 and len(plan.walk.hits) == 0


@pytest.mark.parametrize(("turn", "corner"), [("left", (6, 3)), ("right", (6, -2))])
def test_a_hit_at_a_corner(turn, corner):
    """A corner becomes the hit point, and the wall is followed from there."""
    diamond = [(4, 0), (6, -2), (8, 0), (6, 3)]
    plan = ke.bug2((0, 0), (10, 0), [diamond], 100.0, turn=turn)
    assert corners(plan) == [[0, 0], [4, 0], list(corner), [8, 0], [10, 0]]
    assert plan.walk.hits.tolist() == [[4, 0]] and plan.walk.leaves.tolist() == [[8, 0]]


def test_a_hit_at_the_end_of_an_edge_slid_along():
    """It slides along an edge into an inner corner: turned left it goes up the wall, turned right
    it goes back along the edge.
    """
    step = [(2, -1), (8, -1), (8, 2), (6, 2), (6, 0), (2, 0)]
    left, right = (ke.bug2((0, 0), (10, 0), [step], 100.0, turn=turn) for turn in ("left", "right"))
    assert left.walk.hits.tolist() == right.walk.hits.tolist() == [[6, 0]]
    assert corners(left) == [[0, 0], [6, 0], [6, 2], [8, 2], [8, 0], [10, 0]]
    assert (
        ke.bug0((0, 0), (10, 0), [step], 100.0, turn="right").path is not None
    )  # the edge behind is no way to the goal
    assert right.path is not None and right.cost == pytest.approx(6 + 4 + 1 + 6 + 1 + 2)


def test_the_way_between_touching_obstacles_is_shut():
    """Two triangles that touch at a point let nothing through, on the straight way or along the
    wall.
    """
    up, down = [(5, 0), (7, 3), (3, 3)], [(5, 0), (3, -2), (7, -2)]
    plan = ke.bug2((0, 0), (10, 0), [up, down], 100.0)
    assert corners(plan) == [[0, 0], [5, 0], [3, 3], [7, 3], [5, 0], [10, 0]]
    wall = [[(4, -9), (6, -9), (5, 0)], [(5, 0), (6, 9), (4, 9)]]
    for name in COMPLETE:
        assert BUGS[name]((0, 1), (10, -1), wall, 1.0).path is not None  # round the ends
        assert BUGS[name]((4, 1e-9), (10, 0), wall, 1.0).cost > 10.0


def on_edge_of_one(seed):
    """A triangle, a point exactly on one of its edges, and another triangle that meets it."""
    rng = np.random.default_rng(seed)
    first = np.array([(0.0, 0.0), (3.0, 0.0), (1.0, 2.0)])
    point = np.array([0.25, 0.5])  # on y = 2 x
    while True:
        other = rng.uniform(-1, 3, (3, 2))
        solid = shapely.Polygon(other)
        if solid.area > 0.2 and solid.distance(shapely.Point(point)) > 1e-3:
            return first, point, other


@pytest.mark.parametrize("seed", range(30))
def test_a_start_or_goal_on_a_wall_is_seen_where_obstacles_meet(seed):
    """The union of obstacles is rounded, the obstacles are not."""
    first, point, other = on_edge_of_one(seed)
    with pytest.raises(InvalidStart):
        ke.bug1(point, (-2, 1), [first, other], 100.0)
    with pytest.raises(InvalidGoal):
        ke.bug1((-2, 1), point, [first, other], 100.0)


@pytest.mark.parametrize("unit", [1.0, 0.1, 1.0 / 3.0])
@pytest.mark.parametrize("name", COMPLETE)
def test_a_goal_where_two_obstacles_meet(name, unit):
    """At a corner of their union it is on a wall, on an edge that both share it is inside."""
    left, right = [(1, 3), (3, 3), (3, 7), (1, 7)], [(3, 3), (5, 3), (5, 7), (3, 7)]
    upper, tip = [(1, 7), (4, 7), (4, 9), (1, 9)], [(3, 7), (4, 9), (2, 9)]
    for pair, goal in (((left, right), (3, 7)), ((left, upper), (1, 7)), ((left, tip), (3, 7))):
        obstacles = [unit * np.array(ring) for ring in pair]
        with pytest.raises(InvalidGoal):
            BUGS[name]((9 * unit, unit), unit * np.array(goal), obstacles, 1.0)
    inside = unit * np.array((3, 4)), unit * np.array([left, right])
    assert BUGS[name]((9 * unit, unit), *inside, 1.0).path is None


@pytest.mark.parametrize("offset", [0.0, 5e6, -(2.0**30)])
def test_walls_far_from_the_origin_are_as_exact_as_their_floats(offset):
    """Obstacles that overlap keep their corners; a start a few digits off a wall is free."""
    first, other = (
        np.array(ring) + offset
        for ring in (
            [(1, -1), (2, -1), (2, 2.3), (1, 2.3)],
            [(1.5, -1), (3, -1), (3, 1.1), (1.5, 1.1)],
        )
    )
    digit = np.spacing(abs(offset) + 3.0)
    walls, corners = make_walls([first, other], 0.0), [*first[[0, 2, 3]], *other[1:3]]
    for corner in corners:
        assert np.abs(walls.points - corner).max(axis=1).min() <= digit + 2.0**-42
    above = np.array([offset + 1.5, first[2, 1] + 64 * digit])
    assert ke.bug1(above, (offset + 8, offset + 2.5), [first, other], 100.0).path is not None


def test_a_record_that_is_full_is_refused_with_what_to_change():
    """Places run out where rounding has changed their order, a trail where obstacles are huge."""
    full, at = empty_places(0, 0), np.zeros(2)
    with pytest.raises(InvalidWorld, match=r"closer together than floats.*move them apart"):
        add_place(full, at, (True, True), (-1, 0.0), GIVEN, (at, at, at, at))
    trail = new_trail(0, 1)
    append(trail, full, 0, False)
    with pytest.raises(InvalidWorld, match="ten million corners; give obstacles with fewer"):
        append(trail, full, 0, False)


def test_obstacles_that_share_a_hit_point():
    """Three obstacles that meet at the hit point form one wall."""
    fan = [[(5, 0), (8, -4), (8, -2)], [(5, 0), (8, -1), (8, 1)], [(5, 0), (8, 2), (8, 4)]]
    for name in BUGS:
        plan = BUGS[name]((0, 0), (12, 0), fan, 1.0)
        assert plan.walk.hits[0].tolist() == [5, 0]
        assert plan.path is not None
    for sense, turn in ((1, "left"), (-1, "right")):
        for obstacles in (
            fan,
            fan[::-1],
            [fan[1], fan[0], fan[2]],
        ):  # the notches between them are not where it came from
            plan = ke.bug2((0, 0), (12, 0), obstacles, 100.0, turn=turn)
            beyond = [[8, 4 * sense], [8, 2 * sense], [5, 0], [8, sense], [8, 0], [12, 0]]
            assert corners(plan) == [[0, 0], [5, 0], *beyond]


def test_start_and_goal_in_one_place_or_in_the_open():
    """The walk is empty or a straight line."""
    assert ke.bug1((1, 1), (1, 1), [BOX], 0.5).cost == 0.0
    assert ke.bug2((0, 0), (3, 4), [], 10.0).path.tolist() == [[0, 0], [3, 4]]


@pytest.mark.parametrize("name", COMPLETE)
def test_a_corner_cut_off_by_less_than_rounding(name):
    """The start-goal line enters and leaves a tip within rounding: the comparison of distances is
    exact and tells them apart.
    """
    tip = [
        (-3.062601955837688, 5.5335765342226155),
        (-0.3549764264716564, 8.477853014569751),
        (3.8247873430679435, 10.068316730233871),
    ]
    tip += [(-4.653065671501808, 9.713340303762214), (-2.4448583112414557, 7.682621156737691)]
    start, goal = (1.7940681960434195, 7.860109369973519), (4.501693725409451, 10.804385850320655)
    for turn in ("left", "right"):
        assert BUGS[name](start, goal, [tip], 1.0, turn=turn).path is not None


NUMBERS = st.integers(-40, 40).map(float) | st.floats(-1e3, 1e3) | st.floats(-1e140, 1e140)


def make_place(found, numbers):
    """A place found in this way; its distance is rounded to nothing."""
    return Place(numbers[0], numbers[1], 1.0, False, False, 0, 0.0, found, tuple(numbers[2:10]))


def squared_distance(place):
    """The squared distance from a place to the goal, by Python's fractions."""
    x, y, gx, gy, ax, ay, bx, by, ox, oy = map(Fraction, (place.x, place.y, *place.points))
    ux, uy = bx - ax, by - ay
    high = ux * (gy - ay) - uy * (gx - ax)
    if place.found == GIVEN:
        return (x - gx) ** 2 + (y - gy) ** 2
    if place.found == FOOT:
        return high**2 / (ux**2 + uy**2)
    other = ux * (oy - ay) - uy * (ox - ax)
    return (high / (high - other)) ** 2 * ((gx - ox) ** 2 + (gy - oy) ** 2)


@LAW
@given(
    st.lists(NUMBERS, min_size=20, max_size=20),
    st.tuples(*2 * [st.sampled_from([GIVEN, FOOT, CROSSING])]),
    st.booleans(),
)
def test_nearer_is_decided_without_rounding(numbers, found, tied):
    """The sign is that of fractions, where the places are equally far too, or within rounding."""
    p, q = make_place(found[0], numbers[:10]), make_place(found[1], numbers[10:])
    if tied:  # mirrored in the diagonal
        swapped = [number for k in range(0, 10, 2) for number in (numbers[k + 1], numbers[k])]
        q = make_place(found[0], swapped)
        q = q._replace(x=math.nextafter(q.x, math.inf)) if numbers[11] > 0.0 else q
    try:
        apart = squared_distance(p) - squared_distance(q)
    except ZeroDivisionError:
        return
    assert compare_distances(p, q) == (apart > 0) - (apart < 0)


# ---- clearance


@LAW
@given(scattered(), bug_names, turns, st.floats(0.01, 0.8))
def test_clearance_is_kept(world, name, turn, clearance):
    """Never closer than the clearance; along walls never farther than a thousandth more, where
    walls do not meet.
    """
    start, goal, polygons = world
    solid = shapely.union_all([shapely.Polygon(polygon) for polygon in polygons])
    assume(all(solid.distance(shapely.Point(end)) > 1.01 * clearance for end in (start, goal)))
    plan = BUGS[name](start, goal, polygons, 0.5, turn=turn, clearance=clearance)
    assert shapely.LineString(plan.walk.points).distance(solid) >= clearance * (1.0 - 1e-9)
    followed = [
        solid.distance(shapely.Point(point)) for point in plan.walk.points[plan.walk.following]
    ]
    assert max(followed, default=0.0) <= 1.001 * clearance
    grown = solid.buffer(1.0011 * clearance, quad_segs=64)
    parts = shapely.get_parts(shapely.box(-30, -30, 50, 50).difference(grown))
    joined = any(
        part.contains(shapely.Point(start)) and part.contains(shapely.Point(goal)) for part in parts
    )
    assert plan.path is not None or not joined or name not in COMPLETE


def test_clearance_round_a_box():
    """Bug 1 walks the box's edges and a circle, to a thousandth of the circle."""
    plan = ke.bug1((0, 0), (10, 0), [BOX], 0.5, clearance=0.5, way_back="same")
    follow = np.diff(plan.walk.travelled)[plan.walk.following[1:]].sum()
    round_once = 10.0 + math.pi
    back = (
        plan.walk.travelled[plan.walk.leave][0] - plan.walk.travelled[plan.walk.hit][0] - round_once
    )
    assert follow == pytest.approx(round_once + back, rel=1e-12)
    assert back == pytest.approx(2.0 + 2.0 + 2.0 + 0.5 * math.pi, rel=1e-3)


# ---- what is refused


@pytest.mark.parametrize("name", [*sorted(BUGS), "bug_base"])
def test_what_is_refused(name):
    """Each wrong argument raises its own error."""
    bug = {**BUGS, "bug_base": ke.bug_base}[name]
    refused = [
        (InvalidStart, ((5, 0), (10, 0), [BOX], 1.0), {}),
        (InvalidStart, ((4, 0), (10, 0), [BOX], 1.0), {}),
        (InvalidStart, ((3.9, 0), (10, 0), [BOX], 1.0), {"clearance": 0.2}),
        (InvalidGoal, ((0, 0), (6, 0), [BOX], 1.0), {}),
        (InvalidPoint, ((0, 0, 0), (10, 0), [BOX], 1.0), {}),
        (InvalidPoint, ((0, math.nan), (10, 0), [BOX], 1.0), {}),
        (InvalidPolygon, ((0, 0), (10, 0), [BOX, [(0, 0), (1, 1)]], 1.0), {}),
        (InvalidParameter, ((0, 0), (10, 0), 7, 1.0), {}),
        (InvalidParameter, ((0, 0), (10, 0), "box", 1.0), {}),
        (InvalidParameter, ((0, 0), (10, 0), [BOX], 0.0), {}),
        (InvalidParameter, ((0, 0), (10, 0), [BOX], math.inf), {}),
        (InvalidParameter, ((0, 0), (10, 0), [BOX], 1e-9), {}),
        (InvalidParameter, ((0, 0), (10, 0), [BOX], 1e-320), {}),
        (InvalidParameter, ((0, 0), (10, 0), [BOX], 1.0), {"turn": "up"}),
        (InvalidParameter, ((0, 0), (10, 0), [BOX], 1.0), {"turn": None}),
        (InvalidParameter, ((0, 0), (10, 0), [BOX], 1.0), {"clearance": -0.1}),
        (InvalidParameter, ((0, 0), (10, 0), [BOX], 1.0), {"clearance": math.nan}),
    ]
    for error, args, options in refused:
        with pytest.raises(error):
            bug(*args, **options)


def test_messages_name_what_is_wrong():
    """A message says what was expected, what was given, and for which obstacle."""
    with pytest.raises(InvalidParameter, match="way_back must be 'shorter' or 'same', got 'long'"):
        ke.bug1((0, 0), (10, 0), [BOX], 1.0, way_back="long")
    with pytest.raises(InvalidPolygon, match="obstacle 1"):
        ke.bug1((0, 0), (10, 0), [BOX, [(0, 0), (1, 1)]], 1.0)
    with pytest.raises(InvalidStart, match=r"closer than 0\.2"):
        ke.bug2((3.9, 0), (10, 0), [BOX], 1.0, clearance=0.2)


def test_contact_knows_rooms():
    """Inside an obstacle, on its wall, in the room that obstacles close, outside."""
    walls = make_walls(check_obstacles(RING), 0.0)
    places = [(1, 4), (2, 4), (4, 4), (20, 4)]
    assert [contact(walls, np.array(q, float)) for q in places] == [1, 0, -1, -1]


# ---- figures


def texts(ax):
    """The labels in a figure."""
    return {text.get_text() for text in ax.texts} - {""}


@pytest.mark.parametrize("clearance", [0.0, 0.3])
def test_a_walk_is_drawn_with_its_marks(clearance):
    """draw_plan shows the walk, hits and leaves by name, start and goal; up to a point only what
    had happened by then.
    """
    from matplotlib import pyplot as plt

    plan = ke.bug1(ME145["start"], ME145["goal"], ME145["obstacles"], 0.1, clearance=clearance)
    ke.figures.draw_plan(plan)
    assert texts(plt.gca()) == {"start", "goal", "H1", "H2", "L1", "L2"}
    assert "length" in plt.gca().get_title() and "2 hits" in plt.gca().get_title()
    plt.close()
    ke.figures.draw_plan(plan, upto=int(plan.walk.hit[0]) + 3)
    assert texts(plt.gca()) == {"start", "goal", "H1"}
    assert f"of {len(plan.walk.points)} points" in plt.gca().get_title()
    plt.close()


def test_the_distance_to_the_goal_is_plotted():
    """The curve holds the walk's own numbers; a plan without a walk is refused."""
    from matplotlib import pyplot as plt

    plan = ke.bug2(ME145["start"], ME145["goal"], ME145["obstacles"], 0.1)
    ke.figures.draw_distance_to_goal(plan)
    lines = np.concatenate(
        [line for collection in plt.gca().collections for line in collection.get_segments()]
    )
    curve = np.column_stack([plan.walk.travelled, plan.walk.distance_to_goal])
    assert {tuple(point) for point in lines.tolist()} == {tuple(point) for point in curve.tolist()}
    assert texts(plt.gca()) == {"H1", "H2", "L1", "L2"}
    plt.close()
    with pytest.raises(TypeError, match="no walk"):
        ke.figures.draw_distance_to_goal(ke.Plan(None, math.inf))


def test_a_flowcharts_words_fit_into_its_steps():
    """In a figure of its own and in given axes; every step's words lie within its shape, and no two
    words over one another.
    """
    from matplotlib import pyplot as plt

    _, ax = plt.subplots()
    assert {artist.axes for artist in ke.figures.draw_bug_base_flowchart(ax)} == {ax}
    plt.close()
    ke.figures.draw_bug_base_flowchart()
    ax = plt.gca()
    plt.gcf().canvas.draw()
    boxes = [text.get_window_extent() for text in ax.texts if text.get_text()]
    shapes = [patch.get_window_extent() for patch in ax.patches]
    for shape in shapes:
        assert any(
            shape.x0 < box.x0 and box.x1 < shape.x1 and shape.y0 < box.y0 and box.y1 < shape.y1
            for box in boxes
        )
    assert not any(a.overlaps(b) for i, a in enumerate(boxes) for b in boxes[:i])
    plt.close()


def test_a_failed_walk_is_saved_as_a_picture(tmp_path):
    """A walk in a circle, and a walk in a world without obstacles, make files."""
    for plan in (ke.bug0((-2, 0), (6, 0), [SPIRAL], 0.5), ke.bug0((0, 0), (0, 0), [], 0.5)):
        ke.figures.save_plan(plan, tmp_path / "walk.png")
        assert (tmp_path / "walk.png").stat().st_size > 1000


@pytest.mark.parametrize("name", ["walk", "walk.xyz"])
def test_a_picture_of_another_ending_is_refused_by_name(tmp_path, name):
    """The message names the file and the endings, and nothing is left in the folder."""
    plan = ke.bug0((0, 0), (0, 0), [], 0.5)
    with pytest.raises(UnknownFormat, match=rf"{name}: a picture ends in \.png, \.svg or \.pdf"):
        ke.figures.save_plan(plan, tmp_path / name)
    assert list(tmp_path.iterdir()) == []

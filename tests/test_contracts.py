"""Checks of planners, robots and worlds: the library passes, and each kind of mistake is found."""

import statistics
import time
from collections import defaultdict
from functools import partial
from typing import NamedTuple

import broken_planners
import numpy as np
import pytest
from broken_planners import BANK, good

import kinoedu as ke
from kinoedu.collision.interface import is_free_path, is_semi_free_path
from kinoedu.contracts import Trap, check_planner, check_robot, check_world, traps_for
from kinoedu.errors import KinoeduError
from kinoedu.planners.registry import PLANNERS
from kinoedu.problems.configurations import space_of
from kinoedu.robots.round import RoundRobot
from kinoedu.spaces.interface import distance, interpolate, sample
from kinoedu.worlds.polygon_world import PolygonWorldRecord

SHORT = {
    "rrt": {"max_nodes": 400, "max_iterations": 800},
    "rrt_connect": {"max_nodes": 400, "max_iterations": 400},
    "rrt_star": {"max_nodes": 100, "max_iterations": 300},
    "informed_rrt_star": {"max_nodes": 100, "max_iterations": 300},
    "prm": {"n": 60},
    "prm_star": {"n": 60},
    "kinodynamic_rrt": {"max_iterations": 12},
    "kinodynamic_prm": {"n": 10},
    "sst": {"max_iterations": 60},
    "hybrid_astar": {"max_nodes": 300},
    "receding_horizon": {"max_moves": 2, "rays": 30},
}
CAR = ke.Car(1.0, 0.5, 0.6)
BAR = ke.RigidPolygon([(-0.4, -0.1), (0.4, -0.1), (0.4, 0.1), (-0.4, 0.1)])
LONG = defaultdict(set, cells_with_headings={"many obstacles"})  # traps that take it long
TOUCHING = {"visibility"}  # whose shortest paths are semi-free
MAY_MISS = {"kinodynamic_rrt", "kinodynamic_prm", "sst", "receding_horizon"}  # in so few iterations


def robot_for(planner):
    """The robot whose traps a planner is for."""
    if planner.name == "cells_with_headings":
        return BAR
    return CAR if planner.robots == ("car",) else None


@pytest.mark.parametrize("planner", PLANNERS.values(), ids=PLANNERS)
def test_a_planner_of_the_library_keeps_its_promises(planner):
    """All of them in all traps; those of drives may miss a path in a short run."""
    short = partial(planner.function, **SHORT.get(planner.name, {}))
    traps = [trap for trap in traps_for(robot_for(planner)) if trap.name not in LONG[planner.name]]
    report = check_planner(short, robot=robot_for(planner), traps=traps, seconds=20.0)
    allowed = {"finds"} if planner.name in MAY_MISS else set()
    assert set(report.broken) <= allowed, report
    assert bool([note for note in report.notes if "touch" in note]) == (planner.name in TOUCHING)
    assert report["free"].tried > 0 or planner.name in MAY_MISS


@pytest.mark.parametrize("planner", BANK, ids=lambda planner: planner.__name__)
def test_a_mistake_is_found(planner):
    """By the promise that it breaks, with a trap and what happened there."""
    broken_planners.MEMORY.clear()
    report = check_planner(planner, seconds=0.5)
    assert BANK[planner] in report.broken, report
    finding = report[BANK[planner]]
    assert all(": " in case for case in finding.where)
    assert f"broken  {finding.promise}" in repr(report) and not report.passed


def test_the_planner_without_a_mistake_passes():
    """So every mistake of the bank is found for its own sake."""
    report = check_planner(good)
    assert report.passed and report.broken == (), report
    assert "a narrow door" in [run.trap.name for run in report.runs]
    assert all(run.trap.solvable for run in report.runs if run.found)
    assert repr(report).startswith("good: 10 of 10 promises kept\n  kept    It returns")


def test_every_trap_is_what_it_says():
    """Solvable ones are solved; in others there is no path for a planner that is exact."""
    for trap in traps_for():
        problem = trap.problem
        if trap.solvable:
            assert ke.rrt_connect(problem, rng=0, max_nodes=4000).path is not None, trap.name
        elif isinstance(problem.world, PolygonWorldRecord) and problem.is_free(problem.start):
            grown = problem._replace(clearance=0.0, robot=ke.Point())
            reach = problem.clearance + problem.robot.radius
            assert reach > 0.4 or ke.plan_by_decomposition(grown).path is None, trap.name
    for robot in (ke.Disk(0.3), BAR):
        for trap in traps_for(robot):
            plan = ke.rrt_connect(trap.problem, rng=0, max_nodes=1000 if trap.solvable else 50)
            assert (plan.path is not None) == trap.solvable, (robot, trap.name)


def test_a_record_of_every_run_can_be_inspected_and_drawn():
    """The plan of each trap, judged in its own problem."""
    report = check_planner(broken_planners.straight)
    run = next(run for run in report.runs if run.trap.name == "a thin wall")
    assert run.plan.problem.start.tolist() == [2.0, 5.0] and run.faults.wrong == (0,)
    assert ke.figures.draw_plan(run.plan)
    assert report.found == ("an empty room", "a start at the goal")


def test_a_refusal_is_a_note_and_breaks_nothing():
    """An exact planner says which problems it is not for."""
    report = check_planner(ke.plan_by_decomposition)
    assert report.passed
    (note,) = [note for note in report.notes if "refuses" in note and "disc" in note]
    assert "moves a point without clearance" in note


def test_traps_of_ones_own():
    """Any problems: here an arm's."""
    world = ke.PolygonWorld([(-9, -9), (9, -9), (9, 9), (-9, 9)], [[(3, 3), (4, 3), (4, 4)]])
    arm = ke.Problem(ke.TwoLinkArm(3, 2, 0.2), world, (0.0, 0.0), (3.0, 0.0))
    traps = [Trap("an arm", arm, solvable=True, must_find=True)]
    assert check_planner(partial(ke.rrt, max_nodes=500), traps=traps).passed
    assert check_planner(broken_planners.straight, traps=traps).broken == ("free", "finds")


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        (lambda: check_planner(3), "needs a function"),
        (lambda: check_planner(good, traps=[]), "traps must be a list of Trap"),
        (lambda: check_planner(good, traps=[3]), "traps must be a list of Trap"),
        (lambda: check_planner(good, traps=[Trap("none", None, False)]), "must be a Problem, got"),
        (lambda: check_planner(good, seconds=0), "seconds must be a positive"),
        (lambda: check_planner(good, seed=-1), "seed must be a whole number"),
        (lambda: check_planner(good, robot=ke.TwoLinkArm(3, 2, 0.2)), "there are traps for"),
        (lambda: check_planner(good, robot="car"), "there are traps for"),
        (lambda: check_robot(ke.Point(), motions=0), "motions must be a whole number"),
        (lambda: check_robot(ke.Point(), 5), "expected a world such as"),
        (lambda: check_robot(ke.Point(), ke.MovingWorld(ARM_ROOM, [])), "in a MovingWorld"),
        (lambda: check_world(ke.MovingWorld(ARM_ROOM, [])), "in a MovingWorld"),
    ],
)
def test_wrong_arguments_raise_named_errors(wrong, words):
    """With what was expected."""
    with pytest.raises(KinoeduError, match=words):
        wrong()


def test_a_check_leaves_random_numbers_alone():
    """Whatever the planner does with them."""
    np.random.seed(5)
    expected = np.random.random()
    np.random.seed(5)
    check_planner(broken_planners.never)
    assert np.random.random() == expected


ARM_ROOM = ke.PolygonWorld([(-9, -9), (9, -9), (9, 9), (-9, 9)], [[(3, 3), (4, 3), (4, 4)]])
ROBOTS = {
    "point": (ke.Point(), None),
    "disk": (ke.Disk(1.0), None),
    "translating": (ke.TranslatingPolygon([(0, 0), (1, 0), (0, 1)]), None),
    "turning": (BAR, None),
    "car": (CAR, None),
    "forward car": (ke.Car(1.0, 0.5, 0.6, speeds=(0.5, 1.0)), None),
    "arm": (ke.TwoLinkArm(3, 2, 0.2), ARM_ROOM),
}


@pytest.mark.parametrize("name", ROBOTS)
def test_a_robot_of_the_library_keeps_its_promises(name):
    """All of them, and some motions are free."""
    robot, world = ROBOTS[name]
    report = check_robot(robot, world, motions=60)
    assert report.passed, report
    assert report["between"].tried > 0


@pytest.mark.parametrize(
    "world",
    [
        ke.Terrain([[1, 1, 0, 1], [1, 0, 1, 1], [1, 1, 1, 1]], resolution=0.5, origin=(3, 4)),
        ke.Terrain([[1, 1, 1]], cost=[[1, 5, 1]]),
        ke.PolygonWorld([(0, 0), (9, 0), (9, 9), (5, 3), (0, 9)], [((3, 3), 1.0)]),
    ],
    ids=["terrain", "costs", "polygons"],
)
def test_a_world_of_the_library_keeps_its_promises(world):
    """All of them, for a point and a disc."""
    for robot in (ke.Point(), ke.Disk(0.1)):
        report = check_world(world, robot, motions=60)
        assert report.passed, report


class Ball(NamedTuple):
    """A robot of one's own, whose `mistake` selects what is wrong with it."""

    radius: float
    mistake: str = ""


class Boxed(NamedTuple):
    """Its space."""

    lo: np.ndarray
    hi: np.ndarray
    mistake: str


QUESTIONS = []


@space_of.register
def _(robot: Ball, world):
    return Boxed(world.lo, world.hi, robot.mistake)


@sample.register(Boxed)
def draw(space, rng):
    """One mistake: samples beside the box."""
    scale = 1.5 if space.mistake == "sample" else 1.0
    return space.lo + scale * (space.hi - space.lo) * rng.random(2)


@distance.register(Boxed)
def far(space, a, b):
    """Mistakes: squared, one way longer than the other, never zero."""
    d = float(np.sqrt(((a - b) ** 2).sum()))
    if space.mistake == "squared":
        return d * d
    if space.mistake == "uphill":
        return d + max(0.0, b[1] - a[1])
    return d + 1.0 if space.mistake == "never zero" else d


@interpolate.register(Boxed)
def go(space, a, b, t):
    """Mistakes: too far, in place."""
    if space.mistake == "in place":
        a += t * (b - a)
        return a
    return a + (np.sqrt(t) if space.mistake == "too far" else t) * (b - a)


@is_free_path.register(Ball, PolygonWorldRecord)
def roll(robot, world, a, b, clearance):
    """The right answer, and ten wrong ones."""
    QUESTIONS.append(1)
    disc, mistake = RoundRobot(robot.radius), robot.mistake
    free = is_free_path(disc, world, a, b, clearance)
    if mistake == "ends only":
        return all(is_free_path(disc, world, q, q, clearance) for q in (a, b))
    if mistake == "first end":
        return is_free_path(disc, world, a, a, clearance)
    if mistake == "without clearance":
        return is_free_path(disc, world, a, b, 0.0)
    if mistake == "clearance the wrong way":
        return is_free_path(RoundRobot(max(2.0 - clearance, 0.1)), world, a, b, 0.0)
    if mistake == "moody":
        return free and len(QUESTIONS) % 3 > 0
    if mistake == "words":
        return "yes" if free else "no"
    if mistake == "none":
        return None if not free else True
    if mistake == "everywhere":
        return True
    if mistake == "timid":
        return free and float(((a - b) ** 2).sum()) < 1.0
    if mistake == "moves":
        a += 1e-9
    if mistake == "raises":
        return 1 / 0
    return free


@is_semi_free_path.register(Ball, PolygonWorldRecord)
def slide(robot, world, a, b, clearance):
    """One mistake: what is free is not free in contact."""
    disc = RoundRobot(robot.radius)
    return robot.mistake != "no contact" and is_semi_free_path(disc, world, a, b, clearance)


BROKEN_ROBOTS = {
    "sample": "space",
    "squared": "distance",
    "uphill": "both_ways",
    "never zero": "distance",
    "too far": "steer",
    "in place": "unchanged",
    "ends only": "between",
    "first end": "both_ways",
    "without clearance": "clearance",
    "clearance the wrong way": "clearance",
    "moody": "same",
    "words": "answers",
    "none": "answers",
    "everywhere": "outside",
    "timid": "halves",
    "moves": "unchanged",
    "raises": "answers",
    "no contact": "contact",
}


@pytest.mark.parametrize("mistake", BROKEN_ROBOTS)
def test_a_mistake_of_a_robot_is_found(mistake):
    """By the promise that it breaks."""
    report = check_robot(Ball(0.5, mistake), motions=80)
    assert BROKEN_ROBOTS[mistake] in report.broken, report


def test_a_motion_without_an_answer_breaks_one_promise():
    """An error is listed once, not under each promise."""
    report = check_robot(Ball(0.3, "raises"), motions=5)
    assert report.broken == ("answers",)
    assert report["between"].tried == 0
    assert "5 motions without an answer" in report.notes[-1]


def test_an_error_of_python_is_shown_with_the_readers_own_line():
    """The line in the standard library helps nobody."""

    def mean_of_nothing(problem):
        return statistics.mean([])

    first = check_planner(mean_of_nothing)["errors"].where[0]
    assert "return statistics.mean([])" in first


def test_a_second_run_that_fails_is_not_another_path():
    """The report says how the second run ended."""
    problems = []

    def tires(problem):
        problems.append(problem)
        if len(problems) > 1:
            raise RuntimeError("tired")
        return [problem.start, problem.goal]

    trap, *_ = [trap for trap in traps_for(ke.Point()) if trap.must_find]
    text = check_planner(tires, traps=[trap])["same"].where[0]
    assert "RuntimeError: tired" in text and "another path" not in text


def test_a_planner_that_waits_is_told_for_how_long():
    """It computed for no time: both times are listed."""
    report = check_planner(lambda problem: time.sleep(60.0), seconds=0.02)
    assert "of which it computed for 0.0 s" in report["time"].where[0]


def test_a_right_robot_of_ones_own_passes():
    """And plans, with a space of its own."""
    assert check_robot(Ball(0.5), motions=80).passed
    world = ke.PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(3, 0), (6, 0), (6, 4), (3, 4)]])
    assert ke.rrt(ke.Problem(Ball(0.5), world, (1, 1), (8, 1)), rng=0).path is not None


class Hall(NamedTuple):
    """A world of one's own."""

    lo: np.ndarray
    hi: np.ndarray


@is_free_path.register(RoundRobot, Hall)
def walk(robot, world, a, b, clearance):
    """Free within its walls."""
    r = robot.radius + clearance
    return bool(all((world.lo + r < q).all() and (q < world.hi - r).all() for q in (a, b)))


class Thing:
    """No record."""

    lo, hi = np.zeros(2), np.ones(2)


@pytest.mark.parametrize(
    ("world", "name"),
    [
        (Hall(np.zeros(2), np.array([4.0, 3.0])), ""),
        (Hall(np.ones(2), np.zeros(2)), "corners"),
        (Hall((0.0, 0.0), (1.0, 1.0)), "corners"),
        (Hall(np.zeros(3), np.ones(3)), "corners"),
        (Hall(np.zeros(2), np.array([1.0, np.inf])), "corners"),
        (Thing(), "record"),
        (3, "corners"),
    ],
)
def test_a_world_of_ones_own(world, name):
    """Its corners and its motions."""
    report = check_world(world, motions=40)
    assert (name in report.broken) if name else report.passed, report


def test_what_is_no_robot_is_said():
    """Without a traceback: the check is for beginners."""
    report = check_robot("robot")
    assert set(report.broken) == {"record", "space"}
    assert "@space_of.register" in report["space"].where[0]

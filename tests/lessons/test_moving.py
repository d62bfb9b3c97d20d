"""Lesson 14: its exercises and boards against independent computations."""

import math

import numpy as np
import pytest

from kinoedu import Disk, Moving, MovingWorld, Point, PolygonWorld, TimedProblem, UncertainWorld
from kinoedu.boards import chance_board, moving_board
from kinoedu.boards.moving.chances import SHOWN
from kinoedu.boards.moving.moving import STEPS, waiting_time, waits_at
from kinoedu.course.lessons.moving import (
    collision_probability,
    earliest_arrival,
    exposing_motions,
    first_contact,
)
from kinoedu.errors import InvalidParameter

HALL = PolygonWorld([(0, 0), (10, 0), (10, 6), (0, 6)], [[(4, 0), (5, 0), (5, 2), (4, 2)]])
WORLD = MovingWorld(HALL, [Moving(1.0, [0, 10], [(9, 3), (-1, 3)])])


def test_the_first_contact_is_where_dense_sampling_sees_it():
    """Samples before the contact are apart; at the contact the distance is the radius."""
    for case in first_contact.FirstContact().cases(np.random.default_rng(1)):
        p0, p1, c0, c1, r = case.given.values()
        x, v = p0 - c0, (p1 - p0) - (c1 - c0)
        nearest = np.clip(
            -(x @ v) / max(v @ v, 1e-300), 0, 1
        )  # a contact may be too short for any sampling
        s = np.sort(np.append(np.linspace(0, 1, 4001), nearest))
        gaps = np.hypot(*(x + s[:, None] * v).T) - r
        moment = first_contact.find_contact(*case.given.values())
        touched = np.flatnonzero(gaps <= 0)
        assert (len(touched) == 0) == (moment == math.inf)
        assert moment == math.inf or abs(s[touched[0]] - moment) < 1e-3


PARTS = (0.25, 2, 16, 120, 128)  # ticks in a unit of time; all times of a case fit one of them


def stepped(safe, moves, start, goal):
    """Return the earliest arrival by stepping through all ticks."""
    ways = earliest_arrival.find_adjacent_places(moves)
    times = [t for own in safe for row in own for t in row] + [d for _, _, d in moves]
    ticks = next(n for n in PARTS if all(abs(n * t - round(n * t)) < 1e-9 for t in times))
    interval = [
        {
            t: k
            for k, (b, e) in enumerate(own)
            for t in range(round(ticks * b), round(ticks * e) + 1)
        }
        for own in safe
    ]
    at = [set() for _ in range(round(ticks * (max(times) + 5)))]
    if 0 in interval[start]:
        at[0].add(start)
    for t, here in enumerate(at):
        if goal in here:
            return t / ticks
        for u in here:
            if t in interval[u] and interval[u].get(t + 1, -1) == interval[u][t]:
                at[t + 1].add(u)
            for v, d in ways.get(u, []):
                if t + round(ticks * d) in interval[v]:
                    at[t + round(ticks * d)].add(v)
    return math.inf


@pytest.mark.parametrize("seed", range(3))
def test_schedules_are_the_earliest(seed):
    """Schedules keep every rule and arrive as early as a search by time steps finds.

    Each case is of the kind that it states.
    """
    for case in earliest_arrival.EarliestArrival().cases(np.random.default_rng(seed)):
        given = (
            [np.asarray(own).tolist() for own in case.given["safe"]],
            *list(case.given.values())[1:],
        )
        rows = earliest_arrival.find_schedule(*given)
        assert (rows[-1][1] if rows else math.inf) == pytest.approx(stepped(*given))
        if rows:
            assert earliest_arrival.find_schedule_fault(*given, rows) == ""
        assert (case.kind == "none") == (not rows)
        if case.kind == "aside":
            assert len({place for place, _ in rows}) < len(rows)
        if case.kind == "again":
            assert earliest_arrival.search_one_arrival_each(*given) > rows[-1][1]


def test_a_schedule_that_breaks_a_rule_is_told_which():
    """A schedule that breaks one rule, and none before it, gets that rule."""
    safe, moves = [[(0, 30)], [(0, 3), (6, 30)], [(0, 1), (7, 30)]], [(0, 1, 2), (1, 2, 2)]
    for rule, rows in (
        ("", [(0, 0), (1, 6), (2, 8)]),
        ("start", [(0, 1), (1, 6), (2, 8)]),
        ("own_row", [(0, 0), (0, 4), (1, 6), (2, 8)]),
        ("move", [(0, 0), (2, 8)]),
        ("too_fast", [(0, 0), (1, 1), (2, 8)]),
        ("wait", [(0, 0), (1, 2), (2, 7)]),
        ("unsafe", [(0, 0), (1, 4), (2, 8)]),
        ("goal", [(0, 0), (1, 6)]),
    ):
        assert earliest_arrival.find_schedule_fault(safe, moves, 0, 2, rows) == rule
    assert (
        earliest_arrival.find_schedule_fault(
            [[(2, 30)], *safe[1:]], moves, 0, 2, [(0, 0), (1, 6), (2, 8)]
        )
        == "begin"
    )


def test_a_rule_that_was_misread_is_named():
    """A misread rule is recognised by the arrival it leads to; otherwise none is named."""
    touching = [[(0, 4), (7, 30)], [(0, 30)], [(0, 1), (10, 30)]], [(0, 1, 2), (0, 2, 1)]
    assert (
        earliest_arrival.find_misread_rule(*touching, 0, 2, [(0, 0), (1, 2), (0, 7), (2, 10)])
        == "closed"
    )
    short = [[(0, 30)], [(0, 3), (6, 30)]], [(0, 1, 2)]
    assert earliest_arrival.find_misread_rule(*short, 0, 1, [(0, 0), (1, 6)]) == "forever"
    assert (
        earliest_arrival.find_misread_rule(*short, 0, 1, [(0, 0), (1, 7)])
        == earliest_arrival.find_misread_rule(*short, 0, 1, [])
        == ""
    )


def test_scenario_cases_are_clear_of_touching():
    """No case is decided by rounding, and the example is as stated; contact is exact."""
    for case in collision_probability.CollisionProbability().cases(np.random.default_rng(0)):
        gaps = collision_probability.measure_gaps(*case.given.values())
        assert np.abs(gaps[gaps != 0.0]).min() > collision_probability.CLEAR
    first = next(collision_probability.CollisionProbability().cases(np.random.default_rng(0)))
    assert collision_probability.estimate_probability(*first.given.values()) == pytest.approx(
        [0.25, 0.0456, 0.6994], abs=5e-5
    )


def test_the_program_to_break_is_right_for_slow_motions():
    """The program sees every contact of motions shorter than a radius between samples."""
    rng = np.random.default_rng(0)
    for _ in range(100):
        p0, c0 = rng.uniform(-9, 9, (2, 2))
        p1, c1 = p0 + rng.uniform(-0.5, 0.5, 2), c0 + rng.uniform(-0.5, 0.5, 2)
        truth = exposing_motions.find_least_distance(p0, p1, c0, c1)
        assert (
            exposing_motions.touch_by_moments(p0, p1, c0, c1, 1.0) == (truth <= 1.0)
            or abs(truth - 1.0) < 0.01
        )


def test_the_board_of_time_plans_anew():
    """A faster robot arrives earlier, a goal in a wall is a warning, and dragging plans again."""
    board = moving_board(TimedProblem(Disk(0.5), WORLD, start=(1, 3), goal=(9, 3)), nodes=60)
    first = board.plan.cost
    assert board.canvas.drawing.total == STEPS and len(board.canvas.drawing.step_texts) == STEPS
    board.speed.value = 2.0
    assert board.plan.cost < first
    scene = board.canvas._shown
    goal = {**scene["handles"][1], "at": [4.5, 1.0]}
    board.canvas.arrange({**scene, "handles": [scene["handles"][0], goal]})
    assert board.plan is None and "not free" in board.canvas.drawing.warning
    assert [layer.kind for layer in board.canvas.drawing.layers] == [
        "bodies"
    ]  # the moving obstacles are still drawn
    board.canvas.arrange({**scene, "handles": [scene["handles"][0], {**goal, "at": [9.0, 5.0]}]})
    assert np.array_equal(board.plan.path[-1, :2], [9, 5])
    assert board.picture().startswith(b"\x89PNG")
    path = np.array([(0, 0, 0), (0, 0, 2.5), (1, 0, 3.5)])
    assert waiting_time(path) == 2.5 and [waits_at(path, t) for t in (0, 2, 2.5, 3, 3.5)] == [
        True,
        True,
        False,
        False,
        False,
    ]
    with pytest.raises(InvalidParameter, match="TimedProblem"):
        moving_board("hall")


def test_the_board_of_chances_keeps_its_promise():
    """Bound and estimate are below delta; without such a path the board says so."""
    world = UncertainWorld(
        [(0, 0), (9, 0), (9, 6), (0, 6)], [((4.5, 3), 1), [(6, 4), (7, 4), (6.5, 5)]], [0.5, 0.2]
    )
    board = chance_board(Point(), world, (1, 3), (8, 3), delta=0.1)
    loose = board.plan.cost
    assert board.canvas.drawing.total == SHOWN
    board.delta.value = 0.01
    assert board.plan.cost > loose
    board.delta.value = 0.0001
    assert board.plan.path is None and "greater chance" in board.canvas.drawing.text
    shown = len(board.canvas.drawing.layers)
    scene = board.canvas._shown
    board.canvas.arrange(
        {**scene, "handles": [{**scene["handles"][0], "at": [4.5, 3.0]}, scene["handles"][1]]}
    )
    assert "not free" in board.canvas.drawing.warning and len(board.canvas.drawing.layers) == shown
    assert board.picture().startswith(b"\x89PNG")
    with pytest.raises(InvalidParameter, match="UncertainWorld"):
        chance_board(Point(), HALL, (1, 3), (8, 3))

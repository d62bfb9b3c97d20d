"""Every public function answers nonsense with an error that has a name, and never with Python's
own.
"""

import math

import numpy as np
import pytest

import kinoedu as ke
from kinoedu.c_space import translating_obstacles
from kinoedu.chances import wilson_interval
from kinoedu.errors import KinoeduError
from kinoedu.files import poses_along
from kinoedu.robots import why_unreachable
from kinoedu.worlds import inflated, landscape, movers_at

ROOM = [(0, 0), (10, 0), (10, 10), (0, 10)]
SQUARE = [(1, 1), (2, 1), (2, 2), (1, 2)]
WORLD = ke.PolygonWorld(ROOM, [SQUARE])
TASK = ke.Problem(ke.Point(), WORLD, (5, 5), (9, 9))
ARM = ke.TwoLinkArm(1, 1, 0.1)
CAR = ke.Car(3, 1, 2)
PARKING = ke.Problem(CAR, WORLD, (5, 5, 0), (7, 7, 0))
CART = ke.Moving(0.5, [0, 4], [(2, 8), (8, 8)])
TRAFFIC = ke.MovingWorld(WORLD, [CART])
DRIVE = ke.Trajectory(CAR, (5, 5, 0), [(1, 0)], [1])
NAN = math.nan
NONSENSE = {
    "nothing": None,
    "a number": 5,
    "letters": "ab",
    "an empty list": [],
    "a list of nothing": [None],
    "a dictionary": {"a": 1},
    "not a number": NAN,
    "a ragged list": [[1], [1, 2]],
    "an object": object(),
}

NOBODY_IN = {  # functions of one thing that is none of these
    "a boundary": ke.PolygonWorld,
    "a bitmap": ke.Terrain,
    "a world's file": ke.read_world,
    "a scene": ke.read_scene,
    "a plan's file": ke.read_plan,
    "cells": ke.trapezoidation,
    "triangles": ke.triangulation,
    "a sweep": lambda x: list(ke.sweep(x)),
    "sight": ke.visibility_roadmap,
    "a path through cells": ke.plan_by_decomposition,
    "a path by sight": ke.plan_by_visibility,
    "a grid": ke.plan_on_grid,
    "a grid roadmap": ke.grid_roadmap,
    "RRT": lambda x: ke.rrt(x, rng=0),
    "RRT-Connect": lambda x: ke.rrt_connect(x, rng=0),
    "RRT*": lambda x: ke.rrt_star(x, rng=0),
    "informed RRT*": lambda x: ke.informed_rrt_star(x, rng=0),
    "PRM": lambda x: ke.prm(x, rng=0),
    "a roadmap": lambda x: ke.build_roadmap(x, rng=0),
    "a roadmap that changes": lambda x: ke.changing_roadmap(x, rng=0),
    "a terrain that changed": lambda x: ke.changed_box(x, x),
    "hybrid A*": ke.hybrid_astar,
    "SST": lambda x: ke.sst(x, rng=0),
    "kinodynamic RRT": lambda x: ke.kinodynamic_rrt(x, rng=0),
    "kinodynamic PRM": lambda x: ke.kinodynamic_prm(x, rng=0),
    "a moving world": lambda x: ke.MovingWorld(x, []),
    "movers": lambda x: ke.MovingWorld(WORLD, x or None),  # an empty list is right
    "a turning polygon": ke.RigidPolygon,
    "a sliding polygon": ke.TranslatingPolygon,
    "a hull": ke.geometry.convex_hull,
    "a world of a problem": lambda x: ke.Problem(ke.Point(), x, (5, 5), (9, 9)),
    "a robot of a problem": lambda x: ke.Problem(x, WORLD, (5, 5), (9, 9)),
    "a start": lambda x: ke.Problem(ke.Point(), WORLD, x, (9, 9)),
    "a world of configurations": lambda x: ke.collision.free_configurations(
        TASK.robot, x, [(5, 5)]
    ),
    "a world of motions": lambda x: ke.collision.free_motions(TASK.robot, x, [(5, 5)], [(6, 6)]),
    "a world of a clearance": lambda x: ke.clearance_of(TASK.robot, x, (5, 5)),
    "a world of headings": lambda x: ke.collision.free_headings(ke.RigidPolygon(SQUARE), x, (5, 5)),
    "a drive": lambda x: ke.collision.is_free_trajectory(CAR, WORLD, x),
    "a world of a drive": lambda x: ke.collision.is_free_trajectory(CAR, x, DRIVE),
    "a world of an arm": lambda x: ke.link_in_contact(ARM, (0, 0), x),
    "angles of an arm": lambda x: ke.link_in_contact(ARM, x, WORLD),
    "an arm": lambda x: ke.link_in_contact(x, (0, 0), WORLD),
    "a tip": ARM.inverse,
    "a line": lambda x: ke.geometry.line_through_points(x, (1, 1)),
    "a point in a polygon": lambda x: ke.geometry.point_in_polygon(x, SQUARE),
    "a polygon": lambda x: ke.geometry.point_in_polygon((1, 1), x),
    "a sum of polygons": lambda x: ke.geometry.minkowski_sum(x, SQUARE),
    "a shortcut": lambda x: ke.shortcut(x, rng=0),
    "a trajectory": ke.trajectory_along,
    "a pose": lambda x: ke.dubins_path(x, (1, 1, 0), 1.0),
    "where clearance is measured": lambda x: ke.clearance_of(TASK.robot, WORLD, x),
    "unsure obstacles": lambda x: ke.UncertainWorld(ROOM, x or None, 0.1),  # an empty list is right
    "an uncertain world": lambda x: ke.collision_probability(TASK.robot, x, [(5, 5)], rng=0),
    "a world to grow": lambda x: ke.worlds.inflated(x, 0.1),
    "a world of scenarios": lambda x: ke.worlds.scenarios(x, 3, rng=0),
    "a world of one scenario": lambda x: ke.worlds.scenario_world(x, [(0, 0)]),
    "a roadmap to search": lambda x: ke.plan_on_roadmap(TASK, x),
    "a bound of risk": lambda x: ke.collision_bound(TASK.robot, x, [(5, 5)]),
    "a norm": lambda x: ke.dispersion([(0.5, 0.5)], norm=x),
    "a planner that hurries": lambda x: ke.best_within(0.1, x, rng=0),
    "a plan made in a hurry": lambda x: ke.best_within(0.1, lambda rng: x, rng=0),
    "a plan in a sensor's map": lambda x: ke.receding_horizon(TASK, planner=lambda *_: x, rng=0),
    "an arm that does not reach": lambda x: why_unreachable(x, (9, 9)),
    "a world to inflate": lambda x: inflated(x, 0.1),
    "movers at a time": lambda x: movers_at(x, 1.0),
    "a time of movers": lambda x: movers_at(TRAFFIC, [] if x == 5 else x),
    "a time of one mover": lambda x: CART.at([] if x == 5 else x),
    "a landscape": lambda x: landscape(x, 0),
    "how far ahead": lambda x: ke.Car(3, 1, 2).ahead((0, 0, 0), [] if x == 5 else x),
    "obstacles to grow": lambda x: translating_obstacles(SQUARE, x or None),
    "a scene to write": lambda x: ke.write_scene(x, "never.json"),
    "a plan to write": lambda x: ke.write_plan(x, "never.json"),
    "a board": ke.board,
    "a board's planner": lambda x: ke.board(TASK, planner=x),
}
REFUSED = {
    "no obstacles": lambda: ke.PolygonWorld(ROOM, None),
    "a car that turns on a pin": lambda: ke.dubins_path((0, 0, 0), (1, 1, 0), 5e-324),
    "a car that backs on a pin": lambda: ke.reeds_shepp_path((0, 0, 0), (1, 1, 0), 5e-324),
    "cells of no size": lambda: ke.hybrid_astar(PARKING, spacing=5e-324),
    "steps of no size": lambda: ke.hybrid_astar(PARKING, step_size=5e-324),
    "poses without number": lambda: poses_along(ke.rrt(TASK, rng=0), 1e-200),
    "a cost without end": lambda: ke.Terrain([[1]], cost=[[10**400]]),
    "costs in letters": lambda: ke.Terrain([[1]], cost=[["1"]]),
    "costs that are complex": lambda: ke.Terrain([[1]], cost=[[1 + 1j]]),
    "costs that are hidden": lambda: ke.Terrain([[1]], cost=np.ma.masked_array([[1.0]], True)),
    "cells that are hidden": lambda: ke.Terrain(np.ma.masked_array([[1]], True)),
    "an obstacle that is one number": lambda: ke.PolygonWorld(ROOM, [np.array(1.0)]),
    "trials in letters": lambda: wilson_interval([1], "3"),
    "half a trial": lambda: wilson_interval([1], 1.5),
    "rooms that are none": lambda: ke.PolygonWorld(ROOM, [(SQUARE, None)]),
    "a size that is true": lambda: ke.TwoLinkArm(True, 1, 0.1),
    "a radius that is true": lambda: ke.Disk(True),
    "a sampler that is a number": lambda: ke.prm(TASK, sampler=5, rng=0),
    "a rule that is a number": lambda: ke.prm(TASK, neighbours=5, rng=0),
    "n in letters": lambda: ke.prm(TASK, n="5", rng=0),
    "n that is true": lambda: ke.prm(TASK, n=True, rng=0),
    "no seed": lambda: ke.prm(TASK, rng=None),
    "a seed below zero": lambda: ke.rrt(TASK, rng=-1),
    "a step of nothing": lambda: ke.rrt(TASK, step_size=NAN, rng=0),
    "a bug's step of zero": lambda: ke.bug1((0, 0), (1, 1), [SQUARE], 0),
    "a bug without a list of obstacles": lambda: ke.bug1((0, 0), (1, 1), None, 0.1),
    "a bug with a number for obstacles": lambda: ke.bug0((0, 0), (1, 1), np.array(1), 0.1),
    "a moving shape with a corner of one number": lambda: ke.Moving([(0, 0), (1,)], [0], [(0, 0)]),
    "a norm of two numbers": lambda: ke.dispersion([(0.5, 0.5)], norm=np.ones(2)),
    "a sensor's planner that is a number": lambda: ke.receding_horizon(TASK, planner=3, rng=0),
    "an edge to no node": lambda: ke.Graph(nodes=[(0, 0)], edges=[(0, 5)]),
    "a start that is no node": lambda: ke.bfs_tree([[1], [0]], -1),
    "fewer points than none": lambda: ke.halton(-1),
    "a base that is no prime": lambda: ke.halton(5, primes=(4,)),
    "a grid of five in a square": lambda: ke.corner_grid(5),
    "a map that is not there": lambda: ke.read_world("no.map"),
    "a circle of no radius": lambda: ke.dubins_path((0, 0, 0), (1, 1, 0), 0),
    "a place to measure with a heading too many": lambda: ke.clearance_of(
        TASK.robot, WORLD, (5, 5, 0)
    ),
    "discs of two numbers": lambda: ke.worlds.scattered(
        3, keep_free=[(1, 2), (3, 4), (5, 6)], rng=0
    ),
    "offsets of other obstacles": lambda: ke.worlds.scenario_world(
        ke.UncertainWorld(ROOM, [SQUARE], 0.1), [(0, 0), (1, 1)]
    ),
    "two segments against three": lambda: ke.geometry.segments_intersect(
        ROOM[:2], ROOM[1:3], ROOM[:3], ROOM[1:]
    ),
    "a world whose distances are rounded to nothing": lambda: ke.Problem(
        ke.Point(), ke.PolygonWorld(1e-300 * np.array(ROOM)), (1e-300, 1e-300), (2e-300, 1e-300)
    ),
    "a tolerance of nearly nothing": lambda: ke.c_space.free_regions(1.0, WORLD, tolerance=1e-17),
    "a painted list": lambda: ke.collision.paint_configuration_space(ARM, [SQUARE], 36),
    "edges of no nodes": lambda: ke.Graph(edges=[(0, 1)]),
    "a roadmap without start and goal": lambda: ke.plan_on_roadmap(
        TASK, ke.build_roadmap(TASK, n=9, rng=0)
    ),
}


@pytest.mark.parametrize("nonsense", NONSENSE.values(), ids=NONSENSE.keys())
@pytest.mark.parametrize("name", NOBODY_IN)
def test_nonsense_has_a_named_error(name, nonsense):
    """Whatever is given in place of a thing."""
    with pytest.raises(KinoeduError):
        NOBODY_IN[name](nonsense)


@pytest.mark.parametrize("name", REFUSED)
def test_what_makes_no_sense_is_refused(name):
    """One wrong argument among right ones."""
    with pytest.raises(KinoeduError):
        REFUSED[name]()


LONG = list(range(9999))
FOR_NUMBERS = {
    "a count": lambda: ke.halton(LONG),
    "a seed": lambda: ke.rrt(TASK, rng=LONG),
    "a fraction": lambda: ke.rrt(TASK, goal_bias=LONG, rng=0),
    "a norm": lambda: ke.dispersion([(0.5, 0.5)], norm=LONG),
    "a radius": lambda: ke.Disk(LONG),
    "a cell's side": lambda: ke.Terrain([[1]], resolution=np.array(LONG)),
    "a width": lambda: ke.TwoLinkArm(1, 1, LONG),
    "a weight": lambda: ke.RigidPolygon(SQUARE, turn_weight=LONG),
    "an image's side": lambda: ke.collision.paint_configuration_space(ARM, WORLD, LONG),
    "a radius that grows": lambda: ke.c_space.grown_obstacles(LONG, WORLD),
    "a tolerance": lambda: ke.c_space.free_regions(1.0, WORLD, tolerance=LONG),
    "a deviation": lambda: ke.UncertainWorld(ROOM, [SQUARE], LONG),
    "a probability": lambda: ke.worlds.chance_margins([0.1], LONG),
    "a part of a way": lambda: ke.c_space.slide([(0, 0), (1, 0)], SQUARE).at(LONG),
}


@pytest.mark.parametrize("name", FOR_NUMBERS)
def test_a_message_about_a_long_value_stays_short(name):
    """An array in place of a number is shown by its first items, on one line."""
    with pytest.raises(KinoeduError) as refused:
        FOR_NUMBERS[name]()
    assert len(str(refused.value)) < 300 and "\n" not in str(refused.value)


class Shy:
    """A class of a reader's own, with a mistake."""

    def __repr__(self):
        return self.name


@pytest.mark.parametrize("name", FOR_NUMBERS)
@pytest.mark.parametrize("value", [-(10**5000), Shy()], ids=["a long number", "no repr"])
def test_what_cannot_be_written_is_named_by_its_type(name, value, monkeypatch):
    """Python writes no integer of more than 4,300 digits."""
    monkeypatch.setitem(globals(), "LONG", value)
    with pytest.raises(KinoeduError):
        FOR_NUMBERS[name]()


@pytest.mark.parametrize("kind", [np.float16, np.float32, np.longdouble])
def test_numbers_of_other_sizes_are_numbers(kind):
    """A number in single precision is taken without a warning; an infinite one is refused."""
    assert ke.worlds.hills(0, highest=kind(0.5)).max() == 0.5
    assert ke.spaces.SE2((0, 0), (1, 1), turn_weight=kind(0.5)).weight[2] == 0.5
    with pytest.raises(ke.errors.InvalidParameter, match="highest"):
        ke.worlds.hills(0, highest=kind(np.inf))
    with pytest.raises(ke.errors.InvalidParameter, match="turn_weight"):
        ke.spaces.SE2((0, 0), (1, 1), turn_weight=kind(np.inf))

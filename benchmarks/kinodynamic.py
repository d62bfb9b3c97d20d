"""A car's trees on a map of 300 x 300: of random drives for 1,000 iterations, no pose counting as
the goal; of Dubins' curves.
"""

import ctypes
from collections.abc import Callable
from ctypes import byref, c_double, c_int64
from typing import Any, NamedTuple

import numpy as np
from ruler import DOUBLES, compile_c, pointer, tree_of, world_of
from timing import Contestant, Goal, Judge, available, measure, report, run

import kinoedu as ke
from kinoedu.collision import is_free
from kinoedu.collision.turning import contact_size
from kinoedu.planners import Drives, GoalBias, GoalRegion
from kinoedu.planners.driving.common import as_car_problem, begin_tree
from kinoedu.planners.driving.parameters import as_drives, as_goal_bias
from kinoedu.problems import ProblemRecord

SECONDS = 90
ITERATIONS, TRIALS, SIDE = 1000, 20, 300.0
INSIDE = [(10, 10), (290, 10), (290, 290), (10, 290)]  # the walls are 10 thick
SOLID = [
    [(75, 75), (100, 75), (100, 100), (75, 100)],
    [(125, 175), (225, 175), (235, 165), (135, 165)],
]
GARAGE = [
    [(230, 230), (290, 230), (290, 232), (230, 232)],
    [(230, 230), (232, 230), (232, 290), (230, 290)],
]  # round (250, 250)
NODES, REACH = 100, 60.0  # of a tree of curves, and how long each may be
GOALS = {
    "C ruler": Goal(at_most=1.05),
    "OMPL": Goal(at_least=25),  # its callbacks are compiled as ours are
    "Robotics Toolbox": Goal(at_least=250),
}


class Case(NamedTuple):
    """The problem, and the seed of the tree."""

    problem: ProblemRecord
    seed: int


class CarInC(ctypes.Structure):
    """`Car` of kinodynamic_ruler.c."""

    _fields_ = (
        *[
            ("outline", DOUBLES),
            ("speeds", DOUBLES),
            ("gears", c_int64),
            ("wheelbase", c_double),
            ("steering", c_double),
        ],
        *[("weight", c_double), ("contact", c_double)],
    )


class BiasInC(ctypes.Structure):
    """`Bias` of kinodynamic_ruler.c."""

    _fields_ = (
        ("goal_every", c_int64),
        ("region_every", c_int64),
        ("region", c_double),
        ("region_turn", c_double),
    )


class DrivesInC(ctypes.Structure):
    """`Drives` of kinodynamic_ruler.c."""

    _fields_ = (("trials", c_int64), ("steps", c_int64), ("step", c_double), ("batches", c_int64))


def on_the_map(seed: int) -> Case:
    """The map of the self-driving car, from one corner to the other."""
    world = ke.PolygonWorld(INSIDE, SOLID)
    return Case(ke.Problem(ke.Car(30, 10, 20), world, (250, 250, 0), (50, 50, np.pi / 2)), seed)


def grown(case: Case, iterations: int = ITERATIONS, **given: Any) -> ke.Plan:
    """The tree of kinoedu's public function; a place must be the goal itself, which none is."""
    exact = GoalRegion(tolerance=0.0, turn_tolerance=0.0)
    limits = {"goal_region": exact, "max_iterations": iterations}
    return ke.kinodynamic_rrt(case.problem, **limits, **given, rng=case.seed)


def kinoedu() -> Contestant:
    """The public function, from the problem to the plan."""
    return lambda case: lambda: grown(case)


def ruler() -> Contestant:
    """The same loop in C, from an empty tree to the full one, on the same random numbers."""
    library = compile_c("kinodynamic_ruler")
    library.grow.restype = None

    def contestant(case: Case) -> Callable[[], Any]:
        problem = as_car_problem(case.problem, "the ruler", None)
        bias, drives = as_goal_bias(problem, GoalBias()), as_drives(problem, Drives(trials=TRIALS))
        robot, space, world = problem.robot, problem.space, world_of(problem)
        contact = contact_size(problem.world.lo, problem.world.hi)
        numbers = robot.wheelbase, robot.max_steering, space.weight[2], contact
        car = CarInC(pointer(robot.outline), pointer(robot.speeds), len(robot.speeds), *numbers)

        def run() -> Any:
            growth, rng = begin_tree(problem, ITERATIONS + 1), np.random.default_rng(case.seed)
            growth.tree.head[:] = -1  # the ruler adds the root itself
            in_c, draws = tree_of(growth.tree), rng.bit_generator.ctypes
            arrays = [pointer(array) for array in (growth.controls, growth.durations)]
            ends = [pointer(q) for q in (space.lo, space.hi, problem.start, problem.goal)]
            how = byref(BiasInC(*bias)), byref(DrivesInC(*drives)), c_int64(ITERATIONS)
            library.grow(
                byref(world),
                byref(in_c),
                *arrays,
                byref(car),
                *ends,
                *how,
                draws.state,
                draws.next_double,
            )
            return in_c.size, growth

        return run

    return contestant


def ompl() -> Contestant:
    """Its RRT for controls, as many iterations, in the same steps of 0.1 s for at most 15 s."""
    from car_peers import Setup

    def contestant(case: Case) -> Callable[[], Any]:
        setup = Setup(case.problem, 0.1, 150)

        def run() -> Any:
            return setup, setup.grow(ITERATIONS)

        return run

    return contestant


def judge(case: Case, answers: dict[str, Any]) -> None:
    """kinoedu's and the ruler's trees are the same, node by node and control by control."""
    ours = answers["kinoedu"].tree
    size, growth = answers["C ruler"]
    assert size == len(ours.nodes), (size, len(ours.nodes))
    same = (
        (growth.tree.nodes, ours.nodes),
        (growth.tree.parent, ours.parent),
        (growth.controls, ours.controls),
    )
    assert all(
        np.array_equal(theirs[:size], kept)
        for theirs, kept in (*same, (growth.durations, ours.durations))
    )


def one_control() -> Contestant:
    """The public function where only one control is tried in each iteration."""
    return lambda case: lambda: grown(case, drives=Drives(trials=1, batches=1))


def judge_ompl(case: Case, answers: dict[str, Any]) -> None:
    """Its tree is about as large, and its poses are free."""
    setup, planner = answers["OMPL"]
    nodes, problem = setup.nodes(planner), case.problem
    assert 0.5 < len(nodes) / len(answers["kinoedu"].tree.nodes) < 2.0, len(nodes)
    assert all(is_free(problem.robot, problem.world, q, 0.0) for q in nodes)


def dubins() -> Contestant:
    """The public function for a car that only goes forward, to a goal that is walled in."""

    def contestant(case: Case) -> Callable[[], Any]:
        car, given = ke.Car(30, 10, 20, speeds=[1.0]), case.problem
        problem = ke.Problem(car, ke.PolygonWorld(INSIDE, SOLID + GARAGE), given.goal, given.start)
        return lambda: ke.rrt(
            problem, step_size=REACH, goal_bias=0.0, max_nodes=NODES, rng=case.seed
        )

    return contestant


def robotics_toolbox() -> Contestant:
    """Its RRT, which joins poses by Dubins' curves no longer than 6, on the same map a tenth as
    large; judged every 0.2.
    """
    from car_peers import toolbox_planner

    return lambda case: toolbox_planner(case.problem, [*SOLID, *GARAGE], case.seed, NODES)


def judge_curves(case: Case, answers: dict[str, Any]) -> None:
    """Both trees are as large."""
    assert len(answers["kinoedu"].tree.nodes) == answers["Robotics Toolbox"].g.n == NODES


def main(repeats: int = 5) -> None:
    """Three trees, each grown five times."""
    race(
        f"{ITERATIONS:,} iterations of {TRIALS} controls",
        {"kinoedu": kinoedu, "C ruler": ruler},
        judge,
        repeats,
    )
    race(
        f"{ITERATIONS:,} iterations of one control",
        {"kinoedu": one_control, "OMPL": ompl},
        judge_ompl,
        repeats,
    )
    race(
        f"{NODES} nodes joined by curves",
        {"kinoedu": dubins, "Robotics Toolbox": robotics_toolbox},
        judge_curves,
        repeats,
    )


def race(
    title: str, makers: dict[str, Callable[[], Contestant]], judge_all: Judge, repeats: int
) -> None:
    """One table, on three seeds; none where kinoedu would run alone."""
    contestants = available(makers)
    if len(contestants) > 1:
        report(
            f"a car's tree, {title}",
            measure(contestants, map(on_the_map, range(3)), judge_all, repeats=repeats),
            GOALS,
        )


if __name__ == "__main__":
    run(main)

"""The table of planners: complete, and true to the functions it names."""

import inspect

import pytest

from kinoedu import PolygonWorld, Problem, RigidPolygon, planners
from kinoedu.cli.plan import CHOICES, SETTINGS
from kinoedu.experiments.files import planners_by_name
from kinoedu.planners.registry import ALL, PLANNERS
from kinoedu.problems import Plan
from kinoedu.robots import Car, Point

ROOM = PolygonWorld([(0, 0), (9, 0), (9, 9), (0, 9)], [[(4, 0), (5, 0), (5, 5)]])
TASKS = {
    "point": Problem(Point(), ROOM, (1, 1), (8, 8)),
    "turning polygon": Problem(
        RigidPolygon([(-0.2, -0.1), (0.2, -0.1), (0.2, 0.1)]), ROOM, (1, 1, 0), (8, 8, 1)
    ),
    "car": Problem(Car(1.0, 0.5, 0.6), ROOM, (1, 1, 0), (8, 8, 1)),
}
FOR_TURNING = {"cells_with_headings"}


def plans_alone(function):
    """Whether a function makes a Plan of a problem and nothing else that it needs but rng."""
    parameters = list(inspect.signature(function).parameters.values())
    needed = {p.name for p in parameters[1:] if p.default is inspect.Parameter.empty}
    returns = inspect.signature(function, eval_str=True).return_annotation
    return parameters[0].name == "problem" and returns is Plan and needed <= {"rng"}


def test_every_planner_of_a_problem_has_a_row():
    """Only plan_in_time is absent: its problem has obstacles that move, which no file describes."""
    public = {getattr(planners, name) for name in planners.__all__}
    found = {one for one in public if inspect.isfunction(one) and plans_alone(one)}
    assert found - {row.function for row in PLANNERS.values()} == {planners.plan_in_time}


@pytest.mark.parametrize("planner", PLANNERS.values(), ids=PLANNERS)
def test_row_is_true_of_its_function(planner):
    """Settings are known, keywords exist, robots have tasks."""
    keywords = inspect.signature(planner.function).parameters
    assert set(planner.options) <= set(SETTINGS)
    assert set(planner.options.values()) | set(planner.quick) <= set(keywords)
    assert set(planner.board or ()) <= set(planner.options)
    assert planner.car_board is None or "iterations" in planner.options
    assert set(planner.robots) <= set(ALL)
    assert getattr(planners, planner.function.__name__) is planner.function


@pytest.mark.parametrize("planner", PLANNERS.values(), ids=PLANNERS)
def test_keywords_are_few_and_mean_one_thing(planner):
    """At most eight; `step` and `iterations` are too vague for a keyword."""
    keywords = list(inspect.signature(planner.function).parameters)[1:]
    assert len(keywords) <= 8
    assert not {"step", "iterations"} & set(keywords)


@pytest.mark.parametrize("planner", PLANNERS.values(), ids=PLANNERS)
def test_short_run_makes_a_plan(planner):
    """With the keywords of its row and seed 0, and the same plan a second time."""
    kind = "turning polygon" if planner.name in FOR_TURNING else "point"
    task = TASKS["car" if planner.robots == ("car",) else kind]
    first, second = planner.quick_plan(task), planner.quick_plan(task)
    assert isinstance(first, Plan)
    assert first.cost == second.cost


def test_a_row_is_all_that_the_command_line_and_experiments_need():
    """Each planner of the table is a choice of both."""
    assert [name.replace("-", "_") for name in CHOICES] == list(PLANNERS)
    assert set(planners_by_name().values()) == {row.function for row in PLANNERS.values()}


def test_settings_by_their_common_names_reach_the_function():
    """`nodes` is max_nodes of an RRT and n of a PRM."""
    assert len(PLANNERS["prm"].plan(TASKS["point"], seed=1, nodes=30).roadmap.nodes) >= 30
    assert len(PLANNERS["rrt"].plan(TASKS["point"], seed=1, nodes=3).tree.nodes) <= 3

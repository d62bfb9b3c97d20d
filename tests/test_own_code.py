"""Code of a reader's own: planners, robots and worlds in experiments, files and commands."""

import pickle
import re
import subprocess
import sys
from functools import partial
from pathlib import Path

import numpy as np
import pytest

import kinoedu as ke
from kinoedu.cli import main
from kinoedu.compiled import modes
from kinoedu.errors import InvalidParameter, KinoeduError
from kinoedu.experiments import Experiment, read_experiment, run
from kinoedu.experiments.cells import kind_of
from kinoedu.experiments.digests import digest
from kinoedu.planners.own import as_plan, call_planner, find_faults
from kinoedu.support import own_code
from kinoedu.support.own_code import load_function

ROOM = [(0, 0), (10, 0), (10, 10), (0, 10)]
WALL = [(4, 0), (6, 0), (6, 8), (4, 8)]
PROBLEM = ke.Problem(ke.Point(), ke.PolygonWorld(ROOM, [WALL]), start=(1, 1), goal=(9, 1))
AROUND = [(1, 1), (3, 9), (7, 9), (9, 1)]

MINE = """
from helpers import corner

def around(problem):
    return [problem.start, corner(3), corner(7), problem.goal]

def random_corner(problem, rng, height=9.0):
    x = rng.uniform(1.0, 3.9)
    return [problem.start, (x, height), (10 - x, height), problem.goal]

def through(problem):
    return [problem.start, problem.goal]

def vandal(problem):
    problem.world.obstacles.points[:] = 0
    problem.goal[:] = problem.start
    return [problem.start, problem.goal]

def none(problem):
    return None

def raising(problem):
    return [][0]
"""
HELPERS = "def corner(x):\n    return (x, 9.0)\n"
EXPERIMENT = """
seeds = 3
[problems.room]
file = "room.json"
[planners.RRT]
planner = "rrt"
[planners.mine]
planner = "{planner}"
"""


@pytest.fixture(autouse=True)
def no_own_modules_remain(monkeypatch):
    """What a test loads is forgotten after it."""
    monkeypatch.setattr(sys, "path", sys.path[:])
    monkeypatch.setattr(own_code, "LOADED", {})
    monkeypatch.setattr(own_code, "FOLDERS", set())
    before = set(sys.modules)
    yield
    for name in set(sys.modules) - before:
        if name in ("mine", "helpers", "robots_of_mine", "air"):
            del sys.modules[name]


@pytest.fixture
def folder(tmp_path):
    """A folder with a scene, a reader's file, and what that imports."""
    ke.write_scene(PROBLEM, tmp_path / "room.json")
    (tmp_path / "mine.py").write_text(MINE)
    (tmp_path / "helpers.py").write_text(HELPERS)
    return tmp_path


@pytest.fixture
def interpreted(monkeypatch):
    """Nothing is compiled, here and in processes that are started; both ways give the same bits."""
    monkeypatch.setenv("KINOEDU_MACHINE_CODE", modes.INTERPRETED)
    with modes.running(modes.INTERPRETED):
        yield


def write_experiment(folder, planner, more=""):
    """An experiment with a planner of the reader's file."""
    file = folder / "own.toml"
    file.write_text(EXPERIMENT.format(planner=planner) + more)
    return file


ANSWERS = {
    "path": (lambda problem: AROUND, True, ""),
    "array": (lambda problem: np.array(AROUND, float), True, ""),
    "plan": (lambda problem: ke.rrt_connect(problem, rng=0), True, ""),
    "random": (lambda problem, rng: ke.rrt(problem, rng=rng), True, ""),
    "named": (lambda problem, *, rng: ke.rrt(problem, rng=rng), True, ""),
    "second": (lambda p, generator: ke.rrt(p, rng=generator), True, ""),
    "none": (lambda problem: None, False, "the planner returned None"),
    "through": (
        lambda problem: [problem.start, problem.goal],
        False,
        "motion 1 of your path, from (1, 1) to (9, 1), is not free",
    ),
    "elsewhere": (lambda problem: [problem.start], False, "must end at the goal (9, 1)"),
    "outside": (
        lambda problem: [problem.start, (1, 11), (9, 11), problem.goal],
        False,
        "motion 1 of your path",
    ),
    "replaced": (
        lambda problem: ke.Plan(np.array([problem.start, problem.goal]), 1.0, problem=problem),
        False,
        "is not free",
    ),
}


@pytest.mark.parametrize("name", ANSWERS)
def test_a_board_and_an_experiment_take_the_same_functions(name):
    """And say the same of what they return."""
    planner, found, words = ANSWERS[name]
    (row, *_) = run(Experiment({"a": PROBLEM}, {"mine": planner}, seeds=1), where="here")
    assert row.found == found and words in row.reason
    assert (row.cost < np.inf) == found
    shown = repr(ke.board(PROBLEM, planner=planner))
    assert (f"yours: length {row.cost:.4g}" in shown) if found else (words in shown or row.reason)
    assert row.status == ("found" if found else "no path" if name == "none" else "wrong")


def test_a_path_in_contact_is_found_and_said_to_touch():
    """As the shortest paths of the library, which turn in contact with corners."""

    def shortest(problem):
        return ke.plan_by_visibility(problem)

    (row,) = run(Experiment({"a": PROBLEM}, {"mine": shortest}), where="here")
    assert row.cost == pytest.approx(ke.plan_by_visibility(PROBLEM).cost)
    assert row.found and "touches an obstacle" in row.reason
    faults = find_faults(as_plan(shortest(PROBLEM), PROBLEM), PROBLEM)
    assert not faults.is_wrong and faults.touching and not faults.wrong


def test_the_cost_is_the_paths_and_not_what_a_planner_says():
    """A plan that flatters itself has the length of its path; on a terrain its cost."""
    flattering = ke.Plan(np.array(AROUND, float), 0.001)
    assert as_plan(flattering, PROBLEM).cost == pytest.approx(
        ke.planners.path_cost(PROBLEM, AROUND)
    )
    mud = ke.Problem(ke.Point(), ke.Terrain([[1, 1, 1]], cost=[[1, 5, 1]]), (0.5, 0.5), (2.5, 0.5))
    assert as_plan([(0.5, 0.5), (2.5, 0.5)], mud).cost == 6.0


@pytest.mark.parametrize("answer", [5, [], [[1, 2, 3]], [[np.nan, 1]], "path", {"a": 1}])
def test_an_answer_that_is_no_path_is_named(answer):
    """With the shape that a path has, and what was returned."""
    with pytest.raises(KinoeduError, match=r"shape \(n, 2\), a Plan or None; it returned"):
        as_plan(answer, PROBLEM)


def test_a_plan_that_drives_is_judged_by_its_drives():
    """The library's drives pass; a changed control does not."""
    from dataclasses import replace

    car = ke.Problem(ke.Car(1.0, 0.5, 0.6), ke.PolygonWorld(ROOM, [WALL]), (2, 2, 0), (2, 8, 1.5))
    plan = ke.hybrid_astar(car)
    assert plan.path is not None and find_faults(as_plan(plan, car), car).text == ""
    drive = plan.trajectory
    straight = drive._replace(controls=drive.controls * (1.0, 0.0), durations=drive.durations * 9)
    assert find_faults(replace(plan, trajectory=straight), car).is_wrong
    shorter = drive._replace(controls=drive.controls[:1], durations=drive.durations[:1])
    assert "must end at the goal" in find_faults(replace(plan, trajectory=shorter), car).text


def test_a_planner_cannot_bend_the_world_it_is_judged_in(folder):
    """Nor that of the other planners."""
    vandal = load_function("mine.vandal", folder)
    rows = run(Experiment({"a": PROBLEM}, {"v": vandal, "A*": ke.plan_on_grid}), where="here")
    assert [row.status for row in rows] == ["wrong", "found"]
    assert PROBLEM.goal.tolist() == [9, 1]


def test_callable_objects_and_methods_are_planners():
    """Whatever a board can call; their state counts for the digest."""

    class Tuned:
        def __init__(self, height):
            self.height = height

        def __call__(self, problem):
            return [problem.start, (3, self.height), (7, self.height), problem.goal]

        def plan(self, problem):
            return self(problem)

    planners = {"object": Tuned(9.0), "method": Tuned(9.0).plan, "low": Tuned(1.0)}
    rows = run(Experiment({"a": PROBLEM}, planners), where="here")
    assert [row.status for row in rows] == ["found", "found", "wrong"]
    assert digest(Tuned(9.0)) == digest(Tuned(9.0)) != digest(Tuned(1.0))
    assert digest(Tuned(9.0).plan) != digest(Tuned(1.0).plan)


def test_a_file_names_a_function_of_its_own(folder):
    """By module or by file; random ones run for each seed; keys are their arguments."""
    more = '[planners.tall]\nplanner = "mine.py:random_corner"\nheight = [8.5, 9]\n'
    experiment = read_experiment(write_experiment(folder, "mine.around", more))
    table = run(experiment, workers=1)
    assert [row.label for row in table if not row.label.startswith("RRT")] == [
        "mine",
        *["tall, height=8.5"] * 3,
        *["tall, height=9"] * 3,
    ]
    assert {row.status for row in table} == {"found"}
    here = run(experiment, where="here")
    assert [row._replace(seconds=0) for row in table] == [row._replace(seconds=0) for row in here]
    assert not (folder / "__pycache__").exists()


@pytest.mark.parametrize("changed", ["mine.py", "helpers.py"])
def test_results_of_a_changed_planner_are_not_used_again(changed, folder):
    """Neither when its file changes, nor one that it imports; those of other planners are."""
    file, out = write_experiment(folder, "mine.around"), folder / "out"
    before = run(read_experiment(file), where="here", out=out)
    assert count_missing(file, out) == 0
    text = (folder / changed).read_text()
    (folder / changed).write_text(text.replace("9.0", "8.5").replace("corner(3)", "corner(2)"))
    assert count_missing(file, out) == 0  # it has just run all
    after = run(read_experiment(file), where="here", out=out)
    assert before[-1].cost != after[-1].cost
    assert [row.cost for row in before[:3]] == [row.cost for row in after[:3]]
    assert len(list((out / "runs").iterdir())) == 3 + 2


def count_missing(file, out):
    """How many runs of an experiment are not in a folder after it was read and run again."""
    calls = []
    experiment = read_experiment(file)
    run(experiment, where="here", out=out, progress=lambda *counts: calls.append(counts))
    run(experiment, where="here", out=out, progress=lambda *counts: calls.append(counts))
    return calls[-1][1] - calls[-1][0]


def test_a_file_that_changed_after_its_import_is_refused(folder, monkeypatch):
    """Another process would run another program than this one."""
    monkeypatch.syspath_prepend(str(folder))
    import mine

    experiment = Experiment({"a": PROBLEM}, {"mine": mine.around})
    run(experiment, where="here")
    (folder / "mine.py").write_text(MINE.replace("corner(3)", "corner(2)"))
    with pytest.raises(InvalidParameter, match=r"mine\.py has changed since it was imported"):
        run(experiment, where="here")
    for half_written in ("def half(", "\0"):
        (folder / "mine.py").write_text(MINE + half_written)
        with pytest.raises(InvalidParameter, match=r"mine\.py has changed since it was imported"):
            run(experiment, where="here")


def test_a_file_with_a_dot_in_its_name_is_refused_by_name(folder):
    """Python would look for a module v2 in a package mine, and say that there is none."""
    (folder / "mine.v2.py").write_text(MINE)
    with pytest.raises(InvalidParameter, match=r"mine\.v2\.py: .* no dot before \.py"):
        load_function("mine.v2.py:around", folder)


def test_a_worker_with_another_version_does_not_answer(folder):
    """A cell says which code it means; a process that has other code does not run it."""
    from kinoedu.experiments.cells import Cell
    from kinoedu.experiments.children import Child
    from kinoedu.experiments.digests import version

    planner = load_function("mine.around", folder)
    kind = kind_of(PROBLEM, planner, 1)
    child = Child()
    try:
        cell = Cell("a", "mine", "", None, PROBLEM, planner, 1, 60.0, kind, version())
        assert child.run(cell).status == "found"
        outcome = child.run(cell._replace(kind=kind[::-1]))
        assert outcome.status == "not run" and "another version of your" in outcome.reason
        outcome = child.run(cell._replace(kind=kind[::-1], version="another"))
        assert outcome.status == "not run" and "another version of kinoedu" in outcome.reason
    finally:
        child.end()


def test_constants_and_helpers_of_a_notebook_count():
    """A function without a file: its source, what it captures, and the globals that it uses."""

    def make(text):
        space = {"__name__": "__main__"}
        exec(text, space)
        return space["planner"]

    base = "K = 1\ndef helper(x):\n    return x\ndef planner(problem):\n    return helper(K)\n"
    same = digest(make(base))
    assert same == digest(make(base))
    for old, new in (("K = 1", "K = 2"), ("return x", "return x + 1"), ("helper(K)", "helper(7)")):
        assert digest(make(base.replace(old, new))) != same, new
    endless = "def planner(problem):\n    return planner(problem)\n"
    assert digest(make(endless)) == digest(make(endless))


NOTEBOOKS = {
    "a function's captured number": """
def make(k):
    return lambda: k
helper = make(5.0)
def planner(problem):
    return helper()
""",
    "a global of a method": """
K = 5.0
class Helper:
    def value(self):
        return K
def planner(problem):
    return Helper().value()
""",
    "a base class": """
class Base:
    @staticmethod
    def value():
        return 5.0
class Helper(Base):
    pass
def planner(problem):
    return Helper.value()
""",
    "a member of a class": """
K = 5.0
class Helper:
    value = K
def planner(problem):
    return Helper.value
""",
    "a global of a decorated function": """
import functools
K = 5.0
@functools.cache
def helper():
    return K
def planner(problem):
    return helper()
""",
    "a global of an object that is a planner": """
K = 5.0
class Planner:
    def __call__(self, problem):
        return K, planner
planner = Planner()
""",
    "the motions of a robot": """
from typing import NamedTuple
from kinoedu.collision.interface import is_free_path
from kinoedu.worlds.terrain import TerrainRecord
class Robot(NamedTuple):
    size: float
@is_free_path.register(Robot, TerrainRecord)
def fly(robot, world, a, b, clearance):
    return 5.0
planner = Robot(1.0)
""",
    "what is left, beside functions of packages": """
from copy import deepcopy
from numpy import linspace
from numpy.linalg import norm
K = 5.0
def planner(problem):
    return norm(linspace(0.0, K)), deepcopy(TABLE)
TABLE = [planner]
""",
}


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_all_that_a_notebook_defines_and_uses_counts(name):
    """The same text has the same digest, and another one where a number in it differs."""

    def make(text):
        space = {"__name__": "__main__"}
        exec(text, space)
        return digest(space["planner"])

    same = make(NOTEBOOKS[name])
    assert make(NOTEBOOKS[name]) == same
    assert make(NOTEBOOKS[name].replace("5.0", "2.0")) != same


WRONG_NAMES = {
    "mine.arround": "mine.py has no function 'arround'; it has around, random_corner",
    "nothing.around": "there is no module nothing",
    "mine.py:x": "has no function 'x'",
    "nothing.py:around": "there is no file",
    "broken.f": "broken in .* cannot be loaded: SyntaxError",
    "leaves.f": "leaves in .* cannot be loaded: SystemExit",
    "lacks.f": "lacks cannot be loaded: No module named 'no_such_module'",
    "random.around": "another module has the name 'random'",
    "mine.HEIGHT": "mine.py has no function 'HEIGHT'",
    "rtt": "planner must be one of .*rrt.* or module.function of your own",
    "os. system": "planner must be one of",
    "mine.around\\nheight": "planner must be one of",
}


@pytest.mark.parametrize("name", WRONG_NAMES)
def test_a_wrong_name_of_code_is_one_error(name, folder, capsys):
    """It says the key, the file and what there is; nothing is run or written."""
    (folder / "mine.py").write_text(MINE + "HEIGHT = 9\n")
    (folder / "broken.py").write_text("def f(:\n")
    (folder / "leaves.py").write_text("raise SystemExit\n")
    (folder / "lacks.py").write_text("import no_such_module\n")
    (folder / "random.py").write_text("def around(problem): return None\n")
    file = write_experiment(folder, name)
    with pytest.raises(KinoeduError, match=f"(?s){WRONG_NAMES[name]}"):
        read_experiment(file)
    assert main(["experiment", str(file), "--out", str(folder / "out")]) == 2
    assert "Traceback" not in capsys.readouterr().err
    assert not (folder / "out").exists()


def test_the_same_name_in_two_folders(folder, tmp_path_factory):
    """Each experiment has the file beside it."""
    other = tmp_path_factory.mktemp("other")
    ke.write_scene(PROBLEM, other / "room.json")
    (other / "mine.py").write_text(MINE.replace("corner(3)", "corner(2)"))
    (other / "helpers.py").write_text(HELPERS)
    rows = [
        run(read_experiment(write_experiment(f, "mine.around")), workers=1) for f in (folder, other)
    ]
    assert rows[0][-1].found and rows[1][-1].found
    assert rows[0][-1].cost != rows[1][-1].cost


ROBOTS = """
from typing import NamedTuple
import numpy as np
import kinoedu as ke
from kinoedu.collision.interface import is_free_path
from kinoedu.problems.configurations import space_of
from kinoedu.robots.round import RoundRobot
from kinoedu.spaces import RealSpace
from kinoedu.worlds.polygon_world import PolygonWorldRecord

class Drone(NamedTuple):
    radius: float

@space_of.register
def _(robot: Drone, world):
    return RealSpace(world.lo, world.hi)

@is_free_path.register(Drone, PolygonWorldRecord)
def fly(robot, world, a, b, clearance):
    return is_free_path(RoundRobot(robot.radius), world, a, b, clearance)

def garden(trees=2, rng=None):
    spots = rng.uniform(3, 7, (trees, 2))
    return ke.PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [(spot, 0.3) for spot in spots])

def quest(trees=2):
    return ke.Problem(Drone(0.2), garden(trees, np.random.default_rng(1)), (1, 1), (9, 9))
"""
GARDENS = """
seeds = 2
[problems.flown]
world = "robots_of_mine.garden"
trees = 4
seed = 1
robot = {kind = "robots_of_mine.Drone", radius = 0.2}
start = [1, 1]
goal = [9, 9]
[problems.whole]
world = "robots_of_mine.quest"
[planners.RRT]
planner = "rrt"
"""


def test_a_negative_seed_of_a_world_of_ones_own_is_named(folder):
    """As for a world of the library."""
    (folder / "robots_of_mine.py").write_text(ROBOTS)
    file = folder / "gardens.toml"
    file.write_text(GARDENS.replace("seed = 1", "seed = -1"))
    with pytest.raises(InvalidParameter, match=r"the seed \(rng\) must be 0, 1, 2, \.\.\."):
        read_experiment(file)


def test_a_robot_and_a_world_of_ones_own(folder, interpreted):
    """In a file, in other processes; a change of their code is another experiment."""
    (folder / "robots_of_mine.py").write_text(ROBOTS)
    file = folder / "gardens.toml"
    file.write_text(GARDENS)
    experiment = read_experiment(file)
    table = run(experiment, workers=1, out=folder / "out")
    assert {row.status for row in table} == {"found"}
    drone = experiment.problems["flown"].robot
    disc = ke.Problem(ke.Disk(0.2), experiment.problems["flown"].world, (1, 1), (9, 9))
    assert table[0].cost == ke.rrt(disc, rng=0).cost
    kinds = {name: digest(problem) for name, problem in experiment.problems.items()}
    (folder / "robots_of_mine.py").write_text(
        ROBOTS.replace("RoundRobot(robot.radius)", "RoundRobot(2.0 * robot.radius)")
    )
    again = read_experiment(file)
    assert type(again.problems["flown"].robot) is not type(drone)
    assert all(digest(again.problems[name]) != kind for name, kind in kinds.items())
    slower = run(again, workers=1, out=folder / "out")
    assert len(list((folder / "out" / "runs").iterdir())) == 8
    assert slower[0].path != table[0].path


GARDEN = 'world = "robots_of_mine.garden"\nseed = 1\n'
ENDS = "start = [1, 1]\ngoal = [9, 9]\n"
WRONG_WORLDS = {
    'world = "robots_of_mine.quest"\n' + ENDS: "do not give start, goal too",
    GARDEN: "lacks 'start'",
    GARDEN.replace("seed = 1\n", "") + ENDS: "lacks 'seed'",
    GARDEN + ENDS + "tree = 3": "did you mean 'trees'",
    GARDEN + ENDS + "trees = -1": "garden raised ValueError.*in line .* of garden",
    'world = "robots_of_mine.Drone"\nradius = 1.0\n' + ENDS: "expected a world",
    GARDEN + ENDS + 'robot = {kind = "robots_of_mine.Drone"}': "Drone raised TypeError",
    GARDEN + ENDS + 'robot = {kind = "robots_of_mine.garden", seed = 1}': "expected a robot",
}


@pytest.mark.parametrize("text", WRONG_WORLDS)
def test_a_wrong_world_or_robot_of_ones_own_is_named(text, folder):
    """With the table and what to change."""
    (folder / "robots_of_mine.py").write_text(ROBOTS)
    file = folder / "wrong.toml"
    file.write_text(f'[problems.a]\n{text}\n[planners.a]\nplanner = "rrt"\n')
    with pytest.raises(KinoeduError, match=f"(?s){WRONG_WORLDS[text]}"):
        read_experiment(file)


def test_scenes_never_name_code(folder):
    """Only an experiment and the command line do: a scene can be taken from anywhere."""
    scene = (folder / "room.json").read_text().replace('"point"', '"robots_of_mine.Drone"')
    (folder / "robots_of_mine.py").write_text("raise AssertionError('it ran')\n")
    (folder / "evil.json").write_text(scene)
    with pytest.raises(KinoeduError, match='"kind" among'):
        ke.read_scene(folder / "evil.json")


@pytest.mark.parametrize(
    ("function", "status", "words"),
    [
        ("around", 0, "found: length 20.49"),
        ("random_corner", 0, "found: length"),
        ("none", 1, "no path: the planner returned None"),
        ("through", 1, "wrong path: motion 1 of your path, from (1, 1) to (9, 1), is not free"),
        ("vandal", 1, "wrong path: "),
        ("raising", 2, "mine.py:raising raised IndexError: list index out of range - in line 2"),
        ("missing", 2, "has no function 'missing'"),
    ],
)
def test_the_command_line_plans_with_a_function_of_a_file(
    function, status, words, folder, capsys, monkeypatch
):
    """It is drawn and saved as any plan."""
    monkeypatch.chdir(folder)
    picture = folder / "plan.png"
    command = ["plan", "room.json", "--planner", f"mine.py:{function}", "--out", str(picture)]
    assert main(command) == status
    out, err = capsys.readouterr()
    assert words in out + err and "Traceback" not in err
    assert picture.exists() == (status < 2)


def test_settings_reach_a_function_that_has_them(folder, capsys, monkeypatch):
    """Others are refused by name; a name that is neither a planner nor code too."""
    monkeypatch.chdir(folder)
    stepping = "def stepping(problem, rng, *, step_size=1.0):\n"
    body = "    return ke.rrt(problem, step_size=step_size, rng=rng)\n"
    (folder / "mine.py").write_text(f"import kinoedu as ke\n{stepping}{body}")
    plan = ["plan", "room.json", "--planner", "mine.py:stepping", "--step-size", "2", "--seed", "3"]
    assert main(plan) == 0
    cost = ke.rrt(PROBLEM, step_size=2.0, rng=np.random.default_rng(3)).cost
    assert f"length {cost:.8g}" in capsys.readouterr().out
    assert main([*plan, "--nodes", "10"]) == 2
    assert "mine.py:stepping has no --nodes; it has --step-size" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        main(["plan", "room.json", "--planner", "bug9"])
    assert "or file.py:function of your own" in capsys.readouterr().err


def test_generators_are_seeded_alike_everywhere():
    """A board, an experiment and the command line give seed 3 as the same generator."""
    drawn = [call_planner(lambda problem, rng: rng.random(), PROBLEM, 3) for _ in range(2)]
    assert drawn == [np.random.default_rng(3).random()] * 2
    assert (
        call_planner(partial(lambda p, rng, k: rng.random() * k, k=2), PROBLEM, 3) == 2 * drawn[0]
    )


def test_loading_imports_nothing_to_find_sources(folder):
    """The sources of what a file imports are found without running them."""
    (folder / "mine.py").write_text("def f(p):\n    import slow.deep\n    from slow import other\n")
    (folder / "slow").mkdir()
    for name in ("__init__", "deep", "other"):
        (folder / "slow" / f"{name}.py").write_text("raise AssertionError('it ran')\n")
    function = load_function("mine.f", folder)
    found = own_code.sources_of(sys.modules["mine"])
    assert list(found) == ["mine", "slow", "slow.deep", "slow.other"]
    assert pickle.loads(pickle.dumps(function)) is function


def test_a_process_of_its_own_finds_the_file(folder):
    """As a user runs it: from another folder, with one worker."""
    file = write_experiment(folder, "mine.random_corner")
    command = [sys.executable, "-m", "kinoedu", "experiment", str(file), "--out", str(folder / "o")]
    ran = subprocess.run([*command, "--workers", "1"], capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert "6 found" in ran.stdout


PAGE = (Path(__file__).parent.parent / "docs" / "own_code.md").read_text(encoding="utf-8")


def blocks(language):
    """The blocks of the guide in a language, in order."""
    return re.findall(rf"^```{language}\n(.*?)^```", PAGE, re.DOTALL | re.MULTILINE)


def test_the_guides_planner_is_as_the_guide_says(tmp_path, monkeypatch, capsys):
    """On a board, checked, from the command line, and beside RRT over fifty seeds."""
    mine, board, check, *_ = blocks("python")
    (tmp_path / "notebooks").mkdir()
    monkeypatch.chdir(tmp_path / "notebooks")
    Path("mine.py").write_text(mine, encoding="utf-8")
    monkeypatch.syspath_prepend(str(Path.cwd()))
    space = {}
    exec(board, space)
    problem, potential = space["problem"], space["potential"]
    ke.write_scene(problem, "pit.json")
    shown = repr(ke.board(problem, planner=potential))
    assert "yours: " in shown and "raised" not in shown and "not free" not in shown
    exec(check, space)
    said = repr(space["report"]).splitlines()
    assert said[: len(blocks("text")[0].splitlines())] == blocks("text")[0].splitlines()
    assert space["report"].passed, space["report"]
    Path("pit.toml").write_text(blocks("toml")[0].replace("[0.1, 0.5]", "0.1"))
    table = run(read_experiment("pit.toml"), where="here")
    rows = {name: [row for row in table if row.planner == name] for name in ("RRT", "potential")}
    assert [len(found) for found in rows.values()] == [50, 50]
    assert all(row.found for row in rows["RRT"])
    assert {row.status for row in rows["potential"]} == {"found", "no path"}
    medians = [np.median([row.cost for row in found if row.found]) for found in rows.values()]
    assert medians[1] > 5.0 * medians[0]
    (plan,) = re.findall(r"^    python start.py (plan .*)$", PAGE, re.MULTILINE)
    monkeypatch.chdir(tmp_path)  # the course's folder
    assert main(plan.split()) == 0
    cost = rows["potential"][int(plan.split()[-3])].cost
    assert f"found: length {cost:.8g}" in capsys.readouterr().out
    assert not rows["potential"][0].found, "the guide says so"


def test_a_reader_who_wants_no_machine_code_gets_none(interpreted):
    """Also in an experiment, which otherwise compiles first."""
    seen = []

    def planner(problem):
        seen.append(modes.mode)

    run(Experiment({"room": PROBLEM}, {"mine": planner}, seeds=1), where="here")
    with modes.running(modes.WHEN_IT_PAYS):
        run(Experiment({"room": PROBLEM}, {"mine": planner}, seeds=1), where="here")
    assert set(seen[: len(seen) // 2]) == {modes.INTERPRETED}
    assert set(seen[len(seen) // 2 :]) == {modes.COMPILED_FIRST}


def test_the_guides_robot_and_world_are_as_the_guide_says(tmp_path, monkeypatch, interpreted):
    """They keep their promises, and planners plan for them."""
    *_, air, checks = blocks("python")
    (tmp_path / "air.py").write_text(air, encoding="utf-8")
    monkeypatch.syspath_prepend(str(tmp_path))
    space = {"ke": ke}
    exec(checks, space)
    assert ke.check_robot(space["Balloons"](0.3, 1.5)).passed
    assert ke.check_world(space["pond"]()).passed
    (tmp_path / "air.toml").write_text(blocks("toml")[1])
    table = run(read_experiment(tmp_path / "air.toml"), where="here")
    assert [row.problem for row in table] == ["orchard"] * 5 + ["pond"] * 5
    assert {row.status for row in table} == {"found"}


class Unspeakable(Exception):
    """An error whose own text fails."""

    def __str__(self):
        return self.missing


def test_an_error_whose_own_text_fails_is_named():
    """By a check of a planner, as by an experiment."""

    def planner(problem):
        raise Unspeakable

    report = ke.check_planner(planner)
    assert "Unspeakable" in report["errors"].where[0]
    problem = ke.Problem(ke.Point(), ke.Terrain([[1] * 9] * 9), (1, 1), (8, 8))
    (row,) = run(Experiment({"empty": problem}, {"mine": planner}), where="here")
    assert row.status == "not run" and "Unspeakable" in row.reason

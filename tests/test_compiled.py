"""Compiled and interpreted are one: the same trees to the last bit, with numba, without it, from a cache that is never stale."""

import hashlib
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

import kinoedu
from kinoedu import Disk, Point, PolygonWorld, Problem, Recorder, Terrain, rrt
from kinoedu.cache import UPPER_ROOMS, is_digested, source_digest
from kinoedu.collision import is_free_path
from kinoedu.compiled import CACHE, JIT, compiled, generic, record
from kinoedu.course.exercise import Exercise
from kinoedu.errors import DuplicateKind, InvalidParameter
from kinoedu.planners.rrt import grow
from kinoedu.robots.round import RoundRobot
from kinoedu.worlds.polygon_world import PolygonWorldRecord

TESTS = Path(__file__).resolve().parent
PACKAGE = Path(kinoedu.__file__).resolve().parent
BOX = [(0, 0), (10, 0), (10, 10), (0, 10)]
needs_jit = pytest.mark.skipif(not JIT, reason="numba is absent or switched off")


def problems() -> dict[str, Any]:
    """Problems of round robots in every kind of world, with walls, rooms, pockets, discs and a clearance."""
    walls = PolygonWorld(
        [(0, 0), (10, 0), (10, 10), (5, 9), (0, 10)],
        [[(4, 0), (6, 0), (6, 8), (4, 8)], ((8, 6), 1), ([(1, 4), (3, 4), (3, 7), (1, 7)], [[(1.5, 4.5), (2.5, 4.5), (2, 6)]])],
    )
    cells = np.random.default_rng(1).random((20, 30)) < 0.85
    cells[0, 0] = cells[-1, -1] = True
    cells[:2, :2] = cells[-2:, -2:] = True
    terrain = Terrain(cells, resolution=0.5, origin=(-1, 2))
    return {
        "point among polygons": Problem(Point(), walls, (1, 1), (9, 1)),
        "disk among polygons": Problem(Disk(0.3), walls, (1, 1), (9, 1), clearance=0.1),
        "point on a terrain": Problem(Point(), terrain, (-0.75, 2.25), (13.75, 11.75)),
        "disk on a terrain": Problem(Disk(0.05), terrain, (-0.75, 2.25), (13.75, 11.75), clearance=0.01),
        "a goal out of reach": Problem(Point(), PolygonWorld(BOX, [[(4, 0), (6, 0), (6, 10), (4, 10)]]), (1, 1), (9, 1)),
    }


def digest(plan: Any) -> str:
    """Every bit of a plan's tree, path, cost and counts."""
    path = b"" if plan.path is None else plan.path.tobytes()
    told = json.dumps([plan.stats, plan.cost], sort_keys=True).encode()
    return hashlib.sha256(plan.tree.nodes.tobytes() + plan.tree.parent.tobytes() + path + told).hexdigest()


def digests(wrapped: Any = lambda problem: problem, nodes: int = 450) -> dict[str, str]:
    """One digest for each problem; trees grow past the size from which the nearest node is looked up in buckets."""
    return {
        f"{name}, seed {seed}": digest(rrt(wrapped(problem), step=0.4, max_nodes=nodes, max_iterations=1500, rng=seed))
        for name, problem in problems().items()
        for seed in (0, 1)
    }


def run(code: str, *, path: Path = PACKAGE.parent, **variables: str) -> Any:
    """What a Python process of its own prints last, as JSON, given the code it runs and its environment."""
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(path), str(TESTS)]), **variables}
    command = [sys.executable, "-c", code]  # which looks for modules in the current folder first
    done = subprocess.run(command, env=environment, cwd=TESTS, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout.splitlines()[-1])


PLAN = "import json, test_compiled as t; print(json.dumps([t.JIT, t.digests()]))"


@pytest.fixture(scope="module")
def trees() -> dict[str, str]:
    """The digests that compiled planning gives, which every other way must give too."""
    return digests()


# ---- one body ----------------------------------------------------------------------------------------------------------------


def test_a_recorder_grows_the_very_same_tree(trees: dict[str, str]) -> None:
    """The interpreted body, asked through a recorder."""
    assert digests(Recorder) == trees


def test_the_trees_are_worth_comparing() -> None:
    """Some problems are solved, one is not; trees are larger than what is searched node by node."""
    plans = {name: rrt(problem, step=0.4, max_nodes=450, max_iterations=1500, rng=0) for name, problem in problems().items()}
    assert plans["a goal out of reach"].path is None
    assert plans["a goal out of reach"].stats["nodes"] > 400
    assert plans["point among polygons"].path is not None
    assert all(plan.stats["nodes"] > 50 for plan in plans.values())


@needs_jit
def test_the_python_body_grows_the_very_same_tree() -> None:
    """`grow.py_func` handed the record itself: no recorder between."""
    from kinoedu.geometry.checks import as_generator
    from kinoedu.spaces.buckets import empty_tree

    for problem in problems().values():
        grown = []
        for body in (grow, grow.py_func):
            tree = empty_tree(451, problem.space.lo, problem.space.hi)
            answer = body(problem, tree, 0.4, 0.05, 0.0, 1500, 1500, as_generator(2))
            n = int(tree.size[0])
            grown.append((tuple(map(int, answer)), tree.nodes[:n].tobytes(), tree.parent[:n].tobytes()))
        assert grown[0] == grown[1]


@needs_jit
def test_numba_switched_off_grows_the_very_same_tree(trees: dict[str, str]) -> None:
    """NUMBA_DISABLE_JIT=1, as a debugger or coverage wants it."""
    assert run(PLAN, NUMBA_DISABLE_JIT="1") == [False, trees]


def test_without_numba_kinoedu_imports_and_grows_the_very_same_tree(trees: dict[str, str]) -> None:
    """A process in which numba cannot be imported."""
    assert run(f"import sys; sys.modules['numba'] = None; {PLAN}") == [False, trees]


def test_a_recorder_writes_down_what_was_asked() -> None:
    """As many motions as the plan's statistics count; every edge of the tree among those found free."""
    recorder = Recorder(problems()["point among polygons"])
    plan = rrt(recorder, step=0.4, max_nodes=200, rng=0)
    asked = [question for question in recorder.log if question.name == "is_free_path"]
    assert len(asked) == plan.stats["checks"] == recorder.counts()["is_free_path"]
    found = {(tuple(q.given[0]), tuple(q.given[1])) for q in asked if q.answer}
    for node, parent in zip(plan.tree.nodes[1:], plan.tree.parent[1:], strict=True):
        assert (tuple(plan.tree.nodes[parent]), tuple(node)) in found


class PlainProblem:
    """A reader's own problem: a plain object with the six names a planner needs."""

    def __init__(self, problem: Any) -> None:
        self.start, self.goal = tuple(problem.start), list(problem.goal)
        self._problem = problem

    def sample(self, rng: np.random.Generator) -> Any:
        lo, hi = self._problem.world.lo, self._problem.world.hi
        return np.array([lo[0] + (hi[0] - lo[0]) * rng.random(), lo[1] + (hi[1] - lo[1]) * rng.random()])

    def distance(self, a: Any, b: Any) -> float:
        return float(np.sqrt((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1])))

    def steer(self, a: Any, b: Any, step: float) -> Any:
        whole = self.distance(a, b)
        return np.array(b) if whole <= step else np.array([a[i] + step / whole * (b[i] - a[i]) for i in range(2)])

    def is_free_path(self, a: Any, b: Any) -> bool:
        return bool(is_free_path(self._problem.robot, self._problem.world, np.asarray(a), np.asarray(b), self._problem.clearance))


def test_a_readers_own_problem_grows_the_very_same_tree(trees: dict[str, str]) -> None:
    """Same answers, same tree; a recorder takes it as well."""
    assert digests(PlainProblem) == trees


def test_what_a_readers_problem_lacks_is_named() -> None:
    """InvalidParameter lists the missing names."""
    with pytest.raises(InvalidParameter, match=r"lacks sample, distance, steer, is_free_path"):
        rrt(type("Half", (), {"start": (0, 0), "goal": (1, 1)})(), rng=0)


def test_a_planner_leaves_its_problem_as_it_was() -> None:
    """Nothing but the count of questions changes, and no array is released that the problem still holds."""
    problem = problems()["point among polygons"]
    held = [problem.start, problem.goal, problem.world.edges, problem.world.obstacles.points, problem.space.lo]
    before, counts = [array.copy() for array in held], [sys.getrefcount(array) for array in held]
    plans = [rrt(problem, rng=seed) for seed in range(5)]
    del plans
    assert [sys.getrefcount(array) for array in held] == counts
    assert all((now == then).all() for now, then in zip(held, before, strict=True))
    assert problem.asked[0] > 0


# ---- questions that each kind answers ----------------------------------------------------------------------------------------


@record
class Cat(NamedTuple):
    """A record of this file."""

    weight: float

    def heavier(self, by: float) -> float:
        """A method that compiled code can call."""
        return self.weight + by


@record
class Dog(NamedTuple):
    """Another with a method of the same name."""

    weight: float

    def heavier(self, by: float) -> float:
        """Another answer."""
        return self.weight + 2.0 * by


@generic(2)
def noise(first: Any, second: Any, loudness: float) -> float:
    """What two animals make of each other; nothing in general."""
    return 0.0


@noise.register(Cat, Dog)
def hiss(first: Cat, second: Dog, loudness: float) -> float:
    return loudness * first.weight


@noise.register(Dog, Cat)
def bark(first: Dog, second: Cat, loudness: float) -> float:
    return -loudness * first.weight


@compiled
def noise_of(first: Any, second: Any, loudness: float) -> float:
    """A compiled caller."""
    return noise(first, second, loudness)


@compiled
def heavier_of(animal: Any, by: float) -> float:
    """A compiled caller of a method."""
    return animal.heavier(by)


def test_each_pair_of_kinds_has_its_own_answer_compiled_and_not() -> None:
    """The order of the pair counts; pairs without an answer get the default."""
    cat, dog = Cat(3.0), Dog(7.0)
    for first, second, expected in ((cat, dog, 6.0), (dog, cat, -14.0), (cat, cat, 0.0), (dog, dog, 0.0)):
        assert noise(first, second, 2.0) == noise_of(first, second, 2.0) == noise_of.py_func(first, second, 2.0) == expected
    assert noise("anything", None, 2.0) == 0.0


def test_methods_of_one_name_belong_to_their_records() -> None:
    """Compiled code calls the method of the record it is handed."""
    for animal, expected in ((Cat(3.0), 4.0), (Dog(7.0), 9.0)):
        assert animal.heavier(1.0) == heavier_of(animal, 1.0) == heavier_of.py_func(animal, 1.0) == expected


def test_a_pair_is_answered_once() -> None:
    """DuplicateKind names the question and the kinds, here and for the package's own."""
    with pytest.raises(DuplicateKind, match=r"noise.*Cat, Dog"):
        noise.register(Cat, Dog)(bark)
    with pytest.raises(DuplicateKind, match=r"is_free_path.*RoundRobot, PolygonWorldRecord"):
        is_free_path.register(RoundRobot, PolygonWorldRecord)(lambda *_: True)
    assert noise(Cat(3.0), Dog(7.0), 2.0) == 6.0


def test_a_robot_that_no_world_knows_is_a_type_error() -> None:
    """The default of a collision question says so instead of answering."""
    with pytest.raises(TypeError, match="cannot be moved"):
        is_free_path(Cat(1.0), problems()["point among polygons"].world, np.zeros(2), np.ones(2), 0.0)


# ---- the cache ---------------------------------------------------------------------------------------------------------------

ORIENT = """
import json, numba, kinoedu.compiled as c
from kinoedu.geometry import orientation
print(json.dumps([orientation((0, 0), (1, 0), (0, 1)), c.CACHE is not None]))
"""


@needs_jit
@pytest.mark.skipif(CACHE is None, reason="no folder for a cache")
def test_a_second_process_loads_what_the_first_compiled(trees: dict[str, str]) -> None:
    """Every body comes from the disk, none is compiled again, and the trees are the same."""
    code = """
import json, test_compiled as t
found = t.digests()
stats = t.grow.stats
print(json.dumps([found, sum(stats.cache_hits.values()), sum(stats.cache_misses.values())]))
"""
    found, hits, misses = run(code)
    assert found == trees
    assert hits == len({(type(problem.robot), type(problem.world)) for problem in problems().values()})
    assert misses == 0


@needs_jit
def test_a_cache_that_cannot_be_written_does_not_hinder(tmp_path: Path) -> None:
    """A file in the folder's place, a file as its parent, a folder that only reads: compiled anew, and right."""
    taken = tmp_path / "taken"
    taken.write_text("a file", encoding="utf-8")
    places = [taken, taken / "below"]
    if os.name == "posix" and os.getuid() != 0:  # root writes everywhere
        sealed = tmp_path / "sealed"
        sealed.mkdir(mode=0o500)
        places.append(sealed)
    for place in places:
        assert run(ORIENT, KINOEDU_CACHE=str(place)) == [1, False]
    assert taken.read_text(encoding="utf-8") == "a file"


@needs_jit
def test_users_begin_with_what_was_warmed_for_all(tmp_path: Path) -> None:
    """A copy of their own, private, from which nothing is compiled. A file where a warmed folder is expected does not hinder."""
    code = """
import json, os, kinoedu.compiled as c
from kinoedu.geometry import orientation
from kinoedu.geometry.exact import turn
orientation((0, 0), (1, 0), (0, 1))
counts = [sum(found.values()) for found in (turn.stats.cache_hits, turn.stats.cache_misses)]
print(json.dumps([*counts, str(c.CACHE), c.CACHE.stat().st_mode & 0o777]))
"""
    warmed, own = tmp_path / "warmed", tmp_path / "own"
    hits, misses, folder, _ = run(code, KINOEDU_CACHE=str(warmed))
    assert (hits, misses) == (0, 1)
    for path in Path(folder).rglob("*"):
        path.chmod(0o555 if path.is_dir() else 0o444)
    hits, misses, folder, mode = run(code, KINOEDU_CACHE=str(own), KINOEDU_WARMED=str(warmed))
    assert (hits, misses) == (1, 0)
    assert Path(folder).parent == own and (os.name != "posix" or mode == 0o700)
    assert run(ORIENT, KINOEDU_CACHE=str(tmp_path / "another"), KINOEDU_WARMED=__file__) == [1, True]


@needs_jit
def test_a_change_in_a_callee_is_never_answered_from_the_cache(tmp_path: Path) -> None:
    """A copy of the package whose innermost function is edited between two processes that share one cache."""
    copy = tmp_path / "site" / "kinoedu"
    shutil.copytree(PACKAGE, copy, ignore=shutil.ignore_patterns("__pycache__"))
    code = """
import json, kinoedu
from kinoedu.geometry import point_in_polygon
print(json.dumps([point_in_polygon((1, 1), [(0, 0), (4, 0), (0, 4)]), kinoedu.__file__]))
"""
    cache = str(tmp_path / "cache")
    assert run(code, path=copy.parent, KINOEDU_CACHE=cache) == [True, str(copy / "__init__.py")]
    callee = copy / "geometry" / "exact.py"
    source = callee.read_text(encoding="utf-8")
    edited = source.replace("return 1 if det > 0.0 else -1", "return -1 if det > 0.0 else 1", 1)
    assert edited != source
    callee.write_text(edited, encoding="utf-8")
    assert run(code, path=copy.parent, KINOEDU_CACHE=cache)[0] is False
    callee.write_text(source, encoding="utf-8")
    assert run(code, path=copy.parent, KINOEDU_CACHE=cache)[0] is True
    assert len([folder for folder in Path(cache).iterdir() if folder.is_dir()]) == 2


OWN_ROBOT = """
from typing import NamedTuple
import numpy as np
from kinoedu.cache import UPPER_ROOMS, is_digested, source_digest
from kinoedu.collision import is_free_path
from kinoedu.configurations import space_of
from kinoedu.spaces import RealSpace
from kinoedu.worlds.terrain import TerrainRecord

class Ghost(NamedTuple):
    size: float

@space_of.register
def ghost_space(robot: Ghost, world):
    return RealSpace(world.lo, world.hi)

@is_free_path.register(Ghost, TerrainRecord)
def ghost_in_terrain(robot, world, a, b, clearance):
    return b[0] LIMIT 5.0 + robot.size
"""
OWN_PLAN = """
import json, mine, numpy as np
from kinoedu import Problem, Recorder, Terrain, rrt
from kinoedu.planners.rrt import grow
problem = Problem(mine.Ghost(1.0), Terrain(np.ones((10, 10))), START, GOAL)
plan, again = rrt(problem, rng=0, max_nodes=100), rrt(Recorder(problem), rng=0, max_nodes=100)
assert plan.tree.nodes.tolist() == again.tree.nodes.tolist()
print(json.dumps([plan.tree.nodes[:, 0].min(), plan.tree.nodes[:, 0].max(), sum(grow.stats.cache_hits.values())]))
"""


@needs_jit
def test_a_kind_from_elsewhere_is_compiled_and_never_stale(tmp_path: Path) -> None:
    """A robot of a reader's own file works in compiled planners, and an edit of that file counts at once."""
    cache = str(tmp_path / "cache")
    (tmp_path / "mine.py").write_text(OWN_ROBOT.replace("LIMIT", "<"), encoding="utf-8")
    paths = {"PYTHONPATH": os.pathsep.join([str(PACKAGE.parent), str(tmp_path)]), "PYTHONDONTWRITEBYTECODE": "1"}
    low, high, hits = run(OWN_PLAN.replace("START", "(1, 1)").replace("GOAL", "(5, 9)"), KINOEDU_CACHE=cache, **paths)
    assert 0.0 <= low < high < 6.0
    assert hits == 0
    (tmp_path / "mine.py").write_text(OWN_ROBOT.replace("LIMIT", ">"), encoding="utf-8")
    low, high, hits = run(OWN_PLAN.replace("START", "(9, 1)").replace("GOAL", "(7, 9)"), KINOEDU_CACHE=cache, **paths)
    assert 6.0 < low < high <= 10.0
    assert hits == 0


# ---- importing ---------------------------------------------------------------------------------------------------------------


def test_importing_is_light_and_leaves_numba_as_it_was(tmp_path: Path) -> None:
    """What only some readers need is imported where it is used; numba's own cache folder is not taken over."""
    code = """
import json, sys
try:
    import numba
    before = numba.config.CACHE_DIR
except ImportError:
    numba = None
import numpy
already = set(sys.modules)  # numba itself reads yaml, for one
import kinoedu
heavy = {"scipy", "matplotlib", "shapely", "trimesh", "IPython", "PIL", "yaml", "nbgrader", "ipywidgets", "anywidget", "networkx"}
print(json.dumps([sorted(heavy & set(sys.modules) - already), numba is None or numba.config.CACHE_DIR == before]))
"""
    assert run(code) == [[], True]
    assert run(code, NUMBA_CACHE_DIR=str(tmp_path)) == [[], True]
    assert list(tmp_path.iterdir()) == []


def test_only_sources_that_code_is_made_of_name_its_folder(tmp_path: Path) -> None:
    """Another algorithm, another folder; another exercise, the same folder, and nothing compiled of exercises is kept."""
    for room in ("planners", "course"):
        (tmp_path / room).mkdir()
        (tmp_path / room / "one.py").write_text("a = 1")
    before = source_digest(tmp_path, without=UPPER_ROOMS)
    (tmp_path / "course" / "one.py").write_text("a = 2")
    assert source_digest(tmp_path, without=UPPER_ROOMS) == before
    (tmp_path / "planners" / "one.py").write_text("a = 2")
    assert source_digest(tmp_path, without=UPPER_ROOMS) != before
    assert is_digested(rrt)
    assert not is_digested(Exercise)
    assert not is_digested(Cat)

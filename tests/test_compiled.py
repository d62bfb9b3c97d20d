"""Machine code and the interpreter give identical trees; no call waits, no code is stale."""

import gc
import hashlib
import json
import os
import shutil
import subprocess
import sys
import threading
import time
from itertools import chain, product
from pathlib import Path
from typing import Any, NamedTuple, cast

import numpy as np
import pytest

import kinoedu
from kinoedu import Disk, Point, PolygonWorld, Problem, Recorder, Terrain, TwoLinkArm, rrt
from kinoedu.boards import arm_board
from kinoedu.collision import is_free_path
from kinoedu.compiled import (
    COMPILED_FIRST,
    HAS_COMPILER,
    INTERPRETED,
    compiled,
    generic,
    modes,
    record,
    requests,
    running,
    saved_state,
    store,
    tiers,
)
from kinoedu.compiled.kinds import kind_of, kinds_of, spell_kind
from kinoedu.compiled.numba_thread import NUMBA_THREAD, WatchedCall
from kinoedu.compiled.store import UPPER_ROOMS, Request, is_digested, source_digest
from kinoedu.course.exercise import Exercise
from kinoedu.errors import DuplicateKind, InvalidParameter
from kinoedu.geometry.checks import Array
from kinoedu.geometry.exact import orientation_sign
from kinoedu.planners.trees.rrt import grow
from kinoedu.robots.round import RoundRobot
from kinoedu.support.threads import raise_in
from kinoedu.warm import first_jobs, later_jobs
from kinoedu.worlds.polygon_world import PolygonWorldRecord

TESTS = Path(__file__).resolve().parent
PACKAGE = Path(kinoedu.__file__).resolve().parent
BOX = [(0, 0), (10, 0), (10, 10), (0, 10)]
needs_compiler = pytest.mark.skipif(not HAS_COMPILER, reason="numba is absent or switched off")


def problems() -> dict[str, Any]:
    """Problems of round robots in every kind of world, with walls, discs and a clearance."""
    walls = PolygonWorld(
        [(0, 0), (10, 0), (10, 10), (5, 9), (0, 10)],
        [
            [(4, 0), (6, 0), (6, 8), (4, 8)],
            ((8, 6), 1),
            ([(1, 4), (3, 4), (3, 7), (1, 7)], [[(1.5, 4.5), (2.5, 4.5), (2, 6)]]),
        ],
    )
    cells = np.random.default_rng(1).random((20, 30)) < 0.85
    cells[0, 0] = cells[-1, -1] = True
    cells[:2, :2] = cells[-2:, -2:] = True
    terrain = Terrain(cells, resolution=0.5, origin=(-1, 2))
    return {
        "point among polygons": Problem(Point(), walls, (1, 1), (9, 1)),
        "disk among polygons": Problem(Disk(0.3), walls, (1, 1), (9, 1), clearance=0.1),
        "point on a terrain": Problem(Point(), terrain, (-0.75, 2.25), (13.75, 11.75)),
        "disk on a terrain": Problem(
            Disk(0.05), terrain, (-0.75, 2.25), (13.75, 11.75), clearance=0.01
        ),
        "a goal out of reach": Problem(
            Point(), PolygonWorld(BOX, [[(4, 0), (6, 0), (6, 10), (4, 10)]]), (1, 1), (9, 1)
        ),
    }


def digest(plan: Any) -> str:
    """A digest of all bits of a plan's tree, path, cost and statistics."""
    path = b"" if plan.path is None else plan.path.tobytes()
    results = json.dumps([plan.stats, plan.cost], sort_keys=True).encode()
    return hashlib.sha256(
        plan.tree.nodes.tobytes() + plan.tree.parent.tobytes() + path + results
    ).hexdigest()


def digests(wrapped: Any = lambda problem: problem, nodes: int = 450) -> dict[str, str]:
    """A digest for each problem; the trees are large enough to use buckets."""
    return {
        f"{name}, seed {seed}": digest(
            rrt(wrapped(problem), step_size=0.4, max_nodes=nodes, max_iterations=1500, rng=seed)
        )
        for name, problem in problems().items()
        for seed in (0, 1)
    }


def run(code: str, *, path: Path = PACKAGE.parent, **variables: str) -> Any:
    """The last line that a separate Python process prints, as JSON."""
    environment = {
        **os.environ,
        "PYTHONPATH": os.pathsep.join([str(path), str(TESTS)]),
        **variables,
    }
    command = [sys.executable, "-c", code]  # imports modules of the current folder first
    done = subprocess.run(
        command,
        env=environment,
        cwd=TESTS,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout.splitlines()[-1])


PLAN = "import json, test_compiled as t; print(json.dumps([t.HAS_COMPILER, t.digests()]))"


@pytest.fixture(scope="module")
def trees() -> dict[str, str]:
    """The digests for machine code, which every other way must reproduce."""
    with running(COMPILED_FIRST):
        return digests()


# ---- one algorithm -----------------------------------------------------------------------------


def test_a_recorder_grows_the_very_same_tree(trees: dict[str, str]) -> None:
    """The algorithm is interpreted with a recorder in place of the problem."""
    assert digests(Recorder) == trees


def test_the_trees_are_worth_comparing() -> None:
    """Some problems are solved and one is not, and the trees are large enough to use buckets."""
    plans = {
        name: rrt(problem, step_size=0.4, max_nodes=450, max_iterations=1500, rng=0)
        for name, problem in problems().items()
    }
    assert plans["a goal out of reach"].path is None
    assert plans["a goal out of reach"].stats["nodes"] > 400
    assert plans["point among polygons"].path is not None
    assert all(plan.stats["nodes"] > 50 for plan in plans.values())


def test_interpreted_the_very_same_tree_grows(trees: dict[str, str]) -> None:
    """The same source, interpreted with all functions it calls."""
    with running(INTERPRETED):
        assert digests() == trees


@needs_compiler
def test_the_python_function_grows_the_very_same_tree() -> None:
    """`grow.py_func` with the record itself, without a recorder."""
    from kinoedu.geometry.checks import as_generator
    from kinoedu.spaces.buckets import empty_tree

    for problem in problems().values():
        grown = []
        for body in (grow, grow.py_func):
            tree = empty_tree(451, problem.space.lo, problem.space.hi)
            answer = body(problem, tree, 0.4, 0.05, 1500, as_generator(2))
            n = int(tree.size[0])
            grown.append(
                (tuple(map(int, answer)), tree.nodes[:n].tobytes(), tree.parent[:n].tobytes())
            )
        assert grown[0] == grown[1]


@needs_compiler
def test_numba_switched_off_grows_the_very_same_tree(trees: dict[str, str]) -> None:
    """NUMBA_DISABLE_JIT=1, as for a debugger or coverage."""
    assert run(PLAN, NUMBA_DISABLE_JIT="1") == [False, trees]


def test_without_numba_kinoedu_imports_and_grows_the_very_same_tree(trees: dict[str, str]) -> None:
    """In a process where numba cannot be imported."""
    assert run(f"import sys; sys.modules['numba'] = None; {PLAN}") == [False, trees]


def test_a_recorder_records_all_queries() -> None:
    """As many motions as the statistics count; every edge of the tree is among the free ones."""
    recorder = Recorder(problems()["point among polygons"])
    plan = rrt(recorder, step_size=0.4, max_nodes=200, rng=0)
    queries = [query for query in recorder.log if query.name == "is_free_path"]
    assert len(queries) == plan.stats["checks"] == recorder.counts()["is_free_path"]
    found = {(tuple(q.given[0]), tuple(q.given[1])) for q in queries if q.answer}
    for node, parent in zip(plan.tree.nodes[1:], plan.tree.parent[1:], strict=True):
        assert (tuple(plan.tree.nodes[parent]), tuple(node)) in found


class PlainProblem:
    """A user's own problem: a plain object with the six names that a planner needs."""

    def __init__(self, problem: Any) -> None:
        self.start, self.goal = tuple(problem.start), list(problem.goal)
        self._problem = problem

    def sample(self, rng: np.random.Generator) -> Any:
        lo, hi = self._problem.world.lo, self._problem.world.hi
        return np.array(
            [lo[0] + (hi[0] - lo[0]) * rng.random(), lo[1] + (hi[1] - lo[1]) * rng.random()]
        )

    def distance(self, a: Any, b: Any) -> float:
        return float(np.sqrt((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1])))

    def steer(self, a: Any, b: Any, step: float) -> Any:
        whole = self.distance(a, b)
        return (
            np.array(b)
            if whole <= step
            else np.array([a[i] + step / whole * (b[i] - a[i]) for i in range(2)])
        )

    def is_free_path(self, a: Any, b: Any) -> bool:
        return bool(
            is_free_path(
                self._problem.robot,
                self._problem.world,
                np.asarray(a),
                np.asarray(b),
                self._problem.clearance,
            )
        )


def test_a_users_own_problem_grows_the_very_same_tree(trees: dict[str, str]) -> None:
    """The tree is the same, also through a recorder."""
    assert digests(PlainProblem) == trees


def test_what_a_users_problem_lacks_is_named() -> None:
    """InvalidParameter lists the missing names."""
    with pytest.raises(InvalidParameter, match=r"lacks sample, distance, steer, is_free_path"):
        rrt(type("Half", (), {"start": (0, 0), "goal": (1, 1)})(), rng=0)


def test_a_planner_leaves_its_problem_as_it_was() -> None:
    """Only the count of queries changes, and no array that the problem still holds is released."""
    problem = problems()["point among polygons"]
    held = [
        problem.start,
        problem.goal,
        problem.world.edges,
        problem.world.obstacles.points,
        problem.space.lo,
    ]
    before, counts = [array.copy() for array in held], [sys.getrefcount(array) for array in held]
    plans = [rrt(problem, rng=seed) for seed in range(5)]
    del plans
    assert [sys.getrefcount(array) for array in held] == counts
    assert all((now == then).all() for now, then in zip(held, before, strict=True))
    assert problem.query_counts[0] > 0


# ---- generic functions -------------------------------------------------------------------------


@record
class Cat(NamedTuple):
    """A record defined in this file."""

    weight: float

    def heavier(self, by: float) -> float:
        """A method that compiled code can call."""
        return self.weight + by

    @property
    def paws(self) -> float:
        """A property that compiled code can read."""
        return 4.0 * self.weight


@record
class Dog(NamedTuple):
    """Another record with a method of the same name."""

    weight: float

    def heavier(self, by: float) -> float:
        """Another answer."""
        return self.weight + 2.0 * by


class Fly(NamedTuple):
    """A record whose fields have the names of a method and a property of others."""

    paws: float
    heavier: float


@generic(2)
def noise(first: Any, second: Any, loudness: float) -> float:
    """The noise that two animals make; by default none."""
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


@compiled
def paws_of(animal: Any) -> float:
    """A compiled reader of a property or a field."""
    return animal.paws


@compiled
def heaviness_of(animal: Any) -> float:
    """A compiled reader of a field."""
    return animal.heavier


def test_each_pair_of_kinds_has_its_own_implementation() -> None:
    """The order of the pair counts, and pairs without an implementation use the default."""
    cat, dog = Cat(3.0), Dog(7.0)
    for first, second, expected in (
        (cat, dog, 6.0),
        (dog, cat, -14.0),
        (cat, cat, 0.0),
        (dog, dog, 0.0),
    ):
        assert (
            noise(first, second, 2.0)
            == noise_of(first, second, 2.0)
            == noise_of.py_func(first, second, 2.0)
            == expected
        )
    assert noise("anything", None, 2.0) == 0.0


def test_methods_of_one_name_belong_to_their_records() -> None:
    """Compiled code calls the method of the record that it is given."""
    for animal, expected in ((Cat(3.0), 4.0), (Dog(7.0), 9.0)):
        assert (
            animal.heavier(1.0)
            == heavier_of(animal, 1.0)
            == heavier_of.py_func(animal, 1.0)
            == expected
        )


def test_properties_are_read_and_hide_no_fields() -> None:
    """Compiled code reads a property, and other records' fields of that name or of a method's."""
    cat, fly = Cat(3.0), Fly(6.0, 0.5)
    with running(COMPILED_FIRST):
        assert (paws_of(cat), paws_of(fly), heaviness_of(fly)) == (12.0, 6.0, 0.5)
        assert heavier_of(cat, 1.0) == 4.0
    if HAS_COMPILER:
        ran = [*paws_of.specializations.values(), *heaviness_of.specializations.values()]
        assert all(one.is_loaded for one in ran)
    assert (paws_of.py_func(cat), paws_of.py_func(fly)) == (12.0, 6.0)


@needs_compiler
def test_kinds_are_assumed_for_a_short_time() -> None:
    """Arguments of the same classes and other kinds get the same answers; soon they are noticed."""

    def largest(values: Array) -> float:
        most = values[0]
        for value in values:
            most = max(most, value)
        return most

    ask, arrays = compiled(largest), (np.array([1.0, 3.0]), np.array([2, 5]), np.array([4.0])[::-1])
    assert [ask(values) for values in arrays] == [3.0, 5, 4.0]
    (first,) = ask.specializations.values()  # type: ignore[attr-defined]
    first.assumed_until = 0.0  # as after some interpreting
    assert [ask(values) for values in arrays[1:]] == [5, 4.0]
    assert len(ask.specializations) == 2  # type: ignore[attr-defined]
    with running(COMPILED_FIRST):
        assert [ask(values) for values in arrays] == [3.0, 5, 4.0]
    assert all(one.is_loaded for one in ask.specializations.values())  # type: ignore[attr-defined]


@needs_compiler
def test_calls_stay_interpreted_until_machine_code_is_there(monkeypatch, tmp_path) -> None:
    """While numba is imported and loads in its thread, no other thread calls it."""
    from kinoedu.compiled import machine

    ask = cast(Any, compiled(lambda value: value))
    call = tiers.Specialization(ask, (kind_of(1.0),))
    call.__dict__["file"] = tmp_path / "any.code"
    while_loading = []
    monkeypatch.setattr(machine, "load", lambda *_: while_loading.append(ask.machine))
    call.load_here()
    assert while_loading == [None]
    assert ask.machine is not None
    assert call.is_loaded


def test_a_pair_is_implemented_once() -> None:
    """DuplicateKind names the function and the kinds, for this file and for the package."""
    with pytest.raises(DuplicateKind, match=r"noise.*Cat, Dog"):
        noise.register(Cat, Dog)(bark)
    with pytest.raises(DuplicateKind, match=r"is_free_path.*RoundRobot, PolygonWorldRecord"):
        is_free_path.register(RoundRobot, PolygonWorldRecord)(lambda *_: True)
    assert noise(Cat(3.0), Dog(7.0), 2.0) == 6.0


def test_a_robot_that_no_world_knows_is_a_type_error() -> None:
    """The default of a collision query raises an error."""
    with pytest.raises(TypeError, match="no motions are defined"):
        is_free_path(
            Cat(1.0), problems()["point among polygons"].world, np.zeros(2), np.ones(2), 0.0
        )


# ---- restarts as machine code ------------------------------------------------------------------


class Impatient(WatchedCall):
    """A watch that interrupts the interpreted call after some checks."""

    looks = ended = 0

    def check(self) -> None:
        """Count down."""
        self.waits = getattr(self, "waits", Impatient.looks) - 1
        if self.waits < 0:
            Impatient.ended += 1
            self.interrupt()


@needs_compiler
def test_algorithms_return_arrays_of_their_own(monkeypatch) -> None:
    """Machine code borrows its arguments: what it returned of them would soon be lost memory."""
    called, lending = set(), set()
    usual = tiers.TieredFunction.__call__

    def call(self: Any, *args: Any) -> Any:
        result = usual(self, *args)
        if self.is_algorithm:
            called.add(self.__name__)
            if any(
                np.may_share_memory(*pair) for pair in product(arrays_in(args), arrays_in(result))
            ):
                lending.add(self.__name__)
        return result

    monkeypatch.setattr(tiers.TieredFunction, "__call__", call)
    for _, job, *given in chain(first_jobs(), later_jobs()):
        job(*given)
    arm_board(TwoLinkArm(1.5, 1.2, 0.2, base=(5, 5)), PolygonWorld(BOX, [((6, 7), 0.4)]))
    assert {"grow", "pose_arm", "paint_image"} <= called
    assert not lending


def arrays_in(value: Any) -> list[np.ndarray]:
    """The arrays in a value, also within tuples."""
    if isinstance(value, tuple):
        return [array for item in value for array in arrays_in(item)]
    return [value] if isinstance(value, np.ndarray) and value.size else []


@needs_compiler
@pytest.mark.parametrize("looks", [0, 1, 2, 3, 5, 8])
def test_restarts_as_machine_code_give_the_same_tree(trees, looks, monkeypatch) -> None:
    """An interpreted call is interrupted at any time and restarted, with identical results."""
    import kinoedu.compiled.numba_thread as keeper

    monkeypatch.setattr(keeper, "WatchedCall", Impatient)
    monkeypatch.setattr(keeper, "POLL_INTERVAL", 0.004)
    monkeypatch.setattr(Impatient, "looks", looks)
    monkeypatch.setattr(Impatient, "ended", 0)
    monkeypatch.setattr(
        tiers.Specialization, "run", lambda self, args: self.interpret_or_restart(args)
    )
    monkeypatch.setattr(tiers.TieredFunction, "__call__", interpreted_at_first)
    assert digests() == trees
    assert Impatient.ended > 0 or looks > 0  # on a busy computer later looks may come too late


def interpreted_at_first(self: Any, *args: Any) -> Any:
    """Interpret an algorithm though its machine code is loaded; the restart uses machine code."""
    if tiers.thread_state.interpreting:
        return self.py_func(*args)
    if self.is_algorithm and kinds_of(args) is not None:
        specialization = self.specializations[kinds_of(args)]
        assert specialization.is_loaded
        return specialization.run(args)
    return self.without_machine_code(*args) if self.machine is None else self.machine(*args)


@needs_compiler
def test_a_restart_begins_with_the_original_arguments() -> None:
    """Arrays, also inside records, and a generator's state."""
    given = (np.arange(3.0), (np.zeros(2, np.int64), 1.5), np.random.default_rng(4), 7)
    saved = saved_state.copy_state(given)
    given[0][:], given[1][0][1] = -1.0, 5
    drawn = given[2].random()
    saved_state.restore_state(given, saved)
    assert (
        given[0].tolist() == [0.0, 1.0, 2.0]
        and given[1][0].tolist() == [0, 0]
        and given[2].random() == drawn
    )


@needs_compiler
def test_an_error_is_raised_though_machine_code_is_loaded(monkeypatch) -> None:
    """The same holds for Ctrl-C at that moment."""
    import kinoedu.compiled.numba_thread as keeper

    @tiers.algorithm
    def fails(x):
        raise KeyboardInterrupt

    def told_at_the_end(self):
        raise keeper.MachineCodeLoaded

    monkeypatch.setattr(WatchedCall, "close", told_at_the_end)
    specialization = tiers.Specialization(fails, kinds_of((1.0,)))
    with pytest.raises(KeyboardInterrupt):
        specialization.interpret_or_restart((1.0,))


@needs_compiler
def test_an_exception_that_the_caller_handles_is_not_raised_again(monkeypatch) -> None:
    """A call within `except` is restarted as any other."""
    import kinoedu.compiled.numba_thread as keeper

    @tiers.algorithm
    def twice(x):
        return x + x

    def told_at_the_end(self):
        raise keeper.MachineCodeLoaded

    monkeypatch.setattr(WatchedCall, "close", told_at_the_end)
    monkeypatch.setattr(twice, "machine", lambda x: 2.0 * x)
    specialization = tiers.Specialization(cast(Any, twice), (kind_of(1.0),))
    try:
        raise KeyError("handled")
    except KeyError:
        assert specialization.interpret_or_restart((1.0,)) == 2.0


# ---- kinds -------------------------------------------------------------------------------------

VALUES = [
    1,
    True,
    2.5,
    np.float64(2.5),
    np.int64(3),
    np.int32(3),
    np.float32(1.5),
    np.bool_(True),
    np.uint8(4),
    np.zeros((2, 3)),
    np.zeros((2, 3), order="F"),
    np.zeros((4, 6))[::2, ::2],
    np.zeros(3, np.int64),
    np.zeros(3, bool),
    np.broadcast_to(np.zeros(3), (2, 3)),
    np.frombuffer(b"12345678", np.uint8),
    (1, 2.0),
    (1, 2),
    (),
    None,
    np.random.default_rng(0),
    *problems().values(),
]


@needs_compiler
@pytest.mark.parametrize("value", VALUES, ids=lambda value: type(value).__name__)
def test_kinds_agree_with_the_types_of_numba(value: Any) -> None:
    """So machine code found by kinds fits the arguments."""
    import numba

    from kinoedu.compiled.machine import numba_type

    assert numba_type(kind_of(value)) == numba.typeof(value)


def test_kinds_are_told_apart_by_their_names() -> None:
    """Different kinds have different file names."""
    kinds = {kind_of(value) for value in VALUES}
    assert len({spell_kind(kind) for kind in kinds}) == len(kinds)


@pytest.mark.parametrize(
    "value", ["text", [1.0], 2**63, np.zeros(2, object), np.zeros(2, complex), {}, int]
)
def test_values_without_a_kind_are_interpreted(value: Any) -> None:
    """Such a call still works."""

    @compiled
    def same(x):
        return x

    assert kinds_of((value,)) is None
    assert same(value) is value


# ---- the folder of machine code ----------------------------------------------------------------

ORIENT = """
import json, sys
from kinoedu.compiled import requests, store
from kinoedu.geometry import orientation
from kinoedu.geometry.exact import orientation_sign
found = orientation((0, 0), (1, 0), (0, 1))
loaded = any(call.is_loaded for call in orientation_sign.specializations.values())
has_started, folder = requests.started != {}, str(store.folder())
print(json.dumps([found, loaded, has_started, folder, "numba" in sys.modules]))
"""


def orient(*, cache: Path, mode: str = "when-it-pays", **variables: str) -> Any:
    """Run a process and return what it prints.

    That is its answer, whether it ran machine code, whether it started a worker, its folder, and
    whether it imported numba.
    """
    code = variables.pop("code", ORIENT)
    path = Path(variables.pop("path", PACKAGE.parent))
    return run(code, path=path, KINOEDU_CACHE=str(cache), KINOEDU_MACHINE_CODE=mode, **variables)


@pytest.fixture(scope="module")
def compiled_once(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A cache with machine code of one function, compiled in a separate process."""
    cache = tmp_path_factory.mktemp("compiled")
    assert orient(cache=cache, mode="first")[:3] == [1, True, True]
    return cache


LONG_AT_WORK = """
import kinoedu.compiled.tiers as t
t.interpreted.seconds = 9
"""
IMPORTED = """
import kinoedu.compiled.machine
from kinoedu.compiled.numba_thread import NUMBA_THREAD
NUMBA_THREAD.has_numba = True
"""
PATIENT = LONG_AT_WORK + IMPORTED + ORIENT


@needs_compiler
def test_machine_code_of_one_process_is_used_by_the_next(
    compiled_once: Path, tmp_path: Path
) -> None:
    """Compiled once in a separate process, then loaded by others, also by a copy of the sources.

    The copy was unpacked in another time zone, so that its dates are in the future. A process with
    little to do does not load it.
    """
    cache = compiled_once
    copy = tmp_path / "elsewhere" / "kinoedu"
    shutil.copytree(PACKAGE, copy, ignore=shutil.ignore_patterns("__pycache__"))
    os.utime(copy / "geometry" / "exact.py", (time.time() + 5 * 3600.0,) * 2)
    for place in (PACKAGE.parent, copy.parent):
        assert orient(cache=cache, code=PATIENT, path=str(place))[:3] == [1, True, False]
    assert orient(cache=cache)[:3] == [1, False, False]
    assert orient(cache=cache, mode="never", code=PATIENT)[:3] == [1, False, False]


@needs_compiler
def test_no_call_waits_for_the_import_of_numba(compiled_once: Path) -> None:
    """The call that begins the import is interpreted; machine code is loaded behind it."""
    code = """
import threading
from kinoedu.compiled.numba_thread import NUMBA_THREAD
release = threading.Event()
NUMBA_THREAD.submit(release.wait)  # the thread is busy, as with an import
"""
    answered = """
release.set()
NUMBA_THREAD.run_and_wait(lambda: None)
(call,) = orientation_sign.specializations.values()
print(json.dumps([found, loaded, call.is_loaded, orientation((0, 0), (1, 0), (0, 1))]))
"""
    asked = ORIENT.replace("print(", "assert (", 1)
    assert orient(cache=compiled_once, code=LONG_AT_WORK + code + asked + answered) == [
        1,
        False,
        True,
        1,
    ]


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there are no forks")
def test_a_fork_waits_until_machine_code_is_loaded() -> None:
    """Otherwise the child would have half of numba, and no machine code from then on.

    Parent and child can both use the thread afterwards, and the thread can itself fork.
    """
    code = """
import json, os, threading, time
from kinoedu.compiled.numba_thread import NUMBA_THREAD

def fork_and_wait():
    child = os.fork()
    if child == 0:
        NUMBA_THREAD.run_and_wait(lambda: done.append("child"))
        os._exit(len(done))
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])

def import_slowly():
    begun.set()
    time.sleep(0.5)
    done.append("import")

done, begun = [], threading.Event()
NUMBA_THREAD.submit(import_slowly)
begun.wait()
codes = [fork_and_wait(), fork_and_wait()]
NUMBA_THREAD.run_and_wait(lambda: codes.append(fork_and_wait()))
print(json.dumps([codes, done]))
"""
    assert run(code) == [[2, 2, 2], ["import"]]


@needs_compiler
def test_an_expensive_call_is_compiled_by_another_process(tmp_path: Path) -> None:
    """A call over its budget requests machine code, which the same process then runs."""
    code = """
import json, time, kinoedu.compiled.tiers as t
from kinoedu.compiled import requests
t.BUDGET, t.IMPORTING, t.LOOK_AGAIN = 0.0, 0.0, 0.0
# it would wait long on a busy computer
request = requests.request_compilation
requests.request_compilation = lambda place, queue, call: request(place, "awaited", call)
from kinoedu.geometry import orientation
from kinoedu.geometry.exact import orientation_sign
answers, last = set(), time.monotonic() + 250
while True:
    answers.add(orientation((0, 0), (1, 0), (0, 1)))
    (call,) = orientation_sign.specializations.values()
    if call.is_loaded or time.monotonic() > last:
        break
    time.sleep(0.05)
print(json.dumps([sorted(answers), call.is_loaded, call.requested_after > 0]))
"""
    assert orient(cache=tmp_path, code=code) == [[1], True, True]


@needs_compiler
def test_a_request_that_is_lost_is_repeated(monkeypatch) -> None:
    """A worker that ends may leave a request behind; it is repeated as the time spent doubles."""
    asked: list[float] = []
    call = tiers.Specialization(orientation_sign, ("f8",) * 6)
    monkeypatch.setattr(NUMBA_THREAD, "submit", lambda _: asked.append(call.requested_after))
    for tenths in range(200):
        call.request_after(tenths / 10)
    assert asked == [2.1, 4.3, 8.7, 17.5]


@needs_compiler
@pytest.mark.parametrize("queue", [store.WANTED, store.AWAITED])
def test_a_request_goes_to_the_worker_of_its_queue(monkeypatch, queue) -> None:
    """Beside other programs a call would wait ten times as long for a worker that gives way."""
    started: list[str] = []
    call = tiers.Specialization(orientation_sign, ("f8",) * 6)
    monkeypatch.setattr(NUMBA_THREAD, "submit", lambda work: work())
    monkeypatch.setattr(requests, "is_there", lambda place, request: False)
    monkeypatch.setattr(requests, "write_request", lambda queue, request: None)
    monkeypatch.setattr(requests, "start_worker", lambda place, queue, slot: started.append(queue))
    call.request_after(3.0, queue)
    assert started == [queue]


@needs_compiler
def test_what_is_compiled_ahead_takes_the_process_of_single_requests_too(monkeypatch) -> None:
    """Each process more types again what others have typed: a sixth more work for all of them."""
    started = set[int]()
    single, *others = (
        Request("kinoedu.geometry.exact", "f", (kind,)) for kind in ("f8", "i8", "b1")
    )
    monkeypatch.setattr(requests, "is_refused", lambda place, request: False)
    monkeypatch.setattr(requests, "is_there", lambda place, request: len(started) > 1)
    monkeypatch.setattr(requests, "write_request", lambda queue, request: None)
    monkeypatch.setattr(requests, "start_worker", lambda place, queue, slot: started.add(slot))
    place = Path()
    requests.compile_all(place, store.AWAITED, others, workers=2)
    both = started.copy()
    started.clear()
    assert requests.request_compilation(place, store.AWAITED, single) and started < both


@needs_compiler
def test_what_is_compiled_ahead_does_not_delay_a_call_that_waits(tmp_path, monkeypatch) -> None:
    """The worker of such calls leaves the older requests, for which nobody waits, to the others."""
    from kinoedu.compiled import worker

    monkeypatch.setattr(store, "user_cache", lambda: tmp_path)
    place = store.folder.__wrapped__()
    ahead = [Request("kinoedu.geometry.exact", "orientation_sign", ("f8",) * n) for n in range(3)]
    call = Request("kinoedu.geometry.exact", "orientation_sign", ("f8",) * 6)
    for request in ahead:
        store.write_request(place / store.WANTED, request)
    store.write_request(place / store.AWAITED, call)
    compiled: list[str] = []
    monkeypatch.setattr(store, "folder", lambda: place)
    monkeypatch.setattr(worker, "LINGER", 0.2)
    monkeypatch.setattr(worker.signal, "signal", lambda *_: None)
    monkeypatch.setattr(worker, "compile_request", lambda queue, file: compiled.append(file.name))
    assert worker.main([str(place), store.AWAITED, "0"]) == 0
    assert compiled == [call.name]
    assert len(store.pending_requests(place / store.WANTED)) == len(ahead)


@pytest.mark.skipif(not hasattr(os, "nice"), reason="priorities of Windows have no numbers")
def test_the_worker_behind_gives_way_also_to_other_sessions() -> None:
    """By its own priority, and by that of its session where the system shares between those."""
    code = """
import json, os
from kinoedu.compiled.worker import AUTOGROUP, lower_priority
before = os.nice(0)
lower_priority()
session = AUTOGROUP.read_text().split()[-1] if AUTOGROUP.exists() else "10"
print(json.dumps([os.nice(0) == min(before + 10, 19), session]))  # 19 is the least priority
"""
    command = [sys.executable, "-c", code]
    done = subprocess.run(command, capture_output=True, check=True, start_new_session=True)
    assert json.loads(done.stdout) == [True, "10"]


@needs_compiler
def test_a_first_plan_imports_no_compiler(tmp_path: Path) -> None:
    """Importing kinoedu does not import it either."""
    code = (
        "import sys, kinoedu; before = 'numba' in "
        f"sys.modules\n{OWN_WORLD}\nprint(json.dumps([before, 'numba' in sys.modules]))"
    )
    assert orient(cache=tmp_path, code=code) == [False, False]


OWN_WORLD = """
import json
from kinoedu import Point, PolygonWorld, Problem, rrt
world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [[(4, 0), (6, 0), (6, 8), (4, 8)]])
assert rrt(Problem(Point(), world, start=(1, 1), goal=(9, 1)), rng=0).path is not None
"""


@needs_compiler
def test_a_folder_that_cannot_be_written_is_no_error(tmp_path: Path) -> None:
    """A file instead of the folder or its parent, or a read-only folder: the answers are right."""
    taken = tmp_path / "taken"
    taken.write_text("a file", encoding="utf-8")
    places = [taken, taken / "below"]
    if os.name == "posix" and os.getuid() != 0:  # root can write everywhere
        sealed = tmp_path / "sealed"
        sealed.mkdir(mode=0o500)
        places.append(sealed)
    for place in places:
        assert orient(cache=place)[:4] == [1, False, False, "None"]
    assert orient(cache=taken, mode="first")[:4] == [
        1,
        True,
        False,
        "None",
    ]  # compiled in this process, as KINOEDU_MACHINE_CODE says
    assert taken.read_text(encoding="utf-8") == "a file"


@needs_compiler
def test_a_new_folder_starts_as_a_copy_of_the_warmed_one(
    compiled_once: Path, tmp_path: Path
) -> None:
    """They get a private copy, and nothing is compiled again; an invalid folder is ignored."""
    warmed, own = tmp_path / "warmed", tmp_path / "own"
    shutil.copytree(compiled_once, warmed)
    for path in warmed.rglob("*"):
        path.chmod(0o555 if path.is_dir() else 0o444)
    answer, is_loaded, compiles, folder, _ = orient(
        cache=own, code=PATIENT, KINOEDU_WARMED=str(warmed)
    )
    assert (answer, is_loaded, compiles) == (1, True, False)
    assert Path(folder).parent == own and (
        os.name != "posix" or Path(folder).stat().st_mode & 0o777 == 0o700
    )
    assert orient(cache=tmp_path / "another", KINOEDU_WARMED=__file__)[:2] == [1, False]


@needs_compiler
def test_a_change_in_a_callee_is_never_ignored(tmp_path: Path) -> None:
    """The innermost function of a copy of the package is edited between two processes."""
    copy = tmp_path / "site" / "kinoedu"
    shutil.copytree(PACKAGE, copy, ignore=shutil.ignore_patterns("__pycache__"))
    cache, where = tmp_path / "cache", {"path": str(copy.parent)}
    assert orient(cache=cache, mode="first", **where)[:2] == [1, True]
    callee = copy / "geometry" / "exact.py"
    source = callee.read_text(encoding="utf-8")
    edited = source.replace("return 1 if det > 0.0 else -1", "return -1 if det > 0.0 else 1", 1)
    assert edited != source
    callee.write_text(edited, encoding="utf-8")
    assert orient(cache=cache, mode="first", **where)[:2] == [-1, True]
    callee.write_text(source, encoding="utf-8")
    assert orient(cache=cache, code=PATIENT, **where)[:2] == [1, True]
    assert len([folder for folder in cache.iterdir() if folder.is_dir()]) == 2


@needs_compiler
def test_damaged_code_is_not_run(compiled_once: Path, tmp_path: Path) -> None:
    """A file with a wrong bit, a truncated one, or one of another computer is removed.

    The call is interpreted.
    """
    shutil.copytree(compiled_once, tmp_path, dirs_exist_ok=True)
    (file,) = tmp_path.rglob("*.code")
    whole = file.read_bytes()
    middle = len(whole) // 2
    flipped = whole[:middle] + bytes([whole[middle] ^ 1]) + whole[middle + 1 :]
    for damaged in (whole[:1000], b"", b"x" * 100, whole.replace(b"0.", b"9.", 1), flipped):
        file.write_bytes(damaged)
        assert orient(cache=tmp_path, code=PATIENT)[:2] == [1, False]
        assert not file.exists()


@needs_compiler
def test_what_cannot_be_compiled_stays_interpreted(tmp_path: Path, monkeypatch) -> None:
    """The same holds for a function whose compilation repeatedly ended its process."""
    import pickle

    from kinoedu.compiled.worker import retry_unfinished

    monkeypatch.setattr(store, "user_cache", lambda: tmp_path)
    place = store.folder.__wrapped__()
    impossible = Request("kinoedu.geometry.exact", "orientation_sign", ("none",) * 6)
    assert requests.compile_all(place, store.WANTED, [impossible], workers=1) == [impossible]
    assert "none" in (place / f"{impossible.name}.refused").read_text()
    assert not requests.request_compilation(place, store.WANTED, impossible)
    deadly = Request("kinoedu.geometry.exact", "orientation_sign", ("f8",) * 6)
    taken = place / "taken-7"
    taken.mkdir()
    for attempt in range(3):
        (taken / deadly.name).write_bytes(pickle.dumps(deadly._replace(attempts=attempt)))
        retry_unfinished(place / store.WANTED, taken)
        assert requests.is_refused(place, deadly) == (attempt == 2)
        assert not list(taken.iterdir())


@needs_compiler
def test_where_nothing_can_be_requested_a_call_that_waits_is_interpreted(tmp_path) -> None:
    """The disk was full, say; the user's call gets its answer."""
    full = """
from kinoedu.compiled import requests

def no_space(*_):
    raise OSError(28, "No space left on device")

requests.write_request = no_space
"""
    assert orient(cache=tmp_path, mode="first", code=full + ORIENT)[:3] == [
        1,
        False,
        False,
    ]


@needs_compiler
@pytest.mark.parametrize("error", [OSError(28, "No space left on device"), MemoryError, SystemExit])
def test_what_stops_a_worker_from_outside_refuses_no_request(tmp_path, monkeypatch, error) -> None:
    """After a full disk, little memory or Ctrl-C, however often, a function is still compiled."""
    from kinoedu.compiled import compiler, worker

    def stop(function, kinds):
        raise error

    monkeypatch.setattr(store, "user_cache", lambda: tmp_path)
    monkeypatch.setattr(compiler, "compile_entry", stop)
    place = store.folder.__wrapped__()
    queue, taken = place / store.AWAITED, place / "taken-7"
    request = Request("kinoedu.geometry.exact", "orientation_sign", ("f8",) * 6)
    store.write_request(queue, request)
    for _ in range(2 * worker.ATTEMPTS):
        worker.retry_unfinished(queue, taken)
        with pytest.raises((OSError, MemoryError, SystemExit)):
            worker.compile_request(queue, worker.take_request(queue, taken))
        assert requests.is_pending(place, request)


def test_only_known_modes_are_accepted() -> None:
    """Other modes are refused; a block restores the mode, also when it fails."""
    before = modes.mode
    with pytest.raises(ValueError, match="first"), running("fast"):
        pass
    with pytest.raises(KeyError), running(INTERPRETED):
        raise KeyError
    assert modes.mode == before


OWN_ROBOT = """
from typing import NamedTuple
import numpy as np
from kinoedu.collision import is_free_path
from kinoedu.problems.configurations import space_of
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
from kinoedu.compiled import COMPILED_FIRST, INTERPRETED, running
from kinoedu.planners.trees.rrt import grow
problem = Problem(mine.Ghost(1.0), Terrain(np.ones((10, 10))), START, GOAL)
plans = [rrt(problem, rng=0, max_nodes=100), rrt(Recorder(problem), rng=0, max_nodes=100)]
(call,) = grow.specializations.values()
loaded = [call.is_loaded]
with running(COMPILED_FIRST):
    plans.append(rrt(problem, rng=0, max_nodes=100))
loaded.append(call.is_loaded)
assert all(plan.tree.nodes.tolist() == plans[0].tree.nodes.tolist() for plan in plans)
print(json.dumps([plans[0].tree.nodes[:, 0].min(), plans[0].tree.nodes[:, 0].max(), loaded]))
"""


@needs_compiler
def test_records_of_a_users_file_work_both_ways_and_are_never_stale(
    tmp_path: Path,
) -> None:
    """A robot of a user's file works both ways, edits take effect, and nothing is stored."""
    cache = str(tmp_path / "cache")
    (tmp_path / "mine.py").write_text(OWN_ROBOT.replace("LIMIT", "<"), encoding="utf-8")
    paths = {
        "PYTHONPATH": os.pathsep.join([str(PACKAGE.parent), str(tmp_path)]),
        "PYTHONDONTWRITEBYTECODE": "1",
    }
    low, high, loaded = run(
        OWN_PLAN.replace("START", "(1, 1)").replace("GOAL", "(5, 9)"), KINOEDU_CACHE=cache, **paths
    )
    assert 0.0 <= low < high < 6.0
    assert loaded == [False, True]
    (tmp_path / "mine.py").write_text(OWN_ROBOT.replace("LIMIT", ">"), encoding="utf-8")
    low, high, loaded = run(
        OWN_PLAN.replace("START", "(9, 1)").replace("GOAL", "(7, 9)"), KINOEDU_CACHE=cache, **paths
    )
    assert 6.0 < low < high <= 10.0
    assert loaded == [False, True]
    assert not list(Path(cache).rglob("*grow*.code"))


# ---- into and out of machine code ---------------------------------------------------------------


class Middle(NamedTuple):
    """A result with an array inside a named tuple."""

    point: Array
    i: int


class Drawn(NamedTuple):
    """A result with a named tuple inside."""

    middle: Middle
    x: float


@compiled
def draw(rng: np.random.Generator, scale: Array) -> Drawn:
    """Arrays, named tuples and a generator go in and out."""
    return Drawn(Middle(scale * rng.random(), rng.integers(0, 5)), rng.random())


def stop_draws(times: int) -> tuple[int, list[str]]:
    """How many of the threads that draw stop when told, and what the others raise."""
    scale, pause = np.arange(3.0), np.random.default_rng(1)
    stops, others = [], []

    def draw_until_stopped() -> None:
        try:
            started.set()  # what is told earlier would end the thread outside of this function
            rng = np.random.default_rng(0)
            while True:
                draw(rng, scale)
        except StopThread:
            stops.append(1)
        except BaseException as error:
            others.append(repr(error))

    with running(COMPILED_FIRST):
        draw(np.random.default_rng(0), scale)
        for _ in range(times):
            started = threading.Event()
            thread = threading.Thread(target=draw_until_stopped)
            thread.start()
            started.wait()
            time.sleep(5e-4 * pause.random())
            raise_in(cast(int, thread.ident), StopThread)
            thread.join()
    return len(stops), others


class StopThread(BaseException):
    """What stops a thread."""


@needs_compiler
def test_a_thread_is_stopped_on_its_way_into_and_out_of_machine_code() -> None:
    """numba's own way ends the process: it calls Python functions there, and does not look."""
    code = "import json, test_compiled as t; print(json.dumps(t.stop_draws(1000)))"
    assert run(code) == [1000, []]


@needs_compiler
def test_machine_code_draws_numpys_numbers() -> None:
    """A result comes back with its classes; the generator goes on where machine code left it."""
    rng, other = np.random.default_rng(3), np.random.default_rng(3)
    with running(COMPILED_FIRST):
        drawn = draw(rng, np.arange(3.0))
    with running(INTERPRETED):
        expected = draw(other, np.arange(3.0))
    assert type(drawn) is Drawn and type(drawn.middle) is Middle
    assert type(drawn.middle.point) is np.ndarray
    assert drawn.middle.point.tolist() == expected.middle.point.tolist()
    assert (drawn.middle.i, drawn.x) == (expected.middle.i, expected.x)
    assert rng.random() == other.random()


# ---- importing ---------------------------------------------------------------------------------


def test_importing_is_light() -> None:
    """Packages that few users need are imported where they are used."""
    code = """
import json, sys, numpy
already = set(sys.modules)
import kinoedu
heavy = "numba scipy matplotlib shapely trimesh IPython PIL yaml nbgrader ipywidgets anywidget"
print(json.dumps(sorted({*heavy.split(), "networkx"} & set(sys.modules) - already)))
"""
    assert run(code) == []


def test_the_folder_depends_only_on_sources_that_are_compiled(tmp_path: Path) -> None:
    """The folder depends on algorithms, not on exercises, whose machine code is not stored."""
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


def test_machine_code_of_two_processes_has_no_symbol_in_common():
    """A function's symbol contains a count; two processes count from different numbers."""
    script = (
        "from kinoedu.compiled import compiler\n"
        "from numba.core.bytecode import FunctionIdentity as identity\n"
        "print(identity.from_function(compiler.borrowing).unique_id)"
    )
    first, second = (
        int(subprocess.run([sys.executable, "-c", script], capture_output=True, check=True).stdout)
        for _ in range(2)
    )
    assert abs(first - second) > 1_000_000


@needs_compiler
def test_code_that_calls_a_function_that_was_not_linked_is_refused() -> None:
    """It would crash the process that calls it; what other libraries define may be missing."""
    import llvmlite.binding
    from numba.core.registry import cpu_target

    from kinoedu.compiled.compiler import LeanLibrary

    library = LeanLibrary(cpu_target.target_context.codegen(), "library")
    library._final_module = llvmlite.binding.parse_assembly("declare double @sin(double)")
    library._verify_declare_only_symbols()
    library._final_module = llvmlite.binding.parse_assembly("declare void @_ZN7kinoedu4grow()")
    with pytest.raises(TypeError, match="_ZN7kinoedu4grow is called, and was not linked"):
        library._verify_declare_only_symbols()


OWNERS = """
import json
from llvmlite import ir
from numba.core.registry import cpu_target
from numba.core.runtime.context import NRTContext
numbas_own = NRTContext.get_meminfos
import kinoedu as ke
from kinoedu.compiled.kinds import kind_of
from kinoedu.compiled.machine import numba_type
from kinoedu.compiled.savings import find_owners

def look(find):
    signature = ir.FunctionType(ir.VoidType(), [context.get_value_type(kind)])
    function = ir.Function(ir.Module(), signature, "f")
    builder = ir.IRBuilder(function.append_basic_block())
    found = find(context.nrt, builder, kind, function.args[0])
    return [[str(owner), path(value)] for owner, value in found], len(builder.block.instructions)

def path(value):
    return path(value.operands[0]) + list(value.indices) if hasattr(value, "indices") else []

context = cpu_target.target_context
world = ke.PolygonWorld([(0, 0), (9, 0), (9, 9)], [[(5, 1), (6, 1), (6, 2)]])
kind = numba_type(kind_of(ke.Problem(ke.Point(), world, (7, 1), (8, 1))))
print(json.dumps([look(numbas_own), look(find_owners)]))
"""


@needs_compiler
def test_the_owners_of_a_records_arrays_are_those_that_numba_finds() -> None:
    """The same values in the same order, by a quarter of the instructions."""
    (usual, many), (found, few) = run(OWNERS)
    assert found == usual
    assert len(found) > 5 and few < many / 4


OPTIONS = """
import itertools, json
from numba.core.compiler import Flags
from kinoedu.compiled.savings import compare_all_options, have_equal_options, hash_of_options
options = [Flags() for _ in range(5)]
options[1].nrt = options[2].nrt = True
options[3].nrt = False
options[4].error_model = "numpy"
pairs = list(itertools.product(options, repeat=2))
print(json.dumps([
    [have_equal_options(one, other) for one, other in pairs],
    [compare_all_options(one, other) for one, other in pairs],
    [hash_of_options(one) == hash_of_options(other) for one, other in pairs],
    have_equal_options(options[0], "text") is NotImplemented,
]))
"""


@needs_compiler
def test_options_are_equal_where_numba_says_so() -> None:
    """Options that are set to their defaults equal those that are not set; equals have one hash."""
    ours, numbas, have_one_hash, is_left_to_text = run(OPTIONS)
    assert ours == numbas
    assert 5 < sum(ours) < 25
    assert all(same for equal, same in zip(ours, have_one_hash, strict=True) if equal)
    assert is_left_to_text


@needs_compiler
def test_python_searches_for_cycles_as_before_after_compiling():
    """It does so less often while numba works; the number comes back where compiling fails too."""
    from kinoedu.compiled.compiler import few_searches_for_cycles

    before, within = gc.get_threshold(), []

    def fail():
        with few_searches_for_cycles():
            within.append(gc.get_threshold()[0])
            raise TypeError

    with pytest.raises(TypeError):
        fail()
    assert within[0] > before[0]
    assert gc.get_threshold() == before


def test_blocks_of_several_threads_leave_the_mode_as_it_was() -> None:
    """The mode is that of the last block that has not ended, in whatever order they end."""
    before = modes.mode
    first, second = running(COMPILED_FIRST), running(INTERPRETED)
    first.__enter__()
    second.__enter__()
    first.__exit__(None, None, None)
    assert modes.mode == INTERPRETED
    second.__exit__(None, None, None)
    assert modes.mode == before


def test_only_folders_of_machine_code_are_removed(tmp_path) -> None:
    """A user's own folder beside them stays, whatever the length of its name."""
    ours, theirs = tmp_path / "0123456789abcdef-01234567", tmp_path / "my-thesis-2023ab"
    for place in (ours, theirs, tmp_path / "0123456789abcdef"):
        place.mkdir()
        os.utime(place, (0, 0))
    (ours / "wanted").mkdir()
    os.utime(ours, (0, 0))
    store.remove_stale(tmp_path / "fedcba9876543210-01234567")
    assert (ours.exists(), theirs.exists(), (tmp_path / "0123456789abcdef").exists()) == (
        False,
        True,
        True,
    )

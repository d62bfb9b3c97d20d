"""The sandbox: what a student's program has of the library, and how values pass."""

import contextlib
import json
import os
import string
import subprocess
import sys
from array import array
from collections import OrderedDict, deque
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinoedu.course.lessons import EXERCISES
from kinoedu.course.release import assignments
from kinoedu.grading.assignments.questions import read_assignment
from kinoedu.grading.judge.answers import DRAWING, PLANNING
from kinoedu.grading.sandbox import sandbox, wire
from kinoedu.grading.sandbox.lent import LentValues
from kinoedu.grading.sandbox.sandbox import Sandbox
from kinoedu.support.generators import plain_state

NO_SANDBOX = sandbox.explain_no_sandbox()
needs_sandbox = pytest.mark.skipif(bool(NO_SANDBOX), reason=NO_SANDBOX or "there is one")
LIMITS = {"memory": 2**30, "cpu": 60, "files": 2**24}
# modules of kinoedu that may be in the memory of a student's process, for problems and drawings
LOADED = (
    *("kinoedu.errors", "kinoedu.support", "kinoedu.compiled", "kinoedu.spaces"),
    *("kinoedu.geometry.checks", "kinoedu.geometry.exact"),
    *("kinoedu.course.lent_problem", "kinoedu.course.poses", "kinoedu.course.exceptions"),
    *("kinoedu.course.axes_contents", "kinoedu.grading.sandbox"),
)


@pytest.fixture(scope="module")
def box():
    """One sandbox for all tests of this file."""
    one = Sandbox()
    yield one
    one.close()


def say(box: Sandbox, source: str, lent: tuple[str, ...] = (), modules: tuple[str, ...] = ()):
    """What a program says of a value: it runs in the sandbox, and raises ValueError(text)."""
    cell = {"number": 1, "source": source, "seconds": 20.0}
    first = {"cells": [cell], "questions": [], "lent": lent, "drawing": DRAWING[0] in modules}
    reply = box.ask([{**first, "patience": 1.0, "limits": LIMITS}, {}], 100.0, modules)
    (line,) = (line for line in reply.parts[0] if "cell" in line)
    (trouble,) = line["troubles"]
    assert trouble["outcome"]["kinds"][0] == "ValueError", trouble
    return json.loads(trouble["outcome"]["message"])


@needs_sandbox
@pytest.mark.parametrize("modules", [(), PLANNING, DRAWING])
def test_nothing_of_the_library_is_in_memory_but_what_is_lent(box, modules):
    """Every function and class in memory is looked at, wherever it hides."""
    source = """
import gc, json, sys, types
homes = {
    str(getattr(thing, "__module__", ""))
    for thing in gc.get_objects()
    if isinstance(thing, types.FunctionType | type)
}
modules = [thing for thing in gc.get_objects() if isinstance(thing, types.ModuleType)]
homes |= {str(getattr(module, "__name__", "")) for module in modules}
raise ValueError(json.dumps(sorted(home for home in homes if home.startswith("kinoedu"))))
"""
    homes = say(box, source, modules=modules)
    assert [home for home in homes if not home.startswith(LOADED)] == []


@needs_sandbox
def test_the_disk_is_empty(box):
    source = """
import json, os
found = [os.path.join(folder, name) for folder, _, names in os.walk("/") for name in names]
raise ValueError(json.dumps(found))
"""
    assert say(box, source) == ["/dev/null"]


@needs_sandbox
def test_a_program_that_draws_can_measure_and_save_its_text(box):
    source = """
import io, json
from matplotlib import pyplot as plt
figure, ax = plt.subplots()
ax.plot([0, 1], label="way")
ax.set(title=r"$\\theta_1$ and $\\sqrt{x}$", xlabel="\u4e00")
text = ax.text(0, 0, "start", family="monospace", weight="bold")
ax.legend(prop={"family": "serif"})
figure.tight_layout()
figure.canvas.draw()
kept = io.BytesIO()
figure.savefig(kept, bbox_inches="tight")
said = [kept.getvalue()[1:4].decode(), bool(text.get_window_extent().width > 20)]
raise ValueError(json.dumps(said))
"""
    assert say(box, source, modules=DRAWING) == ["PNG", True]


def test_axes_have_the_canvas_that_they_have_in_a_notebook():
    ax = LentValues(lambda *_: None).find(wire.LENT, {"is": "axes"})
    assert ax.figure.canvas.get_renderer().width == ax.figure.bbox.width


@needs_sandbox
def test_pythons_library_and_numpy_are_there_without_a_disk(box):
    source = """
import json, collections, dataclasses, fractions, functools, heapq, itertools, statistics, decimal
import enum, typing, copy, random, bisect, operator, string, textwrap, time, datetime, re, abc
import numpy as np, numpy.random, numpy.linalg, numpy.polynomial, numpy.ma, numpy.testing
import xml.dom, html.parser, unittest, doctest, cmath, array, queue, secrets, hashlib, zlib
rng = np.random.default_rng(0)
raise ValueError(json.dumps([int(rng.integers(1000)), statistics.median([1, 2, 3])]))
"""
    assert say(box, source) == [int(np.random.default_rng(0).integers(1000)), 2]


@needs_sandbox
def test_classes_of_a_notebook_are_found_where_python_looks_for_them(box):
    """As in a notebook: to copy with pickle, and for annotations that are text."""
    source = """
from __future__ import annotations
import json, pickle, typing
from dataclasses import dataclass
from typing import ClassVar

@dataclass
class Node:
    cost: float
    known: ClassVar[list] = []

copy = pickle.loads(pickle.dumps(Node(2.0)))
hints = [one.__name__ for one in typing.get_type_hints(Node).values() if isinstance(one, type)]
raise ValueError(json.dumps([copy == Node(2.0), hints]))
"""
    assert say(box, source) == [True, ["float"]]


@needs_sandbox
def test_what_an_assignment_lends_answers_and_the_rest_says_that_it_is_not_lent(box):
    source = """
import json, kinoedu as ke
import numpy as np
from kinoedu.geometry import convex_hull, minkowski_sum
from kinoedu.planners.trees.rrt import grow
hull = convex_hull([(0, 0), (2, 0), (1, 1), (1, 0.5), (1, 3)])
said = [np.asarray(hull).tolist(), ke.geometry.convex_hull is convex_hull]
said += [convex_hull.__name__]
for absent in (minkowski_sum, grow, ke.rrt, ke.geometry.point_in_polygon):
    try:
        absent(hull, hull)
    except Exception as error:
        said.append(type(error).__name__)
try:
    convex_hull([(0, float('nan'))])
except ValueError as error:
    said.append(type(error).__name__)
raise ValueError(json.dumps(said))
"""
    hull, same, name, *errors = say(box, source, ("kinoedu.geometry:convex_hull",))
    assert name == "convex_hull"
    assert sorted(hull) == [[0.0, 0.0], [1.0, 3.0], [2.0, 0.0]]
    assert same and errors == ["NotLentError"] * 4 + ["InvalidPoint"]


@needs_sandbox
def test_a_graph_that_a_program_makes_has_its_methods_and_data(box):
    """As in a notebook; what is not public is not asked for."""
    source = """
import json
from kinoedu.graphs import Graph, bfs_path
graph = Graph(3, [(0, 1)])
graph.add_edge(1, 2)
assert len(graph.node_data) == 3 and not graph.directed
said = [list(map(int, graph.neighbours(1))), graph.size]
said += [len(graph), list(graph), 2 in graph, 3 in graph, bool(Graph(0))]
said += [graph.edges.tolist(), bfs_path(graph, 0, 2).tolist()]
for absent in ("_embedding", "neighbors", "nodes"):
    try:
        getattr(graph, absent)
    except Exception as error:
        said.append(type(error).__name__)
raise ValueError(json.dumps(said))
"""
    near, size, length, nodes, *has, edges, path, first, second, third = say(
        box, source, ("kinoedu.graphs:Graph", "kinoedu.graphs:bfs_path")
    )
    assert (sorted(near), size, edges, path) == ([0, 2], 3, [[0, 1], [1, 2]], [0, 1, 2])
    assert (length, nodes, has) == (3, [0, 1, 2], [True, False, False])
    assert [first, second, third] == ["AttributeError", "AttributeError", "InvalidGraph"]


@needs_sandbox
def test_a_class_of_the_library_is_a_class_for_a_program_too(box):
    source = """
import json
from kinoedu.graphs import Graph
from kinoedu.problems import Problem

class Rooms(Graph):
    def __init__(self, names, doors):
        self.early = hasattr(self, "names")
        super().__init__(len(names), doors)
        self.names = names

    def neighbours(self, u):
        return [self.names[v] for v in super().neighbours(u)]

def count(graph: Graph | None, problem: None | Problem = None) -> int:
    return len(graph) if isinstance(graph, Graph) else 0

rooms = Rooms(["hall", "loft"], [(0, 1)])
said = [count(rooms), count(Graph(3)), count(None), rooms.neighbours(0), rooms.size, rooms.early]
said += [list(map(int, Graph.neighbours(rooms, 0))), Graph.__name__]
raise ValueError(json.dumps(said))
"""
    said = say(box, source, ("kinoedu.graphs:Graph",))
    assert said == [2, 3, 0, ["loft"], 2, False, [1], "Graph"]


@needs_sandbox
def test_what_no_lent_class_made_has_nothing_to_ask_for(box):
    """A generator of Python holds the library's own variables; nor is a graph's class asked."""
    source = """
import json
from kinoedu.graphs import Graph, dijkstra_expansions
graph = Graph(2, [(0, 1)])
running = dijkstra_expansions(graph, 0)
said = []
asked = ((running, "gi_frame"), (running, "close"), (running, "__iter__"), (graph, "mro"))
asked += ((graph, "__class__"), (graph, "__repr__"), (graph, "__dict__"))
for thing, name in asked:
    try:
        said.append(str(thing._ask(thing._number, name, ())))
    except Exception as error:
        said.append(type(error).__name__)
raise ValueError(json.dumps(said))
"""
    said = say(box, source, ("kinoedu.graphs:Graph", "kinoedu.graphs:dijkstra_expansions"))
    assert said == ["TypeError"] * 3 + ["AttributeError"] * 4


@pytest.mark.parametrize("name", assignments())
def test_no_assignment_lends_what_it_asks_for(name):
    """Nor a function of an exercise's module, but a wrong program that students must expose."""
    assignment = read_assignment(name)
    asked = {question.exercise.name for question in assignment.questions}
    sources = {
        f"{source.__module__}:{source.__name__}"
        for one in assignment.questions
        if (source := one.exercise.source) is not None
    }
    names = {place.partition(":")[2] for place in assignment.lent}
    assert not asked & names and not sources & set(assignment.lent)
    book = json.loads((Path("exercises") / f"{name}.ipynb").read_text(encoding="utf-8"))
    text = "".join("".join(cell["source"]) for cell in book["cells"])
    assert all(lent in text for lent in names)


def test_every_exercise_is_known_where_its_cases_are_run():
    """The runner finds an exercise by its name."""
    assert all(exercise.name == name for name, exercise in EXERCISES.items())


plain = st.recursive(
    st.none()
    | st.booleans()
    | st.integers(-(2**60), 2**60)
    | st.floats(allow_nan=False)
    | st.text(string.printable, max_size=5),
    lambda inner: (
        st.lists(inner, max_size=4)
        | st.lists(inner, max_size=4).map(tuple)
        | st.dictionaries(st.text(max_size=3), inner, max_size=3)
    ),
    max_leaves=12,
)


@given(plain)
def test_plain_values_pass_unchanged(value):
    line = wire.write_line({"value": wire.encode(value, lambda one: None)})
    there = wire.decode(wire.read_line(line)["value"], lambda mark, content: None)
    assert there == value and repr(there) == repr(value)


def test_text_of_numpy_passes_as_text():
    """As the names of planners in an array, which are given back to `run`."""
    names = np.array(["RRT", "PRM"])
    assert wire.encode((names, names[0]), lambda one: None) == {wire.TUPLE: [["RRT", "PRM"], "RRT"]}


def test_fractions_pass_as_the_numbers_to_which_they_are_rounded():
    """As `check` takes them; one that no float holds is no number there either."""
    third = Fraction(1, 3)
    for value in (third, [(third, 2)], np.array([third])):
        there = wire.decode(wire.encode(value, lambda one: None), lambda mark, content: None)
        assert np.array_equal(np.array(there), np.array(value, float))
    huge = wire.encode(Fraction(10**400), lambda one: None)
    assert huge == {wire.OTHER: "Fraction"}


@pytest.mark.parametrize(
    "numbers",
    [np.eye(2), np.array([]), np.zeros((0, 2)), np.array([[1, 2]]), np.array(True), np.float64(3)],
)
def test_arrays_pass_with_their_shapes_and_kinds(numbers):
    there = wire.decode(wire.encode(numbers, lambda one: None), lambda mark, content: None)
    assert np.array_equal(there, numbers) and np.shape(there) == np.shape(numbers)
    assert np.asarray(there).dtype == np.asarray(numbers).dtype


@given(
    st.recursive(
        st.none() | st.integers() | st.text("acdhgot", max_size=2),
        lambda inner: (
            st.lists(inner, max_size=3)
            | st.dictionaries(st.sampled_from("acdhgot"), inner, max_size=2)
        ),
    )
)
def test_a_line_of_nonsense_is_refused_by_name(data):
    """Whatever comes is decoded, or is Unfit."""
    with contextlib.suppress(wire.Unfit):
        wire.decode(data, lambda mark, content: content)


class Whole(int):
    """An integer of a class of its own."""


@pytest.mark.parametrize(
    ("value", "wanted"),
    [
        (range(3), [0, 1, 2]),
        (deque([1, 2]), [1, 2]),
        (array("d", [1.0, 2.0]), [1.0, 2.0]),
        (OrderedDict(a=1), {"a": 1}),
        (np.array([[1, 2], [3]], dtype=object), [[1, 2], [3]]),
        (np.array([2**63], np.uint64), [2**63]),
        (np.longdouble(0.5), 0.5),
        (np.float32(0.1), float(np.float32(0.1))),
        (Whole(7), 7),
        (10**40, 10**40),
        (float("inf"), float("inf")),
    ],
    ids=lambda value: type(value).__name__,
)
def test_what_check_accepts_passes_as_what_it_stands_for(value, wanted):
    line = wire.write_line({"value": wire.encode(value, lambda one: None)})
    there = wire.decode(wire.read_line(line)["value"], lambda mark, content: None)
    assert (there.tolist() if isinstance(there, np.ndarray) else there) == wanted


def test_a_list_in_itself_ends():
    endless: list = []
    endless.append(endless)
    assert "list" in json.dumps(wire.encode(endless, lambda one: None))


def test_what_does_not_pass_is_named_and_never_run():
    class Bomb:
        def __repr__(self):
            raise RuntimeError

    there = wire.decode(wire.encode([Bomb(), {1, 2}], lambda one: None), lambda *_: None)
    assert [type(one).__name__ for one in there] == ["Bomb", "set"]


def test_generators_pass_with_their_states():
    for bits in (np.random.PCG64, np.random.MT19937, np.random.Philox, np.random.SFC64):
        here = np.random.Generator(bits(3))
        here.random(5)
        state = json.loads(json.dumps(plain_state(here.bit_generator.state)))
        assert wire.generator_of(state).random() == here.random()


@pytest.mark.parametrize(
    ("bits", "where", "most"), [("MT19937", "pos", 624), ("Philox", "buffer_pos", 4)]
)
def test_a_state_that_reads_memory_beyond_its_numbers_is_no_state(bits, where, most):
    """By such a state a program had read the runner's memory, number by number."""
    for used, is_state in ((1, True), (most, True), (most + 1, False), (-1, False), (2.0, False)):
        state = plain_state(getattr(np.random, bits)(3).state)
        (state if where in state else state["state"])[where] = used
        if is_state:
            wire.generator_of(state).random(2000)
            continue
        with pytest.raises(wire.Unfit, match="state of a generator"):
            wire.generator_of(state)


def test_a_generator_of_the_older_kind_passes_with_its_state():
    """Of it the half that is kept of two normal numbers is a part."""
    here = np.random.RandomState(5)
    here.standard_normal()
    state = wire.read_line(wire.write_line(wire.read_state(here)))
    there = wire.generator_of(state)
    assert there.standard_normal(3).tolist() == here.standard_normal(3).tolist()
    for name, wrong in (
        ("has_gauss", "x"),
        ("gauss", [1]),
        ("state", 3),
        ("bit_generator", "SFC64"),
    ):
        with pytest.raises(wire.Unfit, match="state of a generator"):
            wire.set_state(there, {**state, name: wrong})
    state["state"]["pos"] = 625
    with pytest.raises(wire.Unfit, match="state of a generator"):
        wire.generator_of(state)


@pytest.mark.parametrize("bits", ["PCG64", "MT19937", "Philox", "none", [], None])
@pytest.mark.parametrize("inner", [{}, {"state": [1]}, {"state": None}, {"state": 7}])
def test_a_state_of_another_shape_is_no_state(bits, inner):
    """No other exception than Unfit: it would end the process that judges."""
    with pytest.raises(wire.Unfit, match="state of a generator"):
        wire.set_state(np.random.default_rng(1), {"bit_generator": bits, **inner})


def test_a_state_that_is_deeper_than_any_is_no_state():
    state: object = 1
    for _ in range(5000):
        state = {"state": state}
    with pytest.raises(wire.Unfit, match="state of a generator"):
        wire.generator_of({"bit_generator": "PCG64", "state": state})


@needs_sandbox
def test_errors_of_the_library_are_caught_by_their_names(box):
    """As in a notebook: by its class, and by that of all errors of the library."""
    source = """
import json
from kinoedu.errors import InvalidPoint, KinoeduError
from kinoedu.geometry import convex_hull
said = []
for kind in (InvalidPoint, KinoeduError, ValueError):
    try:
        convex_hull([(0, float('nan'))])
    except kind as error:
        said.append(type(error).__name__)
raise ValueError(json.dumps(said))
"""
    assert say(box, source, ("kinoedu.geometry:convex_hull",)) == ["InvalidPoint"] * 3


def test_data_deeper_than_any_value_is_no_value():
    """Whoever sends it is told so, instead of ending the reader."""
    data = []
    for _ in range(700):
        data = [data]
    with pytest.raises(wire.Unfit, match="deep"):
        wire.decode(data, lambda mark, content: None)
    value: object = 1
    for k in range(wire.MOST_DEEP - 1):
        value = {"a": value} if k % 2 else [value]
    assert wire.decode(wire.encode(value, lambda value: None), lambda mark, content: None) == value


def test_without_walls_matplotlib_reads_nothing_that_a_program_may_have_left(tmp_path, monkeypatch):
    """It read /tmp/matplotlib, which a program made first; some versions run what stands there."""
    monkeypatch.setenv("KINOEDU_CACHE", str(tmp_path))
    command = sandbox.trusted_command("trusted.py")
    assert f"MPLCONFIGDIR={tmp_path.resolve() / 'matplotlib'}" in command


@pytest.mark.skipif(os.name == "nt", reason="programs run on Linux and macOS only")
def test_a_trusted_program_has_a_folder_whatever_a_killed_run_has_left(tmp_path):
    """The numbers of processes come again, and so did the folder's name."""
    code = """
import os, sys
from pathlib import Path
from kinoedu.grading.sandbox import trusted
trusted.PLACE = Path(sys.argv[1])
(trusted.PLACE / f"kinoedu-trusted-{os.getpid()}").mkdir()
trusted.give_up_rights(0, memory=2**30, cpu=10, files=2**20)
print(len(list(Path().iterdir())), Path.cwd().parent == trusted.PLACE.resolve())
"""
    line = [sys.executable, "-c", code, str(tmp_path)]
    assert subprocess.run(line, capture_output=True, text=True, check=False).stdout == "0 True\n"


def test_a_sandbox_that_does_not_start_in_time_is_explained(monkeypatch):
    """The command says so, and shows no traceback."""

    def hang(command, *, timeout, **_):
        raise subprocess.TimeoutExpired(command, timeout)

    monkeypatch.setattr(sandbox.sys, "platform", "linux")
    monkeypatch.setattr(sandbox, "REFUSED", (1,))
    monkeypatch.setattr(sandbox.shutil, "which", lambda name: f"/usr/bin/{name}")
    monkeypatch.setattr(sandbox.subprocess, "run", hang)
    assert "try again" in sandbox.explain_no_sandbox()

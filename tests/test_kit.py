"""The kit for students: it has no answer to an exercise, and judges as the whole project does."""

import ast
import inspect
import json
import os
import subprocess
import sys
import zipfile
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from judged_programs import judge_all, wrong_programs

from kinoedu.course import EXERCISES
from kinoedu.course.assignments import list_assignments
from kinoedu.course.kit import (
    NAMED_PROGRAMS,
    compress_results,
    cut_answers,
    find_imports,
    find_uses,
    is_marked,
    name_defined,
    names_in,
    reach,
    record_results,
    take_out_answers,
)
from kinoedu.course.recorded import decode, encode, key_of
from kinoedu.course.release import LESSONS, RESULTS, pack_course
from kinoedu.course.withheld import is_withheld, recorded_results, withhold
from kinoedu.messages import get_message
from kinoedu.problems import Tree

HOUSE = Path(__file__).resolve().parent.parent
ROOM = HOUSE / LESSONS
SOURCES = {
    file.relative_to(ROOM).as_posix(): file.read_text(encoding="utf-8")
    for file in sorted(ROOM.rglob("*.py"))
}


@cache
def kit_sources():
    """The same files without the answers."""
    return take_out_answers(SOURCES)


# What answers use and students have: each is a small part of an answer, or needed for any input.
PARTS = {
    "calls of the open library": "cells_of convert_path as_graph find_shortest search_matrix_by",
    "vectors and distances": "turn_left is_short edge_areas nearest_on_edges measure_length "
    "measure_distances measure_turns ends_of_links bounding_box edges_round",
    "pictures": "bar circle is_arm",
    "conversions": "list_neighbours convert_case find_ancestors find_adjacent_places "
    "remove_duplicates swap_entries",
    "judges, which see answers of students": "keep_free measure_edges measure_duration "
    "find_near_goal find_relative_motion find_cuts find_crossed_cells find_arrival "
    "cells_containing floors_and_ceilings shared_wall",
    "wrong programs that an exercise shows": "inverse_by_sines",
}


@pytest.fixture(scope="module")
def kit(tmp_path_factory):
    """The unpacked kit."""
    folder = tmp_path_factory.mktemp("kit")
    pack_course(folder / "course.zip")
    with zipfile.ZipFile(folder / "course.zip") as archive:
        archive.extractall(folder)
    return folder / "kinoedu-course"


def run_in(kit, *command):
    """What Python prints with the kit's library."""
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(kit), str(HOUSE / "tests")])}
    run = subprocess.run(
        [sys.executable, "-P", *command],
        cwd=kit,
        env=environment,
        capture_output=True,
        text=True,
        encoding="utf-8",
        check=False,
    )
    assert run.returncode == 0, run.stderr
    return run.stdout


def names_of_answers():
    """What the bodies of withheld functions, misconceptions, and other right answers use."""
    used = set()
    for path, text in SOURCES.items():
        tree = ast.parse(text)
        known = find_imports(tree, path, SOURCES)
        known |= {name: (path, name) for node in tree.body if (name := name_defined(node))}
        for node in ast.walk(tree):
            secret = []
            if isinstance(node, ast.FunctionDef) and (
                is_marked(node) or node.name in ("right_answer", "truth")
            ):
                secret = node.body
            elif isinstance(node, ast.Call) and ast.unparse(node.func) in NAMED_PROGRAMS:
                secret = node.args[1:]
            used |= {known[name] for part in secret for name in names_in(part) if name in known}
    return used


def test_every_right_answer_is_withheld():
    """The source and the reference of each exercise, where they are not the open library's."""
    listed = set(" ".join(PARTS.values()).split())
    for exercise in EXERCISES.values():
        for name in ("source", "reference"):
            answer = getattr(type(exercise), name, None)
            ours = inspect.unwrap(answer) if inspect.isroutine(answer) else None
            if ours is None or not ours.__module__.startswith("kinoedu.course.lessons"):
                continue
            within = ours.__qualname__.split(".")[0]
            is_open = within in listed or exercise.name == "free_heading"  # it calls the library
            assert is_withheld(answer) or is_open, (exercise.name, name)


def test_what_answers_use_is_not_in_the_kit_but_for_a_short_list():
    """A helper of an answer that students have is a deliberate choice: the list is exact."""
    functions = {
        (path, node.name)
        for path, text in kit_sources().items()
        for node in ast.parse(text).body
        if isinstance(node, ast.FunctionDef) and not is_marked(node)
    }
    found = {name for _, name in reach(find_uses(SOURCES), names_of_answers()) & functions}
    assert found == set(" ".join(PARTS.values()).split())


def test_no_body_of_a_withheld_function_is_in_the_kit():
    """Nor a program of a misconception or a variant; the signatures and docstrings are."""
    marked = 0
    for path, text in SOURCES.items():
        kept = kit_sources()[path]
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.FunctionDef) and is_marked(node):
                marked += 1
                lines = text.splitlines()[node.body[1].lineno - 1 : node.end_lineno]
                assert "\n".join(lines) not in kept, (path, node.name)
        for node in ast.walk(ast.parse(kept)):
            if isinstance(node, ast.FunctionDef) and is_marked(node):
                assert len(node.body) == 1
                assert ast.get_docstring(node)
            if isinstance(node, ast.Call) and ast.unparse(node.func) in NAMED_PROGRAMS:
                assert len(node.args) == 1
    assert marked > 60


def test_a_withheld_function_needs_a_docstring():
    """It is all that students get."""
    with pytest.raises(ValueError, match="half is withheld"):
        cut_answers("@withheld\ndef half(x):\n    return x / 2\n")


def test_an_answer_goes_with_its_helpers_and_their_imports():
    """What an answer and a misconception used alone is gone; what others use stays."""
    helpers = "import math\n\nTWO = 2\n\n\n# halves\ndef half(x):\n    return x / TWO\n\n\n"
    helpers += "def other(x):\n    return math.pi\n"
    answer = "from .helpers import half, other\n\n\n@withheld\ndef answer(x):\n    'The answer.'\n"
    answer += "    # a hint\n    return half(x)\n\n\n"
    answer += "slips = (Slip('sign', lambda x: -half(x)),)\n"
    answer += "changes = (Change('less', lambda f, x: f(half(x))),)\nlist = [answer, other]\n"
    kit = take_out_answers({"a/helpers.py": helpers, "a/answer.py": answer})
    assert kit["a/helpers.py"] == "import math\n\n\ndef other(x):\n    return math.pi\n"
    assert kit["a/answer.py"] == (
        "from .helpers import other\n\n\n@withheld\ndef answer(x):\n    'The answer.'\n\n\n"
        "slips = (Slip('sign'),)\nchanges = (Change('less'),)\nlist = [answer, other]\n"
    )


def test_results_come_back_as_they_were():
    """Numbers to the last bit, arrays with their types, records, and errors with their messages."""
    tree = Tree(np.array([[0.1 + 0.2, np.inf]]), np.array([-1]))
    for value in (None, [1, 2.5, (True, "a")], {"a": np.eye(2, dtype=bool)}, tree):
        back = decode(json.loads(json.dumps(encode(value))))
        assert repr(back) == repr(value)
        assert type(back) is type(value)
    with recorded_results() as results:
        half = withhold(lambda x: x / 0, "half")
        with pytest.raises(ZeroDivisionError):
            half(1)
    assert results == {
        "half": {key_of(((1,), {})): {"error": "ZeroDivisionError", "message": "division by zero"}}
    }
    with pytest.raises(TypeError, match="function"):
        encode(key_of)


def test_arguments_that_differ_by_rounding_have_one_key():
    """The last bits differ between processors; numbers that matter do not share a key."""
    right_angle = np.array([np.cos(np.pi / 2), np.sin(np.pi / 2)])
    assert key_of(right_angle) == key_of(np.array([0.0, 1.0]))
    assert key_of(0.1 + 0.2) == key_of(0.3)
    assert key_of(-0.0) == key_of(0.0)
    assert len({key_of(x) for x in (0.0, 1e-12, 1e-13, 3e-9, 4e-9, 1.0, 1.000001, 1, True)}) == 9


def test_what_cannot_be_recorded_is_an_error():
    """A function that changes its arguments, and two calls with one key and different results."""
    with recorded_results():
        with pytest.raises(RuntimeError, match="must not change"):
            withhold(lambda rows: rows.append(1), "append")([0])
        with pytest.raises(RuntimeError, match="must not change"):
            withhold(lambda rng: rng.random(), "draw")(np.random.default_rng(0))
        answers = iter((1, 2))
        again = withhold(lambda x: next(answers), "again")
        assert again(0.3) == 1
        with pytest.raises(RuntimeError, match="same key"):
            again(0.1 + 0.2)


def test_the_same_course_makes_the_same_results():
    """Byte for byte, whatever was asked for before."""
    some = [EXERCISES[name] for name in ("bfs_tree", "follow", "rrt", "segment_intersection")]
    assert compress_results(record_results(some)) == compress_results(record_results(some))


def test_a_teacher_sees_how_far_the_recording_is():
    """It takes minutes: each exercise and each variant with results of its own counts."""
    some, seen = [EXERCISES[name] for name in ("follow", "segment_intersection")], []
    record_results(some, lambda done, everything: seen.append((done, everything)))
    count = seen[-1][1]
    assert seen == [(done, count) for done in range(count + 1)] and count > len(some)


def test_the_kit_holds_no_secret(kit):
    """Lessons, exercises and the library; no solutions, no bank, no tests, and nothing that running
    left behind.
    """
    names = {file.relative_to(kit).as_posix() for file in kit.rglob("*") if file.is_file()}
    assert {"start.py", "exercises/01_geometry.ipynb", "notebooks/01_geometry.ipynb"} <= names
    assert not {name.split("/")[0] for name in names} & {"solutions", "tests", "benchmarks"}
    assert not any("__pycache__" in name or name.endswith(".part") for name in names)
    for name in names:
        text = (kit / name).read_bytes()
        assert b"BEGIN SOLUTION" not in text.replace(b'"BEGIN SOLUTION"', b"")
        assert b"@wrong(" not in text.replace(b'`@wrong("name_of_the_exercise")`', b"")
    for path, text in kit_sources().items():
        assert (kit / LESSONS / path).read_text(encoding="utf-8") == text
    assert (kit / RESULTS).stat().st_size < 3.5e6  # a quarter of it are drawings


def test_lessons_and_exercises_import_nothing_that_is_withheld():
    """What a notebook imports from the lessons' code, students have."""
    for notebook in (*HOUSE.glob("notebooks/*.ipynb"), *HOUSE.glob("exercises/*.ipynb")):
        for cell in json.loads(notebook.read_text(encoding="utf-8"))["cells"]:
            for line in cell["source"] if cell["cell_type"] == "code" else []:
                module, _, names = line.partition(" import ")
                if module.startswith("from kinoedu.course.lessons."):
                    path = module.removeprefix("from kinoedu.course.lessons.").replace(".", "/")
                    for name in names.replace("(", "").replace(")", "").split(","):
                        assert is_open(f"{path}.py", name.strip()), (notebook.name, line)


def is_open(path, name):
    """Whether a file of the kit defines or imports a name that is not withheld."""
    tree = ast.parse(kit_sources()[path])
    marked = {n.name for n in tree.body if isinstance(n, ast.FunctionDef) and is_marked(n)}
    names = {name_defined(node) for node in tree.body}
    for node in tree.body:
        if isinstance(node, ast.Import | ast.ImportFrom):
            names |= {one.asname or one.name for one in node.names}
    return not name or (name in names and name not in marked)


IN_THE_KIT = """
import numpy as np
from kinoedu.course import EXERCISES, check, show
from kinoedu.course.checking import PASSED
from kinoedu.course.lessons.cars.order_of_error import orders
from kinoedu.course.lessons.trees.rrt import Rrt, grow_tree
from kinoedu.course.withheld import NotInTheKit

hidden = list(Rrt().cases(np.random.default_rng(1)))[-1]
for call in (lambda: grow_tree(*hidden.given.values()), lambda: orders([1, 2, 4], [1, 2, 5])):
    try:
        call()
    except NotInTheKit as error:
        print(error)
print(orders(np.array([0.8, 0.4]), np.array([0.06, 0.03])))
PASSED.update(EXERCISES)
print([name for name, one in EXERCISES.items() if one.source and "teacher" in repr(show(name))])
"""


def test_the_kit_has_results_of_the_fixed_cases_alone(kit):
    """Another call raises an error of its own; `show` shows the library's functions alone."""
    lines = run_in(kit, "-c", IN_THE_KIT).splitlines()
    assert all("this copy of the course is for students" in line for line in lines[:2])
    assert "trees.rrt.grow_tree" in lines[0]
    assert lines[2] == "[1.]"
    assert "order_of_error" in lines[3]
    assert "'rrt'" not in lines[3]  # the library's RRT is shown


def test_the_kit_knows_what_each_assignment_asks(kit):
    """As the whole course does from the solutions."""
    code = (
        "from kinoedu.course.assignments import list_assignments as f; import json; "
        "print(json.dumps(f()))"
    )
    assert json.loads(run_in(kit, "-c", code)) == list_assignments()


def test_the_kit_judges_as_the_whole_project_does(kit):
    """All right programs are right there. Wrong ones break the same rule, have the same text and
    the same picture; only where obstacles are left out of a world, the world may be larger.
    """
    printed = run_in(kit, str(HOUSE / "tests" / "judged_programs.py"), str(HOUSE))
    right, wrong = json.loads(printed.splitlines()[-1])  # solutions print as well
    varied = sum(len(getattr(exercise, "changes", ())) for exercise in EXERCISES.values())
    assert len(right) == len(EXERCISES) + varied
    assert [name for name, found in right.items() if not found["right"]] == []
    here = json.loads(json.dumps(judge_all(wrong_programs(HOUSE))))
    assert here.keys() == wrong.keys()
    for name, found in here.items():
        world_may_differ = "obstacles" in EXERCISES[name.partition("-")[0]].given.fields
        assert comparable(wrong[name], world_may_differ) == comparable(found, world_may_differ), (
            name
        )


def comparable(found, world_may_differ):
    """What depends neither on times nor on the obstacles that were left out."""
    if "lacks" in found or not (world_may_differ or found["rule"] == "late"):
        return found
    shown = {get_message(f"check.{key}") for key in ("call", "yours", "wanted", "where")}
    text = {title: text for title, text in found["text"].items() if title not in shown}
    return {**found, "text": text, "picture": []}


def test_answers_are_cut_where_they_are_also_below_a_page_break():
    """A page break ends no line of Python."""
    text = "X = 1\n\x0c\n\n@withheld\ndef half(x):\n    'Half of x.'\n    return x / 2\n"
    assert cut_answers(text) == text.replace("\n    return x / 2", "")

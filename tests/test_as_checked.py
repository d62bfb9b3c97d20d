"""Functions as their checks saw them: what is found, at what cost, and what is too late."""

import pytest
from submissions import notebook

from kinoedu.course.outcomes import Late
from kinoedu.grading.assignments.questions import read_assignment
from kinoedu.grading.collect.notebook import Cell
from kinoedu.grading.judge import submission
from kinoedu.grading.judge.answers import Run
from kinoedu.grading.judge.as_checked import find_cells_as_checked
from kinoedu.grading.sandbox import sandbox
from kinoedu.grading.sandbox.sandbox import Sandbox

NO_SANDBOX = sandbox.explain_no_sandbox()
needs_sandbox = pytest.mark.skipif(bool(NO_SANDBOX), reason=NO_SANDBOX or "there is one")
HELPED = """
import numpy as np
def dist(a, b):
    return np.linalg.norm(a - b)
def {0}(q, p1, p2):
    way = p2 - p1
    t = np.dot(q - p1, way) / np.dot(way, way) if way.any() else 0.0
    return dist(q, p1 + min(max(t, 0.0), 1.0) * way)
check({0})
"""
LINE, SEGMENT = map(HELPED.format, ("point_line_distance", "point_segment_distance"))
CHANGED = "def dist(q):\n    pass"


def graded(*sources, patience=1.0):
    """The questions of lesson 1 by name, for these code cells."""
    box = Sandbox()
    try:
        record = submission.grade(
            notebook(*sources), read_assignment("01_geometry"), b"a secret", box, patience=patience
        )
    finally:
        box.close()
    return {question["question"]: question for question in record["questions"]}


@needs_sandbox
def test_what_is_late_as_its_check_saw_it_is_told_to_be_late(monkeypatch):
    """Late notebooks are graded again, alone and with more time: the computer may be busy."""
    ask_apart = Run.ask_apart

    def ask(run, cells, questions):
        if cells[-1].source == LINE:
            run.found.outcomes.update({one.name: [Late(False)] for one in questions})
        else:
            ask_apart(run, cells, questions)

    monkeypatch.setattr(Run, "ask_apart", ask)
    result = graded(LINE, SEGMENT, CHANGED)
    assert result["point_line_distance"]["late"]
    assert result["point_segment_distance"]["status"] == "right"


@needs_sandbox
def test_a_draft_below_that_never_ends_costs_nothing():
    """A check has called the function above it right."""
    draft = "def point_segment_distance(q, p1, p2):\n    while True:\n        pass"
    assert graded(SEGMENT, draft, patience=0.2)["point_segment_distance"]["status"] == "right"


@needs_sandbox
def test_all_calls_as_checks_saw_functions_have_the_time_of_one_program(monkeypatch):
    """A notebook with many wrong answers does not take many times longer."""
    monkeypatch.setattr(submission, "LONGEST", 0.0)
    result = graded(LINE, SEGMENT, CHANGED)
    assert result["point_line_distance"]["late"]
    assert result["point_segment_distance"]["status"] == "wrong"


def test_cells_as_checked_are_found_without_compiling():
    """Python compiles what is in `finally` twice: in eighteen of them 250,000 times."""
    nested = "".join(f"{' ' * deep}try: pass\n{' ' * deep}finally:\n" for deep in range(1, 19))
    function = f"def f():\n{nested}{' ' * 19}return d({'a, ' * 50})\n"
    cells = [Cell(at, text) for at, text in enumerate([function, "check(f)", "d = 1"], 1)]
    assert find_cells_as_checked(["f"], cells) == {"f": cells[:2]}


@pytest.mark.parametrize(
    ("above", "below", "is_found"),
    [
        ("def f(x):\n    return d(x)", "d = 1", True),
        ("def f(x):\n    return [d(x) for d in x]", "d = 1", False),
        ("def f(d):\n    return d", "d = 1", False),
        ("def f(x):\n    return d(x)", "del d", True),
        ("def f(x):\n    return d(min(x, key=lambda d: d[0]))", "d = 1", True),
        ("class C:\n    def f(self):\n        return d\nf = C().f", "import a as d", True),
        ("f = lambda x: d.e(x)", "e = 1", False),
        ("def f(x):\n    return d", "def f(:\nd = 2", True),
        ("def f(x):\n    return d", "def d():\n    raise NotImplementedError", False),
        ("d = 1\ndef f(x):\n    return x", "d = 2", False),
        ("def g(x):\n    return d", "d = 1\ndef f(x):\n    return d", False),
    ],
)
def test_a_cell_below_changes_what_functions_use(above, below, is_found):
    """A name that is the function's own, or that of an attribute, is another one."""
    cells = [Cell(1, above), Cell(2, "check( f )"), Cell(3, below)]
    assert ("f" in find_cells_as_checked(["f"], cells)) == is_found

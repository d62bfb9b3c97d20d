"""Students' own contracts.

A program is accepted by its own contract's judge only. A contract is stated in the notebook, and
grades follow it.
"""

import csv
import json
import re
import runpy
import shutil
import unicodedata
from math import inf, pi
from pathlib import Path

import numpy as np
import pytest
from judged_programs import take_few_cases

from kinoedu.cli import main
from kinoedu.course import EXERCISES, check
from kinoedu.course.bank import Solutions, read_variants
from kinoedu.course.exercise import Case
from kinoedu.course.feedback import Feedback
from kinoedu.course.judging import judge_outcomes, judge_until_failure, run_case
from kinoedu.course.lessons import find
from kinoedu.course.lessons.shared.graph_slips import search_breadth_first
from kinoedu.course.outcomes import Answer
from kinoedu.course.restated import OuterValue
from kinoedu.course.section import choose_for_section, vary_exercises
from kinoedu.course.trivial import find_trivial_kinds
from kinoedu.errors import InvalidParameter
from kinoedu.grading import class_grading
from kinoedu.grading.assignments.questions import Assignment, draw_cases, read_assignment
from kinoedu.grading.collect.submissions import Submission
from kinoedu.grading.export.autograder import autograde
from kinoedu.grading.export.autograder_zip import pack_autograder
from kinoedu.grading.judge import contracts
from kinoedu.grading.judge import variants as handing_out
from kinoedu.grading.judge.contracts import (
    add_contracts,
    add_section,
    apply_contracts,
    choose_contract,
    choose_contracts,
    refuse_forgotten,
    set_apart,
    vary,
    warn_of_other_variants,
)
from kinoedu.grading.judge.running import Graded, compute_key
from kinoedu.grading.judge.variants import write_section, write_variants
from kinoedu.grading.sandbox import sandbox
from kinoedu.planners import bug1, bug2

NO_SANDBOX = sandbox.explain_no_sandbox()
needs_sandbox = pytest.mark.skipif(bool(NO_SANDBOX), reason=NO_SANDBOX or "there is one")
SECRET = b"a secret of the tests, no course's"
GRAPHS, BUGS = "04_graph_search", "02_bug_algorithms"
NO_VARIANTS = Assignment("01_walls", (), {})
HOUSE = Path(__file__).resolve().parent.parent
CHANGED = [  # variants with another right answer
    find(exercise.name, change.key)
    for exercise in EXERCISES.values()
    for change in exercise.changes
]
ANSWERS = [
    right
    for file in sorted((HOUSE / "solutions" / "bank").glob("*.py"))
    for right in read_variants(file)
]


def tree(choose):
    """A breadth-first tree by levels, in which `choose` picks each node's parent."""

    def bfs_tree(neighbours, start):
        parent, level, seen = [-1] * len(neighbours), {start}, {start}
        while level:
            below: dict[int, list[int]] = {}
            for v in level:
                for u in set(neighbours[v]) - seen:
                    below.setdefault(u, []).append(v)
            for u, able in below.items():
                parent[u] = choose(able)
            level = set(below)
            seen |= level
        return parent

    return bfs_tree


def walker(planner, **how):
    """A bug of the library as a student's function."""
    return lambda start, goal, obstacles, step: planner(start, goal, obstacles, step, **how).path


PROGRAMS = {
    ("bfs_tree", "smallest"): tree(min),
    ("bfs_tree", "largest"): tree(max),
    ("bug1", "left"): walker(bug1, turn="left"),
    ("bug1", "right"): walker(bug1, turn="right"),
    ("bug2", "left"): walker(bug2, turn="left"),
    ("bug2", "right"): walker(bug2, turn="right"),
}


def judged(exercise, function, seed=0):
    """The report on a function."""
    cases = list(exercise.cases(np.random.default_rng(seed)))
    return judge_outcomes(exercise, cases, (run_case(exercise, function, case) for case in cases))


@pytest.mark.parametrize("name", ["bfs_tree", "bug1", "bug2"])
def test_a_contract_accepts_its_own_and_no_other(name):
    """Each contract's program is right for it and for the plain exercise, and wrong for others."""
    variants = EXERCISES[name].variants
    assert len(variants) > 1
    for mine in variants:
        assert judged(EXERCISES[name], PROGRAMS[name, mine]).is_right
        for other in variants:
            report = judged(find(name, other), PROGRAMS[name, mine])
            assert report.is_right == (mine == other), (mine, other, report.failure)
            if mine != other:  # only the contract is broken, and no misconception is reported
                assert (report.failure.verdict.rule, report.failure.slip) == ("contract", "")


@pytest.mark.parametrize("variant", ["smallest", "largest"])
def test_a_tree_by_no_contract_is_no_misconception(variant):
    """A program that takes the first parent breaks the contract, whichever cases are drawn.

    No misconception is reported.
    """
    for seed in range(20):
        report = judged(find("bfs_tree", variant), search_breadth_first, seed)
        assert (report.failure.verdict.rule, report.failure.slip) == ("contract", "")


@pytest.fixture(scope="module")
def usual_answers():
    """The solutions to the usual forms, by the name of the exercise."""
    notebooks = {one.lesson: None for one in CHANGED}
    return {
        name: answer
        for lesson in notebooks
        for name, answer in Solutions(HOUSE / "solutions" / f"{lesson}.ipynb").right.items()
    }


@pytest.mark.parametrize("exercise", CHANGED, ids=lambda one: f"{one.name}-{one.variant}")
def test_a_changed_exercise_accepts_its_own_answer_alone(exercise, usual_answers):
    """The usual answer and those to other variants are refused, and the message is the contract.

    The usual answer earns nothing, whatever it is right for.
    """
    cases = take_few_cases(exercise)

    def judge(function):
        return judge_until_failure(exercise, cases, lambda case: run_case(exercise, function, case))

    answers = {one.variant: one.function for one in ANSWERS if one.exercise == exercise.name}
    assert set(answers) == set(exercise.variants)
    for variant, function in answers.items():
        assert judge(function).is_right == (variant == exercise.variant), variant
    refused = judge(usual_answers[exercise.name])
    assert not refused.is_right
    assert (refused.failure.verdict.rule, refused.failure.slip) == ("contract", "")
    assert exercise.contract in repr(Feedback(refused))
    assert "usual form" in repr(Feedback(refused))
    if exercise.name != "tree_roadmap":  # it tells sizes alone
        case = refused.failure.case
        wanted = EXERCISES[exercise.name].describe_expected(case)
        assert exercise.describe_expected(case) != wanted


@pytest.mark.parametrize(
    "exercise",
    [one for one in CHANGED if isinstance(one, OuterValue)],
    ids=lambda one: f"{one.name}-{one.variant}",
)
def test_what_is_shown_as_right_is_right(exercise):
    """A message shows the true answer in the variant's form: the judge would accept it."""
    for case in {case.kind: case for case in exercise.fixed_cases[::-1]}.values():
        truth = exercise.truth(case)
        if not isinstance(truth, ValueError):
            value = exercise.answer.decode(exercise.answer.encode(truth))
            assert exercise.judge(case, Answer(value)).is_right, (case, value)


def test_the_usual_answer_to_a_changed_exercise_earns_nothing():
    """It is right for two kinds of input, and no kind counts that it is right for."""
    exercise, usual = find("heading_distance", "sum"), EXERCISES["heading_distance"]
    cases = draw_cases("heading_distance", SECRET, "sum").cases
    trivial = find_trivial_kinds(exercise, cases)
    assert frozenset({"place", "heading"}) in trivial
    outcomes = [run_case(exercise, usual.right_answer, case) for case in cases]
    report = judge_outcomes(exercise, cases, outcomes, trivial)
    assert set(report.passed) == {"place", "heading"}
    assert report.score == 0.0


EXAMPLE = re.compile(r"`(\w+)\((.*?)\)` (?:is|may be) `(.*?)`")


@pytest.mark.parametrize("exercise", CHANGED, ids=lambda one: f"{one.name}-{one.variant}")
def test_the_example_of_a_contract_is_right(exercise, monkeypatch):
    """Each contract has an example; those that are calls are judged here, to six digits."""
    monkeypatch.setattr(type(EXERCISES["collision_probability"]), "tolerance", 1e-6)
    if "problem" in exercise.given.fields:
        assert "eturn" in exercise.contract or "joined" in exercise.contract
        return
    name, *texts = EXAMPLE.search(exercise.contract).groups()
    assert name == exercise.name
    values, wanted = (eval(f"[{text}]", {"pi": pi, "inf": inf}) for text in texts)
    given = exercise.given.encode(dict(zip(exercise.given.fields, values, strict=True)))
    case = Case(exercise.kinds[0], exercise.given.decode(given))
    outcome = run_case(exercise, lambda *given: wanted[0], case)
    assert exercise.judge(case, outcome).is_right


@pytest.mark.parametrize(
    "exercise",
    [EXERCISES[name] for name in ("bfs_tree", "bug1", "bug2")],
    ids=lambda one: one.name,
)
def test_every_contract_has_words_of_its_own(exercise):
    """A program that breaks the contract gets its text."""
    words = [find(exercise.name, variant).contract for variant in exercise.variants]
    assert len(set(words)) == len(words)
    assert exercise.contract == ""
    for mine, other in zip(exercise.variants, exercise.variants[::-1]):
        feedback = check(PROGRAMS[exercise.name, other], exercise.name, variant=mine)
        assert "Your contract" in repr(feedback)
        assert find(exercise.name, mine).contract in repr(feedback)
        assert feedback.picture() is not None
        assert "right, for all" in repr(
            check(PROGRAMS[exercise.name, mine], exercise.name, variant=mine)
        )


def test_an_unknown_contract_is_refused():
    """The message lists the contracts that exist."""
    with pytest.raises(InvalidParameter, match="left, right"):
        find("bug2", "backwards")
    with pytest.raises(InvalidParameter, match="none"):
        find("radical_inverse", "left")


def test_contracts_follow_from_secret_and_student():
    """Upper case and the spelling of accents do not matter; all are about as frequent; another
    secret gives others.

    An assignment without contracts has none.
    """
    students = [f"étudiant{n}" for n in range(400)]
    first = [choose_contract(EXERCISES["bug2"], SECRET, student) for student in students]
    assert first == [
        choose_contract(EXERCISES["bug2"], SECRET, f" {student.upper()} ") for student in students
    ]
    apart = [unicodedata.normalize("NFD", student) for student in students]
    assert first == [choose_contract(EXERCISES["bug2"], SECRET, student) for student in apart]
    assert 150 < first.count("left") < 250
    assert first != [
        choose_contract(EXERCISES["bug2"], b"another", student) for student in students
    ]
    assert first != [choose_contract(EXERCISES["bug1"], SECRET, student) for student in students]
    assert choose_contracts(NO_VARIANTS, SECRET, "ann") == ()
    task = apply_contracts(read_assignment(GRAPHS), (("bfs_tree", "largest"),))
    assert [one.exercise.variant for one in task.questions if one.exercise.name == "bfs_tree"] == [
        "largest"
    ]
    assert [one.points for one in task.questions] == [
        one.points for one in read_assignment(GRAPHS).questions
    ]


def test_hidden_cases_and_results_know_the_contract():
    """Equal bytes under another contract have another result."""
    one = Submission("ann", GRAPHS, "x.ipynb", b"{}")
    keys = {
        compute_key(one._replace(variants=(("bfs_tree", variant),)), SECRET)
        for variant in ("smallest", "largest")
    }
    assert len(keys | {compute_key(one, SECRET)}) == 3
    assert draw_cases("bfs_tree", SECRET, "largest").cases != draw_cases("bfs_tree", SECRET).cases
    assert add_contracts(one, SECRET).variants == choose_contracts(
        read_assignment(GRAPHS), SECRET, "ann"
    )


def test_each_student_gets_their_own_notebook(tmp_path, monkeypatch):
    """The contract stands before the answer and in the check; nothing else changes.

    A table lists which student has which contract, and where the notebook is.
    """
    students = [*(f"s{n}" for n in range(11)), "Jane Doe_4711"]
    assert write_variants([GRAPHS], students, SECRET, tmp_path) == 12
    plain = json.loads(
        (Path(__file__).parent.parent / "exercises" / f"{GRAPHS}.ipynb").read_text(encoding="utf-8")
    )
    with (tmp_path / "variants.csv").open(encoding="utf-8", newline="") as table:
        rows = list(csv.DictReader(table))
    places = {row["student"]: row["notebook"] for row in rows}
    for student in students:
        mine = choose_contract(EXERCISES["bfs_tree"], SECRET, student)
        book = json.loads((tmp_path / places[student]).read_text(encoding="utf-8"))
        sources = ["".join(cell["source"]) for cell in book["cells"]]
        at = next(at for at, cell in enumerate(book["cells"]) if cell["id"] == "contract_bfs_tree")
        assert find("bfs_tree", mine).contract in sources[at]
        assert "def bfs_tree" in sources[at + 1]
        assert f'check(bfs_tree, variant="{mine}")' in sources
        varied = len(choose_contracts(read_assignment(GRAPHS), SECRET, student))
        assert len(sources) == len(plain["cells"]) + varied
        others = ["".join(cell["source"]) for cell in plain["cells"]]
        assert len([source for source in sources if source not in others]) == 2 * varied
    assert {row["variant"] for row in rows if row["question"] == "bfs_tree"} == {
        "smallest",
        "largest",
    }
    monkeypatch.setattr(handing_out, "read_assignment", lambda *_: NO_VARIANTS)
    with pytest.raises(InvalidParameter, match="no exercise of 04_graph"):
        write_variants([GRAPHS], students, SECRET, tmp_path)


def test_an_exercise_with_answers_in_it_is_not_handed_out(tmp_path):
    """A teacher tried the exercise and saved it: neither students nor sections get the answers."""
    for folder in ("solutions", "exercises"):
        (tmp_path / folder).mkdir()
        shutil.copy(HOUSE / "solutions" / f"{GRAPHS}.ipynb", tmp_path / folder)
    out = tmp_path / "out"
    with pytest.raises(InvalidParameter, match="may have answers in it"):
        write_variants([GRAPHS], ["ann"], SECRET, out, tmp_path)
    with pytest.raises(InvalidParameter, match="may have answers in it"):
        write_section([GRAPHS], "B", out, tmp_path)
    assert not out.exists()


def test_forgotten_contracts_are_refused(tmp_path):
    """Grading is refused if most notebooks hold a contract, but not if a single one does."""
    given, plain = (
        Submission(str(n), GRAPHS, "x", data)
        for n, data in enumerate((b'check(bfs_tree, variant="largest")', b"{}"))
    )
    refuse_forgotten([given, plain])
    with pytest.raises(InvalidParameter, match="--variants"):
        refuse_forgotten([given, given, plain])


def test_the_kit_of_a_section_has_its_variants():
    """A is the first variant of each exercise, B the second; other files stay as they are."""
    files = {
        place: (HOUSE / place).read_bytes()
        for place in ("exercises/README.md", f"exercises/{BUGS}.ipynb", f"exercises/{GRAPHS}.ipynb")
    }
    for letter, bugs, graphs in (("A", "left", "smallest"), ("B", "right", "largest")):
        made = vary_exercises(files, letter)
        assert set(made) == {f"exercises/{BUGS}.ipynb", f"exercises/{GRAPHS}.ipynb"}
        checks = re.findall(r"check\((\w+), variant=.\W(\w+)", b"".join(made.values()).decode())
        assert checks[:3] == [("bug1", bugs), ("bug2", bugs), ("bfs_tree", graphs)]
        exercises = [one for one in EXERCISES.values() if one.lesson in (BUGS, GRAPHS)]
        assert dict(checks) == dict(choose_for_section(exercises, letter))
    for wrong in ("C", "b", "AB", "students.txt"):
        with pytest.raises(InvalidParameter, match="A, B, got"):
            vary_exercises(files, wrong)


def test_a_notebook_of_another_section_has_no_score(tmp_path):
    """It is not graded as its own section's: the reason names the variant that it asks for."""
    plain = Submission("ann", GRAPHS, "x", (HOUSE / "exercises" / f"{GRAPHS}.ipynb").read_bytes())
    given = {
        letter: plain._replace(data=write_section([GRAPHS], letter, tmp_path)[0].read_bytes())
        for letter in "AB"
    }
    mine = add_section(given["B"], "B")
    assert (mine.trouble, mine.letter) == ("", "B")
    assert mine.variants[0] == ("bfs_tree", "largest")
    other = add_section(given["A"], "B").trouble
    assert other.startswith("its checks ask for variant A (")
    assert "bfs_tree: smallest" in other
    assert other.endswith("this section has variant B: grade it apart, with --variant A")
    assert "usual form" in add_section(plain, "B").trouble
    assert add_section(given["A"], "") == given["A"]
    damaged = add_section(plain._replace(data=b"{"), "B")
    assert damaged.letter == "B"
    assert damaged.trouble.startswith("the file is not a whole notebook")
    with pytest.raises(InvalidParameter, match="with --variant and the letter"):
        refuse_forgotten([given["B"]])


def test_a_notebook_of_a_section_among_the_usual_has_no_score(tmp_path, monkeypatch):
    """It is listed with the option to grade it with; one check that was edited is none."""
    plain = Submission("ann", GRAPHS, "x", (HOUSE / "exercises" / f"{GRAPHS}.ipynb").read_bytes())
    given = plain._replace(data=write_section([GRAPHS], "B", tmp_path)[0].read_bytes())
    trouble = set_apart(given).trouble
    assert trouble.startswith("its checks ask for variant B (")
    assert trouble.endswith("this section has the usual form: grade it apart, with --variant B")
    write_variants([GRAPHS], ["s1"], SECRET, tmp_path)
    own = plain._replace(data=(tmp_path / "s1" / f"{GRAPHS}.ipynb").read_bytes())
    assert set_apart(own).trouble.endswith("grade it apart, with --variants")
    edited = plain.data.replace(b"check(bfs_tree", b"check(bfs_tree, variant='largest'", 1)
    assert edited != plain.data
    for one in (plain, plain._replace(data=edited), given._replace(letter="B")):
        assert set_apart(one) == one
    monkeypatch.setattr(contracts, "read_assignment", lambda *_: NO_VARIANTS)
    assert set_apart(given) == given


def test_a_section_is_graded_by_its_variant(tmp_path, capsys, monkeypatch):
    """The judges of a section's notebooks are those of its variant, also where it is regraded.

    Another section may be graded into the same folder. A notebook of section A among those of
    section B is listed, and has no score.
    """
    given = []

    def grade_all(submissions, *_, **__):
        given.extend(submissions)
        return [Graded(one, None, one.trouble) for one in submissions]

    monkeypatch.setattr(class_grading, "grade_all", grade_all)
    monkeypatch.setattr(class_grading, "require_sandbox", lambda trusted: None)
    for folder, letter in (("in/ann", "B"), ("in/bob", "A"), ("other/cy", "A")):
        folder = tmp_path / folder
        assert main(["release", GRAPHS, "--variant", letter, "--out", str(folder)]) == 0
    (tmp_path / "secret").write_text(SECRET.hex())
    options = ["--secret", str(tmp_path / "secret"), "--out"]
    grade = ["grade", str(tmp_path / "in"), *options, str(tmp_path / "out"), "--variant", "B"]
    other = ["grade", str(tmp_path / "other"), *grade[2:-1], "A"]
    again = ["regrade", str(tmp_path / "out"), *options, str(tmp_path / "new")]
    for command in (grade, other, again):
        before = [] if command is again else list(given)
        given.clear()
        assert main(command) == 1
        ann, bob, *others = [*before, *given]
        assert {one.variants[0] for one in others} <= {("bfs_tree", "smallest")}
        questions = apply_contracts(read_assignment(GRAPHS), ann.variants).questions
        assert questions[0].exercise is find("bfs_tree", "largest")
        assert bob.trouble.endswith("grade it apart, with --variant A")
        listed = capsys.readouterr().out
        assert f"bob/{GRAPHS}.ipynb: unreadable: {bob.trouble}" in listed


def test_an_assignment_in_the_usual_form_keeps_it_beside_one_with_variants(
    tmp_path, capsys, monkeypatch
):
    """In one folder of submissions and one of grades, also where all is graded again."""
    given = {}

    def grade_all(submissions, *_, **__):
        given.update({(one.student, one.assignment): bool(one.variants) for one in submissions})
        return [Graded(one, None, one.trouble) for one in submissions]

    monkeypatch.setattr(class_grading, "grade_all", grade_all)
    monkeypatch.setattr(class_grading, "require_sandbox", lambda trusted: None)
    (tmp_path / "secret").write_text(SECRET.hex())
    write_variants([GRAPHS], ["ann", "bob"], SECRET, tmp_path / "in")
    (tmp_path / "in" / "variants.csv").unlink()
    for student in ("ann", "bob"):
        shutil.copy(HOUSE / "exercises" / f"{BUGS}.ipynb", tmp_path / "in" / student)
    options = ["--secret", str(tmp_path / "secret"), "--out", str(tmp_path / "out")]
    grade = ["grade", str(tmp_path / "in"), *options]
    assert main([*grade, "--variants"]) == 2
    assert f"no notebook of {BUGS} asks for variants" in capsys.readouterr().err
    again = ["regrade", str(tmp_path / "out"), *options[:3], str(tmp_path / "new")]
    with_variants = [*grade, "--assignment", GRAPHS]
    for command in (
        [*with_variants, "--variants"],
        [*grade, "--assignment", BUGS],
        with_variants,
        again,
    ):
        assert main(command) == 1
        assert all(has_own == (name == GRAPHS) for (_, name), has_own in given.items())
    assert len(given) == 4


def test_one_notebook_without_checks_is_graded_by_its_students_variants(caplog):
    """Only several without any tell that the exercise was handed out in the usual form."""
    one = Submission("ann", GRAPHS, "x", b'{"nbformat": 4, "cells": []}')
    vary([one], SECRET)
    with pytest.raises(InvalidParameter, match="no notebook of"):
        vary([one, one._replace(student="bob")], SECRET)


@needs_sandbox
def test_an_autograder_knows_its_section(tmp_path):
    """Gradescope tells a student of another section what to do, without the options of `grade`.

    A letter without variants is refused.
    """
    write_section([GRAPHS], "A", tmp_path / "submission")
    (tmp_path / "results").mkdir()
    for letter in ("B", ""):
        results = autograde(tmp_path, GRAPHS, SECRET, letter=letter)
        assert results["tests"] == []
        assert "ask for variant A (" in results["output"]
        assert ": hand it in where your section does" in results["output"]
        assert "--variant" not in results["output"]
    with pytest.raises(InvalidParameter, match="A, B, got 'Z'"):
        pack_autograder(tmp_path / "a.zip", GRAPHS, SECRET, letter="Z")


ANSWER = """
def bfs_tree(neighbours, start):
    parent, level, seen = [-1] * len(neighbours), {start}, {start}
    while level:
        below = {}
        for v in level:
            for u in set(neighbours[v]) - seen:
                below.setdefault(u, []).append(v)
        for u, able in below.items():
            parent[u] = CHOOSE(able)
        level = set(below)
        seen |= level
    return parent
"""


@needs_sandbox
def test_a_copy_of_anothers_contract_does_not_pass(tmp_path, capsys, caplog):
    """Two students with different contracts hand in one program; it is right for one.

    Regrading does not change that.
    """
    secret = tmp_path / "secret"
    secret.write_text(SECRET.hex())
    names = {
        choose_contract(EXERCISES["bfs_tree"], SECRET, name): name
        for name in ("ann", "bob", "cy", "dan", "eve")
    }
    (tmp_path / "students.txt").write_text("\n".join(names.values()) + "\n")
    command = ["release", GRAPHS, "--variants", str(tmp_path / "students.txt")]
    command += ["--out", str(tmp_path / "hand"), "--secret", str(secret)]
    assert main(command) == 0
    for student in names.values():
        book = json.loads(
            (tmp_path / "hand" / student / f"{GRAPHS}.ipynb").read_text(encoding="utf-8")
        )
        for cell in book["cells"]:
            if cell["metadata"].get("nbgrader", {}).get("grade_id") == "bfs_tree":
                cell["source"] = ANSWER.replace("CHOOSE", "max")
        (tmp_path / "in" / student).mkdir(parents=True)
        (tmp_path / "in" / student / f"{GRAPHS}.ipynb").write_text(json.dumps(book))
    grade = ["grade", str(tmp_path / "in"), "--out", str(tmp_path / "out")]
    grade += ["--secret", str(secret), "--workers", "1"]
    assert main(grade) == 2
    assert "--variants" in capsys.readouterr().err
    assert main([*grade, "--variants"]) == 0
    assert "other variants" not in caplog.text
    table = (tmp_path / "out" / "grades.csv").read_text(encoding="utf-8")
    scores = {
        line.split(",")[0]: line.split(",")[3]
        for line in table.splitlines()
        if ",bfs_tree," in line
    }
    assert float(scores[names["largest"]]) == 4.0
    assert float(scores[names["smallest"]]) < 4.0
    page = next((tmp_path / "out" / "feedback" / names["smallest"]).iterdir()).read_text(
        encoding="utf-8"
    )
    assert find("bfs_tree", "smallest").contract in page
    regrade = ["regrade", str(tmp_path / "out"), "--out", str(tmp_path / "new")]
    assert main([*regrade, "--workers", "1"]) == 0
    assert "0 scores changed" in capsys.readouterr().out
    shutil.copy(
        tmp_path / "in" / names["smallest"] / f"{GRAPHS}.ipynb", tmp_path / "in" / names["largest"]
    )
    assert main([*grade, "--variants"]) == 0
    assert "1 of 2 notebooks ask for other variants" in caplog.text
    assert f"such as that of {names['largest']};" in caplog.text


@pytest.mark.parametrize(
    ("check", "is_told"),
    [
        ("check(bfs_tree, variant='largest')", False),
        ("check(bfs_tree, variant='smallest')", True),
        ("check(bfs_tree)", True),
    ],
)
def test_a_class_is_told_of_checks_for_other_students_variants(check, is_told, caplog):
    """Where ids were spelled otherwise at release, say, right answers would lose their points
    without a word.
    """
    cell = {"cell_type": "code", "source": check, "metadata": {}, "outputs": []}
    data = json.dumps({"cells": [cell], "metadata": {}, "nbformat": 4, "nbformat_minor": 5})
    one = Submission("ann", GRAPHS, "x.ipynb", data.encode())
    warn_of_other_variants([one._replace(variants=(("bfs_tree", "largest"),)), one])
    assert ("1 of 1 notebooks ask for other variants" in caplog.text) == is_told
    assert ("such as that of ann" in caplog.text) == is_told


def test_the_page_of_variants_lists_all():
    """As they are: python docs/variants.py writes it anew.

    What is listed without variants has none, and is there once. A new exercise need not have any.
    """
    page = HOUSE / "docs" / "variants.md"
    written = runpy.run_path(str(HOUSE / "docs" / "variants.py"))["written"]()
    assert page.read_text(encoding="utf-8") == written, "run python docs/variants.py"
    without = re.findall(r"`(\w+)`", written.partition("## Exercises without variants")[2])
    without.remove("similar")
    assert len(without) == len(set(without))
    assert not any(EXERCISES[name].variants for name in without)


@pytest.mark.parametrize(
    ("name", "variant"),
    [("displacement", ""), ("displacement", "way_back"), ("csc_length", "backward")],
)
def test_kept_cases_are_those_that_are_drawn(name, variant):
    """A variant keeps the cases of the usual form, in its own arguments; they are drawn once."""
    exercise = find(name, variant)
    drawn = exercise.cases(np.random.default_rng(0))
    spelled = [(case.kind, exercise.given.encode(case.given)) for case in exercise.fixed_cases]
    assert spelled == [(case.kind, exercise.given.encode(case.given)) for case in drawn]
    assert exercise.fixed_cases is find(name, variant).fixed_cases

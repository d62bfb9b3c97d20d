"""Judges right and wrong programs by `check`: python judged_programs.py HOUSE prints as JSON what
it says about each. Solutions and banks are those of the house; the library is the one that Python
finds, such as that of a kit for students.
"""

import json
import sys
from pathlib import Path

from kinoedu.course import EXERCISES, check
from kinoedu.course.bank import read_bank, read_variants
from kinoedu.course.withheld import NotInTheKit
from kinoedu.figures.plane import plane_figure

# programs of the bank that compute, or wait, until they are stopped
ENDLESS = {
    "all_paths_that_never_forget",
    "connects_by_straight_lines",
    "follows_first_neighbours",
    "goes_round_for_ever",
    "marks_its_own_path_only",
    "much_nearer_than_the_hit",
    "nearer_in_x",
    "never_arrives",
    "never_ends",
    "never_marks_anything",
    "round_and_round",
    "seen_on_this_way_only",
    "sleeps",
}


def take_few_cases(exercise) -> list:
    """The first cases of an exercise, at least three of each kind."""
    missing, cases = dict.fromkeys(exercise.kinds, 3), []
    for case in exercise.fixed_cases:
        cases.append(case)
        missing[case.kind] -= 1
        if max(missing.values()) <= 0:
            break
    return cases


def right_programs(house: Path, lessons: str = "*"):
    """Yield the names of the exercises and of their variants, and the right programs."""
    for notebook in sorted((house / "solutions").glob(f"{lessons}.ipynb")):
        defined = {}
        for cell in json.loads(notebook.read_text(encoding="utf-8"))["cells"]:
            source = "".join(cell["source"])
            if (
                cell["cell_type"] == "code"
                and not source.startswith("check(")
                and "show(" not in source
            ):
                exec(compile(source, notebook.name, "exec"), defined)
        for exercise in EXERCISES.values():
            if exercise.lesson == notebook.stem:
                yield exercise.name, "", defined[exercise.name]
    for bank in sorted((house / "solutions" / "bank").glob("*.py")):
        for right in read_variants(bank):
            yield right.exercise, right.variant, right.function


def wrong_programs(house: Path):
    """Yield a wrong program for each exercise, and one for a variant of it where there are any.

    It has a known misconception, where there is one.
    """
    chosen = {}
    for bank in sorted((house / "solutions" / "bank").glob("*.py")):
        for item in read_bank(bank):
            form = item.exercise, bool(item.variant)
            if item.slip and not chosen.setdefault(form, item).slip:
                chosen[form] = item
            elif item.name not in ENDLESS:
                chosen.setdefault(form, item)
    for item in chosen.values():
        yield item.exercise, item.variant, item.function


def judged(name: str, variant: str, program) -> dict:
    """What `check` says about a program, with the kinds of things in its picture."""
    feedback = check(program, name, variant=variant)
    failure = feedback.report.failure
    found = {
        "right": feedback.report.is_right,
        "failed": list(feedback.report.failed),
        "text": dict(feedback.list_entries()),
    }
    if failure is not None:
        _, ax = plane_figure()
        feedback.report.exercise.draw(failure.case, failure.outcome, ax)
        picture = [type(thing).__name__ for thing in ax.get_children()]
        found |= {"rule": failure.verdict.rule, "slip": failure.slip, "picture": picture}
    return found


def judge_all(programs) -> dict[str, dict]:
    """What `check` says about each program, by exercise and variant; or what the kit lacks."""
    found = {}
    for exercise, variant, program in programs:
        try:
            found[f"{exercise}-{variant}"] = judged(exercise, variant, program)
        except NotInTheKit as error:
            found[f"{exercise}-{variant}"] = {"right": False, "lacks": str(error)}
    return found


if __name__ == "__main__":
    house = Path(sys.argv[1])
    print(json.dumps([judge_all(right_programs(house)), judge_all(wrong_programs(house))]))

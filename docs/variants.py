"""Writes variants.md: every variant of every exercise, with the contract that its students read.

python docs/variants.py, after a change of a variant.
"""

from collections.abc import Iterator
from itertools import groupby
from pathlib import Path

from kinoedu.course import EXERCISES, find

PAGE = Path(__file__).resolve().parent / "variants.md"
HEAD = """\
# Variants of exercises

`python start.py release NAME --variants students.txt` gives each student one of them
([how](grading_more.md)). `python docs/variants.py` writes this page.
"""


def written() -> str:
    """The page: a list of the contracts of each lesson."""
    varied = [exercise for exercise in EXERCISES.values() if exercise.variants]
    lessons = groupby(varied, key=lambda exercise: exercise.lesson)
    return HEAD + "".join(
        f"\n## {lesson}\n\n" + "".join(line for one in its for line in lines(one.name))
        for lesson, its in lessons
    )


def lines(name: str) -> Iterator[str]:
    """A line for each variant of an exercise."""
    for variant in EXERCISES[name].variants:
        yield f"- `{name}`, `{variant}`: {find(name, variant).contract}\n"


if __name__ == "__main__":
    PAGE.write_text(written(), encoding="utf-8")

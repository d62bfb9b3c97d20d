"""Writes variants.md: every variant of every exercise, with the contract that its students read.

python docs/variants.py, after a change of a variant.
"""

from collections.abc import Iterable, Iterator
from itertools import groupby
from pathlib import Path
from string import ascii_uppercase

from kinoedu.course import EXERCISES, find

PAGE = Path(__file__).resolve().parent / "variants.md"
HEAD = """\
# Variants of exercises

`python start.py release NAME --variants students.txt` gives each student one of them,
`python start.py release --zip course_B.zip --variant B` gives a section the second of each exercise
([how](grading_more.md#variants)). `.venv/bin/python docs/variants.py` writes this page.
"""
WITHOUT = {
    "a later exercise calls the function": (
        "line_through_points",
        "point_segment_distance",
        "bug_base",
        "crossings",
        "extract_path",
        "rotation",
        "circle_distance",
        "corner_grid",
        "sukharev_grid",
        "radical_inverse",
        "link_in_contact",
        "k_closest",
        "move",
        "fastest_drive",
    ),
    "the answer is an input that one finds; many are right, and `similar` shows equal ones": (
        "exposing_case",
        "exposing_problem",
        "exposing_world",
        "misleading_estimate",
        "exposing_reach",
        "exposing_corridor",
        "overlooked_gap",
        "exposing_sight",
        "exposing_room",
        "exposing_motion",
        "exposing_obstacle",
        "exposing_drive",
        "exposing_motions",
    ),
    "the judge follows the program's own steps, or its random numbers": (
        "uniform_random",
        "sampled_roadmap",
        "rrt",
        "rrt_connect",
        "rrt_on_terrain",
        "prm_on_terrain",
        "compare_planners",
        "rrt_for_polygon",
        "kinodynamic_rrt",
        "kinodynamic_prm",
    ),
    "the answer is a drawing": ("plot_environment", "plot_configuration_space"),
}


def written() -> str:
    """The page: a list of the contracts of each lesson."""
    varied = [exercise for exercise in EXERCISES.values() if exercise.variants]
    lessons = groupby(varied, key=lambda exercise: exercise.lesson)
    return (
        HEAD
        + "".join(
            f"\n## {lesson}\n\n" + "".join(line for one in its for line in lines(one.name))
            for lesson, its in lessons
        )
        + "\n## Exercises without variants\n\n"
        + "".join(f"- {reason}: {listed(names)}\n" for reason, names in WITHOUT.items())
    )


def listed(names: Iterable[str]) -> str:
    """Names of functions, as a list in a sentence."""
    return ", ".join(f"`{name}`" for name in names)


def lines(name: str) -> Iterator[str]:
    """A line for each variant of an exercise."""
    for letter, variant in zip(ascii_uppercase, EXERCISES[name].variants):
        yield f"- `{name}`, {letter}, `{variant}`: {find(name, variant).contract}\n"


if __name__ == "__main__":
    PAGE.write_text(written(), encoding="utf-8")

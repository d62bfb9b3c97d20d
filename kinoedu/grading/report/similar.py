"""Find similar programs among submissions, and between submissions and the course's own programs.

The result is for people to look at. It proves nothing, and no score depends on it. Code that all
students were given is removed first. A fingerprint weighs more, the fewer submissions have it,
since code that half of a class writes is no sign of copying.
"""

import functools
import math
from collections import Counter
from collections.abc import Collection, Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ...course.release import HOUSE, solution_path
from ..assignments.questions import read_assignment
from ..collect.notebook import UnreadableSubmission, read_cells
from ..collect.submissions import Submission
from .fingerprints import Piece, split_program

ROOMS = (
    *("geometry", "graphs", "spaces", "sampling", "curves"),
    *("worlds", "robots", "collision", "decomposition", "planners"),
)
EQUAL = 1e-6  # weights that differ by less count as equal


class Program(NamedTuple):
    """A program: its author, or its place in the course, and its pieces."""

    name: str
    pieces: list[Piece]

    @property
    def prints(self) -> set[int]:
        """The set of all its fingerprints."""
        return {one for piece in self.pieces for one in piece.prints}


class Likeness(NamedTuple):
    """Two programs with common fingerprints.

    weight : the weight of these.
    of_first, of_second : their fraction of each program's weight.
    """

    first: Program
    second: Program
    weight: float
    of_first: float
    of_second: float


class Similar(NamedTuple):
    """The programs of an assignment, and the pairs with common fingerprints, heaviest first.

    each_other : pairs of submissions.
    course : pairs of a submission and a program of the course.
    """

    assignment: str
    programs: list[Program]
    each_other: list[Likeness]
    course: list[Likeness]


def find_similar(
    name: str, submissions: Iterable[Submission], most: int = 100, house: Path = HOUSE
) -> Similar:
    """Compare the submissions of one assignment; unreadable ones are left out.

    most : the largest number of pairs of either kind.
    """
    handed_out = find_handed_out_prints(house)
    by_name = sorted(submissions, key=lambda one: (one.student, one.file))
    read = ((one.student, sources) for one in by_name for sources in read_sources(one))
    programs = [make_program(student, sources, handed_out) for student, sources in read]
    course = read_course_programs(name, house)
    others = [make_program(place, sources, handed_out) for place, sources in course]
    pairs = rank_pairs(programs, [one for one in others if one.pieces], most)
    return Similar(name, programs, *pairs)


def read_sources(one: Submission) -> Iterator[list[str]]:
    """Yield a submission's code cells, if they can be read."""
    if not one.trouble:
        try:
            yield [cell.source for cell in read_cells(one.data)]
        except UnreadableSubmission:
            return


def make_program(name: str, sources: Iterable[str], handed_out: Collection[int]) -> Program:
    """A program without the fingerprints that all were given."""
    own = (
        Piece(piece.lines, {one: at for one, at in piece.prints.items() if one not in handed_out})
        for piece in split_program(sources)
    )
    return Program(name, [piece for piece in own if piece.prints])


@functools.cache
def find_handed_out_prints(house: Path) -> frozenset[int]:
    """Every fingerprint of the exercises as handed out and of the lessons."""
    rooms = ("exercises", "notebooks")
    found = [file for room in rooms for file in sorted((house / room).glob("*.ipynb"))]
    books = [[cell.source for cell in read_cells(file.read_bytes())] for file in found]
    return frozenset(
        one
        for sources in books
        for piece in split_program(sources, window=1)
        for one in piece.prints
    )


def read_course_programs(name: str, house: Path) -> Iterator[tuple[str, list[str]]]:
    """Yield the course's own programs: the solution, the bank's wrong answers, and the library."""
    file = solution_path(name, house)
    yield f"solutions/{file.name}", [cell.source for cell in read_cells(file.read_bytes())]
    quoted_names = [f'"{one.exercise.name}"' for one in read_assignment(name, house).questions]
    bank = [
        one
        for one in sorted((house / "solutions" / "bank").glob("*.py"))
        if any(name in one.read_text("utf-8") for name in quoted_names)
    ]
    library = [file for room in ROOMS for file in sorted((house / "kinoedu" / room).rglob("*.py"))]
    for one in bank + library:
        yield one.relative_to(house).as_posix(), [one.read_text(encoding="utf-8")]


def rank_pairs(
    programs: list[Program], others: list[Program], most: int
) -> tuple[list[Likeness], list[Likeness]]:
    """The pairs of programs with each other, and with others, heaviest first."""
    counts = Counter(one for program in programs for one in program.prints)
    weights = {one: math.log((len(programs) + 1) / count) for one, count in counts.items()}
    places = {one: place for place, one in enumerate(sorted(weights))}
    mine, theirs = make_matrix(programs, places), make_matrix(others, places)
    by_place = np.array([weights[one] for one in places])
    if places:
        alike = (mine.multiply(by_place) @ mine.T).toarray()
        like_course = (mine.multiply(by_place) @ theirs.T).toarray()
    else:
        alike, like_course = (np.zeros((len(programs), len(one))) for one in (programs, others))
    unseen = math.log(len(programs) + 1)
    totals = {
        id(one): sum(weights.get(p, unseen) for p in one.prints) for one in (*programs, *others)
    }
    each_other = select_heaviest(np.triu(alike, 1), programs, programs, totals, most)
    return each_other, select_heaviest(like_course, programs, others, totals, most)


def make_matrix(programs: list[Program], places: dict[int, int]) -> "scipy.sparse.csr_array":  # type: ignore[name-defined] # noqa: F821
    """The programs by fingerprints: 1 where a program has the fingerprint."""
    from scipy.sparse import csr_array

    pairs = [
        (row, places[one])
        for row, program in enumerate(programs)
        for one in program.prints
        if one in places
    ]
    rows, columns = np.array(pairs, int).reshape(-1, 2).T
    return csr_array((np.ones(len(pairs)), (rows, columns)), shape=(len(programs), len(places)))


def select_heaviest(
    weights: np.ndarray,
    rows: list[Program],
    columns: list[Program],
    totals: dict[int, float],
    most: int,
) -> list[Likeness]:
    """The pairs for the largest entries of a table; ties are ordered by name."""
    there = weights[weights > EQUAL]
    least = np.partition(there, -most)[-most] if len(there) > most else 0.0
    found = []
    for i, j in np.argwhere(weights > max(EQUAL, least - EQUAL)).tolist():
        first, second, weight = rows[i], columns[j], float(weights[i, j])
        fractions = (weight / totals[id(one)] for one in (first, second))
        found.append(Likeness(first, second, weight, *fractions))
    found.sort(key=lambda one: (-round(one.weight, 5), one.first.name, one.second.name))
    return found[:most]

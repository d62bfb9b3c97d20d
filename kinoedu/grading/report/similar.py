"""Which programs are alike: submissions with each other, and with what the course itself has
written. For a person to look at; it proves nothing, and no score knows of it.

What all were given is taken out first. A fingerprint counts the more, the fewer submissions have
it: what half a class writes by itself is no sign of anything.
"""

import functools
import math
from collections import Counter
from collections.abc import Collection, Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ...course.release import HOUSE, solution_path
from ..assignments.questions import assignment
from ..collect.notebook import UnreadableSubmission, cells_in
from ..collect.submissions import Submission
from .fingerprints import Piece, pieces

ROOMS = (
    "geometry",
    "graphs",
    "spaces",
    "sampling",
    "curves",
    "worlds",
    "robots",
    "collision",
    "decomposition",
    "planners",
)
EQUAL = 1e-6  # weights that differ by less are equal, and names decide


class Program(NamedTuple):
    """A program: whose it is, or where in the course it stands, and its pieces."""

    name: str
    pieces: list[Piece]

    @property
    def prints(self) -> set[int]:
        """All its fingerprints."""
        return {one for piece in self.pieces for one in piece.prints}


class Likeness(NamedTuple):
    """Two programs that have something in common: how much that weighs, and what share of each it
    is.
    """

    first: Program
    second: Program
    weight: float
    of_first: float
    of_second: float


class Similar(NamedTuple):
    """An assignment's programs, what submissions have in common with each other, and with the
    course, the heaviest first.
    """

    assignment: str
    programs: list[Program]
    each_other: list[Likeness]
    course: list[Likeness]


def similar(
    name: str, submissions: Iterable[Submission], most: int = 100, house: Path = HOUSE
) -> Similar:
    """Compare the submissions of one assignment; at most so many likenesses of either kind.
    Unreadable ones are left out.
    """
    given = given_prints(house)
    by_name = sorted(submissions, key=lambda one: (one.student, one.file))
    programs = [
        program(one.student, sources, given) for one in by_name for sources in readable(one)
    ]
    others = [program(place, sources, given) for place, sources in of_the_course(name, house)]
    return Similar(name, programs, *ranked(programs, [one for one in others if one.pieces], most))


def readable(one: Submission) -> Iterator[list[str]]:
    """A submission's cells of code, where they can be read."""
    if not one.trouble:
        try:
            yield [cell.source for cell in cells_in(one.data)]
        except UnreadableSubmission:
            return


def program(name: str, sources: Iterable[str], given: Collection[int]) -> Program:
    """A program without what all were given."""
    own = (
        Piece(piece.lines, {one: at for one, at in piece.prints.items() if one not in given})
        for piece in pieces(sources)
    )
    return Program(name, [piece for piece in own if piece.prints])


@functools.cache
def given_prints(house: Path) -> frozenset[int]:
    """Every fingerprint of what all students have in their hands: the exercises as they are handed
    out, and the lessons.
    """
    found = [
        file
        for room in ("exercises", "notebooks")
        for file in sorted((house / room).glob("*.ipynb"))
    ]
    books = [[cell.source for cell in cells_in(file.read_bytes())] for file in found]
    return frozenset(
        one for sources in books for piece in pieces(sources, window=1) for one in piece.prints
    )


def of_the_course(name: str, house: Path) -> Iterator[tuple[str, list[str]]]:
    """What the course has written: the solution, the wrong answers to its questions, the
    library.
    """
    file = solution_path(name, house)
    yield f"solutions/{file.name}", [cell.source for cell in cells_in(file.read_bytes())]
    asked = [f'"{one.exercise.name}"' for one in assignment(name, house).questions]
    bank = [
        one
        for one in sorted((house / "solutions" / "bank").glob("*.py"))
        if any(word in one.read_text("utf-8") for word in asked)
    ]
    for one in bank + [
        file for room in ROOMS for file in sorted((house / "kinoedu" / room).rglob("*.py"))
    ]:
        yield one.relative_to(house).as_posix(), [one.read_text(encoding="utf-8")]


def ranked(
    programs: list[Program], others: list[Program], most: int
) -> tuple[list[Likeness], list[Likeness]]:
    """The likenesses of programs with each other, and with others, the heaviest first."""
    counts = Counter(one for program in programs for one in program.prints)
    weights = {one: math.log((len(programs) + 1) / count) for one, count in counts.items()}
    places = {one: place for place, one in enumerate(sorted(weights))}
    mine, theirs = matrix(programs, places), matrix(others, places)
    by_place = np.array([weights[one] for one in places])
    alike = (
        (mine.multiply(by_place) @ mine.T).toarray() if places else np.zeros((len(programs),) * 2)
    )
    like_course = (
        (mine.multiply(by_place) @ theirs.T).toarray()
        if places
        else np.zeros((len(programs), len(others)))
    )
    whole = {
        id(one): sum(weights.get(p, math.log(len(programs) + 1)) for p in one.prints)
        for one in (*programs, *others)
    }
    return heaviest(np.triu(alike, 1), programs, programs, whole, most), heaviest(
        like_course, programs, others, whole, most
    )


def matrix(programs: list[Program], places: dict[int, int]) -> "scipy.sparse.csr_array":  # type: ignore[name-defined] # noqa: F821
    """Programs by fingerprints: 1 where a program has it."""
    from scipy.sparse import csr_array

    pairs = [
        (row, places[one])
        for row, program in enumerate(programs)
        for one in program.prints
        if one in places
    ]
    rows, columns = np.array(pairs, int).reshape(-1, 2).T
    return csr_array((np.ones(len(pairs)), (rows, columns)), shape=(len(programs), len(places)))


def heaviest(
    weights: np.ndarray,
    rows: list[Program],
    columns: list[Program],
    whole: dict[int, float],
    most: int,
) -> list[Likeness]:
    """The heaviest entries of a table, in an order that depends on nothing else than names."""
    there = weights[weights > EQUAL]
    least = np.partition(there, -most)[-most] if len(there) > most else 0.0
    found = []
    for i, j in np.argwhere(weights > max(EQUAL, least - EQUAL)).tolist():
        first, second, weight = rows[i], columns[j], float(weights[i, j])
        found.append(
            Likeness(first, second, weight, weight / whole[id(first)], weight / whole[id(second)])
        )
    return sorted(found, key=lambda one: (-round(one.weight, 5), one.first.name, one.second.name))[
        :most
    ]

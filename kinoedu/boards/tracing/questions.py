"""The questions that a reader's function asks a problem: recorded, and drawn in order."""

from collections.abc import Iterable
from typing import Any

from ...errors import KinoeduError
from ...geometry.checks import Array, as_array
from ...problems import Question
from ..core.drawing import Layer, dots, edges
from ..core.notes import note, with_notes

MOST = 20_000  # the questions kept and drawn; of later ones only the motions are counted
MOTIONS = ("is_free_path", "is_semi_free_path")
SAYS = {  # the note of a question: whether it is about a motion, and whether that is free
    (True, True): "accepted",
    (True, False): "refused",
    (False, True): "free",
    (False, False): "not_free",
}


class FirstQuestions(list[Question]):
    """A recorder's log that keeps the first questions about free space and counts motions."""

    motions = 0

    def append(self, question: Question) -> None:
        """Count a motion, and keep the question if there is room."""
        self.motions += question.name in MOTIONS
        if len(self) < MOST and question.name in (*MOTIONS, "is_free"):
            super().append(question)


def draw_questions(questions: list[Question]) -> list[Layer]:
    """Questions as layers that grow."""
    kinds: dict[tuple[bool, bool], list[tuple[int, Any]]] = {
        (motion, free): [] for motion in (True, False) for free in (True, False)
    }
    for number, question in enumerate(questions, start=1):
        points = plane_points(question.given)
        if points is not None:
            kinds[len(points) == 2, bool(question.answer)].append((number, points))
    layers = []
    order = sorted(kinds, key=lambda kind: (not kind[0], kind[1]))  # free motions on top of others
    for motion, free in order:
        found = kinds[motion, free]
        rows, when = [points for _, points in found], [number for number, _ in found]
        colour = "tree" if free else "obstacle" if motion else "contact"
        if motion:
            width, dash = (1.4, ()) if free else (1.0, (3, 5))
            layer = edges(rows, colour, width=width, dash=dash, when=when)
        else:
            layer = dots(rows, colour, when=when)
        says = note(SAYS[motion, free], number=None)
        layers.append(with_notes(layer, says, number=when))
    return layers


def plane_points(given: Iterable[Any]) -> list[Array] | None:
    """The configurations of a question as points of the plane, or None where they are none."""
    try:
        points = [as_array(q, "q") for q in given]
    except KinoeduError:
        return None
    planar = points and all(q.ndim == 1 and len(q) >= 2 for q in points)
    return [q[:2] for q in points] if planar else None

"""The exercise on an arm among discs: which link is in contact? Bullo & Smith, chapters 3 and 4."""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ....geometry import point_line_distance, point_segment_distance
from ....geometry.checks import Array
from ...exercise import Axes, Case, Slip, ValueExercise
from ...outcomes import Answer, Outcome
from ...shapes import Number, Numbers, Record
from ...whole_shapes import Integer
from ...withheld import withheld
from ..geometry.lines import POINT
from .arm_pictures import draw_contact

DISCS = Numbers(("m", 3))
# distance of every case from a change of its answer, except for exact contact
CLEAR = 1e-4


def ends_of_links(q: Array, lengths: Array) -> Array:
    """Base, elbow and tip of an arm with its base at the origin, (3, 2)."""
    heading = np.cumsum(q)
    steps = np.column_stack([lengths * np.cos(heading), lengths * np.sin(heading)])
    return np.vstack([np.zeros(2), np.cumsum(steps, axis=0)])


def gaps(q: Array, lengths: Array, width: float, discs: Array) -> Array:
    """Distance between each link and each disc, negative where they overlap; (2, m)."""
    ends = ends_of_links(q, lengths)
    centres, radii = discs[:, :2], discs[:, 2]
    rows = [
        point_segment_distance(centres, a, b) - radii - width / 2 for a, b in zip(ends, ends[1:])
    ]
    return np.array(rows)


@withheld
def touched_link(q: Array, lengths: Array, width: float, discs: Array) -> int:
    """First link that touches a disc, 1 or 2; 0 where none does."""
    first, second = touches(q, lengths, width, discs)
    return 1 if first else 2 if second else 0


def touches(q: Array, lengths: Array, width: float, discs: Array) -> list[bool]:
    """Whether each link touches a disc."""
    return [bool((row <= 0.0).any()) for row in gaps(q, lengths, width, discs)]


class LinkInContact(ValueExercise):
    """Which link of a two-link arm touches a disc."""

    name = "link_in_contact"
    lesson = "07_collision_detection"
    kinds = ("free", "link_1", "link_2", "both", "end", "touching")
    given = Record(q=POINT, lengths=POINT, width=Number(), discs=DISCS)
    answer = Integer()
    source = staticmethod(touched_link)
    slips = (
        Slip("from_x", lambda q, *others: touched_link(q - (0, q[0]), *others)),
        Slip("degrees", lambda q, *others: touched_link(np.radians(q), *others)),
        Slip("thin", lambda q, links, w, discs: touched_link(q, links, 0.0, discs)),
        Slip("exchanged", lambda *arm: (0, 2, 1)[touched_link(*arm)]),
        Slip("squares", lambda *arm: by_squares(*arm)),
        Slip("whole_width", lambda q, links, w, discs: touched_link(q, links, 2 * w, discs)),
        Slip("centres", lambda q, links, w, discs: touched_link(q, links, w, discs * (1, 1, 0))),
        Slip(
            "endless",
            lambda q, links, w, discs: by_distances(q, links, w, discs, point_line_distance),
        ),
        Slip("square", lambda q, links, w, discs: by_distances(q, links, w, discs, beside)),
        Slip("ends_only", lambda q, links, w, discs: by_distances(q, links, w, discs, nearer_end)),
        Slip("one_disc", lambda q, links, w, discs: touched_link(q, links, w, discs[:1])),
        Slip("one_disc", lambda q, links, w, discs: touched_link(q, links, w, discs[-1:])),
        Slip("nearest", lambda *arm: nearest_centre_only(*arm)),
        Slip("second_first", lambda *arm: second_first(*arm)),
        Slip("disc_first", lambda *arm: disc_first(*arm)),
        Slip("open", lambda q, links, w, discs: touched_link(q, links, w - 1e-9, discs)),
    )
    reference = staticmethod(touched_link)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Arms along the x-axis first, on squared paper; then any arms."""
        for kind, q, *discs in (
            ("free", (0, 0), (1, 2, 0.5)),
            ("link_2", (0, 0), (3, 1, 1)),
            ("link_1", (0, 0), (1, 1, 1)),
            ("both", (0, 0), (2, 0, 1)),
            ("end", (0, 0), (4, 0, 0.875)),
            ("touching", (0, 0), (1, 1, 0.75)),
            ("touching", (0, 0), (3, -1.25, 1)),
            ("touching", (0, 0), (4.25, 0, 1)),
            ("link_2", (0, np.pi / 2), (2, 1, 0.5)),
            ("free", (np.pi / 2, 0), (2, 1, 0.5)),
            ("both", (0, 0), (3, 1, 1), (1, -1, 1)),
            ("link_1", (0, 0), (1, 0.5, 0.125), (0, -3, 2.875)),
            ("link_2", (0, 0), (2.5, 0.5, 0.125), (3, -3, 2.875)),
            ("free", (0.5, 1.0)),
        ):
            lengths = (2.0, 1.0)
            yield case_of(kind, q, lengths, 0.5, discs)
        for x, kind in ((0.0041, "free"), (0.0037, "end"), (0.0025, "link_2")):
            yield case_of(kind, (0, 0), (0.002, 0.001), 0.0005, [(x, 0, 0.0005)])
        for number in range(12):
            for kind in self.kinds:
                yield random_case(rng, kind, 1 + number // 3)

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the discs and the arm with numbered links."""
        ends, value = (
            ends_of_links(case.given["q"], case.given["lengths"]),
            outcome.value if isinstance(outcome, Answer) else None,
        )
        draw_contact(self, case, ends, value, self.truth(case), ax)


def case_of(kind: str, q: ArrayLike, lengths: ArrayLike, width: float, discs: ArrayLike) -> Case:
    """Case of an arm and discs with rows x, y, r."""
    rows = np.array(discs, float).reshape(-1, 3)
    arm = {"q": np.array(q, float), "lengths": np.array(lengths, float), "width": float(width)}
    return Case(kind, {**arm, "discs": rows})


def random_case(rng: np.random.Generator, kind: str, n: int) -> Case:
    """Random case of a kind: an arm among n discs."""
    while True:
        lengths, width = (
            np.round(rng.uniform(0.5, 3.0, 2), 2),
            float(np.round(rng.uniform(0.1, 0.6), 2)),
        )
        q = np.round(rng.uniform(-2.0 * np.pi, 2.0 * np.pi, 2), 3)
        if kind == "touching":
            return touching_case(rng, n)
        ends, reach = ends_of_links(q, lengths), float(lengths.sum())
        discs = np.column_stack(
            [rng.uniform(-reach, reach, (n, 2)), rng.uniform(0.05, 0.3 if n > 1 else 0.8, n)]
        )
        if n > 1 and rng.random() < 0.5:  # a large disc, whose centre may be farther than others
            discs[0] = *rng.uniform(-1.5 * reach, 1.5 * reach, 2), rng.uniform(0.3, 0.9) * reach
        if kind == "end":  # just beyond the tip, at the rounded end
            out = (ends[2] - ends[1]) / lengths[1]
            discs[-1, :2] = ends[2] + out * (discs[-1, 2] + width * rng.uniform(0.3, 0.45))
        discs = np.round(discs, 3)
        case = case_of(kind, q, lengths, width, discs)
        if kind_of(*case.given.values()) == kind:
            return case


def touching_case(rng: np.random.Generator, n: int) -> Case:
    """Case of an arm along the x-axis that exactly touches the last of n discs.

    All numbers are multiples of an eighth, which floats represent exactly.
    """
    lengths, half = rng.integers(4, 17, 2) / 4.0, int(rng.integers(1, 5)) / 8.0
    radius, along = int(rng.integers(2, 9)) / 8.0, int(rng.integers(1, 8 * lengths[0])) / 8.0
    x = along if rng.random() < 0.5 else lengths[0] + lengths[1] / 2
    y = float(rng.choice([-1.0, 1.0])) * (radius + half)
    far = [(-9.0 - i, 9.0, 0.5) for i in range(n - 1)]
    return case_of("touching", (0, 0), lengths, 2 * half, [*far, (x, y, radius)])


@withheld
def kind_of(q: Array, lengths: Array, width: float, discs: Array) -> str:
    """Kind of a case; "" where a link nearly touches a disc."""
    if abs(gaps(q, lengths, width, discs)).min() <= CLEAR:
        return ""
    first, second = touches(q, lengths, width, discs)
    if first:
        return "both" if second else "link_1"
    if not second:
        return "free"
    return "end" if by_distances(q, lengths, width, discs, beside) == 0 else "link_2"


def by_distances(q: Array, lengths: Array, width: float, discs: Array, distance: Any) -> int:
    """The answer with another distance from a point to a segment."""
    ends = ends_of_links(q, lengths)
    for link, (a, b) in enumerate(zip(ends, ends[1:]), 1):
        if any(distance(disc[:2], a, b) <= width / 2 + disc[2] for disc in discs):
            return link
    return 0


def by_squares(q: Array, lengths: Array, width: float, discs: Array) -> int:
    """The answer of a program that compares squares, with a wrong sum of two of them."""
    radii = np.sqrt(discs[:, 2:] ** 2 + (width / 2) ** 2)
    return touched_link(q, lengths, 0.0, np.column_stack([discs[:, :2], radii]))


def beside(p: Array, a: Array, b: Array) -> float:
    """Distance from a point to a segment, infinite beyond its ends."""
    share = np.dot(p - a, b - a) / np.dot(b - a, b - a)
    return point_line_distance(p, a, b) if 0.0 <= share <= 1.0 else np.inf


def nearer_end(p: Array, a: Array, b: Array) -> float:
    """Distance from a point to the nearer end of a segment."""
    return float(min(np.linalg.norm(p - a), np.linalg.norm(p - b)))


def nearest_centre_only(q: Array, lengths: Array, width: float, discs: Array) -> int:
    """The answer of a program that tests each link with the disc whose centre is nearest."""
    for link, row in enumerate(gaps(q, lengths, width, discs), 1):
        if len(discs) and row[np.argmin(row + discs[:, 2])] <= 0.0:
            return link
    return 0


def second_first(q: Array, lengths: Array, width: float, discs: Array) -> int:
    """The last link that touches a disc."""
    first, second = touches(q, lengths, width, discs)
    return 2 if second else 1 if first else 0


def disc_first(q: Array, lengths: Array, width: float, discs: Array) -> int:
    """The link that touches the first touched disc."""
    answers = [touched_link(q, lengths, width, disc[None]) for disc in discs]
    return next((link for link in answers if link), 0)

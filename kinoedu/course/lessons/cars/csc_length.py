"""The exercise on Dubins curves of an arc, a straight line and an arc. LaValle, section 15.3.1."""

import math
from collections.abc import Iterator
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ....curves.dubins import all_dubins_curves, shortest_forward
from ....geometry.checks import Array
from ...exercise import Axes, Case, Given, Restated, Slip, ValueExercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Number, Record, Value
from ...withheld import withheld
from ..shared.car_pictures import draw_tangents
from ..shared.driving import POSE, a_pose

FULL = 2.0 * math.pi
CLEAR = 1e-3  # all turns are this far from 0 and from 2 pi, except in the straight cases
NEARLY = 2e-3  # a length that is relatively so near has probably been rounded
WORDS = {"LSL": (1, 1), "RSR": (-1, -1), "LSR": (1, -1), "RSL": (-1, 1)}


def words_to(
    a: Array,
    b: Array,
    r: float,
    turn: Value = lambda angle: angle % FULL,
    *,
    crossing: bool = False,
    lean: float = 1.0,
) -> Given:
    """First turn, straight length and last turn of each word, computed from its circles.

    Parameters
    ----------
    turn : how the angle of an arc is measured.
    crossing : include words whose circles cross, with a tangent of length 0.
    lean : factor of the angle between an inner tangent and the line of the centres.
    """
    found = {}
    for word, (first, last) in WORDS.items():
        (x0, y0), (x1, y1) = (
            p[:2] + side * r * np.array([-math.sin(p[2]), math.cos(p[2])])
            for p, side in ((a, first), (b, last))
        )
        apart, heading = math.hypot(x1 - x0, y1 - y0), math.atan2(y1 - y0, x1 - x0)
        straight = apart if first == last else math.sqrt(max(apart * apart - 4.0 * r * r, 0.0))
        if first != last and apart < 2.0 * r and not crossing:
            continue
        heading += 0.0 if first == last else lean * first * math.atan2(2.0 * r, straight)
        found[word] = turn(first * (heading - a[2])), straight, turn(last * (b[2] - heading))
    return found


def shortest_of(words: dict[str, Any], r: float, names: tuple[str, ...] = tuple(WORDS)) -> float:
    """Length of the shortest of some words; infinity where there is none."""
    return min(
        (r * (t + v) + u for word, (t, u, v) in words.items() if word in names), default=math.inf
    )


def shortest_without(word: str, a: Array, b: Array, r: float) -> float:
    """Length of the shortest of the other three words."""
    return shortest_of(words_to(a, b, r), r, tuple(other for other in WORDS if other != word))


@withheld
def csc(a: Array, b: Array, r: float) -> float:
    """Length of the shortest of LSL, RSR, LSR and RSL."""
    return min(curve.length for curve in all_dubins_curves(a, b, r) if curve.word[1] == "S")


class CscLength(ValueExercise):
    """The length of the shortest curve of an arc, a straight line and an arc, driven forward."""

    name = "csc_length"
    lesson = "12_the_car"
    kinds = ("straight", "outer", "inner", "crossing")
    given = Record(a=POSE, b=POSE, r=Number())
    answer = Number()
    source = staticmethod(csc)
    shown = staticmethod(shortest_forward)
    slips = (
        Slip("lsl_only", lambda a, b, r: shortest_of(words_to(a, b, r), r, ("LSL",))),
        Slip("outer_only", lambda a, b, r: shortest_of(words_to(a, b, r), r, ("LSL", "RSR"))),
        Slip("inner_only", lambda a, b, r: shortest_of(words_to(a, b, r), r, ("LSR", "RSL"))),
        Slip("rsr_only", lambda a, b, r: shortest_of(words_to(a, b, r), r, ("RSR",))),
        *(Slip("three_words", partial(shortest_without, word)) for word in WORDS),
        Slip("sign", lambda a, b, r: shortest_of(words_to(a, b, r, abs), r)),
        Slip(
            "half_turns", lambda a, b, r: shortest_of(words_to(a, b, r, lambda t: t % math.pi), r)
        ),
        Slip("right_as_left", lambda a, b, r: shortest_of(as_left_turns(a, b, r), r)),
        Slip(
            "short_way",
            lambda a, b, r: shortest_of(
                words_to(a, b, r, lambda t: abs((t + math.pi) % FULL - math.pi)), r
            ),
        ),
        Slip(
            "radians",
            lambda a, b, r: shortest_of(
                {w: (t / r, u, v / r) for w, (t, u, v) in words_to(a, b, r).items()}, r
            ),
        ),
        Slip("leans_wrong", lambda a, b, r: shortest_of(words_to(a, b, r, lean=-1.0), r)),
        Slip("no_lean", lambda a, b, r: shortest_of(words_to(a, b, r, lean=0.0), r)),
        Slip("no_root", lambda a, b, r: shortest_of(without_root(a, b, r), r)),
        Slip("crossing", lambda a, b, r: shortest_of(words_to(a, b, r, crossing=True), r)),
        Slip("three_arcs", lambda a, b, r: min(c.length for c in all_dubins_curves(a, b, r))),
        Slip("finite", lambda a, b, r: min(csc(a, b, r), 1000.0)),
        Slip("finite", lambda a, b, r: min(csc(a, b, r), 100.0)),
        Slip("beeline", lambda a, b, r: math.dist(a[:2], b[:2])),
        Slip(
            "longest",
            lambda a, b, r: max(r * (t + v) + u for t, u, v in words_to(a, b, r).values()),
        ),
    )
    reference = staticmethod(csc)

    changes = (
        Restated("backward", given=lambda a, b, r: (b, a, r)),
        Restated(
            "in_radii",
            answer=lambda length, a, b, r: length / r,
            usual_answer=lambda length, a, b, r: length * r,
        ),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Straight lines and half circles first, then far poses, and random ones of each kind."""
        half = math.pi
        yield pair_case("straight", (0, 0, 0), (10, 0, 0), 2)
        yield pair_case("outer", (0, 0, 0), (1, 8, half), 2)
        yield pair_case("outer", (0, 0, 0), (1, -8, -half), 2)
        yield pair_case("inner", (0, 0, 0), (10, 4, 0.1), 1)
        yield pair_case("inner", (0, 0, 0), (10, -4, -0.1), 1)
        yield pair_case("inner", (0, 0, 0), (20, 6, 0), 2)  # same heading, but not straight ahead
        yield pair_case("straight", (-900, 100, 0), (900, 100, 0), 300)  # four far pairs
        yield pair_case("outer", (-700, -500, 3), (1000, 1000, -3), 700)
        yield pair_case("inner", (700, 400, 0), (-300, -800, 0), 500)
        yield pair_case("crossing", (-800, -800, 0), (300, -500, -3), 700)
        wanted = dict.fromkeys(("outer", "inner", "crossing"), 12)
        while any(wanted.values()):
            a, r = a_pose(rng), np.round(rng.uniform(0.5, 10), 1)
            place = a[:2] + rng.uniform(0.5, 9) * r * random_direction(rng)
            b = np.round([*place, rng.uniform(-3.1, 3.1)], 2)
            kind = kind_of(a, b, r)
            if kind and wanted[kind]:
                wanted[kind] -= 1
                yield pair_case(kind, a, b, r)
        for _ in range(10):
            x, y, far = (int(number) for number in rng.integers(1, 40, 3))
            yield pair_case("straight", (x, -y, 0), (x + far, -y, 0), int(rng.integers(1, 9)))

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Compare the lengths; one that is nearly right breaks a rule of its own."""
        verdict, truth = super().value_verdict(case, value), self.truth(case)
        is_nearly_right = not verdict.is_right and abs(value - truth) <= NEARLY * truth
        return verdict._replace(rule="digits") if is_nearly_right else verdict

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the shortest curve with its circles, and both lengths."""
        draw_tangents(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def as_left_turns(a: Array, b: Array, r: float) -> Given:
    """Right turns measured as left turns: the remainder of a whole turn."""
    right = {word: (first < 0, last < 0) for word, (first, last) in WORDS.items()}
    words = words_to(a, b, r).items()
    return {
        w: ((-t if right[w][0] else t) % FULL, u, (-v if right[w][1] else v) % FULL)
        for w, (t, u, v) in words
    }


def without_root(a: Array, b: Array, r: float) -> Given:
    """Words with the inner tangent taken to be as long as the distance of the centres."""
    words = words_to(a, b, r)
    inner = {
        word: (t, math.sqrt(u * u + 4.0 * r * r), v)
        for word, (t, u, v) in words.items()
        if word in ("LSR", "RSL")
    }
    return {**words, **inner}


@withheld
def kind_of(a: Array, b: Array, r: float) -> str:
    """Kind of a pair of poses; "" near a degenerate case.

    A case is degenerate where a turn is nearly zero or whole, or circles nearly touch.
    """
    words = words_to(a, b, r)
    turns = np.array([turn for first, _, last in words.values() for turn in (first, last)])
    near = words_to(a, b, r * (1.0 - CLEAR)).keys() ^ words_to(a, b, r * (1.0 + CLEAR)).keys()
    if near or (turns < CLEAR).any() or (turns > FULL - CLEAR).any():
        return ""
    lengths = {word: r * (t + v) + u for word, (t, u, v) in words.items()}
    if len(words) < len(WORDS):
        return "crossing"
    return "outer" if min(lengths, key=lengths.__getitem__) in ("LSL", "RSR") else "inner"


def random_direction(rng: np.random.Generator) -> Array:
    """Random direction in the plane."""
    angle = rng.uniform(-math.pi, math.pi)
    return np.array([math.cos(angle), math.sin(angle)])


def pair_case(kind: str, a: ArrayLike, b: ArrayLike, r: float) -> Case:
    """Case of two poses."""
    return Case(kind, {"a": np.array(a, float), "b": np.array(b, float), "r": float(r)})

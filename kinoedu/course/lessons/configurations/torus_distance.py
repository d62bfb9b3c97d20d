"""The exercise `torus_distance`. Bullo & Smith, chapter 3."""

from collections.abc import Callable, Iterator
from math import pi

import numpy as np
from numpy.typing import ArrayLike

from ....geometry.checks import Array
from ....spaces import circle_distance, torus_distance
from ...exercise import Case, Change, Slip
from ...shapes import Number, Numbers, Record
from .angles import TURN, BetweenAngles


class TorusDistance(BetweenAngles):
    """The distance on the flat torus of any number of angles."""

    name = "torus_distance"
    kinds = ("near", "across_one", "across_all", "turns", "joints")
    given = Record(a=Numbers(("d",)), b=Numbers(("d",)))
    answer = Number()
    source = staticmethod(torus_distance)
    slips = (
        Slip("no_wrap", lambda a, b: np.linalg.norm(a - b)),
        Slip("sum", lambda a, b: np.sum(circle_distance(a, b))),
        Slip("largest", lambda a, b: np.max(circle_distance(a, b))),
        Slip("square", lambda a, b: torus_distance(a, b) ** 2),
        Slip("two", lambda a, b: torus_distance(a[:2], b[:2])),
        Slip(
            "first", lambda a, b: np.hypot(circle_distance(a[0], b[0]), np.linalg.norm((a - b)[1:]))
        ),
        Slip("whole", lambda a, b: min(np.linalg.norm(a - b), TURN - np.linalg.norm(a - b))),
        Slip("whole", lambda a, b: circle_distance(np.linalg.norm(a - b), 0.0)),
        Slip("once", lambda a, b: np.linalg.norm(np.minimum(abs(a - b), TURN - abs(a - b)))),
        Slip("long", lambda a, b: np.linalg.norm((b - a) % TURN)),
    )
    reference = staticmethod(torus_distance)
    changes = (
        Change("sum", lambda distance, a, b: sum(measure_each(distance, a, b))),
        Change("largest", lambda distance, a, b: max(measure_each(distance, a, b))),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Two angles first, with small numbers; then any number of angles."""
        for kind, a, b in (
            ("near", (0, 0), (0.3, 0.4)),
            ("near", (1, -1), (1, 2)),
            ("across_one", (3, 0), (-3, 0)),
            ("across_one", (0, -3), (1, 3)),
            ("across_all", (3, 3), (-3, -3)),
            ("turns", (0, 0), (7, 0)),
            ("turns", (0, 0), (TURN, 2 * TURN)),
            ("joints", (3,), (-3,)),
            ("joints", (3, 0, 0), (-3, 0, 1)),
            ("joints", (0, 0, 1, 2), (0, 0, -1, 2)),
        ):
            yield case_of(kind, a, b)
        for _ in range(20):
            p = np.round(rng.uniform(-1.5, 1.5, 2), 2)
            yield case_of("near", p, np.round(p + rng.uniform(-1.6, 1.6, 2), 2))
            high, low = (
                np.round(rng.uniform(1.6, 3.14, 2), 2),
                np.round(rng.uniform(-3.14, -1.6, 2), 2),
            )
            yield case_of("across_all", high, low)
            mixed = rng.permutation([0, 1])
            yield case_of(
                "across_one", np.array([high[0], p[0]])[mixed], np.array([low[0], p[1]])[mixed]
            )
            yield case_of(
                "turns",
                p,
                np.round(p + rng.uniform(-1.5, 1.5, 2) + TURN * rng.integers(1, 9, 2), 2),
            )
            d = int(rng.choice([1, 3, 4, 5]))
            yield case_of(
                "joints", np.round(rng.uniform(-pi, pi, d), 2), np.round(rng.uniform(-pi, pi, d), 2)
            )


def measure_each(distance: Callable[..., float], a: Array, b: Array) -> list[float]:
    """The distance for each angle alone."""
    return [distance(a[i : i + 1], b[i : i + 1]) for i in range(len(a))]


def case_of(kind: str, a: ArrayLike, b: ArrayLike) -> Case:
    """Case of two rows of angles."""
    return Case(kind, {"a": np.array(a, float), "b": np.array(b, float)})

"""Inputs of a plain function, drawn by kind: the cases and pictures of exercises made from one.

Each kind of input draws small values (few whole numbers, for work by hand), large ones, and special
ones: zero, whole turns, a point on a vertex of another input.
"""

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from ....figures.palette import GOAL, OBSTACLE, START
from ....geometry.checks import Array
from ....messages import get_message
from ...exercise import Axes, Case, Given, format_value
from ...outcomes import Answer, Outcome
from ...shapes import Number, Numbers, Shape, Value
from ...whole_shapes import Integer
from .random_shapes import points, sizes, star_polygon

KINDS = ("small", "large", "special")


class Input(NamedTuple):
    """A kind of input.

    Attributes
    ----------
    shape : of its values.
    draw : from rng and a size, a value; coordinates and lengths are at most the size.
    special : from rng and the other inputs drawn so far, a value at which something changes.
    """

    shape: Shape
    draw: Callable[[np.random.Generator, float], Value]
    special: Callable[[np.random.Generator, Given], Value]


def draw_polygon(rng: np.random.Generator, size: float) -> Array:
    """A simple polygon of four to nine vertices, counter-clockwise, rarely convex."""
    return star_polygon(rng, int(rng.integers(4, 10)), size)


def draw_touching_point(rng: np.random.Generator, others: Given) -> Array:
    """A vertex of another input, or half-way between two; the origin where there is none."""
    arrays = [value for value in others.values() if np.ndim(value) > 0]
    if not arrays:
        return np.zeros(2)
    corners = np.atleast_2d(arrays[rng.integers(len(arrays))])
    i = int(rng.integers(len(corners)))
    return np.asarray((corners[i] + corners[i - int(rng.integers(2))]) / 2.0)


POINT = Input(Numbers((2,)), lambda rng, size: points(rng, 1, size)[0], draw_touching_point)
POINTS = Input(
    Numbers(("n", 2)),
    lambda rng, size: points(rng, int(rng.integers(4, 10)), size),
    lambda rng, others: np.arange(4.0)[:, None] * rng.integers(1, 5, 2),  # on one line
)
POLYGON = Input(
    Numbers(("n", 2)),
    draw_polygon,
    lambda rng, others: (
        np.array([(0, 0), (6, 0), (6, 4), (4, 4), (4, 2), (2, 2), (2, 5), (0, 5)])
        * float(rng.integers(1, 4))
    ),  # with a bay
)
NUMBER = Input(
    Number(),
    lambda rng, size: float(np.round(rng.uniform(-size, size), 2)),
    lambda rng, others: 0.0,
)
LENGTH = Input(
    Number(),
    lambda rng, size: float(np.round(rng.uniform(0.1, size), 2)),
    lambda rng, others: float(rng.integers(1, 5)),
)
ANGLE = Input(
    Number(),
    lambda rng, size: float(np.round(rng.uniform(-np.pi, np.pi), 2)),
    lambda rng, others: float(rng.choice([0.0, np.pi / 2, -np.pi / 2, np.pi, 2 * np.pi])),
)
COUNT = Input(
    Integer(),
    lambda rng, size: int(rng.integers(1, int(min(size, 30.0)) + 2)),
    lambda rng, others: int(rng.integers(0, 2)),
)
INPUTS = {
    "point": POINT,
    "points": POINTS,
    "polygon": POLYGON,
    "number": NUMBER,
    "length": LENGTH,
    "angle": ANGLE,
    "count": COUNT,
}


def draw_cases(inputs: dict[str, Input], rng: np.random.Generator) -> Iterator[Case]:
    """Cases of each kind, from small to large."""
    for size in sizes(4):
        kind = "small" if size < 10.0 else "large"
        yield Case(kind, {name: one.draw(rng, size) for name, one in inputs.items()})
        if size <= 10.0:
            yield Case("small", {name: one.draw(rng, 4.0) for name, one in inputs.items()})
        yield draw_special_case(inputs, rng, min(size, 10.0))


def draw_special_case(inputs: dict[str, Input], rng: np.random.Generator, size: float) -> Case:
    """A case in which at least one input is special; points are drawn last, to lie on others."""
    given: Given = {}
    order = sorted(inputs, key=lambda name: inputs[name] is POINT)
    chosen = order[-1 - int(rng.integers(len(order)))]
    for name in order:
        one = inputs[name]
        given[name] = one.special(rng, given) if name == chosen else one.draw(rng, size)
    return Case("special", {name: given[name] for name in inputs})


def draw_plain_case(case: Case, outcome: Outcome, truth: Value, title: str, ax: Axes) -> None:
    """Draw the inputs, the true answer as a square and the student's as a cross."""
    from ....figures import palette, plane

    value: Value = outcome.value if isinstance(outcome, Answer) else None
    places = [np.atleast_2d(one) for one in case.given.values() if np.ndim(one) > 0]
    places += [as_places(one) for one in (truth, value)]
    plane.frame(np.vstack([*places, np.zeros((1, 2))]), ax, margin=0.3)
    for name, one in case.given.items():
        if np.ndim(one) == 2:
            ax.fill(*np.asarray(one).T, facecolor=palette.SHAPE, edgecolor=OBSTACLE, linewidth=1.5)
        elif np.ndim(one) == 1:
            plane.dot(one, name, ax)
    draw_answer(truth, get_message("picture.true"), "s", START, ax)
    draw_answer(value, get_message("picture.yours_short"), "X", GOAL, ax)
    ax.legend(fontsize=palette.TEXT_SIZE, loc="best")
    plane.title(title, ax)


def draw_answer(value: Value, label: str, mark: str, colour: str, ax: Axes) -> None:
    """Draw an answer where it is a place, or several; else say it in the legend."""
    places = as_places(value)
    label = label if len(places) else f"{label}: {describe(value)}"
    size = 13 if mark == "s" else 9
    ax.plot(*places.T, mark, label=label, color=colour, markersize=size, zorder=5)


def as_places(value: Value) -> Array:
    """The places in an answer, (n, 2); none where it is a number or not finite."""
    is_place = np.ndim(value) > 0 and np.shape(value)[-1] == 2 and np.isfinite(value).all()
    return np.atleast_2d(np.asarray(value, float)) if is_place else np.zeros((0, 2))


def describe(value: Value) -> str:
    """An answer in words."""
    if value is None or isinstance(value, ValueError):
        return get_message("picture.no_answer")
    return format_value(value)

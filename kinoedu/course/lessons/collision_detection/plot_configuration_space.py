"""The exercise on drawing samples of an arm's configuration space. Bullo & Smith, chapter 4."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from ....geometry.checks import Array
from ....messages import get_message
from ....sampling import halton, sukharev_grid, uniform_random
from ...exercise import RIGHT, Axes, Case, Given, Slip, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Number, Numbers, Record, Value
from ...withheld import withheld
from ..geometry.lines import POINT
from .arm_pictures import draw_samples
from .drawn_exercise import FULL, DrawnExercise, same_dots
from .link_in_contact import DISCS, gaps, random_case, touched_link

OTHER = 9  # a colour that is none of the three


@withheld
def right_dots(samples: Array, *arm: Value) -> Array:
    """The right dots for samples of the unit square: rows of both angles and the link."""
    return colour_dots(FULL * samples, FULL * samples, *arm)


class PlotConfigurationSpace(DrawnExercise):
    """Samples of the configuration space as dots: black and red for contacts, blue for free.

    Black is contact of link 1, red is contact of link 2.
    """

    name = "plot_configuration_space"
    lesson = "07_collision_detection"
    kinds = ("grid", "random", "halton")
    given = Record(samples=Numbers(("n", 2)), lengths=POINT, width=Number(), discs=DISCS)
    slips = (
        Slip("unscaled", lambda samples, *arm: colour_dots(samples, samples, *arm)),
        Slip("unscaled_dots", lambda samples, *arm: colour_dots(samples, FULL * samples, *arm)),
        Slip("unscaled_links", lambda samples, *arm: colour_dots(FULL * samples, samples, *arm)),
        Slip("root", lambda samples, *arm: right_dots(samples[: int(np.sqrt(len(samples)))], *arm)),
        Slip("degrees", lambda samples, *arm: colour_dots(360 * samples, FULL * samples, *arm)),
        Slip(
            "transposed",
            lambda samples, *arm: colour_dots(FULL * samples[:, ::-1], FULL * samples, *arm),
        ),
        Slip(
            "only_free",
            lambda *given: np.array([dot for dot in right_dots(*given) if dot[2] == 0]),
        ),
        Slip("one_red", lambda *given: replace_colours(right_dots(*given), (0, 2, 2))),
        Slip("permuted", lambda *given: replace_colours(right_dots(*given), (1, 0, 2))),
        Slip("permuted", lambda *given: replace_colours(right_dots(*given), (2, 1, 0))),
        Slip("permuted", lambda *given: replace_colours(right_dots(*given), (1, 2, 0))),
        Slip("permuted", lambda *given: replace_colours(right_dots(*given), (2, 0, 1))),
        Slip("swapped", lambda *given: replace_colours(right_dots(*given), (0, 2, 1))),
    )

    reference = staticmethod(right_dots)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Few samples first, with each sampler; every sample is clearly in contact or free."""
        for number in range(10):
            for kind in self.kinds:
                yield Case(kind, sampled_arm(rng, kind, 2 + number))

    def same(self, value: object, truth: object) -> bool:
        """Compare dots with their colours, up to order and whole turns."""
        return same_dots(dots_of(value), truth, modulo=True)

    def value_verdict(self, case: Case, value: object) -> Verdict:
        """Check the number of dots, their places, that colours are known, then the colours.

        No line may join right dots.
        """
        truth, found = self.truth(case), dots_of(value)
        if same_dots(found, truth, modulo=True):
            joined = are_joined(value)
            return Verdict(0.0, "joined", self.describe_expected(case)) if joined else RIGHT
        if len(found) != len(truth):
            return Verdict(0.0, "count", self.describe_expected(case))
        in_place = same_dots(found[:, :2], truth[:, :2], modulo=True)
        if not in_place:
            return Verdict(0.0, "places", self.describe_expected(case))
        return Verdict(
            0.0,
            "shades" if (found[:, 2] == OTHER).any() else "colours",
            self.describe_expected(case),
        )

    def describe_answer(self, case: Case, value: object) -> str:
        """Number of dots of each colour."""
        return describe_counts(dots_of(value))

    def describe_expected(self, case: Case) -> str:
        """Number of dots of each colour."""
        return describe_counts(self.truth(case))

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the right dots as rings, and the student's dots inside them."""
        dots = dots_of(outcome.value) if isinstance(outcome, Answer) else None
        draw_samples(self, case, self.truth(case), dots, ax)


def dots_of(plot: Any) -> Array:
    """Dots of a plot as rows of both angles and the link of their colour, or OTHER."""
    rows = [(*point, shade(one["colour"])) for one in plot["dots"] for point in one["points"]]
    return np.array(rows, float).reshape(-1, 3)


def are_joined(plot: Any) -> bool:
    """Whether a line leads from dot to dot, as `ax.plot` draws it with a marker alone."""
    dots = [one["points"] for one in plot["dots"]]
    return any(
        len(one["points"]) > 1 and any(np.array_equal(one["points"], points) for points in dots)
        for one in plot["lines"]
    )


def shade(colour: str) -> int:
    """0 for any blue, 1 for any black, 2 for any red, OTHER for other colours."""
    if colour == "none":
        return OTHER
    red, green, blue = (int(colour[i : i + 2], 16) for i in (1, 3, 5))
    if max(red, green, blue) < 70:
        return 1
    if red > 100 and red > 1.5 * max(green, blue):
        return 2
    return 0 if blue > 100 and blue > 1.2 * max(red, green) else OTHER


def replace_colours(dots: Array, links: tuple[int, int, int]) -> Array:
    """Dots with the colours of other links."""
    return np.column_stack([dots[:, :2], np.array(links)[dots[:, 2].astype(int)]])


def colour_dots(places: Array, samples: Array, lengths: Array, width: float, discs: Array) -> Array:
    """Dots at given places, with the colours of other samples.

    Samples are rows of two angles and a link.
    """
    return np.column_stack([places, [touched_link(q, lengths, width, discs) for q in samples]])


def describe_counts(dots: Array) -> str:
    """Number of dots of each colour."""
    blue, black, red = (int((dots[:, 2] == link).sum()) for link in range(3))
    counts = {"all": len(dots), "blue": blue, "black": black, "red": red}
    others = len(dots) - blue - black - red
    if others:
        return get_message("plot_configuration_space.counted_others", **counts, others=others)
    return get_message("plot_configuration_space.counted", **counts)


def sampled_arm(rng: np.random.Generator, kind: str, k: int) -> Given:
    """Random arm and discs with k * k samples; where there are many, of all three colours."""
    while True:
        arm = random_case(rng, "both", 1 + k // 5).given
        given = {
            "samples": unit_samples(rng, kind, k),
            **{name: arm[name] for name in ("lengths", "width", "discs")},
        }
        if not is_clear(*given.values()):
            continue
        colours = np.unique(right_dots(*given.values())[:, 2])
        if len(colours) >= (3 if k > 4 else 2):
            return given


@withheld
def is_clear(samples: Array, *arm: Value) -> bool:
    """Whether every sample is clearly in contact or clearly free."""
    return bool(min(np.abs(gaps(FULL * q, *arm)).min() for q in samples) > 1e-6)


def unit_samples(rng: np.random.Generator, kind: str, k: int) -> Array:
    """k * k samples of the unit square: cell centres, random, or Halton's from a random start."""
    if kind == "grid":
        return sukharev_grid(k * k)
    return (
        uniform_random(k * k, rng=rng)
        if kind == "random"
        else halton(k * k, start=int(rng.integers(1, 50)))
    )

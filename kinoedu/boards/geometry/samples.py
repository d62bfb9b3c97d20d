"""The samples' board: points of the unit square by a sampler and a number, and a place to drag into
the largest hole.
"""

import math
from collections.abc import Callable
from typing import Any

import ipywidgets as widgets
import numpy as np

from ...geometry.checks import Array, whole
from ...planners.tuning import one_of
from ...sampling import corner_grid, halton, largest_empty_ball, sukharev_grid, uniform_random
from ...words import say
from ..core.canvas import Canvas, with_picture
from ..core.controls import look
from ..core.drawing import Drawing, dots, edges
from ..core.scene import Scene, handle, make_scene, place_of

MOST = 400
SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
AROUND = 96  # corners of a circle as it is drawn
SAMPLERS: dict[str, Callable[[int], Array]] = {
    "corner": lambda n: corner_grid(math.isqrt(n) ** 2),
    "sukharev": lambda n: sukharev_grid(math.isqrt(n) ** 2),
    "random": lambda n: uniform_random(n, rng=0),
    "halton": halton,
}


def samples_board(sampler: str = "random", n: int = 100) -> "SamplesBoard":
    """Choose a sampler and how many points; drag q into the largest hole: the nearest point, and
    the largest empty ball beside it.

    Parameters
    ----------
    sampler : "corner", "sukharev", "random" or "halton". n : 1 to 400; of a grid, the points of the
    largest one with no more.

    Raises InvalidParameter.

    >>> samples_board("sukharev", 16)
    SamplesBoard(points 16; largest hole 0.1768; q is 0.1768 from the nearest point)
    """
    return SamplesBoard(sampler, n)


class SamplesBoard(widgets.VBox):
    """What `samples_board` makes: the choice of the sampler, the number, and the square in
    `canvas`.
    """

    def __init__(self, sampler: str, n: int) -> None:
        names = (
            say("samples_board.corner"),
            say("samples_board.sukharev"),
            say("samples_board.random"),
            say("samples_board.halton"),
        )
        self.sampler = widgets.Dropdown(
            options=list(zip(names, SAMPLERS, strict=True)),
            value=one_of(sampler, "sampler", tuple(SAMPLERS)),
            **{**look("planner"), "description": say("samples_board.sampler")},
        )
        self.n = widgets.IntSlider(
            min(whole(n, "n", least=1), MOST), 1, MOST, **{**look("samples"), "description": "n"}
        )
        scene = make_scene(
            (-0.04, -0.04),
            (1.04, 1.04),
            handles=[handle(say("samples_board.q"), (0.5, 0.5), colour="start")],
        )
        self.canvas = Canvas(scene, self.answer)
        super().__init__([self.sampler, self.n, self.canvas])
        for control in (self.sampler, self.n):
            control.observe(lambda _: self.canvas.refresh(), "value")

    def answer(self, scene: Scene) -> Drawing:
        """The points, the largest hole, and how far q is from the nearest point."""
        points = SAMPLERS[self.sampler.value](self.n.value)
        q = np.clip(place_of(scene, say("samples_board.q")), 0.0, 1.0)
        ball = largest_empty_ball(points)
        away = np.sqrt(((points - q) ** 2).sum(axis=1))
        layers = [
            edges([[SQUARE[i - 1], SQUARE[i]] for i in range(4)], "ink", width=1.6),
            edges(circle_in_square(ball.centre, ball.radius), "path", width=3.0),
            edges(circle_in_square(q, away.min()), "start", width=2.0, dash=(6, 4)),
            edges([[q, points[away.argmin()]]], "start", width=2.0),
            dots(points, "tree", radius=4.5 if len(points) <= 150 else 3.0),
        ]
        said = say(
            "samples_board.told", n=len(points), hole=f"{ball.radius:.4f}", away=f"{away.min():.4f}"
        )
        return Drawing(layers, text=said)

    def picture(self) -> bytes:
        """The board as it is now, as a PNG."""
        return self.canvas.picture()

    def __repr__(self) -> str:
        return f"SamplesBoard({self.canvas.drawing.says})"

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        return with_picture(super()._repr_mimebundle_(**kwargs), self, self)


def circle_in_square(centre: Array, radius: float) -> Array:
    """The part of a circle that lies in the unit square, as short segments (m, 2, 2)."""
    angles = np.linspace(0.0, 2.0 * np.pi, AROUND + 1)
    rim = centre + radius * np.column_stack([np.cos(angles), np.sin(angles)])
    inside = np.abs(rim - 0.5).max(axis=1) <= 0.5
    return np.stack([rim[:-1], rim[1:]], axis=1)[inside[:-1] & inside[1:]]

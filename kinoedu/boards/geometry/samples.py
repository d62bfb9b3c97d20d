"""The samples' board: points of the unit square, and a point to drag into the largest hole."""

from __future__ import annotations

import math
from collections.abc import Callable

import ipywidgets as widgets
import numpy as np

from ...geometry.checks import Array, integer
from ...messages import get_message
from ...planners.tuning import one_of
from ...sampling import corner_grid, halton, largest_empty_ball, sukharev_grid, uniform_random
from ..core.canvas import Canvas
from ..core.drawing import Drawing, dots, edges, segments_along
from ..core.framed import Framed, control_style, make_menu
from ..core.scene import Scene, handle, make_scene, place_of

MOST = 400
SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
AROUND = 96  # corners of the polygon that draws a circle
SAMPLERS: dict[str, Callable[[int], Array]] = {
    "corner": lambda n: corner_grid(math.isqrt(n) ** 2),
    "sukharev": lambda n: sukharev_grid(math.isqrt(n) ** 2),
    "random": lambda n: uniform_random(n, rng=0),
    "halton": halton,
}


def samples_board(sampler: str = "random", n: int = 100) -> SamplesBoard:
    """Choose a sampler and a number of points; drag q into the largest hole.

    The nearest point to q and the largest empty ball are drawn.

    Parameters
    ----------
    sampler : "corner", "sukharev", "random" or "halton".
    n : 1 to 400; for a grid, the points of the largest grid with at most n.

    Raises
    ------
    InvalidParameter

    Examples
    --------
    >>> samples_board("sukharev", 16)
    SamplesBoard(points 16; largest hole 0.1768; q is 0.1768 from the nearest point)
    """
    return SamplesBoard(sampler, n)


class SamplesBoard(Framed):
    """The widget that `samples_board` returns: sampler, number, and the square in `canvas`."""

    def __init__(self, sampler: str, n: int) -> None:
        options = [(get_message(f"samples_board.{name}"), name) for name in SAMPLERS]
        chosen = one_of(sampler, "sampler", tuple(SAMPLERS))
        self.sampler = make_menu("samples_board.sampler", options, chosen)
        style = {**control_style("board.samples"), "description": "n"}
        self.n = widgets.IntSlider(integer(n, "n", least=1, most=MOST), 1, MOST, **style)
        q = handle(get_message("samples_board.q"), (0.5, 0.5), colour="start")
        scene = make_scene((-0.04, -0.04), (1.04, 1.04), handles=[q])
        super().__init__([self.sampler, self.n], [Canvas(scene, self.answer)])

    def answer(self, scene: Scene) -> Drawing:
        """Draw the points, the largest hole, and the distance from q to the nearest point."""
        points = SAMPLERS[self.sampler.value](self.n.value)
        q = np.clip(place_of(scene, get_message("samples_board.q")), 0.0, 1.0)
        ball = largest_empty_ball(points)
        away = np.sqrt(((points - q) ** 2).sum(axis=1))
        layers = [
            edges([[SQUARE[i - 1], SQUARE[i]] for i in range(4)], "ink", width=1.6),
            edges(clip_circle(ball.centre, ball.radius), "path", width=3.0),
            edges(clip_circle(q, away.min()), "start", width=2.0, dash=(6, 4)),
            edges([[q, points[away.argmin()]]], "start", width=2.0),
            dots(points, "tree", radius=4.5 if len(points) <= 150 else 3.0),
        ]
        hole, far = f"{ball.radius:.4f}", f"{away.min():.4f}"
        return Drawing(
            layers, text=get_message("samples_board.result", n=len(points), hole=hole, away=far)
        )


def clip_circle(centre: Array, radius: float) -> Array:
    """The part of a circle that lies in the unit square, as short segments (m, 2, 2)."""
    angles = np.linspace(0.0, 2.0 * np.pi, AROUND + 1)
    rim = centre + radius * np.column_stack([np.cos(angles), np.sin(angles)])
    inside = np.abs(rim - 0.5).max(axis=1) <= 0.5
    return segments_along(rim)[inside[:-1] & inside[1:]]

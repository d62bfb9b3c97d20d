"""The square of an arm's two angles, with opposite sides identified: the torus laid flat."""

from functools import cache

import numpy as np

from ...geometry.checks import Array
from ...messages import get_message
from ...support.json_fields import JsonObject
from ..core.drawing import Layer, arrows, edges, labels, sides_of
from ..core.scene import Scene, make_scene

PI, TURN = np.pi, 2.0 * np.pi
COLOURS = ["free_area", "hit_1_area", "hit_2_area"]  # of an image: free, link 1 hits, link 2 hits


def make_square_scene(handles: list[JsonObject]) -> Scene:
    """The square [-pi, pi) x [-pi, pi), with room for its scales at the left and below."""
    scene = make_scene((-PI - 0.7, -PI - 0.7), (PI + 0.3, PI + 0.3), handles=handles)
    glued = {"lo": [-PI, -PI], "hi": [PI, PI]}
    meanings = [get_message(f"figure.link_{link}") for link in range(len(COLOURS))]
    return {**scene, "glued": glued, "colours": COLOURS, "meanings": meanings, "ticks": False}


@cache
def draw_frame() -> tuple[Layer, ...]:
    """Scales and side arrows; identified sides carry equal arrows in the same direction."""
    values, names = np.array([-PI, 0.0, PI]), ["-π", "0", "π"]
    corners = np.array([(-PI, -PI), (PI, -PI), (PI, PI), (-PI, PI)])
    sides = np.array([-PI, PI])
    upright = np.column_stack([sides, [0.0, 0.0]])
    level = np.array([(x, y) for y in sides for x in (0.0, 0.3)])
    return (
        edges(sides_of(corners), "ink", width=1.5),
        arrows(upright - (0.0, 0.25), np.full((2, 2), (0.0, 0.5)), "ceiling", width=3.5),
        arrows(level - (0.4, 0.0), np.full((4, 2), (0.5, 0.0)), "floor", width=3.5),
        labels(np.column_stack([values - 0.3, np.full(3, -PI - 0.55)]), names, "ink"),
        labels(np.column_stack([np.full(3, -PI - 0.65), values - 0.2]), names, "ink"),
        labels([(0.5 * PI - 0.3, -PI - 0.55), (-PI - 0.65, 0.5 * PI - 0.2)], ["θ₁", "θ₂"], "ink"),
    )


def split_motions(begins: Array, ends: Array) -> Array:
    """Motions along shortest arcs, as segments within the square, (m, 2, 2), cut at its sides.

    begins, ends : (n, 2), angles in [-pi, pi).
    """
    change = (ends - begins + PI) % TURN - PI
    with np.errstate(divide="ignore", invalid="ignore"):
        crossing = np.where(
            np.abs(begins + change) > PI, (np.copysign(PI, change) - begins) / change, 1.0
        )
    n = len(begins)
    fractions = np.sort(np.column_stack([np.zeros(n), crossing, np.ones(n)]), axis=1)
    stops = begins[:, None] + fractions[:, :, None] * change[:, None]
    middle = 0.5 * (stops[:, :-1] + stops[:, 1:])
    turns = TURN * np.floor((middle + PI) / TURN)
    pieces = np.stack([stops[:, :-1] - turns, stops[:, 1:] - turns], axis=2)
    return pieces[np.diff(fractions, axis=1) > 0.0]

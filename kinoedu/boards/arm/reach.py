"""Boards about configurations: which angles put an arm's tip somewhere, and the short way on the
torus.
"""

import numpy as np
from numpy.typing import ArrayLike

from ...figures.configurations import way_on_torus
from ...geometry.checks import Array
from ...robots.arm import ArmRobot, why_unreachable
from ...spaces import torus_distance
from ...words import say
from ..core.canvas import Canvas
from ..core.drawing import Drawing, Layer, dots, edges
from ..core.scene import Scene, handle, make_scene, place_of

ROUND = np.linspace(0.0, 2.0 * np.pi, 121)


def reach_board(arm: ArmRobot, p: ArrayLike) -> Canvas:
    """Drag a target: every configuration of a two-link arm that puts its tip there, and the ring
    that the tip reaches.

    p : (2,), where the target begins. Raises InvalidPoint, InvalidRobot.

    >>> from kinoedu.robots import TwoLinkArm
    >>> reach_board(TwoLinkArm(2, 1, 0), p=(2, 1))
    Canvas(2.236 from the base: θ₁ = 0, θ₂ = 1.571; or θ₁ = 0.927, θ₂ = -1.571)
    """
    why_unreachable(arm, p)  # refuses what is no arm of two links, or no target
    reach = 1.25 * float(arm.lengths.sum())
    scene = make_scene(
        arm.base - reach, arm.base + reach, handles=[handle("p", p, colour="goal", marker="star")]
    )
    return Canvas(scene, lambda now: solutions_drawn(arm, now))


def solutions_drawn(arm: ArmRobot, scene: Scene) -> Drawing:
    """The ring, the arms whose tip is at the target, and their angles; or why there is none."""
    p = place_of(scene, "p")
    rims = [
        rim(arm, radius) for radius in (arm.lengths.sum(), abs(arm.lengths[0] - arm.lengths[1]))
    ]
    why = why_unreachable(arm, p)
    if why:
        return Drawing(
            [*rims, dots([arm.base], "ink", radius=6.0)], text=say("reach_board.none", why=why)
        )
    solutions = arm.inverse(p)
    places = [np.vstack([arm.base, *arm.joints(q)]) for q in solutions]
    links = edges(
        [segment for joints in places for segment in (joints[:2], joints[1:])], "robot", width=5.0
    )
    elbows = dots([joints[1] for joints in places], "robot", radius=6.0)
    pairs = say("reach_board.or").join(
        say("reach_board.pair", first=short(float(q[0])), second=short(float(q[1])))
        for q in solutions
    )
    text = say("reach_board.found", far=f"{float(np.hypot(*(p - arm.base))):.4g}", pairs=pairs)
    return Drawing([*rims, links, elbows, dots([arm.base], "ink", radius=6.0)], text=text)


def rim(arm: ArmRobot, radius: float) -> Layer:
    """A circle round an arm's base."""
    points = arm.base + radius * np.column_stack([np.cos(ROUND), np.sin(ROUND)])
    return edges(segments(points), "tree", width=1.5)


def torus_board(a: ArrayLike, b: ArrayLike) -> Canvas:
    """Drag two configurations of a two-link arm on the square of their angles: the short way, which
    may cross the edges.

    a, b : (2,), angles in radians. Raises InvalidPoint.

    >>> torus_board((3, 0), (-3, 0))
    Canvas(0.283 on the torus; 6 as in the plane)
    """
    square = np.pi * np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    ends = [handle("a", a, colour="start"), handle("b", b, colour="goal", marker="star")]
    return Canvas(make_scene((-3.6, -3.6), (3.6, 3.6), boundary=square, handles=ends), way_drawn)


def way_drawn(scene: Scene) -> Drawing:
    """The short way from a to b, and dashed the straight one that a square with walls would
    have.
    """
    a, b = place_of(scene, "a"), place_of(scene, "b")
    pieces = segments(way_on_torus(a, b))
    whole = pieces[(np.abs(pieces[:, 1] - pieces[:, 0]) < np.pi).all(axis=1)]
    walled, short_one = float(np.hypot(*(a - b))), float(torus_distance(a, b))
    layers = [edges([[a, b]], "goal", width=1.5, dash=(6, 4)), edges(whole, "path", width=4.0)]
    return Drawing(
        layers, text=say("torus_board.text", torus=f"{short_one:.3g}", plane=f"{walled:.3g}")
    )


def segments(points: Array) -> Array:
    """A line through points (n, 2) as segments, shape (n - 1, 2, 2)."""
    return np.stack([points[:-1], points[1:]], axis=1)


def short(angle: float) -> str:
    """An angle with three decimals at most."""
    return f"{round(angle, 3) + 0.0:g}"

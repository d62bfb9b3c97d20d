"""Boards of configurations: inverse kinematics of an arm, and shortest paths on the torus."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ...figures.configurations import sample_torus_path
from ...messages import get_message
from ...robots.arm import ArmRobot, why_unreachable
from ...spaces import torus_distance
from ..core.canvas import Canvas
from ..core.drawing import Drawing, Layer, dots, edges, segments_along
from ..core.scene import Scene, handle, make_scene, place_of

ROUND = np.linspace(0.0, 2.0 * np.pi, 121)


def reach_board(arm: ArmRobot, p: ArrayLike) -> Canvas:
    """Drag a target: every configuration of a two-link arm with its tip there.

    The ring that the tip can reach is drawn too.

    Parameters
    ----------
    arm : TwoLinkArm(l1, l2, width).
    p : (2,), the first target.

    Raises
    ------
    InvalidPoint, InvalidRobot

    Examples
    --------
    >>> from kinoedu.robots import TwoLinkArm
    >>> reach_board(TwoLinkArm(2, 1, 0), p=(2, 1))
    Canvas(2.236 from the base: θ₁ = 0, θ₂ = 1.571; or θ₁ = 0.927, θ₂ = -1.571)
    """
    why_unreachable(arm, p)  # raises unless this is an arm of two links and a target
    reach = 1.25 * float(arm.lengths.sum())
    target = handle("p", p, colour="goal", marker="star")
    scene = make_scene(arm.base - reach, arm.base + reach, handles=[target])
    return Canvas(scene, lambda now: draw_solutions(arm, now))


def draw_solutions(arm: ArmRobot, scene: Scene) -> Drawing:
    """Draw the ring, the arms with their tip at the target and their angles, or why none is."""
    p = place_of(scene, "p")
    rims = [
        draw_rim(arm, radius)
        for radius in (arm.lengths.sum(), abs(arm.lengths[0] - arm.lengths[1]))
    ]
    base = dots([arm.base], "ink", radius=6.0)
    why = why_unreachable(arm, p)
    if why:
        return Drawing([*rims, base], text=get_message("reach_board.none", why=why))
    solutions = arm.inverse(p)
    places = [np.vstack([arm.base, *arm.joints(q)]) for q in solutions]
    links = edges(
        [segment for joints in places for segment in (joints[:2], joints[1:])], "robot", width=5.0
    )
    elbows = dots([joints[1] for joints in places], "robot", radius=6.0)
    pairs = get_message("reach_board.or").join(
        get_message(
            "reach_board.pair", first=format_angle(float(q[0])), second=format_angle(float(q[1]))
        )
        for q in solutions
    )
    text = get_message(
        "reach_board.found", far=f"{float(np.hypot(*(p - arm.base))):.4g}", pairs=pairs
    )
    return Drawing([*rims, links, elbows, base], text=text)


def draw_rim(arm: ArmRobot, radius: float) -> Layer:
    """A circle round an arm's base."""
    points = arm.base + radius * np.column_stack([np.cos(ROUND), np.sin(ROUND)])
    return edges(segments_along(points), "tree", width=1.5)


def torus_board(a: ArrayLike, b: ArrayLike) -> Canvas:
    """Drag two configurations on the square of angles: the shortest path may cross the edges.

    Parameters
    ----------
    a, b : (2,), angles in radians.

    Raises
    ------
    InvalidPoint

    Examples
    --------
    >>> torus_board((3, 0), (-3, 0))
    Canvas(0.283 on the torus; 6 as in the plane)
    """
    square = np.pi * np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    ends = [handle("a", a, colour="start"), handle("b", b, colour="goal", marker="star")]
    return Canvas(
        make_scene((-3.6, -3.6), (3.6, 3.6), boundary=square, handles=ends), answer_torus_path
    )


def answer_torus_path(scene: Scene) -> Drawing:
    """Draw the shortest path from a to b, and dashed the straight one of a square with walls."""
    a, b = place_of(scene, "a"), place_of(scene, "b")
    pieces = segments_along(sample_torus_path(a, b))
    uncut = pieces[(np.abs(pieces[:, 1] - pieces[:, 0]) < np.pi).all(axis=1)]
    plane, torus = float(np.hypot(*(a - b))), float(torus_distance(a, b))
    layers = [edges([[a, b]], "ink", width=1.5, dash=(6, 4)), edges(uncut, "path", width=4.0)]
    text = get_message("torus_board.text", torus=f"{torus:.3g}", plane=f"{plane:.3g}")
    return Drawing(layers, text=text)


def format_angle(angle: float) -> str:
    """An angle with at most three decimals."""
    return f"{round(angle, 3) + 0.0:g}"

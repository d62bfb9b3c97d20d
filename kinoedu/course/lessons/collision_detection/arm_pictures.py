"""Pictures of arms for exercises: truth solid green, student's answer dashed brown."""

import numpy as np

from ....geometry.checks import Array
from ....messages import get_message
from ...exercise import Axes, Case, Exercise

LINKS = ("link 1", "link 2")
JOINTS = "joints"
Scene = dict[str, list[Array]]
CORNERS = 64  # vertices of a circle
# figures are imported inside the functions: matplotlib is only needed for failing cases


def circle(centre: Array, radius: float) -> Array:
    """Outline of a disc, (64, 2)."""
    angles = 2.0 * np.pi * np.arange(CORNERS) / CORNERS
    return centre + radius * np.column_stack([np.cos(angles), np.sin(angles)])


def bar(a: Array, b: Array, width: float, *, rounded: bool = True) -> Array:
    """Outline of a link from a to b, with rounded ends or as a rectangle.

    With rounded ends it bounds all points within half the width of the segment.
    """
    along = (b - a) / np.linalg.norm(b - a)
    aside = width / 2 * np.array([-along[1], along[0]])
    if not rounded:
        return np.array([a - aside, b - aside, b + aside, a + aside])
    half = np.arctan2(*along[::-1]) - np.pi / 2 + np.linspace(0.0, np.pi, CORNERS // 2 + 1)
    cap = width / 2 * np.column_stack([np.cos(half), np.sin(half)])
    return np.vstack([b + cap, a - cap])


def draw_contact(
    exercise: Exercise, case: Case, ends: Array, value: object, truth: int, ax: Axes
) -> None:
    """Draw the discs and the arm: the touching link green, the student's answer dashed."""
    from ....figures import palette, plane

    width, discs = case.given["width"], case.given["discs"]
    outlines = [bar(a, b, width) for a, b in zip(ends, ends[1:])]
    rounds = [circle(disc[:2], disc[2]) for disc in discs]
    plane.frame(np.vstack([*outlines, *rounds]), ax, margin=0.15)
    for outline in rounds:
        ax.fill(*outline.T, facecolor=palette.OBSTACLE, alpha=0.6, zorder=2)
    for link, outline in enumerate(outlines, 1):
        ax.fill(*outline.T, facecolor=palette.ROBOT, alpha=0.45, zorder=3)
        closed = np.vstack([outline, outline[:1]])
        edge = palette.TRUE if link == truth else palette.INK
        ax.plot(*closed.T, "-", color=edge, linewidth=3.5 if link == truth else 1.2, zorder=4)
        if link == value:
            ax.plot(*closed.T, "--", color=palette.YOURS, linewidth=2.5, zorder=5)
        plane.label(
            (ends[link - 1] + ends[link]) / 2,
            get_message("collision_picture.link", number=link),
            ax,
        )
    for end in ends:
        plane.dot(end, "", ax)
    words = (
        get_message("picture.no_answer")
        if value is None
        else get_message("picture.yours", value=value)
    )
    plane.corner_note(words, ax, colour=palette.YOURS)
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def draw_scene(exercise: Exercise, case: Case, truth: Scene, value: Scene | None, ax: Axes) -> None:
    """Draw the right drawing pale, and the student's shapes with the same labels dashed."""
    from ....figures import palette, plane

    plane.frame(
        np.vstack([ring for label in (*LINKS, "disc") for ring in truth[label]]), ax, margin=0.2
    )
    for label, colour in (
        (LINKS[0], palette.ROBOT),
        (LINKS[1], palette.ROBOT),
        ("disc", palette.OBSTACLE),
    ):
        for ring in truth[label]:
            edge: palette.Style = {"edgecolor": palette.TRUE, "linewidth": 2.0}
            ax.fill(*ring.T, facecolor=colour, alpha=0.4, zorder=2, **edge)
        for ring in [] if value is None else value[label]:
            if len(ring) > 1:
                closed = np.vstack([ring, ring[:1]])
                ax.plot(*closed.T, "--", color=palette.YOURS, linewidth=2.5, zorder=4)
        if label in LINKS:
            plane.label(truth[label][0].mean(axis=0), label, ax)
    for place in truth[JOINTS]:
        plane.dot(place, "", ax, colour=palette.TRUE)
    for place in [] if value is None else value[JOINTS]:
        plane.dot(place, "", ax, colour=palette.YOURS, marker="x")
    if value is None:
        plane.corner_note(get_message("picture.no_answer"), ax, colour=palette.YOURS)
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def draw_samples(
    exercise: Exercise, case: Case, truth: Array, value: Array | None, ax: Axes
) -> None:
    """Draw the right samples of the configuration space, and the student's dots as crosses."""
    from ....figures import palette, plane

    full = 2.0 * np.pi
    ax.set_aspect("equal")
    for rows, marker, size in (
        (truth, "os^", 11),
        (value if value is not None else truth[:0], "xxxx", 6),
    ):
        for link, colour in zip((0, 1, 2, 9), (*palette.LINKS, palette.OUTSIDE)):
            places = rows[rows[:, 2] == link][:, :2] % full
            fill: palette.Style = {
                "markerfacecolor": "none",
                "markeredgecolor": colour,
                "markeredgewidth": 2.2,
            }
            ax.plot(
                *places.T, marker[min(link, len(marker) - 1)], markersize=size, zorder=3, **fill
            )
    ax.set(xlim=(-0.3, full + 0.3), ylim=(-0.3, full + 0.3))
    for set_ticks in (ax.set_xticks, ax.set_yticks):
        set_ticks(
            full * np.arange(5) / 4, ["0", "π/2", "π", "3π/2", "2π"], fontsize=palette.TEXT_SIZE
        )
    ax.set_xlabel(get_message("collision_picture.first_angle"), fontsize=palette.TEXT_SIZE)
    ax.set_ylabel(get_message("collision_picture.second_angle"), fontsize=palette.TEXT_SIZE)
    plane.title(
        get_message("picture.no_answer")
        if value is None
        else exercise.message(f"pictures.{case.kind}"),
        ax,
    )

"""Pictures of failing cases of lesson 14.

The right answer is solid and green, the student's is dashed and brown.
"""

import math

import numpy as np

from ....geometry.checks import Array
from ....messages import get_message
from ...exercise import Axes, Case, Exercise, ValueExercise, format_value
from ...shapes import Value
from .scenarios import find_contacts

# functions import figures themselves: matplotlib is needed only where an answer is wrong

MOST_DRAWN = 40  # scenarios that are drawn
SPECK = 0.01  # a disc of a smaller radius is too small to be drawn as a ring


def format_answer(value: float | None) -> str:
    """Format an answer, or say that there is none."""
    return get_message("timed_picture.none") if value is None else format_value(value)


def draw_contact(exercise: ValueExercise, case: Case, value: float | None, ax: Axes) -> None:
    """Draw both motions, and point and disc at the right and at the student's time."""
    from ....figures import palette, plane

    p0, p1, c0, c1, r = case.given.values()
    rim = np.array([(r, r), (-r, -r)])
    plane.frame(np.vstack([p0, p1, c0 + rim, c1 + rim]), ax, margin=0.15)
    plane.arrow(p0, p1 - p0, "", ax, colour=palette.ROBOT)
    plane.arrow(c0, c1 - c0, "", ax, colour=palette.OBSTACLE)
    plane.dot(p0, "p0", ax, colour=palette.ROBOT)
    plane.dot(c0, "c0", ax, colour=palette.OBSTACLE, marker="s")
    plane.ring(c0, r, "", ax, colour=palette.OBSTACLE, style=":")
    truth = exercise.truth(case)
    for s, colour, style in ((truth, palette.TRUE, "-"), (value, palette.YOURS, "--")):
        if s is not None and 0.0 <= s <= 1.0:
            plane.ring(c0 + s * (c1 - c0), r, "", ax, colour=colour, style=style)
            marker = "o" if colour == palette.TRUE else "X"
            plane.dot(p0 + s * (p1 - p0), "", ax, colour=colour, marker=marker)
    shown = [format_answer(exercise.as_asked(one, case)) for one in (truth, value)]
    plane.corner_note(
        get_message("timed_picture.both", true=shown[0], yours=shown[1]),
        ax,
        colour=palette.YOURS,
    )
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def draw_schedule(
    exercise: Exercise, case: Case, best: Value, value: Array | None, ax: Axes
) -> None:
    """Draw a line for each place, thick where safe, with the right path and the student's."""
    from ....figures import palette, plane

    safe, moves, start, goal = case.given.values()
    durations = {frozenset((int(u), int(v))): d for u, v, d in moves}
    thick: palette.Style = {"linewidth": 9, "alpha": 0.45, "solid_capstyle": "butt", "zorder": 2}
    for place, own in enumerate(safe):
        ax.axhline(place, color=palette.OUTSIDE, linewidth=1.0, zorder=1)
        for begin, end in own:
            ax.plot([begin, end], [place, place], color=palette.ROADMAP, **thick)
    yours = np.empty((0, 2)) if value is None else value[np.isfinite(value).all(axis=1)]
    for rows, colour, style in ((best, palette.TRUE, "-o"), (yours, palette.YOURS, "--X")):
        points = []
        for (u, a), (v, b) in zip(rows, rows[1:]):
            points += [(a, u), (b - durations.get(frozenset((int(u), int(v))), 0.0), u)]
        points += [(row[1], row[0]) for row in rows[-1:]]
        x, y = np.reshape(points, (-1, 2)).T
        ax.plot(x, y, style, color=colour, linewidth=2.2, markersize=7, zorder=4)
    right = max([12.0, *(float(row[1]) for row in best)])
    latest = max([right, *(float(row[1]) for row in yours)])
    ax.set(
        xlim=(-0.04 * right, min(1.15 * latest, max(60.0, 2.0 * right))),
        ylim=(-0.6, len(safe) - 0.4),
        yticks=range(len(safe)),
    )
    ax.set_xlabel(get_message("timed_picture.time"), fontsize=palette.TEXT_SIZE)
    ax.set_ylabel(
        get_message("timed_picture.place", start=start, goal=goal), fontsize=palette.TEXT_SIZE
    )
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def draw_margins(exercise: ValueExercise, case: Case, value: Array | None, ax: Axes) -> None:
    """Draw the margin of each obstacle, and the student's."""
    from ....figures import palette, plane

    truth = exercise.truth(case)
    number = np.arange(len(truth))
    ax.bar(number - 0.2, truth, 0.38, color=palette.TRUE, zorder=3)
    yours = np.nan_to_num(value) if value is not None and len(value) == len(truth) else np.empty(0)
    striped: palette.Style = {"hatch": "//", "edgecolor": "white", "zorder": 3}
    ax.bar(number[: len(yours)] + 0.2, yours, 0.38, color=palette.YOURS, **striped)
    ax.set(xticks=number)
    ax.set_xlabel(get_message("timed_picture.obstacle"), fontsize=palette.TEXT_SIZE)
    ax.set_ylabel(get_message("timed_picture.margin"), fontsize=palette.TEXT_SIZE)
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    shown = np.concatenate([truth, yours, [0.0]])
    ax.set_ylim(shown.min(), 1.3 * shown.max())
    text = get_message("timed_picture.bars") if len(yours) else get_message("timed_picture.none")
    ax.annotate(
        text, (0.02, 0.92), xycoords="axes fraction", fontsize=palette.TEXT_SIZE, color=palette.INK
    )
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def draw_scenarios(exercise: ValueExercise, case: Case, value: Array | None, ax: Axes) -> None:
    """Draw the path, the discs at their centres, and the discs in some scenarios.

    Discs that hit the path are red and solid.
    """
    from ....figures import palette, plane

    path, discs, offsets = case.given.values()
    some = offsets[:MOST_DRAWN]
    centres, hit = discs[:, :2] + some, find_contacts(path, discs, offsets)[:MOST_DRAWN]
    plane.frame(
        np.vstack([path, discs[:, :2] - discs[:, 2:], discs[:, :2] + discs[:, 2:]]), ax, margin=0.2
    )
    for (s, j), was_hit in np.ndenumerate(hit):
        colour, style = (palette.HIT, "-") if was_hit else (palette.OUTSIDE, ":")
        for artist in plane.ring(centres[s, j], discs[j, 2], "", ax, colour=colour, style=style):
            artist.set(linewidth=0.9)
        if discs[j, 2] < SPECK:
            ax.plot(*centres[s, j], "o" if was_hit else "x", color=colour, markersize=6, zorder=6)
    for x, y, r in discs:
        plane.ring((x, y), r, "", ax, colour=palette.OBSTACLE)
    ax.plot(*path.T, "-o", color=palette.PATH, linewidth=3.0, zorder=5)
    true, yours = (
        get_message("timed_picture.none")
        if numbers is None
        else format_value(tuple(round(float(x), 4) for x in exercise.as_asked(numbers, case)))
        for numbers in (exercise.truth(case), value)
    )
    ax.set_xlabel(
        get_message("timed_picture.shares", true=true, yours=yours),
        fontsize=palette.TEXT_SIZE,
        color=palette.YOURS,
    )
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def draw_missed(value: Value, radius: float, moments: int, ax: Axes) -> None:
    """Draw the point's motion seen from the disc, with the moments that the program samples."""
    from ....figures import palette, plane

    if value is None:
        plane.frame([(0, 0), (1, 1)], ax)
        plane.corner_note(get_message("picture.no_answer"), ax, colour=palette.YOURS)
        return
    p0, p1, c0, c1 = value
    way = (p0 - c0) + np.linspace(0.0, 1.0, moments)[:, None] * ((p1 - p0) - (c1 - c0))
    near = way[np.hypot(*way.T) < 4.0 * radius + 1.5 * math.dist(way[0], way[1])]
    near = near if len(near) else way
    plane.frame(np.vstack([near, [(radius, radius), (-radius, -radius)]]), ax, margin=0.2)
    plane.ring((0, 0), radius, "", ax, colour=palette.OBSTACLE)
    plane.corner_note(get_message("timed_picture.disc"), ax, colour=palette.OBSTACLE)
    ax.plot(*way.T, "-o", color=palette.YOURS, linewidth=1.5, markersize=6, zorder=4)
    plane.title(get_message("exposing_motions.picture"), ax)

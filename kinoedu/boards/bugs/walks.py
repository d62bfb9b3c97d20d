"""Bugs' walks on a board: in the world, and as distance to the goal against distance walked.

All walks of a drawing share one clock: at each step they have walked the same distance.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...geometry.checks import Array
from ...messages import get_message
from ...problems import Plan, Walk
from ..core.drawing import Drawing, Layer, arrows, dots, edges, labels, segments_along, sides_of
from ..core.notes import note, with_notes
from ..core.scene import Scene, make_scene

ARROWS = 12  # about the number of arrows that show the direction of a walk
FREE, ALONG = ("tree", 2.5), ("path", 5.0)  # towards the goal; along a wall: colour, width
LOOKS = {  # colour and width of each of several walks, the widest beneath
    "BugBase": ("outside", 14.0),
    "Bug 1": ("roadmap", 10.0),
    "Bug 0": ("robot", 6.5),
    "Bug 2.prelim": ("path", 4.0),
    "Bug 2": ("ink", 1.5),
}
PLOT = (2.0, 1.2)  # the size of a plot on its board


class Clock(NamedTuple):
    """The distance walked at each step: `tick` per step, up to step `total`."""

    tick: float
    total: int

    def when(self, walk: Walk) -> Array:
        """The step at which each point of a walk is reached."""
        return np.minimum(np.ceil(walk.travelled / self.tick - 1e-9), self.total)

    def at(self, walk: Walk) -> NDArray[np.int64]:
        """The index of the last point reached, at each step from 0."""
        return np.searchsorted(self.when(walk), np.arange(self.total + 1), side="right") - 1


def make_clock(walks: Sequence[Walk], spacing: float) -> Clock:
    """A clock that ends with the longest walk and has ticks of at most `spacing`."""
    longest = max(float(walk.travelled[-1]) for walk in walks)
    total = max(1, int(np.ceil(longest / spacing)))
    return Clock(longest / total or 1.0, total)


def draw_walk(
    plan: Plan, walk: Walk, clock: Clock, texts: Sequence[str], rings: Sequence[Array]
) -> Drawing:
    """Draw one walk: free motion, walls followed, hits and leaves, the robot and its contacts."""
    size = float(np.ptp(np.concatenate([*rings, walk.points]), axis=0).max())
    layers = [
        edges([[plan.problem.start, plan.problem.goal]], "ink", width=1.0, dash=(2.0, 5.0)),
        *draw_stretches(walk.points, walk, clock),
        draw_directions(walk, clock, 0.02 * size),
        *draw_marks(walk.points, walk, clock),
        *draw_sensor(walk, clock, rings, 1e-9 * size),
    ]
    return grow_by_clock(clock, layers, describe_outcome(plan, walk), texts)


def grow_by_clock(
    clock: Clock, layers: Sequence[Layer], text: str, texts: Sequence[str]
) -> Drawing:
    """A drawing that grows by a clock."""
    unit = get_message("bug_board.unit")
    return Drawing(layers, text=text, total=clock.total, unit=unit, step_texts=texts)


def describe_steps(plans: Sequence[tuple[Plan, Walk]], clock: Clock) -> list[str]:
    """For each step what the one bug does, or how far all have come, in words."""
    if len(plans) > 1:
        far = clock.tick * np.arange(clock.total + 1)
        return [get_message("bug_board.race", travelled=f"{s:.4g}") for s in far]
    (plan, walk) = plans[0]
    at, texts = clock.at(walk), []
    values = walk.travelled[at], walk.distance_to_goal[at], walk.following[at]
    for s, d, follows in zip(*values, strict=True):
        numbers = {"travelled": f"{s:.4g}", "distance": f"{d:.4g}"}
        kind = "along" if follows else "free"
        texts.append(get_message(f"bug_board.{kind}", bug=plan.planner, **numbers))
    return texts


def describe_outcome(plan: Plan, walk: Walk) -> str:
    """The result of a walk, in words."""
    values = {"bug": plan.planner, "length": f"{walk.travelled[-1]:.4g}", "hits": len(walk.hit)}
    if plan.path is not None:
        return get_message("bug_board.reached", **values)
    return get_message("bug_board.failed", **values, reason=plan.reason)


def draw_race(plans: Sequence[tuple[Plan, Walk]], clock: Clock, texts: Sequence[str]) -> Drawing:
    """Draw several walks over one another, the widest line beneath."""
    problem = plans[0][0].problem
    layers = [edges([[problem.start, problem.goal]], "ink", width=1.0, dash=(2.0, 5.0))]
    layers += [
        draw_race_line(walk.points, plan, walk, clock) for plan, walk in sort_by_width(plans)
    ]
    for plan, walk in sort_by_width(plans):
        layers += draw_robot(walk.points, walk, clock, LOOKS[plan.planner][0])
    reached = [
        f"{plan.planner} {walk.travelled[-1]:.4g}" for plan, walk in plans if plan.path is not None
    ]
    missed = [plan.planner for plan, _ in plans if plan.path is None]
    lines = [get_message("bug_board.lengths", lengths=", ".join(reached))] if reached else []
    lines += [get_message("bug_board.missed", names=", ".join(missed))] if missed else []
    return grow_by_clock(clock, layers, "\n".join(lines), texts)


def sort_by_width(plans: Sequence[tuple[Plan, Walk]]) -> list[tuple[Plan, Walk]]:
    """The walks in the order in which they are drawn."""
    return sorted(plans, key=lambda pair: -LOOKS[pair[0].planner][1])


def draw_race_line(points: Array, plan: Plan, walk: Walk, clock: Clock) -> Layer:
    """One walk among several."""
    colour, width = LOOKS[plan.planner]
    return edges(segments_along(points), colour, width=width, when=clock.when(walk)[1:])


def draw_stretches(points: Array, walk: Walk, clock: Clock) -> list[Layer]:
    """The line through points (n, 2), in one style towards the goal and another along walls."""
    segments, when, along = segments_along(points), clock.when(walk)[1:], walk.following[1:]
    looks = ((~along, FREE), (along, ALONG))
    says = note("walk", travelled=None, distance=None)
    values = {"travelled": walk.travelled[1:], "distance": walk.distance_to_goal[1:]}
    return [
        with_notes(
            edges(segments[these], colour, width=width, when=when[these]),
            says,
            **{name: column[these] for name, column in values.items()},
        )
        for these, (colour, width) in looks
        if these.any()
    ]


def draw_directions(walk: Walk, clock: Clock, length: float) -> Layer:
    """Arrow heads along a walk that show its direction, at equal distances, not at corners."""
    tips = (np.arange(ARROWS) + 0.5) / ARROWS * walk.travelled[-1]
    begins, ends = (
        np.column_stack([np.interp(s, walk.travelled, column) for column in walk.points.T])
        for s in (tips - length, tips)
    )
    along, when = ends - begins, np.ceil(tips / clock.tick)
    straight = np.hypot(*along.T) > 0.999 * length
    return arrows(begins[straight], along[straight], "ink", width=1.5, when=when[straight])


def draw_marks(points: Array, walk: Walk, clock: Clock) -> list[Layer]:
    """Labels H1, H2, ... where the bug hit walls and L1, L2, ... where it left them.

    Labels of the same point are joined into one.
    """
    when, names = clock.when(walk), dict[tuple[float, ...], list[str]]()
    hits = [(i, f"H{k}") for k, i in enumerate(walk.hit, start=1)]
    leaves = [(i, f"L{k}") for k, i in enumerate(walk.leave, start=1)]
    times: list[float] = []
    for i, name in sorted(hits + leaves, key=lambda event: event[0]):
        place = tuple(points[i].tolist())
        if place not in names:
            times.append(when[i])
        names.setdefault(place, []).append(name)
    places = np.array(list(names)).reshape(-1, 2)
    return [
        dots(places, "contact", radius=5.0, when=times),
        labels(places, [", ".join(group) for group in names.values()], "contact", when=times),
    ]


def draw_sensor(walk: Walk, clock: Clock, rings: Sequence[Array], reach: float) -> list[Layer]:
    """The robot at each step; in contact it has a rim, and the touched edges are marked."""
    places = walk.points[clock.at(walk)]
    walls = np.concatenate([np.empty((0, 2, 2)), *(sides_of(ring) for ring in rings)])
    steps, touched = np.nonzero(distances_to(places, walls) <= reach)
    feels = np.unique(steps)
    return [
        edges(walls[touched], "contact", width=4.0, when=steps, until=steps + 1),
        dots(places[feels], "contact", radius=9.5, when=feels, until=feels + 1),
        *draw_robot(walk.points, walk, clock, "robot"),
    ]


def draw_robot(points: Array, walk: Walk, clock: Clock, colour: str) -> list[Layer]:
    """The robot at each step, placed on the points (n, 2) that stand for the walk's points."""
    places, steps = points[clock.at(walk)], np.arange(clock.total + 1.0)
    return [
        dots(places, "free", radius=7.5, when=steps, until=steps + 1),
        dots(places, colour, radius=6.0, when=steps, until=steps + 1),
    ]


def distances_to(points: Array, segments: Array) -> Array:
    """The distances from points (n, 2) to segments (m, 2, 2), shape (n, m)."""
    a, along = segments[:, 0], segments[:, 1] - segments[:, 0]
    apart = points[:, None] - a
    squared = np.maximum((along * along).sum(axis=1), 1e-300)
    fraction = np.clip((apart * along).sum(axis=2) / squared, 0.0, 1.0)
    rest = apart - fraction[..., None] * along
    return np.sqrt((rest * rest).sum(axis=2))


def make_plot_scene() -> Scene:
    """The scene of a plot: nothing can be dragged."""
    wide, high = PLOT
    return {**make_scene((-0.26, -0.33), (wide + 0.1, high + 0.2)), "ticks": False}


def draw_plot(plans: Sequence[tuple[Plan, Walk]], clock: Clock, texts: Sequence[str]) -> Drawing:
    """Draw the distance to the goal against the distance walked, for one walk or several."""
    longest = max(float(walk.travelled[-1]) for _, walk in plans) or 1.0
    far = max(float(walk.distance_to_goal.max()) for _, walk in plans) or 1.0
    curves = [
        np.column_stack([walk.travelled / longest * PLOT[0], walk.distance_to_goal / far * PLOT[1]])
        for _, walk in plans
    ]
    layers = draw_axes(longest, far)
    if len(plans) == 1:
        walk, curve = plans[0][1], curves[0]
        layers += [
            *draw_stretches(curve, walk, clock),
            *draw_marks(curve, walk, clock),
            *draw_robot(curve, walk, clock, "robot"),
        ]
    else:
        by_name = {plan.planner: curve for (plan, _), curve in zip(plans, curves, strict=True)}
        layers += [
            draw_race_line(by_name[plan.planner], plan, walk, clock)
            for plan, walk in sort_by_width(plans)
        ]
        layers += [
            layer
            for plan, walk in plans
            for layer in draw_robot(by_name[plan.planner], walk, clock, LOOKS[plan.planner][0])
        ]
        layers += label_ends(by_name)
    return grow_by_clock(clock, layers, get_message("bug_board.nothing"), texts)


def draw_axes(longest: float, far: float) -> list[Layer]:
    """The frame of a plot, with lines and numbers at round values."""
    (wide, high), across, up = PLOT, round_values(longest, 5), round_values(far, 4)
    x, y = across / longest * wide, up / far * high
    upright = [((a, 0.0), (a, high)) for a in x[1:].tolist()]
    level = [((0.0, b), (wide, b)) for b in y[1:].tolist()]
    below = np.column_stack([x - 0.06, np.full(len(x), -0.17)])
    left = np.column_stack([np.full(len(y) - 1, -0.22), y[1:] - 0.06])
    return [
        edges(np.array(upright + level), "outside", width=0.7),
        edges([[(0.0, high), (0.0, 0.0)], [(0.0, 0.0), (wide, 0.0)]], "ink", width=1.5),
        labels(below, [f"{value:g}" for value in across], "ink"),
        labels(left, [f"{value:g}" for value in up[1:]], "ink"),
        labels([(-0.22, high + 0.08)], [get_message("bug_board.distance")], "ink"),
        labels([(0.62 * wide, -0.31)], [get_message("bug_board.way")], "ink"),
    ]


def round_values(most: float, count: int) -> Array:
    """Multiples of 1, 2 or 5 times a power of ten, from 0 to `most`, about `count` of them."""
    rough = most / count
    power = 10.0 ** np.floor(np.log10(rough))
    step = next(m * power for m in (1.0, 2.0, 5.0, 10.0) if m * power >= rough * (1.0 - 1e-9))
    return step * np.arange(int(most / step * (1.0 + 1e-9)) + 1)


def label_ends(curves: dict[str, Array]) -> list[Layer]:
    """The curves' names at their ends; curves that end at the same point share a label."""
    groups: dict[tuple[float, ...], list[str]] = {}
    for name, curve in curves.items():
        groups.setdefault(tuple(np.round(curve[-1], 6).tolist()), []).append(name)
    reached = [end for end in sorted(groups) if end[1] == 0.0]
    heights = {end: 0.1 * k for k, end in enumerate(reached)}
    return [
        labels([(x, heights.get((x, y), y))], [", ".join(names)], "ink")
        for (x, y), names in groups.items()
    ]

"""Several bugs' walks on a board: in the world, and as distance to goal by distance walked.

All walks share one clock: at each step they have walked the same distance. One walk alone is drawn
by its body, `kinoedu.browser.bugs`.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...browser.bug_looks import AXES
from ...browser.walks import (
    HIGH,
    WIDE,
    Course,
    count_steps,
    draw_axes,
    points_reached,
    robot_at_steps,
    steps_of,
)
from ...geometry.checks import Array
from ...messages import get_message
from ...problems import Plan, Walk
from ..core.drawing import Drawing, Layer, dots, edges, labels, segments_along
from ..core.scene import Scene, make_scene
from ..core.shown import make_layer

LOOKS = {  # colour and width of each of several walks, the widest beneath
    "BugBase": ("outside", 14.0),
    "Bug 1": ("roadmap", 10.0),
    "Bug 0": ("robot", 6.5),
    "Bug 2.prelim": ("path", 4.0),
    "Bug 2": ("ink", 1.5),
}


class Clock(NamedTuple):
    """The distance walked at each step: `tick` per step, up to step `total`."""

    tick: float
    total: int

    def when(self, walk: Walk) -> Array:
        """The step at which each point of a walk is reached."""
        return steps_of(walk.travelled, self.tick, self.total)

    def at(self, walk: Walk) -> NDArray[np.int64]:
        """The index of the last point reached, at each step from 0."""
        return points_reached(self.when(walk), self.total)


def make_clock(walks: Sequence[Walk], step: float) -> Clock:
    """A clock that ends with the longest walk and has ticks of at most `step`."""
    total, tick = count_steps(max(float(walk.travelled[-1]) for walk in walks), step)
    return Clock(tick, total)


def course_of(walk: Walk) -> Course:
    """A walk as its body takes it."""
    return Course(walk.points, walk.following, walk.travelled, walk.hit, walk.leave)


def grow_by_clock(clock: Clock, layers: Sequence[Layer], text: str) -> Drawing:
    """A drawing that grows by a clock, and says at each step how far all have come."""
    far = clock.tick * np.arange(clock.total + 1)
    unit = get_message("bug_board.unit")
    return Drawing(layers, text=text, total=clock.total, unit=unit).with_texts(
        lambda: [get_message("bug_board.race", travelled=f"{s:.4g}") for s in far]
    )


def draw_race(plans: Sequence[tuple[Plan, Walk]], clock: Clock) -> Drawing:
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
    return grow_by_clock(clock, layers, "\n".join(lines))


def sort_by_width(plans: Sequence[tuple[Plan, Walk]]) -> list[tuple[Plan, Walk]]:
    """The walks in the order in which they are drawn."""
    return sorted(plans, key=lambda pair: -LOOKS[pair[0].planner][1])


def draw_race_line(points: Array, plan: Plan, walk: Walk, clock: Clock) -> Layer:
    """One walk among several."""
    colour, width = LOOKS[plan.planner]
    return edges(segments_along(points), colour, width=width, when=clock.when(walk)[1:])


def draw_robot(points: Array, walk: Walk, clock: Clock, colour: str) -> list[Layer]:
    """The robot at each step, placed on the points (n, 2) that stand for the walk's points."""
    rows = robot_at_steps(points, clock.at(walk))
    places, when, until = rows[:, :2], rows[:, 2], rows[:, 3]
    return [
        dots(places, "free", radius=7.5, when=when, until=until),
        dots(places, colour, radius=6.0, when=when, until=until),
    ]


def make_plot_scene() -> Scene:
    """The scene of a plot: nothing can be dragged."""
    return {**make_scene((-0.26, -0.33), (WIDE + 0.1, HIGH + 0.2)), "ticks": False}


def draw_plots(plans: Sequence[tuple[Plan, Walk]], clock: Clock) -> Drawing:
    """Draw the distance to the goal against the distance walked, for several walks."""
    longest = max(float(walk.travelled[-1]) for _, walk in plans) or 1.0
    far = max(float(walk.distance_to_goal.max()) for _, walk in plans) or 1.0
    scales = np.array([WIDE / longest, HIGH / far])
    curves = {
        plan.planner: np.column_stack([walk.travelled, walk.distance_to_goal]) * scales
        for plan, walk in plans
    }
    layers = [make_layer(look, rows, {}) for look, rows in zip(AXES, draw_axes(longest, far))]
    layers += [
        draw_race_line(curves[plan.planner], plan, walk, clock)
        for plan, walk in sort_by_width(plans)
    ]
    layers += [
        layer
        for plan, walk in plans
        for layer in draw_robot(curves[plan.planner], walk, clock, LOOKS[plan.planner][0])
    ]
    layers += label_ends(curves)
    return grow_by_clock(clock, layers, get_message("bug_board.nothing"))


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

"""Bugs' walks on a board: in the world, and as a plot of the distance to the goal against the way
walked.

All that is drawn of some walks shares one clock: each has walked equally far at each of its steps.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...geometry.checks import Array
from ...problems import Plan, Walk
from ...words import say
from ..core.drawing import Drawing, Layer, arrows, dots, edges, labels
from ..core.scene import Scene, make_scene

ARROWS = 12  # about so many show the sense of a walk
FREE, ALONG = ("tree", 2.5), ("path", 5.0)  # towards the goal; along a wall: colour, width
LOOKS = {  # where several walks lie over one another, the widest beneath: colour, width
    "BugBase": ("outside", 14.0),
    "Bug 1": ("roadmap", 10.0),
    "Bug 0": ("robot", 6.5),
    "Bug 2.prelim": ("path", 4.0),
    "Bug 2": ("ink", 1.5),
}
PLOT = (2.0, 1.2)  # the size of a plot on its board


class Clock(NamedTuple):
    """How far a bug has come at a step: `tick` each, up to step `total`."""

    tick: float
    total: int

    def when(self, walk: Walk) -> Array:
        """The step at which each point of a walk came."""
        return np.minimum(np.ceil(walk.travelled / self.tick - 1e-9), self.total)

    def at(self, walk: Walk) -> NDArray[np.int64]:
        """The number of the last point that came, at each step from 0."""
        return np.searchsorted(self.when(walk), np.arange(self.total + 1), side="right") - 1


def clock_for(walks: Sequence[Walk], step: float) -> Clock:
    """A clock that ends with the longest walk, at most `step` a tick."""
    longest = max(float(walk.travelled[-1]) for walk in walks)
    total = max(1, int(np.ceil(longest / step)))
    return Clock(longest / total or 1.0, total)


def walk_drawn(
    plan: Plan, walk: Walk, clock: Clock, told: Sequence[str], rings: Sequence[Array]
) -> Drawing:
    """One walk: free motion and walls followed, hits and leaves, and the robot with the wall that
    it touches.
    """
    size = float(np.ptp(np.concatenate([*rings, walk.points]), axis=0).max())
    layers = [
        edges([[plan.problem.start, plan.problem.goal]], "ink", width=1.0, dash=(2.0, 5.0)),
        *stretches(walk.points, walk, clock),
        senses(walk, clock, 0.02 * size),
        *marks(walk.points, walk, clock),
        *sensor(walk, clock, rings, 1e-9 * size),
    ]
    return Drawing(
        layers, text=outcome(plan, walk), total=clock.total, unit=say("bug_board.unit"), told=told
    )


def told_of(plans: Sequence[tuple[Plan, Walk]], clock: Clock) -> list[str]:
    """What one bug does at each step, or how far all have come, in words."""
    if len(plans) > 1:
        return [
            say("bug_board.race", travelled=f"{k * clock.tick:.4g}") for k in range(clock.total + 1)
        ]
    (plan, walk) = plans[0]
    at = clock.at(walk)
    return [
        say(
            "bug_board.along" if follows else "bug_board.free",
            bug=plan.planner,
            travelled=f"{s:.4g}",
            distance=f"{d:.4g}",
        )
        for s, d, follows in zip(
            walk.travelled[at], walk.distance_to_goal[at], walk.following[at], strict=True
        )
    ]


def outcome(plan: Plan, walk: Walk) -> str:
    """What became of a walk, in words."""
    said = {"bug": plan.planner, "length": f"{walk.travelled[-1]:.4g}", "hits": len(walk.hit)}
    return (
        say("bug_board.reached", **said)
        if plan.path is not None
        else say("bug_board.failed", **said, reason=plan.reason)
    )


def race_drawn(plans: Sequence[tuple[Plan, Walk]], clock: Clock, told: Sequence[str]) -> Drawing:
    """Several walks over one another, the widest line beneath."""
    problem = plans[0][0].problem
    layers = [edges([[problem.start, problem.goal]], "ink", width=1.0, dash=(2.0, 5.0))]
    layers += [race_line(walk.points, plan, walk, clock) for plan, walk in widest_first(plans)]
    for plan, walk in widest_first(plans):
        layers += runner(walk.points, walk, clock, LOOKS[plan.planner][0])
    reached = [
        f"{plan.planner} {walk.travelled[-1]:.4g}" for plan, walk in plans if plan.path is not None
    ]
    missed = [plan.planner for plan, _ in plans if plan.path is None]
    lines = [say("bug_board.lengths", lengths=", ".join(reached))] if reached else []
    lines += [say("bug_board.missed", names=", ".join(missed))] if missed else []
    return Drawing(
        layers, text="\n".join(lines), total=clock.total, unit=say("bug_board.unit"), told=told
    )


def widest_first(plans: Sequence[tuple[Plan, Walk]]) -> list[tuple[Plan, Walk]]:
    """In the order in which they are drawn."""
    return sorted(plans, key=lambda pair: -LOOKS[pair[0].planner][1])


def race_line(points: Array, plan: Plan, walk: Walk, clock: Clock) -> Layer:
    """One walk among several."""
    colour, width = LOOKS[plan.planner]
    return edges(
        np.stack([points[:-1], points[1:]], axis=1), colour, width=width, when=clock.when(walk)[1:]
    )


def stretches(points: Array, walk: Walk, clock: Clock) -> list[Layer]:
    """The way through points (n, 2): what was walked towards the goal, and what along walls."""
    segments, when, along = (
        np.stack([points[:-1], points[1:]], axis=1),
        clock.when(walk)[1:],
        walk.following[1:],
    )
    looks = ((~along, FREE), (along, ALONG))
    return [
        edges(segments[these], colour, width=width, when=when[these])
        for these, (colour, width) in looks
        if these.any()
    ]


def senses(walk: Walk, clock: Clock, length: float) -> Layer:
    """Arrow heads along a walk that show its sense, at equal distances, none on a corner."""
    tips = (np.arange(ARROWS) + 0.5) / ARROWS * walk.travelled[-1]
    begins, ends = (
        np.column_stack([np.interp(s, walk.travelled, column) for column in walk.points.T])
        for s in (tips - length, tips)
    )
    straight = np.hypot(*(ends - begins).T) > 0.999 * length
    when = np.ceil(tips / clock.tick)
    return arrows(
        begins[straight], (ends - begins)[straight], "ink", width=1.5, when=when[straight]
    )


def marks(points: Array, walk: Walk, clock: Clock) -> list[Layer]:
    """H1, H2, ... where it hit walls and L1, L2, ... where it left them, each place named once for
    all that it is.
    """
    when, names = clock.when(walk), dict[tuple[float, ...], list[str]]()
    turns = [(i, f"H{k}") for k, i in enumerate(walk.hit, start=1)] + [
        (i, f"L{k}") for k, i in enumerate(walk.leave, start=1)
    ]
    came: list[float] = []
    for i, name in sorted(turns, key=lambda turn: turn[0]):
        place = tuple(points[i].tolist())
        if place not in names:
            came.append(when[i])
        names.setdefault(place, []).append(name)
    places = np.array(list(names)).reshape(-1, 2)
    return [
        dots(places, "contact", radius=5.0, when=came),
        labels(places, [", ".join(group) for group in names.values()], "contact", when=came),
    ]


def sensor(walk: Walk, clock: Clock, rings: Sequence[Array], reach: float) -> list[Layer]:
    """The robot at each step, with a rim and the touched edges of obstacles where its contact
    sensor feels a wall.
    """
    places = walk.points[clock.at(walk)]
    walls = np.concatenate(
        [np.stack([ring, np.roll(ring, -1, axis=0)], axis=1) for ring in rings]
        or [np.empty((0, 2, 2))]
    )
    steps, touched = np.nonzero(distances_to(places, walls) <= reach)
    feels = np.unique(steps)
    return [
        edges(walls[touched], "contact", width=4.0, when=steps, until=steps + 1),
        dots(places[feels], "contact", radius=9.5, when=feels, until=feels + 1),
        *runner(walk.points, walk, clock, "robot"),
    ]


def runner(points: Array, walk: Walk, clock: Clock, colour: str) -> list[Layer]:
    """Where a robot is at each step, among the points (n, 2) that stand for those of its walk."""
    places, steps = points[clock.at(walk)], np.arange(clock.total + 1.0)
    return [
        dots(places, "free", radius=7.5, when=steps, until=steps + 1),
        dots(places, colour, radius=6.0, when=steps, until=steps + 1),
    ]


def distances_to(points: Array, segments: Array) -> Array:
    """From points (n, 2) to segments (m, 2, 2), shape (n, m)."""
    a, along = segments[:, 0], segments[:, 1] - segments[:, 0]
    apart = points[:, None] - a
    share = np.clip(
        (apart * along).sum(axis=2) / np.maximum((along * along).sum(axis=1), 1e-300), 0.0, 1.0
    )
    rest = apart - share[..., None] * along
    return np.sqrt((rest * rest).sum(axis=2))


def plot_scene() -> Scene:
    """The board of a plot: nothing can be dragged."""
    wide, high = PLOT
    return {**make_scene((-0.1, -0.33), (wide + 0.1, high + 0.2)), "ticks": False}


def plot_drawn(plans: Sequence[tuple[Plan, Walk]], clock: Clock, told: Sequence[str]) -> Drawing:
    """The distance to the goal against the way walked, of one walk or of several."""
    way = max(float(walk.travelled[-1]) for _, walk in plans) or 1.0
    far = max(float(walk.distance_to_goal.max()) for _, walk in plans) or 1.0
    curves = [
        np.column_stack([walk.travelled / way * PLOT[0], walk.distance_to_goal / far * PLOT[1]])
        for _, walk in plans
    ]
    layers = axes_of_plot(way, far)
    if len(plans) == 1:
        walk, curve = plans[0][1], curves[0]
        layers += [
            *stretches(curve, walk, clock),
            *marks(curve, walk, clock),
            *runner(curve, walk, clock, "robot"),
        ]
    else:
        by_name = {plan.planner: curve for (plan, _), curve in zip(plans, curves, strict=True)}
        layers += [
            race_line(by_name[plan.planner], plan, walk, clock)
            for plan, walk in widest_first(plans)
        ]
        layers += [
            layer
            for plan, walk in plans
            for layer in runner(by_name[plan.planner], walk, clock, LOOKS[plan.planner][0])
        ]
        layers += ends_named(by_name)
    return Drawing(
        layers,
        text=say("bug_board.nothing"),
        total=clock.total,
        unit=say("bug_board.unit"),
        told=told,
    )


def axes_of_plot(way: float, far: float) -> list[Layer]:
    """The frame of a plot, with lines and numbers at round values."""
    (wide, high), across, up = PLOT, round_values(way, 5), round_values(far, 4)
    x, y = across / way * wide, up / far * high
    lines = [((a, 0.0), (a, high)) for a in x[1:].tolist()] + [
        ((0.0, b), (wide, b)) for b in y[1:].tolist()
    ]
    return [
        edges(np.array(lines), "outside", width=0.7),
        edges([[(0.0, high), (0.0, 0.0)], [(0.0, 0.0), (wide, 0.0)]], "ink", width=1.5),
        labels(
            np.column_stack([x - 0.06, np.full(len(x), -0.17)]),
            [f"{value:g}" for value in across],
            "ink",
        ),
        labels(
            np.column_stack([np.full(len(y) - 1, -0.03), y[1:]]),
            [f"{value:g}" for value in up[1:]],
            "ink",
        ),
        labels([(-0.03, high + 0.08)], [say("bug_board.distance")], "ink"),
        labels([(0.62 * wide, -0.31)], [say("bug_board.way")], "ink"),
    ]


def round_values(most: float, count: int) -> Array:
    """From 0 up to at most `most`, about so many steps of 1, 2 or 5 times a power of ten."""
    rough = most / count
    power = 10.0 ** np.floor(np.log10(rough))
    step = next(m * power for m in (1.0, 2.0, 5.0, 10.0) if m * power >= rough * (1.0 - 1e-9))
    return step * np.arange(int(most / step * (1.0 + 1e-9)) + 1)


def ends_named(curves: dict[str, Array]) -> list[Layer]:
    """Each curve's name at its end; those that end together are named together, one above
    another.
    """
    groups: dict[tuple[float, ...], list[str]] = {}
    for name, curve in curves.items():
        groups.setdefault(tuple(np.round(curve[-1], 6).tolist()), []).append(name)
    reached = [end for end in sorted(groups) if end[1] == 0.0]
    heights = {end: 0.1 * k for k, end in enumerate(reached)}
    return [
        labels([(x, heights.get((x, y), y))], [", ".join(names)], "ink")
        for (x, y), names in groups.items()
    ]

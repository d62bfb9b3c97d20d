"""An exploration drawn so that it can be scrubbed: what was known at each step, and where the robot
was.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from ...geometry.checks import Array
from ...planners.exploring.receding_horizon import Look
from ...problems import Plan
from ...words import say
from ..core.drawing import Drawing, Layer, bodies, cells, dots, edges

MOVES = 8  # steps from one look to the next


def exploration_drawn(plan: Plan, looks: Sequence[Look]) -> Drawing:
    """Region and walls seen, the plan in that map, the way gone, and the robot on it."""
    ways = [np.vstack([look.seen.origin, look.followed]) for look in looks]
    spots = [at_shares(way, np.arange(MOVES) / MOVES) for way in ways]
    places = np.concatenate([*spots, ways[-1][-1:]]) if ways else plan.problem.start[None]
    steps = np.arange(len(places))
    total = len(places) - 1
    begins = MOVES * np.arange(len(looks))
    ends = np.append(begins[1:], np.inf)
    walked = np.concatenate([[0.0], np.sqrt((np.diff(places, axis=0) ** 2).sum(axis=1)).cumsum()])
    robot = [
        dots(places, colour, radius=r, when=steps, until=steps + 1)
        for colour, r in (("free", 8.0), ("robot", 6.5))
    ]
    layers = [
        *(seen_drawn(looks, begins, ends) if looks else []),
        edges(np.stack([places[:-1], places[1:]], axis=1), "ink", width=5.0, when=steps[1:]),
        edges(np.stack([places[:-1], places[1:]], axis=1), "path", width=3.0, when=steps[1:]),
        *robot,
    ]
    told = told_of(looks, walked)
    return Drawing(
        layers,
        text=outcome(plan, len(looks), walked[-1]),
        total=total,
        unit=say("exploring_board.unit"),
        told=told,
    )


def seen_drawn(looks: Sequence[Look], begins: NDArray[np.int64], ends: Array) -> list[Layer]:
    """What the sensor saw at each look, the walls that it added to the map, and the plan in it."""
    regions = np.array([look.seen.points for look in looks])
    known = [0, *(len(look.walls) for look in looks)]
    walls = looks[-1].walls[:, :2]
    came = np.repeat(begins, np.diff(known))
    plans = [
        (path_edges(look.plan.path), k)
        for k, look in enumerate(looks)
        if look.plan.path is not None
    ]
    which = np.repeat([k for _, k in plans], [len(rows) for rows, _ in plans]).astype(np.int64)
    rows = np.concatenate([np.empty((0, 2, 2)), *(rows for rows, _ in plans)])
    return [
        cells(regions, "cell", when=begins),
        bodies(regions, "roadmap", when=begins, until=ends),
        edges(walls, "hit", width=3.0, when=came),
        edges(rows, "tree", width=2.5, dash=(7.0, 5.0), when=begins[which], until=ends[which]),
    ]


def path_edges(points: Array) -> Array:
    """The motions of a path, (n - 1, 2, 2)."""
    return np.stack([points[:-1], points[1:]], axis=1)


def at_shares(points: Array, shares: Array) -> Array:
    """Places at shares of the length of a path, (k, 2)."""
    gone = np.concatenate([[0.0], np.sqrt((np.diff(points, axis=0) ** 2).sum(axis=1)).cumsum()])
    return np.column_stack([np.interp(shares * gone[-1], gone, axis) for axis in points.T])


def told_of(looks: Sequence[Look], walked: Array) -> list[str]:
    """What the robot knows at each step before the last."""
    told = []
    for k, look in enumerate(looks):
        for gone in walked[MOVES * k : MOVES * (k + 1)].tolist():
            said = {"look": k + 1, "walls": len(look.walls), "walked": f"{gone:.4g}"}
            if look.plan.path is None:
                told.append(say("exploring_board.stuck", **said))
            else:
                promised = sum(
                    float(np.sqrt(((b - a) ** 2).sum())) for a, b in pairwise(look.plan.path)
                )
                told.append(say("exploring_board.now", **said, promised=f"{promised:.4g}"))
    return told


def outcome(plan: Plan, looks: int, walked: float) -> str:
    """What became of it."""
    if plan.path is None:
        return say("exploring_board.failed", reason=plan.reason, walked=f"{walked:.4g}")
    return say("exploring_board.arrived", looks=looks, walked=f"{plan.cost:.4g}")

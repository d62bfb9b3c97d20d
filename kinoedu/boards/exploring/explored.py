"""An exploration that can be scrubbed: the robot's map and position at each step."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from ...geometry.checks import Array
from ...geometry.paths import distances_along, points_at_fractions
from ...messages import get_message
from ...planners.exploring.receding_horizon import Look
from ...problems import Plan
from ..core.drawing import Drawing, Layer, bodies, cells, dots, edges, path_edges, segments_along

MOVES = 8  # steps from one look to the next


def draw_exploration(plan: Plan, looks: Sequence[Look]) -> Drawing:
    """Draw the regions and walls seen, the plan in that map, the path driven and the robot."""
    walks = [np.vstack([look.scan.origin, look.followed]) for look in looks]
    stops = [points_at_fractions(walk, np.arange(MOVES) / MOVES) for walk in walks]
    places = np.concatenate([*stops, walks[-1][-1:]]) if walks else plan.problem.start[None]
    steps = np.arange(len(places))
    total = len(places) - 1
    begins = MOVES * np.arange(len(looks))
    ends = np.append(begins[1:], np.inf)
    walked = distances_along(places)
    robot = [
        dots(places, colour, radius=r, when=steps, until=steps + 1)
        for colour, r in (("free", 8.0), ("robot", 6.5))
    ]
    layers = [
        *(draw_looks(looks, begins, ends) if looks else []),
        *path_edges(segments_along(places), when=steps[1:]),
        *robot,
    ]
    text, unit = describe_outcome(plan, len(looks), walked[-1]), get_message("exploring_board.unit")
    return Drawing(layers, text=text, total=total, unit=unit).with_texts(
        lambda: describe_steps(looks, walked)
    )


def draw_looks(looks: Sequence[Look], begins: NDArray[np.int64], ends: Array) -> list[Layer]:
    """Draw each look: the region seen, the walls added to the map, and the plan in the map."""
    regions = np.array([look.scan.points for look in looks])
    counts = [0, *(len(look.walls) for look in looks)]
    walls = looks[-1].walls[:, :2]
    times = np.repeat(begins, np.diff(counts))
    paths = [(look.plan.path, k) for k, look in enumerate(looks)]
    plans = [(segments_along(points), k) for points, k in paths if points is not None]
    which = np.repeat([k for _, k in plans], [len(rows) for rows, _ in plans]).astype(np.int64)
    rows = np.concatenate([np.empty((0, 2, 2)), *(rows for rows, _ in plans)])
    return [
        cells(regions, "cell", when=begins),
        bodies(regions, "roadmap", when=begins, until=ends),
        edges(walls, "hit", width=3.0, when=times),
        edges(rows, "tree", width=2.5, dash=(7.0, 5.0), when=begins[which], until=ends[which]),
    ]


def describe_steps(looks: Sequence[Look], walked: Array) -> list[str]:
    """The robot's knowledge at each step before the last, in words."""
    texts = []
    for k, look in enumerate(looks):
        for distance in walked[MOVES * k : MOVES * (k + 1)].tolist():
            values = {"look": k + 1, "walls": len(look.walls), "walked": f"{distance:.4g}"}
            if look.plan.path is None:
                texts.append(get_message("exploring_board.stuck", **values))
            else:
                legs = pairwise(look.plan.path)
                promised = sum(float(np.sqrt(((b - a) ** 2).sum())) for a, b in legs)
                texts.append(
                    get_message("exploring_board.now", **values, promised=f"{promised:.4g}")
                )
    return texts


def describe_outcome(plan: Plan, looks: int, walked: float) -> str:
    """The result of the exploration, in words."""
    if plan.path is None:
        return get_message("exploring_board.failed", reason=plan.reason, walked=f"{walked:.4g}")
    return get_message("exploring_board.arrived", looks=looks, walked=f"{plan.cost:.4g}")

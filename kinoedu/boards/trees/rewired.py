"""The tree of an RRT* as it was at each step, drawn so that it can be scrubbed: a step is a
node.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...figures.drawing import line_width
from ...geometry.checks import Array
from ...graphs import extract_path
from ...planners.trees.rewiring import Rewirings
from ...words import say
from ..core.drawing import Layer, bodies, dots, edges

CORNERS = 40  # of a ball as it is drawn


class Way(NamedTuple):
    """The way to the goal from the step on at which it came, (k, 2), and its length."""

    step: int
    points: Array
    cost: float


def tree_as_it_was(log: Rewirings) -> Layer:
    """Every edge, from the step at which it came to that at which it was replaced."""
    n = len(log.nodes)
    until = np.where(log.gone < n, log.gone + 1.0, np.inf)
    return edges(
        segments(log, log.parent, log.node),
        "tree",
        width=line_width(n),
        when=log.came + 1,
        until=until,
    )


def segments(log: Rewirings, begins: NDArray[np.int64], ends: NDArray[np.int64]) -> Array:
    """From nodes to nodes, (m, 2, 2)."""
    return np.stack([log.nodes[begins, :2], log.nodes[ends, :2]], axis=1)


def ways_to_goal(log: Rewirings) -> list[Way]:
    """The way to the goal whenever it became another."""
    parent, ways, on_way = np.full(len(log.nodes), -1), list[Way](), {log.at_goal}
    for node, above, came in zip(
        log.node.tolist(), log.parent.tolist(), log.came.tolist(), strict=True
    ):
        parent[node] = above
        if node in on_way and came >= log.at_goal:
            numbers = extract_path(parent, log.at_goal)
            on_way, points = set(numbers.tolist()), log.nodes[numbers, :2]
            while ways and ways[-1].step == came + 1:
                ways.pop()
            ways.append(
                Way(
                    came + 1,
                    points,
                    float(np.sqrt((np.diff(points, axis=0) ** 2).sum(axis=1)).sum()),
                )
            )
    return ways


def ways_drawn(ways: list[Way]) -> list[Layer]:
    """Ways one after another, on a dark casing as a path is drawn."""
    rows, when, until = [np.empty((0, 2, 2))], list[float](), list[float]()
    for way, after in zip(ways, [*(float(way.step) for way in ways[1:]), np.inf], strict=False):
        rows.append(np.stack([way.points[:-1], way.points[1:]], axis=1))
        when += [way.step] * len(rows[-1])
        until += [after] * len(rows[-1])
    whole = np.concatenate(rows)
    return [
        edges(whole, colour, width=width, when=when, until=until)
        for colour, width in (("ink", 5.0), ("path", 3.0))
    ]


def costs_at(ways: list[Way], total: int) -> list[float]:
    """The length of the way to the goal at each step from 0, infinite before there is one."""
    costs = np.full(total + 1, np.inf)
    for way in ways:
        costs[way.step :] = way.cost
    return costs.tolist()


def moments_drawn(log: Rewirings, near: NDArray[np.int64]) -> list[Layer]:
    """At each step the new node with its ball, the nodes near, the parent chosen, and the edges
    re-hung, the old ones dashed.
    """
    n, nodes = len(log.nodes), log.nodes[:, :2]
    old = rehung_from(log)
    new, again = log.node == log.came, log.node != log.came
    looked = np.flatnonzero(log.radius > 0.0)

    def then(numbers: NDArray[np.int64]) -> dict[str, Any]:
        return {"when": numbers + 1, "until": numbers + 2}

    angles = 2.0 * np.pi * np.arange(CORNERS) / CORNERS
    rim = np.column_stack([np.cos(angles), np.sin(angles)])
    balls = nodes[looked, None] + log.radius[looked, None, None] * rim
    return [
        bodies(balls, "robot", **then(looked)),
        edges(
            segments(log, old, log.node[again]),
            "hit",
            width=1.8,
            dash=(3.0, 5.0),
            **then(log.came[again]),
        ),
        edges(
            segments(log, log.parent[again], log.node[again]),
            "hit",
            width=4.0,
            **then(log.came[again]),
        ),
        edges(
            segments(log, log.parent[new], log.node[new]), "ink", width=4.0, **then(log.came[new])
        ),
        dots(nodes[near[:, 1]], "ink", radius=4.6, **then(near[:, 0])),
        dots(nodes[near[:, 1]], "frontier", radius=3.4, **then(near[:, 0])),
        dots(nodes, "ink", radius=6.5, **then(np.arange(n))),
        dots(nodes, "robot", radius=5.0, **then(np.arange(n))),
    ]


def rehung_from(log: Rewirings) -> NDArray[np.int64]:
    """For each edge that was rewired the parent that its node had before."""
    before, parents = dict[int, int](), []
    for node, parent, came in zip(
        log.node.tolist(), log.parent.tolist(), log.came.tolist(), strict=True
    ):
        if node != came:
            parents.append(before[node])
        before[node] = parent
    return np.array(parents, np.int64)


def near_pairs(log: Rewirings) -> NDArray[np.int64]:
    """Pairs of a node and an older one within its ball, (m, 2)."""
    from scipy.spatial import cKDTree

    nodes = log.nodes[:, :2]
    older, newer = (
        cKDTree(nodes).query_pairs(float(log.radius.max()) * (1.0 + 1e-9), output_type="ndarray").T
    )
    within = ((nodes[older] - nodes[newer]) ** 2).sum(axis=1) <= log.radius[newer] ** 2
    pairs = np.column_stack([newer, older])[within]
    return pairs[np.lexsort((pairs[:, 1], pairs[:, 0]))]


def told_of(log: Rewirings, near: NDArray[np.int64], costs: list[float]) -> list[str]:
    """What happens at each step, in words."""
    n = len(log.radius)
    count = np.bincount(near[:, 0], minlength=n).tolist()
    hung = np.bincount(log.came[log.node != log.came], minlength=n).tolist()
    parent = dict(zip(*log_rows(log), strict=True))
    told = ["", say("rewiring_board.root")]
    for node in range(1, n):
        cost = costs[node + 1]
        way = (
            say("rewiring_board.way", cost=f"{cost:.4g}")
            if np.isfinite(cost)
            else say("rewiring_board.no_way")
        )
        if node == log.at_goal:
            told.append(say("rewiring_board.goal", node=node, parent=parent[node], way=way))
        else:
            told.append(
                say(
                    "rewiring_board.node",
                    node=node,
                    parent=parent[node],
                    near=count[node],
                    hung=hung[node],
                    way=way,
                )
            )
    return told


def log_rows(log: Rewirings) -> tuple[list[int], list[int]]:
    """The new nodes and the parents chosen for them."""
    new = log.node == log.came
    return log.node[new].tolist(), log.parent[new].tolist()

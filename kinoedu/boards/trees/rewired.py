"""The tree of RRT* at each step, drawn so that it can be scrubbed: one step is one node."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...figures.drawing import line_width
from ...geometry.checks import Array
from ...geometry.paths import path_length
from ...graphs import extract_path
from ...messages import get_message
from ...planners.trees.rewiring import Rewirings
from ...support.json_fields import JsonObject
from ..core.drawing import Layer, bodies, dots, edges, path_edges, segments_along
from ..core.notes import note, with_notes

CORNERS = 40  # of the polygon that draws a ball


class PathToGoal(NamedTuple):
    """A path to the goal (k, 2), its length, and the step from which it is the path found."""

    step: int
    points: Array
    cost: float


def draw_tree_history(log: Rewirings) -> Layer:
    """Every edge, from the step at which it was added to the step at which it was replaced."""
    n = len(log.nodes)
    until = np.where(log.replaced_at < n, log.replaced_at + 1.0, np.inf)
    span: JsonObject = {"when": log.created_at + 1, "until": until}
    layer = edges(log_segments(log, log.parent, log.node), "tree", width=line_width(n), **span)
    return with_notes(layer, note("node", node=None), node=log.node, parent=log.parent)


def log_segments(log: Rewirings, begins: NDArray[np.int64], ends: NDArray[np.int64]) -> Array:
    """Segments from nodes to nodes, (m, 2, 2)."""
    return np.stack([log.nodes[begins, :2], log.nodes[ends, :2]], axis=1)


def find_paths_to_goal(log: Rewirings) -> list[PathToGoal]:
    """The path to the goal after each change of it."""
    parent, paths, on_path = np.full(len(log.nodes), -1), list[PathToGoal](), {log.at_goal}
    for node, above, created in zip(
        log.node.tolist(), log.parent.tolist(), log.created_at.tolist(), strict=True
    ):
        parent[node] = above
        if node in on_path and created >= log.at_goal:
            numbers = extract_path(parent, log.at_goal)
            on_path, points = set(numbers.tolist()), log.nodes[numbers, :2]
            while paths and paths[-1].step == created + 1:
                paths.pop()
            paths.append(PathToGoal(created + 1, points, path_length(points)))
    return paths


def find_last_path(log: Rewirings) -> list[PathToGoal]:
    """The last of the paths to the goal; none where there is none."""
    if log.at_goal < 0:
        return []
    n, last = len(log.nodes), log.replaced_at == len(log.nodes)
    parent = np.full(n, -1)
    parent[log.node[last]] = log.parent[last]
    numbers = extract_path(parent, log.at_goal)
    points = log.nodes[numbers, :2]
    step = int(log.created_at[last & np.isin(log.node, numbers)].max())
    return [PathToGoal(max(step, log.at_goal) + 1, points, path_length(points))]


def draw_paths(paths: list[PathToGoal]) -> list[Layer]:
    """Draw the paths one after another, on a dark casing."""
    rows, when, until = [np.empty((0, 2, 2))], list[float](), list[float]()
    for path, after in zip(
        paths, [*(float(path.step) for path in paths[1:]), np.inf], strict=False
    ):
        rows.append(segments_along(path.points))
        when += [path.step] * len(rows[-1])
        until += [after] * len(rows[-1])
    return path_edges(np.concatenate(rows), when=when, until=until)


def costs_at(paths: list[PathToGoal], total: int) -> list[float]:
    """The length of the path to the goal at each step from 0, infinite before there is one."""
    costs = np.full(total + 1, np.inf)
    for path in paths:
        costs[path.step :] = path.cost
    return costs.tolist()


def draw_moments(
    log: Rewirings, near: NDArray[np.int64], numbers: NDArray[np.int64]
) -> list[Layer]:
    """Draw at some steps the new node, its ball and neighbours, its parent and the rewired edges.

    The edges that were replaced are dashed.

    Parameters
    ----------
    near : (m, 2), from `find_near_pairs`.
    numbers : (k,), the new nodes of these steps.
    """
    nodes, drawn = log.nodes[:, :2], np.isin(log.created_at, numbers)
    new, again = drawn & (log.node == log.created_at), drawn & (log.node != log.created_at)
    old, searching = former_parents(log)[again], numbers[log.radius[numbers] > 0.0]

    def then(numbers: NDArray[np.int64]) -> JsonObject:
        return {"when": numbers + 1, "until": numbers + 2}

    angles = 2.0 * np.pi * np.arange(CORNERS) / CORNERS
    rim = np.column_stack([np.cos(angles), np.sin(angles)])
    balls = nodes[searching, None] + log.radius[searching, None, None] * rim
    replaced = log_segments(log, old, log.node[again])
    rewired = log_segments(log, log.parent[again], log.node[again])
    added = log_segments(log, log.parent[new], log.node[new])
    return [
        bodies(balls, "robot", **then(searching)),
        edges(replaced, "hit", width=1.8, dash=(3.0, 5.0), **then(log.created_at[again])),
        edges(rewired, "hit", width=4.0, **then(log.created_at[again])),
        edges(added, "ink", width=4.0, **then(log.created_at[new])),
        dots(nodes[near[:, 1]], "ink", radius=4.6, **then(near[:, 0])),
        dots(nodes[near[:, 1]], "frontier", radius=3.4, **then(near[:, 0])),
        dots(nodes[numbers], "ink", radius=6.5, **then(numbers)),
        dots(nodes[numbers], "robot", radius=5.0, **then(numbers)),
    ]


def former_parents(log: Rewirings) -> NDArray[np.int64]:
    """For each edge the parent that its node had before, (m,); -1 where it is new."""
    order, before = np.argsort(log.node, kind="stable"), np.full(len(log.node), -1)
    again = log.node[order][1:] == log.node[order][:-1]
    before[order[1:][again]] = log.parent[order[:-1][again]]
    return before


def find_near_pairs(log: Rewirings, numbers: NDArray[np.int64]) -> NDArray[np.int64]:
    """Pairs of a node with one of these numbers and an older one within its ball, (m, 2)."""
    x, y = log.nodes[:, 0], log.nodes[:, 1]
    pairs = [np.empty((0, 2), np.int64)]
    for node in numbers.tolist():
        apart = (x[:node] - x[node]) ** 2 + (y[:node] - y[node]) ** 2
        older = np.flatnonzero(apart <= log.radius[node] ** 2)
        pairs.append(np.column_stack([np.full(len(older), node), older]))
    return np.concatenate(pairs)


def describe_steps(
    log: Rewirings, near: NDArray[np.int64], costs: list[float], steps: Iterable[int]
) -> list[str]:
    """What happens at some steps, in words."""
    n = len(log.radius)
    count = np.bincount(near[:, 0], minlength=n).tolist()
    rewired = np.bincount(log.created_at[log.node != log.created_at], minlength=n).tolist()
    new = log.node == log.created_at
    parent = dict(zip(log.node[new].tolist(), log.parent[new].tolist(), strict=True))
    texts = []
    for step in steps:
        node, cost = step - 1, costs[step]
        if node < 1:
            texts.append(get_message("rewiring_board.root") if node == 0 else "")
            continue
        values = {"node": node, "parent": parent[node]}
        way = get_message("rewiring_board.no_way")
        if np.isfinite(cost):
            way = get_message("rewiring_board.way", cost=f"{cost:.4g}")
        if node == log.at_goal:
            texts.append(get_message("rewiring_board.goal", **values, way=way))
        else:
            counts = {"near": count[node], "rewired": rewired[node]}
            texts.append(get_message("rewiring_board.node", **values, **counts, way=way))
    return texts

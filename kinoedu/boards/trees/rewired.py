"""The tree of RRT* at each step, drawn so that it can be scrubbed: one step is one node."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...figures.drawing import line_width
from ...geometry.checks import Array
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
            length = float(np.sqrt((np.diff(points, axis=0) ** 2).sum(axis=1)).sum())
            paths.append(PathToGoal(created + 1, points, length))
    return paths


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


def draw_moments(log: Rewirings, near: NDArray[np.int64]) -> list[Layer]:
    """Draw at each step the new node, its ball and neighbours, its parent and the rewired edges.

    The edges that were replaced are dashed.
    """
    n, nodes = len(log.nodes), log.nodes[:, :2]
    old = former_parents(log)
    new, again = log.node == log.created_at, log.node != log.created_at
    searching = np.flatnonzero(log.radius > 0.0)

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
        dots(nodes, "ink", radius=6.5, **then(np.arange(n))),
        dots(nodes, "robot", radius=5.0, **then(np.arange(n))),
    ]


def former_parents(log: Rewirings) -> NDArray[np.int64]:
    """For each rewired edge the former parent of its node."""
    before, parents = dict[int, int](), []
    for node, parent, created in zip(
        log.node.tolist(), log.parent.tolist(), log.created_at.tolist(), strict=True
    ):
        if node != created:
            parents.append(before[node])
        before[node] = parent
    return np.array(parents, np.int64)


def find_near_pairs(log: Rewirings) -> NDArray[np.int64]:
    """Pairs of a node and an older one within its ball, (m, 2)."""
    from scipy.spatial import cKDTree

    nodes, farthest = log.nodes[:, :2], float(log.radius.max()) * (1.0 + 1e-9)
    older, newer = cKDTree(nodes).query_pairs(farthest, output_type="ndarray").T
    within = ((nodes[older] - nodes[newer]) ** 2).sum(axis=1) <= log.radius[newer] ** 2
    pairs = np.column_stack([newer, older])[within]
    return pairs[np.lexsort((pairs[:, 1], pairs[:, 0]))]


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

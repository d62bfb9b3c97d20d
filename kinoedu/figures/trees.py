"""Figures of trees: whose region a sample falls into, and what an insertion of RRT* changes."""

from __future__ import annotations

from textwrap import fill
from typing import Any

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from numpy.typing import ArrayLike, NDArray

from ..geometry.checks import Array
from ..messages import get_message
from ..problems import ProblemRecord, Tree
from . import palette
from .drawing import World, axes_for, draw_edges, draw_problem, draw_tree, draw_world
from .palette import Style
from .plane import dot, label, ring

ACROSS = 240  # places along the longer side at which the nearest node is computed


def draw_regions(problem: ProblemRecord, tree: Tree, ax: Axes | None = None) -> list[Artist]:
    """Draw the Voronoi region of each node: the larger it is, the darker.

    The world is drawn over the regions, since the distance to a sample ignores it. The title says
    which share of all samples is nearest to leaves.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem, rrt
    >>> problem = Problem(Point(), PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)]), (1, 1), (8, 5))
    >>> artists = draw_regions(problem, rrt(problem, max_nodes=9, rng=0).tree)
    >>> plt.close()
    """
    lo, hi = problem.world.lo, problem.world.hi
    ax = axes_for(problem.world, ax)
    step = float((hi - lo).max()) / ACROSS
    x, y = (np.arange(a + 0.5 * step, b, step) for a, b in zip(lo, hi))
    nearest = nearest_nodes(tree, x, y)
    share = np.bincount(nearest.ravel(), minlength=len(tree.nodes)) / nearest.size
    leaf = ~np.isin(np.arange(len(tree.nodes)), tree.parent)
    look: Style = {"origin": "lower", "extent": (lo[0], hi[0], lo[1], hi[1]), "cmap": "Blues"}
    artists: list[Artist] = draw_problem(problem, ax)
    artists.append(ax.imshow(share[nearest], vmax=1.6 * share.max(), zorder=0.5, **look))
    ax.set_facecolor("none")
    artists += draw_tree(tree, ax)
    for these, marker in ((~leaf, "."), (leaf, "o")):
        artists += ax.plot(*tree.nodes[these].T, marker, color=palette.TREE, zorder=4)
    words = get_message("regions.title", share=f"{share[leaf].sum():.0%}")
    return [*artists, ax.set_title(words, fontsize=palette.TEXT_SIZE + 1)]


def nearest_nodes(tree: Tree, x: Array, y: Array) -> NDArray[np.int64]:
    """The number of the node nearest to each place (x[j], y[i])."""
    away = (x[None, :, None] - tree.nodes[:, 0]) ** 2 + (y[:, None, None] - tree.nodes[:, 1]) ** 2
    return np.asarray(away.argmin(axis=2))


def draw_insertion(
    world: World,
    nodes: ArrayLike,
    before: tuple[Any, Any],
    after: tuple[Any, Any],
    radius: float,
    axes: Any = None,
) -> list[Artist]:
    """Draw a tree before and after RRT* inserts its last node, with the cost of each node.

    As on the board, the edge to the chosen parent is black, an edge that is rewired is red, and the
    edge that it replaces is dashed. Costs that fall are red too.

    Parameters
    ----------
    nodes : (n + 1, 2), the new node last.
    before : the parents and the costs of the first n nodes.
    after : the parents and the costs of all n + 1.
    radius : of the circle of near nodes.
    axes : two; by default those of a new figure.

    Examples
    --------
    >>> from kinoedu import PolygonWorld
    >>> world = PolygonWorld([(0, 0), (9, 0), (9, 9), (0, 9)])
    >>> before = [-1, 0, 1], [0.0, 4.0, 8.0]
    >>> after = [-1, 0, 3, 0], [0.0, 4.0, 5.7, 2.8]
    >>> nodes = [(1, 1), (1, 5), (5, 5), (3, 3)]
    >>> artists = draw_insertion(world, nodes, before, after, 3.0)
    >>> plt.close()
    """
    places = np.asarray(nodes, float)
    new = len(places) - 1
    if axes is None:
        _, axes = plt.subplots(1, 2, figsize=(9.6, 5.2), dpi=72, layout="constrained")
    old_parent, old_cost = (np.asarray(row) for row in before)
    parent, cost = (np.asarray(row) for row in after)
    moved = np.flatnonzero(old_parent != parent[:new])
    cheaper = np.append(cost[:new] < old_cost - 1e-9, False)
    left, right = axes
    artists: list[Artist] = []
    for ax, rows, costs in ((left, old_parent, old_cost), (right, parent, cost)):
        artists += draw_world(world, ax)
        artists += draw_tree(Tree(places[: len(rows)], rows), ax)
        artists += ring(places[new], radius, "", ax, colour=palette.OUTSIDE, style=":")
        for i, (q, c) in enumerate(zip(places, costs)):
            falls = ax is right and cheaper[i]
            colour = palette.HIT if falls else palette.INK if i == new else palette.TREE
            artists += dot(q, "", ax, colour=colour)
            words = f"{i}: {old_cost[i]:.1f} → {c:.1f}" if falls else f"{i}: {c:.1f}"
            artists.append(label(q, words, ax, colour=colour, offset=(10, -5)))
        ax.set(xlabel="", ylabel="", xticks=[], yticks=[])
    artists += draw_edges([(places[parent[new]], places[new])], right, palette.INK, **THICK)
    artists += draw_edges([(places[new], places[i]) for i in moved], right, palette.HIT, **THICK)
    for k in moved.tolist():
        gone = np.array([places[old_parent[k]], places[k]])
        artists += right.plot(*gone.T, "--", color=palette.HIT, linewidth=1.8, zorder=2.5)
    artists += left.plot(*places[new], "o", color="white", markeredgecolor=palette.INK, zorder=6)
    artists.append(
        label(places[new], get_message("insertion.new", n=new), left, colour=palette.INK)
    )
    above = [get_message("insertion.before"), get_message("insertion.after", n=new)]
    size = palette.TEXT_SIZE + 1
    titles = [ax.set_title(fill(text, 38), fontsize=size) for ax, text in zip(axes, above)]
    return [*artists, *titles]


THICK: Style = {"width": 4.0, "zorder": 3.5}

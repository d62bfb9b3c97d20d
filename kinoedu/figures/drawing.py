"""Figures of worlds, problems and plans; each function takes ax=None and returns its artists."""

from __future__ import annotations

from functools import singledispatch
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.colors import LinearSegmentedColormap, ListedColormap
from matplotlib.patches import Circle, PathPatch, Rectangle
from matplotlib.path import Path as Outline
from numpy.typing import ArrayLike, NDArray

from ..geometry.checks import Array
from ..messages import get_message
from ..problems import Plan, ProblemRecord, Roadmap, Tree
from ..problems.plan import roots_of
from ..robots import Point
from ..robots.trajectory import DrivenRoadmap, DrivenTree
from ..worlds.checks import World
from ..worlds.open_world import OpenWorld
from ..worlds.polygon_world import PolygonWorldRecord, discs_of, rings_of
from ..worlds.terrain import TerrainRecord
from . import palette
from .names import HALO, label_beside, move_names_off
from .palette import Style
from .robots import (
    draw_along,
    draw_driven,
    draw_robot,
    driven_tracks,
    even_times,
    place_of,
    track_of,
    tracks,
)
from .walks import draw_walk

POINT = Point()
CLOSE = 0.15  # of the world's size: the names of nearer places would overlap
# Name, colour, marker and its size of start and goal.
ENDS = (("start", palette.START, "o", 9), ("goal", palette.GOAL, "*", 15))


def figure_size(world: World) -> tuple[float, float]:
    """Width and height in inches of a figure that has the world's shape."""
    extent = world.hi - world.lo
    width, height = np.maximum(6.0 * extent / extent.max(), 2.2)
    return float(width) + 1.0, float(height) + 1.0


def axes_for(world: World, ax: Axes | None = None) -> Axes:
    """The axes given, or those of a new figure of the world's shape: equal scales, labelled."""
    ax = palette.axes_or_new(ax, figure_size(world))
    ax.set_aspect("equal")
    margin = 0.01 * (world.hi - world.lo).max()
    ax.set_xlim(world.lo[0] - margin, world.hi[0] + margin)
    ax.set_ylim(world.lo[1] - margin, world.hi[1] + margin)
    ax.set_xlabel("x", **palette.TEXT)
    ax.set_ylabel("y", **palette.TEXT)
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    return ax


def draw_box(low: ArrayLike, high: ArrayLike, name: str, ax: Axes) -> list[Artist]:
    """Mark a part of a picture by a red frame, with a name above it."""
    (x0, y0), (x1, y1) = np.asarray(low, float), np.asarray(high, float)
    if x0 == x1 or y0 == y1:
        return []
    look: Style = {"fill": False, "edgecolor": palette.HIT, "linewidth": 2.8, "zorder": 6}
    frame = Rectangle((x0, y0), x1 - x0, y1 - y0, **look)
    style: Style = {"color": palette.HIT, "path_effects": HALO, "zorder": 8, **palette.BOLD}
    beside: Style = {"xytext": (0, 4), "textcoords": "offset points"}
    return [ax.add_patch(frame), ax.annotate(name, (x0, y1), **beside, **style)]


@singledispatch
def draw_world(world: World, ax: Axes | None = None) -> list[Artist]:
    """Draw the free space and the obstacles of a world.

    Raises
    ------
    TypeError
        Where `world` is not a world.
    """
    raise TypeError(f"a figure cannot draw a {type(world).__name__}")


@draw_world.register
def _(world: PolygonWorldRecord, ax: Axes | None = None) -> list[Artist]:
    ax = axes_for(world, ax)
    (outline,), *solids = rings_of(world)
    rim: Style = {"facecolor": palette.OUTSIDE, "edgecolor": palette.OBSTACLE, "zorder": 1}
    outside = PathPatch(compound([frame(world), outline]), **rim)
    polygons = [PathPatch(compound(rings), zorder=1, **palette.SOLID) for rings in solids]
    discs = [Circle((x, y), r, facecolor=palette.OBSTACLE, zorder=1) for x, y, r in discs_of(world)]
    ax.set_facecolor(palette.FREE)
    return [ax.add_patch(patch) for patch in (outside, *polygons, *discs)]


def frame(world: PolygonWorldRecord) -> Array:
    """A box around the world at a distance, counter-clockwise."""
    (x0, y0), (x1, y1) = world.lo - (world.hi - world.lo), world.hi + (world.hi - world.lo)
    return np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])


def compound(rings: list[Array]) -> Outline:
    """One outline of several rings; rings of opposite orientation are cut out of each other."""
    closed = (Outline(np.vstack([ring, ring[:1]]), closed=True) for ring in rings)
    return Outline.make_compound_path(*closed)


@draw_world.register
def _(world: TerrainRecord, ax: Axes | None = None) -> list[Artist]:
    ax = axes_for(world, ax)
    (x0, y0), (x1, y1) = world.lo, world.hi
    extent = x0, x1, y0, y1
    ax.set_facecolor(palette.OUTSIDE)
    if world.cost.size:
        ground = LinearSegmentedColormap.from_list("ground", [palette.FREE, palette.DEAR])
        ground.set_bad(palette.OBSTACLE)
        costs = np.ma.masked_invalid(world.cost)
        dearest = float(np.quantile(costs.compressed(), 0.98)) + 1e-9
        look: Style = {"origin": "lower", "extent": extent, "interpolation": "nearest"}
        return [ax.imshow(costs, cmap=ground, vmin=1.0, vmax=dearest, zorder=1, **look)]
    return [draw_cells(world.free, extent, ax)]


def draw_cells(
    free: NDArray[np.bool_], extent: tuple[float, float, float, float], ax: Axes
) -> Artist:
    """Draw cells (rows, columns), the lowest row first, in a rectangle x0, x1, y0, y1."""
    colours = ListedColormap([palette.OBSTACLE, palette.FREE])
    look: Style = {"origin": "lower", "extent": extent, "interpolation": "nearest"}
    return ax.imshow(free, cmap=colours, vmin=0, vmax=1, zorder=1, **look)


@draw_world.register
def _(world: OpenWorld, ax: Axes | None = None) -> list[Artist]:
    ax = axes_for(world, ax)
    ax.set_facecolor(palette.FREE)
    shapes = [(compound(world.walls), palette.OUTSIDE)] if world.walls else []
    shapes += [(compound([ring]), palette.OBSTACLE) for ring in world.obstacles]
    return [
        ax.add_patch(PathPatch(outline, facecolor=colour, edgecolor="none", zorder=1))
        for outline, colour in shapes
    ]


def draw_problem(problem: ProblemRecord, ax: Axes | None = None) -> list[Artist]:
    """Draw the world, and the robot at start and goal."""
    ax = axes_for(problem.world, ax)
    artists = draw_world(problem.world, ax)
    for q, (name, colour, marker, size) in zip((problem.start, problem.goal), ENDS, strict=True):
        artists += draw_robot(problem.robot, q, ax, colour)
        at = place_of(problem.robot, q)
        artists += draw_end(at, name, colour, marker, size, problem.world, ax)
    start, goal = (place_of(problem.robot, q) for q in (problem.start, problem.goal))
    if abs(goal - start).max() < CLOSE * abs(problem.world.hi - problem.world.lo).max():
        artists[-1].set(position=(0, -9), ha="center", va="top")  # below, off the other name
    return artists


def draw_end(
    at: Array, name: str, colour: str, marker: str, size: float, world: World, ax: Axes
) -> list[Artist]:
    """Draw the marker of a start or a goal, with its name beside it."""
    look: Style = {"color": colour, "markersize": size, "markeredgewidth": 1.2, **palette.RIM}
    return [*ax.plot(*at, marker, zorder=7, **look), label_beside(at, name, colour, world, ax)]


def draw_edges(
    segments: ArrayLike, ax: Axes, colour: str, *, width: float, zorder: float
) -> list[Artist]:
    """Draw segments, shape (m, 2, 2), or polylines, shape (m, k, 2)."""
    lines = list(np.asarray(segments))
    drawn = LineCollection(lines, colors=colour, linewidths=width, zorder=zorder)
    return [ax.add_collection(drawn, autolim=False)]


def draw_tree(
    tree: Tree | DrivenTree, ax: Axes, *, upto: int | None = None, robot: Any = POINT
) -> list[Artist]:
    """Draw a tree, or the tree of its first `upto` nodes.

    An arm's tree is drawn by the path of its tip. A second tree, with a root of its own, has the
    colour of a goal's tree.
    """
    grown = np.arange(1, len(tree.nodes) if upto is None else max(upto, 1))
    grown = grown[tree.parent[grown] >= 0]
    begins, ends = tree.nodes[tree.parent[grown]], tree.nodes[grown]
    if isinstance(tree, DrivenTree):
        lines = driven_tracks(robot, begins, tree.controls[grown], tree.durations[grown])
    else:
        lines = tracks(robot, begins, ends)
    width, roots = line_width(len(tree.nodes)), roots_of(tree.parent)[grown]
    first = np.asarray(roots == 0)
    artists = draw_edges(rows_of(lines, first), ax, palette.TREE, width=width, zorder=3)
    if first.all():
        return artists
    return artists + draw_edges(
        rows_of(lines, ~first), ax, palette.GOAL_TREE, width=1.3 * width, zorder=3
    )


def rows_of(lines: Any, these: Array) -> list[Any]:
    """Some of the lines."""
    return [line for line, wanted in zip(lines, these) if wanted]


def draw_meeting(plan: Plan, ax: Axes) -> list[Artist]:
    """Mark where the trees of a plan meet: the configuration of its path that both have."""
    if plan.tree is None or plan.path is None or (plan.tree.parent < 0).sum() != 2:
        return []
    roots = roots_of(plan.tree.parent)
    here, there = ({q.tobytes() for q in plan.tree.nodes[roots == root]} for root in (0, 1))
    both = [q for q in plan.path if q.tobytes() in here & there]
    look: Style = {"color": "white", "markeredgecolor": palette.INK, "markersize": 11}
    at = np.array([place_of(plan.problem.robot, q) for q in both[:1]]).reshape(-1, 2)
    name, world = get_message("figure.meeting"), plan.problem.world
    words = [label_beside(q, name, palette.INK, world, ax) for q in at]
    return [*ax.plot(*at.T, "D", zorder=8, **look), *words]


def draw_roadmap(
    roadmap: Roadmap | DrivenRoadmap, ax: Axes, *, upto: int | None = None, robot: Any = POINT
) -> list[Artist]:
    """Draw a roadmap's nodes, and its edges or the first `upto` of them.

    An arm's roadmap is drawn by the path of its tip.
    """
    edges = roadmap.edges[:upto]
    places = np.array([place_of(robot, q) for q in roadmap.nodes])
    size = dot_size(len(roadmap.nodes))
    dots = ax.plot(*places.T, ".", color=palette.TREE, markersize=size, zorder=3.5)
    begins, ends = roadmap.nodes[edges[:, 0]], roadmap.nodes[edges[:, 1]]
    if isinstance(roadmap, DrivenRoadmap):
        lines = driven_tracks(robot, begins, roadmap.controls[:upto], roadmap.durations[:upto])
    else:
        lines = tracks(robot, begins, ends)
    return [*draw_edges(lines, ax, palette.ROADMAP, width=0.8, zorder=3), *dots]


def line_width(n: int) -> float:
    """A line width that falls with the number of lines."""
    return float(np.clip(2.0 - 0.4 * np.log10(max(n, 1)), 0.5, 1.6))


def dot_size(n: int) -> float:
    """A dot size that falls with the number of dots."""
    return float(np.clip(9.0 - 2.0 * np.log10(max(n, 1)), 1.5, 8.0))


def draw_path(path: Array, ax: Axes) -> list[Artist]:
    """Draw a path, shape (n, d), on a dark casing that keeps it visible on any background.

    Names of places that it passes through give way.
    """
    line, style = path[:, :2].T, {"solid_capstyle": "round"}
    casing: Style = {"color": palette.INK, "linewidth": 5.0, "zorder": 4, **style}
    inner: Style = {"color": palette.PATH, "linewidth": 3.0, "zorder": 5, **style}
    lines: list[Artist] = [*ax.plot(*line, **casing), *ax.plot(*line, **inner)]
    move_names_off(path[:, :2], ax)
    return lines


def draw_plan(
    plan: Plan, ax: Axes | None = None, *, upto: int | None = None, title: str | None = None
) -> list[Artist]:
    """Draw a plan: its problem, its tree, roadmap or walk, and the path.

    upto : draw only the first so many nodes of the tree, edges of the roadmap or points of the
        walk; the path only when all are there.
    """
    ax = axes_for(plan.problem.world, ax)
    artists = draw_problem(plan.problem, ax)
    robot = getattr(plan.problem, "robot", POINT)
    total, _ = growth_of(plan)
    if plan.tree is not None:
        artists += draw_tree(plan.tree, ax, upto=upto, robot=robot)
    if plan.roadmap is not None:
        artists += draw_roadmap(plan.roadmap, ax, upto=upto, robot=robot)
    if plan.walk is not None:
        artists += draw_walk(plan.walk, ax, upto=upto)
    shown = total if upto is None else min(upto, total)
    if plan.trajectory is not None and shown == total:
        poses = plan.trajectory.at(even_times(plan.trajectory))
        artists += draw_driven(robot, plan.trajectory, ax) + draw_path(poses, ax)
    elif plan.path is not None and plan.walk is None and shown == total:
        artists += draw_along(robot, plan.problem.space, plan.path, ax)
        artists += draw_path(track_of(robot, plan.path), ax)
        artists += draw_meeting(plan, ax)
    ax.set_title(summary(plan, shown) if title is None else title, wrap=True, **palette.TEXT)
    return artists


def summary(plan: Plan, shown: int) -> str:
    """The content of a plan's figure, in words."""
    total, unit = growth_of(plan)
    counts = {"planner": plan.planner, "total": f"{total:,}", "unit": unit}
    if shown < total:
        return get_message("figure.growing", shown=f"{shown:,}", **counts)
    if plan.path is None:
        if plan.reason.startswith(plan.planner):
            return plan.reason
        return get_message("figure.no_path", planner=plan.planner, reason=plan.reason)
    if plan.walk is not None:
        hits = len(plan.walk.hit)
        unit = get_message("figure.hit" if hits == 1 else "figure.hits")
        counts |= {"total": f"{hits:,}", "unit": unit}
    return get_message("figure.path", length=f"{plan.cost:.4g}", **counts)


def growth_of(plan: Plan) -> tuple[int, str]:
    """The number of steps of a plan's growth, and what a step is, in words."""
    if plan.walk is not None:
        return len(plan.walk.points), get_message("figure.points")
    if plan.roadmap is not None:
        return len(plan.roadmap.edges), get_message("figure.edges")
    return len(plan.tree.nodes) if plan.tree is not None else 0, get_message("figure.nodes")

"""Pictures of failing cases of lesson 13.

The right answer is solid and green, the student's is dashed and brown.
"""

import math
from typing import Any

import numpy as np

from ....geometry.checks import Array
from ....messages import get_message
from ....robots.trajectory import TrajectoryRecord
from ...exercise import Axes, Case, ValueExercise, format_value
from ...shapes import Value
from ..shared.car_pictures import arc, set_axes

# functions import figures themselves: matplotlib is needed only where an answer is wrong


def draw_driven_answer(problem: Any, built: Value, fault: Value, text: str, ax: Axes) -> None:
    """Draw the problem, the tree, the path, and a cross on the fault."""
    from ....figures import palette, plane
    from ....figures.drawing import draw_path, draw_problem, draw_tree

    draw_problem(problem, ax)
    if built is None:
        plane.corner_note(get_message("picture.no_answer"), ax, colour=palette.YOURS)
    else:
        tree, poses = built
        draw_tree(tree, ax, robot=problem.robot)
        ax.plot(*tree.nodes[:, :2].T, ".", color=palette.TREE, markersize=6, zorder=3.5)
        numbers = [int(np.argmin(np.abs(tree.nodes - pose).sum(axis=1))) for pose in poses[1:]]
        drive = TrajectoryRecord(
            problem.start, tree.controls[numbers], tree.durations[numbers], problem.robot.wheelbase
        )
        if len(numbers):
            draw_path(drive.at(np.linspace(0.0, drive.duration, 12 * len(numbers)))[:, :2], ax)
        zoom_in(
            np.vstack([tree.nodes, problem.start, problem.goal])[:, :2],
            5.0 * problem.robot.wheelbase,
            ax,
        )
    if fault is not None and len(fault.marked):
        look: palette.Style = {"color": palette.YOURS, "linewidth": 3.5, "zorder": 8}
        ax.plot(*fault.marked[:, :2].T, "--", **look, scalex=False, scaley=False)
        look = {
            "color": palette.YOURS,
            "markersize": 13,
            "markeredgecolor": "white",
            "zorder": 9,
        }
        ax.plot(*fault.marked[-1, :2], "X", **look)
    plane.title(text, ax)


def zoom_in(places: Array, least: float, ax: Axes) -> None:
    """Zoom in on the positions, with at least `least` units around them, in a large world."""
    middle, reach = (
        (places.min(axis=0) + places.max(axis=0)) / 2.0,
        max(0.6 * float(np.ptp(places, axis=0).max()), least),
    )
    if 4.0 * reach < float(np.ptp(ax.get_xlim())):
        ax.set(
            xlim=(middle[0] - reach, middle[0] + reach), ylim=(middle[1] - reach, middle[1] + reach)
        )


def draw_two_poses(exercise: ValueExercise, case: Case, value: object, ax: Axes) -> None:
    """Draw both poses as arrows, the angle between them, and both distances."""
    from ....figures import cars, palette, plane

    a, b, radian = case.given.values()
    size = max(0.4 * math.dist(a[:2], b[:2]), 1.0)
    plane.frame(np.array([a[:2] - size, a[:2] + size, b[:2] - size, b[:2] + size]), ax)
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)
    ax.plot(*np.array([a, b])[:, :2].T, ":", color=palette.INK, linewidth=2.0)
    cars.draw_pose(a, size, "a", ax, colour=palette.INK)
    cars.draw_pose(b, size, "b", ax, colour=palette.TREE, below=True)
    yours = "-" if value is None else format_value(value)
    plane.corner_note(
        exercise.message(
            "picture", true=format_value(exercise.truth(case)), yours=yours, radian=radian
        ),
        ax,
        colour=palette.YOURS,
    )


def draw_choice(exercise: ValueExercise, case: Case, value: Value, ax: Axes) -> None:
    """Draw the drives by all controls, the right one up to its cut, and the student's.

    Where there is an obstacle, the car's outline is drawn too.
    """
    from ....figures import cars, palette, plane
    from ....figures.drawing import draw_world
    from ....figures.robots import outline_at

    room, q, target, controls, t, n = case.given.values()
    bends = np.tan(controls[:, 1]) / room.problem.robot.wheelbase
    ways = [arc(q, v * t, bend) for (v, _), bend in zip(controls, bends)]
    shown = exercise.truth(case) if value is None or not is_choice(value, controls, n) else value
    poses: Any = [] if shown is None else find_swept_poses(case, bends, *shown)
    outlines = [outline_at(room.problem.robot, pose) for pose in poses]
    tips = [
        pose[:2] + 8.0 * np.array([math.cos(pose[2]), math.sin(pose[2])]) for pose in (q, target)
    ]
    around = np.vstack([*(way[:, :2] for way in ways), *outlines, *tips, target[:2]])
    set_axes(around, None if value is None else around[:1], "", ax)
    limits = ax.get_xlim(), ax.get_ylim()
    draw_world(room.problem.world, ax)
    ax.set(xlim=limits[0], ylim=limits[1])
    for outline in outlines:
        ax.fill(*outline.T, facecolor="none", edgecolor=palette.ROBOT, linewidth=1.4, zorder=4)
    for number, way in enumerate(ways):
        ax.plot(*way[:, :2].T, "-", color=palette.OUTSIDE, linewidth=2.0, zorder=3)
        plane.label(
            way[-1, :2], str(exercise.as_asked((number, n), case)[0]), ax, colour=palette.INK
        )
    for choice, colour, style in (
        (exercise.truth(case), palette.TRUE, "-"),
        (value, palette.YOURS, "--"),
    ):
        if choice is not None and is_choice(choice, controls, n):
            i, k = choice
            way = arc(q, controls[i, 0] * t * k / n, bends[i])
            ax.plot(*way[:, :2].T, style, color=colour, linewidth=4.0, zorder=5)
    cars.draw_pose(q, 8.0, "q", ax, colour=palette.INK, below=True)
    cars.draw_pose(target, 8.0, get_message("driven_picture.target"), ax, colour=palette.TREE)
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def is_choice(choice: Value, controls: Array, n: int) -> bool:
    """Whether the answer names an existing control and an existing step."""
    return bool(0 <= choice[0] < len(controls) and 0 <= choice[1] <= n)


def find_swept_poses(case: Case, bends: Array, i: int, k: int) -> Array:
    """Return four poses of the drive by control i up to step k, both ends included."""
    _, q, _, controls, t, n = case.given.values()
    way = arc(q, controls[i, 0] * t * k / n, bends[i])
    return way[np.unique(np.linspace(0, len(way) - 1, 4).astype(int))]


def draw_fastest(exercise: ValueExercise, case: Case, value: Value, ax: Axes) -> None:
    """Draw the roadmap with its durations, a fastest path and the student's."""
    from ....figures import palette, plane
    from ....figures.graphs import draw_graph, layout
    from ....graphs import Graph

    n, edges, _, durations, ends = case.given.values()
    graph = Graph(n, edges, durations, directed=True)
    draw_graph(graph, ax, weights=n <= 12, highlight=[0, *ends])
    places, truth = layout(graph), exercise.truth(case)
    for way, colour, style in ((truth, palette.TRUE, "-"), (value, palette.YOURS, "--")):
        known = [u for u in ([] if way is None else way) if 0 <= u < n]
        ax.plot(*places[known].T, style, color=colour, linewidth=4.0, alpha=0.7, zorder=4)
    if value is None:
        plane.corner_note(
            get_message("picture.no_answer") if truth is not None else "None",
            ax,
            colour=palette.YOURS,
        )
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)
    ax.set_axis_off()

"""Pictures of failing cases of lesson 11.

The right answer is solid and green, the student's is dashed and brown.
"""

import numpy as np

from ....geometry.checks import Array
from ....messages import get_message
from ...exercise import Axes
from ...shapes import Value
from ...tasks import StudentProblem

# functions import figures themselves: matplotlib is needed only where an answer is wrong


def draw_heading(
    problem: StudentProblem,
    place: Value,
    value: float | None,
    right: float | None,
    texts: tuple[str, str],
    ax: Axes,
) -> None:
    """Draw the world, the robot at a free heading and at the student's.

    Parameters
    ----------
    texts : the title, and the student's heading.
    """
    from ....figures import palette, plane
    from ....figures.drawing import draw_robot, draw_world

    draw_world(problem.world, ax)
    if right is not None:
        draw_robot(problem.robot, np.array([*place, right]), ax, palette.TRUE)
    if value is None:
        plane.corner_note(get_message("picture.yours", value="None"), ax, colour=palette.YOURS)
    elif np.isfinite(value):
        (body,) = draw_robot(problem.robot, np.array([*place, value]), ax, palette.YOURS)
        body.set(linestyle="--")
        plane.corner_note(get_message("picture.yours", value=texts[1]), ax, colour=palette.YOURS)
    plane.dot(place, "", ax)
    plane.title(texts[0], ax)


def draw_matrix(
    problem: StudentProblem, nodes: Array, truth: Value, value: Value, text: str, ax: Axes
) -> None:
    """Draw the numbered configurations, the free motions, and the student's wrong entries."""
    from ....figures import palette, plane
    from ....figures.drawing import draw_robot, draw_world

    draw_world(problem.world, ax)
    fits = value is not None and value.shape == truth.shape
    for i, j in np.argwhere(np.triu(truth, 1)):
        plane.segment(nodes[i, :2], nodes[j, :2], "", ax, colour=palette.TRUE)
    for i, j in np.argwhere((value != truth) & (value != 0)) if fits else []:
        plane.segment(
            nodes[i, :2], nodes[j, :2], "", ax, colour=palette.YOURS, style="--", width=4.0
        )
    for number, q in enumerate(nodes):
        draw_robot(problem.robot, q, ax)
        plane.label(q[:2], str(number), ax, offset=(3, 3))
    if not fits:
        plane.corner_note(get_message("picture.no_answer"), ax, colour=palette.YOURS)
    plane.title(text, ax)


def draw_swept(value: Value, chords: Value, text: str, ax: Axes) -> None:
    """Draw what a disk of radius 1 sweeps, its chords, and an obstacle.

    Parameters
    ----------
    value : (a, b, obstacle), or None.
    """
    from ....figures import palette, plane
    from ....figures.bars import draw_bar

    if value is None:
        plane.frame([(-1.0, -1.0), (5.0, 1.5)], ax)
        plane.corner_note(get_message("picture.no_answer"), ax, colour=palette.YOURS)
    else:
        a, b, obstacle = value
        plane.frame(np.vstack([a - 1.0, a + 1.0, b - 1.0, b + 1.0, obstacle]), ax)
        draw_bar(a, b, 1.0, ax, palette.ROBOT, alpha=0.3, zorder=2)
        for p, q in chords:
            plane.segment(p, q, "", ax, colour=palette.TREE)
        plane.polygon(obstacle, ax, numbers=False)
    plane.title(text, ax)

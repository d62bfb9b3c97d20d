"""The board of a robot that slides round an obstacle: its reference point traces the C-obstacle.

LaValle, section 4.3.2.
"""

from __future__ import annotations

from typing import Any

import ipywidgets as widgets
import numpy as np
from numpy.typing import ArrayLike

from ...c_space import Slide, slide
from ...errors import KinoeduError
from ...geometry.checks import Array, as_points
from ...geometry.polygons import nearest_on_ring
from ...messages import get_message
from ..core.canvas import Canvas
from ..core.drawing import Drawing, Layer, bodies, dots, edges, labels, segments_along, sides_of
from ..core.framed import Framed, control_style
from ..core.scene import Scene, handle, make_scene, mark_drawn, polygon

NOTCH = 0.002  # of the slider
CONTACTS = {"EV": "slide_board.ev", "VE": "slide_board.ve", "EE": "slide_board.ee"}


def slide_board(robot_vertices: ArrayLike, obstacle_vertices: ArrayLike) -> SlideBoard:
    """Slide a convex robot, which does not turn, round a convex obstacle.

    Move it by the slider, or drag its reference point q, which traces the C-obstacle. The text
    names the features in contact. The vertices of both polygons can be dragged; those of the robot
    on its copy at the left. Dragging the whole copy moves it relative to its reference point.

    Parameters
    ----------
    robot_vertices : (n, 2), a convex polygon with the reference point at the origin.
    obstacle_vertices : (m, 2), a convex polygon.

    Returns
    -------
    SlideBoard
        `slide` is the path round the obstacle, `share` the fraction of it that was driven, 0 to 1.

    Raises
    ------
    InvalidPolygon, InvalidPoint

    Examples
    --------
    >>> slide_board([(0, 0), (1, 0), (0, 1)], [(2, 2), (4, 2), (4, 3), (2, 3)])
    SlideBoard(edge-vertex contact (EV): edge 0 of the robot slides along vertex 0 of the obstacle)
    """
    return SlideBoard(robot_vertices, obstacle_vertices)


class SlideBoard(Framed):
    """The widget that `slide_board` returns: the slider `gone`, and the picture in `canvas`."""

    def __init__(self, robot_vertices: ArrayLike, obstacle_vertices: ArrayLike) -> None:
        self.slide, self.share = slide(robot_vertices, obstacle_vertices), 0.0
        self._home = place_copy(self.slide)
        scene = make_slide_scene(self.slide, self._home)
        self._placed = scene["handles"][0]["at"]
        self.gone = widgets.FloatSlider(
            0.0,
            min=0.0,
            max=1.0,
            step=NOTCH,
            readout_format=".0%",
            **control_style("slide_board.gone"),
        )
        super().__init__([self.gone], [Canvas(scene, self.answer)])
        self.canvas.observe(self._let_go, "scene")

    def _changed(self, change: Any) -> None:
        """Follow the slider, unless the browser has only rounded it to a notch."""
        if abs(change["new"] - self.share) > 0.51 * NOTCH:
            self.share = float(change["new"])
            self.canvas.refresh()

    def _let_go(self, _: object) -> None:
        """Move the slider once, when the dragged point is released.

        While the point is dragged the slider's own messages would come back late.
        """
        self.gone.value = round(self.share / NOTCH) * NOTCH

    def answer(self, scene: Scene) -> Drawing:
        """Put the robot in contact at q's place or the slider's, and draw both polygons."""
        obstacle, shown = (as_points(item["rings"][0], item["name"]) for item in scene["polygons"])
        pattern = draw_copy(shown, self._home)
        try:
            self.slide = slide(shown - self._home, obstacle)
        except KinoeduError as error:
            return Drawing(pattern, warning=str(error))
        at = scene["handles"][0]["at"]
        if at != self._placed:
            self.share = fraction_at(self.slide, at)
        q, stretch = self.slide.at(self.share)
        self._placed = q.tolist()
        layers = [
            *pattern,
            number_vertices(self.slide.robot + self._home, "ink"),
            *draw_boundary(self.slide, q, stretch),
            *draw_contact(self.slide, q, stretch),
        ]
        text, places = describe_contact(self.slide, stretch), [("handle", 0, self._placed)]
        return Drawing(layers, text=text, places=places)


def place_copy(path: Slide) -> Array:
    """The reference point of the robot's copy, which stands to the left of everything else."""
    reach = path.corners.min(axis=0) + path.robot.min(axis=0)
    gap = 0.25 * np.ptp(path.corners, axis=0).max()
    middle = path.obstacle.mean(axis=0) - path.robot.mean(axis=0)
    return np.array([reach[0] - gap - path.robot[:, 0].max(), middle[1]])


def make_slide_scene(path: Slide, home: Array) -> Scene:
    """The obstacle, the robot's copy beside it, and the reference point of the sliding robot."""
    robot = path.robot + home
    swept = np.concatenate(
        [path.corners + corner for corner in (path.robot.min(axis=0), path.robot.max(axis=0))]
    )
    shown = np.concatenate([swept, path.corners, path.obstacle, robot, home[None]])
    lo, hi = shown.min(axis=0), shown.max(axis=0)
    margin = 0.05 * (hi - lo).max()
    return make_scene(
        lo - margin,
        hi + margin,
        handles=[mark_drawn(handle(get_message("slide_board.q"), path.corners[0], colour="robot"))],
        polygons=[
            polygon(get_message("slide_board.obstacle"), [path.obstacle]),
            mark_drawn(polygon(get_message("slide_board.robot"), [robot])),
        ],
    )


def fraction_at(path: Slide, p: ArrayLike) -> float:
    """The fraction of the way at which the reference point is nearest to p."""
    x, y = np.asarray(p, float)
    stretch, nx, ny, _ = nearest_on_ring(x, y, path.corners)
    travelled = path.lengths[:stretch].sum() + np.hypot(
        nx - path.corners[stretch, 0], ny - path.corners[stretch, 1]
    )
    return float(min(travelled / path.lengths.sum(), 1.0))


def describe_contact(path: Slide, stretch: int) -> str:
    """The features in contact in a stretch, in words."""
    parts = {"robot": path.robot_part[stretch], "obstacle": path.obstacle_part[stretch]}
    return get_message(CONTACTS[str(path.kind[stretch])], **parts)


def draw_copy(ring: Array, home: Array) -> list[Layer]:
    """Draw the robot's copy: its vertices, which can be dragged, and its reference point."""
    return [
        bodies([ring], "robot"),
        dots(ring, "obstacle", radius=5.0),
        dots(ring, "free", radius=3.5),
        dots([home], "ink", radius=4.0),
        labels([below(ring)], [get_message("slide_board.point")], "ink"),
    ]


def number_vertices(ring: Array, colour: str) -> Layer:
    """The numbers of a ring's vertices, beside them."""
    return labels(ring, [str(i) for i in range(len(ring))], colour)


def below(ring: Array) -> Array:
    """A place under a ring, away from its vertices' numbers."""
    return np.array([ring[:, 0].min(), ring[:, 1].min() - 0.55 * np.ptp(ring[:, 1])])


def draw_boundary(path: Slide, q: Array, stretch: int) -> list[Layer]:
    """Draw the boundary of the C-obstacle dashed, and the part traced so far."""
    legs = segments_along(np.vstack([path.corners[: stretch + 1], q]))
    return [
        edges(sides_of(path.corners), "ink", width=1.5, dash=(5.0, 5.0)),
        edges(legs, "ink", width=6.0),
        edges(legs, "path", width=4.0),
    ]


def draw_contact(path: Slide, q: Array, stretch: int) -> list[Layer]:
    """Draw the robot in contact, the touching features, and the obstacle's vertex numbers."""
    robot, sides = path.robot + q, str(path.kind[stretch])
    return [
        bodies([robot], "robot"),
        draw_feature(robot, path.robot_part[stretch], sides[0]),
        draw_feature(path.obstacle, path.obstacle_part[stretch], sides[1]),
        number_vertices(path.obstacle, "obstacle"),
        dots([q], "free", radius=9.0),
        dots([q], "path", radius=7.0),
        labels([q], [get_message("slide_board.q")], "ink"),
    ]


def draw_feature(ring: Array, part: int, side: str) -> Layer:
    """A vertex "V" or an edge "E" of a ring that touches something."""
    if side == "V":
        return dots([ring[part]], "contact", radius=7.0)
    return edges([[ring[part], ring[(part + 1) % len(ring)]]], "contact", width=6.0)

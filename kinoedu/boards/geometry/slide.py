"""The board of a robot that slides round an obstacle: its reference point traces the C-obstacle.
LaValle, section 4.3.2.
"""

from typing import Any

import ipywidgets as widgets
import numpy as np
from numpy.typing import ArrayLike

from ...c_space import Slide, slide
from ...errors import KinoeduError
from ...geometry.checks import Array, as_points
from ...geometry.polygons import nearest_on_ring
from ...words import say
from ..core.canvas import Canvas, with_picture
from ..core.controls import look
from ..core.drawing import Drawing, Layer, bodies, dots, edges, labels
from ..core.scene import Scene, drawn, handle, make_scene, polygon

NOTCH = 0.002  # of the slider
CONTACTS = {"EV": "slide_board.ev", "VE": "slide_board.ve", "EE": "slide_board.ee"}


def slide_board(robot_vertices: ArrayLike, obstacle_vertices: ArrayLike) -> "SlideBoard":
    """Slide a convex robot, which does not turn, round a convex obstacle, by the slider or by
    dragging its reference point q, which traces the C-obstacle. The vertices of both polygons can
    be dragged; the words say what touches what.

    Parameters
    ----------
    robot_vertices : (n, 2), its reference point at the origin. obstacle_vertices : (m, 2). Both
    convex polygons, as for `slide`.

    The robot stands once more to the left, where its vertices are dragged; dragged whole, it moves
    away from its reference point. `board.slide` is the way on show, `board.share` how much of it
    has been gone, from 0 to 1. Raises InvalidPolygon, InvalidPoint.

    >>> slide_board([(0, 0), (1, 0), (0, 1)], [(2, 2), (4, 2), (4, 3), (2, 3)])
    SlideBoard(edge-vertex contact (EV): edge 0 of the robot slides along vertex 0 of the obstacle)
    """
    return SlideBoard(robot_vertices, obstacle_vertices)


class SlideBoard(widgets.VBox):
    """What `slide_board` makes: the slider `gone`, and the picture in `canvas`."""

    def __init__(self, robot_vertices: ArrayLike, obstacle_vertices: ArrayLike) -> None:
        self.slide, self.share = slide(robot_vertices, obstacle_vertices), 0.0
        self._home = home_of(self.slide)
        scene = scene_of(self.slide, self._home)
        self._placed = scene["handles"][0]["at"]
        self.gone = widgets.FloatSlider(
            0.0,
            min=0.0,
            max=1.0,
            step=NOTCH,
            readout_format=".0%",
            **{**look("step"), "description": say("slide_board.gone")},
        )
        self.canvas = Canvas(scene, self.answer)
        super().__init__([self.gone, self.canvas])
        self.gone.observe(self._slid, "value")
        self.canvas.observe(self._let_go, "scene")

    def _slid(self, change: Any) -> None:
        """The slider was moved; unless the browser has only set it to a notch."""
        if abs(change["new"] - self.share) > 0.51 * NOTCH:
            self.share = float(change["new"])
            self.canvas.refresh()

    def _let_go(self, _: Any) -> None:
        """What was dragged is let go: the slider goes there, once, since what it says while it
        follows comes back late.
        """
        self.gone.value = round(self.share / NOTCH) * NOTCH

    def answer(self, scene: Scene) -> Drawing:
        """Put the robot of a scene in contact with its obstacle, where q was dragged or the slider
        is, and draw them.
        """
        obstacle, shown = (as_points(item["rings"][0], item["name"]) for item in scene["polygons"])
        pattern = pattern_drawn(shown, self._home)
        try:
            self.slide = slide(shown - self._home, obstacle)
        except KinoeduError as error:
            return Drawing(pattern, warning=str(error))
        at = scene["handles"][0]["at"]
        if at != self._placed:
            self.share = share_at(self.slide, at)
        q, stretch = self.slide.at(self.share)
        self._placed = q.tolist()
        pattern.append(
            labels(
                self.slide.robot + self._home, [str(i) for i in range(len(self.slide.robot))], "ink"
            )
        )
        layers = [
            *pattern,
            *way_drawn(self.slide, q, stretch),
            *contact_drawn(self.slide, q, stretch),
        ]
        return Drawing(
            layers, text=contact_said(self.slide, stretch), places=[("handle", 0, self._placed)]
        )

    def picture(self) -> bytes:
        """The board as it is now, as a PNG."""
        return self.canvas.picture()

    def __repr__(self) -> str:
        return f"SlideBoard({self.canvas.drawing.says})"

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        return with_picture(super()._repr_mimebundle_(**kwargs), self, self)


def home_of(way: Slide) -> Array:
    """Where the reference point of the robot is that stands beside the obstacle, to the left of all
    that slides.
    """
    reach, gap = (
        way.corners.min(axis=0) + way.robot.min(axis=0),
        0.25 * np.ptp(way.corners, axis=0).max(),
    )
    middle = way.obstacle.mean(axis=0) - way.robot.mean(axis=0)
    return np.array([reach[0] - gap - way.robot[:, 0].max(), middle[1]])


def scene_of(way: Slide, home: Array) -> Scene:
    """Obstacle, the robot beside it, and the reference point of the one that slides."""
    robot = way.robot + home
    swept = np.concatenate(
        [way.corners + corner for corner in (way.robot.min(axis=0), way.robot.max(axis=0))]
    )
    shown = np.concatenate([swept, way.corners, way.obstacle, robot, home[None]])
    lo, hi = shown.min(axis=0), shown.max(axis=0)
    margin = 0.05 * (hi - lo).max()
    return make_scene(
        lo - margin,
        hi + margin,
        handles=[drawn(handle(say("slide_board.q"), way.corners[0], colour="robot"))],
        polygons=[
            polygon(say("slide_board.obstacle"), [way.obstacle]),
            drawn(polygon(say("slide_board.robot"), [robot])),
        ],
    )


def share_at(way: Slide, p: ArrayLike) -> float:
    """The share of the way after which the reference point is nearest to p."""
    x, y = np.asarray(p, float)
    stretch, nx, ny, _ = nearest_on_ring(x, y, way.corners)
    gone = way.lengths[:stretch].sum() + np.hypot(
        nx - way.corners[stretch, 0], ny - way.corners[stretch, 1]
    )
    return float(min(gone / way.lengths.sum(), 1.0))


def contact_said(way: Slide, stretch: int) -> str:
    """What touches what in a stretch, in words."""
    return say(
        CONTACTS[str(way.kind[stretch])],
        robot=way.robot_part[stretch],
        obstacle=way.obstacle_part[stretch],
    )


def pattern_drawn(ring: Array, home: Array) -> list[Layer]:
    """The robot that stands beside: its vertices, which can be dragged, and its reference point."""
    return [
        bodies([ring], "robot"),
        dots(ring, "obstacle", radius=5.0),
        dots(ring, "free", radius=3.5),
        dots([home], "ink", radius=4.0),
        labels([below(ring)], [say("slide_board.point")], "ink"),
    ]


def below(ring: Array) -> Array:
    """A place under a ring, off its vertices' numbers."""
    return np.array([ring[:, 0].min(), ring[:, 1].min() - 0.55 * np.ptp(ring[:, 1])])


def way_drawn(way: Slide, q: Array, stretch: int) -> list[Layer]:
    """The whole boundary of the C-obstacle dashed, and what of it has been traced."""
    whole = np.stack([way.corners, np.roll(way.corners, -1, axis=0)], axis=1)
    traced = np.vstack([way.corners[: stretch + 1], q])
    legs = np.stack([traced[:-1], traced[1:]], axis=1)
    return [
        edges(whole, "ink", width=1.5, dash=(5.0, 5.0)),
        edges(legs, "ink", width=6.0),
        edges(legs, "path", width=4.0),
    ]


def contact_drawn(way: Slide, q: Array, stretch: int) -> list[Layer]:
    """The robot in contact, what of both touches in black, and the numbers of the obstacle's
    vertices.
    """
    robot, sides = way.robot + q, str(way.kind[stretch])
    return [
        bodies([robot], "robot"),
        part_drawn(robot, way.robot_part[stretch], sides[0]),
        part_drawn(way.obstacle, way.obstacle_part[stretch], sides[1]),
        labels(way.obstacle, [str(i) for i in range(len(way.obstacle))], "obstacle"),
        dots([q], "free", radius=9.0),
        dots([q], "path", radius=7.0),
        labels([q], [say("slide_board.q")], "ink"),
    ]


def part_drawn(ring: Array, part: int, side: str) -> Layer:
    """A vertex "V" or an edge "E" of a ring that touches something."""
    if side == "V":
        return dots([ring[part]], "contact", radius=7.0)
    return edges([[ring[part], ring[(part + 1) % len(ring)]]], "contact", width=6.0)

"""The board of solids: a mesh to turn and to cut, and the meaning of the cut in the plane.

The browser turns the mesh, moves the plane and drags the point; Python answers with the trait
`section`: {theta, place, text, shapes}, each shape a list of points with colours. Only one
question is open at a time, and each is answered, also where the answer fails.
"""

from __future__ import annotations

import logging
from collections.abc import Callable
from pathlib import Path
from textwrap import fill
from typing import TYPE_CHECKING, Any

import anywidget
import numpy as np
import traitlets
from numpy.typing import ArrayLike

from ...c_space import translating_obstacles, turned, turning_obstacle
from ...errors import InvalidParameter, KinoeduError
from ...figures import palette
from ...figures.names import without_formulas
from ...figures.solid import cut_mesh, draw_mesh, shade_faces
from ...figures.style import as_png, keep_few_colours
from ...geometry import convex_polygons_intersect
from ...geometry.checks import Array, as_array, as_point
from ...geometry.convex import convex_parts
from ...geometry.rings import as_ring
from ...messages import get_message
from ...support.json_fields import JsonObject
from ...support.text import shortened
from ..core.canvas import front_messages, widget_script, widget_style
from ..core.printed import SHARP, render
from ..core.stored import Stored

if TYPE_CHECKING:
    from trimesh import Trimesh

log = logging.getLogger("kinoedu")

MOST = 40_000  # the most triangles that a browser can paint while they are turned
FRONT: dict[str, tuple[str, ...]] = {  # the messages that the browser shows, and their values
    **dict.fromkeys(("theta", "hint"), ()),
    "solid": ("azimuth", "height", "theta"),
    "slice": ("theta",),
}
Section = Callable[[float, Array], dict[str, Any]]


def shape(
    points: ArrayLike, fill: str = "", line: str = "", *, alpha: float = 1.0, closed: bool = True
) -> JsonObject:
    """A polygon or line of a section, (n, 2); fill and line are names of colours, "" for none."""
    return {
        "points": np.asarray(points, float).tolist(),
        "fill": fill,
        "line": line,
        "alpha": alpha,
        "closed": closed,
    }


def solid_board(
    mesh: Trimesh,
    *,
    section: Section | None = None,
    theta: float = 0.0,
    place: ArrayLike | None = None,
) -> SolidBoard:
    """A mesh in (x, y, theta) to turn by dragging, wheel or keys, and a plane that cuts it.

    The cut is shown beside the mesh.

    Parameters
    ----------
    mesh : a trimesh.Trimesh of at most 40,000 triangles, drawn in its own face colours where it has
        any.
    section : a function f(theta, place) -> {"text": words, "shapes": [shape(...), ...]} that says
        what the plane shows; by default the cut.
    theta : the first height of the plane.
    place : (2,), the point in the plane that can be dragged; None for no point.

    Raises
    ------
    InvalidParameter, InvalidPoint
    """
    return SolidBoard(mesh, section, theta, place)


def turning_board(
    robot_vertices: ArrayLike,
    obstacle: ArrayLike,
    *,
    theta: float = 0.0,
    place: ArrayLike | None = None,
) -> SolidBoard:
    """The C-obstacle of a polygon that turns, and the workspace at the plane's heading.

    The robot in the workspace can be dragged.

    Parameters
    ----------
    robot_vertices : (n, 2), with the reference point at the origin.
    obstacle : (m, 2).
    theta : the first heading.
    place : (2,), the first place of the reference point.

    Raises
    ------
    InvalidPolygon, InvalidPoint

    Examples
    --------
    >>> turning_board([(0, 0), (2, 0), (0, 1)], [(3, 3), (6, 3), (6, 5), (3, 5)], place=(4, 4))
    SolidBoard(θ = 0°: the robot touches the obstacle with its reference point at (4, 4))
    """
    robot, solid = as_ring(robot_vertices, "robot"), as_ring(obstacle, "obstacle")
    mesh = turning_obstacle(robot, solid)
    here = mesh.bounds[0, :2] if place is None else place
    return SolidBoard(
        mesh, lambda theta, place: workspace_section(robot, solid, theta, place), theta, here
    )


def workspace_section(robot: Array, obstacle: Array, theta: float, place: Array) -> JsonObject:
    """The workspace at one heading: C-obstacle slice, obstacle, robot, and exact contact."""
    body = turned(robot, theta)
    touches = any(
        convex_polygons_intersect(p + place, q)
        for p in convex_parts(body)
        for q in convex_parts(obstacle)
    )
    grown = [
        shape(part, "outside", "", alpha=0.4) for part in translating_obstacles(body, [obstacle])
    ]
    state, degrees = "touches" if touches else "clear", f"{np.degrees(theta):.0f}"
    x, y = (f"{value:.3g}" for value in place)
    return {
        "text": get_message(
            "c_space.section", theta=degrees, state=get_message(f"c_space.{state}"), x=x, y=y
        ),
        "shapes": [
            *grown,
            shape(obstacle, "obstacle", ""),
            shape(body + place, "robot", "robot", alpha=0.5),
        ],
    }


class SolidBoard(Stored, anywidget.AnyWidget):
    """The widget that `solid_board` returns.

    Set `theta` and `place` to move the plane and the point.
    """

    _esm = widget_script(Path(__file__).with_name("solid.js"))
    _css = widget_style(Path(__file__).with_name("solid.css"))
    vertices = traitlets.Bytes().tag(sync=True)
    faces = traitlets.Bytes().tag(sync=True)
    colours = traitlets.Bytes().tag(sync=True)
    theta = traitlets.Float().tag(sync=True)
    place: Any = traitlets.List(allow_none=True, default_value=None).tag(sync=True)
    section = traitlets.Dict().tag(sync=True)
    cut: Any = traitlets.List().tag(sync=True)
    box: Any = traitlets.List().tag(sync=True)
    palette = traitlets.Dict().tag(sync=True)
    words = traitlets.Dict().tag(sync=True)

    def __init__(
        self, mesh: Trimesh, section: Section | None, theta: float, place: ArrayLike | None
    ) -> None:
        if not hasattr(mesh, "triangles") or not 0 < len(mesh.faces) <= MOST:
            raise InvalidParameter(
                f"a board needs a mesh of 1 to {MOST:,} triangles, got {shortened(mesh)}"
            )
        self._mesh, self._section = mesh, section or self._outline
        here = None if place is None else as_point(place, "place").tolist()
        angle = as_array(theta, "theta")
        if angle.ndim:
            raise InvalidParameter(f"theta must be one angle, got {theta!r}")
        colours = 255.0 * np.broadcast_to(shade_faces(mesh), (len(mesh.faces), 3))
        super().__init__(
            vertices=np.asarray(mesh.vertices, np.float32).tobytes(),
            faces=np.asarray(mesh.faces, np.uint32).tobytes(),
            colours=colours.astype(np.uint8).tobytes(),
            box=mesh.bounds.tolist(),
            theta=float(angle),
            place=here,
            palette=palette.THEMES,
            words=front_messages("c_space.front", FRONT),
        )
        self.observe(lambda _: self._answer(), ["theta", "place"])
        self._answer()

    def set_state(self, sync_data: JsonObject) -> None:
        """Accept from a page only valid places of the plane and of the point."""
        checked: dict[str, Any] = {}
        try:
            if "theta" in sync_data:
                checked["theta"] = self._nearest(as_array([sync_data["theta"]], "theta").item())
            if "place" in sync_data and self.place is not None:
                checked["place"] = as_point(sync_data["place"], "place").tolist()
        except (KinoeduError, ValueError) as error:
            log.warning("a board was sent a place that it cannot show: %s", error)
        try:
            super().set_state(checked)
        except BaseException as error:  # a reader's section fails, or is interrupted: a page waits
            log.exception("a board could not answer")
            fault = get_message("board.failed", error=f"{type(error).__name__}: {error}")
            self.section = {**self._asked(), "text": fault, "shapes": []}
            if not isinstance(error, Exception):
                raise

    def _nearest(self, theta: float) -> float:
        """The height of the solid that is nearest to an angle."""
        return float(np.clip(theta, *self._mesh.bounds[:, 2]))

    @traitlets.validate("theta")
    def _within(self, proposal: Any) -> float:
        return self._nearest(as_array(proposal["value"], "theta").item())

    @traitlets.validate("place")
    def _point(self, proposal: Any) -> list[float] | None:
        value = proposal["value"]
        return value if value is None else as_point(value, "place").tolist()

    def _asked(self) -> JsonObject:
        """The plane and the point that an answer is about."""
        return {"theta": self.theta, "place": self.place}

    def _answer(self) -> None:
        """Compute what the plane shows now; once where plane and point have both moved."""
        if {**self.section, **self._asked()} == self.section:
            return
        place = np.array((0.0, 0.0) if self.place is None else self.place)
        with self.hold_sync():
            if self.section.get("theta") != self.theta:
                self.cut = cut_mesh(self._mesh, self.theta)[:, :, :2].tolist()
            self.section = {**self._section(self.theta, place), **self._asked()}

    def _outline(self, theta: float, _: Array) -> JsonObject:
        """The cut itself, as a section."""
        lines = [
            shape(line[:, :2], line="cut", closed=False) for line in cut_mesh(self._mesh, theta)
        ]
        return {
            "text": get_message("c_space.nothing", theta=f"{np.degrees(theta):.0f}"),
            "shapes": lines,
        }

    def picture(self) -> bytes:
        """The board as it is now, as a PNG."""
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
        from matplotlib.patches import Polygon

        # Without a layout engine, which would overestimate the box of the solid.
        figure = Figure(figsize=(11.0, 5.0), dpi=60 * SHARP)
        FigureCanvasAgg(figure)
        left = figure.add_axes((0.0, 0.02, 0.5, 0.96), projection="3d")
        draw_mesh(self._mesh, left, theta=self.theta)
        ax = figure.add_axes((0.54, 0.08, 0.44, 0.76), aspect="equal")
        named = {"": "none", **palette.NAMED}
        for part in self.section["shapes"]:
            style = {
                "closed": part["closed"],
                "facecolor": named[part["fill"]] if part["closed"] else "none",
                "alpha": part["alpha"],
            }
            ax.add_patch(Polygon(part["points"], edgecolor=named[part["line"]], **style))
        for line in self.cut:
            ax.plot(*np.transpose(line), color=palette.CUT, linewidth=2.0)
        if self.place is not None:
            dot: palette.Style = {"color": palette.INK, "markersize": 9, "zorder": 9}
            left.plot(*self.place, self.theta, "o", **dot)
            ax.plot(*self.place, "o", **dot, **palette.RIM)
        ax.autoscale_view()
        ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
        text = without_formulas(fill(self.section["text"], 44))
        ax.set_title(text, fontsize=palette.TEXT_SIZE)
        return as_png(keep_few_colours(render(figure).convert("RGB")))

    def __repr__(self) -> str:
        return f"SolidBoard({self.section['text']})"

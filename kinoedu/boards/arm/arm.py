"""The arm's board: a two-link arm among obstacles, and its configuration space as a square.

The square is the torus of the two angles, painted again when obstacles move.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import ipywidgets as widgets
import numpy as np
from numpy.typing import ArrayLike

from ...browser.arms import ShownArm, pose_arm
from ...browser.bodies import ARM
from ...browser.regions import name_regions
from ...collision import paint_configuration_space
from ...geometry.checks import Array
from ...messages import get_message
from ...planners import rrt
from ...planners.tuning import integer
from ...problems import Plan
from ...problems.configurations import as_configuration, space_of
from ...robots.arm import ArmRobot, check_arm
from ...robots.pulling import pull_arm
from ...support.json_fields import JsonObject
from ...worlds.checks import World
from ...worlds.polygon_world import PolygonWorldRecord
from ..core.canvas import Canvas
from ..core.drawing import Drawing, Layer, bodies, encode_drawing
from ..core.framed import Pictured, arrange_in_row
from ..core.printed import join_pictures
from ..core.recorded import record_drawing
from ..core.scene import Scene, frame_of, handle, mark_drawn
from ..core.shown import draw_beside, draw_shown, make_live
from ..planning.own import Attempt
from ..planning.plans import make_canvas, make_world_scene, world_in
from .arm_drawn import link_outlines
from .glued import draw_frame, make_square_scene
from .rides import Ride, draw_ride_in_square, draw_ride_in_workspace, plan_ride

ELBOW, TIP = 0, 1  # the numbers of the workspace's handles; the square's are q and the goal


def arm_board(
    arm: ArmRobot,
    world: World,
    q: ArrayLike = (0.0, 0.0),
    *,
    goal: ArrayLike | None = None,
    planner: Callable[..., object] = rrt,
    rng: int = 0,
) -> ArmBoard:
    """Drag an arm's elbow or tip, or its configuration q in the square of its two angles.

    Drag an obstacle, and the free space is painted again. A tip pulled out of reach goes to the
    nearest reachable place, by the solution nearer to q.

    Parameters
    ----------
    arm : TwoLinkArm(l1, l2, width).
    world : PolygonWorld(...), whose obstacles and vertices can be dragged, or Terrain(...).
    q : the first configuration (theta1, theta2) in radians; contact is allowed.
    goal : a configuration. With one, the board plans from q to it, and the growth slider moves the
        arm along the path.
    planner : rrt, prm, or a function of yours, `f(problem)` or `f(problem, rng)`, which is stopped
        after two seconds.
    rng : its seed.

    Returns
    -------
    ArmBoard
        `q`, `goal`, `world`, `plan` and `image`, from `paint_configuration_space`, are shown.

    Raises
    ------
    InvalidRobot, InvalidPoint

    Examples
    --------
    >>> from kinoedu import PolygonWorld, TwoLinkArm
    >>> world = PolygonWorld([(-4, -4), (4, -4), (4, 4), (-4, 4)], [((2, 1), 0.5)])
    >>> arm_board(TwoLinkArm(1.5, 1.2, 0.2), world, q=(0.6, 0))
    ArmBoard(q = (0.60, 0.00): link 2 is in contact)
    """
    return ArmBoard(arm, world, q, goal, planner, rng)


class ArmBoard(Pictured, widgets.VBox):
    """The widget that `arm_board` returns: the workspace in `canvas`, the torus in `square`."""

    def __init__(
        self,
        arm: ArmRobot,
        world: World,
        q: ArrayLike,
        goal: ArrayLike | None,
        planner: Callable[..., object],
        rng: int,
    ) -> None:
        check_arm(arm)
        space = space_of(arm, world)
        self.arm, self.world = arm, world
        self.image = paint_configuration_space(arm, world)
        self._names = name_regions(self.image)
        self.q = as_configuration(q, space, "q")
        self.goal = None if goal is None else as_configuration(goal, space, "goal")
        self._planner, self._seed = planner, integer(rng, "rng", least=0)
        self._ride: Ride | None = None
        self._plan_anew()
        scene, plane = make_world_scene(world, self._grips()), make_square_scene(self._spots())
        self._standing = obstacle_places(scene)
        self._gripped, self._spotted = handle_places(scene), handle_places(plane)
        self.square = Canvas(plane, self._in_square, free=self.image)
        self.canvas = make_canvas(world, scene, self.answer)
        self.square.partner = self.canvas.key
        self.canvas.observe(lambda _: self.square.keep(), "scene")
        self.square.observe(lambda _: self.canvas.keep(), "scene")
        super().__init__([arrange_in_row([self.canvas, self.square], width="20em")])

    @property
    def plan(self) -> Plan | Attempt | None:
        """The plan shown; an Attempt for a reader's planner, None without a problem to solve."""
        return None if self._ride is None else self._ride.plan

    def answer(self, scene: Scene) -> Drawing:
        """Take over what was moved in the workspace, update the square, and draw the arm."""
        shown = self._posed(self._take(scene))
        status, *facts = shown.facts.tolist()
        drawing = draw_shown(ARM, int(status), facts, shown)
        layers: list[Layer] = []
        if self.goal is not None:
            layers.append(bodies(link_outlines(self.arm, self.goal), "goal"))
        layers += draw_ride_in_workspace(self.arm, self._ride) if self._ride else []
        layers += drawing.layers
        self._gripped = [at for _, _, at in drawing.places]
        lines = (drawing.text, self._ride.text if self._ride else "")
        return self._drawn(layers, "\n".join(filter(None, lines)), self._gripped)

    def _posed(self, tip: Array) -> ShownArm:
        """What is shown of the arm, whose tip was pulled to a place."""
        return pose_arm(self.arm, self.world, self.q, tip, self._names, np.empty((0, 0)))

    def _in_square(self, scene: Scene) -> Drawing:
        """Take over what was moved in the square, update the workspace, and draw on the image."""
        at = handle_places(scene)
        if at != self._spotted:
            space = space_of(self.arm, self.world)
            self.q = as_configuration(at[0], space, "q")
            self.goal = None if self.goal is None else as_configuration(at[1], space, "goal")
            self._plan_anew()
            self.canvas.refresh()
        shown = self._posed(self.arm.joints(self.q)[1])
        status, *facts = shown.facts.tolist()
        drawing = draw_beside(ARM, int(status), facts, shown)
        layers = [*draw_frame(), *drawing.layers]
        layers += draw_ride_in_square(self._ride) if self._ride else []
        self._spotted = [q.tolist() for q in (self.q, self.goal) if q is not None]
        return self._drawn(layers, drawing.text, self._spotted)

    def _take(self, scene: Scene) -> Array:
        """Take over what was moved in the workspace; returns where the tip was pulled to.

        Its own place, if only the elbow was pulled or nothing.
        """
        now, at = obstacle_places(scene), handle_places(scene)
        if now == self._standing and at == self._gripped:
            return self.arm.joints(self.q)[1]
        if now != self._standing:
            self.world = world_in(scene)
            self.image = paint_configuration_space(self.arm, self.world)
            self._names = name_regions(self.image)
            self.square.set_bitmap(self.image)
            self._standing = now
        pulls = [
            None if here == before else np.array(here)
            for here, before in zip(at, self._gripped, strict=True)
        ]
        self.q = pull_arm(self.arm, self.q, pulls[ELBOW], pulls[TIP])
        self._plan_anew()
        self.square.refresh()
        pulled = pulls[TIP] if pulls[ELBOW] is None else None
        return self.arm.joints(self.q)[1] if pulled is None else pulled

    def _plan_anew(self) -> None:
        """Plan if there is a goal.

        A reader's planner that could not be stopped is not started again.
        """
        stuck = self._ride is not None and getattr(self._ride.plan, "still_running", False)
        if self.goal is None or stuck:
            return
        self._ride = plan_ride(self._planner, self.arm, self.world, (self.q, self.goal), self._seed)

    def _drawn(self, layers: list[Layer], text: str, handles: list[Any]) -> Drawing:
        """A drawing of either picture, with the steps of the ride and the handles' places."""
        places = [("handle", number, place) for number, place in enumerate(handles)]
        stops = self._ride.stops.tolist() if self._ride else []
        texts = [
            get_message("arm_board.riding", first=f"{first:.2f}", second=f"{second:.2f}")
            for first, second in stops
        ]
        total, unit = max(len(texts) - 1, 0), get_message("arm_board.unit")
        drawing = Drawing(layers, text=text, total=total, unit=unit)
        return replace(drawing, step_texts=texts, places=places)

    def _grips(self) -> list[JsonObject]:
        """The workspace's handles: elbow and tip."""
        names = (get_message("arm_board.elbow"), get_message("arm_board.tip"))
        return [
            mark_drawn(handle(name, at, colour="ink"))
            for name, at in zip(names, self.arm.joints(self.q), strict=True)
        ]

    def _spots(self) -> list[JsonObject]:
        """The square's handles: q, and the goal where there is one."""
        handles = [handle(get_message("arm_board.q"), self.q, colour="ink")]
        if self.goal is not None:
            goal = handle(get_message("arm_board.goal"), self.goal, colour="goal", marker="star")
            handles.append(goal)
        return handles

    def record(self) -> list[JsonObject]:
        """Both pictures as they are now; without a goal, among polygons, a page answers them."""
        self.canvas.live = self.square.live = None
        rooms = any(len(item["rings"]) > 1 for item in self.canvas.shown["polygons"])
        if self.goal is None and not rooms and isinstance(self.world, PolygonWorldRecord):
            width = 2.0 * self.arm.shape.radius[0]
            settings = [*self.arm.lengths.tolist(), float(width), *self.arm.base.tolist()]
            spots = self.square.shown["handles"]
            frame = encode_drawing(Drawing([*draw_frame()]), *frame_of(self.square.shown))
            self.canvas.live = {**make_live("arm", settings), "beside": [*spots, *spots]}
            self.square.live = {"body": "arm", "under": record_drawing(*frame)}
        return super().record()

    def picture(self) -> bytes:
        """Workspace and square side by side, as a PNG."""
        return join_pictures(self.canvas.picture(), self.square.picture())


def obstacle_places(scene: Scene) -> list[Any]:
    """Where the obstacles of a scene are."""
    return [[item["rings"] for item in scene["polygons"]], [item["at"] for item in scene["discs"]]]


def handle_places(scene: Scene) -> list[Any]:
    """Where the handles of a scene are."""
    return [item["at"] for item in scene["handles"]]

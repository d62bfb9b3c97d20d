"""The arm's board: a two-link arm among obstacles, and beside it the torus of its configurations,
painted anew as they move.
"""

from collections.abc import Callable
from typing import Any

import ipywidgets as widgets
import numpy as np
from numpy.typing import ArrayLike

from ...collision import link_in_contact, paint_configuration_space
from ...collision.arms import check_arm
from ...planners import rrt
from ...planners.tuning import whole
from ...problems import Plan
from ...problems.configurations import as_configuration, space_of
from ...robots import why_unreachable
from ...robots.arm import ArmRobot
from ...words import say
from ...worlds.terrain import TerrainRecord
from ..core.canvas import Canvas, with_picture
from ..core.drawing import Drawing, Layer, bodies
from ..core.printed import side_by_side
from ..core.scene import Scene, drawn, handle
from ..planning.own import Attempt
from ..planning.plans import scene_with, world_in
from .arm_drawn import arm_drawn, contact_said, links_in_contact, outlines
from .glued import frame, regions_named, sights, square_scene
from .pulling import pulled
from .rides import Ride, ride_in_square, ride_in_workspace, ride_of

ELBOW, TIP = 0, 1  # the numbers of the workspace's handles; the square's are q and the goal


def arm_board(
    arm: ArmRobot,
    world: Any,
    q: ArrayLike = (0.0, 0.0),
    *,
    goal: ArrayLike | None = None,
    planner: Callable[..., Any] = rrt,
    rng: int = 0,
) -> "ArmBoard":
    """Drag the elbow or the tip of an arm of two links, and see where its configuration q is in the
    square of its two angles; drag q, and see the arm. Drag an obstacle, and the free space is
    painted anew.

    Parameters
    ----------
    arm : TwoLinkArm(l1, l2, width). world : PolygonWorld(...), whose obstacles and their vertices
    can be dragged, or Terrain(...).
    q : where the arm begins, (theta1, theta2) in radians; in contact, too.
    goal : a configuration; with one the board plans from q to it, and the growth slider moves the
    arm along the path.
    planner : rrt, prm, or a function of yours, `f(problem)` or `f(problem, rng)`, which is stopped
    after two seconds.
    rng : its seed.

    A tip pulled out of reach goes to the nearest place within, by the solution nearer to q.
    `board.q`, `board.goal`, `board.world`, `board.image` (what `paint_configuration_space` paints)
    and `board.plan` are what is on show. Raises InvalidRobot, InvalidPoint.

    >>> from kinoedu import PolygonWorld, TwoLinkArm
    >>> world = PolygonWorld([(-4, -4), (4, -4), (4, 4), (-4, 4)], [((2, 1), 0.5)])
    >>> arm_board(TwoLinkArm(1.5, 1.2, 0.2), world, q=(0.6, 0))
    ArmBoard(q = (0.60, 0.00): link 2 is in contact)
    """
    return ArmBoard(arm, world, q, goal, planner, rng)


class ArmBoard(widgets.VBox):
    """What `arm_board` makes: the workspace in `canvas`, the torus laid flat in `square`."""

    def __init__(
        self,
        arm: ArmRobot,
        world: Any,
        q: ArrayLike,
        goal: ArrayLike | None,
        planner: Callable[..., Any],
        rng: int,
    ) -> None:
        check_arm(arm)
        space = space_of(arm, world)
        self.arm, self.world = arm, world
        self.image = paint_configuration_space(arm, world)
        self._names = regions_named(self.image)
        self.q = as_configuration(q, space, "q")
        self.goal = None if goal is None else as_configuration(goal, space, "goal")
        self._planner, self._seed = planner, whole(rng, "rng", least=0)
        self._ride: Ride | None = None
        self._plan_anew()
        scene, plane = scene_with(world, self._grips()), square_scene(self._spots())
        self._standing, self._gripped, self._spotted = (
            standing(scene),
            places_in(scene),
            places_in(plane),
        )
        self.square = Canvas(plane, self._in_square, free=self.image)
        self.canvas = Canvas(
            scene, self.answer, free=world.free if isinstance(world, TerrainRecord) else None
        )
        self.square.partner = self.canvas.key
        for picture in (self.canvas, self.square):
            picture.layout = widgets.Layout(flex="1 1 20em", min_width="0", padding="0 2px 0 0")
        super().__init__(
            [
                widgets.HBox(
                    [self.canvas, self.square],
                    layout=widgets.Layout(flex_flow="row wrap", grid_gap="8px"),
                )
            ]
        )

    @property
    def plan(self) -> Plan | Attempt | None:
        """The plan on show, of a reader's planner what came of it; None without a goal, or where
        none could be asked for.
        """
        return None if self._ride is None else self._ride.plan

    def answer(self, scene: Scene) -> Drawing:
        """Take what was moved in the workspace, tell the square of it, and draw the arm."""
        hindered = self._take(scene)
        hits = links_in_contact(self.arm, self.q, self.world)
        layers: list[Layer] = (
            [] if self.goal is None else [bodies(outlines(self.arm, self.goal), "goal")]
        )
        layers += ride_in_workspace(self.arm, self._ride) if self._ride else []
        layers += arm_drawn(self.arm, self.q, hits)
        first, second = (f"{angle:.2f}" for angle in self.q)
        text = say("arm_board.told", first=first, second=second, contact=contact_said(hits))
        self._gripped = [joint.tolist() for joint in self.arm.joints(self.q)]
        lines = (text, hindered, self._ride.text if self._ride else "")
        return self._drawn(layers, "\n".join(filter(None, lines)), self._gripped)

    def _in_square(self, scene: Scene) -> Drawing:
        """Take what was moved in the square, tell the workspace of it, and draw what lies over the
        painted picture.
        """
        at = places_in(scene)
        if at != self._spotted:
            space = space_of(self.arm, self.world)
            self.q = as_configuration(at[0], space, "q")
            self.goal = None if self.goal is None else as_configuration(at[1], space, "goal")
            self._plan_anew()
            self.canvas.refresh()
        layers = [
            *frame(),
            *self._names,
            sights(self.q),
            *(ride_in_square(self._ride) if self._ride else []),
        ]
        self._spotted = [q.tolist() for q in (self.q, self.goal) if q is not None]
        first, second = (f"{np.degrees(angle):.0f}" for angle in self.q)
        link = link_in_contact(self.arm, self.q, self.world)
        text = say(
            "arm_board.in_square", first=first, second=second, link=say(f"figure.link_{link}")
        )
        return self._drawn(layers, text, self._spotted)

    def _take(self, scene: Scene) -> str:
        """Take what was moved in the workspace; why the tip cannot be where it was pulled, or
        nothing.
        """
        now, at = standing(scene), places_in(scene)
        if now == self._standing and at == self._gripped:
            return ""
        if now != self._standing:
            self.world = world_in(scene)
            self.image = paint_configuration_space(self.arm, self.world)
            self._names = regions_named(self.image)
            self.square.lay(self.image)
            self._standing = now
        pulls = [
            None if here == before else np.array(here)
            for here, before in zip(at, self._gripped, strict=True)
        ]
        self.q = pulled(self.arm, self.q, pulls[ELBOW], pulls[TIP])
        self._plan_anew()
        self.square.refresh()
        tip = pulls[TIP] if pulls[ELBOW] is None else None
        reason = "" if tip is None else why_unreachable(self.arm, tip)
        return say("arm_board.out_of_reach", reason=reason) if reason else ""

    def _plan_anew(self) -> None:
        """Plan where there is a goal; a reader's planner that could not be stopped is not started
        again.
        """
        if self.goal is None or (
            self._ride is not None and getattr(self._ride.plan, "still_running", False)
        ):
            return
        self._ride = ride_of(self._planner, self.arm, self.world, (self.q, self.goal), self._seed)

    def _drawn(self, layers: list[Layer], text: str, handles: list[Any]) -> Drawing:
        """A drawing of either picture, with the steps of the ride, and the handles where they
        belong.
        """
        places = [("handle", number, place) for number, place in enumerate(handles)]
        stops = self._ride.stops.tolist() if self._ride else []
        told = [
            say("arm_board.riding", first=f"{first:.2f}", second=f"{second:.2f}")
            for first, second in stops
        ]
        return Drawing(
            layers,
            text=text,
            total=max(len(told) - 1, 0),
            unit=say("arm_board.unit"),
            told=told,
            places=places,
        )

    def _grips(self) -> list[dict[str, Any]]:
        """The workspace's handles: elbow and tip."""
        names = (say("arm_board.elbow"), say("arm_board.tip"))
        return [
            drawn(handle(name, at, colour="ink"))
            for name, at in zip(names, self.arm.joints(self.q), strict=True)
        ]

    def _spots(self) -> list[dict[str, Any]]:
        """The square's handles: q, and the goal where there is one."""
        q = handle(say("arm_board.q"), self.q, colour="ink")
        return (
            [q]
            if self.goal is None
            else [q, handle(say("arm_board.goal"), self.goal, colour="goal", marker="star")]
        )

    def picture(self) -> bytes:
        """Workspace and square beside each other, as a PNG."""
        return side_by_side(self.canvas.picture(), self.square.picture())

    def __repr__(self) -> str:
        return f"ArmBoard({self.canvas.drawing.says})"

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        return with_picture(super()._repr_mimebundle_(**kwargs), self, self)


def standing(scene: Scene) -> list[Any]:
    """Where the obstacles of a scene are."""
    return [[item["rings"] for item in scene["polygons"]], [item["at"] for item in scene["discs"]]]


def places_in(scene: Scene) -> list[Any]:
    """Where its handles are."""
    return [item["at"] for item in scene["handles"]]

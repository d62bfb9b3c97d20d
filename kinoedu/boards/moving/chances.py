"""The board of uncertain obstacles: a path with a bounded collision chance, tried in scenarios."""

from __future__ import annotations

from typing import Any

import ipywidgets as widgets
import numpy as np
from numpy.typing import ArrayLike

from ...chances import wilson_interval
from ...collision import collision_bound
from ...collision.probability import as_translating_robot, hit_scenarios, part_gaps
from ...errors import InvalidParameter, KinoeduError
from ...figures.uncertain import expected_outlines, margin_rings
from ...geometry.checks import Array
from ...messages import get_message
from ...planners import prm, shortcut
from ...planners.tuning import integer
from ...problems import Plan, Problem
from ...robots.kinds import Robot
from ...support.text import shortened
from ...worlds.polygon_world import rings_of
from ...worlds.uncertain import UncertainWorldRecord, inflated, scenarios
from ..core.canvas import Canvas
from ..core.drawing import Drawing, Layer, bodies, edges, path, sides_of
from ..core.framed import Framed, control_style, make_counter
from ..core.scene import Scene, handle, make_scene, place_of
from ..planning.plans import GOAL, START

SHOWN, TRIED = 60, 4000  # the numbers of scenarios drawn and tried
CHANCES = (0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.001, 0.0001)


def chance_board(
    robot: Robot,
    world: UncertainWorldRecord,
    start: ArrayLike,
    goal: ArrayLike,
    *,
    delta: float = 0.05,
    rng: int = 0,
) -> ChanceBoard:
    """Choose the chance delta; the margins follow, dashed, and so does the path.

    Drag start and goal. Scrub: each step is one scenario, in red where the path is hit.

    Parameters
    ----------
    robot : Point(), Disk(radius) or TranslatingPolygon(vertices).
    world : an UncertainWorld.
    start, goal : (x, y).
    delta, rng : the first values of the controls.

    Returns
    -------
    ChanceBoard
        `plan` is the plan shown.

    Raises
    ------
    InvalidParameter

    Examples
    --------
    >>> from kinoedu import Point, UncertainWorld
    >>> world = UncertainWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [((4.5, 3), 1)], 0.2)
    >>> chance_board(Point(), world, (1, 3), (8, 3))  # doctest: +NORMALIZE_WHITESPACE
    ChanceBoard(promised at most 5%, bound 4.7%; hit in 40 of 4,000 scenarios: 1% (0.74% to 1.4%);
    length 7.712)
    """
    return ChanceBoard(robot, world, start, goal, delta, rng)


class ChanceBoard(Framed):
    """The widget that `chance_board` returns: controls, and the world in `canvas`.

    The slider of the canvas goes through scenarios.
    """

    def __init__(
        self,
        robot: Robot,
        world: UncertainWorldRecord,
        start: ArrayLike,
        goal: ArrayLike,
        delta: float,
        rng: int,
    ) -> None:
        if not isinstance(world, UncertainWorldRecord):
            raise InvalidParameter(get_message("chance_board.needs", given=shortened(world)))
        self._robot, self._world = as_translating_robot(robot), world
        inflated(world, delta)
        choices = sorted({*CHANCES, float(delta)}, reverse=True)
        options = [(f"{chance:.6g}", chance) for chance in choices]
        style = control_style("chance_board.delta")
        self.delta = widgets.SelectionSlider(options=options, value=float(delta), **style)
        self.seed = make_counter("board.seed", integer(rng, "rng", least=0), 0, 99)
        self.plan: Plan | None = None
        radius = getattr(robot, "radius", 0.0)
        handles = [
            handle(START, start, colour="start", radius=radius),
            handle(GOAL, goal, colour="goal", marker="star", radius=radius),
        ]
        outline = rings_of(world.empty)[0][0][::-1]
        scene = make_scene(world.empty.lo, world.empty.hi, boundary=outline, handles=handles)
        super().__init__([self.delta, self.seed], [Canvas(scene, self.answer)])

    def answer(self, scene: Scene) -> Drawing:
        """Plan with margins in a scene and try the path in scenarios, or say why it cannot."""
        self.plan = None
        world, robot, delta = self._world, self._robot, self.delta.value
        bare = [*draw_margins(world, delta), *draw_expected(world, 0)]
        ends = place_of(scene, START), place_of(scene, GOAL)
        try:
            problem = Problem(robot, inflated(world, delta), *ends)
        except KinoeduError as error:
            return Drawing(bare, warning=str(error))
        self.plan = plan = shortcut(prm(problem, n=400, rng=self.seed.value), rng=self.seed.value)
        if plan.path is None:
            return Drawing(bare, text=get_message("chance_board.none", delta=f"{delta:.4g}"))
        offsets = scenarios(world, TRIED, rng=self.seed.value)
        gaps = part_gaps(robot, world.parts, plan.path)
        hit = hit_scenarios(robot, world.parts, world.owner, gaps, plan.path, offsets)
        layers = [
            *draw_margins(world, delta),
            *draw_scenarios(world, offsets[:SHOWN], hit[:SHOWN]),
            *draw_all_scenarios(world, offsets[:SHOWN], hit[:SHOWN]),
            path(plan.path, "path")._replace(last=False),
            *draw_expected(world, SHOWN),
        ]
        texts = [
            get_message(f"chance_board.{'hit' if was else 'missed'}", number=k + 1)
            for k, was in enumerate(hit[:SHOWN])
        ]
        text, unit = self._text(plan, plan.path, hit), get_message("chance_board.unit")
        return Drawing(layers, text=text, total=SHOWN, unit=unit, step_texts=texts)

    def _text(self, plan: Plan, points: Array, hit: Any) -> str:
        """The chance promised, the bound proven, and the scenarios hit, in words."""
        low, high = wilson_interval(int(hit.sum()), TRIED)
        chances = {
            "delta": self.delta.value,
            "bound": collision_bound(self._robot, self._world, points),
            "share": hit.mean(),
            "low": low,
            "high": high,
        }
        percents = {name: format_percent(float(value)) for name, value in chances.items()}
        counts = {"hits": f"{hit.sum():,}", "tried": f"{TRIED:,}"}
        return get_message("chance_board.text", **counts, length=f"{plan.cost:.4g}", **percents)


def format_percent(fraction: float) -> str:
    """A fraction as a percentage with two digits."""
    return f"{100.0 * fraction:.2g}%"


def draw_closed_line(ring: Array, colour: str, width: float, dash: tuple[float, float]) -> Layer:
    """A dashed outline in one piece, so that its dashes run on round corners."""
    closed = np.vstack([ring, ring[:1]])
    return path(closed, colour, width=width, dash=dash, casing=False)._replace(last=False)


def draw_margins(world: UncertainWorldRecord, delta: float) -> list[Layer]:
    """Draw the margin of each obstacle."""
    return [draw_closed_line(ring, "ink", 1.5, (5, 4)) for ring in margin_rings(world, delta)]


def draw_expected(world: UncertainWorldRecord, step: int) -> list[Layer]:
    """Draw the obstacles at their expected places: dotted, and from a step on as bodies."""
    rings = [ring for _, ring in expected_outlines(world)]
    dotted = [draw_closed_line(ring, "obstacle", 1.2, (1.5, 3)) for ring in rings]
    return [*dotted, *(bodies([ring], "obstacle", when=[step]) for ring in rings)]


def draw_scenarios(world: UncertainWorldRecord, offsets: Array, hit: Any) -> list[Layer]:
    """Draw the obstacles of each scenario at its step, red and hatched where the path is hit.

    At the last step none of them is shown.
    """
    layers = []
    for number, ring in expected_outlines(world):
        for was_hit, colour in ((False, "obstacle"), (True, "hit")):
            steps = np.flatnonzero(hit == was_hit)
            if len(steps):
                shapes = ring + offsets[steps, number][:, None]
                layers.append(bodies(shapes, colour, hatched=was_hit, when=steps, until=steps + 1))
    return layers


def draw_all_scenarios(world: UncertainWorldRecord, offsets: Array, hit: Any) -> list[Layer]:
    """Draw at the last step the outlines of all scenarios, red where the path is hit."""
    layers = []
    for was_hit, colour in ((False, "outside"), (True, "hit")):
        sides = [
            (sides_of(ring) + offsets[hit == was_hit, number][:, None, None]).reshape(-1, 2, 2)
            for number, ring in expected_outlines(world)
        ]
        segments = np.concatenate([np.empty((0, 2, 2)), *sides])
        if len(segments):
            layers.append(edges(segments, colour, width=0.6, when=np.full(len(segments), SHOWN)))
    return layers

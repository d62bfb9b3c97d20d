"""The arguments of a function on a board: what can be dragged, and the values it then has."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Collection, Mapping
from copy import deepcopy
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...errors import KinoeduError
from ...figures.robots import Outlined, outline_at
from ...geometry.checks import Array, as_array
from ...graphs import Graph
from ...messages import get_message
from ...problems import Problem, ProblemRecord, Recorder
from ...robots.car import CarRobot
from ...robots.polygon import RigidPolygonRobot
from ...support.json_fields import JsonObject
from ...worlds.terrain import TerrainRecord
from ..core.drawing import Layer, arrows, bodies, edges
from ..core.scene import Scene, handle, make_scene, mark_area, mark_drawn, place_of, polygon
from ..planning.plans import make_problem_scene, make_world_scene, problem_in, world_in
from ..search.ground import place_nodes
from ..tracing.questions import FirstQuestions
from ..tracing.variables import find_points

COLOURS = ("start", "goal", "robot", "ink")  # of points and poses that can be dragged
PLANE, POSE = 2, 3  # coordinates
LOOKS = 0.25  # how far before the body the point is that turns a pose, of the body's length

Parts = dict[str, list[JsonObject]]


class Argument(ABC):
    """An argument of the function, under the name of its parameter."""

    free: NDArray[np.bool_] | None = None  # the bitmap beneath the picture

    def __init__(self, name: str, value: Any) -> None:
        self.name, self.given = name, value

    def make_scene(self) -> Scene | None:
        """The scene that all other arguments are part of, or None."""
        return None

    def list_parts(self, colour: str) -> Parts:  # most have no handle to colour
        """The handles and polygons that stand for it."""
        return {}

    @abstractmethod
    def value(self, scene: Scene) -> Any:
        """Its value where the scene has it."""

    def draw(self, scene: Scene) -> list[Layer]:  # most are painted as handles
        """What is drawn of it at every step."""
        return []

    def list_places(self, scene: Scene) -> Mapping[str, Array]:  # poses move
        """The handles that the answer moves, by name; asked last of a scene."""
        return {}

    def points(self) -> Array:
        """Points that the picture must show, (n, 2)."""
        return np.empty((0, PLANE))


class Fixed(Argument):
    """An argument that is not shown, and is passed on as a copy."""

    def value(self, scene: Scene) -> Any:
        """A copy, since the function may change it."""
        return deepcopy(self.given)


class PointArgument(Argument):
    """A point that can be dragged."""

    def list_parts(self, colour: str) -> Parts:
        """One handle."""
        return {"handles": [handle(self.name, self.given, colour=colour)]}

    def value(self, scene: Scene) -> Array:
        """The place of the handle."""
        return place_of(scene, self.name)

    def points(self) -> Array:
        """The point."""
        return np.array([self.given], float)


class RingsArgument(Argument):
    """A polygon, or a list of them: obstacles."""

    def list_parts(self, colour: str) -> Parts:
        """A polygon for each."""
        return {"polygons": [polygon(name, [ring]) for name, ring in self.rings().items()]}

    def rings(self) -> dict[str, Array]:
        """The polygons by their names on the board."""
        return name_rings(self.name, self.given)

    def value(self, scene: Scene) -> Any:
        """The polygons where they are now."""
        rings = {one["name"]: np.array(one["rings"][0]) for one in scene["polygons"]}
        found = [rings[part] for part in self.rings()]
        return found if isinstance(self.given, list) else found[0]

    def points(self) -> Array:
        """All vertices."""
        return np.concatenate([*self.rings().values()])


class AreaArgument(RingsArgument):
    """A polygon, or a list of them, that are no obstacles."""

    def list_parts(self, colour: str) -> Parts:
        """A pale polygon for each."""
        return {"polygons": [mark_area(one) for one in super().list_parts(colour)["polygons"]]}


class PoseArgument(Argument):
    """A pose (x, y, theta) of a robot: its place is dragged, and a point in front of it."""

    def __init__(self, name: str, value: Any, robot: Outlined) -> None:
        super().__init__(name, np.array(value, float))
        self.robot, self.colour, self.last = robot, COLOURS[0], self.given
        self.looks = get_message("board.code.looks", name=name)
        long = float(np.ptp(robot.outline[:, 0]))
        self.reach = float(robot.outline[:, 0].max()) + LOOKS * long

    def list_parts(self, colour: str) -> Parts:
        """The place, and the point that the robot looks at."""
        self.colour = colour
        place = handle(self.name, self.given[:PLANE], colour=colour)
        tip = handle(self.looks, self.find_tip(self.given), colour=colour)
        return {"handles": [place, mark_drawn(tip)]}

    def find_tip(self, pose: Array) -> Array:
        """The point that a pose looks at."""
        return pose[:PLANE] + self.reach * np.array([math.cos(pose[2]), math.sin(pose[2])])

    def value(self, scene: Scene) -> Array:
        """The pose at the place that looks at the tip.

        A tip that stands where the pose given or the last one has it was not moved: the heading
        stays, to the last digit.
        """
        place, tip = place_of(scene, self.name), place_of(scene, self.looks)
        for pose in (self.given, self.last):
            if np.array_equal(tip, self.find_tip(pose)):
                return np.array([*place, pose[2]])
        return np.array([*place, math.atan2(tip[1] - place[1], tip[0] - place[0])])

    def draw(self, scene: Scene) -> list[Layer]:
        """The body, and an arrow to the tip."""
        pose = self.value(scene)
        arrow = arrows([pose[:PLANE]], [self.find_tip(pose) - pose[:PLANE]], self.colour)
        return [bodies([outline_at(self.robot, pose)], self.colour), arrow]

    def list_places(self, scene: Scene) -> Mapping[str, Array]:
        """The tip returns to its distance from the place, where it is in the next scene."""
        self.last = self.value(scene)
        return {self.looks: self.find_tip(self.last)}

    def points(self) -> Array:
        """The body and the tip."""
        return np.vstack([outline_at(self.robot, self.given), self.find_tip(self.given)])


class GraphArgument(Argument):
    """An embedded graph, whose nodes can be dragged."""

    given: Graph

    def list_parts(self, colour: str) -> Parts:
        """A handle on each node, named by its number."""
        nodes = self.given.nodes
        return {"handles": [handle(str(u), nodes[u], colour="ink") for u in self.given]}

    def value(self, scene: Scene) -> Graph:
        """The graph with its nodes where they are now; weights that are lengths change too."""
        return place_nodes(self.given, [place_of(scene, str(u)) for u in self.given])

    def draw(self, scene: Scene) -> list[Layer]:
        """The edges."""
        graph = self.value(scene)
        return [edges(graph.nodes[graph.edges], "outside", width=2.0)]

    def points(self) -> Array:
        """The nodes."""
        return self.given.nodes[list(self.given)]


class BitmapArgument(Fixed):
    """A bitmap, rows from below, free where it is true; cells are squares of side 1."""

    def __init__(self, name: str, value: NDArray[np.bool_]) -> None:
        super().__init__(name, value)
        self.free = value

    def make_scene(self) -> Scene:
        """The rectangle of the cells."""
        return make_scene((0.0, 0.0), self.given.shape[::-1])

    def points(self) -> Array:
        """Two corners."""
        return np.array([(0.0, 0.0), self.given.shape[::-1]])


class ProblemArgument(Argument):
    """A Problem; what the function asks it is recorded.

    Start and goal can be dragged where configurations are points of the plane.

    Attributes
    ----------
    own : the names of polygons of the scene that are not the problem's.
    log : where the questions are recorded.
    """

    given: ProblemRecord

    def __init__(self, name: str, value: ProblemRecord) -> None:
        super().__init__(name, value)
        self.own: Collection[str] = ()
        self.log = FirstQuestions()
        self.in_plane = value.start.shape == (PLANE,)
        self.free = value.world.free if isinstance(value.world, TerrainRecord) else None

    def make_scene(self) -> Scene:
        """The scene of its world, with start and goal."""
        if self.in_plane:
            return make_problem_scene(self.given)
        return make_world_scene(self.given.world, [])

    def value(self, scene: Scene) -> Recorder:
        """The problem with everything where it is now."""
        polygons = [one for one in scene["polygons"] if one["name"] not in self.own]
        mine = {**scene, "polygons": polygons}
        recorder = Recorder(self.place(mine))
        recorder.log = self.log
        return recorder

    def place(self, scene: Scene) -> ProblemRecord:
        """The problem in a scene of its own parts."""
        problem = self.given
        if self.in_plane:
            return problem_in(scene, problem)
        if scene["boundary"] is None:
            return problem
        ends = problem.start, problem.goal
        return Problem(problem.robot, world_in(scene), *ends, clearance=problem.clearance)

    def points(self) -> Array:
        """Two corners of the world."""
        return np.array([self.given.world.lo, self.given.world.hi])


def make_arguments(
    given: Mapping[str, Any], fixed: Collection[str], areas: Collection[str]
) -> list[Argument]:
    """The arguments of a function, by the names of their parameters.

    fixed : the names of those that cannot be dragged.
    areas : the names of polygons that are no obstacles.
    """
    robot = find_robot(given.values())
    made = [make_argument(name, value, robot, fixed, areas) for name, value in given.items()]
    own = {part for one in made if isinstance(one, RingsArgument) for part in one.rings()}
    for one in made:
        if isinstance(one, ProblemArgument):
            one.own = own
    return made


def make_argument(
    name: str,
    value: Any,
    robot: Outlined | None,
    fixed: Collection[str],
    areas: Collection[str],
) -> Argument:
    """The argument of one parameter."""
    if isinstance(value, ProblemRecord):
        return ProblemArgument(name, value)
    if is_bitmap(value):
        return BitmapArgument(name, value)
    parameter = name.partition(" ")[0]  # of `points 0` it is `*points`
    if parameter in fixed:
        return Fixed(name, value)
    if is_plane_point(value):
        return PointArgument(name, value)
    if robot is not None and is_pose(value):
        return PoseArgument(name, value, robot)
    if isinstance(value, Graph) and value.space is not None and value.nodes.shape[1] == PLANE:
        return GraphArgument(name, value)
    if not name_rings(name, value):
        return Fixed(name, value)
    return AreaArgument(name, value) if parameter in areas else RingsArgument(name, value)


def find_robot(values: Collection[Any]) -> Outlined | None:
    """The robot among the arguments, or of a Problem among them, that has an outline and turns."""
    for value in values:
        robot = value.robot if isinstance(value, ProblemRecord) else value
        if isinstance(robot, RigidPolygonRobot | CarRobot):
            return robot
    return None


def is_bitmap(value: object) -> bool:
    """Whether an argument is a two-dimensional array of booleans."""
    return isinstance(value, np.ndarray) and value.ndim == 2 and value.dtype == np.bool_


def is_pose(value: object) -> bool:
    """Whether an argument is (x, y, theta), an array or tuple of three numbers."""
    if type(value) not in (np.ndarray, tuple):
        return False
    row: Any = value
    return len(row) == POSE and all(isinstance(x, int | float | np.number) for x in row)


def is_plane_point(value: object) -> bool:
    """Whether an argument is a point of the plane."""
    return find_points(value)[1]


def name_rings(name: str, value: object) -> dict[str, Array]:
    """The polygons that an argument is, or holds as a list, by their names on the board."""
    rings: Any = value if isinstance(value, list) else [value]
    try:
        arrays = [as_array(ring, name) for ring in rings]
    except KinoeduError:
        return {}
    if not all(ring.ndim == 2 and ring.shape[1] == PLANE and len(ring) > PLANE for ring in arrays):
        return {}
    names = [f"{name} {k}" for k in range(len(arrays))] if isinstance(value, list) else [name]
    return dict(zip(names, arrays, strict=True))

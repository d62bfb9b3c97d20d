"""A car on a board: its body and steered wheels, its path, and the ride along it."""

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from ...figures.ackermann import steered_wheels
from ...figures.drawing import line_width
from ...figures.robots import driven_tracks, outline_at, tracks
from ...geometry.checks import Array
from ...messages import get_message
from ...problems import Plan
from ...robots.car import CarRobot
from ...robots.trajectory import TrajectoryRecord
from ..core.drawing import Layer, arrows, bodies, edges, eye, labels, path_edges, segments_along
from ..core.notes import note, with_notes
from .car_poses import body_middles, tip_of

STEPS = 200  # of a ride
GROWTH = 100  # the most steps of a tree's growth: half as long as the ride
PIECES = 4  # of an edge
EYE = 7.0  # the width of the view that follows the car, in wheelbases


class Ride(NamedTuple):
    """A trajectory at equal time steps: times (k,), poses (k, 3) and controls (k, 2)."""

    times: Array
    poses: Array
    controls: Array

    @property
    def last(self) -> "Ride":
        """The last moment alone."""
        return Ride(self.times[-1:], self.poses[-1:], self.controls[-1:])


def make_ride(trajectory: TrajectoryRecord) -> Ride:
    """The ride along a trajectory, ends included; one moment where nothing is driven."""
    n = len(trajectory.durations)
    times = np.linspace(0.0, trajectory.duration, STEPS + 1 if n else 1)
    which = np.minimum(np.searchsorted(np.cumsum(trajectory.durations), times), max(n - 1, 0))
    return Ride(times, trajectory.at(times), trajectory.controls[which] if n else np.zeros((1, 2)))


def draw_ride(car: CarRobot, ride: Ride, begin: int, *, hit: bool = False) -> list[Layer]:
    """Draw the car at its first moment until step `begin`, then at one moment per step.

    hit : whether the car at the last moment is in contact.
    """
    n = len(ride.times)
    when = np.append(0, begin + 1 + np.arange(n - 1)) if n > 1 else np.array([0])
    until = np.append(when[1:], begin + n)
    outlines = place_shapes(car.outline[None, None], ride.poses)[:, 0]
    rolling = dict.fromkeys(ride.controls[:, 1].tolist())
    straight = {phi: np.array(steered_wheels(car, np.zeros(3), phi)) for phi in rolling}
    wheels = place_shapes(
        np.array([straight[phi] for phi in ride.controls[:, 1].tolist()]), ride.poses
    )
    good = n - 1 if hit else n
    layers = [bodies(outlines[:good], "robot", when=when[:good], until=until[:good])]
    if hit:
        last: Any = {"when": when[good:], "until": until[good:]}
        layers.append(bodies(outlines[good:], "hit", hatched=True, **last))
    span: Any = {"when": np.repeat(when, 4), "until": np.repeat(until, 4)}
    return [*layers, bodies(wheels.reshape(-1, 4, 2), "ink", **span)]


def place_shapes(shapes: Array, poses: Array) -> Array:
    """Shapes (m, k, c, 2) in the car's frame, moved to poses (m, 3)."""
    cos, sin = np.cos(poses[:, 2]), np.sin(poses[:, 2])
    turns = np.stack([cos, sin, -sin, cos], axis=1).reshape(-1, 1, 2, 2)
    return shapes @ turns + poses[:, None, None, :2]


def draw_rear_axle_path(ride: Ride, begin: int) -> list[Layer]:
    """Draw the path of the rear axle's midpoint from step `begin` on, dashed where it goes back."""
    pieces = segments_along(ride.poses[:, :2])
    back = ride.controls[1:, 0] < 0.0
    some = pieces[~back | (np.arange(len(pieces)) % 2 == 0)]
    return path_edges(some, when=np.full(len(some), begin))


def draw_growth(car: CarRobot, plan: Plan) -> tuple[Layer, int]:
    """Draw the tree or roadmap of a plan as it grew; also returns the number of steps."""
    if plan.roadmap is not None:
        roadmap, colour = plan.roadmap, "roadmap"
        begins = roadmap.nodes[roadmap.edges[:, 0]]
        lines = driven_tracks(car, begins, roadmap.controls, roadmap.durations, PIECES)
    else:
        tree: Any = plan.tree
        begins, colour = tree.nodes[tree.parent[1:]], "tree"
        if hasattr(tree, "controls"):
            lines = driven_tracks(car, begins, tree.controls[1:], tree.durations[1:], PIECES)
        else:
            lines = tracks(car, begins, tree.nodes[1:])
            lines = lines[:, :: max(1, (lines.shape[1] - 1) // PIECES)]
    n = len(lines)
    total = min(n, GROWTH)
    when = np.ceil((np.arange(n) + 1) * total / max(n, 1))
    pieces = np.stack([lines[:, :-1], lines[:, 1:]], axis=2)
    return edges(pieces, colour, width=line_width(n), when=np.repeat(when, pieces.shape[1])), total


def note_tree(layer: Layer, tree: Any) -> Layer:
    """The edges of a tree in equally many pieces each, with what each of them says.

    A piece is a node of the branch: its parent is the piece before it.
    """
    n = len(tree.nodes)
    k = len(layer.rows) // max(n - 1, 1)
    pieces, first = np.arange(len(layer.rows)), np.arange(len(layer.rows)) % k == 0
    above = np.repeat(tree.parent[1:], k) * k - 1
    branch = {"node": pieces, "parent": np.where(first, np.maximum(above, -1), pieces - 1)}
    number = np.repeat(np.arange(1, n), k)
    if not hasattr(tree, "durations"):
        return with_notes(layer, note("car_length", number=None), number=number, **branch)
    time = [0.0] * n
    for node, (parent, duration) in enumerate(zip(tree.parent.tolist(), tree.durations.tolist())):
        time[node] = time[parent] + duration
    says = note("car_node", number=None, time=None)
    return with_notes(layer, says, number=number, time=np.array(time)[number], **branch)


def draw_ends(car: CarRobot, ends: Sequence[Array]) -> list[Layer]:
    """Draw the start and goal poses: bodies, tips and names."""
    drawn: list[Layer] = []
    for name, pose in zip(("start", "goal"), ends, strict=True):
        outline, wheels = outline_at(car, pose), np.array(steered_wheels(car, pose, 0.0))
        beside = outline[:, 0].max(), outline[:, 1].min() - 0.5 * np.ptp(car.outline[:, 1])
        drawn += [
            bodies([outline], name),
            bodies(wheels, name),
            labels([beside], [get_message(f"car_board.{name}")], name),
            arrows([pose[:2]], [tip_of(car, pose) - pose[:2]], name),
        ]
    return drawn


def draw_refused(car: CarRobot, poses: Sequence[Array]) -> list[Layer]:
    """Draw the car at poses where it cannot be."""
    return [bodies([outline_at(car, pose)], "hit", hatched=True) for pose in poses]


def follow_car(car: CarRobot, ride: Ride, begin: int) -> Layer:
    """An eye that moves with the car."""
    when = np.append(0, begin + 1 + np.arange(len(ride.times) - 1))
    return eye(body_middles(car, ride.poses), EYE * car.wheelbase, when=when)


def describe_ride(ride: Ride) -> list[str]:
    """The text at each moment of a ride."""
    return [describe_moment(t, v, phi) for t, (v, phi) in zip(ride.times, ride.controls)]


def describe_moment(t: float, v: float, phi: float) -> str:
    """A moment of a ride in words."""
    return get_message("car_board.moment", t=f"{t:.1f}", v=f"{v:.3g}", phi=round(math.degrees(phi)))

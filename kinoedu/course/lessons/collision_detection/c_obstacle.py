"""The exercise on C-obstacles of a robot that does not turn. Bullo & Smith, chapter 4."""

from collections.abc import Iterator

import numpy as np

from ....geometry import convex_hull, minkowski_difference, minkowski_sum
from ....geometry.checks import Array
from ....geometry.minkowski import corner_pairs
from ...exercise import RIGHT, Axes, Case, Change, Restated, Slip, ValueExercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Record, Value
from ...withheld import withheld
from ..shared.random_shapes import convex_polygon, sizes
from .convex import RING, edge_areas
from .pictures import draw_grown_obstacle

BOX = np.array([(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0)])
WEDGE = np.array([(0.0, 0.0), (2.0, 0.0), (0.0, 1.0)])


@withheld
def difference_of(robot: Array, obstacle: Array) -> Array:
    """C-obstacle of a convex robot and a convex obstacle, (k, 2)."""
    return minkowski_difference(obstacle, robot)


class CObstacle(ValueExercise):
    """The vertices of the C-obstacle of a convex robot that does not turn, in order."""

    name = "c_obstacle"
    lesson = "07_collision_detection"
    kinds = ("boxes", "parallel", "general", "off")
    given = Record(robot=RING, obstacle=RING)
    answer = RING
    source = staticmethod(difference_of)
    shown = staticmethod(corner_pairs)
    slips = (
        Slip("sum", lambda robot, obstacle: minkowski_sum(obstacle, robot)),
        Slip("swapped", lambda robot, obstacle: minkowski_difference(robot, obstacle)),
        Slip("unchanged", lambda robot, obstacle: obstacle),
        Slip(
            "centred",
            lambda robot, obstacle: minkowski_difference(obstacle, robot - robot.mean(axis=0)),
        ),
        Slip(
            "first_vertex", lambda robot, obstacle: minkowski_difference(obstacle, robot - robot[0])
        ),
        Slip(
            "box",
            lambda robot, other: minkowski_difference(bounding_box(other), bounding_box(robot)),
        ),
        Slip("all", lambda robot, obstacle: (obstacle[:, None] - robot).reshape(-1, 2)),
    )
    reference = staticmethod(difference_of)
    changes = (
        Restated("obstacle_moves", answer=lambda grown, *given: np.negative(grown)),
        Change("bounding_box", lambda grown, *given: bounding_box(np.asarray(grown(*given)))),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Boxes on squared paper first."""
        for kind, robot, obstacle in (
            ("boxes", BOX, [(4, 3), (8, 3), (8, 5), (4, 5)]),
            ("boxes", BOX - 1, [(4, 3), (6, 3), (6, 4), (4, 4)]),
            ("general", WEDGE, [(4, 2), (6, 3), (3, 5)]),
            ("parallel", WEDGE, [(4, 3), (7, 3), (7, 5), (4, 5)]),
            ("off", WEDGE + 1, [(6, 2), (8, 3), (5, 5)]),
            ("general", WEDGE / 64, np.array([(4, 2), (6, 3), (3, 5)]) / 64),
        ):
            yield Case(
                kind, {"robot": np.array(robot, float), "obstacle": np.array(obstacle, float)}
            )
        for number, size in enumerate(sizes(3)):
            for kind in self.kinds:
                mover, solid = shapes_of(rng, 3 + number // 3, size, kind)
                yield Case(kind, {"robot": mover, "obstacle": solid})

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Compare the polygons; an answer that is not a convex polygon breaks the rule "order"."""
        if self.same(value, self.truth(case)):
            return RIGHT
        return Verdict(
            0.0, case.kind if is_convex(value) else "order", self.describe_expected(case)
        )

    def same(self, value: Value, truth: Value) -> bool:
        """Compare polygons up to the first vertex, the orientation, and vertices inside edges."""
        answer = np.asarray(value, float)
        if not is_convex(answer):
            return super().same(value, truth)
        slack = self.tolerance * (1.0 + float(np.abs(truth).max()))
        return all(
            distance_outside(points, ring) <= slack
            for points, ring in ((answer, truth), (truth, counter_clockwise_corners(answer)))
        )

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the obstacle, the robot, the C-obstacle and the student's answer."""
        draw_grown_obstacle(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def is_convex(ring: Array) -> bool:
    """Whether points are, up to rounding, the vertices of a convex polygon in order.

    Both orientations are accepted.
    """
    points = np.asarray(ring, float)
    if len(points) < 3 or not np.isfinite(points).all():
        return False
    extent = float(np.ptp(points, axis=0).max())
    # repeated vertices count once
    points = points[np.abs(points - np.roll(points, 1, axis=0)).max(axis=1) > 1e-9 * extent]
    if len(points) < 3:
        return False
    before, after = points - np.roll(points, 1, axis=0), np.roll(points, -1, axis=0) - points
    turns = np.arctan2(
        before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0], (before * after).sum(axis=1)
    )
    turns = np.where(np.abs(turns) < 1e-7, 0.0, turns)
    return bool(
        ((turns >= 0).all() or (turns <= 0).all()) and abs(abs(turns.sum()) - 2.0 * np.pi) < 1e-3
    )


def counter_clockwise_corners(ring: Array) -> Array:
    """Vertices of a convex polygon, counter-clockwise, without those inside edges."""
    return convex_hull(ring)


def distance_outside(points: Array, ring: Array) -> float:
    """Upper bound for how far a point lies outside a convex polygon; 0 where all are inside."""
    sides = np.linalg.norm(np.roll(ring, -1, axis=0) - ring, axis=1)
    return float(max((-(edge_areas(q, ring) / sides).min() for q in points), default=0.0))


def bounding_box(ring: Array) -> Array:
    """Bounding box of a polygon."""
    (x0, y0), (x1, y1) = ring.min(axis=0), ring.max(axis=0)
    return np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])


def shapes_of(rng: np.random.Generator, n: int, size: float, kind: str) -> tuple[Array, Array]:
    """Random robot and obstacle of a kind.

    Coordinates are whole for boxes, and have two decimals for the other kinds. The reference
    point is inside the robot, or outside for one kind. The polygons are boxes, have parallel
    edges, or neither.
    """
    robot, obstacle = convex_polygon(rng, n, size), convex_polygon(rng, n + 1, size)
    if kind == "boxes":
        robot, obstacle = bounding_box(robot), bounding_box(obstacle)
    if kind == "parallel":
        obstacle = convex_hull(np.vstack([robot, robot + rng.integers(1, 2 + int(size), 2)]))
    shift = 3.0 * size if kind == "off" else 0.0
    robot = robot - np.round(robot.mean(axis=0)) + np.round(shift * rng.choice([-1.0, 1.0], 2))
    obstacle = obstacle + np.round(rng.uniform(2.0, 4.0, 2) * size)
    scale = 1.0 if kind == "boxes" else 0.37
    return np.round(scale * robot, 2) + 0.0, np.round(scale * obstacle, 2) + 0.0

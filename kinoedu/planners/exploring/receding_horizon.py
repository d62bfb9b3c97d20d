"""Sensor-based planning with a receding horizon: sense, plan in the map, follow, and repeat.

    RECEDING-HORIZON(start, goal)
     1  q := start; the map is empty
     2  while q is not the goal:
     3      add to the map what the range sensor sees from q
     4      plan a path from q to the goal in the map, where what was never seen counts as free
     5      if there is none: return failure
     6      follow the path for the length of the horizon, or until a motion is not free
     7  return the path that was followed

Bullo & Smith, chapter 5.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import compress
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...errors import InvalidGoal, InvalidParameter, InvalidStart
from ...geometry.checks import Array, as_generator
from ...geometry.exact import orientation_sign
from ...problems import Plan, Problem, ProblemRecord, Recorder, Tree
from ...problems.recorder import unwrap_recorder
from ...robots.round import RoundRobot
from ...support.constructors import with_type_names
from ...worlds.polygon_world import PolygonWorldRecord, world_of_triangles
from ...worlds.range_sensor import Scan, scan
from ..answers import plan_along
from ..problem_input import count_checks, world_size
from ..shortcut import shortcut
from ..trees.rrt_connect import rrt_connect
from ..tuning import integer, positive

FACING = 2.0  # times the distance of two rays' hits on a wall that faces them
GRAZING = 6.0  # the same, for hits that are in line with the one before or after them
IN_LINE = 0.995  # at least this cosine of the turn at a hit
STRAIGHT = 1.0 - 1e-12  # the same, on one straight wall
THICKNESS = 0.1  # of the distance of two hits

Local = Callable[[ProblemRecord, np.random.Generator], Plan]


class SeenMap(NamedTuple):
    """The walls seen so far, as thin triangles between hits, behind the wall as the sensor sees it.

    Where an earlier scan has seen a wall, later ones add none: `squares` has the size of each piece
    between neighbouring hits (a power of two), and its square of a grid of half that size.
    """

    walls: list[Array]
    squares: set[tuple[int, ...]]

    def add(self, measured: Scan) -> None:
        """Add the walls between hits of a scan; neighbouring pieces of a straight wall are one."""
        points, origin = measured.points, measured.origin
        apart, turn = measure_steps(points)
        middle = 0.5 * (points + np.roll(points, -1, axis=0))
        size = np.frexp(apart)[1][:, None]
        rows = np.hstack([size, np.floor(middle / 2.0 ** (size - 1)).astype(int)])
        squares = list(map(tuple, rows.tolist()))
        is_new = are_joined(measured) & [square not in self.squares for square in squares]
        self.squares.update(compress(squares, is_new))
        for first, last in find_runs(is_new, turn >= STRAIGHT):
            a, b = points[first], points[(last + 1) % len(points)]
            away = 0.5 * (a + b) - origin
            depth = THICKNESS * min(apart[first], apart[last]) / np.sqrt((away**2).sum())
            wall = np.array([b, a, 0.5 * (a + b) + depth * away])
            if orientation_sign(*wall.ravel().tolist()) > 0:
                self.walls.append(wall)

    def triangles(self) -> Array:
        """The walls seen so far, each counter-clockwise, shape (k, 3, 2)."""
        return np.array(self.walls).reshape(-1, 3, 2)


def measure_steps(points: Array) -> tuple[Array, Array]:
    """The distance from each point of a ring (n, 2) to the next, and the cosine of the turn there.

    The cosine is 0 where a point and its neighbour are the same.
    """
    step = np.roll(points, -1, axis=0) - points
    apart = np.sqrt((step**2).sum(axis=1))
    lengths = apart * np.roll(apart, 1)
    along = (step * np.roll(step, 1, axis=0)).sum(axis=1)
    return apart, np.divide(along, lengths, out=np.zeros_like(along), where=lengths > 0.0)


def are_joined(measured: Scan) -> NDArray[np.bool_]:
    """Whether each hit of a scan and the next one are on one wall, shape (n,).

    They are if they are near each other, for their distance from the sensor. Hits on a wall that
    the rays only graze are farther apart, but in line with their neighbours. Else there may be a
    passage between them.
    """
    hit, (apart, turn) = measured.hit, measure_steps(measured.points)
    both = hit & np.roll(hit, -1)
    in_line = (turn >= IN_LINE) & both & np.roll(hit, 1)  # at each hit
    limit = np.where(in_line | np.roll(in_line, -1), GRAZING, FACING)
    farther = np.maximum(measured.distances, np.roll(measured.distances, -1))
    near = apart <= limit * farther * (2.0 * np.pi / len(measured.angles))
    return both & near & (apart > 0.0)


def find_runs(pieces: NDArray[np.bool_], straight: NDArray[np.bool_]) -> Iterator[tuple[int, int]]:
    """The first and the last piece of each run in a ring.

    Piece i leads to piece i + 1; both are in one run if the ring is straight between them.

    Examples
    --------
    >>> list(find_runs(np.array([1, 1, 0, 1, 1]) > 0, np.array([1, 0, 1, 1, 1]) > 0))
    [(1, 1), (3, 0)]
    """
    goes_on = np.roll(pieces, 1) & straight & pieces  # from the piece before
    firsts = np.flatnonzero(pieces & ~goes_on)
    lasts = np.flatnonzero(pieces & ~np.roll(goes_on, -1))
    around = len(firsts) > 0 and lasts[0] < firsts[0]
    return zip(firsts.tolist(), np.roll(lasts, -1 if around else 0).tolist())


@with_type_names
class Look(NamedTuple):
    """One iteration of the loop.

    scan : what the sensor measures.
    walls : (k, 3, 2), the walls of the map, with this scan.
    plan : the plan in that map.
    followed : (j, d), the points of the plan that are followed; none where there is no plan or no
        move is left.
    checks : how many motions were checked.
    """

    scan: Scan
    walls: Array
    plan: Plan
    followed: Array
    checks: int


def receding_horizon(
    problem: ProblemRecord | Recorder,
    *,
    reach: float | None = None,
    horizon: float | None = None,
    rays: int = 180,
    planner: Local | None = None,
    max_moves: int = 200,
    rng: int | np.random.Generator,
) -> Plan:
    """Plan through a world that only a range sensor sees.

    Not complete: the path that is followed may miss a passage.

    Parameters
    ----------
    problem : a Problem of a Point or Disk in a PolygonWorld, or a Recorder of one. Only the world's
        bounding box is known in advance.
    reach : the range of the sensor; by default a quarter of the world's diagonal.
    horizon : how far a plan is followed before the robot looks again; by default half the reach.
    rays : in how many directions the sensor looks.
    planner : a function of a problem and a generator that plans in the map; by default rrt_connect,
        then shortcut.
    max_moves : stop after this many moves.
    rng : a seed or a numpy Generator.

    Returns
    -------
    Plan whose path was followed, and whose `tree` is the chain of places where the robot looked.
    Without a path `plan.reason` says whether the map shows no path or the moves ran out.

    Raises
    ------
    InvalidParameter
        Where the robot or the world is another, or a parameter is out of its range.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> wall = [(4, 0), (6, 0), (6, 8), (4, 8)]
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [wall])
    >>> plan = receding_horizon(Problem(Point(), world, start=(1, 1), goal=(9, 1)), rng=0)
    >>> bool(17.2 < plan.cost < 40)
    True
    """
    given: Any = {
        "reach": reach,
        "horizon": horizon,
        "rays": rays,
        "planner": planner,
        "max_moves": max_moves,
        "rng": rng,
    }
    return plan_from_looks(problem, list(receding_horizon_looks(problem, **given)))


def receding_horizon_looks(
    problem: ProblemRecord | Recorder,
    *,
    reach: float | None = None,
    horizon: float | None = None,
    rays: int = 180,
    planner: Local | None = None,
    max_moves: int = 200,
    rng: int | np.random.Generator,
) -> Iterator[Look]:
    """The iterations of `receding_horizon`, which has the same parameters.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> wall = [(4, 0), (6, 0), (6, 8), (4, 8)]
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [wall])
    >>> problem = Problem(Point(), world, start=(1, 1), goal=(9, 1))
    >>> looks = list(receding_horizon_looks(problem, rng=0))
    >>> looks[0].scan.origin, looks[-1].followed[-1]
    (array([1., 1.]), array([9., 1.]))
    """
    inner = unwrap_recorder(problem)
    if not (
        isinstance(inner, ProblemRecord)
        and isinstance(inner.robot, RoundRobot)
        and isinstance(inner.world, PolygonWorldRecord)
    ):
        raise InvalidParameter(
            "receding_horizon needs a Problem of a Point or a Disk in a PolygonWorld"
        )
    sight = positive(world_size(inner) / 4.0 if reach is None else reach, "reach")
    ahead = positive(sight / 2.0 if horizon is None else horizon, "horizon")
    most, generator = integer(max_moves, "max_moves", least=0), as_generator(rng)
    local = connect_and_shorten if planner is None else planner
    seen_map, margin = SeenMap([], set()), sight * np.pi / integer(rays, "rays", least=3)
    q, moves = problem.start, 0
    while not np.array_equal(q, problem.goal) and moves <= most:
        around = scan(inner.world, q, rays=rays, reach=sight)
        seen_map.add(around)
        room = 0.5 * (float(around.distances.min()) - inner.robot.radius - inner.clearance)
        plan = plan_in_map(seen_map, inner, q, min(margin, room), local, generator)
        before, walls = count_checks(problem), seen_map.triangles()
        followed = [] if plan.path is None or moves == most else follow(problem, plan.path, ahead)
        points, checks = np.array(followed).reshape(-1, len(q)), count_checks(problem) - before
        yield Look(around, walls, plan, points, checks)
        if plan.path is None:
            return
        q, moves = followed[-1] if followed else q, moves + 1


def plan_from_looks(problem: ProblemRecord | Recorder, looks: list[Look]) -> Plan:
    """The plan that results from all looks: the path followed, or why it ends elsewhere."""
    path = np.concatenate([[problem.start], *(look.followed for look in looks)])
    reason = ""
    if looks and looks[-1].plan.path is None:
        reason = (
            f"after {len(looks):,} looks the map shows no way to the goal: {looks[-1].plan.reason}"
        )
    elif not np.array_equal(path[-1], problem.goal):
        reason = f"{len(looks) - 1:,} moves did not lead to the goal; allow more, or a longer reach"
    places = np.array([look.scan.origin for look in looks] + ([] if reason else [path[-1]]))
    walls = len(looks[-1].walls) if looks else 0
    stats = {"looks": len(looks), "walls": walls, "checks": sum(look.checks for look in looks)}
    tree = Tree(places, np.arange(len(places)) - 1)
    numbers = None if reason else np.arange(len(path))
    return plan_along(
        problem, path, numbers, reason, planner="receding horizon", tree=tree, stats=stats
    )


def connect_and_shorten(problem: ProblemRecord, rng: np.random.Generator) -> Plan:
    """RRT-Connect, then shortcuts."""
    return shortcut(rrt_connect(problem, max_nodes=4000, max_iterations=8000, rng=rng), rng=rng)


def plan_in_map(
    seen_map: SeenMap,
    problem: ProblemRecord,
    q: Array,
    margin: float,
    planner: Local,
    rng: np.random.Generator,
) -> Plan:
    """A plan from q in the map, with a margin to the walls where this leaves a path.

    Corners between two rays were not seen, so a margin is needed.
    """
    world = world_of_triangles(problem.world.lo, problem.world.hi, seen_map.triangles())
    plan = Plan(None, np.inf, reason="the walls seen leave no room at the start or the goal")
    for fraction in (1.0, 0.25, 0.0625, 0.015625):
        room = problem.clearance + fraction * margin
        try:
            plan = planner(Problem(problem.robot, world, q, problem.goal, clearance=room), rng)
        except (InvalidStart, InvalidGoal):
            continue
        if plan.path is not None:
            break
    return plan


def follow(problem: ProblemRecord | Recorder, path: Array, ahead: float) -> list[Array]:
    """The points of a path up to the horizon, or to the first motion that is not free.

    That motion is halved up to four times, to come nearer.
    """
    followed, left = [], ahead
    for a, b in zip(path[:-1], path[1:], strict=True):
        apart = problem.distance(a, b)
        q = b if apart <= left else problem.steer(a, b, left)
        for _ in range(5):
            if problem.is_free_path(a, q):
                followed.append(q)
                break
            q = problem.steer(a, q, 0.5 * problem.distance(a, q))
        if not followed or not np.array_equal(followed[-1], b):
            break
        left -= apart
    return followed

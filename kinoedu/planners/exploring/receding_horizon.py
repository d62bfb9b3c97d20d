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
from typing import NamedTuple

import numpy as np

from ...errors import InvalidGoal, InvalidParameter, InvalidStart
from ...geometry.checks import Array, as_generator
from ...problems import Plan, Problem, ProblemRecord, Recorder, Tree
from ...problems.recorder import unwrap_recorder
from ...robots.round import RoundRobot
from ...support.constructors import with_type_names
from ...support.text import shortened
from ...worlds.polygon_world import PolygonWorldRecord, world_of_triangles
from ...worlds.range_sensor import Scan, scan
from ..answers import plan_along, plan_of
from ..problem_input import count_checks, world_size
from ..shortcut import shortcut
from ..trees.rrt_connect import rrt_connect
from ..tuning import integer, positive
from .seen_map import SeenMap

Local = Callable[[ProblemRecord, np.random.Generator], Plan]


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
    looks = receding_horizon_looks(
        problem,
        reach=reach,
        horizon=horizon,
        rays=rays,
        planner=planner,
        max_moves=max_moves,
        rng=rng,
    )
    return plan_from_looks(problem, list(looks))


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
    if not callable(local):
        raise InvalidParameter(
            f"planner must be a function of a problem and a generator, got {shortened(planner)}"
        )
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
            task = Problem(problem.robot, world, q, problem.goal, clearance=room)
            plan = plan_of(planner(task, rng))
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

"""A roadmap for a world that changes between queries: only motions near a change are checked again.

Every motion that was ever checked is kept, free or not, so that a blocked passage can open again.
After P. Leven, S. Hutchinson, "A framework for real-time path planning in changing environments"
(2002).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...compiled import algorithm
from ...errors import InvalidParameter
from ...geometry.checks import Array, as_generator, as_point
from ...problems import ProblemRecord, Recorder, Roadmap
from ...problems.protocols import PlanningProblem
from ...problems.recorder import unwrap_recorder
from ...robots.round import RoundRobot
from ...support.constructors import with_type_names
from ...support.text import shortened
from ...worlds.terrain import TerrainRecord
from ..tuning import integer
from .neighbours import k_closest


@with_type_names
class ChangingRoadmap(NamedTuple):
    """A roadmap with its blocked edges.

    nodes : (n, 2), free or not.
    pairs : (m, 2), the pairs of nodes whose motion was checked.
    is_open : (m,), whether the motion of each pair is free.
    judged : how many motions were checked for the last change.
    """

    nodes: Array
    pairs: NDArray[np.int64]
    is_open: NDArray[np.bool_]
    judged: int

    def roadmap(self) -> Roadmap:
        """The roadmap of the motions that are free now, for `query`."""
        return Roadmap(self.nodes, self.pairs[self.is_open])


@algorithm
def free_pairs(
    problem: PlanningProblem, nodes: Array, pairs: NDArray[np.int64]
) -> NDArray[np.bool_]:
    """Whether the motion of each pair (m, 2) is free, (m,)."""
    free = np.empty(len(pairs), np.bool_)
    for i in range(len(pairs)):
        free[i] = problem.is_free_path(nodes[pairs[i, 0]], nodes[pairs[i, 1]])
    return free


def changing_roadmap(
    problem: ProblemRecord | Recorder, *, n: int = 500, k: int = 10, rng: int | np.random.Generator
) -> ChangingRoadmap:
    """A probabilistic roadmap for a changing world: n configurations, each with its k closest.

    The configurations may be free or not.

    Parameters
    ----------
    problem : a Problem for Point() or Disk(r).
    n, k : how many configurations are sampled, and how many closest ones each is paired with.
    rng : a seed or a numpy Generator.

    Returns
    -------
    ChangingRoadmap

    Raises
    ------
    InvalidParameter
        Where the robot is another, or a parameter is out of its range.

    Examples
    --------
    >>> import kinoedu as ke
    >>> free = np.ones((9, 9), bool)
    >>> problem = ke.Problem(ke.Point(), ke.Terrain(free), (1, 1), (8, 8))
    >>> roadmap = changing_roadmap(problem, n=50, rng=0)
    >>> free[3, 4] = False  # a rock rolls into the way
    >>> after = ke.Problem(ke.Point(), ke.Terrain(free), (1, 1), (8, 8))
    >>> roadmap_after = after_change(after, roadmap, *changed_box(problem.world, after.world))
    >>> roadmap_after.judged < roadmap.judged
    True
    >>> bool(ke.query(after, roadmap_after.roadmap()).cost >= 9.8)
    True
    """
    check_round(problem)
    generator, count = as_generator(rng), integer(n, "n", least=2)
    nodes = np.array([problem.sample(generator) for _ in range(count)])
    near = k_closest(problem, nodes, integer(k, "k", least=1))
    both = np.sort(
        np.column_stack([np.repeat(np.arange(count), near.shape[1]), near.ravel()]), axis=1
    )
    pairs = np.unique(both, axis=0).astype(np.int64)
    return ChangingRoadmap(nodes, pairs, free_pairs(problem, nodes, pairs), len(pairs))


def after_change(
    problem: ProblemRecord | Recorder, roadmap: ChangingRoadmap, lo: ArrayLike, hi: ArrayLike
) -> ChangingRoadmap:
    """The roadmap after the world has changed inside the box from lo to hi and nowhere else.

    A pair is checked again where the bounding box of its motion, grown by the robot and its
    clearance, meets the box of the change. The answers for other pairs are kept.

    Parameters
    ----------
    problem : the Problem as it is now, with the same robot.
    roadmap : the roadmap before the change.
    lo, hi : (x, y), the corners of the box.

    Returns
    -------
    ChangingRoadmap

    Raises
    ------
    InvalidParameter
        Where the robot is not round, or `roadmap` was not made by `changing_roadmap`.
    InvalidPoint
        Where lo or hi is not a point.
    """
    if not isinstance(roadmap, ChangingRoadmap):
        raise InvalidParameter(
            f"expected the roadmap that changing_roadmap made, got {shortened(roadmap)}"
        )
    reach = check_round(problem) * (1.0 + 1e-9)
    low, high = as_point(lo, "lo") - reach, as_point(hi, "hi") + reach
    a, b = roadmap.nodes[roadmap.pairs[:, 0]], roadmap.nodes[roadmap.pairs[:, 1]]
    near = ((np.minimum(a, b) <= high) & (np.maximum(a, b) >= low)).all(axis=1)
    is_open = roadmap.is_open.copy()
    is_open[near] = free_pairs(problem, roadmap.nodes, roadmap.pairs[near])
    return roadmap._replace(is_open=is_open, judged=int(near.sum()))


def changed_box(before: TerrainRecord, after: TerrainRecord) -> tuple[Array, Array]:
    """The corners of the least box that holds every cell in which two terrains differ.

    Where they do not differ it is an empty box at the origin.

    Raises
    ------
    InvalidParameter
        Where one is not a terrain, or their cells do not coincide.
    """
    for terrain in (before, after):
        if not isinstance(terrain, TerrainRecord):
            raise InvalidParameter(f"before and after must be terrains, got {shortened(terrain)}")
    same = before.free.shape == after.free.shape and before.resolution == after.resolution
    if not same or not np.array_equal(before.origin, after.origin):
        raise InvalidParameter("both terrains must have the same cells at the same place")
    rows, columns = np.nonzero(before.free != after.free)
    if not len(rows):
        return after.origin.copy(), after.origin.copy()
    corners = np.array([(columns.min(), rows.min()), (columns.max() + 1, rows.max() + 1)])
    low, high = after.origin + after.resolution * corners
    return low, high


def check_round(problem: PlanningProblem) -> float:
    """The radius of a round robot and its clearance together.

    Raises
    ------
    InvalidParameter
        Where the robot is not round.
    """
    inner = unwrap_recorder(problem)
    if not isinstance(inner, ProblemRecord) or not isinstance(inner.robot, RoundRobot):
        raise InvalidParameter("a changing roadmap needs a Problem for Point() or Disk(r)")
    return float(inner.robot.radius + inner.clearance)

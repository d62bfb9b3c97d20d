"""The exercise on visibility roadmaps. Bullo & Smith, chapter 5; LaValle, section 6.2.4."""

from collections.abc import Iterator
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....geometry.checks import Array
from ....messages import get_message
from ....planners import visibility_roadmap
from ....problems.protocols import PlanningProblem
from ...exercise import Axes, Case, Restated, Slip, ValueExercise, Verdict, format_value
from ...outcomes import Answer, Outcome
from ...shapes import Listed, Numbers, Record, Together, Value
from ...tasks import StudentProblem
from ...whole_shapes import Integers
from ...withheld import withheld
from ..decomposition.free_intervals import RING
from ..shared.planned import ProblemShape
from .halls import GOAL, START, WALL, draw_obstacles, make_hall, measure_turns
from .joining import are_pairs, keep_free, keep_semi_free, renumber_pairs
from .rules import set_title

SEEN = Together((Numbers(("n", 2)), Integers(("m", 2))))
Seen = tuple[Array, NDArray[np.int64]]
BOX = np.array([(6, 3), (10, 3), (10, 7), (6, 7)], float)
TENT = np.array([(5, 3), (11, 3), (8, 7)], float)
ANGLE = np.array([(5, 2), (11, 2), (11, 4), (7, 4), (7, 8), (5, 8)], float)
# its middle tip is convex, but not on its convex hull
CROWN = np.array([(5, 2), (11, 2), (11, 8), (9.5, 4), (8, 6), (6.5, 4), (5, 8)], float)
# its vertex on top is convex, by a millionth
FLAT = np.array([(6, 3), (10, 3), (10, 7), (8, 7.000001), (6, 7)])
# two of its angles are straight
TUB = np.array([(4, 2), (12, 2), (12, 7), (11, 7), (11, 3), (5, 3), (5, 7), (4, 7)], float)
BENT_BOX = np.array([(6, 3), (8, 3), (10, 3), (10, 5), (10, 7), (6, 7)], float)


@withheld
def build_visibility_roadmap(problem: StudentProblem, obstacles: list[Array]) -> Seen:
    """Return the library's roadmap with start and goal first."""
    roadmap = visibility_roadmap(problem)
    n = len(roadmap.nodes)
    return np.roll(roadmap.nodes, 2, axis=0), np.sort((roadmap.edges + 2) % n, axis=1)


def is_convex(ring: Array) -> Value:
    """Return which vertices turn left."""
    return measure_turns(ring) > 0.0


def is_on_hull(ring: Array) -> Value:
    """Return which vertices are corners of the convex hull."""
    import shapely

    corners = set(shapely.MultiPoint(ring).convex_hull.exterior.coords)
    return [tuple(v) in corners for v in ring.tolist()]


def join_visible(
    problem: Any, obstacles: list[Array], *, kept: Any = is_convex, join: Any = keep_semi_free
) -> Seen:
    """Return start, goal and the kept vertices, with the pairs that `join` keeps."""
    nodes = np.vstack([problem.start, problem.goal, *(ring[kept(ring)] for ring in obstacles)])
    pairs = np.argwhere(np.triu(np.ones((len(nodes), len(nodes))), 1))
    return nodes, join(problem, nodes, pairs)


def leave_ends_alone(problem: PlanningProblem, obstacles: list[Array]) -> Seen:
    """Return a roadmap whose start and goal have no edges."""
    nodes, pairs = join_visible(problem, obstacles)
    return nodes, pairs[(pairs > 1).all(axis=1)]


def join_between_obstacles(problem: PlanningProblem, obstacles: list[Array]) -> Seen:
    """Return a roadmap without edges between vertices of one obstacle."""
    nodes, pairs = join_visible(problem, obstacles)
    owner = np.concatenate(
        [
            [-1, -2],
            *(np.full(int((measure_turns(ring) > 0).sum()), i) for i, ring in enumerate(obstacles)),
        ]
    )
    return nodes, pairs[owner[pairs[:, 0]] != owner[pairs[:, 1]]]


def put_ends_last(seen: Seen, *given: Value) -> Seen:
    """Return the roadmap with start and goal as the last two nodes."""
    return renumber(seen, np.roll(np.arange(len(seen[0])), -2))


def put_ends_first(seen: Seen, *given: Value) -> Seen:
    """Return the roadmap with the last two nodes as the first ones."""
    return renumber(seen, np.roll(np.arange(len(seen[0])), 2))


def exchange_ends(seen: Seen, *given: Value) -> Seen:
    """Return the roadmap with its first two nodes exchanged."""
    order = np.arange(len(seen[0]))
    return renumber(seen, np.append(order[:2][::-1], order[2:]))


class VisibleCorners(ValueExercise):
    """Build the visibility roadmap of start, goal and convex corners."""

    name = "visibility_roadmap"
    lesson = "08_roadmaps"
    seconds = 10.0
    kinds = ("one", "bay", "straight", "several")
    given = Record(problem=ProblemShape(), obstacles=Listed(RING))
    answer = SEEN
    reference = staticmethod(build_visibility_roadmap)
    source = staticmethod(build_visibility_roadmap)
    slips = (
        Slip(
            "every_vertex",
            lambda problem, obstacles: join_visible(
                problem, obstacles, kept=lambda ring: slice(None)
            ),
        ),
        Slip(
            "not_reflex",
            lambda problem, obstacles: join_visible(
                problem, obstacles, kept=lambda ring: measure_turns(ring) > -1e-9
            ),
        ),
        Slip("hull", lambda problem, obstacles: join_visible(problem, obstacles, kept=is_on_hull)),
        Slip(
            "no_contact",
            lambda problem, obstacles: join_visible(problem, obstacles, join=keep_free),
        ),
        Slip("no_ends", leave_ends_alone),
        Slip("between", join_between_obstacles),
    )

    changes = (
        Restated("ends_last", answer=put_ends_last, usual_answer=put_ends_first),
        Restated("goal_first", answer=exchange_ends),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield a triangle, a box and a shape with a reflex vertex, then random obstacles."""
        yield make_case("one", [TENT])
        yield make_case("one", [BOX])
        yield make_case("one", [FLAT])
        yield make_case("bay", [ANGLE])
        yield make_case("bay", [CROWN])
        yield make_case("straight", [BENT_BOX])
        yield make_case("several", [WALL, TENT * 0.4 + (8, 5.5)])
        # in the mouth, between two convex vertices that follow each other
        yield make_case("several", [TUB, np.array([(7, 5), (9, 5), (8, 9)], float)])
        for i in range(12):
            shift, turned = rng.integers(-2, 3, 2), int(rng.integers(6))
            yield make_case("one", draw_obstacles_apart(rng, 1))
            bays = draw_obstacles_apart(rng, 1, convex=False)
            while (measure_turns(bays[0]) > 0).all():
                bays = draw_obstacles_apart(rng, 1, convex=False)
            yield make_case("bay", bays)
            yield make_case("straight", [np.roll(BENT_BOX + shift, turned, axis=0)])
            yield make_case("several", draw_obstacles_apart(rng, 2 + i // 4, convex=bool(i % 2)))

    def same(self, value: Value, truth: Value) -> bool:
        """Whether nodes and edges are the same; the order counts for start and goal alone."""
        (found, pairs), (nodes, edges) = value, truth
        order = find_order(found, nodes)
        if order is None:
            return False
        back = np.argsort(np.array(order))
        renamed = np.sort(back[edges], axis=1).reshape(-1, 2)
        return sorted(map(tuple, np.asarray(pairs).tolist())) == sorted(
            map(tuple, renamed.tolist())
        )

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge the order of start and goal, the convex vertices, and the pairs."""
        if self.same(value, self.truth(case)):
            return Verdict(1.0)
        (found, pairs), problem = value, case.given["problem"]
        rule = "edges" if case.kind in ("one", "several") else case.kind
        if len(found) < 2 or not np.array_equal(found[:2], [problem.start, problem.goal]):
            rule = "ends"
        elif find_order(found, self.truth(case)[0]) is None:
            rule = "nodes"
        elif not are_pairs(pairs, len(found)):
            rule = "pairs"
        return Verdict(0.0, rule, self.describe_expected(case))

    def describe_expected(self, case: Case) -> str:
        """Describe the right nodes, and how many edges are right."""
        return self.describe_answer(case, self.as_asked(self.truth(case), case))

    def describe_answer(self, case: Case, value: Value) -> str:
        """Describe the student's nodes, and how many edges there are."""
        nodes, edges = value
        return get_message(
            "visibility_roadmap.wanted",
            nodes=len(nodes),
            places=format_value(np.asarray(nodes)),
            edges=len(edges),
        )

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the right roadmap and the student's over it."""
        from .pictures import draw_roadmap_answer

        value = outcome.value if isinstance(outcome, Answer) else None
        draw_roadmap_answer(case.given["problem"], self.truth(case), value, ax)
        set_title(self, case, ax)


def renumber(seen: Seen, order: NDArray[np.int64]) -> Seen:
    """Return the roadmap whose node k is the node order[k] of this one."""
    nodes, pairs = seen
    return np.asarray(nodes)[order], renumber_pairs(pairs, np.argsort(order))


def make_case(kind: str, obstacles: list[Array]) -> Case:
    """Return a case in the hall.

    One motion is checked here, so that no compilation counts as the student's time.
    """
    problem = make_hall(*obstacles)
    problem.is_semi_free_path(problem.start, problem.goal)
    return Case(
        kind, {"problem": problem, "obstacles": [np.array(ring, float) for ring in obstacles]}
    )


def draw_obstacles_apart(rng: np.random.Generator, n: int, *, convex: bool = True) -> list[Array]:
    """Draw obstacles such that no three of their vertices, start and goal are in line.

    Three points with two decimals can be in line exactly, yet miss that after rounding by less
    than the collision check can tell.
    """
    rings = draw_obstacles(rng, n, convex=convex)
    while is_in_line(np.vstack([START, GOAL, *rings])):
        rings = draw_obstacles(rng, n, convex=convex)
    return rings


def is_in_line(points: Array) -> bool:
    """Whether any three of the points are in line, up to rounding."""
    a, b, c = (points[at] for at in np.array(list(combinations(range(len(points)), 3))).T)
    (ux, uy), (vx, vy) = (b - a).T, (c - a).T
    return bool((np.abs(ux * vy - uy * vx) < 1e-9).any())


def find_order(found: Array, nodes: Array) -> list[int] | None:
    """Return the right index of each found node, start and goal first.

    Returns
    -------
    A list; None where the nodes differ.
    """
    numbers = {tuple(node): i for i, node in enumerate(np.asarray(nodes).tolist())}
    order = [numbers.get(tuple(node), -1) for node in np.asarray(found).tolist()]
    return order if sorted(order) == list(range(len(nodes))) and order[:2] == [0, 1] else None

"""The exercise on one insertion of RRT*.

S. Karaman, E. Frazzoli, "Sampling-based algorithms for optimal motion planning" (2011).
"""

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ....geometry.checks import Array
from ....planners.trees.rrt_star import grow_shortest
from ....problems import Problem, Tree
from ....problems.protocols import PlanningProblem, ProblemLike
from ....robots import Point
from ....worlds import PolygonWorld
from ...exercise import Axes, Case, Given, Restated, Slip, ValueExercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Number, Numbers, Record, Together, Value
from ...tasks import StudentProblem
from ...whole_shapes import Integers
from ...withheld import withheld
from ..roadmaps.halls import is_arm, make_arm
from ..shared.planned import NODES, Fault, ProblemShape
from ..shared.planned_pictures import draw_answer
from ..shared.small_problems import box, in_room
from .rrt import grow_tree
from .tree_forms import (
    Insertion,
    double_cost,
    double_costs,
    halve_cost,
    halve_costs,
    put_new_first,
    put_new_last,
)

LISTS = Integers(("n",)), Numbers(("n",))
OPEN = in_room((1, 1), (9, 9))
WALL = in_room((1, 1), (9, 9), box(4, 3, 4.6, 8))
ARM = make_arm()
WIDE = StudentProblem(
    Problem(Point(), PolygonWorld(box(0, 0, 20_000, 20_000)), (1_000, 1_000), (19_000, 19_000))
)
Parents = NDArray[np.int64]


class WithoutObstacles(NamedTuple):
    """The distances of a problem in which every motion is free."""

    distance: Callable[[Array, Array], float]

    def is_free_path(self, a: Array, b: Array) -> bool:
        """Accept every motion."""
        return True


@withheld
def insert_node(
    problem: Any,
    nodes: Array,
    parent: Parents,
    cost: Array,
    q_new: Array,
    radius: float,
) -> Insertion:
    """Insert a node into a tree as RRT* does.

    Returns
    -------
    Parents and costs of n + 1 nodes, the new one last.
    """
    near, apart = find_neighbours(problem, nodes, q_new, radius)
    best = min(near, key=lambda i: cost[i] + apart[i])
    return rewire(near, apart, *attach(parent, cost, best, apart[best]))


def find_neighbours(
    problem: ProblemLike, nodes: Array, q_new: Array, radius: float
) -> tuple[list[int], list[float]]:
    """Return the nodes in the radius with a free motion, and the distance of every node."""
    apart = [problem.distance(q, q_new) for q in nodes]
    near = [i for i, q in enumerate(nodes) if apart[i] <= radius and problem.is_free_path(q, q_new)]
    return near, apart


def attach(parent: Parents, cost: Array, best: int, distance: float) -> Insertion:
    """Append a node whose parent is `best`."""
    return [*parent.tolist(), best], [*cost.tolist(), cost[best] + distance]


def find_descendants(node: int, parents: list[int]) -> list[int]:
    """Return a node and all nodes below it; the last of all nodes is not looked at."""
    return [j for j in range(len(parents) - 1) if node in find_ancestors(j, parents)]


def rewire(
    near: list[int],
    apart: list[float],
    parents: list[int],
    costs: list[float],
    *,
    lowered: Callable[[int, list[int]], list[int]] = find_descendants,
) -> Insertion:
    """Make the last node the parent of each neighbour that becomes cheaper by it.

    Parameters
    ----------
    lowered : returns the nodes whose cost falls together with that of a neighbour.
    """
    for i in near:
        gain = costs[i] - (costs[-1] + apart[i])
        if gain > 0.0:
            parents[i] = len(apart)
            for j in lowered(i, parents):
                costs[j] -= gain
    return parents, costs


def insert_at_nearest(
    problem: PlanningProblem,
    nodes: Array,
    parent: Parents,
    cost: Array,
    q_new: Array,
    radius: float,
) -> Insertion:
    """Take the nearest neighbour as the parent instead of the cheapest."""
    near, apart = find_neighbours(problem, nodes, q_new, radius)
    best = min(near, key=lambda i: apart[i])
    return rewire(near, apart, *attach(parent, cost, best, apart[best]))


def insert_without_rewiring(
    problem: PlanningProblem,
    nodes: Array,
    parent: Parents,
    cost: Array,
    q_new: Array,
    radius: float,
) -> Insertion:
    """Choose the parent of the new node, and change no other node."""
    near, apart = find_neighbours(problem, nodes, q_new, radius)
    best = min(near, key=lambda i: cost[i] + apart[i])
    return attach(parent, cost, best, apart[best])


def insert_without_descendants(*given: Value) -> Insertion:
    """Rewire neighbours, and leave the costs of their descendants as they were."""
    problem, nodes, _, _, q_new, radius = given
    near, apart = find_neighbours(problem, nodes, q_new, radius)
    tree = insert_without_rewiring(*given)
    return rewire(near, apart, *tree, lowered=lambda i, parents: [i])


def insert_unchecked(problem: Any, *given: Value) -> Insertion:
    """Insert a node as if every motion were free."""
    return insert_node(WithoutObstacles(problem.distance), *given)


def find_ancestors(node: int, parent: list[int]) -> list[int]:
    """Return a node, its parent, its parent's parent, and so on to the root."""
    way = []
    while node >= 0:
        way.append(node)
        node = parent[node]
    return way


class Insert(ValueExercise):
    """Attach a new node at least cost, and rewire its neighbours where that is cheaper."""

    name = "insert"
    lesson = "09_trees"
    kinds = ("parent", "rewire", "below", "blocked", "grown")
    given = Record(
        problem=ProblemShape(),
        nodes=NODES,
        parent=LISTS[0],
        cost=LISTS[1],
        q_new=Numbers(("d",)),
        radius=Number(),
    )
    answer = Together(LISTS)
    source = staticmethod(insert_node)
    shown = staticmethod(grow_shortest)
    slips = (
        Slip("nearest", insert_at_nearest),
        Slip("no_rewiring", insert_without_rewiring),
        Slip("not_below", insert_without_descendants),
        Slip("unchecked", insert_unchecked),
    )

    reference = staticmethod(insert_node)

    changes = (
        Restated("new_first", answer=put_new_first, usual_answer=put_new_last),
        Restated(
            "half_speed",
            answer=double_costs,
            usual_answer=halve_costs,
            given=double_cost,
            usual_given=halve_cost,
        ),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield cases that can be done on paper, then random ones of each kind."""
        yield make_case("parent", OPEN, [(1, 1), (4, 1), (5, 1.5)], [-1, 0, 1], (3, 3), 3.0)
        yield make_case("parent", OPEN, [(1, 1), (1, 5), (5, 5)], [-1, 0, 0], (7, 8), 7.0)
        # the root is exactly at the radius
        yield make_case("parent", OPEN, [(1, 1), (1, 5), (6, 5)], [-1, 0, 0], (4, 5), 5.0)
        places = [(1_000, 1_000), (1_000, 16_000), (9_000, 16_000)]
        yield make_case("parent", WIDE, places, [-1, 0, 1], (5_000, 19_000), 5_500.0)
        # the first node of the arm is near, because its angle wraps
        yield make_case("parent", ARM, [(3.0, 0.3), (-2.5, 0.5)], [-1, 0], (-3.0, 0.3), 0.6)
        yield make_case("rewire", OPEN, [(1, 1), (1, 5), (5, 5)], [-1, 0, 1], (3, 3), 3.0)
        yield make_case(
            "rewire", OPEN, [(1, 1), (1, 4), (4, 6.5), (6.5, 4)], [-1, 0, 1, 2], (4, 4), 4.5
        )
        yield make_case("below", OPEN, [(1, 1), (1, 5), (5, 5), (9, 5)], [-1, 0, 1, 2], (3, 3), 3.0)
        yield make_case(
            "below", OPEN, [(1, 1), (9, 9), (9, 5), (5, 5), (1, 5)], [-1, 2, 3, 4, 0], (3, 3), 3.0
        )
        yield make_case(
            "below", OPEN, [(1, 1), (1, 5), (5, 5), (9, 5), (9, 9)], [-1, 0, 1, 2, 3], (3, 3), 3.0
        )
        # numbers fall all the way down
        places = [(1, 1), (5, 9), (9, 9), (9, 5), (5, 5), (1, 5)]
        yield make_case("below", OPEN, places, [-1, 2, 3, 4, 5, 0], (3, 3), 3.0)
        places = [(1, 1), (1, 9), (3, 9), (5, 9), (9, 9), (9, 5), (5, 5), (1, 5)]
        yield make_case("below", OPEN, places, [-1, 2, 3, 4, 5, 6, 7, 0], (3, 3), 3.0)
        yield make_case(
            "blocked", WALL, [(1, 1), (2, 2), (5, 2), (6, 5)], [-1, 0, 0, 2], (3.5, 4), 3.0
        )
        # the motion to node 2 only touches the corner of the wall
        touched = in_room((1, 1), (9, 9), box(4, 3, 5, 8))
        yield make_case("blocked", touched, [(1, 1), (7, 2), (6, 5)], [-1, 0, 1], (4, 1), 5.0)
        left = {**dict.fromkeys(self.kinds, 12), "blocked": 11}
        while any(left.values()):
            blocked = bool(rng.random() < 0.5)
            case = draw_case(rng, WALL if blocked else OPEN, int(rng.integers(3, 8)))
            if case is not None and left[case.kind]:
                left[case.kind] -= 1
                yield case
            if left["grown"]:
                left["grown"] -= 1
                yield grow_case(rng, WALL)

    def same(self, value: Value, truth: Value) -> bool:
        """Whether the parents are the same, and the costs up to rounding."""
        return (
            len(value[0]) == len(truth[0])
            and (np.array(value[0]) == truth[0]).all()
            and super().same(value[1], truth[1])
        )

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge parents and costs; the rule is that of the first step that is wrong."""
        verdict = super().value_verdict(case, value)
        parent, cost = self.truth(case)
        new = len(parent) - 1
        lengths_differ = not len(value[0]) == len(value[1]) == len(parent)
        if verdict.is_right or lengths_differ or differs(value, parent, cost, new):
            return verdict
        if list(value[0]) != list(parent):
            return verdict if case.kind == "blocked" else verdict._replace(rule="rewire")
        wrong = next(i for i in range(new) if differs(value, parent, cost, i))
        return verdict._replace(rule="costs" if parent[wrong] == new else "below")

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the right tree, and a cross at the first node with a wrong parent or cost."""
        from ....figures import palette, plane
        from ....figures.robots import place_of

        problem = case.given["problem"]
        nodes = np.vstack([case.given["nodes"], case.given["q_new"]])
        parent, cost = self.truth(case)
        trees, fault = [Tree(nodes, np.array(parent))], None
        if isinstance(outcome, Answer):
            wrong = (i for i in range(len(nodes)) if differs(outcome.value, parent, cost, i))
            first = next(wrong, None)
            fault = None if first is None else Fault("", nodes[first : first + 1])
        draw_answer(problem.problem, trees, None, fault, self.message(f"pictures.{case.kind}"), ax)
        if not is_arm(problem):
            plane.ring(nodes[-1], case.given["radius"], "", ax, colour=palette.OUTSIDE, style=":")
        if len(nodes) <= 9:
            for number, (q, c) in enumerate(zip(nodes, cost)):
                offset, place = (8, -16 if number % 2 else 8), place_of(problem.robot, q)
                plane.label(place, f"{number}: {c:.3g}", ax, colour=palette.INK, offset=offset)


def differs(value: Value, parent: list[int], cost: list[float], i: int) -> bool:
    """Whether an answer has another parent or another cost for node i."""
    parents, costs = value
    return (
        i >= min(len(parents), len(costs))
        or parents[i] != parent[i]
        or not abs(costs[i] - cost[i]) < 1e-6
    )


def make_case(
    kind: str,
    problem: StudentProblem,
    nodes: object,
    parent: Value,
    q_new: object,
    radius: float,
) -> Case:
    """Return a case with the costs that belong to its tree."""
    places, above = np.array(nodes, float), np.array(parent)
    cost = np.zeros(len(places))
    for i in range(len(places)):
        way = find_ancestors(i, parent)
        cost[i] = sum(problem.distance(places[a], places[b]) for a, b in zip(way, way[1:]))
    tree = {"problem": problem, "nodes": places, "parent": above, "cost": cost}
    return Case(kind, {**tree, "q_new": np.array(q_new, float), "radius": radius})


def draw_case(rng: np.random.Generator, problem: StudentProblem, n: int) -> Case | None:
    """Draw a small free tree and a new node, and classify the case.

    Returns
    -------
    The case; None where two answers would be nearly equally good, or where a wall is between
    neighbours and a node is rewired as well: each part of the idea has kinds of its own.
    """
    nodes = np.round(rng.uniform(0.5, 9.5, (n, 2)), 1)
    nodes[0] = problem.start
    above = [int(rng.integers(i)) * int(rng.integers(2)) for i in range(1, n)]
    number = [0, *(1 + rng.permutation(n - 1)).tolist()]  # a parent may have a larger number
    parent = [-1] * n
    for i, p in enumerate(above, 1):
        parent[number[i]] = number[p]
    q_new = np.round(rng.uniform(1.0, 9.0, 2), 1)
    case = make_case("", problem, nodes, parent, q_new, round(float(rng.uniform(3.0, 6.0)), 1))
    if not is_fair(case.given):
        return None
    kind = classify(case.given)
    return None if kind == "blocked" and is_rewired(case.given) else case._replace(kind=kind)


def grow_case(rng: np.random.Generator, problem: StudentProblem) -> Case:
    """Draw a tree of an RRT with two nodes inserted, and a new node near it."""
    nodes, parent, _ = grow_tree(
        problem, 1.0, 0.0, int(rng.integers(20, 80)), int(rng.integers(10**6))
    )
    for left in (2, 1, 0):
        while True:
            q_new = nodes[int(rng.integers(len(nodes)))] + np.round(rng.uniform(-0.6, 0.6, 2), 2)
            case = make_case("grown", problem, nodes, parent, q_new, 1.5)
            if is_fair(case.given):
                break
        if left:
            nodes, parent = [*nodes, q_new], insert_node(*case.given.values())[0]
    return case


@withheld
def is_fair(given: Given) -> bool:
    """Whether the case is valid and no two costs that are compared are nearly equal.

    It is valid if the tree is free and the new node has a neighbour with a free motion.
    """
    problem, nodes, parent, cost, q_new, radius = given.values()
    if (
        not all(problem.is_free(q) for q in (*nodes, q_new))
        or problem.distance(problem.start, q_new) == 0.0
    ):
        return False
    if not all(problem.is_free_path(nodes[p], q) for p, q in zip(parent[1:], nodes[1:])):
        return False
    near, distances = find_neighbours(problem, nodes, q_new, radius)
    apart = np.array(distances)
    if not near or (np.abs(apart - radius) < 1e-6).any() or (apart < 1e-3).any():
        return False
    through = np.sort(cost[near] + apart[near])
    gains = cost[near] - through[0] - apart[near]
    return bool((np.diff(through) > 1e-3).all() and (np.abs(gains) > 1e-3).all())


@withheld
def classify(given: Given) -> str:
    """Return which part of the insertion the case needs."""
    truth = insert_node(*given.values())
    if insert_unchecked(*given.values()) != truth:
        return "blocked"
    if insert_without_descendants(*given.values()) != truth:
        return "below"
    return "rewire" if is_rewired(given) else "parent"


@withheld
def is_rewired(given: Given) -> bool:
    """Whether a node gets another parent by the insertion."""
    return bool(insert_node(*given.values())[0][:-1] != given["parent"].tolist())

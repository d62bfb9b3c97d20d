"""The exercises that ask for the two planners of the document: RRT and PRM on a bitmap, with its parameters."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from ...geometry.checks import Array
from ...graphs import Graph, astar, extract_path
from ...planners.prm import prm
from ...planners.rrt import grow
from ...problems import Problem, Tree
from ...robots import Point
from ...worlds import Terrain
from ..exercise import Case
from ..shapes import Maybe, Number, Record, Together
from ..whole_shapes import Whole, WholeNumbers
from .planned import (
    NODES,
    PATH,
    Asked,
    Fault,
    PlannerExercise,
    Task,
    empty_boxes,
    not_along_tree,
    not_to_nearest,
    three_times,
    why_not_a_path,
    why_not_a_tree,
)

STEP, SPACING, FAILURES = 6.0, 3.0, 400
KINDS = ("same", "open", "thin", "bag", "sealed")
SMALL = 40  # cells either way


def on_terrain(blocked: Any, start: Any, goal: Any) -> Asked:
    """A point on a terrain of 40 x 40 cells; blocked boxes (x0, y0, x1, y1)."""
    free = np.ones((SMALL, SMALL), np.bool_)
    for x0, y0, x1, y1 in blocked:
        free[y0:y1, x0:x1] = False
    return Asked(Problem(Point(), Terrain(free), start, goal))


TERRAINS = {
    "same": on_terrain([], (20.5, 20.5), (20.5, 20.5)),
    "open": on_terrain([(17, 12, 20, 16)], (5.5, 5.5), (34.5, 33.5)),
    "thin": on_terrain([(33, 14, 34, 26)], (6.5, 20.5), (35.5, 20.5)),  # one cell thick, less than a step before the goal
    "bag": on_terrain([(26, 10, 28, 30), (14, 10, 28, 12), (14, 28, 28, 30)], (22.5, 20.5), (34.5, 20.5)),
    "sealed": on_terrain([(28, 28, 40, 30), (28, 28, 30, 40)], (5.5, 5.5), (35.5, 35.5)),
}


class TerrainPlanner(PlannerExercise):
    """A planner on small terrains that are traps."""

    lesson = "10_terrains"
    kinds = KINDS

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Each terrain twice, and rocks by chance."""
        for _ in range(2):
            for kind, problem in TERRAINS.items():
                yield self.asked(kind, problem, int(rng.integers(1000)))
        for _ in range(2):
            corners = rng.integers(8, 28, (5, 2))
            rocks = [(x, y, x + 4, y + 4) for x, y in corners.tolist()]
            yield self.asked("open", on_terrain(rocks, (3.5, 3.5), (36.5, 36.5)), int(rng.integers(1000)))

    def asked(self, kind: str, problem: Asked, rng: int) -> Case:
        """The case of a problem, with a seed."""
        raise NotImplementedError

    def fault_of_end(self, case: Case, path: Array | None) -> Fault | None:
        """What is wrong with a path, or with there being none where there is a way."""
        if path is None:
            return None if case.kind == "sealed" else Fault("missed", np.empty((0, 2)))
        return why_not_a_path(case.given["problem"], path)


def own_rrt(problem: Any, step: float, spacing: float, goal_bias: float, failures: int, rng: int) -> Any:
    """RRT as the exercise asks for it."""
    chance, nodes, parent, in_a_row = np.random.default_rng(rng), [problem.start], [-1], 0

    def reached(q: Array) -> bool:
        return problem.distance(q, problem.goal) <= step and problem.is_free_path(q, problem.goal)

    while in_a_row < failures and not reached(nodes[-1]):
        q_rand = problem.goal if chance.random() < goal_bias else problem.sample(chance)
        near = int(np.argmin([problem.distance(q, q_rand) for q in nodes]))
        q_new = problem.steer(nodes[near], q_rand, step)
        in_a_row += 1
        apart = min(problem.distance(q, q_new) for q in nodes) >= spacing
        if apart and problem.is_free_path(nodes[near], q_new):
            nodes.append(q_new)
            parent.append(near)
            in_a_row = 0
    if in_a_row == failures:
        return nodes, parent, None
    nodes.append(problem.goal)
    parent.append(len(nodes) - 2)
    return nodes, parent, np.array(nodes)[extract_path(np.array(parent), len(nodes) - 1)]


class RrtOnTerrain(TerrainPlanner):
    """One tree, half of whose samples are the goal, given up after so many failures in a row."""

    name = "rrt_on_terrain"
    given = Record(problem=Task(), step=Number(), spacing=Number(), goal_bias=Number(), failures=Whole(), rng=Whole())
    result = Together((NODES, WholeNumbers(("n",)), Maybe(PATH)))
    answer = three_times(result)
    source = staticmethod(own_rrt)
    shown = staticmethod(grow)

    def asked(self, kind: str, problem: Asked, rng: int) -> Case:
        """Fewer failures where there is no way: a tree that nothing stops grows for ever."""
        failures = 40 if kind == "sealed" else FAILURES
        tuning = {"step": STEP, "spacing": SPACING, "goal_bias": 0.5, "failures": failures}
        return Case(kind, {"problem": problem, **tuning, "rng": rng})

    def fault(self, case: Case, answer: Any) -> Fault | None:
        """The path; the tree and its rule; whether the one belongs to the other; where it gave up."""
        nodes, parent, path = answer
        problem = case.given["problem"]
        fault = None if path is None else self.fault_of_end(case, path)
        fault = fault or why_not_a_tree(problem, nodes, parent, case.given["step"]) or not_to_nearest(problem, nodes, parent)
        fault = fault or too_near(problem, nodes, case.given["spacing"])
        if fault is None and path is not None:
            fault = not_along_tree(path, nodes, parent)
        if fault is None and case.kind == "sealed" and len(nodes) < LEAST:
            fault = Fault("gave_up", nodes[:0])
        return fault or self.fault_of_end(case, path)

    def drawn(self, answer: Any) -> tuple[list[Tree], Array | None]:
        """The tree and the path."""
        nodes, parent, path = answer
        return [Tree(nodes, parent)], path


LEAST = 45  # nodes of a tree that has filled what is not sealed: it has 60 and more


def too_near(problem: Any, nodes: Array, spacing: float) -> Fault | None:
    """A node that is nearer than the spacing to an earlier one, the goal excepted."""
    for i in range(1, len(nodes)):
        apart = [problem.distance(q, nodes[i]) for q in nodes[:i]]
        if min(apart) < spacing * (1.0 - 1e-9) and not np.array_equal(nodes[i], problem.goal):
            return Fault("too_near", nodes[[int(np.argmin(apart)), i]])
    return None


def bounds(problem: Any) -> tuple[Array, Array]:
    """The corners of a problem's world."""
    return problem.world.lo, problem.world.hi


def own_prm(problem: Any, n: int, rng: int) -> Any:
    """PRM as the exercise asks for it."""
    chance, nodes = np.random.default_rng(rng), [problem.start, problem.goal]
    while len(nodes) < n + 2:
        q = problem.sample(chance)
        if problem.is_free(q):
            nodes.append(q)
    edges = [(i, j) for i in range(n + 2) for j in range(i + 1, n + 2) if problem.is_free_path(nodes[i], nodes[j])]
    numbers = shortest(problem, np.array(nodes), np.array(edges))
    return nodes, edges, None if numbers is None else np.array(nodes)[numbers]


def shortest(problem: Any, nodes: Array, edges: Array) -> Any:
    """The numbers of the nodes on a shortest path from node 0 to node 1, or None."""
    lengths = [problem.distance(nodes[i], nodes[j]) for i, j in edges]
    return astar(Graph(len(nodes), np.reshape(edges, (-1, 2)), np.array(lengths)), 0, 1, np.zeros(len(nodes)))[0]


class PrmOnTerrain(TerrainPlanner):
    """A roadmap of so many free samples, every free pair joined, and a shortest path on it."""

    name = "prm_on_terrain"
    given = Record(problem=Task(), n=Whole(), rng=Whole())
    result = Together((NODES, WholeNumbers(("m", 2)), Maybe(PATH)))
    answer = three_times(result)
    source = staticmethod(own_prm)
    shown = staticmethod(prm)

    def asked(self, kind: str, problem: Asked, rng: int) -> Case:
        """Enough samples for every trap."""
        return Case(kind, {"problem": problem, "n": 8 if kind == "same" else 40, "rng": rng})

    def uses_chance(self, case: Case) -> bool:
        """Nodes are drawn in every case."""
        return True

    def fault(self, case: Case, answer: Any) -> Fault | None:
        """The nodes; the edges, each free pair once; the path, along them, and as short as they allow."""
        nodes, edges, path = answer
        problem, n = case.given["problem"], case.given["n"]
        fault = fault_of_nodes(problem, nodes, n) or fault_of_edges(problem, nodes, edges)
        if fault is not None or path is None:
            known = fault is not None or shortest(problem, nodes, edges) is None
            return fault if known else Fault("missed", nodes[:0])
        return self.fault_of_end(case, path) or fault_of_way(problem, nodes, edges, path)

    def drawn(self, answer: Any) -> tuple[list[Tree], Array | None]:
        """The nodes, as trees of one node each, and the path."""
        nodes, _, path = answer
        return [Tree(nodes, np.full(len(nodes), -1))], path


def fault_of_nodes(problem: Any, nodes: Array, n: int) -> Fault | None:
    """Start, goal and n free samples from everywhere."""
    if len(nodes) != n + 2:
        return Fault("count", nodes[:0])
    if not (np.array_equal(nodes[0], problem.start) and np.array_equal(nodes[1], problem.goal)):
        return Fault("ends_first", nodes[:2])
    for q in nodes:
        if not problem.problem.is_free(q):
            return Fault("free_node", q[None])
    return Fault("corner", nodes[:0]) if n >= 40 and empty_boxes(nodes, *bounds(problem), 2) else None


def fault_of_edges(problem: Any, nodes: Array, edges: Array) -> Fault | None:
    """Every free pair, each once and no other."""
    if len(edges) and (edges.min() < 0 or edges.max() >= len(nodes)):
        return Fault("numbers_of_nodes", nodes[:0])
    pairs = {(min(i, j), max(i, j)) for i, j in edges.tolist()}
    if len(pairs) < len(edges) or any(i == j for i, j in pairs):
        return Fault("once", nodes[:0])
    for i in range(len(nodes)):
        for j in range(i + 1, len(nodes)):
            if ((i, j) in pairs) != bool(problem.problem.is_free_path(nodes[i], nodes[j])):
                return Fault("free" if (i, j) in pairs else "all_pairs", nodes[[i, j]])
    return None


def fault_of_way(problem: Any, nodes: Array, edges: Array, path: Array) -> Fault | None:
    """A path along the edges, no longer than the shortest."""
    at = [int(np.argmin(((nodes - q) ** 2).sum(axis=1))) for q in path]
    pairs = {(i, j) for i, j in edges.tolist()} | {(j, i) for i, j in edges.tolist()}
    for a, b, i, j in zip(path[:-1], path[1:], at[:-1], at[1:]):
        on_nodes = np.allclose(nodes[[i, j]], [a, b], rtol=0.0, atol=1e-9)
        if not on_nodes or ((i, j) not in pairs and i != j):
            return Fault("along_edges", np.array([a, b]))
    best = nodes[shortest(problem, nodes, edges)]
    found, least = (sum(problem.distance(a, b) for a, b in zip(way[:-1], way[1:])) for way in (path, best))
    return Fault("shortest", nodes[:0]) if found > least + 1e-6 * (1.0 + least) else None

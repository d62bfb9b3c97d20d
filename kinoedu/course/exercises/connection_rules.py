"""Exercises on the rules by which a roadmap's nodes are joined. Bullo & Smith, chapter 5; LaValle, section 5.6."""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...geometry.checks import Array
from ..exercise import RIGHT, Case, Slip, ValueExercise, Verdict
from ..outcomes import Answer, Outcome
from ..shapes import Number, Numbers, Record
from ..whole_shapes import Whole, WholeNumbers
from .hall_worlds import ASTRIDE, GRAZING, SHEET, WALL, arm, distances, free_nodes, hall, random_obstacles
from .joining import allowed, are_pairs, by_samples, closest_rows, in_components, unique, with_contact, without_wrap
from .planned import Task
from .roadmap_pictures import draw_joined

Pairs = NDArray[np.int64]
NODES = Numbers(("n", 2))
PAIRS = WholeNumbers(("m", 2))
ROUND = 12  # random cases of each kind


def radius_pairs(problem: Any, nodes: Array, r: float) -> Pairs:
    """The pairs at most r apart whose motion is free."""
    return allowed(problem, nodes, np.argwhere(np.triu(distances(problem, nodes) <= r, 1)))


def closest_pairs(problem: Any, nodes: Array, k: int) -> Pairs:
    """The pairs of which one is among the other's k closest, and whose motion is free."""
    return allowed(problem, nodes, unique(closest_rows(problem, nodes, k)))


def component_pairs(problem: Any, nodes: Array, k: int) -> Pairs:
    """Each node in turn joined to every component of those before it, by the first free motion to one of its k closest."""
    return in_components(problem, nodes, k)


class RuleExercise(ValueExercise):
    """From a problem, nodes and a number to the pairs of nodes that are joined, in any order."""

    lesson = "08_roadmaps"
    seconds = 10.0
    answer = PAIRS

    def same(self, value: Any, truth: Any) -> bool:
        """The same pairs, as often, in any order."""
        return bool(sorted(map(tuple, np.asarray(value).tolist())) == sorted(map(tuple, np.asarray(truth).tolist())))

    def value_verdict(self, case: Case, value: Any) -> Verdict:
        """Pairs of numbers of nodes, the smaller first, each once; their motions free; and the right ones."""
        problem, nodes, _ = case.given.values()
        wanted = self.wanted(case)
        if not are_pairs(value, len(nodes)):
            return Verdict(0.0, "pairs", wanted)
        if len(allowed(problem, nodes, value)) < len(value):
            return Verdict(0.0, "motion", wanted)
        return RIGHT if self.same(value, self.truth(case)) else Verdict(0.0, case.kind, wanted)

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """The nodes with their numbers, the right edges and the student's."""
        value = outcome.value if isinstance(outcome, Answer) else None
        draw_joined(case.given["problem"], case.given["nodes"], self.truth(case), value, ax)
        titled(self, case, ax)


def titled(exercise: Any, case: Case, ax: Any) -> None:
    """What to see in the picture of this kind of input."""
    from ...figures import plane

    plane.title(exercise.words(f"pictures.{case.kind}"), ax)


class RadiusNeighbours(RuleExercise):
    """The r-radius rule."""

    name = "radius_neighbours"
    kinds = ("pair", "wall", "many", "torus")
    given = Record(problem=Task(), nodes=NODES, r=Number())
    reference = staticmethod(radius_pairs)
    source = staticmethod(radius_pairs)
    slips = (
        Slip("strict", lambda p, q, r: radius_pairs(p, q, np.nextafter(r, 0.0))),
        Slip("blind", lambda p, q, r: np.argwhere(np.triu(distances(p, q) <= r, 1))),
        Slip("twice", lambda p, q, r: np.vstack([radius_pairs(p, q, r), radius_pairs(p, q, r)[:, ::-1]])),
        Slip("itself", lambda p, q, r: np.vstack([radius_pairs(p, q, r), np.repeat(np.arange(len(q)), 2).reshape(-1, 2)])),
        Slip("straight", lambda p, q, r: radius_pairs(without_wrap(p), q, r)),
        Slip("touching", lambda p, q, r: radius_pairs(with_contact(p), q, r)),
        Slip("sampled", lambda p, q, r: radius_pairs(by_samples(p), q, r)),
        Slip("squared", lambda p, q, r: radius_pairs(p, q, np.sqrt(r))),
        Slip("diameter", lambda p, q, r: radius_pairs(p, q, r / 2)),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Two nodes, three, a wall; then many."""
        for row, far in ((((2, 2), (4, 2)), 3), (((2, 2), (6, 5)), 5), (((2, 2), (6, 5)), 4), (((1, 1), (4, 5), (7, 1)), 5)):
            yield rule_case("pair", hall(), row, float(far))
        yield rule_case("wall", hall(WALL), ((5, 3), (11, 3)), 8.0)
        yield rule_case("wall", hall(WALL), ((5, 3), (11, 3), (8, 8)), 8.0)
        yield from two_nodes(8.0)
        for i in range(ROUND):
            at = rng.integers(1, 5, 2)
            yield rule_case("pair", hall(), (at, at + ((3, 4), (4, 3))[i % 2]), (5.0, 4.5, 5.0, 5.5)[i % 4])
            for kind, problem in worlds(rng, i):
                r = float(rng.integers(2, 6)) if kind != "torus" else round(float(rng.uniform(1.0, 2.0)), 2)
                yield rule_case(kind, problem, free_nodes(rng, problem, 4 + i), r)


class KClosestNeighbours(RuleExercise):
    """The K-closest rule."""

    name = "k_closest"
    kinds = ("few", "one_sided", "ties", "wall", "many", "torus")
    given = Record(problem=Task(), nodes=NODES, k=Whole())
    reference = staticmethod(closest_pairs)
    source = staticmethod(closest_pairs)
    slips = (
        Slip("farthest", lambda p, q, k: allowed(p, q, unique(closest_rows(p, q, k, farthest=True)))),
        Slip("blind", lambda p, q, k: unique(closest_rows(p, q, k))),
        Slip("itself", lambda p, q, k: closest_pairs(p, q, k - 1)),
        Slip("replaced", lambda p, q, k: unique(closest_rows(p, q, k, only_free=True))),
        Slip("mutual", lambda p, q, k: allowed(p, q, twice_named(closest_rows(p, q, k)))),
        Slip("lost", lambda p, q, k: allowed(p, q, upwards(closest_rows(p, q, k)))),
        Slip("later", lambda p, q, k: allowed(p, q, unique(closest_rows(p, q, k, only_later=True)))),
        Slip("straight", lambda p, q, k: closest_pairs(without_wrap(p), q, k)),
        Slip("touching", lambda p, q, k: closest_pairs(with_contact(p), q, k)),
        Slip("sampled", lambda p, q, k: closest_pairs(by_samples(p), q, k)),
        Slip("one", lambda p, q, k: closest_pairs(p, q, 1)),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Three nodes, a node that is nobody's closest, ties on squared paper, a wall; then many."""
        row, tail = ((1, 1), (3, 1), (6, 1)), ((6, 1), (3, 1), (1, 1))
        yield rule_case("few", hall(), row[:2], 1)
        yield rule_case("few", hall(), row, 2)
        yield rule_case("few", hall(), row, 5)
        yield rule_case("one_sided", hall(), row, 1)
        yield rule_case("one_sided", hall(), tail, 1)
        yield rule_case("one_sided", hall(), ((3, 1), (1, 1), (6, 1)), 1)
        yield rule_case("ties", hall(), ((5, 5), (3, 5), (7, 5), (5, 1)), 1)
        yield rule_case("wall", hall(WALL), ((6, 3), (10, 3), (1, 3), (1, 4)), 1)
        yield from two_nodes(1)
        for i in range(ROUND):
            yield rule_case("few", hall(), free_nodes(rng, hall(), 3), int(rng.integers(2, 5)))
            yield rule_case("one_sided", hall(), chain(rng), 1)
            yield rule_case("ties", hall(), rng.permutation(lattice(2 + i % 3)), int(rng.integers(1, 4)))
            for kind, problem in worlds(rng, i):
                yield rule_case(kind, problem, free_nodes(rng, problem, 4 + i), int(rng.integers(1, 4)))


class ComponentNeighbours(RuleExercise):
    """The component-wise K-closest rule."""

    name = "component_k_closest"
    kinds = ("few", "parts", "wall", "many", "torus")
    given = Record(problem=Task(), nodes=NODES, k=Whole())
    reference = staticmethod(component_pairs)
    source = staticmethod(component_pairs)
    slips = (
        Slip("blind", lambda p, q, k: in_components(p, q, k, blind=True)),
        Slip("goes_on", lambda p, q, k: in_components(p, q, k, goes_on=True)),
        Slip("one_component", lambda p, q, k: in_components(p, q, k, one=True)),
        Slip("nearest_only", lambda p, q, k: in_components(p, q, 1)),
        Slip("any_number", lambda p, q, k: in_components(p, q, len(q))),
        Slip("closest", closest_pairs),
        Slip("straight", lambda p, q, k: component_pairs(without_wrap(p), q, k)),
        Slip("touching", lambda p, q, k: component_pairs(with_contact(p), q, k)),
        Slip("sampled", lambda p, q, k: component_pairs(by_samples(p), q, k)),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """A row, two parts that a third node joins, a wall round which the second closest leads; then many."""
        apart = ((6, 3), (10, 3), (8, 8))
        yield rule_case("few", hall(), ((1, 1), (3, 1)), 1)
        yield rule_case("few", hall(), ((1, 1), (3, 1), (6, 1)), 1)
        yield rule_case("parts", hall(WALL), apart, 1)
        yield rule_case("wall", hall(WALL), ((10, 3), (10, 8), (6, 4)), 1)
        yield rule_case("wall", hall(WALL), ((10, 3), (10, 8), (6, 4)), 2)
        yield from two_nodes(1)
        for i in range(ROUND):
            yield rule_case("few", hall(), free_nodes(rng, hall(), 3 + i % 2), int(rng.integers(1, 4)))
            sides = np.vstack([beside(rng, 4, 6), beside(rng, 10, 12), beside(rng, 4, 12, low=7.5)])
            yield rule_case("parts", hall(WALL), sides, int(rng.integers(1, 4)))
            for kind, problem in worlds(rng, i):
                yield rule_case(kind, problem, free_nodes(rng, problem, 5 + i), int(rng.integers(1, 4)))


def rule_case(kind: str, problem: Any, nodes: Any, number: float) -> Case:
    """A case: the number is a radius or K."""
    return Case(kind, {"problem": problem, "nodes": np.array(nodes, float), "r" if isinstance(number, float) else "k": number})


def two_nodes(number: float) -> Iterator[Case]:
    """Motions that only the problem can judge: one that touches a corner, one through a thin wall, and an arm's short way."""
    yield rule_case("wall", hall(WALL), GRAZING, number)
    yield rule_case("wall", hall(SHEET), ASTRIDE, number)
    yield rule_case("torus", arm(), ((5.9, 0.3), (0.4, 0.3)), number)


def worlds(rng: np.random.Generator, i: int) -> Iterator[tuple[str, Any]]:
    """A problem with a wall, one with several obstacles, and the arm's, whose angles wrap."""
    yield "wall", hall(WALL)
    yield "many", hall(*random_obstacles(rng, 1 + i // 4))
    yield "torus", arm()


def lattice(k: int) -> Array:
    """A lattice of k by 3 nodes, 2 apart."""
    return (2.0 + 2.0 * np.indices((k, 3)).reshape(2, -1).T).astype(float)


def chain(rng: np.random.Generator) -> Array:
    """Nodes in a row whose gaps grow, in an order by chance."""
    x = np.array([1.0, 2.0, 3.5, 6.0, 9.5])
    return rng.permutation(np.column_stack([x, np.round(rng.uniform(1, 1.2, 5), 2)]))


def beside(rng: np.random.Generator, left: float, right: float, low: float = 1.0) -> Array:
    """Two nodes in a strip of the hall."""
    return np.round(rng.uniform((left, low), (right, low + 1.5), (2, 2)), 2)


def upwards(rows: Pairs) -> Pairs:
    """The rows whose second number is the larger one."""
    return rows[rows[:, 0] < rows[:, 1]]


def twice_named(rows: Pairs) -> Pairs:
    """The pairs that each of the two names."""
    pairs, times = np.unique(np.sort(rows, axis=1), axis=0, return_counts=True)
    return pairs[times == 2]

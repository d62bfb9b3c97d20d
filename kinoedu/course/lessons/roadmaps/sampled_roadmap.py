"""The exercise on a whole probabilistic roadmap.

Bullo & Smith, chapter 5; LaValle, section 5.6.
"""

from collections import Counter
from collections.abc import Iterator
from itertools import islice

import numpy as np

from ....geometry.checks import Array
from ....messages import get_message
from ....planners.roadmaps.connecting import KClosest, connect_nodes
from ....problems.protocols import PlanningProblem
from ...exercise import Axes, Case
from ...outcomes import Answer, Outcome
from ...shapes import Numbers, Record, Together, Value
from ...tasks import StudentProblem
from ...whole_shapes import Integer, Integers
from ...withheld import withheld
from ..shared.planned import Fault, PlannerExercise, ProblemShape, Run, Watched, watched_three_times
from .halls import ASTRIDE, GRAZING, HALL, SHEET, WALL, draw_obstacles, make_hall
from .joining import are_pairs, keep_free
from .rules import Pairs, join_k_closest

BUILT = Together((Numbers(("n", "d")), Integers(("m", 2))))
MANY = 160
# two blocks that leave a corridor with start and goal: one sample in forty is free
NARROW = (
    np.array([(0.01, 0.01), (15.99, 0.01), (15.99, 0.9), (0.01, 0.9)]),
    np.array([(0.01, 1.1), (15.99, 1.1), (15.99, 9.99), (0.01, 9.99)]),
)


@withheld
def build_roadmap(problem: PlanningProblem, n: int, k: int, rng: int) -> tuple[Array, Pairs]:
    """Return start, goal and n free samples, joined by the K-closest rule."""
    chance, nodes = np.random.default_rng(rng), [problem.start, problem.goal]
    while len(nodes) < n + 2:
        q = problem.sample(chance)
        if problem.is_free(q):
            nodes.append(q)
    return np.array(nodes), join_k_closest(problem, np.array(nodes), k)


class SampledRoadmap(Watched, PlannerExercise):
    """Build a probabilistic roadmap: nodes and edges."""

    name = "sampled_roadmap"
    lesson = "08_roadmaps"
    kinds = ("none", "room", "wall", "several", "many")
    given = Record(problem=ProblemShape(), n=Integer(), k=Integer(), rng=Integer())
    result = BUILT
    answer = watched_three_times(BUILT)
    source = staticmethod(build_roadmap)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield no samples, an empty room, walls and obstacles, and many samples."""

        def case(kind: str, problem: PlanningProblem, n: int, k: int) -> Case:
            return Case(kind, {"problem": problem, "n": n, "k": k, "rng": int(rng.integers(1000))})

        yield case("none", make_hall(), 0, 3)
        yield case("none", make_hall(WALL), 0, 3)
        yield case("none", make_hall(WALL, start=GRAZING[0], goal=GRAZING[1]), 0, 3)
        yield case("none", make_hall(SHEET, start=ASTRIDE[0], goal=ASTRIDE[1]), 0, 3)
        yield case("room", make_hall(), 3, 2)
        yield case("wall", make_hall(WALL), 6, 2)
        for i in range(4):
            yield case("room", make_hall(), 4 + 4 * i, 3)
            yield case("wall", make_hall(WALL), 10 + 6 * i, 3)
            yield case("several", make_hall(*draw_obstacles(rng, 2 + i // 2)), 20 + 5 * i, 4)
        yield case("wall", make_hall(*NARROW), 10, 3)
        for room in (HALL, 2 * HALL):
            yield case("many", make_hall(room=room), MANY, 2)

    def uses_chance(self, case: Case) -> bool:
        """Whether another seed gives another answer: there is a sample."""
        return bool(case.given["n"] > 0)

    def fault_of_run(self, case: Case, answer: Value, run: Run | None) -> Fault | None:
        """Judge start and goal, that the samples are the first free ones drawn, and the edges."""
        (nodes, pairs), (problem, n, k, _) = answer, case.given.values()
        nowhere = np.empty((0, 2))
        if len(nodes) != n + 2 or nodes.shape[1] != 2 or not np.isfinite(nodes).all():
            return Fault("count", nowhere)
        if not np.array_equal(nodes[:2], [problem.start, problem.goal]):
            return Fault("ends", nodes[:2])
        for q in nodes:
            if not problem.problem.is_free(q):
                return Fault("not_free", q[None])
        fault = None if run is None else find_sample_fault(problem, nodes[2:], run)
        if fault is not None:
            return fault
        if not are_pairs(pairs, len(nodes)):
            return Fault("pairs", nowhere)
        return self.fault_of_edges(problem, nodes, pairs, k)

    def fault_of_edges(
        self, problem: StudentProblem, nodes: Array, pairs: Pairs, k: int
    ) -> Fault | None:
        """Judge the edges: each free, each joined by the rule, none missing."""
        free = set(map(tuple, keep_free(problem.problem, nodes, pairs).tolist()))
        edges, _ = connect_nodes(KClosest(k), problem.problem, nodes)
        found, right = (set(map(tuple, rows.tolist())) for rows in (pairs, np.sort(edges, axis=1)))
        for rule, wrong in (
            ("free", found - free),
            ("extra", found - right),
            ("missing", right - found),
        ):
            if wrong:
                return Fault(rule, nodes[list(min(wrong))])
        return None

    def size_limit(self, case: Case) -> int:
        """The most rows: all pairs of nodes; each node of the smallest case may be there twice."""
        n = int(case.given["n"]) + 2
        return n * (n - 1) // 2 + n

    def drawn(self, answer: object) -> tuple[list[Value], Array | None]:
        """Return neither trees nor a path."""
        return [], None

    def describe_expected(self, case: Case) -> str:
        """Describe what the answer must be."""
        _, n, k, _ = case.given.values()
        return get_message(f"{self.name}.wanted", n=n, nodes=n + 2, k=k)

    def describe_answer(self, case: Case, value: Value) -> str:
        """Describe the size of the answer and where its fault is."""
        nodes, pairs = self.answer_at_fault(case, value)
        fault = self.fault_of_three(case, value)
        marked = [] if fault is None else np.round(fault.marked, 3).tolist()
        return get_message(
            f"{self.name}.yours",
            nodes=len(nodes),
            edges=len(pairs),
            marked=f": {marked}" if marked else "",
        )

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the student's roadmap and a cross at the fault."""
        from ....figures import palette, plane
        from .pictures import draw_roadmap_answer

        value = outcome.value if isinstance(outcome, Answer) else None
        shown = None if value is None else self.answer_at_fault(case, value)
        good = shown is not None and shown[0].ndim == 2 and shown[0].shape[1:] == (2,)
        draw_roadmap_answer(case.given["problem"], None, shown if good else None, ax)
        fault = self.fault_of_three(case, value) if value is not None else None
        if fault is not None and len(fault.marked) and good:
            look: palette.Style = {"color": palette.YOURS, "markeredgecolor": "white", "zorder": 9}
            ax.plot(*fault.marked.T, "X", markersize=14, **look)
        rule = self.judge(case, outcome).rule
        plane.title(self.message(f"pictures.{rule}"), ax)


def find_sample_fault(problem: StudentProblem, nodes: Array, run: Run) -> Fault | None:
    """Return the fault of nodes that are not the first free samples drawn, or None.

    They may be in any order. More may have been drawn than were needed.
    """
    if run.generators > 1:
        return Fault("generator", nodes[:0])
    free = islice((q for q in run.samples if problem.problem.is_free(q)), len(nodes))
    left = Counter(map(tuple, free))
    for q in nodes:
        if not left[tuple(q)]:
            return Fault("samples", q[None])
        left[tuple(q)] -= 1
    return None

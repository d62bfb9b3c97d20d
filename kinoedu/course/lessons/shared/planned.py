"""Base class and judges for all exercises that ask for a planner.

A planner exercise is a `PlannerExercise`. Its `given` begins with `problem=ProblemShape()` and ends
with `rng=Integer()`, a seed; `result` is the shape of one answer. The planner is called three
times, twice with the same seed and once with another, each time with a new problem that records its
calls. `fault` finds what is wrong with one answer, by `find_path_fault` and `find_tree_fault`;
these check every motion again with the course's own collision code. Of a `Watched` planner,
`fault_of_run` also knows what was drawn in that call. Whether all randomness comes from `rng` is
judged here.

Messages that planner exercises share are in messages.toml of this folder; an exercise's own
messages come first.
"""

from abc import abstractmethod
from collections.abc import Callable
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ....geometry.checks import Array
from ....problems import Tree
from ....problems.protocols import PlanningProblem, ProblemLike
from ....spaces import RealSpace
from ...exercise import RIGHT, Axes, Case, Exercise, Given, Verdict, format_value
from ...outcomes import Answer, Outcome
from ...shapes import Numbers, Shape, Together, Truth, Value
from ...sizes import count_numbers, count_rows, refuse_excess
from ...tasks import ProblemShape, StudentProblem, problem_of
from ...watching import FAR, Run, call_three_times, read_nothing, read_samples
from ...whole_shapes import Integer
from .small_problems import TRAPS

__all__ = [
    "NODES",
    "PATH",
    "TRAPS",
    "Fault",
    "PlannerExercise",
    "ProblemShape",
    "Run",
    "StudentProblem",
    "Watched",
    "find_motion_off_tree",
    "find_node_off_nearest",
    "find_path_fault",
    "find_tree_fault",
    "find_unreturned_path",
    "first_not_free",
    "measure_distances",
    "problem_of",
    "same_configuration",
    "three_times",
    "watched_three_times",
    "with_other_seed",
]

NODES, PATH = Numbers(("n", "d")), Numbers(("k", "d"))
MOST_IN_ALL = 200_000  # numbers in three answers and what was drawn for them
ROUNDING = 1e-9  # relative tolerance of lengths and end points


class Fault(NamedTuple):
    """A rule that an answer breaks, and the configurations involved, shape (k, d).

    There are two configurations for a motion, and there may be none. `call` is the number of the
    call at fault: 0 and 1 had the case's seed, 2 had another.
    """

    rule: str
    marked: Array
    call: int = 0


RUN = Together((Numbers(("m", "d")), Integer(), Integer()))
DRAWING = ("samples", "generator", "coin", "share")  # rules of `fault_of_run` on what is drawn


def find_path_fault(problem: StudentProblem, path: Array) -> Fault | None:
    """First reason why a path is not a free path from start to goal.

    Returns
    -------
    Fault or None
        None where the path is right.
    """
    fault = not_configurations(problem, path)
    if fault is not None or len(path) == 0:
        return fault or Fault("empty", np.empty((0, len(problem.start))))
    for rule, row, end in (("start", path[0], problem.start), ("goal", path[-1], problem.goal)):
        if not same_configuration(problem, row, end):
            return Fault(rule, row[None])
    return first_not_free(problem, path[:-1], path[1:])


def find_tree_fault(
    problem: StudentProblem,
    nodes: Array,
    parent: NDArray[np.int64],
    step: float,
    root: Array | None = None,
) -> Fault | None:
    """First reason why nodes and parents are not a tree of free steps from its root.

    Parameters
    ----------
    step : the maximum length of an edge.
    root : the root; by default the start.

    Returns
    -------
    Fault or None
        None where the tree is right.
    """
    fault = not_configurations(problem, nodes)
    if fault is not None:
        return fault
    if len(nodes) == 0 or len(parent) != len(nodes):
        return Fault("parents", nodes[:0])
    if parent[0] != -1 or not same_configuration(
        problem, nodes[0], problem.start if root is None else root
    ):
        return Fault("root", nodes[:1])
    for i in range(1, len(nodes)):
        if not 0 <= parent[i] < i:
            return Fault("parents", nodes[i : i + 1])
    before, after = nodes[parent[1:]], nodes[1:]
    for a, b in zip(before, after):
        if problem.distance(a, b) > step * (1.0 + ROUNDING):
            return Fault("step", np.array([a, b]))
    return first_not_free(problem, before, after)


def find_node_off_nearest(
    problem: PlanningProblem, nodes: Array, parent: NDArray[np.int64]
) -> Fault | None:
    """First node that is not connected to its nearest earlier node, the goal excepted.

    A new node lies on the straight way from its nearest node to the sample. By the triangle
    inequality no other node can be nearer to it.

    Returns
    -------
    Fault or None
    """
    for i in range(1, len(nodes)):
        if same_configuration(problem, nodes[i], problem.goal):
            continue
        length = problem.distance(nodes[parent[i]], nodes[i])
        nearest = measure_distances(problem, nodes[:i], nodes[i]).min()
        if nearest < length - 1e-7 * (1.0 + length):
            return Fault("nearest", nodes[[parent[i], i]])
    return None


def find_unreturned_path(problem: StudentProblem, nodes: Array, path: Array | None) -> Fault | None:
    """Fault of a tree that ends at the goal where the path is None, or None."""
    ended = path is None and len(nodes) > 1 and same_configuration(problem, nodes[-1], problem.goal)
    return Fault("unreturned", nodes[-1:]) if ended else None


def measure_distances(problem: PlanningProblem, nodes: Array, q: Array) -> Array:
    """Distances from nodes to a configuration."""
    record: Any = getattr(problem, "problem", problem)
    if isinstance(record.space, RealSpace):
        return np.sqrt(((nodes - q) ** 2).sum(axis=1))
    return np.array([problem.distance(node, q) for node in nodes])


def find_motion_off_tree(path: Array, nodes: Array, parent: NDArray[np.int64]) -> Fault | None:
    """First motion of a path that does not lead from a node of the tree to a child.

    Returns
    -------
    Fault or None
    """

    def near(rows: Array, q: Array) -> NDArray[np.bool_]:
        return np.asarray(np.abs(rows - q).max(axis=1) <= ROUNDING * (1.0 + np.abs(q).max()))

    before, after = nodes[parent[1:]], nodes[1:]
    for a, b in zip(path[:-1], path[1:]):
        if not near(a[None], b).all() and not (near(before, a) & near(after, b)).any():
            return Fault("along", np.array([a, b]))
    return None


def not_configurations(problem: StudentProblem, q: Array) -> Fault | None:
    """Whether rows are not configurations: of the wrong length, or not finite."""
    if len(q) and (q.shape[1] != len(problem.start) or not np.isfinite(q).all()):
        return Fault("numbers", np.empty((0, len(problem.start))))
    return None


def same_configuration(problem: ProblemLike, a: Array, b: Array) -> bool:
    """Whether two configurations are equal up to rounding."""
    return bool(problem.distance(a, b) <= ROUNDING * (1.0 + np.abs(b).max()))


def first_not_free(problem: ProblemLike, a: Array, b: Array) -> Fault | None:
    """First of the motions from a[i] to b[i] that is in collision anywhere along it, or None."""
    record = getattr(problem, "problem", problem)
    for p, q in zip(a, b):
        if not record.is_free_path(p, q):
            return Fault("free", np.array([p, q]))
    return None


class Watched:
    """A planner exercise that also judges what was drawn in each call."""

    def call(self, function: Callable[..., object], given: Given) -> Value:
        """Call the planner three times, and read the samples of the first and the third call."""
        return call_three_times(function, given, read_samples)


class PlannerExercise(Exercise):
    """A planner to write, called three times.

    Subclasses declare `result`, and `answer = three_times(result)`. To judge what was drawn as
    well, they are `Watched` and declare `answer = watched_three_times(result)`.
    """

    result: ClassVar[Shape]
    shared: ClassVar[tuple[str, ...]] = ("planner", "exercise")
    seconds = 20.0

    def fault(self, case: Case, answer: Value) -> Fault | None:
        """What is wrong with one answer, or None."""
        raise NotImplementedError

    def fault_of_run(self, case: Case, answer: Value, run: Run | None) -> Fault | None:
        """What is wrong with one answer and with what was drawn for it, or None."""
        return self.fault(case, answer)

    @abstractmethod
    def drawn(self, answer: object) -> tuple[list[Tree], Array | None]:
        """Trees and path of one answer, for the picture."""

    def uses_chance(self, case: Case) -> bool:
        """Whether another seed must give another answer."""
        return case.kind not in ("same", "trivial")

    def call(self, function: Callable[..., object], given: Given) -> Value:
        """Call the planner three times: the answers, and whether global generators were unused."""
        return call_three_times(function, given, read_nothing)[:4]

    def fault_of_three(self, case: Case, value: Value) -> Fault | None:
        """What is wrong with the answers or with their use of randomness, or None."""
        first, again, other, alone, *runs = value
        drawn, drawn_then = [Run(*run) for run in runs] or (None, None)
        fault = self.fault_of_run(case, first, drawn)
        if fault is not None and (alone or fault.rule not in DRAWING):
            return fault
        nowhere = np.empty((0, len(case.given["problem"].start)))
        if not alone:
            return Fault("global", nowhere)
        if self.result.encode(first) != self.result.encode(again):
            return Fault("again", nowhere)
        if self.uses_chance(case) and self.result.encode(first) == self.result.encode(other):
            return Fault("another", nowhere)
        fault = self.fault_of_run(with_other_seed(case), other, drawn_then)
        return None if fault is None else fault._replace(call=2)

    def answer_at_fault(self, case: Case, value: Value) -> Value:
        """The first of the three answers with a fault; the first of all where there is none."""
        fault = self.fault_of_three(case, value)
        return value[0 if fault is None else fault.call]

    def size_limit(self, case: Case) -> int:
        """The most rows of a list in one answer: a node for each iteration, and both ends."""
        return int(case.given["iterations"]) + 2

    def bound_size(self, case: Case, outcome: Outcome) -> Outcome:
        """The outcome, or an answer of the wrong shape where a list is too long."""
        if not isinstance(outcome, Answer):
            return outcome
        rows = count_rows(tuple(outcome.value[:3]))
        size, most = count_numbers(outcome.value), self.size_limit(case)
        outcome = refuse_excess(outcome, size, MOST_IN_ALL, "shape.too_many_numbers")
        return refuse_excess(outcome, rows, most, "shape.too_many_rows")

    def case_at_fault(self, case: Case, outcome: Outcome) -> Case:
        """The case with the seed of the call that failed."""
        fault = self.fault_of_three(case, outcome.value) if isinstance(outcome, Answer) else None
        return with_other_seed(case) if fault is not None and fault.call == 2 else case

    def value_verdict(self, case: Case, value: object) -> Verdict:
        """Right where none of the three answers has a fault."""
        fault = self.fault_of_three(case, value)
        return RIGHT if fault is None else Verdict(0.0, fault.rule, self.describe_expected(case))

    def describe_expected(self, case: Case) -> str:
        """Description of what the case asks for."""
        return self.message(f"wanted.{case.kind}")

    def describe_answer(self, case: Case, value: Value) -> str:
        """Description of what was built, and of the configurations at fault."""
        trees, path = self.drawn(self.answer_at_fault(case, value))
        parts = [self.message("answers.tree", nodes=len(tree.nodes)) for tree in trees]
        if path is None:
            parts.append(self.message("answers.no_path"))
        else:
            parts.append(self.message("answers.path", rows=len(path)))
        fault = self.fault_of_three(case, value)
        if fault is not None and len(fault.marked):
            parts.append(self.message("answers.at", marked=format_value(np.round(fault.marked, 3))))
        return "; ".join(parts)

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the problem, the answer, and a cross on what is at fault."""
        from .planned_pictures import draw_answer

        value = outcome.value if isinstance(outcome, Answer) else None
        fault = None if value is None else self.fault_of_three(case, value)
        trees, path = ([], None) if value is None else self.drawn(self.answer_at_fault(case, value))
        title = self.message(f"pictures.{self.judge(case, outcome).rule}")
        draw_answer(case.given["problem"].problem, trees, path, fault, title, ax)


def with_other_seed(case: Case) -> Case:
    """The case of the third call."""
    return case._replace(given={**case.given, "rng": case.given["rng"] + FAR})


def three_times(result: Shape) -> Together:
    """Shape of the result of `PlannerExercise.call`."""
    return Together((result, result, result, Truth()), is_returned=False)


def watched_three_times(result: Shape) -> Together:
    """Shape of the result of `PlannerExercise.call` where the calls are watched."""
    return Together((result, result, result, Truth(), RUN, RUN), is_returned=False)

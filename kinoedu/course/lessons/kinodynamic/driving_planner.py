"""What the exercises on planners that drive have in common: calls, faults and pictures."""

from abc import abstractmethod
from collections.abc import Callable

import numpy as np

from ....geometry.checks import Array
from ....problems import Tree
from ....robots.trajectory import DrivenTree
from ...exercise import Axes, Case, Given
from ...outcomes import Answer, Outcome
from ...shapes import Shape, Together, Truth, Value
from ...watching import call_three_times, read_drives
from ..shared.planned import Fault, PlannerExercise, with_other_seed
from .driven_trees import NOWHERE, TurnFault, find_drive_fault, find_near_goal, replay
from .driven_turns import LOG, Turns, find_turn_fault
from .garages import BEYOND_PI, FEW


def with_logs(result: Shape) -> Together:
    """Shape of the result of `DrivingPlanner.call`."""
    return Together((result, result, result, Truth(), LOG, LOG), is_returned=False)


class DrivingPlanner(PlannerExercise):
    """An exercise on a planner whose answer ends with the nodes along its path."""

    lesson = "13_kinodynamic_planning"
    shared = ("driving_planner", "planner", "exercise")

    def uses_chance(self, case: Case) -> bool:
        """Whether another seed gives another answer: always, unless start is goal."""
        return case.kind != "same"

    def size_limit(self, case: Case) -> int:
        """Twice the most rows, so that an answer with a few drives too many breaks a rule."""
        return 2 * int(case.given.get("k", 1) * case.given["iterations"]) + 2

    @abstractmethod
    def tree_of(self, case: Case, answer: Value) -> DrivenTree:
        """Return the tree in an answer, without its nodes."""

    def nodes_of(self, case: Case, answer: Value) -> tuple[DrivenTree, Array]:
        """Return the valid part of the tree, and the known poses along the path."""
        tree = self.tree_of(case, answer)
        _, nodes = find_drive_fault(case.given["problem"], tree)
        path = answer[-1][(answer[-1] >= 0) & (answer[-1] < len(nodes))]
        n = len(nodes)
        return DrivenTree(nodes, tree.parent[:n], tree.controls[:n], tree.durations[:n]), nodes[
            path
        ]

    @abstractmethod
    def turns_of(self, case: Case, tree: DrivenTree, log: Array) -> Turns:
        """What the planner was asked for, and what it did."""

    def case_beyond_pi(self, rng: np.random.Generator, **more: int) -> Case:
        """Case in which headings that do not wrap lead to the wrong end of the path.

        Seeds are drawn until it is so.
        """
        while True:
            seed = int(rng.integers(1000))
            case = Case("far", {"problem": BEYOND_PI, **more, "iterations": FEW, "rng": seed})
            answer: Value = self.result.decode(
                self.result.encode(self.right_answer(*case.given.values()))
            )
            nodes = replay(BEYOND_PI, self.tree_of(case, answer))
            off = (nodes - BEYOND_PI.goal) * (1.0, 1.0, BEYOND_PI.radian)
            plain = int(np.linalg.norm(off, axis=1).argmin())
            if plain != answer[-1][-1] and not len(find_near_goal(BEYOND_PI, nodes)):
                return case

    def call(self, function: Callable[..., object], given: Given) -> Value:
        """Call the planner three times, and read the drives of the first and the third call."""
        return call_three_times(function, given, read_drives)

    def find_fault(self, case: Case, value: Value) -> tuple[Fault | TurnFault | None, int]:
        """Return the first fault, or None, and which of the three answers has it."""
        first, again, other, alone, log, other_log = value
        fault: Fault | TurnFault | None = self.fault(case, first)
        if fault is not None:
            return fault, 0
        if not alone:
            return Fault("global", NOWHERE), 0
        fault = self.fault_of_turns(case, first, log)
        if fault is not None:
            return fault, 0
        if self.result.encode(first) != self.result.encode(again):
            return Fault("again", NOWHERE), 0
        if self.uses_chance(case) and self.result.encode(first) == self.result.encode(other):
            return Fault("another", NOWHERE), 2
        return self.fault(case, other) or self.fault_of_turns(case, other, other_log), 2

    def fault_of_turns(self, case: Case, answer: Value, log: Array) -> TurnFault | None:
        """Judge every turn of an answer without a fault, by the log of its calls."""
        tree = self.tree_of(case, answer)
        nodes = replay(case.given["problem"], tree)
        return find_turn_fault(self.turns_of(case, tree._replace(nodes=nodes), log))

    def case_at_fault(self, case: Case, outcome: Outcome) -> Case:
        """The case with the seed of the call that failed."""
        which = self.find_fault(case, outcome.value)[1] if isinstance(outcome, Answer) else 0
        return with_other_seed(case) if which else case

    def fault_of_three(self, case: Case, value: Value) -> Value:
        """What is wrong with the answers or with their calls, or None."""
        return self.find_fault(case, value)[0]

    def drawn(self, answer: object) -> tuple[list[Tree], Array | None]:
        """Return nothing to draw: `describe_answer` describes the answer."""
        return [], None

    def describe_answer(self, case: Case, value: Value) -> str:
        """Describe the size of the answer, where its path ends, and where its fault is."""
        fault, which = self.find_fault(case, value)
        tree, poses = self.nodes_of(case, value[which])
        parts = (
            [self.message("answers.seed", rng=with_other_seed(case).given["rng"])] if which else []
        )
        if len(poses):
            x, y, theta = poses[-1]
            end = {"drives": len(poses) - 1, "x": x, "y": y, "theta": theta}
            parts.append(self.message("answers.drive", nodes=len(tree.nodes), **end))
        else:
            parts.append(self.message("answers.nowhere", nodes=len(tree.nodes)))
        if isinstance(fault, TurnFault) and fault.turn:
            parts.append(self.message("answers.turn", turn=fault.turn))
        if fault is not None and len(fault.marked):
            parts.append(self.describe_marked(fault))
        return "; ".join(parts)

    def describe_marked(self, fault: Fault | TurnFault) -> str:
        """Describe the poses at fault."""
        marked = np.round(fault.marked, 2).tolist()
        if fault.rule != "nearest":
            return self.message("answers.at", marked=marked)
        target, nearest, q = marked
        return self.message("answers.nearest", target=target, nearest=nearest, q=q)

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the problem, the tree, the path, and a cross at the fault."""
        from .pictures import draw_driven_answer

        value = outcome.value if isinstance(outcome, Answer) else None
        fault, which = (None, 0) if value is None else self.find_fault(case, value)
        built = None if value is None else self.nodes_of(case, value[which])
        rule = self.judge(case, outcome).rule
        draw_driven_answer(
            case.given["problem"].problem, built, fault, self.message(f"pictures.{rule}"), ax
        )

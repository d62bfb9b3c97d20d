"""What an exercise is: cases, a call, a judge.

`cases` and `judge` know the truth and never meet student code. `call` runs student code and knows
nothing. A check in a notebook, the project's tests and the grader run the same three; only where
`call` runs differs.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from typing import Any, ClassVar, NamedTuple

import numpy as np

from ..words import has_words, say
from .outcomes import Answer, Changed, Late, Misshapen, Outcome, Raised
from .shapes import Record, Shape


class Case(NamedTuple):
    """One input: the kind of input it is, and the arguments by name."""

    kind: str
    given: dict[str, Any]


class Verdict(NamedTuple):
    """What the judge says of one outcome.

    score : 1.0 for right, 0.0 for wrong. rule : the key of the rule that was broken, or "". wanted
        : in words, what was right.
    """

    score: float
    rule: str = ""
    wanted: str = ""

    @property
    def is_right(self) -> bool:
        """Whether nothing was wrong."""
        return self.score >= 1.0


RIGHT = Verdict(1.0)
# the rule that is broken where an answer is right but for the student's own contract
CONTRACT = "contract"


class Slip(NamedTuple):
    """A known misconception: its key in the catalogue, and what a program that has it answers to a
    case's arguments.
    """

    key: str
    answer: Callable[..., Any]


class Exercise(ABC):
    """One function to write. Subclasses declare what is below, and are listed in
    `kinoedu.course.lessons`.

    name : what the function is called. lesson : the notebook that asks for it. kinds : the kinds of
        input, each worth the same.
    given, answer : the shapes of a case's arguments and of the answer. seconds : the time for one
        call.
    slips : known misconceptions. shared : whose words it uses where it has none of its own. source
        : the library's own function, withheld when graded; None where there is none. shown : the
        lines of the library that a student may compare with in the end; those of `source` where
        they are None. variants : names of contracts, of which each student may be given one.
    """

    name: ClassVar[str]
    lesson: ClassVar[str]
    kinds: ClassVar[tuple[str, ...]]
    given: ClassVar[Record]
    answer: ClassVar[Shape]
    seconds: ClassVar[float] = 5.0
    slips: ClassVar[tuple[Slip, ...]] = ()
    shared: ClassVar[tuple[str, ...]] = ("exercise",)
    source: ClassVar[Callable[..., Any] | None] = None
    shown: ClassVar[Callable[..., Any] | None] = None
    variants: ClassVar[tuple[str, ...]] = ()

    def __init__(self, variant: str = "") -> None:
        self.variant = variant  # "" where whatever the statement allows is right

    @property
    def contract(self) -> str:
        """What a variant demands beside the statement, in words; "" where nothing."""
        return self.words(f"contracts.{self.variant}") if self.variant else ""

    @abstractmethod
    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Cases from small to large, some of every kind; the same for the same rng."""

    def call(self, function: Callable[..., Any], given: dict[str, Any]) -> Any:
        """Run the student's function on a case's arguments, in the order in which they are
        declared.
        """
        return function(*given.values())

    def right_answer(self, *given: Any) -> Any:
        """One answer that is right: what the library answers."""
        assert self.source is not None
        return self.source(*given)

    @abstractmethod
    def value_verdict(self, case: Case, value: Any) -> Verdict:
        """Judge an answer of the declared shape."""

    def judge(self, case: Case, outcome: Outcome) -> Verdict:
        """Judge what became of a call."""
        if isinstance(outcome, Answer):
            return self.value_verdict(case, outcome.value)
        rule = {Misshapen: "shape", Changed: "changed", Raised: "raised", Late: "late"}[
            type(outcome)
        ]
        return Verdict(0.0, rule, self.wanted(case))

    @abstractmethod
    def wanted(self, case: Case) -> str:
        """What the answer to a case should be, in words."""

    def answer_words(self, case: Case, value: Any) -> str:
        """What was answered to a case, in words."""
        return spoken(value)

    @abstractmethod
    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """Draw a case, what was answered and what is true, into matplotlib axes."""

    def table_with(self, key: str) -> str:
        """The first table of words that has a key, of this exercise's own and those it shares; ""
        where none has.
        """
        return next(
            (table for table in (self.name, *self.shared) if has_words(f"{table}.{key}")), ""
        )

    def words(self, key: str, **values: Any) -> str:
        """This exercise's words for a key, or those that it shares with others."""
        return say(f"{self.table_with(key) or self.shared[-1]}.{key}", **values)


TRUTHS: dict[
    tuple[int, int], tuple[Exercise, Case, Any]
] = {}  # by what they are the truths of, which is kept with them
MOST_TRUTHS = 4096


class ValueExercise(Exercise):
    """An exercise whose answers are numbers that equal the reference's up to rounding, or a
    ValueError that it must raise.
    """

    tolerance: ClassVar[float] = 1e-6

    @staticmethod
    @abstractmethod
    def reference(*given: Any) -> Any:
        """The true answer, or a ValueError where there is none."""

    def truth(self, case: Case) -> Any:
        """The true answer, or the ValueError; kept, since a whole class is judged by the same
        cases.
        """
        kept = TRUTHS.get((id(self), id(case)))
        if kept is None or kept[0] is not self or kept[1] is not case:
            try:
                truth = self.reference(*case.given.values())
            except ValueError as refusal:
                truth = refusal.with_traceback(None)
            if len(TRUTHS) >= MOST_TRUTHS:
                TRUTHS.clear()
            TRUTHS[id(self), id(case)] = kept = self, case, truth
        return kept[2]

    def judge(self, case: Case, outcome: Outcome) -> Verdict:
        """Where the reference refuses the input, a ValueError is the right answer and anything else
        is not.
        """
        if not isinstance(self.truth(case), ValueError):
            return super().judge(case, outcome)
        if isinstance(outcome, Raised) and "ValueError" in outcome.kinds:
            return RIGHT
        rule = {Late: "late", Changed: "changed"}.get(type(outcome), case.kind)
        return Verdict(0.0, rule, self.wanted(case))

    def value_verdict(self, case: Case, value: Any) -> Verdict:
        """Right where the value is the reference's."""
        return (
            RIGHT
            if self.same(value, self.truth(case))
            else Verdict(0.0, case.kind, self.wanted(case))
        )

    def same(self, value: Any, truth: Any) -> bool:
        """Whether two answers are the same but for rounding; nan is the same as nan."""
        found, wanted = np.ravel(value).tolist(), np.ravel(truth).tolist()
        return len(found) == len(wanted) and all(map(self.near, found, wanted))

    def near(self, found: float, wanted: float) -> bool:
        """The same for two numbers; what is infinite is near to nothing else."""
        both_nan = found != found and wanted != wanted
        allowed = self.tolerance * (1.0 + abs(wanted)) if abs(wanted) < np.inf else 0.0
        return both_nan or found == wanted or abs(found - wanted) <= allowed

    def wanted(self, case: Case) -> str:
        """The true answer in words."""
        truth = self.truth(case)
        return say("exercise.wanted_error") if isinstance(truth, ValueError) else spoken(truth)


MOST_SHOWN, MOST_NUMBERS = 12, 60  # points of a long array, numbers of a long list


def spoken(value: Any) -> str:
    """A value as a student would write it: at most ten digits, no trailing zeros.

    >>> spoken(np.array([[0.0, 1.5], [2.0, 1 / 3]])), spoken(5.0), spoken(True), spoken((float("nan"), -0.0))
    ('[(0, 1.5), (2, 0.3333333333)]', '5', 'True', '(nan, 0)')
    >>> spoken(([[1, 2], [2], []], 0))
    '([[1, 2], [2], []], 0)'
    """
    if isinstance(value, np.ndarray) and value.ndim > 0:
        value = list(value) if value.ndim > 1 else tuple(value)
    if isinstance(value, bool | np.bool_ | str) or value is None:
        return repr(value)
    if isinstance(value, tuple):
        return "(" + ", ".join(map(spoken, value)) + ("," if len(value) == 1 else "") + ")"
    if isinstance(value, list):
        most = (
            MOST_SHOWN
            if any(isinstance(row, list | tuple | np.ndarray) for row in value)
            else MOST_NUMBERS
        )
        if len(value) > most:
            return say("exercise.and_more", shown=spoken(value[:most])[:-1], more=len(value) - most)
        return "[" + ", ".join(map(spoken, value)) + "]"
    return f"{0.0 if abs(value) <= 1e-12 else float(value):.10g}"

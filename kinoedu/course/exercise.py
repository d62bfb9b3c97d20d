"""What an exercise is: cases, a call and a judge.

`cases` and `judge` know the truth and never meet student code. `call` runs student code and does
not know the truth. A check in a notebook, the project's tests and the grader use the same three
methods; they differ only in where `call` runs.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

import numpy as np

from ..messages import get_message, has_message
from .outcomes import Answer, Changed, Late, Misshapen, Outcome, Raised
from .shapes import Record, Shape, Value
from .sizes import MOST_NUMBERS, MOST_OF_EXAMPLE, count_numbers, refuse_excess
from .withheld import NotInTheKit, not_in_the_kit, withhold

if TYPE_CHECKING:
    from ..figures.palette import Axes as Axes
else:
    Axes = object  # matplotlib is imported only where an answer is drawn

Given = dict[str, Any]  # the arguments of a case by name


class Case(NamedTuple):
    """One input: its kind, and the arguments by name."""

    kind: str
    given: Given


class Verdict(NamedTuple):
    """The judgement of one outcome.

    Attributes
    ----------
    score : 1.0 for right, 0.0 for wrong.
    rule : key of the broken rule, or "".
    wanted : description of a right answer.
    """

    score: float
    rule: str = ""
    wanted: str = ""

    @property
    def is_right(self) -> bool:
        """Whether the outcome is right."""
        return self.score >= 1.0


RIGHT = Verdict(1.0)
# rule that is broken where an answer is right except for the student's own contract
CONTRACT = "contract"


class Slip(NamedTuple):
    """A known misconception: its key in the catalogue, and the answer of a program that has it.

    Students get the key alone; the answers to the cases that they see are recorded.
    """

    key: str
    answer: Callable[..., object] = not_in_the_kit


class Change(NamedTuple):
    """A variant with another right answer: its key, and what it makes of a program.

    Called with a program for the usual form and the arguments of a case, it returns the answer of
    the same program for the variant. So the right program gives the variant's right answer, and
    each misconception gives the misconception in the variant. Students get the key alone.
    """

    key: str
    answer: Callable[..., object] = not_in_the_kit


class Restated(NamedTuple):
    """A variant that puts the usual question in another form: its key, and how the forms relate.

    It is judged in the usual form, so all laws of the usual form hold, and it needs no further
    right answers. Students get these functions: they say no more than the contract.

    Attributes
    ----------
    key : name of the variant.
    answer : makes the variant's answer from a usual one and the usual arguments. None stays None.
    usual_answer : makes the usual answer from the variant's; by default this is `answer` as well.
        It takes every answer of the declared shape.
    given : makes the variant's arguments from the usual ones, all of them in order.
    usual_given : makes the usual arguments from the variant's; by default this is `given` as well.
    """

    key: str
    answer: Callable[..., Any] | None = None
    usual_answer: Callable[..., Any] | None = None
    given: Callable[..., tuple[Any, ...]] | None = None
    usual_given: Callable[..., tuple[Any, ...]] | None = None


class Exercise(ABC):
    """One function that students write. Subclasses are listed in `kinoedu.course.lessons`.

    Attributes
    ----------
    name : name of the function.
    lesson : name of the notebook that asks for it.
    kinds : kinds of input; all are worth the same.
    given, answer : shapes of a case's arguments and of the answer.
    seconds : time limit of one call.
    slips : known misconceptions.
    shared : tables of messages to use where the exercise has no message of its own.
    source : the library's own function, or a withheld one of the lesson, or None; the grader keeps
        it from students' programs.
    shown : library function that students may compare with afterwards. None stands for `source`.
    variants : names of contracts; each student may be assigned one.
    changes : the variants that have another right answer; `variants` are their names. A `Change`
        is for a `ValueExercise`.
    trivial : programs that solve nothing, beside constants and arguments; they earn no points.
    """

    name: ClassVar[str]
    lesson: ClassVar[str]
    kinds: ClassVar[tuple[str, ...]]
    given: ClassVar[Record]
    answer: ClassVar[Shape]
    seconds: ClassVar[float] = 5.0
    slips: ClassVar[tuple[Slip, ...]] = ()
    shared: ClassVar[tuple[str, ...]] = ("exercise",)
    source: ClassVar[Callable[..., object] | None] = None
    shown: ClassVar[Callable[..., object] | None] = None
    variants: ClassVar[tuple[str, ...]] = ()
    changes: ClassVar[tuple[Change | Restated, ...]] = ()
    trivial: ClassVar[tuple[Callable[..., object], ...]] = ()

    def __init_subclass__(cls) -> None:
        """Withhold the programs of the misconceptions: most are nearly right. Name the variants."""
        super().__init_subclass__()
        if "changes" in vars(cls):
            cls.variants = tuple(change.key for change in cls.changes)
        if "slips" in vars(cls):
            cls.slips = tuple(
                slip._replace(answer=withhold(slip.answer, f"{cls.__name__}.slips.{i}"))
                for i, slip in enumerate(cls.slips)
            )

    def __init__(self, variant: str = "") -> None:
        self.variant = variant  # "" allows everything that the statement allows

    @property
    def contract(self) -> str:
        """What the variant demands in addition to the statement; "" without a variant."""
        return self.message(f"contracts.{self.variant}", name=self.name) if self.variant else ""

    @abstractmethod
    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield cases from small to large, some of each kind; the same for the same rng."""

    @cached_property
    def fixed_cases(self) -> tuple[Case, ...]:
        """The cases of `check`, which are the same for everybody. They are drawn once."""
        return tuple(self.cases(np.random.default_rng(0)))

    def call(self, function: Callable[..., object], given: Given) -> Value:
        """Call the student's function with a case's arguments, in the declared order."""
        return function(*given.values())

    def right_answer(self, *given: Value) -> Value:
        """One right answer, computed by the library."""
        assert self.source is not None
        return self.source(*given)

    @abstractmethod
    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge an answer of the declared shape."""

    def size_limit(self, case: Case) -> int:
        """The most numbers that an answer to a case may hold, far more than a right one needs."""
        return MOST_NUMBERS if self.given.fields else MOST_OF_EXAMPLE

    def bound_size(self, case: Case, outcome: Outcome) -> Outcome:
        """The outcome, or an answer of the wrong shape where it is too large to be judged."""
        if not isinstance(outcome, Answer):
            return outcome
        most = self.size_limit(case)
        return refuse_excess(outcome, count_numbers(outcome.value), most, "shape.too_many_numbers")

    def judge(self, case: Case, outcome: Outcome) -> Verdict:
        """Judge the outcome of a call."""
        if isinstance(outcome, Answer):
            return self.value_verdict(case, outcome.value)
        rules = {Misshapen: "shape", Changed: "changed", Raised: "raised", Late: "late"}
        return Verdict(0.0, rules[type(outcome)], self.describe_expected(case))

    def judge_own_form(self, case: Case, outcome: Outcome) -> Verdict:
        """Judge an outcome, whatever it is in the usual form of a variant."""
        return self.judge(case, outcome)

    def is_usual(self, case: Case, outcome: Outcome) -> bool:
        """Whether an outcome may be that of a program for the usual form of a variant."""
        return True

    @abstractmethod
    def describe_expected(self, case: Case) -> str:
        """Description of the right answer to a case."""

    def describe_answer(self, case: Case, value: Value) -> str:
        """Description of the answer that was given to a case."""
        return format_value(value)

    def as_asked(self, value: Value, case: Case) -> Value:
        """A right answer in the form in which it is asked for: that of a restated variant."""
        return value

    def ask_for_answers(self, case: Case) -> None:
        """Ask withheld functions for all that judging and drawing a case needs.

        The results are recorded: students have no others.
        """
        self.describe_expected(case)
        self.size_limit(case)

    def case_at_fault(self, case: Case, outcome: Outcome) -> Case:
        """The case as it is shown to a student, who copies it to repeat the call that failed."""
        return case

    @abstractmethod
    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw a case, the given answer and the true one into matplotlib axes."""

    def table_with(self, key: str) -> str:
        """First table of messages that contains a key, this exercise's own table first; or ""."""
        tables = (self.name, *self.shared)
        return next((table for table in tables if has_message(f"{table}.{key}")), "")

    def message(self, key: str, **values: Any) -> str:
        """Message for a key, from this exercise's own table or from a shared one."""
        return get_message(f"{self.table_with(key) or self.shared[-1]}.{key}", **values)


# keyed by exercise, case and function; the entry keeps all three alive, so their ids stay valid
ANSWER_CACHE: dict[tuple[int, int, int], tuple[Exercise, Case, Callable[..., Value], Value]] = {}
MAX_CACHED_ANSWERS = 32_768
NO_ANSWER = (ValueError, ZeroDivisionError, NotInTheKit)  # of a misconception


class ValueExercise(Exercise):
    """An exercise whose right answer is a reference value up to rounding, or a ValueError."""

    tolerance: ClassVar[float] = 1e-6
    one_for_each: ClassVar[str] = ""  # argument that has as many items as the answer

    @staticmethod
    @abstractmethod
    def reference(*given: Value) -> Value:
        """True answer. Raises ValueError where there is none."""

    def truth(self, case: Case) -> Value:
        """True answer, or the ValueError itself."""
        return self.answer_of(self.reference, case, ValueError)

    def mistaken_answer(self, slip: Slip, case: Case) -> Value:
        """What a misconception answers, or the error itself where it has no answer."""
        return self.answer_of(slip.answer, case, NO_ANSWER)

    def answer_of(
        self,
        function: Callable[..., Value],
        case: Case,
        refusals: type[Exception] | tuple[type[Exception], ...],
    ) -> Value:
        """What a function of the exercise answers to a case, or the error by which it refuses.

        The result is cached, because a whole class is judged on the same cases.
        """
        key = id(self), id(case), id(function)
        if key not in ANSWER_CACHE:
            try:
                answer = function(*case.given.values())
            except refusals as refusal:
                answer = refusal.with_traceback(None)
            if len(ANSWER_CACHE) >= MAX_CACHED_ANSWERS:
                ANSWER_CACHE.clear()
            ANSWER_CACHE[key] = self, case, function, answer
        return ANSWER_CACHE[key][-1]

    def ask_for_answers(self, case: Case) -> None:
        """Ask for the truth, and for what each misconception answers."""
        super().ask_for_answers(case)
        if isinstance(self.truth(case), ValueError):
            return
        for slip in self.slips:
            self.mistaken_answer(slip, case)

    def judge(self, case: Case, outcome: Outcome) -> Verdict:
        """Judge an outcome; where the reference raises a ValueError, only a ValueError is right."""
        if not isinstance(self.truth(case), ValueError):
            return super().judge(case, outcome)
        if isinstance(outcome, Raised) and "ValueError" in outcome.kinds:
            return RIGHT
        rule = {Late: "late", Changed: "changed"}.get(type(outcome), case.kind)
        return Verdict(0.0, rule, self.describe_expected(case))

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Compare a value with the reference."""
        if self.same(value, self.truth(case)):
            return RIGHT
        if self.one_for_each and len(value) != len(case.given[self.one_for_each]):
            return Verdict(0.0, "shape", self.describe_expected(case))
        return Verdict(0.0, case.kind, self.describe_expected(case))

    def same(self, value: Value, truth: Value) -> bool:
        """Whether two answers agree up to rounding; nan equals nan."""
        found, wanted = np.ravel(value).tolist(), np.ravel(truth).tolist()
        return len(found) == len(wanted) and all(map(self.near, found, wanted))

    def agree(self, case: Case, value: Value, other: Value) -> bool:
        """Whether two answers to a case agree, of which one is a misconception's."""
        return self.same(value, other)

    def near(self, found: float, wanted: float) -> bool:
        """Whether two numbers agree up to rounding; infinity equals only itself."""
        both_nan = found != found and wanted != wanted
        allowed = self.tolerance * (1.0 + abs(wanted)) if abs(wanted) < np.inf else 0.0
        return both_nan or found == wanted or abs(found - wanted) <= allowed

    def describe_expected(self, case: Case) -> str:
        """Description of the true answer."""
        truth = self.truth(case)
        return (
            get_message("exercise.wanted_error")
            if isinstance(truth, ValueError)
            else format_value(self.as_asked(truth, case))
        )


MAX_POINTS_SHOWN, MAX_NUMBERS_SHOWN = 12, 60  # rows of a long array, entries of a long list


def format_value(value: Value) -> str:
    """Format a value as a student would write it: at most ten digits, no trailing zeros.

    >>> format_value(np.array([[0.0, 1.5], [2.0, 1 / 3]]))
    '[(0, 1.5), (2, 0.3333333333)]'
    >>> format_value(5.0), format_value(True), format_value((float("nan"), -0.0))
    ('5', 'True', '(nan, 0)')
    >>> format_value(([[1, 2], [2], []], 0))
    '([[1, 2], [2], []], 0)'
    """
    if isinstance(value, np.ndarray) and value.ndim > 0:
        value = list(value) if value.ndim > 1 else tuple(value)
    if isinstance(value, bool | np.bool_ | str) or value is None:
        return repr(value)
    if isinstance(value, tuple):
        return "(" + ", ".join(map(format_value, value)) + ("," if len(value) == 1 else "") + ")"
    if isinstance(value, list):
        has_rows = any(isinstance(row, list | tuple | np.ndarray) for row in value)
        most = MAX_POINTS_SHOWN if has_rows else MAX_NUMBERS_SHOWN
        if len(value) > most:
            return get_message(
                "exercise.and_more", shown=format_value(value[:most])[:-1], more=len(value) - most
            )
        return "[" + ", ".join(map(format_value, value)) + "]"
    return f"{0.0 if abs(value) <= 1e-12 else float(value):.10g}"

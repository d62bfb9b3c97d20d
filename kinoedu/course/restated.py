"""Variants that put the usual question in another form, and are judged in the usual form.

Two exercises make up such a variant. The outer one has the variant's cases and answers. It turns
them into the usual form and asks the inner one, which is the usual exercise with the messages of
the variant.
"""

from collections.abc import Callable, Iterator
from functools import cached_property
from typing import Any, ClassVar, cast

import numpy as np

from ..messages import has_message
from .exercise import CONTRACT, Axes, Case, Exercise, Given, Restated, Slip, ValueExercise, Verdict
from .outcomes import Answer, Outcome
from .shapes import Value

MAX_CACHED_CASES = 4096


class VariedMessages(Exercise):
    """An exercise with a variant's own messages, where it has any."""

    def table_with(self, key: str) -> str:
        """The variant's own table of messages where it contains a key, otherwise the usual one."""
        own = (f"{table}.{self.variant}" for table in (self.name, *self.shared))
        found = next((table for table in own if has_message(f"{table}.{key}")), "")
        return found or super().table_with(key)


class OtherForm(VariedMessages):
    """A variant with other right answers than the usual form.

    Attributes
    ----------
    usual : the exercise in its usual form. What is right for it, and not here, breaks the contract.
    """

    usual: ClassVar[Any]

    def judge(self, case: Case, outcome: Outcome) -> Verdict:
        """Judge an outcome; one that is right for the usual form has a rule of its own."""
        verdict = self.judge_own_form(case, outcome)
        if verdict.is_right or not self.is_usual(case, outcome):
            return verdict
        return verdict._replace(rule=CONTRACT)

    @np.errstate(all="ignore")
    def is_usual(self, case: Case, outcome: Outcome) -> bool:
        """Whether an outcome is right for the usual form."""
        return bool(self.usual.judge(case, outcome).is_right)


class Inner(VariedMessages):
    """The usual exercise, which describes right answers in the variant's form."""

    form: ClassVar[Restated]

    @np.errstate(all="ignore")
    def as_asked(self, value: Value, case: Case) -> Value:
        """The variant's answer that corresponds to a usual one."""
        if value is None or self.form.answer is None:
            return value
        return self.form.answer(value, *case.given.values())


class Outer(OtherForm):
    """A restated variant.

    Attributes
    ----------
    form : how the variant's arguments and answers relate to the usual ones.
    inner : the usual exercise with the variant's messages.
    """

    form: ClassVar[Restated]
    inner: ClassVar[Any]

    def __init__(self, variant: str = "") -> None:
        super().__init__(variant)
        self.usual_cases: dict[int, tuple[Case, Case]] = {}  # with the case that has this id

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """The usual cases with the variant's arguments."""
        for case in self.inner.cases(rng):
            yield change_arguments(case, self.form.given)

    @cached_property
    def fixed_cases(self) -> tuple[Case, ...]:
        """Those of the usual form, with the variant's arguments."""
        return tuple(change_arguments(case, self.form.given) for case in self.usual.fixed_cases)

    def usual_case(self, case: Case) -> Case:
        """The usual case that corresponds to one of the variant."""
        if self.form.given is None:
            return case
        if id(case) not in self.usual_cases:
            if len(self.usual_cases) >= MAX_CACHED_CASES:
                self.usual_cases.clear()
            back = self.form.usual_given or self.form.given
            self.usual_cases[id(case)] = case, change_arguments(case, back)
        return self.usual_cases[id(case)][1]

    @np.errstate(all="ignore")
    def usual_value(self, case: Case, value: Value) -> Value:
        """The usual answer that corresponds to one of the variant."""
        back = self.form.usual_answer or self.form.answer
        if value is None or back is None:
            return value
        return back(value, *self.usual_case(case).given.values())

    def usual_outcome(self, case: Case, outcome: Outcome) -> Outcome:
        """The outcome with the usual answer."""
        if not isinstance(outcome, Answer):
            return outcome
        return Answer(self.usual_value(case, outcome.value))

    def right_answer(self, *given: Value) -> Value:
        """A right answer: the usual one in the variant's form."""
        case = Case("", dict(zip(self.given.fields, given)))
        usual = self.usual_case(case)
        return self.inner.as_asked(self.usual.right_answer(*usual.given.values()), usual)

    def size_limit(self, case: Case) -> int:
        """The usual limit."""
        return int(self.inner.size_limit(self.usual_case(case)))

    @np.errstate(all="ignore")
    def judge_own_form(self, case: Case, outcome: Outcome) -> Verdict:
        """Judge an outcome as the usual one to which it corresponds."""
        judged: Verdict = self.inner.judge(self.usual_case(case), self.usual_outcome(case, outcome))
        return judged

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge an answer of the declared shape."""
        return self.judge(case, Answer(value))

    def describe_expected(self, case: Case) -> str:
        """Description of the right answer in the variant's form."""
        return str(self.inner.describe_expected(self.usual_case(case)))

    def ask_for_answers(self, case: Case) -> None:
        """Ask for what the usual form needs, and for what the usual answer is to this case."""
        self.inner.ask_for_answers(self.usual_case(case))
        self.usual.describe_expected(case)

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the usual case and the usual answers."""
        self.inner.draw(self.usual_case(case), self.usual_outcome(case, outcome), ax)


class OuterValue(Outer, ValueExercise):
    """A restated variant of an exercise with a reference value."""

    def truth(self, case: Case) -> Value:
        """True answer in the variant's form, or the ValueError itself."""
        return self.in_form(case, self.inner.truth(self.usual_case(case)))

    def mistaken_answer(self, slip: Slip, case: Case) -> Value:
        """What a misconception answers, or the error itself where it has no answer."""
        return self.in_form(case, self.inner.mistaken_answer(slip, self.usual_case(case)))

    def in_form(self, case: Case, value: Value) -> Value:
        """The variant's answer that corresponds to a usual one; an error stays the same."""
        if isinstance(value, Exception):
            return value
        try:
            return self.inner.as_asked(value, self.usual_case(case))
        except (ValueError, ArithmeticError, LookupError) as error:  # of a misconception's answer
            return ValueError(str(error))

    def agree(self, case: Case, value: Value, other: Value) -> bool:
        """Whether two answers agree in the usual form."""
        return bool(self.inner.same(self.usual_value(case, value), self.usual_value(case, other)))


def change_arguments(case: Case, change: Callable[..., tuple[Any, ...]] | None) -> Case:
    """A case whose arguments have the same names and the values that `change` makes of theirs."""
    if change is None:
        return case
    given: Given = dict(zip(case.given, change(*case.given.values()), strict=True))
    return case._replace(given=given)


def restate(kind: type[Exercise], usual: Exercise, form: Restated) -> Exercise:
    """The variant of an exercise in another form than the usual one.

    A program that is right for the usual form earns nothing here.
    """
    name = f"{kind.__name__}.{form.key}"
    parts: dict[str, Any] = {
        "__module__": kind.__module__,
        "form": form,
        "shared": ("varied", *kind.shared),
    }
    inner = cast("type[Exercise]", type(f"{name}.inner", (Inner, kind), parts))(form.key)
    outer = OuterValue if issubclass(kind, ValueExercise) else Outer
    parts |= {
        "inner": inner,
        "usual": usual,
        "trivial": (*kind.trivial, usual.right_answer),
    }
    return cast("type[Exercise]", type(name, (outer, kind), parts))(form.key)

"""Variants of exercises: contracts that allow less, changed answers, and other forms."""

import functools
from collections.abc import Callable
from typing import Any, cast

from .exercise import Case, Change, Exercise, Restated, ValueExercise, Verdict
from .outcomes import Outcome
from .restated import OtherForm, restate
from .shapes import Value
from .withheld import withhold

Program = Callable[..., Any]


class Varied(OtherForm, ValueExercise):
    """A variant that has another right answer. Cases and laws are those of the usual form."""

    @functools.cached_property
    def fixed_cases(self) -> tuple[Case, ...]:
        """Those of the usual form."""
        return tuple(self.usual.fixed_cases)

    def right_answer(self, *given: Value) -> Value:
        """The right answer, which the library does not have."""
        return self.reference(*given)

    def judge_own_form(self, case: Case, outcome: Outcome) -> Verdict:
        """Judge an outcome by the variant's right answer."""
        return super(OtherForm, self).judge(case, outcome)


@functools.cache
def make_variant(kind: type[Exercise], variant: str) -> Exercise:
    """The variant of an exercise, or its usual form by ""; made once, because it keeps results."""
    change = next((one for one in kind.changes if one.key == variant), None)
    if change is None:
        return kind(variant)
    if isinstance(change, Restated):
        return restate(kind, make_variant(kind, ""), change)
    return vary(cast("type[ValueExercise]", kind), change)


def vary(kind: type[ValueExercise], change: Change) -> Exercise:
    """The variant of an exercise by a change: of its right answer, and of its misconceptions.

    A program that is right for the usual form earns nothing here.
    """
    name = f"{kind.__name__}.{change.key}"
    reference = withhold(change_program(change, kind.reference), f"{name}.reference")
    parts = {
        "__module__": kind.__module__,
        "usual": make_variant(kind, ""),
        "reference": staticmethod(reference),
        "slips": tuple(
            slip._replace(answer=change_program(change, slip.answer)) for slip in kind.slips
        ),
        "shared": ("varied", *kind.shared),
        "trivial": (*kind.trivial, kind.reference),
    }
    varied = cast("type[Exercise]", type(name, (Varied, kind), parts))
    return varied(change.key)


def change_program(change: Change, program: Program) -> Program:
    """The program for a variant that corresponds to one for the usual form."""
    return lambda *given: change.answer(program, *given)

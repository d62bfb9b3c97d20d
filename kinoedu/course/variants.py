"""Variants of exercises: contracts that allow less, and changes that have another right answer."""

import functools
from collections.abc import Callable
from typing import Any, ClassVar, cast

from ..messages import has_message
from .exercise import CONTRACT, Case, Change, Exercise, ValueExercise, Verdict
from .outcomes import Outcome
from .shapes import Value
from .withheld import withhold

Program = Callable[..., Any]


class Varied(ValueExercise):
    """A variant that has another right answer. Cases and laws are those of the usual form.

    Attributes
    ----------
    usual : the exercise in its usual form. What is right for it, and not here, breaks the contract.
    """

    usual: ClassVar[ValueExercise]

    def right_answer(self, *given: Value) -> Value:
        """The right answer, which the library does not have."""
        return self.reference(*given)

    def judge(self, case: Case, outcome: Outcome) -> Verdict:
        """Judge an outcome; one that is right for the usual form has a rule of its own."""
        verdict = super().judge(case, outcome)
        if verdict.is_right or not self.usual.judge(case, outcome).is_right:
            return verdict
        return verdict._replace(rule=CONTRACT)

    def table_with(self, key: str) -> str:
        """The variant's own table of messages where it contains a key, otherwise the usual one."""
        own = f"{self.name}.{self.variant}"
        return own if has_message(f"{own}.{key}") else super().table_with(key)


@functools.cache
def make_variant(kind: type[Exercise], variant: str) -> Exercise:
    """The variant of an exercise, made once: results are cached with the object."""
    changes = kind.changes if issubclass(kind, ValueExercise) else ()
    change = next((one for one in changes if one.key == variant), None)
    return kind(variant) if change is None else vary(cast("type[ValueExercise]", kind), change)


def vary(kind: type[ValueExercise], change: Change) -> Exercise:
    """The variant of an exercise by a change: of its right answer, and of its misconceptions.

    A program that is right for the usual form earns nothing here.
    """
    name = f"{kind.__name__}.{change.key}"
    reference = withhold(change_program(change, kind.reference), f"{name}.reference")
    parts = {
        "__module__": kind.__module__,
        "usual": kind(),
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

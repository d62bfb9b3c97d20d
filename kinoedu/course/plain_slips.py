"""The usual mistakes with a plain function, by its kinds of input and of answer.

A mistake is a program that calls the right function with something changed: a vertex left out, two
arguments exchanged, an angle in degrees, the answer squared.
"""

import copy
from collections.abc import Callable
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np

from ..errors import InvalidParameter
from ..support.text import shortened
from .exercise import Case
from .lessons.shared.drawn_inputs import INPUTS, draw_cases
from .plain_function import PlainFunction, agree

ROWS = (
    ("last_of_{name}", "You leave out the last point of {name}. How far do you go?", "{name}[:-1]"),
    ("first_of_{name}", "You leave out the first point of {name}. Its number is 0.", "{name}[1:]"),
)
OF_INPUTS = {  # by the kind of an input: key, what the student reads, what is given in its place
    "polygon": ROWS,
    "points": ROWS,
    "point": (
        ("axes_of_{name}", "You exchange x and y of {name}. x comes first.", "{name}[::-1]"),
    ),
    "angle": (("degrees_{name}", "{name} is in radians already.", "np.radians({name})"),),
    "count": (
        ("one_more_{name}", "Your answer fits {name} + 1. Where do you begin?", "{name} + 1"),
    ),
}
OF_ANSWERS = {  # by key: what the student reads, what is returned
    "sign": ("Your answer has the wrong sign.", "-1.0 * np.asarray({right})"),
    "square": ("You return the square of the answer.", "{right} ** 2"),
    "half": ("Your answer is half of the right one.", "0.5 * np.asarray({right})"),
    "rounded": (
        "Your answer is rounded. Return it without rounding; round only when you print.",
        "np.round({right}, 0)",
    ),
    "axes": ("You exchange x and y of the answer. x comes first.", "np.asarray({right})[::-1]"),
    "opposite": ("Your answer is reversed.", "not {right}"),
}
FITTING = {  # keys by the kind of answer; for numbers `possible_slips` has them
    "truth": ("opposite",),
    "count": (),
    "point": ("sign", "axes", "half", "rounded"),
    "points": ("sign", "half", "rounded"),
}


class PlainSlip(NamedTuple):
    """A usual mistake: its key, what it says, and its program as Python.

    `program` uses `right`, the right function.
    """

    key: str
    text: str
    program: str


def usual_slips(plain: PlainFunction) -> list[PlainSlip]:
    """The usual mistakes that are mistakes for this function: each is wrong for some drawn case.

    Two that give the same answers everywhere are one.

    Raises
    ------
    InvalidParameter
        Where the function cannot answer such a case.
    """
    kinds = {name: INPUTS[kind] for name, kind in plain.inputs.items()}
    cases = [case for seed in (0, 1) for case in draw_cases(kinds, np.random.default_rng(seed))]
    refuse_failures(plain, cases)
    right = [answer_of(plain.function, case) for case in cases]
    chosen, seen = [], [right]
    for slip in possible_slips(plain):
        program = eval(slip.program, {"np": np, "right": plain.function})  # written below
        answers = [answer_of(program, case) for case in cases]
        different = all(any(not same(a, b) for a, b in zip(answers, other)) for other in seen)
        if different and not any(one is None for one in answers):
            chosen.append(slip)
            seen.append(answers)
    return chosen


def refuse_failures(plain: PlainFunction, cases: list[Case]) -> None:
    """Raise InvalidParameter where a function changes its arguments or raises no ValueError."""
    for case in cases:
        given = copy.deepcopy(case.given)
        try:
            with np.errstate(all="ignore"):
                plain.function(*given.values())
        except ValueError:
            pass  # a right answer
        except Exception as error:
            called = {name: np.asarray(one).tolist() for name, one in case.given.items()}
            raise InvalidParameter(
                f"{plain.name} fails for {shortened(called)}: {type(error).__name__}: {error}; "
                "return an answer there, or raise a ValueError"
            ) from error
        changed = [name for name, one in given.items() if not np.array_equal(one, case.given[name])]
        if changed:
            raise InvalidParameter(
                f"{plain.name} changes its argument {changed[0]}; let it work on a copy"
            )


def answer_of(function: Callable[..., Any], case: Case) -> Any:
    """A function's answer to a case, a ValueError, or None after another error."""
    try:
        with np.errstate(all="ignore"):
            return function(*case.given.values())
    except ValueError as refusal:
        return refusal
    except Exception:
        return None


def same(one: Any, other: Any) -> bool:
    """Whether two answers are the same to a judge."""
    if isinstance(one, ValueError) or isinstance(other, ValueError):
        return isinstance(one, ValueError) and isinstance(other, ValueError)
    return one is not None and other is not None and agree(one, other)


def possible_slips(plain: PlainFunction) -> list[PlainSlip]:
    """The usual mistakes with inputs and answers of these kinds."""
    names = list(plain.inputs)
    right = call_with({name: name for name in names})
    changed = [
        (key.format(name=name), text.format(name=name), {name: program.format(name=name)})
        for name, kind in plain.inputs.items()
        for key, text, program in OF_INPUTS.get(kind, ())
    ]
    swapped = [
        (f"swapped_{one}_{other}", f"You exchange {one} and {other}.", {one: other, other: one})
        for one, other in combinations(names, 2)
        if plain.inputs[one] == plain.inputs[other]
    ]
    programs = [
        (key, text, call_with({name: change.get(name, name) for name in names}))
        for key, text, change in changed + swapped
    ]
    programs += [
        (key, OF_ANSWERS[key][0], OF_ANSWERS[key][1].format(right=right))
        for key in FITTING.get(plain.answer, ("sign", "square", "half", "rounded"))
    ]
    head = f"lambda {', '.join(names)}: "
    return [PlainSlip(key, text, head + program) for key, text, program in programs]


def call_with(given: dict[str, str]) -> str:
    """A call of the right function with these arguments, as Python."""
    return f"right({', '.join(given.values())})"

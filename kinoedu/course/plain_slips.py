"""The usual mistakes with a plain function, by its kinds of input and of answer.

A mistake is a program that calls the right function with something changed: a vertex left out, two
arguments exchanged, an angle in degrees, the answer squared.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from .exercise import Case
from .lessons.shared.drawn_inputs import INPUTS, draw_cases
from .plain_function import PlainFunction, agree


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
    """
    kinds = {name: INPUTS[kind] for name, kind in plain.inputs.items()}
    cases = [case for seed in (0, 1) for case in draw_cases(kinds, np.random.default_rng(seed))]
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
    head = f"lambda {', '.join(names)}: "

    def with_input(name: str, changed: str) -> str:
        return f"{head}right({', '.join(changed if one == name else one for one in names)})"

    slips = []
    for name, kind in plain.inputs.items():
        if kind in ("polygon", "points"):
            what = "vertex" if kind == "polygon" else "point"
            slips += [
                PlainSlip(
                    f"last_of_{name}",
                    f"You leave out the last {what} of {name}. How far does your loop run?",
                    with_input(name, f"{name}[:-1]"),
                ),
                PlainSlip(
                    f"first_of_{name}",
                    f"You leave out the first {what} of {name}. Its number is 0, not 1.",
                    with_input(name, f"{name}[1:]"),
                ),
            ]
        if kind == "point":
            slips.append(
                PlainSlip(
                    f"axes_of_{name}",
                    f"You exchange x and y of {name}. x comes first.",
                    with_input(name, f"{name}[::-1]"),
                )
            )
        if kind == "angle":
            slips.append(
                PlainSlip(
                    f"degrees_{name}",
                    f"{name} is in radians already.",
                    with_input(name, f"np.radians({name})"),
                )
            )
        if kind == "count":
            slips.append(
                PlainSlip(
                    f"one_more_{name}",
                    f"Your answer fits {name} + 1. From which number do you count?",
                    with_input(name, f"{name} + 1"),
                )
            )
    for i, one in enumerate(names):
        for other in names[i + 1 :]:
            if plain.inputs[one] == plain.inputs[other]:
                swap = {one: other, other: one}
                slips.append(
                    PlainSlip(
                        f"swapped_{one}_{other}",
                        f"You exchange {one} and {other}.",
                        f"{head}right({', '.join(swap.get(name, name) for name in names)})",
                    )
                )
    call = f"right({', '.join(names)})"
    answers = {
        "sign": ("Your answer has the wrong sign.", f"-1.0 * np.asarray({call})"),
        "square": ("You return the square of the answer.", f"{call} ** 2"),
        "half": ("Your answer is half of the right one.", f"0.5 * np.asarray({call})"),
        "rounded": (
            "Your answer is rounded. Return it without rounding; round only when you print.",
            f"np.round({call}, 0)",
        ),
        "axes": ("You exchange x and y of the answer. x comes first.", f"np.asarray({call})[::-1]"),
        "opposite": ("Your answer is reversed.", f"not {call}"),
    }
    fitting = {
        "truth": ("opposite",),
        "count": (),
        "point": ("sign", "axes", "half", "rounded"),
        "points": ("sign", "half", "rounded"),
    }.get(plain.answer, ("sign", "square", "half", "rounded"))
    slips += [PlainSlip(key, answers[key][0], head + answers[key][1]) for key in fitting]
    return slips

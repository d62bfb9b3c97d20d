"""Read a plain function, from which `new-exercise --from` makes an exercise.

The file holds imports and one function. Its annotations name the kinds of input, its docstring is
the statement, and its doctest is the example that is worked out by hand:

    import numpy as np

    def middle(p1: "point", p2: "point") -> "point":
        \"\"\"The point half-way between two points.

        >>> middle((0, 0), (4, 2))
        (2, 1)
        \"\"\"
        return (p1 + p2) / 2
"""

import ast
import doctest
from collections.abc import Callable
from os import PathLike
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from ..errors import InvalidParameter
from .exercise import Case
from .lessons.shared.drawn_inputs import INPUTS, draw_cases

ANSWERS = {
    "point": "Numbers((2,))",
    "points": 'Numbers(("n", 2))',
    "number": "Number()",
    "length": "Number()",
    "angle": "Number()",
    "count": "Integer()",
    "truth": "Truth()",
}


class PlainFunction(NamedTuple):
    """A function as it was read.

    Attributes
    ----------
    name : of the function.
    inputs : the kind of each argument by its name.
    answer : the kind of its answer.
    statement : the docstring without the example.
    call, result : the example, as Python.
    imports : the file's imports, as Python.
    body : the function's body without the docstring, as Python.
    function : the function itself; it takes arrays.
    """

    name: str
    inputs: dict[str, str]
    answer: str
    statement: str
    call: str
    result: str
    imports: str
    body: str
    function: Callable[..., Any]


class PlainSlip(NamedTuple):
    """A usual mistake: its key, what it says, and its program as Python.

    `program` uses `right`, the right function.
    """

    key: str
    text: str
    program: str


def read_plain_function(file: str | PathLike[str]) -> PlainFunction:
    """Read a plain function. The file is executed.

    Raises
    ------
    InvalidParameter
        Where the file is not as described above; the message says what is missing.
    """
    text = Path(file).read_text(encoding="utf-8")
    try:
        tree = ast.parse(text)
    except SyntaxError as error:
        raise InvalidParameter(f"{file} is not Python: {error}") from None
    functions = [node for node in tree.body if isinstance(node, ast.FunctionDef)]
    imports = [node for node in tree.body if isinstance(node, ast.Import | ast.ImportFrom)]
    documents = [node for node in tree.body if isinstance(node, ast.Expr)]
    if len(functions) != 1 or len(imports) + len(documents) + 1 != len(tree.body):
        raise InvalidParameter(f"{file} should hold imports and one function, and nothing else")
    (node,) = functions
    inputs = {one.arg: read_kind(one.annotation, INPUTS, one.arg) for one in node.args.args}
    if not inputs:
        raise InvalidParameter(f"{node.name} should take at least one argument")
    answer = read_kind(node.returns, ANSWERS, "the answer")
    documentation = ast.get_docstring(node) or ""
    examples = doctest.DocTestParser().get_examples(documentation)
    if not documentation or len(examples) != 1 or not examples[0].want.strip():
        raise InvalidParameter(
            f"{node.name} needs a docstring with its statement and one example, such as "
            f">>> {node.name}(...) and its result in the next line"
        )
    defined: dict[str, Any] = {}
    exec(compile(tree, str(file), "exec"), defined)  # the instructor's own function
    lines = text.splitlines()[node.body[1].lineno - 1 : node.end_lineno]
    return PlainFunction(
        node.name,
        inputs,
        answer,
        documentation.partition(">>>")[0].strip(),
        examples[0].source.strip(),
        examples[0].want.strip(),
        "\n".join(map(ast.unparse, imports)),
        "\n".join(line[4:] if line[:4] == "    " else line for line in lines),
        defined[node.name],
    )


def read_kind(annotation: ast.expr | None, known: dict[str, Any], what: str) -> str:
    """The kind that an annotation names, as a name or a string.

    Raises
    ------
    InvalidParameter
        Where it names none.
    """
    found = getattr(annotation, "id", getattr(annotation, "value", None))
    if found not in known:
        raise InvalidParameter(
            f"{what} needs an annotation, one of {', '.join(known)}; got {found!r}"
        )
    return str(found)


def example_of(plain: PlainFunction) -> tuple[dict[str, Any], Any]:
    """The arguments and the result of the example.

    Raises
    ------
    InvalidParameter
        Where the call has other arguments than plain values, or the function returns another
        result.
    """
    try:
        call = ast.parse(plain.call, mode="eval").body
        assert isinstance(call, ast.Call) and not call.keywords
        values = [ast.literal_eval(one) for one in call.args]
        wanted = ast.literal_eval(plain.result)
    except (ValueError, SyntaxError, AssertionError):
        raise InvalidParameter(
            f"the example of {plain.name} should be a call with plain values, such as (1, 2), and "
            f"a plain result; got {plain.call} and {plain.result}"
        ) from None
    if len(values) != len(plain.inputs):
        raise InvalidParameter(f"the example of {plain.name} has {len(values)} arguments")
    given = {
        name: np.array(value, float) if isinstance(value, tuple | list) else value
        for name, value in zip(plain.inputs, values)
    }
    found = plain.function(*given.values())
    if not agree(found, wanted):
        raise InvalidParameter(
            f"the example of {plain.name} says {plain.result}, but the function returns {found!r}"
        )
    return given, wanted


def agree(found: Any, wanted: Any) -> bool:
    """Whether two answers are equal up to rounding."""
    one, other = np.ravel(found), np.ravel(wanted)
    return len(one) == len(other) and bool(np.allclose(one.astype(float), other.astype(float)))


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

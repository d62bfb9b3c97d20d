"""Read a plain function, from which `new-exercise --from` makes an exercise.

The file holds imports and one function. Its annotations name the kinds of input, its docstring is
the statement, and its doctest is the example that is worked out by hand:

    import numpy as np

    def middle(p1: "point", p2: "point") -> "point":
        \"\"\"The point half-way between two points.

        (here the doctest: middle((0, 0), (4, 2)) is (2, 1))
        \"\"\"
        return (p1 + p2) / 2
"""

import ast
import copy
import doctest
from collections.abc import Callable
from os import PathLike
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from ..errors import InvalidParameter
from .lessons.shared.drawn_inputs import INPUTS

ANSWERS = {
    "point": "Numbers((2,))",
    "points": 'Numbers(("n", 2))',
    "number": "Number()",
    "length": "Number()",
    "angle": "Number()",
    "count": "Integer()",
    "truth": "Truth()",
}
RESERVED = ("np", "right", "self")  # what the exercise's own lines use


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


def read_plain_function(file: str | PathLike[str]) -> PlainFunction:
    """Read a plain function. The file is executed.

    Raises
    ------
    InvalidParameter
        Where the file is not as described above; the message says what is missing.
    """
    try:
        text = Path(file).read_text(encoding="utf-8")
        tree = ast.parse(text)
    except (SyntaxError, ValueError) as error:
        raise InvalidParameter(f"{file} is not Python: {error}") from None
    functions = [node for node in tree.body if isinstance(node, ast.FunctionDef)]
    imports = [node for node in tree.body if isinstance(node, ast.Import | ast.ImportFrom)]
    documents = [node for node in tree.body if isinstance(node, ast.Expr)]
    if len(functions) != 1 or len(imports) + len(documents) + 1 != len(tree.body):
        raise InvalidParameter(f"{file} should hold imports and one function, and nothing else")
    (node,) = functions
    inputs = read_inputs(node)
    answer = read_kind(node.returns, ANSWERS, "the answer")
    documentation = ast.get_docstring(node) or ""
    parts = doctest.DocTestParser().parse(documentation)
    examples = [part for part in parts if isinstance(part, doctest.Example)]
    if not documentation or len(examples) != 1 or not examples[0].want.strip():
        raise InvalidParameter(
            f"{node.name} needs a docstring with its statement and one example, such as "
            f">>> {node.name}(...) and its result in the next line"
        )
    body = read_body(node, text)
    defined: dict[str, Any] = {}
    try:
        exec(compile(tree, str(file), "exec"), defined)  # the instructor's own function
    except Exception as error:
        raise InvalidParameter(f"{file} cannot be run: {type(error).__name__}: {error}") from error
    return PlainFunction(
        node.name,
        inputs,
        answer,
        "\n\n".join(part.strip() for part in parts if isinstance(part, str) and part.strip()),
        examples[0].source.strip(),
        examples[0].want.strip(),
        "\n".join(ast.unparse(one) for one in imports if not is_of_the_future(one)),
        body,
        defined[node.name],
    )


def read_inputs(node: ast.FunctionDef) -> dict[str, str]:
    """The kind of each argument of a function by its name.

    Raises
    ------
    InvalidParameter
        Where the function has other arguments than plain ones, or a decorator.
    """
    form = node.args
    others = [*form.posonlyargs, *form.kwonlyargs, *form.defaults, form.vararg, form.kwarg]
    if not form.args or any(others) or node.decorator_list:
        raise InvalidParameter(
            f"{node.name} should take one argument or more, without *, / and default values, and "
            "have no decorator"
        )
    taken = [one.arg for one in form.args if one.arg in RESERVED]
    if taken:
        raise InvalidParameter(
            f"no argument can be named {taken[0]}, which the exercise's own lines use"
        )
    return {one.arg: read_kind(one.annotation, INPUTS, one.arg) for one in form.args}


def read_body(node: ast.FunctionDef, text: str) -> str:
    """The lines of a function below its docstring, as they would stand at the left margin.

    Raises
    ------
    InvalidParameter
        Where there are none.
    """
    docstring, *rest = node.body
    if not rest or rest[0].lineno == docstring.end_lineno:
        raise InvalidParameter(f"the lines of {node.name} should stand below its docstring")
    lines = text.split("\n")
    margin = lines[rest[0].lineno - 1][: rest[0].col_offset]
    first = min([rest[0], *getattr(rest[0], "decorator_list", [])], key=lambda one: one.lineno)
    return "\n".join(
        line.removeprefix(margin) for line in lines[first.lineno - 1 : node.end_lineno]
    )


def is_of_the_future(node: ast.Import | ast.ImportFrom) -> bool:
    """Whether it is `from __future__ import ...`, which a cell cannot have in a function."""
    return isinstance(node, ast.ImportFrom) and node.module == "__future__"


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


def example_of(plain: PlainFunction) -> dict[str, Any]:
    """The arguments of the example, whose result is checked.

    Raises
    ------
    InvalidParameter
        Where the call has other arguments than plain values, or the function fails or returns
        another result.
    """
    try:
        call = ast.parse(plain.call, mode="eval").body
        assert isinstance(call, ast.Call) and not call.keywords
        assert ast.unparse(call.func) == plain.name
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
    try:
        found = plain.function(*copy.deepcopy(given).values())
    except Exception as error:
        raise InvalidParameter(
            f"the example of {plain.name} fails: {type(error).__name__}: {error}"
        ) from error
    if not agree(found, wanted):
        raise InvalidParameter(
            f"the example of {plain.name} says {plain.result}, but the function returns {found!r}"
        )
    return given


def agree(found: Any, wanted: Any) -> bool:
    """Whether the numbers of two answers are equal up to rounding; their shapes do not matter."""
    try:
        one, other = np.ravel(found).astype(float), np.ravel(wanted).astype(float)
    except (TypeError, ValueError):  # no numbers
        return False
    return len(one) == len(other) and bool(np.allclose(one, other))

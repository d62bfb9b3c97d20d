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

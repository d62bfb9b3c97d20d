"""Explanations of the most common Python errors, for students who meet them for the first time."""

import re
from collections.abc import Callable

from .outcomes import Misshapen, Outcome, Raised

OF_ARRAYS = "shape|size|ndim|T|dtype|sum|min|max|mean|tolist|astype|reshape|any|all"
OF_GENERATORS = "rand|uniform|integers|choice|normal|standard|shuffle|permut"  # how methods begin
OF_LISTS = "index|insert|extend|pop|remove|reverse|count"
# (key of the message, class of the exception, pattern of its text); the first match is used
COMMON_ERRORS = (
    ("ambiguous", "ValueError", "truth value of an array"),
    ("domain", "ValueError", "math domain error|expected a (nonneg|posi)tive|in range from -1"),
    ("domain", "TypeError", "'complex'|not complex"),
    ("empty", "ValueError", "arg is an empty|argument is empty|zero-size array|of an empty seq"),
    ("power", "TypeError", "ufunc 'bitwise_xor'|unsupported operand.*\\^"),
    ("no_numbers", "TypeError", "numpy boolean (subtract|negative)"),
    ("no_arrays", "TypeError", "unsupported operand.*'(tuple|list)'|can't multiply sequence"),
    ("no_arrays", "InvalidPoint", "must be one point"),
    ("whole", "TypeError", "scalar index"),
    ("one_number", "TypeError", "arrays can be converted"),
    ("no_append", "AttributeError", "ndarray' object has no attribute 'append'"),
    ("not_a_list", "AttributeError", f"'numpy.ndarray' object has no attribute '({OF_LISTS})'"),
    ("not_an_array", "AttributeError", f"'(list|tuple)' object has no attribute '({OF_ARRAYS})'"),
    ("rows_differ", "ValueError", "array element with a sequence"),
    ("not_in_list", "ValueError", "not in (list|deque)|tuple.index"),
    ("not_finite", "ValueError", "cannot convert float NaN"),
    ("not_finite", "OverflowError", "cannot convert float infinity"),
    (
        "unlisted",
        "TypeError",
        "'(set|map|zip|generator|dict_\\w+)' (object is not subscr|has no len)",
    ),
    ("cross", "ValueError", "3-dimensional vectors|dimensions for cross product"),
    ("shapes", "ValueError", "could not be broadcast|mismatch in its core dimension"),
    ("unpack", "ValueError", "values to unpack"),
    ("unpack", "TypeError", "cannot unpack non-iterable (?!NoneType)"),
    ("no_row", "IndexError", "invalid index to scalar"),
    ("no_row", "TypeError", "'(int|float|numpy\\.\\w+)' object is not subscriptable"),
    ("not_hashable", "TypeError", "unhashable type"),
    ("no_list", "TypeError", "'(int|float|numpy\\.\\w+)' (object is not iterable|has no len)"),
    ("joined_lists", "TypeError", "can only concatenate (list|tuple) (?!.*NoneType)"),
    ("shape_of_zeros", "TypeError", "as a data type"),
    ("brackets", "TypeError", "not callable|(function|method|type)' object is not subscr"),
    ("parameters", "TypeError", "positional argument|unexpected keyword|^problem\\.\\w+ takes "),
    ("two_indices", "TypeError", "indices must be integers or slices, not tuple"),
    ("whole", "IndexError", "only integers"),
    ("whole", "TypeError", "indices must be integers|interpreted as an integer"),
    ("nothing_left", "IndexError", "pop from|^index out of range$"),  # the last one is a heap's
    ("beyond_end", "IndexError", ""),
    ("nothing_left", "KeyError", "pop from|is empty"),
    ("no_key", "KeyError", ""),
    ("changed_in_loop", "RuntimeError", "during iteration"),
    ("seed", "AttributeError", f"'int' object has no attribute '({OF_GENERATORS})"),
    ("no_value", "UnboundLocalError", ""),
    ("unknown_name", "NameError", ""),
    ("unknown_name", "AttributeError", "^module "),
    ("problem_parts", "AttributeError", "^a problem has no "),
    ("ends_stay", "AttributeError", "^property '(start|goal)' of "),
    ("endless_calls", "RecursionError", ""),
    ("divided_by_zero", "ZeroDivisionError", ""),
    ("none", "TypeError", "NoneType"),
    ("none", "AttributeError", "NoneType"),
    ("nothing_next", "StopIteration", ""),
)
# the end of a message on a value whose items Python has not listed, or has in no order
UNLISTED = re.compile(r" (generator|map|zip|filter|enumerate|reversed|dict_\w+|(frozen)?set)$")
PLACED = re.compile(r"(at index|value) \d+")  # one of several values does not fit
EXCESS = re.compile(r"expected at most ")


def find_advice(outcome: Outcome) -> str:
    """Key of the message that explains a common error.

    Returns
    -------
    str
        A key of the table `advice` of the catalogue; "" where the error is not a common one.
    """
    if isinstance(outcome, Raised):
        for key, kind, message in COMMON_ERRORS:
            if kind in outcome.kinds and re.search(message, outcome.message):
                # check() calls the student's function itself: then no line is named
                return "arguments" if key == "parameters" and outcome.lines else key
    if isinstance(outcome, Misshapen):
        if outcome.message.endswith("Error"):
            return "returned_error"
        if UNLISTED.search(outcome.message):
            return "unlisted"
        if PLACED.match(outcome.message):
            return "placed"
    return ""


def raises_itself(outcome: Outcome) -> bool:
    """Whether the error comes from a line `raise ...` of the student's program."""
    if not isinstance(outcome, Raised) or not outcome.kinds or not outcome.lines:
        return False
    return bool(re.search(rf"\braise {re.escape(outcome.kinds[0])}\b", outcome.lines[-1]))


def is_excess(outcome: Outcome) -> bool:
    """Whether an answer has far more numbers or rows than a right one."""
    return isinstance(outcome, Misshapen) and bool(EXCESS.match(outcome.message))


def default_sizes(function: Callable[..., object]) -> list[int]:
    """Sizes of those default values of a function's parameters that calls can fill."""
    values = [
        *(getattr(function, "__defaults__", None) or ()),
        *(getattr(function, "__kwdefaults__", None) or {}).values(),
    ]
    return [len(value) for value in values if isinstance(value, list | set | dict)]

"""What Python's commonest complaints mean, for those who meet them for the first time."""

import re

from .outcomes import Misshapen, Outcome, Raised

# (key of the words, class of the exception, what its message says); the first that fits is told
COMPLAINTS = (
    ("ambiguous", "ValueError", "truth value of an array"),
    ("power", "TypeError", "bitwise_xor|unsupported operand.*\\^"),
    ("parameters", "TypeError", "positional argument|unexpected keyword"),
    ("beyond_end", "IndexError", ""),
    ("no_value", "UnboundLocalError", ""),
    ("unknown_name", "NameError", ""),
    ("endless_calls", "RecursionError", ""),
    ("divided_by_zero", "ZeroDivisionError", ""),
    ("none", "TypeError", "NoneType"),
)


def advice_on(outcome: Outcome) -> str:
    """The key of the words that explain an outcome, under `advice` in the catalogue; "" where
    nothing common was recognised.
    """
    if isinstance(outcome, Raised):
        for key, kind, message in COMPLAINTS:
            if kind in outcome.kinds and re.search(message, outcome.message):
                return key
    if isinstance(outcome, Misshapen) and outcome.message.endswith("Error"):
        return "returned_error"
    return ""

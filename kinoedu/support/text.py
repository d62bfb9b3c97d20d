"""Values as text for error messages."""

from typing import Any


def shortened(value: Any) -> str:
    """The repr of a value on one line of at most 80 characters."""
    text = " ".join(repr(value).split())
    return text if len(text) <= 80 else text[:77] + "..."

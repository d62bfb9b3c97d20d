"""Values as text for error messages."""

from typing import Any


def shortened(value: Any) -> str:
    """A value as text that fits an error message."""
    text = " ".join(repr(value).split())
    return text if len(text) <= 80 else text[:77] + "..."

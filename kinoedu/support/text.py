"""Values as text for error messages."""


def shortened(value: object) -> str:
    """The repr of a value on one line of at most 80 characters."""
    text = " ".join(repr(value).split())
    return text if len(text) <= 80 else text[:77] + "..."

"""Shared by the exercises on van der Corput's and Halton's sequences. Bullo & Smith, chapter 4;
LaValle, section 5.2.4.
"""


def digits(i: int, base: int) -> list[int]:
    """The digits of a whole number, the last one first; those of 0 are [0].

    >>> digits(6, 2)
    [0, 1, 1]
    """
    found = [i % base]
    while i := i // base:
        found.append(i % base)
    return found


def unmirrored(i: int, base: int) -> float:
    """The digits behind the point in the order in which they stand."""
    return i / float(base) ** len(digits(i, base))

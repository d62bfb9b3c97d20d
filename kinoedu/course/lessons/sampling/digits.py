"""Digits for the exercises on van der Corput's and Halton's sequences.

Bullo & Smith, chapter 4; LaValle, section 5.2.4.
"""


def find_digits(i: int, base: int) -> list[int]:
    """Return the digits of a whole number, lowest first; those of 0 are [0].

    >>> find_digits(6, 2)
    [0, 1, 1]
    """
    found = [i % base]
    while i := i // base:
        found.append(i % base)
    return found


def keep_order(i: int, base: int) -> float:
    """Return the number whose digits follow the point in their original order."""
    return i / float(base) ** len(find_digits(i, base))

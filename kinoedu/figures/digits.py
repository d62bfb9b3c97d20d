"""The Van der Corput sequence, digit by digit."""

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes

from ..geometry.checks import integer
from ..sampling import van_der_corput
from . import palette
from .palette import Style

LETTERS = "0123456789abcdefghijklmnopqrstuvwxyz"


def digits_of(i: int, base: int) -> str:
    """A nonnegative integer written in a base of at least 2.

    Digits beyond 9 are letters; in bases beyond 36 they are separated by spaces.

    Examples
    --------
    >>> digits_of(6, 2), digits_of(11, 3), digits_of(0, 2), digits_of(75, 40)
    ('110', '102', '0', '1 35')
    """
    found = [i % base]
    while i := i // base:
        found.append(i % base)
    if base <= len(LETTERS):
        return "".join(LETTERS[d] for d in found[::-1])
    return " ".join(map(str, found[::-1]))


def mirrored_digits(i: int, base: int) -> str:
    """The digits mirrored at the point.

    Examples
    --------
    >>> mirrored_digits(6, 2)
    '0.011'
    """
    digits = digits_of(i, base)
    return "0." + (digits[::-1] if base <= len(LETTERS) else " ".join(digits.split()[::-1]))


def draw_van_der_corput(n: int, base: int = 2, ax: Axes | None = None) -> list[Artist]:
    """Draw numbers 1 to n of the sequence: i, its digits, mirrored digits, and the point.

    Each number has a row, in which earlier points are small and grey.

    Returns
    -------
    list of artists

    Raises
    ------
    InvalidParameter

    Examples
    --------
    >>> from matplotlib import pyplot as plt
    >>> artists = draw_van_der_corput(7)
    >>> plt.close()
    """
    places = van_der_corput(integer(n, "n", least=1), base)
    ax = palette.axes_or_new(ax, (8.0, 0.8 + 0.36 * n))
    artists: list[Artist] = []
    mono: Style = {**palette.TEXT, "fontfamily": "monospace", "va": "center", "color": palette.INK}
    earlier: Style = {"color": palette.OUTSIDE, "markersize": 6, "zorder": 2}
    newest: Style = {"color": palette.TREE, "markersize": 11, "zorder": 3, **palette.RIM}
    for i, place in enumerate(places, start=1):
        artists += ax.plot([0, 1], [-i, -i], "-", color=palette.OUTSIDE, linewidth=1.2, zorder=1)
        artists += ax.plot(places[: i - 1], np.full(i - 1, -i), "o", **earlier)
        artists += ax.plot(place, -i, "o", **newest)
        text = f"{i:>3} = {digits_of(i, base):>6} -> {mirrored_digits(i, base)}"
        artists.append(ax.text(-0.52, -i, text, ha="left", **mono))
    ax.set_xlim(-0.54, 1.03)
    ax.set_ylim(-n - 0.6, -0.4)
    ax.set_xticks([0, 0.25, 0.5, 0.75, 1], ["0", "1/4", "1/2", "3/4", "1"])
    ax.tick_params(labelsize=palette.TEXT_SIZE)
    ax.set_yticks([])
    for side in ("left", "top", "right", "bottom"):
        ax.spines[side].set_visible(False)
    return artists

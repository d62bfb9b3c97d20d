"""Straight motions on a terrain: the cells they cross, samples along them, and their faults."""

import numpy as np

from ....geometry.checks import Array

MOST = 12  # cells along each side


def measure_length(a: Array, b: Array) -> float:
    """Return |b - a|."""
    return float(np.sqrt(((b - a) ** 2).sum()))


def find_cuts(a: Array, b: Array) -> Array:
    """Return the sorted fractions of a motion at which it enters another cell, with 0 and 1."""
    shares = [0.0, 1.0]
    for p, q in zip(a, b):
        lines = np.arange(np.ceil(min(p, q)), np.floor(max(p, q)) + 1.0)
        shares += ((lines - p) / (q - p)).tolist() if p != q else []
    return np.unique(np.clip(shares, 0.0, 1.0))


def find_crossed_cells(a: Array, b: Array) -> list[tuple[int, int]]:
    """Return the cells (i, j) that a motion crosses, in order.

    A motion of length 0 crosses the cell that contains it.
    """
    shares = find_cuts(a, b)
    middles = [a + (b - a) * t for t in (shares[1:] + shares[:-1]) / 2]
    return [(int(x), int(y)) for x, y in middles]


def sample_motion(a: Array, b: Array) -> Array:
    """Return points half a cell apart along a motion from a, and b itself, (n, 2)."""
    shares = np.append(
        np.arange(0.0, measure_length(a, b), 0.5) / (measure_length(a, b) or 1.0), 1.0
    )
    return a + shares[:, None] * (b - a)


def find_motion_fault(free: Array, a: Array, b: Array) -> str:
    """Return the rule that a terrain with a motion inside it breaks, or ""."""
    rows, columns = free.shape
    if not (1 <= rows <= MOST and 1 <= columns <= MOST) or not np.isin(free, (0, 1)).all():
        return "valid"
    inside = all(0 < x < columns and 0 < y < rows for x, y in (a, b))  # false for nan
    return "" if inside else "inside"

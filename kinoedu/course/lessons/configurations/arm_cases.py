"""Shared parts of the exercises on the two-link arm. Bullo & Smith, chapter 3."""

from typing import Any

import numpy as np

from ...exercise import Case
from ...shapes import Numbers

PAIR = Numbers((2,))


def arm_case(kind: str, l1: float, l2: float, **other: Any) -> Case:
    """Case of an arm."""
    ((name, pair),) = other.items()
    return Case(kind, {"l1": float(l1), "l2": float(l2), name: np.array(pair, float) + 0.0})

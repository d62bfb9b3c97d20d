"""Shared parts of the exercises on lines. Bullo & Smith, chapter 1."""

import numpy as np

from ...shapes import Numbers

POINT = Numbers((2,))
LEVEL, UPRIGHT = np.eye(2)

"""An arm on a board: its links, and which of them are in contact."""

import numpy as np

from ...browser.arms import find_hits, outline_links
from ...geometry.checks import Array
from ...robots.arm import ArmRobot
from ...worlds.checks import World


def links_in_contact(arm: ArmRobot, q: Array, world: World) -> list[int]:
    """Every link of a two-link arm, from 1, that touches something."""
    return [i + 1 for i in np.flatnonzero(find_hits(arm, world, np.asarray(q))).tolist()]


def link_outlines(arm: ArmRobot, q: Array) -> Array:
    """The outlines of the links at q, shape (2, 50, 2)."""
    return np.asarray(outline_links(arm, q)).reshape(2, -1, 2)

"""An arm on a board: its links and joints, and its contacts."""

from collections.abc import Sequence

import numpy as np

from ...collision import link_in_contact
from ...figures.bars import bar_outline
from ...geometry.checks import Array
from ...messages import get_message
from ...robots import ArmChain
from ...robots.arm import ArmRobot
from ...worlds.checks import World
from ..core.drawing import Layer, bodies, dots, labels

ASIDE = 0.15  # the distance of a link's name from it, as a fraction of its length
HITS = ("ink", "hit")  # the colours of links 1 and 2 in contact, as in the square


def links_in_contact(arm: ArmRobot, q: Array, world: World) -> list[int]:
    """Every link, from 1, that touches something.

    `link_in_contact` stops at the first one, so the second link is tried as an arm of its own.
    """
    first = link_in_contact(arm, q, world)
    if first != 1:
        return [first] if first else []
    second = ArmChain(arm.lengths[1:], 2.0 * arm.shape.radius[1], base=arm.joints(q)[0])
    return [1, 2] if link_in_contact(second, [q.sum()], world) else [1]


def describe_contact(hits: Sequence[int]) -> str:
    """The links in contact, in words."""
    if len(hits) == 2:
        return get_message("arm_board.both")
    return (
        get_message("figure.link_in_contact", link=hits[0])
        if hits
        else get_message("figure.no_link_in_contact")
    )


def link_outlines(arm: ArmRobot, q: Array) -> Array:
    """The outlines of the links at q, shape (2, 50, 2)."""
    joints, radii = [arm.base, *arm.joints(q)], arm.shape.radius
    links = zip(joints, joints[1:], radii, strict=False)
    return np.array([bar_outline(a, b, r) for a, b, r in links])


def draw_arm(arm: ArmRobot, q: Array, hits: Sequence[int]) -> list[Layer]:
    """Draw the arm at q; a link in contact is striped and has its colour in the square."""
    joints = np.array([arm.base, *arm.joints(q)])
    looks = [(HITS[i], True) if i + 1 in hits else ("free_link", False) for i in range(2)]
    links = [
        bodies([outline], colour, hatched=hit)
        for outline, (colour, hit) in zip(link_outlines(arm, q), looks, strict=True)
    ]
    return [
        *links,
        dots(joints[:1], "ink", radius=8.0),
        dots(joints[1:], "ink", radius=7.0),
        dots(joints[1:], "free", radius=4.5),
        label_links(joints, q),
    ]


def label_links(joints: Array, q: Array) -> Layer:
    """The links' names beside their midpoints, on the outer side of the bent elbow."""
    along = np.diff(joints, axis=0)
    lengths = np.sqrt((along**2).sum(axis=1, keepdims=True))
    far = ASIDE * float(lengths.max()) * (1.0 if q[1] >= 0.0 else -1.0)
    aside = far * np.column_stack([along[:, 1], -along[:, 0]]) / lengths
    names = [get_message("arm_board.link", number=i + 1) for i in range(2)]
    return labels(joints[:-1] + 0.5 * along + aside, names, "ink")

"""The body of the arm's board: an arm among obstacles, and the square of its two angles.

Sines, cosines and their inverses are each C library's own, so the last digits may differ.
"""

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..collision.arms import paint_image
from ..collision.turning import contact_size, piece_in_contact
from ..compiled import algorithm, compiled
from ..geometry.bars import bar_outline
from ..geometry.checks import Array
from ..geometry.parts import Parts
from ..geometry.rings import SIMPLE
from ..robots.arm import ArmRobot, compare_reach, joints_at
from ..robots.pulling import pull_elbow, pull_elbow_and_tip, pull_tip
from ..spaces.angles import wrap_angle
from .regions import name_regions
from .scenes import SceneArrays, find_fault, no_rows, refuse_ring, world_of_scene

CELLS = 360  # of the image, in each direction
ELBOW, TIP, Q, Q_BEFORE = range(4)  # the handles: two of the arm, q in the square, q as it was
CORNERS = 100  # columns of an outline
STILL = 1e-9  # a joint that moved by a smaller part of the arm is where another C library put it
ASIDE = 0.15  # the distance of a link's name from it, as a fraction of its length
PI = math.pi


class ArmSettings(NamedTuple):
    """An arm of two links: their lengths and width, and the place of the first joint."""

    first: float
    second: float
    width: float
    x: float
    y: float


class ShownArm(NamedTuple):
    """What is shown of an arm.

    facts : (9,), the status, q in radians and in degrees, how far the tip was pulled, the least and
        the largest distance that it reaches, and what the square says.
    free_links, first_hit, second_hit : (k, 100), outlines of links.
    base, joints : (1, 2) and (2, 2).
    names : (2, 3), rows x, y, link.
    grips : (2, 3), rows number, x, y: where elbow and tip are.
    regions : (k, 3), rows x, y, link: names of the image's regions.
    sights : (2, 4), lines through q.
    spot : (1, 3), row 0, q.
    image : the colours of the square.
    """

    facts: Array
    free_links: Array
    first_hit: Array
    second_hit: Array
    base: Array
    joints: Array
    names: Array
    grips: Array
    regions: Array
    sights: Array
    spot: Array
    image: Array


@algorithm
def show_arm(scene: SceneArrays, settings: ArmSettings, rng: np.random.Generator) -> ShownArm:
    """The arm after a pull on its elbow or tip, or at q where that was moved."""
    ring, fault = find_fault(scene)
    if fault.kind != SIMPLE:
        return ShownArm(
            refuse_ring(ring, fault),
            no_rows(),
            no_rows(),
            no_rows(),
            no_rows(),
            no_rows(),
            no_rows(),
            no_rows(),
            no_rows(),
            no_rows(),
            no_rows(),
            no_rows(),
        )
    world, arm = world_of_scene(scene), arm_of(settings)
    q, tip = q_of_scene(arm, scene.handles)
    image = paint_image(arm, world, CELLS, contact_size(world.lo, world.hi))
    return pose_arm(arm, world, q, tip, name_regions(image), image.astype(np.float64))


@compiled
def arm_of(settings: ArmSettings) -> ArmRobot:
    """The arm of the settings."""
    lengths, links = np.array([settings.first, settings.second]), np.zeros((4, 2))
    links[1, 0], links[3, 0] = settings.first, settings.second
    radius = np.full(2, settings.width / 2.0)
    return ArmRobot(
        lengths, np.array([settings.x, settings.y]), Parts(links, np.array([0, 2, 4]), radius)
    )


@compiled
def q_of_scene(arm: ArmRobot, handles: Array) -> tuple[Array, Array]:
    """The configuration of a scene whose handles were moved, and where the tip was pulled to.

    The tip's own place is returned where it was not pulled.
    """
    q, before = handles[Q, :2].copy(), handles[Q_BEFORE, :2]
    ends = np.empty((3, 2))
    joints_at(arm.lengths, arm.base, q, ends)
    if q[0] != before[0] or q[1] != before[1]:
        q[0], q[1] = wrap_angle(q[0]), wrap_angle(q[1])
        joints_at(arm.lengths, arm.base, q, ends)
        return q, ends[2].copy()
    elbow, tip = handles[ELBOW, :2].copy(), handles[TIP, :2].copy()
    least = STILL * (arm.lengths[0] + arm.lengths[1])
    pulls_elbow, pulls_tip = is_apart(elbow, ends[1], least), is_apart(tip, ends[2], least)
    if pulls_elbow and pulls_tip:
        q = pull_elbow_and_tip(arm, q, elbow, tip)
    elif pulls_elbow:
        q = pull_elbow(arm, q, elbow)
    elif pulls_tip:
        return pull_tip(arm, q, tip), tip
    joints_at(arm.lengths, arm.base, q, ends)
    return q, ends[2].copy()


@compiled
def is_apart(a: Array, b: Array, least: float) -> bool:
    """Whether two points differ by more than a least distance in x or y."""
    return abs(a[0] - b[0]) > least or abs(a[1] - b[1]) > least


@algorithm
def pose_arm(
    arm: ArmRobot, world: Any, q: Array, tip: Array, regions: Array, image: Array
) -> ShownArm:
    """An arm at q, whose tip was pulled to a place."""
    ends, hits = np.empty((3, 2)), find_hits(arm, world, q)
    joints_at(arm.lengths, arm.base, q, ends)
    outlines = outline_links(arm, q)
    l1, l2 = arm.lengths[0], arm.lengths[1]
    dx, dy = tip[0] - arm.base[0], tip[1] - arm.base[1]
    far = math.sqrt(dx * dx + dy * dy)
    contact = (1 if hits[0] else 0) + (2 if hits[1] else 0)
    first = 1 if hits[0] else 2 if hits[1] else 0
    inner, outer = abs(l1 - l2), l1 + l2
    status, degrees = 4.0 * compare_reach(l1, l2, far) + contact, 180.0 / PI
    facts = np.array(
        [status, q[0], q[1], degrees * q[0], degrees * q[1], far, inner, outer, float(first)]
    )
    spot = np.array([0.0, q[0], q[1]]).reshape(1, 3)
    grips = np.array([0.0, ends[1, 0], ends[1, 1], 1.0, ends[2, 0], ends[2, 1]]).reshape(2, 3)
    sights = np.array([-PI, q[1], PI, q[1], q[0], -PI, q[0], PI]).reshape(2, 4)
    return ShownArm(
        facts,
        outlines[~hits],
        outlines[:1][hits[:1]],
        outlines[1:][hits[1:]],
        ends[:1].copy(),
        ends[1:].copy(),
        name_links(ends, q[1]),
        grips,
        regions.copy(),
        sights,
        spot,
        image.copy(),
    )


@compiled
def find_hits(arm: ArmRobot, world: Any, q: Array) -> NDArray[np.bool_]:
    """Whether each link touches something, (2,)."""
    hits, corners, still = np.empty(2, np.bool_), np.empty((4, 5)), np.zeros(2)
    contact = contact_size(world.lo, world.hi)
    for i in range(2):
        hits[i] = piece_in_contact(arm, i, world, q, still, corners, contact, contact)
    return hits


@compiled
def outline_links(arm: ArmRobot, q: Array) -> Array:
    """The outlines of the links at q, (2, 100)."""
    ends, outlines = np.empty((3, 2)), np.empty((2, CORNERS))
    joints_at(arm.lengths, arm.base, q, ends)
    for i in range(2):
        outlines[i] = bar_outline(ends[i], ends[i + 1], arm.shape.radius[i]).ravel()
    return outlines


@compiled
def name_links(ends: Array, bend: float) -> Array:
    """Rows x, y, link: beside the middle of each link, on the outer side of the bent elbow."""
    names, lengths = np.empty((2, 3)), np.empty(2)
    for i in range(2):
        dx, dy = ends[i + 1, 0] - ends[i, 0], ends[i + 1, 1] - ends[i, 1]
        lengths[i] = math.sqrt(dx * dx + dy * dy)
    far = ASIDE * max(lengths[0], lengths[1]) * (1.0 if bend >= 0.0 else -1.0)
    for i in range(2):
        dx, dy = ends[i + 1, 0] - ends[i, 0], ends[i + 1, 1] - ends[i, 1]
        names[i, 0] = ends[i, 0] + 0.5 * dx + far * dy / lengths[i]
        names[i, 1] = ends[i, 1] + 0.5 * dy - far * dx / lengths[i]
        names[i, 2] = i + 1
    return names

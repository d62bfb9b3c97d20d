"""The link of an arm that is in contact: at one configuration, or over the configuration space.

Bullo & Smith, chapter 4.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import algorithm, compiled, inlined
from ..errors import InvalidPoint, InvalidRobot
from ..geometry.checks import Array, as_array, integer
from ..geometry.parts import Parts
from ..geometry.separation import line_towards, nearest_corner
from ..robots.arm import ArmRobot, check_arm
from ..robots.moving import X, Y, place_piece
from ..robots.round import RoundRobot
from ..spaces.angles import FULL_TURN, wrap_angle
from ..support.text import shortened
from ..worlds.checks import World, check_world
from ..worlds.nearby import obstacles_near, rim
from .interface import is_free
from .turning import box_within, contact_size, first_in_contact, meets_part

# radians: cells so near to the end of an interval are tested for collision; the closed form is far
# more accurate, except where the link only grazes the part
DOUBT = 1e-3


def link_in_contact(arm: ArmRobot, q: ArrayLike, world: World) -> int:
    """The first link that touches an obstacle or leaves the world, counted from 1; 0 for no link.

    Contact is the same as in `is_free`: it is decided to 1e-9 of the world's size.

    Parameters
    ----------
    arm : TwoLinkArm(...) or ArmChain(...).
    q : its angles, shape (n,).

    Returns
    -------
    int

    Raises
    ------
    InvalidRobot
        Where `arm` is not an arm.
    InvalidPoint
        Where q is not n angles.
    InvalidWorld
        Where `world` is not a world.

    Examples
    --------
    >>> from kinoedu import PolygonWorld, TwoLinkArm
    >>> world = PolygonWorld([(-4, -4), (4, -4), (4, 4), (-4, 4)], [((2, 1), 0.5)])
    >>> arm = TwoLinkArm(1.5, 1.2, 0.2)
    >>> [link_in_contact(arm, q, world) for q in ((0, 0), (0.6, 0), (0, 1.2))]
    [0, 2, 2]
    """
    check_arm(arm)
    check_world(world)
    angles = as_array(q, "q")
    if angles.shape != arm.lengths.shape:
        raise InvalidPoint(
            f"q must be {len(arm.lengths)} angles, one for each link, got {shortened(q)}"
        )
    return int(first_link_in_contact(arm, world, angles, contact_size(world.lo, world.hi)))


@compiled
def first_link_in_contact(arm: ArmRobot, world: World, q: Array, contact: float) -> int:
    """`link_in_contact` for arrays."""
    return first_in_contact(arm, world, q, np.zeros(len(q)), contact, contact) + 1


def paint_configuration_space(arm: ArmRobot, world: World, n: int = 360) -> NDArray[np.int8]:
    """Evaluate `link_in_contact` of a two-link arm over its configuration space, as an image.

    image[i2, i1] belongs to theta1 = angles[i1] and theta2 = angles[i2], where angles = -pi + (i +
    1/2) * 2 pi / n are the centres of n equal cells: theta1 to the right, theta2 up when row 0 is
    drawn lowest.

    Link 1 depends on theta1 alone; for each theta1, link 2 rotates about the elbow. The directions
    in which a link meets a convex obstacle are one interval around the direction of the obstacle's
    nearest point, and the ends of the interval have a closed form; only cells near an end are
    tested for collision. O(n (m + k)) for k corners within reach and m cells in the intervals of
    all obstacles, instead of O(n^2 k).

    Returns
    -------
    (n, n) array, int8.

    Raises
    ------
    InvalidRobot
        Where `arm` is not an arm of two links.
    InvalidWorld
        Where `world` is not a world.
    InvalidParameter
        Where n is not an integer from 1 to 20,000.

    Examples
    --------
    >>> from kinoedu import PolygonWorld, TwoLinkArm
    >>> world = PolygonWorld([(-4, -4), (4, -4), (4, 4), (-4, 4)], [((2, 1), 0.5)])
    >>> image = paint_configuration_space(TwoLinkArm(1.5, 1.2, 0.2), world, 36)
    >>> [int((image == link).sum()) for link in (0, 1, 2)]
    [1224, 0, 72]
    """
    check_arm(arm)
    check_world(world)
    if len(arm.lengths) != 2:
        raise InvalidRobot(
            "the image is for an arm of two links, one for each axis; this one has "
            f"{len(arm.lengths)}"
        )
    side = integer(n, "n", least=1, most=20_000)
    return paint_image(arm, world, side, contact_size(world.lo, world.hi))


@algorithm
def paint_image(arm: ArmRobot, world: World, n: int, contact: float) -> NDArray[np.int8]:
    """`paint_configuration_space` for checked arguments."""
    image, first = np.zeros((n, n), np.int8), np.zeros(n, np.int8)
    corners, q = np.empty((4, 5)), np.zeros(2)
    if is_free(RoundRobot(arm.shape.radius[0]), world, arm.base, contact):
        paint_link(arm, 0, world, q, contact, corners, first)
    else:
        first[:] = 1  # the base itself is in contact
    for i1 in range(n):
        if first[i1] == 1:
            image[:, i1] = 1
        else:
            q[0] = cell_angle(i1, n)
            paint_link(arm, 1, world, q, contact, corners, image[:, i1])
    return image


@compiled
def paint_link(
    arm: ArmRobot,
    i: int,
    world: World,
    q: Array,
    contact: float,
    corners: Array,
    cells: NDArray[np.int8],
) -> None:
    """Paint the angles of link i at which it is in contact; the joint where it begins is not."""
    q[i] = 0.0
    place_piece(arm, i, q, np.zeros(2), 0.0, corners)
    x, y = corners[2 * i, X], corners[2 * i, Y]
    reach, ring = arm.lengths[i] + arm.shape.radius[i] + contact, rim(world)
    x0, y0, x1, y1 = x - reach, y - reach, x + reach, y + reach
    if not box_within(x0, y0, x1, y1, ring):
        walls = rim_parts(ring)
        paint_parts(arm, i, q, walls, np.arange(len(walls.radius)), contact, corners, cells)
    parts, near = obstacles_near(world, x0, y0, x1, y1)
    paint_parts(arm, i, q, parts, near, contact, corners, cells)


@compiled
def rim_parts(ring: Array) -> Parts:
    """The edges of a ring as parts of two points each.

    A body that starts inside the ring can leave it only through one of them.
    """
    n = len(ring)
    points = np.empty((2 * n, 2))
    for i in range(n):
        points[2 * i], points[2 * i + 1] = ring[i - 1], ring[i]
    return Parts(points, 2 * np.arange(n + 1), np.zeros(n))


@compiled
def cell_angle(i: int, n: int) -> float:
    """The angle at the centre of cell i of n."""
    return (i + 0.5) * (FULL_TURN / n) - math.pi


@compiled
def paint_parts(
    arm: ArmRobot,
    i: int,
    q: Array,
    parts: Parts,
    near: NDArray[np.int64],
    contact: float,
    corners: Array,
    cells: NDArray[np.int8],
) -> None:
    """Paint the angles of link i at which it meets a part.

    Row 2 i of `corners` is the joint where the link begins; it touches none of the parts.
    """
    n, still = len(cells), np.zeros(2)
    length, radius = arm.lengths[i], arm.shape.radius[i] + contact
    x, y = corners[2 * i, X], corners[2 * i, Y]
    straight = q[:i].sum()  # the link's direction where its angle is 0
    for j in near:
        r = radius + parts.radius[j]
        _, a, b, apart = nearest_corner(
            corners, 2 * i, 2 * i + 1, parts.points, parts.first[j], parts.first[j + 1]
        )
        if apart > length + r + contact:
            continue
        _, _, nx, ny = line_towards(
            x, y, parts.points[a, X], parts.points[a, Y], parts.points[b, X], parts.points[b, Y]
        )
        towards = math.atan2(-ny, -nx)
        ahead = wrap_angle(towards - straight)
        below = math.floor((ahead + math.pi) / (FULL_TURN / n) - 0.5)
        clockwise, counter = last_contacts(parts, j, x, y, length, r, towards)
        for begin, side, half in ((below, -1, clockwise), (below + 1, 1, counter)):
            turn = ahead + side * half
            count = cells_in_contact(
                arm, i, q, still, corners, parts, j, contact, begin, side, n, turn
            )
            for k in range(count):
                cells[(begin + k * side) % n] = i + 1


@inlined
def cells_in_contact(
    arm: ArmRobot,
    i: int,
    q: Array,
    still: Array,
    corners: Array,
    parts: Parts,
    j: int,
    contact: float,
    begin: int,
    side: int,
    n: int,
    turn: float,
) -> int:
    """The number of cells, counted from `begin`, at which link i meets part j.

    The closed form says that it meets the part up to the angle `turn`; cells near that angle are
    tested for collision. There is no contact beyond a right angle from the part's nearest point.
    """
    most = max(min(n // 4 + 2, n // 2), 1)
    cells = n / FULL_TURN
    doubt = (DOUBT + 2.0 * math.sqrt(contact / arm.lengths[i])) * cells
    to_end = side * (turn - cell_angle(begin, n)) * cells
    count = min(max(math.floor(to_end - doubt) + 1, 0), most)
    while count < most and count <= to_end + doubt:
        q[i] = cell_angle((begin + count * side) % n, n)
        if not meets_part(
            arm, i, q, still, corners, parts, j, arm.shape.radius[i] + contact, contact
        ):
            break
        count += 1
    return count


@compiled
def last_contacts(
    parts: Parts, j: int, x: float, y: float, length: float, r: float, towards: float
) -> tuple[float, float]:
    """The largest angles to either side at which a link comes within `r` of part j.

    The first is clockwise, the second counter-clockwise; in radians, at least 0. The link turns
    about (x, y), starting in the direction `towards` of the part's nearest point. At the last
    contact its end or its flank touches a circle round a corner, or its end crosses the line
    parallel to an edge.
    """
    begin, end = parts.first[j], parts.first[j + 1]
    clockwise, counter, before = 0.0, 0.0, end - 1
    for k in range(begin, end):
        ax, ay = parts.points[before, X] - x, parts.points[before, Y] - y
        bx, by = parts.points[k, X] - x, parts.points[k, Y] - y
        before = k
        turn, half = wrap_angle(math.atan2(by, bx) - towards), angle_at_corner(bx, by, length, r)
        clockwise, counter = max(clockwise, half - turn), max(counter, half + turn)
        right, left = angles_at_edge(ax, ay, bx, by, length, r, towards)
        clockwise, counter = max(clockwise, right), max(counter, left)
    return clockwise, counter


@compiled
def angle_at_corner(x: float, y: float, length: float, radius: float) -> float:
    """The angle from a corner's direction to a link that touches the circle round it.

    The link begins at the origin. -inf where the circle, of this radius, is out of reach.
    """
    squared = x * x + y * y
    d = math.sqrt(squared)
    if not radius <= d <= length + radius:
        return -np.inf
    if squared - radius * radius <= length * length:
        return math.asin(radius / d)
    return math.acos(min((squared + length * length - radius * radius) / (2.0 * d * length), 1.0))


@compiled
def angles_at_edge(
    ax: float, ay: float, bx: float, by: float, length: float, offset: float, towards: float
) -> tuple[float, float]:
    """The angles from `towards` at which the end of a link crosses the line parallel to an edge.

    The first is clockwise, the second counter-clockwise. The link begins at the origin; the line
    lies at this offset on the origin's side of the edge a-b. -inf where the end of the link passes
    beyond the ends of the edge.
    """
    ex, ey = bx - ax, by - ay
    size = math.sqrt(ex * ex + ey * ey)
    if size == 0.0:
        return -np.inf, -np.inf
    # signed: the foot of the perpendicular on the edge's line is (ey, -ex) * apart / size
    apart = (ax * ey - ay * ex) / size
    d = abs(apart) - offset
    if not 0.0 <= d <= length:
        return -np.inf, -np.inf
    turn, half = wrap_angle(math.atan2(-ex * apart, ey * apart) - towards), math.acos(d / length)
    foot = -(ax * ex + ay * ey) / size  # from a on, along the edge
    along = math.copysign(math.sqrt(length * length - d * d), apart)
    return (
        half - turn if 0.0 <= foot - along <= size else -np.inf,
        half + turn if 0.0 <= foot + along <= size else -np.inf,
    )

"""The link of an arm that is in contact: at one configuration, or over the configuration space.

Bullo & Smith, chapter 4.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import algorithm, compiled, inlined
from ..errors import InvalidParameter, InvalidPoint, InvalidRobot
from ..geometry.checks import Array, as_array
from ..geometry.parts import Parts
from ..geometry.separation import line_towards, nearest_corner
from ..robots.arm import ArmRobot
from ..robots.moving import X, Y, place_piece
from ..spaces.angles import FULL_TURN, wrap_angle
from ..support.text import shortened
from ..worlds.checks import World, check_world
from ..worlds.nearby import obstacles_near, rim
from .turning import contact_size, first_in_contact, meets_part, piece_in_contact

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


def check_arm(arm: object) -> None:
    """Raise InvalidRobot where the argument is not an arm."""
    if not isinstance(arm, ArmRobot):
        raise InvalidRobot(
            f"expected an arm such as TwoLinkArm(1.5, 1.2, 0.2), got {shortened(arm)}"
        )


@compiled
def first_link_in_contact(arm: ArmRobot, world: World, q: Array, contact: float) -> int:
    """`link_in_contact` for arrays."""
    return first_in_contact(arm, world, q, np.zeros(len(q)), contact, contact) + 1


def paint_configuration_space(arm: ArmRobot, world: World, n: int = 360) -> NDArray[np.int8]:
    """Evaluate `link_in_contact` of a two-link arm over its configuration space, as an image.

    image[i2, i1] belongs to theta1 = angles[i1] and theta2 = angles[i2], where angles = -pi + (i +
    1/2) * 2 pi / n are the centres of n equal cells: theta1 to the right, theta2 up when row 0 is
    drawn lowest.

    Link 1 depends on theta1 alone. Link 2 rotates about the elbow. The directions in which it meets
    a convex obstacle are one interval around the direction of the obstacle's nearest point, and the
    ends of the interval have a closed form; only cells near an end are tested for collision. O(n (n
    + k)) for k corners within reach, instead of O(n^2 k).

    Returns
    -------
    (n, n) array, int8.

    Raises
    ------
    InvalidRobot
        Where `arm` is not an arm of two links.
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
    if len(arm.lengths) != 2:
        raise InvalidRobot(
            "the image is for an arm of two links, one for each axis; this one has "
            f"{len(arm.lengths)}"
        )
    if isinstance(n, bool) or not isinstance(n, int | np.integer) or not 1 <= n <= 20_000:
        raise InvalidParameter(f"n must be a whole number from 1 to 20,000, got {n!r}")
    return paint_image(
        arm, world, np.zeros((int(n), int(n)), np.int8), contact_size(world.lo, world.hi)
    )


@algorithm
def paint_image(
    arm: ArmRobot, world: World, image: NDArray[np.int8], contact: float
) -> NDArray[np.int8]:
    """Write `paint_configuration_space` into an image of zeros."""
    n, ring = len(image), rim_parts(rim(world))
    corners, q, still = np.empty((4, 5)), np.zeros(2), np.zeros(2)
    for i1 in range(n):
        q[0], q[1] = cell_angle(i1, n), 0.0
        if piece_in_contact(arm, 0, world, q, still, corners, contact, contact):
            image[:, i1] = 1
            continue
        place_piece(arm, 1, q, still, 0.0, corners)
        x, y, reach = corners[2, X], corners[2, Y], arm.lengths[1] + arm.shape.radius[1] + contact
        paint_second_link(arm, q, ring, np.arange(len(ring.radius)), contact, corners, image[:, i1])
        parts, near = obstacles_near(world, x - reach, y - reach, x + reach, y + reach)
        paint_second_link(arm, q, parts, near, contact, corners, image[:, i1])
    return image.copy()


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
def paint_second_link(
    arm: ArmRobot,
    q: Array,
    parts: Parts,
    near: NDArray[np.int64],
    contact: float,
    corners: Array,
    column: NDArray[np.int8],
) -> None:
    """Paint the angles of link 2 at which it meets a part; its elbow touches none of the parts."""
    n, still = len(column), np.zeros(2)
    reach = arm.lengths[1] + arm.shape.radius[1] + 2.0 * contact
    for j in near:
        q[1] = 0.0
        place_piece(arm, 1, q, still, 0.0, corners)
        x, y = corners[2, X], corners[2, Y]
        _, a, b, apart = nearest_corner(
            corners, 2, 3, parts.points, parts.first[j], parts.first[j + 1]
        )
        if apart > reach + parts.radius[j]:
            continue
        _, _, nx, ny = line_towards(
            x, y, parts.points[a, X], parts.points[a, Y], parts.points[b, X], parts.points[b, Y]
        )
        towards = math.atan2(-ny, -nx)
        ahead = wrap_angle(towards - q[0])
        below = math.floor((ahead + math.pi) / (FULL_TURN / n) - 0.5)
        for begin, side in ((below, -1), (below + 1, 1)):
            r = arm.shape.radius[1] + parts.radius[j] + contact
            turn = ahead + side * last_contact(parts, j, x, y, arm.lengths[1], r, towards, side)
            count = cells_in_contact(
                arm, q, still, corners, parts, j, contact, begin, side, n, turn
            )
            for k in range(count):
                column[(begin + k * side) % n] = 2


@inlined
def cells_in_contact(
    arm: ArmRobot,
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
    """The number of cells, counted from `begin`, at which link 2 meets part j.

    The closed form says that it meets the part up to the angle `turn`; cells near that angle are
    tested for collision. There is no contact beyond a right angle from the part's nearest point.
    """
    most = max(min(n // 4 + 2, n // 2), 1)
    cells = n / FULL_TURN
    doubt = (DOUBT + 2.0 * math.sqrt(contact / arm.lengths[1])) * cells
    to_end = side * (turn - cell_angle(begin, n)) * cells
    count = min(max(math.floor(to_end - doubt) + 1, 0), most)
    while count < most and count <= to_end + doubt:
        q[1] = cell_angle((begin + count * side) % n, n)
        if not meets_part(
            arm, 1, q, still, corners, parts, j, arm.shape.radius[1] + contact, contact
        ):
            break
        count += 1
    return count


@compiled
def last_contact(
    parts: Parts, j: int, x: float, y: float, length: float, r: float, towards: float, side: int
) -> float:
    """The largest angle to one side at which a link comes within `r` of part j; radians, >= 0.

    The link turns about (x, y), starting in the direction `towards` of the part's nearest point, to
    the side 1 or -1. At the last contact its end or its flank touches a circle round a corner, or
    its end crosses the line parallel to an edge.
    """
    begin, end, last = parts.first[j], parts.first[j + 1], 0.0
    before = end - 1
    for k in range(begin, end):
        ax, ay = parts.points[before, X] - x, parts.points[before, Y] - y
        bx, by = parts.points[k, X] - x, parts.points[k, Y] - y
        before = k
        last = max(
            last,
            side * wrap_angle(math.atan2(by, bx) - towards) + angle_at_corner(bx, by, length, r),
        )
        last = max(last, angle_at_edge(ax, ay, bx, by, length, r, towards, side))
    return last


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
def angle_at_edge(
    ax: float,
    ay: float,
    bx: float,
    by: float,
    length: float,
    offset: float,
    towards: float,
    side: int,
) -> float:
    """The angle at which the end of a link crosses the line parallel to the edge a-b.

    The link begins at the origin; the line lies at this offset on the origin's side. The angle
    is measured from `towards` to one side; -inf where the end of the link passes beyond the ends of
    the edge.
    """
    ex, ey = bx - ax, by - ay
    size = math.sqrt(ex * ex + ey * ey)
    if size == 0.0:
        return -np.inf
    # signed: the foot of the perpendicular on the edge's line is (ey, -ex) * apart / size
    apart = (ax * ey - ay * ex) / size
    if not 0.0 <= abs(apart) - offset <= length:
        return -np.inf
    straight, half = math.atan2(-ex * apart, ey * apart), math.acos((abs(apart) - offset) / length)
    tip = straight + side * half
    along = ((length * math.cos(tip) - ax) * ex + (length * math.sin(tip) - ay) * ey) / size
    return side * wrap_angle(straight - towards) + half if 0.0 <= along <= size else -np.inf

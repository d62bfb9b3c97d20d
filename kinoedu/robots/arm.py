"""Arms in the plane: bars with rounded ends, one joint after another. Bullo & Smith, chapter 3."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..compiled import compiled
from ..errors import InvalidPoint, InvalidRobot
from ..geometry.checks import Array, as_array, as_point
from ..geometry.exact import length
from ..geometry.parts import Parts, make_parts
from ..spaces.angles import wrapped
from ..support.text import shortened

RIM = 1e-12  # of the arm's length: so near to the rim of what it reaches, a target is on it


class ArmRobot(NamedTuple):
    """What `TwoLinkArm` and `ArmChain` make: lengths (n,), base (2,), and each link as a bar along
    the x-axis of its own frame.

    A configuration q has n angles: the first link's from the x-axis, and each other's from the link
    before it.
    """

    lengths: Array
    base: Array
    shape: Parts

    def joints(self, q: ArrayLike) -> tuple[Array, ...]:
        """Where each link ends: for two links the elbow and the tip. Forward kinematics. Raises
        InvalidPoint.

        >>> elbow, tip = TwoLinkArm(2, 1, 0.2).joints((0, np.pi / 2))
        >>> elbow, tip.round(12)
        (array([2., 0.]), array([2., 1.]))
        """
        angles = as_array(q, "q")
        if angles.shape != self.lengths.shape:
            raise InvalidPoint(
                f"q must be {len(self.lengths)} angles, one for each link, got {shortened(q)}"
            )
        ends = np.empty((len(angles) + 1, 2))
        joints_at(self.lengths, self.base, angles, ends)
        return tuple(ends[1:])

    def inverse(self, p: ArrayLike) -> list[Array]:
        """Every q that puts the tip of a two-link arm at p, angles in [-pi, pi): the one with the
        elbow to the right of the way to p first, the one to its left second. At the rims of what it
        reaches there is one; beyond them none, and `why_unreachable` says why. Inverse kinematics.

        Raises InvalidPoint where all angles of link 1 do, which is at the base of an arm of two
        equal links; InvalidRobot unless there are two links.

        >>> arm = TwoLinkArm(2, 1, 0.2)
        >>> [q.round(6).tolist() for q in arm.inverse((2, 1))], arm.inverse((3, 0)), arm.inverse((4, 0))
        ([[0.0, 1.570796], [0.927295, -1.570796]], [array([0., 0.])], [])
        """
        l1, l2, x, y, far = two_links(self, p)
        if far == 0.0 and l1 == l2:
            raise InvalidPoint(
                "at its base an arm of two equal links has infinitely many solutions: q = (any "
                "angle, -pi)"
            )
        whole, heading = l1 + l2, math.atan2(y, x)
        if abs(far - whole) <= RIM * whole:
            return [np.array([wrapped(heading), 0.0])]
        if abs(far - abs(l1 - l2)) <= RIM * whole and l1 != l2:
            return [np.array([wrapped(heading if l1 > l2 else heading + math.pi), -math.pi])]
        if far > whole or far < abs(l1 - l2):
            return []
        # half angles of the triangle base, elbow, tip: tangents stay accurate near the rims,
        # cosines do not
        bend = 2.0 * math.atan2(
            math.sqrt((whole - far) * (whole + far)), math.sqrt((far - l1 + l2) * (far + l1 - l2))
        )
        lead = 2.0 * math.atan2(
            math.sqrt((whole - far) * (l2 + far - l1)), math.sqrt((far + l1 - l2) * (far + whole))
        )
        return [
            np.array([wrapped(heading - lead), wrapped(bend)]),
            np.array([wrapped(heading + lead), wrapped(-bend)]),
        ]


def TwoLinkArm(l1: float, l2: float, width: float, *, base: ArrayLike = (0.0, 0.0)) -> ArmRobot:
    """An arm of two links. Its configuration is q = (angle of link 1, angle of link 2 from link 1),
    in radians.

    Parameters
    ----------
    l1, l2 : the lengths between joints, in the world's unit.
    width : W; each link is a bar with rounded ends, all that is within W / 2 of the line between
    its joints. 0 makes it a line.
    base : where the first joint is.

    Raises InvalidRobot, InvalidPoint.

    >>> TwoLinkArm(1.5, 1.2, 0.2).shape.radius
    array([0.1, 0.1])
    """
    if any(isinstance(size, bool | np.bool_) for size in (l1, l2, width)):
        raise InvalidRobot(f"an arm's sizes must be numbers, got {l1!r}, {l2!r} and {width!r}")
    return ArmChain([l1, l2], width, base=base)


def ArmChain(lengths: ArrayLike, width: float, *, base: ArrayLike = (0.0, 0.0)) -> ArmRobot:
    """An arm of any number of links, shape (n,), each moved by the joint at its beginning; all else
    as in `TwoLinkArm`.

    Raises InvalidRobot, InvalidPoint.
    """
    sizes, across = as_array(lengths, "the links' lengths"), as_array(width, "width")
    if sizes.ndim != 1 or len(sizes) == 0 or (sizes <= 0.0).any():
        raise InvalidRobot(f"an arm's links must have positive lengths, got {shortened(lengths)}")
    if across.ndim or across < 0.0:
        raise InvalidRobot(f"an arm's width must be one length, zero or more, got {width!r}")
    links = make_parts(
        [np.array([(0.0, 0.0), (size, 0.0)]) for size in sizes], [float(across) / 2.0] * len(sizes)
    )
    return ArmRobot(sizes, as_point(base, "base"), links)


def why_unreachable(arm: ArmRobot, p: ArrayLike) -> str:
    """Why a two-link arm cannot put its tip at p, in words; empty where it can. Raises
    InvalidPoint, InvalidRobot.

    >>> why_unreachable(TwoLinkArm(2, 1, 0.2), (4, 0))
    'it is 4 from the base, and the links together reach only 3'
    """
    l1, l2, _, _, far = two_links(arm, p)
    if far > (l1 + l2) * (1.0 + RIM):
        return f"it is {far:g} from the base, and the links together reach only {l1 + l2:g}"
    if far < abs(l1 - l2) - RIM * (l1 + l2):
        return (
            f"it is {far:g} from the base, and folded up the arm still reaches {abs(l1 - l2):g} "
            "away"
        )
    return ""


def two_links(arm: ArmRobot, p: ArrayLike) -> tuple[float, float, float, float, float]:
    """The two lengths, and a target seen from the base: x, y and its distance."""
    if len(arm.lengths) != 2:
        raise InvalidRobot(
            f"inverse kinematics is for an arm of two links, this one has {len(arm.lengths)}"
        )
    (l1, l2), (x, y) = arm.lengths.tolist(), (as_point(p, "p") - arm.base).tolist()
    return l1, l2, x, y, length(x, y)


@compiled
def joints_at(lengths: Array, base: Array, q: Array, ends: Array) -> None:
    """Write where the joints are into ends, shape (n + 1, 2): the base first, the tip last."""
    ends[0] = base
    angle = 0.0
    for i in range(len(lengths)):
        angle += q[i]
        ends[i + 1, 0] = ends[i, 0] + lengths[i] * math.cos(angle)
        ends[i + 1, 1] = ends[i, 1] + lengths[i] * math.sin(angle)

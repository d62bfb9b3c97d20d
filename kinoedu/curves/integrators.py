"""Motion of a car with constant speed v and curvature kappa, computed in three ways.

The equations are x' = v cos theta, y' = v sin theta, theta' = v kappa. The global error of Euler's
rule is proportional to the step, that of the classical Runge-Kutta rule to the fourth power of the
step. The closed form has no error. Source: LaValle, section 14.3.2.
"""

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from ..geometry.checks import Array, as_array, integer
from ..spaces.angles import wrap_angle
from .arcs import drive_arc
from .curve import as_pose

Rule = Callable[[Array, float, float, float], Array]


def rates(pose: Array, v: float, curvature: float) -> Array:
    """The derivative of a pose with respect to time, shape (3,)."""
    return np.array([v * math.cos(pose[2]), v * math.sin(pose[2]), v * curvature])


def euler_step(pose: Array, v: float, curvature: float, h: float) -> Array:
    """One step along the derivative at its beginning."""
    return pose + h * rates(pose, v, curvature)


def runge_kutta_step(pose: Array, v: float, curvature: float, h: float) -> Array:
    """One step with derivatives at its beginning, twice at its middle, and at its end.

    Their weights are 1 : 2 : 2 : 1.
    """
    k1 = rates(pose, v, curvature)
    k2 = rates(pose + 0.5 * h * k1, v, curvature)
    k3 = rates(pose + 0.5 * h * k2, v, curvature)
    k4 = rates(pose + h * k3, v, curvature)
    return pose + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)


def exact_step(pose: Array, v: float, curvature: float, h: float) -> Array:
    """One step along the exact arc."""
    return np.array(drive_arc(pose[0], pose[1], pose[2], v * h, curvature))


def euler(pose: ArrayLike, v: float, curvature: float, t: float, steps: int) -> Array:
    """The poses at steps + 1 equally spaced times from 0 to t, by Euler's rule.

    Parameters
    ----------
    pose : (3,) start (x, y, theta).
    v, curvature, t : numbers.
    steps : a positive integer.

    Returns
    -------
    (steps + 1, 3) array
        Headings are wrapped.

    Raises
    ------
    InvalidPoint
        Where the pose or a number is not finite.
    InvalidParameter
        Where `steps` is not a positive integer.

    Examples
    --------
    >>> euler((0, 0, 0), 1, 1, 1, 2)[-1]
    array([0.93879128, 0.23971277, 1.        ])
    """
    return integrate(euler_step, pose, v, curvature, t, steps)


def runge_kutta(pose: ArrayLike, v: float, curvature: float, t: float, steps: int) -> Array:
    """The poses as `euler` returns them, by the classical Runge-Kutta rule of order four.

    Examples
    --------
    >>> runge_kutta((0, 0, 0), 1, 1, 1, 2)[-1]
    array([0.84148938, 0.45970774, 1.        ])
    """
    return integrate(runge_kutta_step, pose, v, curvature, t, steps)


def exact(pose: ArrayLike, v: float, curvature: float, t: float, steps: int) -> Array:
    """The poses as `euler` returns them, in closed form.

    Examples
    --------
    >>> exact((0, 0, 0), 1, 1, 1, 2)[-1]
    array([0.84147098, 0.45969769, 1.        ])
    """
    return integrate(exact_step, pose, v, curvature, t, steps)


def integrate(
    rule: Rule, pose: ArrayLike, v: float, curvature: float, t: float, steps: int
) -> Array:
    """The poses after each step of a rule, shape (steps + 1, 3); headings are wrapped."""
    n = integer(steps, "steps", least=1)
    speed, kappa, time = as_array((v, curvature, t), "v, curvature and t")
    poses = np.empty((n + 1, 3))
    poses[0] = as_pose(pose, "pose")
    for k in range(n):
        poses[k + 1] = rule(poses[k], float(speed), float(kappa), float(time) / n)
        poses[k + 1, 2] = wrap_angle(poses[k + 1, 2])
    return poses

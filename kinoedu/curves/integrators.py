"""How a car's motion is computed: step by step with Euler's rule or Runge's and Kutta's, or in
closed form.

x' = v cos theta, y' = v sin theta, theta' = v kappa, with a speed v and a curvature kappa that are
held. Euler's error falls like the step, that of the classical Runge-Kutta rule like its fourth
power; the closed form has none. LaValle, section 14.3.2.
"""

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from ..geometry.checks import Array, as_array, whole
from ..spaces.angles import wrapped
from .arcs import driven
from .curve import as_pose

Rule = Callable[[Array, float, float, float], Array]


def rates(pose: Array, v: float, curvature: float) -> Array:
    """How fast each coordinate of a pose changes, shape (3,)."""
    return np.array([v * math.cos(pose[2]), v * math.sin(pose[2]), v * curvature])


def euler_step(pose: Array, v: float, curvature: float, h: float) -> Array:
    """Straight on as fast as at the beginning of the step."""
    return pose + h * rates(pose, v, curvature)


def runge_kutta_step(pose: Array, v: float, curvature: float, h: float) -> Array:
    """With the rates at the beginning, twice in the middle and at the end, weighed 1 : 2 : 2 :
    1.
    """
    k1 = rates(pose, v, curvature)
    k2 = rates(pose + 0.5 * h * k1, v, curvature)
    k3 = rates(pose + 0.5 * h * k2, v, curvature)
    k4 = rates(pose + h * k3, v, curvature)
    return pose + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)


def exact_step(pose: Array, v: float, curvature: float, h: float) -> Array:
    """Along the arc itself."""
    return np.array(driven(pose[0], pose[1], pose[2], v * h, curvature))


def euler(pose: ArrayLike, v: float, curvature: float, t: float, steps: int) -> Array:
    """The poses at steps + 1 even times from 0 to t by Euler's rule, shape (steps + 1, 3).
    InvalidPoint, InvalidParameter.

    >>> euler((0, 0, 0), 1, 1, 1, 2)[-1]
    array([0.93879128, 0.23971277, 1.        ])
    """
    return integrated(euler_step, pose, v, curvature, t, steps)


def runge_kutta(pose: ArrayLike, v: float, curvature: float, t: float, steps: int) -> Array:
    """The same by the classical Runge-Kutta rule of the fourth order.

    >>> runge_kutta((0, 0, 0), 1, 1, 1, 2)[-1]
    array([0.84148938, 0.45970774, 1.        ])
    """
    return integrated(runge_kutta_step, pose, v, curvature, t, steps)


def exact(pose: ArrayLike, v: float, curvature: float, t: float, steps: int) -> Array:
    """The same in closed form.

    >>> exact((0, 0, 0), 1, 1, 1, 2)[-1]
    array([0.84147098, 0.45969769, 1.        ])
    """
    return integrated(exact_step, pose, v, curvature, t, steps)


def integrated(
    rule: Rule, pose: ArrayLike, v: float, curvature: float, t: float, steps: int
) -> Array:
    """Step after step by a rule; headings are wrapped. Raises InvalidPoint, InvalidParameter."""
    n = whole(steps, "steps", least=1)
    speed, bend, time = as_array((v, curvature, t), "v, curvature and t")
    poses = np.empty((n + 1, 3))
    poses[0] = as_pose(pose, "pose")
    for k in range(n):
        poses[k + 1] = rule(poses[k], float(speed), float(bend), float(time) / n)
        poses[k + 1, 2] = wrapped(poses[k + 1, 2])
    return poses

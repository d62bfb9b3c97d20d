"""Lesson 5: Configuration spaces. Its exercises, in the order of the notebook."""

from .circle_distance import CircleDistance
from .degrees_of_freedom import DegreesOfFreedom
from .displacement import Displacement
from .exposing_reach import ExposeReach
from .forward_kinematics import ForwardKinematics
from .inverse_kinematics import InverseKinematics
from .rotation import Rotation
from .torus_distance import TorusDistance

EXERCISES = [
    DegreesOfFreedom,
    Rotation,
    Displacement,
    ForwardKinematics,
    InverseKinematics,
    CircleDistance,
    TorusDistance,
    ExposeReach,
]

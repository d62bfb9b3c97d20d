"""Lesson 14: Moving and uncertain obstacles. Its exercises, in the order of the notebook."""

from .chance_margins import ChanceMargins
from .collision_probability import CollisionProbability
from .earliest_arrival import EarliestArrival
from .exposing_motions import ExposeMoments
from .first_contact import FirstContact

EXERCISES = [
    FirstContact,
    EarliestArrival,
    ChanceMargins,
    CollisionProbability,
    ExposeMoments,
]

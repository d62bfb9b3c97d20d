"""Lesson 13: Planning by driving. Its exercises, in the order of the notebook."""

from .best_control import BestControl
from .fastest_drive import FastestDrive
from .heading_distance import HeadingDistance
from .kinodynamic_prm import KinodynamicPrm
from .kinodynamic_rrt import KinodynamicRrt

EXERCISES = [
    HeadingDistance,
    BestControl,
    KinodynamicRrt,
    FastestDrive,
    KinodynamicPrm,
]

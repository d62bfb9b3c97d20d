"""The kinds of robots, as one type."""

from .arm import ArmRobot
from .car import CarRobot
from .polygon import RigidPolygonRobot, TranslatingPolygonRobot
from .round import RoundRobot

Robot = RoundRobot | TranslatingPolygonRobot | RigidPolygonRobot | CarRobot | ArmRobot

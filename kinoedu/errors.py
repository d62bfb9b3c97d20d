"""The errors that kinoedu raises for wrong input.

All derive from `KinoeduError`, which derives from `ValueError`. A message says what was expected,
what was given and what to do. The absence of a path is not an error but a result: `plan.path` is
None and `plan.reason` explains it.
"""


class KinoeduError(ValueError):
    """The base class of all errors of kinoedu."""


class InvalidPoint(KinoeduError):
    """A point, a set of points or a configuration cannot be used.

    Its shape is wrong, or a coordinate is not finite, or too large or too small for exact
    arithmetic.
    """


class InvalidSegment(KinoeduError):
    """The two points that should define a line coincide."""


class InvalidPolygon(KinoeduError):
    """A polygon cannot be used.

    It has too few vertices or no area, repeats a vertex, intersects itself, or is not convex where
    it must be.
    """


class InvalidWorld(KinoeduError):
    """A boundary, an obstacle or a bitmap does not define a world."""


class InvalidRobot(KinoeduError):
    """The dimensions of a robot are not possible."""


class InvalidStart(KinoeduError):
    """The start is outside the world or in contact with an obstacle."""


class InvalidGoal(KinoeduError):
    """The goal is outside the world or in contact with an obstacle."""


class InvalidParameter(KinoeduError):
    """A tuning argument (a step, a count, a bias, a seed) is outside its range."""


class InvalidGraph(KinoeduError):
    """A node or an edge does not exist, a weight is not allowed, or the value is not a graph."""


class UnreadableScene(KinoeduError):
    """A file is damaged, contradicts itself, or does not match its extension."""


class UnknownFormat(UnreadableScene):
    """No reader exists for the file's extension."""


class SceneTooLarge(UnreadableScene):
    """A file holds more cells than a planner can handle on this computer."""


class DuplicateKind(KinoeduError):
    """A generic function already has an implementation for these record types."""


class MendedPolygons(UserWarning):
    """A map's polygons were not simple and have been repaired.

    This is a warning: the world can be used. The message says which polygons, and what they became.
    """

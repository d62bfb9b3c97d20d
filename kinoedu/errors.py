"""Every failure that kinoedu names.

All derive from `KinoeduError`, and that from `ValueError`: the input was at fault, and the message
says what was expected, what came and what to do. That no path exists is not an error: it is an
answer (`plan.path is None`, with `plan.reason`).
"""


class KinoeduError(ValueError):
    """What every error named here has in common."""


class InvalidPoint(KinoeduError):
    """A point, a set of points or a configuration has the wrong shape, is not finite, or is too
    large or too small to be exact.
    """


class InvalidSegment(KinoeduError):
    """Two points that should span a line coincide."""


class InvalidPolygon(KinoeduError):
    """A ring of vertices is too short, has no area, repeats a vertex, meets itself, or is not
    convex where it must be.
    """


class InvalidWorld(KinoeduError):
    """A boundary, an obstacle or a bitmap cannot make a world."""


class InvalidRobot(KinoeduError):
    """A robot's size makes no sense."""


class InvalidStart(KinoeduError):
    """The start is outside the world or in contact with an obstacle."""


class InvalidGoal(KinoeduError):
    """The goal is outside the world or in contact with an obstacle."""


class InvalidParameter(KinoeduError):
    """A tuning argument (a step, a count, a bias, a seed) is outside its range."""


class InvalidGraph(KinoeduError):
    """A node, an edge or a place is not there, a weight is one that no search can use, or what was
    given is no graph.
    """


class UnreadableScene(KinoeduError):
    """A file is damaged, contradicts itself, or is not what its name says."""


class UnknownFormat(UnreadableScene):
    """No reader knows the file's extension."""


class SceneTooLarge(UnreadableScene):
    """A file holds more cells than a planner on this computer should be given."""


class DuplicateKind(KinoeduError):
    """A generic question already has an answer for these kinds of record."""


class MendedPolygons(UserWarning):
    """A map's polygons were not simple; the message says which, and what was made of them. It is a
    warning: the world is there.
    """

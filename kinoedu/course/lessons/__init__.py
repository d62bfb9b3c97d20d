"""Every exercise of the course, by the name of the function that students write.

Each package in this folder holds the exercises of one lesson: a file for each exercise, the
pictures of failing cases, and the messages that students read. `shared` is code that several
lessons use.
"""

from importlib import import_module
from pkgutil import iter_modules

from ...errors import InvalidParameter
from ...messages import get_message
from ..exercise import Exercise
from ..variants import make_variant

ROOMS = [room.name for room in iter_modules(__path__) if room.name != "shared"]


def all_exercises() -> dict[str, Exercise]:
    """All exercises by name, in the order of the lessons."""
    rooms = [import_module(f"{__name__}.{room}").EXERCISES for room in ROOMS]
    rooms.sort(key=lambda exercises: exercises[0].lesson)
    return {
        exercise.name: make_variant(exercise, "") for exercises in rooms for exercise in exercises
    }


EXERCISES = all_exercises()


def find(name: str, variant: str = "") -> Exercise:
    """Find an exercise by the name of the function that students write.

    Parameters
    ----------
    variant : the name of a variant of the exercise; by default its usual form.

    Returns
    -------
    Exercise

    Raises
    ------
    InvalidParameter
        Where no exercise has this name, or the exercise has no such variant.

    Examples
    --------
    >>> find("point_line_distance").lesson
    '01_geometry'
    """
    if name not in EXERCISES:
        raise InvalidParameter(get_message("check.unknown", name=name, names=", ".join(EXERCISES)))
    exercise = EXERCISES[name]
    if variant and variant not in exercise.variants:
        raise InvalidParameter(
            get_message(
                "check.no_variant",
                name=name,
                variant=variant,
                names=", ".join(exercise.variants) or "none",
            )
        )
    return make_variant(type(exercise), variant) if variant else exercise


__all__ = ["EXERCISES", "find"]

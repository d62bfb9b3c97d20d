"""Every exercise of the course, by the name of the function that it asks for.

A room of this folder holds a lesson's exercises: a file for each function that is asked for, the
pictures of what fails, and the messages that students read. `shared` is what several rooms use.
"""

import functools
from importlib import import_module
from pkgutil import iter_modules

from ...errors import InvalidParameter
from ...messages import get_message
from ..exercise import Exercise

ROOMS = [room.name for room in iter_modules(__path__) if room.name != "shared"]


def all_exercises() -> dict[str, Exercise]:
    """The exercises of all rooms by name, lesson after lesson."""
    rooms = [import_module(f"{__name__}.{room}").EXERCISES for room in ROOMS]
    rooms.sort(key=lambda exercises: exercises[0].lesson)
    return {exercise.name: exercise() for exercises in rooms for exercise in exercises}


EXERCISES = all_exercises()


def find(name: str, variant: str = "") -> Exercise:
    """The exercise that asks for a function of this name, with a contract of its own where a
    variant is named. Raises InvalidParameter.

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
    return varied(type(exercise), variant) if variant else exercise


@functools.cache
def varied(kind: type[Exercise], variant: str) -> Exercise:
    """An exercise with a contract, each once: what it computes is kept by what it is."""
    return kind(variant)


__all__ = ["EXERCISES", "find"]

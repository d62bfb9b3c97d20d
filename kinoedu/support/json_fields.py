"""JSON read with care: every value knows its name, so that what is wrong with it can be said."""

import difflib
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

from ..errors import KinoeduError, UnreadableScene
from .reading import read_text
from .text import shortened

Built = TypeVar("Built")


class Field(NamedTuple):
    """A value of the scene with its name, such as world.obstacles[2].radius, for the message where
    it is wrong.
    """

    name: str
    value: Any
    folder: Path

    def wrong(self, expected: str) -> UnreadableScene:
        """The error that names this field."""
        return UnreadableScene(f"{self.name} must be {expected}, got {shortened(self.value)}")

    def check_version(self, known: int) -> None:
        """Raise UnreadableScene for an object of another version than the one that is known."""
        if isinstance(self.value, dict) and self.value.get("version") not in (known, None):
            given = shortened(self.value["version"])
            raise UnreadableScene(
                f"{self.name}.version must be {known}, got {given}; this kinoedu knows no other"
            )

    def members(
        self, needed: tuple[str, ...], optional: tuple[str, ...] = ()
    ) -> dict[str, "Field"]:
        """The fields of an object, which has all that are needed and none that is not known."""
        if not isinstance(self.value, dict):
            raise self.wrong("an object {...}")
        for key in self.value:
            if key not in needed + optional:
                close = difflib.get_close_matches(key, needed + optional, 1)
                hint = (
                    f"did you mean {close[0]!r}?"
                    if close
                    else f"known are {', '.join(needed + optional)}"
                )
                raise UnreadableScene(f"{self.name} has an unknown key {key!r}; {hint}")
        for key in needed:
            if key not in self.value:
                raise UnreadableScene(f"{self.name} lacks {key!r}")
        return {
            key: self._replace(name=f"{self.name}.{key}", value=value)
            for key, value in self.value.items()
        }

    def items(self) -> list["Field"]:
        """The elements of a list."""
        if not isinstance(self.value, list):
            raise self.wrong("a list [...]")
        return [
            self._replace(name=f"{self.name}[{i}]", value=value)
            for i, value in enumerate(self.value)
        ]

    def text(self) -> str:
        """A string."""
        if not isinstance(self.value, str):
            raise self.wrong("a string")
        return self.value

    def number(self) -> float:
        """A number; true and false are none."""
        if isinstance(self.value, bool) or not isinstance(self.value, int | float):
            raise self.wrong("a number")
        try:
            return float(self.value)
        except OverflowError:
            raise self.wrong("a number of at most 300 digits") from None

    def numbers(self) -> list[float]:
        """A list of numbers."""
        return [item.number() for item in self.items()]

    def points(self) -> list[list[float]]:
        """A list of points [x, y]."""
        return [item.numbers() for item in self.items()]

    def kind(self, kinds: dict[str, Callable[["Field"], Any]]) -> Any:
        """What the reader for this object's "kind" makes of it."""
        name = self.value.get("kind") if isinstance(self.value, dict) else None
        if not isinstance(name, str) or name not in kinds:
            raise self.wrong(f'an object with a "kind" among {", ".join(kinds)}')
        return kinds[name](self)


def read_json(file: Path, name: str, build: Callable[[Field], Built]) -> Built:
    """What is built of the whole of a file. Its own errors, and UnreadableScene, name the file and
    the field at fault.
    """
    try:
        return build(Field(name, parsed(read_text(file)), file.parent))
    except KinoeduError as error:
        raise type(error)(
            f"{file}: {error}" if str(file) not in str(error) else str(error)
        ) from error


def parsed(text: str) -> Any:
    """JSON as Python values; NaN, repeated keys and what is no JSON are refused."""
    try:
        return json.loads(text, parse_constant=not_a_number, object_pairs_hook=without_repeats)
    except json.JSONDecodeError as error:
        raise UnreadableScene(
            f"no JSON: {error.msg} in line {error.lineno}, column {error.colno}"
        ) from error
    except RecursionError as error:
        raise UnreadableScene("lists are nested too deeply for a scene") from error
    except KinoeduError:
        raise
    except ValueError as error:
        raise UnreadableScene(f"no scene: {error}") from error


def not_a_number(constant: str) -> float:
    """NaN and Infinity are no JSON."""
    raise UnreadableScene(f"numbers must be finite, got {constant}")


def without_repeats(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """An object's members, each key once."""
    members = dict(pairs)
    if len(members) < len(pairs):
        keys = [key for key, _ in pairs]
        raise UnreadableScene(
            f"a key is there twice: {next(key for key in keys if keys.count(key) > 1)!r}"
        )
    return members

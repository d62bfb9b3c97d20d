"""Validated JSON: every value knows its name, so that an error message can name it."""

import difflib
import json
import math
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

from ..errors import KinoeduError, UnreadableScene
from .reading import naming, read_text
from .text import shortened

Json = Any  # what json.loads returns
JsonObject = dict[str, Json]
Built = TypeVar("Built")


class Field(NamedTuple):
    """A value of a file with its name, such as world.obstacles[2].radius, for error messages."""

    name: str
    value: Json
    folder: Path

    def wrong(self, expected: str) -> UnreadableScene:
        """An error that names this field and says what was expected."""
        return UnreadableScene(f"{self.name} must be {expected}, got {shortened(self.value)}")

    def check_version(self, version: int) -> None:
        """Check that an object has no other version than this one.

        Raises
        ------
        UnreadableScene
            Where it has another version.
        """
        if isinstance(self.value, dict) and self.value.get("version") not in (version, None):
            given = shortened(self.value["version"])
            raise UnreadableScene(
                f"{self.name}.version must be {version}, got {given}; this kinoedu knows no other"
            )

    def members(
        self, needed: tuple[str, ...], optional: tuple[str, ...] = ()
    ) -> dict[str, "Field"]:
        """The fields of an object, which must have all needed keys and no unknown ones.

        Raises
        ------
        UnreadableScene
            Where it is not an object, or a key is missing or unknown.
        """
        if not isinstance(self.value, dict):
            raise self.wrong("an object {...}")
        for key in self.value:
            if key not in needed + optional:
                close = difflib.get_close_matches(key, needed + optional, 1)
                choices = f"known are {', '.join(needed + optional)}"
                hint = f"did you mean {close[0]!r}?" if close else choices
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
        """A number; true and false are refused."""
        if isinstance(self.value, bool) or not isinstance(self.value, int | float):
            raise self.wrong("a number")
        try:
            number = float(self.value)
        except OverflowError:
            number = math.inf
        if not math.isfinite(number):  # Python reads 1e400 as infinite
            raise self.wrong("a number below 1e308")
        return number

    def numbers(self) -> list[float]:
        """A list of numbers."""
        return [item.number() for item in self.items()]

    def points(self) -> list[list[float]]:
        """A list of points [x, y]."""
        return [item.numbers() for item in self.items()]

    def kind(self, kinds: dict[str, Callable[["Field"], Any]]) -> Any:
        """The object built by the reader for this object's "kind".

        Parameters
        ----------
        kinds : the readers by kind.

        Raises
        ------
        UnreadableScene
            Where the object has no known kind.
        """
        name = self.value.get("kind") if isinstance(self.value, dict) else None
        if not isinstance(name, str) or name not in kinds:
            raise self.wrong(f'an object with a "kind" among {", ".join(kinds)}')
        return kinds[name](self)


def read_json(file: Path, name: str, build: Callable[[Field], Built]) -> Built:
    """Build an object from a JSON file.

    Parameters
    ----------
    file : the path.
    name : the name of the whole value in error messages.
    build : a function that builds the object from the whole value.

    Raises
    ------
    UnreadableScene
        Where the file is not JSON. This error and those of `build` name the file and the field.
    """
    with naming(file):
        return build(Field(name, parse_json(read_text(file)), file.parent))


def parse_json(text: str) -> Any:
    """JSON as Python values; NaN and repeated keys are refused."""
    try:
        return json.loads(
            text, parse_constant=refuse_constant, object_pairs_hook=members_without_repeats
        )
    except json.JSONDecodeError as error:
        place = f"line {error.lineno}, column {error.colno}"
        raise UnreadableScene(f"no JSON: {error.msg} in {place}") from error
    except RecursionError as error:
        raise UnreadableScene("lists are nested too deeply for a scene") from error
    except KinoeduError:
        raise
    except ValueError as error:
        raise UnreadableScene(f"no scene: {error}") from error


def refuse_constant(constant: str) -> float:
    """Refuse NaN and Infinity, which are not JSON."""
    raise UnreadableScene(f"numbers must be finite, got {constant}")


def members_without_repeats(pairs: list[tuple[str, Json]]) -> JsonObject:
    """The members of an object; a repeated key is refused."""
    members = dict(pairs)
    if len(members) < len(pairs):
        [(repeated, _)] = Counter(key for key, _ in pairs).most_common(1)
        raise UnreadableScene(f"a key is there twice: {repeated!r}")
    return members

"""The messages that students read, in one catalogue: the files of the folder `en` beside this file,
and `messages.toml` in each room of the lessons.

A translation is a folder beside `en`, such as `de`. `KINOEDU_LANGUAGE=de` looks there first, and in
English for what is missing.
"""

import os
import tomllib
from functools import cache
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
LESSONS = HERE.parent / "course" / "lessons"


def say(key: str, /, **values: Any) -> str:
    """The words under a dotted key, with `{name}` filled in. Raises KeyError where no catalogue has
    them.

    >>> say("picture.should_be", value=4)
    'should be 4'
    """
    return words_for(key, os.environ.get("KINOEDU_LANGUAGE", "en")).format(**values)


@cache
def words_for(key: str, language: str) -> str:
    """The words under a dotted key, before anything is filled in; English ones where a language has
    none. Raises KeyError.
    """
    for name in (language, "en"):
        words = found(catalogue(name), key)
        if words is not None:
            return words
    raise KeyError(f"no words for {key!r} in {HERE / 'en'} and {LESSONS}")


def has_words(key: str) -> bool:
    """Whether the English catalogue has words under a key."""
    return found(catalogue("en"), key) is not None


@cache
def catalogue(language: str) -> dict[str, Any]:
    """A language's words; none where there is no folder for it."""
    files = sorted((HERE / language).glob("*.toml")) if language.isalpha() else []
    if language == "en":
        files += sorted(LESSONS.glob("*/*.toml"))
    return {
        name: table
        for file in files
        for name, table in tomllib.loads(file.read_text(encoding="utf-8")).items()
    }


def found(words: dict[str, Any], key: str) -> str | None:
    """The words under a dotted key, or None."""
    here: Any = words
    for part in key.split("."):
        here = here.get(part) if isinstance(here, dict) else None
    return here if isinstance(here, str) else None

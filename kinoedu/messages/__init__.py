"""The messages that students read, in one catalogue.

They are in the files of the folder `en` beside this file, and in `messages.toml` of each lesson's
package. A translation is a folder beside `en`, such as `de`. `KINOEDU_LANGUAGE=de` looks there
first, and in English for missing messages.
"""

import os
import tomllib
from functools import cache
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
LESSONS = HERE.parent / "course" / "lessons"


def get_message(key: str, /, **values: Any) -> str:
    """The message under a dotted key, with `{name}` filled in.

    Raises
    ------
    KeyError
        Where no catalogue has a message under the key.

    Examples
    --------
    >>> get_message("picture.should_be", value=4)
    'should be 4'
    """
    return get_template(key, chosen_language()).format(**values)


def chosen_language() -> str:
    """The language of this process's messages."""
    return os.environ.get("KINOEDU_LANGUAGE", "en")


@cache
def get_template(key: str, language: str) -> str:
    """The message under a dotted key, before values are filled in.

    A message that the language lacks is taken from English.

    Raises
    ------
    KeyError
        Where English lacks it too.
    """
    for name in (language, "en"):
        text = look_up(catalogue(name), key)
        if text is not None:
            return text
    raise KeyError(f"no message for {key!r} in {HERE / 'en'} and {LESSONS}")


def has_message(key: str) -> bool:
    """Whether the English catalogue has a message under a key."""
    return look_up(catalogue("en"), key) is not None


@cache
def catalogue(language: str) -> dict[str, Any]:
    """The messages of a language; empty where it has no folder."""
    files = sorted((HERE / language).glob("*.toml")) if language.isalpha() else []
    if language == "en":
        files += sorted(LESSONS.glob("*/*.toml"))
    return {
        name: table
        for file in files
        for name, table in tomllib.loads(file.read_text(encoding="utf-8")).items()
    }


def look_up(messages: dict[str, Any], key: str) -> str | None:
    """The message under a dotted key, or None."""
    here: Any = messages
    for part in key.split("."):
        here = here.get(part) if isinstance(here, dict) else None
    return here if isinstance(here, str) else None

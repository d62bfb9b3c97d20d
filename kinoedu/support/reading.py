"""Files read with care: what is no regular file, no text or too long is refused by name."""

import os
from pathlib import Path
from stat import S_ISDIR, S_ISREG

from ..errors import SceneTooLarge, UnreadableScene
from .text import shortened

# the longest text of a terrain of 5,000 x 5,000 cells: one a row, with Windows line ends
MAX_BYTES = 75_001_000


def as_path(path: str | os.PathLike[str]) -> Path:
    """The path of a file. Raises UnreadableScene for what is none."""
    try:
        return Path(path)
    except TypeError:
        raise UnreadableScene(f"expected the path of a file, got {shortened(path)}") from None


def regular_file(path: str | os.PathLike[str]) -> Path:
    """`path` again, once it is known to lead to a regular file.

    Raises
    ------
    UnreadableScene
        Nothing is there, the links run in a circle, or it is a folder, a pipe (opening it would
        wait for ever) or a device (reading it might never end).
    """
    path = as_path(path)
    try:
        mode = path.stat().st_mode
    except (OSError, ValueError) as error:  # ValueError: a NUL in the name
        why = getattr(error, "strerror", None) or error
        raise UnreadableScene(
            f"{str(path)!r}: expected a file, got: {why}; check the path"
        ) from error
    if not S_ISREG(mode):
        what = "a folder" if S_ISDIR(mode) else "a pipe or a device"
        raise UnreadableScene(f"{path}: expected a file, got {what}; give the path of a file")
    return path


def read_text(path: str | os.PathLike[str], most: int = MAX_BYTES) -> str:
    """The text of a UTF-8 or ASCII file of at most `most` bytes, every line end turned into a
    newline.

    Raises
    ------
    UnreadableScene, SceneTooLarge
        The file is missing or is not text; it is longer than `most`.
    """
    path = regular_file(path)
    try:
        with path.open("rb") as stream:
            data = stream.read(
                most + 1
            )  # not the size in the folder's list, which may be stale or 0
        text = data.decode("utf-8-sig")  # some editors begin a file with a byte-order mark
    except (OSError, UnicodeDecodeError) as error:
        raise UnreadableScene(
            f"{path}: expected plain text, got: {error}; save it as UTF-8"
        ) from error
    if len(data) > most:
        raise SceneTooLarge(
            f"{path}: expected at most {most:,} bytes, got more; is it the right file?"
        )
    if "\0" in text:
        raise UnreadableScene(f"{path}: expected plain text, got a NUL byte; save it as UTF-8")
    return text.replace("\r\n", "\n").replace("\r", "\n")

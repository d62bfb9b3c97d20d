"""Safe reading of files: only regular files of text up to a maximal size."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from stat import S_ISDIR, S_ISREG

from ..errors import KinoeduError, SceneTooLarge, UnreadableScene
from .text import shortened

# The longest file of a terrain of 5,000 x 5,000 cells: one cell per line, Windows line ends.
MAX_BYTES = 75_001_000


@contextmanager
def naming(file: object) -> Iterator[None]:
    """Let errors of this package name the file that the block reads."""
    try:
        yield
    except KinoeduError as error:
        if str(file) in str(error):
            raise
        raise type(error)(f"{file}: {error}") from error


def as_path(path: str | os.PathLike[str]) -> Path:
    """The path of a file.

    Raises
    ------
    UnreadableScene
        Where the value is not a path.
    """
    try:
        return Path(path)
    except TypeError:
        raise UnreadableScene(f"expected the path of a file, got {shortened(path)}") from None


def regular_file(path: str | os.PathLike[str]) -> Path:
    """The path of an existing regular file.

    Raises
    ------
    UnreadableScene
        Where nothing is there, or the links form a cycle, or it is a folder, a pipe (opening it
        could block for ever) or a device (reading it might never end).
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


def read_bytes(path: str | os.PathLike[str], most: int) -> bytes:
    """The bytes of a file, of a longer one the first `most` and one more.

    Raises
    ------
    UnreadableScene
        Where the file is missing or must not be read.
    """
    path = regular_file(path)
    try:
        with path.open("rb") as stream:
            # the size that the system reports may be stale or 0
            return stream.read(most + 1)
    except OSError as error:
        why = error.strerror or error
        raise UnreadableScene(f"{path}: it cannot be read: {why}; check its permissions") from error


def read_text(path: str | os.PathLike[str], most: int = MAX_BYTES) -> str:
    """The text of a UTF-8 or ASCII file of at most `most` bytes, with every line end as a newline.

    Raises
    ------
    UnreadableScene
        Where the file is missing or not text.
    SceneTooLarge
        Where it is longer than `most` bytes.
    """
    data = read_bytes(path, most)
    if len(data) > most:
        raise SceneTooLarge(
            f"{path}: expected at most {most:,} bytes, got more; is it the right file?"
        )
    try:
        text = data.decode("utf-8-sig")  # some editors write a byte-order mark first
    except UnicodeDecodeError as error:
        raise UnreadableScene(
            f"{path}: expected plain text, got: {error}; save it as UTF-8"
        ) from error
    if "\0" in text:
        raise UnreadableScene(f"{path}: expected plain text, got a NUL byte; save it as UTF-8")
    return text.replace("\r\n", "\n").replace("\r", "\n")

"""Atomic writing: a file is written completely or not at all."""

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def written_whole(path: str | os.PathLike[str], mode: int = 0o644) -> Iterator[Path]:
    """A temporary file beside `path`, which replaces `path` when the block ends.

    It is removed where the block fails.

    Parameters
    ----------
    mode : the permissions of the file.

    Raises
    ------
    OSError
        Where the file cannot be made or written; it names `path`.
    """
    file = Path(path)
    try:  # a name may be as long as the system allows
        handle, name = tempfile.mkstemp(dir=file.parent, prefix=file.stem[:50], suffix=".part")
    except OSError as error:
        raise type(error)(error.errno, error.strerror, str(file)) from None
    os.close(handle)
    part = Path(name)
    try:
        yield part
        part.chmod(mode)
        os.replace(part, file)
    except OSError as error:
        if error.errno is None or error.filename not in (None, name, part):
            raise  # about another file
        raise type(error)(error.errno, error.strerror, str(file)) from None  # such as a full disk
    finally:
        part.unlink(missing_ok=True)

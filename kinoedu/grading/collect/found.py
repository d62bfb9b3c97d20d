"""The files that were handed in: of a folder, of zips in it, and of a zip. A zip is read in memory,
no further than it may be long, and nothing of it is ever unpacked to the disk.
"""

import io
import zipfile
import zlib
from collections.abc import Iterator
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from .notebook import MOST_BYTES, UnreadableSubmission, read_bytes

METADATA = "submission_metadata.yml"  # what Gradescope says of its folders
MOST_MEMBERS = 10_000
MOST_UNPACKED = 2 * 2**30  # bytes of all notebooks of a class, and here of one student
MOST_OF_ONE, MOST_UNPACKED_OF_ONE = 100, 4 * MOST_BYTES
PACKED = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)  # others take what memory the file says
UNREADABLE = (
    zipfile.BadZipFile,
    zlib.error,
    OSError,
    ValueError,
    NotImplementedError,
    RuntimeError,
    EOFError,
)


class Found(NamedTuple):
    """A file, its place as names from the top down, and its bytes or the trouble with it."""

    place: tuple[str, ...]
    data: bytes
    trouble: str = ""


def files_in(folder: Path) -> Iterator[Found]:
    """Every file in a folder, also those in its zips; in a stable order. What is no plain file has
    that trouble.
    """
    if folder.is_file():
        yield from unpacked(Found((folder.name,), read_bytes(folder)), top=True)
        return
    for file in sorted(folder.rglob("*")):
        place = file.relative_to(folder).parts
        if any(part.startswith(".") or part == "__MACOSX" for part in place) or (
            file.is_dir() and not file.is_symlink()
        ):
            continue
        try:
            data = read_bytes(file) if is_read(file.name) else b""
        except UnreadableSubmission as trouble:
            yield Found(place, b"", str(trouble))
        else:
            yield from unpacked(Found(place, data))


def is_read(name: str) -> bool:
    """Whether a file is opened at all: what else lies beside a notebook takes no memory and is no
    trouble, whatever it is.
    """
    return name.lower().endswith((".ipynb", ".zip")) or name == METADATA


def unpacked(file: Found, *, top: bool = False) -> Iterator[Found]:
    """A file, or what is in it where it is a zip; a zip in a zip only where the first is a whole
    class.
    """
    if not file.place[-1].lower().endswith(".zip"):
        yield file
        return
    above = () if top else file.place
    try:
        with zipfile.ZipFile(io.BytesIO(file.data)) as archive:
            for member in members_of(archive, top=top):
                place = (*above, *PurePosixPath(member.filename.replace("\\", "/")).parts)
                inner = member_of(archive, member, place)
                yield from unpacked(inner) if top and not inner.trouble else [inner]
    except (*UNREADABLE, UnreadableSubmission) as error:
        yield Found(file.place, b"", f"the zip cannot be read: {error}")


def members_of(archive: zipfile.ZipFile, *, top: bool) -> list[zipfile.ZipInfo]:
    """The files of a class's zip, or the notebooks of a student's. Raises UnreadableSubmission."""
    most, most_bytes = (MOST_MEMBERS, MOST_UNPACKED) if top else (MOST_OF_ONE, MOST_UNPACKED_OF_ONE)
    members = [
        one
        for one in archive.infolist()
        if not one.is_dir() and (top or one.filename.lower().endswith(".ipynb"))
    ]
    if (
        len(members) > most
        or sum(one.file_size for one in members if is_read(one.filename)) > most_bytes
    ):
        raise UnreadableSubmission("the zip holds too much")
    if not (members or top):
        raise UnreadableSubmission(
            "it holds no notebook, unless that is in another zip; hand in the notebook itself"
        )
    return members


def member_of(archive: zipfile.ZipFile, member: zipfile.ZipInfo, place: tuple[str, ...]) -> Found:
    """One file of a zip, read no further than it may be long."""
    if any(part.startswith(".") or part == "__MACOSX" for part in place):
        return Found((*place[:-1], ".skipped"), b"")
    if not is_read(place[-1]):
        return Found(place, b"")
    if member.compress_type not in PACKED:
        return Found(place, b"", "it was packed in an unusual way; pack it with an ordinary zip")
    with archive.open(member) as stream:
        data = stream.read(MOST_BYTES + 1)
    return (
        Found(place, data)
        if len(data) <= MOST_BYTES
        else Found(place, b"", "the file is too large")
    )

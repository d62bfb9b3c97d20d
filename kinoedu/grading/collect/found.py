"""The files that were handed in: in a folder, in a zip, and in zips inside either.

Zips are read in memory, up to fixed limits, and are never unpacked to the disk.
"""

import io
import zipfile
import zlib
from collections.abc import Iterator
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from .notebook import MOST_BYTES, UnreadableSubmission, read_bytes

METADATA = "submission_metadata.yml"  # where Gradescope lists the owners of its folders
HIDDEN = ".hidden"  # in the place of the name of what is not read
MOST_MEMBERS = 10_000
MOST_UNPACKED = 2 * 2**30  # bytes of a class's zip, and of all notebooks in it
MOST_OF_ONE, MOST_UNPACKED_OF_ONE = 100, 4 * MOST_BYTES  # the same for a student's zip
PACKED = (
    zipfile.ZIP_STORED,
    zipfile.ZIP_DEFLATED,
)  # other methods allocate as much memory as the file demands
UTF_8 = 0x800  # the flag of a zip's member whose name is in UTF-8
UNREADABLE = (
    zipfile.BadZipFile,
    zlib.error,
    OSError,
    ValueError,
    NotImplementedError,
    RuntimeError,
    EOFError,
    IndexError,  # of a member without a name, in some versions of Python
)


class Found(NamedTuple):
    """A file that was handed in.

    place : the names of its folders and its own, from the top down.
    data : its bytes, empty where there is trouble.
    trouble : why it could not be read, or "".
    """

    place: tuple[str, ...]
    data: bytes
    trouble: str = ""


def read_files(folder: Path) -> Iterator[Found]:
    """Yield every file in a folder or zip, and in zips inside it, in a stable order.

    A file that is not a plain file comes with that trouble, and an empty folder as if it held
    something hidden.

    Raises
    ------
    UnreadableSubmission
        Where `folder` is a file that cannot be read.
    """
    if folder.is_file():
        yield from unpack(Found((folder.name,), read_bytes(folder, MOST_UNPACKED)), top=True)
        return
    for file in sorted(folder.rglob("*")):
        place = file.relative_to(folder).parts
        if file.is_dir() and not file.is_symlink():
            if not any(file.iterdir()):
                yield Found(cut_at_hidden((*place, HIDDEN)), b"")
            continue
        if (shown := cut_at_hidden(place)) != place:
            yield Found(shown, b"")
            continue
        try:
            data = read_bytes(file) if is_read(file.name) else b""
        except UnreadableSubmission as trouble:
            yield Found(place, b"", str(trouble))
        else:
            yield from unpack(Found(place, data))


def cut_at_hidden(place: tuple[str, ...]) -> tuple[str, ...]:
    """The place down to the first name that systems hide, which becomes HIDDEN; or all of it.

    >>> cut_at_hidden(("ann", ".git", "x.ipynb")), cut_at_hidden(("ann", "x.ipynb"))
    (('ann', '.hidden'), ('ann', 'x.ipynb'))
    """
    for at, part in enumerate(place):
        if part.startswith(".") or part == "__MACOSX":
            return (*place[:at], HIDDEN)
    return place


def is_read(name: str) -> bool:
    """Whether a file is opened at all.

    Other files beside a notebook take no memory and cause no trouble.
    """
    return name.lower().endswith((".ipynb", ".zip")) or name == METADATA


def unpack(file: Found, *, top: bool = False) -> Iterator[Found]:
    """Yield the file, or the files inside it if it is a zip.

    A zip inside a zip is opened only where the outer one holds a whole class (`top`).
    """
    if not file.place[-1].lower().endswith(".zip"):
        yield file
        return
    above = () if top else file.place
    try:
        with zipfile.ZipFile(io.BytesIO(file.data)) as archive:
            for member in list_members(archive, top=top):
                name = read_member_name(member)
                within = PurePosixPath(name.replace("\\", "/").lstrip("/")).parts
                if not within:  # such as "." and a name that begins with a NUL
                    continue
                place = (*above, *within)
                inner = read_member(archive, member, place)
                yield from unpack(inner) if top and not inner.trouble else [inner]
    except (*UNREADABLE, UnreadableSubmission) as error:
        yield Found(file.place, b"", f"the zip cannot be read: {error}")


def list_members(archive: zipfile.ZipFile, *, top: bool) -> list[zipfile.ZipInfo]:
    """The files in a class's zip (`top`), or the notebooks in a student's.

    Raises UnreadableSubmission where there are too many, or no notebook.
    """
    most, most_bytes = (MOST_MEMBERS, MOST_UNPACKED) if top else (MOST_OF_ONE, MOST_UNPACKED_OF_ONE)
    members = [
        one
        for one in archive.infolist()
        if not one.filename.endswith("/") and (top or one.filename.lower().endswith(".ipynb"))
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


def read_member_name(member: zipfile.ZipInfo) -> str:
    """The name of a file in a zip.

    macOS writes it in UTF-8 without saying so; Python then takes it for the letters of an old PC.
    """
    if member.flag_bits & UTF_8:
        return member.filename
    try:
        return member.filename.encode("cp437").decode("utf-8")
    except UnicodeError:
        return member.filename


def read_member(archive: zipfile.ZipFile, member: zipfile.ZipInfo, place: tuple[str, ...]) -> Found:
    """One file of a zip, read up to the limit on its size."""
    if (shown := cut_at_hidden(place)) != place:
        return Found(shown, b"")
    if not is_read(place[-1]):
        return Found(place, b"")
    if member.compress_type not in PACKED:
        return Found(place, b"", "it was packed in an unusual way; pack it with an ordinary zip")
    try:
        with archive.open(member) as stream:
            data = stream.read(MOST_BYTES + 1)
    except UNREADABLE as error:  # such as a damaged member; the others may be whole
        return Found(place, b"", f"it cannot be read in its zip: {error}")
    return (
        Found(place, data)
        if len(data) <= MOST_BYTES
        else Found(place, b"", "the file is too large")
    )

"""The folder of machine code on the disk, and the requests for more.

The folder is private to its user, because its files are pickles. Its name is a digest of everything
that machine code depends on: the package's sources (not their location), the versions of Python and
numba, and the processor. So another copy of the same sources uses the same folder, and machine code
is never stale.

    <digest>/
      <module>.<function>.<kinds>.code       machine code
      <module>.<function>.<kinds>.refused    why numba could not compile it: it stays interpreted
      awaited/<module>.<function>.<kinds>    a request to the process that compiles: someone waits
      wanted/<module>.<function>.<kinds>     the same, where nobody waits
"""

import functools
import hashlib
import os
import pickle
import platform
import re
import shutil
import sys
import tempfile
import time
from collections.abc import Collection
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import IO, Any, NamedTuple

from ..support.whole_files import written_whole
from .kinds import Kind, record_classes, spell_kind

PACKAGE = Path(__file__).resolve().parent.parent
NAME = __name__.partition(".")[0]

# The packages on top of all others. Machine code of their functions is not stored.
UPPER_ROOMS = (
    "bench",
    "boards",
    "cli",
    "contracts",
    "course",
    "experiments",
    "figures",
    "files",
    "grading",
    "slides",
)
AWAITED, WANTED = "awaited", "wanted"  # the queues of requests; those of the second give way
VERSION = re.compile(r"[0-9a-f]{16}(-[0-9a-f]{8})?")  # the name of a folder of machine code
STALE = 30 * 24 * 3600.0  # seconds after which the machine code of other versions is removed
SKEW = 60.0  # seconds by which a disk's clock may be ahead of this computer's
IMPORTED = time.time()  # sources changed later than this do not run in this process


class Request(NamedTuple):
    """A request to compile a function, by module and name, for kinds of arguments.

    attempts : how many processes ended while they compiled it.
    """

    module: str
    function: str
    kinds: tuple[Kind, ...]
    attempts: int = 0

    @property
    def name(self) -> str:
        """The name of its files."""
        digest = hashlib.sha256(", ".join(map(spell_kind, self.kinds)).encode()).hexdigest()
        return f"{self.module}.{self.function}.{digest[:16]}"


@functools.cache
def folder() -> Path | None:
    """The writable folder of machine code for the sources that run here, or None if there is none.

    KINOEDU_CACHE names another place than the user's cache folder. KINOEDU_WARMED names a folder
    that was prepared for all users; a new folder starts as a copy of it.
    """
    try:
        if changed_since(IMPORTED):
            return None
        place = user_cache() / f"{source_digest(PACKAGE, UPPER_ROOMS)}-{machine_digest()}"
        if not place.exists():
            make_folder(place)
            remove_stale(place)
        tempfile.TemporaryFile(dir=place).close()
    except (OSError, RuntimeError):  # RuntimeError: the user has no home
        return None
    return place


def user_cache() -> Path:
    """The folder of all versions."""
    if "KINOEDU_CACHE" in os.environ:
        return Path(os.environ["KINOEDU_CACHE"])
    import platformdirs

    return Path(platformdirs.user_cache_dir(NAME, appauthor=False))


def sources(package: Path, without: Collection[str] = ()) -> list[Path]:
    """The source files of a package, without those of some subpackages."""
    found = package.rglob("*.py")
    return sorted(file for file in found if file.relative_to(package).parts[0] not in without)


def source_digest(package: Path, without: Collection[str] = ()) -> str:
    """A digest of a package's sources, independent of its location."""
    digest = hashlib.sha256()
    for file in sources(package, without):
        digest.update(file.relative_to(package).as_posix().encode() + b"\0" + file.read_bytes())
    return digest.hexdigest()[:16]


def changed_since(when: float) -> bool:
    """Whether a source file was changed later, so that it differs from what this process runs.

    A date in the future, as of files that were unpacked in another time zone, tells of no change.
    """
    latest = time.time() + SKEW
    return any(when < file.stat().st_mtime < latest for file in sources(PACKAGE, UPPER_ROOMS))


def machine_digest() -> str:
    """A digest of the versions of Python and numba, and of the processor."""
    versions = [sys.implementation.cache_tag or "", sys.platform]
    for package in ("numba", "llvmlite", "numpy"):
        try:
            versions.append(version(package))
        except PackageNotFoundError:
            versions.append("")
    return hashlib.sha256("\n".join([*versions, processor()]).encode()).hexdigest()[:8]


def processor() -> str:
    """A text that identifies the kind of processor."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").partition("\n\n")[0].splitlines()
        lines = [line for line in lines if line.startswith(("model", "flags", "Features", "CPU "))]
        return "\n".join(line for line in lines if not line.startswith("CPU MHz"))
    except OSError:
        return f"{platform.machine()} {platform.processor()}"


def make_folder(place: Path) -> None:
    """Make the folder, with the machine code that was prepared for all users.

    It appears complete or not at all, because several processes may make it at once.
    """
    place.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    fresh = Path(tempfile.mkdtemp(dir=place.parent))
    warmed = Path(os.environ.get("KINOEDU_WARMED") or os.devnull) / place.name
    try:
        shutil.copytree(warmed, fresh, dirs_exist_ok=True)
    except OSError:  # nothing is prepared, or this user cannot read it
        shutil.rmtree(fresh)
        fresh.mkdir()
    fresh.chmod(0o700)
    for queue in (AWAITED, WANTED):
        (fresh / queue).mkdir(exist_ok=True)
    try:
        fresh.rename(place)
    except OSError:  # another process was faster
        shutil.rmtree(fresh, ignore_errors=True)


def remove_stale(place: Path) -> None:
    """Remove the folders of other versions in which nothing was compiled for a month."""
    for other in place.parent.iterdir():
        is_version = VERSION.fullmatch(other.name) and (other / WANTED).is_dir()
        if is_version and other != place and time.time() - other.stat().st_mtime > STALE:
            shutil.rmtree(other, ignore_errors=True)


def is_digested(thing: Any) -> bool:
    """Whether a function or a class is defined in the sources that the folder's name depends on."""
    package, room = [*thing.__module__.split("."), ""][:2]
    return package == NAME and room not in UPPER_ROOMS and "<locals>" not in thing.__qualname__


def are_digested(kinds: tuple[Kind, ...]) -> bool:
    """Whether kinds consist of numbers, arrays and records of those sources."""
    return all(map(is_digested, set[type]().union(*map(record_classes, kinds))))


def write_request(queue: Path, request: Request) -> None:
    """Write a request for machine code into the folder of a queue."""
    with written_whole(queue / request.name) as part:
        part.write_bytes(pickle.dumps(request))


def slot_file(place: Path, queue: str, slot: int | str) -> Path:
    """The file that the worker of a queue's slot keeps locked."""
    return place / f"slot-{queue}-{slot}"


def try_lock(lock: IO[bytes]) -> bool:
    """Try to lock a file until this process ends; returns whether it succeeded."""
    try:
        if os.name == "nt":
            import msvcrt

            msvcrt.locking(lock.fileno(), msvcrt.LK_NBLCK, 1)  # type: ignore[attr-defined]
        else:
            import fcntl

            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except (BlockingIOError, PermissionError):
        return False
    except OSError:
        pass  # some network disks have no locks; then two workers may compile the same
    return True


def pending_requests(queue: Path) -> list[Path]:
    """The files of a queue's requests, the oldest first."""
    found = []
    for file in queue.iterdir():
        if not file.name.endswith(".part"):
            try:
                found.append((file.stat().st_mtime_ns, file))
            except OSError:  # a worker has just taken it
                continue
    return [file for _, file in sorted(found)]

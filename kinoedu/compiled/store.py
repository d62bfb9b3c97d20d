"""Where machine code lies on the disk, and which is wanted there.

The folder is private to its user: entries are pickles. Its name is a digest of what machine code is
made of: the package's sources (not where they lie), the versions of Python and numba, and the
processor. So a second copy of the same sources finds what is there, and no code is ever stale.

    <digest>/
      <module>.<function>.<kinds>.code       machine code
      <module>.<function>.<kinds>.refused    why numba could not compile it: it stays interpreted
      wanted/<module>.<function>.<kinds>     for the process that compiles
"""

import functools
import hashlib
import os
import pickle
import platform
import shutil
import sys
import tempfile
import time
from collections.abc import Collection
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import IO, Any, NamedTuple

from ..support.whole_files import written_whole
from .kinds import Kind, classes_in, spelled

PACKAGE = Path(__file__).resolve().parent.parent
NAME = __name__.partition(".")[0]

# Nothing below these rooms calls them: none of what they compile is kept.
UPPER_ROOMS = ("bench", "boards", "cli", "course", "experiments", "figures", "files", "grading")
STALE = 30 * 24 * 3600.0  # seconds after which the code of other versions is cleared away
IMPORTED = time.time()  # sources that were changed later are not those that run here


class Wanted(NamedTuple):
    """What is to be compiled: a function by its module and name, the kinds of its arguments; and
    how often it was begun in vain."""

    module: str
    function: str
    kinds: tuple[Kind, ...]
    attempts: int = 0

    @property
    def name(self) -> str:
        """The name of its files."""
        digest = hashlib.sha256(", ".join(map(spelled, self.kinds)).encode()).hexdigest()
        return f"{self.module}.{self.function}.{digest[:16]}"


@functools.cache
def folder() -> Path | None:
    """The writable folder for machine code of the sources that run here; None where there is none.

    KINOEDU_CACHE names another place than the user's cache folder; KINOEDU_WARMED one that somebody
    has warmed for all users, who begin with a copy of it.
    """
    try:
        if changed_since(IMPORTED):
            return None
        place = user_cache() / f"{source_digest(PACKAGE, UPPER_ROOMS)}-{machine_digest()}"
        if not place.exists():
            make_folder(place)
            clear_stale(place)
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
    """A package's source files, those of some rooms left out."""
    found = package.rglob("*.py")
    return sorted(file for file in found if file.relative_to(package).parts[0] not in without)


def source_digest(package: Path, without: Collection[str] = ()) -> str:
    """What tells one version of a package from another, wherever it lies."""
    digest = hashlib.sha256()
    for file in sources(package, without):
        digest.update(file.relative_to(package).as_posix().encode() + b"\0" + file.read_bytes())
    return digest.hexdigest()[:16]


def changed_since(when: float) -> bool:
    """Whether a source was written later: then this process runs others than those on the disk."""
    return any(file.stat().st_mtime > when for file in sources(PACKAGE, UPPER_ROOMS))


def machine_digest() -> str:
    """What machine code depends on beside its sources: Python, numba and the processor."""
    versions = [sys.implementation.cache_tag or "", sys.platform]
    for package in ("numba", "llvmlite", "numpy"):
        try:
            versions.append(version(package))
        except PackageNotFoundError:
            versions.append("")
    return hashlib.sha256("\n".join([*versions, processor()]).encode()).hexdigest()[:8]


def processor() -> str:
    """What tells one kind of processor from another."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").partition("\n\n")[0].splitlines()
        told = [line for line in lines if line.startswith(("model", "flags", "Features", "CPU "))]
        return "\n".join(line for line in told if not line.startswith("CPU MHz"))
    except OSError:
        return f"{platform.machine()} {platform.processor()}"


def make_folder(place: Path) -> None:
    """Make the folder, with what is warmed for all users in it; whole or not at all, as several
    processes may begin at once."""
    place.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    fresh = Path(tempfile.mkdtemp(dir=place.parent))
    warmed = Path(os.environ.get("KINOEDU_WARMED") or os.devnull) / place.name
    try:
        shutil.copytree(warmed, fresh, dirs_exist_ok=True)
    except OSError:  # nothing is warmed, or not for this user to read
        shutil.rmtree(fresh)
        fresh.mkdir()
    fresh.chmod(0o700)
    (fresh / "wanted").mkdir(exist_ok=True)
    try:
        fresh.rename(place)
    except OSError:  # another process was faster
        shutil.rmtree(fresh, ignore_errors=True)


def clear_stale(place: Path) -> None:
    """Remove the folders of other versions in which nothing was compiled for a month."""
    for other in place.parent.iterdir():
        is_version = len(other.name) in (16, 25) and other != place
        if is_version and time.time() - other.stat().st_mtime > STALE:
            shutil.rmtree(other, ignore_errors=True)


def is_digested(thing: Any) -> bool:
    """Whether a function or a class is among the sources that the folder is named by."""
    package, room = [*thing.__module__.split("."), ""][:2]
    return package == NAME and room not in UPPER_ROOMS and "<locals>" not in thing.__qualname__


def are_digested(kinds: tuple[Kind, ...]) -> bool:
    """Whether kinds are made of numbers, arrays and records of those sources."""
    return all(map(is_digested, set[type]().union(*map(classes_in, kinds))))


def want(place: Path, wanted: Wanted) -> None:
    """Write down that machine code is wanted."""
    with written_whole(place / "wanted" / wanted.name) as part:
        part.write_bytes(pickle.dumps(wanted))


def lock_taken(lock: IO[bytes]) -> bool:
    """Take the lock on a file; whether nobody had it. The system frees it when this process
    ends.
    """
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
        pass  # some network disks know no locks: then two may compile the same
    return True


def all_wanted(place: Path) -> list[Path]:
    """What is wanted, the oldest first."""
    found = []
    for file in (place / "wanted").iterdir():
        if not file.name.endswith(".part"):
            try:
                found.append((file.stat().st_mtime_ns, file))
            except OSError:  # it was just taken
                continue
    return [file for _, file in sorted(found)]

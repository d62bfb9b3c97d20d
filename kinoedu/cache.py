"""Where machine code is kept: a folder private to its user, named by a digest of the sources that it is made of."""

import hashlib
import os
import shutil
import tempfile
import time
from collections.abc import Collection
from pathlib import Path
from typing import Any

# Nothing below these rooms calls them: none of what they compile is kept.
UPPER_ROOMS = ("bench", "boards", "cli", "course", "experiments", "figures", "grading")
STALE = 30 * 24 * 3600.0  # seconds after which the code of other versions is cleared away


def cache_folder(package: Path) -> Path | None:
    """The writable folder for the code compiled from a package's sources, or None where there is none.

    KINOEDU_CACHE names another place than the user's cache folder; KINOEDU_WARMED one that somebody has warmed for all users, who
    begin with a copy of it.
    """
    try:
        folder = user_cache() / source_digest(package, without=UPPER_ROOMS)
        if not folder.exists():
            make_folder(folder)
            clear_stale(folder)
        tempfile.TemporaryFile(dir=folder).close()
    except (OSError, RuntimeError):  # RuntimeError: the user has no home
        return None
    return folder


def make_folder(folder: Path) -> None:
    """Make the folder, with what is warmed for all users in it; whole or not at all, as several processes may begin at once."""
    folder.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    fresh = Path(tempfile.mkdtemp(dir=folder.parent))
    warmed = Path(os.environ.get("KINOEDU_WARMED") or os.devnull) / folder.name
    try:
        shutil.copytree(warmed, fresh, dirs_exist_ok=True)
    except OSError:  # nothing is warmed, or not for this user to read
        shutil.rmtree(fresh)
        fresh.mkdir()
    fresh.chmod(0o700)
    try:
        fresh.rename(folder)
    except OSError:  # another process was faster
        shutil.rmtree(fresh, ignore_errors=True)


def source_digest(package: Path, without: Collection[str] = ()) -> str:
    """What tells one version of a package from another: a digest of its sources, those of some rooms left out."""
    digest = hashlib.sha256()
    for source in sorted(package.rglob("*.py")):
        if source.relative_to(package).parts[0] not in without:
            digest.update(source.read_bytes())
    return digest.hexdigest()[:16]


def is_digested(source: Any) -> bool:
    """Whether a function or a class is among the sources that the cache's folder is named by."""
    package, room = [*source.__module__.split("."), ""][:2]
    return package == __name__.partition(".")[0] and room not in UPPER_ROOMS


def is_ours(kind: Any) -> bool:
    """Whether a numba type is made of nothing but numbers, arrays and records that are digested."""
    record_class = getattr(kind, "instance_class", None)
    return (record_class is None or is_digested(record_class)) and all(map(is_ours, getattr(kind, "types", ())))


def user_cache() -> Path:
    """The folder of all versions."""
    if "KINOEDU_CACHE" in os.environ:
        return Path(os.environ["KINOEDU_CACHE"])
    import platformdirs

    return Path(platformdirs.user_cache_dir("kinoedu", appauthor=False))


def clear_stale(folder: Path) -> None:
    """Remove the folders of other versions in which nothing was compiled for a month."""
    for other in folder.parent.iterdir():
        if len(other.name) == 16 and other != folder and time.time() - other.stat().st_mtime > STALE:
            shutil.rmtree(other, ignore_errors=True)

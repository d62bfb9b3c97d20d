"""Where machine code is kept: a folder private to its user, named by a digest of the package's sources."""

import hashlib
import os
import shutil
import tempfile
import time
from pathlib import Path

STALE = 30 * 24 * 3600.0  # seconds after which the code of other versions is cleared away


def cache_folder(package: Path) -> Path | None:
    """The writable folder for the code compiled from a package's sources, or None where there is none.

    KINOEDU_CACHE names another place than the user's cache folder.
    """
    try:
        folder = user_cache() / source_digest(package)
        if not folder.exists():
            folder.mkdir(mode=0o700, parents=True, exist_ok=True)
            clear_stale(folder)
        tempfile.TemporaryFile(dir=folder).close()
    except (OSError, RuntimeError):  # RuntimeError: the user has no home
        return None
    return folder


def source_digest(package: Path) -> str:
    """What tells one version of a package from another: a digest of its sources."""
    digest = hashlib.sha256()
    for source in sorted(package.rglob("*.py")):
        digest.update(source.read_bytes())
    return digest.hexdigest()[:16]


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

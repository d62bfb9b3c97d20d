"""What measured times depend on: versions, processor and load."""

import os
import platform
from importlib.metadata import PackageNotFoundError, version

COMPARED = (
    "numpy",
    "numba",
    "scipy",
    "shapely",
    "triangle",
    "ompl",
    "pathplanning",
    "roboticstoolbox-python",
    "rsplan",
)


def surroundings() -> str:
    """One line with the versions of Python and the timed packages, the processor and its load."""
    versions = [f"{name} {found}" for name in COMPARED if (found := installed(name))]
    return (
        f"Python {platform.python_version()}, {', '.join(versions)}, {platform.machine()}, "
        f"{os.cpu_count()} cores, {load()}"
    )


def load() -> str:
    """Load average of the last minute, where the system reports it."""
    return f"load {os.getloadavg()[0]:.1f}" if hasattr(os, "getloadavg") else "load unknown"


def installed(name: str) -> str | None:
    """Version of an installed package, or None.

    >>> installed("numpy") is None, installed("no such package") is None
    (False, True)
    """
    try:
        return version(name)
    except PackageNotFoundError:
        return None

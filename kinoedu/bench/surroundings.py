"""What times depend on: versions, processor, load."""

import os
import platform
from importlib.metadata import PackageNotFoundError, version

WITH = (
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
    """Python, the packages that are timed, the processor and how busy it is, in a line."""
    versions = [f"{name} {found}" for name in WITH if (found := installed(name))]
    return (
        f"Python {platform.python_version()}, {', '.join(versions)}, {platform.machine()}, "
        f"{os.cpu_count()} cores, {load()}"
    )


def load() -> str:
    """How many processes wanted the processor in the last minute, where the system tells."""
    return f"load {os.getloadavg()[0]:.1f}" if hasattr(os, "getloadavg") else "load unknown"


def installed(name: str) -> str | None:
    """A package's version, or None.

    >>> installed("numpy") is None, installed("no such package") is None
    (False, True)
    """
    try:
        return version(name)
    except PackageNotFoundError:
        return None

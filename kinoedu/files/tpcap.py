"""Parking cases in CSV, of the Trajectory Planning Competition for Automated Parking (TPCAP).

    x0, y0, theta0, x1, y1, theta1, n, m_1, ..., m_n, x, y, x, y, ...

The numbers stand in one column or one row: the start and the goal of the middle of the rear axle,
the number n of obstacles, how many corners each has, and their corners one after another. All cases
have the same car and no boundary. B. Li et al., "Online competition of trajectory planning for
automated parking: benchmarks, achievements, learned lessons, and future perspectives" (2023);
https://tpcap.github.io/benchmarks.
"""

import math
import os
import re

import numpy as np

from ..errors import UnreadableScene
from ..geometry.checks import Array
from ..problems import Problem, ProblemRecord
from ..robots import Car
from ..support.reading import as_path, naming, read_text
from ..support.text import shortened
from ..worlds import PolygonWorld
from .mending import mend_polygons
from .outlines import rectangle

LENGTH, WIDTH, WHEELBASE = 4.689, 1.942, 2.8  # metres
REAR_OVERHANG, MAX_STEERING = 0.929, 0.75
MARGIN = 8.0  # metres of free ground round everything
WORD = re.compile(r"[-+.0-9eE]+")  # Python's float would read 1_0, and digits of other scripts
HEAD = 7  # numbers before those of corners


def read_tpcap(path: str | os.PathLike[str]) -> ProblemRecord:
    """Read a parking case of TPCAP, with the car of the competition.

    The world is a rectangle of free ground, 8 metres beyond all corners, the start and the goal.
    Repeated corners are dropped; the warning MendedPolygons says where.

    Returns
    -------
    ProblemRecord

    Raises
    ------
    UnreadableScene
        Where the file is missing or damaged; the message names the number.
    InvalidPolygon, InvalidStart, InvalidGoal
        Where an obstacle has no area, or the start or the goal is not free.

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     case = Path(folder) / "case.csv"
    ...     _ = case.write_text("0,0,0, 9,0,0, 1, 3, 4,1, 5,1, 5,2")
    ...     problem = read_tpcap(case)
    >>> problem.goal, problem.world.lo
    (array([9., 0., 0.]), array([-8., -8.]))
    """
    file = str(as_path(path))
    numbers = read_numbers(file)
    start, goal, counts = numbers[:3], numbers[3:6], read_counts(file, numbers)
    corners = numbers[HEAD + len(counts) :].reshape(-1, 2)
    drawn = np.split(corners, np.cumsum(counts)[:-1]) if counts else []
    places = np.vstack([corners, start[:2], goal[:2]])
    boundary = rectangle(places.min(axis=0) - MARGIN, places.max(axis=0) + MARGIN)
    car = Car(LENGTH, WIDTH, WHEELBASE, rear_overhang=REAR_OVERHANG, max_steering=MAX_STEERING)
    with naming(file):
        return Problem(car, PolygonWorld(boundary, mend_polygons(drawn, file)), start, goal)


def read_numbers(file: str) -> Array:
    """All numbers of a file, at least `HEAD`."""
    text = read_text(file).strip().removesuffix(",")
    fields = text.split(",") if text else []
    words = [word for field in fields for word in field.split() or [""]]
    numbers = np.array([read_number(file, i, word) for i, word in enumerate(words, start=1)])
    if len(numbers) < HEAD:
        raise UnreadableScene(
            f"{file}: expected start, goal and the number of obstacles, {HEAD} numbers, got "
            f"{len(numbers)}"
        )
    return numbers


def read_number(file: str, i: int, word: str) -> float:
    """The finite number that a word says."""
    try:
        number = float(word) if WORD.fullmatch(word) else math.nan
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise UnreadableScene(f"{file}: number {i} must be finite, got {shortened(word)}")
    return number


def read_counts(file: str, numbers: Array) -> list[int]:
    """How many corners each obstacle has; together they are all that follow."""
    obstacles = read_count(file, HEAD, numbers[HEAD - 1], least=0)
    given = numbers[HEAD : HEAD + obstacles]
    counts = [read_count(file, i, value, least=3) for i, value in enumerate(given, HEAD + 1)]
    size = HEAD + obstacles + 2 * sum(counts)
    if size != len(numbers):
        raise UnreadableScene(
            f"{file}: expected {size:,} numbers for {obstacles:,} obstacles of {sum(counts):,} "
            f"corners, got {len(numbers):,}"
        )
    return counts


def read_count(file: str, i: int, value: float, least: int) -> int:
    """A count, at least `least`."""
    if not value.is_integer() or not least <= value < 2**53:
        raise UnreadableScene(
            f"{file}: number {i} must be a whole number of {least} or more, got {value:g}"
        )
    return int(value)

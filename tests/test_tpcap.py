"""The twenty cases of TPCAP: they are read as they are published, and a car parks in each."""

import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely

import kinoedu as ke
from kinoedu.errors import MendedPolygons, UnreadableScene
from kinoedu.files import read_tpcap

CASES = Path(__file__).parent / "data" / "parking" / "tpcap"
GOOD = "0,0,0, 20,0,0, 1, 3, 4,1, 5,1, 5,2".replace(" ", "").split(",")


def published(number: int) -> tuple[np.ndarray, list[np.ndarray]]:
    """The two poses (2, 3) and the rings of a case, read by numpy alone."""
    numbers = np.loadtxt(CASES / f"Case{number}.csv", delimiter=",")
    n = int(numbers[6])
    ends = np.cumsum(numbers[7 : 7 + n].astype(int))[:-1]
    return numbers[:6].reshape(2, 3), np.split(numbers[7 + n :].reshape(-1, 2), ends)


def read(number: int) -> ke.problems.ProblemRecord:
    """The problem of a case; that corners are repeated is known."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", MendedPolygons)
        return read_tpcap(CASES / f"Case{number}.csv")


def swept(drive: Any, outline: np.ndarray) -> Any:
    """The body of the car at 3,000 poses of a drive, as shapely's polygons."""
    poses = drive.at(np.linspace(0.0, drive.duration, 3000))
    cos, sin, (x, y) = np.cos(poses[:, 2:]), np.sin(poses[:, 2:]), outline.T
    places = [poses[:, :1] + cos * x - sin * y, poses[:, 1:2] + sin * x + cos * y]
    return shapely.polygons(np.stack(places, axis=-1))


@pytest.mark.parametrize("number", range(1, 21))
def test_a_car_parks_in_every_case(number: int) -> None:
    """Without a parameter for the place, be it tight (7, 20), far from the origin (13 to 15) or
    drawn with repeated corners (19). Shapely sees no contact with what is published.
    """
    problem, (ends, rings) = read(number), published(number)
    plan = ke.hybrid_astar(problem, max_nodes=6000)  # less than by default: only 7 is cut short
    assert plan.path is not None, plan.reason
    drive, rounding = plan.trajectory, 1e-15 * np.abs(ends[:, :2]).max() + 1e-9
    assert np.array_equal(drive.poses[0, :2], ends[0, :2])
    for pose, end in zip(drive.poses[[0, -1]], ends):
        assert np.abs(pose - end)[:2].max() < rounding and abs(np.sin((pose - end)[2] / 2)) < 1e-9
    solid = shapely.union_all([shapely.Polygon(ring) for ring in rings])
    assert not shapely.intersects(swept(drive, problem.robot.outline), solid).any()


def test_the_car_is_that_of_the_competition() -> None:
    """Front overhang, wheelbase, rear overhang, width and steering angle in metres and radians."""
    car = read(1).robot
    assert np.allclose(car.outline.max(axis=0), (2.8 + 0.96, 0.971), rtol=0, atol=1e-12)
    assert np.allclose(car.outline.min(axis=0), (-0.929, -0.971), rtol=0, atol=1e-12)
    assert (car.wheelbase, car.max_steering, car.both_ways) == (2.8, 0.75, True)


@pytest.mark.parametrize("number", [1, 15, 19])
def test_obstacles_are_those_of_the_file(number: int) -> None:
    """Start, goal and the solid, within a rectangle 8 m beyond everything."""
    problem, (ends, rings) = read(number), published(number)
    assert np.array_equal(problem.start[:2], ends[0, :2])
    assert np.array_equal(problem.goal[:2], ends[1, :2])
    places = np.vstack([*rings, ends[:, :2]])
    assert np.array_equal(problem.world.lo, places.min(axis=0) - 8.0)
    assert np.array_equal(problem.world.hi, places.max(axis=0) + 8.0)
    solid = shapely.union_all([shapely.Polygon(ring) for ring in rings])
    samples = np.random.default_rng(0).uniform(problem.world.lo, problem.world.hi, (2000, 2))
    point = ke.Problem(ke.Point(), problem.world, ends[0, :2], ends[1, :2])
    free = [point.is_free(q) for q in samples]
    assert np.array_equal(free, ~shapely.intersects_xy(solid, samples)) and 0 < sum(free) < 2000


def test_repeated_corners_are_dropped_with_a_warning() -> None:
    """Case 19 repeats the first of four until there are eleven."""
    with pytest.warns(MendedPolygons, match=r"Case19\.csv.*polygon 0 repeats 7 of its corners"):
        read_tpcap(CASES / "Case19.csv")


def test_numbers_stand_in_a_row_or_in_a_column(tmp_path: Path) -> None:
    """The site says a column; the files have a row. `read_problem` reads both."""
    for name, between in (("row.csv", ","), ("column.CSV", "\n")):
        (tmp_path / name).write_text(between.join(GOOD))
        problem = ke.read_problem(tmp_path / name)
        assert problem.goal.tolist() == [20, 0, 0] and problem.robot.wheelbase == 2.8
    with pytest.raises(ke.errors.InvalidParameter, match="has its own robot"):
        ke.read_problem(tmp_path / "row.csv", start=(0, 0, 0), goal=(1, 0, 0))


@pytest.mark.parametrize(
    ("place", "wrong", "says"),
    [
        (0, "here", "number 1 must be finite, got 'here'"),
        (3, "1_0", "number 4 must be finite, got '1_0'"),
        (3, "\u0665", "number 4 must be finite"),
        (3, "", "number 4 must be finite, got ''"),
        (3, "nan", "number 4 must be finite"),
        (6, "1.5", "number 7 must be a whole number of 0 or more, got 1.5"),
        (6, "-1", "number 7 must be a whole number of 0 or more"),
        (6, "1e300", "expected|must be a whole number"),
        (7, "2", "number 8 must be a whole number of 3 or more, got 2"),
        (7, "4", "expected 16 numbers for 1 obstacles of 4 corners, got 14"),
        (6, "0", "expected 7 numbers"),
    ],
)
def test_a_damaged_file_is_refused_by_the_number_that_is_wrong(
    place: int, wrong: str, says: str, tmp_path: Path
) -> None:
    """Counts that contradict the file, and what is no number."""
    file = tmp_path / "case.csv"
    file.write_text(",".join([*GOOD[:place], wrong, *GOOD[place + 1 :]]))
    with pytest.raises(UnreadableScene, match=says):
        read_tpcap(file)


def test_what_is_too_short_or_missing_is_refused(tmp_path: Path) -> None:
    """An empty file, no file, and what is no path."""
    (tmp_path / "empty.csv").write_text("")
    for path in (tmp_path / "empty.csv", tmp_path / "gone.csv", None):
        with pytest.raises(UnreadableScene):
            read_tpcap(path)  # type: ignore[arg-type]  # on purpose


def test_open_ground_has_no_obstacle(tmp_path: Path) -> None:
    """A case without obstacles is a case."""
    (tmp_path / "open.csv").write_text("0,0,0,9,0,1,0")
    assert ke.hybrid_astar(read_tpcap(tmp_path / "open.csv")).path is not None

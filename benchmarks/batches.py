"""Many questions at once, beside shapely: points in polygons, segments against polygons, pairs of
convex polygons.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import shapely
from timing import Contestant, Goal, available, measure, report, run
from trapezoids import stars
from worlds import SIDE, SQUARE, among_polygons

import kinoedu as ke
from kinoedu.collision import free_configurations, free_motions
from kinoedu.geometry import ConvexPolygons, convex_pairs_intersect
from kinoedu.worlds.polygon_world import rings_of

SECONDS = 120
POINTS, PAIRS, LENGTH = 100_000, 20_000, 10.0
PREPARED, TREE, BUILT = "shapely, prepared", "shapely, STRtree", "shapely"


class Among(NamedTuple):
    """A world and its polygons; points, ends of motions from them; and all that shapely may
    prepare.
    """

    world: Any
    polygons: list[np.ndarray]
    a: np.ndarray
    b: np.ndarray
    union: Any
    tree: Any
    points: np.ndarray
    lines: np.ndarray


class Pairs(NamedTuple):
    """Pairs of convex polygons: as arrays, as kinoedu's and as shapely's."""

    P: np.ndarray
    Q: np.ndarray
    checked: tuple[Any, Any]
    polygons: tuple[np.ndarray, np.ndarray]


def among(polygons: list[np.ndarray], seed: int) -> Among:
    """Points all over the square, and motions from each of them up to LENGTH along x and along
    y.
    """
    rng = np.random.default_rng(seed)
    a = rng.uniform(0, SIDE, (POINTS, 2))
    b = np.clip(a + rng.uniform(-LENGTH, LENGTH, a.shape), 1e-3, SIDE - 1e-3)
    theirs = [shapely.Polygon(polygon) for polygon in polygons]
    union = shapely.union_all(theirs)
    shapely.prepare(union)
    lines = shapely.linestrings(np.stack([a, b], axis=1))
    world = ke.PolygonWorld(SQUARE, polygons)
    return Among(world, polygons, a, b, union, shapely.STRtree(theirs), shapely.points(a), lines)


def standard(seed: int) -> Among:
    """The 24 polygons that RRT is timed among."""
    return among([rings[0] for rings in rings_of(among_polygons(seed).problem.world)[1:]], seed)


def many(seed: int) -> Among:
    """The 200 polygons that trapezoids are timed among."""
    return among(stars(200, seed)[0], seed)


def pairs(span: float, seed: int) -> Pairs:
    """Polygons of six and of five corners on circles of radius 0.5 to 1.5 with centres in a square
    of side `span`.
    """
    rng = np.random.default_rng(seed)
    P, Q = (on_circles(corners, span, rng) for corners in (6, 5))
    theirs = shapely.polygons(P), shapely.polygons(Q)
    shapely.prepare(theirs[0])
    return Pairs(P, Q, (ConvexPolygons(P), ConvexPolygons(Q)), theirs)


def on_circles(corners: int, span: float, rng: np.random.Generator) -> np.ndarray:
    """PAIRS convex polygons, shape (PAIRS, corners, 2)."""
    angles = 2 * np.pi * (np.arange(corners) + rng.uniform(0.1, 0.9, (PAIRS, corners))) / corners
    centres, radii = rng.uniform(0, span, (PAIRS, 1, 2)), rng.uniform(0.5, 1.5, (PAIRS, 1, 1))
    return centres + radii * np.stack([np.cos(angles), np.sin(angles)], axis=2)


def met(tree: Any, shapes: np.ndarray) -> np.ndarray:
    """Whether each shape meets one that is in the tree."""
    answers = np.zeros(len(shapes), bool)
    answers[tree.query(shapes, predicate="intersects")[0]] = True
    return answers


def from_polygons(case: Among) -> np.ndarray:
    """shapely's answers for points, from the polygons on."""
    union = shapely.union_all([shapely.Polygon(polygon) for polygon in case.polygons])
    shapely.prepare(union)
    return shapely.intersects_xy(union, case.a[:, 0], case.a[:, 1])


def from_arrays(case: Pairs) -> np.ndarray:
    """shapely's answers for pairs, from the arrays on."""
    return shapely.intersects(shapely.polygons(case.P), shapely.polygons(case.Q))


def judge(case: Any, answers: dict[str, np.ndarray]) -> None:
    """All give the very same answers."""
    for name, answer in answers.items():
        assert np.array_equal(answer, answers["kinoedu"]), (
            f"{name} disagrees in {(answer != answers['kinoedu']).sum()} answers"
        )


def ask(question: Callable[[Any], np.ndarray]) -> Callable[[], Contestant]:
    """A maker of the contestant that answers the question."""
    return lambda: lambda case: lambda: question(case)


def points() -> dict[str, Callable[[Any], np.ndarray]]:
    """Which points lie in a polygon; none lies on the rim of the square."""
    return {
        "kinoedu": lambda case: ~free_configurations(ke.Point(), case.world, case.a),
        PREPARED: lambda case: shapely.intersects_xy(case.union, case.a[:, 0], case.a[:, 1]),
        TREE: lambda case: met(case.tree, case.points),
    }


def points_from_polygons() -> dict[str, Callable[[Any], np.ndarray]]:
    """The same, the world or the prepared union made within the time."""

    def ours(case: Any) -> np.ndarray:
        return ~free_configurations(ke.Point(), ke.PolygonWorld(SQUARE, case.polygons), case.a)

    return {"kinoedu": ours, BUILT: from_polygons}


def first_points() -> dict[str, Callable[[Any], np.ndarray]]:
    """A world or a prepared union is made anew, as when an obstacle is dragged, and one point is
    judged.
    """

    def ours(case: Any) -> np.ndarray:
        world = ke.PolygonWorld(SQUARE, case.polygons)
        return ~free_configurations(ke.Point(), world, case.a[:1])

    return {"kinoedu": ours, BUILT: lambda case: from_polygons(case._replace(a=case.a[:1]))}


def segments() -> dict[str, Callable[[Any], np.ndarray]]:
    """Which segments meet a polygon."""
    return {
        "kinoedu": lambda case: ~free_motions(ke.Point(), case.world, case.a, case.b),
        PREPARED: lambda case: shapely.intersects(case.union, case.lines),
        TREE: lambda case: met(case.tree, case.lines),
    }


def convex_pairs() -> dict[str, Callable[[Any], np.ndarray]]:
    """Which pairs meet: kinoedu's polygons are checked, shapely's made and prepared before."""
    return {
        "kinoedu": lambda case: convex_pairs_intersect(*case.checked),
        PREPARED: lambda case: shapely.intersects(*case.polygons),
    }


def pairs_from_arrays() -> dict[str, Callable[[Any], np.ndarray]]:
    """The same, the polygons checked or made within the time."""
    return {"kinoedu": lambda case: convex_pairs_intersect(case.P, case.Q), BUILT: from_arrays}


def main(repeats: int = 11) -> None:
    """Three seeds each; the answers of all are compared after every turn."""
    for name, make in (("24 convex polygons", standard), ("200 polygons", many)):
        cases = list(map(make, range(3)))
        for title, questions, times in (
            (f"{POINTS:,} points among {name}", points(), 10),
            (
                f"{POINTS:,} points among {name}, which are given as arrays",
                points_from_polygons(),
                None,
            ),
            (f"one point among {name}, which are given as arrays", first_points(), None),
            (f"{POINTS:,} segments against {name}", segments(), 6),
        ):
            compare(title, questions, cases, times, repeats)
    for name, span in (("that are near", 2.0), ("of which most are far apart", 20.0)):
        title, cases = (
            f"{PAIRS:,} pairs of convex polygons {name}",
            [pairs(span, seed) for seed in range(3)],
        )
        compare(title, convex_pairs(), cases, 14, repeats)
        compare(f"{title}, which are given as arrays", pairs_from_arrays(), cases, 14, repeats)


def compare(
    title: str, questions: dict[str, Any], cases: list[Any], times: float | None, repeats: int
) -> None:
    """One table."""
    contestants = available({name: ask(question) for name, question in questions.items()})
    peers = [name for name in questions if name != "kinoedu"]
    report(
        title,
        measure(contestants, cases, judge, repeats=repeats),
        {name: Goal(at_least=times) for name in peers},
    )


if __name__ == "__main__":
    run(main)

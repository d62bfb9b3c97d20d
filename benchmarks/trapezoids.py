"""Trapezoids of 200 star-shaped polygons, beside a triangulation in C; and how their time grows
with the number of vertices.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from timing import Contestant, Goal, available, measure, report, run, turn
from worlds import SIDE, SQUARE

import kinoedu as ke
from kinoedu.decomposition.sweep import new_sweep
from kinoedu.decomposition.trapezoidation import drain
from kinoedu.worlds.polygon_world import edges_of

SECONDS = 30
GOALS = {"triangle": Goal(at_most=1.0)}


class Stars(NamedTuple):
    """A world, the polygons in it, and a point in each."""

    world: Any
    polygons: list[np.ndarray]
    centres: np.ndarray


def stars(count: int, seed: int) -> tuple[list[np.ndarray], np.ndarray]:
    """Polygons of 4 to 8 corners, one in each cell of a grid, no two touching; and a point in
    each.
    """
    rng = np.random.default_rng(seed)
    columns = int(np.ceil(np.sqrt(count)))
    side = SIDE / columns
    centres = (
        np.column_stack([np.arange(count) % columns, np.arange(count) // columns]) + 0.5
    ) * side
    return [star(centre, 0.45 * side, rng) for centre in centres], centres


def star(centre: np.ndarray, radius: float, rng: np.random.Generator) -> np.ndarray:
    """A polygon that is seen whole from its centre, no larger than a circle."""
    k = int(rng.integers(4, 9))
    angles = 2 * np.pi * (np.arange(k) + rng.uniform(0.1, 0.9, k)) / k
    return centre + radius * rng.uniform(0.3, 1.0, (k, 1)) * np.column_stack(
        [np.cos(angles), np.sin(angles)]
    )


def kinoedu() -> Contestant:
    """The public function, from the world to cells, neighbours and walls."""
    return lambda case: lambda: ke.trapezoidation(case.world)


def triangle() -> Contestant:
    """J. R. Shewchuk's Triangle, in C: the constrained Delaunay triangulation with neighbours and
    without new points.
    """
    from triangle import triangulate

    def contestant(case: Stars) -> Callable[[], Any]:
        rings = [np.array(SQUARE, float), *case.polygons]
        first = np.cumsum([0, *map(len, rings)])
        segments = [
            np.column_stack([np.arange(len(r)), np.roll(np.arange(len(r)), -1)]) + i
            for r, i in zip(rings, first)
        ]
        triangle_input = {
            "vertices": np.concatenate(rings),
            "segments": np.concatenate(segments),
            "holes": case.centres,
        }
        return lambda: triangulate(triangle_input, "pn")

    return contestant


def judge(case: Stars, answers: dict[str, Any]) -> None:
    """Both cover the same area."""
    area = answers["kinoedu"].areas.sum()
    if "triangle" in answers:
        a, b, c = answers["triangle"]["vertices"][answers["triangle"]["triangles"]].transpose(
            1, 2, 0
        )
        doubled = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        assert abs(doubled.sum() / 2 - area) <= 1e-9 * area


def growth() -> None:
    """Print the time of a sweep, sorting included, for more and more vertices, beside n log n."""
    print(
        "\n### A sweep, from the edges to the cells\n\n| vertices | ms | exponent | of n log n "
        "|\n|---:|---:|---:|---:|"
    )
    before = (0, 0.0)
    for count in (17, 167, 1667, 16667):
        rings = [np.array(SQUARE, float)[::-1], *stars(count, 0)[0]]
        edges = np.concatenate([edges_of(ring, solid) for solid, ring in enumerate(rings)])
        drain(new_sweep(edges))
        n, took = (
            len(edges),
            min(turn(lambda case: lambda: drain(new_sweep(case)), edges)[0] for _ in range(5)),
        )
        exponents = ["", ""]
        if before[0]:
            slope = np.log(n / before[0])
            exponents = [
                f"{np.log(took / before[1]) / slope:.2f}",
                f"{1 + np.log(np.log(n) / np.log(before[0])) / slope:.2f}",
            ]
        print(f"| {n:,} | {1e3 * took:.3g} | {' | '.join(exponents)} |")
        before = (n, took)


def main(repeats: int = 11) -> None:
    """Three worlds, each cut up in eleven times."""
    cases = []
    for seed in range(3):
        polygons, centres = stars(200, seed)
        cases.append(Stars(ke.PolygonWorld(SQUARE, polygons), polygons, centres))
    contestants = available({"kinoedu": kinoedu, "triangle": triangle})
    seconds = measure(contestants, cases, judge, repeats=repeats)
    report(f"cells of 200 polygons, about {len(cases[0].world.edges):,} vertices", seconds, GOALS)
    growth()


if __name__ == "__main__":
    run(main)

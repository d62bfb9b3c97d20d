"""A two-link arm's configuration space, 360 x 360: which link is in contact, over a lattice of
angles; beside shapely.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from timing import Contestant, Goal, available, measure, report, run

import kinoedu as ke
from kinoedu.collision import paint_configuration_space

SECONDS = 40
GOALS = {"shapely": Goal(at_least=100)}
N, L1, L2, WIDTH = 360, 1.5, 1.2, 0.2


class Case(NamedTuple):
    """Triangles and discs round the arm's base."""

    triangles: list[np.ndarray]
    discs: list[tuple[tuple[float, float], float]]


def case(seed: int) -> Case:
    """Five triangles and three discs within reach, none on the base."""
    rng = np.random.default_rng(seed)
    turns, far = rng.uniform(0, 2 * np.pi, 8), rng.uniform(1.2, 2.6, 8)
    centres = far[:, None] * np.stack([np.cos(turns), np.sin(turns)], axis=1)
    corners = np.array([0, 2, 4]) * np.pi / 3
    triangle = np.stack([np.cos(corners), np.sin(corners)], axis=1)
    return Case(
        [c + rng.uniform(0.2, 0.5) * triangle for c in centres[:5]],
        [((x, y), 0.25) for x, y in centres[5:].tolist()],
    )


def kinoedu() -> Contestant:
    """The painter; the world is made before."""

    def contestant(case: Case) -> Callable[[], Any]:
        world = ke.PolygonWorld([(-9, -9), (9, -9), (9, 9), (-9, 9)], case.triangles + case.discs)
        arm = ke.TwoLinkArm(L1, L2, WIDTH)
        return lambda: paint_configuration_space(arm, world, N)

    return contestant


def shapely() -> Contestant:
    """Lines for all links at once, and the distance of each from every prepared obstacle; link 2
    only where link 1 is free.
    """
    import shapely as sh

    def contestant(case: Case) -> Callable[[], Any]:
        solids = [(sh.Polygon(t), WIDTH / 2) for t in case.triangles] + [
            (sh.Point(c), r + WIDTH / 2) for c, r in case.discs
        ]
        for solid, _ in solids:
            sh.prepare(solid)

        def hits(links: Any) -> Any:
            return np.any([sh.dwithin(links, solid, reach) for solid, reach in solids], axis=0)

        def run() -> Any:
            angles = -np.pi + (np.arange(N) + 0.5) * 2 * np.pi / N
            elbows = L1 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
            image = np.zeros((N, N), np.int8)
            first = hits(sh.linestrings(np.stack([np.zeros_like(elbows), elbows], axis=1)))
            image[:, first] = 1
            heading = angles[None, ~first] + angles[:, None]
            tips = elbows[~first] + L2 * np.stack([np.cos(heading), np.sin(heading)], axis=2)
            links = sh.linestrings(
                np.stack([np.broadcast_to(elbows[~first], tips.shape), tips], axis=2)
            )
            image[:, ~first] = 2 * hits(links)
            return image

        return run

    return contestant


def judge(case: Case, answers: dict[str, Any]) -> None:
    """The very same picture."""
    if "shapely" in answers:
        assert (answers["kinoedu"] == answers["shapely"]).all()


def main(repeats: int = 3) -> None:
    """Five worlds."""
    seconds = measure(
        available({"kinoedu": kinoedu, "shapely": shapely}),
        [case(seed) for seed in range(5)],
        judge,
        repeats=repeats,
    )
    report(f"two-link configuration space, {N} x {N}", seconds, GOALS)


if __name__ == "__main__":
    run(main)

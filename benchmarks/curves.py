"""Dubins' and Reeds and Shepp's curves between 10,000 pairs of poses: how long they are, and who is
right where lengths differ.
"""

import cmath
import math
from collections import defaultdict
from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

import numpy as np
from timing import Contestant, available, measure, report, run

import kinoedu as ke
from kinoedu.curves.space import CurveSpace
from kinoedu.spaces import distance

SECONDS = 60
PAIRS, BATCH, RADIUS = 10_000, 500, 2.5
COMPILED = "kinoedu, in compiled code"
SAME = 1e-9  # of the radius: lengths that differ by less are the same
Pieces = Iterable[tuple[float, float]]  # curvature and signed length of each


class Answer(NamedTuple):
    """How long the curve of each pair is, (n,), and what it consists of; nothing where a library
    only tells lengths.
    """

    lengths: np.ndarray
    pieces: list[Pieces] | None


def pairs_of(seed: int) -> np.ndarray:
    """Pairs of poses, shape (n, 2, 3): near ones, far ones, and every fifth on a grid, headings
    too, where words tie.
    """
    rng = np.random.default_rng(seed)
    pairs = rng.uniform(-1.0, 1.0, (BATCH, 2, 3)) * [1.0, 1.0, math.pi]
    pairs[..., :2] *= rng.choice([0.5, 2.0, 8.0], (BATCH, 1, 1)) * RADIUS
    on_grid = rng.integers(-4, 5, (BATCH // 5, 2, 3)) * [RADIUS, RADIUS, math.pi / 4.0]
    pairs[::5] = on_grid
    return pairs


def kinoedu(curve: Callable[..., ke.curves.Curve]) -> Contestant:
    """The public function, a pair at a time."""

    def contestant(pairs: np.ndarray) -> Callable[[], Answer]:
        def run() -> Answer:
            found = [curve(a, b, RADIUS) for a, b in pairs]
            pieces = [list(zip(one.turns / one.radius, one.lengths)) for one in found]
            return Answer(np.array([one.length for one in found]), pieces)

        return run

    return contestant


def in_compiled_code(both_ways: bool) -> Contestant:
    """The distance that planners ask for, in compiled code."""
    from compiling import njit

    space = CurveSpace(np.full(3, -100.0), np.full(3, 100.0), RADIUS, both_ways)

    @njit
    def lengths(pairs):  # type: ignore[no-untyped-def]
        found = np.empty(len(pairs))
        for i in range(len(pairs)):
            found[i] = distance(space, pairs[i, 0], pairs[i, 1])
        return found

    return lambda pairs: lambda: Answer(lengths(pairs), None)


def rsplan() -> Contestant:
    """Its path without a runway, and the shortest one: by default it prefers fewer pieces to two
    metres.
    """
    from rsplan import path

    signs = {"left": 1.0 / RADIUS, "right": -1.0 / RADIUS, "straight": 0.0}

    def contestant(pairs: np.ndarray) -> Callable[[], Answer]:
        ends = [(tuple(a), tuple(b)) for a, b in pairs.tolist()]

        def run() -> Answer:
            found = [path(a, b, RADIUS, 0.0, 1.0, length_tolerance=0.0) for a, b in ends]
            pieces = [
                [(signs[part.type], part.direction * abs(part.length)) for part in one.segments]
                for one in found
            ]
            return Answer(np.array([one.total_length for one in found]), pieces)

        return run

    return contestant


def ompl(kind: str) -> Contestant:
    """The distance of its state space."""
    from ompl import base

    space = getattr(base, kind)(RADIUS)

    def contestant(pairs: np.ndarray) -> Callable[[], Answer]:
        states = [(as_state(space, a), as_state(space, b)) for a, b in pairs]
        return lambda: Answer(np.array([space.distance(a, b) for a, b in states]), None)

    return contestant


def as_state(space: Any, q: np.ndarray) -> Any:
    """A pose as OMPL's state."""
    state = space.allocState()
    state.setXY(q[0], q[1])
    state.setYaw(q[2])
    return state


def off_goal(pair: np.ndarray, pieces: Pieces) -> float:
    """How far from the second pose pieces end that begin at the first, in radii and radians: no
    code of anyone's library.
    """
    place, theta = complex(*pair[0, :2]), pair[0, 2]
    for curvature, length in pieces:
        turned = theta + curvature * length
        along = cmath.exp(1j * theta) * length
        place += (
            (cmath.exp(1j * turned) - cmath.exp(1j * theta)) / (1j * curvature)
            if curvature
            else along
        )
        theta = turned
    return max(
        abs(place - complex(*pair[1, :2])) / RADIUS, 2.0 * abs(math.sin(0.5 * (theta - pair[1, 2])))
    )


class Verdicts:
    """What came of all pairs: how many curves each peer has too long, too short, or astray, and the
    worst difference.
    """

    def __init__(self) -> None:
        self.counts: dict[str, dict[bytes, np.ndarray]] = defaultdict(
            dict
        )  # by name and batch, which is judged in every round

    def __call__(self, pairs: np.ndarray, answers: dict[str, Answer]) -> None:
        """Ours must end where they should. A curve that also does, and is shorter, would prove us
        wrong.
        """
        ours = answers["kinoedu"]
        assert max(map(off_goal, pairs, ours.pieces)) < SAME
        assert np.allclose(
            [sum(abs(s) for _, s in one) for one in ours.pieces], ours.lengths, rtol=0, atol=SAME
        )
        for name, theirs in answers.items():
            more = (theirs.lengths - ours.lengths) / RADIUS
            ends = map(off_goal, pairs, theirs.pieces) if theirs.pieces else np.zeros(len(pairs))
            astray = np.array(list(ends)) > 1e-6
            assert (more[~astray] > -SAME).all(), f"{name} has a shorter curve"
            counts = (
                len(pairs),
                (more > SAME).sum(),
                (more < -SAME).sum(),
                astray.sum(),
                np.abs(more).max(),
            )
            self.counts[name][pairs.tobytes()] = np.array(counts)

    def print(self) -> None:
        """A row for each peer."""
        print(
            "\n| beside kinoedu | pairs | longer | shorter | astray | worst difference, radii "
            "|\n|---|---:|---:|---:|---:|---:|"
        )
        for name, batches in self.counts.items():
            *counts, worst = np.array(list(batches.values())).T
            pairs, longer, shorter, astray = np.sum(counts, axis=1).astype(int)
            print(
                f"| {name} | {pairs:,} | {longer:,} | {shorter:,} | {astray:,} | "
                f"{worst.max():.2g} |"
            )


def race(title: str, makers: dict[str, Callable[[], Contestant]], batches: int) -> None:
    """Lengths and times of all batches: of the curves, and of their lengths alone, which is all
    that OMPL tells.
    """
    verdicts = Verdicts()
    seconds = measure(available(makers), map(pairs_of, range(batches)), verdicts, repeats=1)
    alone = {name: seconds.pop(name) for name in (COMPILED, "OMPL") if name in seconds}
    report(f"{title}, {BATCH} pairs at a time", seconds, {})
    report(f"{title}, {BATCH} lengths alone", alone, {}, ours=COMPILED)
    verdicts.print()


def main(pairs: int = PAIRS) -> None:
    """Both kinds of curve."""
    batches = -(-pairs // BATCH)
    peers = {"rsplan": rsplan, "OMPL": lambda: ompl("ReedsSheppStateSpace")}
    ours = {
        "kinoedu": lambda: kinoedu(ke.reeds_shepp_path),
        COMPILED: lambda: in_compiled_code(True),
    }
    race("Reeds and Shepp", ours | peers, batches)
    ours = {"kinoedu": lambda: kinoedu(ke.dubins_path), COMPILED: lambda: in_compiled_code(False)}
    race("Dubins", ours | {"OMPL": lambda: ompl("DubinsStateSpace")}, batches)


if __name__ == "__main__":
    run(main)

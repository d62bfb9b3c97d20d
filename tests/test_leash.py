"""How far one path follows another, compared with all walks of the two."""

import numpy as np
import pytest

from kinoedu.geometry.leash import count_followed_points, densify_path


def follow_in_all_ways(path, guide, leash):
    """The places of both that can be reached together, one step of either or of both at a time."""
    waiting, reached = [(0, 0)], set()
    while waiting:
        i, j = waiting.pop()
        if (i, j) in reached or i == len(path) or j == len(guide):
            continue
        if np.linalg.norm(path[i] - guide[j]) <= leash:
            reached.add((i, j))
            waiting += [(i + 1, j), (i, j + 1), (i + 1, j + 1)]
    farthest = max((i + 1 for i, _ in reached), default=0)
    ends = (len(path) - 1, len(guide) - 1) in reached
    return len(path) if ends else min(farthest, len(path) - 1)


@pytest.mark.parametrize("seed", range(60))
def test_a_path_follows_as_far_as_any_walk_of_both(seed):
    """Paths beside their guide, on a part of it, and elsewhere; a leash of several lengths."""
    rng = np.random.default_rng(seed)
    guide = densify_path(rng.integers(0, 4, (4, 2)), 0.5)
    beside = guide[: rng.integers(1, len(guide) + 1)] + rng.normal(0.0, 0.1, 2)
    for path in (beside, guide[rng.integers(0, len(guide), 6)], beside[::-1], guide[::2]):
        for leash in (0.1, 0.35, 0.6, 1.5):
            expected = follow_in_all_ways(path, guide, leash)
            assert count_followed_points(path, guide, leash) == expected


def test_a_path_of_no_points_is_followed_nowhere():
    """And vertices of a path keep every bit."""
    assert count_followed_points(np.empty((0, 2)), [(0, 0), (1, 1)], 0.5) == 0
    path = np.random.default_rng(0).normal(0.0, 1e3, (5, 2)) ** 3
    assert all(p in densify_path(path, 1e8).tolist() for p in path.tolist())


def test_points_are_added_along_each_segment():
    """Corners stay, no gap is longer than the spacing, and a point that repeats stays too."""
    path = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 0.0), (1.0, 2.5)])
    dense = densify_path(path, 0.4)
    assert np.linalg.norm(np.diff(dense, axis=0), axis=1).max() <= 0.4
    assert dense[[0, 3, 4, -1]].tolist() == path.tolist() and len(dense) == 1 + 3 + 1 + 7

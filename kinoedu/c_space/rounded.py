"""A convex shape with everything that is within a radius of it: what a disk's centre must avoid.
LaValle, section 4.3.2.
"""

import math
from typing import NamedTuple

import numpy as np

from ..geometry.checks import Array


class Rounded(NamedTuple):
    """A convex polygon, a segment or a point, grown by a radius: its outline is segments and arcs
    in turn, exactly.

    corners : (k, 2), of what was grown, counter-clockwise, none on an edge. radius : by how much.
    """

    corners: Array
    radius: float

    @property
    def area(self) -> float:
        """A + p r + pi r^2 (Steiner), with the area A and the perimeter p of what was grown; a
        segment's p is twice its length.
        """
        p, q = self.corners - self.corners[0], np.roll(self.corners, -1, axis=0) - self.corners[0]
        core = float((p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]).sum()) / 2.0
        return core + self.radius * self.straight + math.pi * self.radius * self.radius

    @property
    def perimeter(self) -> float:
        """p + 2 pi r."""
        return self.straight + 2.0 * math.pi * self.radius

    @property
    def straight(self) -> float:
        """The length of all the segments."""
        along = np.roll(self.corners, -1, axis=0) - self.corners
        return float(np.sqrt((along * along).sum(axis=1)).sum())

    @property
    def segments(self) -> Array:
        """The straight pieces, (k, 2, 2): segment i is edge i, moved outward."""
        normals = self.radius * np.column_stack([np.cos(self.headings), np.sin(self.headings)])
        return np.stack(
            [self.corners + normals, np.roll(self.corners, -1, axis=0) + normals], axis=1
        )

    @property
    def arcs(self) -> Array:
        """The round pieces as rows x, y, angle, turn, (k, 4): arc i, round corner i, comes before
        segment i; it begins at an angle and goes on counter-clockwise by a turn."""
        before = np.roll(self.headings, 1)
        turns = np.mod(self.headings - before, 2.0 * math.pi)
        return np.column_stack([self.corners, before, turns if len(turns) > 1 else [2.0 * math.pi]])

    @property
    def headings(self) -> Array:
        """The direction in which each edge faces outward, (k,), an angle; 0 for a point."""
        along = np.roll(self.corners, -1, axis=0) - self.corners
        return np.arctan2(-along[:, 0], along[:, 1])

    def polyline(self, tolerance: float) -> Array:
        """A convex polygon round it, (n, 2), nowhere farther from it than the tolerance: tangents
        in place of the arcs.
        """
        widest = 2.0 * math.acos(self.radius / (self.radius + tolerance))
        points = []
        for x, y, angle, turn in self.arcs.tolist():
            count = max(math.ceil(turn / widest), 1)
            middles = angle + turn * (np.arange(count) + 0.5) / count
            reach = self.radius / math.cos(0.5 * turn / count)
            points.append(
                np.column_stack([x + reach * np.cos(middles), y + reach * np.sin(middles)])
            )
        return np.concatenate(points)

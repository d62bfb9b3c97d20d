"""The Minkowski sum of a convex shape and a disc: a disk's C-obstacle. LaValle, section 4.3.2."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ..geometry.checks import Array
from ..support.constructors import with_type_names


@with_type_names
class Rounded(NamedTuple):
    """A convex polygon, a segment or a point, grown by a radius; its outline is segments and arcs.

    corners : (k, 2), of the shape before it is grown, counter-clockwise, without corners inside an
        edge.
    radius : the distance by which it is grown.
    """

    corners: Array
    radius: float

    @property
    def area(self) -> float:
        """The area A + p r + pi r^2 (Steiner).

        A and p are the area and the perimeter of the shape before it is grown. The perimeter of a
        segment is twice its length.
        """
        p, q = self.corners - self.corners[0], np.roll(self.corners, -1, axis=0) - self.corners[0]
        core = float((p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]).sum()) / 2.0
        return core + self.radius * self.straight + math.pi * self.radius * self.radius

    @property
    def perimeter(self) -> float:
        """The perimeter p + 2 pi r."""
        return self.straight + 2.0 * math.pi * self.radius

    @property
    def straight(self) -> float:
        """The total length of the segments."""
        along = np.roll(self.corners, -1, axis=0) - self.corners
        return float(np.sqrt((along * along).sum(axis=1)).sum())

    @property
    def segments(self) -> Array:
        """The segments of the outline, (k, 2, 2): segment i is edge i, moved outward."""
        normals = self.radius * np.column_stack([np.cos(self.headings), np.sin(self.headings)])
        return np.stack(
            [self.corners + normals, np.roll(self.corners, -1, axis=0) + normals], axis=1
        )

    @property
    def arcs(self) -> Array:
        """The arcs of the outline as rows x, y, angle, turn, (k, 4).

        Arc i is centred at corner i and comes before segment i. It begins at `angle` and goes on
        counter-clockwise by `turn`.
        """
        before = np.roll(self.headings, 1)
        turns = np.mod(self.headings - before, 2.0 * math.pi)
        turns[turns > 1.5 * math.pi] = 0.0  # a straight corner, rounded to the wrong side
        return np.column_stack([self.corners, before, turns if len(turns) > 1 else [2.0 * math.pi]])

    @property
    def headings(self) -> Array:
        """The angle of the outward normal of each edge, (k,); 0 for a point."""
        along = np.roll(self.corners, -1, axis=0) - self.corners
        return np.arctan2(-along[:, 0], along[:, 1])

    def polyline(self, tolerance: float) -> Array:
        """A circumscribed convex polygon (n, 2), nowhere farther from the shape than the tolerance.

        Tangents replace the arcs.
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

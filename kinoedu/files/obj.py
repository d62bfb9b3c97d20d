"""The triangles of a Wavefront .obj file.

A line is a vertex (v), a face (f) of three or more corners, or something else, which is left out.
A corner is a vertex's number from 1, or, counted back from the last vertex so far, from -1; what
follows it after a slash are textures and normals.

trimesh reads the other formats. Of an .obj it loses lines that begin with a blank or have tabs,
counts back from the end of the file, and cuts a face that is not convex into triangles that cover
more than the face.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..errors import UnreadableScene
from ..geometry.checks import Array
from ..geometry.ear_clipping import cut_ears
from ..support.text import shortened

Numbers = NDArray[np.int64]
CONTINUED = b"\v\f"  # stands for the end of a line that goes on in the next; a blank


def read_obj(data: bytes) -> Array:
    """The triangles of a file, (m, 3, 3); of all its bodies.

    Raises
    ------
    UnreadableScene
        Where a line is damaged; the message names the line, but not the file.
    """
    vertices, faces = list[list[float]](), dict[int, list[list[int]]]()
    joined = data.replace(b"\\\r\n", CONTINUED).replace(b"\\\n", CONTINUED)
    number = 1
    for line in joined.splitlines():
        kind, *words = line.partition(b"#")[0].split() or [b""]
        if kind == b"v":
            vertices.append(read_vertex(words, number))
        elif kind == b"f":
            corners = [read_corner(word, len(vertices), number) for word in words]
            if len(corners) < 3:
                raise damage(
                    number, b" ".join([kind, *words]), "is a face of fewer than three corners"
                )
            faces.setdefault(len(corners), []).append(corners)
        number += 1 + line.count(CONTINUED)
    points = np.array(vertices, float).reshape(-1, 3)
    parts = [cut_faces(points, np.array(of_size)) for of_size in faces.values()]
    return np.concatenate([np.empty((0, 3, 3)), *parts])


def read_vertex(words: list[bytes], number: int) -> list[float]:
    """The coordinates of a vertex; a weight and colours after them are left out."""
    try:
        if b"_" not in b"".join(words):  # Python would read 1_0 as 10
            x, y, z = map(float, words[:3])
            return [x, y, z]
    except ValueError:
        pass
    raise damage(number, b" ".join([b"v", *words]), "is no vertex of three numbers")


def read_corner(word: bytes, count: int, number: int) -> int:
    """The index of a corner's vertex, from 0, where `count` vertices came before the face."""
    first, _, _ = word.partition(b"/")
    if not first.removeprefix(b"-").isdigit() or int(first) == 0 or int(first) < -count:
        raise damage(number, word, f"is no corner of a face after {count:,} vertices")
    return int(first) - 1 if int(first) > 0 else count + int(first)


def damage(number: int, line: bytes, what: str) -> UnreadableScene:
    """An error that names a line."""
    shown = shortened(line.decode(errors="replace").strip())
    return UnreadableScene(
        f"expected a mesh in .obj, got damage: in line {number:,} {shown} {what}; export it again"
    )


def cut_faces(points: Array, faces: Numbers) -> Array:
    """Cut faces of n corners each, (k, n), into triangles, (k (n - 2), 3, 3).

    Raises
    ------
    UnreadableScene
        Where a face has a corner that is no vertex.
    """
    if faces.max() >= len(points):
        raise UnreadableScene(
            f"expected a mesh in .obj, got damage: a face has the corner {faces.max() + 1:,}, and "
            f"there are {len(points):,} vertices; export it again"
        )
    n, rings = faces.shape[1], points[faces]
    with np.errstate(all="ignore"):  # infinite coordinates are refused by the caller
        edges = np.roll(rings, -1, axis=1) - rings
        normals = np.cross(rings[:, 1:-1] - rings[:, :1], rings[:, 2:] - rings[:, :1]).sum(axis=1)
        turns = np.einsum("knd,kd->kn", np.cross(edges, np.roll(edges, -1, axis=1)), normals)
    is_convex = (turns >= 0.0).all(axis=1) | (n == 3) | ~np.isfinite(turns).all(axis=1)
    fan = np.array([(0, i, i + 1) for i in range(1, n - 1)])
    ears = [cut_ring(ring, normal) for ring, normal in zip(rings[~is_convex], normals[~is_convex])]
    return np.concatenate([rings[is_convex][:, fan].reshape(-1, 3, 3), *ears])


def cut_ring(ring: Array, normal: Array) -> Array:
    """The triangles of a face (n, 3), by its ears as seen along an axis; they keep its side."""
    axis = int(np.abs(normal).argmax())
    flat = np.delete(ring, axis, axis=1)
    is_seen_from_below = (normal[axis] < 0.0) != (axis == 1)  # (x, z) is turned the other way
    order = np.arange(len(ring))[:: -1 if is_seen_from_below else 1]
    mesh = cut_ears(np.ascontiguousarray(flat[order]))
    corners, seen = [], np.zeros(len(mesh.origin), bool)
    for edge in range(len(mesh.origin)):
        if not seen[edge]:
            around = [edge, mesh.after[edge], mesh.after[mesh.after[edge]]]
            seen[around] = True
            corners.append(order[mesh.origin[around]])
    triangles = ring[np.array(corners)]
    return triangles[:, ::-1] if is_seen_from_below else triangles

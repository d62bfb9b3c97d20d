"""Layers of what the variables of a running function show, step by step."""

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from ...figures.robots import Outlined, outline_at
from ...geometry.checks import Array
from ..core.drawing import Layer, arrows, bodies, dots, edges, labels, sides_of
from .variables import Variable

Noted = dict[str, Variable]
SIDES = 120  # of a circle


def draw_variables(notes: Sequence[Noted], colours: dict[str, str]) -> list[Layer]:
    """Points with their names, and lists of points as small dots, at the steps that have them."""
    layers = []
    for name, colour in colours.items():
        rows, when, until = rows_over_time([note.get(name) for note in notes])
        if not len(rows):
            continue
        many = any(name in note and not note[name].is_point for note in notes)
        points = dots(rows, colour, radius=4.0 if many else 6.0, when=when, until=until)
        layers.append(points._replace(casing=not many))
        if not many:
            layers.append(labels(rows, [name] * len(rows), colour, when=when, until=until))
    return layers


def draw_lines(notes: Sequence[Noted], lines: Iterable[tuple[str, str]]) -> list[Layer]:
    """A dashed line between two variables, at the steps at which both are points."""
    layers = []
    for first, second in lines:
        ends = [join_points(note.get(first), note.get(second)) for note in notes]
        rows, when, until = rows_over_time(ends)
        layers.append(edges(rows, "ink", width=2.0, dash=(6, 4), when=when, until=until))
    return layers


def draw_vectors(
    notes: Sequence[Noted], vectors: Mapping[str, str], colours: Mapping[str, str]
) -> list[Layer]:
    """An arrow with its name for each variable that is a vector, from the point where it begins."""
    layers = []
    for name, begin in vectors.items():
        ends = [join_points(note.get(begin), note.get(name)) for note in notes]
        rows, when, until = rows_over_time(ends)
        if not len(rows) or name not in colours:
            continue
        at, vector = rows[:, :2], rows[:, 2:]
        layers += [
            arrows(at, vector, colours[name], when=when, until=until),
            labels(at + vector / 2, [name] * len(rows), colours[name], when=when, until=until),
        ]
    return layers


def draw_circles(notes: Sequence[Noted], radii: Sequence[Mapping[str, float]]) -> list[Layer]:
    """Circles round points, at the steps at which point and radius have a value."""
    layers = []
    for name in dict.fromkeys(name for radius in radii for name in radius):
        found = [
            join_radius(note.get(name), radius.get(name))
            for note, radius in zip(notes, radii, strict=True)
        ]
        rows, when, until = rows_over_time(found)
        circles = [sides_of(make_circle(row[:2], row[2])) for row in rows]
        sides = np.array(circles).reshape(-1, 4)
        times = np.repeat(when, SIDES), np.repeat(until, SIDES)
        layers.append(edges(sides, "roadmap", width=1.6, when=times[0], until=times[1]))
    return layers


def make_circle(middle: Array, radius: float) -> Array:
    """Points of a circle, (SIDES, 2)."""
    angles = np.linspace(0.0, 2.0 * np.pi, SIDES, endpoint=False)
    return middle + radius * np.column_stack([np.cos(angles), np.sin(angles)])


def join_radius(point: Variable | None, radius: float | None) -> Variable | None:
    """A point and a radius as one row (1, 3), or None."""
    if point is None or point.points is None or radius is None or not np.isfinite(radius):
        return None
    return Variable("", np.array([[*point.points[-1], radius]]))


def draw_bodies(notes: Sequence[Noted], robot: Outlined, colours: Mapping[str, str]) -> list[Layer]:
    """The robot's body and the name at each variable that is a pose."""
    layers = list[Layer]()
    for name, colour in colours.items():
        poses = [note[name].pose if name in note else None for note in notes]
        values = [None if pose is None else Variable("", pose[None]) for pose in poses]
        rows, when, until = rows_over_time(values)
        if not len(rows):
            continue
        shapes = [outline_at(robot, pose) for pose in rows]
        layers.append(bodies(shapes, colour, when=when, until=until))
        layers.append(labels(rows[:, :2], [name] * len(rows), colour, when=when, until=until))
    return layers


def join_points(a: Variable | None, b: Variable | None) -> Variable | None:
    """Two points as one row (1, 4), or None."""
    if a is None or b is None or a.points is None or b.points is None:
        return None
    return Variable("", np.hstack([a.points[-1:], b.points[-1:]]))


def rows_over_time(values: Sequence[Variable | None]) -> tuple[Array, list[int], list[int]]:
    """The rows that variables have in the course of the steps.

    A row that stays is there once: a growing list has each of its points once.

    Returns
    -------
    The rows, for each the step at which it appears, and the step at which it disappears.
    """
    rows, when, until = list[Array](), list[int](), list[int]()
    present = list[int]()  # the indices of the rows that are there now
    last = nothing = np.empty((0, 2))
    for step, value in enumerate(values, start=1):
        now = nothing if value is None or value.points is None else value.points
        if np.array_equal(now, last):  # as after most lines
            continue
        last = now
        same = count_same([rows[k] for k in present], now)
        for k in present[same:]:
            until[k] = step
        del present[same:]
        for row in now[same:]:
            present.append(len(rows))
            rows.append(row)
            when.append(step)
            until.append(len(values) + 1)
    return np.array(rows).reshape(len(rows), len(rows[0]) if rows else 2), when, until


def count_same(before: Sequence[Array], now: Array) -> int:
    """How many of the first rows are the same."""
    most = min(len(before), len(now))
    if most == 0:
        return 0
    differ = (np.array(before[:most]) != now[:most]).any(axis=1)
    return int(differ.argmax()) if differ.any() else most


def draw_moments(drawn: Sequence[Iterable[Layer]]) -> list[Layer]:
    """The layers of each step, shown at that step only; those of one style become one layer.

    Their notes are left out.
    """
    found: dict[object, list[tuple[int, Layer]]] = {}
    for step, layers in enumerate(drawn, start=1):
        for layer in layers:
            style = (layer.kind, layer.colour, layer.width, layer.dash, layer.rows.shape[1])
            found.setdefault((*style, layer.casing, layer.hatched), []).append((step, layer))
    return [join_layers(parts) for parts in found.values()]


def join_layers(parts: Sequence[tuple[int, Layer]]) -> Layer:
    """Layers of one style as one, each shown at its own step."""
    when = np.concatenate([np.full(len(layer.rows), float(step)) for step, layer in parts])
    return parts[0][1]._replace(
        rows=np.concatenate([layer.rows for _, layer in parts]),
        texts=tuple(text for _, layer in parts for text in layer.texts),
        when=when,
        until=when + 1.0,
        last=False,
        says=(),
        names=(),
        notes=None,
    )

"""Pictures of failing cases: the truth solid green, the student's answer dashed brown."""

import numpy as np

from ....geometry import closest_point_on_segment, line_through_points
from ....geometry.checks import Array
from ....geometry.polygons import nearest_on_ring
from ....messages import get_message
from ...exercise import Axes, Case, ValueExercise
from ...outcomes import Answer

# figures are imported inside the functions: matplotlib is only needed for failing cases


def draw_line(exercise: ValueExercise, case: Case, value: Array | None, ax: Axes) -> None:
    """Draw two points, the line through them, and the student's line."""
    from ....figures import palette, plane

    p1, p2 = case.given["p1"], case.given["p2"]
    plane.frame([p1, p2], ax, margin=0.6)
    if (p1 != p2).any():
        plane.line(
            line_through_points(p1, p2), get_message("picture.true"), ax, colour=palette.TRUE
        )
    if value is not None:
        numbers = ", ".join(f"{number if abs(number) > 1e-12 else 0.0:.3g}" for number in value)
        plane.line(
            value, get_message("picture.yours", value=numbers), ax, colour=palette.YOURS, style="--"
        )
    if ax.lines:
        ax.legend(fontsize=palette.TEXT_SIZE, loc="best")
    plane.dot(p1, "p1" if (p1 != p2).any() else "p1 = p2", ax)
    plane.dot(p2, "p2" if (p1 != p2).any() else "", ax)
    if value is None:
        plane.corner_note(get_message("picture.no_answer"), ax, colour=palette.YOURS)
    plane.title(title_words(exercise, case, value), ax)


def title_words(exercise: ValueExercise, case: Case, value: Array | None) -> str:
    """Title of the picture: about the length where that is wrong, else about the kind of input."""
    wrong_length = value is not None and exercise.judge(case, Answer(value)).rule == "unit"
    return exercise.message(f"pictures.{'unit' if wrong_length else case.kind}")


def draw_distance(exercise: ValueExercise, case: Case, value: float | None, ax: Axes) -> None:
    """Draw q, the object measured to, and a circle around q for each of the two distances."""
    from ....figures import palette, plane

    q, truth = case.given["q"], exercise.truth(case)
    target = case.given.get("polygon")
    if target is None:
        target = np.array([case.given["p1"], case.given["p2"]])
    nearest = None if isinstance(truth, ValueError) else nearest_point(exercise, case)
    plane.frame(np.vstack([q, target] + ([] if nearest is None else [nearest])), ax, margin=0.35)
    draw_target(exercise, target, ax)
    if nearest is not None:
        plane.ring(q, abs(truth), "", ax, colour=palette.TRUE)
        words = get_message("picture.should_be", value=f"{truth:.4g}")
        if truth != 0:
            plane.segment(q, nearest, words, ax, colour=palette.TRUE)
    if value is not None and np.isfinite(value) and value != 0:
        name = get_message("picture.yours", value=f"{value:.4g}")
        plane.ring(q, abs(value), name, ax, colour=palette.YOURS, style="--")
    else:
        words = get_message("picture.no_answer")
        if value is not None:
            words = get_message("picture.yours", value=f"{value:.4g}")
        plane.corner_note(words, ax, colour=palette.YOURS)
    plane.dot(q, "q", ax)
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def draw_target(exercise: ValueExercise, target: Array, ax: Axes) -> None:
    """Draw the line, the segment or the polygon that the distance is measured to."""
    from ....figures import palette, plane

    if exercise.name == "point_polygon_distance":
        plane.polygon(target, ax)
        return
    p1, p2 = target
    if exercise.name == "point_line_distance" and (p1 != p2).any():
        plane.line(line_through_points(p1, p2), "", ax, colour=palette.OBSTACLE)
    plane.segment(p1, p2, "", ax, colour=palette.OBSTACLE, width=4.0)
    plane.dot(p1, "p1" if (p1 != p2).any() else "p1 = p2", ax, colour=palette.OBSTACLE)
    plane.dot(p2, "p2" if (p1 != p2).any() else "", ax, colour=palette.OBSTACLE)


def nearest_point(exercise: ValueExercise, case: Case) -> Array:
    """The point that is truly nearest to q."""
    q = case.given["q"]
    if "polygon" in case.given:
        return np.array(nearest_on_ring(q[0], q[1], case.given["polygon"])[1:3])
    p1, p2 = case.given["p1"], case.given["p2"]
    if exercise.name == "point_segment_distance":
        return closest_point_on_segment(q, p1, p2)[0]
    a, b, c = line_through_points(p1, p2)
    return q - (a * q[0] + b * q[1] + c) * np.array([a, b])


def draw_tangent(exercise: ValueExercise, case: Case, value: Array | None, ax: Axes) -> None:
    """Draw the polygon, q, its nearest point, and both vectors at a visible length."""
    from ....figures import palette, plane

    q, polygon = case.given["q"], case.given["polygon"]
    _, x, y, region = nearest_on_ring(q[0], q[1], polygon)
    reach = 0.25 * float(np.ptp(np.vstack([polygon, q]), axis=0).max())
    truth = exercise.truth(case)
    size = 0.0 if value is None else float(np.linalg.norm(value))
    # a longer arrow is shortened to fit
    seen = value if value is None or size <= 4.0 else 4.0 * value / size
    ends = [q + reach * truth]
    if seen is not None and np.isfinite(seen).all():
        ends.append(q + reach * seen)
    plane.frame(np.vstack([q, polygon, *ends]), ax, margin=0.15)
    plane.polygon(polygon, ax)
    plane.segment(q, (x, y), "", ax, style=":")
    if region != 0:
        plane.ring(
            (x, y), float(np.hypot(*(q - (x, y)))), "", ax, colour=palette.OUTSIDE, style=":"
        )
    plane.arrow(q, reach * truth, get_message("picture.true"), ax, colour=palette.TRUE)
    if seen is not None and np.isfinite(seen).all() and seen.any():
        words = get_message("picture.yours_short")
        if abs(size - 1.0) >= 1e-6:
            words = get_message("picture.yours_long", length=f"{size:.3g}")
        plane.arrow(q, reach * seen, words, ax, colour=palette.YOURS, style="--")
    plane.dot(q, "q", ax)
    plane.title(title_words(exercise, case, value), ax)


def draw_crossings(value: tuple[Array, Array] | None, ax: Axes) -> None:
    """Draw a polygon, q, the ray from q to the right, and a cross where it meets an edge."""
    from ....figures import palette, plane

    q, polygon = value if value is not None else (np.zeros(2), np.empty((0, 2)))
    if value is None or not np.isfinite(np.vstack([q, polygon])).all():
        plane.frame([(0, 0), (1, 1)], ax)
        plane.corner_note(get_message("picture.no_answer"), ax, colour=palette.YOURS)
        return
    plane.frame(np.vstack([q, polygon]), ax, margin=0.3)
    if len(polygon) > 1:
        plane.polygon(polygon, ax)
    far = max(ax.get_xlim()[1], q[0])
    plane.segment(q, (far, q[1]), "", ax, colour=palette.YOURS, style="--")
    crossed: dict[float, int] = {}
    for a, b in zip(polygon, np.roll(polygon, -1, axis=0)):
        if a[1] != b[1] and min(a[1], b[1]) <= q[1] <= max(a[1], b[1]):
            x = a[0] + (q[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
            if x > q[0]:
                crossed[float(x)] = crossed.get(float(x), 0) + 1
    for x, times in crossed.items():
        plane.dot((x, q[1]), f"{times}x" if times > 1 else "", ax, colour=palette.YOURS, marker="X")
    plane.dot(q, "q", ax)
    plane.title(get_message("exposing_case.picture"), ax)

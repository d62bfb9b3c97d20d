"""The exercise on drawing an arm among discs."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from ....geometry.checks import Array
from ....messages import get_message
from ...exercise import RIGHT, Axes, Case, Slip, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Number, Record, Value
from ...withheld import withheld
from ..geometry.lines import POINT
from .arm_pictures import JOINTS, LINKS, Scene, bar, circle, draw_scene
from .drawn_exercise import DrawnExercise, same_dots
from .link_in_contact import DISCS, ends_of_links, random_case


class PlotEnvironment(DrawnExercise):
    """The links, the joints and the discs, each with its label."""

    name = "plot_environment"
    lesson = "07_collision_detection"
    kinds = ("straight", "bent", "several")
    given = Record(q=POINT, lengths=POINT, width=Number(), discs=DISCS)
    slips = (
        Slip("square", lambda q, links, w, discs: scene_of(q, links, w, discs, rounded=False)),
        Slip("from_x", lambda q, *others: scene_of(q - (0, q[0]), *others)),
        Slip("degrees", lambda q, *others: scene_of(np.radians(q), *others)),
        Slip("whole_width", lambda q, links, w, discs: scene_of(q, links, 2 * w, discs)),
        Slip("narrow", lambda q, links, w, discs: scene_of(q, links, w / 2, discs)),
        Slip("exchanged", lambda *given: exchange_links(scene_of(*given))),
        Slip("half_discs", lambda q, links, w, discs: scene_of(q, links, w, discs * (1, 1, 0.5))),
        Slip("one_disc", lambda q, links, w, discs: scene_of(q, links, w, discs[:1])),
    )

    @staticmethod
    @withheld
    def reference(*given: Value) -> Value:
        """Outlines by their labels."""
        return scene_of(*given)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """An arm along the x-axis, one bent by a right angle, then any arms."""
        for kind, q in (
            ("straight", (0, 0)),
            ("bent", (0, np.pi / 2)),
            ("bent", (np.pi / 2, -np.pi / 4)),
        ):
            arm = (np.array([2.0, 1.0]), 0.5, np.array([(1.0, 2.0, 0.5)]))
            yield Case(kind, dict(zip(self.given.fields, (np.array(q, float), *arm))))
        for number in range(10):
            for kind in self.kinds:
                given = random_case(rng, "free", 1 + (kind == "several") * (1 + number // 4)).given
                yield Case(kind, {**given, "q": given["q"] * (1, kind != "straight")})

    def same(self, value: object, truth: object) -> bool:
        """Whether every label has the same region."""
        return self.fault(value, truth) == ""

    def fault(self, value: Value, truth: Value) -> str:
        """First rule that a drawing breaks, or ""."""
        found, wanted = (drawn_scene(one) if "dots" in one else one for one in (value, truth))
        rules = dict(zip((*LINKS, "disc"), ("first", "second", "discs")))
        missing = [
            label for label in (*rules, JOINTS) if len(wanted[label]) and not len(found[label])
        ]
        if missing:
            return "labels"
        wrong = [
            rule for label, rule in rules.items() if not same_region(found[label], wanted[label])
        ]
        dots = [without_repetition(one[JOINTS]) for one in (found, wanted)]
        return wrong[0] if wrong else "" if same_dots(*dots) else JOINTS

    def value_verdict(self, case: Case, value: object) -> Verdict:
        """Check labels, links, discs and joints."""
        rule = self.fault(value, self.truth(case))
        return Verdict(0.0, rule, self.describe_expected(case)) if rule else RIGHT

    def describe_answer(self, case: Case, value: object) -> str:
        """Number of shapes or dots of each label."""
        counts = ", ".join(
            f"{label!r}: {len(shapes)}" for label, shapes in drawn_scene(value).items()
        )
        return get_message("plot_environment.answered", counts=counts)

    def describe_expected(self, case: Case) -> str:
        """Description of the right drawing."""
        elbow, tip = ends_of_links(case.given["q"], case.given["lengths"])[1:].round(3).tolist()
        return get_message(
            "plot_environment.wanted",
            elbow=tuple(elbow),
            tip=tuple(tip),
            discs=len(case.given["discs"]),
        )

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the right drawing pale, and the student's dashed."""
        drawn = drawn_scene(outcome.value) if isinstance(outcome, Answer) else None
        draw_scene(self, case, self.truth(case), drawn, ax)


def scene_of(
    q: Array, lengths: Array, width: float, discs: Array, *, rounded: bool = True
) -> Scene:
    """Outlines and joints of the right drawing, by their labels."""
    ends = ends_of_links(q, lengths)
    links = {
        label: [bar(a, b, width, rounded=rounded)] for label, a, b in zip(LINKS, ends, ends[1:])
    }
    return {**links, "disc": [circle(disc[:2], disc[2]) for disc in discs], JOINTS: list(ends)}


def exchange_links(scene: Scene) -> Scene:
    """The same outlines, each link with the label of the other."""
    return {**scene, **{label: scene[other] for label, other in zip(LINKS, LINKS[::-1])}}


def drawn_scene(plot: Any) -> Scene:
    """Contents of a plot by label: closed outlines, and dots for the joints."""
    shapes = [*plot["polygons"], *plot["lines"]]
    scene = {
        label: [one["points"] for one in shapes if one["label"] == label]
        for label in (*LINKS, "disc")
    }
    return {
        **scene,
        JOINTS: [dot for one in plot["dots"] if one["label"] == JOINTS for dot in one["points"]],
    }


def without_repetition(dots: list[Array]) -> Array:
    """Dots, each place once, (n, 2): a joint may be drawn as an end of each of its links."""
    places = np.reshape(dots, (-1, 2))
    _, first = np.unique(np.round(places, 5) + 0.0, axis=0, return_index=True)
    return places[first]


def same_region(found: list[Array], wanted: list[Array]) -> bool:
    """Whether outlines together enclose the same region, up to a hundredth of its area."""
    import shapely

    def together(rings: list[Array]) -> Value:
        good = [ring for ring in rings if len(ring) > 2 and np.isfinite(ring).all()]
        return shapely.union_all([shapely.make_valid(shapely.Polygon(ring)) for ring in good])

    region = together(wanted)
    return bool(shapely.symmetric_difference(together(found), region).area <= 0.01 * region.area)

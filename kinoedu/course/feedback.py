"""A report in words and with a picture: what a student reads."""

import io
from html import escape
from typing import Any

from ..words import has_words, say
from .exercise import Exercise, spoken
from .judging import Judged, Report
from .outcomes import Answer, Misshapen, Outcome, Raised

RULE, CASE, PICTURE, ALL = 1, 2, 3, 4  # the stages: each shows what those before it show, and more
TRIES: dict[str, list[int]] = {}  # for each exercise the failures so far in this session, different ones


class Feedback:
    """A report, told up to a stage. Shows itself in a notebook: words, then the picture of the smallest case that failed."""

    def __init__(self, report: Report, stage: int = ALL) -> None:
        self.report = report
        self.stage = stage

    def __repr__(self) -> str:
        return "\n".join(f"{title}{': ' if title else ''}{text}" for title, text in told(self.report, self.stage))

    def _repr_html_(self) -> str:
        """The same words, laid out."""
        sign = "unanswered" if self.report.unanswered else "right" if self.report.is_right else "wrong"
        rows = [row(title, text) for title, text in told(self.report, self.stage)]
        return f"<div class='kinoedu-check kinoedu-{sign}' style='{STYLE[sign]}'>{''.join(rows)}</div>"

    def picture(self) -> bytes | None:
        """The smallest failing case as a PNG; None where nothing failed or it is not to be shown yet."""
        failure = self.report.failure
        if failure is None or self.report.unanswered or self.stage < PICTURE:
            return None
        return picture_of(self.report.exercise, failure)

    def _ipython_display_(self) -> None:
        """Two outputs, so that stored words are compared and pictures are not."""
        from IPython.display import Image, display

        display({"text/plain": repr(self), "text/html": self._repr_html_()}, raw=True)
        picture = self.picture()
        if picture is not None:
            display(Image(picture, alt=say("check.picture", name=self.report.exercise.name)))


def told(report: Report, stage: int) -> list[tuple[str, str]]:
    """What is said, as pairs of a title and a text."""
    exercise, failure = report.exercise, report.failure
    if report.unanswered:
        return [("", say("check.unanswered", name=exercise.name))]
    if failure is None:
        return told_right(report)
    lines = [
        ("", say("check.wrong", name=exercise.name, right=len(exercise.kinds) - len(report.failed), total=len(exercise.kinds)))
    ]
    lines.append((say("check.rule"), rule_words(exercise, failure)))
    if stage >= CASE:
        lines += told_case(exercise, failure)
    if stage >= ALL:
        lines.append((say("check.hint"), hint_words(exercise, failure)))
        lines.append((say("check.read"), exercise.words("section")))
    good = [exercise.words(f"kinds.{kind}") for kind in exercise.kinds if kind not in report.failed]
    if good:
        lines.append((say("check.good"), "; ".join(good)))
    return lines


def told_right(report: Report) -> list[tuple[str, str]]:
    """What a right answer survived, and what to wonder about."""
    exercise = report.exercise
    survived = "; ".join(f"{exercise.words(f'kinds.{kind}')} ({report.survived[kind]})" for kind in exercise.kinds)
    lines = [("", say("check.right", name=exercise.name, cases=sum(report.survived.values())))]
    lines += [(say("check.survived"), survived), (say("check.wonder"), exercise.words("wonder"))]
    if exercise.source is not None:
        lines.append((say("check.ours"), say("check.show", name=exercise.name)))
    return lines


def told_case(exercise: Exercise, failure: Judged) -> list[tuple[str, str]]:
    """The call that failed, what came of it, and what should have."""
    given = ", ".join(f"{name}={spoken(value)}" for name, value in failure.case.given.items())
    lines = [(say("check.call"), f"{exercise.name}({given})")]
    lines += [(say("check.yours"), outcome_words(exercise, failure.outcome)), (say("check.wanted"), failure.verdict.wanted)]
    if isinstance(failure.outcome, Raised) and failure.outcome.lines:
        lines.append((say("check.where"), "\n".join(failure.outcome.lines)))
    return lines


def outcome_words(exercise: Exercise, outcome: Outcome) -> str:
    """What came of a call, in words."""
    if isinstance(outcome, Answer):
        return spoken(outcome.value)
    if isinstance(outcome, Misshapen):
        return outcome.message
    if isinstance(outcome, Raised):
        return say("check.raised", kind=outcome.kinds[0] if outcome.kinds else "", message=outcome.message)
    return say("check.still_running" if outcome.left_running else "check.late", seconds=exercise.seconds)


def rule_words(exercise: Exercise, failure: Judged) -> str:
    """The rule that was broken."""
    return exercise.words(f"rules.{failure.verdict.rule}")


def hint_words(exercise: Exercise, failure: Judged) -> str:
    """The hint of the misconception that was recognised, else that of the rule."""
    key = f"slips.{failure.slip}" if failure.slip else f"hints.{failure.verdict.rule}"
    if not has_words(f"{exercise.name}.{key}") and not has_words(f"exercise.{key}"):
        key = f"hints.{failure.case.kind}"
    return exercise.words(key)


def stage_of(report: Report) -> int:
    """How much a student who asked for hints bit by bit has earned: one stage more for each different failure."""
    if report.failure is None:
        return ALL
    tries = TRIES.setdefault(report.exercise.name, [])
    failure = hash((repr(report.failure.outcome), report.failed, repr(report.failure.case)))
    if failure not in tries:
        tries.append(failure)
    return min(len(tries), ALL)


def picture_of(exercise: Exercise, failure: Judged) -> bytes:
    """The failing case, drawn by the exercise; a PNG."""
    from ..figures.plane import plane_figure

    figure, ax = plane_figure()
    exercise.draw(failure.case, failure.outcome, ax)
    stream = io.BytesIO()
    figure.savefig(stream, format="png", dpi=72)
    return stream.getvalue()


def row(title: str, text: str) -> str:
    """One line of the words as HTML; what a student's program said is escaped."""
    body = "<br>".join(escape(text).splitlines())
    if not title:
        return f"<p style='margin:0 0 .4em'><b>{body}</b></p>"
    kind = "code" if title in (say("check.call"), say("check.yours"), say("check.where")) else "span"
    return (
        f"<div style='display:flex;gap:.8em;margin:.15em 0'><span style='flex:0 0 9em;opacity:.75'>{escape(title)}</span>"
        f"<{kind} style='flex:1;white-space:pre-wrap;overflow-wrap:anywhere'>{body}</{kind}></div>"
    )


BOX = "border-left:6px solid {colour};padding:.5em 1em;max-width:60em;line-height:1.45;font-size:14px"
STYLE: dict[str, Any] = {
    "right": BOX.format(colour="#007A5E"),
    "wrong": BOX.format(colour="#C44E00"),
    "unanswered": BOX.format(colour="#9CA3AF"),
}

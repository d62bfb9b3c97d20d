"""A report in words and with a picture: what a student reads."""

import io
from html import escape
from typing import Any

import numpy as np

from ..words import say
from .advice import advice_on
from .exercise import Exercise
from .judging import Judged, Report
from .outcomes import Answer, Changed, Late, Misshapen, Outcome, Raised

RULE, CASE, PICTURE, ALL = 1, 2, 3, 4  # the stages: each shows what those before it show, and more
LONG, SHOWN = 400, 60  # letters: of a line that is longer than that so many are shown at first
TRIES: dict[
    str, list[int]
] = {}  # for each exercise the failures so far in this session, different ones


class Feedback:
    """A report, told up to a stage. Shows itself in a notebook: words, then the picture of the
    smallest case that failed.
    """

    def __init__(self, report: Report, stage: int = ALL, printed: str = "") -> None:
        self.report = report
        self.stage = stage
        self.printed = printed

    def told(self) -> list[tuple[str, str]]:
        """What is said, as pairs of a title and a text."""
        return told(self.report, self.stage, self.printed.rstrip())

    def __repr__(self) -> str:
        return "\n".join(laid_out(title, text) for title, text in self.told())

    def _repr_html_(self) -> str:
        """The same words, laid out."""
        sign = (
            "unanswered" if self.report.unwritten else "right" if self.report.is_right else "wrong"
        )
        rows = [row(title, text) for title, text in self.told()]
        return (
            f"<div class='kinoedu-check kinoedu-{sign}' style='{STYLE[sign]}'>{''.join(rows)}</div>"
        )

    def picture(self) -> bytes | None:
        """The smallest failing case as a PNG; None where nothing failed or it is not to be shown
        yet.
        """
        failure = self.report.failure
        if failure is None or self.report.unwritten or self.stage < PICTURE:
            return None
        return picture_of(self.report.exercise, failure)

    def _ipython_display_(self) -> None:
        """Two outputs, so that stored words are compared and pictures are not."""
        from IPython.display import Image, display

        display({"text/plain": repr(self), "text/html": self._repr_html_()}, raw=True)
        picture = self.picture()
        if picture is not None:
            display(Image(picture, alt=say("check.picture", name=self.report.exercise.name)))


def told(report: Report, stage: int, printed: str) -> list[tuple[str, str]]:
    """What is said up to a stage, as pairs of a title and a text; `printed` is what the program
    wrote in the case that failed.
    """
    exercise, failure = report.exercise, report.failure
    if report.unwritten:
        other = report.unwritten != exercise.name
        return [
            (
                "",
                say(
                    "check.unwritten" if other else "check.unanswered",
                    name=exercise.name,
                    called=report.unwritten,
                ),
            )
        ]
    if failure is None:
        return told_right(report)
    lines = [
        (
            "",
            say(
                "check.wrong",
                name=exercise.name,
                right=len(exercise.kinds) - len(report.failed),
                total=len(exercise.kinds),
            ),
        )
    ]
    lines.append((say("check.rule"), rule_words(exercise, failure)))
    if stage >= CASE:
        lines += told_case(exercise, failure, printed)
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
    survived = "; ".join(
        f"{exercise.words(f'kinds.{kind}')} ({report.survived[kind]})" for kind in exercise.kinds
    )
    lines = [("", exercise.words("right", name=exercise.name, cases=sum(report.survived.values())))]
    if exercise.given.fields:
        lines.append((say("check.survived"), survived))
    lines.append((say("check.wonder"), exercise.words("wonder")))
    if exercise.source is not None:
        lines.append((say("check.ours"), say("check.show", name=exercise.name)))
    return lines


def told_case(exercise: Exercise, failure: Judged, printed: str) -> list[tuple[str, str]]:
    """The call that failed, what came of it, and what should have."""
    given = [f"{name} = {as_code(value)}" for name, value in failure.case.given.items()]
    lines = [(say("check.contract"), exercise.contract)] if exercise.contract else []
    lines += [
        (
            say("check.call"),
            "\n".join([*given, f"{exercise.name}({', '.join(failure.case.given)})"]),
        )
    ]
    lines.append((say("check.yours"), outcome_words(exercise, failure)))
    if printed:
        lines.append((say("check.printed"), printed))
    lines.append((say("check.wanted"), failure.verdict.wanted))
    if isinstance(failure.outcome, Raised | Late) and failure.outcome.lines:
        lines.append((say("check.where"), "\n".join(failure.outcome.lines)))
    return lines


def outcome_words(exercise: Exercise, failure: Judged) -> str:
    """What came of a call, in words."""
    outcome = failure.outcome
    if isinstance(outcome, Answer):
        return exercise.answer_words(failure.case, outcome.value)
    if isinstance(outcome, Misshapen):
        return outcome.message
    if isinstance(outcome, Changed):
        return say("check.changed", names=", ".join(outcome.names))
    if isinstance(outcome, Raised):
        return say(
            "check.raised", kind=outcome.kinds[0] if outcome.kinds else "", message=outcome.message
        )
    return late_words(outcome)


def late_words(late: Late) -> str:
    """Why a program has no answer: how long it computed, and for how long it was allowed to."""
    key = "late" if late.used > late.allowed else "late_waiting" if late.allowed else "late_unknown"
    seconds = {"used": late.used, "allowed": late.allowed, "passed": late.passed}
    words = say(f"check.{key}", **{name: f"{value:.1f}" for name, value in seconds.items()})
    return f"{words} {say('check.still_running' if late.left_running else 'check.stopped')}"


def as_code(value: Any) -> str:
    """A value as a line of Python that a student can copy.

    >>> as_code(np.array([[0.0, 0.5], [2.0, 1.0]])), as_code(2.0)
    ('np.array([(0.0, 0.5), (2.0, 1.0)])', '2.0')
    """
    if isinstance(value, np.ndarray) and value.ndim == 2:
        return f"np.array([{', '.join(str(tuple(row)) for row in value.tolist())}])"
    if isinstance(value, np.ndarray):
        return f"np.array({value.tolist()})"
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(as_code, value))}]"
    return repr(value)


def laid_out(title: str, text: str) -> str:
    """A title and its text; a text of several lines stands below, indented."""
    if "\n" in text:
        text = "\n    " + text.replace("\n", "\n    ")
    return f"{title}: {text}" if title else text


def rule_words(exercise: Exercise, failure: Judged) -> str:
    """The rule that was broken."""
    return exercise.words(f"rules.{failure.verdict.rule}")


def hint_words(exercise: Exercise, failure: Judged) -> str:
    """The hint of the misconception that was recognised, of the error that Python raised, else that
    of the rule.
    """
    advice = advice_on(failure.outcome)
    if advice:
        return say(f"advice.{advice}")
    key = f"slips.{failure.slip}" if failure.slip else f"hints.{failure.verdict.rule}"
    if not exercise.table_with(key):
        key = f"hints.{failure.case.kind}"
    if is_slow(failure.outcome) and exercise.table_with(key) == exercise.shared[-1]:
        return say("advice.slow")
    return exercise.words(key)


def is_slow(outcome: Outcome) -> bool:
    """Whether a program was late, and nothing is known of where it spent its time."""
    return isinstance(outcome, Late) and not outcome.lines


def stage_of(report: Report) -> int:
    """How much a student who asked for hints bit by bit has earned: one stage more for each
    different failure.
    """
    if report.failure is None:
        return ALL
    tries = TRIES.setdefault(report.exercise.name, [])
    outcome = report.failure.outcome
    came = "Late" if isinstance(outcome, Late) else repr(outcome)  # its seconds are never the same
    failure = hash((came, report.failed, repr(report.failure.case)))
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


def folded(line: str) -> str:
    """A line as HTML; of one that is very long the beginning, and all of it on a click."""
    if len(line) <= LONG:
        return escape(line)
    return (
        f"<details style='display:inline-block'><summary>{escape(line[:SHOWN])} "
        f"…</summary>{escape(line)}</details>"
    )


def row(title: str, text: str) -> str:
    """One line of the words as HTML; what a student's program said is escaped."""
    body = "<br>".join(folded(line) for line in text.splitlines())
    if not title:
        return f"<p style='margin:0 0 .4em'><b>{body}</b></p>"
    kind = (
        "code"
        if title
        in (say("check.call"), say("check.yours"), say("check.where"), say("check.printed"))
        else "span"
    )
    return (
        "<div style='display:flex;gap:.8em;margin:.15em 0'><span style='flex:0 0 "
        f"9em;opacity:.75'>{escape(title)}</span>"
        f"<{kind} style='flex:1;white-space:pre-wrap;overflow-wrap:anywhere'>{body}</{kind}></div>"
    )


BOX = (
    "border-left:6px solid {colour};padding:.5em 1em;max-width:60em;line-height:1.45;font-size:14px"
)
STYLE: dict[str, Any] = {
    "right": BOX.format(colour="#007A5E"),
    "wrong": BOX.format(colour="#C44E00"),
    "unanswered": BOX.format(colour="#9CA3AF"),
}

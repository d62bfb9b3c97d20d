"""Feedback for students: a report as text and a picture."""

import io
from collections.abc import Callable
from html import escape
from typing import Any

import numpy as np

from ..errors import InvalidPoint
from ..messages import get_message
from ..support.text import with_code
from .advice import find_advice, is_excess, raises_itself
from .exercise import Exercise
from .judging import JudgedCase, Report
from .outcomes import Answer, Changed, Late, Misshapen, Outcome, Raised
from .withheld import IN_THE_KIT, NotInTheKit, is_withheld

RULE, CASE, PICTURE, ALL = 1, 2, 3, 4  # stages; each also shows all that the earlier ones show
LONG_LINE, SHOWN_LETTERS = 400, 60  # a line longer than the first is shortened to the second
IDLE_SHARE = 0.1  # a program that used less of its time computed next to nothing
TRIES: dict[str, list[int]] = {}  # hashes of the different failures of each exercise, this session


class Feedback:
    """A report up to a stage, displayed in a notebook as text and a picture.

    The picture shows the smallest case that failed.
    """

    def __init__(
        self, report: Report, stage: int = ALL, printed: str = "", advice: str = ""
    ) -> None:
        self.report = report
        self.advice = advice
        self.stage = stage
        self.printed = printed

    def list_entries(self) -> list[tuple[str, str]]:
        """Text of the feedback, as pairs of a title and a text."""
        return feedback_lines(self.report, self.stage, self.printed.rstrip(), self.advice)

    def __repr__(self) -> str:
        return "\n".join(format_entry(title, text) for title, text in self.list_entries())

    def _repr_html_(self) -> str:
        """The same text as HTML."""
        result = "right" if self.report.is_right else "wrong"
        if self.report.unwritten:
            result = "unanswered"
        entries = "".join(html_entry(title, text) for title, text in self.list_entries())
        style = f"class='kinoedu-check kinoedu-{result}' style='{STYLE[result]}'"
        return f"<div {style}>{entries}</div>"

    def picture(self) -> bytes | None:
        """PNG of the smallest failing case; None where nothing failed or the stage hides it.

        It is None as well where an answer's coordinates are too large for a picture, and in the kit
        for students where a picture needs more than they have.
        """
        failure = self.report.failure
        if failure is None or self.report.unwritten or self.stage < PICTURE:
            return None
        try:
            return draw_failure(self.report.exercise, failure)
        except (NotInTheKit, InvalidPoint):
            return None

    def _ipython_display_(self) -> None:
        """Display text and picture as two outputs, so that notebook tests compare only the text."""
        from IPython.display import Image, display

        display({"text/plain": repr(self), "text/html": self._repr_html_()}, raw=True)
        picture = self.picture()
        if picture is not None:
            words = get_message("check.picture", name=self.report.exercise.name)
            display(Image(picture, alt=words, width=WIDTH))


def feedback_lines(
    report: Report, stage: int, printed: str, advice: str = ""
) -> list[tuple[str, str]]:
    """Text of the feedback up to a stage, as pairs of a title and a text.

    `printed` is the program's own output in the case that failed. `advice` is the key of advice on
    the program itself, which comes before every other hint.
    """
    exercise, failure = report.exercise, report.failure
    if report.unwritten:
        key = "check.unanswered" if report.unwritten == exercise.name else "check.unwritten"
        return [("", get_message(key, name=exercise.name, called=report.unwritten))]
    if failure is None:
        return right_answer_lines(report)
    kind = exercise.message(f"kinds.{failure.case.kind}")
    lines = [("", get_message("check.wrong", name=exercise.name, kind=kind))]
    lines.append((get_message("check.rule"), rule_message(exercise, failure)))
    if stage >= CASE:
        lines += case_lines(exercise, failure, printed)
    if stage >= ALL:
        lines.append((get_message("check.hint"), hint_message(exercise, failure, advice)))
        lines.append((get_message("check.read"), exercise.message("section")))
    good = [exercise.message(f"kinds.{kind}") for kind in report.right_so_far]
    if good:
        lines.append((get_message("check.good"), "; ".join(good)))
    return lines


def right_answer_lines(report: Report) -> list[tuple[str, str]]:
    """Feedback for a right answer: what it passed, and a further question."""
    exercise = report.exercise
    survived = "; ".join(
        f"{exercise.message(f'kinds.{kind}')} ({report.survived[kind]})" for kind in exercise.kinds
    )
    lines = [
        ("", exercise.message("right", name=exercise.name, cases=sum(report.survived.values())))
    ]
    if exercise.given.fields:
        lines.append((get_message("check.survived"), survived))
    lines.append((get_message("check.wonder"), exercise.message("wonder")))
    if has_program_to_show(exercise):
        lines.append((get_message("check.ours"), get_message("check.show", name=exercise.name)))
    return lines


def has_program_to_show(exercise: Exercise) -> bool:
    """Whether `show` has a program to compare with; students do not have all of them."""
    shown = exercise.shown or exercise.source
    return exercise.source is not None and not (IN_THE_KIT and is_withheld(shown))


def case_lines(exercise: Exercise, failure: JudgedCase, printed: str) -> list[tuple[str, str]]:
    """The call that failed, its outcome, and the right answer."""
    shown = exercise.case_at_fault(failure.case, failure.outcome).given
    given = [f"{name} = {as_code(value)}" for name, value in shown.items()]
    lines = [(get_message("check.contract"), exercise.contract)] if exercise.contract else []
    call = f"{exercise.name}({', '.join(failure.case.given)})"
    lines.append((get_message("check.call"), "\n".join([*given, call])))
    lines.append((get_message("check.yours"), outcome_message(exercise, failure)))
    if printed:
        lines.append((get_message("check.printed"), printed))
    lines.append((get_message("check.wanted"), failure.verdict.wanted))
    if isinstance(failure.outcome, Raised | Late) and failure.outcome.lines:
        lines.append((get_message("check.where"), "\n".join(failure.outcome.lines)))
    return lines


def outcome_message(exercise: Exercise, failure: JudgedCase) -> str:
    """Description of the outcome of a call."""
    outcome = failure.outcome
    if isinstance(outcome, Answer):
        return exercise.describe_answer(failure.case, outcome.value)
    if isinstance(outcome, Misshapen):
        return outcome.message
    if isinstance(outcome, Changed):
        return get_message("check.changed", names=", ".join(outcome.names))
    if isinstance(outcome, Raised):
        kind = outcome.kinds[0] if outcome.kinds else ""
        return get_message("check.raised", kind=kind, message=outcome.message)
    return late_message(outcome)


def late_message(late: Late) -> str:
    """Message for a program without an answer: the computing time it used and was allowed."""
    key = "late" if late.used > late.allowed else "late_waiting" if late.allowed else "late_unknown"
    seconds = {"used": late.used, "allowed": late.allowed, "passed": late.passed}
    message = get_message(
        f"check.{key}", **{name: f"{value:.1f}" for name, value in seconds.items()}
    )
    return (
        f"{message} {get_message('check.still_running' if late.left_running else 'check.stopped')}"
    )


def as_code(value: object) -> str:
    """Write a value as a line of Python that a student can copy.

    >>> as_code(np.array([[0.0, 0.5], [2.0, 1.0]])), as_code(2.0), as_code(np.empty((0, 2)))
    ('np.array([(0.0, 0.5), (2.0, 1.0)])', '2.0', 'np.empty((0, 2))')
    """
    if isinstance(value, np.ndarray) and value.ndim > 1 and not value.size:
        return f"np.empty({value.shape})"
    if isinstance(value, np.ndarray) and value.ndim == 2:
        return f"np.array([{', '.join(str(tuple(row)) for row in value.tolist())}])"
    if isinstance(value, np.ndarray):
        return f"np.array({value.tolist()})"
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(as_code, value))}]"
    return repr(value)


def format_entry(title: str, text: str) -> str:
    """Format a title and its text; text of several lines is indented below the title."""
    if "\n" in text:
        text = "\n    " + text.replace("\n", "\n    ")
    return f"{title}: {text}" if title else text


def rule_message(exercise: Exercise, failure: JudgedCase) -> str:
    """Message for the rule that was broken."""
    return exercise.message(f"rules.{failure.verdict.rule}")


def hint_message(exercise: Exercise, failure: JudgedCase, advice: str = "") -> str:
    """Hint for the misconception that was recognised, for the Python error, or for the rule.

    An exercise may have its own hint for a Python error, in its table `advice`.
    """
    advice = advice or find_advice(failure.outcome)
    has_own_hint = failure.slip or exercise.table_with("hints.raised") != exercise.shared[-1]
    if failure.verdict.rule == "raised" and not has_own_hint and raises_itself(failure.outcome):
        advice = "own_error"
    if advice:
        own = exercise.table_with(f"advice.{advice}")
        return get_message(f"{own}.advice.{advice}" if own else f"advice.{advice}")
    if is_excess(failure.outcome):
        own_late = exercise.table_with("hints.late") != exercise.shared[-1]
        return exercise.message("hints.late" if own_late else "hints.judging")
    if is_idle(failure.outcome):
        return get_message("advice.try_again")
    key = f"slips.{failure.slip}" if failure.slip else f"hints.{failure.verdict.rule}"
    if not exercise.table_with(key):
        key = f"hints.{failure.case.kind}"
    if is_slow(failure.outcome) and exercise.table_with(key) == exercise.shared[-1]:
        return get_message("advice.slow")
    return exercise.message(key)


def is_slow(outcome: Outcome) -> bool:
    """Whether a program was late and the lines where it spent its time are unknown."""
    return isinstance(outcome, Late) and not outcome.lines


def is_idle(outcome: Outcome) -> bool:
    """Whether a program was late, but computed next to nothing: the computer may be busy."""
    return isinstance(outcome, Late) and outcome.used < IDLE_SHARE * outcome.allowed


def advance_stage(report: Report) -> int:
    """Record a failure and return the stage of feedback that the student has reached.

    Each different failure of an exercise adds one stage.
    """
    if report.failure is None:
        return ALL
    tries = TRIES.setdefault(report.exercise.name, [])
    outcome = report.failure.outcome
    outcome_key = "Late" if isinstance(outcome, Late) else repr(outcome)  # times vary
    failure = hash((outcome_key, report.failed, repr(report.failure.case)))
    if failure not in tries:
        tries.append(failure)
    return min(len(tries), ALL)


def draw_failure(exercise: Exercise, failure: JudgedCase) -> bytes:
    """Draw the failing case as a PNG."""
    from ..figures.plane import plane_figure

    figure, ax = plane_figure()
    exercise.draw(failure.case, failure.outcome, ax)
    stream = io.BytesIO()
    figure.savefig(stream, format="png", dpi=2 * DPI)
    return stream.getvalue()


def fold_line(line: str, to_html: Callable[[str], str]) -> str:
    """HTML of a line; a very long line shows its beginning and expands on a click."""
    if len(line) <= LONG_LINE:
        return to_html(line)
    return (
        f"<details style='display:inline-block'><summary>{to_html(line[:SHOWN_LETTERS])} "
        f"…</summary>{to_html(line)}</details>"
    )


def html_entry(title: str, text: str) -> str:
    """HTML of one entry of the feedback; the student's own words stay as they are."""
    code_titles = [get_message(f"check.{key}") for key in ("call", "yours", "where", "printed")]
    tag, to_html = ("code", escape) if title in code_titles else ("span", with_code)
    body = "<br>".join(fold_line(line, to_html) for line in text.splitlines())
    if not title:
        return f"<p style='margin:0 0 .4em'><b>{body}</b></p>"
    return (
        "<div style='display:flex;gap:.8em;margin:.15em 0'>"
        f"<span style='flex:0 0 9em;opacity:.75'>{escape(title)}</span>"
        f"<{tag} style='flex:1;white-space:pre-wrap;overflow-wrap:anywhere'>{body}</{tag}></div>"
    )


BOX = (
    "border-left:6px solid {colour};padding:.5em 1em;max-width:60em;line-height:1.45;font-size:14px"
)
DPI = 72  # of a picture as it is shown; it is stored with twice the pixels, so that it is sharp
WIDTH = 7 * DPI  # pixels
STYLE: dict[str, Any] = {
    "right": BOX.format(colour="#007A5E"),
    "wrong": BOX.format(colour="#A84300"),
    "unanswered": BOX.format(colour="#9CA3AF"),
}

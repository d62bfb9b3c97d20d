"""The instructor's overview of a class: GRADES/report.html."""

from collections import Counter
from collections.abc import Iterable, Iterator
from html import escape
from urllib.parse import quote

from ...course.lessons import EXERCISES, find
from ...figures import palette
from ...messages import get_message
from ...support.csv_cells import number
from ..judge.class_list import Class, read_record
from ..judge.submission import UNANSWERED
from .failures import describe_kind
from .feedback_page import add_name, name_page
from .pages import breakable, heading, page, paragraph, table
from .rows import DECIDED, NOT_GRADED, UNREADABLE, Row, Total, sum_totals

TENTHS = 10


def render_report(of: Class, rows: list[Row]) -> str:
    """The page: the distribution of totals, questions, misconceptions, students and decisions.

    It also lists the submissions that were not graded.
    """
    found = {whose: total for whose, total in sum_totals(rows).items() if whose[1]}
    names = sorted({assignment for _, assignment in found})
    bad = {row[:2] for row in rows if row.status in (UNREADABLE, NOT_GRADED)}
    counts = {"students": len({row.student for row in rows}), "submissions": len(of.entries)}
    graded = sum((entry.student, entry.assignment) not in bad for entry in of.entries)
    late = sum(entry.late for entry in of.entries)
    about = get_message("grades.report.summary", **counts, graded=graded) + describe_late(late)
    body = [paragraph(about)]
    body += list_not_graded(of, rows)
    for name in names:
        its = [total for (_, assignment), total in found.items() if assignment == name]
        body += draw_histogram(name, its)
    body += tabulate_questions(rows)
    body += tabulate_kinds(of)
    body += tabulate_mistakes(of)
    body += tabulate_students(of, found, names)
    body += tabulate_decisions(rows)
    return page(get_message("grades.report.title"), body)


def describe_late(count: int) -> str:
    """The number of late submissions in words, or "" if there are none."""
    return " " + get_message("grades.report.late", count=count) if count else ""


def list_not_graded(of: Class, rows: list[Row]) -> Iterator[str]:
    """Yield a table of the submissions without scores, with the reasons."""
    troubled = {row[:2]: row for row in rows if row.status in (UNREADABLE, NOT_GRADED)}
    found = [
        (entry, troubled[entry.student, entry.assignment])
        for entry in of.entries
        if (entry.student, entry.assignment) in troubled
    ]
    if found:
        yield heading(get_message("grades.report.not_graded"))
        head = [get_message(f"grades.report.{key}") for key in ("student", "file", "reason")]
        reasons = [
            (entry.student, entry.file, f"{row.status}: {entry.trouble or row.message}")
            for entry, row in found
        ]
        yield table(head, [map(breakable, reason) for reason in reasons])


def draw_histogram(name: str, found: list[Total]) -> Iterator[str]:
    """Yield a histogram of an assignment's totals, by tenths of its points.

    It counts students who have at least one score.
    """
    shares = [
        total.score / (total.max_score or 1.0) for total in found if total.waiting < total.questions
    ]
    counts = Counter(min(TENTHS - 1, int(TENTHS * share + 1e-9)) for share in shares)
    yield heading(f"{name}: {get_message('grades.report.histogram')}")
    if shares:
        yield paragraph(describe_spread([100.0 * share for share in shares]))
    yield draw_bars([counts[tenth] for tenth in range(TENTHS)], name)


def describe_spread(percents: list[float]) -> str:
    """The median, the quartiles and the extremes of totals, in percent of the points.

    >>> describe_spread([0.0, 50.0, 100.0])
    'Median 50 %; half of the students have 25 to 75 %, all have 0 to 100 %.'
    """
    ordered = sorted(percents)
    low, median, high = (find_quantile(ordered, share) for share in (0.25, 0.5, 0.75))
    found = {"least": ordered[0], "low": low, "median": median, "high": high, "most": ordered[-1]}
    texts = {name: f"{value:.0f}" for name, value in found.items()}
    return get_message("grades.report.spread", **texts)


def find_quantile(ordered: list[float], share: float) -> float:
    """The quantile of ordered numbers, linear between two of them.

    >>> find_quantile([0.0, 1.0, 4.0], 0.75)
    2.5
    """
    place = share * (len(ordered) - 1)
    below = int(place)
    above = min(below + 1, len(ordered) - 1)
    return ordered[below] + (place - below) * (ordered[above] - ordered[below])


def draw_bars(counts: list[int], name: str) -> str:
    """Bars with their numbers above them, as SVG."""
    wide, high, gap, top = 62, 150, 6, max([1, *counts])
    parts = []
    for at, count in enumerate(counts):
        tall, left = high * count / top, at * wide
        parts.append(
            f'<rect x="{left + gap / 2:g}" y="{30 + high - tall:g}" '
            f'width="{wide - gap}" height="{tall:g}" fill="{palette.TREE}"/>'
        )
        if count:
            middle, above = left + wide / 2, 24 + high - tall
            parts.append(f'<text x="{middle:g}" y="{above:g}" text-anchor="middle">{count}</text>')
    for tenth in range(0, TENTHS + 1, 2):
        x, anchor = tenth * wide, "start" if tenth == 0 else "end" if tenth == TENTHS else "middle"
        parts.append(f'<text x="{x}" y="{52 + high}" text-anchor="{anchor}">{10 * tenth} %</text>')
    full, ground = TENTHS * wide, 30 + high
    line = f'<line x1="0" x2="{full}" y1="{ground}" y2="{ground}" stroke="{palette.INK}"/>'
    listed = ", ".join(map(str, counts))
    alt = escape(get_message("grades.report.histogram_alt", assignment=name, counts=listed))
    return (
        f'<svg role="img" aria-label="{alt}" viewBox="0 0 {full} {62 + high}" width="{full}" '
        f'font-size="16" fill="{palette.INK}">{"".join(parts)}{line}</svg>'
    )


def tabulate_questions(rows: list[Row]) -> Iterator[str]:
    """Yield a table of the questions: how many answered, had full points, and the spread.

    Only questions with a score are counted.
    """
    yield heading(get_message("grades.report.questions"))
    head = [
        get_message(f"grades.report.{key}")
        for key in ("assignment", "question", "answered", "full", "mean", "median", "quartiles")
    ]
    scored = [row for row in rows if row.score is not None and row.max_score]
    of_question: dict[tuple[str, str], list[Row]] = {}
    for row in sorted(scored, key=lambda row: row.assignment):
        of_question.setdefault((row.assignment, row.question), []).append(row)
    lines = []
    for (assignment, question), its in of_question.items():
        shares = [(row.score or 0.0) / row.max_score for row in its]
        answered = sum(row.status != UNANSWERED for row in its)
        full, mean = sum(share >= 1.0 for share in shares) / len(shares), sum(shares) / len(shares)
        names = [breakable(assignment), breakable(question)]
        low, median, high = (find_quantile(sorted(shares), at) for at in (0.25, 0.5, 0.75))
        numbers = [f"{answered} / {len(shares)}", f"{full:.0%}", f"{mean:.0%}", f"{median:.0%}"]
        lines.append([*names, *numbers, f"{low:.0%} - {high:.0%}"])
    yield table(head, lines, numbers=5)


def tabulate_kinds(of: Class) -> Iterator[str]:
    """Yield a table of the kinds of input: how many of the answers were right for each."""
    right, answers = Counter[tuple[str, str, str]](), Counter[tuple[str, str, str]]()
    for entry in of.entries:
        record = read_record(entry, of.out)
        for question in record["questions"] if record is not None else ():
            passed, failed = question.get("passed", []), question.get("kinds", [])
            whose = entry.assignment, question["question"]
            answers.update((*whose, kind) for kind in order_kinds(whose[1], {*passed, *failed}))
            right.update((*whose, kind) for kind in passed)
    if answers:
        yield heading(get_message("grades.report.kinds"))
        yield paragraph(get_message("grades.report.kinds_about"), "quiet")
        head = [
            get_message(f"grades.report.{key}")
            for key in ("assignment", "question", "kind", "right")
        ]
        lines = [
            [
                *map(breakable, (assignment, question, describe_kind(question, kind))),
                f"{right[assignment, question, kind]} / {count}",
            ]
            for (assignment, question, kind), count in answers.items()
        ]
        yield table(head, lines, numbers=1)


def order_kinds(question: str, kinds: set[str]) -> list[str]:
    """Kinds in the order of the exercise; others, of an earlier course, at the end."""
    now = EXERCISES[question].kinds if question in EXERCISES else ()
    return [*(kind for kind in now if kind in kinds), *sorted(kinds - set(now))]


def tabulate_mistakes(of: Class) -> Iterator[str]:
    """Yield a table of the rules broken first and the misconceptions, with their counts."""
    counts: Counter[tuple[str, str]] = Counter()
    for entry in of.entries:
        record = read_record(entry, of.out)
        for question in record["questions"] if record is not None else ():
            if question.get("reason"):
                counts[question["question"], question["reason"]] += 1
    yield heading(get_message("grades.report.mistakes"))
    if not counts:
        yield paragraph(get_message("grades.report.nothing"))
        return
    yield paragraph(get_message("grades.report.mistakes_about"), "quiet")
    head = [get_message(f"grades.report.{key}") for key in ("question", "mistake", "count")]
    often = sorted(counts.items(), key=lambda item: (-item[1], item[0]))
    lines = [
        [breakable(name), breakable(describe_reason(name, reason)), str(count)]
        for (name, reason), count in often
    ]
    yield table(head, lines, numbers=1)


def describe_reason(question: str, reason: str) -> str:
    """The text of a rule or a misconception, or its key if the course has changed since."""
    try:
        return find(question).message(reason)
    except (KeyError, ValueError):
        return reason


def tabulate_students(
    of: Class, found: dict[tuple[str, str], Total], names: list[str]
) -> Iterator[str]:
    """Yield a table of the students with links to their pages.

    Late submissions are marked, and so are those that could not be read; there is a column for
    files of no known assignment.
    """
    yield heading(get_message("grades.report.students"))
    entries = {(entry.student, entry.assignment): entry for entry in of.entries}
    called = {entry.student: entry.name for entry in of.entries}
    columns = [*names, *([""] if any(not entry.assignment for entry in of.entries) else [])]
    lines = []
    for student in sorted(called):
        line = [breakable(add_name(student, called[student]))]
        for name in columns:
            entry = entries.get((student, name))
            if entry is None:
                line.append("")
                continue
            record = read_record(entry, of.out)
            marks = [get_message("grades.late_mark")] if entry.late else []
            if not entry.key or (record is not None and record["status"] == UNREADABLE):
                marks.append(get_message("grades.unreadable_mark"))
            text = describe_total(found[student, name]) if name else ""
            link = f'<a href="{quote(name_page(student, name))}">{text or marks.pop()}</a>'
            line.append(" ".join([link, *marks]))
        lines.append(line)
    head = [name or get_message("grades.unknown") for name in columns]
    yield table([get_message("grades.report.student"), *head], lines, numbers=len(columns))


def describe_total(total: Total) -> str:
    """A total as a cell; it shows no score, rather than zero, if no question has a score."""
    if total.waiting == total.questions:
        return get_message("grades.report.all_open", most=number(total.max_score))
    score = f"{number(total.score)} / {number(total.max_score)}"
    return (
        get_message("grades.report.open", score=score, waiting=total.waiting)
        if total.waiting
        else score
    )


def tabulate_decisions(rows: Iterable[Row]) -> Iterator[str]:
    """Yield a table of the scores and comments that people gave."""
    found = [row for row in rows if row.status == DECIDED or row.comment]
    if found:
        yield heading(get_message("grades.report.decisions"))
        head = [
            get_message(f"grades.report.{key}")
            for key in ("student", "question", "reason", "score")
        ]
        lines = [
            [*map(breakable, (row.student, row.question, row.message)), number(row.score)]
            for row in found
        ]
        yield table(head, lines, numbers=1)

"""The class at a glance, for the instructor: GRADES/report.html."""

from collections import Counter
from collections.abc import Iterable, Iterator
from html import escape
from itertools import groupby
from urllib.parse import quote

from ...course.lessons import find
from ...figures import palette
from ...messages import get_message
from ...support.csv_cells import number
from ..judge.class_list import Class, record_of
from .feedback_page import page_name
from .pages import breakable, heading, page, paragraph, table
from .rows import DECIDED, NOT_GRADED, UNREADABLE, Row, Total, totals

TENTHS = 10


def report_page(of: Class, rows: list[Row]) -> str:
    """The page: students and assignments, how totals are spread, questions, misconceptions,
    decisions, and what was not graded.
    """
    found = {whose: total for whose, total in totals(rows).items() if whose[1]}
    names = sorted({assignment for _, assignment in found})
    bad = {row[:2] for row in rows if row.status in (UNREADABLE, NOT_GRADED)}
    counts = {"students": len({row.student for row in rows}), "submissions": len(of.entries)}
    graded = sum((entry.student, entry.assignment) not in bad for entry in of.entries)
    late = {(entry.student, entry.assignment) for entry in of.entries if entry.late}
    body = [
        paragraph(
            get_message("grades.report.summary", **counts, graded=graded) + late_words(len(late))
        )
    ]
    body += not_graded(of, rows)
    for name in names:
        body += spread(
            name, [total for (_, assignment), total in found.items() if assignment == name]
        )
    body += questions(rows)
    body += mistakes(of)
    body += students(found, names, late)
    body += decisions(rows)
    return page(get_message("grades.report.title"), body)


def late_words(count: int) -> str:
    """How many were late, where any were."""
    return " " + get_message("grades.report.late", count=count) if count else ""


def not_graded(of: Class, rows: list[Row]) -> Iterator[str]:
    """Each submission without scores, by name and with the reason."""
    said = {row[:2]: row for row in rows if row.status in (UNREADABLE, NOT_GRADED)}
    found = [
        (entry, said[entry.student, entry.assignment])
        for entry in of.entries
        if (entry.student, entry.assignment) in said
    ]
    if found:
        yield heading(get_message("grades.report.not_graded"))
        head = [get_message(f"grades.report.{key}") for key in ("student", "file", "reason")]
        reasons = [
            (entry.student, entry.file, f"{row.status}: {entry.trouble or row.message}")
            for entry, row in found
        ]
        yield table(head, [map(breakable, reason) for reason in reasons])


def spread(name: str, found: list[Total]) -> Iterator[str]:
    """A histogram of the totals of an assignment, by tenths of its points; of those with any
    score.
    """
    shares = [
        total.score / (total.max_score or 1.0) for total in found if total.waiting < total.questions
    ]
    counts = Counter(min(TENTHS - 1, int(TENTHS * share + 1e-9)) for share in shares)
    yield heading(f"{name}: {get_message('grades.report.histogram')}")
    yield bars([counts[tenth] for tenth in range(TENTHS)], name)


def bars(counts: list[int], name: str) -> str:
    """Bars with their numbers above them, as SVG."""
    wide, high, gap, top = 62, 150, 6, max([1, *counts])
    parts = []
    for at, count in enumerate(counts):
        tall, left = high * count / top, at * wide
        parts.append(
            f'<rect x="{left + gap / 2:g}" y="{30 + high - tall:g}" width="{wide - gap}" height="{tall:g}" fill="{palette.TREE}"/>'
        )
        if count:
            parts.append(
                f'<text x="{left + wide / 2:g}" y="{24 + high - tall:g}" text-anchor="middle">{count}</text>'
            )
    for tenth in range(0, TENTHS + 1, 2):
        x, anchor = tenth * wide, "start" if tenth == 0 else "end" if tenth == TENTHS else "middle"
        parts.append(f'<text x="{x}" y="{52 + high}" text-anchor="{anchor}">{10 * tenth} %</text>')
    line = f'<line x1="0" x2="{TENTHS * wide}" y1="{30 + high}" y2="{30 + high}" stroke="{palette.INK}"/>'
    alt = escape(
        get_message(
            "grades.report.histogram_alt", assignment=name, counts=", ".join(map(str, counts))
        )
    )
    return (
        f'<svg role="img" aria-label="{alt}" viewBox="0 0 {TENTHS * wide} {62 + high}" width="{TENTHS * wide}" '
        f'font-size="16" fill="{palette.INK}">{"".join(parts)}{line}</svg>'
    )


def questions(rows: list[Row]) -> Iterator[str]:
    """Of each question how many points were had on average, by how many all, and who answered at
    all; of what is scored.
    """
    yield heading(get_message("grades.report.questions"))
    head = [
        get_message(f"grades.report.{key}")
        for key in ("assignment", "question", "answered", "full", "mean")
    ]
    scored = sorted(
        (row for row in rows if row.score is not None and row.max_score),
        key=lambda row: row.assignment,
    )
    places = {
        whose: at
        for at, whose in reversed([*enumerate((row.assignment, row.question) for row in scored)])
    }
    lines = []
    for (assignment, question), group in groupby(
        sorted(scored, key=lambda row: places[row.assignment, row.question]),
        key=lambda row: (row.assignment, row.question),
    ):
        shares = [(row.score or 0.0) / row.max_score for row in group]
        answered = sum(
            row.status != "not answered"
            for row in scored
            if (row.assignment, row.question) == (assignment, question)
        )
        full, mean = sum(share >= 1.0 for share in shares) / len(shares), sum(shares) / len(shares)
        lines.append(
            [
                breakable(assignment),
                breakable(question),
                f"{answered} / {len(shares)}",
                f"{full:.0%}",
                f"{mean:.0%}",
            ]
        )
    yield table(head, lines, numbers=3)


def mistakes(of: Class) -> Iterator[str]:
    """How often each rule was broken first, and each misconception met."""
    met: Counter[tuple[str, str]] = Counter()
    for entry in of.entries:
        record = record_of(entry, of.out)
        for question in record["questions"] if record is not None else ():
            if question.get("reason"):
                met[question["question"], question["reason"]] += 1
    yield heading(get_message("grades.report.mistakes"))
    if not met:
        yield paragraph(get_message("grades.report.nothing"))
        return
    yield paragraph(get_message("grades.report.mistakes_about"), "quiet")
    head = [get_message(f"grades.report.{key}") for key in ("question", "mistake", "count")]
    often = sorted(met.items(), key=lambda item: (-item[1], item[0]))
    lines = [
        [breakable(name), breakable(words_of(name, reason)), str(count)]
        for (name, reason), count in often
    ]
    yield table(head, lines, numbers=1)


def words_of(question: str, reason: str) -> str:
    """A rule or a misconception in words; its key where the course has changed since."""
    try:
        return find(question).message(reason)
    except (KeyError, ValueError):
        return reason


def students(
    found: dict[tuple[str, str], Total], names: list[str], late: set[tuple[str, str]]
) -> Iterator[str]:
    """A line for each student, with links to their pages, and what was late."""
    yield heading(get_message("grades.report.students"))
    lines = []
    for student in sorted({student for student, _ in found}):
        line = [breakable(student)]
        for name in names:
            total, mark = (
                found.get((student, name)),
                " " + get_message("grades.late_mark") if (student, name) in late else "",
            )
            line.append(
                ""
                if total is None
                else f'<a href="{quote(page_name(student, name))}">{total_words(total)}</a>{mark}'
            )
        lines.append(line)
    yield table([get_message("grades.report.student"), *names], lines, numbers=len(names))


def total_words(total: Total) -> str:
    """A total as a cell; where nothing has a score it is none rather than zero."""
    if total.waiting == total.questions:
        return get_message("grades.report.all_open", most=number(total.max_score))
    score = f"{number(total.score)} / {number(total.max_score)}"
    return (
        get_message("grades.report.open", score=score, waiting=total.waiting)
        if total.waiting
        else score
    )


def decisions(rows: Iterable[Row]) -> Iterator[str]:
    """What people decided, and where they only said something, that."""
    found = [row for row in rows if row.status == DECIDED or row.comment]
    if found:
        yield heading(get_message("grades.report.decisions"))
        head = [
            get_message(f"grades.report.{key}")
            for key in ("student", "question", "reason", "score")
        ]
        yield table(
            head,
            [
                [*map(breakable, (row.student, row.question, row.message)), number(row.score)]
                for row in found
            ],
            1,
        )

"""Questions for Moodle: an XML file for its question bank, with a category for each lesson.

Moodle reads it under Question bank, Import, Moodle XML format.
"""

import os
from collections.abc import Iterable
from html import escape
from xml.etree.ElementTree import Element, SubElement

from ...support.whole_files import written_whole
from .asking import verdict
from .canvas import as_xml, title_of
from .question import Choice, Question, read_questions


def write_moodle(file: str | os.PathLike[str], lessons: Iterable[str]) -> int:
    """Write the questions of some lessons for Moodle's question bank.

    Returns
    -------
    int
        The number of questions.

    Raises
    ------
    InvalidParameter
        Where a lesson has no questions, or its answers are held back.
    """
    quizzes = {lesson: read_questions(lesson) for lesson in lessons}
    root = Element("quiz")
    for lesson, questions in quizzes.items():
        root.append(category(lesson))
        root.extend([as_moodle(lesson, question) for question in questions])
    with written_whole(file) as part:
        part.write_bytes(as_xml(root))
    return sum(map(len, quizzes.values()))


def category(lesson: str) -> Element:
    """The category to which the questions after it belong."""
    made = Element("question", {"type": "category"})
    add_text(made, "category", f"$course$/top/kinoedu/{title_of(lesson)}")
    return made


def as_moodle(lesson: str, question: Question) -> Element:
    """A question with its choices and a reason for each."""
    made = Element("question", {"type": "multichoice"})
    add_text(made, "name", question.name.replace("_", " ").capitalize())
    add_html(made, "questiontext", question.text)
    settings = {"defaultgrade": "1.0", "penalty": "0.3333333", "hidden": "0"}
    settings |= {"idnumber": f"kinoedu.{lesson}.{question.name}", "single": "true"}
    settings |= {"shuffleanswers": "true", "answernumbering": "abc"}
    for tag, value in settings.items():
        SubElement(made, tag).text = value
    right = question.right_choice
    made.extend([as_answer(question, choice, right) for choice in question.choices])
    return made


def as_answer(question: Question, choice: Choice, right: Choice) -> Element:
    """A choice with its share of the points, in percent, and its reason."""
    share = "100" if choice is right else "0"
    made = Element("answer", {"fraction": share, "format": "html"})
    SubElement(made, "text").text = f"<p>{escape(choice.text, quote=False)}</p>"
    add_html(made, "feedback", verdict(question, choice))
    return made


def add_text(parent: Element, tag: str, text: str) -> Element:
    """Add a field of plain text."""
    field = SubElement(parent, tag)
    SubElement(field, "text").text = text
    return field


def add_html(parent: Element, tag: str, text: str) -> None:
    """Add a field of HTML with one paragraph."""
    add_text(parent, tag, f"<p>{escape(text, quote=False)}</p>").set("format", "html")

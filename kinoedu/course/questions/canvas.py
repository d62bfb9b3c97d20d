"""Questions for Canvas: a zip with a quiz for each lesson, in the format QTI 1.2.

Canvas reads it under Settings, Import Course Content, QTI .zip file. The format is that of the IMS
QTI 1.2.1 specification, with the metadata that Canvas needs.
"""

import hashlib
import os
from collections.abc import Iterable
from html import escape
from xml.etree.ElementTree import Element, SubElement, indent, tostring

from ..release import Packed, write_zip
from .asking import verdict
from .question import Choice, Question, read_questions

QTI = "http://www.imsglobal.org/xsd/ims_qtiasiv1p2"
PACKAGE = "http://www.imsglobal.org/xsd/imsccv1p1/imscp_v1p1"


def write_canvas(zip_file: str | os.PathLike[str], lessons: Iterable[str]) -> int:
    """Write the questions of some lessons as quizzes for Canvas.

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
    files = [Packed("imsmanifest.xml", as_xml(manifest(quizzes)))]
    files += [
        Packed(place_of(lesson), as_xml(assessment(lesson, questions)))
        for lesson, questions in quizzes.items()
    ]
    write_zip(zip_file, files)
    return sum(map(len, quizzes.values()))


def identify(*names: str) -> str:
    """An identifier, the same for the same names: importing again replaces a quiz.

    >>> identify("01_geometry") == identify("01_geometry"), len(identify("a", "b"))
    (True, 33)
    """
    return "k" + hashlib.sha256("/".join(names).encode()).hexdigest()[:32]


def place_of(lesson: str) -> str:
    """Path of a lesson's quiz in the zip."""
    return f"{identify(lesson)}/{identify(lesson)}.xml"


def title_of(lesson: str) -> str:
    """Title of a lesson's quiz.

    >>> title_of("01_geometry")
    'Lesson 1: Geometry'
    """
    number, _, topic = lesson.partition("_")
    return f"Lesson {int(number)}: {topic.replace('_', ' ').capitalize()}"


def manifest(lessons: Iterable[str]) -> Element:
    """The list of the zip's files."""
    root = Element("manifest", {"identifier": identify("manifest", *lessons), "xmlns": PACKAGE})
    metadata = SubElement(root, "metadata")
    SubElement(metadata, "schema").text = "IMS Content"
    SubElement(metadata, "schemaversion").text = "1.1.3"
    SubElement(root, "organizations")
    resources = SubElement(root, "resources")
    for lesson in lessons:
        kind = {"identifier": identify(lesson), "type": "imsqti_xmlv1p2"}
        SubElement(SubElement(resources, "resource", kind), "file", {"href": place_of(lesson)})
    return root


def assessment(lesson: str, questions: Iterable[Question]) -> Element:
    """A quiz with the questions of a lesson."""
    root = Element("questestinterop", {"xmlns": QTI})
    quiz = SubElement(root, "assessment", {"ident": identify(lesson), "title": title_of(lesson)})
    add_fields(quiz, {"cc_maxattempts": "1"})
    section = SubElement(quiz, "section", {"ident": "root_section"})
    for question in questions:
        section.append(item(lesson, question))
    return root


def item(lesson: str, question: Question) -> Element:
    """A question with its choices, the right one, and a reason for each."""
    idents = {
        choice.letter: identify(lesson, question.name, choice.letter) for choice in question.choices
    }
    ident = identify(lesson, question.name)
    made = Element("item", {"ident": ident, "title": question.name.replace("_", " ").capitalize()})
    fields = {"question_type": "multiple_choice_question", "points_possible": "1.0"}
    fields["original_answer_ids"] = ",".join(idents.values())
    fields["assessment_question_identifierref"] = identify(ident)
    add_fields(SubElement(made, "itemmetadata"), fields)
    presentation = SubElement(made, "presentation")
    add_text(presentation, question.text)
    lid = {"ident": "response1", "rcardinality": "Single"}
    choices = SubElement(SubElement(presentation, "response_lid", lid), "render_choice")
    for choice in question.choices:
        add_text(
            SubElement(choices, "response_label", {"ident": idents[choice.letter]}), choice.text
        )
    made.append(scoring(idents, question.right_choice))
    for choice in question.choices:
        feedback = SubElement(made, "itemfeedback", {"ident": f"{idents[choice.letter]}_fb"})
        add_text(SubElement(feedback, "flow_mat"), verdict(question, choice))
    return made


def scoring(idents: dict[str, str], right: Choice) -> Element:
    """Each choice shows its reason; the right one gives all points."""
    processing = Element("resprocessing")
    points = {"maxvalue": "100", "minvalue": "0", "varname": "SCORE", "vartype": "Decimal"}
    SubElement(SubElement(processing, "outcomes"), "decvar", points)
    for ident in idents.values():
        shown = add_condition(processing, ident, "Yes")
        SubElement(
            shown, "displayfeedback", {"feedbacktype": "Response", "linkrefid": f"{ident}_fb"}
        )
    scored = add_condition(processing, idents[right.letter], "No")
    SubElement(scored, "setvar", {"action": "Set", "varname": "SCORE"}).text = "100"
    return processing


def add_condition(processing: Element, ident: str, goes_on: str) -> Element:
    """Add what happens if a choice was made."""
    condition = SubElement(processing, "respcondition", {"continue": goes_on})
    chosen = SubElement(
        SubElement(condition, "conditionvar"), "varequal", {"respident": "response1"}
    )
    chosen.text = ident
    return condition


def add_fields(parent: Element, fields: dict[str, str]) -> None:
    """Add metadata."""
    metadata = SubElement(parent, "qtimetadata")
    for label, entry in fields.items():
        field = SubElement(metadata, "qtimetadatafield")
        SubElement(field, "fieldlabel").text = label
        SubElement(field, "fieldentry").text = entry


def add_text(parent: Element, text: str) -> None:
    """Add a text, which Canvas shows as HTML."""
    mattext = SubElement(SubElement(parent, "material"), "mattext", {"texttype": "text/html"})
    mattext.text = f"<p>{escape(text, quote=False)}</p>"


def as_xml(root: Element) -> bytes:
    """An XML file."""
    indent(root)
    return tostring(root, encoding="utf-8", xml_declaration=True)

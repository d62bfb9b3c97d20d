"""`ask("01_geometry")`: the concept questions of a lesson, in the notebook."""

from html import escape

from ...messages import get_message
from .question import Choice, Question, read_questions

ASKED = "kinoedu-questions"  # in the HTML of questions


class Questions:
    """The questions of a lesson, which a notebook displays.

    Each choice opens, by a click or by the Enter key, and says whether it is right and why. No
    kernel is needed for that, so it works on a page too.
    """

    def __init__(self, lesson: str, questions: tuple[Question, ...]) -> None:
        self.lesson = lesson
        self.questions = questions

    def __repr__(self) -> str:
        return "\n\n".join(
            "\n".join([f"{n}. {one.text}", *(f"   {c.letter}) {c.text}" for c in one.choices)])
            for n, one in enumerate(self.questions, 1)
        )

    def _repr_html_(self) -> str:
        """The questions as a list, in which each choice opens."""
        items = "".join(f"<li>{question_html(one)}</li>" for one in self.questions)
        held = any(not one.right for one in self.questions)
        note = get_message("questions.held_back" if held else "questions.open_one")
        return f"<div class='{ASKED}'><p><i>{escape(note)}</i></p><ol>{items}</ol></div>"


def ask(lesson: str) -> Questions:
    """Ask the concept questions of a lesson.

    Parameters
    ----------
    lesson : name of the lesson's notebook, such as "01_geometry".

    Returns
    -------
    Questions
        A notebook displays them; each choice opens and says why it is right or wrong.

    Raises
    ------
    InvalidParameter
        Where there is no such lesson.

    Examples
    --------
    >>> print(repr(ask("04_graph_search"))[:15])
    1. Three towns.
    """
    return Questions(lesson, read_questions(lesson))


def question_html(question: Question) -> str:
    """A question, and its choices in a group of which one is open at a time."""
    choices = "".join(choice_html(question, choice) for choice in question.choices)
    return f"<p>{escape(question.text)}</p>{choices}"


def choice_html(question: Question, choice: Choice) -> str:
    """A choice; where the answers are not held back, it opens."""
    text = f"{choice.letter}) {escape(choice.text)}"
    if not question.right:
        return f"<p>{text}</p>"
    return (
        f"<details name='{question.name}'><summary>{text}</summary>"
        f"<p>{escape(verdict(question, choice))}</p></details>"
    )


def verdict(question: Question, choice: Choice) -> str:
    """Whether a choice is right, and why."""
    key = "questions.right" if choice.letter == question.right else "questions.wrong"
    return get_message(key, why=choice.why)

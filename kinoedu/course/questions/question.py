"""Read concept questions from their files."""

import os
import re
import tomllib
from pathlib import Path
from typing import Any, NamedTuple

from ...errors import InvalidParameter
from ...messages import get_message

HERE = Path(__file__).parent
ANSWER = re.compile(r"^(?:right|why\.\w+|slip\.\w+) *=.*\n", re.MULTILINE)


class Choice(NamedTuple):
    """One choice of a question.

    Attributes
    ----------
    letter : its letter, from "a".
    text : what it says.
    why : why it is right or wrong; "" where the answers are held back.
    slip : the misconception behind it, as EXERCISE.SLIP, or "".
    """

    letter: str
    text: str
    why: str
    slip: str


class Question(NamedTuple):
    """A question with its choices.

    Attributes
    ----------
    name : unique in the course.
    text : the question.
    choices : in the order in which they are asked.
    right : letter of the right choice; "" where the answers are held back.
    """

    name: str
    text: str
    choices: tuple[Choice, ...]
    right: str

    @property
    def right_choice(self) -> Choice:
        """The choice that is right. Raises InvalidParameter where answers are held back."""
        if not self.right:
            raise InvalidParameter(get_message("questions.held_back"))
        return next(choice for choice in self.choices if choice.letter == self.right)


def lessons_with_questions() -> list[str]:
    """Names of the lessons that have questions, in order, such as 01_geometry."""
    return sorted(file.stem for file in (HERE / "en").glob("*.toml"))


def read_questions(lesson: str) -> tuple[Question, ...]:
    """Read the questions of a lesson, in the language of the course.

    Raises
    ------
    InvalidParameter
        Where the lesson has no questions, or its file has a mistake; the message names it.

    Examples
    --------
    >>> first = read_questions("01_geometry")[0]
    >>> first.name, first.right_choice.text
    ('segment_or_line', '5')
    """
    lessons = lessons_with_questions()
    if lesson not in lessons:
        raise InvalidParameter(
            get_message("questions.unknown", lesson=repr(lesson), names=", ".join(lessons))
        )
    language = os.environ.get("KINOEDU_LANGUAGE", "en")
    own = HERE / language / f"{lesson}.toml"
    file = own if language.isalpha() and own.is_file() else HERE / "en" / f"{lesson}.toml"
    return parse_questions(file.read_text(encoding="utf-8"), file.name)


def parse_questions(text: str, file: str) -> tuple[Question, ...]:
    """The questions of a file. Raises InvalidParameter where it has a mistake."""
    try:
        tables = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise InvalidParameter(f"{file} is not TOML: {error}") from None
    return tuple(parse_question(name, table, file) for name, table in tables.items())


def parse_question(name: str, table: Any, file: str) -> Question:
    """One question of a file. Raises InvalidParameter where something is missing."""
    table = table if isinstance(table, dict) else {}
    choices, why, slip = (table.get(key, {}) for key in ("choices", "why", "slip"))
    right = table.get("right", "")
    if not isinstance(table.get("question"), str) or len(choices) < 2:
        raise InvalidParameter(f"{file}: [{name}] needs a question and at least two choices")
    if (right or why) and right not in choices:
        raise InvalidParameter(
            f"{file}: [{name}] right is {right!r}, which is none of {', '.join(choices)}"
        )
    if right and set(why) != set(choices):
        odd = ", ".join(sorted(set(why) ^ set(choices)))
        raise InvalidParameter(f"{file}: [{name}] needs one reason for each choice; see {odd}")
    made = (Choice(a, text, why.get(a, ""), slip.get(a, "")) for a, text in choices.items())
    return Question(name, table["question"], tuple(made), right)


def hold_back(text: str) -> str:
    """The text of a file of questions without answers and reasons.

    >>> hold_back('[q]\\nquestion = "?"\\nright = "a"\\nchoices.a = "1"\\nwhy.a = "So."\\n')
    '[q]\\nquestion = "?"\\nchoices.a = "1"\\n'
    """
    return ANSWER.sub("", text)

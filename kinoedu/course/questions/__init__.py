"""Concept questions: five for each lesson, each with a reason for every choice.

A file in `en` holds the questions of a lesson:

    [name_of_the_question]
    question = "What is asked."
    right = "b"                         # the letter of the right choice
    choices.a = "A wrong answer."
    why.a = "Why it is wrong, in words that help."
    slip.a = "halton.from_zero"         # if an exercise knows this mistake: EXERCISE.SLIP
    choices.b = "The right answer."
    why.b = "Why it is right."

Texts are plain: no markup, formulas in Unicode. A translation is a folder beside `en`, such as
`de`; lessons that it lacks are asked in English. `right`, `why` and `slip` have a line of their own
each, since a kit for students may leave them out (`hold_back`).
"""

from .asking import Questions, ask
from .question import Choice, Question, hold_back, lessons_with_questions, read_questions

__all__ = [
    "Choice",
    "Question",
    "Questions",
    "ask",
    "hold_back",
    "lessons_with_questions",
    "read_questions",
]

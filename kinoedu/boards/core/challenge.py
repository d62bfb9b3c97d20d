"""Challenges: goals that a board recognises while one drags, and answers in words."""

from __future__ import annotations

import logging
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

from ...errors import InvalidParameter, KinoeduError
from ...messages import get_message
from ...support.json_fields import JsonObject
from ...support.text import shortened

log = logging.getLogger("kinoedu")

REACHED = "reached"
Answer = tuple[str, JsonObject]  # "reached" or another word for the present state, and its numbers
Judge = Callable[[Any, dict[str, Any]], Answer]
AnyBoard = TypeVar("AnyBoard")


@dataclass(frozen=True)
class Challenge:
    """A goal, and the function that recognises it.

    Attributes
    ----------
    sentence : what is to be done.
    judge : takes the board as it is now and a dict in which it may keep what was before. Returns
        whether the goal is reached, and why, in words.
    """

    sentence: str
    judge: Callable[[Any, dict[str, Any]], tuple[bool, str]]


def posed(judge: Judge) -> Challenge:
    """The challenge of a judge whose words are in the catalogue, under the judge's name.

    The judge returns the key of a message, "reached" where the goal is reached, and its values.
    """
    key = f"challenge.{judge.__name__}"

    def judged(board: Any, kept: dict[str, Any]) -> tuple[bool, str]:
        word, values = judge(board, kept)
        return word == REACHED, get_message(f"{key}.{word}", **values)

    judged.__wrapped__ = judge  # type: ignore[attr-defined]  # the source that `show` shows
    return Challenge(get_message(f"{key}.sentence"), judged)


def challenge(board: AnyBoard, *challenges: Challenge) -> AnyBoard:
    """Pose challenges on a board, which answers them below its picture while one drags.

    Parameters
    ----------
    board : any board with a canvas.
    challenges : of `kinoedu.boards.challenges`, or your own.

    Returns
    -------
    the board

    Raises
    ------
    InvalidParameter

    Examples
    --------
    >>> from kinoedu.boards import Challenge, challenge, samples_board
    >>> few = Challenge("Have at most ten.", lambda board, kept: (board.n.value <= 10, "counted"))
    >>> challenge(samples_board("halton", 8), few).canvas.challenges.answers
    [{'sentence': 'Have at most ten.', 'now': True, 'done': True, 'text': 'counted'}]
    """
    canvas: Any = getattr(board, "canvas", board)
    wrong = [one for one in challenges if not isinstance(one, Challenge)]
    if wrong or not hasattr(canvas, "challenges"):
        raise InvalidParameter(
            "challenge takes a board with a canvas and Challenges, got "
            f"{shortened((board, *challenges))}"
        )
    canvas.challenges = Posed(board, challenges)
    canvas.refresh()
    return board


class Posed:
    """Challenges on a board; `answers` are the newest answers."""

    def __init__(self, board: Any, challenges: Sequence[Challenge]) -> None:
        self._board, self._challenges = board, challenges
        self._kept: list[dict[str, Any]] = [{} for _ in challenges]
        self._done = [False] * len(challenges)
        self.answers: list[JsonObject] = []

    def judge(self) -> None:
        """Judge the board as it is now; a goal that was reached once stays done."""
        self.answers = answers = list[JsonObject]()
        for number, one in enumerate(self._challenges):
            now, text = judge_one(one, self._board, self._kept[number])
            if self.answers is not answers:  # the judge asked for the whole: all were judged by it
                return
            self._done[number] |= now
            state = {"now": now, "done": self._done[number]}
            answers.append({"sentence": one.sentence, **state, "text": text})


def judge_one(one: Challenge, board: Any, kept: dict[str, Any]) -> tuple[bool, str]:
    """Whether a goal is reached, and the answer in words; an error of the judge is logged."""
    try:
        now, text = one.judge(board, kept)
    except KinoeduError as error:
        return False, str(error)
    except Exception as error:
        log.exception("a challenge could not be judged")
        words = f"{type(error).__name__}: {error}"
        return False, get_message("board.failed", error=words)
    return bool(now), str(text)

"""What went wrong in a reader's function, in words."""

import linecache
import sysconfig
from pathlib import Path
from traceback import walk_tb

from ..messages import get_message
from .time_limit import TimeUp

PACKAGE = Path(__file__).resolve().parent.parent
PYTHON = Path(sysconfig.get_path("stdlib"))


def describe_timeout(over: TimeUp, who: str) -> str:
    """A message why a function was stopped: the time it used and the time allowed."""
    why = "time_up" if over.used > over.allowed else "waited"
    seconds = {"used": over.used, "allowed": over.allowed, "passed": over.passed}
    message = get_message(
        f"board.own.{why}", who=who, **{name: f"{value:.1f}" for name, value in seconds.items()}
    )
    ending = "board.own.left_running" if over.left_running else "board.own.stopped"
    return f"{message} {get_message(ending)}"


def describe_exception(error: BaseException, who: str) -> str:
    """An exception that someone's function raised, in words.

    It has the reader's own line, and none of the package's.
    """
    name = type(error).__name__
    text = f"{name}: {shorten_message(error)}" if str(error) else name
    frames = [(frame.f_code.co_filename, line) for frame, line in walk_tb(error.__traceback__)]
    own = [(file, line) for file, line in frames if is_readers_code(file)]
    if not own:
        return get_message("board.own.raised", who=who, error=text)
    line = linecache.getline(*own[-1]).strip()
    return get_message("board.own.raised_in", who=who, error=text, number=own[-1][1], line=line)


def is_readers_code(file: str) -> bool:
    """Whether code is a reader's: neither this package's, nor Python's, nor a library's."""
    return (
        {PACKAGE, PYTHON}.isdisjoint(Path(file).parents)
        and "site-packages" not in file
        and not file.startswith("<frozen")
    )


def shorten_message(error: BaseException) -> str:
    """The message of an exception, on one line."""
    text = " ".join(str(error).split())
    return text if len(text) <= 200 else text[:197] + "..."

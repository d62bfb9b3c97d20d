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
    message = shorten_message(error)
    text = f"{name}: {message}" if message else name
    calls = [(frame.f_code, line) for frame, line in walk_tb(error.__traceback__)]
    own = [(code, line) for code, line in calls if is_readers_code(code.co_filename)]
    if not own:
        return get_message("board.own.raised", who=who, error=text)
    code, line = own[-1]
    return get_message(
        "board.own.raised_in",
        who=who,
        error=text,
        number=line - code.co_firstlineno + 1,
        function=code.co_name,
        line=linecache.getline(code.co_filename, line).strip(),
    )


def is_readers_code(file: str) -> bool:
    """Whether code is a reader's, with a source that is known.

    It is not this package's, nor Python's, nor a library's, such as numpy's compiled parts.
    """
    return (
        bool(linecache.getlines(file))
        and {PACKAGE, PYTHON}.isdisjoint(Path(file).parents)
        and "site-packages" not in file
        and not file.startswith("<frozen")
    )


def shorten_message(error: BaseException) -> str:
    """The message of an exception, on one line that can be encoded; "" where its own code fails."""
    try:
        text = " ".join(str(error).split())
    except Exception:
        return ""
    text = text.encode("utf-8", "backslashreplace").decode()  # such as a file's name in Latin-1
    return text if len(text) <= 200 else text[:197] + "..."

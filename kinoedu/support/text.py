"""Values and foreign texts as text that is safe to show."""

import io
import re
from html import escape

# control and invisible characters, and those for right-to-left text; not newlines and tabs
CONTROLS = re.compile(
    "[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\xad\u061c\u180e\u200b\u200e\u200f\u2028-\u202e"
    "\u2060-\u206f\ufeff\ufff9-\ufffb\ud800-\udfff\U000e0000-\U000e007f]"
)

CODE = re.compile("`([^`]+)`")


def shortened(value: object) -> str:
    """The repr of a value on one line of at most 80 characters; its type where it has none."""
    try:
        text = " ".join(repr(value).split())
    except Exception:  # by a reader's own class, or an integer of more digits than Python writes
        text = f"<{type(value).__name__}>"
    return text if len(text) <= 80 else text[:77] + "..."


def distinct_numbers(*numbers: float) -> list[str]:
    """Numbers in six digits, or in as many more as different numbers need to look different.

    >>> distinct_numbers(3.0, 3.0000004), distinct_numbers(1 / 3, 2.0)
    (['3', '3.0000004'], ['0.333333', '2'])
    """
    texts: list[str] = []
    for digits in range(6, 18):
        texts = [f"{number:.{digits}g}" for number in numbers]
        if len(set(texts)) >= len(set(numbers)):
            break
    return texts


def split_lines(source: str) -> list[str]:
    r"""The lines of a program with their ends, as Python counts them.

    `str.splitlines` also cuts at page breaks and at Unicode's separators, which stand in lines.

    >>> split_lines("x = '\u2028'\r\n\x0cy = 1") == ["x = '\u2028'\r\n", "\x0cy = 1"]
    True
    """
    return io.StringIO(source, newline="").readlines()


def show_controls(text: str) -> str:
    """Text in which control characters are visible, as Python writes them.

    >>> print(show_controls("ann\\x1b[2J\\u202e"))
    ann\\x1b[2J\\u202e
    """
    return CONTROLS.sub(lambda found: found[0].encode("unicode_escape").decode(), text)


def with_code(text: str) -> str:
    """HTML of a text; what stands between backticks is set as code.

    >>> with_code("Replace `a < b`.")
    'Replace <code>a &lt; b</code>.'
    """
    return CODE.sub(r"<code>\1</code>", escape(text))

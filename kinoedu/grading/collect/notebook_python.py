"""Turn the source of a cell into Python, as IPython does: `%time f(x)` becomes a call.

The source may be made to break or to occupy its reader, so the work is bounded. It is counted and
not timed, so that a notebook is read alike on every computer.
"""

import ast
import warnings

from ...support.text import split_lines

LONGEST_PARSED = 200_000  # characters of a cell
LONGEST, MOST_COMMANDS = 20_000, 500  # characters and commands of a cell with commands
MOST_WORK = 2e8  # of a notebook, in characters times those of the longest line
SHORT_LINE = 200  # characters; shorter lines take no less work for each character
# commands whose cells are Python
PYTHON_CELLS = (["%%time"], ["%%timeit"], ["%%capture"], ["%%prun"])


class PythonReader:
    """Reads the cells of one notebook."""

    def __init__(self) -> None:
        self.work_left = MOST_WORK

    def read(self, source: str) -> str:
        """The source as Python with the same lines, or unchanged where IPython cannot read it.

        >>> reader = PythonReader()
        >>> print(reader.read("%%time\\nfiles = !ls"))
        # %%time
        files = get_ipython().getoutput('ls')
        """
        source = comment_out_command(source)
        if is_python(source) or len(source) > LONGEST:
            return source
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                return self.transform(source)
        except Exception:
            return source

    def transform(self, source: str) -> str:
        """The source as IPython transforms it; it may raise any exception."""
        from IPython.core.inputtransformer2 import TransformerManager

        manager = TransformerManager()
        self.spend(source)
        lines = split_lines(source if source.endswith("\n") else f"{source}\n")
        count = len(lines)
        for change in manager.cleanup_transforms:
            lines = split_lines("".join(change(lines)))
        above = "\n" * (count - len(lines))
        for change in manager.line_transforms:
            lines = change(lines)
        for _ in range(MOST_COMMANDS):
            self.spend("".join(lines))
            changed, after = manager.do_one_token_transform(lines)
            if not changed:
                break
            lines = keep_number_of_lines(lines, after)
        return above + "".join(lines)

    def spend(self, source: str) -> None:
        """Count the work of reading the source once. Raises ValueError where it is too much."""
        self.work_left -= len(source) * max(SHORT_LINE, *map(len, split_lines(source)))
        if self.work_left < 0:
            raise ValueError("the notebook holds too many commands")


def comment_out_command(source: str) -> str:
    """The source with a command such as `%%time`, whose cell is Python, as a comment."""
    lines = split_lines(source)
    for number, line in enumerate(lines):
        if line.split()[:1] in PYTHON_CELLS:
            lines[number] = f"# {line}"
        elif line.strip():
            break
    return "".join(lines)


def keep_number_of_lines(lines: list[str], after: list[str]) -> list[str]:
    """The lines after a change, with empty ones where it made several lines into one."""
    same = next(
        (number for number, (one, other) in enumerate(zip(lines, after)) if one != other), 0
    )
    return [*after[: same + 1], *["\n"] * (len(lines) - len(after)), *after[same + 1 :]]


def is_python(source: str) -> bool:
    """Whether Python can parse the source."""
    if len(source) > LONGEST_PARSED:
        return False
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            ast.parse(source)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return False
    return True

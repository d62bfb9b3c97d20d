"""Run a row in its own process, keep its output, and continue with the others if it fails."""

import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

from ..compiled import COMPILED_FIRST
from .rows import Row

RESULTS = "KINOEDU_RESULTS"  # environment variable with the folder for a row's ratios
PACKAGES = str(Path(__file__).resolve().parent.parent.parent)
SKIPPED = "skipped: "  # a row prints this before each contestant that it leaves out
NOTHING_RUN = 3  # exit status of a row that has left out all of them
PATIENCE = 4.0  # seconds for a row to end by itself, and again after Ctrl-C


class Outcome(NamedTuple):
    """How a row ended.

    Attributes
    ----------
    ended : "done", "skipped" or "failed"; `reason` says why.
    seconds, processor : seconds of wall time and of processor time.
    memory : most memory used at once, in bytes. `processor` and `memory` are None where the system
        does not report them.
    left_out : contestants that the row has skipped.
    """

    row: Row
    ended: str
    reason: str
    seconds: float
    processor: float | None
    memory: int | None
    left_out: list[str]


def run_row(row: Row, folder: Path, given: Mapping[str, object]) -> Outcome:
    """Run a row, and write its output to NAME.md in a folder.

    Where it fails, its error output is appended.

    Parameters
    ----------
    given : values of options; the row receives those that it has.

    Returns
    -------
    Outcome
    """
    options = [
        text
        for name, value in given.items()
        if name in row.options
        for text in (f"--{name}", str(value))
    ]
    path = os.pathsep.join([PACKAGES, *filter(None, [os.environ.get("PYTHONPATH")])])
    variables = {**os.environ, "PYTHONPATH": path, "PYTHONUTF8": "1"}
    variables[RESULTS] = str(folder.resolve())
    variables["KINOEDU_MACHINE_CODE"] = COMPILED_FIRST  # rows time machine code
    page, began = folder / f"{row.name}.md", time.monotonic()
    with page.open("wb") as output, tempfile.TemporaryFile() as error_file:
        line = [sys.executable, str(row.file), *options]
        child = subprocess.Popen(
            line, stdin=subprocess.DEVNULL, stdout=output, stderr=error_file, env=variables
        )
        try:
            status, processor, memory = wait_for(child)
        finally:
            end_process(child)
        error_file.seek(0)
        errors = error_file.read().decode("utf-8", "replace").strip()
    printed = page.read_text("utf-8", "replace").splitlines()
    skipped = list(
        dict.fromkeys(text.removeprefix(SKIPPED) for text in printed if text.startswith(SKIPPED))
    )
    ended, reason = how_it_ended(status, errors.splitlines()[-1] if errors else "", skipped)
    if ended == "failed":
        with page.open("a", encoding="utf-8") as output_end:
            output_end.write(f"\n{reason}\n\n```\n{errors}\n```\n")
    seconds = time.monotonic() - began
    left_out = [] if ended == "skipped" else skipped
    return Outcome(row, ended, reason, seconds, processor, memory, left_out)


def how_it_ended(status: int, last: str, skipped: list[str]) -> tuple[str, str]:
    """How a row ended, and the reason.

    `last` is the last line of its error output.

    >>> how_it_ended(1, "AssertionError: scipy disagrees", [])
    ('failed', 'AssertionError: scipy disagrees')
    >>> how_it_ended(-9, "", [])
    ('failed', 'ended by signal 9')
    """
    if status == 0:
        return "done", ""
    if status == NOTHING_RUN and skipped:
        return "skipped", skipped[-1]
    return "failed", last or (
        f"ended by signal {-status}" if status < 0 else f"ended with status {status}"
    )


def wait_for(child: "subprocess.Popen[bytes]") -> tuple[int, float | None, int | None]:
    """Wait for a process.

    Returns
    -------
    Its exit status, its seconds of processor time, and the most memory it used at once.
    """
    if not hasattr(os, "wait4"):
        return child.wait(), None, None
    _, status, used = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    unit = 1 if sys.platform == "darwin" else 1024
    return child.returncode, used.ru_utime + used.ru_stime, used.ru_maxrss * unit


def end_process(child: "subprocess.Popen[bytes]") -> None:
    """End a process: wait, then send Ctrl-C, then kill it."""
    signals = [lambda: None]
    if os.name != "nt":
        signals.append(lambda: child.send_signal(signal.SIGINT))
    for send in [*signals, child.kill]:
        send()
        with suppress(subprocess.TimeoutExpired):
            child.wait(PATIENCE)
            return

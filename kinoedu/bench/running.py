"""A row in a process of its own: what it prints is kept, and when it fails the others go on."""

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

RESULTS = "KINOEDU_RESULTS"  # tells a row the folder that its ratios go to, beside being printed
PACKAGES = str(Path(__file__).resolve().parent.parent.parent)
SKIPPED, NOTHING_RUN = (
    "skipped: ",
    3,
)  # before what a row left out, and its status where that is all of it
PATIENCE = 4.0  # seconds that a row has to clear up after Ctrl-C, twice


class Outcome(NamedTuple):
    """How a row ended, "done", "skipped" or "failed", with the reason; what it took of the clock,
    the processor and memory, in seconds and bytes, where the system tells; and the contestants that
    it left out.
    """

    row: Row
    ended: str
    reason: str
    seconds: float
    processor: float | None
    memory: int | None
    left_out: list[str]


def run_row(row: Row, folder: Path, given: Mapping[str, object]) -> Outcome:
    """Run a row. What it prints goes into `folder`/NAME.md, its complaints too where it fails. Of
    the options that are `given` it gets those that it knows.
    """
    options = [
        text
        for name, value in given.items()
        if name in row.options
        for text in (f"--{name}", str(value))
    ]
    path = os.pathsep.join([PACKAGES, *filter(None, [os.environ.get("PYTHONPATH")])])
    variables = {
        **os.environ,
        RESULTS: str(folder.resolve()),
        "PYTHONPATH": path,
        "PYTHONUTF8": "1",
    }
    variables["KINOEDU_MACHINE_CODE"] = COMPILED_FIRST  # rows time machine code
    page, began = folder / f"{row.name}.md", time.monotonic()
    with page.open("wb") as told, tempfile.TemporaryFile() as complaints:
        line = [sys.executable, str(row.file), *options]
        child = subprocess.Popen(
            line, stdin=subprocess.DEVNULL, stdout=told, stderr=complaints, env=variables
        )
        try:
            status, processor, memory = waited(child)
        finally:
            end(child)
        complaints.seek(0)
        said = complaints.read().decode("utf-8", "replace").strip()
    printed = page.read_text("utf-8", "replace").splitlines()
    skipped = list(
        dict.fromkeys(text.removeprefix(SKIPPED) for text in printed if text.startswith(SKIPPED))
    )
    ended, reason = how_it_ended(status, said.splitlines()[-1] if said else "", skipped)
    if ended == "failed":
        with page.open("a", encoding="utf-8") as told_more:
            told_more.write(f"\n{reason}\n\n```\n{said}\n```\n")
    return Outcome(
        row,
        ended,
        reason,
        time.monotonic() - began,
        processor,
        memory,
        skipped if ended != "skipped" else [],
    )


def how_it_ended(status: int, last: str, skipped: list[str]) -> tuple[str, str]:
    """In a word, and the reason where it is needed; `last` is the last line of the complaints.

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


def waited(child: "subprocess.Popen[bytes]") -> tuple[int, float | None, int | None]:
    """The exit status of a process, the seconds of the processor that it used, and the most memory
    that it held at once.
    """
    if not hasattr(os, "wait4"):
        return child.wait(), None, None
    _, status, used = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    unit = 1 if sys.platform == "darwin" else 1024
    return child.returncode, used.ru_utime + used.ru_stime, used.ru_maxrss * unit


def end(child: "subprocess.Popen[bytes]") -> None:
    """End a process that has not ended: Ctrl-C has reached it or is sent to it, and where that is
    no use it is killed.
    """
    ways = (
        [lambda: None, lambda: child.send_signal(signal.SIGINT)]
        if os.name != "nt"
        else [lambda: None]
    )
    for way in [*ways, child.kill]:
        way()
        with suppress(subprocess.TimeoutExpired):
            child.wait(PATIENCE)
            return

"""Programs that a test starts, and stops."""

import os
import signal
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any


@contextmanager
def ctrl_c_is_heard() -> Iterator[None]:
    """By programs begun meanwhile, though the tests be deaf: jobs in a shell's background are, and
    so would be their children.
    """
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


@contextmanager
def started(command: list[str], **options: Any) -> Iterator["subprocess.Popen[str]"]:
    """A program that hears Ctrl-C, and ends with the block at the latest."""
    with ctrl_c_is_heard():
        program = subprocess.Popen(command, text=True, **options)
    with program:
        try:
            yield program
        finally:
            program.kill()


def forks(problem: Any, note: str) -> list[Any]:
    """A planner that starts a process which stays, and notes its number in a file."""
    child = os.fork()
    if child == 0:
        time.sleep(600)
    with open(note, "w", encoding="ascii") as file:
        file.write(str(child))
    return [problem.start, problem.goal]

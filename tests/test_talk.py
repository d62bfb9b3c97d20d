"""An exchange with a process ends in time, whatever the process does."""

import os
import subprocess
import sys
import time

import pytest

from kinoedu.grading.sandbox import talk


def exchange(program: str, patience: float = 1.0) -> tuple[list[bytes], str, float]:
    """The lines from a program, how the exchange ended, and its seconds."""
    (read_asking, write_asking), (read_answer, write_answer) = os.pipe(), os.pipe()
    process = subprocess.Popen(
        [sys.executable, "-Ic", program], stdin=read_asking, stdout=write_answer
    )
    for end in (read_asking, write_answer):
        os.close(end)
    begin = time.monotonic()
    one = talk.Talk(write_asking, read_answer, patience)
    one.send(b"x" * 2**20 + b"\n")
    received = list(one.lines())
    took = time.monotonic() - begin
    process.kill()
    process.wait()
    for end in (write_asking, read_answer):
        os.close(end)
    return received, one.end, took


@pytest.mark.skipif(sys.platform != "linux", reason="there is no sandbox but on Linux")
@pytest.mark.parametrize(
    ("program", "end"),
    [
        ("import time; print('{}', flush=True); time.sleep(60)", "late"),
        ("import time\nwhile True: print('{}', flush=True); time.sleep(0.05)", "late"),
        ("import sys\nwhile True: sys.stdout.write('x' * 10**6)", "flood"),
        ("print('{}\\n' * 10**6)", "flood"),
        ("print('{}')", "died"),
        ("import os; os.close(0); print('{}')", "died"),
    ],
    ids=["silent", "chatty", "one line", "many lines", "short", "deaf"],
)
def test_an_exchange_ends_whatever_the_program_does(program, end, monkeypatch):
    monkeypatch.setattr(talk, "START", 20.0)
    monkeypatch.setattr(talk, "LONGEST", -18.0)  # two seconds after START
    monkeypatch.setattr(talk, "MOST_OUTPUT", 2**20)
    _, ended, took = exchange(program)
    assert ended == end
    assert took < 20.0

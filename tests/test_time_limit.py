"""Time limits count a student's own program only, and are longer on a slow computer."""

import subprocess
import sys
import threading
import time

import pytest

from kinoedu.compiled import numba_thread as keeper
from kinoedu.course import EXERCISES, check
from kinoedu.course.feedback import late_message
from kinoedu.course.outcomes import Late, outcome_of
from kinoedu.course.shapes import Number
from kinoedu.support import time_limit
from kinoedu.support.time_limit import TimeUp, run_within, run_within_processor_time

has_clocks = pytest.mark.skipif(
    not hasattr(time, "pthread_getcpuclockid"), reason="no thread's processor time is known here"
)


@pytest.fixture(autouse=True)
def usual_speed(monkeypatch):
    """Treat this computer as a typical one."""
    monkeypatch.setattr(time_limit, "slowdown", lambda: 1.0)


def compute(seconds):
    """Compute for the given time in this thread."""
    until = time.thread_time() + seconds
    while time.thread_time() < until:
        pass
    return seconds


def endless():
    """Never end."""
    while True:
        pass


def stopped(seconds, work):
    """The TimeUp of a program."""
    with pytest.raises(TimeUp) as over:
        run_within_processor_time(seconds, work)
    return over.value


def test_an_answer_and_an_error_come_through():
    """The work's result is returned, and its error is raised."""
    assert run_within_processor_time(5.0, lambda: 42) == run_within(5.0, lambda: 42) == 42
    with pytest.raises(ZeroDivisionError):
        run_within_processor_time(5.0, lambda: 1 / 0)


def test_an_endless_loop_is_stopped_and_the_next_program_runs():
    """TimeUp has both times, and the lines in which the program was."""
    over = stopped(0.3, endless)
    assert over.used > over.allowed == 0.3 and not over.left_running
    assert over.seen is not None and over.seen.function == "endless"
    assert run_within_processor_time(5.0, lambda: compute(0.01)) == 0.01


@has_clocks
@pytest.mark.parametrize("wait", [lambda: time.sleep(100), lambda: threading.Event().wait(100)])
def test_a_program_that_waits_is_ended(wait):
    """It computes next to nothing, so wall-clock time ends it."""
    over = stopped(0.05, wait)
    assert over.used < over.allowed == 0.05 < over.passed and over.seen is None


@has_clocks
def test_a_program_may_wait_for_a_while():
    """Time in which other processes use the processor does not count."""
    assert run_within_processor_time(0.2, lambda: time.sleep(0.4)) is None


def test_what_the_library_takes_is_not_counted(monkeypatch):
    """Interpreted functions of the library take all the time, and the program is not stopped."""
    monkeypatch.setattr(time_limit, "library_seconds", lambda thread: time.perf_counter())
    assert run_within_processor_time(0.4, lambda: compute(0.5)) == 0.5
    assert stopped(0.02, endless).passed > 20 * 0.02  # the longest time for any program


def test_a_slow_computer_gets_more_time(monkeypatch):
    """Its limit is longer in proportion, and the message says so."""
    monkeypatch.setattr(time_limit, "slowdown", lambda: 10.0)
    assert run_within_processor_time(0.05, lambda: compute(0.2)) == 0.2
    assert stopped(0.03, endless).allowed == pytest.approx(0.3)


def test_the_speed_of_a_computer_is_kept_in_bounds(monkeypatch):
    """A fast computer counts as typical, and a very slow one as 20 times slower."""
    for seconds, factor in ((1e-9, 1.0), (2 * time_limit.REFERENCE, 2.0), (1e9, 20.0)):
        monkeypatch.setattr(time_limit, "time_practice_loop", lambda seconds=seconds: seconds)
        assert measured() == factor


measured = time_limit.slowdown.__wrapped__


def test_wall_clock_time_counts_where_processor_time_is_unknown(monkeypatch):
    """A sleeping program ends there too."""
    monkeypatch.setattr(time_limit, "clock_of_this_thread", lambda: None)
    over = stopped(0.1, lambda: time.sleep(100))
    assert over.used > over.allowed == 0.1
    assert run_within_processor_time(5.0, lambda: 42) == 42


def test_imports_do_not_count():
    """Imports are recognized by the calls on the stack."""

    def calls(module):
        names = {}
        exec(compile("import sys\ndef f():\n    return sys._getframe()", module, "exec"), names)
        frame = names["f"]()
        return [(frame, (frame.f_code, frame.f_lineno))]

    assert time_limit.loads_a_module(calls("<frozen importlib._bootstrap>"))
    assert not time_limit.loads_a_module(calls("student.py"))
    assert time_limit.waits_for_machine_code(calls(keeper.__file__))
    assert not time_limit.waits_for_machine_code(calls("student.py"))


def test_the_calls_of_a_thread_are_those_on_its_stack():
    """Innermost first; a thread that has ended has none."""
    begun, end = threading.Event(), threading.Event()

    def inner():
        begun.set()
        end.wait()

    def outer():
        inner()

    thread = threading.Thread(target=outer)
    thread.start()
    begun.wait()
    names = [code.co_name for _, (code, _) in time_limit.calls_of(thread.ident)]
    end.set()
    thread.join()
    at = names.index("inner")
    assert names[at : at + 2] == ["inner", "outer"] and names[-1] == "_bootstrap"
    assert time_limit.calls_of(thread.ident) == []


def test_a_location_is_reported_only_for_few_lines():
    """For a program that was in many places there is no location."""
    places = time_limit.SeenCalls()

    def look():
        places.add(time_limit.calls_of(threading.get_ident())[1:])

    for _ in range(10):
        look()
    seen = places.seen()
    assert seen is not None and seen.function == "test_a_location_is_reported_only_for_few_lines"
    assert seen.first == seen.last
    places = time_limit.SeenCalls()
    places.add(time_limit.calls_of(threading.get_ident())[1:])
    assert places.seen() is None


def test_the_message_has_both_numbers():
    """The time used and the time allowed; loops are mentioned only where one was seen."""
    late = late_message(Late(False, 7.61, 7.5, 8.0, []))
    assert "7.6 s" in late and "7.5 s" in late and "this computer" in late
    waited = late_message(Late(True, 0.01, 5.0, 20.0, []))
    assert "20.0 s" in waited and "0.0 s" in waited and "Restart the kernel" in waited
    assert "allowed time" in late_message(Late(False))


def test_the_message_mentions_loops_only_where_one_was_seen(monkeypatch):
    """The line is shown; the message for a waiting program does not mention loops."""
    monkeypatch.setattr(type(EXERCISES["polygon_tangent"]), "seconds", 0.3)

    def polygon_tangent(q, polygon):
        while True:
            pass

    looping = repr(check(polygon_tangent))
    assert "in a loop?" in looping and ("while True:" in looping or "pass" in looping)
    outcome = outcome_of(lambda: time.sleep(100), Number(), 0.05)
    assert isinstance(outcome, Late) and not outcome.lines

    def polygon_tangent(q, polygon):
        time.sleep(100)

    monkeypatch.setattr(type(EXERCISES["polygon_tangent"]), "seconds", 0.05)
    assert "loop" not in repr(check(polygon_tangent))


def test_the_same_time_out_earns_no_further_hint(monkeypatch):
    """The seconds differ each time, but it is the same failure."""
    from kinoedu.course import feedback

    monkeypatch.setattr(feedback, "TRIES", {})
    monkeypatch.setattr(type(EXERCISES["point_line_distance"]), "seconds", 0.05)

    def point_line_distance(q, p1, p2):
        return endless()

    for _ in range(2):
        assert "smallest case" not in repr(check(point_line_distance, staged=True))


def test_alarms_count_processor_time_where_there_are_no_threads():
    """In the sandbox, a computing and a waiting program are stopped, but not after a short wait."""
    code = """
import os, runpy, sys, time
import kinoedu.grading.sandbox
sys.path.insert(0, os.path.dirname(kinoedu.grading.sandbox.__file__))
student = runpy.run_path(sys.path[0] + "/student.py")
program = student["Program"](*os.pipe())

def report(work):
    try:
        return program.run_with_alarm(0.1, work)
    except student["TimeUp"] as over:
        used, allowed, passed = over.args
        return used >= 0.09, allowed, passed >= 0.39

def endless():
    while True:
        pass

print(report(endless)[:2], report(lambda: time.sleep(100)), report(lambda: time.sleep(0.2)))
"""
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=100)
    assert run.stdout.strip() == "(True, 0.1) (False, 0.1, True) None", run.stderr

"""A run of all tests begins with compiling what they use, on all cores; a run of some does not.
Where a test process crashes, the run's end says in which lines.
"""

import faulthandler
import gc
import logging
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import IO, Any

import nbval.kernel
import nbval.plugin
import pytest
from nbval.kernel import RunningKernel, start_new_kernel

# What takes longest is begun first, so that at the end of a run no process works alone.
LONGEST = (
    "tests/test_bank.py",
    "tests/in_lab",
    "tests/test_kit.py",
    "tests/on_site",
    "tests/test_grading.py",
    "tests/test_house.py",
    "tests/test_course.py",
    "tests/test_compiled.py",
    "tests/test_trivial.py",
    "tests/test_attacks.py",
)
SHARING = ("tests/in_lab", "tests/on_site")  # folders whose files share what takes long to start

WHERE_CRASHED = "KINOEDU_WHERE_CRASHED"  # the folder with a file of each test process
RUNNERS = {"_pytest", "pluggy", "xdist", "execnet"}  # their lines tell nothing about a crash
open_files: list[IO[str]] = []


def start_kernel(*given: Any, **more: Any) -> RunningKernel:
    """Start the kernel of a notebook; once more where it does not answer for a minute.

    Of hundreds of kernels on a busy computer one did not, for no reason that was found.
    """
    try:
        return RunningKernel(*given, **more)
    except RuntimeError as error:
        logging.getLogger("nbval").warning("a kernel is started once more: %s", error)
        return RunningKernel(*given, **more)


def start_silent_kernel(*, stderr: IO[str], **given: Any) -> Any:
    """Start the process of a kernel, without the file that nbval opens and never closes.

    Python's warning of such a file would be the failure of whichever cell runs when it comes.
    """
    stderr.close()
    return start_new_kernel(stderr=subprocess.DEVNULL, **given)


@pytest.hookimpl(trylast=True)
def pytest_configure(config: pytest.Config) -> None:
    """Kernels are started as above, and a test process writes where it crashed into a file, because
    other output hides it.
    """
    nbval.plugin.RunningKernel = start_kernel
    nbval.kernel.start_new_kernel = start_silent_kernel
    if not hasattr(config, "workerinput"):
        os.environ[WHERE_CRASHED] = tempfile.mkdtemp()
        return
    file = Path(os.environ[WHERE_CRASHED]) / config.workerinput["workerid"]
    open_files.append(file.open("w", encoding="utf-8"))
    faulthandler.enable(open_files[-1])


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Print where test processes crashed."""
    for file in sorted(Path(os.environ[WHERE_CRASHED]).iterdir()):
        where, _, _ = file.read_text(encoding="utf-8").partition("Extension modules:")
        for line in where.splitlines():
            if RUNNERS.isdisjoint(line.split("/")):
                terminalreporter.write_line(f"{file.name} crashed: {line}")


def pytest_sessionfinish(session: pytest.Session) -> None:
    """Where it is asked for, write down what this test process wanted to have compiled."""
    if hasattr(session.config, "workerinput") and (notes := os.environ.get("KINOEDU_NOTES")):
        from machine_code import note_requests

        note_requests(Path(notes), session.config.workerinput["workerid"])


def pytest_unconfigure(config: pytest.Config) -> None:
    """Close this process's file; the last process removes all files."""
    if hasattr(config, "workerinput"):
        faulthandler.disable()
        open_files.pop().close()
    else:
        shutil.rmtree(os.environ[WHERE_CRASHED], ignore_errors=True)


def pytest_xdist_auto_num_workers(config: pytest.Config) -> int:
    """One process more than cores, because many tests wait for a browser, a kernel or a clock."""
    asked = os.environ.get("PYTEST_XDIST_AUTO_NUM_WORKERS")
    return int(asked) if asked else (os.cpu_count() or 1) + 1


def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """One process runs all tests of a file, or of a folder whose files share something."""
    from xdist.scheduler import LoadFileScheduling

    class Scheduling(LoadFileScheduling):
        def _split_scope(self, nodeid: str) -> str:
            return run_together(nodeid)

    return Scheduling(config, log)


def run_together(nodeid: str) -> str:
    """The file of a test, or its folder where files share something."""
    file = nodeid.partition("::")[0]
    folder = file.rpartition("/")[0]
    return folder if folder in SHARING else file


@pytest.hookimpl(tryfirst=True)
def pytest_sessionstart(session: pytest.Session) -> None:
    """Before the first test, and before the processes that share them are started."""
    config = session.config
    runs_all = config.args == config.getini("testpaths") and not config.option.collectonly
    if runs_all and not hasattr(config, "workerinput"):
        script = Path(__file__).with_name("machine_code.py")
        subprocess.run([sys.executable, "-P", str(script)], check=True)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Sort the longest files to the front; all else stays in its order."""
    rank = {name: number for number, name in enumerate(LONGEST)}
    items.sort(key=lambda item: rank.get(run_together(item.nodeid), len(rank)))


@pytest.fixture(scope="module")
def chromium() -> Iterator[Any]:
    """One browser for the tests of a file; each opens a page of its own, and closes it.

    Not one for all files: some have event loops of their own, which it would disturb.
    """
    from lab_driver import launched, needs_chromium

    needs_chromium()
    with launched() as browser:
        yield browser


def pytest_collection_finish() -> None:
    """Leave the thousands of collected tests alone when Python looks for unused cycles."""
    gc.freeze()

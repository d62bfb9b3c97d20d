"""A class is graded once and with equal grades, whichever processes are killed meanwhile.

It is graded by one worker, by two, and by Dask's.
"""

import importlib.util
import subprocess
import sys
from pathlib import Path

import pytest

from kinoedu.grading.sandbox import sandbox

HOUSE = Path(__file__).resolve().parent.parent
sys.path.append(str(HOUSE / "benchmarks"))

from grading_soak import class_of, grader, results, soaked  # noqa: E402

NO_SANDBOX = sandbox.explain_no_sandbox()
pytestmark = pytest.mark.skipif(bool(NO_SANDBOX), reason=NO_SANDBOX or "there is one")
SIZE = 20
# attacks that end at once
BRIEF = ["exits", "forged_lines", "memory", "output", "processes", "signals", "broken_python"]


@pytest.fixture(scope="module")
def calm(tmp_path_factory):
    """A class, and its results when two workers are not disturbed."""
    folder = tmp_path_factory.mktemp("calm")
    class_of(SIZE, folder / "class", 0.2, BRIEF)
    assert grader(folder / "class", folder / "out", "2").wait() == 0
    return folder / "class", results(folder / "out")


def test_every_submission_is_graded_once(calm):
    _, found = calm
    assert len(found) == SIZE


@pytest.mark.parametrize("workers", ["2"])
def test_grades_do_not_depend_on_killed_processes(calm, tmp_path, workers):
    submissions, wanted = calm
    killed, status = soaked(
        submissions, tmp_path / "out", workers, every=6, grader_dies_at=SIZE // 2
    )
    assert status == 0
    assert killed > 0
    assert results(tmp_path / "out") == wanted


@pytest.mark.skipif(
    importlib.util.find_spec("distributed") is None, reason="Dask distributed is not installed"
)
def test_dask_grades_the_same_though_a_worker_is_lost(calm, tmp_path):
    submissions, wanted = calm
    program = tmp_path / "cluster.py"
    program.write_text(CLUSTER, encoding="utf-8")
    run = subprocess.run(
        [sys.executable, str(program), str(submissions), str(tmp_path / "out")],
        timeout=500,
        check=False,
    )
    assert run.returncode == 0
    assert results(tmp_path / "out") == wanted


CLUSTER = f"""
import os, signal, sys, threading, time
from pathlib import Path
sys.path.insert(0, {str(HOUSE / "benchmarks")!r})
if __name__ == "__main__":
    from distributed import LocalCluster
    from grading_soak import SECRET, results
    from kinoedu.grading.judge.running import grade_all, use_dask_workers
    from kinoedu.grading.collect.submissions import collect
    out = Path(sys.argv[2])
    how = dict(n_workers=2, threads_per_worker=2, dashboard_address=None, silence_logs=50)
    with LocalCluster(**how) as cluster:
        def kill():
            while len(results(out)) < 5:
                time.sleep(0.05)
            os.kill(next(iter(cluster.workers.values())).pid, signal.SIGKILL)
        threading.Thread(target=kill, daemon=True).start()
        place = use_dask_workers(cluster.scheduler_address)
        graded = grade_all(collect(Path(sys.argv[1])), out, SECRET, place=place)
        assert all(one.grade is not None for one in graded), [one.trouble for one in graded]
"""

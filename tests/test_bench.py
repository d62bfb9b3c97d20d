"""The benchmark table: rows run one by one, failures do not stop others, all are reported."""

import csv
import gc
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from children import started
from PIL import Image

from kinoedu.bench import Ratio, append_ratios, install_peer, named_peers, read_ratios, read_rows
from kinoedu.bench.running import run_row
from kinoedu.cli import main
from kinoedu.errors import InvalidParameter, UnreadableScene
from kinoedu.figures.growth import save_growth

BENCHMARKS = Path(__file__).resolve().parent.parent / "benchmarks"
sys.path.insert(0, str(BENCHMARKS))

from growing import GROWTHS, Task  # noqa: E402 - the benchmarks are scripts beside each other
from growth import exponents, timed, write_csv  # noqa: E402
from timing import Missing  # noqa: E402

sys.path.remove(str(BENCHMARKS))

HOLDS = '''"""A row that holds one goal and misses another.

More about it.
"""
from timing import Goal, report, run
SECONDS = 2
def main(repeats: int = 3) -> None:
    ours, theirs = [0.001] * repeats, [0.004] * repeats
    report("apples | pears", {"kinoedu": ours, "a peer": theirs}, {"a peer": Goal(at_least=3)})
    times = {"kinoedu": ours, "C ruler": [0.0005] * repeats, "other": theirs}
    report("plums", times, {"C ruler": Goal(at_most=1.2)})
if __name__ == "__main__":
    run(main)
'''
FAILS = '''"""A row whose answers are wrong in the end."""
from timing import Missing, available, report, run
SECONDS = 1.5
def absent():
    raise Missing("it is not there")
def main() -> None:
    available({"ghost": absent})
    available({"ghost": absent})
    report("figs", {"kinoedu": [0.002], "a peer": [0.002]}, {})
    assert False, "a peer disagrees"
if __name__ == "__main__":
    run(main)
'''
LACKS = '''"""A row for which this computer lacks what it needs."""
from timing import run
SECONDS = 1
def main() -> None:
    import no_such_package
if __name__ == "__main__":
    run(main)
'''
WAITS = '''"""A row that takes long, and clears up when it is interrupted."""
import sys, time
from pathlib import Path
SECONDS = 100
Path(sys.argv[0]).with_suffix(".began").touch()
try:
    time.sleep(100)
finally:
    Path(sys.argv[0]).with_suffix(".cleared").touch()
'''


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """Artificial benchmarks: four rows, and scripts that are not rows."""
    place = tmp_path / "benchmarks of mine"
    place.mkdir()
    for name, text in {
        "holds": HOLDS,
        "fails": FAILS,
        "lacks": LACKS,
        "waits": WAITS,
        "no_row": "SECONDS: float\n",
    }.items():
        (place / f"{name}.py").write_text(text)
    shutil.copy(BENCHMARKS / "timing.py", place)
    monkeypatch.setattr("kinoedu.cli.bench.BENCHMARKS", place)
    return place


def test_the_table_and_the_picture_contain_all_rows(folder, capsys):
    """A failing row is listed with its reason and its measurements; the others run; status 1."""
    assert main(["bench", "fails", "lacks", "holds", "holds", "--repeats", "5"]) == 1
    out, err = capsys.readouterr()
    results = folder / "results"
    with (results / "ratios.csv").open(newline="") as file:
        lines = list(csv.DictReader(file))
    found = {
        (line["title"], line["contestant"]): (
            line["ratio"],
            line["goal"],
            line["holds"],
            line["rounds"],
        )
        for line in lines
    }
    assert found == {
        ("figs", "kinoedu"): ("", "", "", "1"),
        ("figs", "a peer"): ("1", "", "", "1"),
        ("apples | pears", "kinoedu"): ("", "", "", "5"),
        ("apples | pears", "a peer"): ("4", ">= 3", "holds", "5"),
        ("plums", "kinoedu"): ("", "", "", "5"),
        ("plums", "C ruler"): ("2", "<= 1.2", "missed", "5"),
        ("plums", "other"): ("4", "", "", "5"),
    }
    assert [line["row"] for line in lines] == ["fails"] * 2 + ["holds"] * 5
    table = (results / "ratios.md").read_text(encoding="utf-8")
    for text in (
        "1 goal held, 1 missed",
        "a peer disagrees",
        "No module named 'no_such_package'",
        "| ghost (it is not there) |",
    ):
        assert text in table
    assert "| C ruler | 0.5 | 2 (2 to 2) | <= 1.2 | **missed** |" in table
    assert "fails: failed" in out and "lacks: skipped" in out and "holds: done" in out
    assert (
        "1 goal held, 1 missed. Failed: fails (AssertionError: a peer disagrees). Skipped: lacks"
        in out
    )
    assert "3 of 3: holds" in err
    assert "### plums" in (results / "holds.md").read_text(encoding="utf-8")
    assert "Traceback" in (results / "fails.md").read_text(encoding="utf-8")
    with Image.open(results / "ratios.png") as image:
        assert min(image.size) > 300
    assert "<svg" in (results / "ratios.svg").read_text(encoding="utf-8")


def test_what_was_in_the_folder_is_replaced(folder, tmp_path):
    """A table reports one run only; missed goals are not failures."""
    out = tmp_path / "new" / "out"
    assert main(["bench", "holds", "--out", str(out)]) == 0
    before = read_ratios(out / "ratios.csv")
    assert main(["bench", "holds", "--out", str(out)]) == 0
    assert read_ratios(out / "ratios.csv") == before
    assert main(["bench", "lacks", "--out", str(out)]) == 0
    assert sorted(path.name for path in out.iterdir()) == ["holds.md", "lacks.md", "ratios.md"]


def test_rows_are_listed_and_none_is_run(folder, capsys):
    """A line for each row with its name, duration and description; nothing is written."""
    assert main(["bench", "--list"]) == 0
    out = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in out[:-1]] == ["fails", "holds", "lacks", "waits"]
    assert out[1].split(maxsplit=3)[1:] == [
        "2",
        "s",
        "A row that holds one goal and misses another.",
    ]
    assert out[-1] == "4 rows, about 2 min in all"
    assert not (folder / "results").exists()


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["hods"], "there is no row 'hods'; the rows are fails, holds, lacks, waits"),
        (["no_row"], "there is no row 'no_row'"),
        (["holds", "--repeats", "0"], "at least 1, got 0"),
        (["holds", "--pythonrobotics", "no/such/folder"], "is not a folder"),
    ],
)
def test_wrong_input_is_reported_before_anything_runs(folder, capsys, arguments, words):
    """One line says what was expected; status 2."""
    assert main(["bench", *arguments]) == 2
    err = capsys.readouterr().err
    assert words in err and err.count("\n") == 1
    assert not (folder / "results").exists()


def test_a_course_without_benchmarks_says_so(tmp_path):
    """A student's copy of the course has no benchmarks."""
    with pytest.raises(InvalidParameter, match="there are no benchmarks in"):
        read_rows(tmp_path / "benchmarks")
    (tmp_path / "broken.py").write_text("SECONDS = = 3")
    with pytest.raises(InvalidParameter, match=r"broken\.py"):
        read_rows(tmp_path)


def test_our_rows_say_what_they_are():
    """Each row has a description and a duration, and those with peers have an option for rounds.

    PythonRobotics is a peer of rrt only.
    """
    rows = {row.name: row for row in read_rows(BENCHMARKS)}
    assert {
        "rrt",
        "prm",
        "trees",
        "grid",
        "trapezoids",
        "batches",
        "arm",
        "halton",
        "kinodynamic",
        "first_plan",
    } <= set(rows)
    assert not {"timing", "ruler", "worlds", "certify"} & set(rows)
    assert all(row.about.endswith(".") and row.seconds > 0 for row in rows.values())
    assert [row.name for row in rows.values() if "pythonrobotics" in row.options] == ["rrt"]
    readme = (BENCHMARKS / "README.md").read_text(encoding="utf-8")
    assert all(f"| `{name}.py` |" in readme for name in rows)


@pytest.mark.skipif(sys.platform == "win32", reason="the signals of POSIX")
def test_a_row_is_ended_with_the_command(folder):
    """When the command is interrupted, it interrupts its row, which cleans up; results are kept."""
    code = f"""
from pathlib import Path
import kinoedu.cli.bench as bench
from kinoedu.cli import main
bench.BENCHMARKS = Path({str(folder)!r})
raise SystemExit(main(["bench", "holds", "waits"]))"""
    with started(
        [sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as running:
        deadline = time.monotonic() + 60
        while not (folder / "waits.began").exists():
            assert time.monotonic() < deadline and running.poll() is None
            time.sleep(0.05)
        running.send_signal(signal.SIGINT)
        running.communicate(timeout=60)
    assert running.returncode == 130
    assert (folder / "waits.cleared").exists()
    assert (folder / "results" / "ratios.png").exists() and "holds" in (
        folder / "results" / "ratios.md"
    ).read_text()


@pytest.mark.parametrize("name", ["grading", "grading_soak"])
def test_a_script_that_is_no_row_says_what_it_takes(name):
    """And refuses in a line what is no number."""
    script = [sys.executable, str(BENCHMARKS / f"{name}.py")]
    helped = subprocess.run([*script, "--help"], capture_output=True, text=True)
    assert helped.returncode == 0 and "submissions" in helped.stdout
    wrong = subprocess.run([*script, "many"], capture_output=True, text=True)
    assert wrong.returncode == 2 and "invalid int value: 'many'" in wrong.stderr


def test_ratios_are_read_as_they_were_written(tmp_path):
    """Six digits of each number are kept; another kind of file is rejected."""
    ratios = [
        Ratio(
            "rrt", 'a "title", with a comma', "C", 1.23456, 1.5, 1.25, 1e6, "<= 1.2", "missed", 5
        ),
        Ratio("rrt", "ünïcode", "kinoedu", 2.0, None, None, None, "", "", 5),
    ]
    for ratio in ratios:
        append_ratios(tmp_path / "ratios.csv", [ratio])
    assert read_ratios(tmp_path / "ratios.csv") == ratios
    assert read_ratios(tmp_path / "none.csv") == []
    (tmp_path / "other.csv").write_text("a,b\n1,2\n")
    with pytest.raises(UnreadableScene, match="not a table of ratios"):
        read_ratios(tmp_path / "other.csv")


@pytest.mark.parametrize("has_uv", [True, False])
def test_a_peer_is_installed_beside_what_the_course_pins(tmp_path, monkeypatch, has_uv):
    """uv or pip installs it from wheels, constrained to the pins; a failure shows the output."""
    (tmp_path / "benchmarks").mkdir()
    file = tmp_path / "benchmarks" / "environment.txt"
    file.write_text("# peers\nnumpy==0.0.1\n\nno-such-peer==1.0  # why\n")
    (tmp_path / "environment.txt").write_text("numpy==2.0.0\n")
    assert named_peers(file) == ["numpy==0.0.1", "no-such-peer==1.0"]
    calls = []

    def ran(command, **_):
        calls.append([str(part) for part in command])
        wrong = command[-1].startswith("no-such")
        return subprocess.CompletedProcess(
            command,
            int(wrong),
            "  \u00d7 No solution found\n  \u2570\u2500\u25b6 it was not found\n".encode(),
        )

    monkeypatch.setattr(
        "kinoedu.bench.peers.shutil.which", lambda name: "/bin/uv" if has_uv else None
    )
    monkeypatch.setattr("kinoedu.bench.peers.importlib.util.find_spec", lambda name: None)
    monkeypatch.setattr("kinoedu.bench.peers.subprocess.run", ran)
    assert install_peer("numpy==0.0.1", file) == ""
    assert install_peer("no-such-peer==1.0", file) == "No solution found it was not found"
    installing = [call for call in calls if "install" in call]
    assert len(installing) == 2 and ["ensurepip" in call for call in calls].count(True) == (
        0 if has_uv else 2
    )
    for call in installing:
        assert (
            call[call.index("--constraint") + 1] == str(tmp_path / "environment.txt")
            and "--only-binary" in call
        )
        assert sys.executable in call


def test_a_peer_that_is_there_is_left_alone(tmp_path, monkeypatch):
    """No installer is run for an installed peer."""
    monkeypatch.setattr(
        "kinoedu.bench.peers.subprocess.run", lambda *_, **__: pytest.fail("an installer was run")
    )
    assert (
        install_peer(f"numpy=={np.__version__}", tmp_path / "benchmarks" / "environment.txt") == ""
    )


def test_a_row_that_dies_is_reported_with_its_signal_or_status(tmp_path):
    """Its resource use is known too, where the system reports it."""
    (tmp_path / "dies.py").write_text('"""Dies."""\nimport os\nSECONDS = 1\nos._exit(7)\n')
    outcome = run_row(read_rows(tmp_path)[0], tmp_path, {"repeats": 3})
    assert (outcome.ended, outcome.reason) == ("failed", "ended with status 7")
    if sys.platform != "win32":
        assert outcome.processor is not None and outcome.memory is not None and outcome.memory > 1e6


# -- growth


def test_the_exponent_is_the_slope_of_the_last_sizes():
    """A power law is found exactly in each round, whatever the smaller sizes give."""
    n = np.array([1.0, 2.0, 4.0, 8.0, 16.0, 32.0])
    seconds = np.column_stack([3e-6 * n**2, 5e-5 * n**1.25])
    seconds[:2] = 7.0
    np.testing.assert_allclose(exponents(n, seconds), [2.0, 1.25], rtol=1e-12)


@pytest.mark.parametrize("name", [name for name in GROWTHS if name != "grading"])
def test_a_wrong_answer_is_not_timed(name):
    """Each judge accepts the right answer, and rejects incomplete ones and ones of another size."""
    growth = GROWTHS[name]
    try:
        small, large = growth.make_task(growth.first), growth.make_task(4 * growth.first)
    except Missing as missing:  # such as a C compiler
        pytest.skip(str(missing))
    answer = small.work()
    small.judge(answer)
    with pytest.raises((AssertionError, IndexError)):
        small.judge(large.work())
    assert small.n < large.n


@pytest.fixture
def small_heap():
    """Free what other tests left, so that garbage collection before a measurement is fast."""
    gc.freeze()
    yield
    gc.unfreeze()


def test_sizes_double_and_every_time_is_written(small_heap, tmp_path, monkeypatch):
    """With a simulated clock the exponent is 1, and the last n first takes half the limit."""
    ticks, judged = [0.0], []

    def make_task(n):
        def work():
            ticks[0] += n / 100
            return n

        return Task(n, work, judged.append)

    monkeypatch.setitem(
        GROWTHS,
        "work",
        GROWTHS["RRT"]._replace(make_task=make_task, first=2, clock=lambda: ticks[0]),
    )
    curve = timed("work", 2.0, 3)
    assert curve.n.tolist() == judged == [2, 4, 8, 16, 32, 64, 128]
    np.testing.assert_allclose(curve.seconds, np.tile(curve.n[:, None] / 100, 3), rtol=1e-9)
    assert curve.exponent == pytest.approx(1.0)
    write_csv([curve], tmp_path / "growth.csv")
    with (tmp_path / "growth.csv").open(newline="") as file:
        lines = list(csv.DictReader(file))
    assert len(lines) == 21 and [*lines[-1].values()] == ["work", "nodes", "128", "3", "1.28"]
    save_growth([curve] * 5, tmp_path / "growth.png")
    with Image.open(tmp_path / "growth.png") as image:
        assert image.size == (1600, 700)


def test_a_benchmarks_own_function_may_call_kinoedus_in_machine_code():
    """In a process in which kinoedu has compiled nothing."""
    code = (
        "import numpy as np; from compiling import njit; from kinoedu.spaces import distance\n"
        "from kinoedu.spaces import RealSpace\n"
        "space = RealSpace(np.zeros(2), np.ones(2))\n"
        "@njit\n"
        "def far(space, a, b): return distance(space, a, b)\n"
        "print(far(space, np.zeros(2), np.array([0.3, 0.4])))"
    )
    ran = subprocess.run(
        [sys.executable, "-c", code], cwd=BENCHMARKS, capture_output=True, text=True, check=False
    )
    assert (ran.stdout, ran.stderr) == ("0.5\n", "")

"""Experiments: the same table on any workers, after any interruption, and checks of the input."""

import csv
import math
import os
import pickle
import signal
import subprocess
import sys
import time
from concurrent.futures import Executor, Future
from contextlib import suppress
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from children import forks, started

import kinoedu as ke
from kinoedu.cli import main
from kinoedu.errors import InvalidParameter, KinoeduError, UnreadableScene
from kinoedu.experiments import (
    Experiment,
    as_text,
    narrow_passage,
    read_experiment,
    run,
    running,
    scattered_polygons,
    summary,
)
from kinoedu.experiments.cells import Outcome, digest_of
from kinoedu.experiments.children import run_batch
from kinoedu.experiments.digests import digest
from kinoedu.experiments.experiment import cells_of
from kinoedu.experiments.files import planners_by_name
from kinoedu.experiments.places import run_in_this_process
from kinoedu.experiments.plots import save_plots
from kinoedu.experiments.summaries import success_fraction
from kinoedu.experiments.table import Row, Table
from kinoedu.files.benchmr import is_polygon_map
from kinoedu.problems import Plan

HOUSE = Path(__file__).resolve().parent.parent
PROBLEM = scattered_polygons(6, rng=1)
SMALL = Experiment(
    {"rubble": PROBLEM, "gap": narrow_passage(2.0)},
    {
        "RRT": partial(ke.rrt, max_nodes=60),
        "PRM": [partial(ke.prm, n=n) for n in (20, 40)],
        "grid": ke.plan_on_grid,
    },
    seeds=[3, 5, 8],
)


def but_for_seconds(table):
    """Rows without times, which must be the same everywhere."""
    return [row._replace(seconds=0.0) for row in table]


def raising(problem):
    """A planner that raises an error."""
    raise ArithmeticError("never mind\nthat")


def endless(problem):
    """A planner that stays in compiled code for a very long time, where Python cannot stop it."""
    return ke.rrt(narrow_passage(1e-9), max_nodes=9_000_000, rng=0)


def crashing(problem, *, rng):
    """A planner that ends its process, once for each seed, and always for seed 0."""
    seed = rng.bit_generator.seed_seq.entropy
    marker = Path(os.environ["KINOEDU_TEST_FOLDER"]) / f"{seed}"
    if seed == 0 or not marker.exists():
        marker.touch()
        os.kill(os.getpid(), signal.SIGABRT)
    return ke.rrt(problem, rng=rng)


def asking(problem):
    """A planner that waits for somebody to type."""
    return input("which way? ")


def pretending(problem):
    """A planner that prints what the watchdog prints, and crashes."""
    print("Timeout (0:00:02)!", flush=True)
    os.kill(os.getpid(), 9)


def stopping(problem):
    """A planner that raises what nothing catches."""
    raise KeyboardInterrupt


def talking(problem):
    """A planner that prints."""
    print("x" * 100_000)
    return ke.plan_on_grid(problem)


def aimless(problem):
    """A planner that does not reach the goal."""
    return [problem.start]


@pytest.fixture(scope="module")
def table():
    """Table of SMALL, computed in this process."""
    return run(SMALL, where="here")


def test_rows_are_what_the_planners_answer(table):
    """Rows are in the experiment's order with the plan's numbers; some planners run once.

    A deterministic planner runs once, whatever the number of seeds.
    """
    assert [(row.problem, row.label, row.seed) for row in table[:10]] == [
        *(
            ("rubble", label, seed)
            for label in ("RRT", "PRM, n=20", "PRM, n=40")
            for seed in (3, 5, 8)
        ),
        ("rubble", "grid", None),
    ]
    for row, seed in zip(table[:3], (3, 5, 8)):
        PROBLEM.query_counts[:] = 0
        plan = ke.rrt(PROBLEM, max_nodes=60, rng=seed)
        assert (row.found, row.status) == (
            (True, "found") if plan.path is not None else (False, "no path")
        )
        assert (row.cost, row.nodes, row.iterations, row.reason) == (
            plan.cost,
            plan.stats["nodes"],
            plan.stats["iterations"],
            plan.reason,
        )
        assert (row.motions, row.places) == tuple(PROBLEM.query_counts)
        assert row.path == (digest_of(plan.path) if plan.path is not None else "")
        assert row.seconds > 0.0
    assert {row.status for row in table} == {"found", "no path"}


@pytest.mark.parametrize("workers", [1, 2])
def test_workers_change_nothing_but_seconds(workers, table, monkeypatch):
    """The table is the same for one process or two, and for few runs submitted at a time."""
    monkeypatch.setattr(running, "AHEAD", 3)
    calls = []
    ran = run(SMALL, workers=workers, progress=lambda *counts: calls.append(counts))
    assert but_for_seconds(ran) == but_for_seconds(table)
    assert calls == [(n, 20) for n in range(21)]


@pytest.mark.parametrize(("slice_seconds", "most"), [(0.0, 1), (60.0, 3)])
def test_a_batch_comes_back_after_its_time(slice_seconds, most, monkeypatch):
    """A batch is of one kind; what it had no time for is run later, in batches as short."""
    monkeypatch.setattr(running, "AHEAD", 3)
    monkeypatch.setattr("kinoedu.experiments.children.SLICE", slice_seconds)
    answered = []

    def submit(batch):
        assert len({cell.kind for cell in batch}) == 1
        future = Future()
        future.set_result(run_batch(batch, lambda cell: Outcome("no path", cost=cell.seed or 0)))
        answered.append(len(future.result()))
        return future

    cells = cells_of(SMALL)
    made = list(running.run_cells(cells, submit))
    assert sorted(cell.key for cell, _ in made) == sorted(cell.key for cell in cells)
    assert all(outcome.cost == (cell.seed or 0) for cell, outcome in made)
    assert (max(answered), sum(answered)) == (most, len(cells))


class Losing(Executor):
    """An executor whose cluster is lost after some batches."""

    def __init__(self, batches):
        self.left = batches

    def submit(self, function, pickled):
        """A future that is done, or that the client has given up."""
        future = Future()
        if self.left:
            batch = pickle.loads(pickled)
            future.set_result([run_in_this_process(cell) for cell in batch])
        else:
            future.cancel()
            future.set_running_or_notify_cancel()
        self.left = max(0, self.left - 1)
        return future


def test_an_experiment_whose_cluster_is_lost_resumes(table, tmp_path):
    """The loss is an error with a name; what was finished before is not run again."""
    with pytest.raises(ConnectionError, match="workers were lost"):
        run(SMALL, where=Losing(7), out=tmp_path)
    calls = []
    ran = run(SMALL, where="here", out=tmp_path, progress=lambda *counts: calls.append(counts))
    assert calls[0] == (7, 20) and len(calls) == 14
    assert but_for_seconds(ran) == but_for_seconds(table)


def test_a_dask_cluster_gives_the_same_rows(table):
    """A cluster gives the same rows; an address without a scheduler is an error."""
    from dask.distributed import LocalCluster

    with LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0", silence_logs=50
    ) as cluster:
        assert but_for_seconds(run(SMALL, where=cluster.scheduler_address)) == but_for_seconds(
            table
        )
        with pytest.raises(InvalidParameter, match="workers can be given"):
            run(SMALL, where=cluster.scheduler_address, workers=2)
    with pytest.raises(InvalidParameter, match="no Dask scheduler answers at 'carrier pigeon'"):
        run(SMALL, where="carrier pigeon")


def test_no_planner_harms_another(tmp_path, monkeypatch):
    """A planner that raises, hangs, crashes, prints or returns nonsense gives a row.

    The row says why. A run that crashed is tried once more.
    """
    monkeypatch.setenv("KINOEDU_TEST_FOLDER", str(tmp_path))
    planners = {
        "raising": raising,
        "asking": asking,
        "endless": endless,
        "crashing": crashing,
        "talking": talking,
        "aimless": aimless,
        "A*": ke.plan_on_grid,
    }
    ran = run(
        Experiment({"rubble": PROBLEM}, planners, seeds=2, time_limit=2.0),
        workers=2,
        out=tmp_path / "out",
    )
    rows = {(row.planner, row.seed): row for row in ran}
    assert {key: row.status for key, row in rows.items()} == {
        ("raising", None): "not run",
        ("asking", None): "not run",
        ("endless", None): "out of time",
        ("crashing", 0): "not run",
        ("crashing", 1): "found",
        ("talking", None): "found",
        ("aimless", None): "wrong",
        ("A*", None): "found",
    }
    assert rows["raising", None].reason == "ArithmeticError: never mind that"
    assert rows["asking", None].reason.startswith("EOFError")
    assert "ended with status" in rows["crashing", 0].reason
    assert "must end at the goal" in rows["aimless", None].reason
    assert rows["endless", None].seconds == 2.0
    assert rows["talking", None].path == rows["A*", None].path
    # cells that were not run are not stored, so that they are tried again
    assert len(list((tmp_path / "out" / "runs").iterdir())) == 5
    assert "not run" in as_text(summary(ran))


def test_here_what_raises_or_hangs_is_a_row_as_well(monkeypatch):
    """In this process, too, errors and endless Python code give a row."""
    monkeypatch.setattr("kinoedu.experiments.places.LOADING", 0.0)
    ran = run(
        Experiment({"rubble": PROBLEM}, {"raising": raising, "idle": idle}, time_limit=0.2),
        where="here",
    )
    assert ran.column("status") == ["not run", "out of time"]


def test_the_status_with_which_a_process_ended_is_its_own():
    """What it printed is no time-out; one that ended by itself was not killed."""
    planners = {"pretending": pretending, "stopping": stopping}
    ran = run(Experiment({"rubble": PROBLEM}, planners, time_limit=2.0), workers=1)
    assert ran.column("status") == ["not run", "not run"]
    assert ran[0].reason.endswith("ended with status -9")
    assert not ran[1].reason.endswith("ended with status -9")


@pytest.mark.parametrize(
    "text", ["[" * 100_000, '{"status": "nonsense", "cost": 1.0, "seconds": 0.1}']
)
def test_a_damaged_outcome_is_run_again(text, tmp_path):
    """Also where it is deeply nested, or has a status that none has."""
    experiment = Experiment({"rubble": PROBLEM}, {"A*": ke.plan_on_grid})
    before = run(experiment, where="here", out=tmp_path)
    (file,) = (tmp_path / "runs").iterdir()
    file.write_text(text)
    assert but_for_seconds(run(experiment, where="here", out=tmp_path)) == but_for_seconds(before)


def test_a_message_that_is_not_unicode_is_written(tmp_path):
    """Such as the name of a file; it does not cost the table."""

    def raising(problem):
        raise FileNotFoundError(os.fsdecode(b"caf\xe9"))

    ran = run(Experiment({"rubble": PROBLEM}, {"raising": raising}), where="here", out=tmp_path)
    assert ran[0].status == "not run"
    assert "caf\\udce9" in (tmp_path / "results.csv").read_text(encoding="utf-8")


def test_here_a_stopped_experiment_runs_nothing_more():
    """Ctrl-C ends it after the run that it is at, not after all that were submitted."""
    calls = []

    def slow(problem, rng):
        calls.append(problem)
        time.sleep(0.05)

    def stop(done, everything):
        if done:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run(Experiment({"rubble": PROBLEM}, {"slow": slow}, 20), where="here", progress=stop)
    assert len(calls) <= 6  # each run is preceded by an untimed one


def idle(problem):
    """A planner that never returns."""
    while True:
        time.sleep(0.01)


FILE = """
seeds = 40
[problems.rubble]
world = "scattered polygons"
obstacles = 6
seed = 1
[planners.RRT]
planner = "rrt"
max_nodes = 60
[planners.PRM]
planner = "prm"
n = [20, 40]
"""


@pytest.mark.skipif(sys.platform == "win32", reason="the signals of POSIX")
@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGKILL])
def test_a_stopped_experiment_resumes(how, tmp_path):
    """An experiment that was killed and started again makes only the missing runs; same table."""
    file, out = tmp_path / "small.toml", tmp_path / "out"
    file.write_text(FILE)
    command = [
        sys.executable,
        "-m",
        "kinoedu",
        "experiment",
        str(file),
        "--out",
        str(out),
        "--workers",
        "1",
    ]
    with started(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as stopped:
        while len(list(out.glob("runs/*.json"))) < 5 and stopped.poll() is None:
            time.sleep(0.002)
        stopped.send_signal(how)
        output = stopped.communicate(timeout=60)[1]
    assert stopped.returncode == (130 if how == signal.SIGINT else -how)
    assert "Traceback" not in output
    before = {kept.name: kept.stat().st_mtime_ns for kept in out.glob("runs/*.json")}
    assert 5 <= len(before) < 120
    assert not (out / "results.csv").exists()
    experiment = read_experiment(file)
    calls = []
    resumed = run(experiment, where="here", out=out, progress=lambda *counts: calls.append(counts))
    assert calls[0] == (len(before), 120)
    assert len(calls) == 121 - len(before)
    assert (
        before.items()
        <= {kept.name: kept.stat().st_mtime_ns for kept in out.glob("runs/*.json")}.items()
    )
    assert but_for_seconds(resumed) == but_for_seconds(run(experiment, where="here"))


def test_only_what_is_the_same_is_taken_from_the_folder(tmp_path):
    """Damaged outcomes, other arguments and runs that had less time are run again.

    Other names are not.
    """
    small = Experiment({"rubble": PROBLEM}, {"RRT": partial(ke.rrt, max_nodes=60)}, seeds=3)
    ran = run(small, where="here", out=tmp_path)
    kept = sorted((tmp_path / "runs").iterdir())
    kept[0].write_text('{"status": "fou')
    assert missing(small, tmp_path) == 1
    assert (
        missing(
            Experiment({"other": PROBLEM}, {"name": partial(ke.rrt, max_nodes=60)}, seeds=4),
            tmp_path,
        )
        == 1
    )
    assert (
        missing(
            Experiment({"rubble": PROBLEM}, {"RRT": partial(ke.rrt, max_nodes=61)}, seeds=3),
            tmp_path,
        )
        == 3
    )
    assert (
        missing(
            Experiment(
                {"rubble": scattered_polygons(6, rng=2)},
                {"RRT": partial(ke.rrt, max_nodes=60)},
                seeds=3,
            ),
            tmp_path,
        )
        == 3
    )
    kept[0].write_text('{"status": "out of time", "seconds": 60.0}')
    assert missing(small, tmp_path) == 0
    assert (
        missing(
            Experiment(
                {"rubble": PROBLEM}, {"RRT": partial(ke.rrt, max_nodes=60)}, seeds=3, time_limit=61
            ),
            tmp_path,
        )
        == 1
    )
    assert but_for_seconds(run(small, where="here")) == but_for_seconds(ran)


def missing(experiment, out):
    """Number of an experiment's runs that a folder does not have."""
    calls = []
    run(experiment, where="here", out=out, progress=lambda *counts: calls.append(counts))
    return calls[-1][1] - calls[0][0]


def test_a_folder_that_cannot_be_written_is_refused_before_anything_runs(tmp_path):
    """No run is made whose outcome would be lost."""
    (tmp_path / "file").touch()
    calls = []
    with pytest.raises(OSError, match="file"):
        run(
            SMALL,
            where="here",
            out=tmp_path / "file",
            progress=lambda *counts: calls.append(counts),
        )
    assert calls == []


PROBLEMS = '[problems.a]\nworld = "narrow passage"\n'
PLANNERS = '[planners.a]\nplanner = "rrt"\n'
DRIVEN = '[planners.a]\nplanner = "kinodynamic_rrt"\n'
NONSENSE = {
    "seeds = = 3": "not valid TOML",
    "": "experiment lacks 'problems'",
    PROBLEMS: "experiment lacks 'planners'",
    "problems = 3\n" + PLANNERS: "experiment.problems must be at least one table",
    "[problems]\n" + PLANNERS: "experiment.problems must be at least one table",
    PROBLEMS + "[planners]": "experiment.planners must be at least one table",
    "seed = 3\n" + PROBLEMS + PLANNERS: "unknown key 'seed'; did you mean 'seeds'",
    "seeds = 0\n" + PROBLEMS + PLANNERS: "seeds must be a whole number from 1",
    "seeds = 2.5\n" + PROBLEMS + PLANNERS: "seeds must be a whole number",
    "seeds = []\n" + PROBLEMS + PLANNERS: "seeds must be at least one",
    "seeds = [1, 1]\n" + PROBLEMS + PLANNERS: "each once",
    'seeds = "three"\n' + PROBLEMS + PLANNERS: "seeds must be a number of seeds",
    "seeds = [-1]\n" + PROBLEMS + PLANNERS: "each of the seeds must be a whole number from 0",
    "repeat = 0\n" + PROBLEMS + PLANNERS: "repeat must be a whole number from 1",
    "time_limit = -1\n" + PROBLEMS + PLANNERS: "time_limit must be a positive number",
    "time_limit = inf\n" + PROBLEMS + PLANNERS: "time_limit must be a positive number",
    "name = 3\n" + PROBLEMS + PLANNERS: "experiment.name must be a string",
    "[problems.a]\n" + PLANNERS: "experiment.problems.a lacks 'file'",
    '[problems.a]\nfile = "none.map"\n' + PLANNERS: "none.map",
    '[problems.a]\nfile = "none.map"\nquery = 1.5\n'
    + PLANNERS: "experiment.problems.a.query must be a whole number",
    '[problems.a]\nworld = "moon"\n'
    + PLANNERS: "experiment.problems.a.world must be one of 'scattered polygons'",
    PROBLEMS + "width = 200\n" + PLANNERS: "width must be below 100",
    PROBLEMS + 'width = "wide"\n' + PLANNERS: "experiment.problems.a.width must be a number",
    PROBLEMS + "seed = 1\n" + PLANNERS: "experiment.problems.a has an unknown key 'seed'",
    PROBLEMS
    + '[planners.a]\nplanner = "rtt"': "experiment.planners.a.planner must be one of .*rrt",
    PROBLEMS + "[planners.a]\nstep_size = 3": "experiment.planners.a.planner must be one of",
    PROBLEMS
    + PLANNERS
    + "step = 3": "experiment.planners.a has an unknown key 'step'; did you mean 'step_size'",
    PROBLEMS + PLANNERS + "rng = 3": "unknown key 'rng'",
    PROBLEMS
    + PLANNERS
    + "max_nodes = 3.5": "experiment.planners.a.max_nodes must be a whole number",
    PROBLEMS
    + PLANNERS
    + "max_nodes = true": "experiment.planners.a.max_nodes must be a whole number",
    PROBLEMS
    + PLANNERS
    + "max_nodes = []": "experiment.planners.a.max_nodes must be a value, or a list",
    PROBLEMS + PLANNERS + "max_nodes = [5, 5]": "planners 'a' must differ",
    PROBLEMS
    + DRIVEN
    + "step = 0.1": "has an unknown key 'step'; known are planner, drives, goal_bias",
    PROBLEMS
    + DRIVEN
    + "drives.step = 0.1": "a.drives has an unknown key 'step'; did you mean 'time_step'",
    PROBLEMS + DRIVEN + "drives.trials = 2.5": "a.drives.trials must be a whole number",
    PROBLEMS + DRIVEN + "drives.trials = []": "a.drives.trials must be a value, or a list",
    PROBLEMS + DRIVEN + "drives.trials = 0": "trials must be a whole number from 1",
    PROBLEMS + DRIVEN + "drives = 8": "experiment.planners.a.drives must be an object",
}


def test_a_record_is_a_table(tmp_path):
    """Its keys are the record's parameters; a list of values stands for several planners."""
    file = tmp_path / "driven.toml"
    file.write_text(PROBLEMS + DRIVEN + "drives.trials = [8, 20]\ndrives.duration = 1")
    first, second = read_experiment(file).contestants
    assert first.function.keywords == {"drives": ke.Drives(trials=8, duration=1)}
    assert second.function.keywords == {"drives": ke.Drives(trials=20, duration=1)}
    assert [first.tuning, second.tuning] == ["drives.trials=8", "drives.trials=20"]


def test_a_record_that_may_be_none_is_a_table_too(tmp_path):
    """As SST's refinement, which is None by default."""
    file = tmp_path / "sparse.toml"
    driven = DRIVEN.replace("kinodynamic_rrt", "sst")
    file.write_text(PROBLEMS + driven + "sparsity.radius = 0.5\nrefinement.radius = 0.1")
    (only,) = read_experiment(file).contestants
    assert only.function.keywords == {
        "sparsity": ke.Sparsity(radius=0.5),
        "refinement": ke.Refinement(radius=0.1),
    }


@pytest.mark.parametrize("text", NONSENSE)
def test_a_nonsense_file_raises_a_named_error(text, tmp_path, capsys):
    """One line names the file, the key and what was expected; nothing is run or written."""
    file = tmp_path / "wrong.toml"
    file.write_text(text)
    with pytest.raises(KinoeduError, match=NONSENSE[text]) as caught:
        read_experiment(file)
    assert str(file) in str(caught.value) or "none.map" in str(caught.value)
    assert main(["experiment", str(file), "--out", str(tmp_path / "out")]) == 2
    complaints = [
        line for line in capsys.readouterr().err.splitlines() if not line.endswith(" ...")
    ]
    assert len(complaints) == 1
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        (lambda: Experiment({}, {"a": ke.rrt}), "problems must be a dict"),
        (
            lambda: Experiment({"": PROBLEM}, {"a": ke.rrt}),
            "name of a problem must be text",
        ),
        (lambda: Experiment({"a": PROBLEM}, {"": ke.rrt}), "name of a planner must be .* got ''"),
        (lambda: Experiment({"a": 3}, {"a": ke.rrt}), "problem 'a' must be a Problem"),
        (lambda: Experiment({"a": PROBLEM}, [ke.rrt]), "planners must be a dict"),
        (lambda: Experiment({"a": PROBLEM}, {"a": "rrt"}), "planner 'a' must be a function"),
        (lambda: Experiment({"a": PROBLEM}, {"a": []}), "planners 'a' must differ"),
        (
            lambda: Experiment({"a": PROBLEM}, {"a": partial(ke.rrt, step=3)}),
            "rrt has no argument 'step'; did you mean 'step_size'",
        ),
        (
            lambda: Experiment({"a": PROBLEM}, {"a": partial(ke.rrt, rng=3)}),
            "planner 'a': leave rng out",
        ),
        (lambda: run([1]), "run takes an Experiment"),
        (lambda: run(SMALL, where=3), "where must be"),
        (lambda: run(SMALL, workers=0), "workers must be a whole number"),
        (
            lambda: run(Experiment({"a": PROBLEM}, {"mine": lambda problem: None})),
            "'mine' exists only in this process",
        ),
        (
            lambda: run(Experiment({"a": PROBLEM}, {"a": partial(ke.prm, sampler=object())})),
            "an experiment takes functions",
        ),
    ],
)
def test_wrong_arguments_raise_named_errors(wrong, words):
    """Wrong arguments raise an error before anything is run."""
    with pytest.raises(InvalidParameter, match=words):
        wrong()


def test_a_column_of_words_has_no_values_for_figures():
    """The error names columns that have."""
    ran = run(Experiment({"a": PROBLEM}, {"A*": ke.plan_on_grid}), where="here")
    with pytest.raises(InvalidParameter, match="such as 'cost' or 'motions', got 'status'"):
        ran.values("status")


def test_a_digest_tells_values_and_functions_apart():
    """Digests are equal for equal values in every process, and different for different values."""
    values = [
        1,
        1.0,
        True,
        "1",
        None,
        [1],
        (1,),
        np.float64(1),
        np.array([1]),
        np.array([1.0]),
        {"a": 1},
        {1: "a"},
        ["a", "b"],
        ["ab"],
        ke.Drives(),
        ke.Drives(trials=8),
        ke.GoalRegion(),
    ]
    assert len({digest(value) for value in values}) == len(values)
    assert digest({"a": 1, "b": 2}) == digest({"b": 2, "a": 1})
    assert digest(ke.rrt) == digest(ke.rrt) != digest(ke.rrt_connect)
    assert digest(capturing(1)) == digest(capturing(1)) != digest(capturing(2))
    ask = (
        "from kinoedu.experiments.digests import digest; from kinoedu.experiments import "
        "narrow_passage; "
    )
    ran = subprocess.run(
        [sys.executable, "-c", ask + "print(digest(narrow_passage(2.0)))"],
        capture_output=True,
        text=True,
        check=True,
    )
    assert ran.stdout.strip() == digest(narrow_passage(2.0))


def capturing(value):
    """A function that captures a value."""
    return lambda problem: value


@pytest.mark.parametrize("n", [0, 1, 2, 7, 40, 100])
def test_scattered_polygons_never_meet(n):
    """Polygons are disjoint, start and goal are free, and the same seed gives the same world.

    So every planner, the exact ones too, accepts the world.
    """
    import shapely

    world = scattered_polygons(n, fill=0.95, rng=n).world
    polygons = [
        shapely.Polygon(np.array(ring)) for (ring,) in ke.worlds.polygon_world.rings_of(world)[1:]
    ]
    assert len(polygons) == n
    assert all(a.distance(b) > 0.0 for i, a in enumerate(polygons) for b in polygons[:i])
    assert digest(scattered_polygons(n, rng=3)) == digest(scattered_polygons(n, rng=3))


def test_csv_and_parquet_hold_the_table(table, tmp_path):
    """Both formats contain every row and column; other endings are rejected."""
    from pyarrow import parquet

    table.write(tmp_path / "t.csv")
    table.write(tmp_path / "t.parquet")
    with (tmp_path / "t.csv").open(newline="", encoding="utf-8") as stream:
        read = list(csv.DictReader(stream))
    assert [row["path"] for row in read] == table.column("path")
    assert [float(row["cost"]) for row in read] == table.column("cost")
    assert [
        tuple(row.values()) for row in parquet.read_table(tmp_path / "t.parquet").to_pylist()
    ] == [tuple(row) for row in table]
    with pytest.raises(KinoeduError, match="a table ends in"):
        table.write(tmp_path / "t.xlsx")
    assert sorted(file.name for file in tmp_path.iterdir()) == ["t.csv", "t.parquet"]


def test_a_summary_is_numpys_and_scipys(table):
    """Quartiles agree with numpy and Wilson's interval with scipy; one line for each planner."""
    from scipy.stats import binomtest

    for successes, runs in ((0, 1), (1, 1), (0, 30), (7, 30), (30, 30), (499, 500)):
        interval = binomtest(successes, runs).proportion_ci(method="wilson")
        assert success_fraction(successes, runs) == pytest.approx(
            (interval.low, successes / runs, interval.high), abs=1e-12
        )
    lines = summary(table)
    assert [(line.problem, line.tuning) for line in lines[:4]] == [
        ("rubble", ""),
        ("rubble", "n=20"),
        ("rubble", "n=40"),
        ("rubble", ""),
    ]
    for line in lines:
        costs = [r.cost for r in table if (r.problem, r.planner, r.tuning) == line[:3] and r.found]
        assert line.found == len(costs)
        assert tuple(line.cost) == pytest.approx(
            tuple(np.quantile(costs, (0.25, 0.5, 0.75))) if costs else (math.nan,) * 3, nan_ok=True
        )
    assert as_text(lines).count("\n") == len(lines)


def test_a_curve_of_shares_ends_where_the_rest_never_came():
    """The curve rises by one run at each value; its label is at its end; labels do not overlap."""
    from matplotlib import pyplot as plt

    values = {"a": [3.0, 1.0, np.inf, np.inf], "b": [2.0], "c": [2.0], "d": [np.inf]}
    _, ax = plt.subplots(figsize=(8, 5), layout="constrained")
    ke.figures.draw_ecdf(values, ax)
    ax.figure.canvas.draw()
    line = ax.lines[0]
    assert list(line.get_ydata()) == [0.0, 0.25, 0.5, 0.5]
    assert list(line.get_xdata())[1:3] == [1.0, 3.0]
    assert [curve.get_ydata()[-1] for curve in ax.lines] == [0.5, 1.0, 1.0, 0.0]
    boxes = [text.get_window_extent() for text in ax.texts]
    assert len(boxes) == 4
    assert not any(a.overlaps(b) for i, a in enumerate(boxes) for b in boxes[:i])
    plt.close()


def test_bars_and_growth_count_only_what_came():
    """A bar is a median of finite values; a curve begins where half of the seeds have a path."""
    from matplotlib import pyplot as plt

    artists = ke.figures.draw_medians({"a": [1.0, 2.0, 6.0, np.inf], "b": [np.inf]}, label="length")
    assert [bar.get_width() for bar in artists[0].axes.patches] == [2.0, 0.0]
    assert [text.get_text() for text in artists[0].axes.texts] == ["2  (3 of 4)", "none"]
    ax = ke.figures.draw_convergence(
        {"a": ([10, 20, 40], [[np.inf, np.inf, 9.0], [np.inf, 8.0, 8.0], [5.0, 6.0, 7.0]])}
    )[1].axes
    assert ax.lines[0].get_ydata() == pytest.approx([math.nan, 8.0, 6.0], nan_ok=True)
    for wrong in ({}, {"a": []}, {"a": [math.nan]}, [1.0]):
        with pytest.raises(KinoeduError):
            ke.figures.draw_ecdf(wrong)
    with pytest.raises(KinoeduError):
        ke.figures.draw_convergence({"a": ([1, 2], [[1.0, 2.0]])})
    with pytest.raises(KinoeduError, match=r"^colours"):
        ke.figures.draw_medians({"a": [1.0]}, colours=0)
    plt.close("all")


def test_the_command_writes_table_summary_and_plots(tmp_path, capsys):
    """The command also prints the summary; cells that were not run give status 1 and a reason."""
    file, out = tmp_path / "small.toml", tmp_path / "out"
    file.write_text(
        FILE.replace("40\n", "3\n", 1) + '[planners.bad]\nplanner = "rrt"\nstep_size = -1.0\n'
    )
    assert main(["experiment", str(file), "--out", str(out), "--workers", "1", "--plots"]) == 1
    output, err = capsys.readouterr()
    assert "12 runs; " in output
    assert "not run: bad: InvalidParameter: step_size must be a positive number" in output
    assert "running small: 0/12" in err
    assert (out / "summary.txt").read_text(encoding="utf-8") in output + "\n"
    pictures = {"1_rubble_medians.png", "1_rubble_ecdf.png", "1_rubble_growth.png"}
    assert {item.name for item in out.iterdir()} == {
        "results.csv",
        "summary.txt",
        "runs",
    } | pictures


def test_a_table_of_nothing_but_failures_is_drawn(tmp_path):
    """No empty picture is written, and no warning is raised."""
    shut = Experiment(
        {"a/b": narrow_passage(1e-6)},
        {"RRT": [partial(ke.rrt, max_nodes=n) for n in (5, 6)]},
        seeds=2,
    )
    assert [file.name for file in save_plots(run(shut, where="here"), tmp_path)] == [
        "1_a_b_medians.png",
        "1_a_b_ecdf.png",
    ]


def test_the_example_is_read_and_names_what_there_is():
    """The example beside the notebooks can be read; a file may name the planners listed here."""
    example = read_experiment(HOUSE / "notebooks" / "experiments" / "trees.toml")
    tunings = [one.tuning for one in example.contestants if one.name == "RRT*"]
    assert tunings == ["max_nodes=500", "max_nodes=1000", "max_nodes=2000"]
    assert len(example.seeds) == 50
    assert {"rrt", "rrt_connect", "prm", "rrt_star", "plan_on_grid", "plan_by_visibility"} <= set(
        planners_by_name()
    )
    assert "query" not in planners_by_name()


def counting(problem):
    """A planner without a path that counts with numpy."""
    return Plan(None, np.inf, stats={"nodes": np.int64(5), "iterations": "many"})


def test_counts_of_ones_own_planner_are_stored(tmp_path):
    """A number of numpy is a number, and a text is none; a second run finds the same."""
    experiment = Experiment({"rubble": PROBLEM}, {"counting": counting})
    for _ in range(2):
        ran = run(experiment, where="here", out=tmp_path)
        assert (ran.column("status"), ran.column("nodes")) == (["no path"], [5])


def test_here_a_run_without_a_path_is_timed_as_often_as_others():
    """The first call, which loads, is not the one that counts."""
    calls = []

    def slow_at_first(problem):
        calls.append(1)
        if len(calls) == 1:
            time.sleep(0.5)
        return Plan(None, np.inf, reason="no way")

    experiment = Experiment({"rubble": PROBLEM}, {"slow": slow_at_first}, repeat=3)
    ran = run(experiment, where="here")
    assert len(calls) == 4
    assert ran.column("seconds")[0] < 0.4


def test_what_took_longer_than_the_limit_is_run_again(tmp_path):
    """A table does not depend on the limits of earlier runs."""

    def slow(problem):
        time.sleep(0.3)
        return Plan(None, np.inf, reason="no way")

    statuses = []
    for limit in (5.0, 0.05):
        experiment = Experiment({"rubble": PROBLEM}, {"slow": slow}, time_limit=limit)
        statuses += run(experiment, where="here", out=tmp_path).column("status")
    assert statuses == ["no path", "out of time"]


def test_a_planner_may_start_processes(tmp_path):
    """They hold the run's pipes; the experiment ends all the same, and they with it."""
    note = tmp_path / "pid"
    planners = {"forks": partial(forks, note=str(note))}
    ran = run(Experiment({"rubble": PROBLEM}, planners), workers=1)
    assert set(ran.column("status")) <= {"found", "wrong"}
    process = Path(f"/proc/{note.read_text()}/stat")
    with suppress(OSError):  # it is gone
        while process.read_text().rpartition(") ")[2][0] != "Z":
            time.sleep(0.05)  # it was killed, and is about to end


@pytest.mark.parametrize(
    "text",
    [
        '{"status":"found","seconds":null}',
        '{"status":"found","cost":1,"seconds":0.1,"nodes":"x"}',
        "[]",
    ],
)
def test_a_result_with_values_of_other_kinds_is_run_again(tmp_path, text):
    experiment = Experiment({"rubble": PROBLEM}, {"rrt": partial(ke.rrt, max_nodes=10)}, seeds=1)
    first = run(experiment, where="here", out=tmp_path)
    (file,) = (tmp_path / "runs").glob("*.json")
    file.write_text(text)
    again = run(experiment, where="here", out=tmp_path)
    assert list(again.column("nodes")) == list(first.column("nodes"))


def test_a_planner_that_calls_itself_has_a_digest():
    def make():
        def again(problem, depth=0):
            return None if depth > 2 else again(problem, depth + 1)

        return again

    assert digest(make()) == digest(make())


def test_a_run_that_was_stopped_takes_no_planner_from_the_curves():
    """It has no nodes, and infinite cost: the median of the others' nodes counts."""
    row = Row("p", "rrt", "", 0, True, "found", 5.0, 0.1, 1, 1, 10, 10, "", "")
    rows = [
        row._replace(tuning=tuning, seed=seed, nodes=nodes + seed, cost=cost)
        for tuning, nodes, cost in (("few", 10, 9.0), ("many", 100, 6.0))
        for seed in range(3)
    ]
    rows[-1] = rows[-1]._replace(found=False, status="out of time", nodes=None, cost=math.inf)
    nodes, costs = Table(tuple(rows)).growth()["rrt"]
    assert nodes.tolist() == [11.0, 100.5]
    assert costs.tolist() == [[9.0] * 3, [6.0, 6.0, math.inf]]


@pytest.mark.parametrize("read", [read_experiment, is_polygon_map, ke.read_problem])
@pytest.mark.parametrize("path", [None, 5])
def test_what_is_no_path_is_refused_by_name(read, path):
    """As by all readers of files."""
    with pytest.raises(UnreadableScene, match="expected the path of a file"):
        read(path)

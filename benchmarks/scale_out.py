"""An experiment of 14 planners x 40 worlds x 200 seeds on local processes and on a Dask cluster by
its address: what it costs besides planning, whether the tables are equal, and whether it resumes
after a worker and the scheduler were killed.

    python benchmarks/scale_out.py [--worlds N] [--seeds N] [--waiting N]

More workers than cores are simulated: their runs wait instead of planning.
"""

import os
import tempfile
import time
from functools import partial
from pathlib import Path
from typing import NamedTuple

from cluster import Cluster
from processes import seconds_of
from timing import run
from waiting import PLANNING, wait

import kinoedu as ke
from kinoedu import experiments
from kinoedu.bench import surroundings
from kinoedu.experiments import Experiment, scattered_polygons
from kinoedu.experiments.experiment import ExperimentRecord
from kinoedu.experiments.table import Row, Table
from kinoedu.planners.roadmaps.prm import prm_star

CORES = 2
TABLE = """
| runs | where, workers | clock, s | client, s | scheduler, s | workers, s | planning, s | share |
|---:|---|---:|---:|---:|---:|---:|---:|"""
PLANNERS = {
    "RRT": [partial(ke.rrt, step_size=step) for step in (3.0, 5.0, 8.0)],
    "RRT-Connect": [partial(ke.rrt_connect, step_size=step) for step in (3.0, 8.0)],
    "RRT*": [partial(ke.rrt_star, max_nodes=n) for n in (500, 1000)],
    "informed RRT*": [partial(ke.informed_rrt_star, max_nodes=n) for n in (500, 1000)],
    "PRM": [partial(ke.prm, n=n) for n in (100, 300, 1000)],
    "PRM*": [partial(prm_star, n=n) for n in (100, 300)],
}


class Cost(NamedTuple):
    """What a run of an experiment took: the clock's seconds, and the processor's of each part.

    planning : the seconds of its runs, as the table has them.
    """

    clock: float
    client: float
    scheduler: float
    workers: float
    planning: float


def experiment_of(worlds: int, seeds: int) -> ExperimentRecord:
    """Worlds of 10 to 49 polygons, and 14 planners."""
    problems = {f"{10 + i} polygons": scattered_polygons(10 + i, rng=i) for i in range(worlds)}
    return Experiment(problems, PLANNERS, seeds=seeds)


def without_seconds(table: Table) -> list[Row]:
    """Rows that must be the same everywhere."""
    return [row._replace(seconds=0.0) for row in table]


def run_locally(experiment: ExperimentRecord, out: Path, workers: int) -> tuple[Table, Cost]:
    """An experiment on processes of this computer."""
    began, before = time.perf_counter(), os.times()
    table = experiments.run(experiment, workers=workers, out=out)
    clock, after = time.perf_counter() - began, os.times()
    client = after.user + after.system - before.user - before.system
    below = (after.children_user + after.children_system) - (
        before.children_user + before.children_system
    )
    return table, Cost(clock, client, 0.0, below, sum(table.column("seconds")))


def run_on(cluster: Cluster, experiment: ExperimentRecord, out: Path) -> tuple[Table, Cost]:
    """An experiment on a cluster."""
    began, client, there = time.perf_counter(), seconds_of([os.getpid()]), cluster.seconds()
    table = experiments.run(experiment, where=cluster.address, out=out)
    clock, now = time.perf_counter() - began, cluster.seconds()
    mine = seconds_of([os.getpid()]) - client
    seconds = sum(table.column("seconds"))
    return table, Cost(clock, mine, now[0] - there[0], now[1] - there[1], seconds)


def report(where: str, runs: int, cost: Cost) -> None:
    """A line of the table; the last column is the share of planning in what workers take."""
    each = " | ".join(f"{part:.1f}" for part in cost)
    print(f"| {runs:,} | {where} | {each} | {cost.planning / cost.workers:.0%} |", flush=True)


def interrupted(folder: Path, experiment: ExperimentRecord) -> tuple[Table, str]:
    """Kill a worker when a quarter is done, the scheduler after half, and continue on others.

    Returns
    -------
    The table, and what was kept.
    """
    out, deaths = folder / "out", [(0.5, "scheduler"), (0.25, "worker")]
    with Cluster(folder, CORES) as cluster:
        cluster.wait_for_workers()

        def progress(done: int, everything: int) -> None:
            if deaths and done > deaths[-1][0] * everything:
                dies = deaths.pop()[1]
                (cluster.workers[0] if dies == "worker" else cluster.scheduler).kill()

        try:
            experiments.run(experiment, where=cluster.address, out=out, progress=progress)
            raise AssertionError("the experiment outlived its scheduler")
        except ConnectionError as error:
            message = str(error)
    kept = {file: file.stat().st_mtime_ns for file in (out / "runs").iterdir()}
    counts: list[tuple[int, int]] = []
    with Cluster(folder / "anew", CORES) as cluster:
        cluster.wait_for_workers()
        table = experiments.run(
            experiment, where=cluster.address, out=out, progress=lambda *n: counts.append(n)
        )
    assert counts[0][0] == len(kept) and len(counts) == len(table) - len(kept) + 1
    assert all(file.stat().st_mtime_ns == then for file, then in kept.items()), "made again"
    return table, f"{message}\n{len(kept):,} runs were kept, {len(counts) - 1:,} made later"


def simulate(folder: Path, workers: int, runs: int) -> str:
    """How busy workers are whose runs wait, and which therefore need few cores."""
    experiment = Experiment({"any": scattered_polygons(1, rng=0)}, {"waits": wait}, seeds=runs)
    first = experiment._replace(seeds=tuple(range(runs, runs + 10 * workers)))
    with Cluster(folder, workers) as cluster:
        cluster.wait_for_workers()
        experiments.run(first, where=cluster.address)  # starts the workers' processes
        _, cost = run_on(cluster, experiment, folder / "out")
    busy = runs * PLANNING / (workers * cost.clock)
    return f"{workers} workers, {runs:,} runs that wait {PLANNING:g} s: {busy:.0%} of the time"


def main(worlds: int = 40, seeds: int = 200, waiting: int = 8) -> None:
    """A tenth of the worlds everywhere; the whole here, and interrupted; waiting workers."""
    part, whole = (experiment_of(count, seeds) for count in (max(1, worlds // 10), worlds))
    print(f"{surroundings()}\n{TABLE}")
    with tempfile.TemporaryDirectory() as name:
        folder, tables = Path(name), []
        for workers in (1, CORES):
            table, cost = run_locally(part, folder / f"local{workers}", workers)
            report(f"local, {workers}", len(table), cost)
            tables.append(without_seconds(table))
        for workers in (1, CORES):
            with Cluster(folder / f"dask{workers}", workers) as cluster:
                cluster.wait_for_workers()
                table, cost = run_on(cluster, part, folder / f"out{workers}")
            report(f"Dask, {workers}", len(table), cost)
            tables.append(without_seconds(table))
        assert all(table == tables[0] for table in tables), "the tables differ"
        table, cost = run_locally(whole, folder / "whole", CORES)
        report(f"local, {CORES}", len(table), cost)
        resumed, kept = interrupted(folder / "interrupted", whole)
        assert without_seconds(resumed) == without_seconds(table), "the tables differ"
        print(f"\n{kept}; the table is the same")
        print(f"\n{simulate(folder / 'waiting', waiting, 250 * waiting)}")


if __name__ == "__main__":
    run(main)

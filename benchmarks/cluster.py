"""A Dask cluster of processes of this computer, known by its address as one of many computers is,
and the processor's time that each part of it takes.
"""

import os
import subprocess
import sys
import time
from pathlib import Path
from typing import Self

from processes import below, seconds_of

START = 300.0  # seconds for a scheduler to write its address, on a busy computer


class Cluster:
    """A scheduler and its workers, which `with` ends."""

    def __init__(self, folder: Path, workers: int, threads: int = 1) -> None:
        folder.mkdir(parents=True, exist_ok=True)
        self.folder, self.log = folder, (folder / "log.txt").open("wb")
        self.scheduler = self.start("scheduler", "--host", "127.0.0.1", "--port", "0")
        self.workers: list[subprocess.Popen[bytes]] = []
        try:
            self.address = self.wait_for_address()
        except BaseException:
            self.__exit__()
            raise
        self.workers = [self.start_worker(threads) for _ in range(workers)]

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        for process in (*self.workers, self.scheduler):
            process.kill()  # a worker without its scheduler may not end by itself
        for process in (*self.workers, self.scheduler):
            process.wait()
        self.log.close()

    def start(self, *words: str) -> "subprocess.Popen[bytes]":
        """Start a program of Dask. The scheduler writes its address to standard error."""
        command = [sys.executable, "-m", "dask", *words, "--no-dashboard"]
        paths = os.pathsep.join([str(Path(__file__).parent), os.environ.get("PYTHONPATH", "")])
        return subprocess.Popen(
            command, stderr=self.log, stdout=self.log, env={**os.environ, "PYTHONPATH": paths}
        )

    def start_worker(self, threads: int = 1) -> "subprocess.Popen[bytes]":
        """Start a worker without a nanny, which would start another one when it is killed."""
        there = ["--local-directory", str(self.folder), "--nthreads", str(threads), "--no-nanny"]
        return self.start("worker", self.address, *there)

    def wait_for_address(self) -> str:
        """The address of the scheduler. Raises TimeoutError."""
        end = time.monotonic() + START
        while time.monotonic() < end:
            for line in (self.folder / "log.txt").read_text(encoding="utf-8").splitlines():
                if "Scheduler at:" in line:
                    return line.split()[-1]
            time.sleep(0.05)
        raise TimeoutError("the scheduler did not start")

    def wait_for_workers(self) -> None:
        """Wait until all workers have come."""
        from distributed import Client

        with Client(self.address, set_as_default=False) as client:
            client.wait_for_workers(len(self.workers), timeout=START)

    def seconds(self) -> tuple[float, float]:
        """The processor's seconds of the scheduler, and of the workers with all they started."""
        own = [process.pid for process in self.workers]
        started = [child for process in own for child in below(process)]
        return seconds_of([self.scheduler.pid]), seconds_of([*own, *started])

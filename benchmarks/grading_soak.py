"""A class is graded while its workers are killed again and again, and the grader itself: is every
submission graded once, and as if nothing had happened?
"""

import argparse
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from processes import below

HOUSE = Path(__file__).resolve().parent.parent
SECRET = b"a secret of the soak, no course's"
ATTACKERS = 0.05
GRADER = """
import sys
from pathlib import Path
from kinoedu.grading.judge.running import grade_all, use_dask_workers, use_local_workers
from kinoedu.grading.collect.submissions import collect
if __name__ == "__main__":
    workers = sys.argv[3]
    place = use_local_workers(int(workers)) if workers.isdigit() else use_dask_workers(workers)
    submissions, secret = collect(Path(sys.argv[1])), bytes.fromhex(sys.argv[4])
    graded = grade_all(submissions, Path(sys.argv[2]), secret, place=place)
    sys.exit(any(one.grade is None for one in graded))
"""


def class_of(
    size: int, folder: Path, attackers: float = ATTACKERS, attacks: list[str] | None = None
) -> None:
    """Write submissions: the solution or the empty exercise, a little different each, and attacks
    among them.
    """
    rng = random.Random(size)
    books = [
        json.loads((HOUSE / room / "01_geometry.ipynb").read_text(encoding="utf-8"))
        for room in ("solutions", "exercises")
    ]
    files = [
        file
        for file in sorted((HOUSE / "tests" / "attacks").glob("*.cells"))
        if attacks is None or file.stem in attacks
    ]
    for number in range(size):
        book = dict(rng.choice(books))
        if number < attackers * size:
            text = rng.choice(files).read_text(encoding="utf-8")
            first = "HARM = []\ndef fails(words, action): pass\n"
            # the check shows that it is no wrong file
            sources = [first, *text.split("# %%\n"), "check(line_through_points)"]
            book["cells"] = [
                {"cell_type": "code", "metadata": {}, "outputs": [], "source": source}
                for source in sources
            ]
        book["metadata"] = {**book["metadata"], "student": number}
        place = folder / f"student{number:03d}" / "01_geometry.ipynb"
        place.parent.mkdir(parents=True)
        place.write_text(json.dumps(book), encoding="utf-8")


def grader(submissions: Path, out: Path, place: str) -> "subprocess.Popen[bytes]":
    """Start to grade a class."""
    program = out.parent / "grade.py"  # a file, since workers that are started anew read it again
    program.write_text(GRADER, encoding="utf-8")
    return subprocess.Popen(
        [sys.executable, str(program), str(submissions), str(out), place, SECRET.hex()]
    )


def results(out: Path) -> dict[str, bytes]:
    """What is kept so far, by its name."""
    return {file.name: file.read_bytes() for file in sorted((out / "results").glob("*.json"))}


def workers(parent: int) -> list[int]:
    """A grader's own workers: the children that were spawned to work."""
    found = []
    for child in below(parent):
        try:
            words = Path(f"/proc/{child}/cmdline").read_bytes()
        except OSError:
            continue
        if b"spawn_main" in words and b"tracker_fd" in words:
            found.append(child)
    return found


def soaked(
    submissions: Path, out: Path, place: str, *, every: int, grader_dies_at: int
) -> tuple[int, int]:
    """Grade a class; after every so many results a worker is killed, once the grader. How many
    were, and the last status.
    """
    rng = random.Random(every)
    killed, last, died = 0, 0, False
    one = grader(submissions, out, place)
    while one.poll() is None:
        time.sleep(0.05)
        done = len(results(out))
        if not died and done >= grader_dies_at:
            died, orphans = True, below(one.pid)
            one.send_signal(signal.SIGKILL)
            one.wait()
            wait_for_end(orphans)
            one = grader(submissions, out, place)
        elif done >= last + every and workers(one.pid):
            killed, last = killed + 1, done
            os.kill(rng.choice(workers(one.pid)), signal.SIGKILL)
    return killed, int(one.returncode)


def wait_for_end(processes: list[int], seconds: float = 30.0) -> None:
    """Wait until processes have ended. Raises TimeoutError where they do not."""
    end = time.monotonic() + seconds
    while alive := [process for process in processes if Path(f"/proc/{process}/exe").exists()]:
        if time.monotonic() > end:
            raise TimeoutError(f"processes {alive} outlive the grader")
        time.sleep(0.1)


def main() -> None:
    """Grade a class undisturbed and disturbed, and compare."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument(
        "submissions", nargs="?", type=int, default=300, help="default: %(default)s"
    )
    options.add_argument(
        "workers",
        nargs="?",
        default="2",
        help="or a Dask scheduler's address; default: %(default)s",
    )
    given = options.parse_args()
    size, place = given.submissions, given.workers
    with tempfile.TemporaryDirectory() as folder:
        home = Path(folder)
        class_of(size, home / "class")
        begin = time.monotonic()
        grader(home / "class", home / "calm", place).wait()
        calm = time.monotonic() - begin
        killed, status = soaked(
            home / "class",
            home / "soaked",
            place,
            every=max(4, size // 60),
            grader_dies_at=size // 2,
        )
        ours, theirs = results(home / "calm"), results(home / "soaked")
    same = sum(ours.get(name) == data for name, data in theirs.items())
    print(
        f"{size} submissions, {calm:.0f} s undisturbed; {killed} workers and the grader killed, "
        f"status {status}"
    )
    print(f"graded {len(theirs)} of {len(ours)}, {same} of them to the same byte")


if __name__ == "__main__":
    main()

"""The first `check()` of every exercise: a new process with an empty cache of machine code judges
the right program. A right program that is refused, because the computer was slow or busy or had to
compile, ends the script with an error.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HOUSE = Path(__file__).resolve().parent.parent
sys.path.append(str(HOUSE / "tests"))


def first_check(name: str, cache: str) -> tuple[bool, float]:
    """Whether the right program of an exercise is accepted, and the seconds of the process."""
    began = time.perf_counter()
    done = subprocess.run(
        [sys.executable, __file__, "--alone", name],
        env=os.environ | {"KINOEDU_CACHE": cache},
        check=True,
        capture_output=True,
        text=True,
    )
    return bool(json.loads(done.stdout.splitlines()[-1])), time.perf_counter() - began


def check_alone(name: str) -> None:
    """Check the right program of one exercise in this process, and print whether it is accepted."""
    from judged_programs import right_programs

    from kinoedu.course import EXERCISES, check

    lesson = EXERCISES[name].lesson
    programs = right_programs(HOUSE, lesson)
    program = next(program for one, variant, program in programs if (one, variant) == (name, ""))
    print("\n" + json.dumps(check(program, name).report.is_right))


def main() -> None:
    """Check one exercise after another, and print a table."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("exercises", nargs="*", help="names; all, if left out")
    options.add_argument("--alone", metavar="EXERCISE", help=argparse.SUPPRESS)
    given = options.parse_args()
    if given.alone:
        check_alone(given.alone)
        return
    from kinoedu.course import EXERCISES

    refused = []
    print("| exercise | accepted | s |\n|---|---|---:|")
    for name in given.exercises or EXERCISES:
        with tempfile.TemporaryDirectory() as cache:
            is_right, seconds = first_check(name, cache)
        refused += [] if is_right else [name]
        print(f"| {name} | {'yes' if is_right else 'NO'} | {seconds:.1f} |", flush=True)
    print(f"\nrefused: {', '.join(refused) or 'none'}")
    raise SystemExit(bool(refused))


if __name__ == "__main__":
    main()

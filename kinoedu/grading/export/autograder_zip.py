"""The zip of which Gradescope makes an autograder.

It holds the library with its judges, the questions of one assignment without their answers, the
secret from which hidden cases are drawn, and two scripts:

    setup.sh          run once, as root, when the container is built
    run_autograder    run, as root, for each submission
    course_secret     readable by root only
    kinoedu-course/   the library, start.py, the questions
"""

import os
from collections.abc import Iterator
from pathlib import Path

from ...course.release import HOUSE, Packed, is_generated, remove_answers, solution_path, write_zip
from ...course.section import choose_for_section
from ..assignments.questions import read_assignment

COURSE = "kinoedu-course"
SECRET = "course_secret"
FILES = ("LICENSE", "start.py", "pyproject.toml", "environment.txt")

SETUP = f"""\
#!/usr/bin/env bash
# Run once, as root, when Gradescope builds the container. It installs Python, bubblewrap and \
the course's packages, and compiles what is slow to compile.
set -euo pipefail
here="$(cd "$(dirname "$0")" && pwd)"
export DEBIAN_FRONTEND=noninteractive
apt-get update
apt-get install -y --no-install-recommends bubblewrap ca-certificates python3 python3-venv
python=python3
if ! python3 -c 'import sys; sys.exit(sys.version_info < (3, 11))'; then
    apt-get install -y --no-install-recommends python3.11 python3.11-venv  \
# Ubuntu 22.04 has it beside its 3.10
    python=python3.11
fi
chmod 600 "$here/{SECRET}"
chmod -R a+rX "$here/{COURSE}"
KINOEDU_CACHE="$here/cache" "$python" "$here/{COURSE}/start.py" warm
"""

RUN = f"""\
#!/usr/bin/env bash
# Run, as root, for each submission. To try it elsewhere, `run_autograder ROOT` takes another \
folder in place of /autograder.
set -euo pipefail
root="${{1:-/autograder}}"
course="$root/source/{COURSE}"
chmod 600 "$root/source/{SECRET}"
chmod go-w "$root/results"
export PYTHONPATH="$course" KINOEDU_CACHE="${{KINOEDU_CACHE:-$root/source/cache}}"
exec "${{KINOEDU_PYTHON:-$course/.venv/bin/python}}" -P -m kinoedu \\
    autograde "$root" --assignment ASSIGNMENT --secret "$root/source/{SECRET}"OPTIONS
"""


def pack_autograder(
    zip_file: str | os.PathLike[str],
    name: str,
    secret: bytes,
    *,
    container_is_wall: bool = False,
    letter: str = "",
    house: Path = HOUSE,
) -> int:
    """Write the zip for an assignment. It contains the secret, so keep it private.

    Parameters
    ----------
    container_is_wall : run programs without a sandbox where none can be made in the container.
    letter : the variant of the section, such as B, or "" for the usual form.

    Returns
    -------
    int
        The number of files.

    Raises
    ------
    InvalidParameter
        Where there is no such assignment, or no variant of that letter.
    """
    options = " --trust-container" if container_is_wall else ""
    task = read_assignment(name, house)  # refuse what could not be graded
    if letter:
        choose_for_section([one.exercise for one in task.questions], letter)
        options += f" --variant {letter}"
    run = RUN.replace("ASSIGNMENT", name).replace("OPTIONS", options)
    files = [
        Packed("setup.sh", SETUP.encode(), 0o755),
        Packed("run_autograder", run.encode(), 0o755),
        Packed(SECRET, secret.hex().encode() + b"\n", 0o600),
        Packed(f"{COURSE}/solutions/{name}.ipynb", read_questions(solution_path(name, house))),
        *pack_library(house),
    ]
    write_zip(zip_file, files, 0o600)
    return len(files)


def read_questions(file: Path) -> bytes:
    """A solution notebook as the grader reads it, without the answers."""
    import nbformat

    return (str(nbformat.writes(remove_answers(file))) + "\n").encode()


def pack_library(house: Path) -> Iterator[Packed]:
    """Yield the files of the library and its installer; no solution, no bank, no tests."""
    for file in [house / name for name in FILES] + sorted((house / "kinoedu").rglob("*")):
        if file.is_file() and not is_generated(file):
            yield Packed(f"{COURSE}/{file.relative_to(house).as_posix()}", file.read_bytes())

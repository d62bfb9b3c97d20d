"""Makes a site on which the lessons run in the reader's browser, without a server: python
jupyterlite/build.py FOLDER.

Needs environment.txt and jupyterlite/environment.txt in the Python that runs it. Whoever serves
FOLDER serves the course; the browser fetches Pyodide, and packages that are not in the site, from
the network.
"""

import json
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

HOUSE = Path(__file__).resolve().parent.parent
ROOMS = ("notebooks", "exercises")
# nothing compiles for a browser, and the page is the lab
ELSEWHERE = {"jupyterlab", "numba"}


def packages() -> list[str]:
    """What kinoedu stands on in a browser, in whatever version Pyodide has."""
    project = tomllib.loads((HOUSE / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    return [
        name
        for name in (re.match(r"[\w-]+", line)[0] for line in project["dependencies"])
        if name not in ELSEWHERE
    ]


def first_cell() -> dict[str, object]:
    """Brings kinoedu into the browser's Python; the wheel comes with the site."""
    source = (
        "# runs in your browser: the first time this takes a minute\n%pip install -q "
        f"{' '.join(packages())}\n"
    )
    source += "%pip install -q --no-deps kinoedu"
    return {
        "cell_type": "code",
        "id": "bring",
        "metadata": {},
        "source": source,
        "outputs": [],
        "execution_count": None,
    }


def unpack_kit(folder: Path) -> Path:
    """What students get: the course without answers."""
    command = "import sys; from kinoedu.course.release import pack_course as p; p(sys.argv[1])"
    folder.mkdir()
    packed = folder / "course.zip"
    subprocess.run([sys.executable, "-c", command, str(packed)], cwd=HOUSE, check=True)
    shutil.unpack_archive(packed, folder)
    return folder / "kinoedu-course"


def copy_lessons(kit: Path, folder: Path) -> None:
    """Lessons, exercises and maps, each notebook with the first cell and for the browser's
    kernel.
    """
    for room in ROOMS:
        shutil.copytree(
            kit / room, folder / room, ignore=shutil.ignore_patterns(".*", "__pycache__")
        )
        for file in (folder / room).glob("*.ipynb"):
            book = json.loads(file.read_text(encoding="utf-8"))
            book["cells"].insert(0, first_cell())
            book["metadata"]["kernelspec"] = {
                "display_name": "Python (Pyodide)",
                "language": "python",
                "name": "python",
            }
            file.write_text(json.dumps(book, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")


def main() -> None:
    """Build the wheel, copy the lessons, and let JupyterLite make the site."""
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    site = Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as workshop:
        work = Path(workshop)
        shutil.copy(HOUSE / "jupyterlite" / "overrides.json", work)
        kit = unpack_kit(work / "kit")
        copy_lessons(kit, work / "contents")
        for room in ROOMS:  # the site has them beside the package
            shutil.rmtree(kit / room)
        subprocess.run(
            [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(work / "wheels")],
            cwd=kit,
            check=True,
        )
        (wheel,) = (work / "wheels").glob("kinoedu-*.whl")
        command = [
            sys.executable,
            "-m",
            "jupyterlite_core",
            "build",
            "--lite-dir",
            str(work),
            "--contents",
            str(work / "contents"),
        ]
        command += [
            "--output-dir",
            str(site),
            "--apps",
            "lab",
            "--no-sourcemaps",
            f"--piplite-wheels={wheel}",
        ]
        subprocess.run(command, cwd=work, check=True)


if __name__ == "__main__":
    main()

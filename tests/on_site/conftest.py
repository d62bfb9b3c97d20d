"""The site that the files here look at."""

import subprocess
import sys
from pathlib import Path

import pytest

HOUSE = Path(__file__).resolve().parent.parent.parent


@pytest.fixture(scope="package")
def site(tmp_path_factory):
    """The folder of the site, built with every warning an error."""
    folder, trees = tmp_path_factory.mktemp("site"), tmp_path_factory.mktemp("doctrees")
    command = [
        sys.executable,
        "-P",
        "-m",
        "sphinx",
        "-W",
        "--keep-going",
        "-q",
        "-j",
        "auto",
        "-c",
        "docs",
        "-d",
        trees,
        ".",
        folder,
    ]
    built = subprocess.run(
        command, cwd=HOUSE, capture_output=True, text=True, encoding="utf-8", errors="replace"
    )
    assert (built.returncode, built.stderr) == (0, "")
    return folder

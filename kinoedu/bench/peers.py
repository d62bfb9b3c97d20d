"""Installs the libraries that kinoedu is compared with, on demand and one by one.

A library that cannot be installed is left out.
"""

import importlib.util
import re
import shutil
import subprocess
import sys
from pathlib import Path

from .surroundings import installed

ONLY_WHEELS = ["--only-binary", ":all:"]
PINS = ("environment.txt", "solutions/environment.txt", "tests/environment.txt")


def named_peers(file: Path) -> list[str]:
    """Requirements in a file, without comments."""
    lines = (
        line.partition("#")[0].strip() for line in file.read_text(encoding="utf-8").splitlines()
    )
    return [line for line in lines if line]


def install_peer(peer: str, file: Path) -> str:
    """Install one of a file's peers, with uv where it is available, otherwise with pip.

    The versions that the course pins are kept: a peer that needs another version is not installed.

    Returns
    -------
    str
        What went wrong, or "".
    """
    house = file.resolve().parent.parent
    keep = [
        text
        for name in PINS
        if (house / name).is_file()
        for text in ("--constraint", str(house / name))
    ]
    name, _, pin = peer.partition("==")
    if pin and installed(name) == pin:
        return ""
    if uv := shutil.which("uv"):
        install = [uv, "pip", "install", "--python", sys.executable]
        return run_installer([*install, *ONLY_WHEELS, *keep, peer])
    python = [sys.executable, "-I", "-m"]
    if importlib.util.find_spec("pip") is None and (wrong := run_installer([*python, "ensurepip"])):
        return wrong
    quiet = ["--no-input", "--disable-pip-version-check"]
    return run_installer([*python, "pip", "install", *quiet, *ONLY_WHEELS, *keep, peer])


def run_installer(command: list[str]) -> str:
    """Run an installer, and return the end of its output where it failed, otherwise ""."""
    ran = subprocess.run(
        command,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        check=False,
    )
    if ran.returncode == 0:
        return ""
    output = re.sub(r"[^\w\s.,:;=<>'\"()/+-]", " ", ran.stdout.decode("utf-8", "replace")).split()
    return " ".join(output)[-300:] or f"{Path(command[0]).name} ended with status {ran.returncode}"

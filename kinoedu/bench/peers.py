"""The libraries that kinoedu is timed beside, installed on demand, each by itself: one that cannot
be had is only missed.
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
    """What a file of requirements names."""
    lines = (
        line.partition("#")[0].strip() for line in file.read_text(encoding="utf-8").splitlines()
    )
    return [line for line in lines if line]


def install_peer(peer: str, file: Path) -> str:
    """Install one of a file's peers, with uv where that is to be had, otherwise with pip; what went
    wrong, or "".

    What the course itself pins is kept as it is: a peer that needs another version of it is not
    installed.
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
        return trouble(
            [uv, "pip", "install", "--python", sys.executable, *ONLY_WHEELS, *keep, peer]
        )
    python = [sys.executable, "-I", "-m"]
    if importlib.util.find_spec("pip") is None and (wrong := trouble([*python, "ensurepip"])):
        return wrong
    return trouble(
        [
            *python,
            "pip",
            "install",
            "--no-input",
            "--disable-pip-version-check",
            *ONLY_WHEELS,
            *keep,
            peer,
        ]
    )


def trouble(command: list[str]) -> str:
    """Run an installer; its last words where it failed, in one line."""
    ran = subprocess.run(
        command,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        check=False,
    )
    if ran.returncode == 0:
        return ""
    words = re.sub(r"[^\w\s.,:;=<>'\"()/+-]", " ", ran.stdout.decode("utf-8", "replace")).split()
    return " ".join(words)[-300:] or f"{Path(command[0]).name} ended with status {ran.returncode}"

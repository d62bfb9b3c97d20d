"""Writes the second half of licences.md: every pinned package with its licence, as its own metadata
tells it, and who needs it.

python docs/licences.py, where all packages to be listed are installed. The line of a package that
is not installed here, as it is for another system, is kept; one without such a line is named, to be
written by hand.
"""

import re
import sys
from importlib.metadata import Distribution, distributions
from pathlib import Path

HOUSE = Path(__file__).resolve().parent.parent
PAGE = HOUSE / "docs" / "licences.md"
HEADING = "## Packages"
ROW = re.compile(r"^\| ([a-z0-9-]+) \|.*\|$", re.MULTILINE)


def canonical(name: str) -> str:
    """A package's name as package indexes spell it."""
    return re.sub(r"[-_.]+", "-", name).lower()


def environments() -> list[Path]:
    """The files that pin: the course's own first."""
    return [HOUSE / "environment.txt", *sorted(HOUSE.glob("[a-z]*/environment.txt"))]


def pinned(file: Path) -> list[str]:
    """The packages of a file, each once, in order."""
    names = re.findall(r"^([A-Za-z0-9._-]+)==", file.read_text(encoding="utf-8"), re.MULTILINE)
    return sorted(set(map(canonical, names)))


def licence(package: Distribution) -> str:
    """In the package's own words: an SPDX expression, or else a line of its own, or else its
    classifiers.
    """
    metadata = package.metadata
    expression, own = metadata.get("License-Expression"), (metadata.get("License") or "").strip()
    if expression or (own and len(own) < 50 and "\n" not in own and own != "UNKNOWN"):
        return expression or own
    classifiers = [
        line.rpartition(" :: ")[2]
        for line in metadata.get_all("Classifier") or []
        if line.startswith("License ::")
    ]
    return ", ".join(classifiers)


def asks(package: Distribution, *, extras: bool) -> set[str]:
    """What a package asks for, in its extras or outside of those; extras for its own makers are
    left out.
    """
    lines = [line for line in package.requires or [] if extras == ("extra ==" in line)]
    return {
        canonical(re.match(r"[\w.-]+", line)[0])
        for line in lines
        if not re.search("extra == .(dev|doc|test|lint)", line)
    }


def users(name: str, installed: dict[str, Distribution], *, extras: bool) -> list[str]:
    """Which packages ask for one."""
    return sorted(
        other for other, package in installed.items() if name in asks(package, extras=extras)
    )


def rows(
    file: Path, installed: dict[str, Distribution], kept: dict[str, str], course: set[str]
) -> list[str]:
    """The table of a file: the course's own choices are marked; for others the packages that need
    them are named.
    """
    table = [
        "",
        f"### `{file.relative_to(HOUSE).as_posix()}`",
        "",
        "| package | licence | needed by |",
        "|---|---|---|",
    ]
    for name in pinned(file):
        if name in installed and licence(installed[name]):
            who = (["**kinoedu**"] if name in course else []) + users(name, installed, extras=False)
            who = who or users(name, installed, extras=True) or ["**kinoedu**"]
            table.append(f"| {name} | {licence(installed[name])} | {', '.join(who)} |")
        else:
            table.append(kept.get(name, f"| {name} | ? | ? |"))
    return table


def main() -> None:
    """Write the page anew; complain of what is to be written by hand."""
    text = PAGE.read_text(encoding="utf-8")
    pins = {name for file in environments() for name in pinned(file)}
    installed = {
        canonical(package.name): package
        for package in distributions()
        if canonical(package.name) in pins
    }
    kept = {row[1]: row[0] for row in ROW.finditer(text)}
    chosen = re.findall(
        r'^    "([A-Za-z0-9._-]+)[^"]*",',
        (HOUSE / "pyproject.toml").read_text(encoding="utf-8"),
        re.MULTILINE,
    )
    tables = [
        row
        for file in environments()
        for row in rows(file, installed, kept, set(map(canonical, chosen)))
    ]
    PAGE.write_text(
        text.partition(HEADING)[0] + HEADING + "\n" + "\n".join(tables) + "\n", encoding="utf-8"
    )
    missing = [row.split()[1] for row in tables if "| ? |" in row]
    if missing:
        sys.exit(f"to be written by hand in {PAGE.name}: {', '.join(missing)}")


if __name__ == "__main__":
    main()

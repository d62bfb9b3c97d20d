"""The rooms of kinoedu and who imports whom, as a picture: python docs/house_picture.py draws
docs/house.svg.

A row of the picture is a layer of the contract in pyproject.toml. Every arrow goes down. An import
is not drawn where a way along others leads there as well.
"""

import ast
import tomllib
from collections.abc import Iterator
from pathlib import Path

HOUSE = Path(__file__).resolve().parent.parent
PICTURE = HOUSE / "docs" / "house.svg"
WIDTH, ROW, BOX, TALL = 900, 62, 124, 30
TOP = {"kinoedu", "kinoedu.__main__"}


def modules() -> dict[str, Path]:
    """The files of the package by the names of their modules."""
    found = {}
    for file in sorted((HOUSE / "kinoedu").rglob("*.py")):
        parts = file.relative_to(HOUSE).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = file
    return found


def imports() -> Iterator[tuple[str, str]]:
    """All pairs of modules of which one imports the other, anywhere in its file."""
    known = modules()
    for name, file in known.items():
        package = name.split(".") if file.name == "__init__.py" else name.split(".")[:-1]
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom):
                above = package[: len(package) - node.level + 1] if node.level else []
                base = ".".join([*above, *filter(None, [node.module])])
                for thing in node.names:
                    other = f"{base}.{thing.name}" if f"{base}.{thing.name}" in known else base
                    if other in known and name != other:
                        yield name, other


def layers() -> list[list[str]]:
    """The rooms, layer by layer, as the contract has them; the top one is left out."""
    contracts = tomllib.loads((HOUSE / "pyproject.toml").read_text(encoding="utf-8"))["tool"][
        "importlinter"
    ]["contracts"]
    rows = [[room.strip() for room in layer.split("|")] for layer in contracts[0]["layers"]]
    return [row for row in rows if not TOP & set(row)]


def drawn() -> str:
    """The picture as SVG."""
    rows = layers()
    place = {
        room: ((i + 0.5) * WIDTH / len(row), ROW * (j + 0.5))
        for j, row in enumerate(rows)
        for i, room in enumerate(row)
    }
    pairs = {(room_of(a), room_of(b)) for a, b in imports() if not TOP & {a, b}} - {
        (room, room) for room in place
    }
    frame = f'viewBox="0 0 {WIDTH} {ROW * len(rows)}" font-family="sans-serif" font-size="15"'
    text = [
        f'<svg xmlns="http://www.w3.org/2000/svg" {frame}>',
        '<rect width="100%" height="100%" fill="#fff"/>',
    ]
    text.append(
        '<marker id="tip" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="7" markerHeight="7" '
        'orient="auto">'
    )
    text.append('<path d="M0 0L8 4L0 8z" fill="#557"/></marker>')
    for a, b in sorted(pair for pair in pairs if not is_implied(*pair, pairs)):
        (x, y), (u, v) = place[a], place[b]
        line = f"M{x:.0f} {y + TALL / 2:.0f}L{u:.0f} {v - TALL / 2:.0f}"
        text.append(f'<path d="{line}" stroke="#557" stroke-opacity=".6" marker-end="url(#tip)"/>')
    for room, (x, y) in place.items():
        corner = f'x="{x - BOX / 2:.0f}" y="{y - TALL / 2:.0f}"'
        text.append(
            f'<rect {corner} width="{BOX}" height="{TALL}" rx="6" fill="#eef" stroke="#557"/>'
        )
        name = room.removeprefix("kinoedu.")
        text.append(f'<text x="{x:.0f}" y="{y + 5:.0f}" text-anchor="middle">{name}</text>')
    return "\n".join([*text, "</svg>\n"])


def is_implied(a: str, b: str, pairs: set[tuple[str, str]]) -> bool:
    """Whether a way along other arrows leads from a to b."""
    reached, waiting = set(), [middle for start, middle in pairs if start == a and middle != b]
    while waiting:
        room = waiting.pop()
        if room not in reached:
            reached.add(room)
            waiting += [end for start, end in pairs if start == room]
    return b in reached


def room_of(module: str) -> str:
    """The room in which a module stands."""
    return ".".join(module.split(".")[:2])


if __name__ == "__main__":
    PICTURE.write_text(drawn(), encoding="utf-8")

"""What a run of all tests compiles first: what lessons use, and what tests use besides.

`data/machine_code.json` has a line for each function of the tests: its module, its name, and the
kinds of its arguments. They are the functions that a run with an empty cache compiles behind the
tests, which interpret them meanwhile. A line that no longer fits is left out, and a test names it:
remove it, or write the file anew.

To do that: python start.py test, with an empty folder as KINOEDU_CACHE and the name of
another folder as KINOEDU_NOTES, and then python tests/machine_code.py NOTES.
"""

import json
import os
import sys
from contextlib import suppress
from pathlib import Path
from typing import Any

from kinoedu.compiled import HAS_COMPILER, requests
from kinoedu.compiled.kinds import Kind, is_tuple_kind
from kinoedu.compiled.store import AWAITED, Request, folder
from kinoedu.compiled.tiers import TIERED
from kinoedu.course.recorded import named
from kinoedu.support.progress import show_progress
from kinoedu.warm import warm_all

FILE = Path(__file__).resolve().parent / "data" / "machine_code.json"


def compile_ahead() -> None:
    """Compile what lessons and tests use, on all cores; a function that cannot be ends the run."""
    left = warm_all()
    place = folder()
    if place is not None and HAS_COMPILER:
        with show_progress("compiling for the tests") as report_progress:
            refused = requests.compile_all(
                place,
                AWAITED,
                read_requests(),
                workers=os.cpu_count() or 1,
                report_progress=report_progress,
            )
        left += [f"{request.module}.{request.function}" for request in refused]
    if left:
        sys.exit(f"no machine code for {', '.join(left)}: the reasons are in {place}")


def read_requests() -> list[Request]:
    """The requests of the lines whose records exist."""
    found = []
    for line in read_lines():
        with suppress(ImportError, AttributeError, ValueError):
            found.append(request_of(line))
    return found


def read_lines() -> list[Any]:
    """The lines of the file: [module, function, kinds]."""
    lines: list[Any] = json.loads(FILE.read_text(encoding="utf-8"))
    return lines


def request_of(line: Any) -> Request:
    """The request of a line; raises as `decode` where a record does not exist."""
    module, function, kinds = line
    return Request(module, function, tuple(map(decode, kinds)))


def encode(kind: Kind) -> Any:
    """A kind as JSON: a record by the name of its class."""
    if is_tuple_kind(kind):
        name = "tuple" if kind[0] is tuple else f"{kind[0].__module__}:{kind[0].__qualname__}"
        return [name, [encode(part) for part in kind[1]]]
    return list(kind) if isinstance(kind, tuple) else kind


def decode(data: Any) -> Kind:
    """A kind from its JSON.

    Raises ImportError, AttributeError or ValueError where it names no record, or not its fields.
    """
    if isinstance(data, str):
        return data
    if not isinstance(data[1], list):
        return tuple(data)
    cls = tuple if data[0] == "tuple" else named(data[0])
    if cls is not tuple and len(cls._fields) != len(data[1]):
        raise ValueError(f"{data[0]} has {len(cls._fields)} fields, not {len(data[1])}")
    return cls, tuple(map(decode, data[1]))


def note_requests(notes: Path, process: str) -> None:
    """Write down for which functions this process has requested machine code."""
    kinds = [one for function in TIERED for one in function.specializations.values()]
    wanted = [one.to_compile for one in kinds if one.requested_after and not one.is_never_stored]
    lines = [[one.module, one.function, list(map(encode, one.kinds))] for one in wanted]
    notes.mkdir(parents=True, exist_ok=True)
    (notes / f"{process}.json").write_text(json.dumps(lines), encoding="utf-8")


def collect_notes(notes: Path) -> None:
    """Write the file from the notes of all processes."""
    lines = {json.dumps(line) for file in notes.iterdir() for line in json.loads(file.read_text())}
    FILE.write_text("[\n" + ",\n".join(sorted(lines)) + "\n]\n", encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) > 1:
        collect_notes(Path(sys.argv[1]))
    else:
        compile_ahead()

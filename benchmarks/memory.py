"""How much memory a lesson takes: each is run in a kernel of its own, and what that kernel held is
read when its last cell is done.

A teacher multiplies it by the lessons that a class has open at once. Compiled code should be there
before: python -m kinoedu warm.
"""

import argparse
import json
from pathlib import Path
from typing import Any

import nbformat
from nbclient import NotebookClient

HOUSE = Path(__file__).resolve().parent.parent
ASK = """
import json as _json, os as _os, sys as _sys
import psutil as _psutil
_held = _psutil.Process().memory_info()
try:
    import resource as _resource
    _peak = _resource.getrusage(_resource.RUSAGE_SELF).ru_maxrss
    _peak *= 1 if _sys.platform == "darwin" else 1024
except ImportError:  # Windows
    _peak = _held.peak_wset
print(_json.dumps([_held.rss, max(_peak, _held.rss)]))
"""


def held(book: Any, folder: Path) -> list[int]:
    """Bytes of a kernel after a notebook's last cell, and the most that it ever held."""
    book.cells.append(nbformat.v4.new_code_cell(ASK))
    NotebookClient(
        book, timeout=600, kernel_name="python3", resources={"metadata": {"path": str(folder)}}
    ).execute()
    return json.loads(book.cells[-1].outputs[0]["text"])


def main() -> None:
    """Run the lessons one after another, and print a table."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument(
        "lessons", nargs="*", help="beginnings of names, such as 04; all, if left out"
    )
    wanted = tuple(options.parse_args().lessons) or ("",)
    print("| lesson | after its last cell, MB | at most, MB |")
    print("|---|---:|---:|")
    empty = nbformat.v4.new_notebook(cells=[])
    books = {"a kernel with no lesson": empty}
    for file in sorted((HOUSE / "notebooks").glob("*.ipynb")):
        if file.name.startswith(wanted):
            books[file.stem] = nbformat.read(file, as_version=4)
    for name, book in books.items():
        resident, peak = held(book, HOUSE / "notebooks")
        print(f"| {name} | {resident / 1e6:.0f} | {peak / 1e6:.0f} |", flush=True)


if __name__ == "__main__":
    main()

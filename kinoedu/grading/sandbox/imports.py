"""Modules kept in memory, so that a program can import them where there is no disk.

Python's own library and numpy are kept as source text, and compiled when a program imports them.
Modules of machine code cannot be kept so: they are loaded before the disk goes.
"""

import importlib
import importlib.abc
import importlib.machinery
import importlib.util
import sys
import sysconfig
from collections.abc import Iterable, Iterator
from contextlib import suppress
from pathlib import Path
from types import ModuleType
from typing import Any

# folders of Python's library that no program of a course needs
UNUSED = ("test", "tests", "idlelib", "lib2to3", "ensurepip", "tkinter", "turtledemo", "distutils")
UNUSED_CODE = ("_test", "_ctypes_test", "_tkinter", "_curses", "_dbm", "_gdbm", "xx", "readline")
PLACE = "<library>"  # in the place of a folder in the names of files


class MemoryFinder(importlib.abc.MetaPathFinder, importlib.abc.InspectLoader):
    """Finds and loads the modules of some folders from memory."""

    def __init__(self, folders: Iterable[tuple[str, Path]]) -> None:
        self.sources = {
            name: (is_package, file.read_bytes())
            for prefix, folder in folders
            for name, is_package, file in find_modules(prefix, folder)
        }

    def find_spec(
        self, name: str, path: Any = None, target: ModuleType | None = None
    ) -> importlib.machinery.ModuleSpec | None:
        """The module's spec; None where it was not kept."""
        if name not in self.sources:
            return None
        return importlib.machinery.ModuleSpec(
            name, self, origin=self.file_of(name), is_package=self.is_package(name)
        )

    def file_of(self, name: str) -> str:
        """The name of a module's file, in tracebacks."""
        return f"{PLACE}/{name.replace('.', '/')}.py"

    def is_package(self, fullname: str) -> bool:
        """Whether a module is a package."""
        return self.sources[fullname][0]

    def get_source(self, fullname: str) -> str:
        """The text of a module."""
        return importlib.util.decode_source(self.sources[fullname][1])

    def get_code(self, fullname: str) -> Any:
        """The compiled module."""
        return compile(self.sources[fullname][1], self.file_of(fullname), "exec", dont_inherit=True)


def find_modules(prefix: str, folder: Path) -> Iterator[tuple[str, bool, Path]]:
    """Yield the name of each module below a folder, whether it is a package, and its file."""
    if prefix:
        yield prefix, True, folder / "__init__.py"
    for place in sorted(folder.iterdir()):
        if place.suffix == ".py" and place.stem != "__init__":
            yield f"{prefix}.{place.stem}".lstrip("."), False, place
        elif (place / "__init__.py").is_file() and place.name not in UNUSED:
            yield from find_modules(f"{prefix}.{place.name}".lstrip("."), place)


def keep_libraries() -> None:
    """Keep Python's library and every package that is loaded, and load their machine code."""
    for file in Path(sysconfig.get_path("platstdlib"), "lib-dynload").glob("*.so"):
        if not file.name.startswith(UNUSED_CODE):
            with suppress(ImportError):
                importlib.import_module(file.name.partition(".")[0])
    folders = [("", Path(sysconfig.get_path("stdlib")))]
    for name in sorted({module.partition(".")[0] for module in sys.modules}):
        place = getattr(sys.modules.get(name), "__file__", None) or ""
        if "site-packages" in place and place.endswith("__init__.py"):
            folders.append((name, Path(place).parent))
    sys.meta_path.append(MemoryFinder(folders))

"""A reader's own code: functions of files, loaded by name, and the sources that they depend on.

Loading runs the file, with all that the reader may do on this computer. So only what a reader names
on the command line or in an experiment's file is loaded; scenes, maps and plans never name code.
"""

import ast
import importlib
import sys
import sysconfig
from collections.abc import Callable, Iterator
from importlib.machinery import SourceFileLoader
from pathlib import Path
from types import CodeType, FunctionType, ModuleType
from typing import Any

from ..errors import InvalidParameter
from .text import shortened

PACKAGE = __name__.partition(".")[0]
INSTALLED = [
    Path(folder).resolve()
    for folder in {*map(sysconfig.get_path, ("stdlib", "purelib", "platlib"))}
]
LOADED: dict[str, dict[str, str]] = {}  # sources of the modules loaded here, when they were loaded
FOLDERS: set[str] = set()  # the folders that were added to sys.path


def names_code(text: object) -> bool:
    """Whether a text has the form of `module.function` or `file.py:function`.

    Examples
    --------
    >>> [names_code(text) for text in ("mine.potential", "mine.py:potential", "rrt", "a b.c")]
    [True, True, False, False]
    """
    if not isinstance(text, str):
        return False
    before, colon, name = text.rpartition(":")
    if colon:
        return before.endswith(".py") and name.isidentifier()
    return "." in text and all(part.isidentifier() for part in text.split("."))


def load_function(text: str, folder: Path) -> Callable[..., Any]:
    """The function of a reader's own file. This runs the file.

    The file's folder is added to the end of `sys.path`, so that other processes of this computer
    find the file too. A file that has changed since it was loaded, or one that it imports, is
    loaded again.

    Parameters
    ----------
    text : `module.function`, of a module in `folder` or an installed one; or `file.py:function`,
        with the path of the file from `folder`.

    Raises
    ------
    InvalidParameter
        Where there is no such file or function, the file raises an error, or another module has
        its name.
    """
    if not names_code(text):
        raise InvalidParameter(
            f"code is named as module.function or file.py:function, got {shortened(text)}"
        )
    before, colon, name = text.rpartition(":")
    if colon:
        file = (folder / before).resolve()
        if "." in file.stem:
            raise InvalidParameter(
                f"{file}: a file that Python can import has no dot before .py; rename it"
            )
        module = load_module(file.stem, file.parent, must_exist=file)
    else:
        module_name, _, name = text.rpartition(".")
        module = load_module(module_name, folder.resolve())
    function = getattr(module, name, None)
    if not callable(function):
        there = [key for key, thing in vars(module).items() if is_of(thing, module)]
        raise InvalidParameter(
            f"{module.__file__} has no function {name!r}; it has {', '.join(there) or 'none'}"
        )
    return function


def is_of(thing: object, module: ModuleType) -> bool:
    """Whether a module defines a function or a class, and not only imports it."""
    return callable(thing) and getattr(thing, "__module__", None) == module.__name__


def load_module(name: str, folder: Path, must_exist: Path | None = None) -> ModuleType:
    """Import a module of a folder or an installed one, anew where its sources have changed."""
    if must_exist is not None and not must_exist.is_file():
        raise InvalidParameter(f"there is no file {must_exist}")
    search_last(folder)
    forget_if_changed(name, folder)
    writes, sys.dont_write_bytecode = sys.dont_write_bytecode, True  # it may change within a second
    try:
        importlib.invalidate_caches()
        module = importlib.import_module(name)
    except ModuleNotFoundError as error:
        if error.name != name.partition(".")[0] and error.name != name:
            raise InvalidParameter(f"{name} cannot be loaded: {error}") from error
        raise InvalidParameter(f"there is no module {name} in {folder}, nor installed") from error
    except (Exception, SystemExit) as error:
        raise InvalidParameter(
            f"{name} in {folder} cannot be loaded: {type(error).__name__}: {error}"
        ) from error
    finally:
        sys.dont_write_bytecode = writes
    check_place(module, folder, must_exist)
    LOADED[name] = sources_of(module)
    return module


def search_last(folder: Path) -> None:
    """Search this folder after all that are installed, and before other folders of readers."""
    place = str(folder)
    if place in FOLDERS and place in sys.path:
        sys.path.remove(place)
    if place not in sys.path:
        others = [sys.path.index(other) for other in FOLDERS if other in sys.path]
        sys.path.insert(min(others, default=len(sys.path)), place)
        FOLDERS.add(place)


def forget_if_changed(name: str, folder: Path) -> None:
    """Remove a module and those that it imports where a source has changed, or its place."""
    module = sys.modules.get(name)
    if module is None or name not in LOADED:
        return
    if sources_of(module) != LOADED[name] or not is_at(module, folder):
        for loaded in {name, name.partition(".")[0], *LOADED[name]}:
            sys.modules.pop(loaded, None)


def is_at(module: ModuleType, folder: Path) -> bool:
    """Whether a module is in a folder, or the folder has none of its name."""
    own = folder.joinpath(*module.__name__.split("."))
    if not (own.with_suffix(".py").is_file() or (own / "__init__.py").is_file()):
        return True
    return Path(module.__file__ or "").resolve().is_relative_to(folder)


def check_place(module: ModuleType, folder: Path, must_exist: Path | None) -> None:
    """Raise InvalidParameter where another module has the name of the reader's file."""
    file = Path(module.__file__ or "").resolve()
    if not is_at(module, folder) or (must_exist is not None and file != must_exist):
        raise InvalidParameter(
            f"another module has the name {module.__name__!r}: {file}; rename your file"
        )


def sources_of(module: ModuleType) -> dict[str, str]:
    """The sources of a reader's module and of the reader's modules that it imports, by name.

    Imports within functions count too. Data files that the code reads are not known.
    """
    found: dict[str, str] = {}
    waiting = [module.__name__]
    while waiting:
        name = waiting.pop()
        file = own_file(name)
        if file is not None and name not in found:
            found[name] = file.read_text(encoding="utf-8", errors="surrogateescape")
            waiting += imported_names(found[name], name, is_package=file.name == "__init__.py")
    return dict(sorted(found.items()))


def own_file(name: str) -> Path | None:
    """The file of a module that is neither installed nor of this package; else None.

    Nothing is imported to find it.
    """
    if name.partition(".")[0] in (PACKAGE, *sys.builtin_module_names):
        return None
    loaded = getattr(sys.modules.get(name), "__file__", None)
    beside = [Path(folder, *name.split(".")) for folder in sys.path]
    places = [f for path in beside for f in (path / "__init__.py", path.with_suffix(".py"))]
    file = Path(loaded) if loaded else next((f for f in places if f.is_file()), None)
    if file is None or file.suffix != ".py" or not file.is_file():
        return None
    file = file.resolve()
    installed = "site-packages" in file.parts or any(map(file.is_relative_to, INSTALLED))
    return None if installed else file


def imported_names(source: str, module: str, *, is_package: bool) -> Iterator[str]:
    """The names of modules that a source may import."""
    try:
        tree = ast.parse(source)
    except (SyntaxError, ValueError):
        return
    package = module.split(".") if is_package else module.split(".")[:-1]
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield from with_parents(alias.name)
        elif isinstance(node, ast.ImportFrom):
            above = package[: len(package) - node.level + 1] if node.level else []
            base = ".".join([*above, *filter(None, [node.module])])
            if base:
                yield from with_parents(base)
                yield from (f"{base}.{alias.name}" for alias in node.names)


def with_parents(name: str) -> list[str]:
    """A module's name and those of the packages that it is in."""
    parts = name.split(".")
    return [".".join(parts[: i + 1]) for i in range(len(parts))]


def check_unchanged(module: ModuleType) -> None:
    """Check that the functions of a loaded module are those of its file.

    Raises
    ------
    InvalidParameter
        Where the file has changed since it was imported, so that another process would run another
        program.
    """
    file = own_file(module.__name__)
    if file is None:
        return
    loaded = LOADED.get(module.__name__)
    if loaded is not None and loaded != sources_of(module):
        raise changed_error(file)
    if type(module.__loader__) is not SourceFileLoader:  # such as that of pytest, which rewrites
        return
    try:
        compiled = compile(file.read_bytes(), str(file), "exec", dont_inherit=True)
    except (SyntaxError, ValueError):  # such as a line that is only half written
        raise changed_error(file) from None
    codes = set(codes_in(compiled))
    for thing in vars(module).values():
        code = thing.__code__ if isinstance(thing, FunctionType) else None
        if code is not None and code.co_filename == module.__file__ and code not in codes:
            raise changed_error(file)


def changed_error(file: Path) -> InvalidParameter:
    """The error for a file that has changed since it was imported."""
    return InvalidParameter(
        f"{file} has changed since it was imported; import it again (importlib.reload), or restart "
        "Python"
    )


def codes_in(code: CodeType) -> Iterator[CodeType]:
    """A code object and those within it."""
    yield code
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from codes_in(constant)

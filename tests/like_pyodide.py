"""Runs a notebook's cells as a browser's Python would: python like_pyodide.py NOTEBOOK.

No numba, no processes, no threads that start, no file locks: what Pyodide lacks is made to fail
here as it fails there. Prints, as JSON, what each code cell shows as text and the modules that were
imported in vain.
"""

import io
import json
import os
import subprocess
import sys
import threading
from contextlib import redirect_stdout
from importlib.abc import MetaPathFinder
from pathlib import Path
from typing import Any

ABSENT = {
    "numba",
    "llvmlite",
    "multiprocessing",
    "_multiprocessing",
    "fcntl",
    "grp",
    "pwd",
    "readline",
    "resource",
    "syslog",
}
ABSENT |= {
    "termios",
    "curses",
    "pty",
    "pexpect",
    "psutil",
    "jupyterlab",
    "jupyter_server",
    "tornado",
    "zmq",
    "nbval",
    "nbgrader",
}
requested: set[str] = set()


class Absent(MetaPathFinder):
    """Finds nothing, and says so at once, for modules that Pyodide has not."""

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> None:
        if name.partition(".")[0] in ABSENT:
            requested.add(name)
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)


def refuse_processes_and_threads() -> None:
    """In Pyodide's words."""

    def no_process(*_: Any, **__: Any) -> None:
        raise OSError(138, "emscripten does not support processes.")

    def no_thread(*_: Any, **__: Any) -> None:
        raise RuntimeError("can't start new thread")

    subprocess.Popen.__init__ = no_process  # type: ignore[assignment]
    os.fork = no_process  # type: ignore[assignment]
    threading.Thread.start = no_thread  # type: ignore[method-assign]
    import kinoedu.support.time_limit

    kinoedu.support.time_limit.IN_BROWSER = True


def shown(notebook: Path) -> list[str]:
    """What each code cell prints and returns; a cell that fails ends it."""
    from IPython.core.interactiveshell import InteractiveShell

    shell = InteractiveShell.instance(history_length=0)
    shell.history_manager.enabled = False
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    texts = []
    for cell in cells:
        if cell["cell_type"] == "code":
            printed = io.StringIO()
            shell.displayhook.write_output_prompt = lambda: None
            shell.displayhook.write_format_data = lambda *_: None
            with redirect_stdout(printed):
                done = shell.run_cell("".join(cell["source"]), store_history=False)
            done.raise_error()
            result = (
                ""
                if done.result is None
                else shell.display_formatter.format(done.result)[0].get("text/plain", "")
            )
            texts.append(printed.getvalue().strip() + "\n" + result)
    return texts


def main() -> None:
    """Run one notebook."""
    # it starts a thread for its history, which Pyodide's kernel does not
    import IPython.core.interactiveshell

    IPython.core.interactiveshell.HistoryManager.enabled = False
    os.environ["MPLBACKEND"] = "agg"
    notebook = Path(sys.argv[1]).resolve()
    os.chdir(notebook.parent)
    sys.meta_path.insert(0, Absent())
    refuse_processes_and_threads()
    texts = shown(notebook)
    print(json.dumps({"texts": texts, "requested": sorted(requested)}))


if __name__ == "__main__":
    main()

"""From bodies to WebAssembly modules.

numba compiles the bodies to LLVM's intermediate language. The same LLVM makes one object file for
WebAssembly of them all, and of this each module is linked with what its body needs and with
`runtime.c`. Nothing of numba or Python is in a module.

`write_scripts` needs the package `ziglang`, which brings a C compiler and a linker. It compiles in
another process, because numba reads its settings only once.
"""

import base64
import hashlib
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from ..compiled import store
from ..support.whole_files import written_whole
from .bodies import BODIES
from .scenes import EMPTY_SCENE

TRIPLE = "wasm32-unknown-unknown"
LAYOUT = "e-m:e-p:32:32-p10:8:8-p20:8:8-i64:64-i128:128-n32:64-S128-ni:1:10:20"
FEATURES = "+bulk-memory,+nontrapping-fptoint,+sign-ext,+mutable-globals"
# numba's settings: code for any processor; numba's own functions not optimized for this one
PLAIN = {
    "NUMBA_CPU_NAME": "generic",
    "NUMBA_CPU_FEATURES": "",
    "NUMBA_OPT": "0",
    "NUMBA_DISABLE_JIT": "0",
}
LINKING = (
    "--target=wasm32-wasi",
    "-O2",
    "-mexec-model=reactor",
    "-Wl,--strip-all,--gc-sections",
    "-Wl,-z,stack-size=262144",
)
RUNTIME = Path(__file__).with_name("runtime.c")


def write_scripts(folder: Path) -> None:
    """Write each body's module as a script `name.js`, which a page can load from a disk too."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, file in module_files().items():
        text = base64.b64encode(file.read_bytes()).decode("ascii")
        script = f'(globalThis.kinoeduModules ??= {{}})["{name}"] = "{text}";\n'
        (folder / f"{name}.js").write_text(script, encoding="ascii")


def module_files() -> dict[str, Path]:
    """The file of each body's module; compiled now, unless these sources were compiled before."""
    digest = hashlib.sha256(RUNTIME.read_bytes()).hexdigest()[:8]
    place = store.user_cache() / f"{store.source_digest(store.PACKAGE, store.UPPER_ROOMS)}-{digest}"
    files = {name: place / f"{name}.wasm" for name in BODIES}
    if not all(file.exists() for file in files.values()):
        place.mkdir(mode=0o700, parents=True, exist_ok=True)
        command = [sys.executable, "-P", "-m", "kinoedu.browser.wasm", str(place)]
        subprocess.run(command, env={**os.environ, **PLAIN}, check=True)
    return files


def make_missing_modules(place: Path) -> None:
    """Make the modules that are missing in a folder; of several processes one does."""
    files = {name: place / f"{name}.wasm" for name in BODIES}
    while not all(file.exists() for file in files.values()):
        with open(place / "lock", "wb") as lock:
            if store.try_lock(lock):
                part = compile_bodies(BODIES)
                for name, file in files.items():
                    with written_whole(file) as unfinished:
                        unfinished.write_bytes(link(part, name))
        time.sleep(0.2)  # another one may be making them


def compile_bodies(names: Iterable[str]) -> bytes:
    """A WebAssembly object file of bodies, in which each function has the name of its body."""
    import llvmlite.binding as llvm

    from ..compiled.intermediate import compile_parts

    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    entries, parts = dict[str, str](), dict[Any, Any]()
    for name in names:
        example = (EMPTY_SCENE, BODIES[name].kinds, np.random.default_rng(0))
        entries[name], found = compile_parts(BODIES[name].function, example)
        parts |= found
    whole = link_all([read_for_browsers(part) for part in parts.values()])
    for value in (*whole.functions, *whole.global_variables):
        if not value.is_declaration:
            value.linkage = llvm.Linkage.internal
    for name, entry in entries.items():
        function = whole.get_function(entry)
        function.linkage, function.name = llvm.Linkage.external, name
    return optimize(whole)


def read_for_browsers(module: Any) -> Any:
    """A copy of an LLVM module for the machine that browsers have."""
    import llvmlite.binding as llvm

    part = llvm.parse_bitcode(module.as_bitcode())
    part.triple, part.data_layout = TRIPLE, LAYOUT
    return part


def link_all(modules: list[Any]) -> Any:
    """One LLVM module of many, which are used up: pairs, then pairs of pairs.

    Each link walks through both modules, so that one that grows would be walked through each time.
    """
    while len(modules) > 1:
        for left, right in zip(modules[::2], modules[1::2], strict=False):
            left.link_in(right)
        modules = modules[::2]
    return modules[0]


def optimize(module: Any) -> bytes:
    """The object file of an LLVM module."""
    import llvmlite.binding as llvm

    machine = llvm.Target.from_triple(TRIPLE).create_target_machine(opt=3, features=FEATURES)
    builder = llvm.create_pass_builder(machine, llvm.create_pipeline_tuning_options(speed_level=2))
    passes = builder.getModulePassManager()
    passes.add_lower_atomic_pass()
    passes.add_refprune_pass()
    passes.run(module, builder)
    return bytes(machine.emit_object(module))


def link(part: bytes, name: str) -> bytes:
    """The module of a body: what it needs of an object file, and the runtime."""
    with tempfile.TemporaryDirectory() as folder:
        source, module = Path(folder, "bodies.o"), Path(folder, "body.wasm")
        source.write_bytes(part)
        command = [sys.executable, "-P", "-m", "ziglang", "cc", *LINKING, f"-Wl,--export={name}"]
        subprocess.run([*command, str(source), str(RUNTIME), "-o", str(module)], check=True)
        return module.read_bytes()


if __name__ == "__main__":
    make_missing_modules(Path(sys.argv[1]))

"""From a body to a WebAssembly module.

numba compiles a body for a plain processor. Its intermediate code is then translated for
WebAssembly by the same LLVM, and linked with `runtime.c`. Nothing of numba or Python is in the
module.

`write_scripts` needs the package `ziglang`, which brings a C compiler and a linker. It compiles in
other processes, because numba reads its settings only once.
"""

import base64
import hashlib
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np

from ..compiled import Compiled, store
from ..compiled.kinds import kinds_of
from ..compiled.tiers import TieredFunction
from ..support.whole_files import written_whole
from .bodies import BODIES
from .scenes import EMPTY_SCENE

TRIPLE = "wasm32-unknown-unknown"
LAYOUT = "e-m:e-p:32:32-p10:8:8-p20:8:8-i64:64-i128:128-n32:64-S128-ni:1:10:20"
FEATURES = "+bulk-memory,+nontrapping-fptoint,+sign-ext,+mutable-globals"
# numba's settings: code for any processor, not optimized, because an optimizer settles where the
# fields of a record lie in memory, which is different where addresses have 32 bits
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
    "-Wl,--export=answer,--strip-all,--gc-sections",
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
        several = [
            subprocess.Popen(command, env={**os.environ, **PLAIN})
            for _ in range(os.cpu_count() or 1)
        ]
        failed = [one for one in several if one.wait() != 0]
        if failed:
            raise subprocess.CalledProcessError(failed[0].returncode, command)
    return files


def make_missing_modules(place: Path) -> None:
    """Make the modules that are missing in a folder; several processes share the work."""
    missing = set(BODIES)
    while missing:
        for name in sorted(missing):
            file = place / f"{name}.wasm"
            with open(place / f"{name}.lock", "wb") as lock:
                if not file.exists() and store.try_lock(lock):
                    with written_whole(file) as unfinished:
                        unfinished.write_bytes(make_module(name))
            if file.exists():
                missing.discard(name)
        if missing:
            time.sleep(0.2)  # others are making them


def make_module(name: str) -> bytes:
    """The module of a body, compiled with the settings of this process."""
    body = BODIES[name]
    example = (EMPTY_SCENE, body.kinds, np.random.default_rng(0))
    code, entry = intermediate_code(body.function, example)
    return link(translate(code, entry))


def intermediate_code(function: Compiled, arguments: tuple[Any, ...]) -> tuple[str, str]:
    """What numba makes of a function before it becomes machine code, and its name there."""
    from ..compiled.compiler import compile_entry

    kinds = kinds_of(arguments)
    if kinds is None or not isinstance(function, TieredFunction):
        raise TypeError("numba cannot compile this function for these arguments")
    result = compile_entry(function, kinds)
    return result.library.get_llvm_str(), result.fndesc.llvm_func_name


def translate(code: str, entry: str) -> bytes:
    """A WebAssembly object file of intermediate code, in which the entry is named `answer`."""
    import llvmlite.binding as llvm

    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    code = re.sub(r'target triple = ".*"', f'target triple = "{TRIPLE}"', code)
    code = re.sub(r'target datalayout = ".*"', f'target datalayout = "{LAYOUT}"', code)
    code = re.sub(r'"target-(cpu|features)"="[^"]*"', "", code)
    module = llvm.parse_assembly(code)
    for value in (*module.functions, *module.global_variables):
        if not value.is_declaration:
            value.linkage = llvm.Linkage.internal
    answer = module.get_function(entry)
    answer.linkage, answer.name = llvm.Linkage.external, "answer"
    machine = llvm.Target.from_triple(TRIPLE).create_target_machine(opt=3, features=FEATURES)
    builder = llvm.create_pass_builder(machine, llvm.create_pipeline_tuning_options(speed_level=2))
    passes = builder.getModulePassManager()
    passes.add_lower_atomic_pass()
    passes.add_refprune_pass()
    passes.run(module, builder)
    return bytes(machine.emit_object(module))


def link(part: bytes) -> bytes:
    """A module of an object file and the runtime."""
    with tempfile.TemporaryDirectory() as folder:
        source, module = Path(folder, "body.o"), Path(folder, "body.wasm")
        source.write_bytes(part)
        command = [sys.executable, "-P", "-m", "ziglang", "cc", *LINKING, str(source), str(RUNTIME)]
        subprocess.run([*command, "-o", str(module)], check=True)
        return module.read_bytes()


if __name__ == "__main__":
    make_missing_modules(Path(sys.argv[1]))

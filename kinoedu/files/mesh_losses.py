"""What trimesh would leave out of a mesh, or put elsewhere, without a word: here it is an error."""

from __future__ import annotations

import io
import json
import re
import warnings
from collections.abc import Iterator
from typing import Any

from ..errors import UnreadableScene
from ..support.text import shortened

# errors of pycollada about what has no place in the plane
HARMLESS = re.compile(
    r"light|camera|effect|image|surface|sampler|shading|color|auxiliar|input semantic",
    re.IGNORECASE,
)
# extensions of .glb that do not move vertices, or move them as trimesh does
HARMLESS_EXTENSIONS = (
    "KHR_materials_",
    "KHR_texture_",
    "EXT_texture_",
    "KHR_lights_",
    "KHR_xmp",
    "KHR_mesh_quantization",
)
INSTANCING = "EXT_mesh_gpu_instancing"
TRIANGLE_FAN = 6  # the number of this mode in a .glb


def refuse_what_trimesh_loses(data: bytes, kind: str) -> None:
    """Check a whole file, of the kind stl, dae or glb.

    Raises
    ------
    UnreadableScene
        Where it stops early, or a body of it would be lost; the message does not name the file.
    """
    check = {"stl": find_losses_of_stl, "dae": find_losses_of_dae, "glb": find_losses_of_glb}[kind]
    for loss in check(data):
        raise UnreadableScene(f"expected a whole .{kind} file, got {loss}; export it again")


def find_losses_of_stl(data: bytes) -> Iterator[str]:
    """Yield how a file of one or several solids is cut short."""
    count = int.from_bytes(data[80:84], "little")
    if len(data) == 84 + 50 * count:
        return
    if data.lstrip()[:5].lower() != b"solid":
        whole = 84 + 50 * count
        yield f"{len(data):,} bytes where a binary one of {count:,} triangles has {whole:,}"
        return
    *_, last = data.strip().lower().splitlines()
    if not last.strip().startswith(b"endsolid"):
        yield "one that stops before endsolid"


def find_losses_of_dae(data: bytes) -> Iterator[str]:
    """Yield the errors of pycollada, which trimesh ignores, and bodies that it does not place."""
    import collada

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        document = collada.Collada(io.BytesIO(data), ignore=[collada.common.DaeError])
    for error in document.errors:
        if not HARMLESS.search(str(error)):
            yield f"damage: {shortened(str(error).partition(': ')[2])}"
    if document.scene is None:
        return
    if any(True for _ in document.scene.objects("controller")):
        yield "a body that is bound to a skeleton: freeze its pose"
    for body in document.geometries:
        if any(
            part.index is not None and part.index.min(initial=0) < 0 for part in body.primitives
        ):
            yield f"damage: a corner of {shortened(body.id)} has a number below 0"


def find_losses_of_glb(data: bytes) -> Iterator[str]:
    """Yield what the JSON of a file asks for and trimesh does not do."""
    scene = read_json_of_glb(data)
    needed = [
        name
        for name in list_of(scene, "extensionsRequired")
        if not str(name).startswith(HARMLESS_EXTENSIONS)
    ]
    needed += [name for name in list_of(scene, "extensionsUsed") if name == INSTANCING]
    if needed:
        yield f"one that needs the extension {shortened(needed[0])}: leave it out"
    accessors = list_of(scene, "accessors")
    for mesh in list_of(scene, "meshes"):
        for part in list_of(mesh, "primitives"):
            if part.get("mode") == TRIANGLE_FAN:
                yield "a fan of triangles: leave each triangle by itself"
            places = accessor_of(accessors, part.get("attributes", {}).get("POSITION"))
            if places.get("normalized"):
                yield "vertices that are packed as fractions: leave them unpacked"
            if "sparse" in places or "sparse" in accessor_of(accessors, part.get("indices")):
                yield "sparse vertices: write all of them"


def read_json_of_glb(data: bytes) -> dict[str, Any]:
    """The JSON of a file; empty where there is none, which trimesh says better."""
    size = int.from_bytes(data[12:16], "little")
    try:
        found = json.loads(data[20 : 20 + size])
    except (ValueError, RecursionError):
        return {}
    return found if isinstance(found, dict) else {}


def list_of(of: Any, name: str) -> list[Any]:
    """A list of an object; empty where it is none."""
    found = of.get(name) if isinstance(of, dict) else None
    return found if isinstance(found, list) else []


def accessor_of(accessors: list[Any], number: Any) -> dict[str, Any]:
    """The accessor with a number; empty where there is none."""
    is_there = isinstance(number, int) and 0 <= number < len(accessors)
    found = accessors[number] if is_there else None
    return found if isinstance(found, dict) else {}

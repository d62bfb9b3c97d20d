"""What mesh formats allow is read as it is meant, and what would be lost is refused."""

import json
import subprocess
import sys

import numpy as np
import pytest
import shapely
from test_meshes import DAE, area, corners

from kinoedu.errors import UnreadableScene
from kinoedu.files import read_mesh
from kinoedu.files.obj import read_obj

SQUARE = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\n"
BOX = {(0, 0), (2, 0), (2, 1), (0, 1)}
TRIANGLE = {(0, 0), (2, 0), (2, 1)}


@pytest.mark.parametrize(
    ("text", "shapes"),
    [
        (f"{SQUARE}f 1 2 3\nf\t1 3 4\n", [BOX]),
        (f"{SQUARE}f 1 2 3\n  f  1   3 4  \n", [BOX]),
        (f"{SQUARE}f 1 2 3 4 # a face\n# f 9 9 9\n", [BOX]),
        (f"{SQUARE}f 1/1 2/2/2 3//3\r\nf 1 3 4\r\n".replace("\n", "\r\n"), [BOX]),
        (f"{SQUARE}f 1 2 \\\n3 4\n", [BOX]),
        ("v\t0 0 0 1.0\n v 2 0 0 0.1 0.2 0.3\nv 2 1 0\nvn 0 0 1\nf 1 2 3\n", [TRIANGLE]),
        (
            "v 0 0 0\nv 2 0 0\nv 2 1 0\nf -3 -2 -1\nv 5 0 0\nv 7 0 0\nv 7 1 0\nf -3 -2 -1\n",
            [TRIANGLE, {(x + 5, y) for x, y in TRIANGLE}],
        ),
        ("f 1 2 3\nv 0 0 0\nv 2 0 0\nv 2 1 0\n", [TRIANGLE]),  # vertices may come later
    ],
)
def test_an_obj_is_read_however_it_is_written(tmp_path, text, shapes):
    """With tabs, blanks, comments, a line that goes on, and numbers that count back."""
    (tmp_path / "x.obj").write_bytes(text.encode())
    found = [corners(outline) for outline, _ in read_mesh(tmp_path / "x.obj")]
    assert sorted(map(sorted, found)) == sorted(map(sorted, shapes))


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("f 0 1 2", "line 5 '0' is no corner"),
        ("f -5 1 2", "'-5' is no corner of a face after 4 vertices"),
        ("f 1 2 5", "corner 5, and there are 4 vertices"),
        ("f 1 2 x", "'x' is no corner"),
        ("f 1 2 1_0", "'1_0' is no corner"),
        ("f 1 2", "fewer than three"),
        ("v 1 2", "no vertex of three numbers"),
        ("v 1 2 1_0", "no vertex of three numbers"),
        ("f 1 2 3 \\\n 4\nf 1 2 x", "line 7 'x' is no corner"),
        ("f 1 \\\n2", "line 5 'f 1 2' is a face of fewer"),
    ],
)
def test_a_damaged_line_of_an_obj_is_named(tmp_path, line, says):
    (tmp_path / "x.obj").write_text(f"{SQUARE}{line}\nf 1 2 3\n")
    with pytest.raises(UnreadableScene, match=says) as error:
        read_mesh(tmp_path / "x.obj")
    assert "x.obj" in str(error.value)


@pytest.mark.parametrize("seed", range(20))
def test_a_face_that_is_not_convex_covers_itself_alone(tmp_path, seed):
    """A star-shaped polygon as one face, in any plane and either way round; its triangles keep its
    side.
    """
    rng = np.random.default_rng(seed)
    n = rng.integers(4, 14)
    angles = np.sort(rng.uniform(0, 2 * np.pi, n))
    if np.diff(angles, append=angles[0] + 2 * np.pi).max() > 3.0:
        angles = np.linspace(0, 2 * np.pi, n, endpoint=False)
    ring = rng.uniform(0.3, 3, n)[:, None] * np.column_stack([np.cos(angles), np.sin(angles)])
    ring = ring[:: rng.choice((-1, 1))]
    slope = rng.uniform(-4, 4, 2)
    points = np.column_stack([ring, ring @ slope])
    text = "".join(f"v {x} {y} {z}\n" for x, y, z in points.tolist())
    text += f"f {' '.join(str(i + 1) for i in range(n))}\n"
    (tmp_path / "x.obj").write_text(text)
    whole = shapely.Polygon(ring)
    assert whole.is_valid
    assert area(read_mesh(tmp_path / "x.obj")) == pytest.approx(whole.area, rel=1e-9)
    triangles = read_obj(text.encode())
    sides = np.cross(*(triangles[:, k] - triangles[:, 0] for k in (1, 2)))
    turns = (
        np.sign(sides[:, 2]) if shapely.is_ccw(shapely.LinearRing(ring)) else -np.sign(sides[:, 2])
    )
    assert (turns[np.abs(sides[:, 2]) > 1e-12] > 0).all()


def solid(name, x):
    """An ASCII solid of one triangle."""
    places = "".join(f"vertex {x + dx} {y} 0\n" for dx, y in ((0, 0), (2, 0), (0, 1)))
    loop = f"facet normal 0 0 1\nouter loop\n{places}endloop\nendfacet\n"
    return f"solid {name}\n{loop}endsolid {name}\n"


def test_odd_normals_of_an_stl_are_ignored_without_a_word(tmp_path):
    """trimesh would print a traceback; some programs write such normals, and nobody needs them."""
    file = tmp_path / "x.stl"
    file.write_text(solid("a", 0).replace("normal 0 0 1", "normal -1.#IND -1.#IND -1.#IND"))
    code = f"import kinoedu as ke; print(len(ke.read_mesh({str(file)!r})))"
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert (ran.stdout, ran.stderr) == ("1\n", "")


def test_an_stl_may_have_several_solids_in_letters_of_any_size(tmp_path):
    """It ends with the last solid's end; cut in a later solid it is refused."""
    file, text = tmp_path / "x.stl", solid("a", 0) + solid("b", 5)
    for written in (text, text.upper(), f"\n {text}\n\n"):
        file.write_text(written)
        assert len(read_mesh(file)) == 2
    for end in ("endsolid b", "endfacet\nendsolid b", "vertex 5 1"):
        file.write_text(text[: text.rindex(end)])
        with pytest.raises(UnreadableScene, match="stops before endsolid"):
            read_mesh(file)
    file.write_bytes(bytes(84))
    with pytest.raises(UnreadableScene, match=r"x\.stl"):
        read_mesh(file)


WHOLE = DAE.format(up="Z")


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("0 2 1 0 1 3 0 3 2 1 2 3", "0 2 1 0 1 3 0 3 2 1 2 9", "damage"),
        ("0 2 1 0 1 3 0 3 2 1 2 3", "0 2 1 0 1 3 0 3 2 1 2 -1", "below 0"),
        ("4 0 0", "4 x 0", "damage"),
        ("0 0 1</float_array>", "0 0</float_array>", "damage"),
        (
            '<node id="n1"><instance_geometry url="#g"/>',
            '<node id="n1"><instance_geometry url="#h"/>',
            "#h not found",
        ),
        ("<rotate>", "<skew>45 0 1 0 1 0 0</skew><rotate>", "skew"),
    ],
)
def test_a_dae_that_would_lose_a_body_is_refused(tmp_path, old, new, says):
    file = tmp_path / "x.dae"
    file.write_text(WHOLE)
    assert len(read_mesh(file)) == 2
    assert old in WHOLE
    file.write_text(WHOLE.replace(old, new))
    with pytest.raises(UnreadableScene, match=says):
        read_mesh(file)


def test_a_dae_may_lack_what_has_no_place_in_the_plane(tmp_path):
    """A lamp that is not there and a node of another program."""
    file = tmp_path / "x.dae"
    more = '<node id="n3"><instance_light url="#nowhere"/></node><node id="n1">'
    file.write_text(WHOLE.replace('<node id="n1">', more))
    assert len(read_mesh(file)) == 2


def glb(**changes):
    """A .glb of a triangle, with members of its JSON changed."""
    data = np.array([(0, 0, 0), (2, 0, 0), (2, 1, 0)], "<f4").tobytes()
    scene = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, **changes.pop("part", {})}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}
            | changes.pop("accessor", {})
        ],
        "bufferViews": [{"buffer": 0, "byteLength": len(data)}],
        "buffers": [{"byteLength": len(data)}],
        **changes,
    }
    text = json.dumps(scene).encode()
    text += b" " * (-len(text) % 4)
    parts = [(len(text), b"JSON", text), (len(data), b"BIN\0", data)]
    chunks = b"".join(size.to_bytes(4, "little") + kind + part for size, kind, part in parts)
    return b"glTF" + (2).to_bytes(4, "little") + (12 + len(chunks)).to_bytes(4, "little") + chunks


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"part": {"mode": 6}}, "a fan of triangles"),
        ({"accessor": {"normalized": True}}, "packed as fractions"),
        ({"accessor": {"sparse": {"count": 1}}}, "sparse vertices"),
        ({"extensionsRequired": ["EXT_meshopt_compression"]}, "'EXT_meshopt_compression'"),
        ({"extensionsUsed": ["EXT_mesh_gpu_instancing"]}, "'EXT_mesh_gpu_instancing'"),
        ({"meshes": 3, "accessors": [None], "extensionsRequired": {}}, "damage"),
    ],
)
def test_a_glb_that_would_be_read_otherwise_is_refused(tmp_path, changes, says):
    file = tmp_path / "x.glb"
    file.write_bytes(glb(extensionsRequired=["KHR_materials_unlit"]))
    assert [corners(outline) for outline, _ in read_mesh(file, up="z")] == [TRIANGLE]
    file.write_bytes(glb(**changes))
    with pytest.raises(UnreadableScene, match=says):
        read_mesh(file)


@pytest.mark.parametrize("path", [None, 3, ()])
def test_what_is_no_path_is_said(path):
    with pytest.raises(UnreadableScene, match="expected the path of a file"):
        read_mesh(path)

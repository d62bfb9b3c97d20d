"""Readers of world files: right on good files, and a named error for everything else."""

import os
import struct
import warnings
import zlib
from collections.abc import Callable
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
import yaml
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PIL import Image

import kinoedu as ke
from kinoedu.errors import (
    InvalidPolygon,
    InvalidStart,
    KinoeduError,
    MendedPolygons,
    SceneTooLarge,
    UnknownFormat,
    UnreadableScene,
)
from kinoedu.files.images import read_image
from kinoedu.files.movingai import read_map, read_scenario, scenario_beside
from kinoedu.files.ros_map import read_ros_map
from kinoedu.files.worlds import read_world

GRIDS = Path(__file__).parent / "data" / "grid"
FREE_CELLS = {  # counted with tail, tr and wc
    "Paris_1_256": 47240,
    "empty-8-8": 64,
    "maze-128-128-10": 14818,
    "maze-32-32-2": 666,
    "random-32-32-20": 819,
    "room-32-32-4": 682,
    "room-64-64-8": 3232,
    "warehouse-10-20-10-2-1": 5699,
}
PAGE = np.array([[1, 0, 0], [1, 1, 0]], dtype=bool)  # as it looks in the picture: a white L
WORLD = [[True, True, False], [True, False, False]]  # the same, row 0 lowest
NOT_FINITE: list[Any] = [float("nan"), float("inf"), "x", True, [], 10**400]
CORNER = "type octile\nheight 2\nwidth 3\nmap\n.@T\nGSW\n"
LINE = "0\tcorner.map\t3\t2\t0\t0\t1\t1\t1.41421356\n"
SETTINGS = {
    "image": "map.pgm",
    "resolution": 0.05,
    "origin": [-1.5, 2, 0],
    "negate": 0,
    "occupied_thresh": 0.65,
    "free_thresh": 0.196,
}


def write(path: Path, content: str | bytes) -> Path:
    """Write a file of exactly these bytes."""
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    return path


def png(
    width: int, height: int, depth: int, kind: int, rows: bytes, *chunks: tuple[bytes, bytes]
) -> bytes:
    """A PNG made by hand, for variants that Pillow does not write."""
    header = struct.pack(">IIBBBBB", width, height, depth, kind, 0, 0, 0)
    parts = [(b"IHDR", header), *chunks, (b"IDAT", zlib.compress(rows)), (b"IEND", b"")]
    packed = [
        struct.pack(">I", len(d)) + t + d + struct.pack(">I", zlib.crc32(t + d)) for t, d in parts
    ]
    return b"\x89PNG\r\n\x1a\n" + b"".join(packed)


def ros(folder: Path, picture: np.ndarray | None = None, **changes: Any) -> Path:
    """A ROS map with some settings changed, or left out where they are None."""
    pixels = np.uint8(PAGE * 255) if picture is None else picture
    Image.fromarray(pixels).save(folder / "map.pgm", format="PPM")
    kept = {key: value for key, value in {**SETTINGS, **changes}.items() if value is not None}
    return write(folder / "map.yaml", yaml.safe_dump(kept))


# ---- pictures ----------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["l.png", "l.bmp", "l.pgm", "L.PNG"])
@pytest.mark.parametrize("mode", ["1", "L", "P", "RGB", "RGBA", "LA"])
def test_a_picture_looks_in_the_world_as_on_the_page(tmp_path: Path, name: str, mode: str) -> None:
    """x to the right, y up, one cell per pixel, in every mode of each format."""
    if (name.endswith("pgm") and mode in ("P", "RGBA", "LA")) or (
        name.endswith("bmp") and mode == "LA"
    ):
        pytest.skip("the format has no such pictures")
    Image.fromarray(np.uint8(PAGE * 255)).convert(mode).save(tmp_path / name)
    terrain = read_world(tmp_path / name)
    assert terrain.free.tolist() == WORLD
    assert terrain.resolution == 1
    assert tuple(terrain.origin) == (0, 0)


@given(greys=st.lists(st.integers(0, 255), min_size=1, max_size=12))
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@pytest.mark.parametrize("kind", ["png", "bmp", "pgm"])
def test_half_of_full_scale_divides_free_from_blocked(
    tmp_path: Path, kind: str, greys: list[int]
) -> None:
    """Every grey value in every format, compared with the plain inequality."""
    Image.fromarray(np.array([greys], np.uint8)).save(tmp_path / f"x.{kind}")
    assert read_image(tmp_path / f"x.{kind}").free.tolist() == [[grey >= 127.5 for grey in greys]]


@pytest.mark.parametrize("most", [1, 7, 100, 254, 255, 256, 1001, 65534, 65535])
@pytest.mark.parametrize("plain", [True, False])
def test_a_pgm_is_judged_by_its_own_full_scale(tmp_path: Path, most: int, plain: bool) -> None:
    """P2 and P5, 8 and 16 bits, odd maxima, comments."""
    values = sorted({0, most // 3, (most - 1) // 2, (most + 1) // 2, most})
    head = f"P{2 if plain else 5}\n# a comment\n{len(values)} 1\n# another\n{most}\n".encode()
    binary = struct.pack(f">{len(values)}{'B' if most < 256 else 'H'}", *values)
    path = write(
        tmp_path / "x.pgm", head + (" ".join(map(str, values)).encode() if plain else binary)
    )
    assert read_image(path).free.tolist() == [[2 * value >= most for value in values]]


def test_sixteen_bit_png(tmp_path: Path) -> None:
    """A 16-bit grey value is not clipped to 8 bits: 300 of 65535 is nearly black."""
    Image.fromarray(np.array([[0, 300, 32767, 32768, 65535]], np.uint16)).save(tmp_path / "x.png")
    assert read_image(tmp_path / "x.png").free.tolist() == [[False, False, False, True, True]]
    colour = b"\0" + struct.pack(">6H", *[300] * 3, *[40000] * 3)
    assert read_image(write(tmp_path / "c.png", png(2, 1, 16, 2, colour))).free.tolist() == [
        [False, True]
    ]


def test_colour_counts_by_its_luminance(tmp_path: Path) -> None:
    """Pure green and yellow are bright, pure red and blue are dark."""
    colours = np.array([[[255, 0, 0], [0, 255, 0], [0, 0, 255], [255, 255, 0]]], np.uint8)
    Image.fromarray(colours).save(tmp_path / "x.png")
    assert read_image(tmp_path / "x.png").free.tolist() == [[False, True, False, True]]


def test_transparency_is_seen_on_white(tmp_path: Path) -> None:
    """Transparent black is white, faint black is bright, opaque black is dark."""
    veils = np.array([[[0, 0, 0, alpha] for alpha in (0, 60, 200, 255)]], np.uint8)
    Image.fromarray(veils).save(tmp_path / "x.png")
    assert read_image(tmp_path / "x.png").free.tolist() == [[True, True, False, False]]
    Image.fromarray(PAGE).convert("P").save(tmp_path / "p.png", transparency=0)
    assert read_image(tmp_path / "p.png").free.all()


@pytest.mark.parametrize(
    ("depth", "row"), [(1, b"\0\x40"), (2, b"\0\x10"), (4, b"\0\x01"), (8, b"\0\0\1")]
)
def test_one_transparent_grey_at_every_depth(tmp_path: Path, depth: int, row: bytes) -> None:
    """Pixels 0 and 1, of which grey 1 is transparent, are black and white."""
    path = write(tmp_path / "x.png", png(2, 1, depth, 0, row, (b"tRNS", b"\0\1")))
    assert read_image(path).free.tolist() == [[False, True]]


@pytest.mark.parametrize(("kind", "channels"), [(0, 1), (2, 3)])
def test_a_transparent_colour_in_16_bits_is_refused(
    tmp_path: Path, kind: int, channels: int
) -> None:
    """Pillow loses the low bits, which decide which pixels are transparent."""
    key = (b"tRNS", b"\x10\5" * channels)
    path = write(tmp_path / "x.png", png(1, 1, 16, kind, b"\0" + b"\x10\5" * channels, key))
    with pytest.raises(UnreadableScene, match="transparent 16-bit"):
        read_image(path)


def test_an_animation_gives_its_first_picture(tmp_path: Path) -> None:
    """Later frames of an APNG are ignored."""
    first, second = (Image.fromarray(np.uint8(page * 255)) for page in (PAGE, ~PAGE))
    first.save(tmp_path / "x.png", save_all=True, append_images=[second])
    assert read_image(tmp_path / "x.png").free.tolist() == WORLD


@pytest.mark.parametrize("kind", ["png", "bmp", "pgm"])
@pytest.mark.parametrize("share", [0, 0.1, 0.5, 0.9])
def test_a_truncated_picture_is_refused_by_name(tmp_path: Path, kind: str, share: float) -> None:
    """No pixels are guessed, and the message names the file."""
    noise = np.random.default_rng(0).integers(0, 255, (40, 40), np.uint8)
    Image.fromarray(noise).save(tmp_path / f"whole.{kind}")
    data = (tmp_path / f"whole.{kind}").read_bytes()
    path = write(tmp_path / f"cut.{kind}", data[: int(share * len(data))])
    with pytest.raises(UnreadableScene, match=f"cut.{kind}"):
        read_world(path)


@pytest.mark.parametrize(
    "content",
    [
        b"\0" * 100,
        "no picture",
        b"\x89PNG\r\n\x1a\n",
        b"GIF89a",
        "P5 0 5 255\n",
        "P5 -3 5 255\n",
        "P5 1 1 0\n\0",
        "P5 1 1 65536\n\0\0",
        "P2 1 1 7 9",
        "P2 1 1 7 x",
        "Pf\n1 1\n-1.0\n\0\0\0\0",
        png(1, 1, 8, 0, b""),
        png(0, 0, 8, 0, b""),
        png(1, 1, 3, 0, b"\0\0"),
    ],
)
def test_invalid_pictures_are_refused(tmp_path: Path, content: str | bytes) -> None:
    """The error is a named one, and its message names the file."""
    with pytest.raises(UnreadableScene, match=r"x\.png"):
        read_image(write(tmp_path / "x.png", content))


def test_a_jpeg_in_disguise_is_refused(tmp_path: Path) -> None:
    """JPEG blurs edges; only the documented formats are tried, whatever the file's name."""
    Image.new("CMYK", (4, 4)).save(tmp_path / "x.png", format="JPEG")
    with pytest.raises(UnreadableScene):
        read_image(tmp_path / "x.png")


@pytest.mark.parametrize("side", [5001, 7072, 10_000, 13_000, 60_000, 2**31 - 1])
@pytest.mark.parametrize("kind", ["png", "pgm", "bmp"])
def test_a_huge_picture_is_judged_by_its_header(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, side: int, kind: str
) -> None:
    """No pixel is decoded, and Pillow's warnings do not appear."""
    bmp = b"BM" + struct.pack("<IHHIIiiHHIIiiII", 54, 0, 0, 54, 40, side, side, 1, 24, *[0] * 6)
    heads = {
        "png": png(side, side, 8, 0, b"\0"),
        "pgm": f"P5 {side} {side} 255\n".encode(),
        "bmp": bmp,
    }
    monkeypatch.setattr("PIL.ImageFile.ImageFile.load", lambda image: pytest.fail("decoded"))
    warnings.simplefilter("error")
    with pytest.raises(SceneTooLarge, match="25,000,000"):
        read_image(write(tmp_path / f"x.{kind}", heads[kind]))


# ---- MovingAI ----------------------------------------------------------------------------------


@pytest.mark.parametrize("name", FREE_CELLS)
def test_the_benchmark_maps(name: str) -> None:
    """The number of free cells agrees with an independent count, and the rows with the file."""
    terrain = read_world(GRIDS / f"{name}.map")
    rows = (GRIDS / f"{name}.map").read_text().split()[7:]
    assert terrain.free.sum() == FREE_CELLS[name]
    assert terrain.free.tolist() == [[letter in ".GS" for letter in row] for row in reversed(rows)]


@pytest.mark.parametrize("name", FREE_CELLS)
def test_the_benchmark_scenarios(name: str) -> None:
    """Starts and goals are centres of free cells; lengths are at least the distance."""
    free = read_map(GRIDS / f"{name}.map").free
    path = scenario_beside(GRIDS / f"{name}.map")
    assert path == GRIDS / f"{name}-even-1.scen"
    queries = read_scenario(path)
    assert len(queries) == len(path.read_text().splitlines()) - 1
    for query in queries:
        for x, y in (query.start, query.goal):
            assert (x % 1, y % 1) == (0.5, 0.5)
            assert free[int(y), int(x)]
        assert query.length >= np.linalg.norm(query.goal - query.start) - 1e-6


@pytest.mark.parametrize(
    "text",
    [
        CORNER,
        CORNER[:-1],
        CORNER + "\n \n\n",
        CORNER.replace("\n", "\r\n"),
        CORNER.replace("\n", "\r"),
        "\ufeff" + CORNER,
        CORNER.replace("height 2\nwidth 3", "width 3\nheight 2"),
        CORNER.replace("type octile", "\n type\toctile ").replace("map", "map "),
    ],
)
def test_a_map_reads_however_its_lines_end(tmp_path: Path, text: str) -> None:
    """Line ends, byte-order mark, blank lines and the order of the header do not matter."""
    assert read_map(write(tmp_path / "x.map", text)).free.tolist() == WORLD


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("GSW", "GXW", "row 2, column 2.*'X'"),
        ("GSW", "G\u00e4W", "row 2, column 2"),
        ("GSW", "GS ?", "expected 3 characters in row 2, got 4"),
        ("GSW", "GS", "expected 3 characters in row 2, got 2"),
        ("GSW\n", "", "expected 2 rows as the header says, got 1"),
        ("GSW\n", "GSW\n...\n", "expected 2 rows as the header says, got 3"),
        (".@T\nGSW\n", "", "rows"),
        ("height 2", "height 0", "at least one"),
        ("height 2", "height -2", "whole number"),
        ("height 2", "height 2.0", "whole number"),
        ("height 2", "height \u0662", "whole number"),
        ("height 2", "height " + "9" * 5000, "whole number"),
        ("height 2", "height 999999999", "25,000,000"),
        ("height 2", "height", "expected lines"),
        ("height 2", "height 2\nheight 2", "expected lines"),
        ("height 2\n", "", "expected lines"),
        ("height", "hieght", "hieght"),
        ("octile", "tile", "type tile"),
        ("map\n", "", "line that says 'map'"),
        ("map\n", "map\n\0", "NUL"),
    ],
)
def test_a_map_that_contradicts_itself_is_refused(
    tmp_path: Path, old: str, new: str, message: str
) -> None:
    """The message names the file and says what was expected."""
    with pytest.raises(UnreadableScene, match=message) as caught:
        read_map(write(tmp_path / "x.map", CORNER.replace(old, new)))
    assert "x.map" in str(caught.value)
    assert isinstance(caught.value, SceneTooLarge) == ("25,000,000" in message)


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "utf-16-be", "utf-32"])
@pytest.mark.parametrize("read", [read_map, read_scenario, read_ros_map])
def test_wide_characters_are_refused(
    tmp_path: Path, read: Callable[[Path], object], encoding: str
) -> None:
    """With and without a byte-order mark."""
    with pytest.raises(UnreadableScene, match="plain text"):
        read(write(tmp_path / "x", CORNER.encode(encoding)))


def test_a_text_longer_than_any_world_is_refused(tmp_path: Path) -> None:
    """A sparse file of 4 GB is not read to its end."""
    with (tmp_path / "x.map").open("wb") as stream:
        stream.truncate(2**32)
    with pytest.raises(UnreadableScene):
        read_map(tmp_path / "x.map")
    with pytest.raises(SceneTooLarge):
        read_ros_map(write(tmp_path / "x.yaml", "#" * 200_000))


@pytest.mark.parametrize("first", ["version 1", "version 1.0", "\ufeffversion  1.0 "])
@pytest.mark.parametrize("line", [LINE, LINE.replace("\t", " "), LINE.replace("\n", "\t\r\n\r\n")])
def test_a_query_leads_between_centres(tmp_path: Path, first: str, line: str) -> None:
    """(0, 0) is the top left cell of two rows: its centre is (0.5, 1.5)."""
    (query,) = read_scenario(write(tmp_path / "x.scen", f"{first}\n{line}"))
    assert (query.map_name, query.length) == ("corner.map", 1.41421356)
    assert (query.start.tolist(), query.goal.tolist()) == ([0.5, 1.5], [1.5, 0.5])


def test_a_scenario_may_be_empty_and_a_map_name_may_have_blanks(tmp_path: Path) -> None:
    """A line with tabs is split at tabs only."""
    assert read_scenario(write(tmp_path / "x.scen", "version 1")) == []
    (query,) = read_scenario(
        write(tmp_path / "x.scen", "version 1\n" + LINE.replace("corner", "a corner"))
    )
    assert query.map_name == "a corner.map"


@pytest.mark.parametrize(
    ("column", "word", "message"),
    [
        (0, "x", "whole number"),
        (2, "0", "at least one"),
        (2, "99999999", "25,000,000"),
        (4, "3", r"3 x 2 map, got \(3, 0\)"),
        (5, "2", r"got \(0, 2\)"),
        (6, "-1", "whole number"),
        (6, "nan", "whole number"),
        (7, "1.5", "whole number"),
        (8, "nan", "length"),
        (8, "inf", "length"),
        (8, "-1", "length"),
        (8, "1_0", "length"),
        (8, "1\t2", "9 columns.*got 10"),
        (8, "", "9 columns.*got 8"),
    ],
)
def test_an_invalid_query_is_refused_with_its_line(
    tmp_path: Path, column: int, word: str, message: str
) -> None:
    """Here line 4, after the version, a good line and a blank one."""
    words = LINE.strip().split("\t")
    words[column] = word
    path = write(tmp_path / "x.scen", f"version 1\n{LINE}\n" + "\t".join(words))
    with pytest.raises(UnreadableScene, match=message) as caught:
        read_scenario(path)
    assert "x.scen" in str(caught.value)
    assert "line 4" in str(caught.value)


@pytest.mark.parametrize("first", ["", "version 2", "version", LINE, "version 1.5", "x\nversion 1"])
def test_a_scenario_says_its_version(tmp_path: Path, first: str) -> None:
    """The first line must be "version 1"."""
    with pytest.raises(UnreadableScene, match="line 1: expected 'version 1'"):
        read_scenario(write(tmp_path / "x.scen", first))


def test_the_scenario_beside_a_map(tmp_path: Path) -> None:
    """The most similar name is preferred; folders and scenarios of other maps are ignored."""
    path = write(tmp_path / "a[1].map", CORNER)
    write(tmp_path / "a1-even-1.scen", "")
    write(tmp_path / "a[1]-evening.scen", "")
    (tmp_path / "a[1].scen").mkdir()
    assert scenario_beside(path) is None
    (tmp_path / "a[1].scen").rmdir()
    for name in (
        "a[1]-random-1.scen",
        "a[1]-even-2.scen",
        "a[1]-even-1.scen",
        "a[1].scen",
        "a[1].map.scen",
    ):
        write(tmp_path / name, "")
        assert scenario_beside(path) == tmp_path / name
    assert scenario_beside(tmp_path / "nowhere" / "a.map") is None
    assert scenario_beside("a\0.map") is None


# ---- ROS ---------------------------------------------------------------------------------------


def test_a_ros_map_lies_where_its_yaml_says(tmp_path: Path) -> None:
    """The lower left corner is at the origin, and the cells have the size of the resolution."""
    terrain = read_world(ros(tmp_path))
    assert terrain.free.tolist() == WORLD
    assert terrain.resolution == 0.05
    assert tuple(terrain.origin) == (-1.5, 2)
    assert read_world(tmp_path / "map.pgm").free.tolist() == WORLD
    assert read_world((tmp_path / "map.yaml").rename(tmp_path / "map.YML")).free.tolist() == WORLD


def test_a_picture_that_a_ros_map_names_wrongly_is_named_with_its_map(tmp_path: Path) -> None:
    """The name to correct is in the map."""
    path = ros(tmp_path, image="room.pgm")
    with pytest.raises(UnreadableScene, match=r"map\.yaml: .*room\.pgm': expected a file"):
        read_ros_map(path)


@given(
    greys=st.lists(st.integers(0, 255), min_size=1, max_size=9),
    free=st.floats(0, 1),
    negate=st.booleans(),
)
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@pytest.mark.parametrize("mode", [None, "trinary", "scale"])
def test_free_is_what_ros_calls_free(
    tmp_path: Path, mode: str | None, greys: list[int], free: float, negate: bool
) -> None:
    """p < free_thresh, strictly; unknown is not free."""
    changes = {"free_thresh": free, "occupied_thresh": 1.0, "negate": int(negate), "mode": mode}
    terrain = read_ros_map(ros(tmp_path, np.array([greys], np.uint8), **changes))
    assert terrain.free.tolist() == [[(x if negate else 255 - x) / 255 < free for x in greys]]


def test_the_unknown_grey_of_ros_is_not_free(tmp_path: Path) -> None:
    """map_saver writes 254 for free, 205 for unknown, 0 for occupied."""
    path = ros(tmp_path, np.array([[254, 205, 0]], np.uint8))
    assert read_ros_map(path).free.tolist() == [[True, False, False]]


def test_colour_alpha_and_16_bits_in_a_ros_map(tmp_path: Path) -> None:
    """Channels have equal weights, transparent white is not free, 16 bits keep their scale."""
    path = ros(tmp_path, np.array([[65535, 60000, 300, 0]], np.uint16))
    assert read_ros_map(path).free.tolist() == [[True, True, False, False]]
    path = ros(tmp_path, np.array([[[255, 255, 60], [0, 255, 0]]], np.uint8), free_thresh=0.3)
    assert read_ros_map(path).free.tolist() == [[True, False]]
    for mode in ("trinary", "scale"):
        path = ros(tmp_path, image="clear.png", mode=mode)
        Image.fromarray(np.array([[[255] * 4, [255, 255, 255, 0]]], np.uint8)).save(
            tmp_path / "clear.png"
        )
        assert read_ros_map(path).free.tolist() == [[True, False]]


@pytest.mark.parametrize(("mode", "free"), [("trinary", True), ("scale", False)])
def test_only_trinary_averages_alpha(tmp_path: Path, mode: str, free: bool) -> None:
    """The mean of 220, 220, 220 and the alpha 255 is lighter than 220."""
    path = ros(tmp_path, image="grey.png", mode=mode, free_thresh=0.12)
    Image.fromarray(np.array([[[220, 220, 220, 255]]], np.uint8)).save(tmp_path / "grey.png")
    assert read_ros_map(path).free.tolist() == [[free]]


def test_numbers_that_yaml_takes_for_text(tmp_path: Path) -> None:
    """1e-2 has no dot, so YAML 1.1 reads a string where ROS reads a number."""
    path = ros(tmp_path)
    write(path, path.read_text().replace("0.05", "5e-2").replace("negate: 0", "negate: false"))
    assert read_ros_map(path).resolution == 0.05


@pytest.mark.parametrize("number", ["010", "1_0", "1:30", "0x10", "0b11", "'1_0'", "\u0661"])
def test_numbers_that_programs_read_differently_are_refused(tmp_path: Path, number: str) -> None:
    """YAML 1.1 reads 010 as 8, and 1:30 as 90."""
    path = ros(tmp_path)
    write(path, path.read_text().replace("0.05", number))
    with pytest.raises(UnreadableScene, match=r"no decimal number|finite number"):
        read_ros_map(path)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        *[({key: None}, f"missing: {key}") for key in SETTINGS],
        ({"resolution": None, "resolutoin": 1}, "misspelt: .*resolutoin"),
        ({"mdoe": "scale"}, "misspelt: .*mdoe"),
        ({"resolution": 0}, "above 0"),
        ({"resolution": -1}, "above 0"),
        *[({"resolution": bad}, "finite number") for bad in NOT_FINITE],
        ({"origin": [0, 0]}, "x, y, yaw"),
        ({"origin": "0 0 0"}, "x, y, yaw"),
        ({"origin": [0, float("inf"), 0]}, "finite number"),
        ({"origin": [0, 0, 0.1]}, "yaw 0"),
        ({"negate": 2}, "negate: 0"),
        ({"negate": "maybe"}, "negate: 0"),
        ({"free_thresh": 0.7}, "<= occupied_thresh"),
        ({"occupied_thresh": 65}, "<= 1"),
        ({"free_thresh": float("nan")}, "finite"),
        ({"mode": "raw"}, "raw"),
        ({"mode": "tirnary"}, "tirnary"),
        ({"mode": ["scale"]}, "scale"),
        ({"image": ""}, "name of a picture"),
        ({"image": 3}, "name of a picture"),
        ({"image": "gone.pgm"}, "gone.pgm"),
        ({"image": "."}, "folder"),
        ({"image": "map.yaml"}, "expected a PNG"),
        ({"image": "a\0b"}, "check the path"),
    ],
)
def test_an_invalid_setting_is_refused(
    tmp_path: Path, changes: dict[str, Any], message: str
) -> None:
    """The message names the file and the setting."""
    with pytest.raises(UnreadableScene, match=message) as caught:
        read_ros_map(ros(tmp_path, **changes))
    assert str(tmp_path)[:20] in str(caught.value)


def test_a_list_and_a_repeated_key_are_told_apart(tmp_path: Path) -> None:
    """The message shows a list; of a repeated key, ROS and this parser use different ones."""
    with pytest.raises(UnreadableScene, match=r"got \['image'\]"):
        read_ros_map(write(tmp_path / "x.yaml", "- image"))
    with pytest.raises(UnreadableScene, match="'resolution' twice"):
        read_ros_map(write(tmp_path / "x.yaml", ros(tmp_path).read_text() + "resolution: 1\n"))


def test_settings_of_other_tools_are_ignored(tmp_path: Path) -> None:
    """A key that resembles none of ours belongs to another program."""
    assert read_ros_map(ros(tmp_path, author="me", map_type="2d")).free.tolist() == WORLD


NINEFOLD = "a{1}: &a{1} {{<<: [*a{0}, *a{0}, *a{0}, *a{0}, *a{0}, *a{0}, *a{0}, *a{0}, *a{0}]}}\n"
BOMB = "a0: &a0 {x: 1}\n" + "".join(NINEFOLD.format(i, i + 1) for i in range(9))


@pytest.mark.parametrize(
    "text",
    [
        "",
        "- image",
        "image",
        "3",
        "image: [",
        "? [a]\n: b",
        "!!python/object/apply:os.system [ls]",
        "a: 2001-13-45",
        "a: 0x",
        "a: " + "9" * 5000,
        "a: 0x" + "f" * 5000,
        "[" * 19_000,
        "? " * 9_000,
        "a: " + ":".join(["1"] * 9_000),
        "{a: " * 4_000,
        "- " * 9_000,
        "\x07",
        "a: *a",
        "".join(f"resolution{i}: 1\n" for i in range(1_000)),
        "--- 1\n--- 2",
        BOMB,
        "%YAML 9",
        "\t",
    ],
)
def test_yaml_that_is_not_a_map_is_refused(tmp_path: Path, text: str) -> None:
    """Expanding aliases, deep nesting, tags and fragments raise the same error."""
    with pytest.raises(UnreadableScene, match=r"x\.yaml"):
        read_ros_map(write(tmp_path / "x.yaml", text))


# ---- all formats, and what is not a file -------------------------------------------------------


@pytest.mark.parametrize("read", [read_world, read_image, read_map, read_scenario, read_ros_map])
@pytest.mark.parametrize("ending", [".png", ".map", ".yaml"])
def test_what_is_not_a_file_is_refused(
    tmp_path: Path, read: Callable[[Path], object], ending: str
) -> None:
    """Missing, a folder, a cycle of links, a pipe, a name too long or with a NUL, ..."""
    (tmp_path / f"folder{ending}").mkdir()
    (tmp_path / f"loop{ending}").symlink_to(tmp_path / f"loop{ending}")
    if hasattr(os, "mkfifo"):  # not on Windows, where the file is simply missing
        os.mkfifo(tmp_path / f"pipe{ending}")
    write(tmp_path / f"empty{ending}", "")
    names = (
        "gone",
        "empty.map/x",
        "folder",
        "loop",
        "pipe",
        "x" * 5000,
        "nul\0",
        "empty",
        "gone/x",
    )
    for name in names:
        with pytest.raises(UnreadableScene, match="expected"):
            read(tmp_path / f"{name}{ending}")


def test_an_unknown_ending_lists_the_known_ones(tmp_path: Path) -> None:
    """The messages for a scene and a folder say what to do instead."""
    with pytest.raises(UnknownFormat, match=r"\.bmp, .*\.map, .*\.stl, \.yaml or \.yml, got \.txt"):
        read_world(write(tmp_path / "x.txt", ""))
    with pytest.raises(UnknownFormat, match="no ending"):
        read_world(str(tmp_path / "x"))
    with pytest.raises(UnknownFormat, match="read_scene"):
        read_world(write(tmp_path / "x.JSON", "{}"))
    with pytest.raises(UnknownFormat, match="a folder"):
        read_world(tmp_path)


@cache
def good_meshes() -> dict[str, bytes]:
    """A box in every format."""
    meshes = {
        f"x.{kind}": trimesh.creation.box().export(file_type=kind)
        for kind in ("stl", "obj", "dae", "glb")
    }
    return {name: mesh.encode() if isinstance(mesh, str) else mesh for name, mesh in meshes.items()}


def good_files(folder: Path) -> dict[str, bytes]:
    """One valid file for each reader."""
    files = {"x.map": CORNER.encode(), "x.scen": f"version 1\n{LINE}{LINE}".encode()}
    for kind in ("png", "bmp", "pgm"):
        Image.fromarray(np.uint8(PAGE * 255)).save(folder / f"x.{kind}")
        files[f"x.{kind}"] = (folder / f"x.{kind}").read_bytes()
    files |= good_meshes()
    files["x.json"] = (
        b'{"polygons": [[[0, 0], [1, 0], [0, 1]], [[0, 0], [2, 2], [2, 0], [0, 2]]],'
        b' "start": [0.9, 0.9]}'
    )
    return {**files, "x.yaml": ros(folder).read_bytes()}


def read_or_refuse(path: Path) -> None:
    """Read a file; only a named error is allowed."""
    with suppress(KinoeduError), warnings.catch_warnings():
        warnings.simplefilter("ignore", MendedPolygons)
        read_scenario(path) if path.suffix == ".scen" else read_world(path)


KINDS = [
    "x.map",
    "x.scen",
    "x.png",
    "x.bmp",
    "x.pgm",
    "x.yaml",
    "x.stl",
    "x.obj",
    "x.dae",
    "x.glb",
    "x.json",
]


@given(data=st.binary(max_size=300))
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@pytest.mark.parametrize("name", KINDS)
def test_random_bytes_read_or_are_refused(tmp_path: Path, name: str, data: bytes) -> None:
    """No reader raises another exception."""
    read_or_refuse(write(tmp_path / name, data))


@given(
    edits=st.lists(
        st.tuples(st.integers(0, 999), st.integers(0, 4), st.binary(max_size=4)),
        min_size=1,
        max_size=4,
    )
)
@settings(
    suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None, max_examples=300
)
@pytest.mark.parametrize("name", KINDS)
def test_a_damaged_file_reads_or_is_refused(
    tmp_path: Path, name: str, edits: list[tuple[int, int, bytes]]
) -> None:
    """Some bytes of a valid file are removed, replaced or inserted."""
    data = good_files(tmp_path)[name]
    for place, cut, patch in edits:
        at = place % (len(data) + 1)
        data = data[:at] + patch + data[at + cut :]
    read_or_refuse(write(tmp_path / name, data))


SCALARS = (
    st.integers()
    | st.floats()
    | st.booleans()
    | st.text(max_size=5)
    | st.dates()
    | st.binary(max_size=3)
)
VALUES = st.recursive(
    SCALARS, lambda inner: st.lists(inner, max_size=3) | st.dictionaries(SCALARS, inner, max_size=2)
)


@given(changes=st.dictionaries(st.sampled_from([*SETTINGS, "mode", "other"]), VALUES))
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
def test_any_settings_read_or_are_refused(tmp_path: Path, changes: dict[str, Any]) -> None:
    """Values of every kind that YAML has."""
    read_or_refuse(ros(tmp_path, **changes))


@pytest.mark.parametrize(
    ("name", "text", "error"),
    [
        ("flat.csv", "0,0,0, 9,0,0, 1, 3, 4,1, 5,1, 6,1", InvalidPolygon),
        ("hit.csv", "0,0,0, 9,0,0, 1, 3, -1,-1, 5,1, 5,2", InvalidStart),
        ("far.csv", "1e160,0,0, 9,0,0, 0", KinoeduError),
        ("many.csv", "0,0,0, 9,0,0, 1e300", UnreadableScene),
        (
            "turning.json",
            '{"polygons": [[[2, 2], [3, 2], [3, 3]]], "start": [1, 1, 0], "goal": [9, 9, 0]}',
            KinoeduError,
        ),
    ],
)
def test_what_is_wrong_with_a_problem_names_its_file(tmp_path, name, text, error):
    """Also where a polygon, a start or a number is wrong, and not the form of the file."""
    (tmp_path / name).write_text(text)
    with pytest.raises(error, match=name) as raised:
        ke.read_problem(tmp_path / name)
    assert len(str(raised.value)) < 300 + len(str(tmp_path))


@pytest.mark.parametrize("name", ["x.csv", "x.png", "x.stl", "x.json", "x.map"])
def test_a_file_that_must_not_be_read_is_called_so(tmp_path, monkeypatch, name):
    (tmp_path / name).write_text("")

    def refuse(*_, **__):
        raise PermissionError(13, "Permission denied", name)

    monkeypatch.setattr(Path, "open", refuse)
    monkeypatch.setattr("builtins.open", refuse)
    with pytest.raises(UnreadableScene, match=f"{name}: it cannot be read: Permission denied"):
        read_world(tmp_path / name) if name == "x.png" else ke.read_problem(tmp_path / name)

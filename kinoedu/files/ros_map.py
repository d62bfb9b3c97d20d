"""Maps of ROS: a picture and a YAML file with its settings (https://wiki.ros.org/map_server)."""

import math
import os
import re
from collections.abc import Iterator
from contextlib import suppress
from difflib import get_close_matches
from itertools import pairwise
from pathlib import Path
from reprlib import repr as brief
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..errors import UnreadableScene
from ..support.reading import naming, read_text
from ..worlds.terrain import Terrain, TerrainRecord
from .images import deep_grey, load_image

if TYPE_CHECKING:
    from PIL.Image import Image

_REQUIRED = ("image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh")
_MAX_YAML = 20_000  # bytes: a map's settings are ten lines
_DECIMAL = re.compile(r"[-+.0-9eE]+")
# YAML 1.1 reads 010 as 8, 1_0 as 10 and 1:30 as 90, and ROS does not
_NO_DECIMAL = re.compile(r"[-+]?(0[xb_0-9][_0-9a-fA-F]*|[0-9][_0-9]*[_:][_:.0-9]*)")


def read_ros_map(path: str | os.PathLike[str]) -> TerrainRecord:
    """Read a terrain from a ROS map, in metres.

    A pixel of shade x, the mean of its channels in 0..255, is occupied with probability p = (255 -
    x) / 255, or x / 255 under `negate`. It is free where p < free_thresh; occupied and unknown
    cells are not free. In mode `trinary` an alpha channel is included in the mean, as in ROS; in
    mode `scale` transparent pixels are unknown.

    Parameters
    ----------
    path : str or path
        The YAML file, with the keys image (a path relative to it), resolution (metres per cell),
        origin (x, y, yaw of the lower left corner), negate, occupied_thresh, free_thresh, and mode
        if it is not trinary.

    Returns
    -------
    TerrainRecord

    Raises
    ------
    UnreadableScene
        Where a file is missing or damaged; a setting is missing, misspelt or not valid; the yaw is
        not 0; the mode is `raw`.
    SceneTooLarge
        Where a file is too large.
    """
    path = Path(path)
    settings = _settings(path)
    resolution = _number(path, "resolution", settings["resolution"])
    _expect(resolution > 0, path, "a resolution above 0 metres a cell", resolution)
    origin = _origin(path, settings["origin"])
    negate, name, mode = settings["negate"], settings["image"], settings.get("mode", "trinary")
    _expect(negate in (0, 1), path, "negate: 0 or negate: 1", negate)
    modes = "mode: trinary or scale (raw does not define which cells are free)"
    _expect(mode in ("trinary", "scale"), path, modes, mode)
    _expect(isinstance(name, str) and name != "", path, "image: the name of a picture", name)
    free_below = _free_threshold(path, settings)
    with naming(path):
        image = load_image(path.parent / str(name))
        free = _free_cells(image, free_below, bool(negate), averages_alpha=mode == "trinary")
        return Terrain(free[::-1], resolution=resolution, origin=origin)


def _expect(holds: bool, path: Path, expected: str, got: object) -> None:
    """Raise UnreadableScene unless the condition holds."""
    if not holds:
        raise UnreadableScene(f"{path}: expected {expected}, got {brief(got)}; correct it")


def _settings(path: Path) -> dict[object, object]:
    """The mapping in a YAML file, with all required keys."""
    settings = _load_yaml(path)
    if not isinstance(settings, dict):
        raise UnreadableScene(
            f"{path}: expected lines like 'resolution: 0.05', got {brief(settings)}"
        )
    missing = [key for key in _REQUIRED if key not in settings]
    keys = [*_REQUIRED, "mode"]
    others = (str(key)[:40] for key in settings if key not in keys)
    misspelt = [key for key in others if get_close_matches(key, keys, cutoff=0.75)]
    if missing or misspelt:
        raise UnreadableScene(
            f"{path}: expected the keys {', '.join(keys)}; missing: "
            f"{', '.join(missing) or 'none'}; misspelt: {brief(misspelt) if misspelt else 'none'}"
        )
    return settings


def _load_yaml(path: Path) -> object:
    """Parse a small YAML file."""
    import yaml

    text = read_text(path, _MAX_YAML)
    try:
        _check_tokens(yaml.scan(text))
        _check_twins(yaml.compose(text, Loader=yaml.SafeLoader))
        return yaml.safe_load(text)
    except Exception as error:  # ValueError and RecursionError too, not only YAMLError
        raise UnreadableScene(
            f"{path}: expected YAML, got: {str(error)[:300]}; correct that line"
        ) from error


def _check_tokens(tokens: Iterator[Any]) -> None:
    """Refuse what costs a parser minutes and no map needs: aliases, deep nesting, long values.

    Numbers that programs read differently are refused too.
    """
    nested = 0
    for token in tokens:
        kind = type(token).__name__
        nested += kind.endswith(("SequenceStartToken", "MappingStartToken"))
        if kind == "AliasToken" or nested > 100 or len(getattr(token, "value", None) or "") > 1_000:
            raise ValueError(
                "an alias (*name), more than 100 lists, or a value longer than 1,000 characters"
            )
        if getattr(token, "plain", False) and _NO_DECIMAL.fullmatch(token.value):
            raise ValueError(f"{token.value}, which is no decimal number")


def _check_twins(node: Any) -> None:
    """Refuse a repeated key: ROS would use the first value, and this parser the last."""
    pairs = node.value if getattr(node, "id", None) == "mapping" else []
    keys = sorted(str(key.value) for key, _ in pairs)
    if twins := [key for key, following in pairwise(keys) if key == following]:
        raise ValueError(f"the key {brief(twins[0])} twice")


def _number(path: Path, key: str, value: object) -> float:
    """A finite number. `1e-2` is text in YAML 1.1 but a number in ROS, so text is tried too."""
    number = math.nan
    is_odd = isinstance(value, str) and not _DECIMAL.fullmatch(value)
    if isinstance(value, int | float | str) and not isinstance(value, bool) and not is_odd:
        with suppress(ValueError, OverflowError):
            number = float(value)
    _expect(math.isfinite(number), path, f"a finite number for {key}", value)
    return number


def _origin(path: Path, value: object) -> tuple[float, float]:
    """The position of the lower left corner, in metres."""
    if not isinstance(value, list) or len(value) != 3:
        raise UnreadableScene(
            f"{path}: expected origin: [x, y, yaw], got {brief(value)}; correct it"
        )
    x, y, yaw = (_number(path, "origin", coordinate) for coordinate in value)
    _expect(yaw == 0, path, "an origin with yaw 0 (rotate the picture instead)", yaw)
    return x, y


def _free_threshold(path: Path, settings: dict[object, object]) -> float:
    """The occupancy below which a cell is free; at most the threshold of occupied cells."""
    free, occupied = (
        _number(path, key, settings[key]) for key in ("free_thresh", "occupied_thresh")
    )
    expected = "0 <= free_thresh <= occupied_thresh <= 1"
    _expect(0 <= free <= occupied <= 1, path, expected, (free, occupied))
    return free


def _free_cells(
    image: "Image", free_below: float, negate: bool, averages_alpha: bool
) -> NDArray[np.bool_]:
    """Whether each cell is free, (rows, columns), top row first; evaluated once for each shade."""
    shade = deep_grey(image)
    full, opaque = 65535, True
    if shade is None:
        pixels = np.asarray(image.convert("RGBA"))
        channels = 4 if averages_alpha and image.has_transparency_data else 3
        shade, full = pixels[..., :channels].sum(axis=2, dtype=np.uint16), 255 * channels
        opaque = True if averages_alpha else pixels[..., 3] == 255
    levels = np.arange(full + 1)
    free_levels = (levels if negate else full - levels) / full < free_below
    return np.asarray(free_levels[shade] & opaque)

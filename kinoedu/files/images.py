"""Terrains from pictures: bright pixels are free, dark pixels are blocked."""

from __future__ import annotations

import os
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..errors import KinoeduError, SceneTooLarge, UnreadableScene
from ..geometry.checks import Array, positive
from ..support.reading import regular_file
from ..worlds.terrain import Terrain, TerrainRecord
from .sizes import MAX_CELLS, check_size

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageFile import ImageFile

_FORMATS = ("PNG", "BMP", "PPM")  # PPM is Pillow's name for a family that includes PGM
_DEEP_GREY = ("I", "I;16", "I;16B", "I;16L", "I;16N")  # Pillow scales each of these to 0..65535
_SHALLOW = ("1", "L", "LA", "P", "PA", "RGB", "RGBA", "RGBX", "CMYK")
_KEY_SCALE = {"1": 255, "L;2": 85, "L;4": 17}  # from 1, 2 and 4 bits to 0..255


def read_image(path: str | os.PathLike[str]) -> TerrainRecord:
    """Read a terrain with one cell for each pixel of a picture, of side 1.

    The lower left corner of the picture is the origin. A pixel is free when its brightness is at
    least half of full scale. The brightness of a colour is its luminance (ITU-R BT.601),
    transparent pixels are laid on white, and of an animation the first picture is used.

    Parameters
    ----------
    path : str or path
        PNG, BMP or PGM (plain P2 or binary P5), 1 to 16 bits a channel.

    Returns
    -------
    TerrainRecord

    Raises
    ------
    UnreadableScene
        Where the file is missing, damaged or not such a picture.
    SceneTooLarge
        Where it has more than `MAX_CELLS` pixels.

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     picture = Path(folder) / "white_above_black.pgm"
    ...     _ = picture.write_text("P2 1 2 255 255 0")
    ...     read_image(picture).free.tolist()  # row 0 is the lowest
    [[False], [True]]
    """
    image = load_image(path)
    deep = deep_grey(image)
    free = _luminance(image) >= 128 if deep is None else deep >= 32768
    return Terrain(free[::-1])


def read_brightness(path: str | os.PathLike[str]) -> NDArray[np.float64]:
    """The brightness of each pixel, from 0 to 1.

    Returns
    -------
    (rows, columns) array, top row first.

    Raises
    ------
    UnreadableScene, SceneTooLarge
        As in `read_image`.
    """
    image = load_image(path)
    deep = deep_grey(image)
    return _luminance(image) / 255.0 if deep is None else deep / 65535.0


def load_image(path: str | os.PathLike[str]) -> Image:
    """Decode a picture after its header has been checked.

    Raises
    ------
    UnreadableScene, SceneTooLarge
        As in `read_image`.
    """
    from PIL import Image, UnidentifiedImageError

    path = regular_file(path)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # the causes are refused here, or harmless
            with Image.open(path, formats=_FORMATS) as image:
                check_size(path, *image.size)
                _check_mode(image, path)
                _scale_transparent_grey(image)
                image.load()
                return image
    except KinoeduError:
        raise
    except PermissionError as error:
        why = error.strerror
        raise UnreadableScene(f"{path}: it cannot be read: {why}; check its permissions") from error
    except Image.DecompressionBombError as error:
        raise SceneTooLarge(
            f"{path}: expected at most {MAX_CELLS:,} cells: {error}; shrink it"
        ) from error
    except Exception as error:  # damaged bytes raise anything from OSError to struct.error
        why = "something else" if isinstance(error, UnidentifiedImageError) else f"damage: {error}"
        raise UnreadableScene(
            f"{path}: expected a PNG, BMP or PGM, got {why}; save it again"
        ) from error


def _check_mode(image: ImageFile, path: Path) -> None:
    """Refuse pixels without a defined brightness: floats, and a transparent colour in 16 bits."""
    if image.mode not in _DEEP_GREY + _SHALLOW:
        raise UnreadableScene(
            f"{path}: expected 1 to 16 bits a channel, got Pillow's mode {image.mode!r}"
        )
    if "transparency" in image.info and image.tile[0][3] in ("I;16B", "RGB;16B"):
        raise UnreadableScene(
            f"{path}: expected 8 bits or an alpha channel, got a transparent 16-bit colour"
        )


def _scale_transparent_grey(image: ImageFile) -> None:
    """Scale the transparent grey of a PNG to 0..255, which Pillow does not always do."""
    scale = _KEY_SCALE.get(str(image.tile[0][3]))
    if scale and "transparency" in image.info:
        image.info["transparency"] = min(255, scale * image.info["transparency"])


def deep_grey(image: Image) -> NDArray[Any] | None:
    """The greys, (rows, columns) in 0..65535, of a picture with more than 8 bits; else None."""
    return np.asarray(image) if image.mode in _DEEP_GREY else None


def _luminance(image: Image) -> NDArray[np.uint8]:
    """The brightness (rows, columns) in 0..255 of a picture laid on white, top row first."""
    from PIL import Image

    paper = Image.new("RGBA", image.size, "white")
    return np.asarray(Image.alpha_composite(paper, image.convert("RGBA")).convert("L"))


def read_heights(path: str | os.PathLike[str], *, highest: float = 1.0) -> Array:
    """Read heights from a grey picture: black is 0, white is `highest`.

    Returns
    -------
    (rows, columns) array; row 0 is the lowest, as in `Terrain`.

    Raises
    ------
    UnreadableScene, SceneTooLarge
        Where the picture cannot be read.
    InvalidParameter
        Where `highest` is not positive.
    """
    return positive(highest, "highest") * read_brightness(path)[::-1]

"""matplotlib's fonts, for programs that draw where there is no disk.

matplotlib measures text by the files of its fonts, also in `tight_layout` and for labels of ticks.
They are read before the disk goes, and each program that draws gets copies of its own.
"""

import sys
from pathlib import Path

FONTS = "fonts/ttf"  # within matplotlib's folder of data
# for text in the usual families, for formulas, and for what no other font has
USUAL = ("DejaVu*.ttf", "cm*.ttf", "LastResort*.ttf")
FOLDER = "pictures"  # takes the place of matplotlib's folder, in that of the program
KEPT: dict[str, bytes] = {}  # the files' contents by their names


def keep_fonts() -> None:
    """Read the fonts, if matplotlib is loaded."""
    if "matplotlib" in sys.modules:
        from matplotlib import get_data_path

        folder = Path(get_data_path(), FONTS)
        files = (file for pattern in USUAL for file in sorted(folder.glob(pattern)))
        KEPT.update((file.name, file.read_bytes()) for file in files)


def install_fonts() -> None:
    """Give this process the fonts that were kept, and let matplotlib know no others."""
    import matplotlib
    from matplotlib.font_manager import fontManager

    home = Path(FOLDER).resolve()
    matplotlib.get_data_path = lambda: str(home)
    fontManager.ttflist.clear()
    (home / FONTS).mkdir(parents=True, exist_ok=True)
    for name, content in KEPT.items():
        file = home / FONTS / name
        file.write_bytes(content)
        fontManager.addfont(file)

"""The site's code can be read in both themes."""

import re
from pathlib import Path

import pytest
from pygments.styles import get_style_by_name
from pygments.token import Whitespace

HOUSE = Path(__file__).resolve().parent.parent
LINEAR = 0.03928  # below it a channel's brightness is linear
STYLES = r'pygments_style, pygments_dark_style = "(.+)", "(.+)"'


@pytest.mark.parametrize("theme", [1, 2], ids=["light", "dark"])
def test_code_can_be_read(theme):
    """Each colour has a contrast of 4.5 to 1 with what is behind it."""
    named = re.search(STYLES, (HOUSE / "docs" / "conf.py").read_text(encoding="utf-8"))
    chosen = get_style_by_name(named[theme])
    for token, look in chosen:
        if look["color"] and token is not Whitespace:
            behind = look["bgcolor"] or chosen.background_color.removeprefix("#")
            assert contrast(look["color"], behind) >= 4.5, token


def contrast(a, b):
    """Of two colours, as WCAG defines it."""
    dark, light = sorted(map(brightness, (a, b)))
    return (light + 0.05) / (dark + 0.05)


def brightness(colour):
    """The relative luminance of six hexadecimal digits."""
    parts = [int(colour[k : k + 2], 16) / 255 for k in (0, 2, 4)]
    red, green, blue = (p / 12.92 if p <= LINEAR else ((p + 0.055) / 1.055) ** 2.4 for p in parts)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue

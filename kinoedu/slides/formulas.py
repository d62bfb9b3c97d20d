"""Formulas as MathML: browsers draw it without JavaScript and fonts of ours, and screen readers
read it.
"""

import re

THIN = '<mspace width="0.167em"/>'

# Where browsers do not space the converter's MathML as TeX would.
SPACED = [
    # = -1
    (
        r"(<mo[^>]*>(?:&#x000(?:28|2C|3D);|&#x02...;|\[|\()</mo>)<mo>(?=&#x02212;)",
        r'\1<mo form="prefix">',
    ),
    (r"<mo>(?=&#x0002F;)", '<mo lspace="0" rspace="0">'),  # a/b
    ("<mi>:</mi><mo>&#x0003D;</mo>", "<mo>:=</mo>"),
    ("<mi>:</mi>", '<mo lspace="0.278em" rspace="0.278em">:</mo>'),  # {a : a > 0}
    (r"(<mi>[a-z]{2,}</mi>)(?=<m(?:[in]|sub|sup)>)", rf"\1{THIN}"),  # sin x
    (r"(?<=</m[in]>)(?=<mi>[a-z]{2,}</mi>)", THIN),  # r sin
]


def to_mathml(tex: str, display: str) -> str:
    """TeX as MathML.

    Parameters
    ----------
    display : "inline", or "block" for a formula in a line of its own.
    """
    from latex2mathml.converter import convert

    text: str = convert(tex.replace(r"\operatorname", r"\text"), display=display)
    for where, spaced in SPACED:
        text = re.sub(where, spaced, text)
    return text

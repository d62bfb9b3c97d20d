"""Formulas as MathML: browsers draw it without JavaScript and fonts of ours, and screen readers
read it.
"""

import re

from docutils import nodes
from latex2mathml.converter import convert

THIN = '<mspace width="0.167em"/>'

# Where browsers do not space the converter's MathML as TeX would.
SPACED = [
    # = -1
    (
        r"(<mo[^>]*>(?:&#x000(?:28|2C|3D);|&#x02...;|\[|\()</mo>)<mo>(?=&#x02212;)",
        r'\1<mo form="prefix">',
    ),
    (r"<mo>(?=&#x0002F;)", '<mo lspace="0" rspace="0">'),  # a/b
    (r"(<mi>[a-z]{2,}</mi>)(?=<m(?:[in]|sub|sup)>)", rf"\1{THIN}"),  # sin x
    (r"(?<=</m[in]>)(?=<mi>[a-z]{2,}</mi>)", THIN),  # r sin
]


def setup(app):
    """Called by Sphinx."""
    app.add_html_math_renderer("mathml", (inline_formula, None), (displayed_formula, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def inline_formula(writer, node):
    """A formula within a line."""
    writer.body.append(mathml(node.astext(), "inline"))
    raise nodes.SkipNode


def displayed_formula(writer, node):
    """A formula in a line of its own."""
    writer.body.append(f'<div class="math">{mathml(node.astext(), "block")}</div>')
    raise nodes.SkipNode


def mathml(tex, display):
    """TeX as MathML."""
    text = convert(tex.replace(r"\operatorname", r"\text"), display=display)
    for where, spaced in SPACED:
        text = re.sub(where, spaced, text)
    return text

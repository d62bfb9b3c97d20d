"""Formulas of the site's pages, as MathML."""

from docutils import nodes

from kinoedu.slides.formulas import to_mathml


def setup(app):
    """Called by Sphinx."""
    app.add_html_math_renderer("mathml", (inline_formula, None), (displayed_formula, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def inline_formula(writer, node):
    """A formula within a line."""
    writer.body.append(to_mathml(node.astext(), "inline"))
    raise nodes.SkipNode


def displayed_formula(writer, node):
    """A formula in a line of its own."""
    writer.body.append(f'<div class="math">{to_mathml(node.astext(), "block")}</div>')
    raise nodes.SkipNode

"""Slides for a lecture, made from a lesson's notebook.

`markdown.py` cuts text into blocks, `rule.py` decides what stands on which slide, `page.py` writes
one file of HTML that needs no network. `formulas.py` makes MathML of TeX, also for the site.
`exporter.py` makes a page of any notebook, whose boards play.
"""

from .page import make_slides

__all__ = ["make_slides"]

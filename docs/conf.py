"""The course as a site, for Sphinx: python start.py site. The sources are the whole course; nothing
is run, nothing is fetched.
"""

import os
import sys
from pathlib import Path

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE))
os.environ["NUMBA_DISABLE_JIT"] = "1"  # the reference shows functions as they are written

project = "kinoedu"
root_doc = "README"
include_patterns = [
    "README.md",
    "CHANGELOG.md",
    "docs/**.md",
    "notebooks/*.ipynb",
    "exercises/*.ipynb",
]
include_patterns += [
    "notebooks/maps/README.md",
    "tests/data/*/README.md",
    "solutions/README.md",
    "benchmarks/README.md",
]
# contents.md is a part of the entrance; folders such as .venv have tens of thousands of files
exclude_patterns = ["docs/contents.md", ".*"]
extensions = ["myst_nb", "sphinx.ext.autodoc", "sphinx.ext.viewcode", "formulas"]
extensions += ["rendering", "searching"]

# Notebooks are shown as they were stored. A board's picture gives place to the board as it was
# recorded; rendering.py reads the record, which myst_nb does not know.
suppress_warnings = ["mystnb.unknown_mime_type"]
nb_execution_mode = "off"
nb_ipywidgets_js = {}
nb_mime_priority_overrides = [("html", "application/vnd.jupyter.widget-view+json", None)]
nb_merge_streams = True
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 3

autodoc_default_options = {"members": True, "member-order": "bysource"}
autodoc_preserve_defaults = True
python_maximum_signature_line_length = 80
toc_object_entries_show_parents = "hide"
add_module_names = False

templates_path = ["templates"]
html_additional_pages = {"index": "front.html"}
html_theme = "furo"
html_title = "kinoedu"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_favicon = "static/favicon.svg"
html_math_renderer = "mathml"
html_copy_source = html_show_copyright = False
# a browser that reads from a disk may not fetch pages to quote from
html_show_search_summary = False
html_search_scorer = str(HERE / "search.js")
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#0072B2", "color-brand-content": "#005A8C"},
    "dark_css_variables": {"color-brand-primary": "#6CB4E2", "color-brand-content": "#6CB4E2"},
}
# each colour with a contrast of 4.5 to 1 at least
pygments_style, pygments_dark_style = "a11y-light", "github-dark"

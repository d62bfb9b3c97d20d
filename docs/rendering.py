"""What the site adds to Sphinx: docstrings as they are written here, links to the source, pictures
that say what they are.
"""

import ast
import html
import importlib.util
import inspect
import json
import re
import shutil
import textwrap
from pathlib import Path, PurePosixPath

from docutils import nodes
from sphinx import addnodes

from kinoedu.boards.core.page_script import CORE, page_script
from kinoedu.boards.core.recorded import RECORD, unpack_records
from kinoedu.browser.bodies import describe_bodies
from kinoedu.browser.wasm import write_scripts
from kinoedu.course.release import exercises_without_solution
from kinoedu.messages import get_message

CODE_OR_MARKUP = re.compile(r"`[^`]+`|[*_|\\]")
HEADING = re.compile(r"(\w+)\n-+\n")
ENTRY = re.compile(r"(?m)^(\S.*)((?:\n +.*)*)")
NAMED = re.compile(r"(?m)^(\w[\w\\, ()]*) : (.*)")
FIGURE = re.compile(r"<Figure size (\d+)")
# in pixels; what is wider cannot be read in the width of a telephone, and is scrolled there
WIDE = 640
BOARD = "application/vnd.jupyter.widget-view+json"
BEGIN_RECORD = '<div class="kinoedu-record">'
NAME = re.compile(r"ke\.([\w.]+)(?:\(.*\))?$")


def setup(app):
    """Called by Sphinx."""
    app.connect("config-inited", leave_out_drafts)
    app.connect("source-read", add_contents)
    app.connect("autodoc-process-docstring", mark_up)
    app.connect("autodoc-process-signature", as_written)
    app.connect("autodoc-skip-member", is_field)
    app.connect("doctree-read", describe_pictures)
    app.connect("builder-inited", write_boards)
    # before Sphinx copies what is linked
    app.connect("doctree-read", lead_to_sources, priority=400)
    app.connect("html-page-context", add_front_board)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def leave_out_drafts(app, config):
    """No page shows a copy of an exercise in which somebody wrote answers; the kit has none."""
    for draft in exercises_without_solution(Path(app.srcdir)):
        file = draft.relative_to(app.srcdir).as_posix()
        config.exclude_patterns.append(file)
        print(f"left out {file}: no solution makes it")


def add_contents(app, docname, source):
    """The entrance is README.md; what GitHub need not show, the order of all pages, is kept
    beside.
    """
    if docname == app.config.root_doc:
        source[0] += Path(app.confdir, "contents.md").read_text(encoding="utf-8")


def add_front_board(app, page, template, context, doctree):
    """The front page has the first board of the tour that answers."""
    if page == "index":
        tour = json.loads(Path(app.srcdir, "notebooks/00_tour.ipynb").read_text(encoding="utf-8"))
        outputs = [output for cell in tour["cells"] for output in cell.get("outputs", ())]
        stored = [output["data"] for output in outputs if RECORD in output.get("data", {})]
        board = next(data for data in stored if is_live(data[RECORD]))
        text, picture = html.escape("".join(board["text/plain"])), board["image/png"].strip()
        image = f'<img alt="{text}" src="data:image/png;base64,{picture}">'
        still = f'<p class="still">{get_message("site.still")}</p>'
        context["board"] = f"{BEGIN_RECORD}{image}{still}{script_of(board[RECORD])}</div>"


def is_live(record):
    """Whether a page can answer what a notebook stored."""
    return any("live" in board for board in unpack_records(record))


def mark_up(app, what, name, thing, options, lines):
    """Docstrings are plain text, with examples, `code` and lists of `name : meaning`; make them
    Sphinx's markup.
    """
    lines[:] = "\n\n".join(
        marked(paragraph) for paragraph in "\n".join(lines).split("\n\n")
    ).splitlines()


def marked(paragraph):
    """A paragraph as reStructuredText."""
    if heading := HEADING.match(paragraph):
        rest = paragraph[heading.end() :]
        rest = ENTRY.sub(as_item, rest) if heading[1] == "Raises" else rest
        return marked(rest) if heading[1] == "Parameters" else f"**{heading[1]}**\n\n{marked(rest)}"
    if paragraph.startswith(">>>"):
        return paragraph
    if paragraph.startswith(" "):
        return f"::\n\n{paragraph}"
    text = CODE_OR_MARKUP.sub(
        lambda found: f"`{found[0]}`" if found[0][0] == "`" else f"\\{found[0]}", paragraph
    )
    if all(line.startswith(" ") or NAMED.match(line) for line in text.splitlines()):
        return NAMED.sub(r"**\1**\n    \2", text)
    return text


def as_item(entry):
    """An error and when it is raised, as an item of a list."""
    name, when = entry[1], " ".join(entry[2].split())
    return f"- {name}: {when}" if when else f"- {name}"


def as_written(app, what, name, thing, options, arguments, returned):
    """A signature as it stands in the source, where types have their short names."""
    if arguments is None:
        return None
    definition = ast.parse(textwrap.dedent(inspect.getsource(thing))).body[0]
    if isinstance(definition, ast.ClassDef):
        fields = [
            part
            for part in definition.body
            if isinstance(part, ast.AnnAssign) and "ClassVar" not in ast.unparse(part)
        ]
        makes = {"__init__", "__new__"}
        definition = next(
            (part for part in definition.body if getattr(part, "name", "") in makes), None
        )
        if definition is None:
            return f"({', '.join(map(ast.unparse, fields))})" if fields else "", None
    taken = definition.args.args
    definition.args.args = taken[1:] if taken and taken[0].arg in ("self", "cls") else taken
    gives = definition.returns if what != "class" else None
    return f"({ast.unparse(definition.args)})", ast.unparse(gives) if gives else None


def is_field(app, what, name, thing, skip, options):
    """Fields of records are described in the record's docstring."""
    return True if type(thing).__name__ == "_tuplegetter" else None


def lead_to_sources(app, doctree):
    """Links to Python files lead to the page with their text, and `ke.rrt` to its place in the
    reference.
    """
    page = app.env.docname
    for link in list(doctree.findall(addnodes.download_reference)):
        file = PurePosixPath(app.env.relfn2path(link["reftarget"], page)[0])
        if file.suffix == ".py":
            uri = "../" * page.count("/") + f"_modules/{file.with_suffix('.html')}"
            link.replace_self(nodes.reference("", "", *link.children, refuri=uri))
    for code in list(doctree.findall(nodes.literal)):
        if named := NAME.match(code.astext()):
            link = addnodes.pending_xref(
                "", refdomain="py", reftype="obj", reftarget=named[1], refspecific=True, refdoc=page
            )
            code.replace_self(link)
            link += code


def write_boards(app):
    """The script and the style of recorded boards, among the site's own files."""
    folder = Path(app.outdir, ".boards")
    folder.mkdir(parents=True, exist_ok=True)
    script = page_script(write_live(folder / "live"))
    (folder / "boards.js").write_text(script, encoding="utf-8")
    shutil.copy(CORE / "board.css", folder / "board.css")
    app.config.html_static_path.append(str(folder))
    app.add_js_file("boards.js", loading_method="defer")
    app.add_css_file("board.css")


def write_live(folder):
    """Write the planners as WebAssembly, and return what the page needs to know of them.

    Where the compiler for it is not installed there are none, and boards are only played.
    """
    if importlib.util.find_spec("ziglang") is None:
        print("ziglang is not installed, so the boards of this site play but do not answer")
        return None
    write_scripts(folder)
    return describe_bodies()


def describe_pictures(app, doctree):
    """A picture of a notebook says in words what it shows, and if it is wide; one of a board, that
    the board is elsewhere.
    """
    records, widths = iter(records_of(app, doctree)), iter(widths_of(app))
    for output in list(doctree.findall(nodes.container)):
        if output.get("nb_element") == "mime_bundle":
            kinds = {kind["mime_type"]: kind for kind in output.children}
            for image in output.findall(nodes.image):
                text, width = kinds["text/plain"].astext(), next(widths)
                if width is not None:
                    image["width"] = f"{width}px"
                figure = FIGURE.match(text)
                image["alt"] = (
                    get_message("site.figure", section=section_of(output)) if figure else text
                )
                image["classes"] += ["wide"] if figure and int(figure[1]) > WIDE else []
            if BOARD in kinds:
                kinds["image/png"] += nodes.paragraph(
                    "", get_message("site.still"), classes=["still"]
                )
                add_record(kinds["image/png"], next(records))


def records_of(app, doctree):
    """What a notebook stored of each of its boards, in order; None for one with only a picture."""
    file = Path(app.env.doc2path(app.env.docname))
    if file.suffix != ".ipynb":
        return []
    book = json.loads(file.read_text(encoding="utf-8"))
    outputs = [output for cell in book["cells"] for output in cell.get("outputs", ())]
    stored = [output.get("data", {}) for output in outputs]
    return [data.get(RECORD) for data in stored if BOARD in data]


def widths_of(app):
    """The widths at which a notebook's pictures are to be shown, in order; None where it has all
    its pixels.
    """
    file = Path(app.env.doc2path(app.env.docname))
    if file.suffix != ".ipynb":
        return []
    book = json.loads(file.read_text(encoding="utf-8"))
    outputs = [output for cell in book["cells"] for output in cell.get("outputs", ())]
    pictures = [output for output in outputs if "image/png" in output.get("data", {})]
    return [one.get("metadata", {}).get("image/png", {}).get("width") for one in pictures]


def add_record(picture, record):
    """Put what was stored of a board beside its picture, for the page's script."""
    if record is not None:
        picture.insert(0, nodes.raw("", BEGIN_RECORD, format="html"))
        picture += nodes.raw("", f"{script_of(record)}</div>", format="html")


def script_of(record):
    """What was stored of a board, in a page."""
    return f'<script type="application/json">{json.dumps(record)}</script>'


def section_of(node):
    """The title of the section that a node is in."""
    while not isinstance(node, nodes.section):
        node = node.parent
    return node.next_node(nodes.title).astext()

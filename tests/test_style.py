"""One look: the colours of figures and boards, and pictures that are sharp and have no default."""

import ast
import base64
import io
import json
import re
from itertools import combinations
from pathlib import Path

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib import pyplot as plt
from matplotlib.colors import to_hex, to_rgb
from PIL import Image

import kinoedu as ke
from kinoedu import figures
from kinoedu.boards import bug_board, search_board
from kinoedu.boards.planning.plans import make_problem_scene
from kinoedu.figures import palette, style
from kinoedu.figures.drawing import ENDS

ROOT = Path(ke.__file__).parent.parent
BOOKS = sorted((ROOT / "notebooks").rglob("*.ipynb")) + sorted((ROOT / "exercises").glob("*.ipynb"))
DEFAULT = {to_hex(c) for c in mpl.rcParamsDefault["axes.prop_cycle"].by_key()["color"]}
GREY = "#7f7f7f"  # one of the defaults, and the rim of black letters
BOX = [(1, -1), (2, -1), (2, 2), (1, 2)]
ROOM = [(0, 0), (10, 0), (10, 10), (0, 10)]
YARD = ke.Problem(
    ke.Point(), ke.PolygonWorld(ROOM, [[(4, 0), (6, 0), (6, 8), (4, 8)]]), (1, 1), (9, 1)
)
DRAWS = {"plot", "scatter", "bar", "barh", "hist", "fill_between", "fill", "step", "loglog"}
DRAWS |= {"semilogx", "semilogy", "axhline", "axvline", "hlines", "vlines", "errorbar", "stem"}
COLOURED = {"color", "c", "colors", "facecolor", "facecolors", "edgecolor", "alpha"}
LINES = ("start", "goal", "tree", "goal_tree", "hit", "clear", "true", "yours", "ink", "contact")


def luminance(colour):
    """The relative luminance of WCAG 2."""
    parts = np.array(to_rgb(colour))
    linear = np.where(parts <= 0.03928, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)
    return float(linear @ (0.2126, 0.7152, 0.0722))


def contrast(one, other):
    """The contrast of WCAG 2, from 1 to 21."""
    dark, light = sorted((luminance(one), luminance(other)))
    return (light + 0.05) / (dark + 0.05)


def source_cells(book):
    """The code of a notebook, cell by cell."""
    for cell in json.loads(book.read_text(encoding="utf-8"))["cells"]:
        if cell["cell_type"] == "code" and not "".join(cell["source"]).lstrip().startswith("%"):
            yield cell["id"], "".join(cell["source"])


def uncoloured(source):
    """The calls that draw without saying in which colour."""
    return [
        ast.unparse(call)
        for call in ast.walk(ast.parse(source))
        if isinstance(call, ast.Call)
        and isinstance(call.func, ast.Attribute)
        and call.func.attr in DRAWS
        and not any(key.arg is None or key.arg in COLOURED for key in call.keywords)
    ]


def test_every_line_of_the_library_has_a_colour_of_the_course():
    """The colours stand in one file, and nothing is drawn without one."""
    files = [*(ROOT / "kinoedu" / "figures").glob("*.py")]
    files += [*(ROOT / "kinoedu" / "boards").rglob("*.py")]
    files += [*(ROOT / "kinoedu" / "course" / "lessons").rglob("*.py")]
    for file in files:
        text = file.read_text(encoding="utf-8")
        assert uncoloured(text) == [], file
        if file.name != "palette.py":
            assert re.findall(r"#[0-9A-Fa-f]{6}\b|[\"']C\d[\"']|tab:", text) == [], file


@pytest.mark.parametrize("book", BOOKS, ids=lambda book: book.stem)
def test_no_picture_of_a_notebook_has_a_default_colour(book):
    """Neither does its code leave a colour to matplotlib, nor do its stored pictures show one."""
    for name, source in source_cells(book):
        assert uncoloured(source) == [], name
        known = {colour.upper() for colour in palette.NAMED.values()}
        known |= {*palette.METHODS, palette.GRID["color"]}
        assert {c.upper() for c in re.findall(r"#[0-9A-Fa-f]{6}\b", source)} <= known, name
    for cell in json.loads(book.read_text(encoding="utf-8"))["cells"]:
        for output in cell.get("outputs", ()):
            data = output.get("data", {}).get("image/png")
            if data is not None:
                assert default_colours(base64.b64decode(data)) == set(), cell["id"]


def default_colours(data):
    """The default colours that a picture shows on a few pixels or more."""
    picture = Image.open(io.BytesIO(data)).convert("RGB")
    red, green, blue = np.moveaxis(np.asarray(picture, np.int32), 2, 0)
    numbers = (red << 16) | (green << 8) | blue
    return {c for c in DEFAULT - {GREY} if (numbers == int(c[1:], 16)).sum() > 20}


def test_a_default_colour_would_be_found():
    _, ax = plt.subplots(dpi=72)
    ax.plot([0, 1], [0, 1], linewidth=3, color="C1")
    stream = io.BytesIO()
    ax.figure.savefig(stream)
    assert default_colours(stream.getvalue()) == {"#ff7f0e"}
    assert uncoloured("ax.plot(x, y, '-o')") and not uncoloured("ax.plot(x, y, color=palette.TREE)")


@pytest.mark.parametrize(
    "draw",
    [
        lambda: figures.draw_plan(ke.rrt(YARD, step_size=1, rng=0)),
        lambda: figures.draw_plan(ke.rrt_connect(YARD, step_size=1, rng=0)),
        lambda: figures.draw_plan(ke.prm(YARD, n=40, rng=0)),
        lambda: figures.draw_plan(ke.planners.bug1((0, 0), (4, 0), [BOX], 0.1)),
        lambda: figures.draw_samples(ke.sampling.halton(20)),
        lambda: figures.draw_decomposition(ke.decomposition.trapezoidation(YARD.world)),
        lambda: figures.draw_graph(ke.Graph(nodes=[(0, 0), (1, 0), (0, 1)], edges=[(0, 1)])),
        figures.draw_rrt_flowchart,
        figures.draw_bug_base_flowchart,
    ],
)
def test_artists_have_the_colours_and_sizes_of_the_course(draw):
    """Lines and markers are of the palette, and no text is smaller than twelve points."""
    plt.close("all")
    draw()
    own = {to_rgb(c) for c in [*palette.NAMED.values(), *palette.METHODS, palette.GRID["color"]]}
    for ax in plt.gcf().axes:
        for line in ax.lines:
            assert to_rgb(line.get_color()) in {*own, to_rgb("white")}
        for text in [*ax.texts, ax.title, ax.xaxis.label, ax.yaxis.label]:
            assert not text.get_text() or text.get_fontsize() >= 12


def test_the_goal_has_a_colour_of_its_own():
    """Neither a method nor another role has it, on light or dark pages."""
    for theme in palette.THEMES.values():
        others = {name: colour for name, colour in theme.items() if name != "goal"}
        assert theme["goal"] not in [*palette.METHODS, *palette.LINKS, *others.values()]
    apart = [np.linalg.norm(np.subtract(to_rgb(palette.GOAL), to_rgb(m))) for m in palette.METHODS]
    assert min(apart) > 0.25


def test_start_and_goal_look_the_same_in_figures_and_on_boards():
    markers = {"o": "dot", "*": "star"}
    looks = [(name, colour, markers[marker]) for name, colour, marker, _ in ENDS]
    bugs = bug_board((0, 0), (4, 0), [BOX])
    grid = search_board(np.ones((3, 3), bool))
    for scene in (make_problem_scene(YARD), bugs.canvas.scene, grid.canvas.scene):
        shown = [(h["name"], palette.NAMED[h["colour"]], h["marker"]) for h in scene["handles"][:2]]
        assert shown == looks


@pytest.mark.parametrize("theme", palette.THEMES)
def test_lines_and_names_stand_out(theme):
    """Three to one for lines on free ground, and 4.5 to one for the names of start and goal."""
    colours = palette.THEMES[theme]
    for name in LINES:
        assert contrast(colours[name], colours["free"]) >= 3.0, name
    for name in ("start", "goal", "ink"):
        assert contrast(colours[name], colours["free"]) >= 4.5, name
    assert contrast(colours["obstacle"], colours["free"]) >= 3.0
    for one, other in combinations(("start", "goal", "hit", "tree"), 2):
        assert colours[one] != colours[other]


def test_a_dark_page_changes_only_named_colours():
    assert set(palette.DARK) < set(palette.NAMED)


def test_pictures_are_sharp_small_and_keep_their_colours():
    """A picture has two pixels for one that is shown; its frequent colours are kept exactly."""
    figure, ax = plt.subplots(figsize=(4, 3), dpi=72)
    ax.plot([0, 1], [0, 1], linewidth=4, color=palette.GOAL)
    ax.set_title("A line\nto the goal")
    data, shown = style.print_sharp(figure)
    assert shown["alt"] == "A line to the goal"
    picture = Image.open(io.BytesIO(base64.b64decode(data)))
    assert picture.width // 2 == shown["width"] and abs(shown["width"] - 4 * 72) < 40
    assert picture.mode == "P" and len(data) < 20_000
    colours = {to_hex(np.array(level) / 255.0) for _, level in picture.convert("RGB").getcolors()}
    assert palette.GOAL.lower() in colours and "#ffffff" in colours


@pytest.mark.parametrize("book", BOOKS, ids=lambda book: book.stem)
def test_stored_pictures_have_twice_the_pixels_of_their_page(book):
    """Figures and boards, in notebooks of less than a megabyte."""
    assert book.stat().st_size < 1_000_000
    for cell in json.loads(book.read_text(encoding="utf-8"))["cells"]:
        for output in cell.get("outputs", []):
            if "image/png" in output.get("data", {}):
                picture = Image.open(io.BytesIO(base64.b64decode(output["data"]["image/png"])))
                size = output["metadata"]["image/png"]
                assert picture.width >= 2 * size["width"], cell["id"]


def test_a_picture_with_many_colours_keeps_them():
    levels = np.random.default_rng(0).integers(0, 255, (300, 300, 3), np.uint8)
    assert style.keep_few_colours(Image.fromarray(levels)).mode == "RGB"


def test_a_part_in_rare_shades_keeps_its_colour():
    """Each of its shades is rarer than those of the rest; black would be nearest of those."""
    x, y = np.meshgrid(np.arange(400), np.arange(400))
    levels = np.stack([0 * x, x // 8, 16 + (x + y) // 8], axis=2).astype(np.uint8)
    levels[:40, :40] = np.stack([200 + 0 * x, x, y], axis=2)[:40, :40]
    kept = np.asarray(style.keep_few_colours(Image.fromarray(levels)).convert("RGB"), int)
    assert np.abs(kept - levels).max() < 40


def test_a_script_keeps_its_own_style():
    """Outside a notebook nothing is changed."""
    style.apply_style()
    assert mpl.rcParams["font.size"] == mpl.rcParamsDefault["font.size"]


def test_an_empty_figure_has_no_picture():
    assert style.print_sharp(plt.figure()) is None


@pytest.mark.parametrize("steps", [(1,), (3, 4), (1, 2, 3)])
def test_an_odd_number_of_steps_leaves_no_empty_frame(steps):
    """Two are in a row."""
    problem = ke.Problem(ke.Point(), ke.PolygonWorld([(0, 0), (9, 0), (9, 6)]), (2, 1), (8, 5))
    tree = ke.rrt(problem, max_nodes=9, rng=0).tree
    figures.draw_rrt_steps(problem, tree, np.array([6.0, 2.0]), 1.0, steps=steps)
    assert [ax.get_visible() for ax in plt.gcf().axes].count(True) == len(steps)
    plt.close("all")

"""The board of solids in a real JupyterLab, by mouse and by keys, without requests elsewhere."""

import pytest

from kinoedu.figures import palette

BOARD = """
import kinoedu as ke
robot, obstacle = [(-1, -0.5), (2, -0.5), (2, 0.5), (-1, 0.5)], [(3, 3), (6, 3), (6, 5), (3, 5)]
board = ke.boards.turning_board(robot, obstacle, place=(1.5, 4))
board
"""


@pytest.fixture(scope="module")
def page(run_in_lab):
    """One notebook with one board."""
    with run_in_lab(BOARD) as page:
        page.wait_for_selector(".kinoedu-solid[data-paints]")
        yield page


def shown_text(page):
    return page.locator(".kinoedu-solid-text").inner_text()


def data(page, name):
    return page.locator(".kinoedu-solid").get_attribute(f"data-{name}")


def drag(page, canvas, dx, dy):
    """Drag from the middle of a canvas, and wait for the next paint."""
    box = page.locator(canvas).bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + dx, y + dy, steps=5)
    page.mouse.up()
    painted(page)


def painted(page):
    """Wait for the next paint."""
    page.evaluate(
        "() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))"
    )


def test_a_solid_is_turned_and_brought_nearer(page):
    """By dragging and by keys; the text does not change, the picture does."""
    solid, words, azimuth = (
        page.locator(".kinoedu-solid-mesh"),
        shown_text(page),
        data(page, "azimuth"),
    )
    before = solid.screenshot()
    drag(page, ".kinoedu-solid-mesh", 80, 30)
    assert (
        data(page, "azimuth") != azimuth
        and solid.screenshot() != before
        and shown_text(page) == words
    )
    solid.focus()
    for key in ("ArrowLeft", "ArrowUp", "+"):
        paints = int(data(page, "paints"))
        page.keyboard.press(key)
        page.wait_for_function(
            "n => document.querySelector('.kinoedu-solid').dataset.paints > n", arg=paints
        )
    assert float(data(page, "zoom")) > 1 and "cut at θ = 0 degrees" in solid.get_attribute(
        "aria-label"
    )


def test_the_plane_and_the_robot_are_answered(page):
    """The slider moves the cut on both sides; the robot moves by dragging and by keys."""
    assert "touches" in shown_text(page)
    slice_ = page.locator(".kinoedu-solid-slice")
    before = slice_.screenshot()
    page.locator(".kinoedu-solid-slider").evaluate(
        "s => { s.value = Math.PI / 2; s.dispatchEvent(new Event('input')); }"
    )
    page.wait_for_function(
        "() => document.querySelector('.kinoedu-solid-text').textContent.includes('90°: the robot "
        "is free')"
    )
    assert slice_.screenshot() != before
    drag(page, ".kinoedu-solid-slice", 90, 0)
    page.wait_for_function(
        "() => document.querySelector('.kinoedu-solid-text').textContent.includes('touches')"
    )
    words = shown_text(page)
    slice_.focus()
    page.keyboard.press("ArrowDown")
    page.wait_for_function(
        "w => document.querySelector('.kinoedu-solid-text').textContent !== w", arg=words
    )


def test_a_page_that_turns_dark_takes_the_solid_along(page):
    """Ground, cut and text have the colours of dark pages, and come back."""
    slice_ = page.locator(".kinoedu-solid-slice")
    before = slice_.screenshot()
    for light, theme in (("false", "dark"), ("true", "light")):
        page.evaluate("light => { document.body.dataset.jpThemeLight = light; }", light)
        page.wait_for_function(
            "theme => document.querySelector('.kinoedu-solid').dataset.theme === theme", arg=theme
        )
        red, green, blue = (int(palette.THEMES[theme]["free"][k : k + 2], 16) for k in (1, 3, 5))
        ground = slice_.evaluate("canvas => getComputedStyle(canvas).backgroundColor")
        assert ground == f"rgb({red}, {green}, {blue})"
        painted(page)
        assert (slice_.screenshot() == before) == (theme == "light")

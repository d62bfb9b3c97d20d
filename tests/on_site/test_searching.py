"""The site's search: what a student finds first, and what is marked on the page."""

import pytest


@pytest.fixture(scope="module")
def search(chromium, site):
    """A function from a query to the addresses found, and the page on which it searches."""
    page, errors = chromium.new_page(), []
    page.on("pageerror", lambda error: errors.append(str(error)))

    def find(query):
        page.goto(f"{site.as_uri()}/README.html")
        page.locator("input[name=q]").first.fill(query)
        page.locator("input[name=q]").first.press("Enter")
        page.wait_for_function("/finished|did not/.test(document.body.textContent)")
        links = page.locator("#search-results a")
        return [link.get_attribute("href") for link in links.all()]

    yield find, page
    page.close()
    assert errors == []


@pytest.mark.parametrize(
    ("query", "first"),
    [
        ("A*", "docs/algorithms.html#word-dijkstra-a"),
        ("C-space", "docs/glossary.html#word-configuration-space-c-space"),
        ("Collision", "docs/glossary.html#word-contact-collision"),
        ("heuristic", "notebooks/04_graph_search.html"),
    ],
)
def test_a_word_of_the_field_leads_to_its_place(search, query, first):
    """The row of a table, or a lesson before a page for contributors."""
    find, page = search
    assert find(query)[0] == first
    page.goto(page.url.rpartition("/")[0] + "/" + first)
    assert page.evaluate("!location.hash || !!document.getElementById(location.hash.slice(1))")


def test_a_star_is_part_of_a_name(search):
    """The function of RRT* comes before that of RRT."""
    find, _ = search
    named = [link for link in find("RRT*") if "#kinoedu" in link]
    assert named[0].endswith("#kinoedu.planners.rrt_star")


def test_odd_queries_find_nothing_at_all(search):
    """A letter is in every name, and tags are no words."""
    find, _ = search
    for query in ("<b>", "'", "x" * 300, "größe", "<img src=x onerror=alert(1)>"):
        assert find(query) == [], query


def test_words_that_were_searched_are_marked_in_the_page(search):
    """Also those that the theme's icons have in their names, such as expand."""
    find, page = search
    find("expand")
    page.goto(page.url.rpartition("/")[0] + "/notebooks/04_graph_search.html")
    page.wait_for_function("document.querySelectorAll('article .highlighted').length > 3")

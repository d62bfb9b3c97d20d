"""What the site's search finds first: the words of the glossary, and the algorithms by name."""

from docutils import nodes
from sphinx import addnodes
from sphinx.transforms import SphinxTransform

TABLES = ("docs/glossary", "docs/algorithms")  # the first column of their tables has the words


def setup(app):
    """Called by Sphinx."""
    app.add_transform(IndexWords)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


class IndexWords(SphinxTransform):
    """Each row can be linked to, and its words are in the index, which the search looks up."""

    default_priority = 700  # before Sphinx collects the index, at 850

    def apply(self, **given):
        """Called by Sphinx for each page."""
        if self.env.docname not in TABLES:
            return
        for body in list(self.document.findall(nodes.tbody)):
            entries = []
            for row in body:
                words = row[0].astext()
                place = nodes.make_id(f"word {words}")
                row["ids"].append(place)
                entries += [("single", word, place, "main", None) for word in words.split(", ")]
            table = body.parent.parent
            table.parent.insert(table.parent.index(table), addnodes.index(entries=entries))

"""The cells of a lesson that its boards need, so that a browser test does not run the others."""

import ast


def keep_what_boards_need(book, boards):
    """The notebook, in which other code cells do nothing; the numbers of its cells stay.

    Parameters
    ----------
    boards : the numbers of the cells that show boards.
    """
    needed, kept = set(), set(boards)
    for number in range(len(book["cells"]) - 1, -1, -1):
        cell = book["cells"][number]
        if cell["cell_type"] != "code":
            continue
        made, used = names_in("".join(cell["source"]))
        if number in kept or made & needed:
            kept.add(number)
            needed |= used
    for number, cell in enumerate(book["cells"]):
        if cell["cell_type"] == "code" and number not in kept:
            cell["source"] = "pass"
    return book


def names_in(source):
    """The names that a cell defines or changes, and those that it uses."""
    made, used = set(), set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Name):
            (used if isinstance(node.ctx, ast.Load) else made).add(node.id)
        elif isinstance(node, ast.FunctionDef | ast.ClassDef):
            made.add(node.name)
        elif isinstance(node, ast.Import | ast.ImportFrom):
            made |= {(one.asname or one.name).partition(".")[0] for one in node.names}
    return made, used

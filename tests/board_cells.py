"""The cells of a lesson that its boards need, so that a browser test does not run the others."""

import symtable


def keep_what_boards_need(book, boards):
    """The notebook, in which other code cells do nothing; the numbers of its cells stay.

    Parameters
    ----------
    boards : the numbers of the cells that show boards.
    """
    needed = set()
    for number in range(len(book["cells"]) - 1, -1, -1):
        cell = book["cells"][number]
        if cell["cell_type"] != "code":
            continue
        made, used = global_names("".join(cell["source"]))
        if number in boards or made & needed:
            needed = needed - made | used
        else:
            cell["source"] = "pass"
    return book


def global_names(source):
    """The global names that a cell defines, and those that it uses; others are local there."""
    cell = symtable.symtable(source, "a cell", "exec")
    made = {one.get_name() for one in cell.get_symbols() if one.is_assigned() or one.is_imported()}
    used = {one.get_name() for one in cell.get_symbols() if one.is_referenced()}
    scopes = cell.get_children()
    for scope in scopes:  # grows while it is read
        used |= {
            one.get_name() for one in scope.get_symbols() if one.is_global() and one.is_referenced()
        }
        scopes += scope.get_children()
    return made, used

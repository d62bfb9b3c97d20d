"""Cut a text cell into blocks, and make HTML of a block."""

import re
from html import unescape
from typing import NamedTuple

from .formulas import to_mathml

HEADING = re.compile(r'<h1[^>]*>(.*?)(?:<a class="anchor-link".*)?</h1>', re.DOTALL)
ITEM = re.compile(r"(\d+\.|[-*]) ")
ABBREVIATED = re.compile(r"(\b[A-Z]|e\.g|i\.e|\bFig|^\d+)\.$")
SHORT = 32  # words of a paragraph that is shown whole
SENTENCE = re.compile(r"(?<=[.?!])(?:\*\*|\*)?\s+")
LABEL = re.compile(r"\*\*[^*?]+\*\*")  # such as "Line by line."
FORMULA = re.compile(r"\$\$(.+?)\$\$|(?<![\\$])\$([^$]+?)\$", re.DOTALL)
LESSON_LINK = re.compile(r'<a href="(\d\d_\w+)\.ipynb">')
OTHER_LINK = re.compile(r'<a href="(?!https?:|\d\d_\w+\.html)[^"]*">(.*?)</a>', re.DOTALL)


class Block(NamedTuple):
    """A block of a text cell: its kind, and its Markdown."""

    kind: str  # heading, prose, predict, list, table, formula, theorem, proof
    text: str


def cut_into_blocks(source: str) -> list[Block]:
    """The blocks of a text cell, in order.

    >>> [block.kind for block in cut_into_blocks("## A\\n\\nIt is so.\\n\\n1. one\\n2. two")]
    ['heading', 'prose', 'list']
    """
    parts, open_text = [], ""
    for part in re.split(r"\n\s*\n", source.strip()):
        open_text = f"{open_text}\n\n{part}" if open_text else part
        if open_text.count("```") % 2 == 0 and open_text.count("$$") % 2 == 0:
            parts.append(open_text)
            open_text = ""
    parts += [open_text] if open_text else []
    return [block for part in parts for block in cut_part(part)]


def cut_part(part: str) -> list[Block]:
    """The blocks of a part without empty lines.

    Lines before a list belong to it. What follows a theorem in a quotation is its proof.
    """
    lines = part.splitlines()
    first = lines[0]
    if first.startswith("#"):
        rest = "\n".join(lines[1:])
        return [Block("heading", first.lstrip("# ")), *(cut_part(rest) if rest else [])]
    if first.startswith(">"):
        statement, proof, rest = part.partition("\n>\n")
        return [Block("theorem", statement), *([Block("proof", unquoted(rest))] if proof else [])]
    if first.startswith("|"):
        return [Block("table", part)]
    if first.startswith("$$"):
        return [Block("formula", part)]
    if "**Predict" in part:
        before, _, rest = part.partition("**Predict")
        prose = [Block("prose", before.strip())] if before.strip() else []
        return [*prose, Block("predict", f"**Predict{rest}")]
    at = next((i for i, line in enumerate(lines) if ITEM.match(line)), None)
    if at is None or first.startswith("```"):
        return [Block("prose", part)]
    return [Block("list", "\n".join([*lines[:at], "", *lines[at:]]).strip())]


def unquoted(text: str) -> str:
    """A quotation without its marks."""
    return re.sub(r"(?m)^> ?", "", text)


def cut_into_sentences(text: str) -> list[str]:
    """The sentences of a paragraph; formulas, code and bold words are not cut.

    >>> cut_into_sentences("A **line** is a set. It has no ends.")
    ['A **line** is a set.', 'It has no ends.']
    >>> cut_into_sentences("See **1. that** one, $a. b$.")
    ['See **1. that** one, $a. b$.']
    """
    sentences, begin = [], 0
    for gap in SENTENCE.finditer(text):
        head = text[begin : gap.end()].strip()
        whole = all(head.count(mark) % 2 == 0 for mark in ("$", "**", "`"))
        if whole and not ABBREVIATED.search(head):
            sentences.append(head)
            begin = gap.end()
    return [*sentences, text[begin:].strip()] if text[begin:].strip() else sentences


def shorten(text: str) -> str:
    """What a slide shows of a paragraph: all of a short one; of a long one the first sentence,
    questions, and what is in bold. A first sentence in bold is a label of the second.

    >>> shorten("It is so. " + "It is long. " * 20 + "**Why?**")
    'It is so. **Why?**'
    >>> shorten("**Line by line.** It is so. " + "It is long. " * 20)
    '**Line by line.** It is so.'
    """
    if len(text.split()) <= SHORT:
        return text
    first, *rest = cut_into_sentences(text)
    if rest and LABEL.fullmatch(first):
        first += f" {rest.pop(0)}"
    kept = [one for one in rest if "**" in one or one.rstrip("*").endswith("?")]
    return " ".join([first, *kept])


def to_html(text: str) -> str:
    """Markdown as HTML, with formulas as MathML, and links to other lessons' slides."""
    from nbconvert.filters import markdown2html

    page: str = markdown2html(text)
    page = FORMULA.sub(formula_html, page)
    page = LESSON_LINK.sub(r'<a href="\1.html">', page)
    return OTHER_LINK.sub(r"\1", page)


def title_html(text: str) -> str:
    """The text of a heading as HTML; a number at its beginning does not make it a list.

    >>> title_html("3. A *segment* ends")
    '3. A <em>segment</em> ends'
    """
    found = HEADING.search(to_html(f"# {text}"))
    return found[1] if found else text


def formula_html(found: re.Match[str]) -> str:
    """The formula that was found, as MathML."""
    block, inline = found[1], found[2]
    if block:
        return f'<div class="formula">{to_mathml(unescape(block), "block")}</div>'
    return to_mathml(unescape(inline), "inline")

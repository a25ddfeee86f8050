"""The Markdown page about the name or the keyword under the pointer."""

from __future__ import annotations

from dataclasses import dataclass

from motionlang.commands.channels import channels_of
from motionlang.commands.help.view import SIGNS, markdown
from motionlang.kernel import ProgramError
from motionlang.kernel.lang import Definition, Span
from motionlang_lsp.editor.page import Page

# The most lines of a comment above a declaration that belong to it.
_MAX_COMMENT = 20
# How often a name is used, where there is a word for it.
_OFTEN = {0: "never used", 1: "used once", 2: "used twice"}


@dataclass(eq=False, slots=True)
class Hover:
    """A text in Markdown about a span."""

    markdown: str
    span: Span


def hover(page: Page, offset: int) -> Hover | None:
    """Return the description of the word at an offset, None if there is none."""
    named = page.names.at(offset)
    if named is not None:
        return Hover(definition_page(page, named[0]), named[1])
    word = page.keyword(offset)
    if word is None:
        return None
    row, span = word
    uses = channel_uses(page, span[0]) if row.channel or row.selects else ""
    about = f"{uses}**{row.name}** · {row.kind}\n\n{markdown(row, page.language.name)}"
    return Hover(about, span)


def channel_uses(page: Page, at: int) -> str:
    """Return a paragraph about each channel that the keyword at an offset uses; "" for a text with errors."""
    try:
        channels = channels_of(page.program, page.language)
    except ProgramError:
        return ""
    found = ["; ".join(each.sentences()).translate(SIGNS) for each in channels if at in each.names_at]
    return "".join(f"{each}\n\n" for each in found)


def definition_page(page: Page, definition: Definition) -> str:
    """Return declaration, comment, type, value and number of uses of a name."""
    written = definition.text
    if definition.kind == "macro" and definition.span is not None:
        start, end = page.line_of(definition.span[0])
        written = page.text[start:end].strip()
    lines = [f"```{page.language.name}", written or definition.name, "```"]
    comment = _comment_above(page, definition)
    if comment:
        lines += ["", comment]
    about = [definition.kind + (f" of {definition.home}" if definition.home else "")]
    if definition.kind == "define":
        about.append(f"replaced by `{definition.value}`")
    elif definition.value:
        about.append(f"value `{definition.value}`")
    others = len(definition.uses) - (definition.span is not None)
    about.append(_OFTEN.get(others, f"used {others} times"))
    if definition.span is None and definition.kind == "macro":
        about.append("not defined in this file")
    return "\n".join([*lines, "", " · ".join(about)])


def _comment_above(page: Page, definition: Definition) -> str:
    """Return the comment above a declaration, or at the end of its line."""
    if definition.span is None:
        return ""
    start, end = page.line_of(definition.span[0])
    found = [piece for kind, piece, _ in page.language.tokens(page.text[start:end]) if kind == "comment"]
    while start > 0 and len(found) < _MAX_COMMENT:
        above, stop = page.line_of(start - 1)
        pieces = [
            (kind, piece)
            for kind, piece, _ in page.language.tokens(page.text[above:stop])
            if not piece.isspace()
        ]
        if len(pieces) != 1 or pieces[0][0] != "comment":
            break
        found.insert(0, pieces[0][1])
        start = above
    text = " ".join(each.lstrip("';# \t").strip() for each in found)
    return text.translate(SIGNS)

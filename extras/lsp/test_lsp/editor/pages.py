"""Pages of texts with a mark for the cursor."""

from __future__ import annotations

from motionlang.kernel import Source, dialect
from motionlang_lsp.editor.page import Page


def page(text: str, language: str = "mint") -> Page:
    """Return the page of a text."""
    return Page(Source("a.mnt" if language == "mint" else "a.mcl", text), dialect(language))


def at_cursor(text: str, language: str = "mint") -> tuple[Page, int]:
    """Return the page of a text without its `|`, and the offset of that mark."""
    offset = text.index("|")
    return page(text[:offset] + text[offset + 1 :], language), offset

"""The layout of a Mint program: indentation by blocks, no trailing blanks.

Tokens and comments do not change, so the program keeps its meaning.
"""

from __future__ import annotations

from motionlang_lsp.editor.fixes import SpanEdit
from motionlang_lsp.editor.page import Page


def format(page: Page, indent: str = "  ") -> list[SpanEdit]:
    """Return the edits that format a text; none for a language without blocks."""
    edits = []
    start = 0
    for line, wanted in zip(page.text.split("\n"), formatted_lines(page, indent), strict=True):
        if line != wanted:
            same = 0  # an edit is the part that changes, so that the cursor of an editor stays where it is
            while same < min(len(line), len(wanted)) and line[same] == wanted[same]:
                same += 1
            tail = 0
            while tail < min(len(line), len(wanted)) - same and line[-1 - tail] == wanted[-1 - tail]:
                tail += 1
            edits.append(
                SpanEdit((start + same, start + len(line) - tail), wanted[same : len(wanted) - tail])
            )
        start += len(line) + 1
    return edits


def formatted_lines(page: Page, indent: str) -> list[str]:
    """Return the lines of a text in the layout of its language."""
    lines = page.text.split("\n")
    layout = page.program.layout
    if layout is None:
        return lines
    found, depth = [], 0
    for line, each in zip(lines, layout, strict=True):
        if each.unreadable:
            found.append(line)
        elif each.continues:
            found.append(line.rstrip(" \t"))
        else:
            body = line.strip(" \t")
            found.append(indent * max(0, depth - each.back) + body if body else "")
        depth = max(0, depth + each.change)
    return found

"""Quick fixes of diagnostics.

A fix is a correction, a name that was probably meant, or a comment that silences a warning.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from motionlang.commands.check.rules import RULES
from motionlang.kernel import Diagnostic
from motionlang.kernel.lang import Span
from motionlang_lsp.editor.page import Page

# A comment that silences warnings, with the codes that it has.
_IGNORE = re.compile(r"lint:\s*ignore\b(?:[ \t]+[\w-]+(?:[ \t]*,[ \t]*[\w-]+)*)?", re.IGNORECASE)


@dataclass(eq=False, slots=True)
class SpanEdit:
    """A replacement of the text in a span."""

    span: Span
    text: str


@dataclass(eq=False, slots=True)
class Fix:
    """One change that an editor offers.

    `preferred` is True for the only possible correction, which `check --fix` also makes.
    """

    title: str
    edits: list[SpanEdit]
    preferred: bool


def fixes(page: Page, diagnostic: Diagnostic) -> Iterator[Fix]:
    """Yield the changes that would resolve a diagnostic, the best first."""
    if not diagnostic.line or not diagnostic.column:
        return
    begin = page.offset(diagnostic.line, diagnostic.column)
    span = begin, page.offset(diagnostic.line, diagnostic.column + diagnostic.length)
    if diagnostic.fix:
        written = " ".join(diagnostic.fix.split())
        yield Fix(f"Change to {written}", [SpanEdit(span, diagnostic.fix)], True)
    for each in diagnostic.candidates:
        yield Fix(f"Change to {each}", [SpanEdit(span, each)], False)
    silenced = silencing(page, diagnostic)
    if silenced is not None:
        yield Fix(f"Suppress {diagnostic.code} on this line", [silenced], False)


def silencing(page: Page, diagnostic: Diagnostic) -> SpanEdit | None:
    """Return an edit that adds a comment to silence a warning on its line, or None.

    A line that continues on the next one cannot have a comment.
    """
    rule = RULES.get(diagnostic.code)
    if diagnostic.severity != "warning" or rule is None or page.language.name not in rule.cases:
        return None
    if diagnostic.code == "silenced":
        return None
    start, end = page.line_of(page.offset(diagnostic.line, 1))
    line = page.text[start:end]
    if line.rstrip(" \t").endswith(("\\", " _", "\t_")):
        return None
    comments = [(piece, at) for kind, piece, at in page.language.tokens(line) if kind == "comment"]
    if not comments:
        blank = "" if line.endswith((" ", "\t")) else "  "
        mark = page.language.comment
        return SpanEdit((end, end), f"{blank}{mark} lint: ignore {diagnostic.code}")
    ignored = _IGNORE.search(line, comments[0][1])
    if ignored is not None:
        at = start + ignored.end()
        return SpanEdit((at, at), f", {diagnostic.code}")
    at = start + len(line.rstrip())
    return SpanEdit((at, at), f" lint: ignore {diagnostic.code}")

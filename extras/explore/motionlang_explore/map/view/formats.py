"""The forms of a map by name."""

from __future__ import annotations

from collections.abc import Callable
from io import StringIO

from motionlang.views.figure_files import svg
from motionlang.views.table import Document
from motionlang_explore.map.program_map import ProgramMap
from motionlang_explore.map.view import tables
from motionlang_explore.map.view.graph import mermaid
from motionlang_explore.map.view.page import page
from motionlang_explore.map.view.text import headline, markdown, render
from motionlang_explore.map.view.timing import timing

# The form for each file extension.
SUFFIXES = {
    ".txt": "text",
    ".md": "markdown",
    ".mmd": "mermaid",
    ".json": "json",
    ".csv": "csv",
    ".html": "html",
}


def written(made: ProgramMap, form: str) -> str:
    """Return a map in one of `FORMS`."""
    return _FORMS[form](made)


def _csv(made: ProgramMap) -> str:
    out = StringIO()
    document(made).csv(out)
    return out.getvalue()


def document(made: ProgramMap) -> Document:
    """Return a map as a document of the commands."""
    values = {"program": made.source.name, "dialect": made.language.name, "summary": headline(made)}
    return Document(tables.tables(made), values)


def _timing(made: ProgramMap) -> str:
    """Return the timing diagram of a cycle as SVG, "" if there is none."""
    figure = timing(made)
    return "" if figure is None else svg(figure)


_FORMS: dict[str, Callable[[ProgramMap], str]] = {
    "text": lambda made: render(made, width=80),
    "markdown": markdown,
    "mermaid": lambda made: "\n".join(mermaid(made.behaviour)) + "\n",
    "json": lambda made: document(made).json(),
    "csv": _csv,
    "html": lambda made: page(made, _timing(made)),
}
FORMS = tuple(_FORMS)

"""The text and the syntax tree of a file, read once for all tests of a process."""

from __future__ import annotations

import ast
import gc
from functools import cache
from pathlib import Path


@cache
def text_of(path: Path) -> str:
    """Return the text of a file."""
    return path.read_text(encoding="utf-8")


@cache
def tree_of(path: Path) -> ast.Module:
    """Return the syntax tree of a file, which must not be changed.

    The trees of the package have 860 000 nodes. Without `freeze`, each full garbage collection visits all of
    them.
    """
    tree = ast.parse(text_of(path))
    gc.freeze()
    return tree


@cache
def nodes_of(path: Path) -> tuple[ast.AST, ...]:
    """Return every node of a file, in the order of `ast.walk`."""
    return tuple(ast.walk(tree_of(path)))

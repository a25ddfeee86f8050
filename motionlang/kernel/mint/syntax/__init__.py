"""Parse Mint text to a syntax tree, and report all syntax errors."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lazy import lazy_names

if TYPE_CHECKING:
    from motionlang.kernel.mint.syntax.errors import recovered as recovered
    from motionlang.kernel.mint.syntax.errors import unfinished as unfinished

# Only a text with errors needs these.
PUBLIC = {"errors": "recovered unfinished"}

if not TYPE_CHECKING:
    __getattr__ = lazy_names(__name__, PUBLIC)

"""The words of Mint: the rows of a subject, and beside them what its words do.

A program that was compiled before imports operations from here and no row: nothing is imported with the package.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.lang.keyword import Table

_vocabulary: Table | None = None


def table() -> Table:
    """All words of Mint."""
    global _vocabulary  # noqa: PLW0603 - one vocabulary a process
    if _vocabulary is None:
        from motionlang.mint.keywords.vocabulary import Vocabulary

        _vocabulary = Vocabulary()
    return _vocabulary

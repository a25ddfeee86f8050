"""The words of Mint, a file a subject: its rows, and above them what its words do.

A run imports the files of the words that it uses, and nothing with the package: `index` says which file has a word.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.keywords.vocabulary import Vocabulary

_vocabulary: Vocabulary | None = None


def table() -> Vocabulary:
    """All words of Mint."""
    global _vocabulary  # noqa: PLW0603 - one vocabulary a process
    if _vocabulary is None:
        from motionlang.mint.keywords.vocabulary import Vocabulary

        _vocabulary = Vocabulary()
    return _vocabulary

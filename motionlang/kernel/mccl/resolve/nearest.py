"""Suggestions for two letters that are not a command."""

from __future__ import annotations

from motionlang.kernel.mccl.keywords import table


def candidates(word: str) -> list[str]:
    """Return the commands that may have been meant by a word."""
    upper, found = word.upper(), table().meant_by(word)
    if found or len(upper) > 2 or upper[0] == upper[-1]:
        return found
    swapped = table().get(upper[::-1])
    return [] if swapped is None else [swapped.name]


def hint(word: str) -> str:
    """Return a hint for an unknown word, or an empty text."""
    upper, found = word.upper(), candidates(word)
    if len(found) > 1 or (found and found[0] != upper[::-1]):
        return f"did you mean {' or '.join(filter(None, (', '.join(found[:-1]), found[-1])))}?"
    if len(upper) > 2:
        return "a command is two letters and its parameter; commands are separated by commas"
    if found and (swapped := table().get(found[0])) is not None:
        return f"did you mean {swapped.name}? {swapped.help}"
    similar = [row.name for row in table() if row.name[0] == upper[0]]
    return f"the commands that begin with {upper[0]} are {', '.join(sorted(similar))}" if similar else ""

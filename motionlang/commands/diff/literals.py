"""The literals that differ between two programs, by address."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from difflib import SequenceMatcher

from motionlang.kernel import Run
from motionlang.kernel.lang import revalued


@dataclass(eq=False, slots=True)
class ChangedLiteral:
    """A number with a different value; `old_address` is None for the same address."""

    address: str
    old_address: str | None
    old: str
    new: str


def changed_literals(old: Run, new: Run) -> list[ChangedLiteral]:
    """Return the literals with a different value, in the order of the new program.

    The literals of both programs are aligned by what they are assigned to. There are none if the languages
    differ, or if a program has errors.
    """
    if old.program is None or new.program is None or old.program.language != new.program.language:
        return []
    before, after = revalued(old.program), revalued(new.program)
    old_bases, new_bases = ([each.base.lower() for each in side] for side in (before, after))
    found: list[ChangedLiteral] = []
    for one, other in _aligned(old_bases, new_bases):
        was, is_ = before[one], after[other]
        if was.text != is_.text:
            old_address = was.address if was.address != is_.address else None
            found.append(ChangedLiteral(is_.address, old_address, was.text, is_.text))
    return found


def _aligned(old: list[str], new: list[str]) -> Iterator[tuple[int, int]]:
    """Yield the indices of equal texts of two lists, in order; what both begin with is not searched for others."""
    first = next((k for k, (one, other) in enumerate(zip(old, new, strict=False)) if one != other), None)
    first = min(len(old), len(new)) if first is None else first
    yield from ((k, k) for k in range(first))
    matcher = SequenceMatcher(None, old[first:], new[first:], autojunk=False)
    for block in matcher.get_matching_blocks():
        yield from ((first + block.a + k, first + block.b + k) for k in range(block.size))

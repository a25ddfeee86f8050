"""The literals that differ between two programs, by address."""

from __future__ import annotations

from dataclasses import dataclass

from motionlang.comparison.align import aligned
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
    for one, other in aligned(old_bases, new_bases, str):
        if one is None or other is None:
            continue
        was, is_ = before[one], after[other]
        if was.text != is_.text:
            old_address = was.address if was.address != is_.address else None
            found.append(ChangedLiteral(is_.address, old_address, was.text, is_.text))
    return found

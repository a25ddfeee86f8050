"""Words of an older Mint, under their present names, from the section `[mint.words]` of the machine file.

[mint.words]
GAIN = "KPROP"
"""

from __future__ import annotations

from collections.abc import Mapping

from motionlang.kernel.lang.syntax.word import Word
from motionlang.kernel.mint.keywords import table
from motionlang.kernel.mint.syntax.nodes import Module
from motionlang.kernel.mint.syntax.traversal import names_of
from motionlang.kernel.tools import nearest, shown

SECTION = "mint.words."


def rename_old_words(module: Module, settings: Mapping[str, object]) -> None:
    """Give each name of the tree that is an older word the name of its present keyword."""
    meant = {
        key.removeprefix(SECTION).lower(): str(value)
        for key, value in settings.items()
        if key.startswith(SECTION)
    }
    if not meant:
        return
    for name in names_of(module):
        if name.name.lower() in meant:
            name.name = Word(meant[name.name.lower()], name.name.start, name.name.end)


def problem(key: str, value: object) -> tuple[str, str] | None:
    """Return what is wrong with an entry and a hint, None if the entry is valid."""
    if isinstance(value, str) and table().get(value) is not None:
        return None
    near = nearest(str(value), table().names())
    hint = f"did you mean {near}?" if near else "motionlang help keywords lists the keywords of Mint"
    return f"{key} must be a keyword of Mint, not {shown(value)}", hint

"""Mint text to its syntax tree."""

from __future__ import annotations

from motionlang.lang.places import Places
from motionlang.lang.tables import Stuck, TooDeep
from motionlang.mint.build import Misuse
from motionlang.mint.tables import TABLES

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.nodes import Module
    from motionlang.source import Source


def parse(source: Source) -> Module:
    """The tree of a program; raises ProgramError with every mistake of the text."""
    texts = TABLES.texts(source.text)
    try:
        module: Module = TABLES.parse(texts)
    except (Stuck, TooDeep, Misuse) as trouble:
        from motionlang.mint.syntax import diagnose  # only a mistake pays for this import

        raise diagnose(source, trouble) from None
    module.places = Places(source, TABLES, texts)
    return module

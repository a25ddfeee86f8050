"""The open assumptions of a program: those of its keywords, from `tables`.

No evidence is loaded.
"""

from __future__ import annotations

from collections.abc import Mapping

from motionlang.kernel.assumptions.tables import DEFAULTS, MOTIONS, OPEN, REMEMBERED
from motionlang.kernel.lang.dialect import Dialect, dialects


def depended_on(language: Dialect, text: str, settings: Mapping[str, object]) -> list[str]:
    """Return the open assumptions of a program, in the order of the list.

    An assumption that the machine file sets is settled. A setting at power-up counts only for a program that never
    writes it. Settings that affect every move count for a program that moves an axis.
    """
    words, written = _words(language, text)
    words.add("@always")
    if any(".plant." in key for key in settings):
        words.add("@motor")
    others = [each for each in dialects() if each != language.name]
    found = [
        name
        for name, on in OPEN.items()
        if not is_of(name, *others)
        and not words.isdisjoint((on if isinstance(on, str) else on.get(language.name, "")).split())
    ]
    moves = not words.isdisjoint(MOTIONS.split())
    for name, (word, instead) in DEFAULTS.get(language.name, {}).items():
        used = moves if instead else word in words
        if used and written.isdisjoint((word, *instead.split())):
            found.append(name)
    return [name for name in found if f"assumptions.{name}" not in settings]


def remembered_in(language: Dialect, text: str) -> set[str]:
    """Return the keywords of a program whose meaning no document states."""
    rows = map(language.table().get, _words(language, text)[0])
    return {row.name for row in rows if row is not None}.intersection(REMEMBERED[language.name].split())


def is_of(name: str, *languages: str) -> bool:
    """True if an assumption is about one of these languages only."""
    return name.partition(".")[0] in languages


def _words(language: Dialect, text: str) -> tuple[set[str], set[str]]:
    """Return a program's keywords, in lower case, and those that begin a statement.

    The latter are written or executed.
    """
    words: set[str] = set()
    first: set[str] = set()
    for line in dict.fromkeys(text.splitlines()):
        begins = True
        for kind, piece, _ in language.tokens(line):
            if kind == "comment":
                continue
            name = piece.lower().partition(".")[0]
            words.add(name)
            if begins:
                first.add(name)
            begins = piece == ":" or name in ("then", "else", "do")
    return words, first

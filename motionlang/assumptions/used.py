"""Which open readings a program depends on: those whose words it uses, as `tables` has them; no evidence is loaded."""

from __future__ import annotations

from motionlang.assumptions.tables import DEFAULTS, MOTIONS, OPEN
from motionlang.lang.dialect import dialects

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping

    from motionlang.lang.dialect import Dialect


def depended_on(language: Dialect, text: str, settings: Mapping[str, object]) -> list[str]:
    """The names of the open readings that a program depends on, in the order of docs/fidelity.md.

    Those that the machine file sets are settled. What a setting is at power-up counts only for a program that never
    writes it; of the settings that shape every move, for one that moves an axis.
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


def is_of(name: str, *languages: str) -> bool:
    """Whether a reading is one of a language alone."""
    return name.partition(".")[0] in languages


def _words(language: Dialect, text: str) -> tuple[set[str], set[str]]:
    """The words of a program, in small letters, and those at the begin of a statement, which are written or done."""
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

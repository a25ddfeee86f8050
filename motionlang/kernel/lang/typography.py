"""Typographic quotes, dashes and blanks in place of a program's plain ones, and invisible characters.

Word processors and web pages insert them. `typographic` names the plain character, and `plain` replaces the typographic
one for `check --fix`.
"""

from __future__ import annotations

import re
from unicodedata import category

_PLAIN = {
    '"': ("quote", "“”„‟«»″"),
    "'": ("quote", "‘’‚‛‹›′´"),
    "-": ("dash", "‐‑‒–—―−"),
    "a blank": ("blank", "\u00a0\u2002\u2003\u2007\u2009\u202f"),
}
# By character: its name, and the plain character.
TYPOGRAPHIC = {
    character: (kind, plain) for plain, (kind, characters) in _PLAIN.items() for character in characters
}
# The closing quote of a text.
_CLOSING = re.compile(f'["{_PLAIN[chr(34)][1]}]')
# An apostrophe inside a word is no quote.
_INSIDE = re.compile(f"(?<=[^\\W\\d_])[{_PLAIN[chr(39)][1]}](?=[^\\W\\d_])")


def typographic(text: str) -> tuple[str, str] | None:
    """Return message and hint for a text that begins with a typographic or an invisible character.

    Returns None for any other text.
    """
    character = text[:1]
    if "\x80" <= character <= "\x9f":  # Windows-1252, read as Latin-1
        character = character.encode("latin-1").decode("cp1252", "replace")
    kind, plain = TYPOGRAPHIC.get(character, ("", ""))
    if not kind:
        is_invisible = bool(character) and category(character) == "Cf"  # such as a zero-width space
        message = f"this is an invisible character, U+{ord(character):04X}" if is_invisible else ""
        return (message, "delete it") if message else None
    if kind == "blank":
        return "this is a non-breaking space, not a plain one", "type a plain space"
    return f"{character} is a typographic {kind}, not a plain {plain}", f"type {plain}"


def unclosed(text: str) -> tuple[str, str] | None:
    """Return message and hint for a text in a plain and a typographic quote.

    The text begins with the plain quote. Returns None for any other text.
    """
    closing = _CLOSING.search(text, 1) if text[:1] == '"' else None
    return typographic(closing[0]) if closing else None


def plain(line: str) -> tuple[int, str]:
    """Return the length of the beginning of `line` to replace, and its plain text.

    The result is (0, "") if the replacement is not certain. The line begins at a typographic character, or at
    the plain quote of a text that a typographic quote closes. For a text in quotes both quotes are replaced.
    A single quote begins a comment, unless there is a second one.
    """
    kind, wanted = TYPOGRAPHIC.get(line[:1], ("", ""))
    if wanted == '"' or line[:1] == '"':
        closing = _CLOSING.search(line, 1)
        if closing is None:
            return (1, '"') if kind else (0, "")
        if not kind and closing[0] == '"':  # both are plain
            return 0, ""
        return closing.end(), f'"{line[1 : closing.start()]}"'
    if wanted == "'":
        others = _INSIDE.sub("", line[1:])
        return (0, "") if any(TYPOGRAPHIC.get(each, ("", ""))[1] == "'" for each in others) else (1, "'")
    return (1, " " if kind == "blank" else wanted) if kind else (0, "")

"""Typographic quotes, dashes and blanks that a word processor puts into a program."""

from __future__ import annotations

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


def typographic(text: str) -> tuple[str, str] | None:
    """Return message and hint for a text that begins with a typographic character.

    None for others.
    """
    character = text[:1]
    if "\x80" <= character <= "\x9f":  # Windows-1252, read as Latin-1
        character = character.encode("latin-1").decode("cp1252", "replace")
    kind, plain = TYPOGRAPHIC.get(character, ("", ""))
    if not kind:
        return None
    if kind == "blank":
        return "a blank that does not break a line stands here, not a plain one", "type a plain blank"
    return f"{character} is a typographic {kind}, not the plain {plain}", f"type {plain}"

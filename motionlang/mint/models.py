"""The two ages of Mint, and which controllers speak which: v4 with dots and labels, MintMT with brackets and tasks.

The grouping of the controllers is remembered (docs/fidelity.md); their names are those of the host library.
"""

from __future__ import annotations

V4, MINTMT = "Mint v4", "MintMT"

# A part of a controller's name, in lower case and without blanks and signs, and its age; the first that fits counts.
_NAMES: tuple[tuple[str, str], ...] = (
    ("mint4", V4),
    ("mintv4", V4),
    ("mintmt", MINTMT),
    ("mintdriveii", MINTMT),
    ("mintdrive", V4),
    ("eurosystem", V4),
    ("servonode", V4),
    ("nextmovepci2", MINTMT),
    ("nextmovebxii", MINTMT),
    ("nextmovebx", V4),
    ("nextmovepc2", V4),
    ("nextmovepci", MINTMT),
    ("nextmovepc", V4),
    ("nextmoverk", V4),
    ("nextmove", MINTMT),
    ("microflex", MINTMT),
    ("motiflex", MINTMT),
    ("flex", MINTMT),
    ("virtualcontroller", MINTMT),
)
# How they are called on the command line.
NAMES = ("mint4", "mintmt")


def age(model: str) -> str | None:
    """`V4` or `MINTMT` for the name of a controller, None where it tells neither."""
    name = "".join(letter for letter in model.lower() if letter.isalnum())
    return next((found for part, found in _NAMES if part in name), None)

"""Mistakes of the text."""

from __future__ import annotations

from motionlang.errors import Diagnostic, ProgramError
from motionlang.lang.places import Places
from motionlang.lang.tables import Stuck
from motionlang.mint.tables import TABLES

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.source import Source


def diagnose(source: Source, trouble: Exception) -> ProgramError:
    """Every mistake of a text that cannot be parsed."""
    places = Places(source, TABLES)
    at = trouble.at if isinstance(trouble, Stuck) else 0
    return ProgramError(
        [
            Diagnostic(
                "syntax", "unexpected text", places.line(at), places.column(at), length=places.length(at)
            )
        ]
    )

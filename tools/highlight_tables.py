"""Writer of `playground/keywords.json`.

The file lists the keywords of both languages by kind, for the editor of the playground. The kinds are those
of `motionlang.views.highlight`.
"""

from __future__ import annotations

import json
from pathlib import Path

from motionlang.kernel.lang.dialect import dialect
from motionlang.kernel.mint.syntax.tokens import SPELLINGS
from motionlang.views.highlight import pieces

FILE = Path(__file__).parent.parent / "playground" / "keywords.json"


def written() -> str:
    """Return the text of the file."""
    return json.dumps({name: _kinds(name) for name in ("mint", "mccl")}, indent=1) + "\n"


def _kinds(name: str) -> dict[str, str]:
    language, found = dialect(name), dict[str, set[str]]()
    words = {spelling.lower() for row in language.table().rows for spelling in (row.name, row.short)}
    if name == "mint":
        words |= {text.lower() for text in SPELLINGS.values()}
    for word in filter(str.isidentifier, words):
        _, kind, piece = next(pieces(language, word))
        if piece == word and kind in ("move", "keyword", "not-simulated", "control"):
            found.setdefault(kind, set()).add(word)
    return {kind: " ".join(sorted(found[kind])) for kind in sorted(found)}


def files() -> dict[Path, str]:
    return {FILE: written()}

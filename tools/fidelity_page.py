"""Writer of the list of assumptions and the tables of docs/fidelity.md.

docs/fidelity.md has hand-written text around the tables, which lie between
`<!-- generated -->` and `<!-- end -->`.
"""

from __future__ import annotations

import re
from pathlib import Path

from tools.assumptions_page import markdown, summary

DOCS = Path(__file__).parent.parent / "docs"
LIST = DOCS / "contributing" / "assumptions.md"
PAGE = DOCS / "fidelity.md"
_SECTION = re.compile(r"(<!-- generated -->\n).*?(<!-- end -->)", re.DOTALL)


def written(text: str) -> str:
    """Return the page with its tables."""
    return _SECTION.sub(lambda found: f"{found[1]}{summary()}{found[2]}", text)


def files() -> dict[Path, str]:
    return {LIST: markdown(), PAGE: written(PAGE.read_text(encoding="utf-8"))}

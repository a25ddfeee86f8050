"""Writer of the list of assumptions and the tables of docs/fidelity.md.

Run `python -m tests.fidelity_page`. docs/fidelity.md has hand-written text around the tables, which lie between
`<!-- generated -->` and `<!-- end -->`.
"""

from __future__ import annotations

import re
from pathlib import Path

from tests.assumptions_page import markdown, summary

DOCS = Path(__file__).parent.parent / "docs"
LIST = DOCS / "contributing" / "assumptions.md"
PAGE = DOCS / "fidelity.md"
_SECTION = re.compile(r"(<!-- generated -->\n).*?(<!-- end -->)", re.DOTALL)


def written(text: str) -> str:
    """Return the page with its tables."""
    return _SECTION.sub(lambda found: f"{found[1]}{summary()}{found[2]}", text)


if __name__ == "__main__":
    LIST.write_text(markdown(), encoding="utf-8")
    PAGE.write_text(written(PAGE.read_text(encoding="utf-8")), encoding="utf-8")

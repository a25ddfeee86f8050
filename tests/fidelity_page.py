"""Writer of docs/fidelity.md from the evidence: `python -m tests.fidelity_page`."""

from __future__ import annotations

from pathlib import Path

from motionlang.assumptions.page import markdown

PAGE = Path(__file__).parent.parent / "docs" / "fidelity.md"

if __name__ == "__main__":
    PAGE.write_text(markdown(), encoding="utf-8")

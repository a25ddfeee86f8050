"""The tables of docs/copley.md match the code."""

from __future__ import annotations

from pathlib import Path

from motionlang_copley.objects import OBJECTS, SUB_MODES

PAGE = Path(__file__).parents[3] / "docs" / "copley.md"


def test_the_page_names_every_object_of_the_note() -> None:
    text = PAGE.read_text(encoding="utf-8")
    for entry in OBJECTS:
        if entry.source != "DS402":
            assert f"0x{entry.index:X}" in text
    for mode in SUB_MODES:
        assert f"| {str(mode).replace('-', '−')} |" in text

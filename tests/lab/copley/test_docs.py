"""The tables of `docs/copley.md` match the code.

`tests/test_docs.py` runs the blocks.
"""

from __future__ import annotations

from motionlang.lab.copley.objects import OBJECTS, SUB_MODES
from tests.lab.copley.docs import PAGE, blocks

TEXT = PAGE.read_text(encoding="utf-8")
BLOCKS = list(blocks(TEXT))


def test_there_are_blocks() -> None:
    assert len(BLOCKS) >= 12


def test_the_page_names_every_object_of_the_note() -> None:
    for entry in OBJECTS:
        if entry.source != "DS402":
            assert f"0x{entry.index:X}" in TEXT
    for mode in SUB_MODES:
        assert f"| {str(mode).replace('-', '−')} |" in TEXT

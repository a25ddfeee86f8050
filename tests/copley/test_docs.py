"""Every command of `docs/copley.md` prints what is shown; tables match the code."""

from __future__ import annotations

import pytest

from motionlang.copley.objects import OBJECTS, SUB_MODES
from tests.copley.docs import PAGE, answer, blocks

TEXT = PAGE.read_text(encoding="utf-8")
BLOCKS = list(blocks(TEXT))


@pytest.mark.parametrize("pairs", BLOCKS, ids=lambda pairs: pairs[-1][0].removeprefix("motionlang pvt ")[:60])
def test_a_block_prints_what_it_shows(
    pairs: list[tuple[str, str]], tmp_path: object, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(str(tmp_path))
    for command, shown in pairs:
        assert answer(command, shown) == shown, command


def test_there_are_blocks() -> None:
    assert len(BLOCKS) >= 12


def test_the_page_names_every_object_of_the_note() -> None:
    for entry in OBJECTS:
        if entry.source != "DS402":
            assert f"0x{entry.index:X}" in TEXT
    for mode in SUB_MODES:
        assert f"| {str(mode).replace('-', '−')} |" in TEXT

"""What a compiled program knows of its text: blocks and lines, as they are where the text is read again."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang.mint import DIALECT
from motionlang.source import Source

ROOT = Path(__file__).parents[3]
GALLERY = sorted((ROOT / "scripts" / "mint").glob("*.mnt"))


@pytest.mark.parametrize("path", GALLERY, ids=lambda path: path.stem)
def test_blocks_and_lines_outlast_the_cache(path: Path) -> None:
    source = Source.read(path)
    program = DIALECT.load(DIALECT.compile(source, {}).payload() or b"")
    assert program.outline is not None
    blocks, lines = program.outline
    assert blocks == DIALECT.blocks(source)
    assert lines
    for at, line in lines.items():
        assert line == DIALECT.locate(source, at)[0]

"""The stored outline of a compiled program equals the outline of its text."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang.mint import DIALECT
from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.extent import blocks_of
from motionlang.mint.syntax.parser import parse
from motionlang.mint.syntax.traversal import walk
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


@pytest.mark.parametrize("path", GALLERY, ids=lambda path: path.stem)
def test_a_block_ends_with_the_last_of_all_its_nodes(path: Path) -> None:
    module = parse(Source.read(path))
    offsets = {block.start: max(node.start for node in walk([block])) for block in blocks_in(module)}
    ends = {module.line(at): module.line(last) for at, last in offsets.items()}
    assert {first: last for _, first, last in blocks_of(module)} == ends


def blocks_in(module: nodes.Module) -> list[nodes.Node]:
    of_tasks = [sub for task in module.tasks for sub in task.subs]
    return [*module.tasks, *of_tasks, *module.subs, *module.events, *module.startup]

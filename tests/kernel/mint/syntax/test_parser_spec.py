"""Every construct of Mint and its tree: `parser_spec.txt` and its golden file."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang import parse

HERE = Path(__file__).parent


def samples() -> dict[str, str]:
    """Return the samples of the specification, by name."""
    blocks = (HERE / "parser_spec.txt").read_text().removesuffix("----\n").split("\n----\n")
    return {block.partition("\n")[0]: block.partition("\n")[2] for block in blocks}


def goldens() -> dict[str, str]:
    blocks = (HERE / "parser_spec.golden.txt").read_text().split("\n----\n")
    return {block.partition("\n")[0]: block.partition("\n")[2] for block in blocks}


def shown(module: object) -> str:
    """Return a tree as text: a line per statement or declaration, below its list."""
    lines = []
    for name in type(module).__slots__:  # type: ignore[attr-defined]
        items = getattr(module, name)
        lines += [f"{name}: {item!r}" for item in items]
    return "\n".join(lines)


@pytest.mark.parametrize("name", samples())
def test_tree(name: str) -> None:
    assert shown(parse(samples()[name], "mint")) == goldens()[name]


def test_every_sample_has_its_golden() -> None:
    assert list(samples()) == list(goldens())

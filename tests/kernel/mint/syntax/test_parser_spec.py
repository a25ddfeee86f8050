"""Every construct of Mint and its tree: `parser_spec.txt` and its golden file."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from motionlang import parse

HERE = Path(__file__).parent


def samples(name: str = "parser_spec.txt") -> dict[str, str]:
    """Return the samples of a file of this folder, by name."""
    blocks = (HERE / name).read_text(encoding="utf-8").removesuffix("----\n").split("\n----\n")
    return {block.partition("\n")[0]: block.partition("\n")[2] for block in blocks}


def shown(module: object) -> str:
    """Return a tree as text: a line per statement or declaration, below its list."""
    lines = []
    for name in type(module).__slots__:  # type: ignore[attr-defined]
        items = getattr(module, name)
        lines += [f"{name}: {item!r}" for item in items]
    return "\n".join(lines)


def together(shown: dict[str, str]) -> str:
    """Return the text of a golden file, from what is shown of each sample."""
    return "\n----\n".join(f"{name}\n{text}" for name, text in shown.items())


def test_trees(golden: Callable[[Path, str], None]) -> None:
    trees = {name: shown(parse(text, "mint")) for name, text in samples().items()}
    golden(HERE / "parser_spec.golden.txt", together(trees))

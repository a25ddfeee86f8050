"""Check Goto and Gosub; name resolution reports labels that are declared twice."""

from __future__ import annotations

from motionlang.kernel.mint.check.body import Body
from motionlang.kernel.mint.syntax import nodes


def jump(b: Body, node: nodes.Jump) -> None:
    """Check a Goto or a Gosub."""
    assert node.symbol is not None
    if node.symbol.declared:
        return
    name, problems = node.name, b.program.problems
    symbol = b.scope.find(name)
    if symbol is not None and symbol.kind == "sub":
        hint = f"a sub is called by its name alone: {symbol.name}"
        problems.add("unknown-word", f"{symbol.name} is a sub, not a label", name.start, hint)
        return

    def labels() -> list[str]:
        return [key for key, label in b.function.labels.items() if label.declared]

    problems.unknown(f"there is no label {name}", name, labels, name.start, label_hint(name))


def label_hint(name: str) -> str:
    return f"a label has a line of its own: #{name}"

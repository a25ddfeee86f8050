"""Names are resolved once: each use of a name stores its meaning."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from motionlang.kernel import ProgramError, Source, execution
from motionlang.kernel.mint import table
from motionlang.kernel.mint.program import checked_program
from motionlang.kernel.mint.resolve.names import Names
from motionlang.kernel.mint.resolve.problems import Problems
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.parser import parse
from motionlang.kernel.mint.syntax.traversal import meant, walk

PACKAGE = Path(__file__).parents[4] / "motionlang" / "kernel" / "mint"
# Lookups of names after the resolver, and how many; the numbers may only shrink. `model` looks up keywords of
# other controllers, also in a program with errors. The check looks for a sub of the name that a
# wrong Gosub or Call has, for its hint. The structure looks
# for the row of what raises an event.
LOOK_UPS = {
    "check/labels.py": 1,
    "check/model.py": 4,
    "check/unknown_words.py": 1,
}


def test_later_passes_look_up_no_names() -> None:
    found = {}
    for path in sorted(
        each
        for name in ("check", "steps", "../../commands/check/mint")
        for each in (PACKAGE / name).glob("*.py")
    ):
        count = len(re.findall(r"scope\.find\(|table\.get\(", path.read_text(encoding="utf-8")))
        if count:
            found[path.relative_to(PACKAGE).as_posix()] = count
    assert found == LOOK_UPS


def resolved(text: str) -> dict[str, list[nodes.Name]]:
    """Return the uses of each name in a program, in source order, by spelling."""
    module = parse(Source("a.mnt", text))
    names = Names(table(), Problems(module))
    names.declare_module(module)
    found: dict[str, list[nodes.Name]] = {}
    every = [node for f in names.functions for node in walk(f.body) if isinstance(node, nodes.Name)]
    for node in sorted(every, key=lambda node: node.start):
        found.setdefault(node.name, []).append(node)
    return found


def test_a_name_is_what_its_function_declares_or_a_word_or_neither() -> None:
    found = resolved("Dim a\na = POS(0) + b\nf\nSub f()\n  Dim a As Integer\n  a = 2\nEnd Sub")
    outer, inner = found["a"]
    assert outer.symbol is not None
    assert inner.symbol is not None
    assert (str(outer.symbol.type), str(inner.symbol.type)) == ("Float", "Integer")
    (position,), (unknown,), (call,) = found["POS"], found["b"], found["f"]
    assert (position.symbol, position.row) == (None, table().get("POS"))
    assert (unknown.symbol, unknown.row) == (None, None)
    assert call.symbol is not None
    assert call.symbol.kind == "sub"


def test_define_is_resolved_at_its_use() -> None:
    found = resolved(
        "Define twice = 2 * a\nDim a\na = twice\nf\nSub f()\n  Dim a As Integer\n  a = twice\nEnd Sub"
    )
    outer, inner = (meant(each) for each in found["twice"])
    assert isinstance(outer, nodes.Binary)
    assert isinstance(inner, nodes.Binary)
    assert outer is not inner
    of_outer, of_inner = (
        next(n for n in walk([each]) if isinstance(n, nodes.Name)) for each in (outer, inner)
    )
    assert (str(of_outer.symbol.type), str(of_inner.symbol.type)) == ("Float", "Integer")  # type: ignore[union-attr]


def test_assignment_to_a_define_writes_its_variable() -> None:
    defines = "Define valve = OUTX(3)\nDefine n = count\nDim count As Integer\n"
    text = f"{defines}valve = 1\nn = 5\nn = n + 2\nPRINT count, valve"
    assert "".join(execution.run(Source("a.mnt", text)).output).replace(" ", "") == "71"


@pytest.mark.parametrize("text", ["Define a = a + 1\nPRINT a", "Define a = b\nDefine b = a\nPRINT a"])
def test_a_define_that_comes_back_to_itself_is_a_mistake(text: str) -> None:
    with pytest.raises(ProgramError, match="is defined by itself"):
        checked_program(Source("a.mnt", text))

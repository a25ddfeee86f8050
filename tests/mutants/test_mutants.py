"""The mutants are changes of what runs, each one place; the long run wants 95 % of them killed."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from tests.mutants.__main__ import main, runs_of
from tests.mutants.mutate import chosen, files, mutants

TEXT = '''"""A sentence with 3 numbers."""
from __future__ import annotations
if TYPE_CHECKING:
    LEFT = 1
LIMIT = 2

def f(a, b):
    """Another 4."""
    assert a > 1
    if a < b and not b:
        raise ValueError(f"{a + 1}")
    return a + b * -1.5 if a == LIMIT else profiles[-1]
'''


def spelt(text: str) -> str:
    """An expression as this Python writes it."""
    return ast.unparse(ast.parse(text, mode="eval"))


def test_what_is_changed(tmp_path: Path) -> None:
    path = tmp_path / "a.py"
    path.write_text(TEXT, encoding="utf-8")
    found = {(each.line, each.before, spelt(each.after)) for each in mutants(path)}
    assert found >= {
        (5, "2", "3"),
        (10, "a < b", "a <= b"),
        (10, "not b", "b"),
        (10, spelt("a < b and not b"), spelt("a < b or not b")),
        (12, "a == LIMIT", "a != LIMIT"),
        (12, "-1", "1"),
    }
    assert {line for line, _, _ in found} == {5, 10, 12}
    for each in mutants(path):
        assert ast.unparse(ast.parse(each.text())) != ast.unparse(ast.parse(TEXT))


def test_the_same_are_chosen_again_from_every_part() -> None:
    once = [str(each) for each in chosen(300, 0)]
    assert once == [str(each) for each in chosen(300, 0)]
    assert {each.split("/")[1] for each in once} == {"profile", "controller", "mint", "mccl"}
    assert all(runs_of(path) for path in files())


@pytest.mark.long
def test_nineteen_of_twenty_are_killed() -> None:
    assert main(300, 0) == 0

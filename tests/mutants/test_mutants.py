"""Each mutant changes one position in code that runs; a long run kills 88 %."""

from __future__ import annotations

import ast
from pathlib import Path
from typing import Any

import pytest

from tests.mutants.__main__ import BAR, EQUIVALENT, default_tests, main
from tests.mutants.forks import BUDGET, NET, within_budget
from tests.mutants.mutate import ROOT, chosen, every, mutants, woven

TEXT = '''"""A sentence with 3 numbers."""
from __future__ import annotations
if TYPE_CHECKING:
    LEFT = 1
LIMIT = 2

def f(a, b):
    """Another 4."""
    assert a > -9
    if a < b and not b:
        raise ValueError(f"{a + 1}")
    return a + b * -1.5 if a == LIMIT else profiles[-1]
    zip(a, b, strict=True)

async def g(a) -> int | None:
    return a < 7
'''


def spelt(text: str) -> str:
    """Return an expression as this version of Python writes it."""
    return ast.unparse(ast.parse(text, mode="eval"))


def written(folder: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr("tests.mutants.mutate.ROOT", folder)
    path = folder / "a.py"
    path.write_text(TEXT, encoding="utf-8")
    return path


def test_what_is_changed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = written(tmp_path, monkeypatch)
    found = {(each.line, each.before, spelt(each.after)) for each in mutants(path)}
    assert found >= {
        (5, "2", "3"),
        (10, "a < b", "a <= b"),
        (10, "not b", "b"),
        (10, spelt("a < b and not b"), spelt("a < b or not b")),
        (12, "a == LIMIT", "a != LIMIT"),
        (12, "-1", "1"),
        (16, "a < 7", "a <= 7"),
    }
    assert {line for line, _, _ in found} == {5, 10, 12, 16}
    assert {each.line for each in mutants(path) if each.imported} == {5}


@pytest.mark.slow
def test_the_same_are_chosen_again_from_every_package() -> None:
    once = chosen(300, 0)
    assert chosen(300, 0) == once != chosen(300, 1)
    assert {each.package for each in once} >= {
        "cli",
        "controller",
        "lang",
        "mccl",
        "mint",
        "views",
    }
    assert {"tests/cli", "tests/golden", "tests/test_files.py"} < set(default_tests())


def test_a_change_elsewhere_leaves_the_choice_and_the_names(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = written(tmp_path, monkeypatch)
    before = [each.name for each in mutants(path)]
    assert len(set(before)) == len(before) > 8
    path.write_text(TEXT.replace("LIMIT = 2", "OTHER = 7\nLIMIT = 2"), encoding="utf-8")
    assert set(before) < {each.name for each in mutants(path)}


def test_each_change_is_made_where_its_number_is_active(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = written(tmp_path, monkeypatch)
    found = list(mutants(path))
    code = compile(woven(path, {each.ordinal: 100 + each.ordinal for each in found}), "a.py", "exec")

    def answers(active: int) -> tuple[object, ...]:
        seen: list[str] = []
        space: dict[str, Any] = {
            "__mutant__": active.__eq__, "__seen__": seen.append, "TYPE_CHECKING": False, "profiles": [7, 8, 9],
        }  # fmt: skip
        exec(code, space)
        results: list[object] = [space["LIMIT"]]
        for a, b in ((2, 3), (2, 2), (3, 0), (-2, 0), (0, 0), (3, 4)):
            try:
                results.append(space["f"](a, b))
            except (ValueError, IndexError) as error:
                results.append(type(error))
        for a in (6, 7, 8):
            with pytest.raises(StopIteration) as end:
                space["g"](a).send(None)
            results.append(end.value.value)
        assert set(seen) == {"a.py"}
        return tuple(results)

    plain = answers(-1)
    assert [each.name for each in found if answers(100 + each.ordinal) == plain] == []


def test_the_net_is_never_left_out() -> None:
    quick, slow, net = "tests/a.py::test_a", "tests/a.py::test_b", f"{NET}::test_c"
    durations = {quick: 1.0, slow: BUDGET, net: BUDGET}
    assert (ROOT / NET).exists()
    assert within_budget([quick, slow, net], durations) == [quick, net]


@pytest.mark.slow
def test_equivalent_mutants_exist_in_the_sources() -> None:
    names = {each.name for each in every()}
    assert [name for name in EQUIVALENT if name not in names] == []


@pytest.mark.long
def test_the_score_reaches_its_bar() -> None:
    assert BAR == 0.88
    assert main(80, [0], [], default_tests()) == 0

"""`check` reports every error of a file in one pass, with complete messages."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang.commands.check import check
from motionlang.kernel import Source
from motionlang.kernel.mccl import DIALECT
from motionlang.views.diagnostics import render
from tests.mccl_runs import Runner

ERRORS = Path(__file__).parents[3] / "errors" / "mccl"
CHECKED = sorted(ERRORS.glob("*.check.mcl"))
RUN = sorted(ERRORS.glob("*.run.mcl"))


def rendered(found: list[object], source: Source) -> str:
    return "\n".join(render(each, source) for each in found)  # type: ignore[arg-type]


@pytest.mark.parametrize("path", CHECKED, ids=lambda path: path.stem)
def test_what_check_says(path: Path, update: bool) -> None:
    source = Source.read(path)
    compare(path, rendered(list(check(DIALECT.program(source))), source), update)


@pytest.mark.parametrize("path", RUN, ids=lambda path: path.stem)
def test_what_a_run_says(path: Path, mccl: Runner, update: bool) -> None:
    source = Source.read(path)
    compare(path, rendered(list(mccl(source.text).diagnostics), Source(path.name, source.text)), update)


def compare(path: Path, found: str, update: bool) -> None:
    expected = path.with_suffix(".txt")
    if update:
        expected.write_text(found)
    assert found == expected.read_text()


def test_there_are_some_of_both() -> None:
    assert CHECKED
    assert RUN

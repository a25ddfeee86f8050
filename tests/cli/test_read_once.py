"""Each command reads the text of a program once."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from lark.parsers.lalr_interactive_parser import InteractiveParser

from motionlang import sweep
from motionlang.cli import main
from motionlang.kernel import Source
from motionlang.kernel.mint import program
from tests.counted_calls import count_calls

PROGRAM = Path(__file__).parents[2] / "scripts" / "mint" / "pick-and-place.mnt"


@pytest.fixture
def calls(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> Callable[[str], tuple[int, int]]:
    """Return a function that runs a command, and returns how often it parses and checks."""

    def count(command: str) -> tuple[int, int]:
        parsed, checked = (
            count_calls(monkeypatch, (InteractiveParser, "feed_eof")),
            count_calls(monkeypatch, (program, "examined")),
        )
        word, *options = command.split()
        assert main([word, str(PROGRAM), *options]) == 0
        assert capsys.readouterr().err == ""
        return parsed.calls, checked.calls

    return count


@pytest.mark.parametrize(
    "command",
    [
        "check",
        "check --steps --tree --literals --evidence",
        "run",
        "run --analog 0=25@1",
        "profile",
        "certify",
    ],
)
def test_a_command_reads_a_program_once(command: str, calls: Callable[[str], tuple[int, int]]) -> None:
    assert calls(command) == (1, 1)


@pytest.mark.parametrize(
    ("command", "parses", "checks"),
    [
        ("run --set _PARTS=2", 1, 1),
        ("run --set SPEED[_axX]@18=700 --set ACCEL[_axX]@19=3000", 1, 1),
        # The text, and the program for all values.
        ("sweep --jobs 1 --vary _PARTS=1,2,3", 1, 2),
        ("sweep --jobs 1 --vary SPEED[_axX]@18=700,800,900 --vary ACCEL[_axX]@19=3000,4000", 1, 2),
    ],
)
def test_variants_of_a_program_are_not_read(
    command: str, parses: int, checks: int, calls: Callable[[str], tuple[int, int]]
) -> None:
    assert calls(command) == (parses, checks)


def test_the_settings_of_a_machine_are_varied_without_a_parse(monkeypatch: pytest.MonkeyPatch) -> None:
    """The check depends on the number of axes."""
    parsed, checked = (
        count_calls(monkeypatch, (InteractiveParser, "feed_eof")),
        count_calls(monkeypatch, (program, "examined")),
    )
    rows = sweep(Source("a.mnt", "MOVER(0) = 5 : GO(0)\n"), {"controller.axes": [1, 2, 3]}, jobs=1)
    assert all(row.ok for row in rows)
    assert (parsed.calls, checked.calls) == (1, 3)

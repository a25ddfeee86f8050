"""Long tables state how many rows they leave out; complete tables do not."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.views.questions import _show_once
from motionlang.views.report import writes_table
from tests.cli.programs import Cell


@pytest.mark.parametrize(
    ("count", "rest"), [(40, []), (41, ["… and 1 more segments"]), (50, ["… and 10 more segments"])]
)
def test_at_most_40_segments_of_a_drive_are_listed(count: int, rest: list[str], cell: Cell) -> None:
    positions = ",".join(map(str, range(count + 1)))
    lines = cell(
        "pvt", "plot", f"--positions={positions}", "--time", "10", "--velocities", "zero"
    ).out.splitlines()
    assert [line for line in lines if line.startswith("…")] == rest
    assert sum(line.split()[:1] == [str(k)] for k in range(count) for line in lines[3:]) == 40
    assert lines[-1].startswith(f"{count} segments, {10 * count} ms")


@pytest.mark.parametrize(("count", "rest"), [(40, 0), (41, 1), (45, 5)])
def test_at_most_40_writes_are_listed(count: int, rest: int) -> None:
    rows = [{"server": 1, "kind": "holding-register", "number": k, "value": k / 4} for k in range(count)]
    lines = writes_table(rows).lines(100)
    assert lines[-1] == (
        f"… and {rest} more: --format json has all" if rest else "Modbus server 1  holding register 39   9.75"
    )


def test_an_answer_that_was_typed_is_not_shown_again() -> None:
    """Only the first text after an answer is the program's echo of it."""
    shown: list[str] = []
    terminal: Any = SimpleNamespace(show=shown.append)
    _show_once(terminal, "12\n")
    for text in ("12\n", "12\n", "next"):
        terminal.show(text)
    assert shown == ["12\n", "next"]

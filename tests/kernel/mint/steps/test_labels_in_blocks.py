"""A block with labels runs like one without, and takes as long."""

from __future__ import annotations

import re

import pytest

from motionlang import run
from motionlang.commands.check import check
from motionlang.kernel import Source
from motionlang.kernel.mint import DIALECT
from tests.kernel.mint.polling_programs import program

_ENDS = re.compile(r"^(End Loop|End While|Until .*|End If)$", re.MULTILINE)


def outcome(text: str, machine: dict[str, object], until: float = 1.0) -> tuple[object, ...]:
    result = run(Source("a.mnt", text), machine=machine, until=until)
    assert not result.diagnostics
    return result.output, result.status, round(result.time, 7), len(result.controller.log.moves)


def with_labels(text: str) -> str:
    """Return a program with a label at the end of every block, except in For loops."""
    count = iter(range(1000))
    return _ENDS.sub(lambda match: f"#here{next(count)}\n{match[1]}", text)


@pytest.mark.parametrize("seed", [seed for seed in range(16) if _ENDS.search(program(seed)[0])])
def test_a_label_that_nothing_goes_to_changes_nothing(seed: int) -> None:
    text, machine = program(seed)
    assert outcome(with_labels(text), machine) == outcome(text, machine)


def test_a_label_at_the_end_of_a_loop_is_not_warned_of() -> None:
    text = "LOOP\n n = n + 1\n IF n = 3 THEN EXIT\n IF n = 2 THEN GOTO next\n PRINT n\n#next\nENDL\nPRINT n"
    assert check(DIALECT.program(Source("a.mnt", f"Dim n As Integer\n{text}"))) == []


def test_a_loop_that_polls_is_skipped_all_the_same() -> None:
    text = "LOOP\n IF INX(1) THEN GOTO next\n IF INX(2) THEN OUTX(3) = 1\n#next\nENDL"
    assert outcome(text, {}, until=28_800.0)[1] == "until"


def test_a_loop_of_gotos_in_a_block_is_logged_from_its_label_to_the_last_jump_back() -> None:
    """Each of the 500 iterations takes four statements of 10 µs, after that of the If."""
    text = "Dim n As Integer\nIf 1 Then\ntop:\n n = n + 1\n POS(0) = n\n If n < 500 Then Goto top\nEnd If\nPRINT n"
    result = run(Source("a.mnt", text))
    ((_, at, since, until, _),) = result.machine.log.loops
    assert (text[at:].partition(":")[0], since, round(until, 9)) == ("top", 1e-5, 0.02)

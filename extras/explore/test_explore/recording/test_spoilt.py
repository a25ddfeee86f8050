"""Recordings that are damaged: `init` answers or refuses, and never has an internal error."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

import pytest

from motionlang.commands.recording import read_file
from motionlang.kernel import ProgramError
from motionlang_explore.init.recorded.drafting import entries_of
from motionlang_explore.init.recorded.recording import measured_recording
from tests.cli.programs import Cell
from tests.commands.recording.test_spoilt import DAMAGE, read_spoilt, refuse_or_answer


def read(path: Path) -> None:
    """Read a file as `init` does; an answer and a ProgramError are the same to this test."""
    with suppress(ProgramError, OSError):
        entries_of(measured_recording(read_file(str(path)), ()))


@pytest.mark.parametrize(("seeds", "rows"), DAMAGE)
@pytest.mark.filterwarnings("error")
def test_a_spoilt_file_is_no_internal_error(seeds: range, rows: int, tmp_path: Path) -> None:
    read_spoilt(read, seeds, rows, tmp_path)


@pytest.mark.slow
def test_the_command_refuses_or_answers(cell: Cell) -> None:
    refuse_or_answer(("init machine.mnt --recording {} --format none --until 9",), cell)

"""Each command reads the text of a program once."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from tests.cli.test_read_once import calls  # noqa: F401


@pytest.mark.parametrize(
    ("command", "parses", "checks"),
    [
        ("map --no-run", 1, 1),
        ("cover", 1, 1),
        # The text, the program for all values, the program that is explored, without and with the edits, and with
        # another number of a group.
        ("improve", 2, 5),
        # The text, and the program that is played.
        ("map", 1, 2),
    ],
)
def test_a_command_reads_a_program_once(
    command: str,
    parses: int,
    checks: int,
    calls: Callable[[str], tuple[int, int]],  # noqa: F811
) -> None:
    assert calls(command) == (parses, checks)

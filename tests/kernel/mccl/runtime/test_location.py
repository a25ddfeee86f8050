"""The place of a command: its line, column and length."""

from __future__ import annotations

import pytest

from motionlang.kernel import Source
from motionlang.kernel.mccl import MacroFile, locate


@pytest.mark.parametrize(
    ("text", "at", "place"),
    [
        ("1MN,1MR400,1WS", 0, (1, 1, 3)),
        ("1MN,1MR400,1WS", 4, (1, 5, 6)),
        ("1MN\n1MR400", 4, (2, 1, 6)),
        # A line of over 255 characters is an error of the line: as much of it as a terminal shows.
        ("1TP" + 252 * " ", 0, (1, 1, 3)),
        ("1TP" + 253 * " ", 0, (1, 1, 80)),
        ("1TP," + 253 * " " + "1TP", 257, (1, 258, 3)),
    ],
)
def test_a_command_has_a_line_a_column_and_a_length(text: str, at: int, place: tuple[int, int, int]) -> None:
    assert locate(Source("a.mcl", text), at) == place


@pytest.mark.parametrize(
    ("text", "is_doubtful", "entries"),
    [
        ("", False, []),
        ("1MN,1TP", False, []),
        ("1MN\n1XX", False, []),
        ("1XX\n1MN", True, []),
        ("x = 5", True, []),
        ("1TP," * 64, True, []),  # too long a line
        # The command after MD is the first of its macro; MD3 has none.
        ("MD1,NO,NO\nNO,NO\nMD2,AL5\nMD3\n1XX\nMD4 , AL6", False, [4, 20, 38]),
    ],
)
def test_what_a_file_may_be_and_where_its_macros_begin(
    text: str, is_doubtful: bool, entries: list[int]
) -> None:
    file = MacroFile(Source("a.mcl", text))
    assert (file.is_doubtful, file.entries) == (is_doubtful, entries)

"""Numbers that differ between two programs, by address."""

from __future__ import annotations

import pytest

from motionlang.commands.diff.literals import changed_literals
from motionlang.kernel import Source, run

# The old program, the new one, and the numbers that differ: new address, old one if another, values.
PROGRAMS: dict[str, tuple[str, str, list[tuple[str, str | None, str, str]]]] = {
    "none": ("SPEED(0) = 20\n", "' slower\nSPEED(0) = 20\n", []),
    "one": ("SPEED(0) = 20\n", "SPEED(0) = 30\n", [("SPEED[0]@1", None, "20", "30")]),
    "one that was put in": (
        "ACCEL(0) = 9\n", "SPEED(0) = 30\nACCEL(0) = 8\n", [("ACCEL[0]@2", "ACCEL[0]@1", "9", "8")],
    ),
    "one among many of one name": (
        "WAIT(10)\n" * 250, "SPEED(0) = 20\n" + "WAIT(10)\n" * 200 + "WAIT(11)\n" + "WAIT(10)\n" * 49,
        [("WAIT@202", "WAIT@201", "10", "11")],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", PROGRAMS)
def test_numbers_are_compared_by_what_they_are_assigned_to(name: str) -> None:
    old, new, expected = PROGRAMS[name]
    runs = [run(Source("a.mnt", text)) for text in (old, new)]
    found = changed_literals(*runs)
    assert [(each.address, each.old_address, each.old, each.new) for each in found] == expected


def test_programs_of_two_languages_have_no_numbers_in_common() -> None:
    """The variable WA of Mint and the wait of MCCL are both called WA@1."""
    mint, mccl = (run(Source(file, text)) for file, text in (("a.mnt", "WA = 5\n"), ("a.mcl", "WA6\n")))
    assert changed_literals(mint, mccl) == changed_literals(mccl, mint) == []

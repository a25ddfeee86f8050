"""`[readings]` of the machine file: confirmed assumptions, and errors in them."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.errors import ProgramError
from motionlang.lang.machine.file import read_machine
from motionlang.source import Source


def answers(name: str, text: str, machine: str) -> list[str]:
    settings = read_machine(Source("m.toml", f"[assumptions]\n{machine}\n"))
    return run(Source(name, text), machine=settings, cache=False).output


def test_machine_file_gives_mint_settings_at_power_up() -> None:
    text = "PRINT HOMESPEED(1)\nHOMESPEED(1) = 7\nDEFAULT(1)\nPRINT HOMESPEED(1)\n"
    assert answers("a.mnt", text, '"mint.homespeed-default" = 1000') == ["1000.0000"] * 2
    assert answers("a.mnt", text, "") == ["4000.0000"] * 2


@pytest.mark.parametrize(
    ("machine", "shown"),
    [
        ("", ["2.5000", "-0.1250", "3.000000e+12", "2.5000"]),
        ("mint.float-decimals = 2", ["2.50", "-0.12", "3.000000e+12", "2.50"]),
        ("mint.float-zeros = 'dropped'", ["2.5", "-0.125", "3.000000e+12", "2.5"]),
        ("mint.float-exponent = 'E+012'", ["2.5000", "-0.1250", "3.000000E+012", "2.5000"]),
    ],
)
def test_how_floats_are_printed(machine: str, shown: list[str]) -> None:
    """Str gives the same text as PRINT."""
    text = "PRINT 2.5\nPRINT -0.125\nPRINT 3e12\nPRINT Str(2.5)\n"
    assert answers("a.mnt", text, machine) == shown


def test_assumptions_of_a_board() -> None:
    text = "1TP\nAL0,IE1,AA1,AA2,AA4,TR0\nAL7,AD2,TR0\nJR99\nTE\nTE\n1TG\n"
    assert answers("a.mcl", text, "") == ["01 0", "4", "3", "?-1", "-1", "-1", "01 0.000000"]
    machine = """
        mccl.reply-form = "1234"
        mccl.skipped = 1
        mccl.quotient = "real"
        mccl.code-parameter = -40
        mccl.error-told = "cleared"
        mccl.gain-default = 12
    """
    assert answers("a.mcl", text, machine) == ["0", "6", "3.500000", "?-40", "-40", "0", "12.000000"]


@pytest.mark.parametrize(
    ("machine", "message", "hint"),
    [
        (
            '"mint.homesped-default" = 1',
            "no assumption mint.homesped-default",
            "mint.homespeed-default",
        ),
        ('"other.thing" = 1', "no assumption other.thing can be set", "docs/contributing/assumptions.md"),
        ('"mint.idletime-default" = 7.5', "must be a whole number, not 7.5", "motionlang probe"),
        ('"mint.idletime-default" = "x"', "must be a number, not 'x'", "motionlang probe"),
        ('"mint.idletime-default" = -1', "must be 0 to 60000, not -1", "motionlang probe"),
        ('"mint.float-zeros" = "gone"', "must be 'kept' or 'dropped', not 'gone'", "motionlang probe"),
        ('"mccl.skipped" = 7', "must be 2 or 1 or 3, not 7", "motionlang probe"),
    ],
)
def test_unknown_assumptions_and_alternatives_are_reported(machine: str, message: str, hint: str) -> None:
    with pytest.raises(ProgramError) as caught:
        read_machine(Source("m.toml", f"[assumptions]\n{machine}\n"))
    (found,) = caught.value.diagnostics
    assert message in found.message
    assert hint in found.hint
    assert (found.code, found.line) == ("machine-file", 2)

"""An error is answered with its code, in a file and at the port, and is isolated."""

from __future__ import annotations

import pytest

from motionlang.kernel import Keyword
from motionlang.kernel.mccl import MEANINGS, table
from tests.cases import cases
from tests.hosts.mccl.test_port import ask, board
from tests.mccl_runs import Runner

# The input, and the code in the answer.
CODES = {
    "an unknown command": ("1XX", 1),
    "a number alone": ("7", 2),
    "one letter": ("1M", 2),
    "two points in a number": ("1MR1.2.3", 2),
    "two commands without a comma": ("1MR10002MR5", 2),
    "a register without a number": ("1MR@", 2),
    "a text without an end": ('LU"STATUS', 2),
    "a text where a number belongs": ('1MR"far"', 2),
    "letters that are none of ours": ("1\xe4\xf6", 2),
    "too long a line": ("1TP," * 64, 4),
    "a value out of range": ("1SA-1", -1),
    "a number beyond all bounds": ("1MA1e400", -1),
    "no number": ("1MAnan", 2),
    "a register that there is not": ("TR256", -1),
    "an indirect register that there is not": ("AL@9999", -1),
    "a channel that there is not": ("CN0", -1),
    "a point that was not learned": ("1MP77", -1),
    "a division by zero": ("AL1,AD0", -1),
    "a jump out of the line": ("JP9", -1),
    "a task that there is not": ("ET9", -1),
    "a variable that there is not": ('LU"NOWHERE"', -1),
    "an unknown escape in a text": (r'OT"\q"', -1),
    "a move in the wrong mode": ("1MN,1VM,1MR5", -2),
    "an arc outside a path": ("1CA5", -2),
    "a code that is no byte": ("XN255,XF255,XN256", -1),
    "a code that is no byte either": ("XN0,XF0,XF256", -1),
    "a prompt that is no character": ("PC0,PC62,PC127", -1),
    "a negative repeat count": ("RP-1", -3),
    "MD within a line": ("1TP,MD1,1TP", -4),
    "too high a macro": ("MD1001,1TP", -5),
    "a macro below none": ("MC-1", -5),
    "a macro below none to define": ("MD-1,1TP", -5),
    "a macro that there is not": ("MC5", -6),
    "a macro that calls itself": ("MC91", -1),
    "no axis where one must be": ("WP100", -14),
    "an axis that there is not": ("99TP", -15),
    "a number of an axis beyond all bounds": ("9" * 200 + "TP", -15),
    "an axis that another one controls": ("1CM1,2CM1,2CM2", -16),
    "an axis twice in a path": ("1MN,2MN,1CM1,2CM1,1CP1,1MA5,2MA5,1MA6", -17),
}
BEFORE = "MD91,MC91"


@cases(
    "text, milliseconds",
    [
        ("NO\nCN33", 2),
        ("TR999\nCN33", 2),
        ("NO,TR999,NO\nNO,CN33", 4),
        ("MD1,NO,BK,NO\nMC1,NO\nCN33", 6),
        ("MD1,TR999\nMC1,NO\nCN33", 4),
        ("WA0.005,TR999\nCN33", 8),
    ],
)
def test_the_line_after_an_error_takes_its_time(text: str, milliseconds: int, mccl: Runner) -> None:
    """Each command takes a millisecond before it acts.

    An error leaves the line and all macros, and BK its macro.
    """
    (switched,) = mccl(text, machine={"controller.instruction_time": 1e-3}).controller.log.outputs
    assert switched.time == pytest.approx(milliseconds / 1000.0)


@cases("what", CODES)
def test_in_a_file(what: str, mccl: Runner) -> None:
    text, code = CODES[what]
    result = mccl(f"{BEFORE}\n{text}\nTE\nAL5,TR0")
    assert result.output[-3:] == [f"?{code}", str(code), "5"]
    (found,) = [each for each in result.diagnostics if each.severity == "error"]
    assert found.message
    assert found.line == (1 if what == "a macro that calls itself" else 2)


@cases("what", CODES)
def test_at_the_port(what: str) -> None:
    text, code = CODES[what]
    console, port = board()
    ask(console, port, BEFORE.encode() + b"\r")
    assert ask(console, port, text.encode("latin-1") + b"\r").split(b"\n")[-2:] == [b"?%d" % code, b">"]
    assert ask(console, port, b"TE\r") == b"%d\n>" % code
    assert ask(console, port, b"AL5,TR0\r") == b"5\n>"


def test_the_codes_that_are_not_a_commands() -> None:
    """0 before any error and -7 after ESC; another test covers 3.

    That is `test_an_error_of_our_own_costs_one_line`.
    """
    console, port = board()
    assert ask(console, port, b"TE\r") == b"0\n>"
    port.feed(b"WA100\r")
    console.run(1.0)
    assert ask(console, port, b"\x1b") == b"?-7\n>"
    assert ask(console, port, b"TE\r") == b"-7\n>"


def test_every_documented_code_has_a_case() -> None:
    cases = {code for _, code in CODES.values()}
    assert set(MEANINGS) == cases | {0, 3, -7}


def test_half_a_line_waits_for_its_other_half() -> None:
    console, port = board()
    assert ask(console, port, b"AL1,T") == b""
    console.run(10.0)
    assert ask(console, port, b"R0\r") == b"1\n>"


def test_control_characters_that_mean_nothing_are_nothing() -> None:
    console, port = board()
    assert ask(console, port, b"1\x00T\x07\x1f\x05P\r") == b"01 0\n>"


def test_escape_sequences_of_a_terminal_clear_the_line_and_are_answered() -> None:
    """An arrow key is ESC [ A: the line is cleared, and the rest is no command."""
    console, port = board()
    assert ask(console, port, b"1TP\x1b[A\r") == b"\n>?2\n>"
    assert ask(console, port, b"1TP\r") == b"01 0\n>"


def test_a_macro_that_jumps_to_itself_is_ended_by_escape() -> None:
    console, port = board()
    ask(console, port, b"MD1,AA1,MJ1\r")
    port.feed(b"MJ1\r")
    console.run(0.1)
    assert port.busy
    assert ask(console, port, b"\x1b") == b"?-7\n>"
    assert int(ask(console, port, b"TR0\r").split(b"\n")[0]) > 100


def test_rp_inside_rp(mccl: Runner) -> None:
    """Each RP of a line has its own count, which restarts when another RP repeats it.

    An RP in a macro has its own count, too.
    """
    assert mccl("AA1,RP2,AA10,RP1,TR0").output == ["26"]
    assert mccl("MD1,AA1,RP2\nMC1,AA10,RP1,TR0").output == ["26"]


def test_a_task_that_ends_itself(mccl: Runner) -> None:
    result = mccl("MD1,WA0.01,AL7,AR20,ET@30,AL8,AR20\nGT1,AR30,WA0.1,TR20,TR30\nET@30\nGT1,AR30,TR0")
    assert result.output == ["7", "1", "?-1", "2"]


def test_a_new_zero_in_the_last_moment_of_a_move_does_not_hold_the_run(mccl: Runner) -> None:
    """Found by random programs: the rest of the move ended slightly before its event."""
    text = 'MN\nMR1,1VM33,2JV"%5.2f"\n1AM5\n1OO,SV90,2TV1000,TP"%d"\n1XN90,1YF100,2CP-1\n1DH5'
    result = mccl(text, machine={"axis.1.motor": "stepper"})
    assert result.status == "ended"
    assert result.time < 0.01


def test_a_macro_that_is_redefined_while_it_runs_goes_on_as_it_was(mccl: Runner) -> None:
    assert mccl("MD1,WA0.1,AL1,AR20\nGT1\nMD1,AL2,AR20\nWA0.2,TR20,MC1,TR20").output == ["1", "2"]


@pytest.mark.slow
@cases("row", list(table()), ids=lambda row: row.name)
def test_no_number_that_is_sent_with_a_command_breaks_anything(row: Keyword, mccl: Runner) -> None:
    numbers = (
        "-1",
        "0",
        "1",
        "2147483648",
        "-99999999999999999999",
        "1e15",
        "1e-300",
        "0.5",
        "@0",
        "@999999999",
        '"\\"',
    )
    lines = [f"{axis}{row.name}{number}" for axis in ("", "1", "9") for number in numbers]
    result = mccl("\n".join(["1MN", *lines, "ESC", "AL5,TR0"]), until=5.0)
    assert result.status in ("ended", "until", "fault")
    assert result.status != "ended" or result.output[-1] == "5"

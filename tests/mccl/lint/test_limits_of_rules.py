"""Diagnostics at the limits of their rules: code, line and column, or none."""

from __future__ import annotations

from motionlang.mccl import DIALECT as MCCL
from motionlang.source import Source
from tests.cases import cases

Found = list[tuple[str, int, int]]


def found(text: str) -> Found:
    """Return code, line and column of each diagnostic."""
    return [(each.code, each.line, each.column) for each in MCCL.check(Source("limits.mcl", text), {})]


@cases(
    "text, expected",
    [
        ("AL1,RP\nTR0", [("endless-loop", 1, 5), ("unreachable", 2, 1)]),
        ("AL1,WA1,RP0,TR0", [("unreachable", 1, 13)]),
        ("AL1,WA1,RP1,TR0", []),
        ("AL5,JP2,AL6", []),
        ("AL5,JP3,AL6,TR0", [("unreachable", 1, 9)]),
        ("AL5,JP3,NO,TR0", []),
        ("AL5,JR2,AL6,TR0", [("unreachable", 1, 9)]),
        ("AL5,JP4,AL6,TR0", [("unreachable", 1, 9)]),
        ("IB5,JP4,NO,AL7", []),
        ("IB5,JP4,AL6,AL7", [("unreachable", 1, 9)]),
        ("IB5,BK,NO,AL7", []),
        ("DN5,BK,AL1", [("unreachable", 1, 8)]),
        ("AL1,BK,AL2,AL3,AL4", [("unreachable", 1, 8)]),
        ("AL1,JP4,AL2,NO,AL3,BK,AL5", [("unreachable", 1, 9), ("unreachable", 1, 23)]),
        ("AL1,BK,AL2,NO,AL3", [("unreachable", 1, 8)]),
        ("AL1,JP4,AL2,AL6,AL3,BK,AL5", [("unreachable", 1, 9), ("unreachable", 1, 24)]),
        ("MD1,AL5,JP3,AL6,TR0", [("unreachable", 1, 13)]),
        ("MD1,WA1,JP0,TR0", [("unreachable", 1, 13)]),
        ("JP@5,AL1,AL2", []),
        ("JP@5,BK,AL1", []),
        ("JP@5,BK,BK,AL1", []),
        ("JP@5,BK", []),
        ("AL1,JR0,TR0", [("endless-loop", 1, 5), ("unreachable", 1, 9)]),
        ("JP0", [("endless-loop", 1, 1)]),
        ("MD1,JP0", [("endless-loop", 1, 5)]),
        ("MD1,AL1,JR0", [("endless-loop", 1, 9)]),
        ("AL1,WA1,JR0", [("endless-loop", 1, 9)]),
        ("MD1,1MN,1MR5,MJ1", [("never-waits", 1, 9)]),
        ("MD1,1MN,1MR5,MJ2\nMD2,TR0", []),
        ("MD1,AL1\nMJ1\nTR0", []),
    ],
)  # fmt: skip
def test_commands_that_never_run_and_loops_that_never_end(text: str, expected: Found) -> None:
    """Jumps count from the first command of the line or macro, JR from itself.

    NO is only padding.
    """
    assert found(text) == expected


@cases(
    "name, value, text, usual",
    [
        ("jump-base", 1, "AL5,JP3,AL6,TR0", "this command can never run: JP3 always jumps elsewhere"),
        ("jump-base", 1, "AL5,JP3", "there is no command 3 here (?-1: command parameter error)"),
        ("jump-relative", "next", "AL5,WA1,JR0", "JR0 jumps to itself forever"),
        ("skipped", 3, "IE5,NO,JR3,BK,TR0,AL1", "this command can never run: BK always jumps elsewhere"),
        ("repeat-for-ever", "once", "AL1,WA1,RP\nAL2", "this line can never run: the line before repeats forever"),
    ],
)  # fmt: skip
def test_the_flow_of_a_board_that_counts_otherwise(name: str, value: object, text: str, usual: str) -> None:
    source = Source("limits.mcl", text)
    assert usual in [each.message for each in MCCL.check(source, {})]
    assert usual not in [each.message for each in MCCL.check(source, {f"assumptions.mccl.{name}": value})]


@cases(
    "text, message",
    [
        ("AL1,WA1,RP0,AL2", "this command can never run: RP0 repeats the commands before it forever"),
        ("AL1,WA1,RP,AL2", "this command can never run: RP repeats the commands before it forever"),
        ("AL5,JP3,AL6,TR0", "this command can never run: JP3 always jumps elsewhere"),
        ("IB5,RP1,NO,JR2,AL6,TR0", "this command can never run: JR2 always jumps elsewhere"),
        ("MD1,WA1,MJ1,AL6", "this command can never run: MJ1 always jumps elsewhere"),
        ("AL1,BK,AL2", "this command can never run: BK always jumps elsewhere"),
        ("WA1,RP\nAL2", "this line can never run: the line before repeats forever"),
    ],
)
def test_why_a_command_never_runs(text: str, message: str) -> None:
    """The reason is the nearest command before it that jumps."""
    assert [each.message for each in MCCL.check(Source("limits.mcl", text), {})] == [message]


@cases(
    "text, expected",
    [
        ("1WS", [("nothing-to-wait-for", 1, 1)]),
        ("WS", [("nothing-to-wait-for", 1, 1)]),
        ("1WT", [("nothing-to-wait-for", 1, 1)]),
        ("2MN,2MR5,1WS", [("nothing-to-wait-for", 1, 10)]),
        ("2MN,2MR5,WS", []),
        ("MN,MR5,1WS", []),
        ("1MN,1WS,1MR5,RP3", []),
        ("1MN,1WS,1MR5", [("nothing-to-wait-for", 1, 5)]),
        ("MD1,1MR5\n1MN,MC1,1WS", []),
        ("MD1,MC1\nMC1,1WS", [("nothing-to-wait-for", 2, 5)]),
        ("MD1,MC2\nMD2,1MN,1MR5\nMC1,1WS", []),
        ("MC9,1WS", [("unknown-word", 1, 1)]),
        ("MC@5,1WS", []),
    ],
)  # fmt: skip
def test_waits_before_any_motion(text: str, expected: Found) -> None:
    """A macro that the file does not define may move any axis.

    So may a line that repeats.
    """
    assert found(text) == expected


@cases(
    "text, expected",
    [
        ("1MN,1GO", [("nothing-loaded", 1, 5)]),
        ("1MN,2MN,2VM,1GO", [("nothing-loaded", 1, 13)]),
        ("MN,VM,1GO", []),
        ("MN,GO", [("nothing-loaded", 1, 4)]),
        ("1MN,1VM,GO", []),
        ("1MN,1CM1,1GO", []),
        ("1MR5,2MR5,1MR5", [("motor-off", 1, 1), ("motor-off", 1, 6)]),
        ("2MN,1MR5,2MR5", [("motor-off", 1, 5)]),
        ("2MN,MR5", []),
        ("MR5", [("motor-off", 1, 1)]),
    ],
)  # fmt: skip
def test_motors_and_modes(text: str, expected: Found) -> None:
    """Once for each axis that no line switches on; GO needs a mode."""
    assert found(text) == expected


@cases(
    "text, expected",
    [
        ("MN,3MR5", []),
        ("JP4,AL1,AL2,AL3", [("unreachable", 1, 5)]),
        ("JP5,AL1,AL2,AL3", [("range", 1, 1)]),
        ("JR4,AL1,AL2,AL3", [("unreachable", 1, 5)]),
        ("JR5,AL1,AL2,AL3", [("range", 1, 1)]),
        ("AL1,JR-1,WA1", [("endless-loop", 1, 5), ("unreachable", 1, 10)]),
        ("AL1,JR-2,WA1", [("range", 1, 5)]),
        ("MD1,AL1,JP2", []),
        ("MD1,AL1,JP3", [("range", 1, 9)]),
        ("MD1,AL1,WA1,JR-2", []),
        ("MD1,AL1,WA1,JR-3", [("range", 1, 13)]),
        ("MD1,AL1,JR1", []),
        ("MD1,AL1,JR2", [("range", 1, 9)]),
        ("AL1,MD1", [("syntax", 1, 5)]),
        ("MD1000,AL1", []),
        ("MD1001,AL1", [("range", 1, 1)]),
        ("AL1,RP-1", [("range", 1, 5)]),
        ("AL1,RP1", []),
        ("WP5", [("axis", 1, 1)]),
        ("00WP5", [("axis", 1, 1)]),
    ],
)  # fmt: skip
def test_numbers_out_of_range(text: str, expected: Found) -> None:
    """Axes 1 to 8, macros 0 to 1000; a jump may lead to the end of the line."""
    assert found(text) == expected


@cases(
    "text, expected",
    [
        ("8TP", []),
        ("9TP", [("axis", 1, 1)]),
        ("1MN,1MR1000,1WR1000", []),
        ("1MN,1MR1000,1WR1001", [("endless-wait", 1, 13)]),
        ("1MN,1MR-1000,1WR1001", [("endless-wait", 1, 14)]),
        ("1MN,1MR1000,1WR-1001", [("endless-wait", 1, 13)]),
        ("1MN,1MR1000,1MR500,1WR1200", []),
        ("1MN,1MR1000,1WS,1MR500,1WR600", [("endless-wait", 1, 24)]),
        ("1MN,1MR1000,1MN,1WR1001", [("endless-wait", 1, 17)]),
        ("1MN,1MR1000,1ST,1WR1001", []),
        ("1MN,1MR1000,2ST,1WR1001", [("endless-wait", 1, 17)]),
        ("1MN,1MA1000,1WR1001", []),
        ("1MN,1MR0.5,1WR1", [("endless-wait", 1, 12)]),
        ("1MN,1VM,1GO,1WS", [("still-running", 1, 13)]),
        ("1MN,1VM,1GO,1ST,1WS", []),
        ("1MN,1VM,1GO,2ST,1WS", [("still-running", 1, 17)]),
        ("1MN,1VM,1GO,ST,1WS", []),
        ("1MN,1VM,1PM,1GO,1WS", []),
        ("1MN,1PS,1VM,1GO,1PM,1MA5", [("still-running", 1, 21)]),
        ("1MN,1PS,1VM,1GO,1PM,1MA5,1MA6,1WS", [("still-running", 1, 21)]),  # once for an axis
    ],
)  # fmt: skip
def test_axes_that_run_and_moves_that_are_too_short(text: str, expected: Found) -> None:
    """ST, MA and a second MR make the distance unknown; MN does not."""
    assert found(text) == expected


@cases(
    "text, expected",
    [
        ("1MN,1PS,1PT,1VM,1GO,1PM,1MA5", []),
        ("1MN,1VM,1GO,1WS,1WS", [("still-running", 1, 13)]),
        ("1MN,1VM,1GO\nJR1\n1WS", []),
        ("CN32", [("wrong-channel", 1, 1)]),
        ("CN33", []),
        ("CN48", []),
        ("CN49", [("wrong-channel", 1, 1)]),
    ],
)  # fmt: skip
def test_channels(text: str, expected: Found) -> None:
    """Channels 33 to 48 are outputs at power-up."""
    assert found(text) == expected


@cases(
    "text, expected",
    [
        ("CT32,CN32", []),
        ("CT@5,CN32", []),
        ("CN@5", []),
        ("WN1", []),
        ('LU"POSITION",1RL@0,IE5,BK,NO,JR-4', [("exact-position", 1, 20)]),
        ('LU"POSITION",1RL@0,IE5,BK,NO', []),
        ('LU"STATUS",1RL@0,IE5,BK,NO,WA1,JR-5', []),
        ('LU"POSITION",AR5\nAL1,1RL@5,IU5,JR-2', [("exact-position", 2, 11)]),
    ],
)  # fmt: skip
def test_positions_compared_for_equality(text: str, expected: Found) -> None:
    """The name comes from LU and moves with AR; a loop is needed."""
    assert found(text) == expected


# The text, and severity, message and hint of its only diagnostic. A warning has no code of the controller.
TEXTS: list[tuple[str, str, str, str]] = [
    ("1MN,1VM,1GO,1WS", "warning", "1WS never ends: axis 1 runs in velocity mode until it is stopped", "1ST first"),
    (
        "1MN,1PS,1VM,1GO,1PM,1MA5", "warning", "1MA5 is rejected: axis 1 still runs in velocity mode",
        "with S-curve, a move starts at rest: 1ST,1WS first, or 1PT for a trapezoid",
    ),
    (
        "2MN,2MR0.5,2WR1", "warning", "2WR1 never ends: axis 2 moves only 0.5",
        "wait for less, or for the end of the move with 2WS",
    ),
    (
        "AL1,RP", "warning", "RP repeats the line forever, without a wait or an exit",
        "add WA0.1 before it, or end after ten repetitions with RP10",
    ),
    ("JP0", "warning", "JP0 jumps to itself forever", "jump to another command"),
    ("MD1,1MN,1MR5,MJ1", "warning", "MJ repeats 1MR5 without waiting for its end", "add 1WS after it"),
    ("AL5,BK,TR0", "warning", "this command can never run: BK always jumps elsewhere", ""),
    (
        "CN32", "warning", "channel 32 is an input on this board: CN32 is rejected",
        "CT32 makes it an output; 33 to 48 are outputs at power-up",
    ),
    ("MC5", "warning", "no line of this file defines macro 5", "MD5,... defines it"),
    ("MD1001,NO", "error", "macros are numbered 0 to 1000, not 1001 (?-5: macro number out of range)", ""),
    ("AL1,JP9", "error", "there is no command 9 here (?-1: command parameter error)", "they are numbered 0 to 1"),
    ("WP5", "error", "WP needs an axis number in front (?-14: no axis specified)", "such as 1WP5"),
    ("99TP", "error", "there is no axis 99 (?-15: axis not assigned)", "the axes are 1 to 8"),
    (
        "1TP,MD1", "error",
        "MD must be the first command of its line (?-4: macro define command not first)",
        "put it on a line of its own",
    ),
]  # fmt: skip


@cases("text, severity, message, hint", TEXTS)
def test_the_text_of_a_diagnostic(text: str, severity: str, message: str, hint: str) -> None:
    (found,) = MCCL.check(Source("limits.mcl", text), {})
    assert (found.severity, found.message, found.hint) == (severity, message, hint)

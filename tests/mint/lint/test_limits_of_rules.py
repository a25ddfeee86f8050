"""Diagnostics of Mint at the limits of their rules: code, line and column."""

from __future__ import annotations

from motionlang.mint import DIALECT as MINT
from motionlang.source import Source
from tests.cases import cases


def on(model: str, text: str) -> list[tuple[int, str, str]]:
    """Return line, message and hint of what does not fit the controller model."""
    found = MINT.check(Source("limits.mnt", text), {"controller.model": model})
    return [(each.line, each.message, each.hint) for each in found if each.code == "model"]


@cases(
    "text, brackets, hint",
    [
        ("SPEED(1) = 5", "SPEED(1)", "write SPEED.1"),
        ("SPEED(n) = 5", "SPEED(n)", "write SPEED.n"),
        ("SPEED(a(1)) = 5", "SPEED(…)", "write SPEED.…"),
        ("SPEED(n + 1) = 5", "SPEED(…)", "write SPEED.…"),
        ("SPEED(0, n) = 5", "SPEED(0, n)", "write SPEED[0, n]"),
        ("SPEED(-1) = 5", "SPEED(…)", "write SPEED.…"),
    ],
)
def test_brackets_that_mint_v4_writes_with_a_dot(text: str, brackets: str, hint: str) -> None:
    """The message repeats numbers and names; anything longer is an ellipsis."""
    found = on("mint4", f"n = 1\nDim a(3)\n{text}")
    assert found == [(3, f"{brackets} is MintMT: it does not compile on Mint v4", hint)]


@cases(
    "text, expected",
    [
        ("Dim a As Integer\nDim b As Float", [(1, "As"), (2, "As")]),
        ("Dim a As Integer : Dim b As Float", [(1, "As"), (1, "As")]),
        ("Const a As Float = 1 : Dim b As Float", [(1, "Const"), (1, "As")]),
        ("If 1 Then\nPRINT 1\nEnd If", [(1, "Then at the end of a line"), (3, "End If")]),
        ("While 1\nEnd While\nLoop\nEnd Loop", [(2, "End While"), (4, "End Loop")]),
        ("If 1 Then PRINT 1\nIf 1 DO\nEnd\nENDIF", []),
    ],
)
def test_tokens_that_mint_v4_lacks(text: str, expected: list[tuple[int, str]]) -> None:
    """A declaration with a type is one finding, and so are the two words of a closer."""
    end = " is MintMT: it does not compile on Mint v4"
    assert [(line, what.removesuffix(end)) for line, what, _ in on("mint4", text)] == expected


@cases(
    "text, fixes",
    [
        ("IF a DO\nELSE IF b DO\nPRINT 1\nENDIF", ["Then", "Then", "End If"]),
        ("IF a DO PRINT 1\nENDIF", ["Then\n ", "End If"]),
        ("IF a DO\n  IF b DO PRINT 1\n  ENDIF\nENDIF", ["Then", "Then\n   ", "End If", "End If"]),
        ("IF a DO\nELSE IF b DO PRINT 1\nENDIF", ["Then", "Then", "End If"]),
        ("x = a%b", [" Mod "]),
    ],
)
def test_the_fixes_of_a_program_for_mint_v4(text: str, fixes: list[str]) -> None:
    """Then begins a block at the end of a line only; behind Else If it needs none."""
    found = MINT.check(Source("limits.mnt", text), {"controller.model": "mintmt"})
    assert [each.fix for each in found if each.code == "model"] == fixes


EVENTS = ("COMMS0", "COMMS1", "COMMS5", "COMMS6", "COMMS10", "COMMS11", "NETDATA0", "NETDATA31", "NETDATA32")


@cases(
    "model, comms, netdata",
    [
        ("NextMove ESB-2", "those of 1 to 5 do", "it has no NETDATA events"),
        ("MicroFlex e150", "it has no COMMS events", "those of 0 to 31 do"),
        ("NextMove e100", "those of 1 to 10 do", "those of 0 to 31 do"),
    ],
)
def test_handlers_of_host_writes_that_a_product_never_reports(model: str, comms: str, netdata: str) -> None:
    """A handler is reported if its number is outside the range that the hint states."""
    known = {"COMMS": comms, "NETDATA": netdata}
    expected = []
    for line, event in enumerate(EVENTS, 2):
        kind = event.rstrip("0123456789")
        words = known[kind].split()
        reported = range(int(words[2]), int(words[4]) + 1) if words[0] == "those" else range(0)
        if int(event.removeprefix(kind)) not in reported:
            expected.append((line, f"{event} never comes on the {model}", known[kind]))
    handlers = "".join(f"Event {event} : End Event\n" for event in (*EVENTS, "IN1", "TIMER", "COMMS"))
    assert on(model, f"WAIT = 1 : End\n{handlers}") == expected


Found = list[tuple[str, int, int]]
# Only input 2 is driven.
ONE_INPUT: dict[str, object] = {"input": [{"channel": 2, "at": 1.0}]}


def found(text: str, settings: dict[str, object] | None = None) -> Found:
    """Return code, line and column of each diagnostic, except for `no-value`."""
    every = MINT.check(Source("limits.mnt", text), settings or {})
    return [(each.code, each.line, each.column) for each in every if each.code != "no-value"]


@cases(
    "text, expected",
    [
        ("PAUSE INX(1)", [("endless-wait", 1, 1)]),
        ("PAUSE INX(2)", []),
        ("PAUSE INX(n)\nn = 2", []),
        ("PAUSE IN(0) > 0", []),
        ("PAUSE ADC(1) > 5", []),
        ("PAUSE INX(1) Or INX(2)", []),
        ("PAUSE INX(1) = _on", [("endless-wait", 1, 1)]),
        ("PAUSE INSTATEX(1)", [("endless-wait", 1, 1)]),
        ("Define door = INX(1)\nPAUSE door", [("endless-wait", 2, 1)]),
        ("Define door = INX(2)\nPAUSE door", []),
        ("While INX(1)\nWAIT = 1\nWend", [("endless-wait", 1, 7)]),
        ("While INX(2)\nWAIT = 1\nWend", []),
        ("While IN(0)\nWAIT = 1\nWend", []),
        ("Repeat\nWAIT = 1\nUntil INX(3)", [("endless-wait", 3, 7)]),
        ("While Not INX(1)\nWAIT = 1\nIf INX(2) Then Exit While\nWend", []),
        ("While INX(1) Or n\nn = 0\nWAIT = 1\nWend", []),
        ("While INX(1) Or POS(0) > 5\nWAIT = 1\nWend", []),
    ],
)
def test_waits_for_an_input_that_nothing_drives(text: str, expected: Found) -> None:
    """The machine file drives input 2 alone."""
    assert found(text, ONE_INPUT) == expected


@cases(
    "text, expected",
    [
        ("PAUSE POS(0) > 5", [("endless-wait", 1, 1)]),
        ("MOVER(0) = 5 : GO(0) : PAUSE POS(0) > 5", []),
        ("MOVER(1) = 5 : GO(1)\nPAUSE POS(0) > 1", [("endless-wait", 2, 1)]),
        ("PAUSE POS(n) > 5\nn = 1", []),
        ("PAUSE Abs(POS(0)) > 5", [("endless-wait", 1, 1)]),
        ("PAUSE VEL(0) > 5 Or INX(1)", []),
        ("PAUSE COMMS(1) = 5", []),
        ("PAUSE TIME > 5", []),
        ("PAUSE Rnd > 5", []),
        ("Dim flag\nPAUSE flag = 1", [("endless-wait", 2, 1)]),
        ("Const k = 5\nDim flag\nPAUSE flag = k", [("endless-wait", 3, 1)]),
        ("Dim a(3)\nPAUSE a(1) = 1", [("endless-wait", 2, 1)]),
        ("Dim began As Time\nPAUSE began > 500", []),
        ("Dim flag\nRun t\nPAUSE flag = 1\nEnd\nTask t\nflag = 1\nEnd Task", []),
        ("Dim flag\nPAUSE flag\nEnd\nEvent IN1\nflag = 1\nEnd Event", []),
        ("Dim flag\nf(flag)\nEnd\nSub f(ByRef x)\nPAUSE x = 1\nEnd Sub", []),
        ("Dim flag\nf(flag)\nEnd\nSub f(x)\nPAUSE x = 1\nEnd Sub", [("endless-wait", 5, 1)]),
        ("Dim flag\nf()\nEnd\nSub f()\nPAUSE flag = 1\nEnd Sub", [("endless-wait", 5, 1)]),
        ("Dim flag\nf()\nRun t\nEnd\nSub f()\nPAUSE flag = 1\nEnd Sub\nTask t\nf()\nEnd Task", []),
    ],
)
def test_waits_for_a_condition_that_cannot_change(text: str, expected: Found) -> None:
    """An axis at rest, or a variable that no other task and no handler changes.

    A sub that two tasks run may wait for either of them.
    """
    assert found(text) == expected


TWICE = "Run t\nf()\nEnd\nTask t\nf()\nEnd Task\nSub f()\n{}\nEnd Sub"
CALL = "f()\nEnd\nSub f()\n{}\nEnd Sub\nSub g()\n{}\nEnd Sub"


@cases(
    "text, expected",
    [
        ("Dim flag\nWhile flag = 0\nWAIT = 1\nWend", [("endless-loop", 2, 1)]),
        ("Dim flag\nRepeat\nWAIT = 1\nUntil flag", [("endless-loop", 2, 1)]),
        ("Const k = 5\nDim n\nWhile n < k\nWAIT = 1\nWend", [("endless-loop", 3, 1)]),
        ("Dim n\nWhile Abs(n) < 5\nWAIT = 1\nWend", [("endless-loop", 2, 1)]),
        ("Dim n\nWhile Rnd < n\nWAIT = 1\nWend", []),
        ("Dim n As Time\nWhile n < 500\nWAIT = 1\nWend", []),
        ("While _true\nWAIT = 1\nWend", []),
        ("Dim flag\nWhile flag = 0\nWAIT = 1\nflag = 1\nWend", []),
        ("Dim flag\nWhile flag = 0\nWAIT = 1\nIf INX(1) Then Exit While\nWend", []),
        ("Dim flag\nWhile flag = 0\nWAIT = 1\nIf INX(1) Then End\nWend", []),
        ("Dim flag\nRun t\nWhile flag = 0\nWAIT = 1\nWend\nEnd\nTask t\nflag = 1\nEnd Task", []),
        ("Dim flag\n" + CALL.format("While flag = 0\ng()\nWend", "flag = 1"), []),
        ("Dim flag\n" + CALL.format("While flag = 0\ng()\nWend", "PRINT 1"), []),
        (CALL.format("Dim flag\nWhile flag = 0\ng()\nWend", "PRINT 1"), [("endless-loop", 5, 1)]),
        ("Dim flag\nWhile flag = 0\nf()\nWend\nEnd\nSub f()\nPRINT 1\nEnd Sub", [("endless-loop", 2, 1)]),
        ("Dim flag\nWhile flag = 0\nf()\nWend\nEnd\nSub f()\nflag = 1\nEnd Sub", []),
        (TWICE.format("Dim n\nWhile n = 0\nWAIT 1\nWend\nn = 1"), []),
    ],
)
def test_loops_whose_condition_cannot_change(text: str, expected: Found) -> None:
    """Nothing in the loop, a task or a handler writes what the condition reads.

    If a sub calls another one in its loop, variables of the program count as changed.
    """
    assert found(text) == expected


@cases(
    "condition, column, effect",
    [
        ("INX(1) And 0", 15, "so the condition is always false"),
        ("INX(1) And 1", 15, "so it changes nothing"),
        ("INX(1) Or 0", 14, "so it changes nothing"),
        ("INX(1) Or 1", 14, "so the condition is always true"),
        ("5 Or INX(1)", 4, "so the condition is always true"),
        ("5 And INX(1)", 4, "so it changes nothing"),
        ("0 And INX(1)", 4, "so the condition is always false"),
        ("Not (INX(1) And 0)", 20, "so the condition is always false"),
        ("INX(1) Or -1", 0, ""),
    ],
)
def test_a_number_on_its_own_in_a_condition(condition: str, column: int, effect: str) -> None:
    every = MINT.check(Source("limits.mnt", f"If {condition} Then PRINT 1"))
    reported = [(each.column, each.message.partition("own, ")[2]) for each in every]
    assert reported == ([(column, effect)] if effect else [])


MOVE = "POS(0) = 0\nMOVEA(0) = 5\nGO(0)\n"
NEXT = "PAUSE IDLE(0)\nMOVER(0) = 6\nGO(0)\n"


@cases(
    "text, expected",
    [
        (MOVE + "PAUSE POS(0) >= 5", []),
        (MOVE + "PAUSE POS(0) > 5.25", []),
        (MOVE + "PAUSE POS(0) > 5.26", [("endless-wait", 4, 1)]),
        (MOVE + "PAUSE POS(0) < -0.25", []),
        (MOVE + "PAUSE POS(0) < -0.26", [("endless-wait", 4, 1)]),
        (MOVE + "PAUSE POS(0) = 7", [("endless-wait", 4, 1)]),
        (MOVE + "PAUSE 7 = POS(0)", [("endless-wait", 4, 1)]),
        (MOVE + "PAUSE 10 < POS(0)", [("endless-wait", 4, 1)]),
        (MOVE + "PAUSE 10 > POS(0)", []),
        (MOVE + "PAUSE Not POS(0) < 10", [("endless-wait", 4, 1)]),
        (MOVE + "PAUSE Not POS(0) > 10", []),
        (MOVE + "PAUSE POS(0) > 10 And INX(1)", [("endless-wait", 4, 1)]),
        (MOVE + "PAUSE INX(1) And POS(0) > 10", [("endless-wait", 4, 1)]),
        (MOVE + "PAUSE POS(0) > 10 Or INX(1)", []),
        (MOVE + "PAUSE POS(0) > 10 Or POS(0) < -10", [("endless-wait", 4, 1)]),
        (MOVE + NEXT + "PAUSE POS(0) > 11", []),
        (MOVE + NEXT + "PAUSE POS(0) > 12", [("endless-wait", 7, 1)]),
        ("POS(0) = 0\nSCALE(0) = 2\nMOVEA(0) = 5\nGO(0)\nPAUSE POS(0) > 10", [("endless-wait", 5, 1)]),
        ("POS(0) = 1\nSCALE(0) = 2\nMOVEA(0) = 5\nGO(0)\nPAUSE POS(0) > 10", []),
        (MOVE + "PAUSE IDLE(0)\nSCALE(0) = 2\nMOVEA(0) = 6\nGO(0)\nPAUSE POS(0) > 20", []),
        ("POS(0) = 0\nJOG(0) = 5\nSTOP(0)\nPAUSE IDLE(0)\nMOVEA(0) = 5\nGO(0)\nPAUSE POS(0) > 10", []),
        (MOVE + "While POS(0) < 10\nWAIT = 1\nWend", [("endless-wait", 4, 7)]),
        (MOVE + "While POS(0) < 5\nWAIT = 1\nWend", []),
        (MOVE + "Repeat\nWAIT = 1\nUntil POS(0) > 10", [("endless-wait", 6, 7)]),
        (MOVE + "While POS(0) < 10\nSTOP(0)\nWend", []),
        (MOVE + "While POS(0) < 10\nSPEED(0) = 5\nWend", [("endless-wait", 4, 7)]),
        (MOVE + "While POS(0) < 10\nf()\nWend\nEnd\nSub f()\nPRINT 1\nEnd Sub", []),
        ("POS(0) = 100\nMOVEA(0) = 105\nGO(0)\nPAUSE POS(0) > 105.26", [("endless-wait", 4, 1)]),
        ("POS(0) = 100\nMOVEA(0) = 105\nGO(0)\nPAUSE POS(0) > 105.25", []),
        ("JOG(0) = 0\nWhile POS(0) <> 5\nSTOP(0)\nWend", [("exact-position", 2, 7)]),
        ("JOG(0) = 0\nWhile POS(0) = 5\nSTOP(0)\nWend", []),
        ("JOG(0) = 0\nRepeat\nSTOP(0)\nUntil POS(0) = 5", [("exact-position", 4, 7)]),
        ("JOG(0) = 0\nPAUSE POS(0) = 5", [("exact-position", 2, 7)]),
        ("JOG(0) = 0\nPAUSE POS(0) <> 5", []),
        ("JOG(0) = 0\nIf POS(0) = 5 Then PRINT 1", []),
        ("End\nPAUSE INX(1)", [("unreachable", 2, 1)]),
        (MOVE + "While POS(0) < 10\nIf INX(1) Then Exit While\nWend", []),
        ("JOG(0) = 5\nPAUSE IDLE(0)", [("endless-wait", 2, 1)]),
        ("JOG(0) = 5\nPAUSE IDLE(0) = 1", [("endless-wait", 2, 1)]),
        ("JOG(0) = 5\nPAUSE IDLE(0) <> 0", [("endless-wait", 2, 1)]),
        ("JOG(0) = 5\nPAUSE IDLE(0) = 0", []),
        ("JOG(0) = 5\nPAUSE Not IDLE(0)", []),
        ("JOG(0) = 0\nPAUSE IDLE(0)", []),
        ("JOG(0) = 5\nSTOP(0)\nPAUSE IDLE(0)", []),
        ("JOG(0) = 5\nPAUSE IDLE(1)", []),
    ],
)
def test_waits_for_a_position_that_no_move_reaches(text: str, expected: Found) -> None:
    """The axis moves between 0 and 5; 5 % of that is allowed beyond each end.

    A new scale keeps 0 alone.
    """
    assert found(text) == expected


def test_of_two_conditions_that_never_hold_the_first_is_explained() -> None:
    text = "MOVEA(0) = 5\nGO(0)\nJOG(1) = 5\nPAUSE POS(0) > 10 Or IDLE(1)"
    (wait,) = MINT.check(Source("limits.mnt", text), {})
    why = "this waits for a condition that cannot change: axis 0 moves between 0 and 5"
    assert (wait.message, wait.hint) == (why, "compare POS(0) with a position that a move reaches")


FUNCTION = "\nSub move({})\nMOVER(a) = 1\nGO(a)\n{}PRINT POS(a)\nEnd Sub"
SUB = "move(0)\nSub move(ByVal a As Integer)\n{}\nEnd Sub"


@cases(
    "text, expected",
    [
        ("Define a = SPEED(0)\na = 5\na = 6\nMOVER(0) = 1 : GO(0)", [("unused-setting", 1, 12)]),
        ("Define a = POS(0)\nMOVER(0) = 1 : GO(0)\na = 0", [("in-motion", 1, 12)]),
        ("Define a = POS(0) + POS(1)\nMOVER(1) = 1 : GO(1)\nPRINT a", [("in-motion", 1, 21)]),
        ("Dim n\nDefine m = n\nm = 5\nPRINT n", []),
        ("Dim flag\nDefine f = flag\nRun t\nPAUSE flag = 1\nEnd\nTask t\nf = 1\nEnd Task", []),
        ("SPEED(0, 1) = 0, 5\nMOVER(0, 1) = 5;\nGO(0, 1)", [("zero-speed", 2, 1)]),
        ("move(0)" + FUNCTION.format("ByVal a As Integer", ""), [("in-motion", 5, 7)]),
        ("move(0)" + FUNCTION.format("ByVal a As Integer", "a = 2\n"), []),
        ("move(0)" + FUNCTION.format("ByVal a As Integer", "MOVER(1) = 1\nGO(1)\n"), []),
        ("Dim n\nmove(n)" + FUNCTION.format("ByRef a", ""), []),
        (SUB.format("JOG(a) = 5\nPAUSE IDLE(a)"), [("endless-wait", 4, 1)]),
        (SUB.format("JOG(a) = 5\nJOG(1) = 5\nPAUSE IDLE(a)"), []),
        (SUB.format("If Not IDLE(a) Then\nSCALE(a) = 2\nEnd If"), [("scale-in-motion", 4, 1)]),
    ],
)
def test_the_axes_that_a_name_or_a_parameter_stands_for(text: str, expected: Found) -> None:
    """A parameter is a known axis if nothing can change it.

    It is passed by value, never assigned, and the only axis of its sub.
    """
    assert found(text) == expected


@cases(
    "text, line",
    [
        ("Dim n\nLoop\nn = n + 1\nEnd Loop", 2),
        ("Dim n\nLoop\nLoop\nn = n + 1\nEnd Loop\nEnd Loop", 3),
        ("Dim n\nLoop\nIf n > 3 Then Exit\nn = n + 1\nEnd Loop", 0),
        ("Dim n\nLoop\nIf n > 3 Then End\nn = n + 1\nEnd Loop", 0),
        ("Dim n\nLoop\nf()\nEnd Loop\nSub f()\nn = n + 1\nEnd Sub", 2),
        ("Dim n\nLoop\nf()\nEnd Loop\nSub f()\nIf n > 3 Then End\nn = n + 1\nEnd Sub", 0),
        ("Dim n\nLoop\nn = n + 1\nINPUT n\nEnd Loop", 0),
        ("Dim n\nLoop\nn = n + 1\nPAUSE n\nEnd Loop", 0),
    ],
)
def test_loops_that_compute_forever(text: str, line: int) -> None:
    """A sub that may end the program may end the loop; 0 means no report."""
    assert [each[1] for each in found(text) if each[0] == "busy-loop"] == ([line] if line else [])


@cases(
    "text, hint",
    [
        ("MOVEA(0) = 5\nGO(0)\nPAUSE POS(0) = 5", "PAUSE IDLE(0) waits for the end of the move"),
        ("MOVEA(0) = 5\nGO(0)\nPAUSE POS(0) = 3", "POS(0) >= 3 stays true from there on"),
        ("MOVEA(0) = -5\nGO(0)\nPAUSE POS(0) = -3", "POS(0) <= -3 stays true from there on"),
        ("MOVEA(0) = 5\nGO(0)\nPAUSE 3 = POS(0)", "POS(0) >= 3 stays true from there on"),
        ("MOVEA(0) = n\nGO(0)\nPAUSE POS(0) = 3\nn = 1", "compare it with >= 3 or <= 3, as the axis moves"),
        ("MOVEA(0) = 5\nGO(0)\nPAUSE POS(0) = n\nn = 1", "compare it with >= or <="),
        ("MOVEA(0) = 5\nGO(0)\nPAUSE POSDEMAND(0) = 3", "compare it with >= or <="),
        ("MOVEA(0) = 5\nGO(0)\nPAUSE VEL(0) = 3", ""),
        ("MOVEA(0) = 5\nGO(0)\nPAUSE IDLE(0)\nPAUSE POS(0) = 5", ""),
        ("MOVEA(0) = 5\nGO(0)\nPAUSE POS(0) >= 3", ""),
    ],
)
def test_hints_for_a_moving_position_that_is_compared_for_equality(text: str, hint: str) -> None:
    every = MINT.check(Source("limits.mnt", text), {})
    assert [each.hint for each in every if each.code == "exact-position"] == ([hint] if hint else [])


@cases(
    "text, fix, length",
    [
        ("WAIT = POS(0) > 5", "PAUSE", 6),
        ("Wait = IDLE(0) = 1", "Pause", 6),
        ("wait = Not IDLE(0)", "Pause", 6),
        ("WAIT=INX(1)", "PAUSE ", 5),
        ("WAIT(INX(1) And INX(2))", "PAUSE ", 4),
        ("PRINT 1 : WAIT = INX(1)", "PAUSE", 6),
        ("WAIT POS(0) > 5", "PAUSE", 4),
        ("WAIT = 5", "", 0),
        ("WAIT = n\nn = 5", "", 0),
        ("WAIT = ADC(1)", "", 0),
    ],
)
def test_a_wait_for_a_condition_becomes_a_pause(text: str, fix: str, length: int) -> None:
    """The fix replaces `WAIT =` up to the condition, in the spelling of the program."""
    every = [each for each in MINT.check(Source("limits.mnt", text), {}) if each.code == "wait-condition"]
    assert [(each.fix, each.length) for each in every] == ([(fix, length)] if fix else [])


LIMITS = "SOFTLIMITFORWARD(0) = 100\nSOFTLIMITREVERSE(0) = -10\n"


@cases(
    "text, expected",
    [
        (LIMITS + "MOVEA(0) = 100\nGO(0)", []),
        (LIMITS + "MOVEA(0) = 101\nGO(0)", [("beyond-travel", 3, 1)]),
        (LIMITS + "MOVEA(0) = -10\nGO(0)", []),
        (LIMITS + "MOVEA(0) = -11\nGO(0)", [("beyond-travel", 3, 1)]),
        (LIMITS + "MOVER(0) = 60\nMOVER(0) = 40\nGO(0)", []),
        (LIMITS + "SOFTLIMITMODE(0) = 0\nMOVEA(0) = 101\nGO(0)", []),
        (LIMITS + "n = 1\nSOFTLIMITMODE(n) = 0\nMOVEA(0) = 101\nGO(0)", []),
        (LIMITS + "SOFTLIMITMODE(1) = 0\nMOVEA(0) = 101\nGO(0)", [("beyond-travel", 4, 1)]),
        (LIMITS + "MOVER(0) = 60\nMOVER(0) = 41\nGO(0)", [("beyond-travel", 4, 1)]),
        (LIMITS + "MOVER(0) = n\nMOVER(0) = 101\nGO(0)\nn = 1", []),
        ("SPEED(0) = 5\nSCALE(0) = 3\nMOVER(0) = 1\nGO(0)", [("scale-after-speed", 2, 1)]),
        ("SCALE(0) = 3\nSPEED(0) = 5\nMOVER(0) = 1\nGO(0)", []),
        ("SPEED(0) = 5\nSCALE(0) = 3\nSPEED(0) = 6\nMOVER(0) = 1\nGO(0)", [("unused-setting", 1, 1)]),
        ("JOG(0) = 5\nSCALE(0) = 2", [("scale-in-motion", 2, 1)]),
        ("JOG(0) = 0\nSCALE(0) = 2", []),
        ("MOVER(0) = 5\nGO(0)\nSCALE(0) = 2", [("scale-in-motion", 3, 1)]),
        ("MOVER(0) = 5\nGO(0)\nPAUSE IDLE(0)\nSCALE(0) = 2", []),
        ("MOVER(0) = 5\nSCALE(0) = 2\nGO(0)", []),
        ("GO(0)", [("nothing-loaded", 1, 1)]),
        ("MOVER(0) = 5\nGO(1)", [("never-started", 1, 1), ("nothing-loaded", 2, 1)]),
        ("MOVER(0) = 5\nSTOP(0)\nGO(0)", [("never-started", 1, 1), ("nothing-loaded", 3, 1)]),
        ("MOVER(0) = 5\nGO(0)\nPOS(0) = 0", [("in-motion", 3, 1)]),
        ("MOVER(0) = 5\nGO(0)\nPRINT POS(0)", [("in-motion", 3, 7)]),
        ("MOVER(0) = 5\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(0)", []),
        ("MOVER(0) = 5\nGO(0)\nPAUSE POS(0) > 1", []),
        ("SPEED(0) = 0\nMOVER(0) = 5\nGO(0)", [("zero-speed", 2, 1)]),
        ("ACCEL(0) = 0\nMOVER(0) = 5\nGO(0)", [("zero-acceleration", 2, 1)]),
        ("SPEED(0) = 0\nMOVER(0) = 5\nSPEED(0) = 1\nGO(0)", []),
        ("PAUSE IDLE(0)\nSPEED(0) = 0\nMOVER(0) = 5\nGO(0)", [("zero-speed", 3, 1)]),
    ],
)
def test_facts_about_an_axis(text: str, expected: Found) -> None:
    """Targets within software limits, scales, loaded moves, positions in motion."""
    assert found(text) == expected


@cases(
    "text, line",
    [
        ("End\nPRINT 1", 2),
        ("Goto a\nPRINT 1\n#a\nPRINT 2", 2),
        ("Goto b\n#a\nPRINT 1\nEnd\n#b\nGoto a", 0),
        ("GoSub a\nPRINT 1\nEnd\n#a\nReturn\nPRINT 2", 6),
        ("Loop\nWAIT = 1\nEnd Loop\nPRINT 1", 4),
        ("While 1\nWAIT = 1\nWend\nPRINT 1", 4),
        ("While INX(1)\nWAIT = 1\nWend\nPRINT 1", 0),
        ("Repeat\nEnd\nUntil INX(1)", 3),
        ("Loop\nIf INX(1) Then Exit Loop\nEnd Loop\nPRINT 1", 0),
        ("Loop\nLoop\nExit Loop\nPRINT 1\nEnd Loop\nWAIT = 1\nEnd Loop", 4),
        ("Loop\nLoop\nExit\nEnd Loop\nWAIT = 1\nEnd Loop\nPRINT 1", 7),
        ("While INX(1)\nLoop\nExit While\nEnd Loop\nWend\nPRINT 1", 0),
        ("For i = 1 To 5\nExit For\nPRINT i\nNext", 3),
        ("If INX(1) Then\nEnd\nElse\nEnd\nEnd If\nPRINT 1", 6),
        ("If INX(1) Then\nEnd\nEnd If\nPRINT 1", 0),
        ("Select Case INX(1)\nCase 1\nEnd\nCase Else\nEnd\nEnd Select\nPRINT 1", 7),
        ("Select Case INX(1)\nCase 1\nEnd\nEnd Select\nPRINT 1", 0),
        ("Loop\nSelect Case INX(1)\nCase 1\nExit\nEnd Select\nWAIT = 1\nEnd Loop\nPRINT 1", 0),
        ("Loop\nSelect Case INX(1)\nCase 1\nExit Loop\nEnd Select\nWAIT = 1\nEnd Loop\nPRINT 1", 0),
        ("Loop\nSelect Case INX(1)\nCase 1\nExit Select\nEnd Select\nWAIT = 1\nEnd Loop\nPRINT 1", 8),
        ("f()\nEnd\nSub f()\nExit Sub\nPRINT 1\nEnd Sub", 5),
        ("x = f()\nPRINT x\nEnd\nFunction f()\nf = 1\nReturn\nf = 2\nEnd Function", 7),
    ],
)
def test_statements_that_never_run(text: str, line: int) -> None:
    """The first of them is reported; 0 means that all statements can run."""
    assert [each[1] for each in found(text) if each[0] == "unreachable"] == ([line] if line else [])


TASK = "\nEnd\nTask t\n{}\nEnd Task"


@cases(
    "text, expected",
    [
        ("Dim a", [("unused-variable", 1, 5)]),
        ("Dim a\na = 1", [("unused-variable", 1, 5)]),
        ("Dim a\na = a + 1", [("unused-variable", 1, 5)]),
        ("Dim a(3)\na(1) = 2", [("unused-variable", 1, 5)]),
        ("Dim a(3)\nPRINT a(1)", []),
        ("Dim a\nINPUT a", [("unused-variable", 1, 5)]),
        ("Dim NV a\na = 1", []),
        ("Dim a\nf(a)\nEnd\nSub f(ByRef x)\nx = 1\nEnd Sub", []),
        ("Dim a\na = 1\nf()\nEnd\nSub f()\nPRINT a\nEnd Sub", []),
        ("Run t\nDim a\nPRINT a" + TASK.format("a = 1"), []),
        ("For i = 1 To 3\nNext", []),
        ("Sub f()\nEnd Sub", [("unused-sub", 1, 1)]),
        ("Task t\nEnd Task", [("unused-task", 1, 1)]),
        ("#a\nPRINT 1", [("unused-label", 1, 1)]),
        ("Event IN1\nEnd Event", []),
        ("Const k = 1", []),
    ],
)
def test_names_that_nothing_uses(text: str, expected: Found) -> None:
    """A variable counts as used if it is read, retained or passed by reference."""
    assert found(text) == expected


RUN = "\nMOVER(0) = 1\nGO(0)"


@cases(
    "text, expected",
    [
        ("SPEED(0) = 5\nSPEED(0) = 6" + RUN, [("unused-setting", 1, 1)]),
        ("SPEED(0) = 5\nSPEED(1) = 6" + RUN + "\nMOVER(1) = 1\nGO(1)", []),
        ("SPEED(0) = 5\nPRINT SPEED(0)\nSPEED(0) = 6" + RUN, []),
        ("SPEED(0) = 5\nIf INX(1) Then SPEED(0) = 6" + RUN, []),
        ("SPEED(n) = 5\nSPEED(n) = 6\nMOVER(n) = 1\nGO(n)\nn = 1", []),
        ("SPEED(0) = 5\nf()\nEnd\nSub f()\nSPEED(0) = 6" + RUN + "\nEnd Sub", []),
        ("f()" + RUN + "\nEnd\nSub f()\nSPEED(0) = 5\nEnd Sub", []),
        ("Run t\nf()" + TASK.format("f()") + "\nSub f()\nSPEED(0) = 5\nSPEED(0) = 6\nEnd Sub", []),
        ("f()" + RUN + "\nEnd\nSub f()\nSPEED(0) = 5\nSPEED(0) = 6\nEnd Sub", [("unused-setting", 6, 1)]),
        ("Loop" + RUN + "\nPAUSE IDLE(0)\nSPEED(0) = 6\nEnd Loop", []),
        ("POS(0) = 0\nSPEED(0) = 5\nSCALE(0) = 3", [("unused-setting", 2, 1)]),
        ("SPEED(0) = 5\nRun t" + TASK.format(RUN), []),
        ("SPEED(0) = 5\nSPEED(0) = 6\nRun t" + TASK.format(RUN), []),
        (
            "SPEED(0) = 5\nSPEED(0) = 6\nRun t" + TASK.format(RUN.replace("0", "1")),
            [("unused-setting", 1, 1)],
        ),
        ("Run t" + RUN + TASK.format(RUN), [("two-tasks", 7, 1)]),
    ],
)
def test_settings_that_no_move_needs(text: str, expected: Found) -> None:
    """A setting may be needed by another task that uses the axis, or after a branch."""
    assert found(text) == expected


@cases(
    "line, hint",
    [
        (
            "If a & 1 = r.n Then PRINT 1",
            "If (a & 1) = r.n Then PRINT 1, as it is read here, or If a & (1 = r.n) Then PRINT 1",
        ),
        ("a = a & 1 = r.n", "a = (a & 1) = r.n, as it is read here, or a = a & (1 = r.n)"),
        ("a = a & 1 = f(1).n", "a = (a & 1) = f(1).n, as it is read here, or a = a & (1 = f(1).n)"),
        (
            "a = (a & 1 = r.n) * (a + 1)",
            "a = ((a & 1) = r.n) * (a + 1), as it is read here, or a = (a & (1 = r.n)) * (a + 1)",
        ),
    ],
)
def test_brackets_end_behind_a_member(line: str, hint: str) -> None:
    text = f"Type pair\nDim n As Integer\nEnd Type\nDim a As Integer, f(3) As pair, r As pair\n{line}"
    every = [each for each in MINT.check(Source("limits.mnt", text), {}) if each.code == "mixed-operators"]
    assert [each.hint for each in every] == [f"add brackets: {hint}"]

"""Messages, hints and fixes of Mint at the limits of their rules."""

from __future__ import annotations

from motionlang.commands.check import check
from motionlang.kernel import Source
from motionlang.kernel.mint import DIALECT as MINT
from tests.cases import cases


def on(model: str, text: str) -> list[tuple[int, str, str]]:
    """Return line, message and hint of what does not fit the controller model."""
    found = check(MINT.program(Source("limits.mnt", text), {"controller.model": model}))
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


def test_a_name_of_the_program_is_no_keyword_of_another_controller() -> None:
    """ADD is a keyword, which a program may use for a sub of its own."""
    found = on("mint4", "Add(1)\nSub Add(k)\nEnd Sub")
    assert [what.partition(" is")[0] for _, what, _ in found] == ["Sub"]


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
    found = check(MINT.program(Source("limits.mnt", text), {"controller.model": "mintmt"}))
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


def test_of_two_conditions_that_never_hold_the_first_is_explained() -> None:
    text = "MOVEA(0) = 5\nGO(0)\nJOG(1) = 5\nPAUSE POS(0) > 10 Or IDLE(1)"
    (wait,) = check(MINT.program(Source("limits.mnt", text), {}))
    why = "this waits for a condition that cannot change: axis 0 moves between 0 and 5"
    assert (wait.message, wait.hint) == (why, "compare POS(0) with a position that a move reaches")


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
    every = check(MINT.program(Source("limits.mnt", text), {}))
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
    every = [
        each for each in check(MINT.program(Source("limits.mnt", text), {})) if each.code == "wait-condition"
    ]
    assert [(each.fix, each.length) for each in every] == ([(fix, length)] if fix else [])


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
    every = [
        each for each in check(MINT.program(Source("limits.mnt", text), {})) if each.code == "mixed-operators"
    ]
    assert [each.hint for each in every] == [f"add brackets: {hint}"]

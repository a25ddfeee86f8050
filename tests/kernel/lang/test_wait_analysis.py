"""What the waits and loops of a program depend on, in both languages."""

from __future__ import annotations

from motionlang.kernel import Source, dialect_of
from motionlang.kernel.lang import LoopDependencies
from tests.cases import cases

Read = tuple[str, int | None]


def found_in(name: str, text: str, at: int = 0) -> LoopDependencies | None:
    language = dialect_of(name)
    assert language is not None
    return language.program(Source(name, text)).structure.waits.at(at)


# A condition, and the readings that it waits for.
PAUSES: list[tuple[str, set[Read]]] = [
    ("INX(3) And POS(1) > 5", {("input", 3), ("position", 1)}),
    ("IDLE(0) Or AXISERROR(2)", {("axis", 0), ("axis", 2)}),
    ("POS(0) > POS(1)", {("position", 0), ("position", 1)}),
    ("POS(second) > VEL(n)", {("position", 1), ("position", None)}),
    ("VEL > 5", {("position", 0)}),
    ("INX(n)", {("input", None)}),
    ("INX(second)", {("input", 1)}),
    ("IN(0)", {("input", None)}),
    ("LIMIT(1)", {("input", None)}),
    ("door", {("input", 9)}),
    ("ready()", {("input", 7)}),
    ("ADC(4) > 5", {("analogue", 4)}),
    ("ENCODER(0) > 5", {("encoder", 0)}),
    ("INKEY = 65", {("operator", None)}),
    ("COMMS(3)", {("host", None)}),
    ("LATCH(2)", {("latch", 2)}),
    ("TIME > 5", {("time", None)}),
    ("began > 5", {("time", None)}),
    ("TASKSTATUS(work)", {("task", None)}),
    ("flag", {("task", None)}),  # another task sets it
    ("parts(2) > 1", {("task", None)}),
    ("n = 5", set()),  # this task sets it
    ("OUTX(3)", {("other", None)}),
]
AROUND = """\
Dim n As Integer, began As Time, flag As Integer, parts(3) As Integer
Const second = 1
Define door = INX(9)
n = 2
PAUSE {}
End
Function ready() As Integer
  ready = INX(7)
End Function
Task work
  flag = 1
  parts(1) = 2
End Task
"""


@cases("condition, reads", PAUSES)
def test_the_reads_of_a_pause(condition: str, reads: set[Read]) -> None:
    text = AROUND.format(condition)
    found = found_in("a.mnt", text, text.index("PAUSE"))
    assert found is not None
    assert ({*found.leaves}, {*found.lines}, found.why) == (reads, {5}, f"until {condition}")


def test_the_reads_of_a_wait_of_mccl() -> None:
    found = found_in("a.mcl", "NO,WN5", 3)
    assert found is not None
    assert ({*found.leaves}, {*found.lines}, found.why) == ({("input", 5)}, {1}, "until channel 5 on")


def test_a_handler_at_a_label_changes_what_a_wait_tests() -> None:
    found = found_in("a.prg", "PAUSE flag = 1\nEND\n#IN3\nflag = 1\nRETURN\n")
    assert found is not None
    assert found.leaves == {("task", None)}


# A loop, the readings that end it, all in it, the lines that it executes, and what it waits for.
LOOPS: list[tuple[str, set[Read], set[Read], set[int], str]] = [
    ("While INX(3)\nWAIT 1\nWend", {("input", 3)}, {("input", 3)}, {1, 2}, "while INX(3)"),
    ("Repeat\nWAIT 1\nUntil INX(3)", {("input", 3)}, {("input", 3)}, {2, 3}, "until INX(3)"),
    ("Loop\nWAIT 1\nEnd Loop", set(), set(), {1, 2}, ""),
    # A condition that leaves the loop, and one that does not.
    ("Loop\nIf INX(3) Then Exit Loop\nIf INX(4) Then PRINT 1\nEnd Loop",
     {("input", 3)}, {("input", 3), ("input", 4)}, {1, 2, 3}, "INX(3)"),
    ("Loop\nIf INX(3) Then\nPRINT 1\nElse\nEnd\nEnd If\nEnd Loop", {("input", 3)}, {("input", 3)}, {1, 2, 3}, "INX(3)"),
    ("Loop\nIf INX(3) Then Exit Loop\nIf INX(3) Then End\nIf INX(4) Then Return\nEnd Loop\nGosub over\n#over\nReturn",
     {("input", 3), ("input", 4)}, {("input", 3), ("input", 4)}, {1, 2, 3, 4}, "INX(3) or INX(4)"),
    ("Loop\nSelect Case INX(2)\nCase 1\nExit Loop\nEnd Select\nEnd Loop",
     {("input", 2)}, {("input", 2)}, {1, 2, 3, 4}, "INX(2) is 1"),
    # A condition that decides whether the loop comes to its end.
    ("Loop\nIf INX(5) Then\nIf INX(6) Then Exit Loop\nEnd If\nEnd Loop",
     {("input", 5), ("input", 6)}, {("input", 5), ("input", 6)}, {1, 2, 3}, "INX(6)"),
    # It never ends by itself.
    ("While 1\nWhile INX(1)\nWAIT 1\nWend\nWend", set(), {("input", 1)}, {1, 2, 3}, ""),
    # The value that the loop itself assigns counts, and the condition for it.
    ("While Not done\ndone = IDLE(0)\nWend\nDim done", {("axis", 0)}, {("axis", 0)}, {1, 2}, "while Not done"),
    ("While Not done\nIf INX(2) Then done = 1\nWend\nDim done",
     {("input", 2)}, {("input", 2)}, {1, 2}, "while Not done"),
    ("While Not done\nIf INX(2) Then done = 1 Else done = 0\nWend\nDim done",
     {("input", 2)}, {("input", 2)}, {1, 2}, "while Not done"),
    ("While Not done\nIf INX(2) Then act()\nWend\nDim done\nSub act()\ndone = 1\nEnd Sub",
     {("input", 2)}, {("input", 2)}, {1, 2, 6}, "while Not done"),
    ("While n < 5\nINPUT n\nWend\nDim n", {("operator", None)}, {("operator", None)}, {1, 2}, "while n < 5"),
    ("While n < 5\nn = n + 1\nWend\nDim n", set(), set(), {1, 2}, "while n < 5"),
    # A sub belongs to the loop that calls it, but its conditions only decide within.
    ("While 1\nact()\nWend\nSub act()\nWAIT 1\nIf INX(6) Then End\nEnd Sub", set(), {("input", 6)}, {1, 2, 5, 6}, ""),
    # A loop of Gotos.
    ("#a\nWAIT 1\nIf INX(5) Then Goto b\nGoto a\n#b", {("input", 5)}, {("input", 5)}, {1, 2, 3, 4}, "INX(5)"),
    ("#a\nWAIT 1\nIf INX(5) Then Goto a\nWAIT 2", {("input", 5)}, {("input", 5)}, {1, 2, 3}, "INX(5)"),
]  # fmt: skip


@cases("text, leaves, within, lines, why", LOOPS)
def test_the_reads_of_a_loop(
    text: str, leaves: set[Read], within: set[Read], lines: set[int], why: str
) -> None:
    found = found_in("a.mnt", text)
    assert found is not None
    assert ({*found.leaves}, {*found.within}, {*found.lines}, found.why) == (leaves, within, lines, why)
    assert not found.counts


def test_a_loop_that_calls_what_is_above_it() -> None:
    text = (
        "b()\nSub a()\nWAIT 1\nEnd Sub\n"
        "Sub b()\nLoop\na()\nIf INX(5) Then\nIf INX(6) Then Exit Loop\nEnd If\nEnd Loop\nEnd Sub"
    )
    found = found_in("a.mnt", text, text.index("Loop"))
    assert found is not None
    assert found.leaves == {("input", 5), ("input", 6)}


def test_a_for_also_counts() -> None:
    found = found_in("a.mnt", "For i = 1 To 5\nIf INX(3) Then Exit For\nNext")
    assert found is not None
    assert found.counts
    assert found.leaves == {("input", 3)}


def test_loops_that_begin_together() -> None:
    text = "Repeat\nRepeat\nWAIT 1\nUntil INX(1)\nUntil INX(2)"
    outer, inner = found_in("a.mnt", text), found_in("a.mnt", text, text.rindex("Repeat"))
    assert outer is not None
    assert inner is not None
    assert (outer.why, {*outer.leaves}, {*outer.lines}) == ("until INX(2)", {("input", 2)}, {2, 3, 4, 5})
    assert (inner.why, {*inner.leaves}, {*inner.lines}) == ("until INX(1)", {("input", 1)}, {3, 4})

    text = "Loop\n#a\nIf INX(3) Then Goto a\nIf INX(4) Then Exit Loop\nEnd Loop"
    outer, inner = found_in("a.mnt", text), found_in("a.mnt", text, text.index("#a"))
    assert outer is not None
    assert inner is not None
    assert ({*outer.leaves}, outer.why) == ({("input", 3), ("input", 4)}, "INX(4)")
    assert ({*inner.leaves}, inner.why) == ({("input", 3)}, "INX(3)")


def test_loops_of_gotos_that_overlap_are_one() -> None:
    text = "#a\nWAIT 1\n#b\nIf INX(1) Then Goto a\nIf INX(2) Then Goto b\n"
    for label in ("#a", "#b"):
        found = found_in("a.mnt", text, text.index(label))
        assert found is not None
        assert ({*found.leaves}, found.why) == ({("input", 1), ("input", 2)}, "INX(2)")

    text = "#a\nWAIT 1\n#b\nIf INX(2) Then Goto b\nIf INX(3) Then Goto a\n"
    found = found_in("a.mnt", text, text.index("#b"))
    assert found is not None
    assert found.leaves == {("input", 2)}


@cases(
    "text, jump, leaves, within, lines, why",
    [
        ("IN5,JR-1,NO", "JR-1", {("input", 5)}, {("input", 5)}, {1}, "channel 5 on"),
        ("IN5,NO,NO,IF6,JP2", "JP2", {("input", 6)}, {("input", 6)}, {1}, "channel 6 off"),
        ("MD1,IN5,NO,NO,IF6,JP2", "JP2", {("input", 6)}, {("input", 6)}, {1}, "channel 6 off"),
        ("IN5,BK,NO,IF6,JP0", "JP0", {("input", 5), ("input", 6)}, {("input", 5), ("input", 6)}, {1},
         "channel 5 on or channel 6 off"),
        ("DN5,DF6,NO,JR-3", "JR-3", {("input", 5), ("input", 6)}, {("input", 5), ("input", 6)}, {1},
         "channel 5 on or channel 6 off"),
        # A jump by a register may lead to the beginning of the line, RP and MJ do so; this one has no end.
        ("IN5,NO,NO,JP@20", "JP@20", set(), {("input", 5)}, {1}, ""),
        ("IN5,NO,NO,RP", "RP", set(), {("input", 5)}, {1}, ""),
        ("MD7,IN5,BK,NO,MJ7", "MJ7", {("input", 5)}, {("input", 5)}, {1}, "channel 5 on"),
        # Macros that jump to each other.
        ("MD1,IN5,BK,NO,MJ2\nMD2,IN6,BK,NO,MJ1\nMC1", "MJ1", {("input", 5), ("input", 6)},
         {("input", 5), ("input", 6)}, {1, 2}, "channel 5 on or channel 6 on"),
        # A macro that it leaves for, and that does not come back.
        ("MD1,NO\nMD2,IN5,MJ1,NO,JR-3\nMC2", "JR-3", {("input", 5)}, {("input", 5)}, {2}, "channel 5 on"),
        # What comes into the accumulator is tested, also in a macro that the loop calls.
        ("RA9,IB5,JP0,NO", "JP0", set(), set(), {1}, "register 9 < 5"),
        ("GA2,IB5,JP0,NO", "JP0", {("analogue", 2)}, {("analogue", 2)}, {1}, "analogue input 2 < 5"),
        ("1RL@20,IB5,JP0,NO", "JP0", {("position", 1)}, {("position", 1)}, {1}, "accumulator < 5"),
        ("2GX,IS5,JP0,NO", "JP0", {("axis", 2)}, {("axis", 2)}, {1}, "bit 5 set"),
        ("MD3,GA2\nMC3,IB5,JP0,NO", "JP0", {("analogue", 2)}, {("analogue", 2)}, {1, 2}, "accumulator < 5"),
        # Registers from 10 on are those of all tasks.
        ("MD1,AL1,AR20\nGT1\nRA20,IB1,JP0,NO", "JP0", {("task", None)}, {("task", None)}, {3}, "register 20 < 1"),
        # A macro that the loop calls belongs to it; one that it does not know does not.
        ("MD3,IN5,NO\nNO\nMC3,MC4,RP", "RP", set(), {("input", 5)}, {1, 3}, ""),
        ("MD3,IN5,NO\nMC@3,RP", "RP", set(), set(), {2}, ""),
    ],
)  # fmt: skip
def test_the_reads_of_a_loop_of_mccl(
    text: str, jump: str, leaves: set[Read], within: set[Read], lines: set[int], why: str
) -> None:
    found = found_in("a.mcl", text, text.rindex(jump))
    assert found is not None
    assert ({*found.leaves}, {*found.within}, {*found.lines}, found.why) == (leaves, within, lines, why)


@cases(
    "text",
    ["MD1,IN5,NO\nMC1,BK", "MD1,IN5,MJ2\nMD2,NO", "MD1,NO\nMD2,IN5,MJ1", "1WS0.1", "IN5,JR2,NO"],
)
def test_other_commands_are_no_loop(text: str) -> None:
    assert [at for at in range(len(text)) if found_in("a.mcl", text, at)] == []


def test_all_waits_and_loops() -> None:
    language = dialect_of("a.mnt")
    assert language is not None
    text = "PAUSE INX(1)\nRepeat\nWAIT 1\nUntil INX(2)\n#a\nIf INX(3) Then Goto a"
    waits = language.program(Source("a.mnt", text)).structure.waits
    assert [each.leaves for each in waits.all()] == [{("input", 1)}, {("input", 2)}, {("input", 3)}]
    # The loop is at its end, too.
    assert waits.at(text.index("INX(2)")) is not None

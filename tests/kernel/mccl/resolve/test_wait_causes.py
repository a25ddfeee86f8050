"""The values that the loops of a program read, and where they depend on inputs."""

from __future__ import annotations

from motionlang.kernel import Source
from motionlang.kernel.mccl import DIALECT as MCCL
from tests.cases import cases


@cases(
    "text, jump, reads, lines, why",
    [
        ("IN5,JR-1,NO", "JR-1", {("input", 5)}, {1}, "in IN5,JR-1"),
        ("IN5,NO,IF6,JP2", "JP2", {("input", 6)}, {1}, "in IF6,JP2"),
        ("MD1,IN5,NO,IF6,JP2", "JP2", {("input", 6)}, {1}, "in IF6,JP2"),
        ("MD1,IN5,NO,IF6,JP0", "JP0", {("input", 5), ("input", 6)}, {1}, "in IN5,NO,IF6,JP0"),
        ("DN5,DF6,NO,JR-3", "JR-3", {("input", 5), ("input", 6)}, {1}, "in DN5,DF6,NO,JR-3"),
        # A jump forward, by a register, RP and MJ: the loop may begin with the line.
        ("IN5,JR2,NO", "JR2", {("input", 5)}, {1}, "in IN5,JR2"),
        ("IN5,JP@20,NO", "JP@20", {("input", 5)}, {1}, "in IN5,JP@20"),
        ("IN5,NO,NO,RP3", "RP3", {("input", 5)}, {1}, "in IN5,NO,NO,RP3"),
        ("MD7,IN5,NO,MJ7", "MJ7", {("input", 5)}, {1}, "in IN5,NO,MJ7"),
        # Registers below 10 are a task's own.
        ("RA9,RA5,RP", "RP", set(), {1}, "in RA9,RA5,RP"),
        ("RA10,RP", "RP", {("task", None)}, {1}, "in RA10,RP"),
        ("RA@3,RP", "RP", {("task", None)}, {1}, "in RA@3,RP"),
        ("GA2,1RL@20,2GX,RP", "RP", {("analogue", 2), ("position", 1), ("axis", 2)}, {1}, "in GA2,1RL@20,2GX,RP"),
        # A macro that the loop calls belongs to it; one that it does not know does not.
        ("MD3,IN5,NO\nNO\nMC3,MC4,RP", "RP", {("input", 5)}, {1, 3}, "in MC3,MC4,RP"),
        ("MD3,IN5,NO\nMC@3,RP", "RP", set(), {2}, "in MC@3,RP"),
        ("NO,IN5\nIN6,RP", "RP", {("input", 6)}, {2}, "in IN6,RP"),
    ],
)  # fmt: skip
def test_the_reads_of_a_loop(
    text: str, jump: str, reads: set[tuple[str, int | None]], lines: set[int], why: str
) -> None:
    found = MCCL.program(Source("loops.mcl", text)).polls(text.rindex(jump))
    assert found is not None
    assert found.leaves == found.within == reads
    assert found.lines == lines
    assert found.why == why
    assert not found.counts


def test_other_commands_are_no_loop() -> None:
    text = "MD1,IN5,NO\nMC1,BK"
    reads = MCCL.program(Source("loops.mcl", text)).polls
    assert [reads(at) for at in range(len(text))] == [None] * len(text)


def test_where_a_program_depends_on_inputs() -> None:
    """WN and WF wait, the others test, each for a level."""
    found = MCCL.program(
        Source("inputs.mcl", "WN5\nCN33,WF6,IN7\nIF8,DN9,DF10,1WE0\nIN11,BK,NO,WA1,RP\nIN12,BK,NO\n")
    ).reads
    assert [(each.kind, each.channel, each.level, each.line) for each in found] == [
        ("wait", 5, 1, 1), ("wait", 6, 0, 2), ("test", 7, 1, 2), ("test", 8, 0, 3), ("test", 9, 1, 3),
        ("test", 10, 0, 3), ("poll", 11, 1, 4), ("test", 12, 1, 5),
    ]  # fmt: skip

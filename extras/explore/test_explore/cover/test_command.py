"""What runs reach of a program: counts, conditions, parts, and what other tools read."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

from motionlang.kernel import Hook, Source, dialect_for, run
from motionlang.kernel.report import text
from motionlang.views.terminal import styled
from motionlang_explore.cover import covered
from motionlang_explore.cover.worlds import Counts, Event, Worlds
from motionlang_explore.map.units import Reachability
from test_explore.worlds import world_of
from tests.cases import cases
from tests.cli.programs import Cell
from tests.generated import polls
from tests.generated.compared import every_iteration
from tests.generated.machines import machine

ROOT = Path(__file__).parents[4]
GALLERY = sorted(
    path for path in (ROOT / "scripts").rglob("*") if path.suffix in (".mnt", ".mcl", ".prg", ".mccl")
)
OLD = sorted(path for path in (ROOT / "examples" / "old").iterdir() if path.suffix != ".md")
# Of the others, which take up to half a minute, 93 to 99 % are reached.
QUICK = ("bagwelder.prg", "coiler.prg", "rotary.mccl")

TABLE = """\
Dim n As Integer
For n = 1 To 3
  If n > 5 Then
    PRINT "many"
  ElseIf INX(2) Then
    Ring
  End If
Next
Select Case n
Case 4 : PRINT "four"
Case Else : PRINT "other"
End Select
While Not INX(2)
End While
End
Sub Ring
  PRINT "ring"
End Sub
Event IN5
  PRINT "five"
End Event
"""


@pytest.fixture
def table(cell: Cell) -> Cell:
    cell.write("table.mnt", TABLE)
    cell.write("table.machine.toml", "[[input]]\nchannel = 2\nat = 1.0\n")
    return cell


def test_a_listing_has_the_count_of_each_line_and_what_is_missing(table: Cell) -> None:
    """The empty loop runs for a second, at 10 µs an iteration; most iterations are skipped, and counted."""
    assert (
        table("cover", "table.mnt", "--all").out
        == """\
table.mnt
              1  Dim n As Integer
        1     2  For n = 1 To 3
        3     3    If n > 5 Then
                 never true: n > 5
        -     4      PRINT "many"
        3     5    ElseIf INX(2) Then
                 never true: INX(2)
        -     6      Ring
              7    End If
              8  Next
        1     9  Select Case n
        1    10  Case 4 : PRINT "four"
                 never false: n is 4
        -    11  Case Else : PRINT "other"
             12  End Select
   99 988    13  While Not INX(2)
             14  End While
        1    15  End
             16  Sub Ring
        -    17    PRINT "ring"
             18  End Sub
             19  Event IN5
        -    20    PRINT "five"
             21  End Event

file       worlds  statements  outcomes   parts  covered  lines to look at
─────────────────────────────────────────────────────────────────────────────
table.mnt       1     7 of 12   7 of 10  0 of 2     64 %  3-6, 10, 11, 17, 20
"""
    )


def test_a_listing_has_one_colour_for_missed_and_another_for_partly_reached_lines(
    table: Cell, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("FORCE_COLOR", "1")
    lines = table("cover", "table.mnt", "--all").out.splitlines()
    (partly,) = (each for each in lines if each.endswith("If n > 5 Then"))
    (missed,) = (each for each in lines if each.endswith('PRINT "many"'))
    assert partly.startswith(styled(f"{3:>9}", "warning", True))
    assert missed.startswith(styled(f"{'-':>9}", "error", True))


def test_scenarios_add_up(table: Cell) -> None:
    (table.folder / "table.scenarios").mkdir()
    table.write(
        "table.scenarios/now.toml", "[[input]]\nchannel = 2\nat = 0.0\n[[input]]\nchannel = 5\nat = 0.1\n"
    )
    ran = table("cover", "table.mnt")
    assert (
        ran.out
        == """\
file       worlds  statements  outcomes   parts  covered  lines to look at
──────────────────────────────────────────────────────────────────────────
table.mnt       2     9 of 12   8 of 10  1 of 2     77 %  3, 4, 10, 11, 20
"""
    )


def test_the_tracefile_of_lcov(table: Cell) -> None:
    assert table("cover", "table.mnt", "-q", "--lcov", "x.info").out == ""
    assert (
        (table.folder / "x.info").read_text()
        == """\
TN:
SF:table.mnt
FN:16,sub Ring
FN:19,event IN5
FNDA:0,sub Ring
FNDA:0,event IN5
FNF:2
FNH:0
BRDA:2,0,0,3
BRDA:2,0,1,1
BRDA:3,1,0,0
BRDA:3,1,1,3
BRDA:5,2,0,0
BRDA:5,2,1,3
BRDA:10,3,0,1
BRDA:10,3,1,0
BRDA:13,4,0,99987
BRDA:13,4,1,1
BRF:10
BRH:7
DA:2,1
DA:3,3
DA:4,0
DA:5,3
DA:6,0
DA:9,1
DA:10,1
DA:11,0
DA:13,99988
DA:15,1
DA:17,0
DA:20,0
LF:12
LH:7
end_of_record
"""
    )


def test_less_than_wanted_is_covered(table: Cell) -> None:
    ran = table("cover", "table.mnt", "-q", "--fail-under", "90")
    assert (ran.status, ran.out, ran.err) == (1, "", "63.6 % is covered, less than 90 %\n")
    assert table("cover", "table.mnt", "-q", "--fail-under", "60").status == 0


def test_a_program_with_an_error_is_reported_beside_the_others(table: Cell) -> None:
    table.write("wrong.mcl", "1MN\n1XX3\n")
    table.write("gone.mnt", "MOVR(0) = 3\n")
    ran = table("cover", "table.mnt", "gone.mnt", "none.mnt")
    assert ran.status == 1
    assert "error[unknown-word]: MOVR is unknown\n --> gone.mnt:1:1\n" in ran.err
    assert "error[file]: none.mnt cannot be read: no such file or directory\n" in ran.err
    assert ran.out.splitlines()[-1].startswith("table.mnt")


def test_the_page_marks_lines(table: Cell) -> None:
    table("cover", "table.mnt", "-q", "--html", "x.html")
    page = (table.folder / "x.html").read_text(encoding="utf-8")
    assert "<title>Coverage: 64 %</title>" in page
    assert "<span class='missed'><b>0     4</b>    PRINT &quot;many&quot;</span>" in page


def test_what_nothing_leads_to_does_not_count(cell: Cell) -> None:
    """NO behind MJ is skipped with it."""
    cell.write("a.mcl", "MD2,CN33\nMD1,IN1,MJ2,NO,WA0.01,MJ1\nMC1\n")
    cell.write("a.machine.toml", "[[input]]\nchannel = 1\nat = 0.5\n")
    assert cell("cover", "a.mcl").out.splitlines()[-1].split()[-2:] == ["100", "%"]


@pytest.mark.parametrize("path", [each for each in OLD if each.name in QUICK], ids=lambda path: path.name)
def test_the_map_has_every_statement_that_begins_as_reached(path: Path) -> None:
    source = Source.read(path)
    language = dialect_for(source, None)
    worlds = Worlds(language.program(source, is_debug=True), language)
    events = worlds.run(world_of(source, language), 20.0).events
    assert {at for at, _, _ in events} <= Reachability(language.program(source, {}).structure).reached


def test_conditions_and_macros_of_mccl(cell: Cell) -> None:
    """IG skips the two commands after it if it is false; macro 9 is never called."""
    cell.write("a.mcl", "MD5,TR0\nMD2,IG5,MC5,NO,TR0\nAL10,MC2\nAL1,MC2\nMD9,TR0\n")
    assert (
        cell("cover", "a.mcl", "--all").out
        == """\
a.mcl
        1     1  MD5,TR0
        1     2  MD2,IG5,MC5,NO,TR0
        1     3  AL10,MC2
        1     4  AL1,MC2
        1     5  MD9,TR0
                 nothing leads here

file   worlds  statements  outcomes   parts  covered  lines to look at
──────────────────────────────────────────────────────────────────────
a.mcl       1    12 of 12    2 of 2  2 of 3    100 %  5
"""
    )


class Stopped(Exception):
    """A stop at a statement."""


def stopping(offsets: set[int]) -> Hook:
    def stop(task: object, time: float, offset: int) -> None:
        raise Stopped

    hook = Hook(stop)
    hook.offsets = frozenset(offsets)
    return hook


@pytest.mark.slow
@cases("path", [*GALLERY, *OLD], ids=lambda path: path.name)
def test_stops_agree_with_the_counts(path: Path) -> None:
    """A stop at what was not reached changes nothing, and the run comes to each first and last statement reached."""
    found = covered(str(path), until=60.0)
    missed = {each.at for each in found.statements if not each.count}
    if len(found.worlds) > 1:
        return  # a stop belongs to one world
    assert text(run(path, until=60.0, hook=stopping(missed))) == text(run(path, until=60.0))
    reached = [each.at for each in found.statements if each.count]
    for at in (*reached[:1], *reached[-2:]):
        with pytest.raises(Stopped):
            run(path, until=60.0, hook=stopping({at}))


@pytest.mark.slow
@cases(
    "name",
    [
        "mint/palletiser.mnt",
        "mint/feeder-cycle.mnt",
        "mint/teach-in.mnt",
        "mccl/pick-cycle.mcl",
        "mccl/watch-task.mcl",
        "mccl/home-by-polling.mcl",
    ],
)
def test_the_counts_are_those_of_a_debugger_that_steps_through(name: str) -> None:
    path = ROOT / "scripts" / name
    met: Counter[int] = Counter()

    def stop(task: object, time: float, offset: int) -> None:
        met[offset] += 1

    with every_iteration():
        run(path, until=5.0, hook=Hook(stop, limit=0))
    found = covered(str(path), until=5.0)
    assert {each.at: each.count for each in found.statements if each.count} == met


def figures_agree(cell: Cell, name: str, *options: str) -> bool:
    """True if the counts that --suggest reports are those of a run of the files it wrote, and `verify` passes them."""
    said = cell("cover", name, "--suggest", "--format", "json", *options).out
    return cell("cover", name, "--format", "json", *options).out == said and not cell("verify", name).status


LINE = """\
AUTO
LINE 1,"STANDBY"
PAUSE INX.0
LINE 1,"       "
? "LAB 1"
IF INX.1 THEN ? "TWO"
END
"""


def test_suggested_scenarios_are_to_be_reviewed(cell: Cell) -> None:
    """A text that is written over another one on the screen is not expected."""
    cell.write("line.prg", LINE)
    assert (
        cell("cover", "line.prg", "--suggest").out
        == """\
line.prg: 22 % → 100 % with 2 scenarios
  line.scenarios/input-0-on-standby-lab.toml: reaches lines 4, 5, 7
  line.scenarios/input-0-on-and-input-1-on-standby-lab.toml: reaches line 6
"""
    )
    assert (
        (cell.folder / "line.scenarios" / "input-0-on-standby-lab.toml").read_text()
        == """\
# A world of line.prg, found by motionlang cover --suggest. It reaches lines 4, 5, 7. The
# expectations are what the program does in it: check whether they are what it should do.

controller.model = "mint4"
run.until = 2.3

input = [
  { channel = 0, at = 0.3, value = 1 },
]

expect = [
  { status = "ended" },
]
"""
    )
    assert cell("verify", "line.prg").out.endswith("2 of 2 scenarios pass\n")
    assert cell("cover", "line.prg", "--fail-under", "100").status == 0
    assert cell("verify", "line.prg", "--update").status == 0
    assert cell("verify", "line.prg").status == 0


GUARD = """\
REM in 2 guard
SPEED.0 = 100 : ACCEL.0 = 1000 : DECEL.0 = 1000
LOOP
PAUSE INX.1
IF INX.2 THEN GOTO OPEN
MOVER.0 = 10 : GO.0 : PAUSE IDLE.0
PAUSE INX.1 = 0
ENDL
#OPEN
? "GUARD"
"""


def test_a_scenario_has_the_names_of_its_changes(cell: Cell) -> None:
    cell.write("old.prg", GUARD)
    cell("cover", "old.prg", "--suggest")
    names = sorted(path.name for path in (cell.folder / "old.scenarios").iterdir())
    assert names == ["input-1-on-and-guard-on.toml", "work.toml"]
    text = (cell.folder / "old.scenarios" / names[0]).read_text()
    assert '\n  { prints = "GUARD" },\n' in text
    assert cell("verify", "old.prg").status == 0


PALLET = """\
Dim n As Integer
Loop
  Pause INX(0)
  MOVER(0) = 10 : GO(0) : Pause IDLE(0)
  n = n + 1
  Print "case ", n
  If n = 12 Then
    Print "pallet full"
    n = 0
  End If
  Pause INX(0) = 0
End Loop
"""


def test_a_scenario_goes_on_to_what_it_reaches(cell: Cell) -> None:
    """Ten cycles would be enough for its moves, but the pallet is full after twelve."""
    cell.write("pallet.mnt", PALLET)
    assert (
        cell("cover", "pallet.mnt", "--suggest").out
        == """\
pallet.mnt: 15 % → 100 % with 1 scenario
  pallet.scenarios/work.toml: reaches lines 4-9, 11
"""
    )
    assert cell("cover", "pallet.mnt", "--fail-under", "100").status == 0
    assert cell("verify", "pallet.mnt").status == 0


def test_the_suggested_figures_are_those_of_the_scenarios(cell: Cell) -> None:
    """A limit of both commands ends the same runs: 40 s are more than the program needs."""
    cell.write("guard.prg", GUARD)
    assert figures_agree(cell, "guard.prg", "--until", "40")


@pytest.mark.slow
@cases("seed", [9, 14, 16])
def test_the_suggested_figures_of_drawn_machines_are_those_of_their_scenarios(seed: int, cell: Cell) -> None:
    suffix, text, _ = machine(seed)
    cell.write(f"m{seed}{suffix}", text)
    assert figures_agree(cell, f"m{seed}{suffix}")


@pytest.mark.parametrize("words", ["--all", "--fail-under 9", "--html x.html", "--lcov x.info"])
def test_suggestions_take_no_option_of_the_table(words: str, table: Cell) -> None:
    ran = table("cover", "table.mnt", "--suggest", *words.split())
    assert (ran.status, "--suggest writes scenarios" in ran.err) == (2, True)


def test_a_limit_of_the_search_needs_a_search(table: Cell) -> None:
    ran = table("cover", "table.mnt", "--seconds", "20")
    assert (ran.status, "--seconds limits the search of --suggest" in ran.err) == (2, True)


@pytest.mark.slow
@cases("name", [*QUICK, "label.prg"])
def test_suggestions_reach_nine_tenths_of_an_old_program(name: str, cell: Cell) -> None:
    cell.write(name, (ROOT / "examples" / "old" / name).read_bytes())
    assert figures_agree(cell, name)
    assert cell("cover", name, "--quiet", "--fail-under", "90").status == 0


@pytest.mark.slow
@cases("seed", [3, 7, 16, 24])
def test_skipped_iterations_of_several_tasks_count_like_carried_out_ones(seed: int) -> None:
    """In program 16 a task waits a millisecond at a time, and is skipped again and again between timer events."""
    text, machine = polls.program(seed)

    def events() -> Counter[Event]:
        counts = Counts()
        run(Source("a.mnt", text), machine=machine, until=0.5, hook=counts, observer=counts)
        return +counts.events

    with every_iteration():
        carried_out = events()
    assert events() == carried_out

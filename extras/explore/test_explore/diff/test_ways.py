"""`motionlang diff --explore` on a press with one line changed: the text of each change is in `ways/press.txt`."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.programs import Cell

FOLDER = Path(__file__).parent / "ways"
OLD = sorted((Path(__file__).parents[4] / "examples" / "old").glob("*.prg"))
# What is changed, and how: each text before and after.
CHANGES = {
    "a swapped condition behind a time-out": [('IF INX.0 THEN ? "PART', 'IF INX.0 = 0 THEN ? "PART')],
    "a lost OUTX in an alarm handler": [("OUTX.2 = 1\n", "")],
    "a reject that is counted twice": [("bad = bad + 1", "bad = bad + 2")],
    "another order of two outputs": [("OUTX.1 = 1\nOUTX.3 = 1", "OUTX.3 = 1\nOUTX.1 = 1")],
    "a handler that no longer stops": [("STOP.0\n", "")],
    "a menu key that does something else": [('? "BAD ",bad : GOTO MENU', "GOTO WORK")],
    "another place, and the wrong output behind it": [
        ("MOVEA.0 = 40", "MOVEA.0 = 41"),
        ("OUT.0 = 0\nPAUSE", "OUT.0 = 1\nPAUSE"),
    ],
    "a longer dwell": [("WAIT = 100", "WAIT = 350")],
    "a slower move": [("SPEED.0 = 200", "SPEED.0 = 150")],
    "a renamed variable": [("bad", "rejects"), ('"BAD', '"BAD')],
    "a moved sub": [
        ("#IN2\nSTOP.0\nOUTX.2 = 1\n", "#IN2\nGOSUB HALT\nOUTX.2 = 1\n"),
        ("#WORK\nPAUSE", "#HALT\nSTOP.0\nRETURN\n#WORK\nPAUSE"),
    ],
}


@pytest.mark.slow
def test_each_change_of_a_press(cell: Cell, golden: Callable[[Path, str], None]) -> None:
    text = (FOLDER / "press.prg").read_text(encoding="utf-8")
    cell.write("press.prg", text)
    parts = []
    for name, pairs in CHANGES.items():
        changed = text
        for old, new in pairs:
            assert old in changed
            changed = changed.replace(old, new)
        cell.write("changed.prg", changed)
        ran = cell("diff", "press.prg", "changed.prg", "--explore")
        parts.append(f"== {name}\n{ran.out}{ran.err}exit status {ran.status}\n")
    golden(FOLDER / "press.txt", "\n".join(parts))


@pytest.mark.slow
def test_each_scenario_passes_on_a_and_fails_on_b(cell: Cell) -> None:
    text = (FOLDER / "press.prg").read_text(encoding="utf-8")
    cell.write("press.prg", text)
    cell.write("changed.prg", text.replace("OUTX.2 = 1\n", "").replace("bad = bad + 1", "bad = bad + 2"))
    ran = cell("diff", "press.prg", "changed.prg", "--explore", "--write-scenarios", "press.scenarios")
    assert (ran.status, ran.err) == (1, "2 scenarios written to press.scenarios\n")
    shutil.copytree(cell.folder / "press.scenarios", cell.folder / "changed.scenarios")
    assert cell("verify", "press.prg").status == 0
    failed = cell("verify", "changed.prg")
    assert failed.status == 1
    assert "switched.2" in failed.out + failed.err
    assert "REJECT 1" in failed.out + failed.err


def test_the_options_that_exclude_each_other(cell: Cell) -> None:
    cell.write("a.prg", "END\n")
    assert cell("diff", "a.prg", "a.prg", "--explore", "--scenarios").status == 2
    assert cell("diff", "a.prg", "a.prg", "--write-scenarios", "out").status == 2
    assert cell("diff", "a.prg", "--explore").status == 2
    assert cell("diff", "a.prg", "a.prg", "--explore", "--tolerance", "time=1ms").status == 2
    assert cell("diff", "a.prg", "a.prg", "--seconds", "3").status == 2


@pytest.mark.long
@pytest.mark.parametrize("path", OLD, ids=lambda path: path.name)
def test_a_port_to_mintmt_is_no_difference(path: Path, cell: Cell) -> None:
    ported = f"{path.stem}.mnt"
    for name in (path.name, ported):
        cell.write(name, path.read_bytes())
    assert cell("check", ported, "--fix", "--model", "mintmt", "--format", "none").status == 0
    ran = cell("diff", path.name, ported, "--explore", "--format", "json")
    assert ran.status == 0, ran.out


COUNTING = "REM IN 0 part\nn = 0\n#WAIT\nPAUSE INX.0\nPAUSE INX.0 = 0\nn = n + 1\nGOTO WAIT\n"


def test_code_that_nothing_leads_to_is_no_change(cell: Cell) -> None:
    cell.write("old.prg", COUNTING)
    cell.write("new.prg", COUNTING.replace("GOTO WAIT\n", "GOTO WAIT\n#NEVER\nOUTX.3 = 1\n"))
    ran = cell("diff", "old.prg", "new.prg", "--explore")
    assert (ran.status, "not reached: line 9 of B" in ran.out) == (0, True)


def test_another_name_of_a_variable_is_no_other_behaviour(cell: Cell) -> None:
    cell.write("old.prg", COUNTING)
    cell.write("new.prg", COUNTING.replace("n ", "count "))
    assert cell("diff", "old.prg", "new.prg", "--explore").status == 0


def test_what_another_terminal_shows_is_compared(cell: Cell) -> None:
    """Its text has no line."""
    text = 'REM IN 0 part\n#WAIT\nPAUSE INX.0\nTERMINAL = 2\n? "PART 1"\nPAUSE INX.0 = 0\nGOTO WAIT\n'
    cell.write("old.prg", text)
    cell.write("new.prg", text.replace("PART 1", "PART 2"))
    ran = cell("diff", "old.prg", "new.prg", "--explore")
    assert (
        "start; input 0 (part) on: A '[terminal 2] PART 1' after 0.00 s, B '[terminal 2] PART 2' after 0.00 s (in"
        in ran.out
    )
    assert "()" not in ran.out


def test_the_page_marks_what_only_one_program_does(cell: Cell) -> None:
    text = "REM IN 0 part\n#WAIT\nPAUSE INX.0\nOUTX.1 = 1\nPAUSE INX.0 = 0\nOUTX.1 = 0\nGOTO WAIT\n"
    cell.write("old.prg", text)
    cell.write("new.prg", text.replace("OUTX.1 = 1\n", "OUTX.2 = 1\n\n"))
    assert cell("diff", "old.prg", "new.prg", "--explore", "--plot", "both.html").status == 1
    page = (cell.folder / "both.html").read_text(encoding="utf-8")
    a, b = page.split("<h2>A: old.prg</h2>")[1].split("<h2>B: new.prg</h2>")
    for side, output, line, letter in ((a, 1, 5, "A"), (b, 2, 6, "B")):
        assert f"<td>output {output} on</td><td>{line}</td><td class=only>only in {letter}</td>" in side
        assert "<td>input 0 (part) off</td>" in side


FEED = """\
SOFTLIMITMODE(0) = 1 : SOFTLIMITFORWARD(0) = 500
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Loop
  PAUSE INX(1)
  MOVER(0) = 60 : GO(0) : PAUSE IDLE(0)
  WAIT(500)
  OUTX(1) = 1
  PRINT "part"
  OUTX(1) = 0
  PAUSE Not INX(1)
End Loop
"""


@pytest.mark.slow
@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        # A cycle whose position goes on is played until it reaches what it approaches.
        ("FORWARD(0) = 500", "FORWARD(0) = 400", "B axis 0 MOVER, cut off at 400"),
        ("WAIT(500)", "WAIT(9000)", "output 1 on comes 8.500 s later in B"),
        # An act that comes long after those of A is later, and not missing.
        ("WAIT(500)", "WAIT(40000)", "output 1 on comes 39.500 s later in B"),
    ],
)
def test_a_feed_that_goes_on(cell: Cell, old: str, new: str, said: str) -> None:
    cell.write("a.mnt", FEED)
    cell.write("b.mnt", FEED.replace(old, new))
    ran = cell("diff", "a.mnt", "b.mnt", "--explore")
    assert ran.status == 1
    assert said in ran.out
    assert "(cycles 3 to 40 times, times to 25 ms)" in ran.out.splitlines()[0]


# What a change shows, or why what was played cannot tell: a program, what is changed in it, and a line of the answer.
HEAD = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
LOOP = (
    HEAD
    + "Dim n As Integer, t As Integer, b As Integer\nLoop\n  PAUSE INX(1)\n{}\n  PAUSE Not INX(1)\nEnd Loop\n"
)
GO = " : GO(0) : PAUSE IDLE(0)"
COUNT = LOOP.format('  n = n + 1\n  If n = 60 Then PRINT "full" : n = 0')
VERDICTS = [
    # Two inputs that decide together; a level that nothing waits for, and one that a speed depends on.
    (LOOP.format(f"  If INX(2) And INX(3) Then MOVER(0) = 7{GO}"), "= 7", "= 8",
     "start; input 1 on and input 2 on and input 3 on: A axis 0"),
    ("Loop\n  If ADC(0) > 60 Then OUTX(1) = 1 Else OUTX(1) = 0\n  WAIT(20)\nEnd Loop\n", "60", "62",
     "start; analogue input 0 = 62: A output 1 on"),
    (LOOP.format(f"  SPEED(0) = 20 + ADC(0) * 10\n  MOVER(0) = 100{GO}"), "* 10", "* 12", "with analogue input 0 "),
    # A master that turns.
    (f"MASTERCHANNEL(0) = 2 : MASTERSOURCE(0) = 2 : FOLLOW(0) = 1\n{LOOP.format('  OUTX(1) = 1')}",
     "FOLLOW(0) = 1", "FOLLOW(0) = 2", "with encoders that turn: A axis 0 FOLLOW at 1000"),
    # A count, a press that is long, a time-out.
    (COUNT, "60", "61", "'full' comes 0.040 s later in B"),
    (COUNT, '"full"', '"box full"', "A 'full', then 'full', then 'full' and 21 more after 2.38 s, B 'box full'"),
    (COUNT, 'PRINT "full" : ', "", "A 'full', then 'full', then 'full' and 21 more after 2.38 s, B does not"),
    # The cycle, too, is played until the count is reached.
    pytest.param(LOOP.format(f"  MOVEA(0) = 5{GO} : MOVEA(0) = 0{GO}")
     .replace("End", '  n = n + 1\n  If n = 12 Then PRINT "full" : n = 0\nEnd'), '"full"', '"box full"', "in 2 ways",
     marks=pytest.mark.slow),
    (LOOP.format('  t = TIME\n  PAUSE Not INX(1)\n  If TIME - t > 2000 Then PRINT "long"'), '"long"', '"LONG"',
     "A 'long' after 0.00 s, B 'LONG'"),
    pytest.param(HEAD + 'Dim t As Integer\nLoop\n  t = TIME\n  PAUSE INX(1) Or TIME - t > 150000\n  PRINT "on"\n'
     "  PAUSE Not INX(1)\nEnd Loop\n", "150000", "190000", "start (200 s apart): 'on' comes 40.000 s later in B",
     marks=pytest.mark.slow),
    # An input that comes before a time-out that begins later in B.
    ('Dim t As Integer\nPAUSE INX(2)\nOUTX(1) = 1\nWAIT = 500\nIf INX(1) Then PRINT "early"\nt = TIME\n'
     'PAUSE INX(1) Or TIME > t + 2000\nIf INX(1) Then PRINT "hand" Else PRINT "none"\n', "500", "1500",
     "2 differ in time alone\nonly the time differs:\n"),
    # An output that is off at the same time, an input that comes as often as it must, and the place of a text.
    (LOOP.format(f"  MOVEA(0) = 100 : GO(0)\n  PAUSE POS(0) > 60\n  OUTX(3) = 1\n  PAUSE IDLE(0)\n  OUTX(3) = 0\n"
                 f"  MOVEA(0) = 0{GO}"), "> 60", "> 70", "output 3 on comes 0.100 s later in B"),
    (LOOP.format("") + 'Event IN5\n  n = n + 1\n  If n = 3 Then PRINT "third"\nEnd Event\n', '"third"', '"3rd"',
     "start; input 5 on 3 times: A 'third'"),
    (LOOP.format('  LINE 1, "BUSY"'), "LINE 1", "LINE 2", "A 'BUSY' at row 1 column 1 after 0.00 s"),
    # What was not carried out, did not come out both ways, or made no difference.
    (LOOP.format('  OUTX(1) = 1') + 'Event ONERROR\n  PRINT "error"\nEnd Event\n', '"error"', '"fault"',
     "not compared: line 9"),
    ('Dim k As Integer\nk = 1\nSelect Case k\nCase 1\n  PRINT "one"\nCase Else\n  PRINT "two"\nEnd Select\n',
     "Case 1", "Case 1, 3", "never false: line 4"),
    (LOOP.format("  Repeat\n    n = n + 1\n  Until n > 0"), "n > 0", "n > -1", "never false: line 7"),
    (LOOP.format("  n = 5 : OUTX(1) = 1"), "n = 5", "n = 6",
     "line 5 changed, and nothing that was played depends on it"),
    (LOOP.format("  OUTX(1) = ADC(0) > 60"), "Integer, b", "Float, b",
     "line 2 changed, and nothing that was played depends on it"),
    (LOOP.format("  MOVER(0) = 10"), "MOVER", "MOVEA", "line 5 changed, and nothing that was played depends on it"),
    (LOOP.format(" OUTX(1) = 1") + "Event IN5\n  n = 1\nEnd Event\n", "IN5", "IN6",
     "line 8 changed, and nothing that was played depends on it"),
    # A level and a variable that are printed.
    (LOOP.format("  PRINT ADC(0) * 10"), "* 10", "* 12", "A '410.0000' after 0.00 s, B '492.0000'"),
    (LOOP.format("  n = 7\n  PRINT n"), "PRINT n", "PRINT b + 7",
     "line 6 changed, and nothing that was played depends on it"),
    # A statement that is written twice, and two that are swapped.
    (LOOP.format("  If INX(2) Then\n    n = 0\n  Else\n    n = n + 1\n  End If\n  n = n * 2\n  n = 0"),
     "    n = 0\n", "",
     "line 6 of A changed, and nothing that was played depends on it"),
    (LOOP.format('  If INX(2) Then n = 0\n  If INX(3) Then n = n + 1\n  If n = 2 Then PRINT "TWO"'),
     "  If INX(2) Then n = 0\n  If INX(3) Then n = n + 1\n", "  If INX(3) Then n = n + 1\n  If INX(2) Then n = 0\n",
     "'TWO' comes 0.040 s later in B (line 7 of A)"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "old", "new", "said"), VERDICTS, ids=lambda each: None)
def test_a_change_shows_or_is_named(cell: Cell, text: str, old: str, new: str, said: str) -> None:
    cell.write("a.mnt", text)
    cell.write("b.mnt", text.replace(old, new, 1))
    ran = cell("diff", "a.mnt", "b.mnt", "--explore")
    assert (ran.status, said in ran.out) == (1, True), ran.out
    assert "off comes" not in ran.out


SPELLINGS = [
    [("n = n + 1", "n = 1 + n"), ("n > 2", "2 < n")],
    [("n", "count")],
    [("Dim n", "Const much = 2\nDim n"), ("n > 2", "n > much"), ("n", "count")],
    [("MOVER(0) = 10", "MR.0=far"), ("Dim", "' another notation\nConst far = 10\nDim")],
    [(f"MOVER(0) = 10{GO}", "Feed"), ("End Loop\n", f"End Loop\nSub Feed()\n  MOVER(0) = 10{GO}\nEnd Sub\n")],
]


@pytest.mark.parametrize("edits", SPELLINGS)
def test_another_spelling_is_the_same(cell: Cell, edits: list[tuple[str, str]]) -> None:
    text = LOOP.format(f"  n = n + 1\n  If n > 2 Then OUTX(1) = 1\n  MOVER(0) = 10{GO}")
    cell.write("a.mnt", text)
    for old, new in edits:
        assert old in text
        text = text.replace(f" {old}", f" {new}") if len(old) == 1 else text.replace(old, new, 1)
    cell.write("b.mnt", text)
    ran = cell("diff", "a.mnt", "b.mnt", "--explore")
    assert (ran.status, "the same" in ran.out) == (0, True), ran.out


@pytest.mark.parametrize(
    ("old", "new"),
    [("n <> 2147483647", "n < 2147483647"), ("n <> -2147483647 - 1", "n > -2147483647 - 1")],
)
def test_no_integer_is_beyond_the_first_and_the_last(cell: Cell, old: str, new: str) -> None:
    text = LOOP.format(f"  n = n + 1\n  If {{}} Then OUTX(1) = 1\n  MOVER(0) = 10{GO}")
    for name, condition in (("a", old), ("b", new)):
        cell.write(f"{name}.mnt", text.format(condition))
    ran = cell("diff", "a.mnt", "b.mnt", "--explore")
    assert (ran.status, "4 the same by their text" in ran.out) == (0, True), ran.out

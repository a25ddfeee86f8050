"""Long programs are split into chunks that are compiled on demand.

Every page and every script is run normally, and again in chunks of a few lines, each compiled at its first
call. The reports must be equal to the last digit of every time.
"""

from __future__ import annotations

from marshal import loads
from pathlib import Path
from types import CodeType

import pytest

from motionlang import run
from motionlang.cache import CHECKSUM
from motionlang.errors import ProgramError
from motionlang.lang.machine.file import read_machine
from motionlang.mint import DIALECT
from motionlang.mint.compile import assembly, jumps, loops, splitting
from motionlang.mint.program import MintProgram, compile_source, load
from motionlang.source import Source

ROOT = Path(__file__).parents[3]
PROGRAMS = sorted(
    path
    for folder in ("scripts/mint", "tests/spec/mint", "tests/spec/mint/machine", "tests/errors/mint")
    for path in (ROOT / folder).glob("*.mnt")
)
# They spend most of their time on a motor; their programs are short.
MOTORS = {"torque", "wrapped_compare"}


def test_chunk_of_a_long_program_is_not_a_caller() -> None:
    """The wait between 800 statements of the main program has no callers."""
    text = "Dim n As Integer\n" + "n = n + 1\n" * 400 + "WAIT(5)\n" + "n = n + 1 : OUTX(1) = 1\n" * 400
    (wait,) = run(Source("long.mnt", text), cache=False).machine.log.waits
    assert wait.callers == ()


def test_a_jump_out_of_a_loop_is_logged_alike_in_groups(monkeypatch: pytest.MonkeyPatch) -> None:
    """A Goto leaves the loop and the chunk that contains it."""
    text = "n = 0\n#begin\nWhile 1\nn = n + 1\nIf n > 1000 Then Goto last\nEnd While\n#last\nPRINT n\n"

    def loops_of() -> list[object]:
        return list(run(Source("a.mnt", text), cache=False).machine.log.loops)

    whole = loops_of()
    assert len(whole) == 1
    monkeypatch.setattr(jumps, "MAX_STRETCHES", 0)
    monkeypatch.setattr(jumps, "SIZE", 1)
    assert loops_of() == whole


def test_a_gosub_may_be_in_forty_loops() -> None:
    """Python allows twenty nested blocks, so chunks call their function's dispatcher."""
    loops = "While n < 3\n" * 40 + "Gosub up\n" + "End While\n" * 40
    result = run(Source("deep.mnt", f"n = 0\n{loops}PRINT n\nEnd\n#up\nn = n + 1\nReturn\n"), cache=False)
    assert (result.status, result.output) == ("ended", ["3.0000"])


def machine_of(path: Path) -> dict[str, object]:
    """Return the machine of a page or script.

    It is in a file next to it, or in the page's own comments.
    """
    for beside in (path.with_suffix(".toml"), path.with_suffix(".machine.toml")):
        if beside.exists():
            return read_machine(Source.read(beside))
    lines = [line[3:] for line in path.read_text().split("\n") if line.startswith("'| ")]
    return read_machine(Source("machine.toml", "\n".join(lines)))


def short_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(splitting, "MAX_LINES", 6)
    monkeypatch.setattr(splitting, "SIZE", 4)
    monkeypatch.setattr(splitting, "MAX_INDENT", 3)
    monkeypatch.setattr(splitting, "MAX_LOOPS", 1)
    monkeypatch.setattr(loops, "MANY_CASES", 1)
    monkeypatch.setattr(jumps, "MAX_STRETCHES", 0)
    monkeypatch.setattr(jumps, "SIZE", 4)
    monkeypatch.setattr(assembly, "SIZE", 4)
    monkeypatch.setattr(assembly, "SHORT", 0)


@pytest.mark.parametrize(
    "path",
    [
        pytest.param(path, marks=pytest.mark.long) if path.stem in MOTORS or number % 6 else path
        for number, path in enumerate(PROGRAMS)
    ],
    ids=[path.stem for path in PROGRAMS],
)
def test_chunks_make_no_difference(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    settings = machine_of(path)
    whole = run(path, machine=settings, cache=False).report
    short_parts(monkeypatch)
    assert run(path, machine=settings, cache=False).report == whole


@pytest.mark.parametrize("cut", [False, True], ids=["whole", "in parts"])
@pytest.mark.slow
def test_every_line_names_the_variables_that_are_shared(cut: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """A shared variable that a line did not declare would become a different global."""
    if cut:
        short_parts(monkeypatch)
    for path in PROGRAMS:
        try:
            code = compile_source(Source.read(path), machine_of(path)).code
        except ProgramError:
            continue
        for unit in code.units:
            inner = list(unit.compile())
            while inner:
                each = inner.pop()
                assert not {*code.shared, "t", "H"} & {*each.co_names}, (path, each.co_name)
                inner += [const for const in each.co_consts if isinstance(const, CodeType)]


def program(text: str) -> MintProgram:
    compiled = DIALECT.compile(Source("long.mnt", text))
    assert isinstance(compiled, MintProgram)
    return compiled


STATEMENTS = "\n".join(f"x = x + {n} : PRINT x" for n in range(1, 1001))


def test_a_long_program_is_compiled_as_it_runs() -> None:
    text = f"{STATEMENTS}\nIf x < 0 Then Never()\nSub Never()\n{STATEMENTS}\nEnd Sub\n"
    long = program(text)
    units = len(long.code.units)
    assert long.size == 1 < units
    result = run(Source("long.mnt", text), cache=False)
    assert result.output[-1] == "500500.0000"
    assert result.time == pytest.approx(2001 * 1e-5)


def test_cache_stores_functions_that_a_run_compiled(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MOTIONLANG_CACHE", str(tmp_path))
    monkeypatch.delenv("MOTIONLANG_NO_CACHE", raising=False)
    text = f"{STATEMENTS}\nIf x < 0 Then Never()\nSub Never()\n{STATEMENTS}\nEnd Sub\n"
    first = run(Source("long.mnt", text))
    (entry,) = tmp_path.iterdir()
    _, _, payload = loads(entry.read_bytes()[CHECKSUM:])
    kept = load(payload)
    assert 1 < kept.size < len(kept.code.units)
    assert run(Source("long.mnt", text)).report == first.report


def test_functions_that_were_not_called_are_stored_as_text() -> None:
    long = program(f"PRINT 1\nSub Never()\n{STATEMENTS}\nEnd Sub\n")
    again = load(long.payload())
    assert [unit.is_compiled for unit in again.code.units] == [unit.is_compiled for unit in long.code.units]
    for unit in (*again.code.units, *long.code.units):
        unit.compile()
    again = load(again.payload())
    assert again.size == len(long.code.units)
    assert again.code.units[-1].compile() == long.code.units[-1].codes


@pytest.mark.parametrize(
    ("around", "end"),
    [
        ("", ""),
        ("Sub Work(a)\n", "End Sub"),
        ("Task Work\n", "End Task"),
        ("While 1\n", "End While"),
        ("If 1 Then\n", "End If"),
    ],
)
def test_mistake_is_reported_at_its_location(around: str, end: str) -> None:
    call = {"S": "Work(3)\n", "T": "Run Work\nWAIT(1000)\n"}.get(around[:1], "")
    body = f"{STATEMENTS}\nx = 1 / (x - x)\n{STATEMENTS}\n"
    text = f"{call}{around}{body}{end}\n" if not call else f"{call}End\n{around}{body}{end}\n"
    (found,) = run(Source("long.mnt", text), cache=False).diagnostics
    line = text.split("\n").index("x = 1 / (x - x)") + 1
    assert (found.code, found.line) == ("division-by-zero", line)


LEAVES = """
For i = 1 To 3
  PRINT "begin "; i
{}
  If i = 2 Then Exit For
{}
Next
PRINT "behind"
Loop
{}
  k = k + 1
  If k = 2 Then Exit Loop
{}
End Loop
Show()
End
Sub Show()
{}
  If x > 5 Then Exit Sub
  PRINT "never"
{}
End Sub
"""


def test_what_leaves_a_block_stays_in_it() -> None:
    some = "\n".join("  x = x + 1\n  If x = -1 Then PRINT x" for _ in range(500))
    result = run(Source("long.mnt", LEAVES.format(*[some] * 6)), cache=False)
    assert result.diagnostics == []
    assert result.output == ["begin 1.0000", "begin 2.0000", "behind"]


def test_a_loop_that_polls_may_be_long() -> None:
    some = "\n".join(f"  If x = {n} Then PRINT x" for n in range(-1000, 0))
    result = run(Source("long.mnt", f"x = 1\nTIME = 0\nWhile TIME < 5000\n{some}\nEnd While\n"), cache=False)
    assert result.diagnostics == []
    assert result.time == pytest.approx(5.0, abs=0.02)


@pytest.mark.slow
def test_a_choice_may_have_many_branches() -> None:
    cases = "\n".join(f"Case {n}\n  PRINT {n}" for n in range(5000))
    branches = "\n".join(f"ElseIf x = {n} Then\n  PRINT {n}" for n in range(190))
    text = f"x = 189\nSelect Case x\n{cases}\nEnd Select\nIf x < 0 Then\n  x = 0\n{branches}\nEnd If\n"
    result = run(Source("long.mnt", text), cache=False)
    assert result.diagnostics == []
    assert result.output == ["189", "189"]


def test_sub_in_chunks_may_recur() -> None:
    some = "\n".join("  y = y + 1" for _ in range(800))
    text = f"""
PRINT Down(3)
Function Down(ByVal n As Integer) As Integer
Dim y
{some}
  If n > 0 Then y = y + Down(n - 1)
{some}
  Down = y
End Function
"""
    result = run(Source("long.mnt", text), cache=False)
    assert result.diagnostics == []
    assert result.output == [str(4 * 1600)]


def nested(count: int, leaf: str) -> str:
    return "While x < 3\n" * count + leaf + "\n" + "Exit\nEnd While\n" * count


# More nested loops than CPython allows, and the output of the program.
DEEP = {
    "counted": (
        "For i = 1 To 1\n" * 60 + "x = x + 1\n" + "Next\n" * 60 + "Print x",
        ["1.0000"],
    ),
    "left one by one": (nested(60, "x = x + 1") + "Print x", ["1.0000"]),
    "left at once by a jump": (nested(60, "x = 7 : Goto out") + "x = 8\n#out\nPrint x", ["7.0000"]),
    "left for a loop a few further out": (
        "For i = 1 To 5\n" + nested(12, "x = x + 1 : WAIT = 1\nExit For") + "Next\nPrint x; i",
        ["1.00001.0000"],
    ),
    "in a task that others see": (
        "Run t\nPause x > 2\nPrint x\nTask t\nDim y\n"
        + nested(30, "x = x + 5 : y = x : WAIT = 2")
        + "End Task",
        ["5.0000"],
    ),
    "in a sub that calls itself": (
        "f(3)\nPrint x\nSub f(a)\n"
        + nested(20, "x = x + 0.1\nIf a > 0 Then f(a - 1)")
        + "x = x + a\nEnd Sub",
        ["6.4000"],
    ),
    "with a parameter by reference": (
        "x = 1\nf(2, x)\nPrint x\nSub f(a, ByRef b)\nDim i\nFor i = 1 To 3\n"
        + nested(30, "b = b + a + i")
        + "Next\nEnd Sub",
        ["4.0000"],
    ),
    "with a handler of errors": (
        nested(30, "i = 3 : a(i) = 1 : x = 2") + "Print x\nEnd\nEvent ONERROR\nPrint ERRCODE > 0\nEnd Event",
        ["1", "2.0000"],
    ),
}


@pytest.mark.parametrize("name", DEEP)
def test_more_loops_within_one_another_than_python_takes(name: str) -> None:
    text, output = DEEP[name]
    result = run(Source("deep.mnt", f"Dim x, i, a(2)\n{text}\n"), cache=False)
    assert (result.output, result.diagnostics) == (output, [])


def test_iteration_of_many_loops_takes_the_time_of_its_statements() -> None:
    """An iteration has sixty loop headers, one assignment and sixty loop ends."""
    text = "Dim x, i\n" + "For i = 1 To 1\n" * 60 + "x = x + 1\n" + "Next\n" * 60
    assert run(Source("deep.mnt", text), cache=False).time == pytest.approx(121 * 10e-6)

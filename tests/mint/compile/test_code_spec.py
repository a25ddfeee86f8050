"""The Python of small programs and what they print: `code_spec.txt`.

Each line of the golden file follows from `docs/contributing/architecture.md`, "To read generated code".
"""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang import run
from motionlang.execution import accelerators
from motionlang.mint import DIALECT
from motionlang.mint.compile.compiler import compile_line, compile_module
from motionlang.mint.compile.listing import listing
from motionlang.mint.program import compile_source
from motionlang.mint.resolve.symbols import Function, Scope
from motionlang.mint.syntax.parser import parse
from motionlang.source import Source
from motionlang.views.listing import render_listing

HERE = Path(__file__).parent
GOLDEN = HERE / "code_spec.golden.txt"


def blocks(path: Path) -> dict[str, str]:
    """Return the blocks of a file, by their first line."""
    found = path.read_text().removesuffix("----\n").split("\n----\n")
    return {block.partition("\n")[0]: block.partition("\n")[2].rstrip("\n") for block in found}


# To each INPUT in turn.
ANSWERS = ["2", "1.5", "ab", "7"]
SAMPLES = blocks(HERE / "code_spec.txt")


def shown(text: str) -> str:
    """Return the code of a program, the facts of its loops, and its run.

    The facts are those by which a run skips iterations. The run is given by its output and its time.
    """
    source = Source("a.mnt", text + "\n")
    program = compile_source(source, {}, {}, ranges=accelerators(True).ranges)
    assert program.outline is not None
    found = listing(program.code, program.outline[1])
    found.head = ""
    code = "".join(render_listing(DIALECT, source, found, colour=False))
    facts = [repr(each) for each in program.code.specs if each[0] in ("loop", "counters")]
    result = run(source, until=1.0, cache=False, answers=ANSWERS)
    errors = [each.message for each in result.diagnostics if each.severity == "error"]
    return "\n".join([code.strip("\n"), *facts, "", *result.output, *errors, f"{result.time * 1000:.3f} ms"])


@pytest.mark.parametrize("name", SAMPLES)
def test_the_code_of_a_program(name: str, request: pytest.FixtureRequest) -> None:
    if request.config.getoption("--update"):
        GOLDEN.write_text("\n----\n".join(f"{each}\n{shown(text)}" for each, text in SAMPLES.items()) + "\n")
    assert shown(SAMPLES[name]) == blocks(GOLDEN)[name]


def test_every_program_has_its_golden() -> None:
    assert list(SAMPLES) == list(blocks(GOLDEN))


DEBUGGED = """\
Dim n As Integer, pad(2) As Float
Type Spot
 x As Float
End Type
Dim p As Spot
Raise(n, pad)
While INX(1)
End While
Sub Raise(ByRef what As Integer, list() As Float)
 #here
 what = what + 1
End Sub
"""


def test_a_debug_build_counts_statements_and_describes_its_variables() -> None:
    """The numbers are the offsets of the call, the While and the assignment.

    `t + 1.0` is the time after a statement that is not paid for yet. A label has no hook, and an empty loop has that of
    its While.
    """
    compiled = compile_module(parse(Source("a.mnt", DEBUGGED)), debug=True)
    hooks = [line.strip() for line in compiled.code.text.split("\n") if ": B(" in line or "m_ =" in line]
    assert hooks == [
        "m_ = lambda: (v_n, v_pad, v_p,)",
        "if (n := n + 1) >= N or (D is not None and 79 in D): B(t, 79)",
        "if (n := n + 1) >= N or (D is not None and 93 in D): B(t + 1.0, 93)",
        "if (n := n + 1) >= N or (D is not None and 93 in D): B(t, 93)",
        "m_ = lambda: (p_what, p_what_k, p_list,)",
        "if (n := n + 1) >= N or (D is not None and 174 in D): B(t, 174)",
    ]
    integer, pad = ("Integer", (), ()), ("Float", (2,), ())
    spot = ("Spot", (), (("x", ("Float", (), ())),))
    main = (("n", "v_n", integer, "boxed"), ("pad", "v_pad", pad, ""), ("p", "v_p", spot, ""))
    raises = (("what", "p_what", integer, "by_ref"), ("list", "p_list", ("Float", (0,), ()), ""))
    assert compiled.stops == ([79, 93, 174], {"main": ("main", main), "s_raise": ("Raise", raises)})


TYPED = """\
Dim b As Float, c(2) As Integer
a = b + POS(0)
PRINT s, POS(0)
WAIT(5)
Task Wink
 OUTX(a) = 1
End Task
"""


def test_a_typed_line_declares_its_new_names_alone() -> None:
    """Names are globals of the session, and operations have the suffix of the line.

    A printed position is rounded to whole counts.
    """
    scope = Scope(Function("main", "main", "main", [], None), None)
    compile_line(parse(Source("1", "Dim a As Integer, s As String")), {}, scope, "_1", "1")
    line = compile_line(parse(Source("2", TYPED)), {}, scope, "_2", "2")
    values: dict[str, object] = {}
    exec(line.first, values)
    del values["__builtins__"]
    assert values == {"v_b": 0.0, "v_c": [0, 0, 0]}
    assert (line.unit.names, line.blocks) == (("main", "k_wink"), {"task wink": "k_wink"})
    assert line.unit.text.split("\n") == [
        " def main():",
        "  nonlocal H, t",
        "  global v_a",
        "  if T(0.0): yield",
        "  v_a = k1_2(v_b + k0_2())",
        "  if T(1.0): yield",
        "  k4_2(v_s + k3_2(k2_2(k0_2(), 0)) + '\\n')",
        "  t += 1.0",
        "  t, H = k5_2(t) or (yield E.wait)",
        "  t += 1.0",
        " def k_wink():",
        "  nonlocal H, t",
        "  if t >= H: yield",
        "  if k6_2(0.0, v_a, 1): yield",
        "  t += 1.0",
    ]
    assert line.offsets == [0, 0, 0, 0, 0, 0, 32, 32, 47, 47, 63, 63, 63, 71, 71, 82, 82, 82]
    assert dict(zip(line.operations, line.specs, strict=True)) == {
        "k0_2": ("read", "POS", 0),
        "k1_2": ("fn", "integer"),
        "k2_2": ("env", "in_whole_counts"),
        "k3_2": ("show", "float"),
        "k4_2": ("read", "(printer)"),
        "k5_2": ("wait", 63, 5.0, False),
        "k6_2": ("write", "OUTX"),
    }


def test_a_typed_line_without_a_task_reads_its_variables_late() -> None:
    """Another line may run at the same time, so `a` is read after what is due before."""
    scope = Scope(Function("main", "main", "main", [], None), None)
    line = compile_line(parse(Source("1", "Dim a As Float\nSPEED(0) = a")), {}, scope, "", "1")
    assert line.unit.text.split("\n")[1:] == [
        "  nonlocal H, t",
        "  if t >= H: yield",
        "  if k0(0.0, v_a): yield",
        "  t += 1.0",
    ]

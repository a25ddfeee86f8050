"""The listing of a program is exactly the code that a run executes."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from motionlang.execution import accelerators, run
from motionlang.mint import DIALECT
from motionlang.mint.program import MintProgram
from motionlang.mint.runtime.code_units import Unit
from motionlang.source import Source
from motionlang.views.listing import WIDTH, render_listing
from tests.cases import cases

# A poll and a print with long lines, a text that looks like an operation, variables that functions share.
PROGRAM = """\
Dim done As Integer, parts As Integer
Dim marks(3) As Float = 1, 2, 3
Run Feed
While Not (done And IDLE(0) And IDLE(1))
Wend
Print "k0  and  'k1'  "; parts; "  of a long line,  whose blanks stay as they are,  "; TIME; "  ms"
GoSub last
End
#last
Return
Task Feed
  MOVER(0) = marks(2) : GO(0)
  PAUSE IDLE(0) And Not done And POS(0) > 1 And POS(0) < 100
  done = 1
  parts = parts + 1
End Task
"""
GALLERY = sorted((Path(__file__).parents[3] / "scripts" / "mint").glob("*.mnt"))


def executed(text: str) -> str:
    """Return the syntax trees of a program's code, free of comments and line breaks."""
    return ast.dump(ast.parse(f"def _():\n{text}"))


@pytest.mark.parametrize("fast", [True, False])
def test_the_code_is_what_runs_from_the_cache(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, fast: bool
) -> None:
    monkeypatch.setenv("MOTIONLANG_CACHE", str(tmp_path / "cache"))
    source = Source(
        "a.mnt",
        "Dim v = 45\nWhile v < 50\n  v = v + 1\nEnd While\nSPEED(0) = v\nMOVER(0) = 5\nGO(0)\nPAUSE IDLE(0)\n",
    )
    run(source, fast=fast)
    program = run(source, fast=fast).program
    assert isinstance(program, MintProgram)
    (cached,) = program.code.units
    assert cached.text == ""  # the cache has no text of the compiled code
    listing = DIALECT.listing(source, {}, {}, accelerators(fast).ranges)
    text = "\n".join(code for _, code, _ in listing.lines)
    assert Unit(cached.names, text, cached.before, cached.cells).compile() == cached.compile()


@cases("source", [Source("a.mnt", PROGRAM), *map(Source.read, GALLERY)], ids=lambda source: source.name)
def test_rendered_code_is_the_same_code(source: Source) -> None:
    listing = DIALECT.listing(source, {}, {})
    shown = list(render_listing(DIALECT, source, listing, colour=False))
    assert executed("".join(shown)) == executed("\n".join(code for _, code, _ in listing.lines))


def test_code_fits_a_terminal() -> None:
    source = Source("a.mnt", PROGRAM)
    listing = DIALECT.listing(source, {}, {})
    assert max(len(code) for _, code, _ in listing.lines) > WIDTH
    shown = "".join(render_listing(DIALECT, source, listing, colour=False)).splitlines()
    assert max(len(line) for line in shown if line not in {f"#   6  {PROGRAM.splitlines()[5]}"}) <= WIDTH


def test_first_values_precede_the_functions() -> None:
    source = Source("a.mnt", PROGRAM)
    lines = [code for _, code, _ in DIALECT.listing(source, {}, {}).lines]
    shown: dict[str, object] = {}
    exec("\n".join(lines[: lines.index(" def main():")]).replace("\n ", "\n").strip(), shown)
    program = DIALECT.compile(source)
    assert isinstance(program, MintProgram)
    assert program.code.first is not None
    values: dict[str, object] = {}
    exec(program.code.first, values)
    del shown["__builtins__"], values["__builtins__"]
    assert shown == values == {"v_done": 0, "v_parts": 0, "v_marks": [0.0] * 4}


def test_operations_are_named_but_not_in_texts() -> None:
    listing = DIALECT.listing(Source("a.mnt", 'SPEED(0) = 5\nPrint "k0"\nGO(0, 1)\n'), {}, {})
    assert [note for _, _, note in listing.lines if note] == ["k0 write SPEED(0)", "k1 do GO(0, 1)"]


def test_variables_of_one_name_are_numbered_from_2() -> None:
    """Each sub has its own x, listed as v_x_2 and v_x_3 after the global x."""
    text = "Dim x\none\nSub one\n Dim x\n x = 1\nEnd Sub\nSub two\n Dim x\n x = 2\nEnd Sub\n"
    code = [each.strip() for _, each, _ in DIALECT.listing(Source("a.mnt", text), {}, {}).lines]
    assert [each for each in code if each.endswith((" = 1.0", " = 2.0"))] == ["v_x_2 = 1.0", "v_x_3 = 2.0"]

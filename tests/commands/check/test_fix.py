"""`check --fix` writes only certain corrections."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from pathlib import Path

import pytest

from motionlang import diff, run
from motionlang.commands.diff.runs import runs_text
from motionlang.kernel import Source, dialect_of, settings_next_to
from tests.cases import cases
from tests.cli.programs import Cell

ROOT = Path(__file__).parents[3]


def of_v4(folder: Path) -> list[Path]:
    """Return the programs of a folder in the notation of Mint v4."""
    return [
        path
        for path in sorted(folder.iterdir())
        if path.suffix in (".mnt", ".prg")
        and re.search(r"\b(ENDIF|ENDW|ENDL)\b|\bSPEED\.0", path.read_text(encoding="utf-8").upper())
    ]


V4 = [path for folder in ("scripts/mint", "tests/spec/mint") for path in of_v4(ROOT / folder)]
# Machine seconds of the runs before and after a port.
SECONDS = 10.0


def test_a_number_without_brackets(cell: Cell) -> None:
    path = cell.folder / "a.mnt"
    path.write_bytes("\ufeffMOVER(3) = 5 ' caf\u00e9\r\nGo3 : MOVER(3) = 4\r\nGo3 : SPED(0) = 3\n".encode())
    ran = cell("check", "a.mnt", "--fix")
    assert path.read_bytes() == (
        "\ufeffMOVER(3) = 5 ' caf\u00e9\r\nGO(3) : MOVER(3) = 4\r\nGO(3) : SPED(0) = 3\n".encode()
    )
    assert (ran.status, ran.out.splitlines()[-1]) == (1, "a.mnt: 2 fixed, 1 error")
    assert ran.out.startswith(
        "a.mnt:2:1: fixed[unknown-word]: Go3 -> GO(3)\na.mnt:3:1: fixed[unknown-word]: Go3 -> GO(3)\nerror["
    )
    assert "did you mean SPEED?" in ran.out


def test_the_notation_of_the_other_age(cell: Cell) -> None:
    text = "SPEED.0 = 10\nIF INX.1 DO\n  x = 7 % 4\nENDIF\nWHILE INX.1\n  WAIT = 5\nENDW\nPRINT x\n"
    cell.write("old.prg", text)
    assert cell("check", "old.prg", "--fix").status == 0
    assert (cell.folder / "old.prg").read_text() == text
    ran = cell("check", "old.prg", "--model", "mintmt", "--fix")
    assert (cell.folder / "old.prg").read_text() == (
        "SPEED(0) = 10\nIF INX(1) Then\n  x = 7 Mod 4\nEnd If\nWHILE INX(1)\n  WAIT = 5\nEnd While\n"
        "PRINT x USING 1, 0\n"
    )
    assert "old.prg:2:10: fixed[model]: DO -> Then\n" in ran.out
    assert ran.out.endswith("\nold.prg: 8 fixed, no problems\n")


BLOCKS = {
    "a block": ("IF a DO\n b = 1\nELSE\n b = 2\nENDIF\n", "IF a Then\n b = 1\nELSE\n b = 2\nEnd If\n"),
    "inside one another": (
        "LOOP\n\tIF a DO\n\t\tIF b DO\n\t\tENDIF\n\tENDIF\n\tEXIT\nENDL\n",
        "LOOP\n\tIF a Then\n\t\tIF b Then\n\t\tEnd If\n\tEnd If\n\tEXIT\nEnd Loop\n",
    ),
    "on one line, where Then would be an If of one line": (
        "  IF a DO b = 1 : ENDIF : b = 2\n",
        "  IF a Then\n    b = 1 : End If : b = 2\n",
    ),
    "with a colon": ("IF a DO : b = 1\nENDIF\n", "IF a Then\n  : b = 1\nEnd If\n"),
    "with a comment": ("IF a DO ' go\nENDIF\n", "IF a Then ' go\nEnd If\n"),
    "ElseIf": (
        "IF a DO\nELSE IF b DO b = 1\nELSEIF b DO\nENDIF\n",
        "IF a Then\nELSE IF b Then b = 1\nELSEIF b Then\nEnd If\n",
    ),
    "a list of axes": (
        "SPEED[0,1] = 600, ADC[0] : STOP[ 0, 1 ] ' [both]\n",
        "SPEED(0,1) = 600, ADC(0) : STOP( 0, 1 ) ' [both]\n",
    ),
    "a list of axes in two lines": ("STOP[0, _\n 1]\n", "STOP(0, _\n 1)\n"),
    "a remainder without blanks": ("b = 7%4 + a %b\n", "b = 7 Mod 4 + a Mod b\n"),
    "an index of many digits": ("COMMS.1 = IN.12\n", "COMMS(1) = IN(12)\n"),
    "line ends of DOS": ("IF a DO b = 1 : ENDIF\r\n", "IF a Then\r\n  b = 1 : End If\r\n"),
}


@pytest.mark.parametrize("name", BLOCKS)
def test_a_block_is_fixed_as_a_whole(name: str, cell: Cell) -> None:
    """The fixed program compiles for MintMT, and nothing is left to fix."""
    old, new = BLOCKS[name]
    head = "Dim a, b As Integer\n".replace("\n", "\r\n" if "\r" in old else "\n")
    path = cell.write("old.prg", head + old)
    check = ("check", "old.prg", "--model", "mintmt", "--fix")
    assert cell(*check).status == 0
    assert path.read_bytes().decode() == head + new
    assert "fixed" not in cell(*check).out
    assert path.read_bytes().decode() == head + new


def test_more_fixes_than_a_check_reports_mistakes(cell: Cell) -> None:
    """A check stops at 100 errors, in the middle of a block."""
    path = cell.write("old.prg", "a = 1\n" + "IF a DO\n a = INX.0\nENDIF\n" * 40 + "OUT.0 = a\n")
    ran = cell("check", "old.prg", "--model", "mintmt", "--fix")
    assert ran.out.splitlines()[-1] == "old.prg: 121 fixed, no problems"
    assert path.read_text() == "a = 1\n" + "IF a Then\n a = INX(0)\nEnd If\n" * 40 + "OUT(0) = a\n"


@pytest.mark.parametrize("path", V4, ids=lambda path: path.stem)
def test_a_ported_program_does_the_same(path: Path, cell: Cell) -> None:
    """The programs are those of the gallery and the manual in the notation of Mint v4.

    Those of old machines, which need a world, are in `extras/explore`.
    """
    assert_port_is_the_same(path, settings_next_to(path), cell)


def assert_port_is_the_same(path: Path, machine: Mapping[str, object], cell: Cell) -> None:
    """Port a program, and compare its run with the one before.

    What differs is the number of decimals of what the port has reported.
    """
    before = Source.read(path)
    language = dialect_of(path.name)
    assert language is not None
    old = language.program(before).target.model or "mintmt"  # the notation of both: it stays MintMT
    written = cell.folder / path.name
    written.write_bytes(path.read_bytes())
    cell("check", path.name, "--model", "mintmt", "--fix")
    after = Source.read(written)
    assert after.text != before.text
    assert "fixed" not in cell("check", path.name, "--model", "mintmt", "--fix").out
    old_run, new_run = (
        run(source, machine={**machine, "controller.model": model}, until=SECONDS)
        for source, model in ((before, old), (after, "mintmt"))
    )
    found = diff(old_run, new_run)
    bare = (
        [[re.sub("[.0]", "", str(act)) for act in acts] for acts in (each.a, each.b)]
        for each in found.differences
    )
    assert not found.later, runs_text(found)
    assert found.apart is None
    assert all(one == other for one, other in bare), runs_text(found)


def test_what_is_not_certain_stays(cell: Cell) -> None:
    cell.write("a.mnt", "SPED(0) = 3\nDim spare As Integer\n")
    cell("check", "a.mnt", "--fix")
    assert (cell.folder / "a.mnt").read_text() == "SPED(0) = 3\nDim spare As Integer\n"
    (cell.folder / "b.mnt").write_bytes(b"' caf\xe9\nGo3\n")
    assert cell("check", "b.mnt", "--fix").status == 1
    assert (cell.folder / "b.mnt").read_bytes() == b"' caf\xe9\nGo3\n"


def test_json_has_what_was_fixed(cell: Cell) -> None:
    cell.write("a.mnt", "MOVER(3) = 5\nGo3\nACCEL(3) = 9 : DECEL(3) = 9\nPAUSE IDLE(3)\n")
    ran = cell("check", "a.mnt", "--fix", "--format", "json")
    document = json.loads(ran.out)
    assert document["diagnostics"] == []
    (fixed,) = document["fixed"]
    assert (fixed["line"], fixed["column"], fixed["before"], fixed["after"]) == (2, 1, "Go3", "GO(3)")
    assert json.loads(cell("check", "a.mnt", "--fix", "--format", "json").out)["fixed"] == []
    assert cell("check", "a.mnt", "--fix").out == "a.mnt: no problems\n"
    assert "fixed" not in json.loads(cell("check", "a.mnt", "--format", "json").out)


PORTED = {
    "whole numbers": (
        "n = 1 : k = n * 2\nPRINT n, (n + k) , -k;\n",
        "PRINT n USING 1, 0, (n + k) USING 1, 0 , -k USING 1, 0;",
    ),
    "a format of its own": ("n = 1\nPRINT n USING 4\n", "PRINT n USING 4"),
    "words of MintMT": ('PRINT INX(0), TIME, "n"\n', 'PRINT INX(0), TIME, "n"'),
    "a mode of motion": ("PRINT MODE.0\n", "PRINT AXISMODE(0)"),
    "a mode of paths": ("CONTOURON[0, 1]\n", "CONTOURMODE(0, 1) = 1;"),
    "a mode of one axis": ("CONTOUROFF.1\n", "CONTOURMODE(1) = 0"),
    "an error in its handler": ("END\n#ONERROR\nPRINT ERR, ERL\n", "PRINT ERRCODE, ERRLINE"),
}


@pytest.mark.parametrize("name", PORTED)
def test_what_mintmt_does_in_its_own_way_is_ported(name: str, cell: Cell) -> None:
    old, new = PORTED[name]
    path = cell.write("old.prg", f"OUTX.4 = 1\n{old}")
    ran = cell("check", "old.prg", "--model", "mintmt", "--fix")
    assert ran.out.endswith(" fixed, no problems\n")
    assert path.read_text().splitlines()[-1] == new


def test_more_prints_than_a_check_reports(cell: Cell) -> None:
    path = cell.write("old.prg", "OUTX.4 = 1 : n = 1\n" + "PRINT n\n" * 150)
    ran = cell("check", "old.prg", "--model", "mintmt", "--fix")
    assert ran.out.splitlines()[-1] == "old.prg: 151 fixed, no problems"
    assert path.read_text() == "OUTX(4) = 1 : n = 1\n" + "PRINT n USING 1, 0\n" * 150


LEFT = {
    "n = 1 / 3\nPRINT n\n": "MintMT prints n with four decimals, Mint v4 with as many as it needs",
    'INPUT "n", n\nPRINT n\n': "MintMT prints n with four decimals, Mint v4 with as many as it needs",
    "PRINT POS.0\n": "MintMT prints POS(0) with four decimals, Mint v4 with as many as it needs",
    "PRINT ERR\n": "ERR is a word of Mint v4",
    "BANK = 1\n": "BANK is a word of Mint v4; MintMT has none for it",
}


@cases("text, message", LEFT.items())
def test_what_a_port_leaves_is_reported_once(text: str, message: str, cell: Cell) -> None:
    cell.write("old.prg", f"OUTX.4 = 1\n{text}")
    check = ("check", "old.prg", "--model", "mintmt", "--fix")
    assert f"warning[model]: {message}\n" in cell(*check).out
    assert cell(*check).out == "old.prg: no problems\n"


def test_a_port_reports_a_machine_file_of_the_old_model(cell: Cell) -> None:
    cell.write("old.prg", "OUTX.4 = 1\n")
    cell.write("old.machine.toml", 'controller.model = "NextMove BX"\n')
    ran = cell("check", "old.prg", "--model", "mintmt", "--fix")
    assert ran.out == (
        "old.prg:1:1: fixed[model]: OUTX.4 -> OUTX(4)\n"
        "warning[model]: old.machine.toml is still for another controller: "
        'controller.model = "NextMove BX"\n --> old.prg\n  hint: write controller.model = "mintmt"\n'
        "old.prg: 1 fixed, 1 warning\n"
    )


def test_a_program_with_a_line_of_v4_is_not_ported(cell: Cell) -> None:
    path = cell.write("a.mnt", "OUTX(4) = 1\nx = 1\nWhile x = 1\nx = 2\nENDW\nPRINT x\n")
    assert "1 fixed, no problems" in cell("check", "a.mnt", "--model", "mintmt", "--fix").out
    assert path.read_text().endswith("End While\nPRINT x\n")


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (b"MOVER(3) = 5\rGo3\rPAUSE IDLE(3)\r\n", "some of its lines end with a carriage return alone"),
        ("MOVER(3) = 5\r\nGo3\r\n".encode("utf-16"), "it is in UTF-16"),
    ],
)
def test_a_file_that_stays_as_it_is_says_why(data: bytes, why: str, cell: Cell) -> None:
    path = cell.folder / "a.mnt"
    path.write_bytes(data)
    assert f"a.mnt is not fixed: {why}" in cell("check", "a.mnt", "--fix").out
    assert path.read_bytes() == data


def test_a_file_that_cannot_be_written_says_so(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_: object, **__: object) -> None:
        raise OSError(28, "No space left on device")

    cell.write("a.mnt", "MOVER(3) = 5\nGo3\nPAUSE IDLE(3)\n")
    monkeypatch.setattr("motionlang.commands.check.fix.replacing", full)
    ran = cell("check", "a.mnt", "--fix")
    assert "a.mnt cannot be written: no space left on device" in ran.out
    assert "fixed" not in ran.out + ran.err


# Texts as a word processor leaves them, and what `--fix` writes.
TYPOGRAPHIC = {
    "a.mnt": (
        'PRINT “it’s here”, POS(0)\nPRINT "open”\nMOVER(0) = –5 ‘ the user’s way back\nGO(0)\u00a0: PRINT „x"\n',
        'PRINT "it’s here", POS(0)\nPRINT "open"\nMOVER(0) = -5 \' the user’s way back\nGO(0) : PRINT "x"\n',
    ),
    "a.mcl": (
        '1MN,1MR–100\nOT“in a row”,1WS\nOT"open”\n1MN,\u00a01TP\n',
        '1MN,1MR-100\nOT"in a row",1WS\nOT"open"\n1MN, 1TP\n',
    ),
}


@cases("name", TYPOGRAPHIC)
def test_typographic_characters_become_plain_ones(name: str, cell: Cell) -> None:
    before, after = TYPOGRAPHIC[name]
    cell.write(name, before)
    ran = cell("check", name, "--fix")
    assert (cell.folder / name).read_text(encoding="utf-8") == after
    assert ran.out.splitlines()[-1].startswith(f"{name}: {4 if name == 'a.mcl' else 6} fixed")


def test_a_message_names_the_plain_character(cell: Cell) -> None:
    """A pair of single quotes may be a text or a comment, so it is only reported."""
    cell.write("a.mnt", 'PRINT "open”\nPRINT ‘x’\n')
    ran = cell("check", "a.mnt")
    assert '” is a typographic quote, not a plain "' in ran.out
    assert "‘ is a typographic quote, not a plain '" in ran.out
    cell("check", "a.mnt", "--fix")
    assert (cell.folder / "a.mnt").read_text(encoding="utf-8") == 'PRINT "open"\nPRINT ‘x’\n'


@pytest.mark.parametrize(
    ("text", "summary"),
    [
        ("MOVER(3) = 5\nGo3\n", "1 error; --fix corrects it"),
        ("MOVER(3) = 5\nGo3\nMOVER(3) = 5\nGo3\n", "2 errors; --fix corrects all"),
        ("MOVER(3) = 5\nGo3\nSPED(0) = 3\n", "2 errors; --fix corrects 1"),
        ("SPED(0) = 3\n", "1 error"),
    ],
)
def test_a_check_says_what_it_would_fix(text: str, summary: str, cell: Cell) -> None:
    cell.write("a.mnt", text)
    assert cell("check", "a.mnt").out.splitlines()[-1] == f"a.mnt: {summary}"
    assert "--fix" not in cell("check", "a.mnt", "--fix").out


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("WAIT IDLE(0)\n", "PAUSE IDLE(0)\n"),
        ("Wait = Not INX(1)\n", "Pause Not INX(1)\n"),
        ("WT=INX(1)\n", "PAUSE INX(1)\n"),
    ],
)
def test_a_wait_for_a_condition_becomes_a_pause(before: str, after: str, cell: Cell) -> None:
    cell.write("a.mnt", before)
    cell("check", "a.mnt", "--fix")
    assert (cell.folder / "a.mnt").read_text() == after


def test_latin_1_stays_latin_1(cell: Cell) -> None:
    path = cell.folder / "old.mnt"
    path.write_bytes(b'\' gr\xfc\xdfe\r\nSPEED.0 = 5 : PRINT "M\xfcll"\r\n')
    assert "1 fixed" in cell("check", "old.mnt", "--model", "mintmt", "--fix").out
    assert path.read_bytes() == b'\' gr\xfc\xdfe\r\nSPEED(0) = 5 : PRINT "M\xfcll"\r\n'

"""Patterns that a command keeps are what `re` makes of the same text, and without `re`."""

from __future__ import annotations

import re
import subprocess
import sys
from itertools import islice
from pathlib import Path

import pytest

from motionlang import user_cache
from motionlang.bytecode import Finder
from motionlang.bytecode_writing import keep
from motionlang.lang.parsing.patterns import compiled
from motionlang.mccl.syntax import tables as mccl
from motionlang.mint.syntax import tables as mint
from tests.cases import cases

ROOT = Path(__file__).parents[3]
PROGRAMS = sorted((ROOT / "scripts").rglob("*.m[nc]?"))
TEXTS = ["x = `a`\n", *(path.read_text(encoding="utf-8") for path in PROGRAMS)]
PATTERNS = (mint.TOKEN, mint.CONTINUED, *mint.CLASSES.values(), mccl.PIECE.pattern, mccl.COMMAND.pattern)

pytestmark = pytest.mark.skipif(sys.implementation.name != "cpython", reason="left to Python there")


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Every process is a command, and may keep something."""
    monkeypatch.setenv("MOTIONLANG_CACHE", str(tmp_path))
    monkeypatch.delenv(user_cache.OFF, raising=False)
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    begin(monkeypatch)
    return tmp_path


def begin(monkeypatch: pytest.MonkeyPatch) -> Finder:
    """Begin a command; a later one has what an earlier one kept."""
    if Finder.of_the_command is not None:
        keep(Finder.of_the_command)
    finder = Finder("/somewhere/motionlang")
    monkeypatch.setattr(Finder, "of_the_command", finder)
    return finder


@cases("text", PATTERNS)
def test_a_kept_pattern_is_that_of_re(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    wanted = re.compile(text, re.ASCII)
    assert compiled(text) is wanted  # which `re` has kept, too
    begin(monkeypatch)
    kept = compiled(text)
    assert kept is not wanted
    assert kept == wanted  # the same text, flags and program
    assert (kept.groups, kept.groupindex) == (wanted.groups, wanted.groupindex)
    found = 0
    for program in TEXTS:
        of_both = [
            [(match.span(), match.groups()) for match in islice(pattern.finditer(program), 200)]
            for pattern in (kept, wanted)
        ]
        assert of_both[0] == of_both[1]
        found += len(of_both[0])
    assert found > 0


def test_names_of_groups_are_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    text = "(?P<axis>[0-9])(?P<word>[A-Z]+)"
    compiled(text)
    begin(monkeypatch)
    match = compiled(text).match("1MR5")
    assert match is not None
    assert (match["axis"], match.lastgroup, match.groupdict()) == ("1", "word", {"axis": "1", "word": "MR"})


def test_a_damaged_pattern_is_compiled_anew(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = "[0-9]+"
    compiled(text)
    begin(monkeypatch)
    (file,) = folder.iterdir()
    data = bytearray(file.read_bytes())
    data[-1] ^= 1
    file.write_bytes(data)
    assert compiled(text) is re.compile(text, re.ASCII)
    begin(monkeypatch)
    assert compiled(text).findall("1 22") == ["1", "22"]
    assert compiled(text) is not re.compile(text, re.ASCII)


def test_where_re_is_made_otherwise_nothing_is_kept(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with monkeypatch.context() as patch:
        patch.delattr("re._compiler._code")
        patch.setattr(re, "compile", lambda text, flags: text)
        assert compiled("[0-9]") == "[0-9]"
    begin(monkeypatch)
    assert list(folder.iterdir()) == []


FIRST_SIGHT = """
import sys
from motionlang import __main__ as command
command._leave = lambda status: None
status = command.main()
print(status, sorted({"re", "enum", "functools"} & set(sys.modules)))
"""


@cases("name, text", [("a.mnt", "PRINT {}\nMOVER(0) = 1 : GO(0)\n"), ("a.mcl", "1MN,1MR{}\n")])
def test_a_command_compiles_a_new_program_without_re(name: str, text: str, tmp_path: Path) -> None:
    program = tmp_path / name
    script = [sys.executable, "-S", "-c", FIRST_SIGHT, "run", str(program), "--report", "none"]
    environment = {"MOTIONLANG_CACHE": str(tmp_path / "cache"), "PYTHONPATH": str(ROOT)}
    for number in (1, 2, 3):
        program.write_text(text.format(number))
        ran = subprocess.run(script, capture_output=True, text=True, check=True, env=environment)
    assert ran.stdout.splitlines()[-1] == "0 []"

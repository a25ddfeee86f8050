"""docs/sources.md: every row is reproduced by its command, and its test exists."""

from __future__ import annotations

import ast
import re
import shutil
from functools import cache
from pathlib import Path

import pytest

from motionlang.cli import commands
from tests.cases import cases
from tests.cli.notes import NAMES, answer
from tests.cli.programs import parser_of
from tests.extras import MISSING
from tools.sources_page import ROOT, Entry, entries

ENTRIES = [each for each in entries() if each.kind != "context"]
NOT_RUN = ("calc ", "page ", *(f"motionlang {name} " for name in sorted(MISSING)))
COMMANDS = [each for each in ENTRIES if not each.command.startswith(NOT_RUN)]


@cache
def output(command: str) -> str:
    """Return the output of the commands in a row.

    `printf 'TEXT' > FILE` writes a file.
    """
    found = ""
    for line in command.split("; "):
        written = re.fullmatch(r"printf '(.*)' > (\S+)", line)
        if written:
            Path(written[2]).write_text(written[1].replace("\\n", "\n"), encoding="utf-8")
        else:
            found += answer(line)
    return found


def has(text: str, shows: tuple[str, ...]) -> bool:
    """True if a text contains all of `shows`, in order.

    A run of blanks counts as one blank.
    """
    pattern = ".*?".join(re.escape(" ".join(each.split())) for each in shows)
    return re.search(pattern, " ".join(text.split()), re.DOTALL) is not None


def label(each: Entry | str) -> str:
    return each if isinstance(each, str) else f"{each.document[:10]}: {each.words}"


@pytest.mark.slow
@pytest.mark.usefixtures("unrendered")
def test_each_command_shows_what_the_document_says(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(commands, "build_parser", parser_of)
    shutil.copytree(ROOT / "scripts", tmp_path / "scripts")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MOTIONLANG_CACHE", str(tmp_path / "cache"))
    output.cache_clear()
    wrong = [
        f"{label(each)}: {each.command}" for each in COMMANDS if not has(output(each.command), each.shows)
    ]
    assert wrong == []


@cases("entry", [each for each in ENTRIES if each.command.startswith("page ")], ids=label)
def test_each_page_says_what_the_document_says(entry: Entry) -> None:
    assert has((ROOT / entry.command[5:]).read_text(encoding="utf-8"), entry.shows)


@cases("entry", [each for each in ENTRIES if each.command.startswith("calc ")], ids=label)
def test_each_calculation_gives_the_number(entry: Entry) -> None:
    """The tolerance is half a step of the last digit shown."""
    number = entry.shows[0]
    decimals = len(number.partition(".")[2])
    value = float(eval(entry.command[5:], dict(NAMES)))  # a line of our own table
    assert value == pytest.approx(float(number), rel=2e-9, abs=0.51 * 10.0**-decimals)


@cache
def functions_of(path: str) -> set[str]:
    tree = ast.parse((ROOT / path).read_text(encoding="utf-8"))
    return {each.name for each in tree.body if isinstance(each, ast.FunctionDef)}


@cases("entry", ENTRIES, ids=label)
def test_each_row_names_a_test_that_exists(entry: Entry) -> None:
    path, _, name = entry.test.partition("::")
    if not name:
        assert path.endswith("/*")
        assert (ROOT / path[:-2]).is_dir()
    else:
        assert name == "*" or name in functions_of(path), entry.test
        assert functions_of(path)


def test_no_row_is_without_a_proof() -> None:
    assert all(each.command and each.shows and each.test for each in ENTRIES)
    assert len({each.document for each in ENTRIES}) == 4  # of TN1069 there are two scans

"""A file in the other language gives a single message."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang import run
from motionlang.commands.check import check
from motionlang.kernel import ProgramError, Source, dialect
from motionlang.kernel.lang import one_sentence
from tests.cases import cases

ROOT = Path(__file__).parents[3]
GALLERY = sorted([*ROOT.glob("scripts/mint/*.mnt"), *ROOT.glob("scripts/mccl/*.mcl")])
WRONG = sorted([*ROOT.glob("tests/errors/*/*.m*"), *ROOT.glob("tests/lint/*/*.m*")])


@pytest.mark.slow
@cases("path", GALLERY, ids=lambda path: path.name)
def test_the_other_language_is_one_sentence(path: Path) -> None:
    language = dialect("mccl" if path.suffix == ".mnt" else "mint")
    source = Source.read(path)
    (found,) = one_sentence(language, source, check(language.program(source)))
    assert found.code == "language"
    assert found.message.startswith(
        f"this is {'Mint, not MCCL' if path.suffix == '.mnt' else 'MCCL, not Mint'}"
    )


@cases("path", WRONG, ids=lambda path: path.name)
def test_mistakes_are_reported_unchanged(path: Path) -> None:
    language = dialect("mint" if path.suffix == ".mnt" else "mccl")
    source = Source.read(path)
    try:
        found = check(language.program(source))
    except ProgramError as error:
        found = error.diagnostics
    assert [each.code for each in one_sentence(language, source, found)] == [each.code for each in found]


def test_text_of_no_language_is_reported_unchanged() -> None:
    language = dialect("mccl")
    source = Source("a.mcl", "\n".join(f"1ZZ3,1TP,{number}QQ" for number in range(500)))
    found = check(language.program(source))
    assert len(found) == 1000
    assert one_sentence(language, source, found) == found


@cases(
    ("name", "text", "hint"),
    [
        ("a.mnt", "1MN,1SV1000\n1MR1000,1WS\n1TP\n", "add --lang mccl"),
        ("a.mcl", "' a comment\nSPEED(0) = 5\nMOVER(0) = 3\nGO(0)\n", "add --lang mint"),
    ],
)
def test_run_reports_the_language_and_runs_nothing(name: str, text: str, hint: str) -> None:
    result = run(Source(name, text))
    assert (result.status, result.output, [each.code for each in result.diagnostics]) == (
        "fault",
        [],
        ["language"],
    )
    assert result.diagnostics[0].hint.startswith(hint)

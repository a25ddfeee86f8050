"""Diagnostics and quick fixes are the same as those of `motionlang check`."""

from __future__ import annotations

from pathlib import Path

import pytest
from lark.parsers.lalr_interactive_parser import InteractiveParser

from motionlang.commands.check.fix import fix
from motionlang.kernel import Source, dialect
from motionlang_lsp.editor.diagnostics import findings, settings_of
from motionlang_lsp.editor.fixes import Fix, fixes
from motionlang_lsp.editor.hover import hover
from motionlang_lsp.editor.page import Page
from test_lsp.editor.pages import page
from tests.cases import cases
from tests.counted_calls import count_calls


def applied(shown: Page, change: Fix) -> str:
    text = shown.text
    for edit in sorted(change.edits, key=lambda each: each.span, reverse=True):
        text = text[: edit.span[0]] + edit.text + text[edit.span[1] :]
    return text


# Language, a text with one mistake that has one correction, and the corrected text.
FIXED = (
    ("mint", "Print “x”\n", 'Print "x"\n'),
    ("mint", "SPEED(3) = 9\nMOVER(3) = 9\nGO3\n", "SPEED(3) = 9\nMOVER(3) = 9\nGO(3)\n"),
    ("mint", "MOVER(0) = –5 : GO(0)\n", "MOVER(0) = -5 : GO(0)\n"),
    ("mccl", "1MN,1MR–5,1WS\n", "1MN,1MR-5,1WS\n"),
)


@cases("language, text, wanted", FIXED)
def test_the_preferred_fix_does_what_check_fix_does(language: str, text: str, wanted: str) -> None:
    shown = page(text, language)
    (preferred,) = (each for found in findings(shown) for each in fixes(shown, found) if each.preferred)
    assert applied(shown, preferred) == wanted


def test_each_fix_alone_equals_check_fix_alone(tmp_path: Path) -> None:
    shown = page("GO3\nPrint “x”\nPrint ‘y\nDim “z\n")
    with_fix = [each for each in findings(shown) if each.fix]
    assert len(with_fix) >= 2
    for found in with_fix:
        path = tmp_path / "a.mnt"
        path.write_text(shown.text, encoding="utf-8")
        fix(str(path), [found], lambda text: [])
        (preferred,) = (each for each in fixes(shown, found) if each.preferred)
        assert applied(shown, preferred) == path.read_text(encoding="utf-8")


# Language, a text, the title of an offered fix, and the text after it.
OFFERED = (
    ("mint", "SPEDE = 3\n", "Change to SPEED", "SPEED = 3\n"),
    ("mint", "counter = 2\nPrint cuonter\n", "Change to counter", "counter = 2\nPrint counter\n"),
    ("mccl", "1MN\nXA5\n", "Change to AX5", "1MN\nAX5\n"),
    (
        "mint", "Dim spare\n", "Suppress unused-variable on this line",
        "Dim spare  ' lint: ignore unused-variable\n",
    ),
    (
        "mint", "Dim spare ' kept\n", "Suppress unused-variable on this line",
        "Dim spare ' kept lint: ignore unused-variable\n",
    ),
    (
        "mint", "Dim spare ' lint: ignore no-value\n", "Suppress unused-variable on this line",
        "Dim spare ' lint: ignore no-value, unused-variable\n",
    ),
    (
        "mccl", "1WS\n", "Suppress nothing-to-wait-for on this line",
        "1WS  ; lint: ignore nothing-to-wait-for\n",
    ),
)  # fmt: skip


@cases("language, text, title, wanted", OFFERED)
def test_other_changes_are_offered(language: str, text: str, title: str, wanted: str) -> None:
    shown = page(text, language)
    offered = [each for found in findings(shown) for each in fixes(shown, found)]
    (chosen,) = (each for each in offered if each.title == title)
    assert not chosen.preferred
    assert applied(shown, chosen) == wanted
    if title.startswith("Suppress"):
        assert findings(page(wanted, language)) == []


def test_an_error_cannot_be_suppressed() -> None:
    shown = page("Print 3 3\n")
    assert [each.title for found in findings(shown) for each in fixes(shown, found)] == []


def test_continued_line_cannot_take_a_comment() -> None:
    shown = page("Dim spare, _\n  other\n")
    assert [each.title for found in findings(shown) if found.line == 1 for each in fixes(shown, found)] == []


def test_a_machine_file_is_checked_against_its_program() -> None:
    machine = Source("a.machine.toml", "[axis.9]\ntravel = [0, 100]\n")
    assert settings_of(machine, None) == ({"axis.9.travel": [0, 100]}, [])
    settings, found = settings_of(machine, dialect("mint"))
    assert settings == {}
    assert [each.message for each in found] == ["axis.9: there is no axis 9"]
    _, wrong = settings_of(Source("a.machine.toml", "[axis.0]\ntravvel = 3\n"), dialect("mint"))
    assert [(each.line, each.message) for each in wrong] == [(2, "there is no key axis.0.travvel")]


def test_the_hint_on_the_other_language_has_no_option_of_the_command_line() -> None:
    (found,) = findings(page("1MN,1SV1000\n1MR100,1WS\n", "mint"))
    assert found.hint == "choose MCCL as the language, or rename the file to .mcl"


def test_an_editor_parses_a_text_once_for_diagnostics_names_and_hovers(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    parsed = count_calls(monkeypatch, (InteractiveParser, "feed_eof"))
    page = Page(Source("a.mnt", "Dim spare\nMOVER(0) = 5 : GO(0)\n"), dialect("mint"))
    assert [each.code for each in findings(page)] == ["unused-variable"]
    assert [each.name for each in page.names.definitions] == ["spare"]
    assert hover(page, 12) is not None
    assert parsed.calls == 1

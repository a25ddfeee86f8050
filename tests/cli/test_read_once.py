"""Each command reads the text of a program once."""

from __future__ import annotations

from pathlib import Path

import pytest
from lark import Lark

from motionlang.cli import main
from motionlang.ide.editor.diagnostics import findings
from motionlang.ide.editor.hover import hover
from motionlang.ide.editor.page import Page
from motionlang.kernel import Source, dialect
from tests.counted_calls import count_calls

PROGRAM = Path(__file__).parents[2] / "scripts" / "mint" / "pick-and-place.mnt"


@pytest.mark.parametrize(
    "command", ["check", "run", "map", "map --run", "cover", "profile", "certify", "prove"]
)
def test_a_command_parses_a_program_once(
    command: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    parsed = count_calls(monkeypatch, (Lark, "parse"))
    word, *options = command.split()
    assert main([word, str(PROGRAM), *options]) == 0
    assert capsys.readouterr().err == ""
    assert parsed.calls == 1


def test_an_editor_parses_a_text_once_for_diagnostics_names_and_hovers(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    parsed = count_calls(monkeypatch, (Lark, "parse"))
    page = Page(Source("a.mnt", "Dim spare\nMOVER(0) = 5 : GO(0)\n"), dialect("mint"))
    assert [each.code for each in findings(page)] == ["unused-variable"]
    assert [each.name for each in page.names.definitions] == ["spare"]
    assert hover(page, 12) is not None
    assert parsed.calls == 1

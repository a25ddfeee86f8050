"""The editor session of docs/debugging.md: mistake, quick fix, times."""

from __future__ import annotations

import re
from pathlib import Path

from lsprotocol import types

from test_lsp.conftest import ROOT, Editor, InOneServer
from test_lsp.test_server import changes_of

PROGRAM = ROOT / "scripts" / "mint" / "limit-recovery.mnt"
# Columns of a program text on the page, before the hint of its line.
WIDTH = 40


def shown_on_the_page() -> tuple[str, str]:
    """Return the page's two pictures of the editor: before and after the quick fix."""
    page = (ROOT / "docs" / "debugging.md").read_text(encoding="utf-8")
    assert f".debug {PROGRAM.relative_to(ROOT).as_posix()}\n" in page
    before, after = re.findall(r"^```editor\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
    return before, after


def diagnosed(text: str, found: types.Diagnostic, offered: list[types.CodeAction]) -> str:
    """Draw the line of a diagnostic with its message and its quick fixes."""
    start, end = found.range.start, found.range.end
    mark = " " * start.character + "^" * (end.character - start.character)
    rows = [
        f"{start.line + 1}  {text.splitlines()[start.line]}",
        f"    {mark} {found.message.splitlines()[0]}",
    ]
    return "\n".join([*rows, *(f"    quick fix: {each.title}" for each in offered)]) + "\n"


def hinted(text: str, hint: types.InlayHint) -> str:
    """Draw the line of an inlay hint."""
    line = text.splitlines()[hint.position.line].partition("'")[0].rstrip()
    return f"{hint.position.line + 1}  {line:{WIDTH}}{hint.label}\n"


def test_the_session_in_an_editor_is_as_documented(in_one_server: InOneServer, tmp_path: Path) -> None:
    before, after = shown_on_the_page()
    right = PROGRAM.read_text(encoding="utf-8")
    machine = PROGRAM.with_suffix(".machine.toml").read_text(encoding="utf-8")
    (tmp_path / "a.machine.toml").write_text(machine, encoding="utf-8")

    async def work(client: Editor) -> None:
        server, document = client.client, client.document
        wrong = right.replace("\nSPEED(0)", "\nSPEDE(0)")
        (found,) = await client.open(wrong)
        offered = await server.text_document_code_action_async(
            types.CodeActionParams(document, found.range, types.CodeActionContext([found]))
        )
        actions = [each for each in offered or () if isinstance(each, types.CodeAction)]
        assert diagnosed(wrong, found, actions) == before

        assert actions[0].edit is not None
        (change,) = changes_of(actions[0].edit, client.uri)
        start, end = change.range.start, change.range.end
        line = wrong.splitlines()[start.line]
        fixed = line[: start.character] + change.new_text + line[end.character :]
        assert fixed == right.splitlines()[start.line]
        edit = types.TextDocumentContentChangePartial(change.range, change.new_text)
        assert await client.change(edit) == []

        lines = types.Range(types.Position(0, 0), types.Position(len(right.splitlines()), 0))
        hints = await server.text_document_inlay_hint_async(types.InlayHintParams(document, lines))
        assert "".join(hinted(right, each) for each in hints or ()) == after

    in_one_server(work, tmp_path / "a.mnt")

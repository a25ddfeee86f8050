"""The server with clients that behave like VS Code, Neovim and Emacs."""

from __future__ import annotations

from pathlib import Path

import pytest
from lsprotocol import types
from pygls.exceptions import JsonRpcException

from test_lsp.conftest import Editor, InOneServer, at, insertion, session
from test_lsp.wire import PROGRAM

# One kind of client in the normal run; the others differ in their capabilities alone.
EDITORS = (
    "visual-studio-code",
    *(pytest.param(name, marks=pytest.mark.slow) for name in ("neovim", "emacs")),
)


def changes_of(edit: types.WorkspaceEdit, uri: str) -> list[types.TextEdit]:
    """Return the edits of one text, in either form of the protocol."""
    found = list((edit.changes or {}).get(uri, ()))
    for each in edit.document_changes or ():
        assert isinstance(each, types.TextDocumentEdit)
        found += [change for change in each.edits if isinstance(change, types.TextEdit)]
    return found


@pytest.mark.slow
@pytest.mark.parametrize("editor", EDITORS)
def test_a_session_of_an_editor(editor: str, tmp_path: Path) -> None:
    async def work(client: Editor) -> None:
        server, document = client.client, client.document
        (found,) = await client.open(PROGRAM)
        assert (found.code, found.range) == ("unused-variable", types.Range(at(1, 0), at(1, 5)))
        assert found.message == "SPEDE is assigned but never read\nhint: did you mean SPEED?"

        context = types.CodeActionContext([found])
        offered = await server.text_document_code_action_async(
            types.CodeActionParams(document, found.range, context)
        )
        assert [each.title for each in offered or ()] == [
            "Change to SPEED",
            "Suppress unused-variable on this line",
        ]

        hover = await server.text_document_hover_async(types.HoverParams(document, at(8, 1)))
        assert hover is not None
        assert "Moves by a distance." in hover.contents.value

        location = await server.text_document_definition_async(types.DefinitionParams(document, at(8, 1)))
        assert location == types.Location(client.uri, types.Range(at(3, 4), at(3, 10)))

        uses = await server.text_document_references_async(
            types.ReferenceParams(types.ReferenceContext(True), document, at(0, 5))
        )
        assert [each.range.start.line for each in uses or ()] == [0, 6, 6, 9]

        proposed = await server.text_document_completion_async(types.CompletionParams(document, at(4, 4)))
        assert isinstance(proposed, types.CompletionList)
        assert "MOVER" in [each.label for each in proposed.items]

        edit = await server.text_document_rename_async(types.RenameParams(document, at(0, 5), "done"))
        assert edit is not None
        assert [(each.range.start.line, each.new_text) for each in changes_of(edit, client.uri)] == [
            (0, "done"), (6, "done"), (6, "done"), (9, "done"),
        ]  # fmt: skip

        with pytest.raises(JsonRpcException, match="SPEED is a keyword of Mint"):
            await server.text_document_rename_async(types.RenameParams(document, at(0, 5), "speed"))

        symbols = await server.text_document_document_symbol_async(types.DocumentSymbolParams(document))
        assert [each.name for each in symbols or ()] == ["count", "SPEDE", "Travel"]

        assert await client.change(insertion(1, 3, "ED"), insertion(1, 5, "X")) != []
        whole = types.TextDocumentContentChangeWholeDocument(PROGRAM.replace("SPEDE = 3\n", ""))
        assert await client.change(whole) == []

        lines = types.Range(at(0, 0), at(20, 0))
        hints = await server.text_document_inlay_hint_async(types.InlayHintParams(document, lines))
        assert [each.position.line for each in hints or ()] == [3, 4]

    assert session(work, tmp_path, editor=editor) == 0


def test_mccl_and_machine_files(in_one_server: InOneServer, tmp_path: Path) -> None:
    async def work(client: Editor) -> None:
        assert await client.open("MD1,1MN,1MR100,1WS\nMC1\n", "mccl") == []
        edit = await client.client.text_document_rename_async(
            types.RenameParams(client.document, at(1, 3), "7")
        )
        assert edit is not None
        machine = Editor(client.client, client.uri.removesuffix(".mcl") + ".machine.toml")
        (found,) = await machine.open("[axis.1]\ntravvel = [0, 1]\n", "toml")
        assert (found.range.start.line, found.code) == (1, "machine-file")
        machine.edit(types.TextDocumentContentChangeWholeDocument("[axis.1]\n\nmotor = "))
        page = await client.client.text_document_hover_async(types.HoverParams(machine.document, at(2, 1)))
        assert page is not None
        assert isinstance(page.contents, types.MarkupContent)
        assert page.contents.value.startswith("**axis.1.motor** · one of servo, stepper")
        listed = await client.client.text_document_completion_async(
            types.CompletionParams(machine.document, at(2, 8))
        )
        assert isinstance(listed, types.CompletionList)
        assert [each.label for each in listed.items] == ["servo", "stepper"]
        assert (
            await machine.change(types.TextDocumentContentChangeWholeDocument("[axis.1]\ntravel = [0, 1]\n"))
            == []
        )

    in_one_server(work, tmp_path / "a.mcl")


def test_a_program_is_checked_with_the_machine_file_next_to_it(
    in_one_server: InOneServer, tmp_path: Path
) -> None:
    (tmp_path / "a.machine.toml").write_text("[axis.0]\ntravel = [0, 100]\n", encoding="utf-8")

    async def work(client: Editor) -> None:
        (found,) = await client.open("MOVEA(0) = 500 : GO(0)\n")
        assert found.code == "beyond-travel"

    in_one_server(work, tmp_path / "a.mnt")


@pytest.mark.slow
def test_a_machine_file_that_changes_on_disk_checks_the_program_again(tmp_path: Path) -> None:
    """The editor is asked to report changes of such files. The move ends at 500.

    The server is its own: one with more programs open would check all of them again.
    """
    machine = tmp_path / "a.machine.toml"

    async def work(client: Editor) -> None:
        assert await client.open("MOVEA(0) = 500 : GO(0)\n") == []
        (registered,) = client.registered
        assert registered.method == "workspace/didChangeWatchedFiles"
        event = types.FileEvent(machine.as_uri(), types.FileChangeType.Changed)
        for travel, codes in ((100, ["beyond-travel"]), (600, [])):
            machine.write_text(f"[axis.0]\ntravel = [0, {travel}]\n", encoding="utf-8")
            client.client.workspace_did_change_watched_files(types.DidChangeWatchedFilesParams([event]))
            assert [each.code for each in await client.diagnostics()] == codes

    assert session(work, tmp_path) == 0


def test_a_machine_file_in_latin_1_is_read_as_a_run_reads_it(
    in_one_server: InOneServer, tmp_path: Path
) -> None:
    text = "# Fräse\n[axis.0]\ntravel = [0, 100]\n"
    (tmp_path / "a.machine.toml").write_bytes(text.encode("latin-1"))

    async def work(client: Editor) -> None:
        (found,) = await client.open("MOVEA(0) = 500 : GO(0)\n")
        assert found.code == "beyond-travel"

    in_one_server(work, tmp_path / "a.mnt")


def test_a_text_in_a_wrong_encoding_has_one_diagnostic(in_one_server: InOneServer, tmp_path: Path) -> None:
    """Editors replace bytes that they cannot decode, here letters of Latin-1."""

    async def work(client: Editor) -> None:
        (found,) = await client.open("' Ma\ufffde\nL\ufffdnge = 3 : Print L\ufffdnge\n")
        assert (found.code, found.range.start) == ("syntax", at(0, 4))
        assert found.message.startswith(
            "3 characters have been lost: the editor has opened this file in a wrong"
        )
        machine = Editor(client.client, client.uri.removesuffix(".mnt") + ".machine.toml")
        (found,) = await machine.open("# Fr\ufffdse\n[axis.0]\ntravel = [0, 100]\n", "toml")
        assert found.message.startswith("1 character has been lost")

    in_one_server(work, tmp_path / "a.mnt")


def test_positions_are_in_units_of_utf_16(in_one_server: InOneServer, tmp_path: Path) -> None:
    """The symbol before the name is one character, but two UTF-16 units."""

    async def work(client: Editor) -> None:
        text = 'Dim name\nname = 1 : Print "\U0001f527\U0001f527", name\n'
        assert await client.open(text) == []
        uses = await client.client.text_document_references_async(
            types.ReferenceParams(types.ReferenceContext(True), client.document, at(0, 4))
        )
        assert [each.range.start.character for each in uses or ()] == [4, 0, 25]
        inside = insertion(1, 19, "x")  # in the middle of a pair
        assert await client.change(inside) == []
        found = await client.change(insertion(1, 26, "(1)"))
        assert [each.range.start.character for each in found] == [29]  # the name is behind the brackets

    in_one_server(work, tmp_path / "a.mnt")


def test_a_program_that_never_ends_has_times_all_the_same(in_one_server: InOneServer, tmp_path: Path) -> None:
    async def work(client: Editor) -> None:
        await client.open("Loop\n  MOVER(0) = 1 : GO(0) : WAIT = 5000\nEnd Loop\n")
        lines = types.Range(at(0, 0), at(9, 0))
        hints = await client.client.text_document_inlay_hint_async(
            types.InlayHintParams(client.document, lines)
        )
        assert [each.position.line for each in hints or ()] == [1]

    in_one_server(work, tmp_path / "a.mnt")


def test_lenses_are_for_editors_that_have_their_commands(in_one_server: InOneServer, tmp_path: Path) -> None:
    async def work(client: Editor) -> None:
        await client.open("Print 1\n")
        lenses = await client.client.text_document_code_lens_async(types.CodeLensParams(client.document))
        assert [each.command.title for each in lenses or () if each.command] == ["run", "debug"]

    in_one_server(work, tmp_path / "a.mnt")

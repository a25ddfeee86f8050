"""A running server, and clients that behave like the usual editors."""

from __future__ import annotations

import asyncio
import sys
from collections.abc import Callable, Coroutine, Iterator
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("pytest_lsp", reason="pytest-lsp is not installed")

from lsprotocol import types
from pytest_lsp import LanguageClient, client_capabilities, make_test_lsp_client

# The longest time that a test waits for an answer, s; a loaded computer is slow.
MAX_SECONDS = 120.0
ROOT = Path(__file__).parents[3]
# The commands of an editor, two of which have lenses.
OPTIONS = {"commands": ["motionlang.run", "motionlang.debug", "motionlang.other"]}


class Editor:
    """A client with one open text, and short names for its requests."""

    def __init__(self, client: LanguageClient, uri: str) -> None:
        self.client, self.uri, self.version = client, uri, 0
        self.document = types.TextDocumentIdentifier(uri)
        # What the server has asked the editor to report.
        self.registered: list[types.Registration] = []

    async def open(self, text: str, language: str = "mint") -> list[types.Diagnostic]:
        """Open a text and return its diagnostics."""
        self.version += 1
        item = types.TextDocumentItem(self.uri, language, self.version, text)
        self.client.text_document_did_open(types.DidOpenTextDocumentParams(item))
        return await self.diagnostics()

    async def change(self, *changes: types.TextDocumentContentChangeEvent) -> list[types.Diagnostic]:
        """Change the text and return its new diagnostics."""
        self.edit(*changes)
        return await self.diagnostics()

    def edit(self, *changes: types.TextDocumentContentChangeEvent) -> None:
        """Change the text."""
        self.version += 1
        identifier = types.VersionedTextDocumentIdentifier(self.version, self.uri)
        self.client.text_document_did_change(types.DidChangeTextDocumentParams(identifier, changes))

    async def diagnostics(self) -> list[types.Diagnostic]:
        """Wait for the diagnostics of the present version and return them."""
        awaited: asyncio.Future[list[types.Diagnostic]] = asyncio.get_running_loop().create_future()

        def listen() -> None:
            self.client.protocol.wait_for_notification(types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS, hear)

        def hear(found: types.PublishDiagnosticsParams) -> None:
            # Those of another text may come in the same read: listen again at once.
            if found.uri == self.uri and found.version == self.version:
                awaited.set_result(list(found.diagnostics))
            else:
                listen()

        listen()
        return await awaited


def at(line: int, character: int) -> types.Position:
    return types.Position(line, character)


def insertion(line: int, character: int, text: str) -> types.TextDocumentContentChangePartial:
    return types.TextDocumentContentChangePartial(types.Range(at(line, character), at(line, character)), text)


Work = Callable[[Editor], Coroutine[Any, Any, None]]
InOneServer = Callable[[Work, Path], None]


def session(
    work: Work,
    folder: Path,
    *,
    editor: str = "visual-studio-code",
    name: str = "a.mnt",
    options: object = None,
) -> int:
    """Run `work` with an editor and its server; return the server's exit status."""

    async def whole() -> int:
        shown = Editor(make_test_lsp_client(), (folder / name).as_uri())
        await start(shown, editor, options)
        try:
            await work(shown)
        finally:
            status = await stop(shown.client)
        return status

    return asyncio.run(asyncio.wait_for(whole(), MAX_SECONDS))


async def start(shown: Editor, editor: str = "visual-studio-code", options: object = None) -> None:
    """Start the server of an editor."""
    client = shown.client

    def register(params: types.RegistrationParams) -> None:
        shown.registered += params.registrations

    client.feature(types.CLIENT_REGISTER_CAPABILITY)(register)
    await client.start_io(sys.executable, "-m", "motionlang", "lsp", cwd=str(ROOT))
    await client.initialize_session(
        types.InitializeParams(
            client_capabilities(editor), workspace_folders=[], initialization_options=options
        )
    )


async def stop(client: LanguageClient) -> int:
    """Shut down a server and return its exit status."""
    await client.shutdown_session()
    process = client._server
    assert process is not None
    return await process.wait()


@pytest.fixture(scope="session")
def in_one_server() -> Iterator[InOneServer]:
    """Yield a function that runs `work` with the text at a path."""
    with asyncio.Runner() as runner:
        first = Editor(make_test_lsp_client(), "")
        runner.run(asyncio.wait_for(start(first, options=OPTIONS), MAX_SECONDS))

        def use(work: Work, path: Path) -> None:
            shown = Editor(first.client, path.as_uri())
            shown.registered = first.registered
            runner.run(asyncio.wait_for(work(shown), MAX_SECONDS))

        yield use
        assert runner.run(asyncio.wait_for(stop(first.client), MAX_SECONDS)) == 0

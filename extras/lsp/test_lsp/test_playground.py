"""`language.py`: the language server in the page, without streams and processes."""

from __future__ import annotations

import asyncio
import json
from typing import Any

from tests.playground.test_runner import module

language = module("language")
PROGRAM = "file:///part.mnt"
MACHINE = "file:///part.machine.toml"


class Editor:
    """Sends the messages of a page to the server, and receives those of the server."""

    def __init__(self) -> None:
        self.got: list[dict[str, Any]] = []
        self.came = asyncio.Event()
        self.send = language.serve(self._take)

    def _take(self, text: str) -> None:
        self.got.append(json.loads(text))
        self.came.set()

    async def ask(self, method: str, **params: Any) -> Any:
        """Return the result of a request."""
        self.send(json.dumps({"jsonrpc": "2.0", "id": method, "method": method, "params": params}))
        while True:
            for each in self.got:
                if each.get("id") == method:
                    self.got.remove(each)
                    return each["result"]
            self.came.clear()
            await self.came.wait()

    def notify(self, method: str, **params: Any) -> None:
        self.send(json.dumps({"jsonrpc": "2.0", "method": method, "params": params}))

    def open(self, uri: str, language: str, text: str) -> None:
        item = {"uri": uri, "languageId": language, "version": 0, "text": text}
        self.notify("textDocument/didOpen", textDocument=item)

    async def diagnostics(self, uri: str) -> list[tuple[int, str]]:
        """Wait for the diagnostics of a text; return line, from 0, and message of each."""
        while True:
            for each in self.got:
                if each.get("method") == "textDocument/publishDiagnostics" and each["params"]["uri"] == uri:
                    found = each["params"]["diagnostics"]
                    return [(one["range"]["start"]["line"], one["message"]) for one in found]
            self.came.clear()
            await self.came.wait()


async def begun() -> Editor:
    editor = Editor()
    await editor.ask("initialize", processId=None, rootUri=None, capabilities={})
    editor.notify("initialized")
    return editor


def test_a_mistake_is_reported_and_a_fix_offered() -> None:
    async def use() -> None:
        editor = await begun()
        editor.open(PROGRAM, "mint", "SPED(0) = 100\n")
        found = await editor.diagnostics(PROGRAM)
        assert found == [(0, "SPED is unknown\nhint: did you mean SPEED?")]
        everywhere = {"start": {"line": 0, "character": 0}, "end": {"line": 1, "character": 0}}
        context = {"diagnostics": [], "only": ["quickfix"]}
        [fix] = await editor.ask(
            "textDocument/codeAction", textDocument={"uri": PROGRAM}, range=everywhere, context=context
        )
        assert fix["title"] == "Change to SPEED"
        assert [each["newText"] for each in fix["edit"]["changes"][PROGRAM]] == ["SPEED"]

    asyncio.run(use())


def test_the_machine_file_is_that_of_the_other_tab() -> None:
    async def use() -> None:
        editor = await begun()
        editor.open(MACHINE, "toml", "[axis.0]\nscal = 5\n")
        editor.open(PROGRAM, "mint", "PRINT 1\n")
        [(line, message)] = await editor.diagnostics(MACHINE)
        assert (line, "scal" in message) == (1, True)
        [(line, message)] = await editor.diagnostics(PROGRAM)
        assert message.startswith("part.machine.toml is invalid, and the program is checked without it")

    asyncio.run(use())


def test_a_blank_machine_file_is_none() -> None:
    async def use() -> None:
        editor = await begun()
        editor.open(MACHINE, "toml", "\n")
        editor.open(PROGRAM, "mint", "PRINT 1\n")
        assert (await editor.diagnostics(MACHINE), await editor.diagnostics(PROGRAM)) == ([], [])

    asyncio.run(use())


def test_a_message_that_is_none_has_an_answer() -> None:
    async def use() -> None:
        editor = await begun()
        editor.send("{")
        assert editor.got[-1]["error"]["message"] == "the message is not valid JSON"
        assert (
            await editor.ask(
                "textDocument/hover", textDocument={"uri": PROGRAM}, position={"line": 0, "character": 0}
            )
            is None
        )

    asyncio.run(use())

"""A server without a process, fed with messages of any form."""

from __future__ import annotations

import asyncio
import json
from random import Random
from typing import Any

from pygls.exceptions import JsonRpcException

from motionlang_lsp.editor.times import NO_TIMES
from motionlang_lsp.jobs import Job, Result, work
from motionlang_lsp.server import EditorServer
from motionlang_lsp.workers import Inline

# What does the jobs, in this process here, and the kinds of jobs.
Worker = Inline
CHECK, NAMES, TIMES = "check", "names", "times"
URI = "file:///nowhere/a.mnt"
# A program with a declaration, a mistake, a comment and a sub.
PROGRAM = """\
Dim count As Integer
SPEDE = 3
' Moves by a distance.
Sub Travel(far As Float)
  MOVER(0) = far : GO(0)
  Pause IDLE(0)
  count = count + 1
End Sub
Travel(10)
Print count
"""
REQUESTS = (
    "textDocument/hover", "textDocument/definition", "textDocument/references", "textDocument/documentHighlight",
    "textDocument/prepareRename", "textDocument/rename", "textDocument/documentSymbol", "textDocument/completion",
    "textDocument/signatureHelp", "textDocument/codeAction", "textDocument/formatting", "textDocument/foldingRange",
    "textDocument/semanticTokens/full", "textDocument/inlayHint", "textDocument/codeLens",
    "workspace/executeCommand", "workspace/symbol", "no/suchMethod", "",
)  # fmt: skip
NOTIFICATIONS = (
    "initialized", "textDocument/didOpen", "textDocument/didChange", "textDocument/didClose", "textDocument/didSave",
    "workspace/didChangeWatchedFiles", "workspace/didChangeConfiguration", "$/cancelRequest", "$/setTrace",
    "no/suchNotification",
)  # fmt: skip
INITIALIZE: dict[str, Any] = {"processId": None, "rootUri": None, "capabilities": {}}


class Checks(Inline):
    """Finds names and executes checks in this process."""

    async def do(self, job: Job) -> Result | None:
        return NO_TIMES if job.what == TIMES else work(job)


class Broken(Inline):
    """Raises an exception in every job."""

    async def do(self, job: Job) -> Result | None:
        raise RuntimeError(f"no {job.what}\nand more")


class Wire:
    """Both ends of a connection in one process; `sent` has the server's messages."""

    def __init__(self, worker: Inline | None = None) -> None:
        self.server = EditorServer(worker or Checks())
        self.sent: list[dict[str, Any]] = []
        self.server.protocol.set_writer(self, include_headers=False)

    def write(self, data: bytes) -> None:
        self.sent.append(json.loads(data))

    def close(self) -> None:
        """Do nothing."""

    def receive(self, body: bytes | str) -> None:
        """Let the server read the body of a message, as in its own loop."""
        try:
            message = json.loads(body, object_hook=self.server.protocol.structure_message)
            self.server.protocol.handle_message(message)
        except Exception as error:
            self.server.report_server_error(error, JsonRpcException)

    def request(self, number: int | str, method: str, parameters: object) -> None:
        """Send a request."""
        self.receive(json.dumps({"jsonrpc": "2.0", "id": number, "method": method, "params": parameters}))

    def notify(self, method: str, parameters: object) -> None:
        """Send a notification."""
        self.receive(json.dumps({"jsonrpc": "2.0", "method": method, "params": parameters}))

    def answers(self) -> dict[int | str | None, list[dict[str, Any]]]:
        """Return all answers so far, by the numbers of their requests."""
        found: dict[int | str | None, list[dict[str, Any]]] = {}
        for each in self.sent:
            if "method" not in each:
                found.setdefault(each["id"], []).append(each)
        return found

    async def settled(self) -> None:
        """Wait until no work is left, as if the user had paused typing."""
        session, waiting = self.server.session, self.server.protocol._request_futures
        while (
            session._tasks
            or any(not each.done() for each in waiting.values())
            or any(known.pause is not None for known in session._known.values())
        ):
            for known in session._known.values():
                if known.pause is not None:
                    known.pause.cancel()
                    session._paused(known)
            await asyncio.sleep(0)
        await asyncio.sleep(0)


class Chance:
    """Generates random messages, mostly of a valid form, with values of all kinds."""

    TEXTS = (
        "", "\n", "Print 1\r\nPrint 2\r", "\ufeffx = 1\n", "x = \U0001f527\nPrint \"\U0001f527\", x\n", "If a Then\n",
        "Sub s\n  Dim n\n  n = 1\n", "Loop\nEnd Loop\n", "Dim n\nInput n\n", "Print 1/0\n", "\x00\x0c\x1a\u2028",
        "a.b.c(1)(2).d\n", "Define a = b\nDefine b = a\nPrint a\n", "((((((((", "MOVER(0) = 5 : GO(0)\n", "#a\ngoto a",
    )  # fmt: skip

    def __init__(self, seed: int) -> None:
        self.random = Random(seed)

    def position(self) -> dict[str, Any]:
        numbers = (0, 1, 2, 3, 7, 26, 10**6, 2**31 - 1)
        return {
            "line": self.random.choice(numbers[:6] + numbers[-1:]),
            "character": self.random.choice(numbers),
        }

    def range(self) -> dict[str, Any]:
        return {"start": self.position(), "end": self.position()}

    def text(self) -> str:
        return "".join(self.random.choices(self.TEXTS, k=self.random.randint(1, 3)))

    def uri(self) -> str:
        return self.random.choice(
            (URI, URI, URI, "file:///nowhere/b.mcl", "file:///nowhere/a.machine.toml", "x:", "")
        )

    def parameters(self, method: str) -> dict[str, Any]:
        """Return parameters of the form that most methods take."""
        uri, version = self.uri(), self.random.choice((-5, 0, 1, 2, 1000))
        found: dict[str, Any] = {
            "textDocument": {"uri": uri},
            "position": self.position(),
            "range": self.range(),
            "newName": self.random.choice(("y", "GO", "1", "")),
            "context": {"diagnostics": [], "includeDeclaration": True},
            "options": {"tabSize": version, "insertSpaces": True},
            "previousResultId": "1",
            "command": "x",
            "query": "",
            "changes": [],
            "value": "off",
            "id": 3,
            "settings": None,
        }
        if method == "textDocument/didOpen":
            found["textDocument"] = {
                "uri": uri,
                "languageId": "mint",
                "version": version,
                "text": self.text(),
            }
        elif method == "textDocument/didChange":
            found["textDocument"] = {"uri": uri, "version": version}
            changes = [{"range": self.range(), "text": self.text()}, {"text": self.text()}]
            found["contentChanges"] = self.random.choices(changes, k=self.random.randint(0, 3))
        return found

    def broken(self, parameters: dict[str, Any]) -> object:
        """Return the parameters with a missing or wrongly typed member, or another object."""
        value: object = self.random.choice((None, 3, "x", [], {}, -1.5, True, {"line": "a"}))
        if self.random.random() < 0.2:
            return value
        key = self.random.choice(list(parameters))
        return (
            {**parameters, key: value}
            if self.random.random() < 0.5
            else {name: each for name, each in parameters.items() if name != key}
        )

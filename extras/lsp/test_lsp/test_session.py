"""The texts of one editor: changes, limits, times and checks."""

from __future__ import annotations

import asyncio
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.kernel import Diagnostic
from motionlang.kernel.lang import NO_NAMES
from motionlang_lsp.editor.times import Times
from test_lsp.test_answers import MACHINE, ask, at, span
from test_lsp.wire import CHECK, INITIALIZE, NAMES, TIMES, URI, Wire, Worker
from tests.cases import cases


class Timed(Worker):
    """Has a time for lines 1 to 3, and an error in line 2 or 4."""

    def __init__(self, fault: int = 2, until: float = 0.0) -> None:
        self.fault, self.until = fault, until

    async def do(self, job: Any) -> Any:
        if job.what != TIMES:
            return [] if job.what == CHECK else NO_NAMES
        lines: list[Any] = [Line(number) for number in (3, 1, 2)]
        return Times(lines, (self.fault, "too far"), self.until, [3] if self.until else [])


class Line(SimpleNamespace):
    """The time of a line: its number in seconds."""

    def __init__(self, line: int) -> None:
        super().__init__(line=line)

    def __str__(self) -> str:
        return f"{self.line} s"


def opened(text: str, worker: Worker | None = None, version: int = 1, **initialize: object) -> Wire:
    """Return a connection with one open text; call it in an event loop."""
    wire = Wire(worker)
    wire.request("first", "initialize", {**INITIALIZE, **initialize})
    item = {"uri": URI, "languageId": "mint", "version": version, "text": text}
    wire.notify("textDocument/didOpen", {"textDocument": item})
    return wire


def published(wire: Wire) -> list[tuple[str, int, list[str]]]:
    """Return file, version and codes of all diagnostics so far."""
    found = [each["params"] for each in wire.sent if each.get("method") == "textDocument/publishDiagnostics"]
    return [
        (each["uri"].rpartition("/")[2], each["version"], [one["code"] for one in each["diagnostics"]])
        for each in found
    ]


def change(text: str, version: int, uri: str = URI) -> dict[str, Any]:
    return {"textDocument": {"uri": uri, "version": version}, "contentChanges": [{"text": text}]}


# ------------------------------------------------------------------------------------------------------- times


@pytest.mark.parametrize(
    ("worker", "lines", "wanted"),
    [
        (Timed(), (0, 9), [(0, "1 s"), (1, "2 s · ends here: too far"), (2, "3 s")]),
        (Timed(4), (0, 9), [(0, "1 s"), (1, "2 s"), (2, "3 s"), (3, "ends here: too far")]),
        (Timed(), (1, 1), [(1, "2 s · ends here: too far")]),
        (Timed(until=2.5), (2, 2), [(2, "3 s · still running at 2.5 s")]),
    ],
)
def test_hints_have_the_times_of_lines(
    worker: Timed, lines: tuple[int, int], wanted: list[tuple[int, str]]
) -> None:
    """Each is at the end of its line; the fourth line has a symbol of two units."""
    text = 'a = 1\nbc = 2\n\nPrint "\U0001f527"\n'
    ends = (5, 6, 0, 10)

    async def whole() -> Any:
        wire = opened(text, worker)
        await wire.settled()
        area = {"start": at(lines[0], 0), "end": at(lines[1], 0)}
        wire.request(1, "textDocument/inlayHint", {"textDocument": {"uri": URI}, "range": area})
        await wire.settled()
        return wire.answers()[1][0]["result"]

    tip = "simulated time of the first 2.5 s" if worker.until else "simulated time of this line"
    assert asyncio.run(whole()) == [
        {"position": at(line, ends[line]), "label": label, "tooltip": tip, "paddingLeft": True}
        for line, label in wanted
    ]


def test_times_are_computed_once_for_a_text_and_again_after_a_change() -> None:
    seen: list[str] = []

    class Counted(Timed):
        async def do(self, job: Any) -> Any:
            seen.append(f"{job.what} {job.name} {job.text!r} {job.language} {job.machine} {job.machine_name}")
            return await super().do(job)

    async def whole() -> list[int]:
        wire = opened("a = 1", Counted())
        area = {"textDocument": {"uri": URI}, "range": {"start": at(0, 0), "end": at(9, 0)}}
        for number in (1, 2):
            wire.request(number, "textDocument/inlayHint", area)
            await wire.settled()
        wire.notify("textDocument/didChange", change("a = 2", 2))
        wire.request(3, "textDocument/inlayHint", area)
        wire.notify("textDocument/didChange", change("a = 3", 3))
        await wire.settled()
        wire.request(4, "textDocument/inlayHint", area)
        await wire.settled()
        return [len(wire.answers()[number][0].get("result", ())) for number in (1, 2, 4)]

    assert asyncio.run(whole()) == [3, 3, 3]
    assert [each for each in seen if each.startswith(TIMES)] == [
        f"times a.mnt 'a = {number}' mint None a.machine.toml" for number in (1, 3)
    ]


# ----------------------------------------------------------------------------------------------------- changes


def test_fixes_are_for_the_text_that_was_checked() -> None:
    """Version 1 has not been checked yet, so nothing is offered for its old mistake."""

    async def whole() -> list[int]:
        wire = opened("SPEDE = 3\n", version=0)
        request = {"textDocument": {"uri": URI}, "range": span(0, 0, 9), "context": {"diagnostics": []}}
        await wire.settled()
        wire.request(1, "textDocument/codeAction", request)
        wire.notify("textDocument/didChange", change("\nSPEDE = 3\n", 1))
        wire.request(2, "textDocument/codeAction", request)
        await wire.settled()
        wire.request(3, "textDocument/codeAction", {**request, "range": span(1, 0, 9)})
        return [len(wire.answers()[number][0]["result"]) for number in (1, 2, 3)]

    assert asyncio.run(whole()) == [2, 0, 2]


def test_a_text_that_is_closed_has_no_diagnostics() -> None:
    """It is not checked either, although the user had paused."""

    async def whole() -> Wire:
        wire = opened("SPEDE = 3\n")
        await wire.settled()
        wire.notify("textDocument/didChange", change("x\n", 2))
        wire.notify("textDocument/didClose", {"textDocument": {"uri": URI}})
        wire.notify("textDocument/didClose", {"textDocument": {"uri": URI}})
        wire.notify("textDocument/didChange", change("y\n", 3))
        await wire.settled()
        return wire

    assert published(asyncio.run(whole())) == [("a.mnt", 1, ["unused-variable"]), ("a.mnt", 2, [])]


def test_programs_are_checked_again_when_a_machine_file_changes() -> None:
    """One that is open counts instead of the file on disk, and is checked alone."""

    async def whole() -> Wire:
        wire = opened("MOVEA(0) = 500 : GO(0)\n")
        await wire.settled()
        item = {"uri": MACHINE, "languageId": "toml", "version": 1, "text": "[axis.0]\ntravel = [0, 100]\n"}
        wire.notify("textDocument/didOpen", {"textDocument": item})
        await wire.settled()
        wire.notify("textDocument/didChange", change("[axis.0]\ntravel = [0, 200]\n", 2, MACHINE))
        await wire.settled()
        wire.notify("workspace/didChangeWatchedFiles", {"changes": []})
        await wire.settled()
        wire.notify("textDocument/didChange", change("MOVEA(0) = 5 : GO(0)\n", 2))
        await wire.settled()
        return wire

    found = published(asyncio.run(whole()))
    assert [each[1:] for each in found if each[0] == "a.machine.toml"] == [(1, []), (2, [])]
    assert [each[1:] for each in found if each[0] == "a.mnt"] == [
        (1, []), (1, ["beyond-travel"]), (1, ["beyond-travel"]), (2, []),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("watched", "count"), [({"dynamicRegistration": True}, 1), ({"dynamicRegistration": False}, 0), (None, 0)]
)
def test_an_editor_is_asked_to_watch_machine_files(watched: object, count: int) -> None:
    async def whole() -> list[Any]:
        workspace = {} if watched is None else {"didChangeWatchedFiles": watched}
        wire = opened("", capabilities={"workspace": workspace})
        wire.notify("initialized", {})
        await wire.settled() if not count else await asyncio.sleep(0)
        return [each["params"] for each in wire.sent if each.get("method") == "client/registerCapability"]

    wanted = {
        "id": "machine files",
        "method": "workspace/didChangeWatchedFiles",
        "registerOptions": {
            "watchers": [{"globPattern": "**/*.machine.toml"}, {"globPattern": "**/machine.toml"}]
        },
    }
    assert asyncio.run(whole()) == [{"registrations": [wanted]}] * count


async def checked(worker: Worker) -> Wire:
    """Return a connection with an empty text that has been checked."""
    wire = opened("", worker)
    await wire.settled()
    return wire


def test_a_check_without_a_result_is_repeated_once() -> None:
    """The process of a check may have died; the next one may have a result."""
    for results, wanted in (
        ([None, []], [("a.mnt", 1, [])]),
        ([None, None], [("a.mnt", 1, ["limit"])]),
        ([[]], [("a.mnt", 1, [])]),
    ):
        left: list[Any] = list(results)

        class Dying(Worker):
            async def do(self, job: Any, left: list[Any] = left) -> Any:
                found: list[Diagnostic] | None = left.pop(0) if job.what == CHECK else []
                return found

        assert published(asyncio.run(checked(Dying()))) == wanted
        assert left == []


def test_an_internal_error_marks_the_first_character() -> None:
    """Its message has only the first line of the exception."""

    class Failing(Worker):
        async def do(self, job: Any) -> Any:
            raise KeyError("a")

    async def whole() -> Any:
        wire = opened("abc\n", Failing())
        await wire.settled()
        return wire.sent[-1]["params"]["diagnostics"]

    message = "a.mnt cannot be checked: internal error: KeyError: 'a'\nhint: motionlang check a.mnt shows the details"
    assert asyncio.run(whole()) == [
        {"range": span(0, 0, 1), "message": message, "severity": 1, "code": "crash", "source": "motionlang"}
    ]


def test_a_session_that_stops_starts_no_check() -> None:
    stopped: list[bool] = []

    class Stopped(Worker):
        def stop(self) -> None:
            stopped.append(True)

    async def whole() -> list[Any]:
        wire = opened("x\n", Stopped())
        known = wire.server.session.known(URI)
        assert known is not None
        assert known.pause is not None
        timer = known.pause
        wire.server.session.stop()
        await wire.settled()
        return [timer.cancelled(), wire.server.session.known(URI), published(wire)]

    assert asyncio.run(whole()) == [True, None, []]
    assert stopped == [True]


def test_a_text_is_checked_at_once_when_it_is_opened_and_after_a_pause_when_it_changes() -> None:
    async def whole() -> list[float]:
        loop, delays = asyncio.get_running_loop(), []
        later = loop.call_later

        def call_later(delay: float, *work: Any) -> asyncio.TimerHandle:
            delays.append(delay)
            return later(delay, *work)

        loop.call_later = call_later  # type: ignore[method-assign,assignment]
        wire = opened("x = 1\n")
        wire.notify("textDocument/didChange", change("x = 2\n", 2))
        await wire.settled()
        return delays

    assert asyncio.run(whole()) == [0.0, 0.2]


# --------------------------------------------------------------------------------------------- broken messages


@cases(
    "body, code, text, number",
    [
        ("{", -32700, "the message is not valid JSON", None),
        ('{"a": 1}', -32600, "the message is not JSON-RPC 2.0", None),
        ('{"jsonrpc": "1.0", "id": 9, "method": "shutdown"}', -32600, "the message is not JSON-RPC 2.0", None),
        ('{"jsonrpc": "2.0", "id": {}, "method": "x"}', -32600, "the message is malformed", None),
        (
            '{"jsonrpc": "2.0", "id": 7, "method": "textDocument/hover", "params": 3}',
            -32602, "invalid parameters of textDocument/hover", 7,
        ),
        (
            '{"jsonrpc": "2.0", "id": true, "method": "textDocument/hover", "params": 3}',
            -32600, "the message is malformed", None,
        ),
        ('{"jsonrpc": "2.0", "id": 7, "method": "initialize", "params": {"capabilities": {}}}', -32600,
         "the server is initialized already", 7),
        ('{"jsonrpc": "2.0", "method": "textDocument/didOpen", "params": 3}', None, "", None),
    ],
)  # fmt: skip
def test_a_broken_message_gets_one_answer(body: str, code: int | None, text: str, number: int | None) -> None:
    async def whole() -> list[Any]:
        wire = opened("")
        await wire.settled()
        count = len(wire.sent)
        wire.receive(body)
        await wire.settled()
        return wire.sent[count:]

    answer = {"jsonrpc": "2.0", "id": number, "error": {"code": code, "message": text}}
    assert asyncio.run(whole()) == ([] if code is None else [answer])


def test_the_report_of_an_invalid_machine_file_marks_the_first_line(tmp_path: Path) -> None:
    (tmp_path / "a.machine.toml").write_text("[axis.0]\ntravvel = 1\n")
    (found,) = ask("  x = 1\nPrint x\n", uri=(tmp_path / "a.mnt").as_uri())
    assert (found["range"], found["severity"], found["code"]) == (span(0, 0, 1), 2, "machine-file")


# ----------------------------------------------------------------------------- names while they are being found


class Slow(Worker):
    """Finds names when it is allowed to."""

    def __init__(self) -> None:
        self.is_allowed = asyncio.Event()

    async def do(self, job: Any) -> Any:
        if job.what == NAMES:
            await self.is_allowed.wait()
        return await super().do(job) if job.what == NAMES else []


TYPED = """\
Dim count As Integer
Sub Travel(far As Float)
  count = far
End Sub
Travel(1)
"""


async def changed(slow: Slow) -> Wire:
    """Return a connection whose text got two lines after its names were found; they are not found again yet."""
    wire = opened(TYPED, slow)
    slow.is_allowed.set()
    await wire.settled()
    slow.is_allowed.clear()
    edits = [{"range": span(4, 9, 9), "text": "\nTravel("}, {"range": span(0, 0, 0), "text": "Dim other\n"}]
    document = {"uri": URI, "version": 2}
    wire.notify("textDocument/didChange", {"textDocument": document, "contentChanges": edits})
    return wire


def asked(wire: Wire, number: int, method: str, line: int, character: int, **more: object) -> None:
    """Send a request about a position."""
    wire.request(
        number,
        f"textDocument/{method}",
        {"textDocument": {"uri": URI}, "position": at(line, character), **more},
    )


def test_what_a_user_waits_for_is_answered_before_the_names_are_found() -> None:
    """The names are those of the text before, at their present positions; references wait for the new ones."""

    async def whole() -> None:
        slow = Slow()
        wire = await changed(slow)
        asked(wire, 1, "hover", 3, 3)
        asked(wire, 2, "completion", 3, 4)
        asked(wire, 3, "signatureHelp", 6, 7)
        asked(wire, 4, "formatting", 0, 0, options={"tabSize": 2, "insertSpaces": True})
        asked(wire, 5, "references", 0, 4, context={"includeDeclaration": True})
        for _ in range(9):
            await asyncio.sleep(0)
        answers = wire.answers()
        assert answers[1][0]["result"]["range"] == span(3, 2, 7)
        assert "count" in [each["label"] for each in answers[2][0]["result"]["items"]]
        assert answers[3][0]["result"]["signatures"][0]["label"] == "Sub Travel(far As Float)"
        assert answers[4][0]["result"] == []
        assert 5 not in answers
        asked(wire, 6, "hover", 0, 4)
        slow.is_allowed.set()
        await wire.settled()
        asked(wire, 7, "hover", 0, 4)
        answers = wire.answers()
        assert answers[5][0]["result"] == [{"uri": URI, "range": span(0, 4, 9)}]
        assert answers[6][0]["result"] is None
        assert "other As Float" in answers[7][0]["result"]["contents"]["value"]
        assert wire.server.protocol._request_futures == {}

    asyncio.run(whole())


def test_names_of_a_text_that_changes_meanwhile_are_used_at_their_new_positions() -> None:
    """A request that waits for them is answered by an error that editors ignore."""

    async def whole() -> None:
        slow = Slow()
        wire = await changed(slow)
        asked(wire, 1, "references", 0, 4, context={"includeDeclaration": True})
        await asyncio.sleep(0)
        edits = [{"range": span(0, 0, 0), "text": "' one line more\n"}]
        document = {"uri": URI, "version": 3}
        wire.notify("textDocument/didChange", {"textDocument": document, "contentChanges": edits})
        slow.is_allowed.set()
        while 1 not in wire.answers():
            await asyncio.sleep(0)
        asked(wire, 2, "hover", 1, 4)
        answers = wire.answers()
        assert answers[1][0]["error"] == {"code": -32801, "message": "the text has changed"}
        assert answers[2][0]["result"]["range"] == span(1, 4, 9)
        await wire.settled()

    asyncio.run(whole())


def test_a_request_is_about_the_text_before_the_next_change() -> None:
    """Its position is never looked up in a later text, however soon that comes."""

    async def whole() -> Any:
        wire = await changed(Slow())
        asked(wire, 1, "references", 0, 4, context={"includeDeclaration": True})
        wire.notify("textDocument/didChange", change("Dim a\n", 3))
        while 1 not in wire.answers():
            await asyncio.sleep(0)
        return wire.answers()[1][0]["error"]

    assert asyncio.run(whole()) == {"code": -32801, "message": "the text has changed"}

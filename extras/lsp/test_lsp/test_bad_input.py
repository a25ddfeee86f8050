"""Bad input: one error per request; no traceback, no hang, no leftover process."""

from __future__ import annotations

import asyncio
import json
import os
import signal
import socket
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

from test_lsp.conftest import MAX_SECONDS, ROOT
from test_lsp.wire import INITIALIZE, NOTIFICATIONS, REQUESTS, URI, Broken, Chance, Wire
from tests.cases import cases

# Bodies that are no message, or none of a valid form.
GARBAGE = (
    "", "{", "[]", "3", "null", '"x"', "NaN", "[1, 2]", "\x00", '{"jsonrpc": "2.0"}', '{"a": 1}', "[" * 100_000,
    '{"jsonrpc": "2.0", "id": {}, "method": "x"}', '{"jsonrpc": "2.0", "id": 7.5, "method": "initialize"}',
    '{"jsonrpc": "2.0", "id": null, "method": "textDocument/hover", "params": {}}',
    '{"jsonrpc": "1.0", "id": 9, "method": "shutdown"}', '{"jsonrpc": "2.0", "id": 9, "result": 3}',
)  # fmt: skip
# The codes of the protocol for requests that are refused.
REFUSED = {-32700, -32600, -32601, -32602, -32002, -32803, -32801, -32800}


def random_messages(seed: int, count: int) -> None:
    """Send random messages in any order, and check that each request has one answer."""

    async def whole() -> None:
        chance, wire = Chance(seed), Wire()
        random = chance.random
        if random.random() < 0.9:
            wire.request("first", "initialize", INITIALIZE)
        requests = []
        for number in range(count):
            method = random.choice(REQUESTS + NOTIFICATIONS * 2)
            parameters: object = chance.parameters(method)
            if random.random() < 0.1:
                parameters = chance.broken(chance.parameters(method))
            if method in REQUESTS:
                requests.append(number)
                wire.request(number, method, parameters)
            else:
                wire.notify(method, parameters)
            if random.random() < 0.05:
                wire.receive(random.choice(GARBAGE))
            if random.random() < 0.02:
                await wire.settled()
        await wire.settled()
        answers = wire.answers()
        assert [number for number in requests if len(answers.get(number, ())) != 1] == []
        errors = [each["error"] for every in answers.values() for each in every if "error" in each]
        assert {each["code"] for each in errors} <= REFUSED
        assert "Traceback" not in json.dumps(wire.sent)
        assert [each for each in wire.sent if each.get("method") == "window/logMessage"] == []

    asyncio.run(whole())


@pytest.mark.parametrize("seed", range(3))
def test_random_messages_get_one_answer_each(seed: int) -> None:
    random_messages(seed, 200)


@pytest.mark.long
@pytest.mark.parametrize("seed", range(100, 150))
def test_ten_thousand_random_messages_get_one_answer_each(seed: int) -> None:
    random_messages(seed, 200)


def test_a_job_that_raises_is_reported_in_one_sentence() -> None:
    """A check that raises gives a diagnostic; other jobs that raise give a log message."""

    async def whole() -> None:
        wire = Wire(Broken())
        wire.request(0, "initialize", INITIALIZE)
        item = {"uri": URI, "languageId": "mint", "version": 1, "text": "x = 1\n"}
        wire.notify("textDocument/didOpen", {"textDocument": item})
        await wire.settled()
        lines = {"start": {"line": 0, "character": 0}, "end": {"line": 1, "character": 0}}
        wire.request(1, "textDocument/inlayHint", {"textDocument": {"uri": URI}, "range": lines})
        await wire.settled()
        assert wire.answers()[1][0]["result"] == []
        (unnamed, checked, logged) = [each["params"] for each in wire.sent if "method" in each]
        assert unnamed["message"] == (
            "motionlang lsp: a.mnt has no names: internal error: RuntimeError: no names; "
            "motionlang check a.mnt shows the details"
        )
        assert [(each["code"], each["message"]) for each in checked["diagnostics"]] == [
            ("crash", "a.mnt cannot be checked: internal error: RuntimeError: no check\n"
                      "hint: motionlang check a.mnt shows the details"),
        ]  # fmt: skip
        assert logged["message"] == (
            "motionlang lsp: a.mnt has no time hints: internal error: RuntimeError: no times; "
            "motionlang run a.mnt shows the details"
        )

    asyncio.run(whole())


def phase(name: str) -> Wire:
    """Return a connection in one phase of a session.

    The phase is "new" before `initialize`, "open" with a text, "closed" after the text has been closed, or "down"
    after `shutdown`.
    """
    wire = Wire()
    if name == "new":
        return wire
    wire.request("first", "initialize", INITIALIZE)
    item = {"uri": URI, "languageId": "mint", "version": 1, "text": "x = 1\nPrint x\n"}
    wire.notify("textDocument/didOpen", {"textDocument": item})
    if name == "closed":
        wire.notify("textDocument/didClose", {"textDocument": {"uri": URI}})
    if name == "down":
        wire.request("last", "shutdown", None)
    return wire


@cases("name, code", (("new", -32002), ("open", None), ("closed", None), ("down", -32600)))
def test_each_request_is_answered_in_each_phase(name: str, code: int | None) -> None:
    async def whole() -> None:
        wire, chance = phase(name), Chance(7)
        for number, method in enumerate(REQUESTS):
            parameters = chance.parameters(method)
            wire.request(number, method, {**parameters, "textDocument": {"uri": URI}})
        wire.request("again", "initialize", INITIALIZE)
        await wire.settled()
        answers = wire.answers()
        for number in (*range(len(REQUESTS)), "again"):
            (answer,) = answers[number]
            if code is not None and not (name == "new" and number == "again"):
                assert answer["error"]["code"] == code
        assert "Traceback" not in json.dumps(wire.sent)

    asyncio.run(whole())


def test_garbage_gets_at_most_an_error() -> None:
    async def whole() -> None:
        wire = phase("open")
        for number, body in enumerate(GARBAGE, 100):
            wire.receive(body)
            wire.request(number, "textDocument/documentSymbol", {"textDocument": {"uri": URI}})
            await wire.settled()
            assert [each["name"] for each in wire.answers()[number][0]["result"]] == ["x"], body[:100]

    asyncio.run(whole())


# A text, and changes of it with positions that it does not have; then the text as it is.
EDITS: tuple[tuple[str, list[dict[str, Any]], str], ...] = (
    ("a\nb", [{"range": [9, 9, 9, 9], "text": "c"}], "a\nbc"),
    ("a\nb", [{"range": [0, 99, 0, 99], "text": "c"}], "ac\nb"),
    ("ab", [{"range": [0, 2, 0, 1], "text": "c"}], "ac"),
    ("\U0001f527b", [{"range": [0, 1, 0, 2], "text": ""}], "b"),
    ("a\r\nb\rc", [{"range": [1, 0, 2, 0], "text": ""}], "a\nc"),
    ("a\x0cb\u2028c\nd", [{"range": [1, 0, 1, 1], "text": "e"}], "a\x0cb\u2028c\ne"),
    ("\ufeffa", [{"range": [0, 1, 0, 2], "text": "b"}], "\ufeffb"),
    ("a", [{"text": "b"}, {"range": [0, 1, 0, 1], "text": "c"}], "bc"),
)


@cases("text, changes, wanted", EDITS)
def test_changes_with_any_position_are_applied(text: str, changes: list[dict[str, Any]], wanted: str) -> None:
    async def whole() -> None:
        wire = phase("closed")
        item = {"uri": URI, "languageId": "mint", "version": 5, "text": text}
        wire.notify("textDocument/didOpen", {"textDocument": item})
        sent = []
        for each in changes:
            made = {"text": each["text"]}
            if "range" in each:
                line, column, last, end = each["range"]
                made["range"] = {
                    "start": {"line": line, "character": column}, "end": {"line": last, "character": end},
                }  # fmt: skip
            sent.append(made)
        identifier = {"uri": URI, "version": 2}  # backwards
        wire.notify("textDocument/didChange", {"textDocument": identifier, "contentChanges": sent})
        known = wire.server.session.known(URI)
        assert known is not None
        assert known.document.text == wanted
        await wire.settled()
        published = [
            each["params"] for each in wire.sent if each.get("method") == "textDocument/publishDiagnostics"
        ]
        assert published[-1]["version"] == 2

    asyncio.run(whole())


# ------------------------------------------------------------------------------------- real processes


class Process:
    """A server in a separate process; messages are sent and received as bytes."""

    def __init__(self, *arguments: str) -> None:
        self.process = subprocess.Popen(
            [sys.executable, "-m", "motionlang", "lsp", *arguments],
            cwd=ROOT,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        self.input, self.output = self.process.stdin, self.process.stdout

    def send(self, message: object) -> None:
        body = json.dumps(message).encode()
        self.input.write(b"Content-Length: %d\r\n\r\n%b" % (len(body), body))
        self.input.flush()

    def request(self, number: int, method: str, parameters: object) -> None:
        self.send({"jsonrpc": "2.0", "id": number, "method": method, "params": parameters})

    def notify(self, method: str, parameters: object) -> None:
        self.send({"jsonrpc": "2.0", "method": method, "params": parameters})

    def open(self, text: str) -> None:
        self.request(0, "initialize", INITIALIZE)
        self.notify("initialized", {})
        item = {"uri": URI, "languageId": "mint", "version": 1, "text": text}
        self.notify("textDocument/didOpen", {"textDocument": item})

    def read(self) -> dict[str, Any]:
        """Return the next message."""
        length = 0
        while (line := self.output.readline()) not in (b"\r\n", b""):
            if line.lower().startswith(b"content-length:"):
                length = int(line.partition(b":")[2])
        assert length
        message: dict[str, Any] = json.loads(self.output.read(length))
        return message

    def until(self, **wanted: object) -> dict[str, Any]:
        """Return the next message that has these members."""
        while True:
            message = self.read()
            if all(message.get(key) == value for key, value in wanted.items()):
                return message

    def end(self) -> tuple[int, str]:
        """Close the connection; return exit status and standard error."""
        _, err = self.process.communicate(timeout=MAX_SECONDS)
        return self.process.returncode, err.decode()


def children(process: int) -> list[int]:
    """Return the processes that a process has started."""
    found = []
    for task in Path(f"/proc/{process}/task").iterdir():
        found += [int(each) for each in (task / "children").read_text().split()]
    return found


def is_running(process: int) -> bool:
    try:
        state = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0]
    except OSError:
        return False
    return state != "Z"


def are_ended(processes: list[int]) -> bool:
    """True as soon as none of the processes runs; False after a minute."""
    end = time.monotonic() + MAX_SECONDS
    while any(map(is_running, processes)):
        if time.monotonic() > end:
            return False
        time.sleep(0.01)
    return True


linux = pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="needs /proc")


@linux
@pytest.mark.parametrize("victim", ["server", "worker", "client"])
@pytest.mark.slow
def test_no_process_is_left_after_a_kill(victim: str) -> None:
    served = Process()
    served.open("Print 1 1\n")
    served.until(method="textDocument/publishDiagnostics")
    started = children(served.process.pid)
    assert started
    if victim == "server":
        served.process.kill()
    elif victim == "client":
        served.input.close()  # which is what the server sees of a client that is killed
    else:
        for each in started:
            os.kill(each, signal.SIGKILL)
        change = {"textDocument": {"uri": URI, "version": 2}, "contentChanges": [{"text": "Print 2 2\n"}]}
        served.notify("textDocument/didChange", change)
        found = served.until(method="textDocument/publishDiagnostics")
        assert found["params"]["version"] == 2
        started = children(served.process.pid)
        served.input.close()
    assert are_ended([*started, served.process.pid])
    served.process.wait()
    for stream in (served.input, served.output, served.process.stderr):
        assert stream is not None
        with suppress(BrokenPipeError):
            stream.close()


@pytest.mark.slow
def test_a_line_of_ten_megabytes_gets_one_warning() -> None:
    served = Process()
    served.open("x = 1" + " + 1" * 2_500_000)
    found = served.until(method="textDocument/publishDiagnostics")["params"]["diagnostics"]
    served.request(1, "shutdown", None)
    served.until(id=1)
    served.notify("exit", None)
    assert served.end() == (0, "")
    assert [each["message"] for each in found] == [
        "the text is too large to be checked as you type\nhint: motionlang check a.mnt checks it"
    ]


def test_bytes_that_are_no_message_are_answered() -> None:
    """A header may have any case, and blanks around its number."""
    served = Process()
    served.input.write(b"nonsense\r\n\r\nContent-Length: 3\r\n\r\n\xff\xfe{")
    served.input.flush()
    assert served.read()["error"]["code"] == -32700
    headers = (b"content-length:%d", b"CONTENT-LENGTH :\t%d ", b"Content-Type: x\r\nContent-length:  %d")
    for number, header in enumerate(headers, 1):
        body = json.dumps({"jsonrpc": "2.0", "id": number, "method": "nothing"}).encode()
        served.input.write(header % len(body) + b"\r\n\r\n" + body)
        served.input.flush()
        assert served.until(id=number)["error"]["code"] == -32002
    served.open("Print 1\n")
    assert served.until(id=0)["result"]["serverInfo"]["name"] == "motionlang"
    served.notify("exit", None)
    assert served.end() == (1, "")


def test_a_server_at_a_port_ends_with_its_editor() -> None:
    served = Process("--tcp", "127.0.0.1:0")
    assert served.process.stderr is not None
    line = served.process.stderr.readline().decode()
    host, _, port = line.removeprefix("waiting for an editor at ").strip().rpartition(":")
    with socket.create_connection((host, int(port)), MAX_SECONDS) as connection:
        body = json.dumps({"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": INITIALIZE}).encode()
        connection.sendall(b"Content-Length: %d\r\n\r\n%b" % (len(body), body))
        assert b"Content-Length" in connection.recv(100)
    assert served.end() == (0, "")

"""`motionlang dap` as a process: stdio, TCP, and a client that disappears."""

from __future__ import annotations

import socket
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import IO, Any

import pytest

from motionlang.hosts.address import listen, shown
from tests.ide.dap.wire import read, written
from tests.ide.debug.test_debugger import CALLS

ENDLESS = "Dim n As Integer\nLoop\n  n = n + 1\n  If n > 99 Then n = 0\nEnd Loop\n"
PATIENCE = 60.0
pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")


def start(*arguments: str) -> subprocess.Popen[bytes]:
    command = [sys.executable, "-m", "motionlang", "dap", *arguments]
    pipe = subprocess.PIPE
    return subprocess.Popen(command, stdin=pipe, stdout=pipe, stderr=pipe)


@pytest.fixture
def stdio() -> Iterator[subprocess.Popen[bytes]]:
    with start() as process:
        yield process
        process.kill()
        for stream in (process.stdin, process.stdout):
            if stream is not None and not stream.closed:
                stream.close()


def has_ipv6() -> bool:
    """True if this computer can listen on its own IPv6 address."""
    try:
        listen("::1", 0).close()
    except OSError:
        return False
    return True


def requests(program: Path, *more: str) -> list[dict[str, Any]]:
    first = [
        ("initialize", {"adapterID": "x"}),
        ("launch", {"program": str(program)}),
        ("configurationDone", {}),
    ]
    commands = [*first, *((each, {}) for each in more)]
    return [
        {"seq": number, "type": "request", "command": command, "arguments": arguments}
        for number, (command, arguments) in enumerate(commands, 1)
    ]


def until(stream: IO[bytes], name: str) -> list[dict[str, Any]]:
    """Return the messages up to an event or a response with this name."""
    found: list[dict[str, Any]] = []
    while not found or name not in (found[-1].get("event"), found[-1].get("command")):
        message = read(stream)
        assert message is not None, found
        found.append(message)
    return found


def send(stream: IO[bytes], messages: list[dict[str, Any]]) -> None:
    stream.write(b"".join(map(written, messages)))
    stream.flush()


def program(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "program.mnt"
    path.write_text(text)
    return path


def test_a_session_over_stdio(stdio: subprocess.Popen[bytes], tmp_path: Path) -> None:
    assert stdio.stdin is not None
    assert stdio.stdout is not None
    send(stdio.stdin, requests(program(tmp_path, CALLS)))
    found = until(stdio.stdout, "terminated")
    assert "12\n" in [each["body"]["output"] for each in found if each.get("event") == "output"]
    assert [each["seq"] for each in found] == list(range(1, len(found) + 1))
    send(stdio.stdin, [{"seq": 9, "type": "request", "command": "disconnect"}])
    assert stdio.wait(PATIENCE) == 0
    assert stdio.stderr is not None
    assert stdio.stderr.read() == b""


@pytest.mark.parametrize("host", ["127.0.0.1", "::1"])
def test_a_session_over_tcp(tmp_path: Path, host: str) -> None:
    if host == "::1" and not has_ipv6():
        pytest.skip("no IPv6 on this computer")
    process = start("--tcp", shown(host, 0))
    assert process.stderr is not None
    text, _, port = process.stderr.readline().decode().rstrip().rpartition(":")
    assert text == f"listening on {shown(host, 0).removesuffix(':0')}"
    with (
        socket.create_connection((host, int(port)), PATIENCE) as connection,
        connection.makefile("rwb") as stream,
    ):
        send(stream, requests(program(tmp_path, CALLS)))  # type: ignore[arg-type]
        until(stream, "terminated")  # type: ignore[arg-type]
    assert process.wait(PATIENCE) == 0  # the client has gone
    process.communicate()


@pytest.mark.parametrize("text", [ENDLESS, "Dim n As Integer\nINPUT n\n", "JOG(0) = 1\nPAUSE INX(1)\n"])
def test_the_adapter_ends_with_its_client(stdio: subprocess.Popen[bytes], tmp_path: Path, text: str) -> None:
    """The adapter sees only the end of the stream when its client is killed."""
    assert stdio.stdin is not None
    assert stdio.stdout is not None
    send(stdio.stdin, requests(program(tmp_path, text)))
    until(stdio.stdout, "configurationDone")
    stdio.stdin.close()
    stdio.stdout.close()
    assert stdio.wait(PATIENCE) == 0


@pytest.mark.parametrize(
    ("text", "answer"),
    [
        (b"\r\n\r\nContent-Length: 2\r\n\r\n{}", b""),
        (b"Content-Length: 4\r\n\r\nnull", b"the message is not an object"),
        (
            b"Content-Length: 2\r\n\r\n[]" + written({"type": "request", "command": "fly"}),
            b"there is no request 'fly'",
        ),
        (b"Content-Length: 3\r\n\r\n\xff\xfe!", b"the message is not JSON in UTF-8"),
        (b"Content-Length: 9\r\n\r\n" + b"[" * 9, b"the message is not JSON in UTF-8"),
        (b"Content-Length: many\r\n\r\n", b"may have up to"),
        (b"Content-Length: 999999999999\r\n\r\n", b"may have up to"),
        (b"GET / HTTP/1.1\r\n\r\n", b"no Content-Length"),
        (b"x" * 20_000, b"the header is too long"),
        (b"Content-Length: 100\r\n\r\nshort", b""),
    ],
)
def test_a_stream_that_is_none_ends_the_session_with_a_sentence(
    stdio: subprocess.Popen[bytes], text: bytes, answer: bytes
) -> None:
    output, errors = stdio.communicate(text, PATIENCE)
    assert (stdio.returncode, errors) == (0, b"")
    assert answer in output

"""Hosts of virtual boards: in process, and over the port of a served board."""

from __future__ import annotations

import os
import re
import shutil
import socket
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from motionlang.hosts.mccl.console import Console
from motionlang.hosts.serve import Limits, LockStep, RealTime, Server
from motionlang.hosts.serve.pace import ServerPace
from motionlang.kernel import Machine
from motionlang_mcapi import MC_OPEN_BINARY, Mcapi
from motionlang_mcapi.build import TARGETS
from motionlang_mcapi.host import McapiHost
from motionlang_mcapi.protocol import encode, parse
from motionlang_mcapi.session import McapiBoard

# The C library, and the functions that its header declares.
SOURCE = Path(__file__).parents[1] / "motionlang_mcapi" / "library"
FUNCTIONS = re.findall(
    r"^MCAPI_EXPORT .* APIENTRY (\w+)\(", (SOURCE / "mcapi.h").read_text("utf-8"), re.MULTILINE
)
# Seconds after which a waiting test has failed; a successful one never waits that long.
PATIENCE = 20.0
COMPILER = next(filter(shutil.which, TARGETS["linux"].compilers), None)
needs_compiler = pytest.mark.skipif(
    COMPILER is None or sys.platform != "linux", reason="the C library needs Linux and a C compiler"
)


def motionlang(cache: Path, *words: str, **more: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "MOTIONLANG_CACHE": str(cache), **more}
    command = [sys.executable, "-m", "motionlang", "mcapi", *words]
    # Hosts write files into their folder.
    return subprocess.run(
        command, env=environment, capture_output=True, text=True, timeout=100, check=False, cwd=cache
    )


@pytest.fixture(scope="session")
def cache(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of a user's cache in which the library has been built."""
    folder = tmp_path_factory.mktemp("cache")
    done = motionlang(folder, "build")
    assert (done.returncode, done.stderr) == (0, "")
    return folder


@pytest.fixture(scope="session")
def library(cache: Path) -> Path:
    """Return the C library."""
    (found,) = cache.rglob(TARGETS["linux"].library)
    return found


@pytest.fixture(scope="session")
def chost(library: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the C host of these tests, linked with the library like other hosts."""
    program = tmp_path_factory.mktemp("host") / "chost"
    source = Path(__file__).parent / "host.c"
    options = ["-O1", f"-I{SOURCE}", f"-L{library.parent}"]
    command = [str(COMPILER), *options, "-o", str(program), str(source), "-lmcapi", "-lpthread"]
    subprocess.run(command, check=True)
    return program


def opened(machine: dict[str, object] | None = None, mode: int = MC_OPEN_BINARY) -> Mcapi:
    """Return a host of a virtual board with an open handle."""
    host = Mcapi.virtual(machine)
    assert host.Open(0, mode) == 1
    return host


@pytest.fixture
def host() -> Mcapi:
    """A host of a virtual MultiFlex with a binary handle."""
    return opened()


class Line:
    """A connection to the port that sends and receives whole lines."""

    def __init__(self, address: tuple[str, int]) -> None:
        self.socket = socket.create_connection(address, PATIENCE)
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._rest = b""

    def send(self, line: str) -> None:
        self.socket.sendall(line.encode("latin-1") + b"\n")

    def answer(self) -> str:
        while b"\n" not in self._rest:
            piece = self.socket.recv(65536)
            if not piece:
                return "closed"
            self._rest += piece
        found, _, self._rest = self._rest.partition(b"\n")
        return found.decode("latin-1")

    def ask(self, line: str) -> str:
        self.send(line)
        return self.answer()


class Board:
    """A served board that runs in a separate thread."""

    def __init__(self, machine: dict[str, object], clock: str, limits: Limits | None) -> None:
        console = Console(Machine(machine, first_axis=1))
        self.complaints: list[str] = []
        self.console = console
        pace: ServerPace = LockStep(console) if clock == "lockstep" else RealTime(console)
        self.server = Server(console, pace, limits=limits, complain=self.complaints.append)
        self.mcapi = McapiBoard(console, self.complaints.append)
        self.address = self.server.listen(
            "127.0.0.1",
            0,
            make=lambda number, channel: McapiHost(
                number, channel, self.mcapi, self.server.limits, self.server.spy
            ),
        )
        self.ascii = self.server.listen("127.0.0.1", 0)
        self.lines: list[Line] = []
        self._thread = threading.Thread(target=self.server.run, daemon=True)
        self._thread.start()

    @property
    def name(self) -> str:
        """The address in the form of the environment variable MCAPI_HOST."""
        return f"{self.address[0]}:{self.address[1]}"

    def connect(self) -> Line:
        line = Line(self.address)
        self.lines.append(line)
        return line

    def end(self) -> None:
        if self._thread.is_alive():
            self.server.stop()
            self._thread.join(PATIENCE)
            assert not self._thread.is_alive()
            self.server.close()
        for line in self.lines:
            line.socket.close()


Serve = Callable[..., Board]


@pytest.fixture
def serve() -> Iterator[Serve]:
    """Yield `serve(machine={}, clock="lockstep", limits=None)`, which serves a board."""
    boards: list[Board] = []

    def begin(
        machine: dict[str, object] | None = None, clock: str = "lockstep", limits: Limits | None = None
    ) -> Board:
        boards.append(Board(machine or {}, clock, limits))
        return boards[-1]

    yield begin
    for board in boards:
        board.end()


def ask(host: Mcapi, line: str) -> str:
    """Return the board's answer to a line of the port."""
    result, outputs = host._calls.call(*parse(line))
    return encode((result, *outputs))


def converse(host: Mcapi, dialogue: str) -> None:
    """Ask each line before `->`, and compare the answer with the text behind it."""
    for row in dialogue.strip().splitlines():
        line, _, wanted = (each.strip() for each in row.partition("->"))
        assert (line, ask(host, line)) == (line, wanted)

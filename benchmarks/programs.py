"""The measured programs, each with one figure and its limit.

A figure is a ratio, to real time or to an empty Python, or the time for a kilobyte of text.
"""

from __future__ import annotations

import gc
import os
import resource
import signal
import socket
import statistics
import subprocess
import sys
import tempfile
import threading
from pathlib import Path
from time import perf_counter, process_time
from typing import TYPE_CHECKING, NamedTuple

from motionlang.kernel.execution import run
from motionlang.kernel.mint.syntax.parser import parse
from motionlang.kernel.report import text
from motionlang.kernel.source import Source

if TYPE_CHECKING:
    from collections.abc import Callable

FOLDER = Path(__file__).parent
ROUNDS = 5
# 2 500 cycles of two moves on each of four axes, in 11.5 s each: 20 000 moves in eight hours.
SHIFT = """
Dim n As Integer
SPEED(0, 1, 2, 3) = 100;
ACCEL(0, 1, 2, 3) = 500;
DECEL(0, 1, 2, 3) = 500;
For n = 1 To 2500
  MOVER(0, 1, 2, 3) = 20, 30, 40, 35
  GO(0, 1, 2, 3)
  PAUSE IDLE(0) And IDLE(1) And IDLE(2) And IDLE(3)
  WAIT(5150)
  MOVEA(0, 1, 2, 3) = 0;
  GO(0, 1, 2, 3)
  PAUSE IDLE(0) And IDLE(1) And IDLE(2) And IDLE(3)
  WAIT(5160)
Next
"""
AXES = "0, 1, 2, 3, 4, 5, 6, 7"
# Eight axes with motors back and forth, at rest for as long as they move.
MOTORS = f"""
Dim n As Integer
SCALEFACTOR({AXES}) = 100;
SPEED({AXES}) = 100;
ACCEL({AXES}) = 500;
DECEL({AXES}) = 500;
For n = 1 To 12
  MOVER({AXES}) = 20, 30, 40, 35, 20, 30, 40, 35
  GO({AXES})
  PAUSE IDLE({AXES})
  WAIT(500)
  MOVEA({AXES}) = 0;
  GO({AXES})
  PAUSE IDLE({AXES})
  WAIT(500)
Next
"""
# Round trips of each kind that a host makes.
TRIPS = 2000


class Program(NamedTuple):
    """A measurement, the unit of its figure, and the limit: a minimum, or a maximum."""

    measure: Callable[[], float]
    unit: str
    limit: float
    is_minimum: bool

    def holds(self, figure: float) -> bool:
        """True if a figure is within the limit."""
        return figure >= self.limit if self.is_minimum else figure <= self.limit


def seconds(work: Callable[[], object]) -> float:
    """Return the shortest processor time of some calls, s."""
    best = float("inf")
    for _ in range(ROUNDS):
        gc.collect()
        began = process_time()
        work()
        best = min(best, process_time() - began)
    return best


def shift() -> float:
    """Return machine time over processor time of a shift, from its text to its JSON report."""
    machine_time = 0.0

    def whole() -> None:
        nonlocal machine_time
        result = run(Source("shift.mnt", SHIFT), machine={})
        assert result.status == "ended", result.status
        text(result)
        machine_time = result.time

    taken = seconds(whole)
    return machine_time / taken


def parsing() -> float:
    """Return the time to parse a kilobyte of an ordinary program, ms, in a text of many copies of it."""
    source = Source("big.mnt", (FOLDER / "start.mnt").read_text(encoding="utf-8") * 20)
    return seconds(lambda: parse(source)) / len(source.text) * 1e6


def start() -> float:
    """Return the processor time of a process that runs a program of a hundred lines, over that of an empty Python."""
    with tempfile.TemporaryDirectory() as folder:
        environment = {**os.environ, "PYTHONPYCACHEPREFIX": f"{folder}/pyc"}
        environment.pop("PYTHONDONTWRITEBYTECODE", None)
        command = [sys.executable, "-m", "motionlang", "run", str(FOLDER / "start.mnt"), "--format", "none"]
        empty = [sys.executable, "-c", "pass"]
        pairs = [(_of_process(command, environment), _of_process(empty, environment)) for _ in range(12)]
    whole, nothing = (statistics.median(each) for each in zip(*pairs[1:], strict=True))
    return float(whole / nothing)


def _of_process(command: list[str], environment: dict[str, str]) -> float:
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, env=environment, stdout=subprocess.DEVNULL, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def motors() -> float:
    """Return machine time over processor time of eight axes with motors, the suggestion of their gains included."""
    machine: dict[str, object] = {f"axis.{axis}.plant.load_inertia": 4e-5 for axis in range(8)}
    machine_time = 0.0

    def whole() -> None:
        nonlocal machine_time
        result = run(Source("eight.mnt", MOTORS), machine=machine)
        assert result.status == "ended", result.status
        machine_time = result.time

    taken = seconds(whole)
    return machine_time / taken


def hosts() -> float:
    """Return the median time of MCGetPositionEx over that of `1TP`, each on a connection to a served board."""
    command = [sys.executable, "-m", "motionlang", "mcapi", "serve", "--tcp", "0", "--port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as server:
        guard = threading.Timer(120.0, server.kill)  # the server never outlives its measurement
        guard.start()
        assert server.stdout is not None
        lines = [server.stdout.readline() for _ in range(3)]
        ports = [int(line.split()[2].rpartition(":")[2]) for line in lines[1:]]
        mcapi, ascii_ = ports if "MCAPI" in lines[1] else ports[::-1]
        calls, commands = [], []
        with _connected(mcapi) as host, _connected(ascii_) as other:
            assert other.recv(1) == b">"
            _ask(host, b"MCOpen 0 2 -\n", b"\n")
            for _ in range(TRIPS):
                begin = perf_counter()
                _ask(host, b"MCGetPositionEx 1 1 +\n", b"\n")
                middle = perf_counter()
                _ask(other, b"1TP\r", b">")
                calls.append(middle - begin)
                commands.append(perf_counter() - middle)
        server.send_signal(signal.SIGTERM)
        server.wait(20)
        guard.cancel()
    return statistics.median(calls) / statistics.median(commands)


def _connected(port: int) -> socket.socket:
    host = socket.create_connection(("127.0.0.1", port), 20)
    host.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    return host


def _ask(host: socket.socket, line: bytes, end: bytes) -> None:
    host.sendall(line)
    answer = host.recv(256)
    while not answer.endswith(end):
        answer += host.recv(256)


PROGRAMS: dict[str, Program] = {
    "shift": Program(shift, "x real time", 50_000.0, True),
    "parse": Program(parsing, "ms/kB", 5.0, False),
    "start": Program(start, "x an empty Python", 20.0, False),
    "motors": Program(motors, "x real time", 25.0, True),
    "hosts": Program(hosts, "x 1TP", 1.3, False),
}

"""The speed of MCAPI compared with ASCII MCCL.

A read over the port and in process, hosts side by side, and the replay of a log.

Prints `name value unit`. Over the port, MCGetPositionEx and `1TP` alternate in one run, with plain sockets
and one server; each figure is a ratio. The replayed log has reads in motion; its memory is the peak of a
separate process.
"""

from __future__ import annotations

import resource
import selectors
import signal
import socket
import statistics
import subprocess
import sys
import threading
from multiprocessing import get_context
from tempfile import TemporaryFile
from time import perf_counter, process_time
from typing import BinaryIO

from motionlang.client.virtual import VirtualWire
from motionlang.execution import accelerators
from motionlang.lang.machine.machine import Machine
from motionlang.mcapi import MC_OPEN_BINARY, Mcapi
from motionlang.mcapi.client import VirtualBoard
from motionlang.mcapi.log import read
from motionlang.mcapi.replay import Replay
from motionlang.mccl.hosts.console import Console

TRIPS = 3000
HOSTS = 20
THREADS = 8
SECONDS = 2.0
READ, ANSWER = b"MCGetPositionEx 1 1 +\n", b"0 0.0\n"
FEW, MANY = 100_000, 1_000_000


def connect(port: int) -> socket.socket:
    """Return a connection to a port."""
    host = socket.create_connection(("127.0.0.1", port), 20)
    host.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    return host


def ask(host: socket.socket, line: bytes, end: bytes) -> bytes:
    """Send a line and return the answer, which ends with `end`."""
    host.sendall(line)
    answer = host.recv(256)
    while not answer.endswith(end):
        answer += host.recv(256)
    return answer


def opened(port: int) -> socket.socket:
    """Return a connection on which a handle is open."""
    host = connect(port)
    assert ask(host, b"MCOpen 0 2 -\n", b"\n") == b"1\n"
    return host


def over_the_port(mcapi: int, ascii: int) -> float:
    """Return the median time of MCGetPositionEx divided by that of 1TP."""
    calls, lines = [], []
    with opened(mcapi) as host, connect(ascii) as other:
        assert other.recv(1) == b">"
        for _ in range(TRIPS):
            begin = perf_counter()
            ask(host, READ, b"\n")
            middle = perf_counter()
            ask(other, b"1TP\r", b">")
            calls.append(middle - begin)
            lines.append(perf_counter() - middle)
    return statistics.median(calls) / statistics.median(lines)


def side_by_side(port: int, count: int) -> dict[socket.socket, int]:
    """Return how many reads each of `count` hosts completes within `SECONDS`."""
    hosts = [opened(port) for _ in range(count)]
    counts = dict.fromkeys(hosts, 0)
    with selectors.DefaultSelector() as selector:
        for host in hosts:
            selector.register(host, selectors.EVENT_READ)
            host.sendall(READ)
        end = perf_counter() + SECONDS
        while perf_counter() < end:
            for key, _ in selector.select(1.0):
                host = key.fileobj  # type: ignore[assignment]
                assert host.recv(64) == ANSWER
                counts[host] += 1
                host.sendall(READ)
    for host in hosts:
        host.close()
    return counts


def total(counts: dict[socket.socket, int]) -> int:
    """Return the number of reads of all hosts."""
    return len([None for count in counts.values() for _ in range(count)])


def next_to_a_wait(port: int) -> float:
    """Return the share of reads that remains while another host waits in a poll.

    It is the number of reads of eight connections, relative to that without the waiting host.
    """
    shares = []
    for _ in range(3):
        alone = total(side_by_side(port, THREADS))
        with opened(port) as waiting:
            for line in (b"MCEnableAxis 1 2 1\n", b"MCSetOperatingMode 1 2 0 4\n", b"MCGoEx 1 2 0.0\n"):
                assert ask(waiting, line, b"\n") == b"0\n"
            waiting.sendall(b"MCIsStopped 1 2 60.0\n")
            shares.append(total(side_by_side(port, THREADS)) / alone)
            with opened(port) as other:
                ask(other, b"MCAbort 1 2\n", b"\n")
            assert waiting.recv(64) == b"1\n"
    return statistics.median(shares)


def served() -> None:
    """Measure everything that needs a server."""
    command = [sys.executable, "-m", "motionlang", "serve", "--tcp", "0", "--mcapi", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as server:
        # The server never outlives its measurement.
        guard = threading.Timer(120.0, server.kill)
        guard.start()
        assert server.stdout is not None
        lines = [server.stdout.readline() for _ in range(3)]
        ports = [int(line.split()[2].rpartition(":")[2]) for line in lines[1:]]
        mcapi, ascii = ports if "MCAPI" in lines[1] else ports[::-1]
        print(f"mcapi_read_over_1tp {over_the_port(mcapi, ascii):.3f} x")
        counts = side_by_side(mcapi, HOSTS)
        print(f"mcapi_20_hosts_least_share {min(counts.values()) * HOSTS / total(counts):.3f} of_mean")
        print(f"mcapi_next_to_a_wait {next_to_a_wait(mcapi):.3f} of_alone")
        server.send_signal(signal.SIGTERM)
        server.wait(20)
        guard.cancel()


def in_process() -> float:
    """Return the time of a read divided by that of a line of 1TP, in virtual time."""
    host = Mcapi.virtual()
    host.Open(0, MC_OPEN_BINARY)
    console = Console(Machine(None, first_axis=1, accelerators=accelerators()))
    wire = VirtualWire(console, 1e-3)
    wire.receive(1.0)
    ratios = []
    for _ in range(20):
        begin = process_time()
        for _ in range(500):
            host.GetPositionEx(1)
        middle = process_time()
        for _ in range(500):
            wire.send(b"1TP\r")
            wire.receive(1.0)
        ratios.append((middle - begin) / (process_time() - middle))
    return statistics.median(ratios)


def write_log(file: BinaryIO, calls: int) -> None:
    """Write a log in which an axis moves and its position is read every millisecond."""
    file.write(b"mcapi-log 1\n0.0 0.0 1 MCOpen 0 2 - = 1\n")
    for k, call in enumerate(
        ("MCEnableAxis 1 1 1", "MCSetOperatingMode 1 1 0 4", "MCSetVelocity 1 1 1000.0")
    ):
        file.write(f"{0.001 * (k + 1):.6f} {0.001 * (k + 1):.6f} 1 {call} = 0\n".encode())
    file.write(b"0.010000 0.010000 1 MCGoEx 1 1 0.0 = 0\n")
    # At 1000 counts/s after 10 ms of acceleration, with the command's own 10 us.
    for k in range(calls):
        time = 0.1 + 0.001 * k
        position = round(1000.0 * (time - 0.01501))
        file.write(f"{time:.6f} {time:.6f} 1 MCGetPositionEx 1 1 + = 0 {position}.0\n".encode())


def replay(calls: int) -> tuple[float, float]:
    """Return the replayed calls per processor second, and the peak of memory, MB."""
    with TemporaryFile() as file:
        write_log(file, calls)
        file.seek(0)
        begin = process_time()
        found = Replay(VirtualBoard(complain=lambda text: None))
        found.run(read(file))
        taken = process_time() - begin
    assert found.counts == {}, found.first and found.first.text
    return found.calls / taken, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def main() -> None:
    """Measure and print."""
    served()
    print(f"mcapi_virtual_over_1tp {in_process():.3f} x")
    context = get_context("spawn")
    with context.Pool(1, maxtasksperchild=1) as pool:
        (rate, few), (_, many) = (pool.apply(replay, (calls,)) for calls in (FEW, MANY))
    print(f"mcapi_replay {rate:.0f} calls/cpu_s")
    print(f"mcapi_replay_memory_growth {many - few:.1f} MB")


if __name__ == "__main__":
    main()

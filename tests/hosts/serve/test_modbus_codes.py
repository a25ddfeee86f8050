"""Requests and exceptions of the Modbus application protocol V1.1b3, byte by byte.

They go through a real connection. The server answers from a run with NetData: elements 0 to 999 are registers
0 to 1999.
"""

from __future__ import annotations

import re
import socket
import struct
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from threading import Thread

from motionlang.hosts.serve import Limits
from motionlang.hosts.serve.modbus import ModbusServer
from motionlang.hosts.serve.modbus_requests import Identity
from motionlang.hosts.serve.outside import LockStepQueue
from motionlang.kernel import Source, run

PATIENCE = 60.0
PROGRAM = "NETINTEGER(0) = 0x00030002\nNETINTEGER(5) = 0x12\nPAUSE NETINTEGER(999) = 1\n"


@contextmanager
def served(
    limits: Limits | None = None,
    complain: Callable[[str], None] = lambda text: None,
    unit: int | None = None,
) -> Iterator[ModbusServer]:
    outside = LockStepQueue()
    identity = Identity("motionlang", "NextMove e100", "0.1.0")
    server = ModbusServer(
        outside, "127.0.0.1", 0, limits=limits, unit=unit, identity=identity, complain=complain
    )
    server.start()
    source = Source("served.mnt", PROGRAM)
    thread = Thread(target=lambda: run(source, until=float("inf"), outside=outside))
    thread.start()
    try:
        yield server
        outside.ask(partial(end, outside)).result(PATIENCE)
        thread.join(PATIENCE)
    finally:
        server.stop()


def end(outside: LockStepQueue) -> None:
    """Write the element that the program waits for, which ends it."""
    assert outside.machine is not None
    outside.machine.host.write("netdata", 999, [1])


@contextmanager
def client(server: ModbusServer) -> Iterator[Callable[[bytes], bytes]]:
    """Yield a function that sends a request in a frame and returns the response."""
    with socket.create_connection(("127.0.0.1", server.port), PATIENCE) as connection:

        def ask(request: bytes) -> bytes:
            connection.sendall(frame(request))
            return response(connection)

        yield ask


def frame(request: bytes, transaction: int = 7, protocol: int = 0, unit: int = 9) -> bytes:
    return struct.pack(">HHHB", transaction, protocol, len(request) + 1, unit) + request


def response(connection: socket.socket, transaction: int = 7) -> bytes:
    head = exactly(connection, 7)
    found, protocol, length, unit = struct.unpack(">HHHB", head)
    assert (found, protocol, unit) == (transaction, 0, 9)
    return exactly(connection, length - 1)


def exactly(connection: socket.socket, count: int) -> bytes:
    data = b""
    while len(data) < count:
        more = connection.recv(count - len(data))
        assert more, "the server closed the connection"
        data += more
    return data


def words(function: int, *values: int) -> bytes:
    return struct.pack(f">B{len(values)}H", function, *values)


# The objects of the identification: number, length, text.
OBJECTS = {
    name: f"{number:02x}{len(text):02x}" + text.encode().hex()
    for name, number, text in (
        ("vendor", 0, "motionlang"),
        ("product", 1, "NextMove e100"),
        ("version", 2, "0.1.0"),
        ("name", 4, "NextMove e100"),
    )
}


def octets(text: str) -> bytes:
    """Return the bytes of a text in hexadecimal, with names of objects and `zeros*COUNT`."""
    text = re.sub(r"zeros\*(\d+)", lambda found: "00" * int(found[1]), text)
    return bytes.fromhex(re.sub("vendor|product|version|name", lambda found: OBJECTS[found[0]], text))


# A request, and its response by the specification.
ANSWERS = {
    name: (octets(request), octets(answer))
    for line in Path(__file__).with_name("modbus_codes.txt").read_text(encoding="utf-8").splitlines()
    if not line.startswith("#")
    for name, request, answer in re.findall("(.*): (.*) -> (.*)", line)
}


def test_each_request_has_the_response_of_the_specification() -> None:
    with served() as server, client(server) as ask:
        found = {name: ask(request) for name, (request, _) in ANSWERS.items()}
        assert found == {name: answer for name, (_, answer) in ANSWERS.items()}
        assert ask(words(3, 10, 1)) == bytes.fromhex("03 02 0017")  # written by the mask
        # Rejected requests wrote nothing: 20 and 21 have the values of "write registers".
        assert ask(words(3, 20, 2)) == bytes.fromhex("03 04 000a 0102")


def test_requests_sent_ahead_are_answered_in_order() -> None:
    with served() as server, socket.create_connection(("127.0.0.1", server.port), PATIENCE) as connection:
        ahead = [frame(words(6, 30 + k, k), transaction=k) for k in range(100)]
        connection.sendall(b"".join(ahead))
        assert [response(connection, k) for k in range(100)] == [words(6, 30 + k, k) for k in range(100)]


def test_frames_of_other_protocols_are_skipped_and_no_frame_ends_the_connection() -> None:
    with served() as server:
        with socket.create_connection(("127.0.0.1", server.port), PATIENCE) as connection:
            connection.sendall(frame(words(3, 0, 1), protocol=1) + frame(words(3, 0, 1)))
            assert response(connection) == bytes.fromhex("03 02 0002")
        for length in (0, 1, 255, 65535):
            with socket.create_connection(("127.0.0.1", server.port), PATIENCE) as connection:
                connection.sendall(struct.pack(">HHHB", 1, 0, length, 1))
                assert connection.recv(1) == b""


def test_only_frames_for_its_unit_and_for_any_device_are_answered() -> None:
    with (
        served(unit=9) as server,
        socket.create_connection(("127.0.0.1", server.port), PATIENCE) as connection,
    ):
        ask = words(3, 0, 1)
        connection.sendall(frame(ask, 1, unit=8) + frame(ask, 2, unit=0) + frame(ask, 3, unit=9))
        connection.sendall(frame(ask, 4, unit=10) + frame(ask, 5, unit=255))
        heads = []
        for _ in range(3):
            number, _, length, unit = struct.unpack(">HHHB", exactly(connection, 7))
            exactly(connection, length - 1)
            heads.append((number, unit))
        assert heads == [(2, 0), (3, 9), (5, 255)]


def test_a_client_too_many_is_turned_away() -> None:
    """The first two are still served.

    Each rejection is logged in a line, or is counted in the next line.
    """
    lines: list[str] = []
    with served(Limits(hosts=2), lines.append) as server:
        with client(server) as first, client(server) as second:
            assert first(words(3, 0, 1)) == second(words(3, 0, 1))
            for _ in range(20):
                with socket.create_connection(("127.0.0.1", server.port), PATIENCE) as third:
                    assert third.recv(1) == b""
            assert first(words(3, 1, 1)) == bytes.fromhex("03 02 0003")
        assert lines[0].endswith(" was turned away: 2 clients are connected already")
    refused = [line for line in lines if "turned away" in line]
    others = [
        int(line.rpartition("(")[2].split()[0]) for line in refused if line.endswith("since the last line)")
    ]
    assert len(refused) + sum(others) == 20


def test_a_silent_client_makes_room() -> None:
    with served(Limits(hosts=1, idle=0.0)) as server:
        silent = socket.create_connection(("127.0.0.1", server.port), PATIENCE)
        silent.sendall(frame(words(3, 0, 1)))
        assert response(silent) == bytes.fromhex("03 02 0002")
        with silent, client(server) as ask:
            assert ask(words(3, 1, 1)) == bytes.fromhex("03 02 0003")
            assert silent.recv(1) == b""


def test_a_client_that_has_sent_nothing_makes_room_and_requests_are_counted() -> None:
    """A request that is rejected counts unless it cannot be parsed."""
    with served(Limits(hosts=1, idle=0.0)) as server:
        silent = socket.create_connection(("127.0.0.1", server.port), PATIENCE)
        with silent, client(server) as ask:
            assert ask(words(3, 1, 1)) == bytes.fromhex("03 02 0003")
            assert ask(bytes.fromhex("2b 0e 01 07"))[:1] == b"\x2b"
            assert ask(bytes.fromhex("01 0000 0001")) == bytes.fromhex("81 01")
            assert silent.recv(1) == b""
            assert server.requests == 2


def test_a_server_that_has_not_started_can_be_stopped() -> None:
    ModbusServer(LockStepQueue(), "127.0.0.1", 0).stop()

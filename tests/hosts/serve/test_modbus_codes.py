"""Requests and exceptions of the Modbus application protocol V1.1b3, byte by byte.

They go through a real connection. The server answers from a run with NetData: elements 0 to 999 are registers
0 to 1999.
"""

from __future__ import annotations

import socket
import struct
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
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


ZEROS = "00" * 242
# The objects of the identification: number, length, text.
VENDOR, PRODUCT, VERSION, NAME = (
    f"{number:02x}{len(text):02x}" + text.encode().hex()
    for number, text in ((0, "motionlang"), (1, "NextMove e100"), (2, "0.1.0"), (4, "NextMove e100"))
)
# A request, and its response by the specification.
ANSWERS = {
    "read holding registers": ("03 0000 0002", "03 04 0002 0003"),
    "read input registers": ("04 0001 0001", "04 02 0003"),
    "read the last register": ("03 07cf 0001", "03 02 0000"),
    "read 125 registers": ("03 000c 007d", "03 fa" + "00" * 250),
    "write a register": ("06 0014 1234", "06 0014 1234"),
    "write registers": ("10 0014 0002 04 000a 0102", "10 0014 0002"),
    # The example of the specification, 6.16: 12 hex and F2, or 25 and not F2, is 17.
    "mask write": ("16 000a 00f2 0025", "16 000a 00f2 0025"),
    "write 121 and read": ("17 0000 0001 0020 0079 f2" + ZEROS, "17 02 0002"),
    # 01: unsupported functions.
    "read coils": ("01 0000 0001", "81 01"),
    "read discrete inputs": ("02 0000 0001", "82 01"),
    "write a coil": ("05 ffff ff00", "85 01"),
    "write coils": ("0f 0000 0001 01 01", "8f 01"),
    "diagnostics": ("08 0000 0000", "88 01"),
    "report server id": ("11", "91 01"),
    "another encapsulated interface": ("2b 0d 01 00", "ab 01"),
    "function 0": ("00", "80 01"),
    "function 80 hex": ("83 0000 0001", "83 01"),
    # 6.21 of the specification: basic, regular, from an object on, and a single one.
    "identify, basic": ("2b 0e 01 00", "2b 0e 01 82 00 00 03" + VENDOR + PRODUCT + VERSION),
    "identify, regular": ("2b 0e 02 00", "2b 0e 02 82 00 00 04" + VENDOR + PRODUCT + VERSION + NAME),
    "identify from object 2": ("2b 0e 01 02", "2b 0e 01 82 00 00 01" + VERSION),
    "identify from an object that does not exist": ("2b 0e 01 07", "2b 0e 01 82 00 00 03" + VENDOR + PRODUCT + VERSION),
    "identify, the product": ("2b 0e 04 01", "2b 0e 04 82 00 00 01" + PRODUCT),
    "identify, an object that does not exist": ("2b 0e 04 07", "ab 02"),
    "identify, category 5": ("2b 0e 05 00", "ab 03"),
    "identify, too short": ("2b 0e 01", "ab 03"),
    "identify, no code": ("2b 0e", "ab 03"),
    "no interface": ("2b", "ab 01"),
    "identify, category 0": ("2b 0e 00 00", "ab 03"),
    "identify, too long": ("2b 0e 01 00 00", "ab 03"),
    # 03 before 02: quantities, and lengths that do not fit them.
    "read no register": ("03 0000 0000", "83 03"),
    "read 126 registers": ("03 0000 007e", "83 03"),
    "read 126 registers that do not exist": ("04 ffff 007e", "84 03"),
    "read, too short": ("03 0000 00", "83 03"),
    "read, too long": ("03 0000 0001 00", "83 03"),
    "write a register, too short": ("06 0014", "86 03"),
    "write no register": ("10 0000 0000 00", "90 03"),
    "write 123 registers": ("10 0020 007b f6" + "00" * 246, "10 0020 007b"),
    "write, too short": ("10 0000 0001", "90 03"),
    "write 124 registers": ("10 0000 007c f8" + "00" * 246, "90 03"),
    "write with another byte count": ("10 0000 0002 02 0001 0002", "90 03"),
    "write with a value missing": ("10 0000 0002 04 0001", "90 03"),
    "mask write, too short": ("16 000a 00f2", "96 03"),
    "read and write no register": ("17 0000 0001 0000 0000 00", "97 03"),
    "read no register and write": ("17 0000 0000 0000 0001 02 0001", "97 03"),
    "read 126 registers and write": ("17 0000 007e 0000 0001 02 0001", "97 03"),
    # 02: a range with a register that does not exist.
    "read beyond the end": ("03 07cf 0002", "83 02"),
    "read beyond 65535": ("03 ffff 0002", "83 02"),
    "write beyond the end": ("06 07d0 0001", "86 02"),
    "write across the end": ("10 07cf 0002 04 0001 0002", "90 02"),
    "mask write beyond the end": ("16 07d0 0000 0000", "96 02"),
    "write, and read beyond the end": ("17 07cf 0002 0014 0001 02 0009", "97 02"),
    "write beyond the end, and read": ("17 0000 0001 07d0 0001 02 0009", "97 02"),
}  # fmt: skip


def test_each_request_has_the_response_of_the_specification() -> None:
    with served() as server, client(server) as ask:
        found = {name: ask(bytes.fromhex(request)) for name, (request, _) in ANSWERS.items()}
        assert found == {name: bytes.fromhex(answer) for name, (_, answer) in ANSWERS.items()}
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

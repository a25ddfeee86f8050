"""A Mint program with Modbus TCP and a real client: the map of ABB AN00198."""

from __future__ import annotations

import os
import re
import signal
import struct
import subprocess
import sys
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from threading import Thread
from typing import Any

import pytest

from motionlang import Run
from motionlang.cli import main
from motionlang.hosts.serve.outside import LockStepQueue, QuestionQueue, RealTimeQueue
from motionlang.kernel import Source, run
from tests.cli.programs import MAX_SECONDS

pytest.importorskip("pymodbus")
from pymodbus.client import ModbusTcpClient
from pyModbusTCP.client import ModbusClient

from motionlang.hosts.serve.modbus import ModbusServer

PACKER = """\
NETFLOAT(2) = 1.5
NETINTEGER(3) = 0x12345678
PAUSE NETINTEGER(9) = 1
PRINT TIME, " stop"
End

Event NETDATA4
  PRINT "event ", NETFLOAT(4)
  NETFLOAT(5) = NETFLOAT(4) * 2
End Event
"""

# Characters that wait for a reader of the output.
STORED = 1 << 18


class Served:
    """A program that runs in a thread with a server, and a connected client."""

    def __init__(self, text: str, outside: QuestionQueue, settings: dict[str, object] | None = None) -> None:
        self.outside = outside
        self.server = ModbusServer(outside, "127.0.0.1", 0)
        self.server.start()
        self.result: Run | None = None
        self._thread = Thread(target=self._run, args=(text, settings or {}), daemon=True)
        self._thread.start()
        self.client: Any = ModbusTcpClient("127.0.0.1", port=self.server.port, timeout=60)
        assert self.client.connect()  # type: ignore[no-untyped-call,unused-ignore]

    def _run(self, text: str, settings: dict[str, object]) -> None:
        source = Source("served.mnt", text)
        self.result = run(source, machine=settings, until=float("inf"), outside=self.outside)

    def read(self, register: int, count: int) -> list[int]:
        answer = self.client.read_holding_registers(register, count=count)
        assert not answer.isError(), answer
        return list(answer.registers)

    def write(self, register: int, *values: int) -> None:
        assert not self.client.write_registers(register, list(values)).isError()

    def end(self) -> Run:
        """End the program and wait until it has ended."""
        self.write(18, 1, 0)
        self._thread.join(10)
        assert self.result is not None
        return self.result

    def close(self) -> None:
        self.outside.close()
        self.client.close()
        self.server.stop()


@pytest.fixture(params=[RealTimeQueue, LockStepQueue])
def served(request: pytest.FixtureRequest) -> Iterator[Served]:
    served = Served(PACKER, request.param())
    yield served
    served.close()


def halves(value: float) -> tuple[int, int]:
    """Return a float as two registers, low half first."""
    low, high = struct.unpack("<HH", struct.pack("<f", value))
    return low, high


def test_element_n_is_registers_2n_and_2n_plus_1(served: Served) -> None:
    assert served.read(4, 4) == [*halves(1.5), 0x5678, 0x1234]
    assert list(served.client.read_input_registers(6, count=2).registers) == [0x5678, 0x1234]


def test_a_write_raises_the_event_and_the_program_answers(served: Served) -> None:
    served.write(8, *halves(2.25))
    while served.read(10, 2) != [*halves(4.5)]:
        pass
    served.write(8, *halves(2.25))  # the same value again is no event
    result = served.end()
    assert (result.status, result.output[0], len(result.output)) == ("ended", "event 2.2500", 2)


def test_every_write_function(served: Served) -> None:
    client = served.client
    assert not client.write_register(20, 7).isError()
    assert not client.mask_write_register(address=20, and_mask=0xFFFE, or_mask=0).isError()
    answer: Any = client.readwrite_registers(read_address=20, read_count=2, write_address=21, values=[3])
    assert list(answer.registers) == [6, 3]


def test_what_does_not_exist_is_reported_to_the_client(served: Served) -> None:
    for answer, code in (
        (served.client.read_holding_registers(1999, count=2), 2),
        (served.client.write_registers(2000, [1]), 2),
        (served.client.read_coils(0, count=1), 1),
    ):
        assert (answer.isError(), answer.exception_code) == (True, code)


def test_another_client_than_pymodbus(served: Served) -> None:
    """pyModbusTCP reads and writes registers, and reads the identification."""
    client = ModbusClient("127.0.0.1", served.server.port, unit_id=5, timeout=60.0)
    try:
        assert client.write_multiple_registers(20, [7, 8])
        assert client.read_holding_registers(20, 2) == [7, 8]
        found = client.read_device_identification()
        assert found is not None
        assert (found.vendor_name, found.product_code) == (b"motionlang", b"Virtual Controller")
    finally:
        client.close()


def test_the_comms_array_of_an_esb() -> None:
    text = (
        PACKER.replace("NETINTEGER", "COMMSINTEGER").replace("NETFLOAT", "COMMS").replace("NETDATA", "COMMS")
    )
    served = Served(text, LockStepQueue(), {"controller.model": "nextmove-esb2"})
    try:
        assert served.client.read_holding_registers(0, count=2).isError()  # there is no element 0
        served.write(8, *halves(1.0))
        served.write(8, *halves(1.0))  # an ESB-2 raises its events on every write
        assert served.end().output[:2] == ["event 1.0000", "event 1.0000"]
    finally:
        served.close()


def test_lock_step_finds_the_same_machine_every_time() -> None:
    outputs = []
    for _ in range(2):
        served = Served(
            "JOG(0) = 1000\nLoop\n  NETFLOAT(6) = POS(0)\n  WAIT = 1\nEnd Loop", LockStepQueue(0.25)
        )
        try:
            outputs.append([tuple(served.read(12, 2)) for _ in range(5)])
        finally:
            served.close()
    assert outputs[0] == outputs[1]
    positions = [struct.unpack("<f", struct.pack("<HH", *each))[0] for each in outputs[0]]
    steps = [after - before for before, after in pairwise(positions)]
    assert steps == pytest.approx([250.0] * 4, abs=2.0)


def test_an_address_that_is_taken() -> None:
    first = ModbusServer(RealTimeQueue(), "127.0.0.1", 0)
    first.start()
    try:
        with pytest.raises(OSError, match=r"127\.0\.0\.1"):
            ModbusServer(RealTimeQueue(), "127.0.0.1", first.port).start()
    finally:
        first.stop()


def test_the_command_serves_until_it_is_told_to_end(tmp_path: Path) -> None:
    program = tmp_path / "packer.mnt"
    program.write_text(PACKER)
    command = [sys.executable, "-m", "motionlang", "serve", str(program), "--modbus", "127.0.0.1:0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stderr is not None
        greeting = process.stderr.readline()
        found = re.match(r"listening on 127\.0\.0\.1:(\d+) \(Modbus TCP\)", greeting)
        assert found, greeting
        assert process.stderr.readline().startswith("clients see NETINTEGER and NETFLOAT; MODBUSPARAMETER(")
        with ModbusTcpClient("127.0.0.1", port=int(found[1])) as client:
            assert not client.read_holding_registers(4, count=2).isError()
        os.kill(process.pid, signal.SIGTERM)
        out, err = process.communicate(timeout=60)
    assert (process.returncode, out) == (0, "")
    client_lines = r"Modbus client (127\.0\.0\.1:\d+) connected\nModbus client \1 has left\n"
    assert re.fullmatch(rf"{client_lines}answered 1 request; machine time \d+\.\d{{3}} s\n", err), err


def test_output_that_is_not_read_holds_up_no_one(tmp_path: Path) -> None:
    """Endless output into a pipe that is not read does not delay the clients."""
    program = tmp_path / "chatter.mnt"
    program.write_text('Loop\n  NETINTEGER(1) = NETINTEGER(1) + 1\n  PRINT "{}"\nEnd Loop\n'.format("x" * 99))
    command = [sys.executable, "-m", "motionlang", "serve", str(program), "--modbus", "127.0.0.1:0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stderr is not None
        greeting = process.stderr.readline()
        with ModbusTcpClient("127.0.0.1", port=int(greeting.split()[2].rpartition(":")[2])) as client:
            while True:  # until the pipe and the queue are full
                low, high = client.read_holding_registers(2, count=2).registers
                if (low + (high << 16)) * 100 > 2 * (STORED + 65536):
                    break
        process.send_signal(signal.SIGTERM)
        status = process.wait(MAX_SECONDS)
        _, err = process.communicate()
    assert status == 0
    assert re.search(r"; \d+ lines of standard output dropped\n$", err), err


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--modbus", "5020"], "--modbus needs a Mint program"),
        (["a.mcl", "--modbus", "5020"], "--modbus serves a Mint program; for a file"),
        (["a.mcl", "--modbus", "5020", "--pty"], "--modbus serves a Mint program; for a file"),
        (["a.mnt", "--modbus", "5020", "--log"], "--echo and --log need --tcp or --pty"),
        (["a.mnt", "--tcp", "0", "--unit", "3"], "--unit needs --modbus HOST:PORT"),
        (["a.mnt", "--modbus", "0", "--unit", "248"], "'248' is not a Modbus unit from 1 to 247"),
        (["a.mnt", "--modbus", "here:port"], "'here:port' is not HOST:PORT"),
        (["a.mnt", "--modbus", "0", "--step", "1"], "--step needs --clock lockstep"),
    ],
)
def test_what_does_not_go_together(
    words: list[str], message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["serve", *words])
    assert ended.value.code == 2
    assert message in capsys.readouterr().err


def test_a_program_that_is_wrong(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    program = tmp_path / "wrong.mnt"
    program.write_text("SPED(0) = 1\n")
    assert main(["serve", str(program), "--modbus", "0"]) == 1
    assert "did you mean SPEED?" in capsys.readouterr().err

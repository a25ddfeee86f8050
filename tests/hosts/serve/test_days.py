"""Twelve days of a served machine take little more memory than one day.

Each server runs in lock step in a separate process. `python -m pytest -m long tests/hosts/serve/test_days.py` runs
these tests.
"""

from __future__ import annotations

import os
import re
import signal
import socket
import struct
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from motionlang.client import Client, CommandError

DAY = 86_400
DAYS = 12
# Kilobytes by which twelve days may differ from one, after which fewer records are there than are retained.
MORE = 10_000
# Moves by a client's distance, and counts its moves; in lock step each request takes five seconds.
COUNTER = """\
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Loop
  PAUSE NETINTEGER(1) > 0
  MOVER(0) = NETINTEGER(1) : GO(0)
  NETINTEGER(1) = 0
  PAUSE IDLE(0)
  NETINTEGER(2) = (NETINTEGER(2) + 1) Mod 10000
End Loop
"""
BOARD = ("serve", "--clock", "lockstep", "--tcp", "127.0.0.1:0")
PROGRAM = ("serve", "counter.mnt", "--clock", "lockstep", "--step", "5", "--modbus", "127.0.0.1:0")


def hosts(address: str, days: int) -> None:
    """Run a host that moves an axis every ten seconds, and two other hosts.

    One of them makes errors, one connects repeatedly.
    """
    with Client.open(address) as main, Client.open(address) as other:
        assert main.send("1MN,1SV1000,1SA10000,1DS10000") == []
        for count in range(days * DAY // 10):
            assert main.send("1MR100,1WS,WA9.8,1TP") == [f"01 {100 * (count + 1)}"]
            with pytest.raises(CommandError):
                other.send("1XX")
            if count % 6 == 0:
                with Client.open(address) as guest:
                    guest.send("1TP")


def client(address: str, days: int) -> None:
    """Run a Modbus client that moves the axis every ten seconds and reads the count."""
    host, _, port = address.rpartition(":")
    with socket.create_connection((host, int(port))) as wire:
        for count in range(days * DAY // 10):
            wire.sendall(struct.pack(">HHHBBHH", 1, 0, 6, 1, 6, 2, 50))
            assert wire.recv(12, socket.MSG_WAITALL)[7:] == struct.pack(">BHH", 6, 2, 50)
            wire.sendall(struct.pack(">HHHBBHH", 2, 0, 6, 1, 3, 4, 1))
            assert wire.recv(11, socket.MSG_WAITALL)[7:] == struct.pack(">BBH", 3, 2, (count + 1) % 10_000)


def memory(command: tuple[str, ...], load: Callable[[str, int], None], days: int, folder: Path) -> int:
    """Return the peak memory, kilobytes, of a server under the load of some days.

    They are days of machine time.
    """
    (folder / "counter.mnt").write_text(COUNTER)
    with open(folder / "out.txt", "w+b") as out:
        process = subprocess.Popen(
            [sys.executable, "-m", "motionlang", *command], cwd=folder, stdout=out, stderr=out
        )
        while not (listening := re.search(r"listening on (\S+)", (folder / "out.txt").read_text())):
            assert process.poll() is None
        try:
            load(listening[1], days)
        finally:
            process.send_signal(signal.SIGTERM)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    served = re.search(r"machine time ([\d.]+)", (folder / "out.txt").read_text())
    assert served is not None
    assert float(served[1]) >= 0.999 * days * DAY
    return used.ru_maxrss


@pytest.mark.long
@pytest.mark.skipif(not hasattr(os, "wait4"), reason="POSIX")
@pytest.mark.parametrize(("command", "load"), [(BOARD, hosts), (PROGRAM, client)], ids=["tcp", "modbus"])
def test_days_of_serving_take_no_more_memory_than_a_day(
    command: tuple[str, ...], load: Callable[[str, int], None], tmp_path: Path
) -> None:
    day, days = memory(command, load, 1, tmp_path), memory(command, load, DAYS, tmp_path)
    print(f"{load.__name__}: {day} kB for a day, {days} kB for {DAYS} days")
    assert days <= day + MORE

"""The client of a Mint controller: in process, over TCP and over a serial device."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from motionlang.client import FrameRejected, LineRejected, MintClient, NoReply
from motionlang.hosts.mint.console import MintConsole
from motionlang.hosts.serve import LockStep, Server
from motionlang.kernel import Source

# The host writes a distance to COMMS 1; the position is COMMS 2.
PACKER = """\
SPEED(0) = 1000 : ACCEL(0) = 1e6 : DECEL(0) = 1e6
Loop
  COMMS(2) = POS(0)
  Wait = 5
End Loop
Event COMMS1
  Print "by ", COMMS(1)
  MOVER(0) = COMMS(1) : GO(0)
End Event
"""


@pytest.fixture(params=["virtual", "tcp", "device"])
def line(request: pytest.FixtureRequest) -> Iterator[MintClient]:
    console = MintConsole({"controller.model": "NextMove ESB-2"})
    console.load(Source("packer.mnt", PACKER))
    if request.param == "virtual":
        yield MintClient.virtual(console)
        return
    with Server(console, LockStep(console, 0.01, at_once=True)) as server:
        if request.param == "device":
            pytest.importorskip("pty")
        address = server.listen("127.0.0.1", 0)
        where = server.device() if request.param == "device" else "{}:{}".format(*address)
        with server.in_thread(), MintClient.open(where, timeout=20.0) as client:
            yield client


def output_until(line: MintClient, mark: str) -> str:
    output = ""
    while mark not in output:
        output += line.output(1.0)
    return output


def test_a_program_moves_by_what_a_host_writes(line: MintClient) -> None:
    """At 1000/s and 10 ms per frame, the axis needs 25 frames for a distance of 250."""
    line.write(1, 250)
    frames = 0
    while line.read(2) < 250.0:
        frames += 1
    assert 24 <= frames <= 27
    assert line.output() == "by 250.0000\n"


def test_a_typed_line_after_a_break(line: MintClient) -> None:
    assert line.break_off().startswith("Break at line ")
    assert line.command("Print 6 * 7") == ["42"]
    with pytest.raises(LineRejected, match=r"Print 1 / 0: Error 1001: division by zero"):
        line.command("Print 1 / 0")
    assert line.command("Wait = 50 : Print 1 : Print 2") == ["1", "2"]


def test_a_download(line: MintClient) -> None:
    line.download('Print "new"\n\nInput "n? ", n\nPrint 2 * n\n')
    assert line.command("LIST") == ['Print "new"', "", 'Input "n? ", n', "Print 2 * n"]
    line.start()
    assert output_until(line, "n? ").endswith("new\nn? ")
    line.type("21\r")
    assert "\n42.0000\nP>" in output_until(line, "P>")


def test_what_is_rejected_and_what_has_no_answer(line: MintClient) -> None:
    with pytest.raises(FrameRejected, match="element 0: the controller rejected the frame"):
        line.read(0)
    with pytest.raises(FrameRejected):
        line.write(5, float("inf"))


def test_another_card_does_not_answer() -> None:
    line = MintClient.virtual(PACKER)
    line.card = 3
    with pytest.raises(NoReply, match=r"element 1: no answer within 5 s"):
        line.read(1)


def test_a_program_with_a_virtual_controller_of_its_own() -> None:
    with MintClient.virtual("COMMS(7) = 1.5\nPAUSE COMMS(8) > 0\nPrint COMMS(8)") as line:
        assert line.read(7) == 1.5
        line.write(8, 1e-3)
        assert line.output(1.0) == "0.0010\nP>"

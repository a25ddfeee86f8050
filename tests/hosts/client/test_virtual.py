"""The lines of virtual boards, and the machine time that passes on them."""

from __future__ import annotations

from motionlang.hosts.channel import Wire
from motionlang.hosts.client.virtual import MintWire, VirtualWire
from motionlang.hosts.mccl.console import Console
from motionlang.hosts.mint.console import MintConsole
from motionlang.kernel import Machine, Source


def heard(wire: Wire, timeout: float, digits: int = 3) -> tuple[bytes, float]:
    """Return what a line receives, and the time after it, s."""
    return wire.receive(timeout), round(wire.now(), digits)


def test_a_line_of_a_virtual_board() -> None:
    """A line begins 1 ms after the one before, and takes 10 µs for each command.

    An idle board answers nothing, and no time passes. ESC ends a wait at once.
    """
    console = Console(Machine(first_axis=1))
    wire = VirtualWire(console, 0.001)
    assert (wire.receive(0.0), wire.receive(0.5), wire.now()) == (b">", b"", 0.0)
    wire.send(b"1TP\r")
    assert heard(wire, 0.0) == (b"", 0.0)
    assert heard(wire, 0.5, 5) == (b"01 0\n>", 1e-5)
    wire.send(b"WA1\r")
    assert heard(wire, 0.25) == (b"", 0.251)
    wire.send(b"\x1b")
    assert heard(wire, 0.5) == (b"?-7\n", 0.251)
    assert heard(wire, 0.5) == (b">", 0.251)


def test_a_virtual_board_that_waits_for_its_host() -> None:
    """A blank pauses the line of a host, and a second one resumes it; WA takes 1 s.

    During the pause, time passes while that host reads, but not while another one does. While a line waits for an
    event, time passes for any host.
    """
    console = Console(Machine(first_axis=1))
    wire, other = VirtualWire(console, 0.001), VirtualWire(console, 0.001)
    assert (wire.receive(0.0), other.receive(0.0)) == (b">", b">")
    wire.send(b"1TP,WA1\r ")
    assert heard(wire, 0.25) == (b"", 0.25)
    assert heard(other, 0.25) == (b"", 0.25)
    wire.send(b" ")
    assert heard(wire, 2.0) == (b"01 0\n>", 1.25)
    wire.send(b"WN40\r")
    assert heard(other, 0.5) == (b"", 1.75)


def test_a_line_of_a_virtual_mint_controller() -> None:
    """Each line takes 10 ms, or as long as it waits; time passes while the host reads."""
    wire = MintWire(MintConsole({}), 0.01)
    assert heard(wire, 0.0) == (b"P>", 0.0)
    assert heard(wire, 0.5) == (b"", 0.5)
    wire.send(b"Print 5\r")
    assert heard(wire, 0.0) == (b"", 0.5)
    assert heard(wire, 0.5) == (b"5\r\nP>", 0.51)
    wire.send(b"Print 6\r")
    wire.send(b"Print 7\r")
    assert heard(wire, 0.0) == (b"6\r\nP>", 0.52)
    wire.send(b"Wait = 250 : Print 1\r")
    assert heard(wire, 0.1) == (b"7\r\nP>", 0.53)
    assert heard(wire, 0.1) == (b"", 0.63)
    assert heard(wire, 0.5) == (b"1\r\nP>", 0.78)


def test_the_output_of_a_virtual_program_arrives_within_1_ms() -> None:
    console = MintConsole({})
    console.load(Source("two.mnt", "Wait = 250 : Print 1\nWait = 100 : Print 2"))
    wire = MintWire(console, 0.01)
    assert heard(wire, 1.0) == (b"1\r\n", 0.251)
    assert heard(wire, 1.0) == (b"2\r\nP>", 0.351)

"""How long a client waits, in simulated time and on virtual controllers."""

from __future__ import annotations

import pytest

from motionlang.client import Client, MintClient, NoReply
from motionlang.client.virtual import MintWire, VirtualWire
from motionlang.client.wire import Wire
from motionlang.lang.machine.machine import Machine
from motionlang.mccl.hosts.console import Console
from motionlang.mint.hosts.console import MintConsole
from tests.client.test_slow_boards import VERSION, VERSION_WITHOUT_PROMPT, Pieces, ScriptedWire, noise

SILENCE: Pieces = []


class LateWire(ScriptedWire):
    """A line that may have old data; `sent` has the time of each line."""

    fresh = False

    def __init__(self, *answers: Pieces) -> None:
        super().__init__(*answers)
        self.sent: list[float] = []

    def send(self, data: bytes) -> None:
        self.sent.append(self.now())
        super().send(data)


def test_a_silent_board_is_asked_three_times() -> None:
    """Each attempt has a third of the time-out, 1 s.

    There are 50 ms of silence before it.
    """
    wire = LateWire(SILENCE, SILENCE, SILENCE)
    with pytest.raises(NoReply, match="VE: no answer within 3 s"):
        Client(wire, timeout=3.0)
    assert wire.sent == pytest.approx([0.05, 1.1, 2.15])
    assert wire.now() == pytest.approx(3.2)


def test_a_board_that_answers_the_second_time() -> None:
    wire = LateWire(SILENCE, [(0.25, VERSION)])
    assert Client(wire, timeout=3.0).version == "MultiFlex PCI 1000 series"
    assert wire.now() == pytest.approx(1.1 + 0.25)


def test_the_version_of_a_board_with_a_prompt_needs_no_silence() -> None:
    wire = ScriptedWire([(0.25, VERSION[:9]), (0.25, VERSION[9:])])
    assert Client(wire).version == "MultiFlex PCI 1000 series"
    assert wire.now() == 0.5


@pytest.mark.parametrize("end", [b"\r", b"\n", b"\r\n"])
def test_the_version_of_a_board_without_a_prompt_ends_in_silence(end: bytes) -> None:
    """The silence is 50 ms after the last byte; half a line is not yet a version."""
    wire = ScriptedWire([(0.25, b"?-7" + end + b"DCX"), (0.25, b"-PC100" + end)])
    board = Client(wire)
    assert (board.version, board.prompts) == ("DCX-PC100", False)
    assert wire.now() == pytest.approx(0.55)


def test_an_answer_without_a_prompt_ends_in_silence() -> None:
    """A line of 1 s, an answer in two lines 20 ms apart, and 50 ms of silence."""
    wire = ScriptedWire([(0.0, VERSION_WITHOUT_PROMPT)], [(1.0, b"01 0\r\n"), (0.02, b"02 0\r\n")])
    board = Client(wire)
    begin = wire.now()
    assert board.send("1TP,2TP") == ["01 0", "02 0"]
    assert wire.now() - begin == pytest.approx(1.07)


def test_a_line_may_be_silent_for_its_time_out() -> None:
    """The answer after 3 s is in time for 4 s, but not for 2 s."""
    wire = ScriptedWire([(0.0, VERSION)], [(3.0, b"01 0\n>")], SILENCE, [(0.0, b"?-7\n>")])
    board = Client(wire)
    assert board.send("1TP", timeout=4.0) == ["01 0"]
    with pytest.raises(NoReply, match="1TP: no answer within 2 s"):
        board.send("1TP", timeout=2.0)
    assert wire.now() == pytest.approx(3.0 + 2.0 + 0.05)


@pytest.mark.parametrize(
    ("version", "end"), [(VERSION, b"\n>"), (VERSION_WITHOUT_PROMPT, b"\r\n")], ids=["prompt", "no prompt"]
)
def test_an_escape_waits_for_its_answer(version: bytes, end: bytes) -> None:
    """The answer after 0.5 s, and 50 ms of silence.

    The time-out of the client is 0.9 s.
    """
    wire = ScriptedWire([(0.0, version)], [(0.5, b"?-7" + end)], [(0.0, b"01 0" + end)])
    board = Client(wire, timeout=0.9)
    begin = wire.now()
    board.escape()
    assert wire.now() - begin == pytest.approx(0.55)
    assert board.send("1TP") == ["01 0"]


def test_output_is_drained_for_half_a_second() -> None:
    """A task prints 32 times per second; the 17th line arrives after the half second."""
    wire = ScriptedWire([(0.0, VERSION)], [(0.0, b"?-7\n>"), *[(1 / 32, b"02 0\n")] * 20])
    board = Client(wire)
    board.escape()
    assert (wire.now(), len(wire._pieces)) == (0.5, 4)


def test_blanks_and_tabs_are_part_of_a_line() -> None:
    with Client.virtual() as board:
        assert board.send("1TP, 2TP,\t3TP") == ["01 0", "02 0", "03 0"]
    with MintClient.virtual() as line:
        assert line.command("Print\t6 * 7") == ["42"]
        with pytest.raises(ValueError, match="is not one line"):
            line.command("Print 1\nPrint 2")


def test_the_version_of_every_model() -> None:
    """Line ends differ between the models."""
    for model in ("dcx-pc100", "dcx-at200", "dcx-pci100"):
        with Client.virtual({"controller.model": model}) as board:
            title = board.version.split()[0]
            assert title == model.upper()
            assert board.version.endswith("0")


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


def test_a_mint_controller_that_does_not_answer() -> None:
    """The line has 2 s from its beginning; what arrives in the meantime is output.

    Output that is there before the line is no answer, either.
    """
    wire = ScriptedWire([(0.5, b"x\r\n")], [(0.5, b"P>")], [(0.0, b"a\r\n"), (1.5, b"b\r\n")])
    line = MintClient(wire, timeout=2.0)
    wire.send(b"")
    assert line.output(1.0) == "x\n"
    assert line.command("") == []
    assert wire.now() == 1.0
    with pytest.raises(NoReply, match="Print 5: no answer within 2 s"):
        line.command("Print 5")
    assert wire.now() == 3.0
    assert line.output() == "a\nb\n"


def test_the_noise_of_a_task_before_the_version() -> None:
    """Old output of 0.2 s is discarded before the first question."""
    wire = LateWire([(0.0, VERSION)])
    wire._pieces = noise(0.2)
    assert Client(wire).version == "MultiFlex PCI 1000 series"
    assert wire.sent == pytest.approx([0.25])

"""How long a client waits, in simulated time and on virtual controllers."""

from __future__ import annotations

import pytest

from motionlang.client import Client, ConnectionLost, MintClient, NoReply
from motionlang.hosts.mccl.console import Console
from motionlang.kernel import Machine
from tests.hosts.client.test_slow_boards import VERSION, VERSION_WITHOUT_PROMPT, Pieces, ScriptedWire, noise

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


def test_a_client_begins_with_one_line() -> None:
    """A virtual board has no earlier output to drain: VE takes the 10 µs of a command.

    While another host's line waits for an event, the answer is read after the whole time of an attempt, 1 s.
    """
    console = Console(Machine(first_axis=1))
    with Client.virtual(console, timeout=3.0) as board:
        assert (board.version[:9], round(console.now, 6)) == ("MultiFlex", 1e-5)
        board._wire.send(b"WN40\r")
        begin = console.now
        with Client.virtual(console, timeout=3.0):
            assert console.now - begin == pytest.approx(1.0)


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


def test_a_mint_answer_in_pieces() -> None:
    """The last bytes arrive exactly at the end of the time-out, 2 s.

    The wire returns after 0.5 s at the latest, with or without data.
    """

    class EarlyWire(ScriptedWire):
        def receive(self, timeout: float) -> bytes:
            return super().receive(min(timeout, 0.5))

    wire = EarlyWire([(1.25, b"Print 5\r\n5\r\n"), (0.75, b"6\r\n"), (0.0, b"P>")])
    line = MintClient(wire, timeout=2.0)
    assert line.command("Print 5") == ["5", "6"]
    assert wire.now() == 2.0


def test_stored_output_is_limited() -> None:
    """The limits are 1000 lines, 100,000 characters, and 1,000,000 bytes of an answer.

    The newest output stays: the second of 1001 lines is the oldest one, and the prompt after a line end takes four
    bytes of the answer.
    """
    lines = b"".join(b"%04d\n" % number for number in range(1001))
    board = Client(ScriptedWire([(0.0, VERSION)], [(0.0, b"\n>" + lines)], [(0.0, b"01 0\n>")]))
    board.send("1MN")
    assert board.send("1TP") == ["01 0"]
    assert (board.unasked[0], board.unasked[-1], len(board.unasked)) == ("0001", "1000", 1000)

    text = b"first" + b"x" * 99_995 + b"\x06"
    line = MintClient(ScriptedWire([(0.0, text + b"y")], [(0.0, b"x" * 1_000_000 + b"\r\nP>")]))
    line.write(1, 5.0)
    assert line.output() == "irst" + "x" * 99_995 + "y"
    assert line.command("Print 5") == ["x" * 999_996]


@pytest.mark.parametrize(
    ("sent", "message"),
    [(b"?3\n", "the server accepts no more hosts"), (b"", "gone"), (b"01 0\n", "gone")],
    ids=["an error code", "nothing", "a line"],
)
def test_a_line_that_ends_before_the_version(sent: bytes, message: str) -> None:
    """A server without room sends one error code and disconnects."""

    class EndingWire(ScriptedWire):
        def receive(self, timeout: float) -> bytes:
            if not self._pieces:
                raise ConnectionLost("gone")
            return super().receive(timeout)

    with pytest.raises(ConnectionLost, match=message):
        Client(EndingWire([(0.0, sent)]))


def test_the_version_of_a_board_that_is_never_silent() -> None:
    """A board without a prompt reports 32 times per second.

    The time-out of 3 s allows 1 s for each attempt. The 32nd report arrives at the end of that second. The version is
    the last of the 31 complete lines before it.
    """
    wire = ScriptedWire([(1 / 32, b"%02d\r\n" % number) for number in range(1, 40)])
    assert Client(wire, timeout=3.0).version == "31"
    assert wire.now() == 1.0


def test_the_noise_of_a_task_before_the_version() -> None:
    """Old output of 0.2 s is discarded before the first question."""
    wire = LateWire([(0.0, VERSION)])
    wire._pieces = noise(0.2)
    assert Client(wire).version == "MultiFlex PCI 1000 series"
    assert wire.sent == pytest.approx([0.25])

"""One client, four connections: in process, TCP, serial device, pyserial URL."""

from __future__ import annotations

import re
import socket
import sys
from collections.abc import Callable, Iterator
from contextlib import nullcontext
from types import SimpleNamespace

import pytest

from motionlang.client import AxisFault, Client, ClientError, CommandError, ConnectionLost, NoReply, Status
from motionlang.hosts.channel import SerialWire
from motionlang.hosts.mccl.console import Console
from motionlang.hosts.mccl.port import Port
from motionlang.hosts.serve import Limits, LockStep, RealTime, Server
from motionlang.kernel import Machine

Open = Callable[[], Client]
TRANSPORTS = ("virtual", "tcp", "device", "socket://")


@pytest.fixture
def console() -> Console:
    return Console(Machine({"axis.1.travel": [-100_000.0, 100_000.0]}, first_axis=1))


@pytest.fixture(params=TRANSPORTS)
def open_client(
    request: pytest.FixtureRequest, console: Console, monkeypatch: pytest.MonkeyPatch
) -> Iterator[Open]:
    """Yield a function that connects a client.

    pyserial pauses for 0.3 s after it has closed a `socket://`, in case of a quick reconnection. Here it does not.
    """
    if request.param == "virtual":
        yield lambda: Client.virtual(console)
        return
    if request.param == "socket://":
        library = pytest.importorskip("serial.urlhandler.protocol_socket")
        monkeypatch.setattr(library, "time", SimpleNamespace(sleep=lambda _: None))
    with Server(console, LockStep(console)) as server:
        address = server.listen("127.0.0.1", 0)
        over = {"tcp": "", "socket://": "socket://"}.get(request.param)
        where = device(server) if over is None else over + "{}:{}".format(*address)
        with server.in_thread():
            yield lambda: Client.open(where)


def device(server: Server) -> str:
    pytest.importorskip("pty")
    return server.device()


@pytest.fixture
def board(open_client: Open) -> Iterator[Client]:
    with open_client() as client:
        yield client


def test_the_board_says_who_it_is(board: Client) -> None:
    assert board.version.startswith("MultiFlex PCI 1000 series")
    assert board.prompts


def test_a_move(board: Client) -> None:
    assert board.send("1MN,1SV20000,1MR5000") == []
    assert not board.status(1) & Status.STOPPED
    board.wait_for_stop(1)
    board.wait_for_target(1)
    assert board.position(1) == 5000
    assert board.status(1) & Status.STOPPED


def test_answers(board: Client) -> None:
    assert board.send("1TP,2TP") == ["01 0", "02 0"]
    assert board.ask("TR0") == "0"
    assert board.number("AL2.5,TR0") == 2.5
    with pytest.raises(ClientError, match="2 lines of answer, not one"):
        board.ask("1TP,2TP")
    with pytest.raises(ClientError, match="the answer is no number: MultiFlex"):
        board.number("VE")


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("1XX", "1XX: ?1, unrecognised command"),
        ("1MR10002MR5", "1MR10002MR5: ?2, bad command format"),
        ("1TP," * 100, "?4, command string too long"),
        ("1SV-5", "1SV-5: ?-1, command parameter error"),
        ("1MN,MD1,1MN", "?-4, macro define command not first"),
        ("MC7", "MC7: ?-6, macro does not exist"),
        ("99MN", "?-15, axis not assigned"),
    ],
)
def test_codes_have_a_meaning(board: Client, line: str, message: str) -> None:
    with pytest.raises(CommandError) as error:
        board.send(line)
    assert str(error.value).endswith(message)
    assert board.ask("1TP") == "01 0"


def test_what_was_answered_before_the_code_is_not_lost(board: Client) -> None:
    with pytest.raises(CommandError) as error:
        board.send("1TP,1XX,2TP")
    assert (error.value.code, error.value.answer) == (1, ["01 0"])


@pytest.mark.parametrize("transport", ["virtual", "tcp"])
def test_a_wait_that_takes_too_long_is_abandoned(console: Console, transport: str) -> None:
    """A time-out is in machine seconds in process, and in real time elsewhere."""
    with Server(console, RealTime(console)) as server:
        address = server.listen("127.0.0.1", 0)
        serving = server.in_thread() if transport == "tcp" else nullcontext()
        with serving, Client.tcp(*address) if transport == "tcp" else Client.virtual(console) as board:
            board.send("1MN,1SV1000,1MR90000")
            with pytest.raises(NoReply, match=r"1WS: no answer within 0.1 s"):
                board.wait_for_stop(1, timeout=0.1)
            assert board.ask("TE") == "-7"
            assert not board.status(1) & Status.STOPPED
            assert 0 < board.position(1) < 90000


def test_a_wait_that_nothing_can_end(board: Client) -> None:
    with pytest.raises(NoReply):
        board.send("WN40", timeout=0.1)
    assert board.ask("TE") == "-7"


def test_an_axis_that_runs_into_its_limit(board: Client) -> None:
    """A wait for the axis reports why it has stopped."""
    board.send("1LM2,1LN3,1MN,1MR200000")
    with pytest.raises(AxisFault, match="axis 1: hard plus tripped") as error:
        board.wait_for_stop(1, timeout=60)
    assert error.value.status & Status.MOTOR_ERROR
    assert board.ask("2TP") == "02 0"


def test_the_faults_of_an_axis_have_bits_of_their_own() -> None:
    """Bit 7 is set with each of bits 11, 13, 15, 17, 19 and 21."""
    assert Status(1 << 7).faults == []
    assert Status(0x7FFFFFFF).faults == [
        "following error",
        "amplifier fault",
        "hard plus tripped",
        "hard minus tripped",
        "soft high tripped",
        "soft low tripped",
    ]


def test_a_download(board: Client) -> None:
    """Comments are not sent; an error names its line."""
    assert board.download("; homing\nMD1,1MN,1MR300,1WS,1TP\n\n# by MX\nMC1 ; go\n") == ["01 300"]
    with pytest.raises(CommandError, match=r"line 2: 1QQ: \?1, unrecognised command") as error:
        board.download("1TP\n1QQ\n1TP\n")
    assert error.value.answer == ["01 300"]


def test_output_of_background_tasks_between_lines_is_separate(console: Console) -> None:
    with Client.virtual(console) as board, Client.virtual(console) as other:
        board.send("MD1,WA0.01,2TP")
        board.send("GT1")
        other.send("WA1")
        assert board.ask("1TP") == "01 0"
        assert list(board.unasked) == ["02 0"]


@pytest.mark.parametrize("model", ["multiflex", "dcx-at200"])
def test_a_board_that_never_keeps_silent(model: str) -> None:
    """A background task prints all the time; answers are found between its lines.

    This works in real time, too. How much is printed within an answer and how much before the next line depends on the
    speed of this computer.
    """
    console = Console(Machine({"controller.model": model}, first_axis=1))
    with Server(console, RealTime(console, 20.0)) as server:
        address = server.listen("127.0.0.1", 0)
        with server.in_thread(), Client.tcp(*address) as board:
            board.send("MD1,2TP,WA0.005,RP")
            board.send("GT1")
            lines: set[str] = set()
            for _ in range(100):
                answer = board.send("1TP")
                assert "01 0" in answer
                lines.update(answer)
            with pytest.raises(NoReply):
                board.send("WN40", timeout=0.05)
            assert "01 0" in board.send("1TP")
            while "02 0" not in lines.union(board.unasked):
                lines.update(board.send("1TP"))
            assert lines.union(board.unasked) == {"01 0", "02 0"}


def test_only_one_line_at_a_time(board: Client) -> None:
    for line in ("1TP\r1TP", "1TP\n", "\x1b", "1TP€"):
        with pytest.raises(ValueError, match="is not one line of MCCL"):
            board.send(line)


def test_half_a_line_of_an_earlier_host_is_forgotten(open_client: Open) -> None:
    with open_client() as first:
        first._wire.send(b"1MN,1MR")
    with open_client() as second:
        assert second.ask("1TP") == "01 0"


def test_echo_is_no_answer(open_client: Open, console: Console) -> None:
    with open_client() as board:
        board.send("EN")
        for port in console.ports:
            assert isinstance(port, Port)
            port._echoes = True
        assert board.ask("1TP") == "01 0"
        assert board.send("1SV500") == []


def test_two_clients_at_one_virtual_board(console: Console) -> None:
    with Client.virtual(console) as first, Client.virtual(console) as second:
        first.send("1MN,1MR700,AL3,AR20")
        second.wait_for_stop(1)
        assert (second.position(1), second.number("TR20")) == (700, 3)


def test_a_virtual_board_takes_no_wall_time() -> None:
    with Client.virtual() as board:
        board.send("1SV1,1MN,1MR3600")
        board.wait_for_stop(1, timeout=4000)
        assert board.position(1) == 3600


# ---------------------------------------------------------------------------------------- no peer


def test_no_board_answers() -> None:
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    with pytest.raises(ConnectionLost, match=f"no board at 127.0.0.1:{port}: connection refused"):
        Client.open(f"127.0.0.1:{port}")
    with pytest.raises(ConnectionLost, match="no board at /dev/no-such-device: no such file"):
        Client.open("/dev/no-such-device")
    with pytest.raises(ConnectionLost, match="is not a serial device"):
        Client.serial(__file__)


def test_a_peer_that_does_not_answer() -> None:
    with (
        socket.create_server(("127.0.0.1", 0)) as silent,
        pytest.raises(NoReply, match=r"VE: no answer within 0.1 s"),
    ):
        Client.tcp("127.0.0.1", silent.getsockname()[1], timeout=0.1)


def test_a_server_without_room() -> None:
    console = Console(Machine(first_axis=1))
    with Server(console, LockStep(console), limits=Limits(hosts=1)) as server:
        address = server.listen("127.0.0.1", 0)
        with server.in_thread(), Client.tcp(*address), pytest.raises(ConnectionLost):
            Client.tcp(*address)


def test_a_board_that_goes_away() -> None:
    console = Console(Machine(first_axis=1))
    with Server(console, LockStep(console)) as server:
        address = server.listen("127.0.0.1", 0)
        with server.in_thread():
            client = Client.tcp(*address)
    with pytest.raises(ConnectionLost, match=r"the (board has closed the connection|connection is gone)"):
        client.ask("1TP")
    client.close()


@pytest.mark.parametrize(
    ("settings", "says"),
    [
        ({"axis.1.home_switch": 3000.0}, "axis.1.home_switch must be two numbers"),
        ({"axis.1.homeswitch": [1.0, 2.0]}, "did you mean axis.N.home_switch?"),
        ({"input": [{"channel": "x"}]}, "channel of [[input]] must be a whole number"),
    ],
)
def test_settings_of_a_virtual_board_that_make_no_sense(settings: dict[str, object], says: str) -> None:
    with pytest.raises(ValueError, match=re.escape(says)):
        Client.virtual(settings)


@pytest.fixture
def loop() -> Iterator[SerialWire]:
    """Yield a serial line on which everything that is sent comes back."""
    pytest.importorskip("serial")
    wire = SerialWire("loop://", 115200, 5.0)
    yield wire
    wire.close()


def test_a_serial_line_brings_what_was_sent_however_much_it_is(loop: SerialWire) -> None:
    loop.send(b"1TP\r")
    assert loop.receive(0.0) == b"1TP\r"
    assert loop.receive(0.0) == b""
    sent, came = bytes(range(256)) * 16, b""
    loop.send(sent[:2000])
    loop.send(sent[2000:])
    while len(came) < len(sent):
        came += loop.receive(5.0)
    assert came == sent


def test_a_serial_line_that_is_gone(loop: SerialWire) -> None:
    loop.close()
    for call in (lambda: loop.send(b"1TP\r"), lambda: loop.receive(0.0)):
        with pytest.raises(ConnectionLost, match="the device is gone"):
            call()


def test_a_com_port_is_a_serial_line(monkeypatch: pytest.MonkeyPatch) -> None:
    """The path goes to pyserial; there is no such port here, as the message states."""
    serial = pytest.importorskip("serial")
    requests: list[tuple[str, int]] = []
    real = serial.serial_for_url

    def opened(path: str, baud: int, **how: object) -> object:
        requests.append((path, baud))
        return real("loop://", baud, **how)

    with pytest.raises(ConnectionLost, match="no board at COM7: "):
        Client.open("COM7")
    monkeypatch.setattr(serial, "serial_for_url", opened)
    client = Client.open("COM7", timeout=0.05)
    client.close()
    assert [path for path, _ in requests] == ["COM7"]


def test_without_pyserial_the_message_says_what_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "serial", None)
    with pytest.raises(ConnectionLost, match=re.escape('python -m pip install "motionlang[serial]"')):
        Client.open("COM7")

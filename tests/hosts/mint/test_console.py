"""The serial line of a Mint controller, where a session of `sessions_mint.txt` cannot show it: limits, and inside."""

from __future__ import annotations

import pytest

from motionlang.hosts.mint.console import MintConsole
from motionlang.kernel import ProgramError, Source
from tests.cases import cases
from tests.hosts.mint.lines import Line


def test_the_faults_of_a_typed_program_are_reported() -> None:
    line = Line()
    line.send(b"EDIT\nPrint 1\nMOVER(77) = 1\n\nRUN\n")
    assert [each.code for each in line.complaints] == ["axis"]


def test_a_program_with_errors_is_not_started() -> None:
    with pytest.raises(ProgramError):
        Line("SPED(0) = 1\n")


def test_unread_output_loses_its_oldest_characters() -> None:
    line = Line('Loop\n  Print "{}"\n  Wait = 1\nEnd Loop'.format("y" * 98))
    line.run(2.0)
    unread = line.port.take()
    assert len(unread) == 65536
    assert unread.endswith(b"y" * 98 + b"\r\n")


def test_a_served_controller_forgets_what_is_over() -> None:
    line = Line('Loop\n  MOVER(0) = 1 : GO(0)\n  Pause IDLE(0)\n  Print "."\nEnd Loop')
    for _ in range(101):
        line.run(0.5)
    log = line.console.machine.log
    for stream in (log.moves, log.prints, log.waits):
        assert stream.past > 7000
        assert len(stream) < 0.5 * stream.past


def test_a_line_has_1000_characters_and_65536_wait_behind_it() -> None:
    """A line is being carried out as the others come, so the last ones are lost."""
    line = Line()
    assert line.ask(b"'" + b"x" * 999 + b"\r") == "P>"
    too_long = "Error: the line is longer than 1000 characters\nP>"
    assert line.ask(b"'" + b"x" * 1000 + b"\r") == too_long
    line.port.feed(b"Wait = 10\r" + b"'" * 65535 + b"\rPrint 1")
    line.run(0.1)
    assert line.received() == f"P>{too_long}"
    assert line.ask(b"\r") == "P>"


def test_the_oldest_of_four_million_characters_of_a_typed_line_are_lost() -> None:
    line = Line()
    line.port.take()
    line.port.send("a" + "x" * 3_999_998 + "yz")
    unread = line.port.take()
    assert (len(unread), unread[:1], unread[-2:]) == (4_000_000, b"x", b"yz")


def test_a_text_has_a_million_characters() -> None:
    """Each line has a line end, so 1000 lines of 999 characters fit.

    A line that replaces another needs no more room.
    """
    line = Line()
    line.ask(b"EDIT\n")
    refused = "Error: the program is longer than 1000000 characters\n"
    for number in range(1, 1001):
        assert line.ask(b"'" + b"x" * 998 + b"\n") == f"{number + 1}>"
    assert line.ask(b"\n") == "P>"
    assert line.ask(b"EDIT 1001\n") == "1001>"
    assert line.ask(b"'\n").startswith(refused)
    line.ask(b"\n")
    line.ask(b"EDIT 1000\n")
    assert line.ask(b"'" + b"y" * 998 + b"\n") == "1001>"
    line.ask(b"\nCON\nEDIT\n")
    assert line.ask(b"' the configuration has a million of its own\n") == "2>"


def state(line: Line) -> str:
    """Return the flags of the console, and the time of the next thing to happen."""
    console, port = line.console, line.port
    flags = {
        "busy": console.is_busy,
        "program": console.runs,
        "asking": console.is_asking,
        "working": console.working,
        "serves": console.serves(port),
        "port busy": port.busy,
        "port waits": port.waiting is not None,
    }
    return f"{' '.join(name for name, on in flags.items() if on)} {console.next_time():g}"


def test_the_state_of_the_console_while_a_line_runs() -> None:
    line = Line()
    seen = [state(line)]
    line.port.feed(b"Wait = 100\r")
    seen.append(state(line))
    assert not line.console.settle(0.05)
    assert line.console.now == 0.05
    seen.append(state(line))
    assert line.console.settle()
    line.port.feed(b"Dim a : Input a\r")
    assert line.console.settle()  # a line that waits for its host does not count
    seen.append(state(line))
    line.port.feed(b"1\r")
    seen.append(state(line))
    assert line.console.settle()
    seen.append(state(line))
    assert seen == [
        " inf",
        "busy working serves port busy 0",
        "busy working serves port busy port waits 0.1",
        "busy asking serves port busy inf",
        "busy working serves port busy port waits 0",
        " inf",
    ]


def test_the_state_of_the_console_while_the_program_runs() -> None:
    line = Line("Wait = 100\nPrint 1")
    seen = [state(line)]
    for _ in range(2):
        line.run(0.06)
        seen.append(state(line))
    assert seen == ["busy program 0", "busy program 0.1", " inf"]


def test_of_much_that_is_printed_before_a_host_comes_the_end_waits() -> None:
    """65536 characters are the last 65 lines of 1000, and 536 of the one before.

    They are sent with CR and LF: 66 more.
    """
    line = Line('Loop\n  Print "{}"\n  Wait = 1\nEnd Loop'.format("y" * 999))
    line.console.close(line.port)
    line.run(0.1)
    unread = line.console.open(echo=False).take()
    assert unread == (b"y" * 999 + b"\r\n")[-537:] + (b"y" * 999 + b"\r\n") * 65


def test_a_value_for_a_name_that_the_program_has_not_is_an_error() -> None:
    source = Source("served.mnt", "Dim width = 3\nPrint width")
    with pytest.raises(ProgramError, match="no constant or variable depth"):
        MintConsole(None, {"depth": 4.0}).load(source)
    console = MintConsole(None, {"width": 4.0})
    console.load(source)
    console.run(0.1)
    assert console.open().take().startswith(b"4.0000\r\n")


def test_a_fault_of_the_machine_file_at_a_line() -> None:
    settings = {"fault": [{"axis": 0, "kind": "following-error", "line": 3}]}
    console = MintConsole(settings)
    console.load(Source("served.mnt", "Wait = 100\nPrint AXISERROR(0)\nWait = 100\nPrint AXISERROR(0)"))
    console.run(1.0)
    before, after = console.open().take().split(b"\r\n")[:2]
    assert before == b"0"
    assert after != b"0"


def test_typed_lines_leave_nothing_but_their_names() -> None:
    line = Line()
    line.ask(b"x = 1\r")
    sizes = []
    for _ in range(3):
        for _ in range(20):
            assert line.ask(b"x = x + 1 : Print POS(0), x\r").endswith("P>")
        environment = line.console._interactive.environment
        sizes.append((len(environment.steps), len(environment.places.shared)))
    assert len(set(sizes)) == 1
    assert line.ask(b"Print x\r") == "61.0000\nP>"


@cases(
    "data, entry",
    [
        (b"PRINT 1\rX", (b"PRINT 1\r", True)),
        (b"PRINT 1\nX", (b"PRINT 1\n", True)),
        (b"\nX", (b"\n", True)),
        (b"PRINT", (b"PRINT", False)),
        (b"PR\x05INT\r", (b"PR", False)),
        (b"PR\x0400", (b"PR", False)),
        (b"\x05\x05", (b"\x05", True)),
        (b"\x05A", (b"\x05", True)),
    ],
)
def test_the_first_entry_at_the_prompt_is_a_line_or_ctrl_e(data: bytes, entry: tuple[bytes, bool]) -> None:
    assert Line().port.next_piece(bytearray(data), True) == entry


def test_a_line_feed_after_a_carriage_return_is_no_line() -> None:
    line = Line()
    line.send(b"PRINT 1\r")
    assert [line.port.next_piece(bytearray(data), True) for data in (b"\nX", b"A\nX")] == [
        (b"\n", False),
        (b"A\n", True),
    ]


def test_the_entries_of_a_program_are_keys_unless_it_asks_for_a_line() -> None:
    line = Line('Dim a\nWait = 500\nInput "? ", a')
    assert line.port.next_piece(bytearray(b"12\r"), True) == (b"1", True)
    line.run(1.0)
    assert line.port.next_piece(bytearray(b"12\r"), True) == (b"12\r", True)

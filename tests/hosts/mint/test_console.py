"""The serial line of a Mint controller: program, typed lines, Ctrl-E, download."""

from __future__ import annotations

import pytest

from motionlang.hosts.mint.console import MintConsole
from motionlang.kernel import ProgramError, Source
from tests.cases import cases
from tests.hosts.mint.lines import Line, write_frame

COUNTER = "Dim n As Integer\nLoop\n  n = n + 1\n  Wait = 100\nEnd Loop\n"


def test_print_goes_out_with_cr_and_lf_and_the_prompt_follows_the_end() -> None:
    line = Line('Print "one"\nPrint "two",')
    line.run(0.1)
    assert line.port.take() == b"one\r\ntwo\r\nP>"


def test_a_controller_without_a_model_has_the_one_of_its_program() -> None:
    line = Line("AUTO\nSPEED.0 = 8\n? SPEED.0", model="")
    line.run(0.1)
    assert line.received() == "8\nP>"


def test_ctrl_e_breaks_with_the_line_and_typed_lines_know_the_variables() -> None:
    line = Line(COUNTER)
    line.run(0.45)  # n is 1 at once, and one more after each 0.1 s
    assert line.ask(b"\x05") == "Break at line 4\nP>"
    assert line.ask(b"Print n\r") == "5\nP>"
    assert line.ask(b"n = 7 : Print n\n") == "7\nP>"
    assert line.ask(b"\x05") == "Break\nP>"


def test_motion_continues_after_a_break() -> None:
    line = Line("SPEED(0) = 100 : JOG(0) = 100\nLoop\n  Wait = 10\nEnd Loop")
    line.run(1.0)
    line.ask(b"\x05")
    line.run(1.0)
    assert line.console.machine.controller.axes[0].position(line.console.now) == pytest.approx(200.0, abs=1.0)


def test_handlers_and_tasks_end_with_the_program() -> None:
    line = Line(
        'Event COMMS1\n  Print "event"\nEnd Event\nTIMEREVENT = 5\nEvent TIMER\n  Print "tick"\nEnd Event\n'
    )
    line.run(0.1)
    line.ask(b"\x05")
    line.send(write_frame(1, "3"))
    line.run(1.0)
    assert line.received() == "\x06"


def test_ctrl_e_ends_the_tasks_and_an_input_of_the_program() -> None:
    line = Line(
        'Dim a\nRun Side\nInput a\nEnd\nTask Side\n  Loop\n    Wait = 100\n    Print "x"\n  End Loop\nEnd Task'
    )
    line.run(0.15)
    assert state(line).startswith("busy program asking 0.2000")
    assert line.ask(b"\x05") == "Break at line 3\nP>"
    line.run(1.0)
    assert line.received() == ""
    line.send(b"NEW\nEDIT\nWait = 100\nPrint INKEY\n\nRUN\n")
    line.run(0.05)
    assert state(line).startswith("busy program 1.2")
    line.send(b"A")
    line.run(0.1)
    assert line.received().endswith("65\nP>")


def test_a_task_that_a_typed_line_starts_goes_on_without_it() -> None:
    """Its waits of 100 ms begin when it is started, 0.1 s after power-up."""
    line = Line('Print "p"\nEnd\nTask Side\n  Loop\n    Wait = 100\n    Print "x"\n  End Loop\nEnd Task')
    line.run(0.1)
    assert line.ask(b"Run Side\r") == "P>"
    assert not line.console.is_busy
    line.run(0.25)
    assert line.received() == "x\nx\n"
    assert line.console.next_time() == pytest.approx(0.4, abs=1e-3)
    assert [line.ask(b"Print 1\r"), line.ask(b"\x05")] == ["1\nP>", "Break\nP>"]
    line.run(0.2)
    assert line.received() == "x\nx\n"
    assert line.ask(b"End Side\r") == "P>"
    line.run(0.2)
    assert line.received() == ""


def test_a_typed_line_takes_no_longer_than_it_needs() -> None:
    line = Line()
    assert line.ask(b'JOG(0) = 10 : Wait = 100 : Print "None"\r') == "None\nP>"
    assert line.console.now == pytest.approx(0.1, abs=1e-3)


def test_input_takes_a_line_and_its_text_is_shown_once() -> None:
    line = Line('Dim a\nInput "Speed? ", a\nPrint "is ", a', echo=True)
    line.run(0.1)
    assert line.received() == "Speed? "
    line.send(b"12\x0850\r\n")
    assert line.received() == "12\b \b50"
    line.run(0.1)
    assert line.received() == "\nis 150.0000\nP>"


def test_keys_that_came_before_input_begin_its_line() -> None:
    line = Line('Dim a\nWait = 500\nInput "? ", a\nPrint a')
    line.send(b"42")
    line.run(1.0)
    line.send(b"\r")
    line.run(0.1)
    assert line.received() == "? \n42.0000\nP>"


def test_keys_that_came_before_input_are_of_the_line_of_their_host() -> None:
    """The second of two hosts types; the first one answers the next INPUT."""
    line = Line('Dim a, b\nWait = 500\nInput "? ", a\nInput "? ", b\nPrint a, " ", b')
    other = line.console.open(False)
    other.feed(b"4")
    line.run(1.0)
    other.feed(b"2\r")
    line.run(0.1)
    line.send(b"7\r")
    line.run(0.1)
    assert line.received() == "? \n? \n42.0000 7.0000\nP>"


def test_the_keys_of_a_host_that_has_left_begin_the_line_of_another() -> None:
    line = Line('Dim a\nWait = 500\nInput "? ", a\nPrint a')
    other = line.console.open(False)
    other.feed(b"4")
    line.console.close(other)
    line.run(1.0)
    line.send(b"2\r")
    line.run(0.1)
    assert line.received() == "? \n42.0000\nP>"


def test_inkey_reads_single_keys() -> None:
    line = Line("Dim k As Integer\nLoop\n  k = INKEY\n  If k Then Print k\nEnd Loop")
    line.run(0.1)
    for key in b"aB":
        line.send(bytes([key]))
        line.run(0.1)
    assert line.received() == "97\n66\n"


def test_an_input_of_a_typed_line_asks_its_host() -> None:
    line = Line()
    assert line.ask(b'Dim a : Input "n? ", a : Print 2 * a\r') == "n? "
    assert line.ask(b"21\r") == "\n42.0000\nP>"


def test_characters_typed_ahead_answer_the_input_of_a_typed_line() -> None:
    line = Line()
    assert line.ask(b'Dim a, b : Input "n? ", a : Input "? ", b : Print a + b\r12\r3') == "n? \n? "
    assert line.ask(b"0\rPrint 7\r") == "\n42.0000\nP>7\nP>"


def test_a_download_as_a_host_does_it() -> None:
    """A host sends Ctrl-E, PROG, NEW, EDIT, the lines, an empty line, and RUN.

    An empty line of the program is sent as a blank.
    """
    line = Line(COUNTER)
    line.run(0.1)
    assert "Break" in line.ask(b"\x05")
    steps = [
        (b"PROG\n", "P>"),
        (b"NEW\n", "P>"),
        (b"EDIT\n", "1>"),
        (b'Print "a > b"\n', "2>"),
        (b" \n", "3>"),
    ]
    steps += [(b'Print "end"\n', "4>"), (b"\n", "P>")]
    assert [line.ask(sent) for sent, _ in steps] == [prompt for _, prompt in steps]
    assert line.ask(b"LIST\n") == 'Print "a > b"\n\nPrint "end"\nP>'
    line.send(b"RUN\n")
    line.run(0.1)
    assert line.received() == "a > b\nend\nP>"


def test_the_configuration_runs_before_the_program() -> None:
    line = Line()
    line.send(b"CON\nEDIT\nSCALE(0) = 4000\nDim top = 7\n\nPROG\nEDIT\nPrint SCALE(0), top\n\n")
    assert line.received().endswith("P>")
    line.send(b"RUN\n")
    line.run(0.1)
    assert line.received() == "4000.00007.0000\nP>"


def test_edit_replaces_a_line_or_adds_at_the_end() -> None:
    line = Line()
    line.send(b"EDIT\nPrint 1\nPrint 2\n\nEDIT 2\nPrint 22\n\nEDIT\nPrint 3\n\n")
    assert line.ask(b"LIST\n") == "Print 1\nPrint 22\nPrint 3\nP>"
    assert line.ask(b"EDIT 9\n") == "Error: EDIT takes a line from 1 to 4, not 9\nP>"


def test_run_begins_with_no_names_and_no_handlers_of_the_program_before() -> None:
    before = "Dim count = 5\nEvent COMMS1\n  Print 1\nEnd Event\nLoop\n  Wait = 10\nEnd Loop"
    line = Line(before)
    line.run(0.1)
    line.ask(b"\x05NEW\nEDIT\nDim count = 6\nWait = 50\nPrint count\n\nRUN\n")
    assert line.ask(write_frame(1, "2")) == "\x06"
    line.run(0.1)
    assert line.received() == "6.0000\nP>"
    line.ask(b"NEW\nEDIT\nPrint count\n\n")
    assert line.ask(b"RUN\n").startswith("Error at line 1: count is unknown")


def test_errors_are_one_line_each_and_the_controller_goes_on() -> None:
    line = Line()
    assert line.ask(b"Print 1 / 0\r").startswith("Error 1001: division by zero")
    assert line.ask(b"SPEED(99) = 1\r").startswith("Error 2: there is no axis 99")
    assert line.ask(b"SPED(0) = 1\r").startswith("Error: ")
    line.send(b"EDIT\nPrint 1\nMOVER(77) = 1\n\nRUN\n")
    line.run(0.1)
    assert "Error 2 at line 2: there is no axis 77" in line.received()
    assert [each.code for each in line.complaints] == ["axis"]
    assert line.ask(b"Print 3\r") == "3\nP>"


def test_a_run_time_fault_of_a_program_has_its_line() -> None:
    line = Line("Dim n\nn = 77\nWait = 10\nMOVER(n) = 1")
    line.run(0.1)
    assert line.received().startswith("Error 2 at line 4: there is no axis 77")


def test_a_line_after_one_with_an_error_is_carried_out() -> None:
    line = Line()
    line.received()
    answer = line.ask(b"n = 0 : Wait = 1 : Print 1 / n\rPrint 2\r")
    assert answer == "Error 1001: division by zero (test the divisor before dividing)\nP>2\nP>"


def test_ctrl_e_ends_a_handler() -> None:
    """The break is in the handler, 30 ms after its first start."""
    line = Line("TIMEREVENT = 50\nLoop\n  Wait = 1\nEnd Loop\nEvent TIMER\n  Wait = 60\n  Print 1\nEnd Event")
    line.run(0.08)
    assert line.ask(b"\x05").startswith("Break at line ")
    assert line.console.next_time() == float("inf")
    assert line.ask(b"Wait = 200 : Print 2\r") == "2\nP>"
    line.send(b"RUN\r")
    line.run(0.13)
    assert line.received() == "1\n"


def test_a_program_with_errors_is_not_started() -> None:
    with pytest.raises(ProgramError):
        Line("SPED(0) = 1\n")
    assert Line().ask(b"RUN\r") == "Error: there is no program to run\nP>"


def test_lines_that_are_typed_ahead_wait_and_ctrl_e_drops_them() -> None:
    line = Line()
    line.port.feed(b"Wait = 100 : Print 1\rPrint 2\r")
    line.run(0.2)
    assert line.received() == "P>1\nP>2\nP>"
    line.port.feed(b"Wait = 100 : Print 1\rPrint 2\r")
    line.run(0.05)
    line.port.feed(b"\x05")
    line.run(0.2)
    assert line.received() == "Break\nP>"


def test_a_block_is_typed_in_several_lines() -> None:
    line = Line()
    assert line.ask(b"For k = 1 To 3\r") == ">"
    assert line.ask(b"  Print k\r") == ">"
    assert line.ask(b"Next\r").startswith("1")


def test_several_hosts_share_the_program_and_have_lines_of_their_own() -> None:
    line = Line('Loop\n  Wait = 100\n  Print "x"\nEnd Loop')
    other = line.console.open(echo=False)
    line.run(0.15)
    assert (line.received(), other.take()) == ("x\n", b"x\r\n")
    other.feed(b"\x05")
    assert (line.received(), other.take()) == ("Break at line 2\nP>", b"Break at line 2\r\nP>")
    assert line.ask(b"Print 5\r") == "5\nP>"
    assert other.take() == b""


def test_a_host_that_leaves_ends_its_line_and_not_the_program() -> None:
    line = Line()
    line.port.feed(b"Wait = 100000\r")
    line.console.close(line.port)
    port = line.console.open(echo=False)
    port.feed(b"Print 4\r")
    line.console.settle()
    assert port.take() == b"P>4\r\nP>"


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


def test_a_program_that_a_host_starts_prints_to_all_hosts() -> None:
    """The output of a typed line goes to its host alone."""
    line = Line()
    other = line.console.open(echo=False)
    line.send(b"EDIT\nPrint 1\n\nRUN\n")
    line.run(0.1)
    assert line.received() == "P>1>2>P>1\nP>"
    assert line.ask(b"Print 5\r") == "5\nP>"
    assert other.take() == b"P>1\r\nP>"


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


def test_the_lines_of_the_editor() -> None:
    """EDIT takes lines up to the first free one, as a number of at most 8 digits."""
    line = Line()
    wrong = "Error: EDIT takes a line from 1 to 1, not {}\nP>"
    answers = {
        b"EDIT 0\n": wrong.format(0),
        b"EDIT 2\n": wrong.format(2),
        b"EDIT x\n": wrong.format("X"),
        b"EDIT 000000001\n": wrong.format("000000001"),
        b"EDIT 00000001\n": "1>",
        b"\n": "P>",
        b"LIST\n": "P>",
        b"CON\n": "C>",
    }
    assert {sent: line.ask(sent) for sent in answers} == answers


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


def test_what_is_printed_before_a_host_comes_waits_for_it() -> None:
    line = Line('Print "ready"\nLoop\n  Wait = 10\nEnd Loop')
    line.console.close(line.port)
    line.run(0.1)
    assert [line.console.open(echo=False).take() for _ in range(2)] == [b"ready\r\n", b""]


def test_a_program_starts_as_at_power_up_each_time() -> None:
    """Startup runs, TIME begins at 0, and the tasks of the run before have ended."""
    tasks = 'Task t\n  Wait = 500\n  Print "task"\nEnd Task\nRun t\nWait = 100'
    line = Line(f'Startup\n  Print "start ", TIME\nEnd Startup\n{tasks}')
    line.run(2.0)
    line.send(b"RUN\n")
    line.run(2.0)
    assert line.received() == "start 0\nP>start 0\nP>"


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
    "reading, shown",
    [
        ("POS(0)", "1.3333"),
        ("POS", "1.3333"),
        ("POSDEMAND(0)", "1.3333"),
        ("POS(0) + 0", "1.2500"),
        ("POSTARGET(0)", "1.2500"),
        ("VEL(1)", "10.1000"),
        ("SPEED(1)", "10.1000"),
    ],
)
def test_the_prompt_shows_a_position_in_whole_counts(reading: str, shown: str) -> None:
    """Axis 0 rests at 1.25 uu, or 3.75 counts of 1/3 uu; axis 1 runs at 10.1 uu/s.

    Only a position alone is rounded: to 4 counts, 1.3333 uu.
    """
    line = Line(
        "SCALE(0) = 3\nMOVER(0) = 1.25 : GO(0)\nSCALE(1) = 3\nSPEED(1) = 10.1\nJOG(1) = 10.1\nPAUSE IDLE(0)"
    )
    line.run(3.0)
    assert line.ask(b"Print " + reading.encode() + b"\r") == f"{shown}\nP>"


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

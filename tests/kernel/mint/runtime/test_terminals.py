"""Terminals other than the console: labelled on screen, separate in the report."""

from __future__ import annotations

import json

from motionlang import run
from motionlang.kernel import Source, report
from motionlang.views.report import render


def ran(text: str, **machine: object) -> tuple[str, dict[str, list[str]], list[str]]:
    """Return the screen, the lines of the other terminals by name, and the console."""
    shown: list[str] = []
    result = run(Source("a.mnt", text), machine=machine, show=shown.append)
    assert [each.message for each in result.diagnostics] == []
    return "".join(shown), result.terminals, result.output


def test_whole_lines_of_other_terminals_are_shown_with_their_label() -> None:
    screen, others, console = ran('PRINT "here"\nPRINT #2, "there ";\nPRINT "here again"\nPRINT #2, 5')
    assert screen == "here\nhere again\n[terminal 2] there 5\n"
    assert others == {"terminal 2": ["there 5"]}
    assert console == ["here", "here again"]


def test_a_line_that_the_console_has_begun_is_not_torn_in_the_report() -> None:
    screen, others, console = ran('PRINT "x = ";\nPRINT #4, "there"\nPRINT 1')
    assert screen == "x = \n[terminal 4] there\n1\n"
    assert others == {"terminal 4": ["there"]}
    assert console == ["x = 1"]


def test_a_line_left_open_is_ended_with_the_run() -> None:
    assert ran('TERMINAL = 2\nPRINT "there";')[:2] == ("[terminal 2] there\n", {"terminal 2": ["there"]})


def test_several_terminals_at_once() -> None:
    screen, others, console = ran('TERMINAL = _Term1 | _Term2\nPRINT "all"\nCLS(2)\nPRINT #_Term3, "three"')
    assert screen == "all\n[terminal 2] all\n[terminal 4] three\n[terminal 2] \x1b[2J\x1b[H\n"
    assert others == {"terminal 2": ["all", "\x1b[2J\x1b[H"], "terminal 4": ["three"]}
    assert console == ["all"]


def test_input_asks_on_its_terminal() -> None:
    answers = [{"text": "7", "terminal": 2}, {"text": "9"}]
    text = 'TERMINAL = 2\nINPUT "n? ", n\nTERMINAL = 1\nINPUT "m? ", m\nPRINT n, m'
    screen, others, console = ran(text, answer=answers)
    assert screen == "[terminal 2] n? 7\nm? 9\n7.00009.0000\n"
    assert others == {"terminal 2": ["n? 7"]}
    assert console == ["m? 9", "7.00009.0000"]


def test_handlers_print_on_the_parents_terminal_and_tasks_on_their_own() -> None:
    text = """
Run Other
TIMEREVENT = 10
TERMINAL = 2
WAIT = 15
TIMEREVENT = 0
End
Task Other
  TERMINAL = 4
  PRINT "task"
End Task
Event TIMER
  PRINT "tick"
End Event
"""
    assert ran(text)[1] == {"terminal 2": ["tick"], "terminal 4": ["task"]}


def test_report_has_the_output_of_other_terminals() -> None:
    result = run(Source("a.mnt", 'PRINT #2, "there"\nMODBUSTCP32(4, 6) = 70000\nREMOTEDAC(1, 2, 5) = 2.5'))
    told = json.loads(report.text(result))
    assert told["output"] == []
    assert told["terminals"] == [{"name": "terminal 2", "output": ["there"]}]
    assert told["device_writes"] == [
        {"server": 4, "kind": "register", "number": 6, "value": 4464},
        {"server": 4, "kind": "register", "number": 7, "value": 1},
        {"bus": 1, "node": 2, "kind": "analogue-output", "number": 5, "value": 2.5},
    ]


def test_a_report_of_a_program_that_speaks_to_nobody_is_as_ever() -> None:
    told = run(Source("a.mnt", 'PRINT "here"')).report
    assert "terminals" not in told
    assert "device_writes" not in told


def test_the_table_shows_what_was_written_into_other_devices() -> None:
    text = """
MODBUSTCP16(4, 6) = -1
REMOTEDAC(1, 2, 3) = 12.5
REMOTEOUTX(2, 7, 1) = 1
"""
    table = render(run(Source("a.mnt", text)))
    assert table.splitlines()[2:7] == [
        "written to                          value",
        "─────────────────────────────────────────",
        "Modbus server 4  register 6         65535",
        "node 2 of bus 1  analogue output 3   12.5",
        "node 7 of bus 2  output 1               1",
    ]


def test_very_many_values_are_counted() -> None:
    text = "For i = 1 To 99\n  MODBUSTCP16(4, i) = i\nNext\n"
    table = render(run(Source("a.mnt", text)))
    assert "… and 59 more: --format json has all" in table
    assert "register 41" not in table


def test_a_row_of_an_operator_panel_takes_what_print_takes() -> None:
    text = (
        'Dim n As Integer = 7\nLINE 1, "X "; 12.5 USING 6, 2, " n "; n USING 3\nLINE 2; n\nLINE 3, n USING 4'
    )
    assert ran(text)[0] == "\x1b[1;1HX  12.50 n   7\x1b[2;1H7\x1b[3;1H   7\n"


def test_the_signs_between_printed_values_belong_to_no_other_word() -> None:
    found = run(Source("a.mnt", "Sub Show\nEnd Sub\nShow 1; 2\nMOVER 1 USING 4\nLINE 3 USING 5"))
    assert [(each.line, each.message) for each in found.diagnostics] == [
        (3, "USING and ; belong among the values of PRINT and LINE, not of Show"),
        (4, "USING and ; belong among the values of PRINT and LINE, not of MOVER"),
        (5, "LINE needs the number of a row"),
    ]

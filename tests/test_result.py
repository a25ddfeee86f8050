"""Diagnostics and notes of a run, compared as a whole."""

from __future__ import annotations

import signal

import pytest

from motionlang.kernel import (
    MACHINE_SUFFIX,
    ONE_SHIFT,
    Diagnostic,
    Machine,
    Run,
    Source,
    Terminated,
    dialect,
    dialect_for,
    dialect_of,
    end_of,
    machine_of,
    run,
    who_ended,
)
from tests import proof
from tests.cases import cases

ENDLESS = "the program waits until IN(2), which can never happen"
ENDLESS_POLL = "the program waits for a change of x, which can never happen"
POLL_HINT = "start a move first, or add a machine file with the event that it waits for"
# A program of Mint, and the status of its run, its notes and its diagnostics: code, message, line, column, length,
# hint, severity.
REPORTED: tuple[
    tuple[str, dict[str, object], str, list[str], list[tuple[str, str, int, int, int, str, str]]], ...
] = (
    ("PRINT 1\n", {}, "ended", [], []),
    ("PARAMETERSAVE\n", {}, "ended", ["keywords without effect here: PARAMETERSAVE (line 1)"], []),
    # The last move of each line that was loaded and not started.
    (
        "MOVER(0) = 5 : MOVER(1) = 3 : MOVER(0) = 4\n  MOVER(2) = 5\n", {}, "ended", [],
        [
            (
                "never-started", f"the program ended, but MOVER on axis {axis} was loaded and never started",
                line, column, length, f"GO({axis}) starts the buffered moves", "warning",
            )
            for axis, line, column, length in ((2, 2, 3, 12), (1, 1, 1, 42), (0, 1, 1, 42))
        ],
    ),
    # A path starts with its first axis; other moves wait for motion that does not end.
    (
        "VECTORA(1, 0) = 2, 2 : GO(0)\n", {}, "ended", [],
        [
            (
                "never-started", "the program ended, but VECTORA on axes 1, 0 was loaded and never started",
                1, 1, 28, "GO(1) starts the buffered moves", "warning",
            )
        ],
    ),
    *(
        (
            f"SPEED(0) = 5 : ACCEL(0) = 9 : DECEL(0) = 9 : {motion}\nMOVEA(0) = 9 : GO(0)\n{end}", {}, status, [],
            [
                (
                    "never-started", "the program ended, but MOVEA on axis 0 was loaded and never started",
                    2, 1, 20, hint, "warning",
                )
            ],
        )
        for motion, end, status, hint in (
            ("JOG(0) = 5", "", "until", "it waits for the end of JOG on axis 0"),
            ("MASTERCHANNEL(0) = 1 : FOLLOW(0) = 1 : GO(0)", "", "ended", "it waits for the end of FOLLOW on axis 0"),
            ("MOVER(0) = 5", "SUSPEND(0) = 1\n", "until", "axis 0 is suspended: resume it"),
        )
    ),
    (
        " x = 0\n PRINT 1 / x\n", {}, "fault", [],
        [
            (
                "division-by-zero", "division by zero", 2, 2, 5,
                "test the divisor before dividing", "error",
            )
        ],
    ),
    # An answer that a fault left unused is not reported.
    (
        "PRINT 1 / 0\n", {"answer": [{"text": "3"}]}, "fault", [],
        [
            (
                "division-by-zero", "division by zero", 1, 7, 1,
                "the divisor is 0 whatever the program does", "error",
            )
        ],
    ),
    # No event ends the wait of the other task.
    (
        "Task t\nPAUSE IN(1)\nEnd Task\nRun t\n PAUSE IN(2)\n", {}, "fault",
        [f"line 5: {ENDLESS}", "line 2: t waits until IN(1)"],
        [("never", ENDLESS, 5, 2, 5, "--input 64=1@0.5 ends it, as does [[input]] of the machine file", "error")],
    ),
    (
        "Task t\nPAUSE IN(1)\nEnd Task\nRun t\n PAUSE IN(2)\n", {"run.until": 2.0}, "fault",
        [f"line 5: {ENDLESS}", "line 2: t waits until IN(1)"],
        [("never", ENDLESS, 5, 2, 5, "--input 64=1@0.5 ends it, as does [[input]] of the machine file", "error")],
    ),
    (
        "Task t\nWAIT=100\nEnd Task\nRun t\nWhile IN(1) = 0\nEnd While\n", {"run.until": 2.0}, "fault",
        ["line 5: the program waits for a change of IN(1), which can never happen"],
        [("never", "the program waits for a change of IN(1), which can never happen", 5, 1, 5,
          "--input 32=1@0.6 ends it, as does [[input]] of the machine file", "error")],
    ),
    # Another task can still set the variable; then nothing is left that could.
    (
        "Dim x\nTask t\nWAIT=100\nx = 1\nEnd Task\nRun t\nWhile x < 1\nWAIT=5\nEnd While\n", {}, "ended", [], [],
    ),
    (
        "Dim x\nTask t\nWAIT=100\nx = 1\nEnd Task\nRun t\nWhile x < 2\nWAIT=5\nEnd While\n", {}, "fault",
        [f"line 7: {ENDLESS_POLL}"],
        [("never", ENDLESS_POLL, 7, 1, 5, POLL_HINT, "error")],
    ),
    (
        "  HOME(0) = 1\nPAUSE IDLE(0)\n", {}, "fault", [],
        [
            (
                "never", "axis 0 homes towards a switch that does not exist", 1, 3, 11,
                "give its position in the machine file: axis.0.home_switch, travel and index_every", "error",
            ),
        ],
    ),
    (
        "PRINT 1\n", {"answer": [{"text": "3"}, {"text": "x" * 62}]}, "ended", [],
        [
            (
                "unasked", f'no INPUT took the answer "{text}"', 0, 0, 1,
                "leave it out, or let its prompt be part of the question", "warning",
            )
            for text in ("3", "x" * 60 + "…")
        ],
    ),
)  # fmt: skip


@cases("text, machine, status, notes, diagnostics", REPORTED)
def test_what_a_run_reports(
    text: str,
    machine: dict[str, object],
    status: str,
    notes: list[str],
    diagnostics: list[tuple[str, str, int, int, int, str, str]],
) -> None:
    found = run(Source("a.mnt", text), machine=machine)
    assert (found.status, found.notes) == (status, notes)
    assert [
        (each.code, each.message, each.line, each.column, each.length, each.hint, each.severity)
        for each in found.diagnostics
    ] == diagnostics


INPUT = {"channel": 1, "value": 1, "at": 0.1}
ASK = "Dim n As Integer\nINPUT n\nWAIT = 500\n"
MOVE = "MOVER(0) = 1 : GO(0) : MOVER(11) = 1 : GO(11) : MOVER(2) = 1 : GO(2)\n"
KEY = "PRINT INKEY\n"
HOST = "PRINT COMMS(2), NETINTEGER(4), MODBUSTCP16(1, 6)\n"
# A program, its machine, and what it depends on. A guess counts if the run has used it.
GUESSES: tuple[tuple[str, dict[str, object], str], ...] = (
    ("WAIT = 500\n", {"input": [INPUT]}, ""),
    ("WAIT = 500\n", {"input": [INPUT | {"guess": True}]}, "1 guess of the machine file: input 1"),
    ("WAIT = 50\n", {"input": [INPUT | {"guess": True}]}, ""),
    (
        "WAIT = 500\n",
        {
            "input": [INPUT | {"guess": True, "channel": channel} for channel in (3, 2)],
            "analogue": [INPUT | {"guess": True, "channel": 0}],
        },
        "3 guesses of the machine file: input 2, 3; analogue input 0",
    ),
    (ASK, {"answer": [{"text": "3", "guess": True}]}, "1 guess of the machine file: 1 answer"),
    (f"{ASK}INPUT n\n", {"answer": [{"text": "3", "guess": True}] * 2}, "2 guesses of the machine file: 2 answers"),
    (f"{KEY}WAIT = 500\n", {"key": [{"text": "R", "at": at, "guess": True} for at in (0.5, 0.6)]},
     "1 guess of the machine file: 1 key"),
    (f"{KEY}WAIT = 500\n", {"key": [{"text": "R", "guess": True}] * 2}, "2 guesses of the machine file: 2 keys"),
    ("WAIT = 500\n", {"key": [{"text": "R", "guess": True}]}, ""),
    (f"{KEY}OUTX(1) = 1\n", {"key": [{"text": "R", "output": n, "guess": True} for n in (1, 2)]},
     "1 guess of the machine file: 1 key"),
    (
        f"{HOST}OUTX(1) = 1\nWAIT = 500\n",
        {
            "comms": [{"element": n, "value": 1, "every": 0.1, "guess": True} for n in (10, 2)],
            "netdata": [{"element": 4, "value": 1, "guess": True}, {"element": 5, "value": 1}],
            "modbus.register": [{"server": 1, "register": 6, "value": 1, "output": 1, "delay": 0.1, "guess": True}],
        },
        "4 guesses of the machine file: comms element 2, 10; network data 4; Modbus register 6",
    ),
    (
        MOVE,
        {"controller.axes": 12, **{f"axis.{n}.guess": n > 0 for n in (2, 11, 0, 1)}},
        "2 guesses of the machine file: the switches of axis 2, 11",
    ),
)  # fmt: skip


@cases("text, machine, message", GUESSES)
def test_a_result_names_its_guesses(text: str, machine: dict[str, object], message: str) -> None:
    found = [each for each in run(Source("a.mnt", text), machine=machine).diagnostics if each.code == "guess"]
    assert [each.message for each in found] == ([f"this result depends on {message}"] if message else [])
    assert all(each.severity == "warning" and not each.line for each in found)


@pytest.mark.parametrize(
    ("text", "status", "output", "code"),
    [
        ("Loop\nEnd Loop\n", "fault", [], "language"),
        ("XX1\n", "ended", ["?1"], "unknown-word"),
        ("1TP\n", "ended", ["01 0"], ""),
    ],
)
def test_a_program_of_the_other_language_is_not_run(
    text: str, status: str, output: list[str], code: str
) -> None:
    """A mistake alone does not make it one."""
    found = run(Source("a.mcl", text))
    assert (found.status, found.output) == (status, output)
    assert [each.code for each in found.diagnostics] == [code] * bool(code)


def test_a_run_of_no_time_is_proved() -> None:
    result = proof.run(Source("a.mnt", ""))
    assert (result.time, proof.prove(result).violations) == (0.0, [])


def new_run() -> Run:
    return Run(Source("a.mnt", " PRINT 1\n"), dialect("mint"), Machine({}))


def test_a_run_in_one_line() -> None:
    result = new_run()
    assert repr(result) == "<Run of a.mnt: ended at 0 s, 0 moves>"
    result.diagnostics.append(Diagnostic("range", "too large"))
    assert repr(result) == "<Run of a.mnt: ended at 0 s, 0 moves, 1 diagnostic>"
    moved = run(Source("a.mnt", "MOVER(0) = 1 : GO(0)\n"))
    assert repr(moved).endswith(" s, 1 move>")


def test_an_interrupt_names_its_cause() -> None:
    assert who_ended(Terminated(signal.SIGTERM)) == "by SIGTERM"
    assert who_ended(KeyboardInterrupt()) == "from the keyboard"


def test_an_interrupted_run_ends_at_its_statement() -> None:
    """The first line is shown at 10 µs, while WAIT is yet to come."""

    def stop(text: str) -> None:
        raise KeyboardInterrupt

    found = run(Source("a.mnt", "x = 1\n PRINT x\nWAIT = 500\n"), show=stop)
    (diagnostic,) = found.diagnostics
    assert found.status == "interrupted"
    assert found.time == pytest.approx(1e-5)
    assert (diagnostic.message, diagnostic.line, diagnostic.column) == (
        "the run was ended from the keyboard",
        2,
        2,
    )


def test_a_run_ends_after_a_shift_of_eight_hours() -> None:
    assert (ONE_SHIFT, end_of({}), end_of({"run.until": 3})) == (28_800.0, 28_800.0, 3)


@pytest.mark.parametrize(
    ("file", "name"),
    [("a.mnt", "mint"), ("A.MCL", "mccl"), ("a.txt", None), ("mnt", None), ("a.b.mnt", "mint")],
)
def test_the_extension_chooses_the_language(file: str, name: str | None) -> None:
    found = dialect_of(file)
    assert (found and found.name) == name
    if name is None:
        with pytest.raises(ValueError, match=f"{file}: unknown file extension"):
            dialect_for(Source(file, ""), None)
    assert dialect_for(Source(file, ""), "mccl").name == "mccl"


def test_a_machine_file_is_next_to_its_program(tmp_path: object) -> None:
    program, machine = f"{tmp_path}/a.mnt", f"{tmp_path}/a{MACHINE_SUFFIX}"
    assert machine_of(program) is None
    assert machine_of(program, "other.toml") == "other.toml"
    with open(machine, "w", encoding="utf-8"):
        pass
    assert machine_of(program) == machine
    assert [machine_of(each) for each in ("-", None, Source("a.mnt", ""))] == [None] * 3
    assert machine_of("-", "other.toml") == "other.toml"

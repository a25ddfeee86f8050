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

ENDLESS = "the program waits until IN(2), which can never happen"
ENDLESS_POLL = "the program waits for a change of x, which can never happen"
POLL_HINT = "start a move first, or add a machine file with the event that it waits for"


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

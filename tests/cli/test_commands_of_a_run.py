"""Commands for one purpose: `profile`, `certify`, `plot`, `trace`, …."""

from __future__ import annotations

import pytest

from tests.cli.programs import Cell

MOVE = "SPEED(0) = 100\nMOVER(0) = 200 : GO(0)\nPAUSE IDLE(0)\n"


@pytest.fixture
def pick(cell: Cell) -> Cell:
    cell.write("pick.mnt", MOVE)
    cell.write("pick.machine.toml", "[axis.0.limits]\nspeed = 125\n")
    return cell


@pytest.mark.parametrize("verb", ["profile", "certify"])
def test_a_verb_answers_before_the_report_of_the_run(pick: Cell, verb: str) -> None:
    ran, plain = pick(verb, "pick.mnt"), pick("run", "pick.mnt")
    assert (ran.status, ran.err) == (0, "")
    answer, found, report = ran.out.partition(plain.out)
    assert (bool(answer), found, report) == (True, plain.out, "")


@pytest.mark.parametrize(("verb", "out"), [("trace", "pick.csv"), ("plot", "pick.html")])
def test_a_verb_with_a_file_prints_no_report(pick: Cell, verb: str, out: str) -> None:
    ran = pick(verb, "pick.mnt", out)
    assert (ran.status, ran.out, ran.err) == (0, "", "")
    assert (pick.folder / out).stat().st_size > 1000
    assert pick(verb, "pick.mnt", out, "--format", "text").out == pick("run", "pick.mnt").out


def test_the_page_of_a_program_is_next_to_it(pick: Cell) -> None:
    assert pick("plot", "pick.mnt").err == "note: wrote pick.html\n"
    assert (pick.folder / "pick.html").stat().st_size > 1000


def test_a_verb_takes_the_options_of_run(pick: Cell) -> None:
    """At 100 uu/s and the default rates, the axis is at full speed in the row at 1 s."""
    assert pick("trace", "pick.mnt", "a.csv", "--rate", "1", "--columns", "velocity").status == 0
    assert (pick.folder / "a.csv").read_text().splitlines()[2] == "1.000000000,100.000000"


@pytest.mark.parametrize(("given", "hint"), [("plot", "FILE"), ("trace", "OUT"), ("profile", "FILE")])
def test_what_is_missing_is_named(pick: Cell, given: str, hint: str) -> None:
    ran = pick(given, *(["pick.mnt"] if hint == "OUT" else []))
    assert ran.status == 2
    assert f"motionlang {given}: error: the following arguments are required: " in ran.err
    assert hint in ran.err


@pytest.mark.parametrize(
    ("typed", "suggestion"),
    [("profle", "profile"), ("certfy", "certify"), ("plott", "plot")],
)
def test_a_suggestion_is_a_verb_of_the_same_kind(cell: Cell, typed: str, suggestion: str) -> None:
    assert f"did you mean {suggestion}?" in cell(typed, "pick.mnt").err


def test_an_option_that_is_a_command_of_its_own_is_named(pick: Cell) -> None:
    ran = pick("run", "pick.mnt", "--plot", "a.svg")
    assert (ran.status, ran.err.splitlines()[-1]) == (2, "  hint: motionlang plot is a command of its own")

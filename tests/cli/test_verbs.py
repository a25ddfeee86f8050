"""Commands for one purpose: `profile`, `prove`, `certify`, `plot`, `trace`, …."""

from __future__ import annotations

import pytest

from tests.cli.programs import Cell

MOVE = "SPEED(0) = 100\nMOVER(0) = 200 : GO(0)\nPAUSE IDLE(0)\n"


@pytest.fixture
def pick(cell: Cell) -> Cell:
    cell.write("pick.mnt", MOVE)
    cell.write("pick.machine.toml", "[axis.0.limits]\nspeed = 125\n")
    return cell


@pytest.mark.parametrize("verb", ["profile", "prove", "certify"])
def test_a_verb_is_run_with_its_option(pick: Cell, verb: str) -> None:
    ran, wanted = pick(verb, "pick.mnt"), pick("run", "pick.mnt", f"--{verb}")
    assert (ran.status, ran.out, ran.err) == (wanted.status, wanted.out, wanted.err)
    assert ran.status == 0


@pytest.mark.parametrize(("verb", "out"), [("trace", "pick.csv"), ("plot", "pick.html")])
def test_a_verb_with_a_file_is_run_with_its_option(pick: Cell, verb: str, out: str) -> None:
    assert pick(verb, "pick.mnt", out).status == 0
    written = (pick.folder / out).read_bytes()
    assert pick("run", "pick.mnt", f"--{verb}", "again" + out, "--format", "none").status == 0
    assert (pick.folder / ("again" + out)).read_bytes() == written


def test_a_verb_takes_the_options_of_run(pick: Cell) -> None:
    """At 100 uu/s and the default rates, the axis is at full speed in the row at 1 s."""
    assert pick("trace", "pick.mnt", "a.csv", "--rate", "1", "--columns", "velocity").status == 0
    assert (pick.folder / "a.csv").read_text().splitlines()[2] == "1.000000000,100.000000"


@pytest.mark.parametrize(("given", "hint"), [("plot", "OUT"), ("trace", "OUT"), ("profile", "FILE")])
def test_what_is_missing_is_named(pick: Cell, given: str, hint: str) -> None:
    ran = pick(given, *(["pick.mnt"] if hint == "OUT" else []))
    assert ran.status == 2
    assert f"motionlang {given}: error: the following arguments are required: " in ran.err
    assert hint in ran.err


@pytest.mark.parametrize(
    ("typed", "suggestion"),
    [("profle", "profile"), ("certfy", "certify"), ("proove", "prove"), ("plott", "plot")],
)
def test_a_suggestion_is_a_verb_of_the_same_kind(cell: Cell, typed: str, suggestion: str) -> None:
    assert f"did you mean {suggestion}?" in cell(typed, "pick.mnt").err

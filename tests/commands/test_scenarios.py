"""Scenarios: merged machine files, and expectations of a run."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang.commands.scenarios import Scenario, scenario_files, unmet
from motionlang.kernel import ProgramError, Source, read_machine, run
from motionlang.kernel.lang import layered

STROKE = """\
SPEED(0) = 200 : ACCEL(0) = 2000 : DECEL(0) = 2000
PAUSE INX(1)
MOVEA(0) = 100 : GO(0) : PAUSE IDLE(0)
PRINT "there"
"""
INPUT = "[[input]]\nchannel = 1\nat = 0.5\n"


def test_entries_about_the_same_thing_are_replaced_and_others_stay() -> None:
    below = read_machine(
        Source(
            "m",
            "axis.0.start = 3.0\ninput = [{channel = 1, at = 0.5}, {channel = 1, at = 2.0}, {channel = 2}]",
        )
    )
    above = read_machine(
        Source("s", "axis.0.travel = [0.0, 9.0]\ninput = [{channel = 1, value = 0}]\nkey = [{text = 'x'}]")
    )
    assert layered(below, above) == {
        "axis.0.start": 3.0,
        "axis.0.travel": [0.0, 9.0],
        "input": [{"channel": 2}, {"channel": 1, "value": 0}],
        "key": [{"text": "x"}],
    }
    assert layered(below, {}) == below


# By hand: the part arrives at 0.5 s, the move takes 100/200 + 200/2000 = 0.6 s.
@pytest.mark.parametrize(
    ("entry", "message"),
    [
        ("prints = 'there'", ""),
        ("prints = 'the'\nafter = 1.0\nbefore = 1.2", ""),
        ("prints = 'there'\nbefore = 1.0", "'there' was printed at 1.100"),
        ("prints = 'here!'", "'here!' was not printed; the last line was 'there'"),
        ("never_prints = 'alarm'", ""),
        ("never_prints = 'there'", "'there' was printed at 1.100"),
        ("never_prints = 'there'\nbefore = 1.0", ""),
        ("event = 'stop'", "an event 'stop' did not happen; nothing did"),
        ("never_event = 'limit'\naxis = 0", ""),
        ("axis = 0\nposition = 100", ""),
        ("axis = 0\nposition = 90\nwithin = 5", "axis 0 is at 100.000000 at 1.100040 "),
        ("axis = 0\nposition = 50\nat = 0.8\nwithin = 0.1", ""),
        ("axis = 0\nposition = 50\nat = 8", "axis 0 is expected at 50 at 8 s, and the run ended at 1.100"),
        ("time = 1.1\nwithin = 0.001", ""),
        ("time = 1.2", "the run ended at 1.100"),
        ("status = 'ended'", ""),
        ("status = 'fault'", "the run ended, not fault"),
        ("diagnostic = 'never'", "the run had no error never; it had none"),
    ],
)
def test_an_expectation_is_met_or_reported(entry: str, message: str) -> None:
    settings = read_machine(Source("m", f"{INPUT}[[expect]]\n{entry}\n"))
    result = run(Source("stroke.mnt", STROKE), machine=settings)
    found = unmet(result, settings["expect"])  # type: ignore[arg-type]
    assert [each[: len(message)] for each in found] == ([message] if message else [])


def test_an_event_is_expected_of_an_axis_and_within_times() -> None:
    """At 50 uu/s, reached without a ramp, the switch at 20 is reached at about 0.4 s."""
    text = "LIMITMODE(0) = 4 : SPEED(0) = 50 : ACCEL(0) = 1e6 : DECEL(0) = 1e6\nMOVER(0) = 60 : GO(0) : PAUSE IDLE(0)\n"
    made = run(Source("limit.mnt", text), machine={"axis.0.travel": [-100.0, 20.0]})

    def problems(**entry: object) -> list[str]:
        return [each for each in unmet(made, [entry, {"status": made.status}]) if "event" in each]

    assert problems(event="limit") == problems(event="limit", axis=0, after=0.3, before=0.5) == []
    assert problems(event="limit", before=0.3)[0].startswith("an event 'limit' happened at 0.4")
    assert "did not happen; nothing did" in problems(event="limit", axis=1)[0]
    assert problems(never_event="limit")[0].startswith("an event 'limit' happened at 0.4")


def test_an_unexpected_error_is_reported() -> None:
    result = run(Source("stroke.mnt", STROKE), machine={"controller.axes": 1})
    (found,) = unmet(result, [])
    assert found.startswith("the run had an unexpected error: line 2: ")
    assert found.endswith("[never]")
    assert unmet(result, [{"diagnostic": "never"}]) == []
    assert unmet(result, [{"status": result.status}]) == ([] if result.status == "fault" else [found])


@pytest.mark.parametrize(
    ("entry", "message"),
    [
        ("", r"\[\[expect\]\] expects one thing: prints"),
        ("time = 1\nstatus = 'ended'", "expects one thing"),
        ("position = 3", "needs the axis"),
        ("status = 'done'", "must be one of ended, until, stopped, fault"),
        ("event = 'limits'", "must be one of limit, soft limit"),
        ("prints = 'x'\nwithin = 1", "within of .* has no effect on prints"),
        ("pints = 'x'", "has no key pints"),
        ("time = 1\nwithin = 0", "must be a number above 0"),
    ],
)
def test_what_no_entry_can_say_is_a_mistake_of_the_file(entry: str, message: str) -> None:
    with pytest.raises(ProgramError, match=message):
        read_machine(Source("m", f"[[expect]]\n{entry}\n"))


def test_a_scenario_is_the_program_in_another_world(tmp_path: Path) -> None:
    program = tmp_path / "stroke.mnt"
    program.write_text(STROKE)
    (tmp_path / "stroke.machine.toml").write_text(f"{INPUT}[[expect]]\ntime = 1.1\nwithin = 0.01\n")
    folder = tmp_path / "stroke.scenarios"
    assert scenario_files(str(program)) == []
    folder.mkdir()
    (folder / "late.toml").write_text(
        "[[input]]\nchannel = 1\nat = 4.0\n[[expect]]\ntime = 4.6\nwithin = 0.01\n"
    )
    (path,) = scenario_files(str(program))
    scenario = Scenario(str(program), path)
    result = scenario.run()
    assert scenario.name == "late"
    assert unmet(result, scenario.expected) == []
    assert 4.6 < result.time < 4.61


NAMED = "[[input]]\nchannel = 7\nname = 'Part'\nat = 0.5\n"


def test_an_input_by_its_name() -> None:
    below = read_machine(Source("m", NAMED))
    above = read_machine(Source("s", "[[input]]\nname = 'part'\nat = 3.0\n"), is_layer=True)
    assert layered(below, above)["input"] == [{"channel": 7, "name": "part", "at": 3.0}]
    with pytest.raises(ProgramError, match="needs channel"):  # a machine file is the lowest layer
        read_machine(Source("m", "[[input]]\nname = 'part'\nat = 3.0\n"))


@pytest.mark.parametrize(
    ("below", "hint"),
    [(NAMED, "did you mean Part?"), (INPUT, "write channel = N"), ("", "write channel = N")],
)
def test_a_name_that_the_machine_file_lacks(below: str, hint: str) -> None:
    above = read_machine(Source("s", "[[input]]\nname = 'pert'\nat = 3.0\n"), is_layer=True)
    with pytest.raises(ProgramError, match="no \\[\\[input\\]\\] of the machine file is named pert") as wrong:
        layered(read_machine(Source("m", below)), above)
    assert wrong.value.diagnostics[0].hint == hint


def test_a_scenario_with_a_named_input(tmp_path: Path) -> None:
    """The part arrives at 3 s instead of 0.5 s; the stroke of 100 takes 0.6 s."""
    program = tmp_path / "feed.mnt"
    program.write_text(STROKE.replace("INX(1)", "INX(7)"))
    (tmp_path / "feed.machine.toml").write_text(NAMED)
    late = tmp_path / "late.toml"
    late.write_text("[[input]]\nname = 'Part'\nat = 3.0\n")
    assert Scenario(str(program), str(late)).run().time == pytest.approx(3.6, abs=1e-3)

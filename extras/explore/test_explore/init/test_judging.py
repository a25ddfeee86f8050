"""The run judges the rules of a recording: no cause of its own cause, and no program that is accused without need."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from motionlang.kernel import Source, read_machine, run
from motionlang_explore.identification import Digital, LevelChange, rules_of
from motionlang_explore.identification.positions import Series
from motionlang_explore.init.recorded.levels import levels_of
from motionlang_explore.init.recorded.outcome import clock_of
from motionlang_explore.init.recorded.recording import MeasuredRecording, machine_positions, since
from test_explore.init.recordings import FOLDER, Logger, csv_of, machine_run, world_of
from tests.cli.programs import Cell

Entry = dict[str, object]
SENSOR: Entry = {"channel": 3, "output": 2, "delay": 0.25}
PRESSES: dict[str, list[Entry]] = {
    "regular": [{"channel": 1, "at": 1.0, "for": 0.3, "every": 2.5}],
    "irregular": [
        {"channel": 1, "at": at, "for": 0.3}
        for at in (1.0, 3.1, 6.4, 8.2, 11.9, 14.0, 17.7, 20.3, 22.2, 26.0)
    ],
}


def measured(cell: Cell, program: str, world: dict[str, object], logger: Logger) -> tuple[list[Entry], str]:
    """Return the inputs that init writes from a recording of a program in a world, and what it says."""
    cell.write(program, (FOLDER / program).read_text())
    made = machine_run(Path(cell.folder) / program, world)
    cell.write("rec.csv", csv_of(logger.table(made)))
    ran = cell("init", program, "--recording", "rec.csv", "--format", "none")
    assert ran.status == 0, ran.err
    machine = (cell.folder / program).with_suffix(".machine.toml")
    return read_machine(Source.read(str(machine)))["input"], ran.err  # type: ignore[return-value]


@pytest.mark.parametrize("presses", PRESSES)
@pytest.mark.parametrize(
    ("step", "noise"), [(0.01, 0.0), (0.005, 0.02), pytest.param(0.001, 0.0, marks=pytest.mark.slow)]
)
def test_a_button_does_not_follow_the_valve_that_it_opens(
    cell: Cell, presses: str, step: float, noise: float
) -> None:
    world = {"input": [*PRESSES[presses], SENSOR], "run.until": 28.0}
    logger = Logger(step, jitter=0.5 * bool(noise), noise=noise)
    found, notes = measured(cell, "press.mnt", world, logger)
    sensor = [each for each in found if each["channel"] == 3]
    assert sensor == [{**SENSOR, "delay": pytest.approx(0.25, abs=step)}]
    button = [each for each in found if each["channel"] == 1]
    assert not any("output" in each or "axis" in each for each in button)
    if presses == "regular":
        assert [(each["every"], each["for"]) for each in button] == [
            (pytest.approx(2.5, abs=0.003), pytest.approx(0.3, abs=step))
        ]
    else:
        assert all("guess" in each for each in button)
        assert len(button) == 2 * len(PRESSES[presses])
    assert "changes of outputs not in the run" not in notes


def test_an_output_that_is_on_from_power_up_on_is_a_cause(cell: Cell) -> None:
    found, _ = measured(cell, "foot.mnt", world_of(FOLDER / "foot.mnt"), Logger(0.005))
    (entry,) = found
    assert entry == {
        "channel": 1,
        "output": 4,
        "delay": pytest.approx(1.0, abs=0.005),
        "for": pytest.approx(0.3, abs=0.005),
    }


HOST = """\
SPEED(0) = 400 : ACCEL(0) = 2000 : DECEL(0) = 2000
Loop
  Repeat
    Wait(20)
  Until COMMS(1) = 6
  COMMS(1) = 0
  OUTX(5) = 1
  OUTX(5) = 0
  MOVEA(0) = 120 : GO(0) : Pause IDLE(0)
  OUTX(2) = 1
  Pause INX(3)
  OUTX(2) = 0
  MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
  Print "part"
End Loop
"""


@pytest.mark.slow
def test_a_host_that_is_asked_takes_as_long_each_time(cell: Cell) -> None:
    """Output 5 is on for less than a row, so no row has it: this is no other program."""
    program = cell.write("host.mnt", HOST)
    world = {
        "input": [{**SENSOR, "delay": 0.4}],
        "comms": [{"element": 1, "value": 6.0, "asked": 0.7}],
        "run.until": 30.0,
    }
    cell.write("rec.csv", csv_of(Logger(0.005).table(machine_run(Path(program), world))))
    ran = cell("init", "host.mnt", "--recording", "rec.csv", "--format", "none")
    assert ran.status == 0, ran.err
    found = read_machine(Source.read(str(cell.folder / "host.machine.toml")))
    assert found["comms"] == [
        {"element": 1, "value": 6.0, "asked": pytest.approx(0.7, abs=0.025), "guess": True}
    ]
    assert found["input"] == [{**SENSOR, "delay": pytest.approx(0.4, abs=0.005)}]
    assert "comms element 1: 6 0." in ran.err


def test_marks_are_those_that_were_seen(cell: Cell) -> None:
    """The carriage looked at 180 mm, and saw nothing there."""
    found, _ = measured(cell, "eye.mnt", world_of(FOLDER / "eye.mnt"), Logger(0.005))
    marks = [(each["between"], each["every"], each["times"]) for each in found]
    near = partial(pytest.approx, abs=2.5)
    assert marks == [([near(98), near(102)], near(40), 2), ([near(218), near(222)], near(40), 2)]


@pytest.mark.parametrize(("program", "every"), [("index.mccl", 200.0), ("marks.mccl", 200.0)])
def test_an_index_mark_is_where_the_homing_turned(cell: Cell, program: str, every: float) -> None:
    """The recordings begin with the homing in the first row; one of them has a new zero at the mark."""
    cell.write(program, (FOLDER / program).read_text())
    recording = (FOLDER / program).with_suffix(".csv")
    ran = cell("init", program, "--recording", str(recording), "--format", "none")
    assert ran.status == 0, ran.err
    machine = read_machine(Source.read(str((cell.folder / program).with_suffix(".machine.toml"))))
    assert machine["axis.1.index_every"] == every
    if program == "index.mccl":
        entry: Entry = machine["input"][0]  # type: ignore[index]
        assert (entry["for"], entry["every"]) == (pytest.approx(0.7, abs=0.01), pytest.approx(1.5, abs=0.01))


HOMING = """\
SPEED(0) = 300 : ACCEL(0) = 3000 : DECEL(0) = 3000 : HOMESPEED(0) = 40
WAIT(wait)
HOME(0) = _hmNEGATIVE_SWITCH
PAUSE IDLE(0)
MOVEA(0) = 150 : GO(0) : PAUSE IDLE(0)
"""


@pytest.mark.parametrize(("wait", "switch"), [(1000, -20.0), (10, -41.0)])
def test_a_switch_is_where_the_homing_turned(cell: Cell, wait: int, switch: float) -> None:
    """The homing begins later than power-up, or its switch lies near the guessed one, at -40 uu."""
    program = cell.write("home.mnt", HOMING.replace("wait", str(wait)))
    made = machine_run(Path(program), {"axis.0.home_switch": [switch - 4.0, switch], "run.until": 10.0})
    cell.write("rec.csv", csv_of(Logger(0.005).table(made)))
    ran = cell("init", "home.mnt", "--recording", "rec.csv", "--format", "none")
    assert ran.status == 0, ran.err
    machine = read_machine(Source.read(str(cell.folder / "home.machine.toml")))
    assert machine["axis.0.home_switch"] == pytest.approx([switch - 4.0, switch], abs=0.3)
    assert machine["axis.0.guess"] is True  # it was seen once


WAIT_FOR = """\
OUTX(0) = 1
waitFor(4)
Print "gripped"
MOVEA(0) = 10 : GO(0) : Pause IDLE(0)
OUTX(0) = 0
End
Sub waitFor(ByVal ch As Integer)
  Pause INX(ch)
End Sub
"""


def test_an_input_that_is_read_by_a_computed_channel_is_written(cell: Cell) -> None:
    cell.write("panel.mnt", WAIT_FOR)
    rows = [f"{k / 100},{int(k >= 70)},{int(20 <= k < 90)}" for k in range(200)]
    cell.write("rec.csv", "\n".join(["time_s,in4,out0", *rows, ""]))
    ran = cell("init", "panel.mnt", "--recording", "rec.csv", "--format", "none")
    assert ran.status == 0, ran.err
    found = read_machine(Source.read(str(cell.folder / "panel.machine.toml")))["input"]
    assert [each["channel"] for each in found] == [4]  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ("columns", "note"),
    [
        ("in5", "input 5 is recorded, and the program never reads it: left out"),
        ("in5,in6", "inputs 5 and 6 are recorded, and the program never reads them: left out"),
    ],
)
def test_inputs_that_the_program_never_reads_are_left_out(cell: Cell, columns: str, note: str) -> None:
    cell.write("grip.mnt", "OUTX(0) = 1\nPause INX(4)\nOUTX(0) = 0\n")
    more = ",0" * len(columns.split(","))
    rows = [f"{k / 100},{int(k >= 70)},{int(20 <= k < 70)}{more}" for k in range(200)]
    cell.write("rec.csv", "\n".join([f"time_s,in4,out0,{columns}", *rows, ""]))
    ran = cell("init", "grip.mnt", "--recording", "rec.csv", "--format", "none")
    assert f"note: {note}\n" in ran.err


@pytest.mark.parametrize(("changes", "is_named"), [(3, False), (4, True)])
def test_an_input_without_a_pulse_is_named_if_the_run_lacks_more_than_three_changes(
    cell: Cell, changes: int, is_named: bool
) -> None:
    """Up to three may be in the same row, in another order. The pulse of the input was between two rows."""
    text = "Wait(500)\nOUTX(1) = 1\nPause INX(3)\n" + "Wait(500)\nOUTX(1) = 1 - OUTX(1)\n" * changes
    cell.write("press.mnt", text)
    rows = [f"{k / 100},0,{min(k // 50, changes + 1) % 2}" for k in range(400)]
    cell.write("rec.csv", "\n".join(["time_s,in3,out1", *rows, ""]))
    ran = cell("init", "press.mnt", "--recording", "rec.csv", "--format", "none")
    assert ("input 3 is off in all of the recording, and the program waits for it" in ran.err) is is_named


def test_what_has_no_column_is_named_before_the_program_is_accused(cell: Cell) -> None:
    text = "Pause (NETINTEGER(10) * 7919 + NETINTEGER(11) * 31) % 10007 = 4242\n"
    cell.write(
        "net.mnt", text + "Loop\n  OUTX(1) = 1\n  Pause INX(2)\n  OUTX(1) = 0\n  Pause INX(2) = 0\nEnd Loop\n"
    )
    rows = [f"{k / 100},{int(k % 100 in range(30, 80))},{int(k % 100 in range(10, 60))}" for k in range(1000)]
    cell.write("rec.csv", "\n".join(["time_s,in2,out1", *rows, ""]))
    ran = cell("init", "net.mnt", "--recording", "rec.csv", "--format", "none")
    assert "is not one of" not in ran.err
    assert "note: nothing recorded shows when the machine was switched on" in ran.err
    assert "no column has network data 10, network data 11, which net.mnt reads" in ran.err


@pytest.mark.parametrize(
    ("delays", "is_guess"), [([0.25] * 6, False), ([0.21, 0.21, 0.29, 0.29, 0.25, 0.25], True)]
)
def test_a_time_that_varies_much_is_a_guess(delays: list[float], is_guess: bool) -> None:
    """Each figure has the interval in which it lies."""
    causes = tuple(LevelChange(2.0 * k + 1.0 + k % 2, 1 - k % 2, 0.0005) for k in range(6))
    changes = tuple(
        LevelChange(each.time + delay, each.level, 0.0005) for each, delay in zip(causes, delays, strict=True)
    )
    recording = MeasuredRecording(
        0.0,
        12.0,
        0.001,
        inputs={3: Digital("in3", 0, changes, 0)},
        outputs={1: Digital("out1", 0, causes, 0)},
    )
    rule = rules_of(3, recording.inputs[3], recording)[0]
    assert rule.entries == ({"channel": 3, "output": 1, "delay": 0.25},)
    assert rule.comments == (f"0.250 s ± 0.0{'40' if is_guess else '01'} (6 changes)",)
    assert rule.is_guess == is_guess


def test_an_input_may_follow_two_outputs_equally_well() -> None:
    causes = tuple(LevelChange(2.0 * k + 1.0 + k % 2, 1 - k % 2, 0.0005) for k in range(6))
    changes = tuple(each._replace(time=each.time + 0.25) for each in causes)
    outputs = {number: Digital("", 0, causes) for number in (1, 2)}
    recording = MeasuredRecording(0.0, 12.0, 0.001, outputs=outputs)
    first, *_ = rules_of(3, Digital("in3", 0, changes), recording)
    assert (first.subject, first.others[0]) == ("output 1", "output 2")


def test_what_comes_before_the_changes_of_an_output_does_not_follow_it() -> None:
    causes = tuple(LevelChange(t, 1 - k % 2, 0.0005) for k, t in enumerate((1.0, 2.3, 5.0, 5.9, 9.0, 10.4)))
    changes = tuple(each._replace(time=each.time - 0.0015) for each in causes)
    recording = MeasuredRecording(0.0, 12.0, 0.001, outputs={1: Digital("", 0, causes)})
    assert not [
        each for each in rules_of(3, Digital("in3", 0, changes), recording) if each.subject == "output 1"
    ]


def test_a_position_is_known_to_the_distance_between_two_rows() -> None:
    """To and fro at 100 uu/s, with a row each 10 ms; the input is on from 40.5 uu on."""
    times = np.arange(0.0, 8.0, 0.01)
    values = 100.0 * np.abs((times + 1.0) % 2.0 - 1.0)
    levels = (values >= 40.5).astype(int)
    rows = np.flatnonzero(np.diff(levels)) + 1
    changes = tuple(LevelChange(float(times[k]), int(levels[k]), 0.005) for k in rows)
    recording = MeasuredRecording(0.0, 8.0, 0.01, positions={0: Series("", times, values)})
    first, *_ = rules_of(3, Digital("in3", 0, changes), recording)
    assert first.subject == "axis 0"
    assert first.comments == ("40.500 uu ± 1.000 (8 changes)",)


def test_an_input_that_a_position_changes_in_one_direction_alone_does_not_follow_it() -> None:
    """To and fro at 100 uu/s: the input is on from 40 to 60 uu, and off there on the way back."""
    times = np.arange(0.0, 16.0, 0.01)
    values = 100.0 * np.abs((times + 1.0) % 2.0 - 1.0)
    levels = ((values >= 40.0) & (values <= 60.0) & (times % 2.0 < 1.0)).astype(int)
    rows = np.flatnonzero(np.diff(levels)) + 1
    changes = tuple(LevelChange(float(times[k]), int(levels[k]), 0.005) for k in rows)
    recording = MeasuredRecording(0.0, 16.0, 0.01, positions={0: Series("", times, values)})
    found = rules_of(3, Digital("in3", 0, changes), recording)
    assert "axis 0" not in [each.subject for each in found]


def test_an_input_may_be_on_to_either_side_of_a_region() -> None:
    """To and fro at 100 uu/s, with a row each 10 ms; the input is off from 40 to 60 uu."""
    times = np.arange(0.0, 16.0, 0.01)
    values = 100.0 * np.abs((times + 1.0) % 2.0 - 1.0)
    levels = ((values < 40.0) | (values > 60.0)).astype(int)
    rows = np.flatnonzero(np.diff(levels)) + 1
    changes = tuple(LevelChange(float(times[k]), int(levels[k]), 0.005) for k in rows)
    recording = MeasuredRecording(0.0, 16.0, 0.01, positions={0: Series("", times, values)})
    first, *_ = rules_of(3, Digital("in3", 1, changes), recording)
    near = partial(pytest.approx, abs=1.0)
    assert first.entries == (
        {"channel": 3, "axis": 0, "below": near(40.0)},
        {"channel": 3, "axis": 0, "above": near(60.0)},
    )


def test_a_new_zero_in_motion_is_no_step() -> None:
    """At 1 uu per row, the third row has the zero."""
    series = Series("", np.arange(8.0), np.array([50.0, 51.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0]))
    assert machine_positions(series).values.tolist() == [50.0 + k for k in range(8)]


def test_a_level_with_noise_has_the_steps_that_are_larger() -> None:
    """Noise of 3 %, and a step to 90 %, which the program may see in the row in which it comes."""
    times = np.arange(0.0, 2.0, 0.01)
    values = np.where(times < 0.995, 50.0, 90.0) + np.random.default_rng(1).normal(0.0, 3.0, len(times))
    near = partial(pytest.approx, abs=1.0)
    assert Series("", times, values).noise(1.0) == near(3.0)
    assert levels_of(4, Series("", times, values)) == [
        ({"channel": 4, "value": near(50.0), "at": 0.0}, "in steps"),
        ({"channel": 4, "value": near(90.0), "at": 0.99}, ""),
    ]


def test_the_first_row_may_be_a_level_of_its_own() -> None:
    series = Series("", np.arange(4.0), np.array([10.0, 50.0, 50.4, 50.2]))
    assert [entry["value"] for entry, _ in levels_of(4, series)] == [10.0, 50.2]


def test_a_change_just_at_the_beginning_is_the_first_level() -> None:
    """The input is on from the first row on, as in a recording that begins there."""
    inputs = {3: Digital("in3", 0, (LevelChange(2.0, 1), LevelChange(5.0, 0)))}
    later = since(MeasuredRecording(0.0, 12.0, inputs=inputs), 2.0)
    assert later.inputs[3] == Digital("in3", 1, (LevelChange(3.0, 0),))


def test_the_times_of_a_fast_clock_are_divided_by_its_rate() -> None:
    """The clock of the recording counts 2 s a second."""
    later = since(MeasuredRecording(3.0, 13.0, 0.2), 1.0, 2.0)
    assert (later.begin, later.end, later.step) == (1.0, 6.0, 0.1)


def test_a_wait_that_an_output_ends_does_not_hide_how_long_it_is_on() -> None:
    """Task 5 ends as it switches the output on, and in that instant ends the wait for the input that follows it.

    The output is on for 0.5 s, and the recording counts 0.3 % more; while it is off the program waits for the input.
    """
    text = "MD5,WA0.2,CN34\nMD6,WA0.7,CF34\nGT5,GT6,WN3,WA1,RP9\n"
    made = run(Source("a.mccl", text), machine={"input": [{"channel": 3, "output": 34, "delay": 0.0}]})
    changes = tuple(LevelChange(1.003 * each.time, int(each.value)) for each in made.machine.log.outputs)
    recording = MeasuredRecording(0.0, 12.0, 0.001, outputs={34: Digital("out34", 0, changes)})
    assert clock_of(made, recording) == pytest.approx(1.003)


def test_a_condition_that_reads_an_input_says_nothing_of_the_clock() -> None:
    """The input comes by itself, 0.5 s after the output goes on; the rest takes 0.3 % longer in the recording."""
    text = "Loop\n  OUTX(1) = 1\n  Pause INX(3)\n  OUTX(1) = 0\n  Wait(700)\nEnd Loop\n"
    entries = [{"channel": 3, "output": 1, "delay": 0.5}]
    made = run(Source("a.mnt", text), machine={"input": entries}, until=15.0)
    changes, time, before = [], 0.0, 0.0
    for each in made.machine.log.outputs:
        time += (each.time - before) * (1.003 if each.value else 1.0)
        before = each.time
        changes.append(LevelChange(time, int(each.value)))
    recording = MeasuredRecording(0.0, 15.1, 0.001, outputs={1: Digital("out1", 0, tuple(changes))})
    assert clock_of(made, recording) == pytest.approx(1.003, abs=1e-5)


FEED = """\
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Loop
  OUTX(1) = 1
  PAUSE INX(1)
  OUTX(1) = 0
  MOVER(0) = 30 : GO(0) : PAUSE IDLE(0)
  OUTX(2) = 1
  PAUSE INX(1) = 0
  OUTX(2) = 0
  MOVER(0) = -30 : GO(0) : PAUSE IDLE(0)
End Loop
"""


LAMP = """\
Task Lamp
  Loop
    OUTX(7) = 1
    WAIT(330)
    OUTX(7) = 0
    WAIT(330)
  End Loop
End Task
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Run Lamp
Loop
  MOVER(0) = 30 : GO(0) : PAUSE IDLE(0)
  OUTX(1) = 1
  WAIT(dwell)
  OUTX(1) = 0
  PAUSE INX(3)
  PAUSE INX(3) = 0
End Loop
"""


def test_the_cycle_is_that_of_the_outputs_that_work_switches(cell: Cell) -> None:
    """The dwell of the machine is 50 ms longer; a lamp that blinks on its own has no place in the order."""
    cell.write("lamp.mnt", LAMP.replace("dwell", "250"))
    other = cell.write("other.mnt", LAMP.replace("dwell", "300"))
    world = {"input": [{"channel": 3, "output": 1, "level": 0, "delay": 0.4, "for": 0.2}], "run.until": 20.0}
    cell.write("rec.csv", csv_of(Logger(0.005).table(machine_run(Path(other), world))))
    ran = cell("init", "lamp.mnt", "--recording", "rec.csv", "--format", "none")
    note = (
        "note: cycle 1.3 s recorded, 1.25 s run (15 cycles): 50 ms longer from output 1 on to output 1 off\n"
    )
    assert note in ran.err


def test_a_recording_that_begins_within_a_cycle(cell: Cell) -> None:
    """Input 1 is on in the first row, and the output that it switches off in the same row is no cause of it."""
    program = cell.write("feed.mnt", FEED)
    world = {"input": [{"channel": 1, "output": 1, "delay": 0.35, "for": 1.2}], "run.until": 20.0}
    late = Logger(0.02, before=-7.3).table(machine_run(Path(program), world))
    cell.write("rec.csv", csv_of(late))
    ran = cell("init", "feed.mnt", "--recording", "rec.csv", "--format", "none")
    assert ran.status == 0, ran.err
    assert "begins while the machine runs, since output 2 is on" in ran.err
    found: list[Entry] = read_machine(Source.read(str(cell.folder / "feed.machine.toml")))["input"]  # type: ignore[assignment]
    on, off = found
    assert (on["output"], on["level"], on["delay"]) == (1, 1, pytest.approx(0.35, abs=0.02))
    assert (off["output"], off["level"], off["delay"]) == (1, 0, pytest.approx(1.2, abs=0.02))


def test_a_gap_does_not_lose_a_rule(cell: Cell) -> None:
    """Three of twenty cycles are not in the recording; input and output have as many changes there."""
    program = cell.write("feed.mnt", FEED)
    world = {"input": [{"channel": 1, "output": 1, "delay": 0.35, "for": 1.2}], "run.until": 40.0}
    table = Logger(0.01).table(machine_run(Path(program), world))
    times = table["time_s"] - 100.0
    kept = (times < 17.0) | (times > 23.0)
    cell.write("rec.csv", csv_of({name: values[kept] for name, values in table.items()}))
    ran = cell("init", "feed.mnt", "--recording", "rec.csv", "--format", "none")
    assert ran.status == 0, ran.err
    found: list[Entry] = read_machine(Source.read(str(cell.folder / "feed.machine.toml")))["input"]  # type: ignore[assignment]
    assert all("output" in each and "guess" not in each for each in found)


def test_what_was_before_a_recording_is_a_guess() -> None:
    """A level that never changes, if the machine ran before; and a clock, if nothing shows power-up."""
    known = MeasuredRecording(0.0, 20.0, 0.01)
    constant = Digital("in1", 1, (), 0)
    times = [each for k in range(5) for each in (1.0 + 3.0 * k, 1.5 + 3.0 * k)]
    clock = Digital("in2", 0, tuple(LevelChange(at, 1 - k % 2, 0.005) for k, at in enumerate(times)), 0)
    late, unplaced = replace(known, is_late=True, is_placed=False), replace(known, is_placed=False)
    assert [rules_of(1, constant, each)[0].is_guess for each in (known, unplaced, late)] == [
        False,
        False,
        True,
    ]
    assert [rules_of(2, clock, each)[0].is_guess for each in (known, unplaced, late)] == [False, True, True]


DIAL = """MD1,1US100,1MN,1SV40,1SA1000,1DS1000,1VM,1DI1,1GO,1FE0,1ST,1WS.1,1PM,1SV100,1MA0,1WS.05,MJ2
MD2,IN2,MJ3,NO,WA.02,MJ2
MD3,CN9,WN3,1MR20,1WS.05,CF9,WF3,MJ2
MC1
"""


@pytest.mark.slow
def test_the_switch_of_an_axis_is_no_input_of_an_operator(cell: Cell) -> None:
    """Its column is left out, and the homing measured: what an axis reads is no question of the exploration."""
    cell.write("dial.mccl", DIAL)
    world: dict[str, object] = {
        "input": [{"channel": 2, "at": 3.0}, {"channel": 3, "output": 9, "delay": 0.25}],
        "axis.1.home_switch": [-40.0, -12.0],
        "controller.model": "dcx-pci300",
        "run.until": 20.0,
    }
    table = Logger(0.005).table(machine_run(cell.folder / "dial.mccl", world))
    way = table["axis1_position_uu"].copy()
    way[table["time_s"] > 102.0] = 0.0  # the homing alone
    table["in17"] = (way <= -11.0).astype(float)
    cell.write("rec.csv", csv_of(table))
    ran = cell("init", "dial.mccl", "--recording", "rec.csv", "--format", "none")
    assert "note: input 17 is recorded, and the program never reads it: left out\n" in ran.err
    machine = read_machine(Source.read(str(cell.folder / "dial.machine.toml")))
    assert {each["channel"] for each in machine["input"]} == {2, 3}  # type: ignore[attr-defined]
    assert machine["axis.1.home_switch"][1] == pytest.approx(-12.0, abs=0.1)  # type: ignore[index]


def test_what_is_switched_before_is_no_power_up(cell: Cell) -> None:
    """The recording begins at rest; the axis moves as at power-up, but an output is on before."""
    cell.write(
        "shuttle.mccl",
        """MD1,1US100,1MN,1SV100,1SA1000,1DS1000,1MR20,1WS.05,1MR-20,1WS.05,MJ2
MD2,IN2,MJ3,NO,WA.02,MJ2
MD3,CN9,WN3,1MR20,1WS.05,1MR-20,1WS.05,CF9,WF3,MJ2
MC1
""",
    )
    world: dict[str, object] = {
        "input": [
            {"channel": 2, "at": 3.0, "for": 0.3, "every": 4.0},
            {"channel": 3, "output": 9, "delay": 0.8},
        ],
        "controller.model": "dcx-pci300",
        "run.until": 40.0,
    }
    result = machine_run(cell.folder / "shuttle.mccl", world)
    cell.write("rec.csv", csv_of(Logger(0.005, before=-6.0).table(result)))
    ran = cell("init", "shuttle.mccl", "--recording", "rec.csv", "--format", "none")
    assert "begins while the machine runs, since output 9 is switched before the program does what" in ran.err
    machine = read_machine(Source.read(str(cell.folder / "shuttle.machine.toml")))
    (sensor,) = [each for each in machine["input"] if each["channel"] == 3]  # type: ignore[attr-defined]
    assert sensor == {"channel": 3, "output": 9, "delay": pytest.approx(0.8, abs=0.005)}

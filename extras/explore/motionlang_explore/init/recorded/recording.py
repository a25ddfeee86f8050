"""The recording of a machine: changes of inputs and outputs, levels of analogue inputs, positions of axes.

A sampled channel has changed between two rows, so a change has the middle of both as its time, and half of the distance
as its uncertainty. A contact bounces: several changes within `BOUNCE` are one change, at the first of them. Positions
are those of the machine: a new zero that the program gives an axis at rest is a step of the recorded position, and is
taken out.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from motionlang.commands.recording import (
    CHANNELS,
    GAP,
    Mapped,
    RecordedSignal,
    RecordedTable,
    Recording,
    read_recording,
)
from motionlang.kernel import Diagnostic, ProgramError
from motionlang.kernel.tools import count_of
from motionlang_explore.identification import Digital, LevelChange, Observation
from motionlang_explore.identification.positions import LEAST, Series

# Changes of a contact within this time, s, are one change.
BOUNCE = 0.02
# A channel is digital if at most this share of its values lies between its two levels.
BETWEEN = 0.05
# Levels that differ by less are one level and its noise.
LEVELS = 0.5
# A step of a position is a new zero if it is so many times as large as the steps around it.
STEP = 8.0
# A pulse of fewer rows may have been missed elsewhere.
SHORT_ROWS = 2.5


@dataclass(frozen=True)
class MeasuredRecording(Observation):
    """The recorded channels and axes of a machine, by number."""

    name: str = ""
    inputs: dict[int, Digital] = field(default_factory=dict)
    analogue: dict[int, Series] = field(default_factory=dict)
    positions: dict[int, Series] = field(default_factory=dict)
    sentence: str = ""
    remarks: tuple[Diagnostic, ...] = ()


def measured_recording(table: RecordedTable, mapping: Sequence[Mapped]) -> MeasuredRecording:
    """Return what a recording has of a machine; raise ProgramError if that is nothing."""
    recording = read_recording(table, mapping, CHANNELS, checked=_kind)
    if not recording.signals:
        raise ProgramError.of(
            "recording",
            f"no column of {table.name} is an input, an output or a position",
            hint=f"--map input.3=NAME --map output.1=NAME; its columns are {', '.join(table.columns)}",
        )
    found = MeasuredRecording(
        float(recording.times[0]),
        float(recording.times[-1]),
        recording.step,
        name=recording.name,
        sentence=recording.sentence,
        gaps=recording.gaps,
        remarks=recording.remarks,
    )
    for target, each in recording.signals.items():
        kind, number = _kind(target)
        if kind in ("input", "output"):
            channel = _digital(each, recording)
            (found.inputs if kind == "input" else found.outputs)[number] = channel
        elif kind == "analogue":
            found.analogue[number] = Series(each.column, each.times, each.scaled)
        elif not recording.events:  # positions in rows of events are points, not a track
            found.positions[number] = machine_positions(Series(each.column, each.times, each.scaled))
    return found


def since(recording: MeasuredRecording, zero: float, clock: float = 1.0) -> MeasuredRecording:
    """Return what was recorded from a time on, s, which becomes 0; the recording counts `clock` seconds for one."""

    def digital(channel: Digital) -> Digital:
        # A change within its uncertainty of the zero comes after it, as that of an output does at power-up.
        before = [each.level for each in channel.changes if each.time + each.within <= zero]
        changes = tuple(
            LevelChange(max(each.time - zero, 0.0) / clock, each.level, each.within / clock)
            for each in channel.changes[len(before) :]
        )
        return Digital(channel.column, before[-1] if before else channel.first, changes, channel.bounces)

    def switched(channel: Digital) -> Digital:
        found = digital(channel)
        if recording.is_late or not found.first:
            return found
        # It was off before power-up, and is on in the first row.
        on = LevelChange(0.0, 1, recording.step / clock)
        return found._replace(first=0, changes=(on, *found.changes))

    def series(each: Series) -> Series:
        later = each.times >= zero
        return Series(each.column, (each.times[later] - zero) / clock, each.values[later])

    return replace(
        recording,
        begin=max(recording.begin - zero, 0.0) / clock,
        end=(recording.end - zero) / clock,
        step=recording.step / clock,
        inputs={number: digital(each) for number, each in recording.inputs.items()},
        outputs={number: switched(each) for number, each in recording.outputs.items()},
        analogue={number: series(each) for number, each in recording.analogue.items()},
        positions={number: series(each) for number, each in recording.positions.items()},
        gaps=tuple(((a - zero) / clock, (b - zero) / clock) for a, b in recording.gaps),
    )


def _kind(target: str) -> tuple[str, int]:
    kind, _, number = target.partition(".")
    if kind in CHANNELS and number.isdecimal():
        return kind, int(number)
    hint = "write input.3, output.1, analogue.0, position.0 or time"
    raise ProgramError.of("recording", f"{target!r} is nothing that init reads from a recording", hint=hint)


def _digital(signal: RecordedSignal, recording: Recording) -> Digital:
    """Return the changes of a channel that has two levels, of any voltage, or -1 for true."""
    values, times = signal.values, signal.times
    low, high = float(values.min()), float(values.max())
    if low == -1.0 and high <= 1.0 and not (values % 1.0).any():
        values = np.abs(values)
        low, high = float(values.min()), float(values.max())
    if high - low >= LEVELS:
        share = (values - low) / (high - low)
        between = (share > 1 / 3) & (share < 2 / 3)
        if between.mean() > BETWEEN:
            raise ProgramError.of(
                "recording",
                f"{signal.column} has {count_of(len(np.unique(values)), 'value')} "
                f"from {low:.6g} to {high:.6g}, and no two levels",
                hint="choose the column of a digital channel with --map input.3=NAME",
            )
        known = np.flatnonzero(~between)
        levels, times = share[known] > 0.5, times[known]
    else:
        levels = np.full(len(values), low + high > 1.0)
    levels = levels != (signal.factor is not None and signal.factor < 0.0)
    # A row for each change has its time; a sampled channel has changed between two rows.
    changes = [
        LevelChange(
            float(times[k + 1]) if recording.events else float(times[k] + times[k + 1]) / 2,
            int(levels[k + 1]),
            recording.step / 2 if recording.events else float(times[k + 1] - times[k]) / 2,
        )
        for k in np.flatnonzero(levels[1:] != levels[:-1])
    ]
    settled, bounces = _settled(changes)
    return Digital(signal.column, int(levels[0]), tuple(settled), bounces)


def _settled(changes: Sequence[LevelChange]) -> tuple[list[LevelChange], int]:
    """Return changes without those of a bouncing contact, and how many changes bounced."""
    found: list[LevelChange] = []
    bounces = k = 0
    while k < len(changes):
        last = k
        while last + 1 < len(changes) and changes[last + 1].time - changes[k].time <= BOUNCE:
            last += 1
        count = last - k + 1
        if count >= 3:
            bounces += 1
            found.append(changes[k])
            if count % 2 == 0:  # a pulse that bounces
                found.append(changes[last])
        else:
            found += changes[k : last + 1]
        k = last + 1
    return found, bounces


def machine_positions(series: Series) -> Series:
    """Return positions of the machine, without the steps at which the program gives an axis a new zero."""
    steps = np.diff(series.values)
    size = np.abs(steps)
    before, after = np.append(0.0, steps[:-1]), np.append(steps[1:], 0.0)
    noise = float(np.median(size)) + LEAST * float(np.ptp(series.values))
    times = np.diff(series.times)
    jumps = size > STEP * (np.maximum(np.abs(before), np.abs(after)) + noise)
    jumps &= times < GAP * np.median(times)
    moved = np.where(jumps, (before + after) / 2.0, steps)
    return series._replace(values=series.values[0] + np.append(0.0, np.cumsum(moved)))


def short_remarks(recording: MeasuredRecording) -> Iterator[str]:
    """Yield a sentence for each channel whose pulses are too short for the rows, or that bounces."""
    for kind, channels in (("input", recording.inputs), ("output", recording.outputs)):
        for number, each in sorted(channels.items()):
            if each.shortest < SHORT_ROWS * recording.step:
                yield (
                    f"{kind} {number}: pulses as short as {each.shortest:.3g} s, and a row every "
                    f"{recording.step:.3g} s; shorter ones are missed: record faster"
                )
            if each.bounces:
                groups = count_of(each.bounces, "group")
                yield f"{kind} {number} bounces: {groups} of changes within {BOUNCE:g} s count as one change"

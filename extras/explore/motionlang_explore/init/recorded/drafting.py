"""The draft of a machine file from a recording: measured entries, the rest by exploration, and a run that is compared.

A first run, with the rules as they are in the file, shows when in the recording the machine was switched on. The rules
are then measured from there, and the exploration finds what no column has, such as keys and answers. Its run shows
whether the clock of the recording is right; if not, everything is measured again in right seconds.
"""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import replace
from math import inf
from typing import NamedTuple

from motionlang.commands.compare.drift import clock_text
from motionlang.kernel import Program, ProgramError, Run, run
from motionlang.kernel.lang import READ
from motionlang.kernel.tools import count_of, listed
from motionlang_explore.exploration import TABLES, Entry, entries
from motionlang_explore.identification import MeasuredRule, rules_of
from motionlang_explore.init import Draft
from motionlang_explore.init.recorded.axes import axis_remarks, stroke_clock, switches
from motionlang_explore.init.recorded.judging import (
    JudgedRules,
    judged,
    missed_text,
    recorded_rules,
    settings_of,
)
from motionlang_explore.init.recorded.outcome import (
    LONGER,
    SAME_PROGRAM,
    SWAPPED,
    MatchedMarks,
    clock_of,
    cycle_text,
    matched,
    near,
    power_up,
    recorded_marks,
    run_marks,
    running,
)
from motionlang_explore.init.recorded.recording import (
    MeasuredRecording,
    short_remarks,
    since,
)
from motionlang_explore.init.recorded.unrecorded import FittedWorld, Tables, fitted, in_words, subject
from motionlang_explore.scenario_text import inline

# Nothing changes any more if it did not for so long, s, and for so many times the longest time between two changes.
QUIET, QUIET_TIMES = 5.0, 3.0

BEST = "not recorded; agrees best with the recording"
OTHER_PROGRAM = (
    "check the program, the columns with --map output.1=NAME, and whether the machine was in trouble"
)

# Devices that a recording has a column of, or whose number says nothing.
RECORDED = (
    "input",
    "input bank",
    "output",
    "output bank",
    "digital",
    "analogue input",
)
SINGLE = ("key", "answer")

Drafting = Callable[[Mapping[str, object]], Draft]


class Measured(NamedTuple):
    """The world of a recording: the draft, the rule of each input, and sentences about the recording and the run."""

    draft: Draft
    rules: dict[int, MeasuredRule]
    sentences: list[str]


def measure(
    program: Program, raw: MeasuredRecording, board: Mapping[str, object], until: float, drafting: Drafting
) -> Measured:
    """Return the world of a recording; raise ProgramError if it is not one of this program.

    `drafting` explores the program with given settings; a run ends at `until`, s.
    """
    recording, sentences = power_up_of(program, raw, board)

    def alone(measured: Mapping[str, object]) -> Run:
        return program_run(program, {**board, **measured}, LONGER * recording.end)

    rules = judged(recording, alone).rules
    draft = drafting({**board, **settings_of(rules, recording)[0]})
    missed = _missed_inputs(draft.run, recording)
    if missed:
        sentences += missed.values()
        recording = _with_inputs(recording, recording.inputs.keys() - missed.keys())
        rules = {number: rule for number, rule in rules.items() if number not in missed}
        draft = drafting({**board, **settings_of(rules, recording)[0]})
    guesses = {table: draft.entries(table) for table in TABLES}
    sentences += unread(program, raw, guesses)

    def play(measured: Mapping[str, object], tables: Tables, end: float) -> Run:
        return program_run(program, _world(draft, {**board, **measured}, tables), end)

    found = refined(recording, guesses, draft.exploration.switches.axes, play)
    sentences += check_program(program, found, recording)
    draft = replace(
        draft,
        world=draft.world._replace(settings=found.tables),
        run=play(found.given, found.tables, until),
        given={**board, **found.given},
        comments=found.comments,
    )
    sentences += [*found.sentences, *outcome(draft.run, found.recording), *rules_in_words(found.rules)]
    return Measured(draft, found.rules, sentences)


class Refined(NamedTuple):
    """A recording in right seconds, its rules, measured settings with comments, and the entries that no column has."""

    recording: MeasuredRecording
    rules: dict[int, MeasuredRule]
    given: dict[str, object]
    comments: dict[str, str]
    tables: dict[str, list[Entry]]
    sentences: list[str]
    run: Run
    refuted: tuple[MeasuredRule, ...]


def refined(
    recording: MeasuredRecording,
    guesses: Tables,
    guessed_switches: Mapping[int, Mapping[str, object]],
    play: Callable[[Mapping[str, object], Tables, float], Run],
) -> Refined:
    """Return what a recording says about entries that no column has, about its clock, and about switches.

    `play` runs the program with measured settings and such entries up to a time.
    """
    end = LONGER * recording.end
    found, rules = _fitted(recording, guesses, lambda given, tables: play(given, tables, end))
    sentences: list[str] = []
    measure_clock = stroke_clock if recording.positions else clock_of
    clock = measure_clock(rules.run, recording)
    if clock is not None:
        sentences.append(clock_text(clock))
        recording, found = since(recording, 0.0, clock), found.corrected(clock)
        rules = judged(recording, lambda given: play(given, found.tables, end))
    given, comments = settings_of(rules.rules, recording)
    sentences += in_words(found)
    sentences += axis_remarks(rules.run, recording)
    settings, texts = switches(
        rules.run, recording, guessed_switches, lambda more: play({**given, **more}, found.tables, end)
    )
    comments |= {inline({**entry, "guess": True}): BEST for _, entry in found.changed}
    return Refined(
        recording,
        rules.rules,
        given | settings,
        comments | texts,
        found.tables,
        sentences,
        rules.run,
        rules.refuted,
    )


def _fitted(
    recording: MeasuredRecording, guesses: Tables, play: Callable[[Mapping[str, object], Tables], Run]
) -> tuple[FittedWorld, JudgedRules]:
    """Return the entries that no column has, as the recording needs them, and the rules of the inputs.

    They are fitted with the rules, and with the inputs as recorded if the rules may be wrong. With them in place, the
    run judges the rules again. Inputs as recorded agree with many entries, so other rules need another fit.
    """
    rules = judged(recording, lambda given: play(given, guesses))

    def fit(these: Mapping[int, MeasuredRule]) -> FittedWorld:
        given, _ = settings_of(these, recording)
        return fitted(guesses, recording, lambda tables: play(given, tables))

    found = fit(rules.rules)
    if not any(guesses.values()):
        return found, rules
    if not found.is_perfect and not recording.is_late:
        found = max(found, fit(recorded_rules(recording)), key=lambda each: each.score)
    again = judged(recording, lambda given: play(given, found.tables))
    if any(rule.entries != rules.rules[number].entries for number, rule in again.rules.items()):
        found = fit(again.rules)
        again = judged(recording, lambda given: play(given, found.tables))
    return found, again


def power_up_of(
    program: Program, raw: MeasuredRecording, board: Mapping[str, object]
) -> tuple[MeasuredRecording, list[str]]:
    """Return a recording of what a program names whose times count from power-up, with sentences about it."""
    _check_axes(program, raw, board)
    sentences = [*short_remarks(raw)]
    found, late = _power_up(program, raw, board)
    zero = raw.begin if found is None else found
    if found is None and not late:
        sentences.append(
            "nothing recorded shows when the machine was switched on: times count from the first row of the recording"
        )
    if late:
        sentences.append(
            f"the recording begins while the machine runs, since {late}: "
            "record from before it is switched on, to measure homing and what happens once"
        )
    if zero > raw.begin + 2.0 * raw.step:
        sentences.append(
            f"the machine is switched on {zero - raw.begin:.4g} s after the begin of the recording"
        )
    named = _with_inputs(raw, raw.inputs.keys() - _unnamed(program, raw))
    return since(replace(named, is_late=bool(late), is_placed=found is not None), zero), sentences


def check_program(program: Program, found: Refined, recording: MeasuredRecording) -> Iterator[str]:
    """Yield what a recording lacks if the run is not that of it; raise ProgramError if it is one of another program.

    What the program reads and no column has may be why it does something else.
    """
    marks = matched(found.run, recording, ("output",))
    if not marks.is_other_program:
        return
    tried = dict.fromkeys(
        f"input {rule.entries[0]['channel']} by {rule.subject}" for rule in found.refuted if rule.subject
    )
    text = f"; tried: {', '.join(tried)}, and all inputs as recorded" if tried else ""
    missing = [*_without_column(program)]
    if not missing or _switches_others(program, marks):
        raise ProgramError.of("recording", _other_program(program, marks) + text, hint=OTHER_PROGRAM)
    yield (
        f"{len(marks.pairs)} of {count_of(len(marks.theirs), 'recorded change')} of outputs are in the run{text}: "
        f"no column has {', '.join(missing)}, which {program.source.name} reads; write the right entries into the "
        "machine file, then --update"
    )


def _without_column(program: Program) -> Iterator[str]:
    """Yield what a program reads that no recording has."""
    uses = [use for each in program.structure.statements.values() for use in each.channels]
    names = {
        f"{use.channel} {use.number}" if use.channel not in SINGLE else f"a {use.channel}"
        for use in uses
        if use.access == READ and use.channel not in RECORDED
    }
    yield from sorted(names)


def _switches_others(program: Program, marks: MatchedMarks) -> bool:
    """True if the recording switches outputs that the text of a program does not name."""
    uses = [use for each in program.structure.statements.values() for use in each.channels]
    written = [use for use in uses if use.channel.startswith("output") and use.access != READ]
    known = {use.number for use in written if use.channel == "output"}
    unknown = [each for each in marks.theirs if str(each.label[1]) not in known]
    is_known = all(use.channel == "output" and use.number.isdecimal() for use in written)
    return is_known and len(unknown) >= SAME_PROGRAM * len(marks.theirs)


def entries_of(
    recording: MeasuredRecording,
) -> tuple[dict[int, MeasuredRule], dict[str, object], dict[str, str]]:
    """Return the likeliest rules of the inputs, the settings with them, and the comment of each entry."""
    rules = {
        number: rules_of(number, each, recording)[0] for number, each in sorted(recording.inputs.items())
    }
    return rules, *settings_of(rules, recording)


def _power_up(
    program: Program, raw: MeasuredRecording, board: Mapping[str, object]
) -> tuple[float | None, str]:
    """Return the time of a recording at which the machine was switched on, s, and what shows that it was before.

    The time is None if nothing shows it.
    """
    _, given, _ = entries_of(since(raw, raw.begin))
    first = program_run(program, {**board, **given}, raw.end - raw.begin)
    late = running(first, raw)
    if late:
        return None, late
    recorded = entries(given, "input") + entries(given, "analogue")
    times = [at for each in recorded if isinstance(at := each.get("at"), float) and at > 0.0]
    found = power_up(first, raw, min(times, default=raw.end))
    zero = raw.begin if found is None else found
    before = (
        each for each in recorded_marks(raw) if each.label[0] == "output" and each.time < zero - near(raw)
    )
    earlier = next(before, None)
    if earlier is not None:
        return None, f"output {earlier.label[1]} is switched before the program does what it does at power-up"
    return found, ""


def program_run(program: Program, settings: Mapping[str, object], until: float) -> Run:
    return run(program, machine=dict(settings), until=until)


def _world(draft: Draft, given: Mapping[str, object], tables: Tables) -> dict[str, object]:
    """Return the settings of a draft with measured ones and entries that no column has."""
    settings = {**draft.exploration.switches.settings, **given, **tables}
    for table in TABLES:
        if entries(given, table):
            settings[table] = [*entries(given, table), *tables.get(table, ())]
    return settings


# ------------------------------------------------------------------------------------------ sentences


def unread(program: Program, raw: MeasuredRecording, guesses: Tables) -> Iterator[str]:
    """Yield what the recording has and the program does not read, and the other way round."""
    unused = sorted(_unnamed(program, raw))
    if unused:
        yield (
            f"{'inputs' if len(unused) > 1 else 'input'} {listed(unused)} {_is(unused)} recorded, "
            f"and the program never reads {_it(unused)}: left out"
        )
    uses = [use for _, use in program.structure.inputs()]
    missing: list[str] = []
    if all(use.channel == "input" and use.number.isdecimal() for use in uses):
        missing = [f"input {each}" for each in sorted({int(use.number) for use in uses} - raw.inputs.keys())]
    missing += [subject(table, each) for table in TABLES for each in guesses.get(table, ())]
    if missing:
        yield f"not recorded: {', '.join(dict.fromkeys(missing))}; the entries are guesses"


def _unnamed(program: Program, raw: MeasuredRecording) -> set[int]:
    """Return the recorded inputs that a program does not name: those of an axis at most, which has its own switches."""
    uses = [use for _, use in program.structure.inputs()]
    for each in program.structure.statements.values():
        uses += [use for use in each.channels if use.channel == "input"]
    if not all(use.channel == "input" and use.number.isdecimal() for use in uses):
        return set()
    return raw.inputs.keys() - {int(use.number) for use in uses}


def _with_inputs(recording: MeasuredRecording, numbers: Collection[int]) -> MeasuredRecording:
    kept = {number: each for number, each in recording.inputs.items() if number in numbers}
    return replace(recording, inputs=kept)


def _is(numbers: list[int]) -> str:
    return "is" if len(numbers) == 1 else "are"


def _it(numbers: list[int]) -> str:
    return "it" if len(numbers) == 1 else "them"


def _check_axes(program: Program, raw: MeasuredRecording, board: Mapping[str, object]) -> None:
    """Raise ProgramError if an axis is recorded that the controller does not have."""
    axes = program_run(program, board, 1e-3).controller.axes
    for axis, path in sorted(raw.positions.items()):
        if axis not in axes:
            numbers = ", ".join(map(str, axes))
            raise ProgramError.of(
                "recording",
                f"{path.column} is the position of axis {axis}, and the controller has the axes {numbers}",
                hint=OTHER_PROGRAM,
            )


def _missed_inputs(result: Run, recording: MeasuredRecording) -> dict[int, str]:
    """Return the inputs that the run waits for at its end, and that never change though the machine goes on."""
    found = matched(result, recording, ("output",))
    if len(found.theirs) - len(found.pairs) <= SWAPPED:
        return {}
    stuck = {number for _, channels in _waits(result) for number in channels}
    return {
        number: (
            f"input {number} is {'on' if channel.first else 'off'} in all of the recording, and the program waits for "
            f"it: pulses shorter than a row of {recording.step:.3g} s are missed, record faster"
        )
        for number, channel in sorted(recording.inputs.items())
        if number in stuck and not channel.changes
    }


def _waits(result: Run) -> list[tuple[int, set[int]]]:
    """Return the lines in which a run waits at its end, with the inputs that they read."""
    scheduler = result.machine.scheduler
    program = result.program or result.dialect.program(result.source)
    found = []
    for task in scheduler.tasks if scheduler is not None else ():
        if not task.done and task.wait is not None and task.wait.due() == inf:
            line = result.dialect.locate(result.source, task.at)[0]
            uses = [use for at, use in program.structure.inputs() if at == line and use.channel == "input"]
            found.append((line, {int(use.number) for use in uses if use.number.isdecimal()}))
    return found


def _other_program(program: Program, found: MatchedMarks) -> str:
    """Return why a recording is not one of a program."""
    shared = {each.label[1] for each in found.theirs} & {each.label[1] for each in found.mine}
    text = f"{len(found.pairs)} of {count_of(len(found.theirs), 'recorded change')} of outputs are in the run"
    text += "" if shared else ", which switches other outputs"
    return f"the recording is not one of {program.source.name}: {text}{_first_difference(found)}"


def _first_difference(found: MatchedMarks) -> str:
    """Return the first recorded mark that the run has not, and what the run does instead."""
    paired = {b: a for a, b in found.pairs}
    for k, each in enumerate(found.theirs):
        if k not in paired:
            before = max((a for b, a in found.pairs if b < k), default=-1)
            mine = found.mine[before + 1] if before + 1 < len(found.mine) else None
            instead = f", the run {mine}" if mine is not None else ", the run nothing more"
            after = f" after {found.theirs[k - 1]}" if k else ""
            return f"; first at {each.time:.4g} s: the recording has {each}{after}{instead}"
    return ""


def outcome(result: Run, recording: MeasuredRecording) -> Iterator[str]:
    """Yield how the run agrees with the recording."""
    text = cycle_text(result, recording)
    if text is not None:
        yield text
    found = matched(result, recording, ("output",))
    lost = len(found.theirs) - len(found.pairs)
    if difference := _first_difference(found):
        yield f"{lost} of {count_of(len(found.theirs), 'recorded change')} of outputs not in the run{difference}"
    counts = Counter(each.label[1] for each in run_marks(result, recording) if each.label[0] == "output")
    for number, channel in sorted(recording.outputs.items()):
        if counts[number] and not channel.changes and not channel.first:
            yield (
                f"output {number} ({channel.column}) never changes in the recording, and the run switches it: "
                f"check its column with --map output.{number}=NAME"
            )
    times = [each.time for each in recorded_marks(recording)]
    times += [each.time for channel in recording.inputs.values() for each in channel.changes]
    times.sort()
    if len(times) > 2:
        longest = max(b - a for a, b in itertools.pairwise(times))
        if recording.end - times[-1] > max(QUIET, QUIET_TIMES * longest):
            yield (
                f"nothing changes from {times[-1]:.4g} s to the end of the recording at {recording.end:.4g} s"
                + "".join(f"; the run then waits in line {line}" for line, _ in _waits(result)[:1])
            )


def rules_in_words(rules: Mapping[int, MeasuredRule]) -> Iterator[str]:
    for number, rule in rules.items():
        if not rule.is_explained:
            count = count_of(len(rule.entries), "change")
            yield f"input {number}: no rule explains its {count}; they are written as recorded"
        elif rule.missed:
            yield (
                f"input {number} follows {rule.subject}, but{missed_text(rule).removeprefix(';')}: "
                "it stays a guess"
            )
        if rule.others:
            names = listed(rule.others)
            yield f"input {number}: {names} would explain it equally well; {rule.subject} {rule.reason}"

"""One program, one machine, one run: from a source to a `Run`."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from math import inf, isclose
from typing import TYPE_CHECKING

from motionlang import kernel
from motionlang.kernel import lang
from motionlang.kernel.errors import ProgramError, Terminated
from motionlang.kernel.lang.debugging import Hook, Observer
from motionlang.kernel.lang.dialect import Dialect, dialect_for
from motionlang.kernel.lang.foreign import one_sentence
from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.lang.program import Program
from motionlang.kernel.lang.scheduler import Outside, Scheduler, Stuck
from motionlang.kernel.result import Run
from motionlang.kernel.run_notes import (
    has_run_out,
    hint_at_stuck,
    interrupted,
    open_nonvolatile,
    report_futile_waits,
    report_guesses,
    report_ignored_limits,
    report_keywords_without_effect,
    report_never_started,
    report_stop,
    report_stuck,
    report_unasked,
    report_wide_positions,
    save_nonvolatile,
)
from motionlang.kernel.source import Source, machine_of
from motionlang.kernel.tools import StackSpace

# The default end of a run, because a machine program has none of its own.
ONE_SHIFT = 8 * 3600.0
if TYPE_CHECKING:
    from motionlang.kernel.lang.machine.entries import Given
    from motionlang.kernel.log.cycle import Cycle

# A program without an end runs so many whole cycles, and so many seconds behind the last entry of the machine file.
ENOUGH_CYCLES, ENOUGH_TIME = 10, 60.0
# The factor of the time of the run by which it goes on, at least, if these are not enough yet.
_LONGER = 1.25


class CheckedSettings(dict[str, object]):
    """Settings that have been checked against the machine file's keys."""

    __slots__ = ()


def run(
    program: str | os.PathLike[str] | Source | Program,
    *,
    dialect: str | Dialect | None = None,
    machine: Mapping[str, object] | str | os.PathLike[str] | None = None,
    until: float | None = None,
    overrides: Mapping[str, float | str] | None = None,
    show: Callable[[str], object] | None = None,
    pace: Callable[[float], None] | None = None,
    outside: Outside | None = None,
    begun: Callable[[Machine], None] | None = None,
    nv: str | None = None,
    keep_crash: bool = False,
    hook: Hook | None = None,
    observer: Observer | None = None,
    inputs: Given = (),
    analog: Given = (),
    answers: Given = (),
    keys: Given = (),
) -> Run:
    """Run a program: a path, a `Source` with its text, or the `Program` of one.

    `motionlang.run` describes the public parameters and the errors raised. The other parameters are for this
    package. A `Program` has the `overrides` already, and was made for a machine that agrees with this one in every
    setting for which `Dialect.compiled_in` is True. `pace` is called with the machine time of the next step. `outside`
    is a world that acts on its own, such as a host; it controls how machine time passes. `begun` is called with the
    machine when the program begins, for an observer. `hook` selects a debug build, which calls it
    before statements. `observer` counts steps. An internal error is raised, or with `keep_crash` stored in `Run.crash`
    together with the results so far.
    """
    made = None
    if isinstance(program, Program):
        made, dialect = program, program.language
        program = program.source
    source = program if isinstance(program, Source) else Source.read(program)
    language = dialect_for(source, dialect)
    settings = checked_settings(machine) if machine is not None else settings_next_to(program)
    if inputs or analog or answers or keys:
        settings = kernel.with_entries(settings, inputs, analog, answers, keys)
    virtual = Machine(
        settings,
        first_axis=language.first_axis,
        show=show,
        overrides=overrides,
        hook=hook,
        observer=observer,
    )
    if virtual.stop is not None:
        virtual.stop.line_of = lambda at: source.location(at)[0] if at >= 0 else 0
    result = Run(source, language, virtual)
    if made is None:
        made = language.program(source, settings, is_debug=hook is not None).with_values(overrides or {})
    if not _is_ready(made, language, result):
        made = None
    result.program = made
    if nv is not None and made is not None and not open_nonvolatile(result, nv):
        made = None
    if made is not None:
        stuck = _perform(result, made, until, pace=pace, outside=outside, begun=begun, keep_crash=keep_crash)
        _report(result, stuck)
        result.notes += made.places.notes
    _finish(result, settings)
    return result


def run_on(
    source: Source,
    language: Dialect,
    program: Program,
    machine: Machine,
    until: float | None = None,
    *,
    has_notes: bool = True,
) -> Run:
    """Continue a run from the state of its machine, which may have been put back; return another result.

    Without notes it has no hint at what would end its last wait either: many runs are continued only to be read.
    """
    result = Run(source, language, machine)
    result.program = program
    stuck = _perform(result, program, until)
    if has_notes:
        _report(result, stuck)
        _finish(result, machine.settings)
    else:
        machine.close_terminals()
        result.time = machine.clock.now
    return result


def _perform(
    result: Run,
    compiled: Program,
    until: float | None,
    *,
    pace: Callable[[float], None] | None = None,
    outside: Outside | None = None,
    begun: Callable[[Machine], None] | None = None,
    keep_crash: bool = False,
) -> Stuck | None:
    stuck = None
    if begun is not None:
        begun(result.machine)
    result.diagnostics += compiled.warnings
    try:
        with StackSpace():
            stuck = _execute(result, compiled, until, pace, outside)
    except Exception as error:
        if not keep_crash:
            raise
        result.crash, result.status = error, "fault"
    result.diagnostics[:0] = result.machine.diagnostics
    return stuck


def _report(result: Run, stuck: Stuck | None) -> None:
    if stuck is not None:
        hint_at_stuck(result, stuck)
    if result.machine.has_motors:
        from motionlang.kernel.tracks.history import notes

        result.notes += notes(result.controller)
    result.notes += result.machine.notes
    report_ignored_limits(result)
    report_wide_positions(result)
    if result.machine.without_effect or result.machine.assumed:
        report_keywords_without_effect(result)
    if result.machine.nv is not None:
        save_nonvolatile(result)


def _finish(result: Run, settings: Mapping[str, object]) -> None:
    if result.machine.nv is not None:
        result.machine.nv.close()
    result.machine.close_terminals()
    result.time = result.machine.clock.now
    if result.program is not None and result.machine.log.moves:
        result.notes += result.program.notes
    report_stop(result)
    if settings:
        report_guesses(result)
    if "answer" in settings and result.status in ("ended", "until", "stopped"):
        report_unasked(result)
    if result.program is not None:
        result.program.worded(result.diagnostics)
        result.notes = [result.program.in_notation(each) for each in result.notes]


def end_of(settings: Mapping[str, object]) -> float:
    """Return the machine time, s, at which a run on this machine ends by default."""
    until = settings.get("run.until", ONE_SHIFT)
    assert isinstance(until, (int, float))
    return until


def settings_next_to(program: str | os.PathLike[str] | Source) -> dict[str, object]:
    """Return the settings of the machine file next to a program with a path."""
    path = machine_of(program)
    if path is None:
        return {}

    return kernel.read_machine(Source.read(path))


def checked_settings(machine: Mapping[str, object] | str | os.PathLike[str]) -> dict[str, object]:
    """Return the settings of a machine file, or a caller's, by dotted key, checked; tables may be nested."""
    if isinstance(machine, str | os.PathLike):
        return kernel.read_machine(Source.read(machine))
    if machine and not isinstance(machine, CheckedSettings):
        machine = dict(lang.flat(machine))
        mistake = lang.first_mistake(machine)
        if mistake:
            raise ValueError(mistake)
    return dict(machine)


def _is_ready(program: Program, language: Dialect, result: Run) -> bool:
    try:
        program.require()
    except (KeyboardInterrupt, Terminated) as error:
        result.diagnostics.append(interrupted(result, None, error))
        result.status = "interrupted"
        return False
    except ProgramError as error:
        result.diagnostics = one_sentence(language, program.source, error.diagnostics)
        result.status = "fault"
        return False
    if program.is_doubtful:
        found = one_sentence(language, program.source, program.errors)
        if [each.code for each in found] == ["language"]:
            result.diagnostics, result.status = found, "fault"
            return False
    return True


def _run_cycles(result: Run, scheduler: Scheduler, compiled: Program) -> str:
    """Run a program for a shift, or one that never ends until it has done enough cycles; return the status.

    The times at which the cycles are counted follow from the log, so the end depends on program and machine file alone.
    """
    end = ENOUGH_TIME + _last_entry(result.machine.settings)
    while end < ONE_SHIFT:
        status = scheduler.run(end)
        if status != "until":
            return status
        if not compiled.structure.never_ends:
            break
        result.time, result.status = end, status
        found = result.cycle
        if found is not None and found.count >= ENOUGH_CYCLES and not _creeps(result, found):
            cycles = f"{found.count} cycles of {found.period:.5g} s"
            result.notes.append(
                f"no path through the program ends it: enough after {cycles}; --until S runs it longer"
            )
            return status
        missing = 0.0 if found is None else (ENOUGH_CYCLES - found.count) * found.period
        end = max(end * _LONGER, end + missing)
    return scheduler.run(ONE_SHIFT)


def _creeps(result: Run, found: Cycle) -> bool:
    """True if an axis with limits is elsewhere after a cycle, so that one of them may end the run."""
    before, after = found.times[-2:]
    zeroed = {axis for time, axis, _ in result.machine.log.zeros if time >= before}
    return any(
        a.barriers and (number in zeroed or not isclose(a.position(before), a.position(after), abs_tol=1e-6))
        for number, a in result.controller.axes.items()
    )


def _last_entry(settings: Mapping[str, object]) -> float:
    entries = (each for value in settings.values() if isinstance(value, list) for each in value)
    times = (each.get("at") for each in entries if isinstance(each, Mapping))
    return max((time for time in times if isinstance(time, (int, float))), default=0.0)


def _execute(
    result: Run,
    compiled: Program,
    until: float | None,
    pace: Callable[[float], None] | None,
    outside: Outside | None,
) -> Stuck | None:
    """Run a program; return the wait that nothing can end if it ended there."""
    machine = result.machine
    settings, scheduler = machine.settings, machine.scheduler
    try:
        if scheduler is None:
            if outside is not None:
                outside.start(machine)
            parent = compiled.start(machine)
            scheduler = machine.scheduler = Scheduler(machine.controller, parent, pace, outside, machine.hook)
        if machine.stop is not None:
            machine.stop.end = scheduler.stop
        scheduler.gives_up = until is None  # a caller that wants so much time gets it
        scheduler.is_limited = "run.until" in settings or machine.stop is not None
        has_limit = until is not None or scheduler.is_limited
        drives = pace is not None or outside is not None or machine.hook is not None
        limit = end_of(settings) if until is None else until
        try:
            if has_limit or drives:
                result.status = scheduler.run(limit)
            else:
                result.status = _run_cycles(result, scheduler, compiled)
        except Stuck as stuck:
            if not has_run_out(result, stuck):
                raise
            result.status, result.has_run_out = "until", True
            if has_limit and limit < inf:
                machine.clock.advance(limit)
        if result.status == "until":
            report_futile_waits(result, scheduler)
        if scheduler.ended is not None and result.status in ("ended", "until"):
            report_never_started(result)
        jogging = machine.controller.moving()
        if jogging and result.status == "ended":
            names = ", ".join(map(str, jogging))
            result.notes.append(f"axis {names} was still jogging when the program ended")
    except (KeyboardInterrupt, Terminated) as error:
        result.status = "interrupted"

        result.controller.finish_updates()
        result.diagnostics.append(interrupted(result, scheduler, error))
    except Stuck as stuck:
        report_stuck(result, stuck)
        return stuck
    except Exception as error:
        from motionlang.kernel.lang.run_errors import explain

        diagnostic = explain(result.dialect, result.source, scheduler.current if scheduler else None, error)
        if diagnostic is None:
            raise
        result.status = "fault"
        # The warning of the check has the same cause.
        where = diagnostic.code, diagnostic.line, diagnostic.column
        result.diagnostics = [
            each for each in result.diagnostics if (each.code, each.line, each.column) != where
        ]
        result.diagnostics.append(diagnostic)
    return None

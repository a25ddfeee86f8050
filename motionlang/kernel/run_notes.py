"""The notes of a run, and the diagnostics that only its end shows.

They are about keywords without effect, waits that nothing ended, guesses, and the fate of nonvolatile data.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import chain
from math import inf

from motionlang.kernel import lang
from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.errors import Diagnostic, OutOfTime, Terminated
from motionlang.kernel.files import InUse
from motionlang.kernel.lang.machine.nonvolatile import NonVolatile
from motionlang.kernel.lang.scheduler import Scheduler, Stuck
from motionlang.kernel.lang.task import Task
from motionlang.kernel.lang.waits import Wait
from motionlang.kernel.log.move import LoggedMove
from motionlang.kernel.log.records import Event
from motionlang.kernel.result import Run
from motionlang.kernel.tools import clipped, count_of

# The tables of what other devices write.
_WRITTEN = ("comms", "netdata", "modbus.register")
# The first position in counts that does not fit 32 bits.
COUNTER = 1 << 31
# Lines that a message names at the most.
MAX_NAMED_LINES = 12
# Maximum lines that are named for a keyword without effect.
MAX_LINES = 5


def report_keywords_without_effect(result: Run) -> None:
    """Report keywords without full effect, with the lines that use them."""
    _note_keywords(result, "keywords without effect here", result.machine.without_effect)
    _note_keywords(result, "unknown values, 0 or empty here", result.machine.assumed)
    _warn_of_decisions(result)


def _warn_of_decisions(result: Run) -> None:
    """Warn where the program has decided by a value that is 0 or empty because it is not simulated."""
    assumed = result.machine.assumed
    statements = result.program.structure.statements.values() if assumed and result.program else ()
    for made in statements:
        for use in made.uses if made.condition or made.waits else ():
            if use.role != "read" or use.row is None or use.row.name not in assumed:
                continue
            line, column, length = result.dialect.locate(result.source, use.at)
            if line in assumed[use.row.name]:
                shown = f"is not simulated and {use.row.without_value} here"
                message = f"the program decides by {use.row.word}, which {shown}"
                hint = f"give it in the machine file: [{result.dialect.name}.values] {use.row.example_value}"
                result.diagnostics.append(
                    Diagnostic(
                        "not-simulated", message, line, column, length=length, hint=hint, severity="warning"
                    )
                )


def _note_keywords(result: Run, what: str, words: Mapping[str, list[int]]) -> None:
    if words:
        named = ", ".join(word + _in_lines(lines) for word, lines in words.items())
        result.notes.append(f"{what}: {named}")


def _in_lines(lines: list[int]) -> str:
    if not lines:
        return ""
    shown = [str(line) for line in sorted(lines)[:MAX_LINES]]
    if len(lines) > MAX_LINES:
        shown.append("…")
    return f" (line{'s' if len(lines) > 1 else ''} {', '.join(shown)})"


def open_nonvolatile(result: Run, path: str) -> bool:
    """Lock and read the nv file; on failure report it and return False: do not run."""
    try:
        result.machine.nv = NonVolatile(path)
    except InUse:
        hint = "wait until it ends, or give each run its own file"
        _no_nonvolatile(result, f"the nv data of {path} are in use by another run", hint)
        return False
    except (OSError, ValueError) as problem:
        _no_nonvolatile(result, f"the nv data of {path} cannot be read: {_why_not(problem)}")
        return False
    return True


def save_nonvolatile(result: Run) -> None:
    """Write the nv file, or report which data do not outlive the run."""
    nonvolatile = result.machine.nonvolatile
    if nonvolatile.path is None:
        if nonvolatile.names:
            words = ", ".join(nonvolatile.names)
            result.notes.append(f"nv data stored only during the run (use --nv FILE): {words}")
        return
    try:
        nonvolatile.save()
    except OSError as problem:
        _no_nonvolatile(result, f"the nv data cannot be written to {nonvolatile.path}: {_why_not(problem)}")


def _why_not(problem: Exception) -> str:
    return getattr(problem, "strerror", None) or str(problem)


def _no_nonvolatile(result: Run, message: str, hint: str = "") -> None:
    result.diagnostics.append(Diagnostic("file", message, hint=hint))
    result.status = "fault"


def report_futile_waits(result: Run, scheduler: Scheduler) -> None:
    """Report waits that only an event could have ended, if no event did.

    These reports are not part of the run's figures.
    """
    if result.machine.controller.moving():
        _report_endless_homing(result, scheduler)
        return
    if result.has_run_out:
        result.wait_notes.append("the machine file has nothing more for what the program waits for")
    is_over = scheduler.is_over()
    for task in scheduler.tasks:
        if task.wait is not None and task.wait.due() == inf:
            line = _line_of(result, task)
            since = f"since {task.wait.since:.3f} s"
            _log_wait(result, task.at, task.wait.why)
            result.wait_notes.append(f"line {line}: {task.name} still waited {task.wait.why}, {since}")
        elif is_over and task.polls_in_vain and task.polled:
            line = _line_of(result, task)
            polled = f"line {line}: {task.name} still polled {task.polled}, which could no longer change"
            result.wait_notes.append(polled)
    result.notes += result.wait_notes


def _log_wait(result: Run, at: int, why: str) -> None:
    """Log an endless wait as an event, at the source position of its task."""
    result.machine.log.events.add(Event(result.machine.clock.now, "wait", None, None, None, at, 0, why))


def _report_endless_homing(result: Run, scheduler: Scheduler) -> None:
    """Report homing that finds no switch or mark, if no task can stop it any more."""
    if scheduler.is_hopeless():
        result.diagnostics += _lost(result)


def _lost(result: Run) -> list[Diagnostic]:
    """Return the diagnostics of homing moves that never end, each at its line."""
    found = []
    for axis, a in result.controller.axes.items():
        homing = a.homing
        if homing is not None and homing.endless_motion:
            text = result.source.line(homing.line)
            column, length = len(text) - len(text.lstrip()) + 1, max(1, len(text.strip()))
            keys = f"axis.{axis}.home_switch, travel and index_every"
            if homing.has_passed_switch:
                other = "home more slowly, so that the axis stops on its switch, or "
            else:
                other = "home in the other direction, or " if homing.provided else ""
            hint = f"{other}give its position in the machine file: {keys}"
            found.append(
                Diagnostic("never", homing.endless_motion, homing.line, column, length=length, hint=hint)
            )
            # The warning of the HOME says the same.
            warned = result.machine.diagnostics
            warned[:] = [each for each in warned if each.code != "never" or not each.hint.endswith(keys)]
    return found


def report_ignored_limits(result: Run) -> None:
    """Note the limit switches that moves have passed while these were not in force."""
    for axis, a in result.controller.axes.items():
        for line, position in (each.ignored for each in a.limits if each.ignored is not None):
            text = f"axis {axis} passed its limit switch at {position:.10g}, which was not in force"
            result.notes.append(f"line {line}: {text}")


def report_wide_positions(result: Run) -> None:
    """Note the axes without a wrap that were beyond the 32 bits of a counter, as a move began or at the end."""
    axes = {number: a for number, a in result.controller.axes.items() if not a.scale.wrap}
    ends = ((number, a.position(result.machine.clock.now) - a.scale.zero) for number, a in axes.items())
    begun = ((each.axis, each.profile.start - each.zero) for each in result.machine.log.moves if each.profile)
    wide = {number for number, counts in chain(ends, begun) if not -COUNTER <= counts < COUNTER}
    for number in sorted(wide & axes.keys()):
        counter = "beyond 32 bits of counts, where a controller may wrap or stop"
        result.notes.append(f"axis {number}: its position was {counter}")


def report_guesses(result: Run) -> None:
    """Warn if the result depends on guessed settings of the machine file.

    Only guesses that the run has used count.
    """
    machine = result.machine
    settings, found, count = machine.settings, [], 0
    tables: dict[str, list[Mapping[str, object]]] = {
        name: [each for each in settings.get(name, ()) if each.get("guess")]  # type: ignore[attr-defined]
        for name in ("input", "analogue", "answer")
        if name in settings
    }
    for name, log in (("input", machine.log.inputs), ("analogue", machine.log.analogue_inputs)):
        changed = {each.channel for each in log} if tables.get(name) else set()
        used = sorted({each["channel"] for each in tables.get(name, ()) if each["channel"] in changed})
        found += [f"{lang.DRIVES[name][0]} {', '.join(map(str, used))}"] if used else []
        count += len(used)
    if tables.get("answer"):
        left = machine.unasked()
        answers = [each for each in tables["answer"] if each["text"] not in left]
        found += [count_of(len(answers), "answer")] if answers else []
        count += len(answers)
    stimuli = machine.controller.stimuli
    pressed = [each for each in stimuli.used("key") if each.get("guess")]
    found += [count_of(len(pressed), "key")] if pressed else []
    count += len(pressed)
    for name in _WRITTEN:
        what, number = lang.DRIVES[name]
        numbers: set[int] = {each[number] for each in stimuli.used(name) if each.get("guess")}  # type: ignore[misc]
        found += [f"{what} {', '.join(map(str, sorted(numbers)))}"] if numbers else []
        count += len(numbers)
    turned: list[Mapping[str, object]] = settings.get("encoder", [])  # type: ignore[assignment]
    guessed = [str(each.get("channel", each.get("aux"))) for each in turned if each.get("guess")]
    found += [f"encoder {', '.join(guessed)}"] if guessed else []
    count += len(guessed)
    axes = [key.split(".")[1] for key, value in settings.items() if value is True and key.endswith(".guess")]
    moved = {str(move.axis) for move in machine.log.moves} if axes else set()
    homed = sorted(moved.intersection(axes), key=int)
    found += [f"the switches of axis {', '.join(homed)}"] if homed else []
    count += len(homed)
    if found:
        guesses = count_of(count, "guess", "guesses")
        message = f"this result depends on {guesses} of the machine file: {'; '.join(found)}"
        hint = "correct each in the machine file and remove its guess = true"
        result.diagnostics.append(Diagnostic("guess", message, hint=hint, severity="warning"))


def report_stop(result: Run) -> None:
    """Report a `run.stop` by a line of which nothing is in the log."""
    stop = result.machine.stop
    if stop is None or not stop.line or stop.counts.total():
        return
    log = result.machine.log
    at = {each.at for stream in (log.waits, log.outputs, log.analogue_outputs, log.prints) for each in stream}
    lines = {move.line for move in log.moves} | {stop.line_of(each) for each in at if each >= 0}
    named = ", ".join(map(str, sorted(lines - {0})[:MAX_NAMED_LINES]))
    message = f"line {stop.line} cannot end the run: it moved, switched and printed nothing, and no wait of it ended"
    hint = f"run.stop.line can be {named}" if named else "end the run by run.until"
    result.diagnostics.append(Diagnostic("machine-file", message, stop.line, hint=hint))


def report_unasked(result: Run) -> None:
    """Warn of given answers that no INPUT used."""
    for text in result.machine.unasked():
        result.diagnostics.append(
            Diagnostic(
                "unasked",
                f'no INPUT took the answer "{clipped(text)}"',
                hint="leave it out, or let its prompt be part of the question",
                severity="warning",
            )
        )


def report_never_started(result: Run) -> None:
    """Warn of moves that were loaded but never started, once per line and axis or path."""
    left = reversed(result.machine.never_started())
    for move, axes in {(axes[0].index, move.line): (move, axes) for move, axes in left}.values():
        text = result.source.line(move.line)
        column = len(text) - len(text.lstrip()) + 1 if text else 0
        names = ", ".join(str(each.index) for each in axes)
        on = f"axis {names}" if len(axes) == 1 else f"axes {names}"
        message = f"the program ended, but {move.command} on {on} was loaded and never started"
        hint = _what_starts(move, axes)
        diagnostic = Diagnostic(
            "never-started",
            message,
            move.line,
            column,
            length=len(text.strip()),
            hint=hint,
            severity="warning",
        )
        result.diagnostics.append(diagnostic)


def _what_starts(move: LoggedMove, axes: Sequence[Axis]) -> str:
    """Return what starts a buffered move of some axes, or what it waits for; the first axis is the master."""
    if not move.released:
        return f"GO({axes[0].index}) starts the buffered moves"
    for each in axes:
        if each.suspended:
            return f"axis {each.index} is suspended: resume it"
        if each.move is not None:
            return f"it waits for the end of {each.move.command} on axis {each.index}"
    return "it waits for the move before it"


def has_run_out(result: Run, stuck: Stuck) -> bool:
    """True if entries of the machine file have ended before what the program waits for, and none is left."""
    waits = [(stuck.task, stuck.wait), *((each, each.wait) for each in _others(result, stuck.task))]
    return _has_ended_before(result, stuck.task) and any(
        _has_ended_before(result, task) and _was_fed(result, task, wait)
        for task, wait in waits
        if wait is not None
    )


def _has_ended_before(result: Run, task: Task) -> bool:
    """True if a wait or a loop like the present one was over before; a loop without an end, if it did anything."""
    log = result.machine.log
    if task.wait is not None:
        return any(each.at == task.at and each.task == task.name for each in log.waits.written())
    ended = {each.at for each in log.loops.written() if each.task == task.name}
    if any(at in ended for at, _, _ in task.loops):
        return True
    return (
        result.program is not None and result.program.structure.never_ends and bool(log.moves or log.prints)
    )


def _was_fed(result: Run, task: Task, wait: Wait) -> bool:
    """True if entries of the machine file have changed what a task waits for, or what handlers answer."""
    machine = result.machine
    is_called = any(each.kind == "handler" for each in machine.log.events.written())
    tables = result.dialect.driven_by(wait.why) or (lang.DRIVES if is_called else ())
    is_any = wait.cause != "input"
    has_changed = any(is_any or each.channel in wait.what for each in machine.log.inputs.written())
    return ("input" in tables and has_changed) or any(map(machine.controller.stimuli.used, tables))


def report_stuck(result: Run, stuck: Stuck) -> None:
    """Report a wait that nothing can end; the run ended there, with a time limit or without.

    `hint_at_stuck` adds the hint.
    """
    line, column, length = result.dialect.locate(result.source, stuck.task.at)
    lost = _lost(result)
    if lost:
        result.status = "fault"
        result.diagnostics += lost
        return
    message = f"the program waits {stuck.wait.why}, which can never happen"
    _log_wait(result, stuck.task.at, stuck.wait.why)
    result.notes.append(f"line {line}: {message}")
    for each in _others(result, stuck.task):
        result.notes.append(f"line {_line_of(result, each)}: {each.name} waits {_why(each)}")
    result.status = "fault"
    result.diagnostics.append(Diagnostic("never", message, line, column, length=length))


def hint_at_stuck(result: Run, stuck: Stuck) -> None:
    """Add what would end the wait to its report."""
    others = _others(result, stuck.task)
    waits = [(stuck.task, stuck.wait), *((each, each.wait) for each in others if each.wait is not None)]
    hints = (
        find(result.dialect, result.program, result.machine, task, wait)
        for find in (lang.what_ends, lang.what_frees)
        for task, wait in waits
    )
    start = "start a move first, or add a machine file with the event that it waits for"
    report = result.diagnostics[-1]
    report.hint = report.hint or next(filter(None, hints), _deadlock(result, others) or start)


def _others(result: Run, task: Task) -> list[Task]:
    scheduler = result.machine.scheduler
    assert scheduler is not None
    return [each for each in scheduler.tasks if each is not task and each.wait is not None]


def _deadlock(result: Run, others: Sequence[Task]) -> str:
    """Return what each of the other tasks waits for; "" if there is none."""
    waits = [f"{each.name} in line {_line_of(result, each)} {_why(each)}" for each in others if _why(each)]
    return f"the tasks wait for each other: {', '.join(waits)}" if waits else ""


def _line_of(result: Run, task: Task) -> int:
    return result.dialect.locate(result.source, task.at)[0]


def _why(task: Task) -> str:
    return "" if task.wait is None else task.wait.why


def who_ended(error: BaseException) -> str:
    """Return the external cause of a run's end, as text."""
    if isinstance(error, OutOfTime):
        return f"after {error.seconds:.10g} s of processor time"
    if isinstance(error, Terminated):
        import signal

        return f"by {signal.Signals(error.number).name}"
    return "from the keyboard"


def interrupted(result: Run, scheduler: Scheduler | None, error: BaseException) -> Diagnostic:
    """Return the diagnostic of Ctrl-C or a signal, at the current task's position."""
    message, hint = f"the run was ended {who_ended(error)}", ""
    if isinstance(error, OutOfTime):
        hint = "--until S ends it at a machine time; --cpu S gives it more processor time, --cpu 0 any"
    if scheduler is None:
        return Diagnostic("interrupted", message, hint=hint)
    line, column, length = result.dialect.locate(result.source, scheduler.current.at_error(error))
    return Diagnostic("interrupted", message, line, column, length=length, hint=hint)

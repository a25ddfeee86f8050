"""A run as data, schema `motionlang.report/3`: the output of `--format json`.

Lengths are user units, times seconds, speeds user units per second, all in full precision. The figures of a
move are those in force when it started. Only axes that the program used are listed; all others are in their state
at power-up.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import cache
from itertools import islice
from json import JSONEncoder
from math import inf
from operator import attrgetter
from typing import TYPE_CHECKING

from motionlang.kernel.assumptions.used import depended_on, remembered_in
from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.faults import ABORT
from motionlang.kernel.controller.operations import Controller
from motionlang.kernel.errors import Diagnostic
from motionlang.kernel.log.move import LoggedMove
from motionlang.kernel.log.records import Switched
from motionlang.kernel.planners import Profile
from motionlang.kernel.planners.ramps import named_ramps
from motionlang.kernel.result import Run

if TYPE_CHECKING:
    from motionlang.kernel.report_types import Report
    from motionlang.kernel.tracks.history import MotorFigures

Row = dict[str, object]

SCHEMA = "motionlang.report/3"
# The value of "ended" for a move in progress at the end of the run.
END_OF_RUN = "end-of-run"
# The sources of an axis's position: without a simulated motor feedback equals demand.
DEMAND, MOTOR = "demand", "simulated motor"
# Moves that are written at once.
AT_ONCE = 1000
# The figures of a move apart from its profile, in the order of `_line_of_ramps`.
_figures = attrgetter("commanded_speed", "scale", "zero", "ended")


def build(run: Run) -> Report:
    """Return the complete report as plain dicts, lists, texts and numbers."""
    from motionlang.kernel.report_types import Report

    lists = {"moves": list(moves(run))} | {name: list(rows) for name, rows in _lists(run).items()}
    return Report(_head(run) | lists | _tail(run) | _concluded(run), run)


def text(run: Run, *, whole: bool = True) -> str:
    """Return the report as one JSON document in ASCII, one line per move.

    If `whole` is False, what follows from the rest is omitted: the cycle, and the assumptions that the results depend
    on.
    """
    return "".join(pieces(run, whole=whole))


def pieces(run: Run, *, whole: bool = True) -> Iterator[str]:
    """Yield the document in chunks, so that a million moves need not be in memory."""
    tail = _tail(run)
    if whole:
        tail |= _concluded(run)
    lists = {name: map(_encoder(), rows) for name, rows in _lists(run).items()}
    return _document(_head(run), {"moves": _move_lines(run)} | lists, tail)


def _lists(run: Run) -> dict[str, Iterator[Row]]:
    """Return the rows of all lists but the moves, which are read one by one."""
    log, line = run.machine.log, _lines(run)
    return {
        "printed": ({"time": each.time, "line": line(each.at)} for each in log.prints),
        "switched": (_switched(each, line) for each in log.outputs),
        "analogue_outputs": (_switched(each, line) for each in log.analogue_outputs),
        "written": (
            {"time": each.time, "target": each.target, "value": each.value, "line": line(each.at)}
            for each in log.writes
        ),
        "events": events(run),
    }


def _switched(each: Switched, line: Callable[[int], int]) -> Row:
    return {"time": each.time, "channel": each.channel, "value": each.value, "line": line(each.at)}


def _lines(run: Run) -> Callable[[int], int]:
    """Return a function that converts a source offset to its line, 0 without one."""

    @cache
    def line(at: int) -> int:
        return run.dialect.locate(run.source, at)[0] if at >= 0 else 0

    return line


def failure(program: str, dialect: str, diagnostics: Iterable[Diagnostic], status: str = "fault") -> str:
    """Return the JSON document of a run that never began.

    The cause is an invalid file or setting, or an interrupt.
    """
    head: Row = {"schema": SCHEMA, "program": program, "dialect": dialect, "status": status}
    head |= {"time": 0.0, "output": []}
    tail: Row = {"axes": [], "diagnostics": [d.as_dict() for d in diagnostics], "notes": []}
    tail |= {"cycle": None, "assumptions": []}
    lists = ("moves", "printed", "switched", "analogue_outputs", "written", "events")
    return "".join(_document(head, {name: iter(()) for name in lists}, tail))


def moves(run: Run, in_full: int | None = None) -> Iterator[Row]:
    """Yield every move that was started, in order; moves in progress end with the run.

    With `in_full` only that many rows are complete, and also those of axes with a simulated motor. The others are
    `_brief`.
    """
    running = _running(run)
    figures = _motor_figures(run.controller)
    for number, move in enumerate(run.controller.log.moves):
        if in_full is not None and number >= in_full and number not in figures:
            yield _brief(run, move, running)
            continue
        yield _move(run, move, running, figures.get(number))


def _brief(run: Run, move: LoggedMove, running: dict[int, float | None]) -> Row:
    """Return the fields of a move's row that are used in sums."""
    profile, _ = _until_end(run, move, running)
    scale = move.scale or 1.0
    return {
        "axis": move.axis,
        "command": move.command,
        "line": move.line,
        "duration": profile.duration,
        "distance": _distance(profile.distance, _rounding(profile), scale),
        "peak_speed": _peak(profile) / abs(scale),
    }


def _move_lines(run: Run) -> Iterator[str]:
    """Yield the lines of the moves, most of them without a row."""
    line = _encoder()
    figures = _motor_figures(run.controller)
    running = _running(run)
    for number, move in enumerate(run.controller.log.moves):
        text = ""
        if id(move) not in running and not move.overlaid and number not in figures:
            profile = move.profile
            if profile is not None and profile.has_ramps:
                about = move.axis, move.command, move.line, move.start_time, *_figures(move)
                text = _line_of_ramps(
                    about, profile.shape, profile.start, profile.end, profile.duration, profile._recipe
                )
        # JSON has null for a figure that has overflowed.
        if not text or "inf" in text or "nan" in text:
            text = line(_move(run, move, running, figures.get(number)))
        yield text


def _line_of_ramps(
    about: tuple[int, str, int, float, float | None, float | None, float, str],
    shape: str,
    start: float,
    end: float,
    duration: float,
    recipe: tuple[float, ...],
) -> str:
    """Return the line of a move of ramps.

    It is that of its row (`_move`), in half the time.
    """
    axis, command, at, start_time, asked, scale, zero, ended = about
    scale = scale or 1.0
    size = abs(scale)
    peak = max(map(abs, recipe[::3])) if duration else 0.0
    commanded = "" if asked is None else f'"commanded_speed": {asked / size!r}, '
    phases = [
        f'{{"name": "{name}", "duration": {time!r}, "distance": {distance / scale!r}}}'
        for name, time, distance, _, _ in named_ramps(recipe)
    ]
    return (
        f'{{"axis": {axis}, "command": "{command}", "line": {at}, "profile": "{shape}", '
        f'"start_time": {start_time!r}, "duration": {duration!r}, "start": {(start - zero) / scale!r}, '
        f'"end": {(end - zero) / scale!r}, "distance": {(end - start) / scale!r}, '
        f'"peak_speed": {peak / size!r}, {commanded}"phases": [{", ".join(phases)}]'
        + (f', "ended": "{ended}"}}' if ended else "}")
    )


def _running(run: Run) -> dict[int, float | None]:
    """Return the moves in progress by identity, with their start position if changed."""
    found: dict[int, float | None] = {}
    for axis in run.controller.axes.values():
        before: LoggedMove | None = None
        for move in axis.entries:
            begin: float | None = None
            if before is not None:
                assert before.profile is not None
                begun = found[id(before)]
                by = 0.0 if begun is None else begun - before.profile.start
                begin = before.profile.position(run.time - before.start_time) + by
            found[id(move)] = begin
            before = move
    return found


# The phases of ramps, which an axis at rest on a path does not have.
_RAMPS = ("accel", "slew", "decel", "stop")


def _phases(profile: Profile, scale: float) -> list[Row]:
    rounding = _rounding(profile)
    return [
        {"name": each.name, "duration": each.duration, "distance": _distance(each.distance, rounding, scale)}
        for each in profile.phases
    ]


def _rounding(profile: Profile) -> float:
    """Return the distance in counts below which a distance within a profile is rounding alone."""
    return 1e-12 * max(
        abs(each) for each in (profile.start, profile.end, *(p.distance for p in profile.phases))
    )


def _distance(distance: float, rounding: float, scale: float) -> float:
    """Return a distance in user units, 0 if it is rounding alone, as that of a whole circle."""
    return distance / scale if abs(distance) > rounding else 0.0


def _standing(profile: Profile) -> list[Row]:
    """Return the phases of an axis that does not move: its ramps are one hold."""
    merged: list[tuple[str, float]] = []
    for phase in profile.phases:
        name, duration = "hold" if phase.name in _RAMPS else phase.name, phase.duration
        if merged and name == merged[-1][0] == "hold":
            duration += merged.pop()[1]
        merged.append((name, duration))
    return [{"name": name, "duration": duration, "distance": 0.0} for name, duration in merged]


def _move(run: Run, move: LoggedMove, running: dict[int, float | None], motor: MotorFigures | None) -> Row:
    start, scale = move.start_time, move.scale or 1.0
    profile, ended = _until_end(run, move, running)
    size, peak = abs(scale), _peak(profile)
    row: Row = {
        "axis": move.axis,
        "command": move.command,
        "line": move.line,
        "profile": profile.shape,
        "start_time": start,
        "duration": profile.duration,
        "start": move.to_user(profile.start),
        "end": move.to_user(profile.end),
        "distance": _distance(profile.distance, _rounding(profile), scale),
        "peak_speed": peak / size,
        **({} if move.commanded_speed is None else {"commanded_speed": move.commanded_speed / size}),
        "phases": _phases(profile, scale) if peak else _standing(profile),
    }
    if ended:
        row["ended"] = ended
    if motor is not None:
        row["motor"] = {
            "peak_following_error": motor.peak_error / size,
            "settle_time": motor.settle_time,
            "rms_torque": motor.rms_torque,
            "peak_output": motor.peak_output,
        }
    return row


def _peak(profile: Profile) -> float:
    """Return the highest speed, counts/s; 0 for a profile without duration.

    Such a profile may have an initial speed.
    """
    return profile.peak_speed if profile.duration else 0.0


def _until_end(run: Run, move: LoggedMove, running: dict[int, float | None]) -> tuple[Profile, str]:
    """Return the profile of a move up to the end of the run, and the cause of its end."""
    begin, is_running = running.get(id(move)), id(move) in running
    ended = move.ended
    is_current = is_running and move is run.controller.axes[move.axis].move
    # A slave's profile is joined on demand, so it is read once.
    profile = None if is_current else move.profile
    if profile is None or ((is_running or move.overlaid) and move.start_time + profile.duration > run.time):
        profile, ended = move.until(run.time), END_OF_RUN
    return profile if begin is None else profile.scaled(begin, 1.0), ended


def _motor_figures(controller: Controller) -> dict[int, MotorFigures]:
    """Return the motor figures of the moves; without motors empty, at no cost."""
    if all(axis.feedback is None for axis in controller.axes.values()):
        return {}
    from motionlang.kernel.tracks.history import figures

    return figures(controller)


def events(run: Run) -> Iterator[Row]:
    """Yield the events in chronological order; `docs/events.md` has the kinds."""
    log, line = run.machine.log, _lines(run)
    for number, event in enumerate(log.events, log.events.first):
        row: Row = {"time": event.time, "kind": event.kind}
        for name, value in (("axis", event.axis), ("value", event.value), ("limit", event.limit)):
            if value is not None:
                row[name] = value
        row["line"] = line(event.at)
        if event.ordered:
            row["commanded_by"] = event.ordered
        if event.text:
            row["text"] = event.text
        if number in log.repeated:
            row["count"] = log.repeated[number]
        yield row


def axes(run: Run) -> list[Row]:
    """Return the final state of every axis that the program used."""
    moved = {move.axis for move in run.controller.log.moves}
    return [
        _axis(axis, run.time)
        for axis in run.controller.axes.values()
        if axis.index in moved or _is_touched(axis)
    ]


def remembered(run: Run) -> list[str]:
    """List the commands that moved an axis by a meaning that no document states, in the order of their first moves."""
    left, found = remembered_in(run.dialect, run.source.text), []
    for move in run.machine.log.moves if left else ():
        if move.command in left:
            left.remove(move.command)
            found.append(move.command)
            if not left:
                break
    return found


def assumptions(run: Run) -> list[str]:
    """List the unconfirmed assumptions that the program depended on.

    Their names are those in docs/contributing/assumptions.md.
    """
    return depended_on(run.dialect, run.source.text, run.machine.settings)


def device_writes(run: Run) -> list[Row]:
    """Return the final values that the program wrote to other devices, each once."""
    return [row for rows in run.machine.written for row in rows()]


def _axis(axis: Axis, now: float) -> Row:
    motor = axis.feedback
    counts = axis.position(now) if motor is None else motor.position
    row: Row = {
        "axis": axis.index,
        "position": axis.scale.position_to_user(counts),
        **({"wrapped_position": axis.scale.shown_position(counts)} if axis.scale.wrap else {}),
        "counts": counts,
        "scale": axis.scale.counts,
        "enabled": axis.enabled,
        "error": axis.faults,
        "feedback": DEMAND if motor is None else MOTOR,
    }
    if motor is not None:
        row["motor"] = {
            "following_error": motor.error / abs(axis.scale.counts or 1.0),
            "output": motor.output + 0.0,  # no minus zero
            "gains": "not needed" if motor.chosen is None else motor.chosen.gains,
        }
    return row


def _is_touched(axis: Axis) -> bool:
    return bool(len(axis.starts) > 1 or axis.faults & ~ABORT or axis.scale.counts != 1.0 or axis.scale.zero)


def _head(run: Run) -> Row:
    return {
        "schema": SCHEMA,
        "program": run.source.name,
        "dialect": run.dialect.name,
        "status": run.status,
        "time": run.time,
        "output": list(run.output),
    }


def _tail(run: Run) -> Row:
    tail: Row = {
        "axes": axes(run),
        "diagnostics": [diagnostic.as_dict() for diagnostic in run.diagnostics],
        "notes": list(run.notes),
    }
    if run.quantities:
        tail["quantities"] = [{"name": name, "value": value} for name, value in run.quantities.items()]
    if run.controller.log.dropped:
        tail["dropped"] = [
            {"axis": move.axis, "command": move.command, "line": move.line, "reason": move.ended}
            for move in run.controller.log.dropped
        ]
    tail |= run.findings
    if run.terminals:
        tail["terminals"] = [{"name": name, "output": lines} for name, lines in sorted(run.terminals.items())]
    if writes := device_writes(run):
        tail["device_writes"] = writes
    return tail


def _concluded(run: Run) -> Row:
    """Return what follows from a run and its program, and is in no golden file."""
    cycle = run.cycle
    return {"cycle": cycle and cycle.as_dict(), "assumptions": assumptions(run)}


def _document(head: Row, lists: dict[str, Iterator[str]], tail: Row) -> Iterator[str]:
    """Yield the document: one line per field, and per move or event.

    `lists` has fields whose elements are already lines. The indentation of json is written in Python and takes three
    times as long.
    """
    line = _encoder()
    fields = [f'"{name}": {line(value)}' for name, value in head.items()]
    yield "{" + ",\n ".join(fields) + ",\n "
    for name, rows in lists.items():
        between = "\n  "
        yield f'"{name}": ['
        while some := list(islice(rows, AT_ONCE)):
            yield between + ",\n  ".join(some)
            between = ",\n  "
        yield "],\n " if between == "\n  " else "\n],\n "
    yield ",\n ".join(f'"{name}": {line(value)}' for name, value in tail.items()) + "}\n"


def _encoder() -> Callable[[object], str]:
    """Return a function that converts a value to a line of JSON."""
    encode = JSONEncoder(allow_nan=False).encode

    def line(value: object) -> str:
        try:
            return encode(value)
        except ValueError:
            return encode(finite(value))

    return line


def finite(value: object) -> object:
    """Replace overflowed figures, which JSON cannot represent, by null."""
    if isinstance(value, dict):
        return {name: finite(each) for name, each in value.items()}
    if isinstance(value, list):
        return [finite(each) for each in value]
    if isinstance(value, float) and not abs(value) < inf:
        return None
    return value

"""A machine as data for a page: what it has, which stays, and its state, which is sent again and again."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import isfinite
from typing import Any

from motionlang.commands.channels import Channel, channels_of
from motionlang.comparison.texts import plain
from motionlang.kernel import Dialect, Machine, Program, Rejected, Run, dialect
from motionlang.kernel.controller import fault_names
from motionlang.kernel.lang import names_in_comments
from motionlang_explore.identification import in_words
from motionlang_explore.map.axes import axes
from motionlang_explore.panel.play import Play
from motionlang_explore.panel.rest import SHADOW, TABLE_OF, seeking, tasks_of
from motionlang_explore.panel.roles import Roles

Data = dict[str, Any]
# The last moves whose starts and lines are shown.
MAX_MOVES = 16
# The tables whose elements a host writes.
MEMORY = ("comms", "netdata")


# ---------------------------------------------------------------------------------------------------- what it has


def contents(program: Program, language: Dialect, settings: Mapping[str, object], roles: Roles) -> Data:
    """Return what a page shows of a program on its machine as long as it runs."""
    used = channels_of(program, language)
    structure = program.structure
    named = names_in_comments(program.source, language)
    moved = [each for each in axes(structure, named) if each.axis is not None]
    held = [each.number for each in used if each.kind == "key"]
    return {
        "file": program.source.name,
        "lines": program.source.text.split("\n"),
        "inputs": [*_inputs(used, settings, roles.kinds), *_others(used)],
        "outputs": [
            {"number": int(each.number), "name": each.name}
            for each in used
            if each.kind == "output" and each.number.isdecimal()
        ],
        "axes": [_axis(int(each.axis or 0), each.name, settings) for each in moved],
        "stops": roles.stops,
        "keys": bool(held),
        "holds": "" in held,
    }


def _inputs(used: Sequence[Channel], settings: Mapping[str, object], kinds: Mapping[int, str]) -> list[Data]:
    """Return the digital inputs: those of the program, and those that the machine file or an exploration has.

    An input without one of the `kinds` is a button if the program waits for it and does not read it elsewhere.
    """
    found = {int(each.number): each for each in used if each.kind == "input" and each.number.isdecimal()}
    driven: dict[int, Mapping[str, object]] = {}
    for entry in settings.get("input", ()):  # type: ignore[attr-defined]
        driven.setdefault(entry["channel"], entry)
    rows = []
    for number in sorted(found.keys() | driven.keys() | kinds.keys()):
        channel, entry = found.get(number), driven.get(number)
        name = channel.name if channel is not None else str((entry or {}).get("name", ""))
        is_awaited = channel is not None and (channel.waits or channel.starts) and not channel.reads
        kind = kinds.get(number, "button" if is_awaited else "switch")
        rows.append(_row("input", number, name, kind, channel))
        rows[-1]["driven"] = "" if entry is None else in_words(entry)
    return rows


def _others(used: Sequence[Channel]) -> list[Data]:
    """Return the analogue inputs and the elements that a host writes."""
    rows = []
    for each in used:
        table = TABLE_OF.get(each.kind, "")
        is_read = bool(each.reads or each.waits or each.starts)
        if each.number.isdecimal() and is_read:
            if table == "analogue":
                rows.append(_row(table, int(each.number), each.name, "slider", each))
            elif table in MEMORY:
                rows.append(_row(table, int(each.number), each.name, "field", each))
    return rows


def _row(table: str, number: int, name: str, kind: str, channel: Channel | None) -> Data:
    title = f"input {number}" if channel is None else channel.title
    lines = [] if channel is None else channel.lines
    return {"table": table, "number": number, "title": title, "name": name, "kind": kind, "lines": lines}


def _axis(number: int, name: str, settings: Mapping[str, object]) -> Data:
    limits = settings.get(f"axis.{number}.limits.position", settings.get(f"axis.{number}.travel"))
    return {"number": number, "name": name, "range": limits}


# ------------------------------------------------------------------------------------------------------ its state


def state_of(play: Play, made: Data) -> Data:
    """Return the state of a play; `made` are the contents of its program. Called in the thread of the play."""
    machine = play.machine
    if machine is None:
        return {"t": 0.0, "mode": "starts"}
    now = play.shown
    controller = machine.controller
    is_at_rest = play.result is None and play.watch.is_at_rest(machine)
    return {
        "t": round(now, 5),
        "mode": _mode(play),
        "speed": play.pace.speed,
        "late": play.pace.is_late,
        "asks": play.asks,
        "question": None if play.question is None else plain(play.question),
        "end": "" if play.result is None else _end(play.result),
        "axes": [_axis_state(machine, each["number"], now) for each in made["axes"]],
        "inputs": {
            channel: value for channel, value in controller.inputs.values if channel < SHADOW and value
        },
        "read": sorted(play.watch.inputs),
        "values": _values(machine, made["inputs"]),
        "held": sorted(play.held),
        "pressed": sorted(play.record.pressed),
        "outputs": [
            each["number"] for each in made["outputs"] if controller.outputs.inverted(each["number"])
        ],
        "tasks": [] if play.result is not None else tasks_of(machine, play.watch, play.stopped),
        "stopped": [play.watch.line(at) for at in play.stopped.values()],
        "waits": play.watch.awaited(machine) if is_at_rest else [],
        "homing": seeking(machine, play.settings, dialect(play.program.language)),
        "moves": [
            [round(each.start_time, 3), each.axis, each.line] for each in machine.log.moves[-MAX_MOVES:]
        ],
        "moving": sorted(
            {each.line for each in machine.log.moves[-MAX_MOVES:] if each.axis in machine.controller.moving()}
        ),
        "pending": play.pending,
    }


def _mode(play: Play) -> str:
    if play.result is not None:
        return "fault" if play.result.status == "fault" else "ended"
    if play.question is not None:
        return "asks"
    if play.now < play.until:
        return "replays"
    return "paused" if play.is_paused else "runs"


def _end(result: Run) -> str:
    errors = [each for each in result.diagnostics if each.severity == "error"]
    if result.crash is not None:
        return f"internal error: {result.crash}"
    if errors:
        line = f"line {errors[0].line}: " if errors[0].line else ""
        return f"{line}{errors[0].message}" + (f"; {errors[0].hint}" if errors[0].hint else "")
    return {"ended": "the program has ended", "until": "the program has ended, and an axis moves on"}.get(
        result.status, f"the run is {result.status}"
    )


def warnings_of(play: Play) -> tuple[int, str]:
    """Return how often a run has warned, and its newest warning in words."""
    machine = play.machine
    found = [] if machine is None else [each for each in machine.diagnostics if each.severity == "warning"]
    if not found:
        return 0, ""
    newest = max(found, key=lambda each: each.last)
    where = f"line {newest.line}: " if newest.line else ""
    return sum(each.count for each in found), f"{where}{newest.message}; {newest.hint}"


def _axis_state(machine: Machine, number: int, now: float) -> list[object]:
    """Return position, velocity and target in user units, and the state in words."""
    axis = machine.controller.axes.get(number)
    if axis is None:
        return [0, 0, None, ""]
    scale = axis.scale
    position = scale.position_to_user(axis.position(now) if axis.feedback is None else axis.actual_position)
    target = scale.position_to_user(axis.target)
    words = [
        "homing" if axis.homing is not None else "homed" if axis.home is not None else "",
        f"error: {fault_names(axis.faults)}" if axis.faults else "",
        "" if axis.enabled else "off",
    ]
    velocity = axis.velocity(now) / (scale.counts or 1.0)
    return [
        round(position, 4) if isfinite(position) else None,
        round(velocity, 3),
        round(target, 4) if isfinite(target) and axis.is_moving else None,
        ", ".join(filter(None, words)),
    ]


def _values(machine: Machine, rows: Sequence[Data]) -> Data:
    """Return the present values of analogue inputs and of elements that a host writes."""
    with machine.controller.reads.replaced():
        return {
            f"{each['table']} {each['number']}": _value(machine, each)
            for each in rows
            if each["table"] != "input"
        }


def _value(machine: Machine, row: Data) -> object:
    """Return the present value of an analogue input, in percent, or of an element."""
    table, number = row["table"], row["number"]
    if table == "analogue":
        return round(machine.controller.analogue_inputs[number], 3)
    try:
        if table == "comms":
            return float(f"{machine.host.real(table, number):.7g}")
        return machine.host.integer(table, number) if table in MEMORY else None
    except Rejected:  # the controller has no such element
        return None

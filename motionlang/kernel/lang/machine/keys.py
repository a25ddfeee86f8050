"""The vocabulary of the machine file: all keys and tables, with kind and help.

`machine.toml` has plain keys (`controller.axes`), keys of an axis (`axis.0.travel`, `N` in the table) and
tables of events (`[[input]]`). Every key has a default.
"""

from __future__ import annotations

from motionlang.kernel.log.records import EVENTS

# The axes that a controller may have.
MAX_AXES = 64
# Other words for the last part of a key.
MEANT = {"velocity": "speed", "deceleration": "acceleration", "range": "position"}
# key -> (kind, help). A pair is two numbers, the first not above the second.
KEYS: dict[str, tuple[str, str]] = {
    "controller.model": (
        "text",
        "The controller model to simulate; empty for the one that the program implies.",
    ),
    "controller.axes": ("count", f"The number of axes, 1 to {MAX_AXES}."),
    "controller.instruction_time": ("time", "The machine time that one statement takes, 1e-9 to 1 second."),
    "run.until": (
        "time",
        "The time limit of the run, in seconds of machine time; the scenario ends there too.",
    ),
    "run.stop.event": (
        "stop event",
        "End the run at an event of this kind, or at an INPUT for which no answer is left: input.",
    ),
    "run.stop.prints": ("text", "End the run when a printed line contains this text."),
    "run.stop.line": (
        "line",
        "End the run when this line of the program has moved, waited, switched or printed.",
    ),
    "run.stop.times": ("times", "The number of times after which it ends; 1 by default."),
    "budget.time": ("positive", "The longest duration of the run allowed, in seconds; more is an error."),
    "budget.motion": ("positive", "The most motion on the critical path of the run, in seconds."),
    "budget.dwell": ("positive", "The most time in dwells such as WAIT on that path, in seconds."),
    "budget.settling": (
        "positive",
        "The most time spent waiting for axes to settle on that path, in seconds.",
    ),
    "budget.waiting": (
        "positive",
        "The most time spent waiting for inputs, tasks and people on that path, in seconds.",
    ),
    "budget.computing": ("positive", "The most time spent computing on that path, in seconds."),
    "improve.hold": (
        "names",
        "Numbers that `motionlang improve` keeps: SPEED[0]@9, or the name of a constant.",
    ),
    "axis.N.travel": ("pair", "The positions of the two limit switches, in user units."),
    "axis.N.forward_input": ("channel", "The input that shows the forward limit switch."),
    "axis.N.reverse_input": ("channel", "The input that shows the reverse limit switch."),
    "axis.N.home_switch": (
        "pair",
        "The two positions between which the home switch is active, in user units.",
    ),
    "axis.N.home_input": ("channel", "The input that shows the home switch."),
    "axis.N.enable_input": (
        "channel",
        "The input that enables the drive: while it is off, the drive is off and cannot be enabled.",
    ),
    "axis.N.index_every": ("positive", "The distance between index marks of the encoder, in user units."),
    "axis.N.motor": ("motor", "servo or stepper; on a MultiFlex a stepper starts with other settings."),
    "axis.N.guess": (
        "flag",
        "true: `motionlang init` has guessed the switches of this axis, and a result that depends on them says so.",
    ),
    "axis.N.start": (
        "number",
        "The position of the machine at power-up, measured from its own zero, in user units.",
    ),
    "axis.N.limits.position": (
        "pair",
        "The positions allowed, in user units, counted from the zero of the homed machine; `motionlang certify` shows "
        "how far the axis went.",
    ),
    "axis.N.limits.speed": ("positive", "The greatest speed allowed, in user units per second."),
    "axis.N.limits.acceleration": (
        "positive",
        "The greatest acceleration and deceleration allowed, in user units/s².",
    ),
    "axis.N.limits.jerk": (
        "positive",
        "The greatest jerk allowed, in user units/s³; the jerk of a trapezoid is infinite.",
    ),
    "axis.N.limits.torque": ("positive", "The greatest torque allowed for its simulated motor, N m."),
    "axis.N.limits.following_error": (
        "positive",
        "The greatest following error allowed for its simulated motor, in user units.",
    ),
    "mccl.codes.COMMAND": (
        "channel",
        "The numeric code of an MCCL command, such as TP = 12, for hosts that call `pmccmdex` of MCAPI. Only DW is "
        "known to have one, 253.",
    ),
    "mint.values.KEYWORD": (
        "reading",
        "The value of a Mint keyword that no simulation can know, such as DRIVEBUSVOLTS = 325, or "
        '{ "0" = 325, "1" = 326 } for each number in its brackets.',
    ),
    "mint.words.WORD": (
        "text",
        'The present name of a word of an older Mint, such as GAIN = "KPROP".',
    ),
    "assumptions.NAME": (
        "reading",
        "The behaviour of this controller where the sources leave a question open, such as "
        '"mint.homespeed-default" = 1000. [The list](contributing/assumptions.md) marks those that can be set.',
    ),
}
# The sections of a simulated motor and its servo loop; their keys are in `kernel/servo/settings.py`.
SERVO = ("axis.N.plant.", "axis.N.servo.")
# The section of a dialect, whose keys the dialect checks.
OF_DIALECTS = ("mint.values.", "mint.words.")
# Tables of events: table -> key -> (kind, help).
_WHEN = {
    "at": ("time", "Time of the event, in seconds of machine time."),
    "axis": ("channel", "The axis whose position triggers the entry."),
    "above": ("number", "Active from this position upwards, in user units."),
    "below": ("number", "Active from this position downwards, in user units."),
    "between": ("pair", "Active between these two positions, in user units."),
}
_ASKED = (
    "positive",
    "Instead: the time after which it happens once the program asks for it, in seconds.",
)
# When a key is pressed or another device writes.
_ACTS = {
    "at": _WHEN["at"],
    "every": ("positive", "The period of repetition, in seconds; at is the first time."),
    "times": (
        "times",
        "Number of times that it happens in total, 1 to 10000. Default: until the end of the run.",
    ),
    "output": ("channel", "Instead: the digital output after whose change it happens, each time."),
    "level": ("bit", "The level to which that output changes. Default 1."),
    "delay": ("time", "The delay after the output, in seconds. Default 0."),
    "asked": _ASKED,
}
_GUESS = ("flag", "true: `motionlang init` has guessed this entry, and a result that depends on it says so.")
_TERMINAL = ("terminal", "The terminal of the operator: 1, 2, 4 and so on up to 128. Default 1.")
_WRITTEN = {
    "value": ("number", "The value: a float in the comms array; elsewhere an integer if it is whole."),
    "as": ("view", "integer or float, to choose the type."),
    "text": (
        "text",
        "A text instead of a value: four characters per element, the first one in the highest byte.",
    ),
}
# What an entry of a table drives: the device, as keywords name it, and the key of its number, "" if it has none.
DRIVES = {
    "input": ("input", "channel"),
    "analogue": ("analogue input", "channel"),
    "comms": ("comms element", "element"),
    "netdata": ("network data", "element"),
    "modbus.register": ("Modbus register", "register"),
    "key": ("key", ""),
    "answer": ("answer", ""),
}
# The tables of a machine file that may occur several times: the kind and help of each key.
TABLES: dict[str, dict[str, tuple[str, str]]] = {
    "input": {
        "channel": ("channel", "The digital input."),
        "name": ("text", "A name for the input, for `run --input NAME=1@0.5`."),
        "value": ("level", "The level while active, 0 or 1. Default 1."),
        "for": ("positive", "Duration in seconds. Default: forever."),
        "every": ("positive", "The period of repetition: seconds, or with between user units."),
        "times": (
            "times",
            "Number of times that it happens in total, 1 to 10000. Default: until the end of the run; "
            "with between it is required.",
        ),
        "output": (
            "channel",
            "The digital output whose level the input follows; with for, whose change activates it.",
        ),
        "level": (
            "bit",
            "With output and for: the level to which the output changes. Default 1. With asked: the only level to "
            "which the input changes.",
        ),
        "delay": ("time", "The delay after the output, in seconds. Default 0."),
        "asked": _ASKED,
        **_WHEN,
        "guess": _GUESS,
    },
    "analogue": {
        "channel": ("channel", "The analogue input."),
        "name": ("text", "A name for the input, for `run --analog NAME=30`."),
        "value": ("percentage", "The value in percent, such as 25."),
        "per_unit": (
            "number",
            "With an axis: the rise per user unit, counted from above, below or the first position of between; "
            "sampled at 1 kHz.",
        ),
        "for": ("positive", "Duration in seconds. Default: forever."),
        "asked": _ASKED,
        "times": (
            "times",
            "With asked: number of times that it changes in total, 1 to 10000. Default: until the end of the run.",
        ),
        **_WHEN,
        "guess": _GUESS,
    },
    "remote": {
        "bus": ("bus", "The bus of the remote node. Default 1."),
        "node": ("node", "The remote node."),
        "channel": ("channel", "A digital input of the node."),
        "analogue": ("channel", "Instead: an analogue input."),
        "event": ("node event", "Instead: the new state of the node, live, dead or emergency."),
        "value": ("number", "The value: a level (default 1) or a percentage. An event has none."),
        "at": _WHEN["at"],
        "for": ("positive", "Time that an input keeps the value, in seconds. Default: forever."),
    },
    "bus": {
        "bus": ("bus", "The bus. Default 1."),
        "event": (
            "bus event",
            "The new state of the bus, operational, passive or off; or receive-overrun or transmit-overrun.",
        ),
        "at": _WHEN["at"],
    },
    "modbus.server": {
        "id": ("channel", "The number that the program uses for the server."),
        "first": ("register", "Its first register. Default 0."),
        "last": ("register", "Its last register; any beyond it are rejected. Default 65535."),
        "registers": ("registers", "The initial values of registers. Default 0."),
        "at": ("time", "Time at which the server begins to answer, in seconds. Default 0."),
        "for": ("positive", "Time that the server answers, in seconds. Default: forever."),
    },
    "modbus.register": {
        "server": ("channel", "The server."),
        "register": ("register", "The register, or the first of two."),
        "value": ("number", "The new value."),
        "as": (
            "width",
            "word (one register), integer or float (two). Default: word for a whole number, float for any other.",
        ),
        **_ACTS,
        "guess": _GUESS,
    },
    "fault": {
        "axis": ("channel", "The axis with the fault; none for controller."),
        "kind": (
            "fault",
            "The fault: following-error, error-input, forward-limit, reverse-limit, drive or controller.",
        ),
        "line": (
            "line",
            "The line of the program that triggers it, when it is reached for the first time.",
        ),
        **{key: _WHEN[key] for key in ("at", "above", "below")},
    },
    "key": {
        **_ACTS,
        "text": (
            "text",
            "The keys that the operator presses, for INKEY; {Enter}, {Esc} and {Tab} are keys, too.",
        ),
        "for": ("positive", "Time that the last key is held, in seconds, for READKEY. Default 0.1."),
        "terminal": _TERMINAL,
        "guess": _GUESS,
    },
    "encoder": {
        "channel": (
            "channel",
            "The encoder that something outside the controller turns, such as a conveyor.",
        ),
        "aux": ("channel", "Instead: an auxiliary encoder."),
        "velocity": ("number", "Its speed, in counts per second, until another entry changes it."),
        "accel": ("positive", "The acceleration to that speed, in counts/s². Default: at once."),
        "index_every": ("positive", "The distance between its index marks, in counts. Default: no marks."),
        "at": _WHEN["at"],
        "guess": _GUESS,
    },
    "answer": {
        "text": ("text", "The line that the operator types at the next INPUT."),
        "prompt": (
            "text",
            "Only for an INPUT whose question, or the line above it, contains this text. Default: any other INPUT.",
        ),
        "terminal": _TERMINAL,
        "guess": _GUESS,
    },
    "comms": {
        **_ACTS,
        "element": ("channel", "The element of the comms array that the host writes, 1 to 99."),
        **_WRITTEN,
        "guess": _GUESS,
    },
    "netdata": {
        **_ACTS,
        "element": ("channel", "The NetData location that the host writes, 0 to 999."),
        **_WRITTEN,
        "guess": _GUESS,
    },
    "expect": {
        "prints": ("text", "A printed line contains this text."),
        "never_prints": ("text", "No printed line contains this text."),
        "event": (
            "event",
            "An event of this kind occurs, such as limit or velocity jump; see [events.md](events.md).",
        ),
        "never_event": ("event", "No event of this kind occurs."),
        "after": ("time", "Only count lines and events at this time or later, in seconds."),
        "before": ("time", "Only count lines and events up to this time, in seconds."),
        "axis": ("channel", "The axis of the position or the event."),
        "position": ("number", "The position of the axis at the end of the run, in user units."),
        "at": ("time", "Instead: the position of the axis at this time, in seconds."),
        "time": ("time", "The time at which the run ends, in seconds."),
        "quantity": (
            "text",
            "A quantity of the run, such as cycle(12) or peak.0; `motionlang sweep --help` lists all.",
        ),
        "value": ("number", "The value of the quantity."),
        "at_least": ("number", "The least value of the quantity."),
        "at_most": ("number", "The greatest value of the quantity."),
        "within": ("positive", "The tolerance of the position, the time or the value. Default 1e-6."),
        "status": ("outcome", "Status at the end of the run: ended, until or fault."),
        "diagnostic": ("text", "The code of an error that the run ends with, such as never."),
    },
}
# The subject of an [[expect]] entry: exactly one of these keys, with the keys that it allows alongside.
EXPECTED: dict[str, tuple[str, ...]] = {
    "prints": ("after", "before"),
    "never_prints": ("after", "before"),
    "event": ("after", "before", "axis"),
    "never_event": ("after", "before", "axis"),
    "position": ("axis", "at", "within"),
    "time": ("within",),
    "quantity": ("value", "at_least", "at_most", "within"),
    "status": (),
    "diagnostic": (),
}
# The keys that an entry of each table must have.
REQUIRED = {
    "input": ("channel",),
    "analogue": ("channel", "value"),
    "remote": ("node",),
    "bus": ("event",),
    "modbus.server": ("id",),
    "modbus.register": ("server", "register", "value"),
    "fault": ("kind",),
    "key": ("text",),
    "encoder": ("velocity",),
    "answer": ("text",),
    "comms": ("element",),
    "netdata": ("element",),
    "expect": (),
}
# The keys that identify the subject of an entry, with their defaults. An entry of a scenario replaces the
# entries of the machine file with the same subject.
# Tables whose entries may have a name, which a scenario gives in place of the channel.
NAMED = ("input", "analogue")
ABOUT: dict[str, dict[str, object]] = {
    "input": {"channel": None},
    "analogue": {"channel": None},
    "remote": {"bus": 1, "node": None, "channel": None, "analogue": None, "event": None},
    "bus": {"bus": 1},
    "modbus.server": {"id": None},
    "modbus.register": {"server": None, "register": None},
    "fault": {"axis": None},
    "key": {"terminal": 1},
    "encoder": {"channel": None, "aux": None},
    "answer": {"terminal": 1},
    "comms": {"element": None},
    "netdata": {"element": None},
}  # fmt: skip
# The shortest period of an input that repeats until the end of the run, s: a shift has 2.9 million of them.
SHORTEST_PERIOD = 0.01
# The keys that identify the subject of a [[remote]] entry.
OF_A_NODE = ("channel", "analogue", "event")
STOPS = ("run.stop.event", "run.stop.prints", "run.stop.line")
LAST_REGISTER = 65535
LAST_LINE = 99_999_999
# The values of kinds that are a choice.
CHOICES: dict[str, tuple[object, ...]] = {
    "flag": ("true", "false"),
    "motor": ("servo", "stepper"),
    "fault": ("following-error", "error-input", "forward-limit", "reverse-limit", "drive", "controller"),
    "width": ("word", "integer", "float"),
    "node event": ("live", "dead", "emergency"),
    "bus event": ("operational", "passive", "off", "receive-overrun", "transmit-overrun"),
    "view": ("integer", "float"),
    "outcome": ("ended", "until", "stopped", "fault"),
    # Those of the log, and a question for which no answer is left.
    "stop event": (*EVENTS, "input"),
    "terminal": (1, 2, 4, 8, 16, 32, 64, 128),
}

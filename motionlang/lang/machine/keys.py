"""The vocabulary of the machine file: every key and every table, with its kind and its help.

`machine.toml` has plain keys (`controller.axes`), keys of an axis (`axis.0.travel`, `N` in the table) and tables of
things that happen (`[[input]]`). Every key has a default.
"""

from __future__ import annotations

MAX_AXES = 64
# key -> (kind, help). A pair is two numbers, the first not above the second.
KEYS: dict[str, tuple[str, str]] = {
    "controller.model": ("text", "The model to behave like; empty for the dialect's own default."),
    "controller.axes": ("count", f"The number of axes, 1 to {MAX_AXES}."),
    "controller.instruction_time": ("time", "What one statement costs, 1e-9 to 1 second of machine time."),
    "run.until": ("time", "The machine time at which the scenario, and with it the run, ends, in seconds."),
    "budget.time": ("positive", "How long the run may take, in seconds; more is an error."),
    "budget.motion": ("positive", "How long of the critical chain of the run may be motion, in seconds."),
    "budget.dwell": ("positive", "How long of it may be dwells such as WAIT, in seconds."),
    "budget.settling": ("positive", "How long of it may be waiting for axes that have arrived, in seconds."),
    "budget.waiting": ("positive", "How long of it may be waiting for inputs, tasks and people, in seconds."),
    "budget.computing": ("positive", "How long of it may be computing, in seconds."),
    "axis.N.travel": ("pair", "The positions of the two limit switches, in user units."),
    "axis.N.forward_input": ("channel", "The input that shows the forward limit switch."),
    "axis.N.reverse_input": ("channel", "The input that shows the reverse limit switch."),
    "axis.N.home_switch": ("pair", "From where to where the home switch is active, in user units."),
    "axis.N.home_input": ("channel", "The input that shows the home switch."),
    "axis.N.enable_input": (
        "channel",
        "The input without which the drive cannot be enabled; it goes off with it.",
    ),
    "axis.N.index_every": ("positive", "The distance between index marks of the encoder, in user units."),
    "axis.N.motor": ("motor", "servo or stepper: on a MultiFlex a stepper has other settings at power-up."),
    "axis.N.start": (
        "number",
        "Where the machine stands at power-up, measured from its own zero, in user units.",
    ),
    "axis.N.limits.position": (
        "pair",
        "Where the machine may be, in user units; `run --certify` tells how far it went.",
    ),
    "axis.N.limits.speed": ("positive", "How fast it may be, in user units a second."),
    "axis.N.limits.acceleration": (
        "positive",
        "Its greatest acceleration and deceleration, in user units/s².",
    ),
    "axis.N.limits.jerk": ("positive", "Its greatest jerk, in user units/s³; a trapezoid's is infinite."),
    "axis.N.limits.torque": ("positive", "The greatest torque of its simulated motor, N m."),
    "axis.N.limits.following_error": (
        "positive",
        "The greatest following error of its simulated motor, in user units.",
    ),
    "mint.readings.WORD": (
        "reading",
        "What a word of Mint reads whose value this program cannot know, such as DRIVEBUSVOLTS = 325, or "
        '{ "0" = 325, "1" = 326 } by what stands in its brackets.',
    ),
    "readings.NAME": (
        "reading",
        "How this controller answers a question that the sources leave open, such as "
        '"mint.homespeed-default" = 1000: one of the readings of [fidelity.md](fidelity.md) that can be set. '
        "`motionlang probe` finds them.",
    ),
}
# The sections of a simulated motor and its loop; their keys are in `servo/settings.py`.
SERVO = ("axis.N.plant.", "axis.N.servo.")
# The section of a dialect, whose words are the dialect's business.
OF_DIALECTS = ("mint.readings.",)
# Tables of things that happen: table -> key -> (kind, help).
_WHEN = {
    "at": ("time", "The machine time at which it happens, in seconds."),
    "axis": ("channel", "The axis whose position decides."),
    "above": ("number", "Active from this position on, in user units."),
    "below": ("number", "Active up to this position, in user units."),
    "between": ("pair", "Active from the first position to the second, in user units."),
}
_TERMINAL = ("terminal", "The terminal at which that is done: 1, 2, 4 and so on up to 128; 1 unless given.")
_WRITTEN = {
    "value": ("number", "The value: a float in the comms array, elsewhere an integer where it is whole."),
    "as": ("view", "integer or float, to have it otherwise."),
    "text": ("text", "A text instead of a value, four characters an element, the first one highest."),
}
TABLES: dict[str, dict[str, tuple[str, str]]] = {
    "input": {
        "channel": ("channel", "The digital input."),
        "value": ("number", "The value while active, 1 unless given."),
        "for": ("positive", "How long it stays so, in seconds; for ever unless given."),
        "every": ("positive", "Again so many seconds later, or with between so many user units further on."),
        "times": ("times", "How often it happens then, the first time included, 1 to 10000."),
        "output": ("channel", "The digital output whose level it follows."),
        "delay": ("time", "How long after the output, in seconds; at once unless given."),
        **_WHEN,
    },
    "analogue": {
        "channel": ("channel", "The analogue input."),
        "value": ("number", "The value in percent."),
        "per_unit": (
            "number",
            "With an axis: what each user unit adds, from above, below or the first of between on; sampled at 1 kHz.",
        ),
        "for": ("positive", "How long it stays so, in seconds; for ever unless given."),
        **_WHEN,
    },
    "remote": {
        "bus": ("bus", "The bus of the remote node, 1 unless given."),
        "node": ("node", "The remote node."),
        "channel": ("channel", "Its digital input."),
        "analogue": ("channel", "Its analogue input, instead."),
        "encoder": ("channel", "Its encoder, instead."),
        "element": ("channel", "The element of its comms array, instead, 1 to 99."),
        "object": ("register", "The object of its dictionary, instead, such as 0x6041."),
        "sub": ("channel", "The sub-index of the object, 0 unless given."),
        "event": ("node event", "What becomes of the node, instead: live, dead or emergency."),
        "value": ("number", "The value: 1 unless given, percent, counts, or the code of the emergency."),
        "at": _WHEN["at"],
        "for": ("positive", "How long an input stays so, in seconds; for ever unless given."),
    },
    "bus": {
        "bus": ("bus", "The bus, 1 unless given."),
        "event": (
            "bus event",
            "operational, passive or off, which the bus then is; receive-overrun or transmit-overrun.",
        ),
        "at": _WHEN["at"],
    },
    "pdo": {
        "bus": ("bus", "The bus, 1 unless given."),
        "cobid": ("register", "The identifier of the process data, such as 0x182."),
        "bank": ("bit", "Its lower 32 bits, 0, as unless given, or its upper ones, 1."),
        "value": ("number", "What it brings."),
        "at": _WHEN["at"],
    },
    "modbus.server": {
        "id": ("channel", "The number by which the program knows the server."),
        "first": ("register", "Its first register, 0 unless given."),
        "last": ("register", "Its last register, 65535 unless given; others are refused."),
        "registers": ("registers", "What registers hold from the beginning, 0 unless given."),
        "at": ("time", "From when on it answers, in seconds; from the beginning unless given."),
        "for": ("positive", "How long it answers, in seconds; for ever unless given."),
    },
    "modbus.register": {
        "server": ("channel", "The server in which something changes."),
        "register": ("register", "The register, or the first of the two."),
        "value": ("number", "The value from then on."),
        "as": (
            "width",
            "word, one register; integer or float, two. A whole number is a word, another one a float.",
        ),
        "at": _WHEN["at"],
    },
    "coil": {
        "coil": ("register", "The coil of the controller that a Modbus client writes."),
        "value": ("number", "The value, 1 unless given."),
        "at": _WHEN["at"],
        "for": ("positive", "How long it stays so, in seconds; for ever unless given."),
    },
    "fault": {
        "axis": ("channel", "The axis that suffers it; none for controller."),
        "kind": ("fault", "following-error, error-input, forward-limit, reverse-limit, drive or controller."),
        "value": ("channel", "The bits that DRIVEERROR and MISCERROR then show; 1 unless given."),
        "line": (
            "line",
            "The line of the program that brings it about, when it is reached for the first time.",
        ),
        **{key: _WHEN[key] for key in ("at", "above", "below")},
    },
    "key": {
        "at": _WHEN["at"],
        "text": ("text", "Keys that the operator presses, for INKEY."),
        "for": ("positive", "How long the last one is held, in seconds, for READKEY; 0.1 unless given."),
        "terminal": _TERMINAL,
    },
    "encoder": {
        "channel": ("channel", "The encoder that something in the world turns, such as a conveyor."),
        "aux": ("channel", "The auxiliary encoder, instead."),
        "velocity": ("number", "How fast it turns, in counts a second, until another entry says otherwise."),
        "accel": ("positive", "How fast it comes to that, in counts/s²; at once unless given."),
        "index_every": ("positive", "The distance between its index marks, in counts; none unless given."),
        "at": _WHEN["at"],
    },
    "answer": {"text": ("text", "What the operator types at the next INPUT."), "terminal": _TERMINAL},
    "serial": {
        "port": ("port", "The serial port, 1 unless given."),
        "text": ("text", "The characters that come in there, for SERIALCHAR."),
        "at": _WHEN["at"],
    },
    "comms": {
        "at": _WHEN["at"],
        "element": ("channel", "The element of the comms array that the host writes, 1 to 99."),
        **_WRITTEN,
    },
    "dpr": {
        "at": _WHEN["at"],
        "address": ("dpr", "The address of the dual-port RAM that the host writes, 0 to 4095."),
        **_WRITTEN,
    },
    "netdata": {
        "at": _WHEN["at"],
        "element": ("channel", "The NetData location that the host writes, 0 to 999."),
        **_WRITTEN,
    },
    "expect": {
        "prints": ("text", "A line that is printed has this in it."),
        "never_prints": ("text", "No line has."),
        "event": (
            "event",
            "Something of this kind happens, such as limit or velocity jump: see [events.md](events.md).",
        ),
        "never_event": ("event", "Nothing of this kind does."),
        "after": ("time", "The line is printed, or it happens, at this time or later, in seconds."),
        "before": ("time", "It is printed, or happens, by this time."),
        "axis": ("channel", "The axis that stands at the position, or that it happens to."),
        "position": ("number", "Where it stands at the end, in user units."),
        "at": ("time", "It stands there at this time instead."),
        "time": ("time", "When the run ends, in seconds."),
        "within": ("positive", "How far off the position or the time may be; a millionth unless given."),
        "status": ("outcome", "How the run ends: ended, until or fault."),
        "diagnostic": ("text", "The code of a mistake that the run ends with, such as never."),
    },
}
# What an entry of [[expect]] is about: one of these, with what else may stand beside it.
EXPECTED: dict[str, tuple[str, ...]] = {
    "prints": ("after", "before"),
    "never_prints": ("after", "before"),
    "event": ("after", "before", "axis"),
    "never_event": ("after", "before", "axis"),
    "position": ("axis", "at", "within"),
    "time": ("within",),
    "status": (),
    "diagnostic": (),
}
OUTCOMES = ("ended", "until", "fault")
REQUIRED = {
    "input": ("channel",),
    "analogue": ("channel", "value"),
    "remote": ("node",),
    "bus": ("event",),
    "pdo": ("cobid", "value"),
    "modbus.server": ("id",),
    "modbus.register": ("server", "register", "value"),
    "coil": ("coil",),
    "fault": ("kind",),
    "key": ("text",),
    "encoder": ("velocity",),
    "answer": ("text",),
    "serial": ("text",),
    "comms": ("element",),
    "netdata": ("element",),
    "dpr": ("address",),
    "expect": (),
}
# What an entry of a table is about, with what it is where that is not said: a scenario's stand in the place of those
# about the same.
ABOUT: dict[str, dict[str, object]] = {
    "input": {"channel": None},
    "analogue": {"channel": None},
    "remote": {"bus": 1, "node": None, "channel": None, "analogue": None, "encoder": None, "element": None,
               "object": None, "sub": 0, "event": None},
    "bus": {"bus": 1},
    "pdo": {"bus": 1, "cobid": None, "bank": 0},
    "modbus.server": {"id": None},
    "modbus.register": {"server": None, "register": None},
    "coil": {"coil": None},
    "fault": {"axis": None},
    "key": {"terminal": 1},
    "encoder": {"channel": None, "aux": None},
    "answer": {"terminal": 1},
    "serial": {"port": 1},
    "comms": {"element": None},
    "dpr": {"address": None},
    "netdata": {"element": None},
}  # fmt: skip
VIEWS = ("integer", "float")
TERMINALS = (1, 2, 4, 8, 16, 32, 64, 128)
WIDTHS = ("word", "integer", "float")
NODE_EVENTS = ("live", "dead", "emergency")
BUS_EVENTS = ("operational", "passive", "off", "receive-overrun", "transmit-overrun")
# What an entry of [[remote]] is about.
OF_A_NODE = ("channel", "analogue", "encoder", "element", "object", "event")
LAST_REGISTER = 65535
LAST_LINE = 99_999_999
MOTORS = ("servo", "stepper")
FAULT_KINDS = ("following-error", "error-input", "forward-limit", "reverse-limit", "drive", "controller")

"""Buffer entries other than moves (dwells and outputs), and move triggers."""

from __future__ import annotations

from collections.abc import Callable

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.watch import Watch, begin, end
from motionlang.kernel.lang.keyword import BANK, Actions, Keyword, constant
from motionlang.kernel.mint.keywords.axis_settings import StoredSettings, setting_reader, setting_writer
from motionlang.kernel.mint.keywords.following_masters import master
from motionlang.kernel.mint.keywords.io_inputs import LAST_CHANNEL, Inputs, checked
from motionlang.kernel.mint.keywords.motion import refuse_stopping
from motionlang.kernel.mint.runtime.binding import Maker, Operation, axis_of, check, of
from motionlang.kernel.mint.runtime.environment import Environment

AUTO, AT_GO, AT_INPUT, AT_POSITION = range(4)
_DEFAULTS = {"TRIGGERMODE": AT_GO, "TRIGGERINPUT": -1}


class Triggers(StoredSettings):
    """TRIGGERMODE of every axis, and the settings that it uses."""

    defaults = _DEFAULTS

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self._watches: dict[int, tuple[Axis, Watch]] = {}
        # TRIGGERVALUE in counts if it is a position of an axis. The counts do not change with the scale.
        self._trigger_counts: dict[int, float] = {}
        environment.controller.listeners.append(self._rescaled)
        environment.component(Inputs).listeners.append(self._changed)
        environment.loaded = self.loaded

    def set(self, name: str, axis: int, value: float) -> None:
        """Change a trigger setting at once, also for moves that are already loaded."""
        super().set(name, axis, value)
        watched = self._watched_axis(axis)
        if name not in ("TRIGGERINPUT", "TRIGGERMODE") and watched is not None:
            self._trigger_counts[axis] = watched.scale.position_to_counts(self.setting("TRIGGERVALUE", axis))
        self._watch(axis)

    def _watched_axis(self, axis: int) -> Axis | None:
        """Return the axis whose position triggers moves, None if an encoder does."""
        if self.setting("TRIGGERSOURCE", axis):
            return None
        return self.controller.axes.get(int(self.setting("TRIGGERCHANNEL", axis)))

    def _rescaled(self, what: str, channel: int) -> None:
        """Recompute TRIGGERVALUE in user units after a change of scale; the counts stay."""
        if what != "scale":
            return
        for axis, counts in self._trigger_counts.items():
            watched = self._watched_axis(axis)
            if watched is not None and watched.index == channel:
                self._settings["TRIGGERVALUE", axis] = watched.scale.position_to_user(counts)

    def loaded(self, axis: int) -> None:
        """Start the axis if loading a move triggers it."""
        if self.setting("TRIGGERMODE", axis) == AUTO:
            self.controller.go((axis,))

    def default(self, axis: int) -> None:
        """Reset the axis to its defaults (DEFAULT)."""
        super().default(axis)
        self._trigger_counts.pop(axis, None)
        self._watch(axis)

    def _start(self, axis: int) -> None:
        if self.controller.axes[axis].buffer:
            self.controller.go((axis,))

    def _changed(self, channel: int, on: bool) -> None:
        for (name, axis), mode in list(self._settings.items()):
            starts = on and name == "TRIGGERMODE" and mode == AT_INPUT
            if starts and self.setting("TRIGGERINPUT", axis) == channel:
                self._start(axis)

    def _watch(self, axis: int) -> None:
        """Watch for the position that starts the moves of an axis, if there is one."""
        track, watch = self._watches.pop(axis, (None, None))
        if track is not None and watch is not None:
            end(track, watch)
        if self.setting("TRIGGERMODE", axis) != AT_POSITION:
            return

        found = master(self.environment, int(self.setting("TRIGGERSOURCE", axis)),
                       int(self.setting("TRIGGERCHANNEL", axis)))  # fmt: skip
        counts = found.to_counts(self.setting("TRIGGERVALUE", axis))
        made = Watch(counts, lambda _: self._start(axis), False)
        begin(found.track, made)
        self._watches[axis] = found.track, made


def read_status(environment: Environment, axis: int) -> int:
    """MOVEBUFFERSTATUS: return the status bits.

    The first three bits concern the move that is executing.
    """
    controller = environment.controller
    a = controller.axes[axis]
    bits = (not a.buffer) << 3 | (controller.room(axis) <= 0) << 4
    if a.move is None:
        return bits
    at_rest = a.suspended and not a.velocity(controller.clock.now)
    run = getattr(a.move.action, "run", None)
    contour = run is not None and run.axes[0].contour_mode
    bits |= (a.move.speed is not None) << 0 | a.move.overridden << 1 | contour << 2 | at_rest << 5
    return bits | (run is not None and run.stops_at_corner) << 6


def loads(kind: type, put: Callable[..., None]) -> Maker:
    """Make an operation that loads a move; it returns True while the buffer is full.

    `put` receives the component `kind` of the environment, the row, the axis, …, the value and the line.
    """

    def made(environment: Environment, row: Keyword) -> Operation:
        room = environment.controller.room
        owner: object = environment.component(kind)

        def load(axis: int, *arguments: float) -> bool:
            axis_of(environment, axis)
            refuse_stopping(environment, axis)
            if room(axis) <= 0:
                return True
            put(owner, row, axis, *arguments)
            if environment.loaded is not None:
                environment.loaded(axis)
            return False

        return load

    return made


def put_dwell(environment: Environment, row: Keyword, axis: int, milliseconds: float, line: int) -> None:
    """MOVEDWELL: load a rest between two moves, in ms."""
    check(row, milliseconds)
    environment.controller.load_dwell(axis, milliseconds / 1000.0, row.name, line)


def put_bank(environment: Environment, row: Keyword, axis: int, bank: int, bits: int, line: int) -> None:
    """MOVEOUT: load the state of a bank of outputs, set between two moves."""
    first = checked(bank, LAST_CHANNEL // BANK, "bank") * BANK
    values = {first + k: bits >> k & 1 for k in range(BANK)}
    environment.controller.load_output(axis, values, row.name, line)


def put_bit(environment: Environment, row: Keyword, axis: int, channel: int, value: int, line: int) -> None:
    """MOVEOUTX: load the state of one output, set between two moves."""
    values = {checked(channel, LAST_CHANNEL, "output"): int(value != 0)}
    environment.controller.load_output(axis, values, row.name, line)


def put_pulse(
    environment: Environment, row: Keyword, axis: int, channel: int, milliseconds: float, line: int
) -> None:
    """MOVEPULSEOUTX: load an output pulse in ms, which begins between two moves."""
    check(row, milliseconds)
    output = checked(channel, LAST_CHANNEL, "output")
    environment.controller.load_pulse(axis, output, milliseconds / 1000.0, row.name, line)


# ------------------------------------------------------------------------------------------------- keywords

_TRIGGER = Actions(read=setting_reader(Triggers), write=setting_writer(Triggers))

_MAX_VALUE = 8388607.0
_TRIGGERS = (
    ("AUTO", "a move starts as soon as it is loaded"),
    ("GO", "moves start at GO"),
    ("INPUT", "moves start when the input TRIGGERINPUT becomes active"),
    ("POSITION", "moves start when the axis or encoder TRIGGERCHANNEL passes TRIGGERVALUE"),
)
_CONSTANTS = tuple(
    constant(f"_tr{name}", value, f"TRIGGERMODE: {help}.")
    for value, (name, help) in enumerate(_TRIGGERS)
)  # fmt: skip


def _trigger(
    name: str,
    actions: Actions,
    unit: str,
    help: str,
    low: float,
    high: float,
    default: float,
    selects: str = "",
) -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", unit, actions, help, f"{name}(0) = 1\nPRINT {name}(0)",
                   default=default, low=low, high=high, group="buffer", selects=selects)  # fmt: skip


ROWS = (
    *_CONSTANTS,
    Keyword("MOVEBUFFERID", "MBI", "setting", "RW", "axis", "integer", "move_id",
            "The mark that moves loaded from now on carry, a number of 16 bits.",
            "MOVEBUFFERID(0) = 7\nMOVER(0) = 10\nGO(0)\nPRINT MOVEBUFFERIDLAST(0)",
            default=0.0, low=-32768.0, high=32767.0, group="buffer"),
    Keyword("MOVEBUFFERIDLAST", "", "reading", "R", "axis", "integer",
            Actions(read=of(Environment, lambda e, axis: e.controller.move_id(axis))),
            "The mark of the move that is executing, or of the last one.",
            "MOVEBUFFERID(0) = 7\nMOVER(0) = 10\nGO(0)\nPRINT MOVEBUFFERIDLAST(0)", default=0.0, group="buffer"),
    Keyword("MOVEBUFFERSTATUS", "MBS", "reading", "R", "axis", "bits", Actions(read=of(Environment, read_status)),
            "Status of the moves: bit 0 the move has a speed of its own (FEEDRATEMODE), 1 the override holds for it, "
            "2 it is run through as a contour, 3 the buffer is empty, 4 full, 5 suspended and at rest, 6 the move ends "
            "at rest because of the angle to the next.",
            "MOVER(0) = 10\nPRINT MOVEBUFFERSTATUS(0)\nGO(0)", default=8.0, low=0, high=119, group="buffer"),
    Keyword("MOVEBUFFERLOW", "", "setting", "RW", "axis", "integer", "buffer_low",
            "The event MBLOW comes when an entry leaves the buffer and more places than this are free; -1 for never.",
            "MOVEBUFFERLOW(0) = 1\nPRINT MOVEBUFFERLOW(0)", default=-1.0, low=-1, high=100, group="buffer"),
    Keyword("TRIGGERMODE", "", "setting", "RW", "axis", "integer", _TRIGGER,
            "Trigger of moves: _trAUTO at once when they are loaded, _trGO at GO, _trINPUT at the input "
            "TRIGGERINPUT, _trPOSITION when TRIGGERCHANNEL passes TRIGGERVALUE. GO starts them in every "
            "mode.",
            "TRIGGERMODE(0) = _trAUTO\nMOVER(0) = 10\nPAUSE IDLE(0)\nPRINT POS(0)",
            default=1.0, low=0, high=3, group="buffer", effect="hands-over switch"),
    _trigger("TRIGGERINPUT", _TRIGGER, "integer", "The input that starts moves; -1 for none.", -1, 999,
             -1.0, selects="input"),
    _trigger("TRIGGERSOURCE", _TRIGGER, "integer",
             "Type of TRIGGERCHANNEL: 0 an axis, 1 an encoder, 2 an auxiliary encoder.", 0, 2, 0.0),
    _trigger("TRIGGERCHANNEL", _TRIGGER, "integer", "The axis or encoder whose position starts moves.",
             0, 999, 0.0),
    _trigger("TRIGGERVALUE", _TRIGGER, "number",
             "The position, in units of TRIGGERCHANNEL, whose passing starts moves.", -_MAX_VALUE, _MAX_VALUE, 0.0),
    Keyword("MOVEDWELL", "", "move", "W", "axis", "ms", Actions(load=loads(Environment, put_dwell)),
            "Put a rest of some milliseconds between moves into the buffer.",
            "MOVER(0) = 10\nMOVEDWELL(0) = 250\nGO(0)\nPAUSE IDLE(0)\nPRINT TIME >= 250",
            low=0, high=2147483647.0, group="motion", effect="entry"),
    Keyword("MOVEOUT", "", "move", "W", "axis, bank", "bits", Actions(load=loads(Environment, put_bank)),
            "Set a bank of outputs between two moves of the buffer.",
            "MOVER(0) = 10\nMOVEOUT(0, 0) = 5\nGO(0)\nPAUSE IDLE(0)\nPRINT OUT(0)", group="motion", effect="entry",
            channel="output bank"),
    Keyword("MOVEOUTX", "", "move", "W", "axis, channel", "bool", Actions(load=loads(Environment, put_bit)),
            "Set one output between two moves of the buffer.",
            "MOVER(0) = 10\nMOVEOUTX(0, 3) = _ON\nGO(0)\nPAUSE IDLE(0)\nPRINT OUTX(3)", group="motion", effect="entry",
            channel="output"),
    Keyword("MOVEPULSEOUTX", "", "move", "W", "axis, channel", "ms", Actions(load=loads(Environment, put_pulse)),
            "Turn an output on for some milliseconds, between two moves of the buffer; they do not wait for its end.",
            "MOVER(0) = 10\nMOVEPULSEOUTX(0, 3) = 50\nGO(0)\nPAUSE IDLE(0)\nPRINT OUTX(3)\nWAIT = 50\nPRINT OUTX(3)",
            low=0, high=2147483647.0, group="motion", effect="entry", channel="output"),
)  # fmt: skip

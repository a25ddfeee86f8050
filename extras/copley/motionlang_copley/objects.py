"""The CANopen objects of the simulated drive, with the effects of access to each.

`OBJECTS` is the table; the node's object dictionary, the documentation and the checks derive from it. This
file does not depend on CAN: `ObjectServer` executes reads and writes, and `Abort` carries the SDO abort code.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from motionlang.lab.pvt.drive import packet
from motionlang.lab.pvt.drive.point import MAX_TIME
from motionlang_copley.buffer import BufferedPoint, entry_of
from motionlang_copley.drive import IDLE, MOVING, STOPPING, WAITING, Drive
from motionlang_copley.modes import (
    HALT,
    HOMING,
    METHODS,
    PROFILE_POSITION,
    PROFILE_VELOCITY,
    REFERENCE_LIMIT,
    SPEED_UNIT,
    START,
    ProfileModes,
)
from motionlang_copley.switches import Switches

# The states of DS402, and the bits of the status word of each.
DISABLED, READY, ON, ENABLED, QUICK_STOP, FAULT = range(6)
STATUS = (0x40, 0x21, 0x23, 0x27, 0x07, 0x08)
SWITCH_ON, VOLTAGE, NO_QUICK_STOP, ENABLE, RESET = 1, 2, 4, 8, 0x80
# Mode of operation (object 0x6060) in which the drive accepts PVT points.
INTERPOLATED_POSITION = 7
MODES = (PROFILE_POSITION, PROFILE_VELOCITY, HOMING, INTERPOLATED_POSITION)
# Object 0x6502 has bit n - 1 for mode n.
SUPPORTED = sum(1 << mode - 1 for mode in MODES)
# Values at power-up: 10 000 counts/s, 100 000 counts/s², homing at 5000 and 500 counts/s.
DEFAULTS: dict[tuple[int, int], int] = {
    (0x6040, 0): 0,
    (0x605A, 0): 2,
    (0x6060, 0): 0,
    (0x607A, 0): 0,
    (0x607C, 0): 0,
    (0x6081, 0): 100_000,
    (0x6083, 0): 10_000,
    (0x6084, 0): 10_000,
    (0x6086, 0): 0,
    (0x6098, 0): 0,
    (0x6099, 1): 50_000,
    (0x6099, 2): 5000,
    (0x609A, 0): 10_000,
    (0x60C0, 0): 0,
    (0x60C1, 1): 0,
    (0x60C1, 2): 0,
    (0x60C1, 3): 0,
    (0x60C2, 1): 1,
    (0x60C2, 2): -3,
    (0x60FF, 0): 0,
}
SUB_MODES: dict[int, str] = {
    0: "linear, fixed time of 0x60C2 steered by one servo period, starts after three new points",
    -1: "linear, fixed time of 0x60C2",
    -2: "linear, the time of each point written with it",
    -3: "cubic, the time and velocity of each point written with it",
}
FIXED_TIME = (0, -1)
# The sub-index of 0x60C1 that copies the record into the buffer when it is written.
TRIGGERS: dict[int, int] = {0: 1, -1: 1, -2: 2, -3: 3}

VALUE_RANGE = 0x06090030
DEVICE_STATE = 0x08000022
READ_ONLY = 0x06010002
WRITE_ONLY = 0x06010001
LENGTH = 0x06070010


class Abort(Exception):
    """The drive rejects a read or write with this SDO abort code."""

    def __init__(self, code: int, reason: str) -> None:
        super().__init__(reason)
        self.code = code


@dataclass(frozen=True, slots=True)
class Object:
    """One object, or one sub-index of it.

    `kind` is i or u followed by the number of bits, or bytes8. `access` is r, w or rw.
    """

    index: int
    sub: int
    name: str
    kind: str
    access: str
    unit: str
    help: str
    source: str = "note"


OBJECTS: tuple[Object, ...] = (
    Object(0x2010, 0, "PVT data", "bytes8", "w", "", "a point or a buffer command in one frame", "manual"),
    Object(0x2011, 0, "Trajectory buffer free count", "u16", "r", "points", "free positions of the buffer"),
    Object(
        0x2012, 0, "Trajectory buffer status", "u32", "r", "", "next number, free, errors, empty", "manual"
    ),
    Object(0x2013, 0, "Next trajectory segment ID", "u16", "r", "", "number of the next segment", "manual"),
    Object(0x6040, 0, "Control word", "u16", "rw", "", "bits 0-3 switch the drive on, bit 4 starts", "DS402"),
    Object(0x6041, 0, "Status word", "u16", "r", "", "state; bit 12: interpolated motion active", "DS402"),
    Object(0x6060, 0, "Mode of operation", "i8", "rw", "", "7: interpolated position", "DS402"),
    Object(0x6061, 0, "Mode of operation display", "i8", "r", "", "the mode in force", "DS402"),
    Object(0x6062, 0, "Position demand value", "i32", "r", "counts", "the commanded position", "DS402"),
    Object(0x6064, 0, "Position actual value", "i32", "r", "counts", "no motor: the commanded one", "DS402"),
    Object(
        0x6085, 0, "Quick stop deceleration", "u32", "rw", "10 counts/s2", "brakes aborted moves", "DS402"
    ),
    Object(0x603F, 0, "Error code", "u16", "r", "", "the last error; 0 after a reset", "DS402"),
    Object(
        0x605A,
        0,
        "Quick stop option code",
        "i16",
        "rw",
        "",
        "2: brake and disable; 6: brake and stay",
        "DS402",
    ),
    Object(0x6063, 0, "Position internal value", "i32", "r", "counts", "like 0x6064", "DS402"),
    Object(0x606B, 0, "Velocity demand value", "i32", "r", "0.1 counts/s", "the commanded velocity", "DS402"),
    Object(
        0x606C, 0, "Velocity actual value", "i32", "r", "0.1 counts/s", "no motor: the commanded one", "DS402"
    ),
    Object(0x607A, 0, "Target position", "i32", "rw", "counts", "of the next set-point", "DS402"),
    Object(0x607C, 0, "Home offset", "i32", "rw", "counts", "the home position becomes minus this", "DS402"),
    Object(0x6081, 0, "Profile velocity", "u32", "rw", "0.1 counts/s", "speed of set-points", "DS402"),
    Object(
        0x6083,
        0,
        "Profile acceleration",
        "u32",
        "rw",
        "10 counts/s2",
        "of set-points and velocities",
        "DS402",
    ),
    Object(
        0x6084,
        0,
        "Profile deceleration",
        "u32",
        "rw",
        "10 counts/s2",
        "of set-points and velocities",
        "DS402",
    ),
    Object(0x6086, 0, "Motion profile type", "i16", "rw", "", "0: trapezoid", "DS402"),
    Object(0x6098, 0, "Homing method", "i8", "rw", "", "1, 2, 17 to 20, 33, 34, 35 or 37", "DS402"),
    Object(
        0x6099, 1, "Homing speed search for switch", "u32", "rw", "0.1 counts/s", "towards a switch", "DS402"
    ),
    Object(
        0x6099,
        2,
        "Homing speed search for zero",
        "u32",
        "rw",
        "0.1 counts/s",
        "off a switch and to an index",
        "DS402",
    ),
    Object(0x609A, 0, "Homing acceleration", "u32", "rw", "10 counts/s2", "of all stages of homing", "DS402"),
    Object(0x60FD, 0, "Digital inputs", "u32", "r", "", "bits 0, 1: limit switches; 2: home switch", "DS402"),
    Object(
        0x60FF, 0, "Target velocity", "i32", "rw", "0.1 counts/s", "followed in profile velocity", "DS402"
    ),
    Object(0x6502, 0, "Supported drive modes", "u32", "r", "", "a bit for each: 1, 3, 6 and 7", "DS402"),
    Object(0x60C0, 0, "Interpolation sub-mode select", "i16", "rw", "", "one of the four sub-modes"),
    Object(
        0x60C1, 1, "Interpolation position", "i32", "rw", "counts", "position; in 0 and -1 adds the point"
    ),
    Object(0x60C1, 2, "Interpolation time", "u8", "rw", "ms", "time; in -2 adds the point"),
    Object(
        0x60C1, 3, "Interpolation velocity", "i32", "rw", "0.1 counts/s", "velocity; in -3 adds the point"
    ),
    Object(
        0x60C2, 1, "Interpolation time units", "u8", "rw", "10^x s", "the fixed time in units of sub-index 2"
    ),
    Object(
        0x60C2, 2, "Interpolation time index", "i8", "rw", "", "x, -3 (milliseconds) to -6 (microseconds)"
    ),
)
BY_ADDRESS: dict[tuple[int, int], Object] = {(o.index, o.sub): o for o in OBJECTS}


class ObjectServer:
    """The objects of one drive.

    `power` is its state in the state machine of `states`. `emergency` is called with the code of an error, and
    `complain` with the reason of one that is not a fault.
    """

    def __init__(self, drive: Drive, switches: Switches | None = None) -> None:
        self.drive = drive
        self.power = DISABLED
        self.values: dict[tuple[int, int], int] = dict(DEFAULTS)
        self.emergency: Callable[[int], None] = lambda code: None
        self.complain: Callable[[str], None] = lambda text: None
        self.error = 0
        self._switches = switches or Switches()
        self._modes = ProfileModes(drive, self.values, self._switches, self._report)
        drive.steering = True
        self._reads: dict[int, Callable[[], int]] = {
            0x2011: lambda: self.drive.buffer.free,
            0x2012: lambda: packet.encode_status(self.drive.buffer.status),
            0x2013: lambda: self.drive.buffer.next_number,
            0x6041: self._status_word,
            0x6061: lambda: self.values[0x6060, 0],
            0x6062: self._position,
            0x6063: self._position,
            0x6064: self._position,
            0x606B: self._velocity,
            0x606C: self._velocity,
            0x603F: lambda: self.error,
            0x60FD: lambda: self._switches.inputs(self.drive.position + self.drive.datum),
            0x6502: lambda: SUPPORTED,
            0x6085: lambda: round(self.drive.abort_deceleration / 10.0),
        }
        self._writes: dict[int, Callable[[int, int], None]] = {
            0x6040: self._control,
            0x605A: partial(self._choose, 0x605A, (2, 6)),
            0x6060: self._choose_mode,
            0x607A: partial(self._store, 0x607A),
            0x607C: partial(self._store, 0x607C),
            0x6081: partial(self._store_positive, 0x6081),
            0x6083: partial(self._store_positive, 0x6083),
            0x6084: partial(self._store_positive, 0x6084),
            0x6086: partial(self._choose, 0x6086, (0,)),
            0x6098: partial(self._choose, 0x6098, (0, *METHODS)),
            0x6099: partial(self._store_positive, 0x6099),
            0x609A: partial(self._store_positive, 0x609A),
            0x60FF: self._set_velocity,
            0x6085: self._set_deceleration,
            0x60C0: self._choose_sub_mode,
            0x60C1: self._record,
            0x60C2: self._set_period,
        }

    @property
    def sub_mode(self) -> int:
        return self.values[0x60C0, 0]

    def read(self, index: int, sub: int) -> int:
        """Return the value of an object; raise `Abort` if it is write-only."""
        if "r" not in BY_ADDRESS[index, sub].access:
            raise Abort(WRITE_ONLY, f"object {index:#06x} can only be written")
        made = self._reads.get(index)
        return made() if made else self.values[index, sub]

    def write(self, index: int, sub: int, value: int) -> None:
        """Write a number; raise `Abort` if the drive rejects it."""
        if "w" not in BY_ADDRESS[index, sub].access:
            raise Abort(READ_ONLY, f"object {index:#06x} can only be read")
        self._writes[index](sub, value)

    def write_packet(self, data: bytes) -> None:
        """Write object 0x2010."""
        try:
            content = packet.decode(data)
        except packet.BadPacket as problem:
            raise Abort(LENGTH if len(data) != 8 else VALUE_RANGE, str(problem)) from None
        if isinstance(content, packet.PacketCommand):
            self._command(content)
        else:
            self._segment(content)

    # ------------------------------------------------------------------------------------------ 0x2010

    def _command(self, command: packet.PacketCommand) -> None:
        drive = self.drive
        if command.code == packet.CLEAR:
            drive.clear()
        elif command.code == packet.POP:
            drive.pop(command.data)
        elif command.code == packet.CLEAR_ERRORS:
            drive.clear_errors(command.data)
        else:
            drive.buffer.next_number = 0

    def _segment(self, segment: packet.Packet) -> None:
        buffer = self.drive.buffer
        if buffer.errors & packet.SEQUENCE:
            return  # until the master clears the error and sends again from the drive's number
        if segment.number != buffer.next_number & 7:
            why = f"a segment numbered {segment.number} came where {buffer.next_number & 7} was due: sequence error"
            self.drive.latch(packet.SEQUENCE, why)
        elif segment.initial is not None:
            self.drive.add_entry(BufferedPoint(segment.initial, None, 0, initial=True))
        else:
            assert segment.point is not None
            self.drive.add_entry(entry_of(segment.point))

    # ------------------------------------------------------------------------------- 0x60C0 0x60C1 0x60C2

    def _choose_sub_mode(self, _: int, value: int) -> None:
        if value not in SUB_MODES:
            raise Abort(VALUE_RANGE, f"there is no sub-mode {value}")
        self._refuse_in_motion("the sub-mode cannot change")
        self.values[0x60C0, 0] = value
        self.drive.steering = value == 0

    def _record(self, sub: int, value: int) -> None:
        if sub > TRIGGERS[self.sub_mode]:
            raise Abort(DEVICE_STATE, f"sub-mode {self.sub_mode} does not use sub-index {sub}")
        self.values[0x60C1, sub] = value
        if sub == TRIGGERS[self.sub_mode] and not self.drive.add_entry(self._entry()):
            raise Abort(DEVICE_STATE, "the trajectory buffer is full")

    def _entry(self) -> BufferedPoint:
        fixed = self.sub_mode in FIXED_TIME
        velocity = self.values[0x60C1, 3] if self.sub_mode == -3 else None
        span = self.period() if fixed else self.values[0x60C1, 2] * 1000
        return BufferedPoint(self.values[0x60C1, 1], velocity, span)

    def period(self) -> int:
        """The fixed time of sub-modes 0 and -1, in microseconds."""
        return int(self.values[0x60C2, 1] * 10 ** (6 + self.values[0x60C2, 2]))

    def _set_period(self, sub: int, value: int) -> None:
        legal = range(1, MAX_TIME + 1) if sub == 1 else range(-6, -2)
        if value not in legal:
            raise Abort(VALUE_RANGE, f"object 0x60C2:{sub} takes {legal[0]} to {legal[-1]}, not {value}")
        self.values[0x60C2, sub] = value

    # -------------------------------------------------------------------------------------------- DS402

    @property
    def mode(self) -> int:
        """The current mode of operation."""
        return self.values[0x6060, 0]

    def update(self) -> None:
        """Update the state machine for the motion: a quick stop ends at rest."""
        if self.power == QUICK_STOP and self.drive.state == IDLE and self.values[0x605A, 0] == 2:
            self.power = DISABLED

    def trip(self, code: int) -> None:
        """Enter the fault state with an error code; the axis brakes."""
        self.error = code
        self._leave("by a fault")
        self.power = FAULT
        self.emergency(code)

    def reset(self) -> None:
        """Return to the state after power-up; the position does not change."""
        self._leave("by a reset")
        self.power, self.error = DISABLED, 0
        self.values.update(DEFAULTS)
        self.drive.steering = True

    def _report(self, code: int, why: str) -> None:
        """Report an error that is not a fault; code 0 means that the axis has left its limit."""
        if code == 0:
            if self.error == REFERENCE_LIMIT:
                self._clear_error()
            return
        self.error = code
        self.emergency(code)
        self.complain(why)

    def _clear_error(self) -> None:
        self.error = 0
        self.emergency(0)

    def _choose_mode(self, _: int, value: int) -> None:
        if value not in (0, *MODES):
            raise Abort(VALUE_RANGE, f"mode {value} is not simulated, only {', '.join(map(str, MODES))}")
        if value == self.mode:
            return
        self._refuse_in_motion("the mode of operation cannot change")
        self._modes.leave("by another mode of operation")
        self.values[0x6060, 0] = value
        if self.power == ENABLED and value == PROFILE_VELOCITY:
            self._modes.follow_velocity()

    def _store(self, index: int, sub: int, value: int) -> None:
        self.values[index, sub] = value

    def _store_positive(self, index: int, sub: int, value: int) -> None:
        if value <= 0:
            raise Abort(VALUE_RANGE, f"object {index:#06x} must be greater than zero")
        self.values[index, sub] = value

    def _choose(self, index: int, known: tuple[int, ...], sub: int, value: int) -> None:
        if value not in known:
            names = ", ".join(map(str, known))
            raise Abort(VALUE_RANGE, f"object {index:#06x} takes {names}, not {value}")
        self.values[index, sub] = value

    def _set_velocity(self, _: int, value: int) -> None:
        self.values[0x60FF, 0] = value
        if self.power == ENABLED and self.mode == PROFILE_VELOCITY:
            self._modes.follow_velocity()

    def _set_deceleration(self, _: int, value: int) -> None:
        if value <= 0:
            raise Abort(VALUE_RANGE, "the quick stop deceleration must be greater than zero")
        self.drive.abort_deceleration = value * 10.0

    def _control(self, _: int, value: int) -> None:
        self.update()
        before, was = self.values[0x6040, 0], self.power
        self.values[0x6040, 0] = value
        self.power = _next_state(was, before, value)
        if value & RESET & ~before and (was == FAULT or not self._modes.is_at_limit):
            self._clear_error()
        if self.power != ENABLED:
            if was == ENABLED:
                self._leave("by the control word")
            self.update()
        elif self.mode == INTERPOLATED_POSITION:
            self._interpolate(before, value)
        else:
            self._modes.control(self.mode, before if was == ENABLED else 0, value)

    def _interpolate(self, before: int, control: int) -> None:
        """Start or stop the move in the buffer, as the control word commands."""
        if control & HALT or not control & START:
            self.drive.stop("by the control word")
        elif not before & START:
            self.drive.start()

    def _leave(self, why: str) -> None:
        self._modes.leave(why)

    def _status_word(self) -> int:
        self.update()
        bits = STATUS[self.power] | 0x0210
        if self.mode in (PROFILE_POSITION, PROFILE_VELOCITY, HOMING):
            return bits | self._modes.status(self.mode)
        return bits | (0x1000 if self.is_moving else 0x0400)

    @property
    def is_moving(self) -> bool:
        """True if the axis moves, brakes, or waits for points to start a move."""
        return self.drive.state in (MOVING, STOPPING, WAITING)

    def _position(self) -> int:
        return _wrapped(round(self.drive.position))

    def _velocity(self) -> int:
        return _wrapped(round(self.drive.velocity / SPEED_UNIT))

    def _refuse_in_motion(self, what: str) -> None:
        if self.is_moving:
            raise Abort(DEVICE_STATE, f"{what} while a move is in progress")


def _wrapped(value: int) -> int:
    """Wrap a number to 32 bits, signed."""
    return (value + 2**31) % 2**32 - 2**31


def _next_state(state: int, before: int, control: int) -> int:
    """Return the state of DS402 after a control word; `before` is the previous one.

    disabled ─▶ ready ─▶ switched on ─▶ enabled ─▶ quick stop ─▶ disabled
                                           any ─▶ fault ─▶ disabled

    A disabled drive can only become ready. From there a command may skip states, in both directions. A rising bit 7
    ends a fault.
    """
    if state == FAULT:
        return DISABLED if control & ~before & RESET else FAULT
    if not control & VOLTAGE:
        return DISABLED
    if not control & NO_QUICK_STOP:
        return QUICK_STOP if state in (ENABLED, QUICK_STOP) else DISABLED
    if state == QUICK_STOP:
        return ENABLED if control & SWITCH_ON and control & ENABLE else QUICK_STOP
    requested = READY if not control & SWITCH_ON else ON if not control & ENABLE else ENABLED
    if state == DISABLED:
        return READY if requested == READY else DISABLED
    return requested

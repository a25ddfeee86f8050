"""The number of position wraps, and motion keywords of older controllers."""

from __future__ import annotations

from math import floor

from motionlang.kernel.controller.queue import buffer
from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.keywords.homing import Homes
from motionlang.kernel.mint.runtime.binding import axis_of, of, of_word, scale_of
from motionlang.kernel.mint.runtime.changes import moving
from motionlang.kernel.mint.runtime.environment import Environment

NEGATIVE_INDEX = 4


def _wraps(environment: Environment, axis: int, counts: float) -> int:
    """Return the number of wraps at a position in counts.

    If the position is infinite, the present position is used instead.
    """
    scale = scale_of(environment, axis)
    if not scale.wrap:
        return 0
    if not abs(counts) < 1e300:
        counts = environment.controller.position(axis)
    return floor(scale.position_to_user(counts) / scale.wrap + 1e-12)


def do_datum(environment: Environment, row: Keyword, axes: tuple[int, ...], line: int) -> None:
    """DATUM: start a HOME of type _hmNEGATIVE_INDEX."""
    homes = environment.component(Homes)
    for axis in [axis_of(environment, axis) for axis in axes]:
        homes.begin(axis, NEGATIVE_INDEX, line)


def write_frequency(environment: Environment, row: Keyword, axis: int, pulses: float, line: int) -> None:
    """FREQ: run at pulses per second; 0 ends the motion, as it ends a jog."""
    environment.controller.jog(axis, pulses, row.name, line, None, not pulses)


# ------------------------------------------------------------------------------------------------- keywords

_DEMAND = Actions(read=moving(of(Environment, lambda e, axis: _wraps(e, axis, e.controller.demand(axis)))))
_TARGET = Actions(read=moving(of(Environment, lambda e, axis: _wraps(e, axis, e.controller.target(axis)))))
_LAST_TARGET = Actions(
    read=moving(of(Environment, lambda e, axis: _wraps(e, axis, buffer.end(e.controller.axes[axis]))))
)
_FREQUENCY = Actions(
    read=moving(of(Environment, lambda e, axis: e.controller.axes[axis].velocity(e.clock.now))),
    write=of_word(Environment, write_frequency),
)

_ROUND = "POSWRAP(0) = 360\nMOVER(0) = 800\nGO(0)\nPRINT {0}(0)\nPAUSE IDLE(0)\nPRINT {0}(0)"


def _reading(name: str, actions: Actions, help: str) -> Keyword:
    return Keyword(name, "", "reading", "R", "axis", "integer", actions, help, _ROUND.format(name), default=0.0,
                   group="state")  # fmt: skip


ROWS = (
    _reading("POSROLLOVERDEMAND", _DEMAND, "Number of times that POSDEMAND has wrapped."),
    _reading("POSROLLOVERTARGET", _TARGET, "Number of times that POS will have wrapped at the end of the move."),
    _reading("POSROLLOVERTARGETLAST", _LAST_TARGET,
           "Number of times that POS will have wrapped when the buffer is empty."),
    Keyword("DATUM", "", "command", "C", "axes", "", Actions(do=of_word(Environment, do_datum)),
            "Find the encoder's index in reverse, which is HOME of type _hmNEGATIVE_INDEX (v3).",
            "If HOMEINPUT(0) >= 0 Then DATUM(0)\nPAUSE IDLE(0)\nPRINT HOMESTATUS(0)",
            group="motion", effect="act datum"),
    Keyword("FREQ", "", "setting", "RW", "axis", "number", _FREQUENCY,
            "Run at a constant number of pulses a second, its sign the direction, until stopped or changed.",
            "FREQ(0) = 100\nWAIT = 500\nSTOP(0)\nPAUSE IDLE(0)\nPRINT FREQ(0)",
            default=0.0, low=-8388607.0, high=8388607.0, group="motion", effect="act"),
)  # fmt: skip

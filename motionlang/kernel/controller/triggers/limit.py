"""Travel limits: software limits of the program and limit switches of the machine.

A limit raises a fault on its axis if the axis passes it, or starts a motion towards it while it is active. The
axis then takes the limit's `action`. Moving away from an active limit is always allowed.
"""

from __future__ import annotations

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.triggers.conditions import FaultCondition
from motionlang.kernel.controller.watch import Watch, begin, end


class Limit(FaultCondition):
    """One end of an axis's travel: `sign` is +1 or -1, `bit` its fault.

    `position` is in counts; a `physical` limit stays at its position on the machine. A limit without a
    position is a switch that is operated from outside. Listeners of the controller are notified of the kind "limit"
    when it changes.
    """

    __slots__ = ("_switch", "ignored", "physical", "watch")

    def __init__(self, a: Axis, sign: int, bit: int, action: str, physical: bool = False) -> None:
        super().__init__(a, sign, bit, action)
        self.physical = physical
        self._switch = False
        self.watch: Watch | None = None
        # The line of the first move to a target that passed this switch while it was not in force, and its position in
        # user units.
        self.ignored: tuple[int, float] | None = None

    @property
    def active(self) -> bool:
        """True if the axis is beyond the limit or its switch is closed."""
        return self._switch or self.passed

    met = active

    @property
    def passed(self) -> bool:
        """True if the axis is at the limit or beyond it."""
        return self.watch is not None and self.watch.side in (self.sign, 0)

    def set_position(self, position: float | None) -> None:
        """Set the position of the limit; None removes it."""
        if self.watch is not None:
            end(self.a, self.watch)
            self.watch = None
        if position is not None:
            self.watch = Watch(position, self._pass, self.physical)
            begin(self.a, self.watch)
        self._changed()

    def set_active(self, active: bool) -> None:
        """Open or close the switch."""
        changed, self._switch = self._switch is not active, active
        self._changed()
        if changed:
            self.a.controller.notify("limit", self.a.index)

    def _changed(self) -> None:
        """Check the limit, which a motion may or may not be able to meet from now on."""
        self.a.barriers = [each for each in self.a.limits if each.watch is not None or each._switch]
        self.check()

    def _pass(self, direction: int) -> None:
        if self.physical and direction == self.sign and not self.in_force and self.ignored is None:
            self._record()
        self.check(direction)
        self.a.controller.notify("limit", self.a.index)

    def _record(self) -> None:
        """Record a move that goes on beyond the switch; a search for the switch, which has no target, is none."""
        a = self.a
        if a.move is not None and abs(a.target) < INFINITY and a.homing is None:
            self.ignored = a.move.line, a.scale.position_to_user(a.here(a.clock.now))

"""Travel limits: software limits that the program sets and switches that the machine has.

A limit that is passed, or already active when a move heads into it, raises a fault on its axis, and the axis does
what the limit's `action` says. Moving away from an active limit is always allowed.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.controller.controller import Controller
    from motionlang.controller.watch import Watch

# What an axis does about a fault. "stop" uses DECEL, "error-stop" ERRORDECEL.
ACTIONS = ("ignore", "stop", "error-stop", "abort", "off")


class Limit:
    """One end of an axis's travel: `sign` +1 or -1 says which, `bit` is the fault it raises.

    `position` is in counts; a `physical` limit stays where the machine has it.
    """

    __slots__ = ("_controller", "_watch", "action", "active", "axis", "bit", "enabled", "physical", "sign")

    def __init__(
        self, controller: Controller, axis: int, sign: int, bit: int, action: str, physical: bool = False
    ) -> None:
        assert action in ACTIONS, action
        self._controller, self.axis, self.sign, self.bit = controller, axis, sign, bit
        self.action, self.physical = action, physical
        self.enabled = True
        self.active = False
        self._watch: Watch | None = None

    def place(self, position: float | None) -> None:
        """Set where the limit is; None takes it away."""
        controller = self._controller
        if self._watch is not None:
            controller.unwatch(self.axis, self._watch)
            self._watch = None
        if position is None:
            self.active = False
            return
        a = controller.axes[self.axis]
        here = a.position(controller.clock.now) - (a.datum if self.physical else 0.0)
        self.active = (here - position) * self.sign > 0
        self._watch = controller.watch(self.axis, position, self._pass, self.physical)

    def set_active(self, active: bool) -> None:
        """The switch has opened or closed."""
        self.active = active
        if active and self._controller.heading(self.axis) == self.sign:
            self.trip()

    def trip(self) -> None:
        """Raise the fault and do what the action says."""
        if self.enabled and self.action != "ignore":
            self._controller.fault(self.axis, self.bit, self.action)

    def _pass(self, direction: int) -> None:
        self.set_active(direction == self.sign)

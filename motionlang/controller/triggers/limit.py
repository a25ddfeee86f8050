"""Travel limits: software limits that the program sets and switches that the machine has.

A limit that is passed, or already active when a move heads into it, raises a fault on its axis, and the axis does
what the limit's `action` says. Moving away from an active limit is always allowed.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.controller.controller import Controller
    from motionlang.controller.triggers.watch import Watch

# What an axis does about a fault. "stop" uses DECEL, "error-stop" ERRORDECEL; "event" only tells of it.
ACTIONS = ("ignore", "stop", "error-stop", "abort", "off", "event")


class Limit:
    """One end of an axis's travel: `sign` +1 or -1 says which, `bit` is the fault it raises.

    `position` is in counts; a `physical` limit stays where the machine has it. A limit may have no position at all and
    only be a switch that somebody opens and closes. Listeners of the controller hear "limit" when it changes.
    """

    __slots__ = ("_controller", "_switch", "action", "axis", "bit", "enabled", "physical", "sign", "watch")

    def __init__(
        self, controller: Controller, axis: int, sign: int, bit: int, action: str, physical: bool = False
    ) -> None:
        assert action in ACTIONS, action
        self._controller, self.axis, self.sign, self.bit = controller, axis, sign, bit
        self.action, self.physical = action, physical
        self.enabled = True
        self._switch = False
        self.watch: Watch | None = None

    @property
    def active(self) -> bool:
        """Whether the axis is beyond the limit or its switch is closed."""
        return self._switch or self.passed

    @property
    def passed(self) -> bool:
        """Whether the axis is beyond the limit."""
        return self.watch is not None and self.watch.side == self.sign

    def place(self, position: float | None) -> None:
        """Set where the limit is; None takes it away."""
        controller = self._controller
        if self.watch is not None:
            controller.unwatch(self.axis, self.watch)
            self.watch = None
        if position is not None:
            self.watch = controller.watch(self.axis, position, self._pass, self.physical)

    def set_active(self, active: bool) -> None:
        """The switch has opened or closed."""
        changed, self._switch = self._switch is not active, active
        self._act()
        if changed:
            self._controller.tell("limit", self.axis)

    def trip(self) -> None:
        """Raise the fault and do what the action says."""
        if self.enabled and self.action != "ignore":
            self._controller.fault(self.axis, self.bit, self.action)

    def _pass(self, direction: int) -> None:
        self._act()
        self._controller.tell("limit", self.axis)

    def _act(self) -> None:
        if self.active and self._controller.heading(self.axis) == self.sign:
            self.trip()

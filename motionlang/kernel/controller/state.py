"""The state of a controller: its axes, and what they share."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from motionlang.kernel import controller
from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import Clock, TimedCall
from motionlang.kernel.controller.io.channels import AnalogueInputs, Channels
from motionlang.kernel.controller.io.reads import ReadObservers
from motionlang.kernel.controller.io.stimuli import Stimuli
from motionlang.kernel.controller.motion_listener import MotionListener
from motionlang.kernel.errors import Rejected
from motionlang.kernel.log.log import Log

if TYPE_CHECKING:
    from motionlang.kernel.controller.io.asking import Asking, AskingTasks


class ControllerState:
    """The `axes`, numbered from `first`, with their clock, log, channels and listeners.

    An axis that does not exist raises KeyError.
    """

    def __init__(self, axes: int, first: int, clock: Clock, log: Log) -> None:
        self.clock, self.log = clock, log
        self.axes: dict[int, Axis] = {number: Axis(number, self) for number in range(first, first + axes)}
        self.inputs = Channels(clock, log.inputs, table="input")
        self.outputs = Channels(clock, log.outputs, log.origin)
        self.analogue_inputs = AnalogueInputs(clock, log)
        self.analogue_outputs = Channels(clock, log.analogue_outputs, log.origin)
        # The observers of what the program reads of the world.
        self.reads = ReadObservers()
        self.reads.join(self.inputs)
        self.reads.join(self.analogue_inputs)
        # The entries of the machine file that take effect by time or after an output.
        self.stimuli = Stimuli(clock, self.outputs)
        # What the world answers when the program asks, if it does, and the tasks of the program.
        self.asking: Asking | None = None
        self.tasks: AskingTasks | None = None
        # The events at which pulses of outputs end.
        self._pulses: dict[int, TimedCall] = {}
        # Encoder channels driven from outside, such as that of a conveyor; they have tracks like axes.
        self.encoders: dict[int, Axis] = {}
        self.listeners = Listeners()
        # The checks of conditions to be made once all axes of a motion have their profiles; None to check at once.
        self.deferred_checks: list[Callable[[], None]] | None = None
        # It is notified of operations, profiles and settings as they happen.
        self.motion_listener = MotionListener()
        # The handler of run-time faults outside a statement; it returns true if it has handled the fault.
        self.fault_handler: Callable[[Rejected], bool] | None = None

    def answering(self) -> Asking:
        """Return what the world answers when the program asks, created on first use."""
        if self.asking is None:
            self.asking = controller.Asking(self)
        return self.asking

    def run_by(self, tasks: AskingTasks) -> None:
        """Take note of the tasks of the program, which may ask for what answers."""
        self.tasks = tasks

    def encoder(self, channel: int) -> Axis:
        """Return the track of an encoder channel driven from outside."""
        found = self.encoders.get(channel)
        if found is None:
            found = self.encoders[channel] = Axis(channel, self)
        return found

    def pulse(self, channel: int, duration: float) -> None:
        """Turn a digital output on for `duration` seconds; another pulse prolongs it."""
        pending = self._pulses.get(channel)
        if pending is not None:
            pending.cancel()
        self.outputs[channel] = 1
        end, origin = self.clock.now + duration, self.log.origin()
        self._pulses[channel] = self.clock.at(end, partial(self.outputs.set, channel, 0, origin))

    def notify(self, what: str, axis: int) -> None:
        """Notify the listeners of a kind; they may unsubscribe meanwhile."""
        self.listeners.notify(what, axis)

    def run_time_fault(self, rejected: Rejected) -> None:
        """Raise a run-time fault outside a statement; unless handled, it ends the program."""
        if self.fault_handler is None or not self.fault_handler(rejected):
            raise rejected

    def run_time_fault_later(self, rejected: Rejected) -> None:
        """Raise a run-time fault once the present statement or event is over.

        The motion that caused it is complete by then, with its limits checked.
        """
        self.clock.at(self.clock.now, lambda: self.run_time_fault(rejected))

    def together(self) -> Together:
        """Return a block that starts several axes; conditions are checked at its end."""
        return Together(self)

    def finish_updates(self) -> None:
        """Roll back or finish partial updates after an interrupt."""
        axes = (*self.axes.values(), *self.encoders.values())
        for a in axes:
            del a.starts[len(a.profiles) :]
        self.motion_listener.finish_updates()


class Together:
    """A block that starts several axes; conditions are checked at its end."""

    __slots__ = ("_controller", "_outer")

    def __init__(self, controller: ControllerState) -> None:
        self._controller = controller
        self._outer: list[Callable[[], None]] | None = None

    def __enter__(self) -> None:
        self._outer = self._controller.deferred_checks
        if self._outer is None:
            self._controller.deferred_checks = []

    def __exit__(self, kind: object, *_: object) -> None:
        if self._outer is not None:
            return
        waiting, self._controller.deferred_checks = self._controller.deferred_checks or [], None
        if kind is None:
            for check in dict.fromkeys(waiting):
                check()


Listener = Callable[[str, int], None]

# The kinds of changes. With the number of an axis: it has come to rest, has a fault, has one that was not
# pending before ("error"), its faults are cleared, it was enabled or disabled, has another scale, its home
# switch or a limit has changed, its buffer has room again, its move holds because its speed is 0. With the
# bits of an error of the controller itself: the last one ("misc").
KINDS = (
    "idle",
    "fault",
    "error",
    "cleared",
    "switched",
    "scale",
    "home",
    "limit",
    "buffer-low",
    "held",
    "misc",
)


class Listeners:
    """The subscribers in order of notification, each with the kinds it wants."""

    def __init__(self) -> None:
        self._calls: list[tuple[Listener, tuple[str, ...]]] = []

    def __contains__(self, call: Listener) -> bool:
        return any(each == call for each, _ in self._calls)

    def append(self, call: Listener, *kinds: str) -> None:
        """Call `call(what, number)` for the given kinds, or for all."""
        self._set([*self._calls, (call, kinds or KINDS)])

    def put_first(self, call: Listener) -> None:
        """Call `call` for every kind, before all others."""
        self._set([(call, KINDS), *self._calls])

    def remove(self, call: Listener) -> None:
        """End a subscription; a no-op if it has ended."""
        self._set([each for each in self._calls if each[0] != call])

    def notify(self, what: str, number: int) -> None:
        """Notify the subscribers of a kind; they may unsubscribe meanwhile."""
        for call, kinds in self._calls:
            if what in kinds:
                call(what, number)

    def _set(self, calls: list[tuple[Listener, tuple[str, ...]]]) -> None:
        self._calls = calls  # a new list, so that a notification in progress uses the old one

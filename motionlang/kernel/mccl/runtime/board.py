"""The board: all state that outlives a line.

It consists of the axes' units and modes, registers, macros, tasks, and the last error.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.operations import Controller
from motionlang.kernel.controller.watch import Watch
from motionlang.kernel.errors import Diagnostic, Rejected
from motionlang.kernel.lang.change_times import Dependencies
from motionlang.kernel.lang.debugging import Hook
from motionlang.kernel.lang.loops import Loops
from motionlang.kernel.lang.machine.machine import MAX_DIAGNOSTICS, Machine
from motionlang.kernel.lang.waits import Wait
from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.axis import motor
from motionlang.kernel.mccl.axis.axis import AxisState
from motionlang.kernel.mccl.axis.limits import ALL, AxisLimits, LimitInputs
from motionlang.kernel.mccl.codes import Fault
from motionlang.kernel.mccl.keywords import of_families
from motionlang.kernel.mccl.keywords.switchable import SWITCHED
from motionlang.kernel.mccl.models import DEFAULT, MODELS, Model, named
from motionlang.kernel.mccl.motion.contour import MAX_QUEUE, Contour
from motionlang.kernel.mccl.motion.joystick import Joysticks
from motionlang.kernel.mccl.runtime.register_uses import PRIVATE
from motionlang.kernel.mccl.runtime.task import BackgroundTask, CommandTask
from motionlang.kernel.mccl.runtime.writer import LineSteps, LineWriter

if TYPE_CHECKING:
    from motionlang.kernel.mccl.motion.edge_search import Seek
    from motionlang.kernel.mccl.resolve.line import Line

# Codes that are assumptions, by their names in the machine file.
CODES = {
    codes.PARAMETER: "mccl.code-parameter",
    codes.NO_AXIS: "mccl.code-no-axis",
    codes.NOT_ASSIGNED: "mccl.code-not-assigned",
}

# The largest number of background tasks at one time.
MAX_TASKS = 32


class Board:
    """A PMC controller with its interpreter's state, built on a `Machine`.

    `write` takes the output of tasks that have no writer of their own. `complain` is called with every
    diagnostic and the task that caused it. If it is None, as on a served board, the `?` codes are the only
    report of errors.
    """

    def __init__(
        self, machine: Machine, complain: Callable[[Diagnostic, CommandTask], None] | None = None
    ) -> None:
        self.machine = machine
        self.controller: Controller = machine.controller
        self.model = _model(machine.model)
        # The assumptions that this board settles differently from the default, by name.
        self.assumptions = machine.assumptions
        self.write: Callable[[str], None] = machine.terminal.write
        self.complain = complain
        # Called before each command of a debug build.
        self.hook: Hook | None = None
        self._seen: dict[tuple[int, str], Diagnostic] = {}
        self.numbers = tuple(sorted(self.controller.axes))
        self.axes = {number: AxisState(number, self.model, self.controller) for number in self.numbers}
        self.all_axes = tuple(self.axes.values())
        self.tasks: list[CommandTask] = []
        self.background: dict[int, BackgroundTask] = {}
        self._last_task = 0
        # Counts of the effects of commands on anything but registers, of changes of registers that tasks share, and
        # of commands that switch an output to its present level.
        self.effects = self.stores = self.rewrites = 0
        self.lacks = of_families(self.model.lacks)
        self.dependencies = Dependencies(self.controller.clock)
        self.has_slices, self.switched = False, 0
        self.loops = Loops(machine, machine.statements, self)
        self.points: dict[tuple[int, int], float] = {}
        self.records: dict[int, tuple[float, int]] = {}
        self.seeks: dict[int, Seek] = {}
        self.breakpoints: dict[int, Watch] = {}
        self.contours: dict[int, Contour] = {}
        self.outputs: set[int] = set()
        self.joysticks = Joysticks(self)
        self.limits = {axis.number: AxisLimits(self, axis) for axis in self.all_axes}
        self.inputs = LimitInputs(self)
        self.controller.listeners.append(self._happened, "idle", "fault", "home")
        self.reset()

    def reset(self) -> None:
        """Reset to power-up: axes off, units counts and seconds, registers 0, no macros."""
        self.registers: list[float | int] = [0] * self.model.registers
        self.macros: dict[int, LineSteps] = {}
        self.time_unit = 1.0
        self.hexadecimal = False
        self.last_error = 0
        self.prompt, self.echo = self.model.prompt, self.model.echo
        self.xon, self.xoff = 17, 19
        self.outputs = set(self.model.outputs)
        self.controller.inputs.set_active_low(())
        self.points.clear()
        for number in list(self.background):
            self.end_task(number)
        for task in self.tasks:
            task.registers[:] = [0] * PRIVATE
        for axis in self.all_axes:
            self.reset_axis(axis)

    def reset_axis(self, axis: AxisState) -> None:
        """Reset one axis to power-up: off, position 0, settings at their defaults."""
        number, controller = axis.number, self.controller
        self.release(axis)
        self.forget_breakpoint(number)
        self.records.pop(number, None)
        axis.reset()
        self.limits[number].set_mode(0)
        self.limits[number].disable(ALL)
        self.limits[number].watch_amplifier(False)
        controller.disable(number)
        if controller.position(number) != 0.0:
            self.define_position(axis, 0.0)
        controller.clear_faults(number)
        for name, value in AXIS_SETTINGS.items():
            controller.configure(number, name, value)
        if self.machine.settings.get(f"axis.{number}.motor") == "stepper":
            speed, accel, axis.minimum = self.model.stepper
            for name, value in (("speed", speed), ("accel", accel), ("decel", accel)):
                controller.configure(number, name, value)
        if self.assumptions:
            for key, choice in self.assumptions.items():
                if key in SWITCHED:
                    axis.stored[SWITCHED[key]] = choice  # type: ignore[assignment]
        axis.apply_units()
        controller.set_scale(number, 1.0)
        motor.power_up(self, axis)

    # -------------------------------------------------------------------------------------- paths and masters

    def contour(self, axis: AxisState) -> Contour:
        """Return the contour that the axis controls."""
        found = self.contours.get(axis.number)
        if found is None:
            found = self.contours[axis.number] = Contour(self, axis)
        return found

    def contour_of(self, axis: AxisState) -> Contour | None:
        """Return the contour whose path the axis is on, if any."""
        if axis.controlling is None:
            return None
        found = self.contours.get(axis.controlling)
        return found if found is not None and axis.number in found.members else None

    def contour_including(self, axis: AxisState) -> Contour | None:
        """Return the contour in motion that the axis is on, waits for or controls."""
        found = self.contours.get(axis.controlling) if axis.controlling is not None else None
        return found if found is not None and found.includes(axis.number) else None

    def awaits_path(self, axis: AxisState) -> bool:
        """True if a path of the axis, or of its master, waits for the current ones to end."""
        if not self.contours:
            return False
        master = self.controller.master_of(axis.number)
        if master is not None and master in self.axes:
            return self.awaits_path(self.axes[master])
        contour = self.contours.get(axis.controlling) if axis.controlling is not None else None
        return contour is not None and contour.waits_for(axis.number)

    def is_complete(self, axis: AxisState) -> bool:
        """True if the axis is at rest and no path of it waits."""
        return self.controller.is_at_standstill(axis.number) and not self.awaits_path(axis)

    def path_end(self, axis: AxisState) -> float | None:
        """Return the end of the last path of the axis, counts; None without paths."""
        contour = self.contours.get(axis.controlling) if axis.controlling is not None else None
        return contour.aim(axis.number) if contour is not None else None

    def leave_contour(self, axis: AxisState) -> None:
        """End the path of an axis that changes to another mode."""
        contour = self.contour_of(axis)
        if contour is not None:
            contour.stop()
        self._forget_paths(axis)
        axis.controlling = None

    def release(self, axis: AxisState, ended: str = "cancel") -> None:
        """Detach an axis from its path, joystick and search.

        The operation that stops it also removes its master. After a fault that stops smoothly, the contour
        still comes to rest along its path.
        """
        seek = self.seeks.pop(axis.number, None)
        if seek is not None:
            seek.cancel()
        self.joysticks.switch_off(axis)
        contour = self.contour_of(axis)
        if contour is not None and not (ended == "fault" and contour.stopping):
            contour.abort(ended)
        self._forget_paths(axis)

    def _forget_paths(self, axis: AxisState) -> None:
        """Remove the queued paths of the axis, whose start is no longer known."""
        if axis.controlling in self.contours:
            self.contours[axis.controlling].forget(axis.number)

    def define_position(self, axis: AxisState, position: float) -> None:
        """Define the current position of the axis as `position`, counts.

        The stored positions of its motion are shifted with it.
        """
        number, controller = axis.number, self.controller
        shift = position - controller.position(number)
        controller.define_position(number, position)
        for contour in self.contours.values():
            contour.shift(number, shift)
        seek = self.seeks.get(number)
        if seek is not None and seek.caught is not None:
            seek.caught += shift

    def forget_breakpoint(self, number: int) -> None:
        """Remove the breakpoint that IP or IR has set on an axis."""
        watch = self.breakpoints.pop(number, None)
        if watch is not None:
            self.controller.unwatch(number, watch)

    def home_changed(self, number: int) -> None:
        """Check a pending search after a change of an axis's home input."""
        seek = self.seeks.get(number)
        if seek is not None:
            seek.check()

    def _happened(self, what: str, number: int) -> None:
        if what == "idle":
            self.axes[number].rested = self.controller.clock.now
            for contour in list(self.contours.values()):
                contour.rested(number)
        elif what == "fault":
            self.limits[number].happened()
            self.release(self.axes[number], "fault")
        elif what == "home":
            self.home_changed(number)

    # ------------------------------------------------------------------------------------------------ queries

    def axis(self, number: int) -> AxisState:
        """Return an axis by its number; raise Fault if it does not exist."""
        found = self.axes.get(number)
        if found is None:
            hint = f"the axes are {self.numbers[0]} to {self.numbers[-1]}; controller.axes sets their number"
            raise Fault(codes.NOT_ASSIGNED, f"there is no axis {number}", hint, "axis")
        return found

    def is_driven(self, channel: int) -> bool:
        """True if the world or the program drives an input."""
        if self.controller.inputs.present(channel) != 0:  # the program reads nothing
            return True
        world = self.machine.world
        return world is not None and channel in world.driven

    @property
    def drives_inputs(self) -> bool:
        """True if the world or the program drives, or ever drove, some input."""
        world = self.machine.world
        return not self.controller.inputs.is_untouched or (world is not None and bool(world.driven))

    def seconds(self, value: float) -> float:
        """Convert a time in the unit of UT to seconds."""
        return value * self.time_unit

    def is_shared(self, task: CommandTask) -> bool:
        """True if another task is ready to run."""
        return any(other.wait is None and other is not task and not other.done for other in self.tasks)

    # ---------------------------------------------------------------------------------------- for the rule of loops

    @property
    def shared(self) -> list[Any]:
        """The registers of all tasks."""
        return self.registers

    @property
    def running(self) -> CommandTask:
        """The task that runs."""
        return self.loops.task  # type: ignore[return-value]  # all tasks of a board are of this class

    def changes(self) -> tuple[int, int]:
        """Return counters of the effects of commands, and of events."""
        return self.effects, self.controller.clock.fired

    def acted(self) -> tuple[int, ...]:
        """Return counters of all that a loop could wait for."""
        return *self.changes(), self.stores, self.rewrites

    def levels(self) -> tuple[object, ...]:
        """Return the levels of outputs; a switch counts as an effect instead."""
        return ()

    def stands_still(self) -> Wait:
        """Return the wait of a loop that repeats until something else acts."""
        acted, now = self.acted(), self.controller.clock.now
        return Wait(now, lambda: self.acted() != acted, lambda: INFINITY, "for its loop to end")

    def period(self, delays: list[tuple[float, float]]) -> int:
        """Return 0: a wait ends at its exact time, and sums of such times round."""
        return 0

    def end_of_wait(self, base: float, count: float, seconds: float) -> float:
        """Return when a wait ends that began at statement `count` from `base`."""
        return base + count * self.machine.statements.cost + seconds

    def written(self, line: Line) -> LineSteps:
        """Return the steps of a line on this board."""
        return LineWriter(line, self).steps

    # -------------------------------------------------------------------------------------------------- tasks

    def foreground(self, task: CommandTask) -> None:
        """Replace the task that executes the host's lines."""
        self.tasks = [task, *self.background.values()]

    def join(self, task: CommandTask) -> None:
        """Add another task that executes a host's lines."""
        self.tasks.append(task)

    def start_task(self, macro: LineSteps, issuer: CommandTask) -> int:
        """Run a macro in the background and return the task's number.

        Its replies go to the same writer as the issuer's. Raises Fault if too many tasks run.
        """
        if len(self.background) >= MAX_TASKS:
            raise Fault(
                codes.PARAMETER, f"there are {MAX_TASKS} background tasks already", "end one with ET", "limit"
            )
        scheduler = self.machine.scheduler
        assert scheduler is not None, "background tasks need a scheduler"
        self._last_task += 1
        task = BackgroundTask(self._last_task, self, macro)
        task.write = issuer.write
        self.background[self._last_task] = task
        self.tasks.append(task)
        scheduler.start(task)
        return self._last_task

    def end_task(self, number: int) -> bool:
        """End a background task; return False if the number does not exist."""
        task = self.background.get(number)
        if task is None:
            return False
        task.abandon()
        task.end()
        return True

    def ended(self, task: CommandTask) -> None:
        """Remove a task that has ended."""
        if task in self.tasks:
            self.tasks.remove(task)
        for number, each in list(self.background.items()):
            if each is task:
                del self.background[number]

    # ------------------------------------------------------------------------------------------------ answers

    def whole(self, value: int) -> str:
        """Format an integer in the base set by DM or HM."""
        if not self.hexadecimal:
            return str(value)
        small = self.assumptions.get("mccl.hex-letters") == "small"
        return f"{value & 0xFFFFFFFF:{'x' if small else 'X'}}"

    def refused(self, task: CommandTask, trouble: Fault | Rejected) -> bool:
        """Answer a rejected command; return True if the rest of the line is to be skipped."""
        if isinstance(trouble, Rejected):
            if trouble.code == "limit":
                raise trouble
            if trouble.code == "disabled-axis":
                # No code of the board means this: it sends no answer and nothing moves.
                self.warn(task, trouble.code, trouble.message, "MN switches it on", "error")
                return False
            trouble = Fault(codes.PARAMETER, trouble.message, trouble.hint, trouble.code)
        code = self._code(trouble.code)
        self.last_error = code
        meaning = codes.MEANINGS.get(trouble.code, "")
        self.warn(task, trouble.kind, f"{trouble.message} (?{code}: {meaning})", trouble.hint, "error")
        task.reply(f"?{code}")
        return True

    def _code(self, code: int) -> int:
        """Return the code that this board gives for the usual `code`."""
        name = CODES.get(code)
        return code if name is None else self.assumptions.get(name, code)  # type: ignore[return-value]

    def forget_complaints(self) -> None:
        """Report repeated diagnostics again, because a new text begins."""
        self._seen.clear()

    def warn(
        self, task: CommandTask, code: str, message: str, hint: str = "", severity: str = "warning"
    ) -> None:
        """Report a diagnostic at the current command of the task.

        It is reported once per position, and repetitions are counted.
        """
        if self.complain is None:
            return
        key = (task.at, message)
        before = self._seen.get(key)
        if before is not None:
            before.again(self.controller.clock.now)
        elif len(self._seen) < MAX_DIAGNOSTICS:
            self._seen[key] = Diagnostic(code, message, hint=hint, severity=severity)
            self.complain(self._seen[key], task)


# The settings of the controller's axes on this board, if they differ from the controller's defaults.
AXIS_SETTINGS: dict[str, float | str] = {
    "buffer_size": MAX_QUEUE,
    "shape": "trapezoid",
    "speed": 40_000.0,
    "accel": 100_000.0,
    "decel": 100_000.0,
    # The ramp ratio defines PMC's S-curve, not a jerk.
    "accel_jerk": INFINITY,
    "decel_jerk": INFINITY,
    "ramp": 0.1,
}


def _model(name: str) -> Model:
    model = named(name or DEFAULT)
    if model is None:
        models = ", ".join(MODELS)
        raise Rejected("machine-file", f"MCCL has no model {name}", f"the models are {models}")
    return model

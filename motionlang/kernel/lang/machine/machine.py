"""The machine that a program runs on: controller, terminal and world.

The machine file describes the world.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from math import inf
from typing import TYPE_CHECKING

from motionlang.kernel import controller, lang
from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import Clock, WatchedClock
from motionlang.kernel.controller.operations import Controller
from motionlang.kernel.errors import Diagnostic, ProgramError
from motionlang.kernel.lang.machine.nonvolatile import NonVolatile
from motionlang.kernel.lang.machine.stop import stop_of
from motionlang.kernel.lang.machine.switch import ASSUMPTIONS
from motionlang.kernel.lang.machine.terminal import Terminal, labelled
from motionlang.kernel.lang.statement_time import StatementTime
from motionlang.kernel.log.log import Log
from motionlang.kernel.log.move import LoggedMove

if TYPE_CHECKING:
    from motionlang.kernel.lang.debugging import Hook, Observer
    from motionlang.kernel.lang.scheduler import Scheduler

# The number of axes of a machine without a machine file.
DEFAULT_AXES = 8
# The number of the terminal that is the console.
CONSOLE = 1
INSTRUCTION_TIME = 10e-6
# The number of different diagnostics that a run reports; further ones add nothing new.
MAX_DIAGNOSTICS = 200


class Machine:
    """A controller with its terminal, its world and the settings that a language needs.

    `world` is what the machine file describes, or None if it describes only the controller.
    """

    def __init__(
        self,
        settings: Mapping[str, object] | None = None,
        *,
        first_axis: int = 0,
        show: Callable[[str], object] | None = None,
        overrides: Mapping[str, float | str] | None = None,
        hook: Hook | None = None,
        observer: Observer | None = None,
    ) -> None:
        self.settings = dict(settings or {})
        get = self.settings.get
        # Called before statements of a debug build.
        self.hook = hook
        self.observer = observer
        self.model = str(get("controller.model", ""))
        self.instruction_time = float(get("controller.instruction_time", INSTRUCTION_TIME))  # type: ignore[arg-type]
        # The assumptions that this controller settles differently from the default, by name.
        self.assumptions = {
            key.removeprefix(ASSUMPTIONS): value
            for key, value in self.settings.items()
            if key.startswith(ASSUMPTIONS)
        }
        self.clock = Clock() if hook is None else WatchedClock(hook.advancing)
        self.statements = StatementTime(self.instruction_time)
        self._operators: dict[int, lang.Operator] = {}
        self.log = Log()
        self.log.hurried = self._hurried
        # What ends the run before its time limit, if anything does.
        self.stop = stop_of(self.settings, self.clock, self.log)
        self.terminal = Terminal(self.clock, self.log.prints, show, self.log.origin)
        # The output to other terminals, by label.
        self.terminals: dict[str, Terminal] = {}
        # Called for a line of the console when the program wants one; None if there is no operator.
        self.ask: Callable[[], str | None] | None = None
        # The values that `--set NAME=VALUE` gives to the program's own names.
        self.overrides = dict(overrides or {})
        # The keywords that the program used and that have no effect here, in order of use, with their lines.
        self.without_effect: dict[str, list[int]] = {}
        # The keywords that it read and whose value is assumed, in order of use, with their lines.
        self.assumed: dict[str, list[int]] = {}
        # Facts about other devices that this run could not know, in the order in which the program met them.
        self.notes: dict[str, None] = {}
        # Each returns, as rows of the report, the data that the program wrote into other devices.
        self.written: list[Callable[[], list[dict[str, object]]]] = []
        # Each schedules an entry of a table, such as a coil, with the time from which its times count.
        self.receivers: dict[str, Callable[[Mapping[str, object], float], None]] = {}
        # Data that outlives the run, if a file for it is given.
        self.nv: NonVolatile | None = None
        # Mistakes of the program that did not end it: MCCL answers with a code and continues.
        self.diagnostics: list[Diagnostic] = []
        self._reported: dict[tuple[object, ...], Diagnostic] = {}
        # Called with a diagnostic that a person would want before the run is over; all of these are in
        # `warned`.
        self.warn: Callable[[Diagnostic], object] | None = None
        self.warned: list[Diagnostic] = []
        # Runs the tasks, so that a program can start further ones; set by the code that starts the program.
        self.scheduler: Scheduler | None = None
        axes: int = get("controller.axes", DEFAULT_AXES)  # type: ignore[assignment]
        if not _is_plain(self.settings):
            _check_axes(self.settings, axes, first_axis)
        self.controller = Controller(axes, first_axis, self.clock, self.log)
        self.world = _world(self.controller, self.settings)
        self._host = self._new_host() if any(area in self.settings for area in controller.AREAS) else None

    def add_entries(self, settings: Mapping[str, object]) -> None:
        """Add inputs, answers, keys and writes of other devices to the world; their times count from now."""
        if "answer" in settings or "key" in settings:
            self.operator.add(settings, self.clock.now)
        for area in controller.AREAS:
            for entry in settings.get(area, ()):  # type: ignore[attr-defined]
                self.host.schedule(self.controller, area, entry, self.clock.now)
        for table, schedule in self.receivers.items():
            for entry in settings.get(table, ()):  # type: ignore[attr-defined]
                schedule(entry, self.clock.now)
        if "input" not in settings and "analogue" not in settings:
            return
        if self.world is None:
            self.world = controller.Surroundings(self.controller, self.settings)
        self.world.wire_inputs(settings)

    def complain(self, diagnostic: Diagnostic) -> None:
        """Report a mistake that does not end the program; repeated ones are counted."""
        if not self.diagnostics:
            self._reported.clear()  # the caller that cleared the list has reported them
        before = self._reported.setdefault(diagnostic.key, diagnostic)
        if before is not diagnostic:
            before.again(self.clock.now)
        elif len(self._reported) <= MAX_DIAGNOSTICS:
            diagnostic.first = diagnostic.last = self.clock.now
            self.diagnostics.append(diagnostic)
        else:
            del self._reported[diagnostic.key]

    def _hurried(self, move: LoggedMove, count: int, span: float) -> None:
        """Warn about a line that starts one move after another without waiting."""
        message = f"{move.command} starts motions without waiting for them: {count} in {span:.3g} s"
        hint = "wait for each to end, or let time pass between them"
        if not any(
            each.profile is None or each.profile.duration for each in self.controller.log.moves[-count:]
        ):
            message = f"{move.command} moves its axis to its present position {count} times in {span:.3g} s"
            hint = "such a move takes no time: end the loop, or let time pass in it"
        found = Diagnostic("never-waits", message, move.line, hint=hint, severity="warning")
        self.complain(found)
        if self.warn is not None and self.diagnostics[-1] is found:
            self.warned.append(found)
            self.warn(found)

    def never_started(self) -> list[tuple[LoggedMove, Sequence[Axis]]]:
        """Return the buffered moves that no motion in progress will start, with the axes that each moves."""
        found: list[tuple[LoggedMove, Sequence[Axis]]] = []
        for a in self.controller.axes.values():
            for move in a.buffer:
                axes = (a,) if move.action is None else move.action.together_with(a)
                end = max(each.end_of_move() for each in axes)
                if not (move.released and self.clock.now < end < inf):
                    found.append((move, axes))
        return found

    @property
    def moves_made(self) -> int:
        """Return the number of moves started so far."""
        return self.log.moves.past

    @property
    def has_motors(self) -> bool:
        """True if the machine file gives an axis a simulated motor."""
        return any(".plant." in key for key in self.settings)

    @property
    def host(self) -> controller.HostMemory:
        """The memory shared with a host; without writes in the machine file, it is created on first use."""
        if self._host is None:
            self._host = self._new_host()
        return self._host

    def _new_host(self) -> controller.HostMemory:
        def written(area: str, element: int, value: float) -> None:
            self.log.write(self.clock.now, f"{lang.DRIVES[area][0]} {element}", value)

        host = controller.HostMemory(controller.PRODUCTS[controller.product(self.model)], written)
        for area in controller.AREAS:
            for entry in self.settings.get(area, ()):  # type: ignore[attr-defined]
                host.schedule(self.controller, area, entry)
        self.controller.reads.join(host)
        return host

    @property
    def nonvolatile(self) -> NonVolatile:
        """Data that outlives the run; without a file it lasts only as long as the run."""
        if self.nv is None:
            self.nv = NonVolatile()
        return self.nv

    @property
    def has_operator(self) -> bool:
        """True if the program reads the keyboard."""
        return CONSOLE in self._operators

    @property
    def operator(self) -> lang.Operator:
        """The operator who presses keys and types at the console, created on first use."""
        return self.operator_at(CONSOLE)

    def operator_at(self, number: int) -> lang.Operator:
        """Return the operator at terminal `number`, created on first use."""
        found = self._operators.get(number)
        if found is None:
            terminal = self.terminal_at(number)
            found = self._operators[number] = lang.Operator(self.controller, terminal, self.settings, number)
        return found

    def unasked(self) -> list[str]:
        """Return the answers in the settings that no INPUT has used."""
        answers = self.settings.get("answer", ())
        return [
            text
            for number in dict.fromkeys(each.get("terminal", CONSOLE) for each in answers)  # type: ignore[attr-defined]
            for text, _ in self.operator_at(number).lines
        ]

    def terminal_at(self, number: int) -> Terminal:
        """Return terminal `number`; one of the terminals is the console."""
        return self.terminal if number == CONSOLE else self.stream(f"terminal {number}")

    def stream(self, label: str) -> Terminal:
        """Return the terminal of other output; its lines are shown with a label."""
        found = self.terminals.get(label)
        if found is None:
            found = self.terminals[label] = labelled(label, self.terminal, self.clock, self.log.new_prints())
        return found

    def close_terminals(self) -> None:
        """End all unfinished lines, that of the console last."""
        for terminal in (*self.terminals.values(), self.terminal):
            terminal.close()


def _check_axes(settings: Mapping[str, object], axes: int, first_axis: int) -> None:
    """Raise ProgramError if the settings name axes that do not exist."""
    if wrong := missing_axes(settings, axes, first_axis):
        raise ProgramError(wrong)


def _world(of: Controller, settings: Mapping[str, object]) -> controller.Surroundings | None:
    """Return the world of a machine file, or None if it describes only the controller."""
    if _is_plain(settings):
        return None

    return controller.Surroundings(of, settings)


def _is_plain(settings: Mapping[str, object]) -> bool:
    """True if the settings describe only the controller."""
    return all(key.startswith(("controller.", "mint.", ASSUMPTIONS)) for key in settings)


def missing_axes(settings: Mapping[str, object], axes: int, first: int) -> list[Diagnostic]:
    """Return a diagnostic for each key and entry whose axis does not exist.

    The axes are numbered from `first`; there are `axes` of them.
    """
    hint = f"the axes are {first} to {first + axes - 1}; controller.axes sets their number"
    return [
        Diagnostic("machine-file", f"{where}: there is no axis {axis}", hint=hint)
        for where, axis in dict.fromkeys(_named(settings))
        if not first <= axis < first + axes
    ]


def _named(settings: Mapping[str, object]) -> Iterator[tuple[str, int]]:
    """Yield the axes that the settings name, each with its key or table."""
    for key, value in settings.items():
        components = key.split(".")
        if components[0] == "axis" and len(components) > 2:
            yield f"axis.{components[1]}", int(components[1])
        elif isinstance(value, list):
            for entry in value:
                if isinstance(entry, dict) and isinstance(entry.get("axis"), int):
                    yield f"[[{key}]]", entry["axis"]

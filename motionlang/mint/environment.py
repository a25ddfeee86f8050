"""What a running Mint program stands on: its tasks, its waits, and the objects that its text calls `kN`."""

from __future__ import annotations

from motionlang.lang.task import GeneratorTask, Wait, wait_until

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from motionlang.lang.machine import Machine
    from motionlang.lang.task import Steps

INFINITY = float("inf")
# The profiler's period: how often a condition is tested that can neither be solved nor told by an event.
TICK = 1e-3
# Rounding of a time in seconds must not cost a millisecond.
_MILLISECOND = 1e-6


class Environment:
    """One program on one machine. `task` is the task that is running; each has its own TIME."""

    def __init__(self, machine: Machine, places: Sequence[int]) -> None:
        self.machine = machine
        self.controller = machine.controller
        self.clock = machine.controller.clock
        self.places = places
        self.jogs: dict[int, float] = {}
        self.task: MintTask
        self.blocks: dict[str, Callable[[float, float], Steps]] = {}
        self._random: Callable[[], float] | None = None

    def make_operations(self, specs: Sequence[tuple[object, ...]]) -> tuple[object, ...]:
        """What each `kN` of the text stands for."""
        return tuple(self._operation(*spec) for spec in specs)

    def _operation(self, how: str, *details: object) -> object:
        if how == "env":
            return getattr(self, str(details[0]))
        if how == "fn":
            from motionlang.mint import functions

            return getattr(functions, str(details[0]))
        if how in ("show", "using"):
            from motionlang.mint import printing

            return getattr(printing, f"{how}_{details[0]}")
        from motionlang.mint.binding import Row, bind

        return bind(self, how, Row(*details))  # type: ignore[arg-type]

    # ---------------------------------------------------------------------------------------------- time

    def elapsed(self, base: float) -> int:
        """Whole milliseconds since a moment."""
        return int((self.clock.now - base) * 1000.0 + _MILLISECOND)

    def since(self, milliseconds: float) -> float:
        """The moment from which so many milliseconds have passed."""
        return self.clock.now - milliseconds / 1000.0

    def random(self) -> float:
        """The next number of `Rnd`."""
        if self._random is None:
            from motionlang.mint.functions import Random

            self._random = Random()
        return self._random()

    def copy(self, record: list[object]) -> list[object]:
        """A copy of a value of a user type, with its arrays and its inner values."""
        return [self.copy(each) if each.__class__ is list else each for each in record]  # type: ignore[arg-type]

    # --------------------------------------------------------------------------------------------- waits

    def wait(self, t: float, milliseconds: float) -> Wait:
        """`WAIT`."""
        if not milliseconds >= 0:
            from motionlang.controller.faults import Refusal

            raise Refusal("range", f"WAIT cannot be {milliseconds:g}", "a wait lasts 0 ms or longer")
        return wait_until(self.controller, t, t + milliseconds / 1000.0)

    def tick(self, t: float) -> Wait:
        """Wait for the next tick of the profiler."""
        return wait_until(self.controller, t, (int(t / TICK + 1e-6) + 1) * TICK)

    def room(self, t: float, axis: int) -> Wait:
        """A move waits for room in the buffer of its axis."""
        room = self.controller.room
        return Wait(t, lambda: room(axis) > 0, lambda: INFINITY, f"for room in the move buffer of axis {axis}")

    def pause(self, t: float, ready: Callable[[], object], watches: tuple[tuple[object, ...], ...]) -> Wait:
        """`PAUSE`."""
        from motionlang.mint.watching import watch

        return watch(self, t, ready, watches)

    # --------------------------------------------------------------------------------------------- tasks

    def end_program(self, t: float) -> None:
        """`End` in a task or a sub: the parent task ends, and with it everything."""
        raise ProgramEnd(t)


class ProgramEnd(Exception):
    """The program ends here."""

    def __init__(self, time: float) -> None:
        super().__init__()
        self.time = time


class MintTask(GeneratorTask):
    """A task of a Mint program; TIME counts from its start."""

    __slots__ = ("environment", "time_base")

    def __init__(
        self, name: str, make: Callable[[float, float], Steps], file: str, environment: Environment
    ) -> None:
        super().__init__(name, make, file, environment.places)
        self.environment = environment
        self.time_base = environment.clock.now

    def resume(self, now: float, horizon: float) -> tuple[float, Wait | None]:
        self.environment.task = self
        try:
            return super().resume(now, horizon)
        except ProgramEnd as end:
            self.done = True
            return end.time, None

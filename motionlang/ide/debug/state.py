"""The state at a stop as a debugger shows it: tasks, calls, scopes, expressions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from motionlang.ide.debug import scopes
from motionlang.ide.debug.expressions import READINGS, WrongExpression, parse
from motionlang.ide.debug.replay import Replay, StopPoint
from motionlang.ide.debug.scopes import Waiting
from motionlang.kernel import Machine, Task, Variable
from motionlang.kernel.lang import Frame

if TYPE_CHECKING:
    from motionlang.ide.debug.debugger import Debugger


class StoppedRun:
    """The state of a run at its stop, or at its end."""

    def __init__(self, debugger: Debugger, replay: Replay, point: StopPoint | None = None) -> None:
        self._debugger, self._replay = debugger, replay
        self._point = replay.point if point is None else point

    @property
    def time(self) -> float:
        """The time of the statement, or of the end, s."""
        if self._point is not None:
            return self._point.time
        assert self._replay.run is not None
        return self._replay.run.time

    @property
    def machine(self) -> Machine:
        """The machine of the run."""
        return self._replay.machine

    def tasks(self) -> list[Waiting]:
        """Return the tasks and event handlers, each with the condition it waits for."""
        running = None if self._point is None else self._point.task
        return scopes.tasks(self._replay.machine, running)

    def frames(self, task: Task) -> Sequence[Frame]:
        """Return the calls of a task, the innermost first."""
        return scopes.frames(self._replay.hook, task, self._point)

    def module(self) -> list[Variable]:
        """Return the global variables of the program, or the shared registers."""
        return scopes.module(self._replay.hook)

    def axes(self) -> list[Variable]:
        """Return the axes at the time of the stop, and their motion at its moment."""
        stop = self._debugger.stop
        moment = None if stop is None else stop.moment
        return scopes.axes(self._replay.machine, self.time, moment)

    def inputs(self) -> list[Variable]:
        return scopes.inputs(self._replay.machine)

    def outputs(self) -> list[Variable]:
        return scopes.outputs(self._replay.machine)

    def find(self, path: Sequence[str]) -> Variable | None:
        """Return the variable at a path, as in `scopes.find`."""
        return scopes.find(self._replay.hook, self._point, path)

    def named(self, name: str) -> tuple[tuple[str, ...], Variable] | None:
        """Return path and variable of a name at the stop."""
        return scopes.named(self._replay.hook, self._point, name)

    def path_of(self, name: str) -> tuple[str, ...]:
        """Return the path of a variable, an element, an axis or a channel such as "output 2".

        Raises WrongExpression if there is none.
        """
        base, bracket, subscripts = name.strip().partition("(")
        found = self.named(f"R{base[1:]}" if base.startswith("@") else base)
        if found is not None:
            path = found[0] if not bracket else (*found[0], f"{found[1].name}({subscripts}")
            if self.find(path) is None:
                raise WrongExpression(f"there is no {path[-1][:60]}")
            return path
        component = scopes.of_machine(name)
        if component is None:
            raise WrongExpression(f"there is no variable {name.strip()[:60]} here")
        scopes.present(self._replay.machine, component)
        return scopes.MACHINE, component

    def names(self) -> list[str]:
        """Return the names that an expression may use at the stop: variables and readings."""
        frames = [] if self._point is None else list(self.frames(self._point.task))[:1]
        found = [each.name for frame in frames for each in frame.variables]
        found += [each.name for each in self.module()]
        return list(dict.fromkeys([*found, *READINGS, "time"]))

    def evaluate(self, text: str) -> object:
        """Return the value of an expression, or the variable with a name.

        Raises WrongExpression.
        """
        found = self.named(text.strip())
        if found is not None:
            return found[1]
        return parse(text)(self)

    # ------------------------------------------------------------------------------------- for expressions

    def variable(self, name: str, subscripts: list[float]) -> float | str | None:
        """Return the value of a variable or an element for an expression."""
        found = self.named(name)
        if found is None:
            return None
        value = found[1].value
        if subscripts:
            wanted = f"{found[1].name}({', '.join(f'{each:.10g}' for each in subscripts)})"
            elements = value if isinstance(value, list) else []
            element = next((each for each in elements if each.name.lower() == wanted.lower()), None)
            if element is None:
                raise WrongExpression(f"there is no {wanted}")
            value = element.value
        if value is None:
            raise WrongExpression(f"{name} has no value yet")
        if isinstance(value, list):
            raise WrongExpression(f"{name} is an array")
        assert isinstance(value, (int, float, str))
        return value

    def reading(self, what: str, number: int) -> float:
        """Return a reading for an expression."""
        if what == "time":
            return self.time
        return scopes.reading(self._replay.machine, self.time, what, number)

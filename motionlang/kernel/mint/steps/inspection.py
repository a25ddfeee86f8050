"""The variables of a debug build at a stop, by their names."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from motionlang.kernel.lang.debugging import Frame, Variable
from motionlang.kernel.lang.steps import Steps, Values
from motionlang.kernel.lang.task import Task
from motionlang.kernel.mint.keywords import table
from motionlang.kernel.mint.resolve.symbols import INTEGER, Function, Symbol, Type
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.mint.runtime.task import PARENT, MintTask
from motionlang.kernel.mint.steps.places import is_shared, variables_of

if TYPE_CHECKING:
    from motionlang.kernel.mint.resolve.names import Symbols

# The range of an Integer.
_LOW, _HIGH = -(2**31), 2**31 - 1


class Inspection:
    """The variables of a program, and the calls of its tasks."""

    def __init__(self, environment: Environment, names: Symbols) -> None:
        self._environment, self._names = environment, names
        self._functions = {id(environment.steps_of(each)): each for each in names.functions}

    def module(self) -> list[Variable]:
        """Return the variables that functions of the program share."""
        return self._variables(self._names.main, [])

    def frames(self, task: Task, offset: int | None) -> list[Frame]:
        """Return the calls and Gosubs of a task, the innermost first.

        `offset` is the source offset of a task that is stopped in the hook; None for one that is suspended.
        """
        assert isinstance(task, MintTask)
        found = []
        steps, values, at = task.steps, task.values, task.at if offset is None else offset
        for call in reversed(task.calls):
            step = call.steps[call.pc - 1]
            label = steps.labels.get(step.to, "") if values is call.values else ""
            found.append(self._frame(steps, values, at, label))
            steps, values, at = call.steps, call.values, step.at
        return [*found, self._frame(steps, values, at)]

    def _frame(self, steps: Steps, values: Values, offset: int, label: str = "") -> Frame:
        """Return a call, or a Gosub to a label."""
        function = self._functions[id(steps)]
        own = [] if function is self._names.main else self._variables(function, values)
        return Frame(label or function.name, offset, own)

    def unlisted(self, task: Task | None, name: str) -> Variable | None:
        """Return TIME, in the milliseconds of a task; None for any other name, because all variables are listed."""
        task = task or self._environment.by_name.get(PARENT)
        if name != table().doing("time") or not isinstance(task, MintTask):
            return None
        return Variable(name, INTEGER, self._environment.milliseconds(task.timer[0], task.now))

    def depth(self, task: Task) -> int:
        """Return the number of calls and Gosubs that the running task is in."""
        assert isinstance(task, MintTask)
        return len(task.calls) + 1

    def _variables(self, function: Function, values: Values) -> list[Variable]:
        places = self._environment.places
        found = []
        for symbol in variables_of(function):
            content = places.shared if is_shared(symbol) else values
            found.append(variable(symbol, content, places.index(symbol)))
        return found


def variable(symbol: Symbol, content: Values, index: int) -> Variable:
    """Return a variable whose content is at an index of a list."""
    if symbol.by_ref:
        content, index = content[index]
    elif symbol.boxed:
        content, index = content[index], 0
    return _element(symbol.name, symbol.type, symbol.dimensions, content, index)


def _element(name: str, kind: Type, sizes: tuple[int, ...], content: Values, index: int) -> Variable:
    """Return what is at a place: a value, an array, or a value of a user type."""
    value = content[index]

    def give(new: object) -> None:
        content[index] = new

    word = str(kind)
    if sizes:
        names = _subscripts(getattr(value, "sizes", sizes))
        elements = [
            _element(f"{name}({each})", kind, (), value, number) for number, each in enumerate(names, 1)
        ]
        return Variable(name, word, elements)
    if kind.record is not None:
        members = [
            _element(field, each.type, each.dimensions, value, each.index)
            for field, each in kind.record.members.items()
        ]
        return Variable(name, word, members)
    if word not in ("Integer", "Float", "String"):
        return Variable(name, word, value[0] is not None if word == "Semaphore" else value)
    return Variable(name, word, value, _giving(word, give))


def _giving(kind: str, give: Callable[[Any], None]) -> Callable[[object], None]:
    return lambda wanted: give(converted(kind, wanted))


def _subscripts(dimensions: tuple[int, ...]) -> list[str]:
    """Return the subscripts of all elements of an array, in storage order."""
    texts = [""]
    for size in dimensions:
        texts = [f"{text}, {n}" if text else str(n) for text in texts for n in range(1, size + 1)]
    return texts


def converted(kind: str, value: object) -> object:
    """Return a value as a variable of a type stores it.

    Raises ValueError if the type does not allow it.
    """
    if kind == "String":
        if not isinstance(value, str):
            raise ValueError(f"a String takes a text in quotes, not {value}")
        return value
    if not isinstance(value, (int, float)):
        raise ValueError(f"a variable of type {kind} takes a number, not {value!r}")
    if kind == "Float":
        return float(value)
    if not _LOW <= value <= _HIGH:
        raise ValueError(f"{value:.10g} is outside the range of an Integer")
    return int(value)

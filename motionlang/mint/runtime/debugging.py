"""A debug build at run time: the hook before statements, and variables at a stop."""

from __future__ import annotations

from sys import _getframe

from motionlang.lang.debugging import Frame, Variable
from motionlang.lang.task import CHUNK
from motionlang.mint.runtime.code_units import CELLS, FILE

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping, Sequence
    from types import CellType, FrameType
    from typing import Any

    from motionlang.lang.debugging import Hook
    from motionlang.lang.task import Task
    from motionlang.mint.compile.stops import Described, Shape
    from motionlang.mint.runtime.environment import Environment

# The range of an Integer.
_LOW, _HIGH = -(2**31), 2**31 - 1


def stopper(hook: Hook, environment: Environment) -> Callable[[float, int], None]:
    """Return the function `B` of generated code.

    Its arguments are the statement's number on the time scale, and the source offset.
    """
    statements = environment.statements

    def stop(count: float, offset: int) -> None:
        hook.stop(environment.task, statements.at(count), offset)

    return stop


class Inspection:
    """The variables of a debug build.

    `functions` maps the Python name of a function to its title and its variables. `shared` are the cells of the
    program by name.
    """

    def __init__(
        self,
        environment: Environment,
        functions: Mapping[str, tuple[str, Sequence[Described]]],
        shared: Mapping[str, CellType],
    ) -> None:
        self._environment, self._functions, self._shared = environment, functions, shared

    def module(self) -> list[Variable]:
        """Return the variables that functions of the program share."""
        _, described = self._functions["main"]
        cells = {**_cells_of(self._environment.blocks["main"]), **self._shared}
        parent = self._environment.tasks.get("ParentTask")
        frame = getattr(getattr(parent, "_generator", None), "gi_frame", None)
        if frame is not None:
            cells |= _captured(frame)
        return [_variable(each, cells) for each in described if each[1] in cells]

    def frames(self, task: Task, offset: int | None) -> list[Frame]:
        """Return the calls of a task, the innermost first.

        `offset` is the source offset of a task that is stopped in the hook; None for one that is suspended.
        """
        found: list[Frame] = []
        inner = offset
        for frame in _running() if offset is not None else _suspended(task):
            name, at = frame.f_code.co_name, self._environment.files[FILE][frame.f_lineno]
            if inner is None:
                inner = at
            if name in self._functions:  # no dispatcher, and no part of a long function
                found.append(Frame(self._functions[name][0], inner, self._variables(frame)))
                inner = None
        return found

    def unlisted(self, task: Task | None, name: str) -> Variable | None:
        """Return None, because all variables are listed."""
        return None

    def depth(self, task: Task) -> int:
        """Return the number of calls and GoSubs that the running task is in."""
        return sum(1 for frame in _running() if not frame.f_code.co_name.startswith(CHUNK))

    def _variables(self, frame: FrameType) -> list[Variable]:
        name = frame.f_code.co_name
        _, described = self._functions[name]
        cells = {**self._shared, **_captured(frame)}
        if name == "main":
            return []
        return [_variable(each, cells) for each in described if each[1] in cells]


def _running() -> Iterator[FrameType]:
    """Yield the frames of generated code on the stack, the innermost first."""
    frame: FrameType | None = _getframe()
    while frame is not None and frame.f_code.co_filename != FILE:
        frame = frame.f_back
    while frame is not None and frame.f_code.co_filename == FILE:
        yield frame
        frame = frame.f_back


def _suspended(task: Task) -> Iterator[FrameType]:
    frames = []
    generator: Any = getattr(task, "_generator", None)
    while (frame := getattr(generator, "gi_frame", None)) is not None:
        if frame.f_code.co_filename == FILE:
            frames.append(frame)
        generator = getattr(generator, "gi_yieldfrom", None)
    yield from reversed(frames)


def _captured(frame: FrameType) -> dict[str, CellType]:
    """Return the cells of a function's variables by name."""
    captured = frame.f_locals.get(CELLS)
    return {} if captured is None else _cells_of(captured)


def _cells_of(function: Any) -> dict[str, CellType]:
    code = getattr(function, "__code__", None)
    if code is None:
        return {}
    return dict(zip(code.co_freevars, getattr(function, "__closure__", None) or (), strict=False))


# ------------------------------------------------------------------------------------------------ variables


def _variable(described: Described, cells: Mapping[str, CellType]) -> Variable:
    name, python, shape, storage = described
    cell = cells[python]
    if storage == "by_ref":
        array, index = cell.cell_contents, cells[f"{python}_k"].cell_contents
        return _element(name, shape, array, index)
    if storage == "boxed":
        return _element(name, shape, cell.cell_contents, 0)
    value = _contents(cell)

    def give(value: object) -> None:
        cell.cell_contents = value

    return _shown(name, shape, value, give)


def _contents(cell: CellType) -> object:
    try:
        return cell.cell_contents
    except ValueError:  # the function has not come that far
        return None


def _element(name: str, shape: Shape, array: Any, index: int) -> Variable:
    def give(value: object) -> None:
        array[index] = value

    return _shown(name, shape, array[index], give)


def _shown(name: str, shape: Shape, value: Any, give: Callable[[object], None]) -> Variable:
    kind, dimensions, members = shape
    if dimensions:
        inner: Shape = (kind, (), members)
        names = _subscripts(dimensions)
        elements = [_element(f"{name}({each})", inner, value, number) for number, each in enumerate(names, 1)]
        return Variable(name, kind, elements)
    if members:
        fields = [_element(field, inner, value, number) for number, (field, inner) in enumerate(members)]
        return Variable(name, kind, fields)
    if kind not in ("Integer", "Float", "String"):
        content = value[0] is not None if kind == "Semaphore" and isinstance(value, list) else value
        return Variable(name, kind, content)
    return Variable(name, kind, value, lambda wanted: give(converted(kind, wanted)))


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

"""The code of a program in units: functions that are compiled together.

A unit is compiled when one of its functions is called, or earlier. Data that functions share is in cells,
created once when the program starts: the variables that several functions use and, if subs are called, the time
`t` and the horizon `H`. A unit is compiled within a function that has those names, and the functions found in
it are combined with the cells:

    def _(t, H, v_x):
     global s_fill
     def s_fill(p_n):
      nonlocal t, v_x
      …

All other names are global: `kN`, `E`, `P`, `T`, and the functions. Until a unit is compiled, stand-ins take the
place of its functions. When called, a stand-in replaces itself with the compiled function.
"""

from __future__ import annotations

from marshal import dumps, loads

from motionlang.record import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence
    from types import CellType, CodeType
    from typing import Any

# The file name of generated code, which distinguishes it from our own in tracebacks.
FILE = "<mint>"
# The time, which subs share with their callers.
TIME = ("t", "H")
# What a debug build shares in addition: the number of statements, its limit, and where to stop (`lang/debugging.py`).
COUNTING = ("n", "N", "D")
# The variable of a debug build that holds the cells of a function's own variables.
CELLS = "m_"
# The prefix of variables that hold no data of the program, or none beyond the next `yield`.
SCRATCH = "m"
# The prefixes of variables that have when a loop began, followed by its source position.
LOOPS = "lr"


def given_name(name: str) -> str:
    """Return the global name for a value that is supplied when the code starts."""
    return f"g_{name.lower()}"


def _example() -> Callable[[], None]:
    """Return a function with a cell, from which the classes of both are taken."""
    cell = None
    return lambda: cell


_FUNCTION: Any = type(_example())
_CODE = type(_example().__code__)  # type: ignore[attr-defined,unused-ignore]
_CELL: Any = type(_example().__closure__[0])  # type: ignore[attr-defined,index,unused-ignore]


class Unit:
    """Functions with these `names`, as text until their code is needed.

    The compiled text has two more lines in front of `text`. Line n of it is line `before` + n of the whole program.
    `cells` are the names that it shares with other units. `packed` is the code of a unit from the cache, until it is
    needed.
    """

    __slots__ = ("before", "cells", "codes", "names", "packed", "text")

    def __init__(
        self,
        names: tuple[str, ...],
        text: str,
        before: int,
        cells: tuple[str, ...],
        packed: bytes = b"",
    ) -> None:
        self.names, self.text, self.before, self.cells, self.packed = names, text, before, cells, packed
        self.codes: tuple[CodeType, ...] = ()

    @property
    def is_compiled(self) -> bool:
        """True if the code has been compiled, even if it is still packed."""
        return bool(self.codes or self.packed)

    def compile(self, file: str = FILE) -> tuple[CodeType, ...]:
        """Return the code of the functions, compiled on first use."""
        if not self.codes and self.packed:
            self.codes = loads(self.packed)
        elif not self.codes:
            head = f"def _({', '.join(self.cells)}):\n global {', '.join(self.names)}"
            text = f"{head}\n{self.text}"
            module = compile(text, file, "exec")
            around = next(each for each in module.co_consts if each.__class__ is _CODE)
            self.codes = tuple(
                _moved(each, self.before) for each in around.co_consts if each.__class__ is _CODE
            )
        return self.codes

    def payload(self) -> tuple[object, ...]:
        """Return the arguments from which `Unit` can be recreated."""
        packed = self.packed or (dumps(self.codes) if self.codes else b"")
        return self.names, "" if packed else self.text, self.before, self.cells, packed


def _moved(code: CodeType, lines: int) -> CodeType:
    """Return the code with its line numbers increased by `lines`."""
    if not lines:
        return code
    inner = tuple(_moved(each, lines) if each.__class__ is _CODE else each for each in code.co_consts)
    return code.replace(co_firstlineno=code.co_firstlineno + lines, co_consts=inner)


@record
class Code:
    """All units of a program, and the data that they need.

    `first` sets the initial values of the cells named in `shared`. `specs` describes the `kN`. `blocks` maps "main",
    "task blink", "event timer" and so on to the names of the functions. `offsets[n]` is the source offset of line n of
    the code. `first_text` is the Python of `first`, which is not cached.
    """

    units: Sequence[Unit]
    first: CodeType | None
    shared: Sequence[str]
    specs: Sequence[tuple[object, ...]]
    blocks: Mapping[str, str]
    offsets: Sequence[int]
    first_text: str = ""

    @property
    def size(self) -> int:
        """The number of units that are compiled."""
        return sum(1 for unit in self.units if unit.is_compiled)

    @property
    def text(self) -> str:
        """The generated Python of the program, without the head lines of its units."""
        return "\n".join(unit.text for unit in self.units)

    def payload(self) -> tuple[object, ...]:
        """Return all data in a form that `marshal` accepts, for `loaded`."""
        units = [unit.payload() for unit in self.units]
        # Equivalent to `array`, whose import takes longer than this line.
        offsets = memoryview(bytearray(8 * len(self.offsets))).cast("q")
        for line, offset in enumerate(self.offsets):
            offsets[line] = offset
        return units, self.first, self.shared, self.specs, self.blocks, offsets.tobytes()

    def link(
        self,
        namespace: dict[str, object],
        time: tuple[CellType, CellType],
        counting: tuple[CellType, ...] = (),
    ) -> list[CellType]:
        """Put the functions, or their stand-ins, into a namespace.

        All other names are already in the namespace. `time` are the cells of the time, and `counting` those of a debug
        build. Returns the cells of the variables that functions share.
        """
        values: dict[str, object] = {}
        if self.first is not None:
            exec(self.first, values)
        cells = dict(zip(TIME, time, strict=True))
        cells.update(zip(COUNTING, counting, strict=False))
        cells.update((name, _CELL(values.get(name))) for name in self.shared)
        for unit in self.units:
            if unit.codes:
                bind(unit, namespace, cells)
            else:
                for name in unit.names:
                    namespace[name] = _LazyFunction(name, unit, namespace, cells)
        return [cells[name] for name in self.shared]


def loaded(payload: tuple[object, ...]) -> Code:
    """Recreate the code from the result of `Code.payload`."""
    units, first, shared, specs, blocks, offsets = payload
    made = [Unit(*unit) for unit in units]  # type: ignore[attr-defined]
    return Code(made, first, shared, specs, blocks, memoryview(offsets).cast("q"))  # type: ignore[arg-type]


def bind(unit: Unit, namespace: dict[str, object], cells: Mapping[str, CellType]) -> None:
    """Put the functions of a unit into a namespace."""
    for code in unit.compile():
        closure = tuple(cells[name] for name in code.co_freevars)
        namespace[code.co_name] = _FUNCTION(code, namespace, code.co_name, None, closure)


class _LazyFunction:
    """A function that is compiled at its first call."""

    __slots__ = ("cells", "name", "namespace", "unit")

    # Shows that the function will be generated code.
    __code__ = _example.__code__.replace(co_filename=FILE)

    def __init__(
        self, name: str, unit: Unit, namespace: dict[str, object], cells: Mapping[str, CellType]
    ) -> None:
        self.name, self.unit, self.namespace, self.cells = name, unit, namespace, cells

    def __call__(self, *arguments: object) -> object:
        if self.namespace[self.name] is self:
            bind(self.unit, self.namespace, self.cells)
        return self.namespace[self.name](*arguments)  # type: ignore[operator]

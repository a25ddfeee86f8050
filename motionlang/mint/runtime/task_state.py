"""The state of a suspended task, and of shared variables, as comparable bytes.

The state of a task is the state of the generators in which it is suspended: the position of each in its code, and
its local variables. Values on the stack of a generator are not included. Instead, a call that leaves such values
while a sub waits is counted (`Environment.midway`), and the counts are compared, too.
"""

from __future__ import annotations

from marshal import dumps

from motionlang.mint.runtime.code_units import LOOPS, SCRATCH, TIME

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from types import CodeType
    from typing import Any

    from motionlang.mint.runtime.operations import PutOff

# In this version equal values give equal bytes. Later versions of marshal also encode which of them are one
# object.
_VERSION = 2
# Names of generated code whose values do not survive a `yield`.
_PASSING = frozenset((*TIME, "z", "x", "jump"))
# The prefix of parameters. A list among them may be a variable of the caller.
_PARAMETER = "p_"


class Names:
    """The names of local variables of some code.

    `parameters` are a subset of `all`; `loops` are those that have when a loop began (`loop_times.py`).
    """

    def __init__(self, code: CodeType) -> None:
        names = dict.fromkeys(code.co_varnames + code.co_cellvars)
        self.loops = [each for each in names if each[0] in LOOPS and each[1:].isdecimal()]
        self.all = [
            each for each in names if each not in (*_PASSING, *self.loops) and not each.startswith(SCRATCH)
        ]
        self.parameters = [each for each in self.all if each.startswith(_PARAMETER)]


_names_of: dict[CodeType, Names] = {}


def of_task(
    generator: Any, put_off: PutOff | None, alive: dict[int, object], is_old: Callable[[Any], bool]
) -> bytes | None:
    """Return the state of a task that is suspended in `generator`.

    The beginnings of loops for which `is_old` returns true are alike.
    Returns None if it is suspended in code that is not compiled Mint. Objects whose identity is part of the state are
    added to `alive`, so that no other object gets the same identity.
    """
    state: list[object] = []
    if put_off is not None:
        operation, arguments, axes = put_off
        state += [_identity(operation, alive), arguments, axes]
    while generator is not None:
        frame = getattr(generator, "gi_frame", None)
        if frame is None:
            return None
        code = frame.f_code
        names = _names_of.get(code)
        if names is None:
            names = _names_of[code] = Names(code)
        values = frame.f_locals
        state += [_identity(code, alive), frame.f_lasti]
        state += [values.get(name) for name in names.all]
        for name in names.loops:
            began = values.get(name)
            state.append(began if began is None or not is_old(began) else True)
        for name in names.parameters:
            if isinstance(values.get(name), list):
                state.append(_identity(values[name], alive))
        generator = generator.gi_yieldfrom
    return of_values(state, alive)


def of_values(values: list[Any], alive: dict[int, object]) -> bytes:
    """Return values as comparable bytes; for `alive` see `of_task`."""
    try:
        return dumps(values, _VERSION)
    except ValueError:  # a task that holds a semaphore
        return dumps(_named(values, alive), _VERSION)


def _named(value: Any, alive: dict[int, object]) -> Any:
    if isinstance(value, (list, tuple)):
        return [_named(each, alive) for each in value]
    if value is None or isinstance(value, (int, float, str)):
        return value
    return ("object", _identity(value, alive))


def _identity(value: object, alive: dict[int, object]) -> int:
    """Return the identity of an object, which is added to `alive`."""
    alive[id(value)] = value
    return id(value)

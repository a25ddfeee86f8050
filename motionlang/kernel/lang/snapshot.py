"""A snapshot of a run, put back in place.

Problem. A debugger goes back to an earlier statement. Running again from the start takes as long as the run. A copy of
the run would be other objects: an event whose function refers to its axis would move the axis of the original.

Idea. The state of a run is in the objects that its scheduler reaches, since tasks run on steps and nothing is in a
frame of Python. `Snapshot` walks these objects and stores the contents of each one that can change: attributes,
elements and cells of closures. `restore` puts the contents back into the same objects. So events, subscribers, readers
and waits, which refer to those objects, are right again, whatever they are made of.

Log, tracks, the changes of a servo and the entries that have taken effect only grow. They are not stored: their classes
name the attributes in `GROWING`, and go back with `cut` to the `extent` that a snapshot stores.

Invariants.
- A run changes only attributes, elements and cells of objects that its scheduler reaches. None of them is a generator,
  an iterator, a file or a socket; a snapshot refuses these.
- An object keeps its identity. A cache compares what it was read from, by identity, before it answers.
- Steps have no memory, a program only caches what its text says, and objects of modules in `CONSTANT` never change.
  Those in `OUTSIDE` are not of the run and do not go back.
- A snapshot is taken between two rounds of the scheduler. It is valid until the run goes back behind it: the lengths
  that it stores are then those of another log.
"""

from __future__ import annotations

from array import array
from collections import deque
from collections.abc import Callable, Collection
from contextlib import suppress
from enum import Enum
from functools import cache, partial
from io import StringIO
from operator import attrgetter, itemgetter
from random import Random
from re import Pattern
from types import (
    BuiltinFunctionType,
    CellType,
    CodeType,
    FunctionType,
    GetSetDescriptorType,
    MappingProxyType,
    MemberDescriptorType,
    MethodType,
    MethodWrapperType,
    ModuleType,
    SimpleNamespace,
    WrapperDescriptorType,
)
from typing import Any

from motionlang.kernel.lang.debugging import Hook
from motionlang.kernel.lang.program import Program
from motionlang.kernel.lang.steps import Steps

# Types of the language and the library whose objects never change or are the same in every run.
_ATOMS = (
    int, float, complex, str, bytes, type(None), type, ModuleType, CodeType, type(Ellipsis), type(NotImplemented),
    property, Enum, range, slice, GetSetDescriptorType, MemberDescriptorType, MappingProxyType, WrapperDescriptorType,
    attrgetter, itemgetter, Pattern,
)  # fmt: skip
# Most objects are of these, which are not even visited.
_PLAIN = frozenset({int, float, str, bytes, bool, type(None), CodeType, ModuleType, type})
# Modules of motion profiles, texts, trees, names and facts of loops, whose objects never change.
CONSTANT = (
    "motionlang.kernel.planners.", "motionlang.kernel.source", "motionlang.kernel.lang.keyword",
    "motionlang.kernel.lang.variable_uses", "motionlang.kernel.mint.syntax.", "motionlang.kernel.mint.resolve.",
    "motionlang.kernel.mccl.resolve.", "lark.",
)  # fmt: skip
# The debugger, which is not part of the run.
OUTSIDE = ("motionlang.ide.debug.",)
_OUTSIDE_TYPES = (Hook,)


class Snapshot:
    """The contents of all objects that an object reaches.

    Raises TypeError if one of them cannot be stored. `size` is the number of attributes and elements.
    """

    # Types of objects that the run does not change, nor anything that only they reach.
    constant: tuple[type, ...] = (Steps, Program)

    def __init__(self, root: object) -> None:
        self._cuts: list[Callable[[], object]] = []
        self._contents: list[Callable[[], object]] = []
        self.size = 0
        self._walk(root)

    def restore(self) -> None:
        """Put the contents back."""
        for put in (*self._cuts, *self._contents):
            put()

    def _walk(self, root: object) -> None:
        """Visit each object once, and store its contents."""
        queue, seen = [root], {id(root): root}
        # The object that led to another one, for the text of an error.
        holders: dict[int, object] = {}
        while queue:
            x = queue.pop()
            try:
                held = self._held(x, type(x))
            except TypeError as error:
                raise TypeError(f"{error}, held by {_path(x, holders)}") from None
            for each in held:
                if type(each) not in _PLAIN and id(each) not in seen:
                    seen[id(each)] = each
                    holders[id(each)] = x
                    queue.append(each)

    def _store(self, put: Callable[[Any, Any], object], x: object, contents: Any) -> None:
        self._contents.append(partial(put, x, contents))
        self.size += len(contents)

    def _held(self, x: Any, kind: type) -> Collection[Any]:
        """Store an object and return the objects that it holds."""
        if kind in _FUNCTIONS:
            return _held_by_function(x)
        if kind in _CONTAINERS:
            return self._elements(x, kind)
        if kind is CellType:
            held = _contents_of_cell(x)
            self._store(_put_cell, x, held)
            return held
        if kind is array or kind is bytearray:
            self._store(_put_array, x, x[:])
        elif kind.__module__ == "numpy" and kind.__name__ == "ndarray":  # which few runs import
            if x.flags.writeable:
                self._store(_put_array, x, x.copy())
        elif kind is memoryview:
            self._store(_put_array, x.cast("B"), bytes(x))
        elif kind is Random:
            self._store(Random.setstate, x, x.getstate())
        elif kind is StringIO:
            self._store(_put_text, x, x.getvalue())
        elif not isinstance(x, self.constant) and (layout := _layout(kind)) is not None:
            return self._attributes(x, *layout)
        return ()

    def _elements(self, x: Any, kind: type) -> Collection[Any]:
        if kind is list or kind is deque:
            contents = list(x)
            self._store(_put_elements, x, contents)
            return contents
        if kind is dict:
            self._store(_put_items, x, dict(x))
            return [*x, *x.values()]
        if kind is set:
            self._store(_put_items, x, set(x))
        return x  # type: ignore[no-any-return]

    def _attributes(self, x: Any, base: type | None, slots: tuple[_Slot, ...]) -> Collection[Any]:
        growing = getattr(x, "GROWING", ())
        if growing:
            self._cuts.append(partial(x.cut, x.extent()))
        held = [] if base is None else list(self._elements(x, base))
        if slots:
            full, empty = [], []
            for slot in slots:
                try:
                    full.append((slot, slot.__get__(x)))
                except AttributeError:
                    empty.append(slot)
            self._store(_put_slots, x, (full, empty))
            held += [value for _, value in full]
        if hasattr(x, "__dict__"):
            attributes = dict(vars(x))
            for name in growing:
                attributes.pop(name, None)
            self._store(_put_attributes, x, attributes)
            held += attributes.values()
        return held


# ------------------------------------------------------------------------------------------------ classes


_Slot = MemberDescriptorType
_CONTAINERS = (tuple, frozenset, list, deque, dict, set)
_FUNCTIONS = (FunctionType, MethodType, partial, BuiltinFunctionType, MethodWrapperType)


@cache
def _layout(kind: type) -> tuple[type | None, tuple[_Slot, ...]] | None:
    """Return the container that a class is derived from, if any, and its slots; None if its objects are not stored.

    A subclass may have a method of the same name as a slot, so the slots are descriptors.
    """
    module = kind.__module__
    if issubclass(kind, (*_ATOMS, *_OUTSIDE_TYPES)) or module.startswith((*CONSTANT, *OUTSIDE)):
        return None
    if not module.startswith("motionlang.") and kind is not SimpleNamespace:
        raise TypeError(f"no snapshot can store a {kind.__qualname__}")
    base = next((each for each in _CONTAINERS if issubclass(kind, each)), None)
    own = [vars(each) for each in kind.__mro__ if "__slots__" in vars(each)]
    growing = getattr(kind, "GROWING", ())
    return base, tuple(
        each
        for values in own
        for name, each in values.items()
        if isinstance(each, _Slot) and name not in growing
    )


def _contents_of_cell(cell: CellType) -> tuple[Any, ...]:
    try:
        return (cell.cell_contents,)
    except ValueError:
        return ()


def _held_by_function(x: Any) -> Collection[Any]:
    if isinstance(x, FunctionType):
        return (*(x.__closure__ or ()), *(x.__defaults__ or ()), *(x.__kwdefaults__ or {}).values())
    if isinstance(x, partial):
        return x.func, x.args, x.keywords
    return (x.__self__,)


def _path(x: object, holders: dict[int, object]) -> str:
    """Return the classes that hold an object, from the inside out."""
    found: list[str] = []
    while (holder := holders.get(id(x))) is not None:
        found.append(getattr(holder, "__qualname__", type(holder).__name__))
        x = holder
    return " of ".join(found[:5])


# ------------------------------------------------------------------------------------------------ in place


def _put_elements(x: Any, contents: list[Any]) -> None:
    x.clear()
    x.extend(contents)


def _put_items(x: Any, contents: Any) -> None:
    x.clear()
    x.update(contents)


def _put_array(x: Any, contents: Any) -> None:
    x[:] = contents


def _put_text(x: StringIO, contents: str) -> None:
    x.seek(0)
    x.truncate()
    x.write(contents)


def _put_cell(x: CellType, contents: tuple[Any, ...]) -> None:
    if contents:
        (x.cell_contents,) = contents
    else:
        del x.cell_contents


def _put_slots(x: Any, contents: tuple[list[tuple[_Slot, Any]], list[_Slot]]) -> None:
    full, empty = contents
    for slot, value in full:
        slot.__set__(x, value)
    for slot in empty:
        with suppress(AttributeError):
            slot.__delete__(x)


def _put_attributes(x: Any, contents: dict[str, Any]) -> None:
    attributes, growing = vars(x), getattr(x, "GROWING", ())
    for name in [each for each in attributes if each not in contents and each not in growing]:
        del attributes[name]
    attributes.update(contents)

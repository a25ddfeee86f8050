"""Numbers that know of which readings they were worked out, for a run that is explored.

Problem. A condition depends on inputs, levels and numbers of a host, which come to it through variables, arrays,
parameters and sums. Differences between runs show which ones, but clocks differ between runs, too.

Idea. A reading returns a number that knows it, and what is worked out of it carries a linear form: for each reading by
how much the number changes if the reading is larger by 1. Both sides of a comparison then say at which value of which
channel it turns. Where an operation is not linear, such as a product of two readings, the factor is NaN: the reading
takes part, and nothing more is known. Truncation keeps the factors, since it changes less than 1.

The bits of a bank are a linear form, too. A number that consists of bits loses those that a mask takes out, and moves
those that a shift moves; after a sum it is a number like any other.

Cost. Only a run whose observer asks for them reads such numbers (`ReadObservers.trace`). They equal plain ones, are
printed like these, and have their types, `int` or `float`.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping
from math import nan
from typing import Any

from motionlang.kernel.tools import signed

# A reading: the table of the machine file that changes the value, its number there, and the value that was read.
Reading = tuple[str, int, float]
Form = Mapping[Reading, float]
# A form with more readings, such as that of a filter, keeps the channels alone.
MAX_READINGS = 64
# The factors by which a result changes with the left and the right side.
Factors = Callable[[Any, Any], tuple[float, float]]
Method = Callable[[Any, Any], Any]


def _methods(operate: Method, factors: Factors, is_sum: bool = False) -> tuple[Method, Method]:
    """Return an operator and its reflection; only a sum of two readings is linear in both."""

    def made(left: Any, right: Any) -> Any:
        a, b = plain(left), plain(right)
        one, other = (nan, nan) if not is_sum and is_traced(left) and is_traced(right) else factors(a, b)
        form = {each: factor * one for each, factor in form_of(left).items()}
        for each, factor in form_of(right).items():
            form[each] = form.get(each, 0.0) + factor * other
        has_bits = is_sum and ((a == 0 and _is_bits(right)) or (b == 0 and _is_bits(left)))  # as a Float
        return traced(operate(a, b), form, has_bits)

    return made, lambda self, other: made(other, self)


def _bit_methods(operate: Method, factor: Callable[[bool], float]) -> tuple[Method, Method]:
    """Return an operator of bits and its reflection; `factor` is that of a bit by whether the other side has it."""

    def made(self: Any, other: Any) -> Any:
        if is_traced(other) or not _is_bits(self):
            return traced(operate(plain(self), plain(other)), {**_unknown(self), **_unknown(other)})
        form = {each: k * factor(bool(int(abs(k)) & other)) for each, k in self.form.items()}
        return traced(operate(plain(self), other), form, is_bits=True)

    return made, made


def _shifted(self: Any, by: Any) -> Any:
    """Shift to the left, or by a negative number to the right."""
    bits, count = plain(self), plain(by)
    if is_traced(by) or not _is_bits(self):
        return traced(bits << count if count >= 0 else bits >> -count, {**_unknown(self), **_unknown(by)})
    moved = {each: k * 2.0**count for each, k in self.form.items() if abs(k) * 2.0**count >= 1.0}
    return traced(bits << count if count >= 0 else bits >> -count, moved, is_bits=True)


class Traced:
    """A number with its linear form; `is_bits` is True if it consists of bits, each of a channel or constant."""

    form: Form
    is_bits: bool

    __add__, __radd__ = _methods(operator.add, lambda a, b: (1.0, 1.0), is_sum=True)
    __sub__, __rsub__ = _methods(operator.sub, lambda a, b: (1.0, -1.0), is_sum=True)
    __mul__, __rmul__ = _methods(operator.mul, lambda a, b: (b, a))
    __truediv__, __rtruediv__ = _methods(operator.truediv, lambda a, b: (1.0 / b, nan))
    __floordiv__, __rfloordiv__ = _methods(operator.floordiv, lambda a, b: (1.0 / b, nan))
    __mod__, __rmod__ = _methods(operator.mod, lambda a, b: (nan, nan))
    __and__, __rand__ = _bit_methods(operator.and_, float)
    __or__, __ror__ = _bit_methods(operator.or_, lambda has: float(not has))
    __xor__, __rxor__ = _bit_methods(operator.xor, lambda has: -1.0 if has else 1.0)
    __lshift__ = _shifted

    def __rshift__(self, by: Any) -> Any:
        return _shifted(self, -by)

    def __invert__(self) -> Any:
        return self ^ -1

    def __neg__(self) -> Any:
        return self * -1

    def __abs__(self) -> Any:
        return -self if plain(self) < 0 else self

    def __trunc__(self) -> Any:
        return traced(int(plain(self)), self.form, self.is_bits)

    def __reduce__(self) -> Any:
        return traced, (plain(self), dict(self.form), self.is_bits)


class TracedInt(Traced, int):
    """An integer with its linear form."""


class TracedFloat(Traced, float):
    """A real number with its linear form."""


def traced(number: Any, form: Form, is_bits: bool = False) -> Any:
    """Return a number with its linear form, a plain one if no channel takes part."""
    form = {each: factor for each, factor in form.items() if factor}
    if not form:
        return number
    if len(form) > MAX_READINGS:
        form = {(table, channel, nan): nan for table, channel, _ in form}
    made: Any = (TracedInt if isinstance(number, int) else TracedFloat)(number)
    made.form, made.is_bits = form, is_bits
    return made


def reading(value: Any, table: str, number: int, factor: float = 1.0) -> Any:
    """Return what was read of a channel; a key has the number 0, an answer the source offset of its INPUT."""
    return traced(value, {(table, number, value): factor})


def bits(word: int, table: str, first: int, count: int, level: Callable[[int], float]) -> Any:
    """Return a word whose bits are the states of some channels, each its level or the opposite of it."""
    form = {}
    for k in range(count):
        on = level(first + k)
        form[table, first + k, on] = signed(1 << k) * (1.0 if (word >> k & 1) == bool(on) else -1.0)
    return traced(word, form, is_bits=True)


def is_traced(number: object) -> bool:
    """True if a number knows of which readings it was worked out."""
    return isinstance(number, Traced)


def form_of(number: object) -> Form:
    """Return the linear form of a number or a text, empty for one that is plain."""
    return number.form if isinstance(number, Traced) else {}


def plain(number: Any) -> Any:
    """Return a number without its form."""
    if isinstance(number, TracedInt):
        return int(number)
    return float(number) if isinstance(number, TracedFloat) else number


def _is_bits(number: object) -> bool:
    return isinstance(number, Traced) and number.is_bits


def _unknown(number: object) -> Form:
    return dict.fromkeys(form_of(number), nan)

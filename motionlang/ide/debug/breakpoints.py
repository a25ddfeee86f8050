"""Breakpoints with condition, hit count and log message, and watched variables."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from motionlang.ide.debug import scopes
from motionlang.ide.debug.expressions import Expression, ExpressionState, WrongExpression, parse
from motionlang.ide.debug.replay import Replay, StopPoint
from motionlang.ide.debug.values import shown

_HITS = re.compile(r"\s*(>=|>|==|=|<=|<|%)?\s*(\d{1,9})\s*")
_MISSING = object()


class Breakpoint:
    """A breakpoint at some source offsets, usually the first statement of a line.

    `condition` is an expression, `hits` a number or a comparison such as ">= 5" or "% 10", and `message` the text of a
    log point with expressions in braces. Raises WrongExpression if one of them is invalid.
    """

    def __init__(
        self,
        offsets: Sequence[int],
        condition: str = "",
        hits: str = "",
        message: str | None = None,
        text: str = "",
    ) -> None:
        self.offsets, self.text = frozenset(offsets), text
        self.condition: Expression | None = parse(condition) if condition.strip() else None
        self._counts = _hits(hits)
        self.is_counted = bool(hits.strip())
        self.message: Callable[[ExpressionState], str] | None = None if message is None else _message(message)

    def counts(self, count: int) -> bool:
        """True if the program stops at hit number `count`, counted from 1."""
        return self._counts(count)


def _hits(text: str) -> Callable[[int], bool]:
    if not text.strip():
        return lambda count: True
    match = _HITS.fullmatch(text)
    if match is None or int(match[2]) < {">=": 0, ">": 0, "<": 2}.get(match[1], 1):
        raise WrongExpression(f"{text.strip()!r} is no hit count; write 5, >= 5 or % 5")
    sign, number = match[1], int(match[2])
    return {
        None: lambda count: count == number,
        "=": lambda count: count == number,
        "==": lambda count: count == number,
        ">=": lambda count: count >= number,
        ">": lambda count: count > number,
        "<=": lambda count: count <= number,
        "<": lambda count: count < number,
        "%": lambda count: count % number == 0,
    }[sign]


def _message(text: str) -> Callable[[ExpressionState], str]:
    """Return a function that makes the text of a log point.

    Expressions in braces are replaced by their values.
    """
    segments = re.split(r"\{([^{}]*)\}", text)
    expressions = [parse(each) for each in segments[1::2]]

    def message(state: ExpressionState) -> str:
        values = []
        for expression in expressions:
            try:
                values.append(shown(expression(state)))
            except ValueError as error:
                values.append(f"<{error}>")
        return "".join(one + other for one, other in zip(segments[::2], [*values, ""], strict=True))

    return message


class Watched:
    """A watched variable, axis or channel, by its path.

    The program stops after it has changed.
    """

    def __init__(self, path: tuple[str, ...]) -> None:
        self.path = path

    def note(self, replay: Replay, point: StopPoint) -> None:
        """Store the current value in a run."""
        replay.values[self.path] = self._value(replay, point)

    def change(self, replay: Replay, point: StopPoint) -> str:
        """Return how the value has changed since the last call in this run.

        The result is "" if it has not.
        """
        before, now = replay.values.get(self.path, _MISSING), self._value(replay, point)
        if now is None:
            return ""  # not in scope
        replay.values[self.path] = now
        if before is _MISSING or before is None or before == now:
            return ""
        if self.path[0] == scopes.MACHINE and isinstance(now, tuple):
            return f"{self.path[-1]} changes"
        return f"{self.path[-1]} changes from {shown(before)} to {shown(now)}"

    def _value(self, replay: Replay, point: StopPoint) -> object:
        if self.path[0] == scopes.MACHINE:
            return scopes.present(replay.machine, self.path[1])
        variable = scopes.find(replay.hook, point, self.path)
        if variable is None:
            return None
        return _flat(variable.value)


def _flat(value: object) -> object:
    if isinstance(value, list):
        return tuple(_flat(each.value) for each in value)
    return value

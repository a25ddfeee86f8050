"""Counter of the calls of engine methods in a run."""

from __future__ import annotations

from collections.abc import Callable
from types import ModuleType

import pytest


class CallCount:
    """Number of calls of the methods that a test counts."""

    def __init__(self) -> None:
        self.calls = 0


def count_calls(monkeypatch: pytest.MonkeyPatch, *methods: tuple[type | ModuleType, str]) -> CallCount:
    """Return a counter of all calls of the given methods together, starting now.

    Each method is given as its class, or its module, and its name.
    """
    count = CallCount()

    def counted(method: Callable[..., object]) -> Callable[..., object]:
        def call(*arguments: object, **named: object) -> object:
            count.calls += 1
            return method(*arguments, **named)

        return call

    for owner, name in methods:
        monkeypatch.setattr(owner, name, counted(getattr(owner, name)))
    return count

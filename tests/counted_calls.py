"""Counters of calls: of engine methods in a run, and of all functions in a piece of work."""

from __future__ import annotations

import gc
import sys
from collections.abc import Callable
from types import FrameType, ModuleType

import pytest


class CallCount:
    """Number of calls of the methods that a test counts."""

    def __init__(self) -> None:
        self.calls = 0


def count_calls(monkeypatch: pytest.MonkeyPatch, *methods: tuple[type | ModuleType, str]) -> CallCount:
    """Return a counter of all calls of the given methods together, starting now."""
    count = CallCount()

    def counted(method: Callable[..., object]) -> Callable[..., object]:
        def call(*arguments: object, **named: object) -> object:
            count.calls += 1
            return method(*arguments, **named)

        return call

    for owner, name in methods:
        monkeypatch.setattr(owner, name, counted(getattr(owner, name)))
    return count


def all_calls(work: Callable[[], object]) -> int:
    """Return how many functions a piece of work calls, those written in C included.

    The collector is off, because its callbacks would be counted, too.
    """
    made = 0

    def count(_: FrameType, event: str, __: object) -> None:
        nonlocal made
        made += event in ("call", "c_call")

    gc.disable()
    sys.setprofile(count)
    try:
        work()
    finally:
        sys.setprofile(None)
        gc.enable()
    return made

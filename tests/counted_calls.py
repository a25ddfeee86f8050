"""Counters of calls: of engine methods in a run, and of all functions in a piece of work."""

from __future__ import annotations

import gc
import sys
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from types import CodeType, FrameType, ModuleType
from typing import Any

import pytest

import motionlang

PACKAGE = str(Path(motionlang.__file__).parent)
Trace = Callable[[FrameType, str, Any], Any]


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


def lines_by_function(work: Callable[[], object]) -> Counter[CodeType]:
    """Return how many lines of each function of ours a piece of work carries out.

    A comprehension counts a line for each of its iterations, which are no calls.
    """
    found: Counter[CodeType] = Counter()

    def count(frame: FrameType, event: str, _: object) -> Trace:
        found[frame.f_code] += event == "line"
        return count

    def begin(frame: FrameType, _: str, __: object) -> Trace | None:
        return count if PACKAGE in frame.f_code.co_filename else None

    before = sys.gettrace()
    sys.settrace(begin)
    try:
        work()
    finally:
        sys.settrace(before)
    return found


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

"""The operator of the machine file: what is typed at INPUT, and the keys for INKEY."""

from __future__ import annotations

from functools import partial

from motionlang.lang.task import Wait
from motionlang.mint.environment import INFINITY

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.environment import Environment


def wait_for_answer(environment: Environment, t: float) -> Wait:
    """Wait for the next `[[answer]]`; where there is none left, for ever."""
    left = answers(environment)
    return Wait(t, lambda: bool(left), lambda: INFINITY, "for the operator to answer INPUT")


def answers(environment: Environment) -> list[str]:
    """The answers that the operator has not given yet."""
    if environment.answers is None:
        given = environment.machine.settings.get("answer", ())
        environment.answers = [str(each["text"]) for each in given]  # type: ignore[attr-defined]
    return environment.answers


def take(environment: Environment, as_text: bool) -> float | str:
    """The next answer, shown as the operator would have seen it; as a number, what it begins with."""
    text = answers(environment).pop(0)
    environment.machine.terminal.write(f"{text}\n")
    if as_text:
        return text
    from motionlang.mint.functions import value

    return value(text)


def keys(environment: Environment) -> Callable[[], int]:
    """INKEY: each key is an event of the clock, so that a wait for one need not poll."""
    clock = environment.clock
    pressed: list[int] = []
    for entry in environment.machine.settings.get("key", ()):  # type: ignore[attr-defined]
        codes = [ord(each) & 0xFF for each in str(entry["text"])]
        clock.at(max(float(entry.get("at", 0.0)), clock.now), partial(pressed.extend, codes))
    return lambda: pressed.pop(0) if pressed else 0
